"""Wear laws, jumps over cycles, and a driver of wear over many cycles. ``stickslip.history.wear`` is the same module.

:func:`run` wears the gap of a history over many cycles. The functions of the laws return a new array of depths. The energy
laws require the area of a cell. The dissipation of a cycle, a step, a history and a state contains its grid, as the attribute
``grid``, and so do its sums and multiples. Other arrays require ``grid=history.grid``. The laws require one number per cell
and reject a total.

A loop without :func:`run` sets the worn gap by ``history.set_gap(history.gap_as_set + depth)``. The attribute ``gap_as_set``
does not contain the depth yielded under a permanent set, which the history adds to every gap.
"""

from ._enums import WearEnding
from ._stickslip import CycleJump, archard, energy, max_stable_cycles, threshold_energy
from ._wear_laws import ArchardLaw, EnergyLaw, JumpLaw, ThresholdEnergyLaw
from ._wear_run import WearHistory, WearResult, WearSnapshot, run

__all__ = [
    "ArchardLaw",
    "CycleJump",
    "EnergyLaw",
    "JumpLaw",
    "ThresholdEnergyLaw",
    "WearEnding",
    "WearHistory",
    "WearResult",
    "WearSnapshot",
    "archard",
    "energy",
    "max_stable_cycles",
    "run",
    "threshold_energy",
]
