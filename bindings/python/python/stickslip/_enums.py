"""Enumerations. Each member is a string, and wherever one is taken its name is too."""

from enum import Enum, IntEnum


class _Name(str, Enum):
    def __str__(self) -> str:
        return str(self.value)


class Axis(_Name):
    """An axis of the plane."""

    X = "x"
    Y = "y"


class TangentialModel(_Name):
    """Which tractions are found: along the axis of the load ("scalar"), or along x and y in every cell ("vector").

    Where pressure and traction are found together, both are, whatever the model.
    """

    SCALAR = "scalar"
    VECTOR = "vector"


class Coupling(_Name):
    """How much is modelled of the coupling between pressure and traction in bodies of different materials.

    "full": both are found together. "one_way": pressure moves the surfaces tangentially, shear does not change the
    pressure (Goodman). "neglected": neither moves the other. Of bodies that are not coupled, such as equal materials, all
    three are the same. Stick ratios depend on the choice, and on whether the load comes in one step or in many.

    A history has "full" by default. A tangential problem, whose pressure is given, has "one_way" and refuses "full"; a coupled
    problem is always "full".
    """

    FULL = "full"
    ONE_WAY = "one_way"
    NEGLECTED = "neglected"


class CellValue(_Name):
    """The meaning of the pressure and the traction of a cell.

    "uniform": uniform over the cell, as in the paper. "centre": the value at its centre, of a traction that is smooth between
    the centres; the influence coefficients have the smoothing of uniform cells taken off, and pressures inside a contact are
    right to a fraction of the error, at no cost. On a grid that repeats along x and y values are those at the centres.
    """

    UNIFORM = "uniform"
    CENTRE = "centre"


class EntryRule(_Name):
    """How far a cell that comes into contact within a step follows the motion of the step.

    "since_touch": from the moment it touches, so that a step may press and shear at once.
    "whole_step": all of it, as in codes that know the start of the step only.
    """

    SINCE_TOUCH = "since_touch"
    WHOLE_STEP = "whole_step"


class LeadingEdge(_Name):
    """Where particles enter a contact that rolls: at the largest or the smallest x or y."""

    PLUS_X = "plus_x"
    MINUS_X = "minus_x"
    PLUS_Y = "plus_y"
    MINUS_Y = "minus_y"

    @property
    def axis(self) -> Axis:
        """The axis that particles move along."""
        return Axis(self.value[-1])


class Method(_Name):
    """The iteration that finds the constrained minimum: active sets by preconditioned conjugate gradients, or the single
    loop of Polonsky and Keer, which solves for pressure or for one traction."""

    ACTIVE_SET = "active_set"
    POLONSKY_KEER = "polonsky_keer"


class Status(_Name):
    """Why an iteration ended; "stalled": the residual no longer falls, mostly because the tolerance is below round-off."""

    UNSOLVED = "unsolved"
    CONVERGED = "converged"
    ITERATION_LIMIT = "iteration_limit"
    TIME_LIMIT = "time_limit"
    STALLED = "stalled"
    CANCELLED = "cancelled"


class EigenvalueBound(_Name):
    """How the smallest eigenvalue of an operator is known, on which a certified error rests.

    "proven": by a bound from below, computed for the operators of this package and stated by your own. "estimated": by an
    estimate on the safe side, of stiff coatings on long grids. "unknown": not at all; the bound of the error, the root of the
    duality gap of the problem, then falls only with the root of the residual.
    """

    UNKNOWN = "unknown"
    ESTIMATED = "estimated"
    PROVEN = "proven"


class Regime(_Name):
    """The regime of a cycle."""

    FULL_STICK = "full_stick"
    PARTIAL_SLIP = "partial_slip"
    GROSS_SLIP = "gross_slip"


class StopReason(_Name):
    """Why a fretting loop ended."""

    STEADY = "steady"
    CYCLE_LIMIT = "cycle_limit"
    STOPPED = "stopped"


class Body(_Name):
    """One of the two bodies; z points into body one."""

    ONE = "one"
    TWO = "two"


class Amplitudes(_Name):
    """Amplitudes of the waves of a rough surface: those of the spectrum, or scattered about them."""

    EXACT = "exact"
    GAUSSIAN = "gaussian"


class Direction(_Name):
    """A direction of a displacement or a traction."""

    X = "x"
    Y = "y"
    Z = "z"


class Component(_Name):
    """A component of the influence tensor: displacement first, traction second."""

    XX = "xx"
    XY = "xy"
    XZ = "xz"
    YX = "yx"
    YY = "yy"
    YZ = "yz"
    ZX = "zx"
    ZY = "zy"
    ZZ = "zz"


class Zone(IntEnum):
    """What a cell does; the numbers of the arrays of zones."""

    SEPARATED = 0
    STICK = 1
    SLIP = 2
