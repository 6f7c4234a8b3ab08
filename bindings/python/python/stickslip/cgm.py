"""Solvers for constrained minima of quadratic forms, with operators of the package or user-defined operators."""

from ._enums import Method, Status
from ._stickslip import Iteration, LinearOperator, Minimum, Report, Settings, TensorOperator, identity, minimise

__all__ = [
    "Iteration",
    "LinearOperator",
    "Method",
    "Minimum",
    "Report",
    "Settings",
    "Status",
    "TensorOperator",
    "identity",
    "minimise",
]
