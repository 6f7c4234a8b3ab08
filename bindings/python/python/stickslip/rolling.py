"""Steady rolling: traction, slip and creepage of two bodies that roll over each other, in the frame of the contact.

Creepages and spin are motions of body 2 over body 1, opposite to the definition of Kalker and CONTACT.

The contact is at rest, and the particles of both surfaces move through it, starting at the leading edge. A creepage is
the motion of body 2 over body 1 per unit length rolled; it is given, or follows from a force. Cells that enter the
contact follow the motion by the law of growing contacts. The grid must extend beyond the leading edge by at least one
step; otherwise a call raises :class:`~stickslip.errors.GridTooShort`. The law also uses slopes of the gap, which need
two more cells. If these cells are missing, the slopes are one-sided.
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
