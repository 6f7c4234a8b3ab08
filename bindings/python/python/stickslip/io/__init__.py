"""Surfaces from files, fields into files; a module for each format. Solutions and surfaces as datasets of xarray."""

from .._stickslip import read
from . import asc, csv, npy, pvd, sdf, sur, vti, x3p, xyz
from ._datasets import from_xarray, to_xarray

__all__ = ["asc", "csv", "from_xarray", "npy", "pvd", "read", "sdf", "sur", "to_xarray", "vti", "x3p", "xyz"]
