"""Surfaces from files, fields into files; a module for each format."""

from .._stickslip import read
from . import asc, csv, npy, pvd, sdf, sur, vti, x3p, xyz

__all__ = ["asc", "csv", "npy", "pvd", "read", "sdf", "sur", "vti", "x3p", "xyz"]
