"""The edges of contacts and stick zones inside the cells."""

from ._stickslip import Edges, TangentialEdges

__all__ = ["Edges", "TangentialEdges"]
