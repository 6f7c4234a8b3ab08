"""Contacts that remember their load: steps, cycles, fretting loops, adaptive steps, steps that roll."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass

from . import wear
from ._enums import LeadingEdge, StopReason, Regime, EntryRule
from ._remarks import warn
from ._stickslip import (
    AdaptiveSteps,
    Cycle,
    EnergyBalance,
    History,
    LoadPath,
    LoadStep,
    LoopPoint,
    LoopPoints,
    Rolling,
    State,
    StepErrorEstimate,
    StepResult,
)
from .errors import Tolerance

# `import stickslip.history.wear` finds it under this name too.
sys.modules[f"{__name__}.wear"] = wear


@dataclass(frozen=True)
class FrettingResult:
    """What a fretting loop came to."""

    cycles: int
    """Whole cycles taken."""
    ending: StopReason
    """Why there were no more."""
    last: Cycle
    """The last cycle; incomplete if the observer broke off."""


class FrettingLoop:
    """Repeats a cycle of tangential load.

    After each cycle its remarks, :attr:`Cycle.warnings`, go to ``warnings``, each kind once a place; those of single steps do
    not.

    Parameters
    ----------
    path : LoadPath
        The values (x, y) at the ends of the steps of a cycle (forces or lengths, as ``load`` takes them).
    load : callable
        Makes a :class:`~stickslip.LoadStep` of a value. In a loop that changes the gap it prescribes the normal load in every
        step: else the pressure stays that of the old gap. Press before the loop: a first step that presses and shears at
        once leaves shear in the cells that touched on the way, and the loop off its centre.
    until_steady : float, optional
        Stops after the first cycle whose :attr:`Cycle.cyclic_residual` is no more than this, in (0, 1); never by default.

    Raises
    ------
    Tolerance

    Examples
    --------
    >>> import stickslip as ss
    >>> from stickslip.history import FrettingLoop, LoadPath
    >>> grid = ss.Grid.square(32, 0.3e-3)
    >>> steel = ss.Material(213e9, 0.29)
    >>> bodies = ss.HalfSpace(grid, (steel, steel))
    >>> history = ss.History(bodies, ss.surface.sphere(grid, 3.5e-3), 0.5)
    >>> step = history.step(normal_force=100.0)
    >>> path = LoadPath.sine((2e-6, 0.0), 20)
    >>> loop = FrettingLoop(path, lambda shift: ss.LoadStep(shift=shift), until_steady=1e-4)
    >>> outcome = loop.run(history, 10)
    >>> outcome.cycles, str(outcome.ending), str(outcome.last.regime)
    (2, 'steady', 'partial_slip')
    """

    def __init__(
        self,
        path: LoadPath,
        load: Callable[[tuple[float, float]], LoadStep],
        *,
        until_steady: float | None = None,
    ) -> None:
        if until_steady is not None and not 0.0 < until_steady < 1.0:
            error = Tolerance(f"the tolerance must lie strictly between 0 and 1, got {until_steady}")
            error.value = until_steady
            raise error
        if not isinstance(path, LoadPath):
            raise TypeError(f"the path must be a LoadPath, got {type(path).__name__}: LoadPath(values)")
        self._path = path
        self._load = load
        self._until_steady = until_steady

    def cycle(self, history: History, cycle: Cycle) -> None:
        """Takes one cycle and adds it up in ``cycle``, which begins anew.

        After a step that fails, or that Ctrl-C ends, both are as they were after the last good one.
        """
        self._pass(history, cycle, None)

    def run(
        self,
        history: History,
        cycles: int,
        observer: Callable[[History, Cycle], object] | None = None,
    ) -> FrettingResult:
        """Takes so many cycles, or fewer if one is steady before.

        Parameters
        ----------
        history : History
            The history that takes the steps.
        cycles : int
            The most cycles to take.
        observer : callable, optional
            Called after every step with the history and the cycle so far. It may wear the gap, change friction or
            write; it breaks off by returning ``False``.
        """
        last = Cycle(history)
        for done in range(cycles):
            if not self._pass(history, last, observer):
                return FrettingResult(done, StopReason.STOPPED, last)
            if self._until_steady is not None and last.cyclic_residual <= self._until_steady:
                return FrettingResult(done + 1, StopReason.STEADY, last)
        return FrettingResult(cycles, StopReason.CYCLE_LIMIT, last)

    # FrettingLoop::run_observed of the crate is not used: within it the history is borrowed, so that an observer could not
    # wear its gap through the object that it is given, and it observes no product, so that Ctrl-C would act only after a step.
    def _pass(
        self,
        history: History,
        cycle: Cycle,
        observer: Callable[[History, Cycle], object] | None,
    ) -> bool:
        cycle.begin(history)
        for value in self._path.cycles(1):
            history.step(self._load(value), warn=False)
            cycle.add(history)
            if observer is not None and observer(history, cycle) is False:
                return False
        # Of the cycle as a whole: after a reversal the first ring that slips is narrow, and matters little.
        warn([(remark.kind, remark.message) for remark in cycle.warnings])
        return True

    def __repr__(self) -> str:
        return f"FrettingLoop({self._path!r}, until_steady={self._until_steady})"


__all__ = [
    "AdaptiveSteps",
    "Cycle",
    "EnergyBalance",
    "FrettingLoop",
    "History",
    "LeadingEdge",
    "LoadPath",
    "LoadStep",
    "StopReason",
    "FrettingResult",
    "LoopPoint",
    "LoopPoints",
    "Regime",
    "Rolling",
    "State",
    "StepErrorEstimate",
    "StepResult",
    "EntryRule",
    "wear",
]


def __dir__() -> list[str]:
    return __all__
