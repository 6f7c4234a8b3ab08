"""Exceptions of the package: one for each reason why a call is rejected or fails, with the offending numbers as
attributes.

Arguments are checked before any work, and a failed call leaves the state of solvers and histories unchanged.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from . import Report


class StickslipError(Exception):
    """Base class of all exceptions of the package."""


class ContactWarning(UserWarning):
    """Category of the warnings about solutions and steps. ``warnings`` shows each kind once per location.

    The argument ``warn=False`` of a solve or a step suppresses them; ``warnings.simplefilter("ignore", ContactWarning)``
    hides all of them.

    A warning is issued after its solve or step. If ``warnings.simplefilter("error", ContactWarning)`` turns it into an
    exception, the step is therefore taken: do not repeat it.
    """

    kind: str = ""
    """Name of the kind, such as "contact_at_edge", equal to ``kind`` of the warning in ``solution.warnings``."""


class _Argument(StickslipError):
    """An argument cannot be converted."""

    def add_note(self, note: str, /) -> None:
        """Adds a note. The note with the name of the argument, which the conversion adds, becomes part of the message."""
        name = re.fullmatch(r"while processing '(\w+)'", note)
        if name is None:
            self.__dict__.setdefault("__notes__", []).append(note)
        elif not hasattr(self, "argument"):  # an exception about a part of the argument has its own name
            self.argument = name[1]
            self.args = (f"{name[1]} {self}",)


class ArgumentType(_Argument, TypeError):
    """An argument has a wrong type, such as text instead of a number, or a Field instead of a HalfSpace."""

    argument: str
    """Name of the argument."""


class ArgumentRange(_Argument, ValueError):
    """A number is out of range, or a name is not one of the names of a choice."""

    argument: str
    """Name of the argument."""


class Shape(StickslipError, ValueError):
    """An array does not have the shape of the grid."""

    quantity: str
    """The array, in words."""
    expected: tuple[int, int]
    """Required rows and columns, (ny, nx)."""
    found: tuple[int, ...]
    """The shape given."""


class GridSize(StickslipError, ValueError):
    """A grid needs at least one cell along each axis."""

    nx: int
    """Number of cells along x."""
    ny: int
    """Number of cells along y."""


class Memory(MemoryError, StickslipError):
    """Memory for a quantity cannot be allocated. Nothing was allocated."""

    quantity: str
    """The quantity that needs the memory, in words."""
    bytes: int
    """Number of bytes required."""


class NotPositive(StickslipError, ValueError):
    """A quantity that must be positive and finite is not."""

    quantity: str
    """The quantity, in words."""
    value: float
    """The value given."""


class NegativeOrNotFinite(StickslipError, ValueError):
    """A quantity that must be zero or positive, and finite, is not."""

    quantity: str
    """The quantity, in words."""
    value: float
    """The value given."""


class NotFinite(StickslipError, ValueError):
    """A quantity that must be finite is not."""

    quantity: str
    """The quantity, in words."""
    value: float
    """The value given."""


class ExtremeNumber(StickslipError, ValueError):
    """A number is so small or so large that its square exceeds the range of floating-point numbers, and no error could be
    certified."""

    quantity: str
    """The quantity, in words."""
    value: float
    """The value found."""
    least: float
    """The smallest value allowed."""
    most: float
    """The largest value allowed."""
    remedy: str
    """The remedy, in words."""


class Sample(StickslipError, ValueError):
    """A sample of a field violates a rule for that field."""

    quantity: str
    """The field, in words."""
    index: int
    """Index into the row-major samples, row * nx + column."""
    row: int | None
    """Row of the sample, the first index of an array of shape (ny, nx); ``None`` for samples outside a field."""
    column: int | None
    """Column of the sample, the second index."""
    value: float
    """The value of the sample."""
    rule: str
    """The rule, in words."""


class PoissonRatio(StickslipError, ValueError):
    """Poisson's ratio is outside (-1, 1/2], the range in which an isotropic body is stable."""

    value: float
    """The value given."""


class BothRigid(StickslipError, ValueError):
    """Both bodies are rigid. Neither deforms, so there is nothing to solve."""


class RigidBody(StickslipError, ValueError):
    """Stress or displacement of a rigid body was requested, which is undetermined."""

    body: str
    """The body, in words."""


class DivergentPeriodicSum(StickslipError, ValueError):
    """A sum over periodic images does not converge."""

    quantity: str
    """The sum, in words."""


class TooManyLayers(StickslipError, ValueError):
    """The number of layers exceeds the limit of a coated body."""

    found: int
    """Number of layers given."""
    limit: int
    """Number of layers allowed."""


class UnsupportedForCoatings(StickslipError, ValueError):
    """A quantity is modelled only for homogeneous bodies, and not for these coated bodies or this kernel."""

    quantity: str
    """The requested quantity, in words."""
    bodies: str
    """The bodies for which it is not modelled, in words."""
    remedy: str
    """The alternative, in words."""


class IncompleteKernel(StickslipError, ValueError):
    """A kernel or a part of it is not available."""

    part: str
    """The part, in words."""


class NotDefinite(StickslipError, ValueError):
    """The smallest eigenvalue of the compliance of coated bodies, or of a kernel, is not positive on the grid, and no
    error could be certified."""

    eigenvalue: float
    """The smallest eigenvalue (a length over a pressure)."""
    sides: tuple[float, float]
    """Sides of a cell (lengths)."""


class DatumTooNear(StickslipError, ValueError):
    """The datum makes the compliance indefinite: a prescribed approach, shift or spring has no unique solution."""

    datum: float
    """Distance of the datum (a length)."""
    least: float
    """Distance beyond which the compliance is definite (a length)."""


class CoupledMaterials(StickslipError, ValueError):
    """The materials couple pressure and traction, and the requested model does not include the effect of shear on the
    pressure. :class:`~stickslip.CoupledProblem` and :class:`~stickslip.History` with ``coupling="full"`` include it."""

    beta: float
    """Dundurs' second parameter of the pair."""


class CellsTooLong(StickslipError, ValueError):
    """The cells are so much longer than wide that the smallest eigenvalue of the compliance is round-off of the
    largest: no error could be certified.
    """

    sides: list[float]
    """Sides of a cell (lengths)."""


class Length(StickslipError, ValueError):
    """A slice, field or list has the wrong number of entries."""

    quantity: str
    """The slice or list, in words."""
    expected: int
    """Number of entries required."""
    found: int
    """Number of entries given."""


class GridMismatch(StickslipError, ValueError):
    """Two fields or bodies have different grids."""

    quantity: str
    """The field, in words."""
    expected_cells: list[int]
    """Numbers of cells along x and y of the expected grid."""
    expected_sides: list[float]
    """Cell sides of the expected grid (lengths)."""
    found_cells: list[int]
    """Numbers of cells along x and y of the field."""
    found_sides: list[float]
    """Cell sides of the field (lengths)."""


class BoundaryMismatch(StickslipError, ValueError):
    """A solution belongs to bodies with a different boundary."""

    quantity: str
    """The solution, in words."""


class CellValueMismatch(StickslipError, ValueError):
    """A solution belongs to bodies whose cell values have a different meaning."""

    quantity: str
    """The solution, in words."""


class Tolerance(StickslipError, ValueError):
    """The tolerance is outside ``(0, 1)`` and therefore meaningless."""

    value: float
    """The value given."""


class IterationLimit(StickslipError, ValueError):
    """The iteration limit is zero."""


class NoPressureToHold(StickslipError, ValueError):
    """A normal problem has no earlier pressure to hold; only a history has one."""


class Method(StickslipError, ValueError):
    """The method is not defined for the problem."""

    method: str
    """The requested method."""
    quantity: str
    """The problem that the method does not solve, in words."""


class Bounds(StickslipError, ValueError):
    """There is no finite value between the bounds of an entry."""

    index: int
    """Index of the entry."""
    lower: float
    """Lower bound of the entry."""
    upper: float
    """Upper bound of the entry."""


class Total(StickslipError, ValueError):
    """No point within the bounds has the prescribed total."""

    total: float
    """The prescribed total."""
    lower: float
    """The smallest total within the bounds."""
    upper: float
    """The largest total within the bounds."""


class RepeatedDirection(StickslipError, ValueError):
    """A direction occurs twice among the directions of one operator."""


class EmptyContact(StickslipError, ValueError):
    """The bodies do not touch: there is no contact to load tangentially."""


class BeyondFrictionCapacity(StickslipError, ValueError):
    """The tangential force exceeds what friction can carry: no equilibrium exists."""

    force: float
    """Magnitude of the requested force."""
    limit: float
    """Largest force that friction can carry, the area integral of the shear limit."""
    remedy: str
    """The loads that are possible instead, in words."""


class BeyondFrictionMoment(StickslipError, ValueError):
    """The moment about the normal is not between the limits for large spins of both signs at the prescribed creepages and
    forces."""

    moment: float
    """The requested moment."""
    limit: float
    """The end of the range that the moment reaches or exceeds."""
    range: list[float]
    """The smallest and the largest moment of a contact that slides as a whole."""


class BeyondHardness(StickslipError, ValueError):
    """The normal force exceeds the largest force that the cells can carry at their hardness."""

    force: float
    """Requested normal force."""
    capacity: float
    """Largest force that the cells can carry, the integral of the hardness."""


class Yielded(StickslipError, ValueError):
    """A quantity that is defined only for elastic contacts was requested for a contact with cells at their hardness."""

    quantity: str
    """The quantity, in words."""
    cells: int
    """Number of cells at their hardness."""


class ObliqueLoad(StickslipError, ValueError):
    """The load has components along both axes, which the scalar tangential model does not allow."""

    x: float
    """Component along x."""
    y: float
    """Component along y."""


class UnsupportedByModel(StickslipError, ValueError):
    """A model does not include this load, or this property of an operator."""

    model: str
    """The model, in words."""
    quantity: str
    """The load or the property, in words."""
    value: float
    """The value of the load or property. If it has no value, a related number that `quantity` names, or zero."""
    remedy: str
    """The options that add it to the model, or that there is no such option, in words."""


class MaterialMismatch(StickslipError, ValueError):
    """A solution or a saved history belongs to bodies of different materials."""

    quantity: str
    """The solution or the saved quantity, in words."""


class ApproachBeyondMeanGap(StickslipError, ValueError):
    """The approach is not less than the mean gap of a periodic contact. The surfaces would touch everywhere, and the
    pressure would be undetermined.
    """

    approach: float
    """The requested approach."""
    mean_gap: float
    """Mean of the initial gap."""


class TooManyCells(StickslipError, ValueError):
    """An explicit matrix of this size exceeds the limit."""

    cells: int
    """Requested number of cells."""
    limit: int
    """Number of cells allowed."""


class NotPositiveDefinite(StickslipError, ValueError):
    """A matrix is not symmetric positive definite."""

    row: int
    """The first row in which this is detected."""


class Undetermined(StickslipError, ValueError):
    """The known points do not determine the unknowns."""

    quantity: str
    """The unknown quantity, in words."""
    unknowns: int
    """Number of unknowns."""
    known: int
    """Number of known points."""


class Degree(StickslipError, ValueError):
    """The degree of a polynomial exceeds the limit."""

    degree: int
    """Requested degree."""
    limit: int
    """Largest degree allowed."""


class Range(StickslipError, ValueError):
    """A range of rows or columns is empty or extends beyond the grid."""

    quantity: str
    """The word "rows" or "columns"."""
    start: int
    """First index of the range."""
    end: int
    """First index after the range."""
    count: int
    """Number of rows or columns of the grid."""


class BeyondSamples(StickslipError, ValueError):
    """A grid extends beyond the samples from which it must be filled."""

    axis: str
    """The axis, x or y."""
    reach: float
    """Distance of the outermost cell centres from the middle."""
    limit: float
    """Distance of the edge of the grid of the samples from the middle."""


class Hurst(StickslipError, ValueError):
    """The Hurst exponent is outside ``[0, 1]``."""

    value: float
    """The value given."""


class BelowMinimum(StickslipError, ValueError):
    """A quantity is below its lower limit. A check of an upper limit reports the ratio of the permitted to the actual value,
    whose lower limit is 1."""

    quantity: str
    """The quantity, in words."""
    value: float
    """The value given."""
    least_is: str
    """The meaning of the lower limit, in words."""
    least: float
    """The lower limit."""


class GridTooShort(StickslipError, ValueError):
    """The grid ends less than one step of rolling ahead of the contact or behind it."""

    side: str
    """The side of the contact: "ahead of" or "behind"."""
    needed: int
    """Number of cells that a step requires on this side."""
    found: int
    """Number of cells of the grid on this side."""


class NoWaveInBand(StickslipError, ValueError):
    """No wave that is periodic on the surface has a wavelength within the requested band."""

    longest: float
    """Longest requested wavelength."""
    shortest: float
    """Shortest requested wavelength."""


class HeightMomentsNotReached(StickslipError):
    """No phases were found that give the heights the requested skewness and kurtosis."""

    skewness: float
    """Requested skewness."""
    kurtosis: float
    """Requested kurtosis."""
    reached: list[float]
    """Skewness and kurtosis at which the search ended."""


class File(StickslipError, OSError):
    """The operating system could not read or write a file."""

    path: str
    """The file."""
    problem: str
    """The message of the operating system."""
    errno: int | None = None
    """Error number of the operating system; see the module ``errno``."""
    strerror: str | None = None
    """Alias of ``problem``."""
    filename: str | None = None
    """Alias of ``path``."""


class Format(StickslipError, ValueError):
    """A file violates the rules of its format, or uses an unsupported part of it."""

    file: str | None
    """The file, if it was read from one."""
    format: str
    """The format, by its usual abbreviation."""
    place: str
    """Location in the file of the violation."""
    problem: str
    """The rule or the unsupported part, and the text or value found."""


class StepsPerCycle(StickslipError, ValueError):
    """The number of steps per cycle is not a positive multiple of 4, so no step would end at a turning point."""

    steps: int
    """The number given."""


class EmptyPath(StickslipError, ValueError):
    """A load path has no steps."""


class StepOutOfOrder(StickslipError, ValueError):
    """A cycle contains the steps of its history up to a certain step, and the added step is not the next one."""

    step: int
    """The number of the step, counted from 1; zero before the first step."""
    last: int
    """The number of the last step that the cycle contains or starts after."""


class NoLastStep(StickslipError, ValueError):
    """The result of the last step was requested, but no step led to the present state of the history.

    The history is new, or its state was set: make a step after ``set_state``, ``from_state`` or ``from_bytes``.
    """


class GapUnderLoad(StickslipError, ValueError):
    """A new gap of a solver or a history is the gap under load of the last solution, which contains the displacements.

    Add the wear to the gap before loading: the attribute ``gap`` of a solver, or ``gap_as_set`` of a history.
    """


class OutdatedSolution(StickslipError, ValueError):
    """A stiffness was requested after a change of the input, to which the last solution does not belong."""

    quantity: str
    """The requested quantity, in words."""
    changed: str
    """The changed input, in words."""
    remedy: str
    """The remedy, in words."""


class SnapshotMismatch(StickslipError, ValueError):
    """A run of wear resumes with another law, loop or history than the run of its snapshot."""

    argument: str
    """The quantity that differs: grid, boundary, pair, model, law, loop, coupling, friction, hardness, settings, entry_rule,
    permanent_set, relative_displacement or gap."""


class CycleNotClosed(StickslipError):
    """A cycle that does not close cannot represent the following cycles."""

    residual: float
    """The :attr:`~stickslip.history.Cycle.cyclic_residual` of the cycle."""
    limit: float
    """The largest residual allowed."""


class NoWholeCycle(StickslipError):
    """One cycle already removes more than the limit of :class:`~stickslip.wear.CycleJump`."""

    cycles: float
    """The limit, a fraction of a cycle."""


class StepTooLong(StickslipError):
    """A load was divided into the shortest steps allowed, and the error of one step still exceeds its tolerance."""

    part: float
    """Length of the step, as a fraction of the load."""
    error: float
    """The :attr:`~stickslip.history.StepErrorEstimate.traction` of the step."""
    tolerance: float
    """The tolerance of the whole load."""


class Ranks(StickslipError):
    """Ranks that solve one contact together cannot continue together."""

    rank: int | None
    """The rank, if a single rank is responsible."""


class NotConverged(StickslipError):
    """The iteration ended before it reached the tolerance."""

    report: Report
    """Report of the solve."""
    last_iterate: Any
    """The last iterate, feasible but not converged; ``None`` for a history, which remains in its state before the step.
    """


def __dir__() -> list[str]:
    public = (name for name in globals() if not name.startswith("_"))
    return [name for name in public if isinstance(item := globals()[name], type) and issubclass(item, Exception)]
