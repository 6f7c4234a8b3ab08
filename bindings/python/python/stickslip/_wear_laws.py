"""Laws of ``wear.run``, and jumps over cycles by these laws."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import CellEnergies, read_only
from ._remarks import warn
from ._stickslip import Cycle, CycleJump, Field, Grid, History, archard, energy, max_stable_cycles, threshold_energy
from .errors import NoWholeCycle, Shape

# Largest difference between the depth of many cycles and that of both halves of them without a warning, over the depth.
LARGEST_DIFFERENCE = 0.01


@dataclass(frozen=True)
class EnergyLaw:
    """Wear law of :func:`run`: the depth of a cycle by :func:`energy`, from the energy dissipated in each cell."""

    coefficient: ArrayLike
    """Volume removed per dissipated energy, a number or an array of shape (ny, nx). The unit is one over a pressure: 1/Pa in SI
    units, and 1 mm3/J is 1e-9 1/Pa. A negative coefficient raises ``NegativeOrNotFinite``, or ``Sample`` in an array."""

    def __post_init__(self) -> None:
        _check_numbers(self.coefficient)

    def __call__(self, history: History, cycle: Cycle) -> NDArray[Any]:
        return energy(self.coefficient, cycle.dissipation, grid=history.grid)


@dataclass(frozen=True)
class ArchardLaw:
    """Wear law of :func:`run`: the depth of a cycle by :func:`archard`, from slip pressure and slip distance."""

    coefficient: ArrayLike
    """Volume removed per normal force and slip distance, a number or an array of shape (ny, nx). The unit is one over a pressure:
    1/Pa in SI units, and 1 mm3/(N m) is 1e-9 1/Pa. A negative coefficient raises ``NegativeOrNotFinite``, or ``Sample`` in an
    array."""

    def __post_init__(self) -> None:
        _check_numbers(self.coefficient)

    def __call__(self, history: History, cycle: Cycle) -> NDArray[Any]:
        return archard(self.coefficient, cycle.slip_pressure, cycle.slip_distance, grid=history.grid)


@runtime_checkable
class JumpLaw(Protocol):
    """Wear law of :func:`run` whose depth depends on the energy that each cell dissipated before, such as
    :class:`ThresholdEnergyLaw`. A law of this kind is a class with one method."""

    def depth_of_jump(self, history: History, cycle: Cycle, dissipation: NDArray[Any], cycles: int) -> ArrayLike:
        """Returns the depth that the given number of cycles like ``cycle`` removes in each cell.

        The depth must not decrease with the number of cycles. :func:`run` calls the method with several numbers to find the
        longest jump. It issues a :class:`~stickslip.errors.ContactWarning` if the sum of the depths of both halves of the
        remaining cycles differs from the depth of all of them. A law that ignores ``dissipation`` has this warning if it is not proportional to the cycles.

        Parameters
        ----------
        history : History
            The history after the cycle.
        cycle : Cycle
            The computed cycle, which represents the following cycles.
        dissipation : ndarray of shape (ny, nx)
            Energy that each cell dissipated in the run before these cycles, including the cycles jumped over; read-only.
        cycles : int
            The number of cycles.

        Returns
        -------
        array_like of shape (ny, nx)
            Depths (lengths), not negative.
        """


@dataclass(frozen=True)
class ThresholdEnergyLaw:
    """Wear law of :func:`run` by :func:`threshold_energy`: the increase of ``coefficient * max(0, E / A - threshold)``, where E is
    the energy that a cell of area A dissipated since the start of the run, including the cycles jumped over.

    The depth of a jump is exact, also in cells that reach the threshold within the jump.

    Examples
    --------
    >>> import stickslip as ss
    >>> grid = ss.Grid.square(32, 0.3e-3)
    >>> steel = ss.Material(213e9, 0.29)
    >>> history = ss.History(ss.HalfSpace(grid, (steel, steel)), ss.surface.sphere(grid, 3.5e-3), 0.5)
    >>> step = history.step(normal_force=100.0)
    >>> path = ss.history.LoadPath.triangle((1e-6, 0.0), 8)
    >>> loop = ss.history.FrettingLoop(path, lambda shift: ss.LoadStep(normal_force=100.0, shift=shift))
    >>> law = ss.wear.ThresholdEnergyLaw(1e-13, threshold=1e5)  # no wear below 0.1 J/mm2
    >>> result = ss.wear.run(history, loop, law, 2000)
    >>> beyond = result.dissipation.max() / grid.cell_area - 1e5
    >>> bool(abs(result.depth.max() / (1e-13 * beyond) - 1.0) < 1e-9)
    True
    """

    coefficient: ArrayLike
    """Volume removed per dissipated energy beyond the threshold (one over a pressure, 1/Pa in SI units), a number or an array of
    shape (ny, nx)."""
    threshold: float
    """Energy per area up to which a cell does not wear (J/m2 in SI units), not negative."""

    def __post_init__(self) -> None:
        _check_numbers(self.coefficient, self.threshold)

    def depth_of_jump(self, history: History, cycle: Cycle, dissipation: NDArray[Any], cycles: int) -> NDArray[Any]:
        of_jump = cycles * cycle.dissipation
        return threshold_energy(self.coefficient, self.threshold, dissipation + of_jump, of_jump, grid=history.grid)


@dataclass(frozen=True)
class Limits:
    """Limits of a jump. ``cycles`` is limited by ``largest_jump``, and ``cycles_left`` is the rest of the run."""

    cycles: int
    cycles_left: int
    largest_depth: float | None
    max_depth: float | None
    max_residual: float


@dataclass(frozen=True)
class CycleWear:
    """Jumps by a law whose depth is proportional to the number of cycles."""

    law: Callable[[History, Cycle], ArrayLike]

    def jump(
        self, history: History, cycle: Cycle, depth: NDArray[Any], dissipation: NDArray[Any], limits: Limits
    ) -> tuple[int, NDArray[Any]]:
        """Returns the number of cycles of a jump and the depth that they remove."""
        of_cycle = _checked(self.law(history, cycle), history)
        left = min(limits.cycles, _until_depth(limits.max_depth, depth, of_cycle, limits.cycles))
        options = {"largest_depth": limits.largest_depth, "max_residual": limits.max_residual, "cycles_left": left}
        try:
            cycles = CycleJump(history.bodies, cycle, of_cycle, **options).cycles()
        except NoWholeCycle as error:
            raise _no_whole_cycle(error.cycles, of_cycle, limits.largest_depth) from None
        assert cycles is not None  # `cycles_left` is finite
        return cycles, cycles * of_cycle


class JumpWear:
    """Jumps by a law whose depth depends on the energy dissipated before."""

    def __init__(self, law: JumpLaw, history: History) -> None:
        self.law = law
        self.is_first = True
        # The depth per pressure of all cycles of a jump must not exceed the smallest compliance, as in `CycleJump`.
        self.compliance = 0.5 * max_stable_cycles(history.bodies, 1.0, np.ones(history.grid.shape))

    def jump(
        self, history: History, cycle: Cycle, depth: NDArray[Any], dissipation: NDArray[Any], limits: Limits
    ) -> tuple[int, NDArray[Any]]:
        """Returns the number of cycles of a jump and the depth that they remove."""

        def removed(cycles: int, before: NDArray[Any] = dissipation) -> NDArray[Any]:
            return _checked(self.law.depth_of_jump(history, cycle, read_only(before), cycles), history)

        # Rejects a cycle that is not closed, and a depth that is negative or not finite. No wear sets no other limit.
        first = removed(1)
        options = {"largest_depth": limits.largest_depth, "max_residual": limits.max_residual, "cycles_left": 0.0}
        CycleJump(history.bodies, cycle, first, **options).cycles()
        pressure = np.asarray(cycle.slip_pressure)
        slips = pressure > 0.0

        def allowed(cycles: int) -> float:
            """Returns the number of cycles that the wear at the end of a jump allows."""
            of_jump = removed(cycles)
            # Cells that wear at the end of the jump, also cells that reached a threshold within it.
            of_next = removed(cycles + 1) - of_jump
            if of_next.min() < -1e-12 * of_jump.max():
                raise ValueError("the depth of the wear law decreases with the number of cycles: it must not decrease")
            rate = (of_next[slips] / pressure[slips]).max(initial=0.0)
            allowed = self.compliance / rate if rate > 0.0 else np.inf
            deepest = of_jump.max()
            if limits.largest_depth is not None and deepest > limits.largest_depth:
                allowed = min(allowed, cycles * limits.largest_depth / deepest)
            return float(allowed)

        if allowed(1) < 1.0:
            raise _no_whole_cycle(allowed(1), first, limits.largest_depth)
        most = limits.cycles
        if limits.max_depth is not None and (depth + removed(most)).max() >= limits.max_depth:
            deepest = limits.max_depth
            most = 1 + _last(lambda cycles: bool((depth + removed(cycles)).max() < deepest), 0, most)
        cycles = _last(lambda cycles: allowed(cycles) >= cycles, 1, most + 1)
        if self.is_first and limits.cycles_left > 1:
            left, half = limits.cycles_left, limits.cycles_left // 2
            after_half = removed(left - half, dissipation + half * np.asarray(cycle.dissipation))
            warn(_remarks_on_halves(removed(left), removed(half) + after_half, left))
            self.is_first = False
        return cycles, removed(cycles)


def _no_whole_cycle(cycles: float, of_cycle: NDArray[Any], largest_depth: float | None) -> NoWholeCycle:
    """Returns the error of a cycle that removes more than a limit. ``cycles`` is the limit, a fraction of a cycle."""
    deepest = of_cycle.max()
    # The tolerance allows for round-off of the quotient.
    if largest_depth is not None and largest_depth <= cycles * deepest * (1.0 + 1e-9):
        error = NoWholeCycle(
            f"a cycle removes up to {deepest:.4g}, more than largest_depth, which is {largest_depth:.4g} ({cycles:.4g} cycles): "
            "give a larger largest_depth and check its unit, or reduce the wear coefficient"
        )
    else:
        error = NoWholeCycle(
            f"a cycle removes more than the limit, which is {cycles:g} cycles: "
            "reduce the wear coefficient, or wear the gap after each step of the cycle; "
            "check the unit of the coefficient (1 mm3/(N m) is 1e-9 1/Pa)"
        )
    error.cycles = cycles
    return error


def _remarks_on_halves(whole: NDArray[Any], halves: NDArray[Any], cycles: int) -> list[tuple[str, str]]:
    """Returns the remark that the sum of the depths of both halves differs from the depth of all remaining cycles."""
    with np.errstate(invalid="ignore"):
        most, difference = whole.max(), np.abs(whole - halves).max()
    if not np.isfinite(difference) or difference <= LARGEST_DIFFERENCE * most:
        return []
    return [
        (
            "inconsistent_law",
            f"the wear law removes up to {most:.3g} in {cycles} equal cycles, and the sum of the depths of both halves differs by "
            f"{difference:.3g}: take the earlier energy from the argument dissipation of depth_of_jump",
        )
    ]


def _last(is_valid: Callable[[int], bool], first: int, end: int) -> int:
    """Returns the last of the numbers from ``first`` to before ``end`` that is valid, if all valid numbers precede the others and
    the first is valid."""
    if first < end - 1 and is_valid(end - 1):
        return end - 1
    while end - first > 1:
        middle = (first + end) // 2
        first, end = (middle, end) if is_valid(middle) else (first, middle)
    return first


def _check_numbers(coefficient: ArrayLike, threshold: float = 0.0) -> None:
    """Raises the error of the laws for a coefficient or a threshold that is negative or not finite."""
    # The labels and the shape of an array are checked with the grid of the history, in the run.
    numbers = np.asanyarray(coefficient)
    shape = numbers.shape if numbers.ndim == 2 else (max(numbers.size, 1), 1)
    if shape[0] * shape[1] > 0:
        zeros = np.zeros(shape)
        given = numbers.reshape(shape) if numbers.ndim else coefficient
        threshold_energy(given, threshold, zeros, zeros, grid=Grid(shape[1], shape[0], 1.0, 1.0))


def _checked(given: ArrayLike, history: History) -> NDArray[Any]:
    """Returns the depth that a wear law returned, an array of the shape of the grid."""
    if isinstance(given, CellEnergies):
        raise TypeError(
            "the wear law must return depths, got energies of cells: return wear.energy(coefficient, cycle.dissipation), or divide "
            "by history.grid.cell_area"
        )
    # A field reads the axes of labelled arrays, and rejects a field on a different grid or in another unit than the gap.
    is_labelled = hasattr(given, "dims") or hasattr(given, "columns") or isinstance(given, Field)
    depth = np.asarray(Field(history.grid, given, history.unit) if is_labelled else given, dtype=float)
    shape = history.grid.shape
    if depth.shape != shape:
        found = f"an array of shape {depth.shape}"
        if depth.ndim == 0:
            found = "None" if given is None else f"the number {depth:g}"
        error = Shape(
            f"the wear law must return an array of shape (ny, nx) = {shape}, got {found}: return a depth for each cell, "
            "for example wear.energy(coefficient, cycle.dissipation, grid=history.grid)"
        )
        error.quantity, error.expected, error.found = "depth of the wear law", shape, depth.shape
        raise error
    return depth


def _until_depth(max_depth: float | None, depth: NDArray[Any], of_cycle: NDArray[Any], cycles: int) -> int:
    """Returns the number of cycles until a cell reaches the largest depth."""
    if max_depth is None or not (of_cycle > 0.0).any():
        return cycles
    worn = of_cycle > 0.0
    return int(min(cycles, np.ceil(((max_depth - depth[worn]) / of_cycle[worn]).min())))


def law_in_words(law: Callable[[History, Cycle], ArrayLike] | JumpLaw) -> str:
    if not isinstance(law, (EnergyLaw, ArchardLaw, ThresholdEnergyLaw)):
        named = law if hasattr(law, "__qualname__") else type(law)
        return f"{named.__module__}.{named.__qualname__}"
    coefficient = np.asarray(law.coefficient, dtype=float)
    text = repr(float(coefficient)) if coefficient.ndim == 0 else f"array of digest {digest(coefficient.tobytes())}"
    if isinstance(law, ThresholdEnergyLaw):
        text += f", threshold={float(law.threshold)!r}"
    return f"{type(law).__name__}(coefficient={text})"


def digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:16]
