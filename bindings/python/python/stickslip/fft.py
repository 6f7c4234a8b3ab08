"""Convolutions by fast transforms."""

from ._stickslip import Convolution

__all__ = ["Convolution"]
