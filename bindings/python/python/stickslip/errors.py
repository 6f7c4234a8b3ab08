"""Every way a call can be refused or fail: one exception for each, with the offending numbers as attributes.

Arguments are checked before any work, and a failed call leaves the state of solvers and histories as it was.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from . import Report


class StickslipError(Exception):
    """What all exceptions of the package derive from."""


class ContactWarning(UserWarning):
    """The category of the remarks on solutions and steps, of which ``warnings`` shows each kind once a place.

    ``warn=False`` of a solve or a step passes none on; ``warnings.simplefilter("ignore", ContactWarning)`` shows none.
    """


class Shape(StickslipError, ValueError):
    """An array does not have the shape of the grid."""

    quantity: str
    """The array, in words."""
    expected: tuple[int, int]
    """Rows and columns needed, (ny, nx)."""
    found: tuple[int, ...]
    """The shape given."""


class GridSize(StickslipError, ValueError):
    """A grid needs at least one cell along each axis."""

    nx: int
    """Cells along x."""
    ny: int
    """Cells along y."""


class Memory(MemoryError, StickslipError):
    """Memory for a quantity cannot be allocated. Nothing was allocated."""

    quantity: str
    """The quantity that needs the memory, in words."""
    bytes: int
    """Bytes needed."""


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
    """A number is so small or so large that squares of it leave the range of numbers, and no error could be certified."""

    quantity: str
    """The quantity, in words."""
    value: float
    """The value found."""
    least: float
    """The least value allowed."""
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
    """Its row, the first index of an array of shape (ny, nx); ``None`` of samples that are no field."""
    column: int | None
    """Its column, the second index."""
    value: float
    """The value found there."""
    rule: str
    """The rule, in words."""


class PoissonRatio(StickslipError, ValueError):
    """Poisson's ratio lies outside (-1, 1/2], the range in which an isotropic body is stable."""

    value: float
    """The value given."""


class BothRigid(StickslipError, ValueError):
    """Both bodies are rigid. Neither deforms, so there is nothing to solve."""


class RigidBody(StickslipError, ValueError):
    """Stress or displacement of a body that is rigid: nothing determines them."""

    body: str
    """The body, in words."""


class DivergentPeriodicSum(StickslipError, ValueError):
    """A sum over images that does not converge."""

    quantity: str
    """The sum, in words."""


class TooManyLayers(StickslipError, ValueError):
    """More layers than a coated body may have."""

    found: int
    """Layers given."""
    limit: int
    """Layers allowed."""


class UnsupportedForCoatings(StickslipError, ValueError):
    """A quantity is modelled for homogeneous bodies only, and not for these coated bodies or this kernel."""

    quantity: str
    """The requested quantity, in words."""
    bodies: str
    """The bodies for which it is not modelled, in words."""
    remedy: str
    """The way round it, in words."""


class IncompleteKernel(StickslipError, ValueError):
    """A kernel, or a part of it, is not at hand."""

    part: str
    """The part, in words."""


class NotDefinite(StickslipError, ValueError):
    """The least eigenvalue of the compliance of coated bodies, or of a kernel, is not positive on the grid: nothing could be certified."""

    eigenvalue: float
    """The least eigenvalue (a length over a pressure)."""
    sides: tuple[float, float]
    """Sides of a cell (lengths)."""


class DatumTooNear(StickslipError, ValueError):
    """A datum that makes the compliance indefinite: a prescribed approach, shift or spring has no unique solution."""

    datum: float
    """Distance of the datum (a length)."""
    least: float
    """Distance beyond which the compliance is definite (a length)."""


class CoupledMaterials(StickslipError, ValueError):
    """The materials couple pressure and traction, and what was asked for does not model how shear changes the pressure."""

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
    """Entries needed."""
    found: int
    """Entries given."""


class GridMismatch(StickslipError, ValueError):
    """Two fields or bodies live on different grids."""

    quantity: str
    """The field, in words."""
    expected_cells: list[int]
    """Cells along x and y of the expected grid."""
    expected_sides: list[float]
    """Cell sides of the expected grid (lengths)."""
    found_cells: list[int]
    """Cells along x and y of the field."""
    found_sides: list[float]
    """Cell sides of the field (lengths)."""


class BoundaryMismatch(StickslipError, ValueError):
    """A solution belongs to bodies with a different boundary."""

    quantity: str
    """The solution, in words."""


class CellValueMismatch(StickslipError, ValueError):
    """A solution belongs to bodies whose cells have values of another meaning."""

    quantity: str
    """The solution, in words."""


class Tolerance(StickslipError, ValueError):
    """The tolerance lies outside ``(0, 1)``, where it is meaningless."""

    value: float
    """The value given."""


class IterationLimit(StickslipError, ValueError):
    """The iteration limit is zero."""


class NoPressureToHold(StickslipError, ValueError):
    """A normal problem that is to hold its pressure: it has none yet."""


class Method(StickslipError, ValueError):
    """The method is not defined for the problem."""

    method: str
    """The method asked for."""
    quantity: str
    """What it does not solve, in words."""


class Bounds(StickslipError, ValueError):
    """No finite value lies between the bounds of an entry."""

    index: int
    """The entry."""
    lower: float
    """Its lower bound."""
    upper: float
    """Its upper bound."""


class Total(StickslipError, ValueError):
    """No point within the bounds has the prescribed total."""

    total: float
    """The total prescribed."""
    lower: float
    """The least total within the bounds."""
    upper: float
    """The greatest total within the bounds."""


class RepeatedDirection(StickslipError, ValueError):
    """A direction occurs twice among those of one operator."""


class EmptyContact(StickslipError, ValueError):
    """The bodies do not touch: there is no contact to load tangentially."""


class BeyondFrictionCapacity(StickslipError, ValueError):
    """The tangential force exceeds what friction can carry: no equilibrium exists."""

    force: float
    """Magnitude of the force requested."""
    limit: float
    """Largest force that friction can carry, the area integral of the shear limit."""
    remedy: str
    """The loads that are possible instead, in words."""


class BeyondFrictionMoment(StickslipError, ValueError):
    """The moment about the normal is not between the moments that large spins of both signs cause, next to the
    prescribed creepages and forces."""

    moment: float
    """The moment requested, positive in the direction of the limit."""
    limit: float
    """The moment of a contact that slides as a whole, in the same direction."""
    range: list[float]
    """The least and the greatest moment of a contact that slides as a whole."""


class BeyondHardness(StickslipError, ValueError):
    """The normal force exceeds what the hardness lets the cells carry."""

    force: float
    """Normal force requested."""
    capacity: float
    """Largest force that the cells carry, the integral of the hardness."""


class Yielded(StickslipError, ValueError):
    """A quantity that only elastic contacts have was asked of one in which cells are at their hardness."""

    quantity: str
    """The quantity, in words."""
    cells: int
    """Cells at their hardness."""


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
    """The value given."""
    remedy: str
    """The options that add it to the model, or that there is no such option, in words."""


class MaterialMismatch(StickslipError, ValueError):
    """A solution or a saved history belongs to bodies of different materials."""

    quantity: str
    """The solution or the saved quantity, in words."""


class ApproachBeyondMeanGap(StickslipError, ValueError):
    """The approach is not below the mean gap of a periodic contact: the surfaces then touch everywhere, and the
    pressure is undetermined.
    """

    approach: float
    """The approach requested."""
    mean_gap: float
    """Mean of the initial gap."""


class TooManyCells(StickslipError, ValueError):
    """An explicit matrix of this size exceeds the limit."""

    cells: int
    """Cells requested."""
    limit: int
    """Cells allowed."""


class NotPositiveDefinite(StickslipError, ValueError):
    """A matrix is not symmetric positive definite."""

    row: int
    """The first row that shows it."""


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
    """Degree requested."""
    limit: int
    """Degree allowed."""


class Range(StickslipError, ValueError):
    """A range of rows or columns is empty or extends beyond the grid."""

    quantity: str
    """Rows or columns."""
    start: int
    """First of the range."""
    end: int
    """First after the range."""
    count: int
    """Number in the grid."""


class BeyondSamples(StickslipError, ValueError):
    """A grid extends beyond the samples it is to be filled from."""

    axis: str
    """The axis, x or y."""
    reach: float
    """Distance of the outermost cell centres from the middle."""
    limit: float
    """Distance of the edge of the samples' grid from the middle."""


class Hurst(StickslipError, ValueError):
    """The Hurst exponent lies outside ``[0, 1]``."""

    value: float
    """The value given."""


class BelowMinimum(StickslipError, ValueError):
    """A quantity is below its lower limit."""

    quantity: str
    """The quantity, in words."""
    value: float
    """The value given."""
    least_is: str
    """The meaning of the lower limit, in words."""
    least: float
    """The lower limit."""


class GridTooShort(StickslipError, ValueError):
    """The grid ends too near the contact for a rolled step."""

    side: str
    """The side of the contact: "ahead of" or "behind"."""
    needed: int
    """Cells that a step needs there."""
    found: int
    """Cells that the grid has there."""


class NoWaveInBand(StickslipError, ValueError):
    """No wave that is periodic on the surface has a wavelength within the requested band."""

    longest: float
    """Longest wavelength requested."""
    shortest: float
    """Shortest wavelength requested."""


class HeightMomentsNotReached(StickslipError):
    """No phases were found that give the heights the requested skewness and kurtosis."""

    skewness: float
    """Skewness requested."""
    kurtosis: float
    """Kurtosis requested."""
    reached: list[float]
    """Skewness and kurtosis at which the search ended."""


class File(StickslipError, OSError):
    """The operating system could not read or write a file."""

    path: str
    """The file."""
    problem: str
    """The message of the operating system."""
    errno: int | None = None
    """Its number of the error, as of the module ``errno``."""
    strerror: str | None = None
    """The same as ``problem``."""
    filename: str | None = None
    """The same as ``path``."""


class Format(StickslipError, ValueError):
    """A file violates the rules of its format, or uses an unsupported part of it."""

    file: str | None
    """The file, if it was read from one."""
    format: str
    """The format, by its usual abbreviation."""
    place: str
    """Where the file violates the rule."""
    problem: str
    """The rule or the unsupported part, with what was found."""


class StepsPerCycle(StickslipError, ValueError):
    """The number of steps per cycle is not a positive multiple of 4, so no step would end at a turning point."""

    steps: int
    """The number given."""


class EmptyPath(StickslipError, ValueError):
    """A load path has no steps."""


class StepAlreadyCounted(StickslipError, ValueError):
    """A cycle already holds the steps of its history up to some step, and this step does not come after it."""

    step: int
    """The number of the step, counted from 1; zero before the first step."""
    last: int
    """The number of the last step that the cycle holds or begins after."""


class CycleNotClosed(StickslipError):
    """A cycle that does not close was to stand for those that follow."""

    residual: float
    """Cycle::cyclic_residual."""
    limit: float
    """The largest one allowed."""


class StepTooLong(StickslipError):
    """A load was cut into the shortest steps allowed, and the error of one is still beyond its tolerance."""

    part: float
    """Length of the step, as a part of the load."""
    error: float
    """StepErrorEstimate::traction of the step."""
    tolerance: float
    """The tolerance of the whole load."""


class Ranks(StickslipError):
    """Ranks that solve together cannot go on together."""

    rank: int | None
    """The rank, if it is one."""


class NotConverged(StickslipError):
    """The iteration ended before it reached the tolerance."""

    report: Report
    """How the solve ended."""
    last_iterate: Any
    """The solution as the solve left it, feasible but not converged; ``None`` of a history, which remains as it was
    before the step.
    """


def __dir__() -> list[str]:
    return [name for name, item in globals().items() if isinstance(item, type) and issubclass(item, Exception)]
