"""Enumerations. Each member is a string, and every argument that accepts a member also accepts its name. A comparison with an unknown
string raises a ``ValueError``."""

from __future__ import annotations

from enum import Enum, IntEnum
from typing import Any

import numpy as np


class _Name(str, Enum):
    def __str__(self) -> str:
        return str(self.value)

    def __eq__(self, other: object) -> bool:
        names = [str(member) for member in type(self)]
        if isinstance(other, str) and not isinstance(other, Enum) and other not in names:
            raise ValueError(f"{str(other)!r} is not a name of {type(self).__name__}: use {', '.join(map(repr, names))}")
        return str.__eq__(self, other)

    def __ne__(self, other: object) -> bool:
        return not self == other

    __hash__ = str.__hash__


class Axis(_Name):
    """Axis of the plane."""

    X = "x"
    Y = "y"


class TangentialModel(_Name):
    """Tractions of the model: along the axis of the load ("scalar"), or along x and y in every cell ("vector").

    If pressure and traction are solved simultaneously, both components are computed, regardless of the model.
    """

    SCALAR = "scalar"
    VECTOR = "vector"


class Coupling(_Name):
    """Model of the coupling between pressure and traction in bodies of different materials.

    "full": both are solved simultaneously. "one_way": pressure displaces the surfaces tangentially, but shear does not
    change the pressure (Goodman). "neglected": neither affects the other. All three are equivalent for bodies that are
    not coupled, such as bodies of the same material. Stick ratios depend on the choice, and on whether the load is
    applied in one step or in many.

    The default of a history is "full". The default of a tangential problem, whose pressure is given, is "one_way". There,
    "full" raises ``CoupledMaterials`` for coupled bodies. A coupled problem always uses "full".
    """

    FULL = "full"
    ONE_WAY = "one_way"
    NEGLECTED = "neglected"


class CellValue(_Name):
    """Meaning of the pressure and the traction of a cell.

    "uniform": uniform over the cell, as in the paper. "centre": the value, at the centre of the cell, of a traction that
    is smooth between the centres. For "centre", the smoothing by uniform cells is removed from the influence
    coefficients. On a sphere of one material with 128 x 128 cells, the error of the pressure inside the contact is then a
    sixth of the error of uniform cells. The gain decreases with Dundurs' beta, and for a beta of 0.5 or more the tractions
    of the cells become less accurate. The cost of a product does not change. On a grid that is periodic along x and y, the
    values are always values at the centres.
    """

    UNIFORM = "uniform"
    CENTRE = "centre"


class EntryRule(_Name):
    """Part of the motion of a step that a cell follows if it comes into contact within the step.

    "since_touch": the motion since the cell touched, so that a step may press and shear simultaneously. "whole_step": the
    whole motion, as in codes that use only the state at the start of the step, such as CONTACT. The error of "whole_step"
    is of first order in the length of the steps in which the contact grows.
    """

    SINCE_TOUCH = "since_touch"
    WHOLE_STEP = "whole_step"


class LeadingEdge(_Name):
    """Edge where particles enter a rolling contact: at the largest or the smallest x or y."""

    PLUS_X = "plus_x"
    MINUS_X = "minus_x"
    PLUS_Y = "plus_y"
    MINUS_Y = "minus_y"

    @property
    def axis(self) -> Axis:
        """Axis along which the particles move."""
        return Axis(self.value[-1])


class Method(_Name):
    """Iteration for the constrained minimum: active sets with preconditioned conjugate gradients, or the single loop of
    Polonsky and Keer, which solves for the pressure or for one traction component."""

    ACTIVE_SET = "active_set"
    POLONSKY_KEER = "polonsky_keer"


class Status(_Name):
    """Reason for the end of an iteration. "stalled" means that the residual no longer decreases, usually because the
    tolerance is below round-off."""

    UNSOLVED = "unsolved"
    CONVERGED = "converged"
    ITERATION_LIMIT = "iteration_limit"
    TIME_LIMIT = "time_limit"
    STALLED = "stalled"
    CANCELLED = "cancelled"


class EigenvalueBound(_Name):
    """Origin of the bound on the smallest eigenvalue of an operator, on which the certified error depends.

    "proven": a lower bound, computed for the operators of this package. "stated": the lower bound that the caller gives
    with a user-defined operator, which is not checked.
    "estimated": an estimate on the safe side, for stiff coatings on long grids. "unknown": no bound is available. The
    error bound, the square root of the duality gap of the problem, then decreases only with the square root of the
    residual.
    """

    UNKNOWN = "unknown"
    ESTIMATED = "estimated"
    STATED = "stated"
    PROVEN = "proven"


class Regime(_Name):
    """Regime of a cycle.

    "full_stick": no cell slipped. "partial_slip": some cells slipped, and some cells stuck at the end of each step.
    "gross_slip": the whole contact was at its friction limit at the end of a step.
    """

    FULL_STICK = "full_stick"
    PARTIAL_SLIP = "partial_slip"
    GROSS_SLIP = "gross_slip"


class StopReason(_Name):
    """Reason for the end of a fretting loop."""

    STEADY = "steady"
    CYCLE_LIMIT = "cycle_limit"
    STOPPED = "stopped"


class WearEnding(_Name):
    """Reason for the end of :func:`stickslip.wear.run`."""

    CYCLE_LIMIT = "cycle_limit"
    DEPTH = "depth"
    STOPPED = "stopped"


class Body(_Name):
    """One of the two bodies; z points into body one."""

    ONE = "one"
    TWO = "two"


class Amplitudes(_Name):
    """Amplitudes of the waves of a rough surface: equal to the spectrum, or scattered about it."""

    EXACT = "exact"
    GAUSSIAN = "gaussian"


class Interpolation(_Name):
    """Interpolation between the samples of a surface: the cubic through the four nearest samples along each axis, or the
    line between the two nearest samples. The values of "linear" lie between the samples."""

    CUBIC = "cubic"
    LINEAR = "linear"


class Quantity(_Name):
    """Quantity whose error can be prescribed.

    "pressure": the error is the integral of the absolute error divided by the force. "area": contact area; the error is
    relative. "approach": approach from the first touch; the error is relative. "force": normal force under a prescribed
    approach; the error is relative. "traction": magnitude of the traction; the error is the integral of the absolute error
    divided by the integral of the traction. "stick_ratio": ratio of stick area to contact area; the error is absolute.
    "shift": the tangential rigid motion; the error is relative.
    """

    PRESSURE = "pressure"
    AREA = "area"
    APPROACH = "approach"
    FORCE = "force"
    TRACTION = "traction"
    STICK_RATIO = "stick_ratio"
    SHIFT = "shift"


class AdaptiveStatus(_Name):
    """Reason why the refinement of the grid ended.

    "reached": all estimates are at most their targets. "cell_limit": the next grid would exceed the limit of the cells.
    "time_limit": the time limit passed. "sample_spacing": the cells are as small as the distance between the samples of
    the gap. "cancelled": the observer cancelled, which is not possible in Python.
    """

    REACHED = "reached"
    CELL_LIMIT = "cell_limit"
    TIME_LIMIT = "time_limit"
    SAMPLE_SPACING = "sample_spacing"
    CANCELLED = "cancelled"


class Direction(_Name):
    """Direction of a displacement or a traction."""

    X = "x"
    Y = "y"
    Z = "z"


class Component(_Name):
    """Component of the influence tensor: direction of the displacement first, direction of the traction second."""

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
    """State of a cell. The members are the numbers in the arrays of zones, and are equal to their names, as in
    ``zones[iy, ix] == "stick"``. Other names raise a ``ValueError``."""

    SEPARATED = 0
    STICK = 1
    SLIP = 2

    @classmethod
    def _missing_(cls, value: object) -> Zone | None:
        found = next((zone for zone in cls if zone.name.lower() == value), None)
        if found is None and isinstance(value, str):
            raise ValueError(f"{value!r} is not a zone: use 'separated', 'stick' or 'slip'")
        return found

    def __eq__(self, other: object) -> bool:
        return self is _zone(other) if isinstance(other, str) else int(self) == other

    def __ne__(self, other: object) -> bool:
        return not self == other

    __hash__ = IntEnum.__hash__


def _zone(value: Any) -> Zone:
    """Returns the zone with a number or a name."""
    return Zone(value)


class Zones(np.ndarray[Any, np.dtype[np.uint8]]):
    """Array of zones. NumPy alone would find a number unequal to every name.

    Functions that combine or select entries, such as ``numpy.concatenate`` and ``numpy.where``, return zones. Results of
    ``numpy.array`` and of computations are plain arrays of numbers, which are unequal to every name.
    """

    def __eq__(self, other: Any) -> Any:
        return np.asarray(self) == _numbers(other)

    def __ne__(self, other: Any) -> Any:
        return np.asarray(self) != _numbers(other)

    def __getitem__(self, index: Any) -> Any:
        entry = super().__getitem__(index)
        return _zone(entry) if isinstance(entry, np.uint8) else entry

    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any:
        # The results of NumPy functions are not zones.
        return np.asarray(array)[()]

    def __array_function__(self, function: Any, types: Any, arguments: Any, options: Any) -> Any:
        result = super().__array_function__(function, types, arguments, options)
        if function.__name__ in _COMBINING and type(result) is np.ndarray and result.dtype == np.uint8:
            return result.view(Zones)
        return result


# Functions of NumPy whose results contain entries of their arguments, but not the class.
_COMBINING = {
    "append", "block", "broadcast_to", "choose", "column_stack", "concatenate", "copy", "delete", "dstack", "hstack", "insert",
    "pad", "resize", "select", "stack", "unique", "vstack", "where",
}  # fmt: skip


def _numbers(names: Any) -> Any:
    """Returns the numbers of names of zones; other objects are returned unchanged."""
    given = np.asarray(names)
    if given.dtype.kind not in "SU":
        return names
    return np.reshape([int(_zone(str(name))) for name in given.flat], given.shape)
