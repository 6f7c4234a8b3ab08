"""Series of images over time for ParaView."""

from .._stickslip import Series

__all__ = ["Series"]
