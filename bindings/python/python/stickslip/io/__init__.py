"""Surfaces from files, fields into files; a module for each format. Solutions as datasets of xarray."""

from .._stickslip import read
from . import asc, csv, npy, pvd, sdf, sur, vti, x3p, xyz
from ._datasets import to_xarray

__all__ = ["asc", "csv", "npy", "pvd", "read", "sdf", "sur", "to_xarray", "vti", "x3p", "xyz"]
