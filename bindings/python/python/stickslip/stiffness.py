"""Derivatives of the forces with respect to approach, shift and twist."""

from ._stickslip import ContactStiffness, NormalStiffness, TangentialStiffness

__all__ = ["ContactStiffness", "NormalStiffness", "TangentialStiffness"]
