"""Influence coefficients of rectangles under uniform traction."""

from ._enums import Component, Direction
from ._stickslip import Rectangle, Table, Tensor

__all__ = ["Component", "Direction", "Rectangle", "Table", "Tensor"]
