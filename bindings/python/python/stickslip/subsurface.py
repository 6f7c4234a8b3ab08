"""Stresses and displacements below the surface: at points of uncoated bodies, on planes, as a volume for ParaView."""

from ._enums import Body
from ._stickslip import Plane, Planes, Principal, PointResult, PointResults, Stress, at_points

__all__ = ["Body", "Plane", "Planes", "Principal", "PointResult", "PointResults", "Stress", "at_points"]
