"""Steady rolling: traction, slip and creepage of two bodies that roll over each other, as the contact sees them.

The contact stands still, and the particles of both surfaces move through it, from the leading edge on. A creepage is what
body 2 moves over body 1 for each length rolled; it is given, or follows from a force. Cells that enter the contact follow
the motion by the law of growing contacts, which needs the slope of the gap two cells ahead of the contact: leave the grid
as much room.
"""

from ._enums import LeadingEdge, EntryRule
from ._stickslip import (
    CoupledRollingProblem,
    CoupledRollingReport,
    CoupledRollingSolution,
    CoupledRollingSolver,
    CreepForce,
    CreepForces,
    RollingProblem,
    RollingSolution,
    RollingSolver,
)

__all__ = [
    "CoupledRollingProblem",
    "CoupledRollingReport",
    "CoupledRollingSolution",
    "CoupledRollingSolver",
    "CreepForce",
    "CreepForces",
    "LeadingEdge",
    "RollingProblem",
    "RollingSolution",
    "RollingSolver",
    "EntryRule",
]
