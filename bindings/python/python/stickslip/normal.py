"""Normal contact."""

from ._stickslip import Hardness, NormalProblem, NormalSolution, NormalSolver

__all__ = ["Hardness", "NormalProblem", "NormalSolution", "NormalSolver"]
