"""Surfaces in ASC files."""

from .._stickslip import asc_parse as parse
from .._stickslip import asc_read as read

__all__ = ["parse", "read"]
