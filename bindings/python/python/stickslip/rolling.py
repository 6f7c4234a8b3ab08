"""Steady rolling: traction, slip and creepage of two bodies that roll over each other, in the frame of the contact.

The contact is at rest, and the particles of both surfaces move through it, starting at the leading edge. A creepage is
the motion of body 2 over body 1 per unit length rolled, opposite to the creepage of Kalker and CONTACT. It is given, or
follows from a force. Cells that enter the contact follow the motion by the law of growing contacts.

The grid must extend ahead of the contact by one step. The law needs the slope of the gap two cells further ahead. If the
grid ends before, this slope is one-sided.
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
