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


def with_nan(values: Any) -> Any:
    """Returns an array of numbers in which the missing values ``NA`` of pandas are NaN; ``None`` if there are none."""
    array = np.array(values)
    if array.dtype.kind != "O":
        return None
    missing = np.array([type(value).__name__ == "NAType" for value in array.flat]).reshape(array.shape)
    if not missing.any():
        return None
    array[missing] = np.nan
    return array.astype(float)


def in_order(values: Any, quantity: str, names: list[str], is_sequence: bool) -> Any:
    """Returns the entries with these names, in this order, or the columns with these names of a sequence of such entries. Labels are
    the columns of a table, the index of a Series, the last coordinate of an array of xarray, or the names of the parts of a named
    tuple or a structured array. Entries without labels, and entries that are only numbered, keep their positions."""
    labels: list[Any] | None = None
    if hasattr(values, "columns"):
        if set(names) <= set(getattr(values, "index", ())):
            values = values.T  # the names are those of the rows
        kind, labels = "columns", list(values.columns)
        entries = values.to_numpy()
    elif hasattr(values, "dims") and hasattr(values, "coords"):
        of_axes = {name: values.coords[name].values.tolist() for name in values.dims if name in values.coords}
        for name, along in of_axes.items():
            if set(names) <= set(along):
                values = values.transpose(..., name)
        kind, entries = "coordinates", values.values
        if getattr(values, "ndim", 0) == 1 + is_sequence:  # datasets have no number of dimensions
            labels = of_axes.get(values.dims[-1])
    elif is_sequence:
        return values
    elif hasattr(values, "index") and hasattr(values, "iloc"):
        kind, labels, entries = "labels", list(values.index), values.to_numpy()
    elif hasattr(values, "_fields"):
        kind, labels, entries = "names", list(values._fields), np.array(values)
    elif getattr(getattr(values, "dtype", None), "names", None):
        kind, labels, entries = "names", list(values.dtype.names), np.array(values.tolist())
    else:
        return values
    if labels is None or labels == list(range(len(labels))):
        return entries
    if not set(names) <= set(labels) or len(set(labels)) < len(labels):
        remedy = "rename them, or give .to_numpy() for columns in this order" if kind == "columns" else "rename them, or give a tuple"
        refuse_type(quantity, f"must have the {kind} {', '.join(names)}, got {', '.join(map(str, labels))}: {remedy}")
    if kind == "columns":
        return values[names].to_numpy()
    return entries[..., [labels.index(name) for name in names]]


def tensor_in_order(values: Any, quantity: str) -> Any:
    """Returns the rows and columns of a labelled tensor of two axes in the order x, y. Labels are the index and the columns of a table,
    or the coordinates of an array of xarray. Axes without labels, and axes that are only numbered, keep their positions."""
    names = ["x", "y"]
    if hasattr(values, "columns"):
        axes, entries = [list(values.index), list(values.columns)], values.to_numpy()
    elif hasattr(values, "dims") and hasattr(values, "coords") and getattr(values, "ndim", 0) == 2:
        axes = [values.coords[name].values.tolist() if name in values.coords else [0, 1] for name in values.dims]
        entries = values.values
    else:
        return values
    for axis, labels in enumerate(axes):
        if labels == list(range(len(labels))):
            continue
        if sorted(map(str, labels)) != names:
            refuse_type(
                quantity,
                f"must have the labels x and y along both axes, got {', '.join(map(str, labels))}: rename them, or give a tuple",
            )
        entries = entries.take([labels.index(name) for name in names], axis=axis)
    return entries
