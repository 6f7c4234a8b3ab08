"""Attributes as dictionaries and as tables of pandas, which is imported only if a table is requested."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ._checks import refuse_type

# Components of tuples that are not vectors.
PARTS = {
    "normal_stress": ("xx", "yy", "zz"),
    "shear_stress": ("xy", "xz", "yz"),
    "error_bounds": ("pressure", "traction"),
}


def record(target: object, names: Iterable[str]) -> dict[str, Any]:
    """Returns attributes by name; the components of a tuple, and the entries of an object with ``to_dict``, become entries."""
    values: dict[str, Any] = {}
    for name in names:
        value = getattr(target, name)
        if isinstance(value, tuple):
            values |= {f"{name}_{part}": number for part, number in zip(PARTS.get(name, "xyz"), value)}
        elif hasattr(value, "to_dict"):
            values |= {f"{name}_{key}": number for key, number in value.to_dict().items()}
        else:
            values[name] = value
    return values


def columns(entries: Iterable[object], names: Iterable[str]) -> dict[str, Any]:
    """Returns attributes of all entries as arrays by name; ``None`` becomes NaN."""
    rows = [record(entry, names) for entry in entries]
    # Without entries, the names of pairs are not known, and there is no number to collect.
    keys = list(rows[0]) if rows else list(names)
    return {key: np.array([np.nan if row[key] is None else row[key] for row in rows]) for key in keys}


def _pandas() -> Any:
    try:
        import pandas  # type: ignore[import-untyped, unused-ignore]
    except ImportError as error:
        raise ImportError("tables require pandas: pip install pandas") from error
    return pandas


def to_frame(columns: Mapping[str, Any]) -> Any:
    """Returns a :class:`pandas.DataFrame` of columns by name."""
    return _pandas().DataFrame(dict(columns))


def to_series(values: Mapping[str, Any], name: str) -> Any:
    """Returns a :class:`pandas.Series` of values by name."""
    return _pandas().Series(dict(values), name=name, dtype=object)


def in_columns(table: Any, quantity: str, names: list[str]) -> Any:
    """Returns an array of the columns with these names, in this order. Columns that are only numbered keep their positions."""
    labels = list(table.columns)
    if labels == list(range(len(labels))):
        return table.to_numpy()
    if not set(names) <= set(labels):
        remedy = "rename them, or give .to_numpy() for columns in this order"
        refuse_type(quantity, f"must have the columns {', '.join(names)}, got {', '.join(map(str, labels))}: {remedy}")
    return table[names].to_numpy()
