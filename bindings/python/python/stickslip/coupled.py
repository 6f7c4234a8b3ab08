"""Pressure and traction found together, of bodies of different materials."""

from ._stickslip import CoupledProblem, CoupledReport, CoupledSolution, CoupledSolver, ErrorEstimate

__all__ = ["CoupledProblem", "CoupledReport", "CoupledSolution", "CoupledSolver", "ErrorEstimate"]
