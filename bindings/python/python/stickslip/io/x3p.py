"""Surfaces in X3P files."""

from .._stickslip import x3p_parse as parse
from .._stickslip import x3p_read as read

__all__ = ["parse", "read"]
