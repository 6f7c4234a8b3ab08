"""Derivatives of the forces with respect to approach, shift and twist, at fixed sets of contact, stick and slip cells."""

from ._stickslip import ContactStiffness, NormalStiffness, TangentialStiffness

__all__ = ["ContactStiffness", "NormalStiffness", "TangentialStiffness"]
