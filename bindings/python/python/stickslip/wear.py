"""Laws of wear, and jumps over cycles; also as the attribute ``wear`` of :mod:`stickslip.history`.

The laws return a new array of depths. Arrays do not know their cells: give ``grid=``.
"""

from ._stickslip import CycleJump, archard, energy, max_stable_cycles, threshold_energy

__all__ = ["CycleJump", "archard", "energy", "max_stable_cycles", "threshold_energy"]
