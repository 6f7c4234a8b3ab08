"""Slopes of the forces by approach, shift and twist."""

from ._stickslip import ContactStiffness, NormalStiffness, TangentialStiffness

__all__ = ["ContactStiffness", "NormalStiffness", "TangentialStiffness"]
