"""Operators with an explicit matrix, for checking results."""

from ._stickslip import DenseMinimum, DenseOperator

__all__ = ["DenseMinimum", "DenseOperator"]
