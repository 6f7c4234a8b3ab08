"""Surfaces in SDF files."""

from .._stickslip import sdf_parse as parse
from .._stickslip import sdf_read as read
from .._stickslip import sdf_to_bytes as to_bytes
from .._stickslip import sdf_write as write

__all__ = ["parse", "read", "to_bytes", "write"]
