"""Reading of surfaces from files and writing of fields to files, with one module per format. Solutions and surfaces can
be converted to and from xarray."""

from .._stickslip import read
from . import asc, csv, npy, pvd, sdf, sur, vti, x3p, xyz
from ._datasets import from_xarray, to_xarray

__all__ = ["asc", "csv", "from_xarray", "npy", "pvd", "read", "sdf", "sur", "to_xarray", "vti", "x3p", "xyz"]
