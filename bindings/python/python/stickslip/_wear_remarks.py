"""Warnings of ``wear.run`` about negligible wear and about limits in another unit."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ._wear_laws import ArchardLaw, EnergyLaw, ThresholdEnergyLaw

if TYPE_CHECKING:
    from ._stickslip import History
    from ._wear_run import WearSnapshot

# Largest worn depth after a run with a warning, in displacements. Coefficients in another unit usually give smaller depths.
LEAST_WEAR = 1e-10

# Least energy per area after a run without a warning, in thresholds. Runs that end below the threshold may be intended.
LEAST_ENERGY = 0.01

# Largest limit of a depth without a warning, in displacements. Lengths in micrometres exceed lengths in metres by 1e6.
LARGEST_LIMIT = 1e3


def remarks_on_wear(law: object, history: History, snapshot: WearSnapshot) -> list[tuple[str, str]]:
    """Returns the remark that a run removed almost nothing although cells dissipated energy."""
    depth, energy = float(snapshot.depth.max()), float(snapshot.dissipation.max()) / history.grid.cell_area
    if not energy > 0.0:
        return []
    # A coefficient of zero is a reference without wear.
    coefficient = _largest_coefficient(law)
    if coefficient == 0.0:
        return []
    cycles = "1 cycle" if snapshot.cycles == 1 else f"{snapshot.cycles} cycles"
    without_threshold = depth
    if isinstance(law, ThresholdEnergyLaw):
        threshold = float(law.threshold)
        if energy < LEAST_ENERGY * threshold:
            return [
                (
                    "negligible_wear",
                    f"the largest worn depth after {cycles} is {depth:.3g}, because the energy per area of the cells is at most "
                    f"{energy:.3g}, which is {energy / threshold:.2g} of the threshold: check the unit of the threshold",
                )
            ]
        without_threshold = coefficient * energy
    displacement = largest_displacement(history)
    if without_threshold > LEAST_WEAR * displacement:
        return []
    return [
        (
            "negligible_wear",
            f"the largest worn depth after {cycles} is {depth:.3g} at a displacement of {displacement:.3g}, although "
            f"cells dissipated up to {energy:.3g} per area: check the unit of the coefficient of wear, and of a threshold",
        )
    ]


def largest_displacement(history: History) -> float:
    """Returns the largest normal displacement of the contact. The approach would depend on the datum of the gap."""
    gap = np.asarray(history.normal.gap)[np.asarray(history.contact)]
    before = np.asarray(history.unloaded_gap)[np.asarray(history.contact)]
    return float((gap - before + history.approach).max(initial=0.0)) if gap.size else 0.0


def remarks_on_limits(displacement: float, **limits: object) -> list[tuple[str, str]]:
    """Returns the remarks that limits of depths exceed the displacement by far. Infinite limits are intended."""
    remarks = []
    for name, limit in limits.items():
        if not isinstance(limit, (int, float, np.number)) or displacement <= 0.0:
            continue
        if math.inf > limit > LARGEST_LIMIT * displacement:
            sentence = (
                f"{name} is {float(limit):.3g} at a displacement of {displacement:.3g}, so that it hardly limits the wear: "
                "check its unit, or omit it"
            )
            # Kinds without the name would hide the warning of a second limit.
            remarks.append((f"ineffective_{name}", sentence))
    return remarks


def _largest_coefficient(law: object) -> float:
    """Returns the largest coefficient of a law of this package, and NaN for laws of users."""
    if not isinstance(law, (EnergyLaw, ArchardLaw, ThresholdEnergyLaw)):
        return math.nan
    return float(np.asarray(law.coefficient, dtype=float).max())
