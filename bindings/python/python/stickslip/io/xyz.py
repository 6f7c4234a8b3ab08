"""Surfaces in XYZ files."""

from .._stickslip import xyz_parse as parse
from .._stickslip import xyz_read as read

__all__ = ["parse", "read"]
