"""Contacts with memory of their load: steps, cycles, fretting loops, adaptive steps, steps of rolling."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from numbers import Real

import numpy as np

from . import wear
from ._checks import check_call, check_whole, kind, refuse_type
from ._enums import LeadingEdge, StopReason, Regime, EntryRule
from ._progress import cycle_bar, is_stop
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
from .errors import EmptyContact, Tolerance

# The alias makes `import stickslip.history.wear` work.
sys.modules[f"{__name__}.wear"] = wear


@dataclass(frozen=True)
class FrettingResult:
    """Result of a fretting loop."""

    cycles: int
    """Number of complete cycles."""
    ending: StopReason
    """Reason for the end of the loop."""
    last: Cycle
    """The last cycle; incomplete if the observer stopped the loop within it."""


class FrettingLoop:
    """Repeats a cycle of tangential load.

    After each cycle, its :attr:`Cycle.warnings` are issued through ``warnings``, each kind once per location, and a warning if no
    cell slips, unless the coefficient of friction exceeds 5. Warnings of single steps are not issued. The warning of a cycle that
    does not close is issued only for the last cycle of :meth:`run`, if the number of cycles ended the loop.

    Parameters
    ----------
    path : LoadPath
        The values (x, y) at the ends of the steps of a cycle (forces or lengths, as ``load`` uses them).
    load : callable
        A function that returns the :class:`~stickslip.LoadStep` of a value. In a loop that changes the gap, it must
        prescribe the normal load in every step; otherwise the pressure remains that of the previous gap. Apply the normal
        load before the loop. If the first step presses and shears simultaneously, shear remains in the cells that touched
        during the step, and the loop is not centred.
    until_steady : float, optional
        Tolerance in (0, 1): the loop stops after the first cycle whose :attr:`Cycle.cyclic_residual` does not exceed it.
        By default, the loop does not stop early. A cycle without contact is an error, because its residual is zero.

    Raises
    ------
    Tolerance
    ArgumentType
        If an argument has a wrong type, for example if path and load are swapped, or if ``load`` does not accept one argument.
    TypeError
        In a cycle, if ``load`` returns no :class:`~stickslip.LoadStep`, for example without a ``return``.

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

    A normal force that oscillates with a phase shift: the path is an ellipse of shift and force, and ``load`` uses its second
    value as the change of the normal force. For any other load, take the steps in a loop and add each to a :class:`Cycle`.

    >>> import math
    >>> ellipse = LoadPath.ellipse((2e-6, 20.0), math.pi / 2, 20)
    >>> step = history.step(normal_force=100.0 + ellipse.end[1])
    >>> loop = FrettingLoop(ellipse, lambda value: ss.LoadStep(normal_force=100.0 + value[1], shift=(value[0], 0.0)))
    >>> result = loop.run(history, 2)
    >>> round(history.normal.force), result.last.energy.dissipated_energy > 0.0
    (120, True)
    """

    def __init__(
        self,
        path: LoadPath,
        load: Callable[[tuple[float, float]], LoadStep],
        *,
        until_steady: float | None = None,
    ) -> None:
        if until_steady is not None and (isinstance(until_steady, bool) or not isinstance(until_steady, Real)):
            refuse_type("until_steady", f"must be a number in (0, 1), got {kind(until_steady)}")
        if until_steady is not None and not 0.0 < until_steady < 1.0:
            error = Tolerance(f"the tolerance must lie strictly between 0 and 1, got {until_steady}")
            error.value = until_steady
            raise error
        if not isinstance(path, LoadPath):
            refuse_type("path", f"must be a LoadPath, got {kind(path)}: create one by LoadPath(values); the order is path, load")
        if isinstance(load, type) or not callable(load):
            remedy = "give a function, such as lambda value: LoadStep(shift=value)"
            refuse_type("load", f"must be a function that returns a LoadStep, got {kind(load)}: {remedy}")
        check_call("load", load, "value")
        self._path = path
        self._load = load
        self._until_steady = until_steady

    def cycle(self, history: History, cycle: Cycle) -> None:
        """Takes one cycle and accumulates it in ``cycle``, which is restarted.

        After a step that fails, or that is interrupted by Ctrl-C, history and cycle are in the state after the last
        successful step.

        Raises
        ------
        ArgumentType
            If an argument has a wrong type, for example if history and cycle are swapped.
        """
        _check_history(history, "history, cycle")
        if not isinstance(cycle, Cycle):
            refuse_type("cycle", f"must be a Cycle, got {kind(cycle)}: create one by Cycle(history)")
        self._pass(history, cycle, None)

    def run(
        self,
        history: History,
        cycles: int,
        observer: Callable[[History, Cycle], object] | None = None,
        *,
        progress: Callable[[int, Cycle], object] | bool | None = None,
    ) -> FrettingResult:
        """Takes the given number of cycles, or fewer if the loop becomes steady earlier.

        Parameters
        ----------
        history : History
            The history that takes the steps.
        cycles : int
            The largest number of cycles.
        observer : callable, optional
            A function that is called after every step with the history and the current cycle. It may change the gap by
            wear, change the friction or write output; it stops the loop by returning ``False``. The energies of the cycle
            are sums over its steps so far. Wear of each step requires ``history.last_step.dissipation``.
        progress : callable or bool, optional
            A function that is called after every complete cycle with the number of complete cycles and the cycle; it
            stops the loop by returning ``False``. ``True`` shows a progress bar of the cycles (requires tqdm).

        Raises
        ------
        ArgumentType
            If an argument has a wrong type, for example if history and cycles are swapped.
        ArgumentRange
            If the number of cycles is negative or not whole.
        ValueError
            If ``load`` returns equal steps for different values of the path.
        EmptyContact
            If no step of a cycle is in contact, and the loop has the tolerance ``until_steady``.
        """
        _check_history(history, "history, cycles")
        check_whole("cycles", cycles, 0, ": the order is history, cycles")
        cycles = int(cycles)
        if not (observer is None or callable(observer)):
            refuse_type("observer", f"must be a function of history and cycle, got {kind(observer)}")
        if observer is not None:
            check_call("observer", observer, "history", "cycle")
        if not (progress is None or isinstance(progress, (bool, np.bool_)) or callable(progress)):
            refuse_type("progress", f"must be a function, True or None, got {kind(progress)}")
        if callable(progress):
            check_call("progress", progress, "cycles", "cycle")
        self._check_loads()
        last = Cycle(history)
        is_pressed = False

        def watch(history: History, cycle: Cycle) -> object:
            nonlocal is_pressed
            is_pressed = is_pressed or bool(history.contact.any())
            return None if observer is None else observer(history, cycle)

        with cycle_bar(cycles, 0, progress is True) as bar:
            for done in range(1, cycles + 1):
                is_pressed = False
                if not self._pass(history, last, observer if self._until_steady is None else watch):
                    return FrettingResult(done - 1, StopReason.STOPPED, last)
                if self._until_steady is not None and not is_pressed:
                    raise EmptyContact(
                        f"no step of cycle {done} is in contact, so the loop cannot become steady: press the bodies by a "
                        "step with a normal load before the loop, or prescribe the normal load in every step"
                    )
                bar(1)
                is_stopped = callable(progress) and is_stop(progress(done, last))
                if self._until_steady is not None and last.cyclic_residual <= self._until_steady:
                    return FrettingResult(done, StopReason.STEADY, last)
                if is_stopped:
                    return FrettingResult(done, StopReason.STOPPED, last)
        warn([(remark.kind, remark.message) for remark in last.warnings if remark.kind == "open_cycle"])
        return FrettingResult(cycles, StopReason.CYCLE_LIMIT, last)

    def _check_loads(self) -> None:
        """Rejects a load function that ignores the values of the path."""
        values = self._path.cycles(1)
        first, *others = (self._step(value) for value in values)
        if len(set(values)) > 1 and all(step == first for step in others):
            raise ValueError(
                "the load function returned equal steps for all values of the path: compute the load from its argument, "
                "for example return LoadStep(shift=value)"
            )

    def _step(self, value: tuple[float, float]) -> LoadStep:
        """Returns the step that the load function returns for a value."""
        step = self._load(value)
        if not isinstance(step, LoadStep):
            name = getattr(self._load, "__qualname__", None) or type(self._load).__qualname__
            found = "None" if step is None else f"an object of the class {type(step).__name__}"
            raise TypeError(
                f"the load function {name} must return a LoadStep, got {found}: end it with return LoadStep(...), "
                "for example return LoadStep(shift=value)"
            )
        return step

    # FrettingLoop::run_observed of the crate is not used here. It borrows the history, so an observer could not change
    # the gap through its argument. It also has no observer of products, so Ctrl-C would take effect only after a step.
    def _pass(
        self,
        history: History,
        cycle: Cycle,
        observer: Callable[[History, Cycle], object] | None,
    ) -> bool:
        cycle.begin(history)
        for value in self._path.cycles(1):
            history.step(self._step(value), warn=False)
            cycle.add(history)
            if observer is not None and is_stop(observer(history, cycle)):
                return False
        # Only warnings of the whole cycle are issued: after a reversal, the first slip ring is narrow but unimportant.
        # The first cycles of a loop do not close.
        remarks = {remark.kind: remark.message for remark in cycle.warnings if remark.kind != "open_cycle"}
        # The warning of large friction already states that the bodies stick everywhere.
        if cycle.regime == Regime.FULL_STICK and history.contact.any() and "large_friction" not in remarks:
            # This warning includes the cause that the slip zone is narrower than a cell.
            remarks.pop("underresolved_slip_zone", None)
            remarks["no_slip"] = _NO_SLIP
        warn(list(remarks.items()))
        return True

    def __repr__(self) -> str:
        return f"FrettingLoop({self._path!r}, until_steady={self._until_steady})"


_NO_SLIP = (
    "no cell slips in the cycle, so its energy and its wear are zero: the loads may be in another unit, such as a length given "
    "as a force, or the cells may be too large for the slip zone"
)


def _check_history(history: object, order: str) -> None:
    if not isinstance(history, History):
        refuse_type("history", f"must be a History, got {kind(history)}: the order is {order}")


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
