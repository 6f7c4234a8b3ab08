"""Checks of the axes and factors of plots, and factors for lengths of known unit."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._checks import kind, refuse_type
from ._stickslip import Field, Grid


def check_axes(axes: object) -> None:
    """Raises an error unless an argument is an object of the class Axes of matplotlib, or ``None``."""
    if axes is None or hasattr(axes, "imshow") and hasattr(axes, "inset_axes"):
        return
    remedy = ""
    if isinstance(axes, tuple):
        remedy = ": give the second value of pyplot.subplots()"
    elif isinstance(axes, (np.ndarray, list)):
        remedy = ": give one of its entries, such as axes[0]"
    elif hasattr(axes, "add_subplot"):
        remedy = ": give figure.subplots(), or one of figure.axes"
    refuse_type("axes", f"must be Axes of matplotlib, got {kind(axes)}{remedy}")


def check_factors(**factors: Any) -> None:
    """Raises an error unless the factors are numbers or ``None``."""
    for name, value in factors.items():
        is_other = isinstance(value, (str, bytes, bool, np.bool_)) or not hasattr(value, "__float__") or np.ndim(value) != 0
        if value is not None and is_other:
            unit = "unit" if name == "value_scale" else "length_unit"
            remedy = f": give the unit by {unit}={value!r}" if isinstance(value, str) else ""
            refuse_type(name, f"must be a number, got {kind(value)}{remedy}")


def factor(given: float | None, own: str | None, shown: str) -> float:
    """Returns a factor for lengths. The default converts a known unit into the unit of the label, if it is a unit of length."""
    if given is not None:
        return given
    if own is None or not shown:
        return 1.0
    try:
        return float(Field(Grid(1, 1, 1.0, 1.0), [[1.0]], own).to_unit(shown).max())
    except ValueError:  # not a unit of length
        return 1.0
