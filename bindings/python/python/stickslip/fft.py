"""Convolutions by fast Fourier transforms."""

from ._stickslip import Convolution

__all__ = ["Convolution"]
