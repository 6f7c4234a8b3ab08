"""Surfaces in SUR files."""

from .._stickslip import sur_parse as parse
from .._stickslip import sur_read as read

__all__ = ["parse", "read"]
