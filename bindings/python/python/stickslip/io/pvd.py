"""Series of images over time for ParaView."""

from .._stickslip import PvdWriter

__all__ = ["PvdWriter"]
