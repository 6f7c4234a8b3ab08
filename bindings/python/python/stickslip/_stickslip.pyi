# Written by stubs.py from the hints of the module.
"""
What the package ``stickslip`` is made of; import that.
"""
from collections.abc import Iterator, Sequence
from typing import Any, Final, final

from numpy import bool_, float64, uint8, uint32, uint64
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "AdaptiveSteps",
    "BentallJohnson",
    "Boundary",
    "Carter",
    "CattaneoMindlin",
    "CattaneoMindlinEllipse",
    "CattaneoMindlinLine",
    "Cone",
    "ConePartialSlip",
    "ContactSpots",
    "ContactStiffness",
    "Convolution",
    "CoupledProblem",
    "CoupledReport",
    "CoupledRollingProblem",
    "CoupledRollingReport",
    "CoupledRollingSolution",
    "CoupledRollingSolver",
    "CoupledSolution",
    "CoupledSolver",
    "CreepForce",
    "CreepForces",
    "Cycle",
    "CycleJump",
    "DenseMinimum",
    "DenseOperator",
    "Edges",
    "ElasticPair",
    "EnergyBalance",
    "ErrorEstimate",
    "Field",
    "Filled",
    "Filtered",
    "FlatPunch",
    "Friction",
    "Grid",
    "HalfSpace",
    "Hardness",
    "HertzEllipse",
    "HertzLine",
    "HertzSphere",
    "History",
    "Iteration",
    "JaegerSuperposition",
    "KalkerCoefficients",
    "Kernel",
    "Layer",
    "Levelled",
    "LinearOperator",
    "LoadPath",
    "LoadStep",
    "LoopPoint",
    "LoopPoints",
    "LubkinTorsion",
    "Material",
    "MindlinDeresiewicz",
    "MindlinFullStick",
    "Minimum",
    "NoSlipPunch",
    "NoSlipSphere",
    "NormalProblem",
    "NormalSolution",
    "NormalSolver",
    "NormalStiffness",
    "Persson",
    "Plane",
    "Planes",
    "PopovLimitingShape",
    "PowerSpectrum",
    "Principal",
    "Rectangle",
    "RelativeDisplacement",
    "Report",
    "PointResult",
    "PointResults",
    "Rolling",
    "RollingProblem",
    "RollingSolution",
    "RollingSolver",
    "RoughSphere",
    "RoughSurface",
    "RoundedPunch",
    "SelfAffine",
    "PvdWriter",
    "Settings",
    "SpencePressing",
    "Spot",
    "State",
    "Statistics",
    "StepErrorEstimate",
    "StepResult",
    "Stress",
    "Table",
    "TangentialEdges",
    "TangentialLoad",
    "TangentialProblem",
    "TangentialSolution",
    "TangentialSolver",
    "TangentialStiffness",
    "Tensor",
    "TensorOperator",
    "VermeulenJohnson",
    "Warning",
    "WaveResponse",
    "Westergaard",
    "WestergaardPartialSlip",
    "__version__",
    "_from_bytes",
    "_restore",
    "archard",
    "asc_parse",
    "asc_read",
    "at_points",
    "bisinusoidal",
    "cone",
    "crop",
    "csv_parse",
    "csv_read",
    "csv_to_bytes",
    "csv_write",
    "cylinder",
    "ellipsoid",
    "energy",
    "fill_missing",
    "flat_punch",
    "gap_between",
    "gap_from_heights",
    "gaussian_filter",
    "identity",
    "inverted",
    "level",
    "linear_stick_ratio",
    "max_stable_cycles",
    "minimise",
    "mirror_x",
    "npy_grid",
    "npy_parse",
    "npy_read",
    "npy_to_bytes",
    "npy_write",
    "num_threads",
    "paraboloid",
    "read",
    "resample",
    "sdf_parse",
    "sdf_read",
    "sdf_to_bytes",
    "sdf_write",
    "set_num_threads",
    "sinusoidal",
    "sphere",
    "sum",
    "sur_parse",
    "sur_read",
    "threshold_energy",
    "vti_to_bytes",
    "vti_write",
    "x3p_parse",
    "x3p_read",
    "xyz_parse",
    "xyz_read",
]

from os import PathLike
from stickslip._enums import Amplitudes, Axis, Body, CellValue, Component, Coupling, EigenvalueBound, LeadingEdge, Method, Regime, Status, TangentialModel, EntryRule
from typing_extensions import disjoint_base

__version__: Final[str]
"""
The version of the package.
"""

@final
class AdaptiveSteps:
    """
    Takes a load in steps short enough for a tolerance, and tells the error of a step. Its buffers take the memory of four
    states.

    Parameters
    ----------
    history : History
        For histories on the grid of this one.
    tolerance : float
        Of :attr:`StepErrorEstimate.traction` for a whole load, in (0, 1); at least about a hundred times the tolerance of the history's
        settings.

    Raises
    ------
    Tolerance
    """
    def __new__(cls, /, history: History, tolerance: float) -> AdaptiveSteps: ...
    def __repr__(self, /) -> str: ...
    def error(self, /, history: History, load: LoadStep) -> StepErrorEstimate:
        """
        The error that a single step makes with this load; the history is then as it was, but for its last step.
        """
    def step(self, /, history: History, load: LoadStep, *, cycle: Cycle | None = None, warn: bool = True) -> int:
        """
        Takes a load, in as many steps as it needs, and returns how many. Ctrl-C ends it after the part under way; the
        history is then as it was, but for its last step.

        Parameters
        ----------
        history : History
            The history that takes the load.
        load : LoadStep
            What is prescribed at its end, reached in proportion.
        cycle : Cycle, optional
            To which each step is added.
        warn : bool, default True
            Whether the remarks on the last step go to ``warnings`` too, each kind once a place.

        Raises
        ------
        GridMismatch, StepTooLong
            And what :meth:`History.step` raises.
        """

@final
class BentallJohnson:
    """
    Cylinders of different materials that roll freely, without a tangential force and with little friction: the limit of
    Bentall and Johnson's solution for a friction much less than Dundurs' beta.

    The pressure stretches the surfaces by different amounts: body 1 slips over body 2, for each length rolled, by
    s = 2 beta p / E* - xi, and the traction is mu p against the slip. Between bodies of which beta is zero nothing
    slips. The leading edge is at +x; with that at -x creepage and slip change their signs. Bentall and Johnson (1967);
    Johnson (1985), section 8.2.

    Parameters
    ----------
    hertz : HertzLine
        The normal contact.
    friction : float
        Coefficient of friction mu (dimensionless), not negative.

    Raises
    ------
    NegativeOrNotFinite, NotFinite
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, hertz: HertzLine, friction: float) -> BentallJohnson: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def creepage(self, /) -> float:
        """
        Creepage xi (dimensionless), 0.9148 beta a/R.
        """
    @property
    def dissipation(self, /) -> float:
        """
        Energy that slip dissipates for each length rolled (a force per length), 0.1239 mu |beta| P a/R: what keeps the
        cylinders rolling.
        """
    @property
    def reversal(self, /) -> float:
        """
        Half-width of the middle strip (a length), at whose ends the slip reverses: 0.4040 a.
        """
    def slip(self, /, x: ArrayLike) -> Any:
        """
        Slip of body 1 over body 2 at x, for each length rolled (dimensionless); zero outside the contact.
        """
    def traction(self, /, x: ArrayLike) -> Any:
        """
        Traction on body 1 along x (a pressure) at x, mu p against the slip; zero outside the contact.
        """

@final
class Boundary:
    """
    What lies beyond the edge of the grid.

    Wherever one is taken, ``"non_periodic"``, ``"periodic"`` and ``("periodic_along_y", datum)`` are too. On a grid that
    repeats along x and y the approach is measured from the mean gap, and the shift from the mean plane of the surface.
    """
    NON_PERIODIC: Final[Boundary]
    """
    Unloaded half-space.
    """
    PERIODIC: Final[Boundary]
    """
    The grid repeats along x and y.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def datum(self, /) -> float | None:
        """
        The datum (a length) of a grid that repeats along y alone; else ``None``.
        """
    @property
    def name(self, /) -> str:
        """
        Its name.
        """
    @staticmethod
    def periodic_along_y(datum: float) -> Boundary:
        """
        The grid repeats along y alone: cylinders, rollers, line contacts. The datum is the distance along x from a line
        load at which it moves nothing (a length), at least the length of the grid; approach and shift are relative to it.
        """

@final
class Carter:
    """
    A cylinder that rolls steadily with longitudinal creepage, in plane strain: Carter's solution.

    The leading edge is at x = a. A strip of half-width c = a (1 - |xi| / xi_s) that ends there sticks, the rest slips,
    against the traction; from the creepage xi_s on all slips. For equal bodies, or bodies of which Dundurs' beta is
    zero. Carter (1926); Johnson (1985), section 8.3.

    Parameters
    ----------
    hertz : HertzLine
        The normal contact.
    friction : float
        Coefficient of friction mu (dimensionless), not negative.
    creepage : float
        Creepage xi along x (dimensionless), of either sign.

    Raises
    ------
    NegativeOrNotFinite, NotFinite, CoupledMaterials
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, hertz: HertzLine, friction: float, creepage: float) -> Carter: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def force(self, /) -> float:
        """
        Tangential force Q on body 1 (a force per length), of the sign of the creepage, of size mu P (1 - c^2/a^2).
        """
    @property
    def sliding_creepage(self, /) -> float:
        """
        The creepage from which on the whole contact slips (dimensionless), xi_s = 2 mu p_0 / E*.
        """
    @property
    def stick_half_width(self, /) -> float:
        """
        Half-width c of the strip that sticks, at the leading edge (a length).
        """
    def traction(self, /, x: ArrayLike) -> Any:
        """
        Traction on body 1 along x (a pressure) at x: with the sign of the creepage, mu p_0 sqrt(1 - x^2/a^2), less
        mu p_0 (c/a) sqrt(1 - (x - a + c)^2/c^2) in the strip that sticks; zero outside the contact.
        """

@final
class CattaneoMindlin:
    """
    A sphere in partial slip: a constant normal load, then a tangential force along x that increases monotonically.

    With f = |F| / (mu W) a disc of radius c = a (1 - f)^(1/3) sticks. The ring around it slips, opposite to the
    traction. This is the solution of the scalar model, with traction along x only; with traction along y allowed it is
    exact for nu = 0. The coupling between pressure and traction of dissimilar bodies is neglected. Cattaneo (1938);
    Mindlin (1949); Johnson (1985), 7.41-7.44.

    Parameters
    ----------
    hertz : HertzSphere
        The normal contact.
    friction : float
        Coefficient of friction mu (dimensionless), not negative.
    force : float
        Tangential force F on body 1 along x, of either sign, at most mu W.

    Raises
    ------
    NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, hertz: HertzSphere, friction: float, force: float) -> CattaneoMindlin: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def displacement(self, /, x: ArrayLike, y: ArrayLike) -> Any:
        """
        Tangential displacement u_x of body 1 relative to body 2 (a length, of the sign of the force), anywhere in the
        plane: shift and slip inside the contact.
        """
    @property
    def energy_of_first_quarter(self, /) -> float:
        """
        Energy dissipated while the force grows from zero to F (a force times a length, not negative),
        (mu W delta_0 / 5) (1 - c/a)^3 (1 + 3 c/a + c^2/a^2): the first quarter of a cycle.
        """
    @property
    def energy_per_cycle(self, /) -> float:
        """
        Energy that one full cycle of the force between F and -F dissipates (a force times a length): four times that
        of the first quarter.
        """
    @property
    def force(self, /) -> float:
        """
        Tangential force F on body 1, positive along +x.
        """
    @property
    def hertz(self, /) -> HertzSphere:
        """
        The normal contact.
        """
    @property
    def shift(self, /) -> float:
        """
        Shift delta_x (a length): the rigid motion of body 2 relative to body 1, of the sign of the force, of size
        (3 mu W / 16 a) ((2 - nu)/G) (1 - (1 - f)^(2/3)).
        """
    @property
    def sliding_shift(self, /) -> float:
        """
        Shift at which the whole contact begins to slide, delta_0 (a length, positive): the shift under mu W.
        """
    def slip(self, /, x: ArrayLike, y: ArrayLike) -> Any:
        """
        Slip u_x - delta_x (a length, opposite to the force) in the ring that slips; zero elsewhere.
        """
    @property
    def stick_radius(self, /) -> float:
        """
        Radius of the stick disc, c = a (1 - f)^(1/3) (a length).
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Fraction of the contact area that sticks, c^2/a^2 = (1 - f)^(2/3).
        """
    def traction(self, /, r: ArrayLike) -> Any:
        """
        Traction on body 1 along x (a pressure, of the sign of the force) at the distance r from the centre:
        mu p_0 sqrt(1 - r^2/a^2), less mu p_0 (c/a) sqrt(1 - r^2/c^2) in the stick disc; zero outside the contact.
        """

@final
class CattaneoMindlinEllipse:
    """
    An elliptic paraboloid in partial slip: a constant normal load, then a tangential force along x that increases
    monotonically.

    The stick ellipse is the contact ellipse scaled by s = (1 - f)^(1/3), f = |F| / (mu W). This is the solution of the
    scalar model, with traction along x only. The coupling between pressure and traction of dissimilar bodies is neglected.
    Mindlin (1949); Vermeulen and Johnson (1964).

    Parameters
    ----------
    hertz : HertzEllipse
        The normal contact.
    friction : float
        Coefficient of friction mu (dimensionless), not negative.
    force : float
        Tangential force F on body 1 along x, of either sign, at most mu W.

    Raises
    ------
    NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, hertz: HertzEllipse, friction: float, force: float) -> CattaneoMindlinEllipse: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def energy_of_first_quarter(self, /) -> float:
        """
        Energy dissipated while the force grows from zero to F (a force times a length, not negative), as
        :attr:`CattaneoMindlin.energy_of_first_quarter`.
        """
    @property
    def energy_per_cycle(self, /) -> float:
        """
        Energy that one full cycle of the force between F and -F dissipates (a force times a length): four times that
        of the first quarter.
        """
    @property
    def force(self, /) -> float:
        """
        Tangential force F on body 1, positive along +x.
        """
    @property
    def hertz(self, /) -> HertzEllipse:
        """
        The normal contact.
        """
    @property
    def shift(self, /) -> float:
        """
        Shift (a length): the rigid motion of body 2 relative to body 1, of the sign of the force, 1 - s^2 of that at
        which the whole contact begins to slide.
        """
    @property
    def sliding_shift(self, /) -> float:
        """
        Shift at which the whole contact begins to slide (a length, positive): the shift under mu W.
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Fraction of the contact area that sticks, (1 - f)^(2/3).
        """
    @property
    def stick_semi_axes(self, /) -> tuple[float, float]:
        """
        Semi-axes of the stick ellipse along x and y (lengths): s times those of the contact.
        """
    def traction(self, /, x: ArrayLike, y: ArrayLike) -> Any:
        """
        Traction on body 1 along x (a pressure, of the sign of the force): with rho^2 = x^2/a_x^2 + y^2/a_y^2 it is
        mu p_0 sqrt(1 - rho^2), less mu p_0 sqrt(s^2 - rho^2) in the stick ellipse; zero outside the contact.
        """

@final
class CattaneoMindlinLine:
    """
    A cylinder in partial slip in plane strain: a constant normal load, then a tangential force along x that
    increases monotonically, with a bulk strain that increases in proportion to it.

    With f = |Q| / (mu P) a strip of half-width c = a sqrt(1 - f) sticks; the rest slips, opposite to the traction. For
    equal bodies, or bodies of which Dundurs' beta is zero. Johnson (1985), section 7.2; with bulk strain Nowell &
    Hills, Int. J. Mech. Sci. 29 (1987) 355.

    Parameters
    ----------
    hertz : HertzLine
        The normal contact.
    friction : float
        Coefficient of friction mu (dimensionless), not negative.
    force : float
        Tangential force Q on body 1 along x (a force per length), of either sign, at most mu P.

    Raises
    ------
    NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity, CoupledMaterials
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, hertz: HertzLine, friction: float, force: float) -> CattaneoMindlinLine: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def energy_of_first_quarter(self, /) -> float:
        """
        Energy dissipated per length while the force, and the strain with it, grow from zero: a quarter of that of a
        cycle.
        """
    @property
    def energy_per_cycle(self, /) -> float:
        """
        Energy that a cycle of the force between Q and -Q, with the strain in proportion to it, dissipates per length,
        ((mu P)^2 / (pi E*)) (4 (1 - f) ln(1 - f) + 4 f - 2 f^2 + 8 f e^2/a^2).
        """
    @property
    def force(self, /) -> float:
        """
        Tangential force Q on body 1 (a force per length), positive along +x.
        """
    @property
    def hertz(self, /) -> HertzLine:
        """
        The normal contact.
        """
    def shift(self, /, datum: ArrayLike) -> Any:
        """
        Shift (a length): the rigid motion of body 2 relative to body 1 along x, of the sign of the force, relative to
        the datum d (a length) of :meth:`Boundary.periodic_along_y`; the strain displaces nothing at x = 0: of size
        (mu P / (pi E*)) (f (2 ln(2d/a) + 1) + (1 - f) ln(1 - f) + 2 e^2/a^2).
        """
    @property
    def stick_centre(self, /) -> float:
        """
        Middle of the strip that sticks (a length along x), of size a E* strain / (2 mu p_0); zero without strain.
        """
    @property
    def stick_half_width(self, /) -> float:
        """
        Half-width of the strip that sticks, c = a sqrt(1 - f) (a length).
        """
    def stress(self, /, x: ArrayLike, depth: ArrayLike) -> tuple[tuple[Any, Any, Any], tuple[Any, Any, Any]]:
        """
        Stresses xx, zz and xz of body 1 and those of body 2, at x and at a depth below the surface of each, a length of
        zero or more (pressures, positive in tension), bulk stress included. Johnson (1985), 7.2.
        """
    def surface_stress(self, /, x: ArrayLike) -> tuple[Any, Any]:
        """
        Stresses xx of the surfaces of body 1 and of body 2 at x (pressures, positive in tension), bulk stress included.
        In body 1 the largest is at the edge of the contact that the traction pulls away from, x = -a under a positive
        force, where it rises as a square root: a row of cells meets it slowly. Johnson (1985), 2.23 and 7.2; Nowell &
        Hills (1987).
        """
    def traction(self, /, x: ArrayLike) -> Any:
        """
        Traction on body 1 along x (a pressure) at x: with the sign of Q, mu p_0 sqrt(1 - x^2/a^2), less
        mu p_0 (c/a) sqrt(1 - (x - e)^2/c^2) in the strip around e that sticks; zero outside the contact.
        """
    def with_bulk_stress(self, /, stress: Sequence[float] | NDArray[Any]) -> CattaneoMindlinLine:
        """
        With these bulk stresses along x in bodies 1 and 2 (pressures, positive in tension), which grow in proportion to
        the force and strain the bodies in plane strain.

        Raises
        ------
        Sample, NotFinite, NotPositive, BelowMinimum
            As :meth:`with_strain`.
        """
    def with_strain(self, /, strain: float) -> CattaneoMindlinLine:
        """
        With this strain of body 1 along x less that of body 2, positive where it is stretched. A bulk stress along x
        in one body strains it by stress (1 - nu^2) / E in plane strain: :meth:`Material.plane_strain_under`.

        Raises
        ------
        NotFinite, NotPositive
        BelowMinimum
            If the strip that sticks would leave the contact: slip then reverses at one end.
        """

@final
class Cone:
    """
    A blunt cone pressed on a half-space.

    The gap is r tan(beta), with the small angle beta between flank and surface. The mean pressure is independent of
    the load, so that the contact area is proportional to the load, as that of a rough surface. Sneddon (1965);
    Johnson (1985), section 5.2.

    Parameters
    ----------
    pair : ElasticPair
        The bodies.
    slope : float
        Slope tan(beta) of the flank (dimensionless), positive.
    load : float
        Normal load W (a force), positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair, slope: float, load: float) -> Cone: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def approach(self, /) -> float:
        """
        Approach of the bodies, delta = (pi/2) a tan(beta) (a length), positive.
        """
    @property
    def contact_area(self, /) -> float:
        """
        Area of the contact circle, pi a^2 (a length squared).
        """
    @property
    def contact_radius(self, /) -> float:
        """
        Radius of the contact circle, a = sqrt(2 W / (pi E* tan(beta))) (a length).
        """
    def displacement(self, /, r: ArrayLike) -> Any:
        """
        Normal displacement u_z of the surfaces (a length), summed over the bodies and positive into each, at the
        distance r from the centre: delta - r tan(beta) inside the contact, and outside it
        (a arcsin(a/r) - r + sqrt(r^2 - a^2)) tan(beta).
        """
    def gap(self, /, r: ArrayLike) -> Any:
        """
        Gap u_z + r tan(beta) - delta between the surfaces (a length) at the distance r from the centre; zero in the
        contact, positive outside.
        """
    @property
    def load(self, /) -> float:
        """
        Normal load W (a force), positive in compression.
        """
    @property
    def mean_pressure(self, /) -> float:
        """
        Mean pressure over the contact circle, E* tan(beta) / 2.
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The bodies.
        """
    def pressure(self, /, r: ArrayLike) -> Any:
        """
        Pressure (E* tan(beta) / 2) arcosh(a/r) at the distance r from the centre; infinite at the apex, zero outside
        the contact.
        """
    @property
    def slope(self, /) -> float:
        """
        Slope tan(beta) of the flank (dimensionless).
        """

@final
class ConePartialSlip:
    """
    A cone in partial slip: a constant normal load, then a tangential force along x that increases monotonically.

    The traction is mu times the difference between the pressure under W and that under the reduced load (1 - f) W,
    f = |F| / (mu W), whose contact circle is the stick disc. This is the solution of the scalar model, with traction
    along x only. The coupling between pressure and traction of dissimilar bodies is neglected. Ciavarella (1998); Jaeger
    (1998).

    Parameters
    ----------
    cone : Cone
        The normal contact.
    friction : float
        Coefficient of friction mu (dimensionless), not negative.
    force : float
        Tangential force F on body 1 along x, of either sign, at most mu W.

    Raises
    ------
    NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, cone: Cone, friction: float, force: float) -> ConePartialSlip: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def cone(self, /) -> Cone:
        """
        The normal contact.
        """
    @property
    def force(self, /) -> float:
        """
        Tangential force F on body 1, positive along +x.
        """
    @property
    def shift(self, /) -> float:
        """
        Shift (a length): the rigid motion of body 2 relative to body 1, of the sign of the force, of size
        mu delta (2 - nu) / (2 (1 - nu)) (1 - sqrt(1 - f)).
        """
    @property
    def sliding_shift(self, /) -> float:
        """
        Shift at which the whole contact begins to slide (a length, positive): the shift under mu W.
        """
    @property
    def stick_radius(self, /) -> float:
        """
        Radius of the stick disc, c = a sqrt(1 - f) (a length).
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Fraction of the contact area that sticks, c^2/a^2 = 1 - f.
        """
    def traction(self, /, r: ArrayLike) -> Any:
        """
        Traction on body 1 along x (a pressure, of the sign of the force) at the distance r from the centre:
        (mu E* tan(beta) / 2) arcosh(a/r), less the same with c in the stick disc; zero outside the contact.
        """

@final
class ContactSpots:
    """
    The connected spots of a contact: a sequence of :class:`Spot`.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __getitem__(self, index: int, /) -> Spot: ...
    def __iter__(self, /) -> Iterator[Spot]: ...
    def __len__(self, /) -> int: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def grid(self, /) -> Grid:
        """
        The grid of the labels.
        """
    @property
    def labels(self, /) -> NDArray[uint32]:
        """
        The number of the spot of every cell, counted from 1, of shape (ny, nx); 0 outside the contact.
        """
    @property
    def largest(self, /) -> Spot | None:
        """
        The spot of the largest area.
        """

@final
class ContactStiffness:
    """
    All slopes of a contact.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    normal : NormalSolution
        The normal contact.
    friction : Friction, float or array_like of shape (ny, nx)
        The friction of the tangential contact.
    shear : TangentialSolution
        The tangential contact under that pressure.

    Raises
    ------
    GridMismatch, BoundaryMismatch, MaterialMismatch, NotFinite, Yielded, NotConverged
    CoupledMaterials
        For the halves of a coupled solution of dissimilar bodies.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, bodies: HalfSpace, normal: NormalSolution, friction: Friction | float | ArrayLike, shear: TangentialSolution) -> ContactStiffness: ...
    def __repr__(self, /) -> str: ...
    @property
    def by_approach(self, /) -> tuple[float, float, float]:
        """
        By the approach, of the tangential forces and the moment; NaN for those that the model does not have.
        """
    @property
    def normal(self, /) -> NormalStiffness:
        """
        By the approach, of the normal force.
        """
    @property
    def normal_by_motion(self, /) -> tuple[float, float, float]:
        """
        By shifts along x and y and the twist, of the normal force: zero but where pressure and traction are found together.
        NaN for motions that the model does not have.
        """
    @property
    def tangential(self, /) -> TangentialStiffness:
        """
        By shifts and twist, of the tangential forces and the moment.
        """

@final
class Convolution(LinearOperator):
    """
    The convolution with an influence coefficient by fast transforms.

    Parameters
    ----------
    grid : Grid
        The cells.
    pair : ElasticPair
        The two bodies.
    component : Component or str
        Displacement first, traction second.
    periodic : bool, default False
        Whether the grid repeats along x and y.
    """
    def __new__(cls, /, grid: Grid, pair: ElasticPair, component: Component | str, *, periodic: bool = False) -> Convolution: ...

@final
class CoupledProblem:
    """
    Bodies, gap, friction and loads of a contact whose pressure and tractions are found together: from rest, in one step.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    gap : Field or array_like of shape (ny, nx)
        The gap before loading (lengths). An array is copied, a Field is shared.
    friction : Friction, float or array_like of shape (ny, nx)
        Coulomb friction; a number or an array is the coefficient of friction (dimensionless, not negative).
    load : TangentialLoad, optional
        The tangential load as an object, instead of by keywords.
    force, shift, spring, force_x, force_y, shift_x, shift_y, spring_x, spring_y, twist : optional
        The tangential load, as of :class:`TangentialLoad`; no force by default.
    normal_force, approach : float
        One of the two: the normal force (not negative), or the approach of the bodies from the datum of the gap (a length,
        positive when they come together).
    relative_displacement : RelativeDisplacement, optional
        A displacement of body 1 relative to body 2 that the contact does not cause, reached in proportion to the load; none
        by default.
    hardness : Hardness, float or array_like of shape (ny, nx), optional
        The largest pressure that the cells carry; no limit by default.
    settings : Settings, optional
        Method, tolerance and limits; those of ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        As of :class:`Settings`; they take precedence over ``settings``.

    Raises
    ------
    GridMismatch, Shape, Sample, NegativeOrNotFinite, NotFinite, NotPositive, UnsupportedByModel, ApproachBeyondMeanGap,
    BeyondHardness, Method, Tolerance, IterationLimit

    Examples
    --------
    >>> import stickslip
    >>> grid = stickslip.Grid.square(32, 0.3)
    >>> pair = (stickslip.Material(70e3, 0.33), stickslip.Material(210e3, 0.3))
    >>> bodies = stickslip.HalfSpace(grid, pair)
    >>> ball = stickslip.surface.sphere(grid, 3.5)
    >>> contact = stickslip.CoupledProblem(bodies, ball, 0.1, normal_force=60.0).solve()
    >>> contact.tangential.slip_area > 0.0  # pressing alone makes the rim slip
    True
    """
    def __getnewargs_ex__(self, /) -> tuple[tuple[Any, ...], dict[str, Any]]: ...
    def __new__(cls, /, bodies: HalfSpace, gap: Field | ArrayLike, friction: Friction | float | ArrayLike, load: TangentialLoad | None = None, *, normal_force: float | None = None, approach: float | None = None, force: Sequence[float] | NDArray[Any] | None = None, shift: Sequence[float] | NDArray[Any] | None = None, spring: tuple[Sequence[float], float] | None = None, force_x: float | None = None, force_y: float | None = None, shift_x: float | None = None, shift_y: float | None = None, spring_x: tuple[float, float] | None = None, spring_y: tuple[float, float] | None = None, twist: float | None = None, relative_displacement: RelativeDisplacement | None = None, hardness: Hardness | float | ArrayLike | None = None, settings: Settings | None = None, tolerance: float | None = None, method: Method | str | None = None, max_iterations: int | None = None, time_limit: float | None = None) -> CoupledProblem: ...
    def __repr__(self, /) -> str: ...
    def solve(self, /, *, progress: Any | None = None, warn: bool = True) -> CoupledSolution:
        """
        Solves from rest; see :meth:`NormalProblem.solve`. A force that slides the contact raises
        :class:`~stickslip.errors.BeyondFrictionCapacity`.
        """
    def solver(self, /) -> CoupledSolver:
        """
        A solver of this problem, which keeps its buffers and starts each solve from the last answer.
        """

@final
class CoupledReport:
    """
    How a coupled solve ended, what it cost, and what its halves certify.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def error_bounds(self, /) -> tuple[float, float] | None:
        """
        Bounds of the errors of pressure and traction as a whole, where friction is weak enough for them.
        """
    @property
    def error_estimate(self, /) -> ErrorEstimate | None:
        """
        What the errors of the whole are likely to be.
        """
    @property
    def is_converged(self, /) -> bool:
        """
        Whether the tolerance was reached.
        """
    @property
    def normal(self, /) -> Report:
        """
        Steps and products with the normal part alone.
        """
    @property
    def pressure_error_bound(self, /) -> float:
        """
        Bound of the error of the pressure at the tractions as they are.
        """
    @property
    def tangential(self, /) -> Report:
        """
        Steps and products with the tangential part alone.
        """
    @property
    def traction_error_bound(self, /) -> float:
        """
        Bound of the error of the tractions at the pressure as it is.
        """
    @property
    def work(self, /) -> Report:
        """
        Why the iteration ended, products with the whole tensor, residual and time.
        """

@final
class CoupledRollingProblem:
    """
    Bodies, gap, friction and loads of steady rolling in which the tractions change the pressure.

    Along an axis without a creepage and a force there is no creepage.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    gap : Field or array_like of shape (ny, nx)
        The gap before loading (lengths). An array is copied, a Field is shared.
    friction : Friction, float or array_like of shape (ny, nx)
        Coulomb friction; a number or an array is the coefficient of friction (dimensionless, not negative).
    normal_force, approach : float
        One of the two: the normal force (not negative), or the approach of the bodies from the datum of the gap (a length,
        positive when they come together).
    creepage, creepage_x, creepage_y, force, force_x, force_y, spin, moment : optional
        As of :class:`RollingProblem`.
    leading_edge, step, entry_rule, slip_corrections : optional
        As of :class:`RollingProblem`.
    settings : Settings, optional
        Method, tolerance and limits; those of ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        As of :class:`Settings`; they take precedence over ``settings``.

    Raises
    ------
    GridMismatch, Shape, Sample, NegativeOrNotFinite, NotFinite, NotPositive, UnsupportedByModel, ApproachBeyondMeanGap, Tolerance,
    IterationLimit, Method

    Examples
    --------
    >>> import stickslip
    >>> grid = stickslip.Grid.square(24, 3.0)
    >>> bodies = stickslip.HalfSpace(grid, (stickslip.Material(1.0, 0.0), stickslip.Material.rigid()))
    >>> ball = stickslip.surface.sphere(grid, 1.0)
    >>> problem = stickslip.rolling.CoupledRollingProblem(bodies, ball, 0.3, normal_force=1.0, force_x=0.0)
    >>> rolling = problem.solve()
    >>> smooth = stickslip.NormalProblem(bodies, ball, force=1.0).solve()
    >>> bool(rolling.normal.pressure.max() > smooth.pressure.max())  # the tractions raise the pressure
    True
    """
    def __getnewargs_ex__(self, /) -> tuple[tuple[Any, ...], dict[str, Any]]: ...
    def __new__(cls, /, bodies: HalfSpace, gap: Field | ArrayLike, friction: Friction | float | ArrayLike, *, normal_force: float | None = None, approach: float | None = None, creepage: Sequence[float] | NDArray[Any] | None = None, creepage_x: float | None = None, creepage_y: float | None = None, force: Sequence[float] | NDArray[Any] | None = None, force_x: float | None = None, force_y: float | None = None, spin: float | None = None, moment: float | None = None, leading_edge: LeadingEdge | str | None = None, step: int | None = None, entry_rule: EntryRule | str | None = None, slip_corrections: int | None = None, settings: Settings | None = None, tolerance: float | None = None, method: Method | str | None = None, max_iterations: int | None = None, time_limit: float | None = None) -> CoupledRollingProblem: ...
    def __repr__(self, /) -> str: ...
    def solve(self, /, *, progress: Any | None = None, warn: bool = True) -> CoupledRollingSolution:
        """
        Solves once; see :meth:`NormalProblem.solve`.
        """
    def solver(self, /) -> CoupledRollingSolver:
        """
        A solver of this problem, which keeps its buffers and starts each solve from the last answer.
        """

@final
class CoupledRollingReport:
    """
    Report of coupled rolling: ending, cost, passes and certified errors.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __repr__(self, /) -> str: ...
    @property
    def coupling_residual(self, /) -> float:
        """
        Residual of the coupling: lift within the contact that the last pass has added, over the largest normal displacement.
        """
    @property
    def error_estimate(self, /) -> float | None:
        """
        Estimate of the relative error of the pressure as a whole, if there is one.
        """
    @property
    def is_converged(self, /) -> bool:
        """
        Whether the tolerance was reached.
        """
    @property
    def normal(self, /) -> Report:
        """
        Steps and products for the pressure.
        """
    @property
    def passes(self, /) -> int:
        """
        Number of passes: solves of the pressure, each followed by a solve of the tractions.
        """
    @property
    def pressure_change(self, /) -> float:
        """
        Change of the pressure in the last pass, over the pressure (root mean squares).
        """
    @property
    def pressure_error_bound(self, /) -> float:
        """
        Bound of the relative error of the pressure in the energy norm, for the tractions of the solution.
        """
    @property
    def rolling(self, /) -> Report:
        """
        Steps and products for the tractions.
        """
    @property
    def traction_error_bound(self, /) -> float:
        """
        Bound of the relative error of the tractions, for the pressure of the solution.
        """
    @property
    def work(self, /) -> Report:
        """
        Status, steps and products of all passes, and the largest residual of both halves.
        """

@final
class CoupledRollingSolution:
    """
    Both halves of coupled steady rolling.
    """
    def __repr__(self, /) -> str: ...
    @property
    def normal(self, /) -> NormalSolution:
        """
        The normal half; a copy.
        """
    @property
    def report(self, /) -> CoupledRollingReport:
        """
        Ending, cost, passes and certified errors.
        """
    @property
    def rolling(self, /) -> RollingSolution:
        """
        The rolling half; a copy.
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Remarks on a result that may mislead; empty if there are none.
        """

@final
class CoupledRollingSolver:
    """
    Solves coupled rolling for one load after the other, each from the last answer; made by
    :meth:`CoupledRollingProblem.solver`.
    """
    def __repr__(self, /) -> str: ...
    @property
    def report(self, /) -> CoupledRollingReport:
        """
        How the last solve ended.
        """
    def reset(self, /) -> None:
        """
        Forgets the last answer: the next solve starts as the first did.
        """
    def set_friction(self, /, friction: Friction | float | ArrayLike) -> None:
        """
        Sets the friction of the next solve.
        """
    def set_gap(self, /, gap: Field | ArrayLike) -> None:
        """
        Sets the gap of the next solve (lengths).
        """
    def set_load(self, /, *, normal_force: float | None = None, approach: float | None = None) -> None:
        """
        Sets the normal load of the next solve: a normal force (not negative) or an approach (a length).
        """
    @property
    def settings(self, /) -> Settings:
        """
        The settings of the next solve; may be assigned.
        """
    @settings.setter
    def settings(self, /, settings: Settings) -> None: ...
    def solve(self, /, *, creepage: Sequence[float] | NDArray[Any] | None = None, creepage_x: float | None = None, creepage_y: float | None = None, force: Sequence[float] | NDArray[Any] | None = None, force_x: float | None = None, force_y: float | None = None, spin: float | None = None, moment: float | None = None, progress: Any | None = None, warn: bool = True) -> CoupledRollingSolution:
        """
        Solves, for these creepages, forces, spin or moment if any is given, else for the last ones.

        Parameters
        ----------
        creepage, creepage_x, creepage_y, force, force_x, force_y, spin, moment : optional
            As of :class:`RollingProblem`: if one is given, those that are not are zero creepages and no spin.
        progress, warn : optional
            As of :meth:`NormalProblem.solve`.

        Returns
        -------
        CoupledRollingSolution

        Raises
        ------
        NotFinite, UnsupportedByModel
            For what is prescribed, which is then unchanged.
        EmptyContact, GridTooShort, BeyondFrictionCapacity, BeyondFrictionMoment
            If the contact cannot roll so.
        NotConverged
            With ``report`` and ``last_iterate``.
        """
    def stiffness(self, /) -> list[list[float]]:
        """
        How forces along x and y and moment (rows) change with the creepages along x and y and the spin (columns) about the
        last answer, with the pressure that follows the tractions.

        Raises
        ------
        NotConverged
            Before the first solve, or if a column is not found.
        """

@final
class CoupledSolution:
    """
    Both halves of a coupled contact, with the displacements that they cause together. Halves and arrays share its memory.
    Two are equal if their answers are, however they were found.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def contact(self, /) -> NDArray[bool_]:
        """
        Whether a cell is in contact, booleans of shape (ny, nx): its pressure is positive; a copy.
        """
    @property
    def displacement(self, /) -> tuple[NDArray[float64], NDArray[float64], NDArray[float64]]:
        """
        Displacements of all cells along x, y and z (lengths).
        """
    @property
    def elastic_energy(self, /) -> float:
        """
        Elastic energy of both bodies.
        """
    @property
    def normal(self, /) -> NormalSolution:
        """
        The normal half.
        """
    @property
    def report(self, /) -> CoupledReport:
        """
        How the solve ended, what it cost, and what is certified.
        """
    def stiffness(self, /, bodies: HalfSpace, friction: Friction | float | ArrayLike) -> ContactStiffness:
        """
        The stiffness: the slopes of the forces and the moment by approach, shift and twist, with the friction of the problem.
        """
    @property
    def tangential(self, /) -> TangentialSolution:
        """
        The tangential half.
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Remarks on a result that may mislead; empty if there are none.
        """

@final
class CoupledSolver:
    """
    Solves coupled contacts again and again, each from the last answer; made by :meth:`CoupledProblem.solver`.
    """
    def __repr__(self, /) -> str: ...
    def reset(self, /) -> None:
        """
        Forgets the last answer: the next solve starts as the first did.
        """
    def set_friction(self, /, friction: Friction | float | ArrayLike) -> None:
        """
        Changes the friction of the next solve.
        """
    def set_gap(self, /, gap: Field | ArrayLike) -> None:
        """
        Changes the gap of the next solve (lengths).
        """
    def set_load(self, /, load: TangentialLoad, *, normal_force: float | None = None, approach: float | None = None) -> None:
        """
        Changes the loads of the next solve: the tangential one, and one of a normal force (not negative) and an approach (a
        length).
        """
    @property
    def settings(self, /) -> Settings:
        """
        The settings of the next solve; may be assigned.
        """
    @settings.setter
    def settings(self, /, settings: Settings) -> None: ...
    def solve(self, /, *, progress: Any | None = None, warn: bool = True) -> CoupledSolution:
        """
        Solves for the loads, the gap and the friction set; see :meth:`NormalProblem.solve`.
        """

@final
class CreepForce:
    """
    A point of a creep curve or a creep surface: creepages and spin, and the loads that they cause.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def creepage(self, /) -> tuple[float, float]:
        """
        The creepages along x and y (dimensionless).
        """
    @property
    def force(self, /) -> tuple[float, float]:
        """
        Tangential force on body 1 along x and y.
        """
    @property
    def moment(self, /) -> float:
        """
        Moment on body 1 about the origin of the grid (a force times a length, positive from x to y).
        """
    @property
    def spin(self, /) -> float:
        """
        The spin (one over a length, positive from x to y).
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Cells that stick over cells in contact.
        """

@final
class CreepForces:
    """
    The points of a creep curve or a creep surface: a sequence of :class:`CreepForce`, and arrays with a number of each
    point, in their order. Vectors are (x, y).
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __getitem__(self, index: int, /) -> CreepForce: ...
    def __iter__(self, /) -> Iterator[CreepForce]: ...
    def __len__(self, /) -> int: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def creepage(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        The creepages along x and y (dimensionless).
        """
    @property
    def force(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Tangential force on body 1 along x and y.
        """
    @property
    def moment(self, /) -> NDArray[float64]:
        """
        Moment on body 1 about the origin of the grid (a force times a length, positive from x to y).
        """
    @property
    def spin(self, /) -> NDArray[float64]:
        """
        The spin (one over a length, positive from x to y).
        """
    @property
    def stick_ratio(self, /) -> NDArray[float64]:
        """
        Cells that stick over cells in contact.
        """

@final
class Cycle:
    """
    Slip, energy and the loop of force and shift, added up over the steps of a cycle, from where the history is. Its arrays
    are copies.

    Parameters
    ----------
    history : History
        The history from whose present state it begins.
    """
    SUMMARY_NAMES: Final[str]
    """
    The names of :meth:`summary_as_csv`.
    """
    def __new__(cls, /, history: History) -> Cycle: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def add(self, /, history: History) -> None:
        """
        Adds the last step of the history: once after each.
        """
    def begin(self, /, history: History) -> None:
        """
        Forgets all steps and begins anew where the history is.
        """
    @property
    def cyclic_residual(self, /) -> float:
        """
        How far the cycle is from closing: the largest change of a traction from beginning to end over the largest traction,
        or that of the shift over its half range, whichever is more.
        """
    @property
    def dissipated_energy(self, /) -> NDArray[float64]:
        """
        Energy that each cell dissipated in the cycle (forces times lengths, not negative).
        """
    @property
    def energy(self, /) -> EnergyBalance:
        """
        Work, elastic energy and dissipation of the cycle.
        """
    @property
    def energy_ratio(self, /) -> float:
        """
        Energy dissipated over that of a rectangle around the loop, of force by shift.
        """
    @property
    def force_amplitude(self, /) -> tuple[float, float]:
        """
        Half the range of the force along x and y.
        """
    @property
    def points(self, /) -> LoopPoints:
        """
        The loop of force and shift: the beginning, and the end of each step. A copy.
        """
    def points_as_csv(self, /) -> str:
        """
        The loop as CSV.
        """
    @property
    def regime(self, /) -> Regime:
        """
        Whether the contact stuck, slipped in part, or slid.
        """
    @property
    def shift_amplitude(self, /) -> tuple[float, float]:
        """
        Half the range of the shift along x and y (lengths).
        """
    @property
    def slip_amplitude(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Half the range of the slip of each cell along x and y (lengths, not negative).
        """
    @property
    def slip_distance(self, /) -> NDArray[float64]:
        """
        Length of the path that each cell slipped in the cycle (lengths, not negative).
        """
    @property
    def slip_pressure(self, /) -> NDArray[float64]:
        """
        Pressure that each cell slipped under, the mean over its path; zero where nothing slipped.
        """
    @property
    def steps(self, /) -> int:
        """
        Steps added.
        """
    @property
    def stick_ratios(self, /) -> tuple[float, float]:
        """
        The least and the largest stick ratio.
        """
    def summary_as_csv(self, /) -> str:
        """
        The cycle as a line of CSV.
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Remarks on its steps.
        """
    @property
    def work_of_loads(self, /) -> float:
        """
        Work of the tangential force and of the moment (a force times a length): the area that the loop of the points
        encloses where it closes. The ``work`` of :attr:`energy` has that of a changing relative displacement, such as bulk
        strain, besides.
        """

@final
class CycleJump:
    """
    How many cycles to jump over: as many as a cycle's wear may be taken off at once, without the pressure swinging.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    cycle : Cycle
        The cycle that stands for those jumped over.
    depth : Field or array_like of shape (ny, nx)
        What the cycle removed, of both bodies together (lengths), not negative.
    largest_depth : float, optional
        The most that a jump may remove in any cell (a length); without limit by default.
    max_residual : float, default 0.25
        The largest :attr:`Cycle.cyclic_residual` of a cycle that may stand for those that follow.
    cycles_left : float, optional
        The most cycles to jump over; without limit by default.

    Raises
    ------
    GridMismatch, Shape, Sample
    """
    def __new__(cls, /, bodies: HalfSpace, cycle: Cycle, depth: Field | ArrayLike, *, largest_depth: float | None = None, max_residual: float | None = None, cycles_left: float | None = None) -> CycleJump: ...
    def __repr__(self, /) -> str: ...
    def cycles(self, /) -> float:
        """
        The cycles to jump over, not rounded; infinite without a limit.

        Raises
        ------
        CycleNotClosed, NotPositive, NegativeOrNotFinite
        """

@final
class DenseMinimum:
    """
    What a direct minimisation found.
    """
    def __repr__(self, /) -> str: ...
    @property
    def multiplier(self, /) -> float:
        """
        The multiplier of the total; zero without one.
        """
    @property
    def x(self, /) -> NDArray[float64]:
        """
        The unknowns.
        """

@final
class DenseOperator(LinearOperator):
    """
    An explicit square matrix, of at most 4096 unknowns.

    Parameters
    ----------
    rows : array_like of shape (n, n)
        Symmetric.

    Raises
    ------
    TooManyCells, Sample
    """
    def __new__(cls, /, rows: Any) -> DenseOperator: ...
    def get(self, /, row: int, column: int) -> float | None:
        """
        The entry of a row and a column; ``None`` outside the matrix.
        """
    def minimise(self, /, linear: Any, *, lower: Any | None = None, upper: Any | None = None, total: float | None = None) -> DenseMinimum:
        """
        Minimises ``x'Cx/2 + linear'x`` within bounds, with ``sum(x) = total`` if given, directly.

        Parameters
        ----------
        linear : array_like
            As many numbers as there are unknowns.
        lower, upper : float or array_like, optional
            Bounds of the unknowns; 0 and infinity by default.
        total : float, optional
            Sum of the unknowns; free by default.

        Returns
        -------
        DenseMinimum

        Raises
        ------
        Sample, Bounds, Total, NotPositiveDefinite, NotConverged
        """
    @staticmethod
    def of_half_space(bodies: HalfSpace, component: Component | str) -> DenseOperator:
        """
        The matrix of one influence coefficient between all cells of a half-space.
        """

@final
class Edges:
    """
    The edge of a contact or of its stick zone, found inside the cells: :meth:`NormalSolution.edges`,
    :meth:`TangentialSolution.edges` and :meth:`History.edges`.

    At a distance s from a smooth edge the pressure rises as the root of s and the gap opens as its power 3/2. A quadratic is
    fitted to the square of the one and the power 2/3 of the other in 7 x 7 cells about each cell at the edge; where it does
    not fit, the cell keeps its own pressure and has a mean correction of its area.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __repr__(self, /) -> str: ...
    @property
    def area(self, /) -> float:
        """
        Area with the parts of the cells at the edge (a length squared).
        """
    def areas_of(self, /, spots: ContactSpots) -> NDArray[float64]:
        """
        Areas of the spots of the contact, in their order, with the parts of the cells at the edges (lengths squared).
        """
    @property
    def cells(self, /) -> NDArray[uint64]:
        """
        The indices of the cells at the edge, in the flat grid, by rising index.
        """
    @property
    def centres(self, /) -> NDArray[float64]:
        """
        Values at the centres of all cells, shape (ny, nx): of a contact the pressure, of a stick zone what friction could
        still bear (pressures).
        """
    @property
    def covered(self, /) -> NDArray[float64]:
        """
        The covered parts of these cells, from 0 to 1.
        """
    @property
    def grid(self, /) -> Grid:
        """
        The grid of the cells.
        """
    @property
    def is_fitted(self, /) -> NDArray[bool_]:
        """
        Whether the edge was fitted in these cells.
        """
    @property
    def means(self, /) -> NDArray[float64]:
        """
        Means of the same over the cells, shape (ny, nx).
        """
    @property
    def outline(self, /) -> NDArray[float64]:
        """
        The edge as straight pieces (lengths): an array of shape (n, 2, 2), of each piece (x, y) of both ends.
        """
    @property
    def unfitted_fraction(self, /) -> float:
        """
        The part of the cells at the edge whose fit was refused.
        """

@final
class ElasticPair:
    """
    Two bodies, at most one of them rigid.

    Parameters
    ----------
    body_1, body_2 : Material
        z points into body 1; pressure and traction act on it, and on body 2 with the other sign.

    Raises
    ------
    BothRigid, NotPositive, NotFinite
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __hash__(self, /) -> int:
        """
        Equal pairs have equal ones.
        """
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, body_1: Material, body_2: Material) -> ElasticPair: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def bodies(self, /) -> tuple[Material, Material]:
        """
        The two bodies.
        """
    @property
    def contact_modulus(self, /) -> float:
        """
        Contact modulus E* (a pressure), 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
        """
    @property
    def dundurs_beta(self, /) -> float:
        """
        Dundurs' second parameter: whether and how strongly pressure and traction are coupled.
        """
    @property
    def equivalent_poisson_ratio(self, /) -> float:
        """
        Poisson's ratio of the one body that is as compliant as both, nu = G (nu_1/G_1 + nu_2/G_2).
        """
    @property
    def equivalent_shear_modulus(self, /) -> float:
        """
        Shear modulus G of the one body that is as compliant as both (a pressure), 1/G = 1/G_1 + 1/G_2.
        """
    @property
    def hardness(self, /) -> float:
        """
        The hardness of the softer body (a pressure); infinite if none is stated.
        """
    @property
    def is_coated(self, /) -> bool:
        """
        Whether a body is coated.
        """
    @property
    def is_coupled(self, /) -> bool:
        """
        Whether pressure and traction are coupled.
        """
    def response(self, /, k: float) -> WaveResponse:
        """
        The response of the relative displacement u_1 - u_2 to waves of traction of the wave number k > 0 (one over a length).

        Raises
        ------
        NotPositive, IncompleteKernel
        """
    @property
    def tangential_modulus(self, /) -> float:
        """
        Tangential modulus G* (a pressure), 1/G* = (2 - nu_1)/G_1 + (2 - nu_2)/G_2.
        """

@final
class EnergyBalance:
    """
    Where the work of the tangential load in a step went, or in the steps of a cycle (energies).
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def dissipated_energy(self, /) -> float:
        """
        Energy dissipated, by the tractions at the end of the step.
        """
    @property
    def elastic_after(self, /) -> float:
        """
        Elastic energy of shear after.
        """
    @property
    def elastic_before(self, /) -> float:
        """
        Elastic energy of shear before.
        """
    @property
    def imbalance(self, /) -> float:
        """
        What is missing in the balance, relative to its largest part.
        """
    @property
    def dissipated_energy_midpoint(self, /) -> float:
        """
        Energy dissipated, by the mean tractions: what closes the balance.
        """
    @property
    def released(self, /) -> float:
        """
        Energy of the tractions that cells drop as they leave the contact.
        """
    @property
    def residual(self, /) -> float:
        """
        Work on the motion that the tolerance leaves in stick cells.
        """
    @property
    def work(self, /) -> float:
        """
        Work of the tangential load.
        """

@final
class ErrorEstimate:
    """
    Estimated errors of a coupled contact as a whole, each in its energy norm: not bounds.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def pressure(self, /) -> float:
        """
        Of the pressure.
        """
    @property
    def traction(self, /) -> float:
        """
        Of the traction.
        """

@final
class Field:
    """
    Samples at the cells of a grid, one number a cell: gaps, heights, pressures. It is never changed.

    Whatever takes a field takes an array of shape (ny, nx) too, and copies it; a Field is made once and shared, so that
    repeated calls copy nothing. ``numpy.asarray(field)`` is a read-only view of it, and ``field[iy, ix]`` a sample. Sums,
    differences, products and quotients with fields, arrays and numbers, in either order and cell by cell, are fields; other
    functions of NumPy take it as its array.

    Parameters
    ----------
    grid : Grid
        Where it lives.
    samples : array_like of shape (ny, nx), or float
        Its values, row-major with x fastest; or one for all cells.
    unit : str, optional
        The unit of the lengths of a surface, such as ``"um"``. What is made of the surface keeps it, and surfaces of
        several units are refused together; the package computes in any, and asks for none.

    Examples
    --------
    >>> import numpy as np, stickslip
    >>> grid = stickslip.Grid(4, 3, 0.5, 0.5)
    >>> field = stickslip.Field(grid, np.arange(12.0).reshape(3, 4))
    >>> field
    Field(4 x 3 cells, 0 to 11)
    >>> (field + 1.0).array[0]
    array([1., 2., 3., 4.])
    """
    def __add__(self, other: object, /) -> Field: ...
    def __array__(self, /, dtype: Any | None = None, copy: bool | None = None) -> Any: ...
    def __array_ufunc__(self, /, ufunc: Any, method: str, *inputs: Any, **kwargs: Any) -> Any:
        """
        What NumPy calls instead of its function where one of the operands is a field.
        """
    def __eq__(self, value: object, /) -> bool: ...
    def __getitem__(self, index: Any, /) -> Any:
        """
        As of :attr:`array`: ``field[iy, ix]`` is a sample, ``field[iy]`` a row.
        """
    def __mul__(self, other: object, /) -> Field: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __neg__(self, /) -> Field: ...
    def __new__(cls, /, grid: Grid, samples: Field | ArrayLike, unit: str | None = None) -> Field: ...
    def __radd__(self, other: object, /) -> Field: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def __rmul__(self, other: object, /) -> Field: ...
    def __rsub__(self, other: object, /) -> Field: ...
    def __rtruediv__(self, other: object, /) -> Field: ...
    def __sub__(self, other: object, /) -> Field: ...
    def __truediv__(self, other: object, /) -> Field: ...
    @property
    def array(self, /) -> NDArray[float64]:
        """
        A read-only array of shape (ny, nx) on the memory of the field, without a copy.
        """
    def get(self, /, ix: int, iy: int) -> float | None:
        """
        The sample of a cell, by column and row; ``None`` beyond the grid.
        """
    @property
    def grid(self, /) -> Grid:
        """
        The grid.
        """
    def integral(self, /) -> float:
        """
        The sum of the samples times the area of a cell.
        """
    def max(self, /) -> float:
        """
        The largest sample; NaN is passed over.
        """
    def mean(self, /) -> float:
        """
        The mean of the samples.
        """
    def min(self, /) -> float:
        """
        The least sample; NaN is passed over.
        """
    @property
    def shape(self, /) -> tuple[int, int]:
        """
        Its shape as an array, (ny, nx).
        """
    def to_unit(self, /, unit: str) -> Field:
        """
        A surface in another unit: its heights and the sides of its cells, from its own unit.

        Units are m, dm, cm, mm, um, nm, pm and A, and the micro sign in the place of u.

        Raises
        ------
        ValueError
            If the unit of the surface is not known, or either is none of these.
        """
    @property
    def unit(self, /) -> str | None:
        """
        The unit of the lengths of a surface, if it is known.
        """

@final
class Filled:
    """
    A surface whose missing heights (NaN) are filled smoothly.
    """
    def __repr__(self, /) -> str: ...
    @property
    def filled_cells(self, /) -> int:
        """
        How many were missing.
        """
    @property
    def heights(self, /) -> Field:
        """
        All heights (lengths).
        """

@final
class Filtered:
    """
    A filtered surface, and what the filter has taken off: the three add up to the surface given.
    """
    def __repr__(self, /) -> str: ...
    @property
    def heights(self, /) -> Field:
        """
        The heights that are left (lengths); missing ones stay missing.
        """
    @property
    def long_waves(self, /) -> Field | None:
        """
        The long waves that the L filter has taken off (lengths), the waviness; ``None`` without an L filter.
        """
    @property
    def short_waves(self, /) -> Field | None:
        """
        The short waves that the S filter has taken off (lengths), such as noise; ``None`` without an S filter.
        """
    @property
    def valid_range(self, /) -> tuple[tuple[int, int], tuple[int, int]]:
        """
        The columns and rows that no edge affects, half a nesting index from each, as :func:`crop` takes them.
        """

@final
class FlatPunch:
    """
    The flat end of a rigid round cylinder pressed on a half-space.

    The gap is zero within the radius a, and there is no contact outside it. For two elastic bodies this is the
    solution of half-spaces with that gap. Johnson (1985), section 3.4 and 3.36-3.37.

    Parameters
    ----------
    pair : ElasticPair
        The bodies.
    radius : float
        Radius a of the flat end (a length), positive.
    load : float
        Normal load W (a force), positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair, radius: float, load: float) -> FlatPunch: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def approach(self, /) -> float:
        """
        Approach of the bodies, delta = W / (2 a E*) (a length), positive.
        """
    @property
    def contact_area(self, /) -> float:
        """
        Area of the contact circle, pi a^2 (a length squared).
        """
    @property
    def contact_radius(self, /) -> float:
        """
        Radius a of the flat end, and of the contact circle (a length).
        """
    def displacement(self, /, r: ArrayLike) -> Any:
        """
        Normal displacement of the surfaces (a length), summed over the bodies and positive into each, at the
        distance r from the centre: the approach inside the contact, and outside it (2 delta / pi) arcsin(a/r).
        """
    def full_stick(self, /, friction: float, force: float) -> MindlinFullStick:
        """
        The punch in full stick under a tangential force along x. Traction and pressure are distributed alike: the
        whole contact sticks up to the force mu W, and then slides at once.

        Parameters
        ----------
        friction : float
            Coefficient of friction mu (dimensionless), not negative.
        force : float
            Tangential force on body 1 along x, of either sign.

        Raises
        ------
        NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
        """
    @property
    def load(self, /) -> float:
        """
        Normal load W (a force), positive in compression.
        """
    @property
    def mean_pressure(self, /) -> float:
        """
        Mean pressure over the contact circle, W / (pi a^2), twice the pressure at the centre.
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The bodies.
        """
    def pressure(self, /, r: ArrayLike) -> Any:
        """
        Pressure W / (2 pi a sqrt(a^2 - r^2)) at the distance r from the centre. It grows without bound towards the
        edge; at the edge and outside zero is returned.
        """

@final
class Friction:
    """
    Coulomb friction, uniform or one coefficient per cell, optionally capped: the friction limit of a cell is
    ``min(mu p, tau_max)``.

    Parameters
    ----------
    coefficient : float, Field or array_like of shape (ny, nx)
        Coefficient of friction mu (dimensionless), not negative.
    max_shear_stress : float, optional
        The shear strength tau_max of the weaker body (a pressure), positive; no limit by default.
    grid : Grid, optional
        Where an array lives; a Field knows it.

    Raises
    ------
    NegativeOrNotFinite, Sample, Shape, NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, coefficient: Field | ArrayLike, *, max_shear_stress: float | None = None, grid: Grid | None = None) -> Friction: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def limit(self, /, index: int, pressure: float) -> float:
        """
        The friction limit of a cell (row-major index) under a pressure; NaN beyond the coefficients.
        """

@final
class Grid:
    """
    A rectangular grid of equal cells, centred on the origin.

    Parameters
    ----------
    nx, ny : int
        Cells along x and y, at least one.
    dx, dy : float
        Sides of a cell along x and y (lengths), positive.

    Raises
    ------
    GridSize, NotPositive

    Examples
    --------
    >>> import stickslip
    >>> grid = stickslip.Grid.square(128, 0.4e-3)
    >>> grid.shape, grid.dx
    ((128, 128), 3.125e-06)
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __hash__(self, /) -> int:
        """
        Equal grids have equal ones.
        """
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, nx: int, ny: int, dx: float, dy: float) -> Grid: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def area(self, /) -> float:
        """
        Area of all cells (a length squared).
        """
    @property
    def cell_area(self, /) -> float:
        """
        Area of a cell (a length squared).
        """
    @property
    def cells(self, /) -> int:
        """
        Number of cells.
        """
    @property
    def dx(self, /) -> float:
        """
        Side of a cell along x (a length).
        """
    @property
    def dy(self, /) -> float:
        """
        Side of a cell along y (a length).
        """
    @property
    def extent(self, /) -> tuple[float, float, float, float]:
        """
        Edges of the grid ``(left, right, bottom, top)`` (lengths), as matplotlib's ``imshow`` takes them.
        """
    @staticmethod
    def line(n: int, dx: float) -> Grid:
        """
        A line of ``n`` cells along x, each ``dx`` long and one unit of length wide: forces are per length.
        """
    @property
    def nx(self, /) -> int:
        """
        Cells along x.
        """
    @property
    def ny(self, /) -> int:
        """
        Cells along y.
        """
    @property
    def rows(self, /) -> slice:
        """
        The rows of the :attr:`whole` grid that it has, a slice: ``array[grid.rows]`` are those of an array of the whole.
        """
    @property
    def shape(self, /) -> tuple[int, int]:
        """
        Shape of the arrays on it, (ny, nx).
        """
    @staticmethod
    def square(n: int, side: float) -> Grid:
        """
        ``n`` x ``n`` square cells on a square of this side (a length): the side of the square, not of a cell.
        """
    @property
    def whole(self, /) -> Grid:
        """
        The grid of which it is some rows, as :meth:`HalfSpace.distributed` deals them out; itself if it is no such part.
        """
    @property
    def x(self, /) -> NDArray[float64]:
        """
        Coordinates of the cell centres along x (lengths).
        """
    @property
    def y(self, /) -> NDArray[float64]:
        """
        Coordinates of the cell centres along y (lengths).
        """

@final
class HalfSpace:
    """
    A pair of half-spaces on a grid. What problems need of it is made when first needed, and shared. Two of equal grid,
    bodies, boundary and meaning of the values are equal.

    Parameters
    ----------
    grid : Grid
        The cells that may come into contact.
    pair : ElasticPair, two Materials, or Kernel
        The two bodies; z points into the first.
    boundary : Boundary or str, default "non_periodic"
        What lies beyond the edge of the grid: "non_periodic", "periodic" or ("periodic_along_y", datum).
    cell_value : CellValue or str, default "uniform"
        The meaning of the pressure and the traction of a cell: "uniform" over it, or that at its "centre".

    Raises
    ------
    NotPositive, Memory, BelowMinimum, UnsupportedForCoatings, IncompleteKernel, GridMismatch, Length, UnsupportedByModel

    Examples
    --------
    >>> import stickslip
    >>> steel = stickslip.Material(213e9, 0.29)
    >>> bodies = stickslip.HalfSpace(stickslip.Grid.square(64, 0.4e-3), (steel, steel))
    >>> bodies.grid.cells
    4096
    """
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self, /) -> int:
        """
        Equal bodies have equal ones.
        """
    def __new__(cls, /, grid: Grid, pair: ElasticPair | Kernel | tuple[Material, Material], boundary: Boundary | str | tuple[str, float] | None = None, cell_value: CellValue | str | None = None) -> HalfSpace: ...
    def __reduce__(self, /) -> tuple[type, tuple[Grid, ElasticPair, Boundary, CellValue]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def boundary(self, /) -> Boundary:
        """
        What lies beyond the edge of the grid.
        """
    @property
    def cell_value(self, /) -> CellValue:
        """
        The meaning of the pressure and the traction of a cell.
        """
    @staticmethod
    def distributed(grid: Grid, pair: ElasticPair | Kernel | tuple[Material, Material], comm: Any, boundary: Boundary | str | tuple[str, float] | None = None, cell_value: CellValue | str | None = None) -> HalfSpace:
        """
        Bodies whose rows are dealt out to the ranks of a communicator, which solve together. Every rank makes them, and then
        the same calls in the same order. Its grid, and all arrays, are those of its rows (:attr:`Grid.rows`); what is said of the
        whole contact, such as forces, areas, reports and spots, every rank knows. The answers have the bits of one process.

        Parameters
        ----------
        grid : Grid
            The whole one.
        pair : ElasticPair, two Materials, or Kernel
            The two bodies; z points into the first.
        comm : mpi4py.MPI.Comm, or any object with three of its methods
            ``Get_rank()``, ``Get_size()`` and ``sendrecv(block, dest=, source=)``, which sends ``bytes`` to one rank and returns
            those of another, of any length, in the order in which they were sent. Nothing else may be received there: give the
            duplicate of a communicator that is used elsewhere. It is called one call at a time, also on threads of the
            package. An exception in it is :class:`~stickslip.errors.Ranks`, and goes to `sys.unraisablehook` itself.
        boundary : Boundary or str, default "non_periodic"
            As of the class.
        cell_value : CellValue or str, default "uniform"
            As of the class.

        Raises
        ------
        NotPositive, Memory, BelowMinimum, UnsupportedForCoatings, IncompleteKernel, GridMismatch, Ranks

        Notes
        -----
        Ranks may be threads of one process: each then makes its bodies, and solves, on a thread of its own.

        Examples
        --------
        Run as ``mpirun -n 4 python -m mpi4py press.py``, which ends all ranks when one has failed::

            from mpi4py import MPI
            import stickslip as ss

            pair = ss.Material(213e9, 0.29), ss.Material.rigid()
            bodies = ss.HalfSpace.distributed(ss.Grid.square(4096, 0.4e-3), pair, MPI.COMM_WORLD.Dup())
            ball = ss.surface.sphere(bodies.grid, 3.5e-3)  # its own rows
            normal = ss.NormalProblem(bodies, ball, force=100.0).solve()
            print(bodies.grid.rows, normal.pressure.shape, normal.contact_area)
        """
    @property
    def grid(self, /) -> Grid:
        """
        The grid; of :meth:`distributed` bodies the rows of this rank.
        """
    def operator(self, /, component: Component | str) -> LinearOperator:
        """
        The operator of one component on the whole grid, made at the first call: displacement first, traction second.

        Examples
        --------
        >>> import numpy as np, stickslip
        >>> grid = stickslip.Grid(5, 3, 1.0, 1.0)
        >>> bodies = stickslip.HalfSpace(grid, (stickslip.Material(1.0, 0.3), stickslip.Material.rigid()))
        >>> bodies.operator("zz")(np.ones(grid.shape)).shape
        (3, 5)
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The two bodies.
        """
    def preconditioner(self, /, component: Component | str) -> LinearOperator | None:
        """
        The circulant preconditioner of one component; ``None`` for all but xx, yy and zz.
        """
    def tensor_operator(self, /) -> TensorOperator:
        """
        The operator of all three directions: displacements along x, y and z from tractions along x, y and z.
        """

@final
class Hardness:
    """
    The largest pressure that the softer body carries, of all cells or of each. Cells at it yield.

    Parameters
    ----------
    limit : float, Field or array_like of shape (ny, nx)
        The largest pressure: a positive number, or one of each cell that is not negative; where it is zero nothing is
        carried.
    grid : Grid, optional
        Where an array lives; a Field knows it.

    Raises
    ------
    NotPositive, Sample, Shape
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, limit: Field | ArrayLike, *, grid: Grid | None = None) -> Hardness: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def capacity(self, /, grid: Grid) -> float:
        """
        The largest normal force that the cells of a grid carry.
        """
    def of_cell(self, /, index: int) -> float:
        """
        The largest pressure of a cell (row-major index); NaN beyond the limits.
        """
    def overlap(self, /, contact: NormalSolution) -> Field:
        """
        By how much the surfaces of a solved contact overlap where its pressure is at the limit (lengths).
        """

@final
class HertzEllipse:
    """
    A paraboloid with two different curvatures pressed on a half-space.

    The gap is x^2 / 2R_x + y^2 / 2R_y. Johnson (1985), 4.26-4.32.

    Parameters
    ----------
    pair : ElasticPair
        The bodies.
    radius_x, radius_y : float
        Radii of curvature R_x and R_y along x and y (lengths), positive.
    load : float
        Normal load W (a force), positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair, radius_x: float, radius_y: float, load: float) -> HertzEllipse: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def approach(self, /) -> float:
        """
        Approach of the bodies, delta = p_0 b K / E* (a length, positive), with the shorter semi-axis b and the
        complete elliptic integral K of the parameter 1 - b^2/a^2. Johnson (1985), 4.26c.
        """
    @property
    def contact_area(self, /) -> float:
        """
        Area of the contact ellipse, pi a b with the semi-axes a and b (a length squared).
        """
    @property
    def load(self, /) -> float:
        """
        Normal load W (a force), positive in compression.
        """
    @property
    def max_pressure(self, /) -> float:
        """
        Pressure at the centre, p_0 = 3 W / (2 pi a b). Johnson (1985), 4.27.
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The bodies.
        """
    def pressure(self, /, x: ArrayLike, y: ArrayLike) -> Any:
        """
        Pressure p_0 sqrt(1 - x^2/a_x^2 - y^2/a_y^2); zero outside the contact. Johnson (1985), 3.58.
        """
    @property
    def radii(self, /) -> tuple[float, float]:
        """
        Radii of curvature (R_x, R_y) (lengths).
        """
    @property
    def semi_axes(self, /) -> tuple[float, float]:
        """
        Semi-axes a_x and a_y of the contact ellipse along x and y (lengths). Johnson (1985), 4.28-4.31.
        """

@final
class HertzLine:
    """
    A cylinder pressed on a half-space along a line, in plane strain.

    The gap is x^2 / 2R. Exact for a parabola. Johnson (1985), 4.43-4.45.

    Parameters
    ----------
    pair : ElasticPair
        The bodies.
    radius : float
        Radius R of the cylinder (a length), positive; of two cylinders 1/R = 1/R_1 + 1/R_2.
    load : float
        Normal load P (a force per length), positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair, radius: float, load: float) -> HertzLine: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def approach(self, /, datum: ArrayLike) -> Any:
        """
        Approach of the bodies, P / (pi E*) (2 ln(2d/a) + 1) (a length), relative to the datum d (a length) of
        :meth:`Boundary.periodic_along_y`; positive for a datum that is large beside a, as it must be.
        """
    @property
    def half_width(self, /) -> float:
        """
        Half-width of the contact, a = sqrt(4 P R / (pi E*)) (a length).
        """
    @property
    def load(self, /) -> float:
        """
        Normal load P (a force per length), positive in compression.
        """
    @property
    def max_pressure(self, /) -> float:
        """
        Pressure at the middle, p_0 = 2 P / (pi a).
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The bodies.
        """
    def pressure(self, /, x: ArrayLike) -> Any:
        """
        Pressure p_0 sqrt(1 - x^2/a^2) at the distance x from the middle; zero outside the contact.
        """
    @property
    def radius(self, /) -> float:
        """
        Radius R of the cylinder (a length).
        """
    def stress(self, /, x: ArrayLike, depth: ArrayLike) -> tuple[Any, Any, Any]:
        """
        Stresses xx, zz and xz of body 1 at x and at a depth below its surface, a length of zero or more (pressures,
        positive in tension); those of body 2 at the same depth differ by the sign of xz. M'Ewen (1949); Johnson (1985),
        4.49.
        """
    def surface_stress(self, /, x: ArrayLike) -> Any:
        """
        Stress xx of the surface of either body at x (a pressure, positive in tension): minus the pressure in the
        contact, zero outside.
        """

@final
class HertzSphere:
    """
    A sphere pressed on a half-space, or a paraboloid of revolution.

    The gap is r^2 / 2R. Exact for a paraboloid; for a sphere it holds while the contact is small beside R. Johnson
    (1985), 4.22-4.24.

    Parameters
    ----------
    pair : ElasticPair
        The bodies.
    radius : float
        Radius R of the sphere (a length), positive; of two spheres 1/R = 1/R_1 + 1/R_2.
    load : float
        Normal load W (a force), positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair, radius: float, load: float) -> HertzSphere: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def approach(self, /) -> float:
        """
        Approach of the bodies, delta = a^2 / R (a length), positive.
        """
    @property
    def contact_area(self, /) -> float:
        """
        Area of the contact circle, pi a^2 (a length squared).
        """
    @property
    def contact_radius(self, /) -> float:
        """
        Radius of the contact circle, a = (3 W R / (4 E*))^(1/3) (a length).
        """
    def displacement(self, /, r: ArrayLike) -> Any:
        """
        Normal displacement u_z of the surfaces (a length), summed over the bodies and positive into each, at the
        distance r from the centre, inside and outside the contact. Johnson (1985), 3.41a and 3.42a.
        """
    def gap(self, /, r: ArrayLike) -> Any:
        """
        Gap u_z + r^2 / 2R - delta between the surfaces (a length) at the distance r from the centre; zero in the
        contact, positive outside.
        """
    @property
    def load(self, /) -> float:
        """
        Normal load W (a force), positive in compression.
        """
    @property
    def max_pressure(self, /) -> float:
        """
        Pressure at the centre, p_0 = 3 W / (2 pi a^2).
        """
    @property
    def mean_pressure(self, /) -> float:
        """
        Mean pressure over the contact circle, W / (pi a^2) = (2/3) p_0.
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The bodies.
        """
    def pressure(self, /, r: ArrayLike) -> Any:
        """
        Pressure p_0 sqrt(1 - r^2/a^2) at the distance r from the centre; zero outside the contact. Johnson (1985),
        3.39.
        """
    @property
    def radius(self, /) -> float:
        """
        Radius R of the sphere (a length).
        """

@final
class History:
    """
    Two bodies in contact that remember their load: pressure, traction, slip and energy, step by step.

    Its arrays are copies, since the next step changes them; :meth:`state` is a snapshot whose arrays are views. One thread
    at a time may use it. A step that fails, or that Ctrl-C ends, leaves it as it was.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    gap : Field or array_like of shape (ny, nx)
        The gap before loading (lengths); copied.
    friction : Friction, float or array_like of shape (ny, nx)
        Coulomb friction; a number or an array is the coefficient of friction (dimensionless, not negative).
    axis : Axis or str, default "x"
        The axis of tangential load and tractions in the scalar model; the vector model has none.
    model : TangentialModel or str, default "scalar"
        "scalar" finds the traction along the axis; "vector" both components, and takes loads of any direction and twist.
    coupling : Coupling or str, default "full"
        Of bodies of different materials: "full" finds pressure and traction together, "one_way" has the pressure move the
        surfaces tangentially, "neglected" neither.
    entry_rule : EntryRule or str, default "since_touch"
        How far a cell that comes into contact within a step follows its motion: "since_touch" from the moment it touches,
        "whole_step" all of it.
    relative_displacement : RelativeDisplacement, optional
        The pattern of a displacement that the contact does not cause, of which steps prescribe the amount; none by default.
    hardness : Hardness, float or array_like of shape (ny, nx), optional
        The largest pressure that the cells carry; no limit by default.
    permanent_set : bool, default False
        Whether what yields under the hardness stays, and is added to the gap of later steps.
    settings : Settings, optional
        Method, tolerance and limits; those of ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        As of :class:`Settings`; they take precedence over ``settings``.

    Raises
    ------
    GridMismatch, Shape, Sample, UnsupportedByModel, Method, Tolerance, IterationLimit

    Examples
    --------
    >>> import stickslip
    >>> grid = stickslip.Grid.square(48, 0.3e-3)
    >>> steel = stickslip.Material(213e9, 0.29)
    >>> bodies = stickslip.HalfSpace(grid, (steel, steel))
    >>> history = stickslip.History(bodies, stickslip.surface.sphere(grid, 3.5e-3), 0.5)
    >>> step = history.step(normal_force=100.0)
    >>> cycle = sum(history.step(force_x=force).energy.dissipated_energy for force in (30.0, -30.0, 30.0))
    >>> history.step(force_x=0.0).shift[0] > 0.0  # without force, not without shear
    True
    """
    def __new__(cls, /, bodies: HalfSpace, gap: Field | ArrayLike, friction: Friction | float | ArrayLike, *, axis: Axis | str | None = None, model: TangentialModel | str | None = None, coupling: Coupling | str | None = None, entry_rule: EntryRule | str | None = None, relative_displacement: RelativeDisplacement | None = None, hardness: Hardness | float | ArrayLike | None = None, permanent_set: bool = False, settings: Settings | None = None, tolerance: float | None = None, method: Method | str | None = None, max_iterations: int | None = None, time_limit: float | None = None) -> History: ...
    def __reduce__(self, /) -> tuple[Any, tuple[type, HalfSpace, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def accumulated_slip(self, /) -> NDArray[float64]:
        """
        Length of the path that each cell slipped since the start (lengths, not negative), a copy.
        """
    @property
    def approach(self, /) -> float:
        """
        Approach of the bodies from the datum of the gap (a length).
        """
    @property
    def axis(self, /) -> Axis | None:
        """
        The axis of the scalar model; ``None`` in the vector model.
        """
    @property
    def bodies(self, /) -> HalfSpace:
        """
        The bodies.
        """
    @property
    def boundary(self, /) -> Boundary:
        """
        What lies beyond the edge of the grid.
        """
    @property
    def contact(self, /) -> NDArray[bool_]:
        """
        Whether a cell is in contact, booleans of shape (ny, nx): its pressure is positive; a copy.
        """
    def displacement(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Displacement of body 1 relative to body 2 by the tractions along x and y (lengths): one product.
        """
    @property
    def dissipated_energy(self, /) -> NDArray[float64]:
        """
        Energy that each cell dissipated since the start (not negative), a copy.
        """
    def edges(self, /) -> TangentialEdges:
        """
        The edges of the contact and of the stick zone inside the cells after the last step, under the friction as last set.
        """
    @property
    def friction(self, /) -> Friction:
        """
        The friction.
        """
    @property
    def friction_capacity(self, /) -> float:
        """
        Largest tangential force that friction holds.
        """
    @staticmethod
    def from_bytes(bodies: HalfSpace, bytes: bytes) -> History:
        """
        A history from its bytes, on the bodies it had; it continues to the same bits.
        """
    @staticmethod
    def from_state(bodies: HalfSpace, state: State) -> History:
        """
        A history that continues from a state, on the bodies it belongs to.
        """
    @property
    def gap(self, /) -> NDArray[float64]:
        """
        The gap before loading (lengths), as last set; a copy.
        """
    @property
    def grid(self, /) -> Grid:
        """
        The grid.
        """
    @property
    def last_step(self, /) -> StepResult:
        """
        What the last step did.
        """
    @staticmethod
    def load(bodies: HalfSpace, path: str | PathLike[str]) -> History:
        """
        A history from a file of :meth:`save`, on the bodies it had.
        """
    @property
    def moment(self, /) -> float:
        """
        Moment about z, at the origin of the grid, on body 1 (a force times a length, positive from x to y).
        """
    @property
    def normal(self, /) -> NormalSolution:
        """
        The normal contact, a copy.
        """
    def press(self, /, load: LoadStep | None = None, *, tolerance: float, normal_force: float | None = None, approach: float | None = None, progress: Any | None = None, warn: bool = True) -> int:
        """
        Takes a load in as many steps of equal growth of the contact as a tolerance needs. A contact of dissimilar bodies must
        be pressed so: which cells stick and slip depends on how the contact grows.

        It takes the load in 1, 2, 4, 8, ... steps from the present state, until the tractions differ from those of half as many
        steps by no more than the tolerance. A call that fails, or that Ctrl-C ends, leaves the state unchanged; the last step is
        then the last one that succeeded.

        Parameters
        ----------
        load : LoadStep, optional
            The load as an object, instead of by keywords; all that it prescribes is reached in proportion.
        tolerance : float
            Largest sum of the lengths of the differences of the tractions, over the sum of the friction limits, in (0, 1):
            0.01 is a good choice. It must be at least about a hundred times the tolerance of the settings.
        normal_force, approach : optional
            As of :class:`LoadStep`.
        progress : callable or bool, optional
            As of :meth:`NormalProblem.solve`.
        warn : bool, default True
            If true, the warnings of the last step are issued through ``warnings`` too.

        Returns
        -------
        int
            The number of steps.

        Raises
        ------
        Tolerance, StepTooLong
            And what :meth:`step` raises.
        """
    @property
    def pressure(self, /) -> NDArray[float64]:
        """
        Pressure, not negative; exactly zero outside the contact. A copy.
        """
    def save(self, /, path: str | PathLike[str]) -> None:
        """
        Saves the state in a file, which is replaced as a whole or not at all.
        """
    def set_friction(self, /, friction: Friction | float | ArrayLike) -> None:
        """
        Changes the friction of later steps.
        """
    def set_gap(self, /, gap: Field | ArrayLike) -> None:
        """
        Changes the gap of later steps (lengths), as wear does.
        """
    def set_relative_displacement(self, /, pattern: RelativeDisplacement) -> None:
        """
        Changes the pattern of the relative displacement.
        """
    def set_state(self, /, state: State) -> None:
        """
        Returns to a state, of this history or of another on equal bodies.
        """
    @property
    def settings(self, /) -> Settings:
        """
        Method, tolerance and limits of later steps; may be assigned.
        """
    @settings.setter
    def settings(self, /, settings: Settings) -> None: ...
    @property
    def shift(self, /) -> tuple[float, float]:
        """
        Shift of body 2 relative to body 1 since the start, along x and y (lengths).
        """
    @property
    def slip(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Slip since the start along x and y (lengths), copies.
        """
    @property
    def spots(self, /) -> ContactSpots:
        """
        The contact spots, with their stick ratios. All ranks that share the history ask for them.
        """
    def state(self, /) -> State:
        """
        A snapshot of the state.
        """
    def step(self, /, load: LoadStep | None = None, *, normal_force: float | None = None, approach: float | None = None, force: Sequence[float] | NDArray[Any] | None = None, shift: Sequence[float] | NDArray[Any] | None = None, spring: tuple[Sequence[float], float] | None = None, force_x: float | None = None, force_y: float | None = None, shift_x: float | None = None, shift_y: float | None = None, spring_x: tuple[float, float] | None = None, spring_y: tuple[float, float] | None = None, twist: float | None = None, relative_displacement: float | None = None, roll: Rolling | None = None, progress: Any | None = None, warn: bool = True) -> StepResult:
        """
        Takes a step, given as a :class:`LoadStep` or by its keywords. A load without a keyword is held. Dissimilar bodies are pressed by
        :meth:`press`.

        A step without a tangential load holds the shift, not the tangential force. The force falls where a lighter pressure or
        less friction cannot carry it: name the force in each step to keep it.

        Parameters
        ----------
        load : LoadStep, optional
            The step as an object, instead of by keywords.
        normal_force, approach, force, shift, spring, force_x, ..., roll : optional
            As of :class:`LoadStep`.
        progress : callable or bool, optional
            As of :meth:`NormalProblem.solve`.
        warn : bool, default True
            Whether the remarks on the step go to ``warnings`` too, each kind once a place.

        Returns
        -------
        StepResult
            Its fields last until the next step; see :meth:`StepResult.keep`.

        Raises
        ------
        NotFinite, NegativeOrNotFinite, NotPositive, ApproachBeyondMeanGap, UnsupportedByModel, BeyondFrictionCapacity, EmptyContact,
        GridTooShort, NotConverged
        """
    @staticmethod
    def step_all(histories: Sequence[History], loads: Sequence[LoadStep], *, warn: bool = True) -> list[tuple[int, Any]]:
        """
        Takes a step of each of many histories, at once.

        Parameters
        ----------
        histories : sequence of History
            Each named once.
        loads : sequence of LoadStep
            One of each history.
        warn : bool, default True
            Whether the remarks on the steps go to ``warnings`` too, each kind once a place.

        Returns
        -------
        list of (int, StickslipError)
            The places and errors of those whose step has failed; they are as they were.

        Raises
        ------
        Length
        """
    @property
    def steps(self, /) -> int:
        """
        Steps taken since the start.
        """
    def stiffness(self, /, *, next_step: bool = False) -> ContactStiffness:
        """
        The stiffness: the slopes of the forces and the moment by approach, shift and twist.

        Parameters
        ----------
        next_step : bool, default False
            If true, ``tangential.loading`` and ``by_approach`` are derivatives of a next step, which starts from the present
            state. Otherwise they are derivatives of the last step. In the next step cells that stick resist fully, also
            those that came into contact in the last step, and cells at their limit continue to slip. A host that shears the
            contact further under the same normal load needs this.
        """
    @property
    def tangential_force(self, /) -> tuple[float, float]:
        """
        Tangential force that body 2 exerts on body 1 along x and y.
        """
    def to_bytes(self, /) -> bytes:
        """
        Its bytes: all that the next step needs but the bodies.
        """
    @property
    def traction(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Shear traction on body 1 along x and y (pressures), copies.
        """
    @property
    def twist(self, /) -> float:
        """
        Rotation of body 2 relative to body 1 since the start (radians, positive from x to y).
        """
    @property
    def zones(self, /) -> NDArray[uint8]:
        """
        The zone of every cell: 0 separated, 1 stick, 2 slip.
        """

@final
class Iteration:
    """
    One step of an iteration, as a progress callback receives it.

    Residual and free entries are the last measured ones.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def double_precision_products(self, /) -> int:
        """
        Products with the operator in double precision so far.
        """
    @property
    def free(self, /) -> int:
        """
        Entries strictly between their bounds: contact cells, or cells that stick.
        """
    @property
    def iteration(self, /) -> int:
        """
        Conjugate-gradient steps so far.
        """
    @property
    def residual(self, /) -> float:
        """
        Largest complementarity residual, relative to the largest displacement.
        """
    @property
    def single_precision_products(self, /) -> int:
        """
        Products in single precision so far.
        """

@final
class JaegerSuperposition:
    """
    Jaeger's superposition: the traction of a contact under one force as the difference of two pressures.

    Parameters
    ----------
    full, stick : NormalSolution
        The contact under its load W, and the same bodies under the load W - F / mu for a tangential force F: its contact
        is the stick zone.
    pair : ElasticPair
        The bodies. The coupling between pressure and traction of different materials is neglected.
    friction : float
        Coefficient of friction mu (dimensionless), not negative.

    Raises
    ------
    NegativeOrNotFinite, GridMismatch, BoundaryMismatch, MaterialMismatch, NotConverged, EmptyContact
    """
    def __new__(cls, /, full: NormalSolution, stick: NormalSolution, pair: ElasticPair, friction: float) -> JaegerSuperposition: ...
    def __repr__(self, /) -> str: ...
    @property
    def force(self, /) -> float:
        """
        The tangential force, mu times the difference of the two loads.
        """
    @property
    def shift(self, /) -> float:
        """
        The shift, the rigid motion of body 2 relative to body 1 (a length).
        """
    @property
    def traction(self, /) -> NDArray[float64]:
        """
        The traction along the load (pressures).
        """
    @property
    def zones(self, /) -> NDArray[uint8]:
        """
        The zone of every cell, as of :attr:`TangentialSolution.zones`.
        """

@final
class KalkerCoefficients:
    """
    Kalker's creepage and spin coefficients: the forces of an elliptic contact that rolls along x with creepages so
    small that it sticks but at its trailing edge.

    With the semi-axes a along x and b along y, c = sqrt(a b), and the shear modulus G of two equal bodies, creepages xi
    along x and eta along y and the spin phi cause on body 1 F_x = G c^2 C11 xi, F_y = G c^2 (C22 eta + c C23 phi) and
    M = G c^3 (C32 eta + c C33 phi). The values are those of solves of this package, right to about 0.1 % (C33 to
    0.3 %). Kalker (1990), table E.3.

    Parameters
    ----------
    ratio : float
        a/b, from 1/16 to 16.
    poisson_ratio : float
        Poisson's ratio of both bodies, from 0 to 1/2; of bodies that differ with Dundurs' beta zero, that of the one
        that is as compliant, and G is twice its modulus.

    Raises
    ------
    NotPositive, BelowMinimum, PoissonRatio
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, ratio: float, poisson_ratio: float) -> KalkerCoefficients: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def c11(self, /) -> float:
        """
        Force along x by the creepage along x.
        """
    @property
    def c22(self, /) -> float:
        """
        Force along y by the creepage along y.
        """
    @property
    def c23(self, /) -> float:
        """
        Force along y by the spin.
        """
    @property
    def c32(self, /) -> float:
        """
        Moment by the creepage along y, -C23.
        """
    @property
    def c33(self, /) -> float:
        """
        Moment by the spin.
        """

@final
class Kernel:
    """
    Two bodies by a response of your own, in place of the pair of a :class:`HalfSpace`: made by :meth:`isotropic`,
    :meth:`tabulated` or :meth:`operators`. It is not pickled, nor are the bodies made of it.

    Examples
    --------
    >>> import stickslip as ss
    >>> rigid, steel = ss.Material.rigid(), ss.Material(210e9, 0.3)
    >>> coated = ss.ElasticPair(steel.coated([ss.layers.Layer(400e9, 0.25, 2e-6)]), rigid)
    >>> def response(k):
    ...     found = coated.response(k)
    ...     return found.normal, found.along, found.across, found.coupling
    >>> outermost = ss.ElasticPair(ss.Material(400e9, 0.25), rigid)
    >>> kernel = ss.Kernel.isotropic(outermost, 2e-6, response)
    >>> grid = ss.Grid.square(32, 20e-6)
    >>> ball = ss.surface.sphere(grid, 1e-3)
    >>> contact, same = (
    ...     ss.NormalProblem(ss.HalfSpace(grid, bodies), ball, force=0.01).solve() for bodies in (kernel, coated)
    ... )
    >>> abs(contact.approach / same.approach - 1) < 1e-6
    True
    """
    def __repr__(self, /) -> str: ...
    @staticmethod
    def isotropic(near: ElasticPair, thickness: float, response: Any) -> Kernel:
        """
        Bodies without a direction in their plane.

        Parameters
        ----------
        near : ElasticPair
            The homogeneous half-spaces that waves much shorter than the thickness see, to 1e-10 for k > 20 / thickness; they
            lend hardness and moduli. Grids that repeat along both axes take the response as it is.
        thickness : float
            Of the outermost layer (a length), positive.
        response : callable
            Of a wave number k > 0 (one over a length), as a float: the displacements by waves of traction of that number
            (lengths over pressures, not times k): normal by pressure, along and across the wave by traction, and the coupling.
            It is called many times, under the GIL, on many threads; where it raises an exception, it counts as not a number,
            which is refused, and the exception goes to `sys.unraisablehook`; Ctrl-C there interrupts the main thread.

        Raises
        ------
        NotPositive, NotFinite, UnsupportedForCoatings
        """
    @staticmethod
    def operators(near: ElasticPair, grid: Grid, operators: dict[str, Any], *, lower_bounds: dict[str, Any] | None = None) -> Kernel:
        """
        Bodies by operators on the cells of a grid, of any boundary: whatever displacements they compute from tractions.

        A contact is solved on all cells of the grid: no window, no coarser grids. A problem takes the operator that has all
        directions it asks for and the fewest others: normal problems ask for "z", tangential ones for "x", "y" or both, and
        all three are found together where ``near`` is coupled. Rolling, ranks, dense matrices, edges inside the cells and
        stresses refuse such bodies.

        Parameters
        ----------
        near : ElasticPair
            The homogeneous half-spaces that they resemble for waves of a few cells, whose inverse preconditions the solves: they
            converge the faster the better it fits, to the same answer. It lends hardness and moduli, and says whether pressure
            and traction are coupled.
        grid : Grid
            The cells.
        operators : dict
            By the directions that it couples, as "z", "xy" or "xyz", a callable or a :class:`~stickslip.cgm.LinearOperator`,
            symmetric and positive. A callable is given an array of tractions of shape (directions, ny, nx), pressures in the
            direction z, and returns as many displacements of body 1 relative to body 2 in the same order (lengths). A
            LinearOperator has as many unknowns: :class:`~stickslip.dense.DenseOperator` takes the compliance matrix of a
            finite-element code. On a grid that repeats along both axes uniform tractions must displace nothing.
        lower_bounds : dict, optional
            By the names of callables, lower bounds of their smallest eigenvalues, by which errors are certified; 0 by default.
            Without one pressure and traction are not found together, nor stiffness. A LinearOperator has its own.

        Raises
        ------
        UnsupportedForCoatings, IncompleteKernel, RepeatedDirection, NotPositive, NotFinite, UnsupportedByModel, BelowMinimum, Memory

        Notes
        -----
        A callable runs under the GIL, on a thread of the package where a grid is large. An exception in it ends the solve, which
        raises it and leaves solvers and histories as they were.

        Examples
        --------
        A bed of springs, of which each cell yields by 0.5 under a unit of pressure:

        >>> import math, stickslip as ss
        >>> near = ss.ElasticPair(ss.Material(1.0, 0.5), ss.Material.rigid())
        >>> grid = ss.Grid.square(32, 1.0)
        >>> bed = ss.Kernel.operators(near, grid, {"z": lambda p: 0.5 * p}, lower_bounds={"z": 0.5})
        >>> ball, depth = ss.surface.sphere(grid, 1.0), 0.06
        >>> contact = ss.NormalProblem(ss.HalfSpace(grid, bed), ball, approach=depth).solve()
        >>> abs(contact.force / (math.pi * depth**2 / 0.5) - 1) < 0.02  # p = (d - r^2 / 2 R) / c
        True
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The pair that lends hardness and moduli, marked as that of this kernel.
        """
    @staticmethod
    def tabulated(near: ElasticPair, sides: Sequence[float] | NDArray[Any], coefficients: dict[str, Any]) -> Kernel:
        """
        Bodies by their influence coefficients, for grids that do not repeat.

        Parameters
        ----------
        near : ElasticPair
            Homogeneous bodies that lend hardness and moduli.
        sides : (float, float)
            Sides of a cell along x and y (lengths): those of the grids.
        coefficients : dict
            By the name of a component, "zz" and others, an array of shape (ny, nx): the displacement at the centre of a cell,
            j cells further along y and i along x, by a unit traction on one (lengths over pressures). Distances of the other
            sign follow from the parity. "xy", "zx" and "zy" are zero where they are not given, and "yx", "xz" and "yz" are
            theirs.

        Raises
        ------
        NotPositive, Length, Sample, UnsupportedForCoatings
        """

@final
class Layer:
    """
    An elastic, isotropic layer bonded to what lies below it.

    Parameters
    ----------
    youngs_modulus : float
        Young's modulus (a pressure), positive.
    poisson_ratio : float
        Poisson's ratio, in (-1, 0.5].
    thickness : float
        Thickness (a length), positive.

    Raises
    ------
    NotPositive, PoissonRatio

    Examples
    --------
    >>> import stickslip as ss
    >>> oxide = ss.layers.Layer(380e9, 0.22, 5e-6)
    >>> anodised = ss.Material(70e9, 0.33).coated([oxide])
    >>> anodised.layers[0].thickness
    5e-06
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __hash__(self, /) -> int:
        """
        Equal layers have equal ones.
        """
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, youngs_modulus: float, poisson_ratio: float, thickness: float) -> Layer: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def poisson_ratio(self, /) -> float:
        """
        Poisson's ratio.
        """
    @property
    def shear_modulus(self, /) -> float:
        """
        Shear modulus (a pressure).
        """
    @property
    def thickness(self, /) -> float:
        """
        Thickness (a length).
        """
    @property
    def youngs_modulus(self, /) -> float:
        """
        Young's modulus (a pressure).
        """

@final
class Levelled:
    """
    A surface without its form.
    """
    def __repr__(self, /) -> str: ...
    @property
    def form(self, /) -> Field:
        """
        What was taken off (lengths).
        """
    @property
    def heights(self, /) -> Field:
        """
        The heights left (lengths).
        """

@disjoint_base
class LinearOperator:
    """
    A linear operator from tractions to displacements, one number a cell.

    Made by :meth:`HalfSpace.operator`, :meth:`HalfSpace.preconditioner`, :class:`stickslip.fft.Convolution`,
    :class:`stickslip.dense.DenseOperator` or :func:`stickslip.cgm.identity`.
    """
    def __call__(self, /, x: Any) -> NDArray[float64]: ...
    def __repr__(self, /) -> str: ...
    def apply(self, /, x: Any, out: Any | None = None) -> NDArray[float64]:
        """
        The product with an array of as many numbers as there are cells, which is read where it lies.

        Parameters
        ----------
        x : array_like
            Tractions (pressures), as many numbers as there are cells.
        out : ndarray, optional
            Where the result goes: C-contiguous, of float64, not overlapping ``x``.

        Returns
        -------
        ndarray of the shape of ``x``
            Displacements (lengths).
        """
    @property
    def cells(self, /) -> int:
        """
        Unknowns.
        """
    @property
    def eigenvalue_bound(self, /) -> EigenvalueBound:
        """
        How that is known: "proven", "estimated" (stiff coatings on long grids), or "unknown", which is zero.
        """
    @property
    def lower_bound(self, /) -> float:
        """
        A lower bound of the smallest eigenvalue.
        """

@final
class LoadPath:
    """
    A cycle of a tangential load in the plane, as the values (x, y) at the ends of its steps: forces or shifts, as the
    caller means them. It is a sequence of pairs.

    Parameters
    ----------
    steps : sequence of pairs of float, or array_like of shape (n, 2)
        The values (x, y) at the ends of the steps (forces or lengths).

    Raises
    ------
    EmptyPath, Sample

    Examples
    --------
    >>> from stickslip.history import LoadPath
    >>> path = LoadPath.sine((20.0, 0.0), 40)
    >>> len(path), path[9], path.end
    (40, (20.0, 0.0), (0.0, 0.0))
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __getitem__(self, index: int, /) -> tuple[float, float]: ...
    def __len__(self, /) -> int: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, steps: Sequence[Sequence[float]] | NDArray[Any]) -> LoadPath: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def cycles(self, /, count: int) -> list[tuple[float, float]]:
        """
        The values of so many cycles, one after the other.
        """
    @staticmethod
    def ellipse(amplitudes: Sequence[float] | NDArray[Any], phase: float, steps: int) -> LoadPath:
        """
        Around an ellipse of amplitudes (A_x, A_y), A_x sin(2 pi t) along x and A_y sin(2 pi t + phase) along y (the phase in
        radians), in a multiple of four steps.
        """
    @property
    def end(self, /) -> tuple[float, float]:
        """
        The value where a cycle ends, and the next begins.
        """
    @staticmethod
    def sine(amplitude: Sequence[float] | NDArray[Any], steps: int) -> LoadPath:
        """
        To and fro along a line, the amplitude (x, y) times sin(2 pi t), in a multiple of four steps: from zero to the
        amplitude, to its negative, and back to zero. A path along x has the amplitude (a, 0).
        """
    @property
    def steps(self, /) -> NDArray[float64]:
        """
        The values of one cycle, of shape (steps, 2).
        """
    @staticmethod
    def triangle(amplitude: Sequence[float] | NDArray[Any], steps: int) -> LoadPath:
        """
        To and fro along a line at a constant rate, in a multiple of four steps.
        """

@final
class LoadStep:
    """
    What a step of a history prescribes at its end; all that is not named is held.

    Parameters
    ----------
    normal_force, approach : float, optional
        One of the two, the normal force (not negative) or the approach of the bodies from the datum of the gap (a length,
        positive when they come together); without either the pressure is held.
    force, shift : pair of float, optional
        Along x and y, of either sign, as totals since the start of the history: the force that body 2 exerts on body 1; the
        shift of body 2 relative to body 1 (lengths).
    spring : ((x, y), stiffness), optional
        Springs along both axes that drag body 2, by the position of their far ends (lengths) and their stiffness (a force
        over a length, positive).
    force_x, force_y, shift_x, shift_y : float, optional
        The same along one axis.
    spring_x, spring_y : (position, stiffness), optional
        The same along one axis.
    twist : float, optional
        Rotation of body 2 relative to body 1 since the start (radians, positive from x to y). The vector model alone has it.
    relative_displacement : float, optional
        Amount of the relative displacement of the history: a factor of its pattern.
    roll : stickslip.history.Rolling, optional
        With rolling: the memory of the particles moves through the contact, and body 2 creeps over body 1 on the way. Along
        an axis of which the step names the force the creepage follows; it names no shift, no spring and no twist. Normal
        load, gap and friction may change in the same step.

    Examples
    --------
    >>> import stickslip
    >>> press = stickslip.LoadStep(normal_force=100.0)
    >>> drag = stickslip.LoadStep(shift_x=1e-6)
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, *, normal_force: float | None = None, approach: float | None = None, force: Sequence[float] | NDArray[Any] | None = None, shift: Sequence[float] | NDArray[Any] | None = None, spring: tuple[Sequence[float], float] | None = None, force_x: float | None = None, force_y: float | None = None, shift_x: float | None = None, shift_y: float | None = None, spring_x: tuple[float, float] | None = None, spring_y: tuple[float, float] | None = None, twist: float | None = None, relative_displacement: float | None = None, roll: Rolling | None = None) -> LoadStep: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @staticmethod
    def of(load: TangentialLoad) -> LoadStep:
        """
        The tangential half alone, with the twist of the load; the pressure is held.
        """

@final
class LoopPoint:
    """
    A point of the loop of force and shift.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def force(self, /) -> tuple[float, float]:
        """
        Tangential force on body 1 along x and y.
        """
    @property
    def moment(self, /) -> float:
        """
        Moment about z (a force times a length, positive from x to y).
        """
    @property
    def shift(self, /) -> tuple[float, float]:
        """
        Shift since the start of the history, along x and y (lengths).
        """
    @property
    def twist(self, /) -> float:
        """
        Rotation since the start of the history (radians, positive from x to y).
        """

@final
class LoopPoints:
    """
    The loop of force and shift of a cycle, its beginning and the end of each step: a sequence of :class:`LoopPoint`, and
    arrays with a number of each point. Vectors are (x, y).
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __getitem__(self, index: int, /) -> LoopPoint: ...
    def __iter__(self, /) -> Iterator[LoopPoint]: ...
    def __len__(self, /) -> int: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def force(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Tangential force on body 1 along x and y.
        """
    @property
    def moment(self, /) -> NDArray[float64]:
        """
        Moment about z (a force times a length, positive from x to y).
        """
    @property
    def shift(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Shift since the start of the history, along x and y (lengths).
        """
    @property
    def twist(self, /) -> NDArray[float64]:
        """
        Rotation since the start of the history (radians, positive from x to y).
        """

@final
class LubkinTorsion:
    """
    A sphere in torsion: a constant normal load, then a twist about the normal that increases monotonically.

    A disc of radius c sticks and rotates rigidly; the ring around it slips. The traction is along circles about the
    centre and equals mu p in the ring. The coupling between pressure and traction of dissimilar bodies is neglected. Lubkin
    (1951); Johnson (1985), section 7.2.

    Parameters
    ----------
    hertz : HertzSphere
        The normal contact.
    friction : float
        Coefficient of friction mu (dimensionless), positive.
    twist : float
        Rotation of body 2 relative to body 1 about the normal (radians), of either sign, positive from x to y.

    Raises
    ------
    NotPositive, NotFinite
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, hertz: HertzSphere, friction: float, twist: float) -> LubkinTorsion: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def hertz(self, /) -> HertzSphere:
        """
        The normal contact.
        """
    @property
    def moment(self, /) -> float:
        """
        Moment about the normal on body 1 (a force times a length), of the sign of the twist; (16/3) G a^3 beta for
        small twists.
        """
    @property
    def sliding_moment(self, /) -> float:
        """
        Moment at which the whole contact slides, (3 pi / 16) mu W a (a force times a length, positive): the limit of
        the moment for large twists.
        """
    @property
    def stick_radius(self, /) -> float:
        """
        Radius c of the stick disc (a length), positive: where beta = (mu p_0 / 2G) (K - E), with the complete elliptic
        integrals of the parameter 1 - c^2/a^2.
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Fraction of the contact area that sticks, c^2/a^2.
        """
    def traction(self, /, r: ArrayLike) -> Any:
        """
        Traction q on body 1 (a pressure, of the sign of the twist) at the distance r from the centre, along the circle
        of that radius from x to y: q_x = -q y/r, q_y = q x/r. Zero outside the contact.
        """
    @property
    def twist(self, /) -> float:
        """
        Twist beta: the rigid rotation of body 2 relative to body 1 (radians), positive from x to y.
        """

@final
class Material:
    """
    A linear elastic, isotropic half-space, homogeneous or :meth:`coated`.

    Parameters
    ----------
    youngs_modulus : float
        Young's modulus (a pressure), positive.
    poisson_ratio : float
        Poisson's ratio, in (-1, 0.5].
    hardness : float, optional
        The hardness (a pressure), positive; none by default. Solutions that press harder warn, and nothing else changes: a
        problem whose pressure is to be limited takes a ``hardness`` of its own.

    Raises
    ------
    NotPositive, PoissonRatio

    Examples
    --------
    >>> import stickslip
    >>> steel = stickslip.Material(210e9, 0.3)
    >>> round(steel.shear_modulus / 1e9, 1)
    80.8
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __hash__(self, /) -> int:
        """
        Equal materials have equal ones.
        """
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, youngs_modulus: float, poisson_ratio: float, *, hardness: float | None = None) -> Material: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def coated(self, /, layers: Sequence[Layer]) -> Material:
        """
        This body under layers that are bonded to it, the outermost first; over those it has. On a rigid body they are a bed on
        a rigid base. The moduli of a coated body are those of what lies below the layers, and a hardness stated before is
        kept.

        Parameters
        ----------
        layers : sequence of Layer
            At most eight in all.

        Raises
        ------
        TooManyLayers
        """
    @staticmethod
    def from_shear_modulus(shear_modulus: float, poisson_ratio: float) -> Material:
        """
        From the shear modulus (a pressure) instead of Young's.
        """
    @property
    def hardness(self, /) -> float:
        """
        The hardness stated (a pressure); infinite if none is.
        """
    @property
    def is_coated(self, /) -> bool:
        """
        Whether it is coated.
        """
    @property
    def is_rigid(self, /) -> bool:
        """
        Whether it is rigid.
        """
    @property
    def layers(self, /) -> list[Layer]:
        """
        The layers of a coated body, the outermost first.
        """
    def plane_strain_under(self, /, stress: float) -> float:
        """
        The strain along x under a stress along x (a pressure) of a body that cannot contract along y,
        stress (1 - nu^2) / E; positive where it is stretched.
        """
    @property
    def poisson_ratio(self, /) -> float:
        """
        Poisson's ratio; zero for a rigid body.
        """
    @staticmethod
    def rigid() -> Material:
        """
        A body that does not deform.
        """
    @property
    def shear_modulus(self, /) -> float:
        """
        Shear modulus (a pressure); infinite for a rigid body.
        """
    @property
    def youngs_modulus(self, /) -> float:
        """
        Young's modulus (a pressure); infinite for a rigid body.
        """

@final
class MindlinDeresiewicz:
    """
    A sphere in partial slip: a constant normal load, and a tangential force along x with any history.

    From zero to the first reversal it is :class:`CattaneoMindlin`. Every reversal adds twice that solution for half the
    change of force since. When the force returns to an earlier reversal it closes a loop, and the contact continues
    as if that loop had not occurred. This is the solution of the scalar model, with traction along x only. The coupling
    between pressure and traction of dissimilar bodies is neglected. Mindlin and Deresiewicz (1953); Jaeger (1998); Johnson
    (1985), 7.52-7.57.

    Parameters
    ----------
    hertz : HertzSphere
        The normal contact.
    friction : float
        Coefficient of friction mu (dimensionless), not negative.
    path : sequence of float
        Values that the tangential force on body 1 along x takes in turn, from zero (forces, of either sign, at most
        mu W); none is no force.

    Raises
    ------
    NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, hertz: HertzSphere, friction: float, path: Sequence[float] | NDArray[Any]) -> MindlinDeresiewicz: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def amplitude(self, /) -> float:
        """
        Largest magnitude F_0 of the force so far.
        """
    def displacement(self, /, x: ArrayLike, y: ArrayLike) -> Any:
        """
        Tangential displacement u_x of body 1 relative to body 2 (a length), anywhere in the plane, superposed as the
        class says.
        """
    @property
    def dissipated_energy(self, /) -> float:
        """
        Energy dissipated along the whole path (a force times a length, not negative).
        """
    @property
    def energy_per_cycle(self, /) -> float:
        """
        Energy that one full cycle of the force between F_0 and -F_0 dissipates (a force times a length),
        (4/5) mu W delta_0 (1 - c/a)^3 (1 + 3 c/a + c^2/a^2) with c = a (1 - F_0 / (mu W))^(1/3).
        """
    @property
    def force(self, /) -> float:
        """
        Tangential force F on body 1 at the end of the path, positive along +x.
        """
    @property
    def hertz(self, /) -> HertzSphere:
        """
        The normal contact.
        """
    @property
    def shift(self, /) -> float:
        """
        Shift delta_x (a length): the rigid motion of body 2 relative to body 1 since before the first loading.
        """
    @property
    def sliding_shift(self, /) -> float:
        """
        Shift at which the whole contact begins to slide at the first loading, delta_0 (a length, positive).
        """
    def slip(self, /, x: ArrayLike, y: ArrayLike) -> Any:
        """
        Slip u_x - delta_x (a length): the motion of the surface of body 1 over that of body 2 since before the first
        loading; zero outside the contact, and where the surfaces have never slipped.
        """
    @property
    def stick_radius(self, /) -> float:
        """
        Radius of the disc that has not slipped since the last reversal of the force (a length): during the first
        loading a (1 - |F| / (mu W))^(1/3), and a (1 - |F - F_n| / (2 mu W))^(1/3) after a reversal at F_n.
        """
    def traction(self, /, r: ArrayLike) -> Any:
        """
        Traction on body 1 along x (a pressure) at the distance r from the centre, superposed as the class says; zero
        outside the contact.
        """

@final
class MindlinFullStick:
    """
    A contact circle in full stick under a tangential force along x.

    For a sphere it is the limit of :class:`CattaneoMindlin` for large friction; under a :class:`FlatPunch` it holds up
    to sliding. The circle moves along x only, whatever nu. The coupling between pressure and traction of dissimilar bodies
    is neglected. Mindlin (1949); Johnson (1985), 3.82 and section 7.2.

    Parameters
    ----------
    pair : ElasticPair
        The bodies.
    contact_radius : float
        Radius a of the contact circle (a length), positive.
    force : float
        Tangential force F on body 1 along x, of either sign.

    Raises
    ------
    NotPositive, NotFinite
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair, contact_radius: float, force: float) -> MindlinFullStick: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def contact_radius(self, /) -> float:
        """
        Radius a of the contact circle (a length).
        """
    def displacement(self, /, x: ArrayLike, y: ArrayLike) -> Any:
        """
        Tangential displacement of body 1 relative to body 2 along x (a length, of the sign of the force), anywhere in
        the plane: the shift inside the contact; at the distance r and the angle theta outside it
        F / (4 pi G a) ((2 - nu) s + nu sin(s) cos(s) cos(2 theta)), with sin(s) = a/r.
        """
    @property
    def force(self, /) -> float:
        """
        Tangential force F on body 1, positive along +x.
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The bodies.
        """
    @property
    def shift(self, /) -> float:
        """
        Shift F (2 - nu) / (8 G a) (a length): the rigid motion of body 2 relative to body 1, of the sign of the force.
        """
    def traction(self, /, r: ArrayLike) -> Any:
        """
        Traction F / (2 pi a sqrt(a^2 - r^2)) on body 1 along x (a pressure, of the sign of the force) at the distance r
        from the centre. It grows without bound towards the edge; at the edge and outside zero is returned.
        """

@final
class Minimum:
    """
    A constrained minimum.
    """
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def multiplier(self, /) -> float:
        """
        The multiplier of the total; zero without one.
        """
    @property
    def report(self, /) -> Report:
        """
        How the solve ended.
        """
    @property
    def x(self, /) -> NDArray[float64]:
        """
        The unknowns, a read-only view.
        """

@final
class NoSlipPunch:
    """
    A flat-ended round punch pressed without any slip, as by friction without limit.

    Where pressure and traction are coupled, by Dundurs' beta, sticking makes the contact stiffer by the factor
    artanh(beta) / beta. Mossakovskii (1954); Borodich & Keer, Proc. R. Soc. Lond. A 460 (2004) 507.

    Parameters
    ----------
    pair : ElasticPair
        The bodies.
    radius : float
        Radius a of the flat end (a length), positive.
    load : float
        Normal load W (a force), positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair, radius: float, load: float) -> NoSlipPunch: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def approach(self, /) -> float:
        """
        Approach of the bodies, W beta / (2 a E* artanh(beta)) (a length), positive.
        """
    @property
    def contact_radius(self, /) -> float:
        """
        Radius a of the flat end, and of the contact circle (a length).
        """
    @property
    def load(self, /) -> float:
        """
        Normal load W (a force), positive in compression.
        """

@final
class NoSlipSphere:
    """
    A sphere pressed by a growing load without any slip: a point that has come into contact sticks.

    Without coupling between pressure and traction it is Hertz's contact. Spence, Proc. R. Soc. Lond. A 305 (1968) 55.

    Parameters
    ----------
    pair : ElasticPair
        The bodies.
    radius : float
        Radius R of the sphere (a length), positive.
    load : float
        Normal load W (a force), positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair, radius: float, load: float) -> NoSlipSphere: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def approach(self, /) -> float:
        """
        Approach of the bodies (a length), positive.
        """
    @property
    def contact_radius(self, /) -> float:
        """
        Radius of the contact circle (a length).
        """
    @property
    def load(self, /) -> float:
        """
        Normal load W (a force), positive in compression.
        """
    @property
    def radius(self, /) -> float:
        """
        Radius R of the sphere (a length).
        """

@final
class NormalProblem:
    """
    Bodies, gap and load of a normal contact.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    gap : Field or array_like of shape (ny, nx)
        The gap before loading (lengths). An array is copied, a Field is shared.
    force, approach : float
        One of the two: the normal force (not negative), or the approach of the bodies from the datum of the gap (a length,
        positive when they come together). On a grid that repeats along x and y the approach is the mean of the initial gap
        less that of the gap under load, and must stay below the mean gap.
    hardness : Hardness, float or array_like of shape (ny, nx), optional
        The largest pressure that the cells carry; no limit by default.
    settings : Settings, optional
        Method, tolerance and limits; those of ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        As of :class:`Settings`; they take precedence over ``settings``.

    Raises
    ------
    GridMismatch, Shape, Sample, NegativeOrNotFinite, NotFinite, Tolerance, IterationLimit, ApproachBeyondMeanGap, BeyondHardness

    Examples
    --------
    >>> import stickslip
    >>> grid = stickslip.Grid.square(64, 0.4e-3)
    >>> steel = stickslip.Material(213e9, 0.29)
    >>> bodies = stickslip.HalfSpace(grid, (steel, steel))
    >>> ball = stickslip.surface.sphere(grid, 3.5e-3)
    >>> contact = stickslip.NormalProblem(bodies, ball, force=100.0).solve()
    >>> hertz = stickslip.analytical.HertzSphere(bodies.pair, 3.5e-3, 100.0)
    >>> bool(abs(contact.pressure.max() / hertz.max_pressure - 1.0) < 2e-3)
    True
    """
    def __getnewargs_ex__(self, /) -> tuple[tuple[Any, ...], dict[str, Any]]: ...
    def __new__(cls, /, bodies: HalfSpace, gap: Field | ArrayLike, *, force: float | None = None, approach: float | None = None, hardness: Hardness | float | ArrayLike | None = None, settings: Settings | None = None, tolerance: float | None = None, method: Method | str | None = None, max_iterations: int | None = None, time_limit: float | None = None) -> NormalProblem: ...
    def __repr__(self, /) -> str: ...
    def solve(self, /, *, progress: Any | None = None, warn: bool = True) -> NormalSolution:
        """
        Solves once.

        Parameters
        ----------
        progress : callable or bool, optional
            Called with an :class:`Iteration` before each product; what it raises ends the solve. ``True`` shows a bar of
            tqdm.
        warn : bool, default True
            Whether the remarks of the solution go to ``warnings`` too, each kind once a place.

        Returns
        -------
        NormalSolution

        Raises
        ------
        NotConverged
            With ``report`` and ``last_iterate``.
        """
    def solver(self, /) -> NormalSolver:
        """
        A solver of this problem, which keeps its buffers and starts each solve from the last answer.
        """

@final
class NormalSolution:
    """
    Pressure, gap and approach of a normal contact. Arrays are read-only views of its memory. Two are equal if their answers
    are, however they were found.
    """
    def __eq__(self, other: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def approach(self, /) -> float:
        """
        Approach of the bodies from the datum of the initial gap (a length). On a grid that repeats along x and y: the mean of
        the initial gap less that of the gap under load.
        """
    @property
    def boundary(self, /) -> Boundary:
        """
        What lies beyond the edge of the grid.
        """
    @property
    def cell_value(self, /) -> CellValue:
        """
        The meaning of the value of a cell.
        """
    @property
    def centre_of_pressure(self, /) -> tuple[float, float] | None:
        """
        Where the normal force acts (lengths); ``None`` without contact.
        """
    @property
    def contact(self, /) -> NDArray[bool_]:
        """
        Whether a cell is in contact, booleans of shape (ny, nx): its pressure is positive. They are what ``contact_cells``
        and ``contact_area`` count; a copy.
        """
    @property
    def contact_area(self, /) -> float:
        """
        Contact area by counting cells: that of the discrete contact, on which ``mean_pressure``, the stick ratio and the areas
        of spots are based. It reads high, by about 0.3 cell sides over the contact radius.
        """
    @property
    def contact_area_corrected(self, /) -> float:
        """
        Contact area less the excess of counting along the perimeter: the one to compare with theory and with other grids,
        nearer to the continuum by a factor of about four (Yastrebov, Anciaux & Molinari 2017).
        """
    @property
    def contact_cells(self, /) -> int:
        """
        Number of contact cells.
        """
    @property
    def contact_extent(self, /) -> tuple[float, float] | None:
        """
        Sides of the contact's bounding box along x and y (lengths); ``None`` without contact.
        """
    @property
    def discretisation_estimate(self, /) -> float | None:
        """
        An estimate of the discretisation error of the pressure: the sum over the cells of its differences from the exact means,
        relative to the sum of the pressure; ``None`` without contact.
        """
    def displacement(self, /, bodies: HalfSpace) -> NDArray[float64]:
        """
        Normal displacement of all cells by the pressure, that of body 1 plus that of body 2 (lengths, positive where the
        surfaces give way), shape (ny, nx): one product.
        """
    def edges(self, /) -> Edges:
        """
        The edge of the contact inside the cells, and the pressure there.
        """
    def elastic_energy(self, /, bodies: HalfSpace) -> float:
        """
        Elastic energy of the normal contact (a force times a length): one product.
        """
    @property
    def force(self, /) -> float:
        """
        Normal force, the integral of the pressure.
        """
    @property
    def gap(self, /) -> NDArray[float64]:
        """
        Gap under load (lengths), shape (ny, nx): zero in the contact up to the residual, negative where cells yield.
        """
    @property
    def grid(self, /) -> Grid:
        """
        The grid of its fields.
        """
    @property
    def mean_pressure(self, /) -> float:
        """
        Normal force over contact area; zero without contact.
        """
    @property
    def moments(self, /) -> tuple[float, float]:
        """
        Moments about x and y, at the origin of the grid, that the pressure exerts on body 1 (forces times lengths).
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The two bodies.
        """
    @property
    def pressure(self, /) -> NDArray[float64]:
        """
        Pressure p >= 0, shape (ny, nx); exactly zero outside the contact.
        """
    @property
    def report(self, /) -> Report:
        """
        How the solve ended, what it cost, how large its error can be.
        """
    @property
    def spots(self, /) -> ContactSpots:
        """
        The contact spots, one by one. All ranks that share the contact ask for them.
        """
    def stiffness(self, /, bodies: HalfSpace) -> NormalStiffness:
        """
        The normal stiffness, the slope of the force by the approach (a force over a length): one solve on the contact cells.
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Remarks on a result that may mislead; empty if there are none.
        """
    @property
    def yielded_cells(self, /) -> int:
        """
        Cells at their hardness.
        """

@final
class NormalSolver:
    """
    Solves normal contacts on one grid again and again, each time from the last answer. Takes what
    :class:`NormalProblem` takes; load and gap may change between calls.

    One thread at a time may use it. The memory of a solution that nobody holds any more is used again.

    Examples
    --------
    >>> import stickslip
    >>> grid = stickslip.Grid.square(32, 8.0)
    >>> bodies = stickslip.HalfSpace(grid, (stickslip.Material(1.0, 0.3), stickslip.Material.rigid()))
    >>> solver = stickslip.NormalSolver(bodies, stickslip.surface.sphere(grid, 10.0), force=0.5)
    >>> [round(solver.solve(force=force).force, 12) for force in (0.5, 1.0, 0.7)]
    [0.5, 1.0, 0.7]
    """
    def __new__(cls, /, bodies: HalfSpace, gap: Field | ArrayLike, *, force: float | None = None, approach: float | None = None, hardness: Hardness | float | ArrayLike | None = None, settings: Settings | None = None, tolerance: float | None = None, method: Method | str | None = None, max_iterations: int | None = None, time_limit: float | None = None) -> NormalSolver: ...
    def __repr__(self, /) -> str: ...
    def reset(self, /) -> None:
        """
        Forgets the last answer: the next solve starts as the first did.
        """
    def set_gap(self, /, gap: Field | ArrayLike) -> None:
        """
        Changes the gap of the next solve, as wear does.
        """
    def set_load(self, /, *, force: float | None = None, approach: float | None = None) -> None:
        """
        Changes the load of the next solve.
        """
    @property
    def settings(self, /) -> Settings:
        """
        The settings of the next solve; may be assigned.
        """
    @settings.setter
    def settings(self, /, settings: Settings) -> None: ...
    def solve(self, /, *, force: float | None = None, approach: float | None = None, gap: Field | ArrayLike | None = None, progress: Any | None = None, warn: bool = True) -> NormalSolution:
        """
        Solves, for this load and gap if they are given, else for the last ones.

        Parameters
        ----------
        force, approach : float, optional
            At most one of the two, as of :class:`NormalProblem`.
        gap : Field or array_like of shape (ny, nx), optional
            The gap before loading (lengths); copied.
        progress, warn : optional
            As of :meth:`NormalProblem.solve`.

        Returns
        -------
        NormalSolution

        Raises
        ------
        GridMismatch, Shape, Sample, NegativeOrNotFinite, NotFinite, ApproachBeyondMeanGap, BeyondHardness
            For load and gap; both are then as they were.
        NotConverged
            With ``report`` and ``last_iterate``.
        """

@final
class NormalStiffness:
    """
    The slope of the normal force by the approach (a force over a length), with a bound of its relative error.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __float__(self, /) -> float: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __repr__(self, /) -> str: ...
    @property
    def bound(self, /) -> float:
        """
        Bound of its relative error; infinite where pressure and traction are found together.
        """
    @property
    def value(self, /) -> float:
        """
        The slope (a force over a length), zero without contact.
        """

@final
class Persson:
    """
    A nominally flat rough surface pressed on a half-space: the fraction of the area in real contact.

    It is erf((sqrt(pi)/2) kappa P) under the reduced pressure P = mean_pressure / (E* rms_slope), which is kappa P for
    light loads. kappa is sqrt(8/pi) in Persson's theory, the default, and sqrt(2 pi) in that of Bush, Gibson and Thomas;
    simulations give 2.0 to 2.2. A mean over infinite surfaces whose shortest waves are resolved. Persson (2001); Bush,
    Gibson and Thomas (1975).

    Parameters
    ----------
    pair : ElasticPair
        The bodies.
    rms_slope : float
        Root mean square of the gradient (Sdq, dimensionless), positive: sqrt(2) times the slope of profiles of an
        isotropic surface.
    mean_pressure : float
        Load over nominal area, positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair, rms_slope: float, mean_pressure: float) -> Persson: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def area_coefficient(self, /) -> float:
        """
        Coefficient kappa of the area (dimensionless).
        """
    @staticmethod
    def area_law(reduced_pressure: float, area_coefficient: float) -> float:
        """
        The contact fraction of any surface at a reduced pressure P (not negative), with a coefficient kappa (positive;
        both dimensionless).
        """
    @property
    def contact_fraction(self, /) -> float:
        """
        Fraction of the nominal area in real contact.
        """
    @property
    def mean_pressure(self, /) -> float:
        """
        Mean pressure: the load over the nominal area.
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The bodies.
        """
    @property
    def reduced_pressure(self, /) -> float:
        """
        Reduced pressure P = mean_pressure / (E* rms_slope) (dimensionless).
        """
    @property
    def rms_slope(self, /) -> float:
        """
        Root mean square of the gradient (dimensionless).
        """
    def stick_ratio(self, /, friction: float, mean_traction: float) -> float:
        """
        Fraction of the real contact area that sticks: the contact area under 1 - f of the load over that under all of
        it, f = |mean_traction| / (mu mean_pressure). Ciavarella (1998); Jaeger (1998).

        Parameters
        ----------
        friction : float
            Coefficient of friction mu (dimensionless), not negative.
        mean_traction : float
            Tangential force over nominal area, of either sign.

        Raises
        ------
        NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
        """
    def with_area_coefficient(self, /, area_coefficient: float) -> Persson:
        """
        The same contact with another coefficient kappa (dimensionless, positive).
        """

@final
class Plane:
    """
    Stress, and displacement if it was asked for, at the cell centres of a plane below the surface. Arrays are views,
    those of derived stresses are new.
    """
    def __repr__(self, /) -> str: ...
    @property
    def body(self, /) -> Body:
        """
        The body.
        """
    @property
    def depth(self, /) -> float:
        """
        Depth below the surface of the body (a length).
        """
    @property
    def displacement(self, /) -> tuple[NDArray[float64], NDArray[float64], NDArray[float64]] | None:
        """
        Displacement along x, y and z (lengths), if it was asked for.
        """
    def get(self, /, ix: int, iy: int) -> Stress | None:
        """
        The stress of a cell, by column and row; ``None`` beyond the grid.
        """
    @property
    def grid(self, /) -> Grid:
        """
        The grid.
        """
    @property
    def hydrostatic(self, /) -> NDArray[float64]:
        """
        Mean of the normal stresses (pressures, tensile positive).
        """
    @property
    def max_shear(self, /) -> NDArray[float64]:
        """
        Largest shear stress (pressures).
        """
    @property
    def normal_stress(self, /) -> tuple[NDArray[float64], NDArray[float64], NDArray[float64]]:
        """
        Components xx, yy and zz (pressures, tensile positive).
        """
    @property
    def shear_stress(self, /) -> tuple[NDArray[float64], NDArray[float64], NDArray[float64]]:
        """
        Components xy, xz and yz (pressures).
        """
    @property
    def von_mises(self, /) -> NDArray[float64]:
        """
        Von Mises' equivalent stress (pressures), of shape (ny, nx).
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Remarks that a value may mislead: on a plane nearer to the surface than a side of a cell, if shear tractions end at
        the edge of a contact; empty if there are none.
        """
    @property
    def z(self, /) -> float:
        """
        Position along z (a length), negative in body two.
        """

@final
class Planes:
    """
    Stresses on planes at chosen depths below each body, by fast transforms; the kernels of a depth are made when it is
    first solved, and kept.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    depths : array_like
        Depths below the surface of each body (lengths), not negative.
    displacements : bool, default False
        Whether displacements are found too.

    Raises
    ------
    Sample, Memory

    Examples
    --------
    >>> import stickslip
    >>> grid = stickslip.Grid.square(64, 0.4)
    >>> steel = stickslip.Material(210e3, 0.3)
    >>> bodies = stickslip.HalfSpace(grid, (steel, steel))
    >>> contact = stickslip.NormalProblem(bodies, stickslip.surface.sphere(grid, 5.0), force=100.0).solve()
    >>> hertz = stickslip.analytical.HertzSphere(bodies.pair, 5.0, 100.0)
    >>> planes = stickslip.subsurface.Planes(bodies, [0.481 * hertz.contact_radius])
    >>> plane = planes.solve(0, "one", contact)
    >>> round(float(plane.max_shear.max()) / hertz.max_pressure, 3)
    0.31
    """
    def __new__(cls, /, bodies: HalfSpace, depths: Sequence[float] | NDArray[Any], *, displacements: bool = False) -> Planes: ...
    def __repr__(self, /) -> str: ...
    @property
    def depths(self, /) -> NDArray[float64]:
        """
        The depths (lengths).
        """
    def solve(self, /, index: int, body: Body | str, tractions: Any, *, uniform_stress: Stress | None = None, warn: bool = True) -> Plane:
        """
        The plane at the depth of this index, which counts from the end if it is negative, in a body; the tractions as of
        :func:`at_points`.

        Parameters
        ----------
        uniform_stress : Stress, optional
            As of :func:`at_points`: bulk stress, which is added.
        warn : bool, default True
            Whether :attr:`Plane.warnings` go to ``warnings`` too, each kind once a place.

        Raises
        ------
        IndexError
            If there is no such depth.
        RigidBody, Memory, GridMismatch, BoundaryMismatch, MaterialMismatch, Sample
        """
    def solve_all(self, /, body: Body | str, tractions: Any, *, uniform_stress: Stress | None = None, warn: bool = True) -> list[Plane]:
        """
        The planes of all depths in a body, as of :meth:`solve`.
        """
    def write_vti(self, /, path: str | PathLike[str], body: Body | str, tractions: Any, *, uniform_stress: Stress | None = None) -> None:
        """
        Writes the stresses of all depths in a body as a volume for ParaView, as of :meth:`solve`.
        """

@final
class PopovLimitingShape:
    """
    The limiting shape of a paraboloid of revolution worn by small oscillations at a constant approach, when wear has
    ceased.

    The disc of radius c that sticks does not wear. The ring around it wears until it carries no pressure and the
    surfaces just touch there. The law of wear decides how fast this shape is reached, but not the shape. Exact where
    Dundurs' beta is zero and the stick disc stays round. Popov (2014).

    Parameters
    ----------
    pair : ElasticPair
        The bodies.
    radius : float
        Radius R of the paraboloid before wear, whose gap is r^2 / 2R (a length), positive.
    approach : float
        Approach d of the bodies (a length), positive.
    stick_radius : float
        Radius c of the stick disc (a length), not negative, at most the contact radius sqrt(R d) before wear; zero is
        gross sliding.

    Raises
    ------
    NotPositive, NegativeOrNotFinite, BelowMinimum
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair, radius: float, approach: float, stick_radius: float) -> PopovLimitingShape: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def approach(self, /) -> float:
        """
        Approach d of the bodies (a length), constant throughout.
        """
    @property
    def load(self, /) -> float:
        """
        Remaining normal load, 2 E* (d c - c^3 / 3R) (a force).
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The bodies.
        """
    def pressure(self, /, r: ArrayLike) -> Any:
        """
        Remaining pressure (E*/pi) (2 s / R + (d - c^2/R) / s), s = sqrt(c^2 - r^2), at the distance r from the centre;
        zero outside the stick disc, towards whose edge it grows without bound.
        """
    def profile(self, /, r: ArrayLike) -> Any:
        """
        Gap without load (a length) at the distance r from the centre, zero at the centre: in the ring
        (2/pi) ((r^2/2 arcsin(c/r) - c/2 sqrt(r^2 - c^2)) / R + d (pi/2 - arcsin(c/r))), elsewhere r^2 / 2R.
        """
    @property
    def radius(self, /) -> float:
        """
        Radius R of the paraboloid before wear (a length).
        """
    @property
    def stick_radius(self, /) -> float:
        """
        Radius c of the stick disc (a length).
        """
    def wear_depth(self, /, r: ArrayLike) -> Any:
        """
        Wear depth (a length), summed over the bodies, at the distance r from the centre: positive in the ring, zero
        elsewhere.
        """
    @property
    def worn_radius(self, /) -> float:
        """
        Radius within which the surfaces are worn (a length), larger than that of the contact before wear.
        """
    @property
    def worn_volume(self, /) -> float:
        """
        Worn volume (a length cubed), summed over the bodies.
        """

@final
class PowerSpectrum:
    """
    The radial average of the power spectrum of a surface that repeats.

    Parameters
    ----------
    heights : Field or topography
        Lengths, none missing.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, heights: Field | ArrayLike) -> PowerSpectrum: ...
    def __repr__(self, /) -> str: ...
    @property
    def modes(self, /) -> NDArray[uint64]:
        """
        Wave vectors in each ring; q and -q are two.
        """
    @property
    def moments(self, /) -> tuple[float, float, float]:
        """
        Spectral moments m0 (a length squared), m2 (a number) and m4 (one over a length squared).
        """
    @property
    def nayak_parameter(self, /) -> float:
        """
        Nayak's parameter.
        """
    @property
    def rms_mean_curvature(self, /) -> float:
        """
        Root mean square of the mean curvature (one over a length).
        """
    @property
    def values(self, /) -> NDArray[float64]:
        """
        Mean spectral density C of the waves of each ring (a length to the fourth): ``2 pi`` times the integral of ``C q`` over
        the wave numbers q is the square of the rms height.
        """
    @property
    def wave_numbers(self, /) -> NDArray[float64]:
        """
        Mean wave number ``2 pi / wavelength`` of the waves of each ring (radians over lengths), in ascending order.
        """

@final
class Principal:
    """
    Principal stresses, the largest first, and the unit vector of each.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def directions(self, /) -> list[list[float]]:
        """
        The unit vector of each.
        """
    @property
    def values(self, /) -> tuple[float, float, float]:
        """
        The principal stresses (pressures, tensile positive).
        """

@final
class Rectangle:
    """
    A rectangle under uniform traction.

    Parameters
    ----------
    a, b : float
        Half sides along x and y (lengths), positive.

    Raises
    ------
    NotPositive
    """
    def __new__(cls, /, a: float, b: float) -> Rectangle: ...
    def __repr__(self, /) -> str: ...
    def pair_tensor(self, /, pair: ElasticPair, x: float, y: float) -> Tensor:
        """
        The coefficients of a pair at a position from the centre (lengths).
        """
    def tensor(self, /, material: Material, x: float, y: float) -> Tensor:
        """
        The coefficients of a body at a position from the centre (lengths).
        """

@final
class RelativeDisplacement:
    """
    A displacement of body 1 relative to body 2 that the contact does not cause: bulk strain, thermal expansion.

    Parameters
    ----------
    along_x, along_y : Field or array_like of shape (ny, nx)
        Displacements of body 1 relative to body 2 along x and y (lengths, of either sign).
    grid : Grid, optional
        Where arrays live; Fields know it.

    Raises
    ------
    GridMismatch, Sample
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, along_x: Field | ArrayLike, along_y: Field | ArrayLike, *, grid: Grid | None = None) -> RelativeDisplacement: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @staticmethod
    def bulk_strain(grid: Grid, strain: Sequence[Sequence[float]] | NDArray[Any]) -> RelativeDisplacement:
        """
        That of a uniform strain ``[[xx, xy], [yx, yy]]`` of body 1 less that of body 2 (dimensionless, positive where body
        1 is stretched); zero at the origin of the grid.
        """
    @property
    def fields(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Its components along x and y (lengths).
        """

@final
class Report:
    """
    How a solve ended, what it cost and how large its error can be.

    Every number is recomputed from a fresh product with the returned iterate, whatever the status.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def double_precision_products(self, /) -> int:
        """
        Products with the operator in double precision, with the final check.
        """
    @property
    def duality_gap(self, /) -> float:
        """
        Certified bound on the squared relative error in the energy norm.
        """
    @property
    def eigenvalue_bound(self, /) -> EigenvalueBound:
        """
        How the smallest eigenvalue is known that :attr:`duality_gap` rests on, and what else is certified beside it: "proven";
        "estimated", on the safe side, of stiff coatings on long grids; or "unknown": the bound of the error, the root of the
        duality gap of the problem, then falls only with the root of the residual.
        """
    @property
    def energy_error_bound(self, /) -> float:
        """
        Certified bound on the relative error in the energy norm, the root of the duality gap.
        """
    @property
    def history(self, /) -> list[Iteration]:
        """
        Every iterate whose residual was measured, in order.
        """
    @property
    def is_converged(self, /) -> bool:
        """
        Whether the tolerance was reached.
        """
    @property
    def iterations(self, /) -> int:
        """
        Conjugate-gradient steps.
        """
    @property
    def load_error(self, /) -> float:
        """
        Relative error of the prescribed total; zero when none is prescribed.
        """
    @property
    def products(self, /) -> int:
        """
        Products of both precisions.
        """
    @property
    def residual(self, /) -> float:
        """
        Largest complementarity residual, relative to the largest displacement.
        """
    @property
    def single_precision_products(self, /) -> int:
        """
        Products in single precision.
        """
    @property
    def status(self, /) -> Status:
        """
        Why the iteration ended.
        """
    @property
    def time(self, /) -> float:
        """
        Wall time of the solve (s).
        """

@final
class PointResult:
    """
    Displacement and stress at a point.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def displacement(self, /) -> tuple[float, float, float]:
        """
        Displacement along x, y and z (lengths).
        """
    @property
    def stress(self, /) -> Stress:
        """
        Stress.
        """

@final
class PointResults:
    """
    Displacements and stresses at points: a sequence of :class:`PointResult`, and arrays with a number of each point, in the
    order of the points.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __getitem__(self, index: int, /) -> PointResult: ...
    def __iter__(self, /) -> Iterator[PointResult]: ...
    def __len__(self, /) -> int: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def displacement(self, /) -> tuple[NDArray[float64], NDArray[float64], NDArray[float64]]:
        """
        Displacement along x, y and z (lengths).
        """
    @property
    def hydrostatic(self, /) -> NDArray[float64]:
        """
        Mean of the normal stresses (pressures, tensile positive).
        """
    @property
    def max_shear(self, /) -> NDArray[float64]:
        """
        Largest shear stress (pressures).
        """
    @property
    def normal_stress(self, /) -> tuple[NDArray[float64], NDArray[float64], NDArray[float64]]:
        """
        Components xx, yy and zz (pressures, tensile positive).
        """
    @property
    def shear_stress(self, /) -> tuple[NDArray[float64], NDArray[float64], NDArray[float64]]:
        """
        Components xy, xz and yz (pressures).
        """
    @property
    def von_mises(self, /) -> NDArray[float64]:
        """
        Von Mises' equivalent stress (pressures).
        """

@final
class Rolling:
    """
    How the bodies roll in a step of a history: by how many cells, where their particles enter the contact, and what body 2
    moves over body 1 on the way. Without creepage and spin they roll freely.

    Parameters
    ----------
    cells : int
        Cells by which the particles of both surfaces move through the contact, one or more.
    creepage : pair of float, optional
        The creepages along x and y, which body 2 moves over body 1 for each length rolled (dimensionless, default zero). A
        positive creepage causes a positive force. Along an axis of which the step names the force the creepage follows, and
        must not be given here.
    creepage_x, creepage_y : float, optional
        The same along one axis.
    spin : float, default 0
        Rotation of body 2 relative to body 1 about the origin of the grid for each length rolled (one over a length,
        positive from x to y). The vector model alone has it.
    leading_edge : LeadingEdge or str, default "plus_x"
        Where particles enter the contact.

    Examples
    --------
    >>> import stickslip as ss
    >>> body = ss.Material.from_shear_modulus(1.0, 0.25)
    >>> bodies = ss.HalfSpace(ss.Grid.square(24, 3.0), (body, body))
    >>> history = ss.History(bodies, ss.surface.sphere(bodies.grid, 1.0), 0.3, model="vector")
    >>> step = history.step(normal_force=1.0)
    >>> rolling = ss.history.Rolling(1, creepage_x=0.05)
    >>> forces = [history.step(roll=rolling).tangential_force[0] for _ in range(5)]
    >>> forces == sorted(forces), history.last_step.creepage  # the force grows towards that of steady rolling
    (True, (0.05, 0.0))
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, cells: int, *, creepage: Sequence[float] | NDArray[Any] | None = None, creepage_x: float | None = None, creepage_y: float | None = None, spin: float | None = None, leading_edge: LeadingEdge | str | None = None) -> Rolling: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...

@final
class RollingProblem:
    """
    Bodies, normal contact, friction, and what is prescribed of their steady rolling.

    Along an axis of which nothing is said there is no creepage.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    normal : NormalSolution
        A solved normal contact of these bodies.
    friction : Friction, float or array_like of shape (ny, nx)
        Coulomb friction; a number or an array is the coefficient of friction (dimensionless, not negative).
    creepage, creepage_x, creepage_y : pair of float, float, optional
        The creepages, which body 2 moves over body 1 for each length rolled (dimensionless). A positive creepage causes a
        positive force.
    force, force_x, force_y : pair of float, float, optional
        The tangential force that body 2 exerts on body 1, less than friction holds; the creepage follows.
    spin : float, default 0
        Rotation of body 2 relative to body 1 about the origin of the grid for each length rolled (one over a length,
        positive from x to y).
    moment : float, optional
        In place of the spin, which follows: the moment on body 1 about the origin of the grid (a force times a length,
        positive from x to y), less than friction holds.
    leading_edge : LeadingEdge or str, default "plus_x"
        Where particles enter the contact.
    step : int, default 1
        Cells that a particle passes in a step. Longer steps cost less and are less accurate.
    entry_rule : EntryRule or str, default "since_touch"
        How cells that enter the contact follow the motion; "whole_step" as CONTACT has it, less accurate.
    slip_corrections : int, default 0
        Number of corrections of the direction of slip. Two raise the order of the forces under spin from 1 to between 1.5 and 2.
    settings : Settings, optional
        Method, tolerance and limits; those of ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        As of :class:`Settings`; they take precedence over ``settings``.

    Raises
    ------
    NotConverged, GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch, EmptyContact, NotFinite, NotPositive,
    UnsupportedByModel, GridTooShort, BeyondFrictionCapacity, BeyondFrictionMoment, Tolerance, IterationLimit, Method

    Examples
    --------
    >>> import stickslip
    >>> grid = stickslip.Grid.square(24, 3.0)
    >>> body = stickslip.Material.from_shear_modulus(1.0, 0.25)
    >>> bodies = stickslip.HalfSpace(grid, (body, body))
    >>> ball = stickslip.surface.sphere(grid, 1.0)
    >>> normal = stickslip.NormalProblem(bodies, ball, force=1.0).solve()
    >>> rolling = stickslip.rolling.RollingProblem(bodies, normal, 0.3, creepage_x=1e-5).solve()
    >>> a = stickslip.analytical.HertzSphere(bodies.pair, 1.0, 1.0).contact_radius
    >>> abs(rolling.force[0] / (a * a * 1e-5) / 4.12 - 1.0) < 0.02  # Kalker's coefficient C11
    True
    """
    def __getnewargs_ex__(self, /) -> tuple[tuple[Any, ...], dict[str, Any]]: ...
    def __new__(cls, /, bodies: HalfSpace, normal: NormalSolution, friction: Friction | float | ArrayLike, *, creepage: Sequence[float] | NDArray[Any] | None = None, creepage_x: float | None = None, creepage_y: float | None = None, force: Sequence[float] | NDArray[Any] | None = None, force_x: float | None = None, force_y: float | None = None, spin: float | None = None, moment: float | None = None, leading_edge: LeadingEdge | str | None = None, step: int | None = None, entry_rule: EntryRule | str | None = None, slip_corrections: int | None = None, settings: Settings | None = None, tolerance: float | None = None, method: Method | str | None = None, max_iterations: int | None = None, time_limit: float | None = None) -> RollingProblem: ...
    def __repr__(self, /) -> str: ...
    def solve(self, /, *, progress: Any | None = None, warn: bool = True) -> RollingSolution:
        """
        Solves once; see :meth:`NormalProblem.solve`.
        """
    def solver(self, /) -> RollingSolver:
        """
        A solver of this problem, which keeps its buffers and starts each solve from the last answer.
        """

@final
class RollingSolution:
    """
    Traction, slip, zones, creepage and dissipation of steady rolling. Vectors are (x, y). Arrays are read-only views of its
    memory, those of the zones and the dissipation copies.
    """
    def __repr__(self, /) -> str: ...
    @property
    def creepage(self, /) -> tuple[float, float]:
        """
        The creepages along x and y, prescribed or caused by the force (dimensionless).
        """
    @property
    def dissipation(self, /) -> NDArray[float64]:
        """
        Energy that slip dissipates in each cell for each length rolled (a pressure): what wear follows. Between bodies of
        the same material its integral is less than the work by a part that falls with the size of the cells.
        """
    @property
    def force(self, /) -> tuple[float, float]:
        """
        Tangential force that body 2 exerts on body 1 along x and y.
        """
    @property
    def grid(self, /) -> Grid:
        """
        The grid of its fields.
        """
    @property
    def moment(self, /) -> float:
        """
        Moment about z, at the origin of the grid, on body 1 (a force times a length, positive from x to y).
        """
    @property
    def report(self, /) -> Report:
        """
        How the solve ended, what it cost, how large its error can be.
        """
    @property
    def slip(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Slip of the surface of body 1 over that of body 2 along x and y for each length rolled (dimensionless), over the
        step that brought the particles here: against the traction in slip cells, zero elsewhere.
        """
    @property
    def spin(self, /) -> float:
        """
        The spin, prescribed or caused by the moment (one over a length, positive from x to y).
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Cells that stick over cells in contact; zero without contact.
        """
    @property
    def traction(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Traction on body 1 along x and y (pressures); zero outside the contact.
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Remarks on a result that may mislead; empty if there are none.
        """
    @property
    def work(self, /) -> float:
        """
        Work of creepages and spin for each length rolled (a force). The spin moves particles as the middles of their
        paths, so that its moment is taken there. Between bodies of the same material all of the work is dissipated.
        Between others the pressure does work as well, which is not included.
        """
    @property
    def zones(self, /) -> NDArray[uint8]:
        """
        The zone of every cell, bytes of shape (ny, nx): the numbers of :class:`Zone`, 0 separated, 1 stick, 2 slip.
        """

@final
class RollingSolver:
    """
    Solves for one creepage, force or spin after the other, each from the last answer; made by
    :meth:`RollingProblem.solver`.
    """
    def __repr__(self, /) -> str: ...
    def creep_forces(self, /, points: ArrayLike) -> CreepForces:
        """
        The loads at each of these points, each solved from the answer of the one before: a creep curve, or a creep surface
        row by row. The last point stays prescribed. All are checked before the first is solved, and Ctrl-C acts once the last
        is.

        Parameters
        ----------
        points : array_like of shape (n, 3)
            Each ``(creepage_x, creepage_y, spin)`` (dimensionless, dimensionless, one over a length). Neighbours in the
            order should be neighbours in the plane.

        Returns
        -------
        CreepForces
            Of each point in turn, and arrays of all.

        Raises
        ------
        NotFinite, UnsupportedByModel
            For any of the points; all is then as it was.
        NotConverged
            At the first point that fails, which stays prescribed.
        """
    @property
    def friction_capacity(self, /) -> float:
        """
        Largest tangential force that friction holds: the integral of the friction limit.
        """
    @property
    def report(self, /) -> Report:
        """
        How the last solve ended.
        """
    def reset(self, /) -> None:
        """
        Forgets the last answer: the next solve starts as the first did.
        """
    def set_friction(self, /, friction: Friction | float | ArrayLike) -> None:
        """
        Changes the friction of the next solve.
        """
    def set_load(self, /, *, force: float | None = None, approach: float | None = None) -> None:
        """
        Sets the normal load of the next solve, and solves for its pressure from the last one. Needs
        :meth:`set_normal_solver`.

        Parameters
        ----------
        force, approach : float, optional
            One of the two, as of :class:`NormalProblem`.

        Raises
        ------
        UnsupportedByModel
            Without a normal solver.
        NegativeOrNotFinite, NotFinite, NotConverged, EmptyContact, GridTooShort, BeyondFrictionCapacity, BeyondFrictionMoment
            The solver is then unchanged.
        """
    def set_normal_solver(self, /, solver: NormalSolver) -> None:
        """
        Sets the solver that finds the pressure of a new load; copied, with its gap, hardness and settings.
        """
    def set_pressure(self, /, pressure: NormalSolution | Field | ArrayLike) -> None:
        """
        Sets the pressure of the next solve. A field has no gap, so it needs a solver of ``entry_rule="whole_step"``.

        Raises
        ------
        UnsupportedByModel, GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch, NotConverged, Sample, EmptyContact,
        GridTooShort, NotFinite, BeyondFrictionCapacity, BeyondFrictionMoment
            The pressure is then unchanged.
        """
    @property
    def settings(self, /) -> Settings:
        """
        The settings of the next solve; may be assigned.
        """
    @settings.setter
    def settings(self, /, settings: Settings) -> None: ...
    def solve(self, /, *, creepage: Sequence[float] | NDArray[Any] | None = None, creepage_x: float | None = None, creepage_y: float | None = None, force: Sequence[float] | NDArray[Any] | None = None, force_x: float | None = None, force_y: float | None = None, spin: float | None = None, moment: float | None = None, progress: Any | None = None, warn: bool = True) -> RollingSolution:
        """
        Solves, for these creepages, forces, spin or moment if any is given, else for the last ones.

        Parameters
        ----------
        creepage, creepage_x, creepage_y, force, force_x, force_y, spin, moment : optional
            As of :class:`RollingProblem`: if one is given, those that are not are zero creepages and no spin.
        progress, warn : optional
            As of :meth:`NormalProblem.solve`.

        Returns
        -------
        RollingSolution

        Raises
        ------
        NotFinite, UnsupportedByModel, BeyondFrictionCapacity, BeyondFrictionMoment
            For what is prescribed, which is then as it was.
        NotConverged
            With ``report`` and ``last_iterate``.
        """
    def stiffness(self, /) -> list[list[float]]:
        """
        How forces along x and y and moment (rows) change with the creepages along x and y and the spin (columns) about the
        last answer: forces, with the spin forces times lengths, in the row of the moment once more times a length. Cells
        that stick follow, cells that slip stay at their limits. Before the first solve all cells stick: these are Kalker's
        coefficients, times G a b and lengths.
        """

@final
class RoughSphere:
    """
    A rough sphere pressed on a half-space: the fraction of the Hertz circle in real contact.

    Where the pressure of the smooth sphere is p, the fraction erf((sqrt(pi)/2) kappa p / (E* rms_slope)) of the area is
    in contact; the ratio is the mean over the Hertz circle. It holds where the roughness is small beside the approach and
    fine beside the circle. kappa is 2 by default. After Müser (2016).

    Parameters
    ----------
    hertz : HertzSphere
        The contact of the smooth sphere.
    rms_slope : float
        Root mean square of the gradient (Sdq, dimensionless), positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, hertz: HertzSphere, rms_slope: float) -> RoughSphere: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def area_coefficient(self, /) -> float:
        """
        Coefficient kappa of the area (dimensionless).
        """
    @staticmethod
    def area_law(reduced_pressure: float, area_coefficient: float) -> float:
        """
        The relative area of any rough sphere at a reduced pressure P (not negative), with a coefficient kappa (positive;
        both dimensionless).
        """
    @property
    def contact_area(self, /) -> float:
        """
        Area of real contact (a length squared).
        """
    @property
    def hertz(self, /) -> HertzSphere:
        """
        The contact of the smooth sphere.
        """
    @property
    def reduced_pressure(self, /) -> float:
        """
        Reduced pressure P = W / (pi a^2 E* rms_slope) (dimensionless), with the mean pressure of the smooth sphere.
        """
    @property
    def relative_contact_area(self, /) -> float:
        """
        Area of real contact over that of the Hertz circle, between 0 and 1.
        """
    @property
    def rms_slope(self, /) -> float:
        """
        Root mean square of the gradient (dimensionless).
        """
    def with_area_coefficient(self, /, area_coefficient: float) -> RoughSphere:
        """
        The same contact with another coefficient kappa (dimensionless, positive), for example one of those that
        :class:`Persson` lists.
        """

@final
class RoughSurface:
    """
    A generated rough surface.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __repr__(self, /) -> str: ...
    @property
    def array(self, /) -> NDArray[float64]:
        """
        Read-only array of the heights, without a copy.
        """
    @property
    def heights(self, /) -> Field:
        """
        Its heights (lengths), of zero mean.
        """
    @property
    def iterations(self, /) -> int:
        """
        Iterations that a prescribed skewness or kurtosis took.
        """
    @property
    def kurtosis(self, /) -> float:
        """
        Kurtosis of the heights.
        """
    @property
    def rms_height(self, /) -> float:
        """
        Root mean square height (a length).
        """
    @property
    def rms_slope(self, /) -> float:
        """
        Root mean square slope.
        """
    @property
    def skewness(self, /) -> float:
        """
        Skewness of the heights.
        """

@final
class RoundedPunch:
    """
    A flat punch with rounded edges pressed on a half-space along a line, in plane strain: the pad of fretting tests
    with nearly complete contact.

    The gap is zero for |x| <= b and (|x| - b)^2 / 2R beyond. Ciavarella, Hills & Monno, Proc. Inst. Mech. Eng. C 212
    (1998) 319.

    Parameters
    ----------
    pair : ElasticPair
        The bodies.
    flat : float
        Half-width b of the flat (a length), positive.
    radius : float
        Radius R of the edges (a length), positive.
    load : float
        Normal load (a force per length), at least a millionth of E* b^2 / 4R.

    Raises
    ------
    NotPositive, BelowMinimum
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair, flat: float, radius: float, load: float) -> RoundedPunch: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def half_width(self, /) -> float:
        """
        Half-width of the contact (a length).
        """
    def pressure(self, /, x: ArrayLike) -> Any:
        """
        Pressure at the distance x from the middle; zero outside the contact.
        """

@final
class SelfAffine:
    """
    A recipe of self-affine roughness. With a cut-off wavelength it stays the same surface when the grid is refined.

    Parameters
    ----------
    rms_height, rms_slope : float
        One of the two: the root mean square of the heights (a length), or that of the gradient (dimensionless).
    hurst : float, default 0.8
        The Hurst exponent, in [0, 1]; the fractal dimension is 3 less this.
    longest_wavelength : float, optional
        Where the spectrum begins (a length); the longer side of the grid by default.
    roll_off_wavelength : float, optional
        Where the plateau of the spectrum ends and it begins to fall (a length); the longest wavelength by default, without
        plateau.
    cut_off_wavelength : float, optional
        Where the spectrum ends (a length), at least two cells; eight cells, of their longer side, by default.
    amplitudes : Amplitudes or str, default "exact"
        "exact" gives each wave the amplitude of the spectrum, and only its phase is random; "gaussian" scatters the
        amplitudes too, as filtered white noise does.
    cropped : bool, default False
        Whether the surface is the middle of a larger one, and does not repeat.
    skewness, kurtosis : float, optional
        Of the heights (kurtosis 3 of Gaussian heights); as they follow from the phases by default.
    seed : int, default 0
        Not negative; another seed is another surface.

    Examples
    --------
    >>> import stickslip
    >>> recipe = stickslip.surface.SelfAffine(rms_slope=0.1, hurst=0.8, seed=1)
    >>> rough = recipe.generate(stickslip.Grid.square(64, 1.0))
    >>> round(rough.rms_slope, 6)
    0.1
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, *, rms_height: float | None = None, rms_slope: float | None = None, hurst: float | None = None, longest_wavelength: float | None = None, roll_off_wavelength: float | None = None, cut_off_wavelength: float | None = None, amplitudes: Amplitudes | str | None = None, cropped: bool = False, skewness: float | None = None, kurtosis: float | None = None, seed: int | None = None) -> SelfAffine: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def generate(self, /, grid: Grid) -> RoughSurface:
        """
        The surface on a grid.

        Raises
        ------
        NotPositive, NotFinite, Hurst, BelowMinimum, NoWaveInBand, HeightMomentsNotReached, Memory
        """
    def generate_on(self, /, bodies: HalfSpace) -> Field:
        """
        The heights on the grid of bodies (lengths).
        """

@final
class PvdWriter:
    """
    A series of images over time for ParaView, listed in a PVD file, which is replaced.

    Parameters
    ----------
    path : path_like
        The PVD file; the images are written beside it.
    """
    def __len__(self, /) -> int: ...
    def __new__(cls, /, path: str | PathLike[str]) -> PvdWriter: ...
    def __repr__(self, /) -> str: ...
    def write(self, /, time: float, fields: dict[str, Any], *, grid: Grid | None = None) -> None:
        """
        Writes fields and vectors at a time, as of :func:`stickslip.io.vti.write`, and lists them.
        """

@final
class Settings:
    """
    Method, tolerance and limits of an iteration, as every problem, solver and history takes them: together as
    ``settings``, or one by one by the same keywords.

    Parameters
    ----------
    tolerance : float, default 1e-8
        Bounds the certified error in the energy norm and the largest residual.
    method : Method or str, default "active_set"
        "active_set", or "polonsky_keer" for one unknown a cell.
    max_iterations : int, default 10000
        Conjugate-gradient steps allowed.
    time_limit : float, optional
        Wall time allowed a solve (s).

    Raises
    ------
    Tolerance, IterationLimit
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, *, tolerance: float | None = None, method: Method | str | None = None, max_iterations: int | None = None, time_limit: float | None = None) -> Settings: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def max_iterations(self, /) -> int:
        """
        Conjugate-gradient steps allowed.
        """
    @property
    def method(self, /) -> Method:
        """
        Which iteration.
        """
    @property
    def time_limit(self, /) -> float | None:
        """
        Wall time allowed (s), or ``None``.
        """
    @property
    def tolerance(self, /) -> float:
        """
        Error accepted.
        """

@final
class SpencePressing:
    """
    How far bodies of different materials stick when they are pressed together by a growing load alone.

    The surfaces slip inwards near the rim of the contact; friction holds the part within k times its radius or half-width.
    Shear does not change the pressure here (one-way coupling). Spence, J. Elasticity 5 (1975) 297; Johnson (1985), section
    5.4. Made by :meth:`round` and :meth:`plane`.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @staticmethod
    def plane(pair: ElasticPair, friction: float) -> SpencePressing:
        """
        The contact of a cylinder or strip in plane strain, with this coefficient of friction (dimensionless, not negative).
        """
    @staticmethod
    def round(pair: ElasticPair, friction: float) -> SpencePressing:
        """
        The contact of a body of revolution, with this coefficient of friction (dimensionless, not negative).
        """
    @property
    def stick_radius(self, /) -> float:
        """
        Radius or half-width of the stick zone over that of the contact, k in [0, 1]: one without coupling, zero without
        friction.
        """

@final
class Spot:
    """
    A connected spot of contact cells.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def area(self, /) -> float:
        """
        Its area (a length squared).
        """
    @property
    def cells(self, /) -> int:
        """
        Its cells.
        """
    @property
    def centroid(self, /) -> tuple[float, float]:
        """
        Mean position of its cells (lengths).
        """
    @property
    def load(self, /) -> float:
        """
        The force it carries.
        """
    @property
    def max_pressure(self, /) -> float:
        """
        The largest pressure in it.
        """
    @property
    def mean_pressure(self, /) -> float:
        """
        Load over area.
        """
    @property
    def perimeter(self, /) -> float:
        """
        Length of its edge along the sides of cells.
        """
    @property
    def stick_ratio(self, /) -> float | None:
        """
        Stick cells over its cells; ``None`` without shear.
        """

@final
class State:
    """
    A state of a history: what to return to, to continue from, or to save. Arrays are read-only views of its memory,
    those of the zones a copy; vectors are (x, y).
    """
    def __reduce__(self, /) -> tuple[Any, tuple[type, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def accumulated_slip(self, /) -> NDArray[float64]:
        """
        Length of the path that each cell slipped since the start (lengths, not negative).
        """
    @property
    def approach(self, /) -> float:
        """
        Approach of the bodies from the datum of the gap (a length).
        """
    @property
    def axis(self, /) -> Axis | None:
        """
        The axis of the scalar model; ``None`` in the vector model.
        """
    @property
    def boundary(self, /) -> Boundary:
        """
        What lies beyond the edge of the grid.
        """
    @property
    def contact(self, /) -> NDArray[bool_]:
        """
        Whether a cell is in contact, booleans of shape (ny, nx): its pressure is positive; a copy.
        """
    @property
    def coupling(self, /) -> Coupling:
        """
        How much is modelled of the coupling between pressure and traction.
        """
    @property
    def dissipated_energy(self, /) -> NDArray[float64]:
        """
        Energy that each cell dissipated since the start (not negative).
        """
    @property
    def friction(self, /) -> Friction:
        """
        The friction.
        """
    @staticmethod
    def from_bytes(bytes: bytes) -> State:
        """
        A state from its bytes.
        """
    @property
    def gap(self, /) -> NDArray[float64]:
        """
        The gap before loading (lengths), as last set, with what the surfaces have yielded.
        """
    @property
    def grid(self, /) -> Grid:
        """
        The grid.
        """
    @property
    def hardness(self, /) -> Hardness | None:
        """
        The largest pressure of the cells, if it is limited.
        """
    @property
    def is_pressure_stale(self, /) -> bool:
        """
        Whether the pressure is still that of an older gap.
        """
    @property
    def moment(self, /) -> float:
        """
        Moment about z, at the origin of the grid, on body 1 (a force times a length, positive from x to y).
        """
    @property
    def normal(self, /) -> NormalSolution:
        """
        The normal contact, which shares the memory of the state.
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The two bodies.
        """
    @property
    def pressure(self, /) -> NDArray[float64]:
        """
        Pressure, not negative; exactly zero outside the contact.
        """
    @property
    def relative_displacement(self, /) -> tuple[NDArray[float64], NDArray[float64]] | None:
        """
        The relative displacement along x and y after the last step (lengths); ``None`` unless the history has one.
        """
    @property
    def settings(self, /) -> Settings:
        """
        Method, tolerance and limits.
        """
    @property
    def shift(self, /) -> tuple[float, float]:
        """
        Shift of body 2 relative to body 1 since the start, along x and y (lengths).
        """
    @property
    def slip(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Slip since the start along x and y (lengths).
        """
    @property
    def steps(self, /) -> int:
        """
        Steps taken since the start.
        """
    @property
    def tangential_force(self, /) -> tuple[float, float]:
        """
        Tangential force that body 2 exerts on body 1 along x and y.
        """
    def to_bytes(self, /) -> bytes:
        """
        Its bytes, which this and later versions read.
        """
    @property
    def entry_rule(self, /) -> EntryRule:
        """
        How far a cell that comes into contact within a step follows its motion.
        """
    @property
    def traction(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Shear traction on body 1 along x and y (pressures).
        """
    @property
    def twist(self, /) -> float:
        """
        Rotation of body 2 relative to body 1 since the start (radians, positive from x to y).
        """
    @property
    def yielded(self, /) -> NDArray[float64] | None:
        """
        How deep the surfaces have yielded since the start (lengths, not negative); ``None`` unless that stays.
        """
    @property
    def zones(self, /) -> NDArray[uint8]:
        """
        The zone of every cell: 0 separated, 1 stick, 2 slip.
        """

@final
class Statistics:
    """
    Parameters of a surface after ISO 25178-2.

    Parameters
    ----------
    heights : Field or topography
        Lengths, none missing.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, heights: Field | ArrayLike) -> Statistics: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def arithmetic_mean_height(self, /) -> float:
        """
        Arithmetic mean height Sa (a length).
        """
    @property
    def deepest_valley(self, /) -> float:
        """
        Deepest valley Sv below the mean (a length).
        """
    @property
    def developed_area_ratio(self, /) -> float:
        """
        Developed area ratio Sdr.
        """
    @property
    def finite_difference_rms_slope(self, /) -> float:
        """
        Root mean square slope by differences of neighbours, Sdq.
        """
    @property
    def height_range(self, /) -> float:
        """
        Highest peak and deepest valley together, Sz (a length).
        """
    @property
    def highest_peak(self, /) -> float:
        """
        Highest peak Sp above the mean (a length).
        """
    @property
    def kurtosis(self, /) -> float:
        """
        Kurtosis Sku; 3 of Gaussian heights.
        """
    @property
    def mean_height(self, /) -> float:
        """
        Mean height (a length).
        """
    @property
    def profile_rms_slope(self, /) -> tuple[float, float]:
        """
        Root mean square slopes of profiles along x and y.
        """
    @property
    def rms_height(self, /) -> float:
        """
        Root mean square height Sq (a length).
        """
    @property
    def skewness(self, /) -> float:
        """
        Skewness Ssk.
        """
    @property
    def spectral_rms_slope(self, /) -> float:
        """
        Root mean square slope by the spectrum, of a surface that repeats.
        """

@final
class StepErrorEstimate:
    """
    What one step differs by from the same load in two.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def dissipated_energy(self, /) -> float:
        """
        Difference of the energy dissipated.
        """
    @property
    def force(self, /) -> tuple[float, float]:
        """
        Difference of the tangential force.
        """
    @property
    def shift(self, /) -> tuple[float, float]:
        """
        Difference of the shift (lengths).
        """
    @property
    def traction(self, /) -> float:
        """
        Sum of the lengths of the differences of the tractions, over the sum of the friction limits.
        """

@final
class StepResult:
    """
    What a step of a history did: its numbers, and its fields for as long as it is the last one, also after a step that
    failed; after an attempt of :class:`AdaptiveSteps` that failed, the last step is that of the attempt. :meth:`keep` copies
    them, for good. Vectors are (x, y).
    """
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def approach(self, /) -> float:
        """
        Approach at its end (a length).
        """
    @property
    def creepage(self, /) -> tuple[float, float] | None:
        """
        The creepages along x and y of a step that rolled, prescribed or caused by the force (dimensionless); ``None`` if it
        did not roll.
        """
    @property
    def dissipated_energy(self, /) -> NDArray[float64]:
        """
        Energy that each cell dissipates, by its traction at the end (forces times lengths, not negative).
        """
    @property
    def energy(self, /) -> EnergyBalance:
        """
        Work, elastic energy and dissipation.
        """
    @property
    def is_gross_slip(self, /) -> bool:
        """
        Whether the whole contact is at its friction limit.
        """
    def keep(self, /) -> StepResult:
        """
        The same with a copy of the fields, which stay when the history goes on.
        """
    @property
    def dissipated_energy_midpoint(self, /) -> NDArray[float64]:
        """
        Energy that each cell dissipates, by the mean of its tractions before and after (forces times lengths).
        """
    @property
    def moment(self, /) -> float:
        """
        Moment about z at its end (a force times a length, positive from x to y).
        """
    @property
    def normal_force(self, /) -> float:
        """
        Normal force at its end.
        """
    @property
    def normal_report(self, /) -> Report | None:
        """
        How the normal contact was solved; ``None`` if the pressure was held.
        """
    @property
    def shift(self, /) -> tuple[float, float]:
        """
        Shift of body 2 relative to body 1 along x and y at its end (lengths).
        """
    @property
    def slip(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Slip of the step along x and y (lengths).
        """
    @property
    def slip_distance(self, /) -> NDArray[float64]:
        """
        Length of the slip of the step (lengths, not negative).
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Stick cells over contact cells at its end.
        """
    @property
    def tangential_force(self, /) -> tuple[float, float]:
        """
        Tangential force on body 1 along x and y at its end.
        """
    @property
    def tangential_report(self, /) -> Report | None:
        """
        How the tangential contact was solved; ``None`` before anything has touched.
        """
    @property
    def twist(self, /) -> float:
        """
        Rotation at its end (radians, positive from x to y).
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Remarks on the step: ``no_contact``, ``contact_at_edge``, ``beyond_hardness``, ``stale_pressure``,
        ``single_load_step`` and those on contacts and zones of too few cells. Warnings of
        contact spots are in ``history.normal.warnings``: a step does not search for spots.
        """

@final
class Stress:
    """
    The symmetric stress tensor at a point (pressures), tensile positive, with z into body 1. Stresses add, subtract and
    scale by numbers.

    Parameters
    ----------
    xx, yy, zz, xy, xz, yz : float, default 0
        Components (pressures).

    Examples
    --------
    >>> from stickslip.subsurface import Stress
    >>> Stress(xy=2.0).principal.values
    (2.0, 0.0, -2.0)
    >>> Stress(xx=1.0) + 2.0 * Stress(xx=3.0)
    Stress(xx=7, yy=0, zz=0, xy=0, xz=0, yz=0)
    """
    def __add__(self, other: object, /) -> Stress:
        """
        The sum with another stress.
        """
    def __eq__(self, value: object, /) -> bool: ...
    def __mul__(self, factor: object, /) -> Stress:
        """
        So many times the stress.
        """
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, *, xx: float = ..., yy: float = ..., zz: float = ..., xy: float = ..., xz: float = ..., yz: float = ...) -> Stress: ...
    def __radd__(self, other: object, /) -> Stress: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def __rmul__(self, factor: object, /) -> Stress: ...
    def __rsub__(self, other: object, /) -> Stress: ...
    def __sub__(self, other: object, /) -> Stress:
        """
        The difference from another stress.
        """
    @property
    def hydrostatic(self, /) -> float:
        """
        Mean of the normal stresses (a pressure, tensile positive).
        """
    @property
    def max_shear(self, /) -> float:
        """
        Largest shear stress (a pressure).
        """
    @property
    def principal(self, /) -> Principal:
        """
        Principal stresses and their directions.
        """
    @property
    def von_mises(self, /) -> float:
        """
        Von Mises' equivalent stress (a pressure).
        """
    @property
    def xx(self, /) -> float:
        """
        Component xx.
        """
    @property
    def xy(self, /) -> float:
        """
        Component xy.
        """
    @property
    def xz(self, /) -> float:
        """
        Component xz.
        """
    @property
    def yy(self, /) -> float:
        """
        Component yy.
        """
    @property
    def yz(self, /) -> float:
        """
        Component yz.
        """
    @property
    def zz(self, /) -> float:
        """
        Component zz.
        """

@final
class Table:
    """
    One influence coefficient at all distances of cells of a grid.

    Parameters
    ----------
    grid : Grid
        The cells.
    pair : ElasticPair
        The two bodies.
    component : Component or str
        Displacement first, traction second.
    """
    def __new__(cls, /, grid: Grid, pair: ElasticPair, component: Component | str) -> Table: ...
    def __repr__(self, /) -> str: ...
    @property
    def component(self, /) -> Component:
        """
        The component.
        """
    def get(self, /, i: int, j: int) -> float | None:
        """
        The coefficient at a distance of so many cells along x and y, of either sign; ``None`` beyond the table.
        """
    @property
    def size(self, /) -> tuple[int, int]:
        """
        Distances along x and y, those of one sign.
        """

@final
class TangentialEdges:
    """
    The edges of a contact in partial slip: of the contact and of its stick zone.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __repr__(self, /) -> str: ...
    @property
    def contact(self, /) -> Edges:
        """
        The edge of the contact.
        """
    @property
    def grid(self, /) -> Grid:
        """
        The grid of the cells.
        """
    @property
    def mean_traction(self, /) -> NDArray[float64]:
        """
        Its means over the cells, shape (ny, nx).
        """
    @property
    def peak_traction(self, /) -> float:
        """
        The largest traction at the centre of a cell (a pressure).
        """
    @property
    def slip_area(self, /) -> float:
        """
        Area of the contact less that of the stick zone.
        """
    @property
    def stick(self, /) -> Edges:
        """
        The edge of the stick zone.
        """
    @property
    def stick_area(self, /) -> float:
        """
        Area of the stick zone, with the parts of the cells at its edge (a length squared).
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Stick area over contact area.
        """
    @property
    def traction(self, /) -> NDArray[float64]:
        """
        Magnitude of the traction at the centres of the cells (a pressure), shape (ny, nx).
        """

@final
class TangentialLoad:
    """
    A tangential load from rest.

    Along an axis of which nothing is said, it is zero, of the kind of the other. The scalar model takes a load along one
    axis, the vector model any.

    Parameters
    ----------
    force, shift : pair of float, optional
        Along x and y, of either sign: the force that body 2 exerts on body 1; the shift of body 2 relative to body 1
        (lengths).
    spring : ((x, y), stiffness), optional
        Springs along both axes that drag body 2, by the position of their far ends (lengths) and their stiffness (a force
        over a length, positive): the force is stiffness (position - shift).
    force_x, force_y, shift_x, shift_y : float, optional
        The same along one axis.
    spring_x, spring_y : (position, stiffness), optional
        The same along one axis.
    twist : float, default 0
        Rotation of body 2 relative to body 1 about the origin of the grid (radians, positive from x to y). The vector model
        alone has it.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, *, force: Sequence[float] | NDArray[Any] | None = None, shift: Sequence[float] | NDArray[Any] | None = None, spring: tuple[Sequence[float], float] | None = None, force_x: float | None = None, force_y: float | None = None, shift_x: float | None = None, shift_y: float | None = None, spring_x: tuple[float, float] | None = None, spring_y: tuple[float, float] | None = None, twist: float | None = None) -> TangentialLoad: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def control(self, /, axis: Axis | str) -> tuple[str, Any]:
        """
        What is prescribed along an axis: ``("force", value)``, ``("shift", value)`` or
        ``("spring", (position, stiffness))``.
        """

@final
class TangentialProblem:
    """
    Bodies, pressure, friction and tangential load: one monotonic step from the unsheared state.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    pressure : NormalSolution, Field or array_like of shape (ny, nx)
        A solved normal contact of these bodies, or a field of pressures (not negative).
    friction : Friction, float or array_like of shape (ny, nx)
        Coulomb friction; a number or an array is the coefficient of friction (dimensionless, not negative).
    load : TangentialLoad, optional
        The tangential load as an object, instead of by keywords.
    force, shift, spring, force_x, force_y, shift_x, shift_y, spring_x, spring_y, twist : optional
        The tangential load, as of :class:`TangentialLoad`; no force by default.
    model : TangentialModel or str, default "scalar"
        "scalar" finds the traction along the axis of the load, "vector" both components.
    coupling : Coupling or str, default "one_way"
        Of bodies of different materials: "one_way" has the pressure move the surfaces tangentially, "neglected" does not;
        "full" is refused, since the pressure is given.
    relative_displacement : RelativeDisplacement, optional
        A displacement of body 1 relative to body 2 that the contact does not cause, reached in proportion to the load; none
        by default.
    settings : Settings, optional
        Method, tolerance and limits; those of ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        As of :class:`Settings`; they take precedence over ``settings``.

    Raises
    ------
    NotConverged, Sample, GridMismatch, BoundaryMismatch, MaterialMismatch, CoupledMaterials, ObliqueLoad, UnsupportedByModel,
    NotFinite, EmptyContact, BeyondFrictionCapacity, Tolerance, IterationLimit

    Examples
    --------
    >>> import stickslip
    >>> grid = stickslip.Grid.square(64, 0.3e-3)
    >>> steel = stickslip.Material(213e9, 0.29)
    >>> bodies = stickslip.HalfSpace(grid, (steel, steel))
    >>> ball = stickslip.surface.sphere(grid, 3.5e-3)
    >>> normal = stickslip.NormalProblem(bodies, ball, force=100.0).solve()
    >>> shear = stickslip.TangentialProblem(bodies, normal, 0.5, force_x=20.0).solve()
    >>> hertz = stickslip.analytical.HertzSphere(bodies.pair, 3.5e-3, 100.0)
    >>> exact = stickslip.analytical.CattaneoMindlin(hertz, 0.5, 20.0)
    >>> abs(shear.stick_ratio - exact.stick_ratio) < 0.02
    True
    """
    def __getnewargs_ex__(self, /) -> tuple[tuple[Any, ...], dict[str, Any]]: ...
    def __new__(cls, /, bodies: HalfSpace, pressure: NormalSolution | Field | ArrayLike, friction: Friction | float | ArrayLike, load: TangentialLoad | None = None, *, force: Sequence[float] | NDArray[Any] | None = None, shift: Sequence[float] | NDArray[Any] | None = None, spring: tuple[Sequence[float], float] | None = None, force_x: float | None = None, force_y: float | None = None, shift_x: float | None = None, shift_y: float | None = None, spring_x: tuple[float, float] | None = None, spring_y: tuple[float, float] | None = None, twist: float | None = None, model: TangentialModel | str | None = None, coupling: Coupling | str | None = None, relative_displacement: RelativeDisplacement | None = None, settings: Settings | None = None, tolerance: float | None = None, method: Method | str | None = None, max_iterations: int | None = None, time_limit: float | None = None) -> TangentialProblem: ...
    def __repr__(self, /) -> str: ...
    @property
    def friction_capacity(self, /) -> float:
        """
        Largest tangential force that friction holds: the integral of the friction limit.
        """
    def solve(self, /, *, progress: Any | None = None, warn: bool = True) -> TangentialSolution:
        """
        Solves once; see :meth:`NormalProblem.solve`.
        """
    def solver(self, /) -> TangentialSolver:
        """
        A solver of this problem, which keeps its buffers and starts each solve from the last answer.
        """

@final
class TangentialSolution:
    """
    Traction, slip, zones and shift of a tangential contact. Vectors are (x, y); the scalar model leaves the component
    across the load at zero. Arrays are read-only views of its memory, those of the zones a copy. Two are equal if their
    answers are, however they were found.
    """
    def __eq__(self, other: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def axis(self, /) -> Axis | None:
        """
        The axis of the load in the scalar model, ``None`` in the vector model.
        """
    @property
    def boundary(self, /) -> Boundary:
        """
        What lies beyond the edge of the grid.
        """
    @property
    def cell_value(self, /) -> CellValue:
        """
        The meaning of the value of a cell.
        """
    @property
    def discretisation_estimate(self, /) -> float | None:
        """
        An estimate of the discretisation error of the tractions: the sum over the cells of the differences from the exact
        means, relative to the sum of their magnitudes; ``None`` without traction.
        """
    def displacement(self, /, bodies: HalfSpace) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Displacement of body 1 relative to body 2 by the tractions along x and y, of all cells (lengths): one product.
        """
    @property
    def dissipated_energy(self, /) -> float:
        """
        Energy dissipated by the step (a force times a length), not negative.
        """
    def edges(self, /, normal: NormalSolution, friction: Friction | float | ArrayLike) -> TangentialEdges:
        """
        The edges of the contact and of the stick zone inside the cells, under the pressure and the friction of the problem.
        """
    def elastic_energy(self, /, bodies: HalfSpace) -> float:
        """
        Elastic energy of shear (a force times a length): one product.
        """
    @property
    def force(self, /) -> tuple[float, float]:
        """
        Tangential force that body 2 exerts on body 1 along x and y.
        """
    @property
    def grid(self, /) -> Grid:
        """
        The grid of its fields.
        """
    @property
    def is_gross_slip(self, /) -> bool:
        """
        Whether the whole contact slips.
        """
    @property
    def moment(self, /) -> float:
        """
        Moment about z, at the origin of the grid, on body 1 (a force times a length, positive from x to y).
        """
    @property
    def report(self, /) -> Report:
        """
        How the solve ended, what it cost, how large its error can be.
        """
    @property
    def shift(self, /) -> tuple[float, float]:
        """
        Shift, the rigid motion of body 2 relative to body 1 along x and y (lengths).
        """
    @property
    def slip(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Slip of the surface of body 1 over that of body 2 along x and y (lengths); exactly zero in stick cells.
        """
    @property
    def slip_area(self, /) -> float:
        """
        Area of the slip zone, by counting cells.
        """
    def spots(self, /, normal: NormalSolution) -> ContactSpots:
        """
        The contact spots of the normal contact below it, with their stick ratios.
        """
    @property
    def stick_area(self, /) -> float:
        """
        Area of the stick zone, by counting cells.
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Stick area over contact area, by counting cells.
        """
    def stiffness(self, /, bodies: HalfSpace) -> TangentialStiffness:
        """
        The tangential stiffness, on loading and at reversal.
        """
    @property
    def traction(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Shear traction on body 1 along x and y (pressures); exactly zero outside the contact.
        """
    @property
    def twist(self, /) -> float:
        """
        Rotation of body 2 relative to body 1 about the origin of the grid (radians, positive from x to y).
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Remarks on a result that may mislead; empty if there are none.
        """
    @property
    def zones(self, /) -> NDArray[uint8]:
        """
        The zone of every cell, bytes of shape (ny, nx): the numbers of :class:`Zone`, 0 separated, 1 stick, 2 slip.
        """

@final
class TangentialSolver:
    """
    Solves tangential contacts again and again, each time from the last answer; made by
    :meth:`TangentialProblem.solver`. Load, friction and pressure may change between calls. It does not remember slip.
    """
    def __repr__(self, /) -> str: ...
    @property
    def friction_capacity(self, /) -> float:
        """
        Largest tangential force that friction holds: the integral of the friction limit.
        """
    def reset(self, /) -> None:
        """
        Forgets the last answer: the next solve starts as the first did.
        """
    def set_friction(self, /, friction: Friction | float | ArrayLike) -> None:
        """
        Changes the friction of the next solve.
        """
    def set_pressure(self, /, pressure: NormalSolution | Field | ArrayLike) -> None:
        """
        Changes the pressure of the next solve.
        """
    def set_relative_displacement(self, /, relative: RelativeDisplacement) -> None:
        """
        Changes the relative displacement of the next solve.
        """
    @property
    def settings(self, /) -> Settings:
        """
        The settings of the next solve; may be assigned.
        """
    @settings.setter
    def settings(self, /, settings: Settings) -> None: ...
    def solve(self, /, load: TangentialLoad | None = None, *, force: Sequence[float] | NDArray[Any] | None = None, shift: Sequence[float] | NDArray[Any] | None = None, spring: tuple[Sequence[float], float] | None = None, force_x: float | None = None, force_y: float | None = None, shift_x: float | None = None, shift_y: float | None = None, spring_x: tuple[float, float] | None = None, spring_y: tuple[float, float] | None = None, twist: float | None = None, progress: Any | None = None, warn: bool = True) -> TangentialSolution:
        """
        Solves, for this load if one is given, else for the last one.

        Parameters
        ----------
        load, force, shift, spring, force_x, ... : optional
            As of :class:`TangentialProblem`.
        progress, warn : optional
            As of :meth:`NormalProblem.solve`.

        Returns
        -------
        TangentialSolution

        Raises
        ------
        NotFinite, NotPositive, ObliqueLoad, UnsupportedByModel, BeyondFrictionCapacity
            For the load, which is then as it was.
        NotConverged
            With ``report`` and ``last_iterate``.
        """

@final
class TangentialStiffness:
    """
    Slopes of the tangential forces along x and y and of the moment (rows) by the shifts along x and y and by the twist
    (columns), under a load that goes on and at its reversal. Forces over lengths in the first two rows and columns, the
    moment over radians in the last place. NaN for loads and motions that the model does not have: in the scalar model what
    is across its axis and the twist, on grids that repeat the twist.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __repr__(self, /) -> str: ...
    @property
    def bound(self, /) -> float:
        """
        Bound of the errors, relative to the root of the product of the two entries on the diagonal; infinite where
        pressure and traction are found together.
        """
    @property
    def loading(self, /) -> list[list[float]]:
        """
        Derivative of the forces of the last step with respect to the motions at its end, if the motion continues in its
        direction. Cells that came into contact in the step follow the motion only in part. After a step that presses a ball
        the derivative is about two thirds of Mindlin's stiffness, although all cells stick.
        ``history.stiffness(next_step=True)`` has the derivative of the next step, in which they resist fully.
        """
    @property
    def reversal(self, /) -> list[list[float]]:
        """
        Derivative if the motion reverses: all contact cells stick.
        """
    def in_series_with(self, /, springs: Sequence[float] | NDArray[Any]) -> TangentialStiffness:
        """
        The stiffness behind springs along x and y (forces over lengths).
        """

@final
class Tensor:
    """
    The nine influence coefficients at a point, displacement first, traction second (lengths over pressures).
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __repr__(self, /) -> str: ...
    @property
    def rows(self, /) -> list[list[float]]:
        """
        As rows, displacement first.
        """
    @property
    def xx(self, /) -> float:
        """
        Coefficient xx.
        """
    @property
    def xy(self, /) -> float:
        """
        Coefficient xy.
        """
    @property
    def xz(self, /) -> float:
        """
        Coefficient xz.
        """
    @property
    def yx(self, /) -> float:
        """
        Coefficient yx.
        """
    @property
    def yy(self, /) -> float:
        """
        Coefficient yy.
        """
    @property
    def yz(self, /) -> float:
        """
        Coefficient yz.
        """
    @property
    def zx(self, /) -> float:
        """
        Coefficient zx.
        """
    @property
    def zy(self, /) -> float:
        """
        Coefficient zy.
        """
    @property
    def zz(self, /) -> float:
        """
        Coefficient zz.
        """

@final
class TensorOperator:
    """
    Displacements along x, y and z from tractions along x, y and z; made by :meth:`HalfSpace.tensor_operator`. One thread
    at a time may use it.
    """
    def __repr__(self, /) -> str: ...
    def apply(self, /, tractions: Sequence[Any]) -> tuple[NDArray[float64], NDArray[float64], NDArray[float64]]:
        """
        The product with three arrays, tractions along x, y and z (pressures), which are read where they lie; returns the
        displacements along x, y and z (lengths).
        """
    @property
    def cells(self, /) -> int:
        """
        Cells of each component.
        """

@final
class VermeulenJohnson:
    """
    Creep forces of an elliptic contact that rolls along x, without spin: the curve of Vermeulen and Johnson with
    Kalker's slope.

    With the force f without slip, by :class:`KalkerCoefficients`, and x = |f| / (mu P), the force has the size
    mu P (1 - (1 - x/3)^3) along f, and mu P from x = 3 on. An approximation, some per cent below the solved force. For
    equal bodies, or bodies of which Dundurs' beta is zero. Vermeulen and Johnson (1964); Johnson (1985), section 8.4.

    Parameters
    ----------
    hertz : HertzEllipse
        The normal contact.
    friction : float
        Coefficient of friction mu (dimensionless), positive.
    creepage : pair of float
        Creepages along x and y (dimensionless), of either sign.

    Raises
    ------
    NotPositive, NotFinite, CoupledMaterials, BelowMinimum
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, hertz: HertzEllipse, friction: float, creepage: Sequence[float] | NDArray[Any]) -> VermeulenJohnson: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def coefficients(self, /) -> KalkerCoefficients:
        """
        The coefficients of the contact without slip.
        """
    @property
    def force(self, /) -> tuple[float, float]:
        """
        Tangential force on body 1 along x and y.
        """
    @property
    def relative_creepage(self, /) -> float:
        """
        The force without slip over the friction limit, x (dimensionless): 3 or more where the whole contact slips.
        """

@final
class Warning:
    """
    A remark on a converged solution that may mislead.

    ``kind`` names it: ``no_contact``, ``contact_at_edge``, ``unresolved_spots``, ``single_row_of_cells``, ``contact_spans_grid``,
    ``beyond_hardness``, ``stale_pressure``, ``underresolved_contact``, ``underresolved_stick_zone``, ``underresolved_slip_zone``,
    ``single_load_step``, ``stress_at_edge``, ``discretisation_error``, ``approach_beyond_grid``, ``large_contact_radius``,
    ``steep_surface``, ``held_shift_lost_force`` or ``neglected_lift``.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __hash__(self, /) -> int: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def __str__(self, /) -> str: ...
    @property
    def cells(self, /) -> int | None:
        """
        The cells it is about, if it counts any.
        """
    @property
    def kind(self, /) -> str:
        """
        Its name.
        """
    @property
    def message(self, /) -> str:
        """
        What it says, and what to do.
        """

@final
class WaveResponse:
    """
    The effect of a wave of traction on the surface of two bodies (lengths over pressures):
    :meth:`ElasticPair.response <stickslip.ElasticPair.response>`.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __repr__(self, /) -> str: ...
    @property
    def across(self, /) -> float:
        """
        Tangential displacement across the wave vector by traction across it.
        """
    @property
    def along(self, /) -> float:
        """
        Tangential displacement along the wave vector by traction along it.
        """
    @property
    def coupling(self, /) -> float:
        """
        Normal displacement by traction along the wave vector, and displacement along it by pressure, up to i.
        """
    @property
    def normal(self, /) -> float:
        """
        Normal displacement by pressure.
        """

@final
class Westergaard:
    """
    A wavy surface pressed on a half-space: waves along x, plane strain.

    The gap is amplitude (1 - cos(2 pi x / lambda)), lambda the wavelength. Contact forms strips of half-width a about
    every crest, up to the pressure p* of full contact. Westergaard (1939); Johnson (1985), section 13.2.

    Parameters
    ----------
    pair : ElasticPair
        The bodies.
    amplitude : float
        Amplitude of the waves, half their height (a length), positive.
    wavelength : float
        Wavelength lambda (a length), positive.
    mean_pressure : float
        Load over nominal area, positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair, amplitude: float, wavelength: float, mean_pressure: float) -> Westergaard: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def amplitude(self, /) -> float:
        """
        Amplitude of the waves, half their height (a length).
        """
    @property
    def approach(self, /) -> float:
        """
        Approach of the mean planes of the two surfaces since first touch (a length):
        amplitude R (1 - ln(R)) with R = mean_pressure / p*, and the amplitude in full contact.
        """
    @property
    def contact_fraction(self, /) -> float:
        """
        Fraction of the nominal area in contact, 2 a / lambda.
        """
    @property
    def contact_half_width(self, /) -> float:
        """
        Half-width of a contact strip, a = (lambda/pi) arcsin(sqrt(mean_pressure / p*)) (a length); half the wavelength
        in full contact.
        """
    @property
    def full_contact_pressure(self, /) -> float:
        """
        Lowest mean pressure of full contact, p* = pi E* amplitude / lambda.
        """
    def gap(self, /, x: ArrayLike) -> Any:
        """
        Gap between the surfaces (a length) at the distance x from a crest; zero in the contact, positive outside.
        """
    @property
    def is_full_contact(self, /) -> bool:
        """
        Whether the surfaces touch everywhere: the mean pressure is at least p*.
        """
    @property
    def max_pressure(self, /) -> float:
        """
        Pressure at the crests: 2 sqrt(mean_pressure p*), in full contact mean_pressure + p*.
        """
    @property
    def mean_pressure(self, /) -> float:
        """
        Mean pressure: the load over the nominal area.
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The bodies.
        """
    def pressure(self, /, x: ArrayLike) -> Any:
        """
        Pressure at the distance x from a crest: 2 p* cos(pi x / lambda) sqrt(sin^2(pi a / lambda) - sin^2(pi x / lambda)),
        zero outside the contact; in full contact mean_pressure + p* cos(2 pi x / lambda).
        """
    @property
    def wavelength(self, /) -> float:
        """
        Wavelength lambda (a length).
        """

@final
class WestergaardPartialSlip:
    """
    A wavy surface in partial slip: a constant mean pressure, then a traction along x that increases monotonically.

    The traction is mu times the difference between the pressure and that under 1 - f of the load, whose contact strips
    stick, f = |mean_traction| / (mu mean_pressure). A full contact sticks everywhere, under a uniform traction, until
    1 - f of the load is that of full contact. Exact for every nu, but for the coupling between pressure and traction of
    dissimilar bodies, which is neglected. Ciavarella (1998); Jaeger (1998).

    Parameters
    ----------
    contact : Westergaard
        The normal contact.
    friction : float
        Coefficient of friction mu (dimensionless), not negative.
    mean_traction : float
        Tangential force on body 1 along x over nominal area, of either sign, at most mu mean_pressure.

    Raises
    ------
    NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, contact: Westergaard, friction: float, mean_traction: float) -> WestergaardPartialSlip: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def contact(self, /) -> Westergaard:
        """
        The normal contact.
        """
    @property
    def mean_traction(self, /) -> float:
        """
        Mean traction on body 1, positive along +x: the tangential force over the nominal area.
        """
    @property
    def stick_half_width(self, /) -> float:
        """
        Half-width c of a stick strip (a length).
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Fraction of the contact area that sticks, c/a.
        """
    def traction(self, /, x: ArrayLike) -> Any:
        """
        Traction on body 1 along x (a pressure, of the sign of the mean traction) at the distance x from a crest; zero
        outside the contact.
        """

def _from_bytes(kind: type, *arguments: Any) -> Any:
    """
    What pickle calls for what has bytes of its own.
    """

def _restore(kind: str, version: str, bytes: bytes) -> Any:
    """
    What pickle calls. Pickles are read by the version that wrote them alone; histories have bytes of their own,
    which later versions read too.
    """

def archard(coefficient: Field | ArrayLike, pressure: Field | ArrayLike, slip_distance: Field | ArrayLike, *, depth: Field | ArrayLike | None = None, grid: Grid | None = None) -> NDArray[float64]:
    """
    Archard's law: the depth ``coefficient * pressure * slip_distance`` (lengths).

    Parameters
    ----------
    coefficient : float, Field or array_like of shape (ny, nx)
        Volume removed per normal force and sliding distance, of the body or the sum of both (one over a pressure), not
        negative.
    pressure, slip_distance : Field or array_like of shape (ny, nx)
        Pressure, and the length that each cell slipped under it (lengths), not negative: those of a step or of a cycle.
    depth : Field or array_like of shape (ny, nx), optional
        What has been removed before (lengths), which is added; zero by default.
    grid : Grid, optional
        That of arrays, which do not know theirs; the law does not depend on the size of the cells, and needs none.

    Returns
    -------
    ndarray of shape (ny, nx)
        Depths (lengths).

    Raises
    ------
    NegativeOrNotFinite, Sample, GridMismatch, Shape, NotFinite
    """

def asc_parse(bytes: bytes) -> Field:
    """
    A surface from the bytes of an ASC file (lengths in metres).
    """

def asc_read(path: str | PathLike[str]) -> Field:
    """
    A surface from an ASC file (lengths in metres).
    """

def at_points(bodies: HalfSpace, body: Body | str, tractions: Any, points: ArrayLike, *, uniform_stress: Stress | None = None) -> PointResults:
    """
    Stress and displacement at points, by sums over all cells.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    body : Body or str
        "one" or "two".
    tractions : solution, (normal, shear), State, History, array_like or (array_like, (array_like, array_like))
        Those of a solution of any kind or of both halves, or fields: a pressure, or a pressure and tractions along x and y.
    points : array_like of shape (n, 3)
        Each ``(x, y, depth)`` (lengths), the depth below the surface of the body.
    uniform_stress : Stress, optional
        A uniform stress of the body, such as bulk stress, which is added to that of the tractions everywhere; none by
        default. Displacements are those of the tractions alone.

    Returns
    -------
    PointResults
        Of each point in turn, and arrays of all.
    """

def bisinusoidal(grid: Grid, amplitude: float, wavelengths: Sequence[float] | NDArray[Any]) -> Field:
    """
    The gap ``amplitude * (1 - cos(2 pi x / wavelengths[0]) * cos(2 pi y / wavelengths[1]))`` under a product of waves
    (lengths), zero on its crests.
    """

def cone(grid: Grid, slope: float) -> Field:
    """
    The gap ``slope * r`` under a cone; the slope is the tangent of the angle between cone and plane.
    """

def crop(heights: Field | ArrayLike, columns: tuple[int, int], rows: tuple[int, int]) -> Field:
    """
    The part of a surface in the columns ``columns[0]`` to before ``columns[1]`` and the rows ``rows[0]`` to before
    ``rows[1]``, on a grid of its own around the origin.

    Raises
    ------
    Range
    """

def csv_parse(bytes: bytes, *, cell: Sequence[float] | NDArray[Any] | None = None, size: Sequence[float] | NDArray[Any] | None = None, missing: float | None = None, skip_rows: int = 0, skip_columns: int = 0, without_labels: bool = False) -> Field:
    """
    A field from the bytes of a matrix in text; see :func:`read`.
    """

def csv_read(path: str | PathLike[str], *, cell: Sequence[float] | NDArray[Any] | None = None, size: Sequence[float] | NDArray[Any] | None = None, missing: float | None = None, skip_rows: int = 0, skip_columns: int = 0, without_labels: bool = False) -> Field:
    """
    A field from a matrix in text.

    Parameters
    ----------
    path : path_like
        The file.
    cell, size : pair of float
        One of the two: sides of a cell, or of the grid (lengths).
    missing : float, optional
        The value that stands for a missing point; none by default.
    skip_rows : int, default 0
        Rows before the matrix.
    skip_columns : int, default 0
        Cells to leave out at the beginning of each row, for names or numbers of rows.
    without_labels : bool, default False
        Whether a first row or column that counts 0, 1, 2 holds heights; otherwise it is rejected.

    Raises
    ------
    File, Format, NotPositive
    """

def csv_to_bytes(field: Field | ArrayLike) -> bytes:
    """
    A field as a matrix in text.
    """

def csv_write(path: str | PathLike[str], field: Field | ArrayLike) -> None:
    """
    Writes a field as a matrix in text.
    """

def cylinder(grid: Grid, radius: float) -> Field:
    """
    The gap ``x^2 / (2 radius)`` under a cylinder of this radius (a length), whose axis is along y.
    """

def ellipsoid(grid: Grid, radius_x: float, radius_y: float) -> Field:
    """
    The gap ``x^2 / (2 radius_x) + y^2 / (2 radius_y)`` under a paraboloid of these radii of curvature (lengths).
    """

def energy(coefficient: Field | ArrayLike, energy: Field | ArrayLike, *, depth: Field | ArrayLike | None = None, grid: Grid | None = None) -> NDArray[float64]:
    """
    The energy law: the depth ``coefficient * energy / cell area`` (lengths).

    Parameters
    ----------
    coefficient : float, Field or array_like of shape (ny, nx)
        Volume removed per energy dissipated, of the body or the sum of both (one over a pressure), not negative.
    energy : Field or array_like of shape (ny, nx)
        Dissipated by each cell in a step or a cycle (forces times lengths), not negative.
    depth : optional
        As of :func:`archard`.
    grid : Grid, optional
        Needed where no Field is given, for the area of a cell: ``history.grid``.

    Returns
    -------
    ndarray of shape (ny, nx)
        Depths (lengths).

    Raises
    ------
    NegativeOrNotFinite, Sample, GridMismatch, Shape, NotFinite
    """

def fill_missing(heights: Field | ArrayLike) -> Filled:
    """
    Fills missing heights, which are NaN, by the smoothest surface through the rim of each hole (Laplace's equation).

    Raises
    ------
    Sample
        For an infinite height.
    Undetermined
        If all heights are missing.
    NotConverged
    """

def flat_punch(grid: Grid, radius: float, recess: float) -> Field:
    """
    The gap under a flat punch of this radius: zero in the cells whose centre is below it, the recess in the others
    (lengths). The recess only has to be deeper than the displacements.
    """

def gap_between(upper: Field | ArrayLike, lower: Field | ArrayLike) -> Field:
    """
    The gap between two rough bodies, touching at one point. Heights point out of their body, both as seen from body 1.
    Surfaces must be in one unit.
    """

def gap_from_heights(heights: Field | ArrayLike) -> Field:
    """
    The gap of a rough body against a flat one: the largest height less each height (lengths, non-negative).
    """

def gaussian_filter(heights: Field | ArrayLike, *, s: float | None = None, l: float | None = None, periodic: bool = False, along: str = "xy") -> Filtered:
    """
    Takes short waves, long waves or both off a surface by Gaussian filters (ISO 16610-61; of lines ISO 16610-21).

    Of a wave of the length of a nesting index half passes, of others 2 to the power of -(index/length)^2. Missing heights
    (NaN) have no weight and stay missing: filter before :func:`fill_missing`. At an edge the mean is that of the heights
    that are there: level the surface first; heights nearer to an edge or a hole than half an index are affected.

    Parameters
    ----------
    heights : Field or topography
        Lengths.
    s, l : float, optional
        Nesting indices, which are cut-off wavelengths (lengths): of the S filter, which takes off what is shorter, such as
        noise, and of the L filter, which takes off what is longer, the waviness. With both, the S-L surface is left.
    periodic : bool, default False
        Whether the surface continues periodically beyond its edges.
    along : "xy", "x" or "y", default "xy"
        Whether heights are averaged over the area, or along rows or columns.

    Raises
    ------
    NotPositive, BelowMinimum
        For a nesting index that is not positive, shorter than two cells or longer than the surface, or for an S filter
        of a longer index than that of the L filter.
    Sample, Undetermined, NotFinite, Memory

    Examples
    --------
    >>> import numpy as np, stickslip as ss
    >>> grid = ss.Grid.square(128, 128.0)
    >>> wave = ss.Field(grid, np.tile(np.sin(2.0 * np.pi * grid.x / 8.0), (128, 1)), unit="um")
    >>> filtered = ss.surface.gaussian_filter(wave, s=8.0, periodic=True)
    >>> float(np.abs(filtered.heights / wave - 0.5).max().round(12)), filtered.heights.unit
    (0.0, 'um')
    """

def identity(cells: int) -> LinearOperator:
    """
    The operator that changes nothing.
    """

def inverted(heights: Field | ArrayLike) -> Field:
    """
    Heights turned upside down (lengths).
    """

def level(heights: Field | ArrayLike, form: Any) -> Levelled:
    """
    Takes a form off a surface, by least squares.

    Parameters
    ----------
    heights : Field or topography
        Lengths.
    form : "mean", "plane" or int
        A number is the degree of a polynomial in x and y.

    Raises
    ------
    Degree, Sample, Undetermined
    """

def linear_stick_ratio(load: float, friction: float, force: float) -> float:
    """
    Stick ratio of a nominally flat rough contact under light loads, 1 - |force| / (friction load); zero without friction.

    Parameters
    ----------
    load : float
        Normal load (a force), positive.
    friction : float
        Coefficient of friction (dimensionless), not negative.
    force : float
        Tangential force, of either sign.

    Raises
    ------
    NotPositive, NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
    """

def max_stable_cycles(bodies: HalfSpace, coefficient: Field | ArrayLike, slip_distance: Field | ArrayLike) -> float:
    """
    Cycles whose wear by Archard's law may be taken off at once before the pressure swings without end:
    ``1.16 h / (E* k s)`` on square cells of side h (0.90 on a periodic grid), with coefficient of wear k and slip s.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    coefficient : float, Field or array_like of shape (ny, nx)
        As of :func:`archard`, the sum of both bodies (one over a pressure); for the energy law its coefficient times that of
        friction.
    slip_distance : Field or array_like of shape (ny, nx)
        The length that each cell slips in one cycle (lengths), not negative: :attr:`Cycle.slip_distance`.

    Returns
    -------
    float
        A number of cycles, not rounded; infinite where nothing slips. No pattern of pressure changes sign below half of it,
        where :class:`CycleJump` stays.

    Raises
    ------
    NegativeOrNotFinite, Sample, GridMismatch, Shape

    Examples
    --------
    >>> import numpy as np, stickslip
    >>> grid = stickslip.Grid.square(64, 64e-6)  # cells of a micrometre
    >>> bodies = stickslip.HalfSpace(grid, (stickslip.Material(115e9, 0.0), stickslip.Material.rigid()))
    >>> cycles = stickslip.wear.max_stable_cycles(bodies, 1e-14, np.full(grid.shape, 40e-6))
    >>> round(cycles, 1)
    25.2
    """

def minimise(operator: Any, linear: Any, *, lower: Any | None = None, upper: Any | None = None, total: float | None = None, spring: tuple[float, float] | None = None, diagonal: Any | None = None, preconditioner: LinearOperator | None = None, lower_bound: float = ..., start: Any | None = None, settings: Settings | None = None, tolerance: float | None = None, method: Method | str | None = None, max_iterations: int | None = None, time_limit: float | None = None, progress: Any | None = None) -> Minimum:
    """
    Minimises ``x'Cx/2 + linear'x`` within bounds, with ``sum(x) = total`` if given.

    Parameters
    ----------
    operator : LinearOperator or callable
        The symmetric operator C; a callable is given an array of the unknowns and returns their product.
    linear : array_like
        The linear term, as many numbers as there are unknowns.
    lower, upper : float or array_like, optional
        Bounds of the unknowns; 0 and infinity by default.
    total : float, optional
        Sum of the unknowns; free by default.
    spring : (far_end, compliance), optional
        Instead of a total: the multiplier is ``far_end - compliance * sum(x)``.
    diagonal : float or array_like, optional
        Numbers that are not negative, added to the diagonal of C; none by default.
    preconditioner : LinearOperator, optional
        An approximation of the inverse of C without ``diagonal``; none by default.
    lower_bound : float, default 0
        A lower bound of the smallest eigenvalue of a callable, by which the error is certified.
    start : array_like, optional
        Where the iteration starts; zero by default.
    settings : Settings, optional
        Method, tolerance and limits; those of ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        As of :class:`Settings`; they take precedence over ``settings``.
    progress : callable or bool, optional
        As of :meth:`NormalProblem.solve`.

    Returns
    -------
    Minimum

    Raises
    ------
    Length, Sample, Bounds, Total, Method, Tolerance, IterationLimit, NotConverged

    Examples
    --------
    >>> import numpy as np
    >>> from stickslip import cgm
    >>> bed = np.array([1.0, 2.0, 4.0])  # independent springs
    >>> minimum = cgm.minimise(lambda x: bed * x, [-1.0, -1.0, 1.0], lower_bound=1.0)
    >>> minimum.x.round(6)
    array([1. , 0.5, 0. ])
    """

def mirror_x(heights: Field | ArrayLike) -> Field:
    """
    Heights with x mirrored, as the surface of a body that is turned over is seen.
    """

def npy_grid(path: str | PathLike[str], *, cell: Sequence[float] | NDArray[Any] | None = None, size: Sequence[float] | NDArray[Any] | None = None) -> Grid:
    """
    The grid of an NPY file, whose samples are not read.
    """

def npy_parse(bytes: bytes, *, cell: Sequence[float] | NDArray[Any] | None = None, size: Sequence[float] | NDArray[Any] | None = None) -> Field:
    """
    A field from the bytes of an NPY file.
    """

def npy_read(path: str | PathLike[str], *, cell: Sequence[float] | NDArray[Any] | None = None, size: Sequence[float] | NDArray[Any] | None = None) -> Field:
    """
    A field from an NPY file, on cells of the sides ``cell`` or a grid of the sides ``size`` (pairs of lengths).
    """

def npy_to_bytes(field: Field | ArrayLike) -> bytes:
    """
    A field as the bytes of an NPY file.
    """

def npy_write(path: str | PathLike[str], field: Field | ArrayLike) -> None:
    """
    Writes a field as NPY.
    """

def num_threads() -> int:
    """
    The number of threads of a solve.
    """

def paraboloid(grid: Grid, curvatures: Sequence[float] | NDArray[Any]) -> Field:
    """
    The gap ``(k_xx x^2 + 2 k_xy x y + k_yy y^2) / 2`` under a paraboloid of curvatures ``(k_xx, k_xy, k_yy)``
    (one over lengths), of which no principal curvature is negative.
    """

def read(path: str | PathLike[str]) -> Field:
    """
    A surface from a file, by its ending: ASC, SDF, SUR, X3P, XYZ. Lengths are in metres, but in the
    unit of the file for XYZ.
    """

def resample(heights: Field | ArrayLike, grid: Grid) -> Field:
    """
    A surface at the cell centres of another grid, by cubic interpolation along x and y.

    Raises
    ------
    Sample, BeyondSamples, Memory
    """

def sdf_parse(bytes: bytes) -> Field:
    """
    A surface from the bytes of an SDF file (lengths in metres).
    """

def sdf_read(path: str | PathLike[str]) -> Field:
    """
    A surface from an SDF file (lengths in metres).
    """

def sdf_to_bytes(field: Field | ArrayLike) -> bytes:
    """
    A surface as the bytes of an SDF file (lengths in metres).
    """

def sdf_write(path: str | PathLike[str], field: Field | ArrayLike) -> None:
    """
    Writes a surface as SDF (lengths in metres).
    """

def set_num_threads(threads: int) -> None:
    """
    Sets the number of threads of all later solves in this process; solves under way keep theirs.

    Results do not depend on it, to the last bit. The default is the environment variable ``RAYON_NUM_THREADS``, or
    else the number of cores. With one thread all work is done by the thread that calls: no other is ever started.

    Parameters
    ----------
    threads : int
        At least 1.

    Examples
    --------
    >>> import stickslip
    >>> stickslip.set_num_threads(2)
    >>> stickslip.num_threads()
    2
    """

def sinusoidal(grid: Grid, amplitude: float, wavelength: float) -> Field:
    """
    The gap ``amplitude * (1 - cos(2 pi x / wavelength))`` under straight waves (lengths), zero on their crests.
    """

def sphere(grid: Grid, radius: float) -> Field:
    """
    The gap under a sphere of this radius (a length): the paraboloid ``(x^2 + y^2) / (2 radius)`` of Hertz's theory.
    Gaps are lengths, zero where the shape touches the plane.
    """

def sum(fields: Sequence[Field | ArrayLike]) -> Field:
    """
    The sum of fields on one grid, cell by cell: the gap between two bodies is the sum of both shapes. Surfaces must be in
    one unit.
    """

def sur_parse(bytes: bytes) -> Field:
    """
    A surface from the bytes of a SUR file (lengths in metres).
    """

def sur_read(path: str | PathLike[str]) -> Field:
    """
    A surface from a SUR file (lengths in metres).
    """

def threshold_energy(coefficient: Field | ArrayLike, threshold: float, accumulated: Field | ArrayLike, energy: Field | ArrayLike, *, depth: Field | ArrayLike | None = None, grid: Grid | None = None) -> NDArray[float64]:
    """
    The energy law beyond a threshold: what a step or a cycle adds to ``coefficient * max(0, accumulated / cell area -
    threshold)`` (lengths).

    Parameters
    ----------
    coefficient : float, Field or array_like of shape (ny, nx)
        As of :func:`energy`.
    threshold : float
        The energy per area that wears nothing, not negative.
    accumulated, energy : Field or array_like of shape (ny, nx)
        Dissipated by each cell since the start, this step or cycle included, and in this one (forces times lengths), not
        negative.
    depth : optional
        As of :func:`archard`.
    grid : Grid, optional
        Needed where no Field is given, for the area of a cell: ``history.grid``.

    Returns
    -------
    ndarray of shape (ny, nx)
        Depths (lengths).

    Raises
    ------
    NegativeOrNotFinite, Sample, GridMismatch, Shape, NotFinite
    """

def vti_to_bytes(fields: dict[str, Any], *, grid: Grid | None = None) -> bytes:
    """
    Fields as the bytes of an image for ParaView; see :func:`write`.
    """

def vti_write(path: str | PathLike[str], fields: dict[str, Any], *, grid: Grid | None = None) -> None:
    """
    Writes fields as an image for ParaView.

    Parameters
    ----------
    path : path_like
        The file, which is replaced.
    fields : dict
        Fields, or pairs of fields for vectors, by name.
    grid : Grid, optional
        Needed for arrays.
    """

def x3p_parse(bytes: bytes) -> Field:
    """
    A surface from the bytes of an X3P file (lengths in metres).
    """

def x3p_read(path: str | PathLike[str]) -> Field:
    """
    A surface from an X3P file (lengths in metres).
    """

def xyz_parse(bytes: bytes, *, missing: float | None = None, skip_rows: int = 0) -> Field:
    """
    A surface from the bytes of an XYZ file (lengths in the unit of the file); see :func:`read`.
    """

def xyz_read(path: str | PathLike[str], *, missing: float | None = None, skip_rows: int = 0) -> Field:
    """
    A surface from an XYZ file (lengths in the unit of the file).

    Parameters
    ----------
    path : path_like
        The file.
    missing : float, optional
        The height of a missing point (default: the value that a comment names, or none).
    skip_rows : int, default 0
        Lines before the points.

    Raises
    ------
    File, Format
    """

