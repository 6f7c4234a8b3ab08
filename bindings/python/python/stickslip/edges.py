"""Edges of contacts and stick zones with sub-cell resolution."""

from ._stickslip import Edges, TangentialEdges

__all__ = ["Edges", "TangentialEdges"]
