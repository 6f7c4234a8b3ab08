"""Tangential contact under a given pressure."""

from ._enums import Axis, TangentialModel, Zone
from ._spring import Spring
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
    "Spring",
    "TangentialLoad",
    "TangentialModel",
    "TangentialProblem",
    "TangentialSolution",
    "TangentialSolver",
    "Zone",
]
