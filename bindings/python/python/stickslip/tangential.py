"""Tangential contact under a given pressure."""

from ._enums import Axis, TangentialModel, Zone
from ._stickslip import (
    Friction,
    JaegerSuperposition,
    RelativeDisplacement,
    TangentialLoad,
    TangentialProblem,
    TangentialSolution,
    TangentialSolver,
)

__all__ = [
    "Axis",
    "Friction",
    "JaegerSuperposition",
    "RelativeDisplacement",
    "TangentialLoad",
    "TangentialModel",
    "TangentialProblem",
    "TangentialSolution",
    "TangentialSolver",
    "Zone",
]
