"""Explicit matrices, to check results with."""

from ._stickslip import DenseMinimum, DenseOperator

__all__ = ["DenseMinimum", "DenseOperator"]
