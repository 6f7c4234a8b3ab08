"""Contacts that are solved to a required accuracy on grids that the solve chooses."""

from ._enums import AdaptiveStatus, Quantity
from ._stickslip import AdaptiveProblem, AdaptiveSolution, GridRecord, Region

__all__ = [
    "AdaptiveProblem",
    "AdaptiveSolution",
    "AdaptiveStatus",
    "GridRecord",
    "Quantity",
    "Region",
]
