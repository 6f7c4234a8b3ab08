"""Wear laws, and jumps over cycles. ``stickslip.history.wear`` is the same module.

The laws return a new array of depths. Arrays, such as those of a :class:`~stickslip.history.Cycle`, do not contain the
size of their cells, so the energy laws require ``grid=history.grid`` with such arrays.
"""

from ._stickslip import CycleJump, archard, energy, max_stable_cycles, threshold_energy

__all__ = ["CycleJump", "archard", "energy", "max_stable_cycles", "threshold_energy"]
