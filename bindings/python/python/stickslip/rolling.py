"""Steady rolling: traction, slip and creepage of two bodies that roll over each other, in the frame of the contact.

The contact is at rest, and the particles of both surfaces move through it, starting at the leading edge. A creepage is
the motion of body 2 over body 1 per unit length rolled; it is given, or follows from a force. Cells that enter the
contact follow the motion by the law of growing contacts. This law needs the slope of the gap two cells ahead of the
contact, so the grid must extend at least that far.
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
