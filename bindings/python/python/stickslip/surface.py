"""Surfaces: shapes, self-affine roughness, statistics, and the preparation of measured ones."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._enums import Amplitudes
from ._stickslip import (
    Field,
    Filled,
    Grid,
    Levelled,
    PowerSpectrum,
    RoughSurface,
    SelfAffine,
    Statistics,
    bisinusoidal,
    cone,
    crop,
    cylinder,
    ellipsoid,
    fill_missing,
    flat_punch,
    gap_between,
    gap_from_heights,
    inverted,
    level,
    mirror_x,
    paraboloid,
    resample,
    sinusoidal,
    sphere,
)
from ._stickslip import sum as sum  # `import *` leaves the builtin of this name


def from_topography(topography: Any) -> Field:
    """The heights of a SurfaceTopography object, or of any that has ``heights()`` and ``physical_sizes``.

    Its arrays are indexed [x, y] and are transposed here. Masked heights become NaN: see :func:`fill_missing`. All
    functions that take heights take such objects too. Lengths are in the unit of the topography.

    Raises
    ------
    ValueError
        If its heights are not those of an area, or it has no physical sizes.

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
    heights: Any = np.ma.asarray(topography.heights(), dtype=float)
    if heights.ndim != 2:
        raise ValueError(f"the heights of the topography have {heights.ndim} dimensions, expected 2")
    sizes = topography.physical_sizes
    if sizes is None:
        raise ValueError("the topography has no physical sizes")
    nx, ny = heights.shape
    grid = Grid(nx, ny, sizes[0] / nx, sizes[1] / ny)
    return Field(grid, np.ascontiguousarray(heights.filled(np.nan).T))


__all__ = [
    "Amplitudes",
    "Filled",
    "Levelled",
    "PowerSpectrum",
    "RoughSurface",
    "SelfAffine",
    "Statistics",
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
    "inverted",
    "level",
    "mirror_x",
    "paraboloid",
    "resample",
    "sinusoidal",
    "sphere",
]


def __dir__() -> list[str]:
    return [*__all__, "sum"]
