"""Coupled contacts: pressure and traction of bodies of different materials, solved simultaneously."""

from ._stickslip import CoupledProblem, CoupledReport, CoupledSolution, CoupledSolver, ErrorEstimate

__all__ = ["CoupledProblem", "CoupledReport", "CoupledSolution", "CoupledSolver", "ErrorEstimate"]
