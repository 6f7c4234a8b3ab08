"""Surfaces: shapes, self-affine roughness, statistics, and the preparation of measured surfaces."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._checks import kind, refuse_type
from ._enums import Amplitudes, Interpolation
from ._stickslip import (
    Autocorrelation,
    Field,
    Filled,
    Filtered,
    Grid,
    Levelled,
    MaterialRatio,
    PowerSpectrum,
    RoughSurface,
    SelfAffine,
    Statistics,
    WithoutOutliers,
    bisinusoidal,
    cone,
    crop,
    cylinder,
    ellipsoid,
    fill_missing,
    flat_punch,
    gap_between,
    gap_from_heights,
    gaussian_filter,
    inverted,
    level,
    mirror_x,
    paraboloid,
    remove_outliers,
    resample,
    sinusoidal,
    sphere,
)
from ._stickslip import sum as sum  # not in `__all__`: `import *` keeps the builtin


def from_topography(topography: Any) -> Field:
    """Converts a SurfaceTopography object, or any object with ``heights()`` and ``physical_sizes``, to a field of
    heights.

    The arrays of such objects are indexed [x, y] and are transposed here. Masked heights become NaN; see
    :func:`fill_missing`. All functions that accept heights also accept such objects. The field has the unit of the
    topography, if it states one.

    Raises
    ------
    ArgumentType
        If the object is no topography, for example an array.
    ValueError
        If the heights do not have two dimensions, or if there are no physical sizes.

    Examples
    --------
    >>> import numpy as np, stickslip
    >>> class Topography:
    ...     physical_sizes = (2.0, 1.0)
    ...     def heights(self):
    ...         return np.arange(8.0).reshape(4, 2)  # four points along x
    >>> field = stickslip.surface.from_topography(Topography())
    >>> field.grid
    Grid(nx=4, ny=2, dx=0.5, dy=0.5)
    >>> field.array[1]
    array([1., 3., 5., 7.])
    """
    if not (callable(getattr(topography, "heights", None)) and hasattr(topography, "physical_sizes")):
        remedy = ": create a Field by Field(grid, array)" if isinstance(topography, np.ndarray) else ""
        refuse_type("topography", f"must have heights() and physical_sizes, got {kind(topography)}{remedy}")
    heights: Any = np.ma.asarray(topography.heights(), dtype=float)
    if heights.ndim != 2:
        raise ValueError(f"the heights of the topography have {heights.ndim} dimensions, expected 2")
    sizes = topography.physical_sizes
    if sizes is None:
        raise ValueError("the topography has no physical sizes: set its physical_sizes")
    nx, ny = heights.shape
    grid = Grid(nx, ny, sizes[0] / nx, sizes[1] / ny)
    unit = getattr(topography, "unit", None)
    return Field(grid, np.ascontiguousarray(heights.filled(np.nan).T), None if unit is None else str(unit))


def parameters(heights: Any, *, periodic: bool = False) -> dict[str, Any]:
    """Computes all parameters of ISO 25178-2 of a surface, by their ISO names.

    The dictionary contains those of :class:`Statistics`, :class:`MaterialRatio` and :class:`Autocorrelation`. Missing heights
    (NaN) have no weight; ``measured_points`` is the number of the other heights.

    Parameters
    ----------
    heights : Field or topography
        The heights (lengths).
    periodic : bool, default False
        Whether the surface continues periodically beyond its edges, for ``Sal`` and ``Str``.

    Examples
    --------
    >>> import stickslip as ss
    >>> rough = ss.surface.SelfAffine(rms_height=0.5, seed=1).generate(ss.Grid.square(64, 100.0))
    >>> found = ss.surface.parameters(rough.heights, periodic=True)
    >>> round(found["Sq"], 6), found["measured_points"], found["Smr1"] < found["Smr2"]
    (0.5, 4096, True)
    """
    spatial = Autocorrelation(heights, periodic=periodic)
    return {**Statistics(heights).to_dict(), **MaterialRatio(heights).to_dict(), **spatial.to_dict()}


__all__ = [
    "Amplitudes",
    "Autocorrelation",
    "Filled",
    "Filtered",
    "Interpolation",
    "Levelled",
    "MaterialRatio",
    "PowerSpectrum",
    "RoughSurface",
    "SelfAffine",
    "Statistics",
    "WithoutOutliers",
    "bisinusoidal",
    "cone",
    "crop",
    "cylinder",
    "ellipsoid",
    "fill_missing",
    "flat_punch",
    "from_topography",
    "gap_between",
    "gap_from_heights",
    "gaussian_filter",
    "inverted",
    "level",
    "mirror_x",
    "parameters",
    "paraboloid",
    "remove_outliers",
    "resample",
    "sinusoidal",
    "sphere",
]


def __dir__() -> list[str]:
    return [*__all__, "sum"]
