"""Time series of images for ParaView."""

from .._stickslip import PvdWriter

__all__ = ["PvdWriter"]
