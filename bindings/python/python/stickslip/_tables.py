"""Tables of pandas, which is imported only if a table is requested."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


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
