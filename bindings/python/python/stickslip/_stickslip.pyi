# Written by stubs.py from the hints of the module.
"""
Extension module of the package ``stickslip``; import that package instead.
"""
from collections.abc import Callable, Iterator, Sequence
from typing import Any, Final, final

from numpy import bool_, float64, uint8, uint32, uint64
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "AdaptiveProblem",
    "AdaptiveSolution",
    "AdaptiveSteps",
    "Autocorrelation",
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
    "Functional",
    "Grid",
    "GridRecord",
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
    "MaterialRatio",
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
    "PointResult",
    "PointResults",
    "PopovLimitingShape",
    "PowerSpectrum",
    "Principal",
    "PvdWriter",
    "Rectangle",
    "Region",
    "RelativeDisplacement",
    "Report",
    "Rolling",
    "RollingProblem",
    "RollingSolution",
    "RollingSolver",
    "RoughSphere",
    "RoughSurface",
    "RoundedPunch",
    "SelfAffine",
    "Sensitivity",
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
    "WithoutOutliers",
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
    "remove_outliers",
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
from stickslip._enums import AdaptiveStatus, Amplitudes, Axis, Body, CellValue, Component, Coupling, EigenvalueBound, EntryRule, Interpolation, LeadingEdge, Method, Quantity, Regime, Status, TangentialModel
from stickslip._spring import Spring
from typing_extensions import disjoint_base

__version__: Final[str]
"""
Version of the package.
"""

@final
class AdaptiveProblem:
    """
    Bodies, gap, load and required accuracy of a contact, whose grid the solve chooses.

    The solve finds the part of the region where the bodies touch. It refines a grid on this part until all estimated errors
    are at most their targets, or until a limit is reached. The estimates are not bounds.

    The search for the contact evaluates the gap at 192 x 192 positions of the region. It does not find a bump between these
    positions. The docs of the Rust module ``adaptive`` describe the method and the estimates.

    Parameters
    ----------
    pair : ElasticPair, two Materials, or Kernel
        The two bodies; z points into the first.
    gap : callable or Field
        The gap before loading (lengths). A function ``gap(x, y)`` receives two arrays of one dimension and equal length, the
        coordinates of positions in the region (lengths). It returns an array of their shape. A Field contains samples on a
        grid that is centred on the origin. The cells are not smaller than the distance between the samples.
    region : Region
        The region where contact may occur. The samples of a Field must cover it.
    force, approach : float
        Exactly one of the two: the normal force (not negative), or the approach of the bodies from the datum of the gap
        (a length, positive when they move together). The tangential load has other keywords.
    target : float or dict, default 0.01
        The largest estimated errors, each between 0 and 1. A number is the target of the pressure, and of the traction if
        there is friction. A dictionary contains the target of each :class:`Quantity`, such as ``{"area": 1e-3}``.
    interpolation : Interpolation or str, default "cubic"
        Interpolation between the samples of a Field: "cubic" or "linear".
    friction : Friction or float, optional
        Coulomb friction with a uniform coefficient (dimensionless, not negative). Friction requires a tangential load or
        ``first_step``.
    load : TangentialLoad, optional
        The tangential load as an object, instead of by keywords. It acts on the contact under its final pressure, as in a
        :class:`~stickslip.TangentialProblem`.
    shift, spring, force_x, force_y, shift_x, shift_y, spring_x, spring_y, twist : optional
        The tangential load; see :class:`~stickslip.TangentialLoad`.
    first_step : LoadStep, optional
        The first step of a history, instead of a tangential load. The normal load of the problem replaces the normal load of
        the step. :attr:`AdaptiveSolution.history` can then take further steps on the same grid.
    model : TangentialModel or str, default "scalar"
        "scalar" computes the traction along the axis of the load, "vector" both components.
    coupling : Coupling or str, optional
        Coupling for bodies of different materials: by default "one_way", or "full" with ``first_step``.
    cell_limit : int, default 1048576
        The largest number of cells of a grid, at least 1024.
    time_limit : float, optional
        Wall time (s) after which no further grid is solved; no limit by default.

    Raises
    ------
    Tolerance, Sample, UnsupportedByModel, BelowMinimum

    Examples
    --------
    >>> import stickslip as ss
    >>> steel = ss.Material(213e9, 0.29)
    >>> region = ss.adaptive.Region.rectangle((-20e-3, 20e-3), (-20e-3, 20e-3))
    >>> ball = lambda x, y: (x**2 + y**2) / 7e-3
    >>> problem = ss.adaptive.AdaptiveProblem((steel, steel), ball, region, force=100.0, target={"approach": 1e-3})
    >>> contact = problem.solve()
    >>> hertz = ss.analytical.HertzSphere(ss.ElasticPair(steel, steel), radius=3.5e-3, load=100.0)
    >>> contact.is_reached, abs(contact.approach / hertz.approach - 1.0) < 1e-3
    (True, True)
    """
    def __getnewargs_ex__(self, /) -> tuple[tuple[Any, ...], dict[str, Any]]: ...
    def __new__(cls, /, pair: ElasticPair | Kernel | tuple[Material, Material], gap: Callable[[NDArray[float64], NDArray[float64]], ArrayLike] | Field, region: Region, *, force: float | None = None, approach: float | None = None, target: float | dict[Any, float] = 0.01, interpolation: Interpolation | str | None = None, friction: Friction | float | None = None, load: TangentialLoad | None = None, shift: Sequence[float] | NDArray[Any] | None = None, spring: Spring | None = None, force_x: float | None = None, force_y: float | None = None, shift_x: float | None = None, shift_y: float | None = None, spring_x: Spring | None = None, spring_y: Spring | None = None, twist: float | None = None, first_step: LoadStep | None = None, model: TangentialModel | str | None = None, coupling: Coupling | str | None = None, cell_limit: int | None = None, time_limit: float | None = None) -> AdaptiveProblem: ...
    def __repr__(self, /) -> str: ...
    def solve(self, /, *, progress: Any | None = None, warn: bool = True) -> AdaptiveSolution:
        """
        Solves the contact on finer and finer grids until all estimates are at most their targets or a limit is reached.

        A limit is not an error. The solution then belongs to the finest grid: its status states the limit, and a warning is
        issued. An exception of the gap function ends the solve and is raised unchanged. Ctrl-C takes effect between grids, or
        between calls of the gap function.

        Parameters
        ----------
        progress : callable or bool, optional
            A function that is called with a :class:`GridRecord` after the solve on each grid. If it returns ``False``, the
            solve ends with the solution on this grid and the status "cancelled". An exception in the function ends the solve.
            ``True`` shows a progress bar of tqdm.
        warn : bool, default True
            Whether the warnings of the solution are also issued through ``warnings``, each kind once per location.

        Returns
        -------
        AdaptiveSolution

        Raises
        ------
        EmptyContact
            If the bodies do not touch.
        Sample
            If the gap is not finite at a position.
        BeyondSamples
            If the samples of the gap do not cover the region.
        ValueError
            If the array that the gap function returns has a wrong shape.

        Notes
        -----
        Exceptions of the contact on a grid can also occur, such as :class:`~stickslip.errors.BeyondFrictionCapacity`.
        """
    @property
    def targets(self, /) -> dict[str, float]:
        """
        Targets of the estimated errors, by the names of the quantities.
        """

@final
class AdaptiveSolution:
    """
    Contact with estimated errors, on the finest grid of a solve. It cannot be pickled; its parts, such as ``normal`` and
    ``history``, can.
    """
    def __repr__(self, /) -> str: ...
    @property
    def approach(self, /) -> float:
        """
        Approach of the bodies from the datum of the gap (a length). On a grid that is periodic along x and y, it is the mean
        initial gap minus the mean gap under load.
        """
    @property
    def area(self, /) -> float:
        """
        Contact area from the edges inside the cells (a length squared).
        """
    @property
    def bodies(self, /) -> HalfSpace:
        """
        The bodies on the grid, for instance for a further problem.
        """
    @property
    def centre(self, /) -> tuple[float, float]:
        """
        Centre of the grid in the coordinates of the gap, (x, y) (lengths).
        """
    def difference(self, /, finer: AdaptiveSolution, quantity: Quantity | str) -> float:
        """
        Returns the difference of a quantity from a solution on a finer grid, in the definition of :class:`Quantity`. The
        difference is zero for a tangential quantity without friction.
        """
    def edges(self, /) -> TangentialEdges | None:
        """
        Returns the edges of contact and stick zone inside the cells; ``None`` without friction. Without friction,
        ``normal.edges()`` returns the edge of the contact.

        Raises
        ------
        UnsupportedForCoatings
        """
    @property
    def estimates(self, /) -> dict[str, float]:
        """
        Estimated errors of all quantities, by name. The dictionary is empty if only one grid was solved.
        """
    @property
    def force(self, /) -> float:
        """
        Normal force, the integral of the pressure.
        """
    @property
    def gap(self, /) -> NDArray[float64]:
        """
        The gap before loading at the centres of the cells (lengths), shape (ny, nx).
        """
    @property
    def grid(self, /) -> Grid:
        """
        The grid, whose coordinates are relative to :attr:`centre`.
        """
    @property
    def grids(self, /) -> list[GridRecord]:
        """
        The grids of all solves after the search for the contact, in order.
        """
    @property
    def history(self, /) -> History | None:
        """
        The history after its first step, for further steps on the same grid; ``None`` without ``first_step``. Further steps
        do not change the other attributes of this solution. The tolerance of the history is 2 % of the smallest target (2e-4
        for the default targets); call ``set_settings`` for a smaller tolerance. Its grid is centred on ``centre``: add the
        centre to positions.
        """
    @property
    def is_reached(self, /) -> bool:
        """
        Whether all estimated errors are at most their targets.
        """
    @property
    def normal(self, /) -> NormalSolution:
        """
        The normal contact.
        """
    @property
    def status(self, /) -> AdaptiveStatus:
        """
        Reason why the refinement ended.
        """
    @property
    def stick_ratio(self, /) -> float | None:
        """
        Ratio of stick area to contact area from the edges inside the cells; ``None`` without friction.
        """
    @property
    def tangential(self, /) -> TangentialSolution | None:
        """
        The tangential contact; ``None`` without a tangential load.
        """
    @property
    def targets(self, /) -> dict[str, float]:
        """
        Targets of the estimated errors, by the names of the quantities.
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Warnings of the normal contact and of the tangential contact or first step, each kind once, and the warning
        ``accuracy_not_reached`` if a limit ended the refinement.
        """
    @property
    def x(self, /) -> NDArray[float64]:
        """
        Coordinates x of the cell centres, in the coordinates of the gap (lengths), shape (nx,).
        """
    @property
    def y(self, /) -> NDArray[float64]:
        """
        Coordinates y of the cell centres, in the coordinates of the gap (lengths), shape (ny,).
        """

@final
class AdaptiveSteps:
    """
    Applies a load in steps short enough for a given tolerance, and estimates the error of a step. The buffers of this
    object require the memory of four states.

    Parameters
    ----------
    history : History
        A history on the grid of the histories to be stepped.
    tolerance : float
        Tolerance of :attr:`StepErrorEstimate.traction` for a whole load, in (0, 1). It must be at least about a hundred
        times the tolerance of the history's settings.

    Raises
    ------
    Tolerance
    """
    def __new__(cls, /, history: History, tolerance: float) -> AdaptiveSteps: ...
    def __repr__(self, /) -> str: ...
    def error(self, /, history: History, load: LoadStep) -> StepErrorEstimate:
        """
        Returns the error of a single step with this load. The state of the history is unchanged afterwards. The history then
        has no last step until its next step.
        """
    def step(self, /, history: History, load: LoadStep, *, cycle: Cycle | None = None, warn: bool = True) -> int:
        """
        Applies a load in as many steps as the tolerance requires, and returns the number of steps. Ctrl-C takes effect
        after the current part. The state of the history is then unchanged, but it has no last step until its next step.

        The last step of the history is the last of these steps, with its slip and energy alone. For wear, give ``cycle``, or take the
        increase of :attr:`History.accumulated_dissipation`.

        Parameters
        ----------
        history : History
            The history to which the load is applied.
        load : LoadStep
            The load at the end of the last step. All prescribed quantities change proportionally from their previous
            values.
        cycle : Cycle, optional
            A cycle to which each step is added.
        warn : bool, default True
            Whether the warnings of the last step are also issued through ``warnings``, each kind once per location.

        Raises
        ------
        GridMismatch, StepTooLong
            In addition to the exceptions of :meth:`History.step`.
        """

@final
class Autocorrelation:
    """
    The autocorrelation function of a surface, with the spatial parameters of ISO 25178-2.

    The function is the mean product of the heights of all pairs of measured points at a lag, relative to its value without a
    lag. Lags extend to half the length of the grid along each axis. Level the surface first.

    Parameters
    ----------
    heights : Field or topography
        The heights (lengths). Missing heights (NaN) form no pairs.
    periodic : bool, default False
        Whether the surface continues periodically beyond its edges.

    Raises
    ------
    Sample, Undetermined, Memory

    Examples
    --------
    >>> import numpy as np, stickslip as ss
    >>> grid = ss.Grid.square(256, 256.0)
    >>> wave = ss.Field(grid, np.tile(np.sin(2.0 * np.pi * grid.x / 128.0), (256, 1)))
    >>> correlation = ss.surface.Autocorrelation(wave, periodic=True)
    >>> round(correlation.Sal / 128.0, 3), round(float(np.arccos(0.2) / (2.0 * np.pi)), 3)
    (0.218, 0.218)
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, heights: Field | ArrayLike, *, periodic: bool = False) -> Autocorrelation: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def Sal(self, /) -> float | None:
        """
        Autocorrelation length (ISO 25178-2) for the threshold 0.2: :meth:`decay_length`.
        """
    @property
    def Str(self, /) -> float | None:
        """
        Texture aspect ratio (ISO 25178-2) for the threshold 0.2: :meth:`texture_aspect_ratio`.
        """
    def decay_length(self, /, threshold: float = ...) -> float | None:
        """
        Returns the autocorrelation length Sal (a length): the smallest distance over which the function falls to a
        threshold between 0 and 1; ``None`` if it remains above the threshold at all lags.

        Raises
        ------
        ArgumentRange
            If the threshold is not between 0 and 1.
        """
    def texture_aspect_ratio(self, /, threshold: float = ...) -> float | None:
        """
        Returns the texture aspect ratio Str, from 0 to 1: the smallest divided by the largest distance over which the
        function falls to a threshold between 0 and 1; ``None`` if it remains above the threshold at all lags. In directions in which
        the function does not fall to the threshold, the largest lag is used, so the true ratio is smaller.

        Raises
        ------
        ArgumentRange
            If the threshold is not between 0 and 1.
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns the numbers by name; a pair (x, y) becomes two numbers with the endings ``_x`` and ``_y``. The numbers of
        an object with the same method have its name as the prefix.
        """
    def to_series(self, /) -> Any:
        """
        Returns the numbers of :meth:`to_dict` as a :class:`pandas.Series` (requires pandas).
        """
    @property
    def values(self, /) -> Field:
        """
        The function on a grid of lags; the lag of a cell is its position, and the lag zero is in the middle. NaN at lags
        without a pair of measured points.
        """

@final
class BentallJohnson:
    """
    Cylinders of different materials that roll freely, without a tangential force and with little friction: the limit
    of Bentall and Johnson's solution for a friction coefficient much smaller than Dundurs' beta.

    The pressure stretches the surfaces by different amounts. Body 1 therefore slips over body 2, per unit length
    rolled, by s = 2 beta p / E* - xi, and the traction is mu p against the slip. There is no slip if beta is zero.
    The leading edge is at +x; if it is at -x, creepage and slip have the opposite sign. Bentall and Johnson (1967);
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
    def __new__(cls, /, hertz: HertzLine, *, friction: float) -> BentallJohnson: ...
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
        Energy dissipated by slip per unit length rolled (a force per length), 0.1239 mu |beta| P a/R. It must be
        supplied to keep the cylinders rolling.
        """
    @property
    def reversal(self, /) -> float:
        """
        Half-width of the middle strip (a length), at whose ends the slip reverses: 0.4040 a.
        """
    def slip(self, /, x: ArrayLike) -> Any:
        """
        Returns the slip of body 1 over body 2 at x per unit length rolled (dimensionless), or zero outside the
        contact.
        """
    def traction(self, /, x: ArrayLike) -> Any:
        """
        Returns the traction on body 1 along x (a pressure) at x, mu p against the slip, or zero outside the contact.
        """

@final
class Boundary:
    """
    Boundary condition at the edge of the grid.

    Every argument of this type also accepts ``"non_periodic"``, ``"periodic"`` and ``("periodic_along_y", datum)``. On a
    grid that is periodic along x and y, the approach is measured from the mean gap and the shift from the mean plane of
    the surface.
    """
    NON_PERIODIC: Final[Boundary]
    """
    Unloaded half-space outside the grid.
    """
    PERIODIC: Final[Boundary]
    """
    Grid that is periodic along x and y.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def datum(self, /) -> float | None:
        """
        The datum (a length) of a grid that is periodic along y only; ``None`` for other grids.
        """
    @property
    def name(self, /) -> str:
        """
        Name of the boundary condition.
        """
    @staticmethod
    def periodic_along_y(datum: float) -> Boundary:
        """
        Returns the boundary of a grid that is periodic along y only, for cylinders, rollers and line contacts. The datum
        (a length, at least the length of the grid) is the distance along x from a line load at which that load causes no
        displacement. Approach and shift are relative to this datum.
        """

@final
class Carter:
    """
    A cylinder that rolls steadily with longitudinal creepage, in plane strain: Carter's solution.

    The leading edge is at x = a. A strip of half-width c = a (1 - |xi| / xi_s) that ends at the leading edge
    sticks; the rest slips, against the traction. For creepages of xi_s or more, the whole contact slips. The
    solution is valid for equal bodies and for bodies whose Dundurs' beta is zero. Carter (1926); Johnson (1985),
    section 8.3.

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
    def __new__(cls, /, hertz: HertzLine, *, friction: float, creepage: float) -> Carter: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def force(self, /) -> float:
        """
        Tangential force Q on body 1 (a force per length), with the sign of the creepage and the magnitude mu P (1 -
        c^2/a^2).
        """
    @property
    def sliding_creepage(self, /) -> float:
        """
        Smallest creepage at which the whole contact slips (dimensionless), xi_s = 2 mu p_0 / E*.
        """
    @property
    def stick_half_width(self, /) -> float:
        """
        Half-width c of the stick strip at the leading edge (a length).
        """
    def traction(self, /, x: ArrayLike) -> Any:
        """
        Returns the traction on body 1 along x (a pressure) at x: with the sign of the creepage, mu p_0 sqrt(1 -
        x^2/a^2), minus mu p_0 (c/a) sqrt(1 - (x - a + c)^2/c^2) in the stick strip. The traction is zero outside the
        contact.
        """

@final
class CattaneoMindlin:
    """
    A sphere in partial slip: a constant normal load, then a tangential force along x that increases monotonically.

    With f = |F| / (mu W) a disc of radius c = a (1 - f)^(1/3) sticks. The ring around it slips, opposite to the
    traction. This is the solution of the scalar model, with traction along x only; for tractions along both axes, it
    is exact for nu = 0. The coupling between pressure and traction of dissimilar bodies is neglected. Cattaneo
    (1938); Mindlin (1949); Johnson (1985), 7.41-7.44.

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
    def __new__(cls, /, hertz: HertzSphere, *, friction: float, force: float) -> CattaneoMindlin: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def displacement(self, /, x: ArrayLike, y: ArrayLike) -> Any:
        """
        Returns the tangential displacement u_x of body 1 relative to body 2 (a length, with the sign of the force),
        anywhere in the plane: shift and slip inside the contact.
        """
    @property
    def energy_of_first_quarter(self, /) -> float:
        """
        Energy dissipated while the force grows from zero to F (a force times a length, not negative): (mu W delta_0 /
        5) (1 - c/a)^3 (1 + 3 c/a + c^2/a^2). This is the first quarter of a cycle.
        """
    @property
    def energy_per_cycle(self, /) -> float:
        """
        Energy dissipated in one full cycle of the force between F and -F (a force times a length), four times the
        energy of the first quarter.
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
        Shift delta_x (a length): the rigid motion of body 2 relative to body 1, with the sign of the force and the
        magnitude (3 mu W / 16 a) ((2 - nu)/G) (1 - (1 - f)^(2/3)).
        """
    @property
    def sliding_shift(self, /) -> float:
        """
        Shift at which the whole contact begins to slide, delta_0 (a length, positive): the shift under mu W.
        """
    def slip(self, /, x: ArrayLike, y: ArrayLike) -> Any:
        """
        Returns the slip u_x - delta_x (a length, opposite to the force) in the ring that slips; zero elsewhere.
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
        Returns the traction on body 1 along x (a pressure, with the sign of the force) at the distance r from the
        centre: mu p_0 sqrt(1 - r^2/a^2), minus mu p_0 (c/a) sqrt(1 - r^2/c^2) in the stick disc. The traction is zero
        outside the contact.
        """

@final
class CattaneoMindlinEllipse:
    """
    An elliptic paraboloid in partial slip: a constant normal load, then a tangential force along x that increases
    monotonically.

    The stick ellipse is the contact ellipse scaled by s = (1 - f)^(1/3), with f = |F| / (mu W). This is the solution
    of the scalar model, with traction along x only. The coupling between pressure and traction of dissimilar bodies
    is neglected. Mindlin (1949); Vermeulen and Johnson (1964).

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
    def __new__(cls, /, hertz: HertzEllipse, *, friction: float, force: float) -> CattaneoMindlinEllipse: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def energy_of_first_quarter(self, /) -> float:
        """
        Energy dissipated while the force grows from zero to F (a force times a length, not negative); see
        :attr:`CattaneoMindlin.energy_of_first_quarter`.
        """
    @property
    def energy_per_cycle(self, /) -> float:
        """
        Energy dissipated in one full cycle of the force between F and -F (a force times a length), four times the
        energy of the first quarter.
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
        Shift (a length): the rigid motion of body 2 relative to body 1, with the sign of the force. Its magnitude
        is 1 - s^2 times the shift at which the whole contact begins to slide.
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
        Semi-axes of the stick ellipse along x and y (lengths): s times the semi-axes of the contact.
        """
    def traction(self, /, x: ArrayLike, y: ArrayLike) -> Any:
        """
        Returns the traction on body 1 along x (a pressure, with the sign of the force), or zero outside the contact.
        With rho^2 = x^2/a_x^2 + y^2/a_y^2, it is mu p_0 sqrt(1 - rho^2), reduced in the stick ellipse by mu p_0
        sqrt(s^2 - rho^2).
        """

@final
class CattaneoMindlinLine:
    """
    A cylinder in partial slip in plane strain: a constant normal load, then a tangential force along x that
    increases monotonically, together with a proportional bulk strain.

    With f = |Q| / (mu P) a strip of half-width c = a sqrt(1 - f) sticks; the rest slips, opposite to the traction.
    The solution is valid for equal bodies and for bodies whose Dundurs' beta is zero. Johnson (1985), section 7.2;
    with bulk strain Nowell & Hills, Int. J. Mech. Sci. 29 (1987) 355.

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
    def __new__(cls, /, hertz: HertzLine, *, friction: float, force: float) -> CattaneoMindlinLine: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def energy_of_first_quarter(self, /) -> float:
        """
        Energy dissipated per length while the force, and the strain with it, grow from zero: a quarter of the energy
        per cycle.
        """
    @property
    def energy_per_cycle(self, /) -> float:
        """
        Energy dissipated per length in a cycle of the force between Q and -Q with the strain proportional to the
        force, ((mu P)^2 / (pi E*)) (4 (1 - f) ln(1 - f) + 4 f - 2 f^2 + 8 f e^2/a^2).
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
        Returns the shift (a length): the rigid motion of body 2 relative to body 1 along x, with the sign of the
        force, relative to the datum d (a length) of :meth:`Boundary.periodic_along_y`. The strain causes no
        displacement at x = 0. The magnitude of the shift is (mu P / (pi E*)) (f (2 ln(2d/a) + 1) + (1 - f) ln(1 -
        f) + 2 e^2/a^2). It is NaN if the datum is zero or negative.
        """
    @property
    def stick_centre(self, /) -> float:
        """
        Middle of the strip that sticks (a length along x), with the magnitude a E* strain / (2 mu p_0); zero
        without strain.
        """
    @property
    def stick_half_width(self, /) -> float:
        """
        Half-width of the strip that sticks, c = a sqrt(1 - f) (a length).
        """
    def stress(self, /, x: ArrayLike, depth: ArrayLike) -> tuple[tuple[Any, Any, Any], tuple[Any, Any, Any]]:
        """
        Returns the stresses xx, zz and xz of body 1 and of body 2 at x and at a depth below the surface of each body
        (a length, zero or more). Stresses are pressures, positive in tension, and include the bulk stress. Johnson
        (1985), 7.2.

        Raises
        ------
        ArgumentRange
            If a depth is negative.
        """
    def surface_stress(self, /, x: ArrayLike) -> tuple[Any, Any]:
        """
        Returns the stresses xx of the surfaces of body 1 and of body 2 at x (pressures, positive in tension),
        including the bulk stress. In body 1 the largest stress is at the trailing edge of the contact with respect
        to the traction, x = -a for a positive force, where the stress rises as a square root. Values on a row of
        cells therefore converge slowly to this maximum. Johnson (1985), 2.23 and 7.2; Nowell & Hills (1987).
        """
    def traction(self, /, x: ArrayLike) -> Any:
        """
        Returns the traction on body 1 along x (a pressure) at x: with the sign of Q, mu p_0 sqrt(1 - x^2/a^2), minus
        mu p_0 (c/a) sqrt(1 - (x - e)^2/c^2) in the stick strip with the middle e. The traction is zero outside the
        contact.
        """
    def with_bulk_stress(self, /, stress: Sequence[float] | NDArray[Any]) -> CattaneoMindlinLine:
        """
        Adds bulk stresses along x in bodies 1 and 2 (pressures, positive in tension), which grow proportionally to
        the force and strain the bodies in plane strain.

        Raises
        ------
        Sample, NotFinite, NotPositive, BelowMinimum
            See :meth:`with_strain`.
        """
    def with_strain(self, /, strain: float) -> CattaneoMindlinLine:
        """
        Adds a strain along x: the strain of body 1 minus the strain of body 2, positive in tension. In plane strain,
        a bulk stress along x in one body causes the strain stress (1 - nu^2) / E; see
        :meth:`Material.plane_strain_under`.

        Raises
        ------
        NotFinite, NotPositive
        BelowMinimum
            If the stick strip would extend beyond the contact. The slip then reverses at one end.
        """

@final
class Cone:
    """
    A blunt cone pressed on a half-space.

    The gap is r tan(beta), with the small angle beta between flank and surface. The mean pressure is independent of
    the load, so that the contact area is proportional to the load, as for a rough surface. Sneddon (1965); Johnson
    (1985), section 5.2.

    Parameters
    ----------
    pair : ElasticPair or two Materials
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
    def __new__(cls, /, pair: ElasticPair | tuple[Material, Material], *, slope: float, load: float) -> Cone: ...
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
        Returns the normal displacement u_z of the surfaces (a length), summed over the bodies and positive into each,
        at the distance r from the centre: delta - r tan(beta) inside the contact, and outside it (a arcsin(a/r) - r +
        sqrt(r^2 - a^2)) tan(beta).
        """
    def gap(self, /, r: ArrayLike) -> Any:
        """
        Returns the gap u_z + r tan(beta) - delta between the surfaces (a length) at the distance r from the centre;
        zero in the contact, positive outside.
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
        Returns the pressure (E* tan(beta) / 2) arcosh(a/r) at the distance r from the centre; infinite at the apex,
        zero outside the contact.
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

    The traction is mu times the difference between the pressure under W and the pressure under the reduced load (1 -
    f) W, with f = |F| / (mu W). The contact circle under the reduced load is the stick disc. This is the solution of
    the scalar model, with traction along x only. The coupling between pressure and traction of dissimilar bodies is
    neglected. Ciavarella, J. Appl. Mech. 65 (1998) 998; Jaeger, J. Tribology 120 (1998) 677.

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
    def __new__(cls, /, cone: Cone, *, friction: float, force: float) -> ConePartialSlip: ...
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
        Shift (a length): the rigid motion of body 2 relative to body 1, with the sign of the force and the
        magnitude mu delta (2 - nu) / (2 (1 - nu)) (1 - sqrt(1 - f)).
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
        Returns the traction on body 1 along x (a pressure, with the sign of the force) at the distance r from the
        centre: (mu E* tan(beta) / 2) arcosh(a/r), minus the same expression with c instead of a in the stick disc.
        The traction is zero outside the contact.
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
        Grid of the labels.
        """
    @property
    def labels(self, /) -> NDArray[uint32]:
        """
        Number of the spot of each cell, counted from 1, of shape (ny, nx); 0 outside the contact.
        """
    @property
    def largest(self, /) -> Spot | None:
        """
        The spot with the largest area.
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns arrays by name, with one entry per element; a vector becomes one array per component with the endings
        ``_x``, ``_y`` and ``_z``, and stresses have endings such as ``_xx``.
        """
    def to_frame(self, /) -> Any:
        """
        Returns the arrays of :meth:`to_dict` as columns of a :class:`pandas.DataFrame` (requires pandas).
        """

@final
class ContactStiffness:
    """
    Derivatives of all forces of a contact with respect to its motions.

    The sets of contact, stick and slip cells are fixed. The pressure is constant while the bodies are sheared,
    unless pressure and traction are solved simultaneously. This class computes the stiffness of a contact that was
    loaded from rest; :meth:`History.stiffness` computes the stiffness after load steps.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    normal : NormalSolution
        The normal contact.
    friction : Friction, float or array_like of shape (ny, nx)
        The friction of the tangential contact.
    shear : TangentialSolution
        The tangential contact under the pressure of ``normal``.

    Raises
    ------
    GridMismatch, BoundaryMismatch, MaterialMismatch, NotFinite, Yielded, NotConverged
    CoupledMaterials
        If the two solutions are parts of a coupled solution of dissimilar bodies.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, bodies: HalfSpace, normal: NormalSolution, friction: Friction | float | ArrayLike, shear: TangentialSolution) -> ContactStiffness: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def by_approach(self, /) -> tuple[float, float, float]:
        """
        Derivatives of the tangential forces (forces over lengths) and the moment (a force) with respect to the
        approach, while slip continues. The friction limit of slip cells follows the pressure, and the tangential force
        follows the limit. NaN for components that the model does not have.

        The derivatives are valid if the shift grows in the same step, or if the approach decreases. If the bodies are
        pressed further at a constant shift, the slip cells stick and the derivatives are zero. The derivatives have no
        error bound. After a solve with one-way coupling they exclude the tangential displacement due to the pressure;
        after steps of a history they include it.
        """
    @property
    def normal(self, /) -> NormalStiffness:
        """
        Derivative of the normal force with respect to the approach.
        """
    @property
    def normal_by_motion(self, /) -> tuple[float, float, float]:
        """
        Derivatives of the normal force with respect to the shifts along x and y (forces over lengths) and the twist (a
        force). They are zero unless pressure and traction are solved simultaneously, and NaN for motions that the model
        does not have.
        """
    @property
    def tangential(self, /) -> TangentialStiffness:
        """
        Derivatives of the tangential forces and the moment with respect to the shifts and the twist.
        """

@final
class Convolution(LinearOperator):
    """
    The convolution with an influence coefficient by fast Fourier transforms.

    Parameters
    ----------
    grid : Grid
        The cells.
    pair : ElasticPair or two Materials
        The two bodies.
    component : Component or str
        Direction of the displacement first, direction of the traction second.
    periodic : bool, default False
        Whether the grid is periodic along x and y.
    """
    def __new__(cls, /, grid: Grid, pair: ElasticPair | tuple[Material, Material], component: Component | str, *, periodic: bool = False) -> Convolution: ...

@final
class CoupledProblem:
    """
    Bodies, gap, friction and loads of a contact whose pressure and tractions are solved simultaneously, from rest in one
    step.

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
        The tangential load; see :class:`TangentialLoad`. No force by default, which presses the bodies only.
    normal_force, approach : float
        Exactly one of the two: the normal force (not negative), or the approach of the bodies from the datum of the gap
        (a length, positive when they move together).
    relative_displacement : RelativeDisplacement, optional
        A displacement of body 1 relative to body 2 that is not caused by the contact. It grows proportionally to the
        load; none by default.
    hardness : Hardness, float or array_like of shape (ny, nx), optional
        The largest pressure that the cells can carry; no limit by default.
    settings : Settings, optional
        Method, tolerance and limits; ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        See :class:`Settings`; these arguments take precedence over ``settings``.

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
    def __new__(cls, /, bodies: HalfSpace, gap: Field | ArrayLike, friction: Friction | float | ArrayLike, load: TangentialLoad | None = None, *, normal_force: float | None = None, approach: float | None = None, force: Sequence[float] | NDArray[Any] | None = None, shift: Sequence[float] | NDArray[Any] | None = None, spring: Spring | None = None, force_x: float | None = None, force_y: float | None = None, shift_x: float | None = None, shift_y: float | None = None, spring_x: Spring | None = None, spring_y: Spring | None = None, twist: float | None = None, relative_displacement: RelativeDisplacement | None = None, hardness: Hardness | float | ArrayLike | None = None, settings: Settings | None = None, tolerance: float | None = None, method: Method | str | None = None, max_iterations: int | None = None, time_limit: float | None = None) -> CoupledProblem: ...
    def __repr__(self, /) -> str: ...
    def solve(self, /, *, progress: Any | None = None, warn: bool = True) -> CoupledSolution:
        """
        Solves from rest; see :meth:`NormalProblem.solve`. A force that makes the contact slide raises
        :class:`~stickslip.errors.BeyondFrictionCapacity`.
        """
    def solver(self, /) -> CoupledSolver:
        """
        Returns a solver of this problem, which keeps its buffers and starts each solve from the last solution.
        """

@final
class CoupledReport:
    """
    Termination and cost of a coupled solve, and the certified error bounds of its normal and tangential parts.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def error_bounds(self, /) -> tuple[float, float] | None:
        """
        Bounds on the errors of pressure and traction of the coupled problem; ``None`` unless friction is weak enough for
        such bounds.
        """
    @property
    def error_estimate(self, /) -> ErrorEstimate | None:
        """
        Estimated errors of the coupled problem, if available.
        """
    @property
    def is_converged(self, /) -> bool:
        """
        Whether the tolerance was reached.
        """
    @property
    def normal(self, /) -> Report:
        """
        Report of the steps and products with the normal part alone.
        """
    @property
    def pressure_error_bound(self, /) -> float:
        """
        Bound on the error of the pressure for the tractions of the solution.
        """
    @property
    def tangential(self, /) -> Report:
        """
        Report of the steps and products with the tangential part alone.
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns the numbers by name; a pair (x, y) becomes two numbers with the endings ``_x`` and ``_y``. The numbers of
        an object with the same method have its name as the prefix.
        """
    def to_series(self, /) -> Any:
        """
        Returns the numbers of :meth:`to_dict` as a :class:`pandas.Series` (requires pandas).
        """
    @property
    def traction_error_bound(self, /) -> float:
        """
        Bound on the error of the tractions for the pressure of the solution.
        """
    @property
    def work(self, /) -> Report:
        """
        Report of the whole solve: reason for its end, products with the full operator, residual and time.
        """

@final
class CoupledRollingProblem:
    """
    Bodies, gap, friction and loads of steady rolling in which the tractions change the pressure.

    The creepage is zero along an axis without a given creepage or force.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    gap : Field or array_like of shape (ny, nx)
        The gap before loading (lengths). An array is copied, a Field is shared.
    friction : Friction, float or array_like of shape (ny, nx)
        Coulomb friction; a number or an array is the coefficient of friction (dimensionless, not negative).
    normal_force, approach : float
        Exactly one of the two: the normal force (not negative), or the approach of the bodies from the datum of the gap
        (a length, positive when they move together).
    creepage, creepage_x, creepage_y, force, force_x, force_y, spin, moment : optional
        See :class:`RollingProblem`.
    leading_edge, step, entry_rule, slip_corrections : optional
        See :class:`RollingProblem`.
    settings : Settings, optional
        Method, tolerance and limits; ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        See :class:`Settings`; these arguments take precedence over ``settings``.

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
        Solves the problem once; see :meth:`NormalProblem.solve`.
        """
    def solver(self, /) -> CoupledRollingSolver:
        """
        Returns a solver of this problem, which keeps its buffers and starts each solve from the last solution.
        """

@final
class CoupledRollingReport:
    """
    Report of coupled rolling: termination, cost, number of passes and certified error bounds.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def coupling_residual(self, /) -> float:
        """
        Residual of the coupling: the lift within the contact added by the last pass, relative to the largest normal
        displacement.
        """
    @property
    def error_estimate(self, /) -> float | None:
        """
        Estimate of the relative error of the pressure of the coupled problem, if available.
        """
    @property
    def is_converged(self, /) -> bool:
        """
        Whether the tolerance was reached.
        """
    @property
    def normal(self, /) -> Report:
        """
        Report of the steps and products for the pressure.
        """
    @property
    def passes(self, /) -> int:
        """
        Number of passes: solves of the pressure, each followed by a solve of the tractions.
        """
    @property
    def pressure_change(self, /) -> float:
        """
        Relative change of the pressure in the last pass (ratio of root mean squares).
        """
    @property
    def pressure_error_bound(self, /) -> float:
        """
        Bound on the relative error of the pressure in the energy norm, for the tractions of the solution.
        """
    @property
    def rolling(self, /) -> Report:
        """
        Report of the steps and products for the tractions.
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns the numbers by name; a pair (x, y) becomes two numbers with the endings ``_x`` and ``_y``. The numbers of
        an object with the same method have its name as the prefix.
        """
    def to_series(self, /) -> Any:
        """
        Returns the numbers of :meth:`to_dict` as a :class:`pandas.Series` (requires pandas).
        """
    @property
    def traction_error_bound(self, /) -> float:
        """
        Bound on the relative error of the tractions, for the pressure of the solution.
        """
    @property
    def work(self, /) -> Report:
        """
        Report of all passes: status, steps, products, and the largest residual of the normal and the tangential part.
        """

@final
class CoupledRollingSolution:
    """
    Normal and rolling solution of coupled steady rolling.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def normal(self, /) -> NormalSolution:
        """
        The normal solution; a copy.
        """
    @property
    def report(self, /) -> CoupledRollingReport:
        """
        Report with termination, cost, number of passes and certified error bounds.
        """
    @property
    def rolling(self, /) -> RollingSolution:
        """
        The rolling solution; a copy.
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Warnings about a result that might mislead; empty if there are none.
        """

@final
class CoupledRollingSolver:
    """
    Solves coupled rolling for successive loads, each time from the last solution; created by
    :meth:`CoupledRollingProblem.solver`.
    """
    def __new__(cls, /, *_arguments: Any, **_options: Any) -> CoupledRollingSolver: ...
    def __repr__(self, /) -> str: ...
    @property
    def friction(self, /) -> Friction:
        """
        The friction of the next solve, as last set, with its ``max_shear_stress``.
        """
    @property
    def gap(self, /) -> NDArray[float64]:
        """
        The gap before loading of the next solve (lengths), as last set; a read-only copy.
        """
    @property
    def report(self, /) -> CoupledRollingReport:
        """
        Report of the last solve.
        """
    def reset(self, /) -> None:
        """
        Discards the last solution, so that the next solve starts like the first.
        """
    def set_friction(self, /, friction: Friction | float | ArrayLike) -> None:
        """
        Sets the friction of the next solve. A law or a coefficient replaces the last law, with its ``max_shear_stress``. A
        coefficient alone has none; a warning is issued if the last law had one.
        """
    def set_gap(self, /, gap: Field | ArrayLike) -> None:
        """
        Sets the gap of the next solve (lengths).

        Raises
        ------
        GapUnderLoad
            If the gap is the gap of the last solution, which is the gap under load.
        ValueError
            If the unit of the gap differs from that of the earlier gaps.
        """
    def set_normal_load(self, /, *, normal_force: float | None = None, approach: float | None = None) -> None:
        """
        Sets the normal load of the next solve: a normal force (not negative) or an approach (a length). If friction cannot
        carry the prescribed forces under this normal force, the load is unchanged and
        :class:`~stickslip.errors.BeyondFrictionCapacity` is raised.
        """
    @property
    def settings(self, /) -> Settings:
        """
        Settings of the next solve; assignable.
        """
    @settings.setter
    def settings(self, /, settings: Settings) -> None: ...
    def solve(self, /, *, creepage: Sequence[float] | NDArray[Any] | None = None, creepage_x: float | None = None, creepage_y: float | None = None, force: Sequence[float] | NDArray[Any] | None = None, force_x: float | None = None, force_y: float | None = None, spin: float | None = None, moment: float | None = None, normal_force: float | None = None, approach: float | None = None, progress: Any | None = None, warn: bool = True) -> CoupledRollingSolution:
        """
        Solves for the given creepages, forces, spin or moment. Omitted arguments keep their last values.

        The arguments set the problem of the solver. They remain set if the solve fails or is cancelled; invalid arguments
        leave it unchanged.

        Parameters
        ----------
        creepage, creepage_x, creepage_y, force, force_x, force_y, spin, moment : optional
            See :class:`RollingProblem`. A creepage or force along an axis replaces the last one along that axis only, and a
            spin or moment replaces the last spin or moment.
        normal_force, approach : float, optional
            One of them sets the normal load together with the other arguments.
        progress, warn : optional
            See :meth:`NormalProblem.solve`.

        Returns
        -------
        CoupledRollingSolution

        Raises
        ------
        NotFinite, UnsupportedByModel
            If the prescribed values are invalid; they are then unchanged.
        EmptyContact, GridTooShort, BeyondFrictionCapacity, BeyondFrictionMoment
            If the contact cannot roll under these loads.
        NotConverged
            The exception has the attributes ``report`` and ``last_iterate``.
        """
    def stiffness(self, /) -> list[list[float]]:
        """
        Returns the derivatives of the forces along x and y and the moment (rows) with respect to the creepages along x
        and y and the spin (columns) at the last solution. They include the change of the pressure with the tractions.

        Raises
        ------
        OutdatedSolution
            If a load, the gap or the friction has changed since the last solve.
        NotConverged
            Before the first solve, if it has not converged, or if the solve of a column does not converge.
        """

@final
class CoupledSolution:
    """
    Normal and tangential solution of a coupled contact, with the displacements that they cause together. Both solutions
    and the arrays share the memory of this object. Two objects are equal if their solutions are equal and their units do
    not differ, even if the iterations differed.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def contact(self, /) -> NDArray[bool_]:
        """
        Mask of the cells in contact, booleans of shape (ny, nx): cells with positive pressure. A read-only copy.
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
        The normal solution.
        """
    @property
    def report(self, /) -> CoupledReport:
        """
        Termination, cost and error bounds of the solve.
        """
    def stiffness(self, /, bodies: HalfSpace, friction: Friction | float | ArrayLike) -> ContactStiffness:
        """
        Returns the derivatives of the forces and the moment with respect to approach, shift and twist, with the friction
        of the problem.
        """
    @property
    def tangential(self, /) -> TangentialSolution:
        """
        The tangential solution.
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Warnings about a result that might mislead; empty if there are none.
        """

@final
class CoupledSolver:
    """
    Solves coupled contacts repeatedly, each time from the last solution; created by :meth:`CoupledProblem.solver`.
    """
    def __new__(cls, /, *_arguments: Any, **_options: Any) -> CoupledSolver: ...
    def __repr__(self, /) -> str: ...
    @property
    def friction(self, /) -> Friction:
        """
        The friction of the next solve, as last set, with its ``max_shear_stress``.
        """
    @property
    def gap(self, /) -> NDArray[float64]:
        """
        The gap before loading of the next solve (lengths), as last set; a read-only copy.
        """
    def reset(self, /) -> None:
        """
        Discards the last solution, so that the next solve starts like the first.
        """
    def sensitivities(self, /, solution: CoupledSolution, functionals: Sequence[Functional], *, tolerance: float | None = None, poisson_ratio: bool = False) -> list[Sensitivity]:
        """
        Computes the sensitivities of several functionals, in their order. They share the responses to prescribed
        forces. The options and the exceptions are those of :meth:`sensitivity`.
        """
    def sensitivity(self, /, solution: CoupledSolution, functional: Functional, *, tolerance: float | None = None, poisson_ratio: bool = False) -> Sensitivity:
        """
        Computes the derivatives of a functional with respect to the input of the problem: gap, loads, friction and
        moduli.

        The derivatives of all cells together cost about one linear solve on the contact cells (the adjoint). The
        sets of contact, stick and slip cells are constant in the derivatives.

        Parameters
        ----------
        solution : CoupledSolution
            The solution of the present problem of this solver.
        functional : Functional
            The functional; see :class:`stickslip.sensitivity.Functional`.
        tolerance : float, optional
            Relative residual at which a linear problem counts as solved; 1e-11 by default.
        poisson_ratio : bool, default False
            Whether to compute the derivatives with respect to Poisson's ratios of tangential and coupled contacts,
            which require further operators. Normal contacts always have them.

        Returns
        -------
        Sensitivity

        Raises
        ------
        GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch
            If the solution belongs to other bodies, or if weights have a different grid.
        UnsupportedByModel
            If the functional depends on a quantity that the problem does not have.
        BelowMinimum, Sample, NotPositive, Tolerance
            If a number of the functional or the tolerance is invalid.
        EmptyContact
            If no cell carries pressure under a prescribed force.
        NotFinite
            If a number of the functional is not finite, if a periodic contact is closed everywhere, or if the contact
            cannot resist a change of the prescribed force, as in sliding.
        NotConverged
            If the solution has not converged, or if a linear solve fails.
        """
    def set_friction(self, /, friction: Friction | float | ArrayLike) -> None:
        """
        Sets the friction of the next solve. A law or a coefficient replaces the last law, with its ``max_shear_stress``. A
        coefficient alone has none; a warning is issued if the last law had one.
        """
    def set_gap(self, /, gap: Field | ArrayLike) -> None:
        """
        Sets the gap of the next solve (lengths).

        Raises
        ------
        GapUnderLoad
            If the gap is the gap of the last solution, which is the gap under load.
        ValueError
            If the unit of the gap differs from that of the earlier gaps.
        """
    def set_loads(self, /, load: TangentialLoad | None = None, *, normal_force: float | None = None, approach: float | None = None) -> None:
        """
        Sets the loads of the next solve: the tangential load, and either a normal force (not negative) or an approach (a
        length). An omitted load keeps its last value.
        """
    @property
    def settings(self, /) -> Settings:
        """
        Settings of the next solve; assignable.
        """
    @settings.setter
    def settings(self, /, settings: Settings) -> None: ...
    def solve(self, /, *, progress: Any | None = None, warn: bool = True) -> CoupledSolution:
        """
        Solves for the current loads, gap and friction; see :meth:`NormalProblem.solve`. The method accepts no loads: set them by
        :meth:`set_loads`.
        """

@final
class CreepForce:
    """
    Point of a creep curve or a creep surface: creepages, spin and the resulting loads.
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
        Ratio of stick cells to contact cells.
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Warnings about a large creepage, a large coefficient of friction and a neglected lift. The warnings about the
        contact are those of a :class:`RollingSolution`.
        """

@final
class CreepForces:
    """
    The points of a creep curve or a creep surface: a sequence of :class:`CreepForce`, and arrays with one number per
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
        Ratio of stick cells to contact cells.
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns arrays by name, with one entry per element; a vector becomes one array per component with the endings
        ``_x``, ``_y`` and ``_z``, and stresses have endings such as ``_xx``.
        """
    def to_frame(self, /) -> Any:
        """
        Returns the arrays of :meth:`to_dict` as columns of a :class:`pandas.DataFrame` (requires pandas).
        """

@final
class Cycle:
    """
    Slip, energy and the force-shift loop, accumulated over the steps of a cycle from the present state of the history.
    The arrays are read-only copies.

    Parameters
    ----------
    history : History
        The history in whose present state the cycle starts.
    """
    SUMMARY_NAMES: Final[str]
    """
    Header line of :meth:`summary_as_csv`.
    """
    def __new__(cls, /, history: History) -> Cycle: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def add(self, /, history: History) -> None:
        """
        Adds the last step of the history; call it once after each step.

        Add a step only after it is accepted. :meth:`History.set_state` does not remove an added step from the cycle. Copy the
        cycle by ``copy.copy`` before a step that may be rejected after it is added.

        Raises
        ------
        NoLastStep
            If the history has taken no step since it was created or since :meth:`History.set_state`.
        StepOutOfOrder
            If the last step of the history is not the next step of the cycle: skipped, already added, or not later than its start.
            A step of another history is rejected too, unless both histories had equal forces and motions before it.
        GridMismatch, BoundaryMismatch, MaterialMismatch
            If the history has other bodies than the history of the cycle.
        """
    def begin(self, /, history: History) -> None:
        """
        Discards all steps and restarts the cycle in the present state of the history.

        Raises
        ------
        GridMismatch, BoundaryMismatch, MaterialMismatch
            If the history has other bodies than the history of the cycle.
        """
    @property
    def cyclic_residual(self, /) -> float:
        """
        Measure of how far the cycle is from closing: the larger of two ratios. The first is the ratio of the largest
        change of a traction between start and end to the largest traction. The second is the ratio of the change of the
        shift to half the range of the shift.

        Raises
        ------
        EmptyPath
            If the cycle has no steps.
        """
    @property
    def dissipation(self, /) -> NDArray[float64]:
        """
        Energy that each cell dissipated in the cycle (forces times lengths, not negative). The array contains its grid, as the
        attribute ``grid``. The sum of the array is ``energy.dissipated_energy``.
        """
    @property
    def energy(self, /) -> EnergyBalance:
        """
        Work, elastic energy and dissipation of the cycle.
        """
    @property
    def energy_ratio(self, /) -> float:
        """
        Ratio of the dissipated energy to the area of a rectangle around the force-shift loop.

        The ratio has no meaning for a path that does not return to its start. The warnings ``open_cycle`` and ``repeated_loop``
        of the cycle are also issued by ``warnings.warn`` when the ratio is read.

        Raises
        ------
        EmptyPath
            If the cycle has no steps.
        """
    @property
    def force_amplitude(self, /) -> tuple[float, float]:
        """
        Half the range of the force along x and y.
        """
    @property
    def points(self, /) -> LoopPoints:
        """
        The force-shift loop: the start, and the end of each step. A copy.
        """
    def points_as_csv(self, /) -> str:
        """
        Returns the loop as CSV.
        """
    @property
    def regime(self, /) -> Regime:
        """
        Regime of the cycle: stick, partial slip or sliding.

        Raises
        ------
        EmptyPath
            If the cycle has no steps.
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
        Pressure under which each cell slipped, averaged over its slip path; zero for cells without slip.
        """
    @property
    def steps(self, /) -> int:
        """
        Number of steps added.
        """
    @property
    def stick_ratios(self, /) -> tuple[float, float]:
        """
        Smallest and largest stick ratio.

        Raises
        ------
        EmptyPath
            If the cycle has no steps.
        """
    def summary_as_csv(self, /) -> str:
        """
        Returns the cycle as a line of CSV.

        Raises
        ------
        EmptyPath
            If the cycle has no steps.
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Warnings of the steps.
        """
    @property
    def work_of_loads(self, /) -> float:
        """
        Work of the tangential force and of the moment (a force times a length), equal to the area enclosed by the loop if
        it is closed. In contrast, the ``work`` of :attr:`energy` includes the work of a changing relative displacement,
        such as bulk strain.
        """

@final
class CycleJump:
    """
    Number of cycles to jump over: the largest factor by which the wear of a cycle can be multiplied without oscillations
    of the pressure.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    cycle : Cycle
        The cycle that represents the skipped cycles.
    depth : Field or array_like of shape (ny, nx)
        Depth that the cycle removed from both bodies together (lengths), not negative.
    largest_depth : float, optional
        The largest depth that a jump may remove in any cell (a length); no limit by default.
    max_residual : float, default 0.25
        The largest :attr:`Cycle.cyclic_residual` of a cycle that may represent the following cycles.
    cycles_left : float, optional
        The largest number of cycles to jump over, such as the rest of a simulation; no limit by default.

    Raises
    ------
    GridMismatch, Shape, Sample
    """
    def __new__(cls, /, bodies: HalfSpace, cycle: Cycle, depth: Field | ArrayLike, *, largest_depth: float | None = None, max_residual: float | None = None, cycles_left: float | None = None) -> CycleJump: ...
    def __repr__(self, /) -> str: ...
    def cycles(self, /) -> int | None:
        """
        Returns the number of whole cycles to jump over, or ``None`` if no limit applies, as in full stick without
        ``cycles_left``. Without wear, multiplying by the number of cycles would have no meaning, so the number is not infinite.

        Raises
        ------
        NoWholeCycle
            If one cycle already removes more than the limit.
        CycleNotClosed, NotPositive, NegativeOrNotFinite
        """
    @property
    def is_unlimited(self, /) -> bool:
        """
        Whether no limit applies to the number of cycles: no cell wears, and ``cycles_left`` is not given.

        Raises
        ------
        CycleNotClosed, NotPositive, NegativeOrNotFinite
        """

@final
class DenseMinimum:
    """
    Result of a direct minimisation.
    """
    def __repr__(self, /) -> str: ...
    @property
    def multiplier(self, /) -> float:
        """
        Multiplier of the prescribed total; zero without a total.
        """
    @property
    def x(self, /) -> NDArray[float64]:
        """
        The unknowns.
        """

@final
class DenseOperator(LinearOperator):
    """
    An explicit square matrix with at most 4096 unknowns.

    Parameters
    ----------
    rows : array_like of shape (n, n)
        The entries of the symmetric matrix.

    Raises
    ------
    TooManyCells, Sample
    """
    def __new__(cls, /, rows: Any) -> DenseOperator: ...
    def get(self, /, row: int, column: int) -> float | None:
        """
        Returns the entry of a row and a column, or ``None`` outside the matrix.
        """
    def minimise(self, /, linear: Any, *, lower: Any | None = None, upper: Any | None = None, total: float | None = None) -> DenseMinimum:
        """
        Minimises ``x'Cx/2 + linear'x`` within bounds, with ``sum(x) = total`` if given, by a direct method.

        Parameters
        ----------
        linear : array_like
            The linear term, one number per unknown.
        lower, upper : float or array_like, optional
            Bounds of the unknowns; zero and infinity by default.
        total : float, optional
            Sum of the unknowns; free by default.

        Returns
        -------
        DenseMinimum

        Raises
        ------
        Sample, Bounds, Total, NotPositiveDefinite, NotConverged
        GridMismatch, Shape
            See :func:`stickslip.cgm.minimise`.
        """
    @staticmethod
    def of_half_space(bodies: HalfSpace, component: Component | str) -> DenseOperator:
        """
        Creates the matrix of one influence coefficient between all cells of a half-space.
        """

@final
class Edges:
    """
    The edge of a contact or of its stick zone with sub-cell resolution, returned by :meth:`NormalSolution.edges`,
    :meth:`TangentialSolution.edges` and :meth:`History.edges`.

    At a distance s from a smooth edge, the pressure is proportional to the square root of s and the gap to s to the
    power 3/2. In 7 x 7 cells about each cell at the edge, one quadratic function is fitted to the square of the
    pressure and to the gap to the power 2/3. If the fit is rejected, the cell keeps its computed pressure, and its area
    is corrected by a mean value.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def area(self, /) -> float:
        """
        Area of the contact or stick zone, with the covered parts of the cells at the edge (a length squared).
        """
    def areas_of(self, /, spots: ContactSpots) -> NDArray[float64]:
        """
        Returns the areas of the contact spots, in their order, with the covered parts of the cells at the edges (lengths
        squared).
        """
    @property
    def cells(self, /) -> NDArray[uint64]:
        """
        Flat indices of the cells at the edge, in increasing order.
        """
    @property
    def centres(self, /) -> NDArray[float64]:
        """
        Values at the centres of all cells, shape (ny, nx): the pressure for a contact, or the margin to the friction
        limit for a stick zone (pressures).
        """
    @property
    def covered(self, /) -> NDArray[float64]:
        """
        Covered fraction of each cell of :attr:`cells`, from 0 to 1.
        """
    @property
    def grid(self, /) -> Grid:
        """
        Grid of the cells.
        """
    @property
    def is_fitted(self, /) -> NDArray[bool_]:
        """
        Whether the edge was fitted, for each cell of :attr:`cells`.
        """
    @property
    def means(self, /) -> NDArray[float64]:
        """
        Mean values over the cells, shape (ny, nx), of the quantity of :attr:`centres`.
        """
    @property
    def outline(self, /) -> NDArray[float64]:
        """
        The edge as line segments (lengths): an array of shape (n, 2, 2), with the coordinates (x, y) of both ends of each
        segment.
        """
    @property
    def unfitted_fraction(self, /) -> float:
        """
        Fraction of the cells at the edge whose fit was rejected.
        """

@final
class ElasticPair:
    """
    Two bodies, at most one of them rigid.

    Parameters
    ----------
    body_1, body_2 : Material
        The two bodies. The z axis points into body 1. Pressure and traction are those that act on body 1; on body 2 they
        have the opposite sign.

    Raises
    ------
    BothRigid, NotPositive, NotFinite
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __hash__(self, /) -> int:
        """
        Equal pairs have equal hashes.
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
        Dundurs' second parameter, which measures the coupling of pressure and traction; zero if they are not coupled.

        beta = ((1 - 2 nu_1) / G_1 - (1 - 2 nu_2) / G_2) / (2 ((1 - nu_1) / G_1 + (1 - nu_2) / G_2)). It is positive if
        body 1 has the larger value of (1 - 2 nu) / G, and an exchange of the bodies reverses its sign. It is zero for
        bodies of the same material, for two incompressible bodies, and for an incompressible body on a rigid body.
        """
    @property
    def equivalent_poisson_ratio(self, /) -> float:
        """
        Poisson's ratio of the single body with the compliance of both bodies, nu = G (nu_1/G_1 + nu_2/G_2).
        """
    @property
    def equivalent_shear_modulus(self, /) -> float:
        """
        Shear modulus G of the single body with the compliance of both bodies (a pressure), 1/G = 1/G_1 + 1/G_2. It is
        half of the modulus of each of two equal bodies.
        """
    @property
    def hardness(self, /) -> float:
        """
        The hardness of the softer body (a pressure); infinite if none is stated.
        """
    @property
    def is_coated(self, /) -> bool:
        """
        Whether one of the bodies is coated.
        """
    @property
    def is_coupled(self, /) -> bool:
        """
        Whether pressure and traction are coupled.
        """
    def response(self, /, k: float) -> WaveResponse:
        """
        Returns the response of the relative displacement u_1 - u_2 to waves of traction of the wave number k > 0 (one
        over a length).

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
    Energy balance of the work of the tangential load in a step or in the steps of a cycle (energies).

    The balance holds for any two states. A balance that closes verifies the bookkeeping of the step, and not the laws of
    contact.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def dissipated_energy(self, /) -> float:
        """
        Dissipated energy, computed from the tractions at the end of the step, not negative. If pressure and friction do
        not change and the load does not turn within the step, this value is exact for any length of the step. Compare this value
        of a :class:`Cycle` with Mindlin's energy of a loop, and not ``dissipated_energy_midpoint``.
        """
    @property
    def dissipated_energy_midpoint(self, /) -> float:
        """
        Dissipated energy, computed from the mean of the tractions before and after the step. This value closes the
        balance. It is not negative if pressure and friction do not change. In partial slip it depends on the length of the
        steps and approaches ``dissipated_energy`` with shorter steps.
        """
    @property
    def elastic_after(self, /) -> float:
        """
        Elastic energy of shear after the step or cycle; energy of pressure and traction if both are solved
        simultaneously.
        """
    @property
    def elastic_before(self, /) -> float:
        """
        Elastic energy of shear before the step or cycle; energy of pressure and traction if both are solved
        simultaneously.
        """
    @property
    def imbalance(self, /) -> float:
        """
        Deficit of the balance, relative to its largest term.
        """
    @property
    def released(self, /) -> float:
        """
        Energy released by the tractions of cells that leave the contact.
        """
    @property
    def residual(self, /) -> float:
        """
        Work on the residual motion that the tolerance permits in stick cells.
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns the numbers by name; a pair (x, y) becomes two numbers with the endings ``_x`` and ``_y``. The numbers of
        an object with the same method have its name as the prefix.
        """
    def to_series(self, /) -> Any:
        """
        Returns the numbers of :meth:`to_dict` as a :class:`pandas.Series` (requires pandas).
        """
    @property
    def work(self, /) -> float:
        """
        Work of the tangential load: mean force times change of the shift, plus mean moment times change of the twist.
        Cells that come into contact contribute only the part of the motion that they follow. The work of a changing
        relative displacement is included, and so is the work of the normal load if pressure and traction are solved
        simultaneously.
        """

@final
class ErrorEstimate:
    """
    Estimated errors of a coupled contact as a whole, each in its energy norm. The estimates are not bounds.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def pressure(self, /) -> float:
        """
        Estimated error of the pressure.
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns the numbers by name; a pair (x, y) becomes two numbers with the endings ``_x`` and ``_y``. The numbers of
        an object with the same method have its name as the prefix.
        """
    def to_series(self, /) -> Any:
        """
        Returns the numbers of :meth:`to_dict` as a :class:`pandas.Series` (requires pandas).
        """
    @property
    def traction(self, /) -> float:
        """
        Estimated error of the traction.
        """

@final
class Field:
    """
    Samples at the cells of a grid, one number per cell, such as gaps, heights or pressures. A field is immutable.

    Every argument that accepts a field also accepts an array of shape (ny, nx), which is copied. A Field is created once
    and shared, so repeated calls copy nothing. ``numpy.asarray(field)`` is a read-only view of a field, and
    ``field[iy, ix]`` is a sample. A sum, difference, product, quotient or power with a field, an array or a number, in
    either order, is computed cell by cell and is a field. A quotient by zero, and any other result that is not finite, issues the
    warning of NumPy. A comparison by ``<``, ``<=``, ``>`` or ``>=`` is an array of booleans, and so is a comparison by ``==`` or ``!=``
    with a number or an array. Two fields are compared as a whole by ``==`` and ``!=``, whose result is one truth value; compare
    their arrays for a result per cell. Fields have no hash. Other NumPy functions, such as ``numpy.maximum``, treat a field as its array: their result has no unit, and fields of
    different units raise an error. The axes of an array of xarray with the
    dimensions x and y are recognised by their names, also by NumPy functions of a field. Its coordinates x and y, if any, must rise in
    steps of the cell sides. Dimensions of other names raise an error if they have coordinates. The labels of a DataFrame of pandas are
    either such coordinates, whole numbers that rise in steps of one, or names. Its rows are y and its columns x. Other labels, such as
    those of a reversed or shuffled table, raise an error. A transposed table raises an error if its axes have the names y and x, or if
    its coordinates do not agree with the cell sides. On a grid of equal sides, a transposed table without names is not noticed. Masked cells and the value ``NA`` of pandas are missing points
    (NaN). They are rejected in a gap or a pressure, and :func:`surface.fill_missing <stickslip.surface.fill_missing>` fills them.

    Parameters
    ----------
    grid : Grid
        Grid of the samples.
    samples : array_like of shape (ny, nx), or float
        The values, row-major with x fastest, or one value for all cells.
    unit : str, optional
        The unit of the lengths of a surface, such as ``"um"``: heights and cell sides. Accepted units are those of
        :meth:`to_unit`. Results computed from the surface keep the unit, and operations on surfaces of different units raise
        an error. The unit is optional; the package computes in any consistent units.

    Notes
    -----
    A number, an array or a field without a unit takes the unit of the other operand in sums, differences and comparisons.
    A product with it and a quotient by it keep the unit, so ``heights * 1e-6`` does not convert a unit; :meth:`to_unit`
    does. Products and ratios of two fields with units, inverse fields and powers have no unit. A gap that replaces the gap of
    a solver or history has the unit of that gap, and raises an error if it states another unit.

    Bodies, loads and grids have no unit. A gap is therefore used as given: its lengths must have the unit of the sides of the
    grid, and moduli and forces a consistent unit. ``Field(grid, heights, "um")`` states that heights and cell sides are both in
    micrometres. Heights in micrometres on a grid in metres are converted by their factor, ``Field(grid, 1e-6 * heights, "m")``.
    An array of xarray whose attribute ``units`` differs from the attribute ``units`` of its coordinates raises an error;
    coordinates without this attribute have the unit of the array.
    In sums with an array of xarray, the field must be the first operand, ``field + array``; the reverse order raises an error. The
    reverse order of a ``Variable`` of xarray raises none and ignores the names of its axes.

    Raises
    ------
    ValueError
        If the unit is not a unit of length.
    Shape, GridMismatch

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
    __pandas_priority__: Final[int]
    def __abs__(self, /) -> Field: ...
    def __add__(self, other: object, /) -> Field: ...
    def __array__(self, /, dtype: Any | None = None, copy: bool | None = None) -> Any: ...
    def __array_function__(self, /, function: Any, _types: Any, arguments: Any, options: dict[str, Any]) -> Any:
        """
        Implements NumPy functions that are not ufuncs, such as ``numpy.stack``, in the same way.
        """
    def __array_ufunc__(self, /, ufunc: Any, method: str, *inputs: Any, **kwargs: Any) -> Any:
        """
        Implements NumPy functions with a field among their operands. Fields of different units are rejected, as in arithmetic.
        """
    def __eq__(self, value: object, /) -> Any: ...
    def __ge__(self, value: object, /) -> NDArray[bool_]: ...
    def __getitem__(self, index: Any, /) -> Any:
        """
        Indexes :attr:`array`: ``field[iy, ix]`` is a sample, and ``field[iy]`` is a row.
        """
    def __gt__(self, value: object, /) -> NDArray[bool_]: ...
    def __le__(self, value: object, /) -> NDArray[bool_]: ...
    def __lt__(self, value: object, /) -> NDArray[bool_]: ...
    def __mul__(self, other: object, /) -> Field: ...
    def __ne__(self, value: object, /) -> Any: ...
    def __neg__(self, /) -> Field: ...
    def __new__(cls, /, grid: Grid, samples: Field | ArrayLike, unit: str | None = None) -> Field: ...
    def __pos__(self, /) -> Field: ...
    def __pow__(self, other: object, modulo: None = None, /) -> Field: ...
    def __radd__(self, other: object, /) -> Field: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def __rmul__(self, other: object, /) -> Field: ...
    def __rpow__(self, other: object, modulo: None = None, /) -> Field: ...
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
        Returns the sample of a cell, given by column and row, or ``None`` outside the grid.
        """
    @property
    def grid(self, /) -> Grid:
        """
        Grid of the field.
        """
    def integral(self, /) -> float:
        """
        Returns the sum of the samples times the area of a cell.
        """
    def max(self, /, axis: Any = None, **options: Any) -> Any:
        """
        Returns the largest sample; NaN is ignored. The arguments are those of :func:`numpy.nanmax`, such as the axis.
        """
    def mean(self, /, axis: Any = None, **options: Any) -> Any:
        """
        Returns the mean of the samples. The arguments are those of :func:`numpy.mean`, such as the axis.
        """
    def min(self, /, axis: Any = None, **options: Any) -> Any:
        """
        Returns the smallest sample; NaN is ignored. The arguments are those of :func:`numpy.nanmin`, such as the axis.
        """
    @property
    def shape(self, /) -> tuple[int, int]:
        """
        Shape of the field as an array, (ny, nx).
        """
    def std(self, /, axis: Any = None, **options: Any) -> Any:
        """
        Returns the standard deviation of the samples. The arguments are those of :func:`numpy.std`, such as the axis.
        """
    def sum(self, /, axis: Any = None, **options: Any) -> Any:
        """
        Returns the sum of the samples. The arguments are those of :func:`numpy.sum`, such as the axis.
        """
    def to_unit(self, /, unit: str) -> Field:
        """
        Converts the heights and the cell sides of a surface from its own unit to another unit.

        Accepted units are km, m, dm, cm, mm, um, nm, A and pm; the micro sign may replace the letter u.

        Raises
        ------
        ValueError
            If the unit of the surface is not known, or if either unit is not in this list.
        """
    @property
    def unit(self, /) -> str | None:
        """
        Unit of the lengths of a surface; ``None`` if it is not known.
        """

@final
class Filled:
    """
    A surface whose missing heights (NaN) are filled smoothly.
    """
    def __array__(self, /, dtype: Any | None = None, copy: bool | None = None) -> Any: ...
    def __array_function__(self, /, function: Any, _types: Any, arguments: Any, options: dict[str, Any]) -> Any:
        """
        Implements other NumPy functions of the heights, in the same way.
        """
    def __array_ufunc__(self, /, ufunc: Any, method: str, *inputs: Any, **kwargs: Any) -> Any:
        """
        Implements NumPy functions of the heights. Operands of different units are rejected.
        """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def filled_cells(self, /) -> int:
        """
        Number of heights that were missing.
        """
    @property
    def heights(self, /) -> Field:
        """
        All heights (lengths).
        """

@final
class Filtered:
    """
    A filtered surface and the removed components: the three add up to the given surface.
    """
    def __array__(self, /, dtype: Any | None = None, copy: bool | None = None) -> Any: ...
    def __array_function__(self, /, function: Any, _types: Any, arguments: Any, options: dict[str, Any]) -> Any:
        """
        Implements other NumPy functions of the heights, in the same way.
        """
    def __array_ufunc__(self, /, ufunc: Any, method: str, *inputs: Any, **kwargs: Any) -> Any:
        """
        Implements NumPy functions of the heights. Operands of different units are rejected.
        """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def heights(self, /) -> Field:
        """
        The remaining heights (lengths); missing heights remain missing.
        """
    @property
    def long_waves(self, /) -> Field | None:
        """
        Long waves removed by the L filter (lengths), the waviness; ``None`` without an L filter.
        """
    @property
    def short_waves(self, /) -> Field | None:
        """
        Short waves removed by the S filter (lengths), such as noise; ``None`` without an S filter.
        """
    @property
    def valid_range(self, /) -> tuple[tuple[int, int], tuple[int, int]]:
        """
        Columns and rows that are not affected by an edge: those at least half a nesting index away from each edge, in the
        form that :func:`crop` accepts.
        """

@final
class FlatPunch:
    """
    The flat end of a rigid round cylinder pressed on a half-space.

    The gap is zero within the radius a, and there is no contact outside it. For two elastic bodies this is the
    solution of half-spaces with that gap. Johnson (1985), section 3.4 and 3.36-3.37.

    Parameters
    ----------
    pair : ElasticPair or two Materials
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
    def __new__(cls, /, pair: ElasticPair | tuple[Material, Material], *, radius: float, load: float) -> FlatPunch: ...
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
        Returns the normal displacement of the surfaces (a length), summed over the bodies and positive into each, at
        the distance r from the centre: the approach inside the contact, and outside it (2 delta / pi) arcsin(a/r).
        """
    def full_stick(self, /, friction: float, force: float) -> MindlinFullStick:
        """
        Returns the solution for the punch in full stick under a tangential force along x. Traction and pressure have
        the same distribution. The whole contact therefore sticks up to the force mu W and then slides. This is valid if
        pressure and traction are uncoupled: on a rigid punch, if Poisson's ratio is 1/2. Otherwise the edge of the
        contact slips under pressing alone (:class:`SpencePressing`).

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
        Returns the pressure W / (2 pi a sqrt(a^2 - r^2)) at the distance r from the centre. It grows without bound
        towards the edge; at the edge and outside, the function returns zero.
        """

@final
class Friction:
    """
    Coulomb friction with a uniform coefficient or one coefficient per cell, and with an optional cap: the friction limit
    of a cell is ``min(mu p, tau_max)``.

    Parameters
    ----------
    coefficient : float, Field or array_like of shape (ny, nx)
        Coefficient of friction mu (dimensionless), not negative.
    max_shear_stress : float, optional
        The shear strength tau_max of the weaker body (a pressure), positive; no limit by default.
    grid : Grid, optional
        Grid of the coefficients; required for an array, because only a Field has its own grid.

    Raises
    ------
    NegativeOrNotFinite, Sample, Shape, GridMismatch, NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, coefficient: Field | ArrayLike, *, max_shear_stress: float | None = None, grid: Grid | None = None) -> Friction: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def limit(self, /, index: int, pressure: float) -> float:
        """
        Returns the friction limit of a cell (row-major index) under a pressure, or NaN if the index is out of range.
        """
    @property
    def max_shear_stress(self, /) -> float | None:
        """
        The shear strength tau_max (a pressure), or ``None`` without a limit.
        """

@final
class Functional:
    """
    Number that depends on the solution of a contact; created by its static methods.

    A functional of tractions, slips or shifts needs the solver of a tangential or coupled contact. The approach needs the
    solver of a normal or coupled contact.

    Examples
    --------
    >>> from stickslip.sensitivity import Functional
    >>> Functional.tangential_force("x")
    Functional.tangential_force('x')
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @staticmethod
    def approach() -> Functional:
        """
        Returns the approach of the bodies.
        """
    @staticmethod
    def dissipated_energy() -> Functional:
        """
        Returns the energy dissipated by the step, computed from the tractions at its end (force times length).
        """
    @staticmethod
    def elastic_energy() -> Functional:
        """
        Returns the elastic energy (force times length): of the pressure in a normal contact, of the tractions in a
        tangential contact, and of both in a coupled contact.
        """
    @staticmethod
    def normal_force() -> Functional:
        """
        Returns the normal force.
        """
    @staticmethod
    def pressure_norm(exponent: float) -> Functional:
        """
        Returns the generalised mean of the pressure, weighted by the load: ``(sum(p**(k + 1)) / sum(p))**(1 / k)``.

        The mean tends to the largest pressure for a large exponent k. Cells that come into contact at pressure zero do not
        change it.

        Parameters
        ----------
        exponent : float
            The exponent k, at least 1.
        """
    @staticmethod
    def rms_pressure() -> Functional:
        """
        Returns the root mean square of the pressure, weighted by the load: ``pressure_norm(2.0)``.
        """
    @staticmethod
    def shift(axis: Axis | str) -> Functional:
        """
        Returns the shift along an axis.
        """
    @staticmethod
    def stick_force(axis: Axis | str) -> Functional:
        """
        Returns the part of the tangential force along an axis that the sticking cells carry.
        """
    @staticmethod
    def tangential_force(axis: Axis | str) -> Functional:
        """
        Returns the tangential force along an axis.
        """
    @staticmethod
    def weighted(*, pressure: Field | ArrayLike | None = None, traction: Sequence[Field | ArrayLike] | None = None, slip: Sequence[Field | ArrayLike] | None = None, approach: float = 0.0, shift: Sequence[float] | NDArray[Any] = (0.0, 0.0), grid: Grid | None = None) -> Functional:
        """
        Returns a weighted sum of the unknowns of all cells, of the approach and of the shifts.

        The result to be differentiated need not be linear: with its derivatives at the solution as weights, the sensitivity
        is the derivative of any smooth result.

        Parameters
        ----------
        pressure : Field or array_like of shape (ny, nx), optional
            Weights of the pressures; zero by default.
        traction, slip : pair of Field or array_like of shape (ny, nx), optional
            Weights of the tractions and the slips along x and y; zero by default.
        approach : float, default 0
            Weight of the approach.
        shift : pair of float, default (0, 0)
            Weights of the shifts along x and y.
        grid : Grid, optional
            Grid of the weights; required for arrays, because only Fields have their own grid.

        Raises
        ------
        Shape

        Examples
        --------
        >>> import numpy as np, stickslip
        >>> grid = stickslip.Grid.square(32, 8.0)
        >>> x, _ = np.meshgrid(grid.x, grid.y)
        >>> moment = stickslip.sensitivity.Functional.weighted(pressure=-x * grid.cell_area, grid=grid)
        """

@final
class Grid:
    """
    A rectangular grid of equal cells, centred on the origin.

    Parameters
    ----------
    nx, ny : int
        Number of cells along x and y, at least one.
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
        Equal grids have equal hashes.
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
        Edges of the grid ``(left, right, bottom, top)`` (lengths), in the order of ``extent`` of matplotlib's ``imshow``.
        """
    @staticmethod
    def line(n: int, dx: float) -> Grid:
        """
        Returns a line of ``n`` cells along x, each ``dx`` long and one unit of length wide. Forces are then per unit
        length. The argument ``dx`` is the side of a cell, and not of the grid as ``side`` of :meth:`square`.
        """
    @property
    def nx(self, /) -> int:
        """
        Number of cells along x.
        """
    @property
    def ny(self, /) -> int:
        """
        Number of cells along y.
        """
    @property
    def rows(self, /) -> slice:
        """
        Slice of the local rows in the :attr:`whole` grid: ``array[grid.rows]`` selects them from an array of the whole
        grid.
        """
    @property
    def shape(self, /) -> tuple[int, int]:
        """
        Shape of the arrays on the grid, (ny, nx).
        """
    @staticmethod
    def square(n: int, side: float) -> Grid:
        """
        Returns a grid of ``n`` x ``n`` square cells. The argument ``side`` (a length) is the side of the grid, not of a
        cell.
        """
    @property
    def whole(self, /) -> Grid:
        """
        The whole grid if this grid is a slab of its rows, created by :meth:`HalfSpace.distributed`; otherwise this grid.
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
class GridRecord:
    """
    Grid of a solve and the estimated errors after it.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __repr__(self, /) -> str: ...
    @property
    def centre(self, /) -> tuple[float, float]:
        """
        Centre of the grid in the coordinates of the gap, (x, y) (lengths).
        """
    @property
    def estimates(self, /) -> dict[str, float]:
        """
        Estimated errors of all quantities, by name; empty after the first solve of a part of the region.
        """
    @property
    def grid(self, /) -> Grid:
        """
        Grid of the solve.
        """

@final
class HalfSpace:
    """
    A pair of half-spaces on a grid. Its influence coefficients and buffers are created on first use and shared. Two pairs
    with equal grid, bodies, boundary and cell value are equal.

    Parameters
    ----------
    grid : Grid
        The cells that may come into contact.
    pair : ElasticPair, two Materials, or Kernel
        The two bodies; z points into the first.
    boundary : Boundary or str, default "non_periodic"
        Boundary condition at the edge of the grid: "non_periodic", "periodic" or ("periodic_along_y", datum).
    cell_value : CellValue or str, default "uniform"
        Meaning of the pressure and the traction of a cell: "uniform" over the cell, or the value at its "centre".

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
        Equal pairs have equal hashes.
        """
    def __new__(cls, /, grid: Grid, pair: ElasticPair | Kernel | tuple[Material, Material], boundary: Boundary | str | tuple[str, float] | None = None, cell_value: CellValue | str | None = None) -> HalfSpace: ...
    def __reduce__(self, /) -> tuple[type, tuple[Grid, ElasticPair, Boundary, CellValue]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def boundary(self, /) -> Boundary:
        """
        Boundary condition at the edge of the grid.
        """
    @property
    def cell_value(self, /) -> CellValue:
        """
        Meaning of the pressure and the traction of a cell.
        """
    @staticmethod
    def distributed(grid: Grid, pair: ElasticPair | Kernel | tuple[Material, Material], comm: Any, boundary: Boundary | str | tuple[str, float] | None = None, cell_value: CellValue | str | None = None) -> HalfSpace:
        """
        Distributes the rows of the bodies over the ranks of a communicator, which solve one contact together. All calls
        are collective: every rank creates the bodies and then makes the same calls in the same order. Grid and arrays are
        local, that is, restricted to the rows of the rank (:attr:`Grid.rows`). Results for the whole contact, such as
        forces, areas, reports and spots, are available on every rank. All results are bitwise identical to those of one
        process.

        Parameters
        ----------
        grid : Grid
            The whole grid.
        pair : ElasticPair, two Materials, or Kernel
            The two bodies; z points into the first.
        comm : mpi4py.MPI.Comm, or any object with three of its methods
            The methods are ``Get_rank()``, ``Get_size()`` and ``sendrecv(block, dest=, source=)``, which sends
            ``bytes`` to one rank and returns ``bytes`` from another. Messages may have any length and must arrive in
            the order of sending. The communicator must not receive other messages: pass a duplicate of a communicator
            that is also used elsewhere. The methods are called one at a time, possibly on threads of the package. An
            exception in a method is raised as :class:`~stickslip.errors.Ranks`, and the original exception is passed to
            `sys.unraisablehook`.
        boundary : Boundary or str, default "non_periodic"
            See the class.
        cell_value : CellValue or str, default "uniform"
            See the class.

        Raises
        ------
        NotPositive, Memory, BelowMinimum, UnsupportedForCoatings, IncompleteKernel, GridMismatch, Ranks

        Notes
        -----
        Ranks can be threads of one process; each rank then creates its bodies and solves on its own thread.

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
        The grid; for :meth:`distributed` bodies, the local rows.
        """
    def operator(self, /, component: Component | str) -> LinearOperator:
        """
        Returns the operator of one component on the whole grid, created at the first call. The component names the
        direction of the displacement first and that of the traction second.

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
        Returns the circulant preconditioner of one component; ``None`` for all components except xx, yy and zz.
        """
    def tensor_operator(self, /) -> TensorOperator:
        """
        Returns the operator of all three directions: displacements along x, y and z due to tractions along x, y and z.
        """

@final
class Hardness:
    """
    The largest pressure that the softer body can carry, for all cells or for each cell. Cells at this pressure yield.

    Parameters
    ----------
    limit : float, Field or array_like of shape (ny, nx)
        The largest pressure: one positive number, or one number per cell, not negative. A cell whose limit is zero
        carries no load.
    grid : Grid, optional
        Grid of the limits; required for an array, because only a Field has its own grid.

    Raises
    ------
    NotPositive, Sample, Shape, GridMismatch
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, limit: Field | ArrayLike, *, grid: Grid | None = None) -> Hardness: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def capacity(self, /, grid: Grid) -> float:
        """
        Returns the largest normal force that the cells of a grid can carry.
        """
    def of_cell(self, /, index: int) -> float:
        """
        Returns the largest pressure of a cell (row-major index), or NaN if the index is out of range.
        """
    def overlap(self, /, contact: NormalSolution) -> Field:
        """
        Returns the overlap of the surfaces of a solved contact in cells whose pressure is at the limit (lengths).
        """

@final
class HertzEllipse:
    """
    A paraboloid with two different curvatures pressed on a half-space.

    The gap is x^2 / 2R_x + y^2 / 2R_y. Johnson (1985), 4.26-4.32.

    Parameters
    ----------
    pair : ElasticPair or two Materials
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
    def __new__(cls, /, pair: ElasticPair | tuple[Material, Material], *, radius_x: float, radius_y: float, load: float) -> HertzEllipse: ...
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
        Returns the pressure p_0 sqrt(1 - x^2/a_x^2 - y^2/a_y^2), or zero outside the contact. Johnson (1985), 3.58.
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

    The gap is x^2 / 2R. The solution is exact for a parabola. Johnson (1985), 4.43-4.45.

    Parameters
    ----------
    pair : ElasticPair or two Materials
        The bodies.
    radius : float
        Radius R of the cylinder (a length), positive; for two cylinders 1/R = 1/R_1 + 1/R_2.
    load : float
        Normal load P (a force per length), positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair | tuple[Material, Material], *, radius: float, load: float) -> HertzLine: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def approach(self, /, datum: ArrayLike) -> Any:
        """
        Returns the approach of the bodies, P / (pi E*) (2 ln(2d/a) + 1) (a length), relative to the datum d (a
        length) of :meth:`Boundary.periodic_along_y`. The datum must be large compared with a; the approach is then
        positive. It is NaN if the datum is zero or negative.
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
        Returns the pressure p_0 sqrt(1 - x^2/a^2) at the distance x from the middle, or zero outside the contact.
        """
    @property
    def radius(self, /) -> float:
        """
        Radius R of the cylinder (a length).
        """
    def stress(self, /, x: ArrayLike, depth: ArrayLike) -> tuple[Any, Any, Any]:
        """
        Returns the stresses xx, zz and xz of body 1 at x and at a depth (a length, zero or more) below its surface
        (pressures, positive in tension). In body 2 at the same depth, xz has the opposite sign. M'Ewen (1949);
        Johnson (1985), 4.49.

        Raises
        ------
        ArgumentRange
            If a depth is negative.
        """
    def surface_stress(self, /, x: ArrayLike) -> Any:
        """
        Stress xx of the surface of either body at x (a pressure, positive in tension): minus the pressure in the
        contact, zero outside.
        """

@final
class HertzSphere:
    """
    A sphere or a paraboloid of revolution pressed on a half-space.

    The gap is r^2 / 2R. The solution is exact for a paraboloid; for a sphere it is valid if the contact is small
    compared with R. Johnson (1985), 4.22-4.24.

    Parameters
    ----------
    pair : ElasticPair or two Materials
        The bodies.
    radius : float
        Radius R of the sphere (a length), positive; for two spheres 1/R = 1/R_1 + 1/R_2.
    load : float
        Normal load W (a force), positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair | tuple[Material, Material], *, radius: float, load: float) -> HertzSphere: ...
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
        Returns the normal displacement u_z of the surfaces (a length), summed over the bodies and positive into each,
        at the distance r from the centre, inside and outside the contact. Johnson (1985), 3.41a and 3.42a.
        """
    def gap(self, /, r: ArrayLike) -> Any:
        """
        Returns the gap u_z + r^2 / 2R - delta between the surfaces (a length) at the distance r from the centre; zero
        in the contact, positive outside.
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
        Returns the pressure p_0 sqrt(1 - r^2/a^2) at the distance r from the centre, or zero outside the contact.
        Johnson (1985), 3.39.
        """
    @property
    def radius(self, /) -> float:
        """
        Radius R of the sphere (a length).
        """

@final
class History:
    """
    Two bodies in contact with memory of their load: pressure, traction, slip and energy, step by step.

    The arrays are copies, because the next step changes the data; :meth:`state` is a snapshot whose arrays are views.
    One thread at a time may use a history. A step that fails, or that is interrupted by Ctrl-C, leaves the history
    unchanged.

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
        "scalar" computes the traction along the axis; "vector" computes both components and supports loads of any
        direction and twist. Give "vector" with the coupling "one_way": "scalar" omits the tractions across the axis, and the
        stick radius of a pressed ball is then too large, several times for a small friction coefficient.
    coupling : Coupling or str, default "full"
        Coupling for bodies of different materials: "full" solves pressure and traction simultaneously; "one_way" includes
        the tangential displacements due to pressure only; "neglected" omits both.
    entry_rule : EntryRule or str, default "since_touch"
        Part of the motion of a step that a cell follows if it comes into contact within the step: "since_touch" for the
        motion since first touch, "whole_step" for the whole motion.
    relative_displacement : RelativeDisplacement, optional
        The pattern of a displacement that is not caused by the contact. Steps prescribe its factor; none by default.
    hardness : Hardness, float or array_like of shape (ny, nx), optional
        The largest pressure that the cells can carry; no limit by default.
    permanent_set : bool, default False
        Whether the yielded depth remains and is added to the gap of later steps; requires ``hardness``.
    settings : Settings, optional
        Method, tolerance and limits; ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        See :class:`Settings`; these arguments take precedence over ``settings``.

    Raises
    ------
    GridMismatch, Shape, Sample, UnsupportedByModel, Method, Tolerance, IterationLimit
    ValueError
        If ``permanent_set`` is true without ``hardness``, or if the units of gap and relative displacement differ.

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
        Length of the path that each cell slipped since the start (lengths, not negative), a read-only copy.
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
        The two bodies and the grid.
        """
    @property
    def boundary(self, /) -> Boundary:
        """
        Boundary condition at the edge of the grid.
        """
    @property
    def contact(self, /) -> NDArray[bool_]:
        """
        Mask of the cells in contact, booleans of shape (ny, nx): cells with positive pressure. A read-only copy.
        """
    def displacement(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Computes the displacement of body 1 relative to body 2 due to the tractions along x and y (lengths). The cost is
        one product.
        """
    @property
    def accumulated_dissipation(self, /) -> NDArray[float64]:
        """
        Energy that each cell dissipated in the steps since the start (not negative), a read-only copy that contains its grid.
        Cycles that :func:`stickslip.wear.run` jumps over are not steps. The result of the run contains their energy.
        """
    def edges(self, /) -> TangentialEdges:
        """
        Returns the edges of the contact and of the stick zone inside the cells after the last step.

        Raises
        ------
        OutdatedSolution
            If the friction has changed since the last step.
        """
    @property
    def friction(self, /) -> Friction:
        """
        The friction of later steps.
        """
    @property
    def friction_capacity(self, /) -> float:
        """
        Largest tangential force that friction can carry.
        """
    @staticmethod
    def from_bytes(bodies: HalfSpace, bytes: bytes | bytearray | memoryview) -> History:
        """
        Restores a history from its bytes, on the same bodies. Continued steps give bitwise identical results on processors with
        the same vector instructions.
        """
    @staticmethod
    def from_state(bodies: HalfSpace, state: State) -> History:
        """
        Creates a history that continues from a state, on the bodies of that state.
        """
    @property
    def unit(self, /) -> str | None:
        """
        Unit of the lengths of the gap, if one of the gaps or relative displacements stated it. Later ones must have the same unit or
        none. A history that was restored from bytes, a file or a pickle has no unit; a state in memory keeps it.
        """
    @property
    def unloaded_gap(self, /) -> NDArray[float64]:
        """
        The gap before loading (lengths), as last set, plus the yielded depth; a read-only copy.
        """
    @property
    def gap_as_set(self, /) -> NDArray[float64]:
        """
        The gap before loading (lengths), as last set, without the yielded depth; a read-only copy. Pass a
        changed array to :meth:`set_gap`, as in ``history.set_gap(history.gap_as_set + depth)``. The yielded depth in :attr:`unloaded_gap`
        would count twice.
        """
    @property
    def grid(self, /) -> Grid:
        """
        The grid.
        """
    @property
    def last_step(self, /) -> StepResult:
        """
        Result of the last step, which led to the present state. Raises ``NoLastStep`` before the first step, after
        :meth:`set_state`, and after a restart.
        """
    @staticmethod
    def load(bodies: HalfSpace, path: str | PathLike[str]) -> History:
        """
        Loads a history from a file written by :meth:`save`, on the same bodies.
        """
    @property
    def moment(self, /) -> float:
        """
        Moment about z, at the origin of the grid, on body 1 (a force times a length, positive from x to y).
        """
    @property
    def normal(self, /) -> NormalSolution:
        """
        The normal solution, a copy.
        """
    def press(self, /, load: LoadStep | None = None, *, tolerance: float, normal_force: float | None = None, approach: float | None = None, cycle: Cycle | None = None, progress: Any | None = None, warn: bool = True) -> int:
        """
        Applies a load in steps with equal growth of the contact, as many as a tolerance requires. Press a contact of
        dissimilar bodies in this way or in several steps, because the stick and slip zones depend on the growth of the
        contact. A single step issues a warning. A history with the coupling "one_way" needs the model "vector", because the scalar
        model omits the tractions across its axis. Its stick radius is too large, several times for a small friction
        coefficient.

        The load is applied in 1, 2, 4, 8, ... steps from the present state, until the tractions differ from the tractions
        for half the number of steps by no more than the tolerance. A call that fails, or that is interrupted by Ctrl-C,
        leaves the state unchanged. The history then has no last step until its next step.

        :attr:`last_step` is the last of these steps, with its slip and energy alone. For the wear of the load, give
        ``cycle``, or take the increase of :attr:`accumulated_dissipation`.

        Parameters
        ----------
        load : LoadStep, optional
            The load as an object, instead of by keywords. All prescribed quantities change proportionally from their
            previous values.
        tolerance : float
            Largest sum of the magnitudes of the traction differences, relative to the sum of the friction limits, in (0,
            1). A value of 0.01 is a good choice. The value must be at least about a hundred times the tolerance of the
            settings.
        normal_force, approach : optional
            See :class:`LoadStep`.
        cycle : Cycle, optional
            A cycle to which each of these steps is added. It must start or end in the present state. The steps are taken a
            second time for this purpose, with identical results. After an exception, restart the cycle by :meth:`Cycle.begin`.
        progress : callable or bool, optional
            See :meth:`NormalProblem.solve`.
        warn : bool, default True
            Whether the warnings of the last step are also issued through ``warnings``.

        Returns
        -------
        int
            The number of steps.

        Raises
        ------
        Tolerance, StepTooLong
            In addition to the exceptions of :meth:`step`.
        StepOutOfOrder
            If the cycle does not start or end in the present state of this history.
        """
    @property
    def pressure(self, /) -> NDArray[float64]:
        """
        Pressure, not negative; exactly zero outside the contact. A read-only copy.
        """
    def save(self, /, path: str | PathLike[str]) -> None:
        """
        Saves the state to a file. An existing file is replaced completely or not at all.
        """
    def sensitivities(self, /, load: LoadStep, functionals: Sequence[Functional], *, tolerance: float | None = None) -> list[Sensitivity]:
        """
        Computes the sensitivities of several functionals of the last step, in their order. The options and the exceptions
        are those of :meth:`sensitivity`.
        """
    def sensitivity(self, /, load: LoadStep, functional: Functional, *, tolerance: float | None = None) -> Sensitivity:
        """
        Computes the derivatives of a functional of the last step with respect to the input of this step: its load, its
        friction and its gap.

        The state before the step is fixed. It includes the offsets of the cells, and the gaps that cells close when they come
        into contact. A program that differentiates several steps adds the effects of earlier steps itself. The elastic energy
        is the energy of shear.

        Parameters
        ----------
        load : LoadStep
            The load of the last step.
        functional : Functional
            The functional; see :class:`stickslip.sensitivity.Functional`.
        tolerance : float, optional
            Relative residual at which a linear problem counts as solved; 1e-11 by default.

        Returns
        -------
        Sensitivity

        Raises
        ------
        EmptyContact
            If the bodies do not touch.
        UnsupportedByModel
            For a step that rolls, for full coupling of dissimilar bodies, or if the history has not taken the step itself.
        BelowMinimum, GridMismatch, NotConverged, NotFinite, NotPositive, Sample, Tolerance
            See :meth:`TangentialSolver.sensitivity`.

        Examples
        --------
        >>> import stickslip as ss
        >>> grid = ss.Grid.square(32, 0.3e-3)
        >>> steel = ss.Material(213e9, 0.29)
        >>> history = ss.History(ss.HalfSpace(grid, (steel, steel)), ss.surface.sphere(grid, 3.5e-3), 0.5)
        >>> done = history.step(normal_force=100.0)
        >>> drag = ss.LoadStep(force_x=30.0)
        >>> done = history.step(drag)
        >>> found = history.sensitivity(drag, ss.sensitivity.Functional.shift("x"))
        >>> found.tangential_load[0] > 0.0 > found.friction_coefficient
        True
        """
    def set_friction(self, /, friction: Friction | float | ArrayLike) -> None:
        """
        Sets the friction of later steps. A law or a coefficient replaces the last law, with its ``max_shear_stress``. A coefficient
        alone has none; a warning is issued if the last law had one. :meth:`stiffness` and :meth:`edges` raise
        ``OutdatedSolution`` until the next step.
        """
    def set_gap(self, /, gap: Field | ArrayLike) -> None:
        """
        Sets the gap of later steps (lengths), for example after wear.

        The gap is given without the yielded depth, which the history adds. To change the present gap, start from
        :attr:`gap_as_set`. With a permanent set, a gap that already contains the yielded depth is rejected.

        Raises
        ------
        GridMismatch, Shape, Sample
        UnsupportedByModel
            If the history has a permanent set of ten cells or more and the gap already contains it.
        GapUnderLoad
            If the gap is the gap under load of the present contact.
        ValueError
            If the unit of the gap differs from :attr:`unit`; the gap is then unchanged.

        Examples
        --------
        >>> import stickslip
        >>> grid = stickslip.Grid.square(32, 0.3e-3)
        >>> steel = stickslip.Material(213e9, 0.29)
        >>> history = stickslip.History(stickslip.HalfSpace(grid, (steel, steel)), stickslip.surface.sphere(grid, 3.5e-3), 0.5)
        >>> step = history.step(normal_force=100.0)
        >>> step = history.step(normal_force=100.0, force_x=30.0)
        >>> depth = stickslip.wear.energy(1e-13, step.dissipation, grid=grid)
        >>> history.set_gap(history.gap_as_set + depth)
        >>> step = history.step(normal_force=100.0)
        """
    def set_relative_displacement(self, /, pattern: RelativeDisplacement) -> None:
        """
        Sets the pattern of the relative displacement.

        Raises
        ------
        GridMismatch
        ValueError
            If the unit of the pattern differs from :attr:`unit`.
        """
    def set_state(self, /, state: State) -> None:
        """
        Restores a state of this history or of a history on equal bodies. Gap, friction, hardness, permanent set, settings
        and model (scalar, vector or coupled) of the state replace those of the history. Changes made after the state was taken, as
        by :meth:`set_friction` or :meth:`set_gap`, are therefore lost. Make them again after this call.

        The history then has no :attr:`last_step` until its next step. Until then, :meth:`Cycle.add` raises ``NoLastStep``. In a
        retry, restore the state, take a smaller step, and add this step to the cycle. A rejected step that was added stays in
        the cycle: add a step only after it is accepted.

        Raises
        ------
        MaterialMismatch, GridMismatch, BoundaryMismatch
        ValueError
            If the unit of the state differs from :attr:`unit`.
        """
    @property
    def settings(self, /) -> Settings:
        """
        Method, tolerance and limits of later steps; assignable.
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
        Slip since the start along x and y (lengths), read-only copies.
        """
    @property
    def spots(self, /) -> ContactSpots:
        """
        The contact spots, with their stick ratios. With distributed bodies, the call is collective.
        """
    def state(self, /) -> State:
        """
        Returns a snapshot of the state.
        """
    def step(self, /, load: LoadStep | None = None, *, normal_force: float | None = None, approach: float | None = None, force: Sequence[float] | NDArray[Any] | None = None, shift: Sequence[float] | NDArray[Any] | None = None, spring: Spring | None = None, force_x: float | None = None, force_y: float | None = None, shift_x: float | None = None, shift_y: float | None = None, spring_x: Spring | None = None, spring_y: Spring | None = None, twist: float | None = None, relative_displacement: float | None = None, roll: Rolling | None = None, progress: Any | None = None, warn: bool = True) -> StepResult:
        """
        Takes a step, given as a :class:`LoadStep` or by its keywords. A quantity without a keyword is held: the
        pressure, the shift, the twist and the relative displacement. A step without arguments holds all of them, for example
        after a change of friction. Any history can be pressed by a step. For dissimilar
        bodies, whose stick zone depends on the growth of the contact, :meth:`press` is more accurate than a single step.

        A step without a tangential load holds the shift, not the tangential force. The force decreases if a lower
        pressure or less friction cannot carry it. To keep the force constant, prescribe it in each step.

        Parameters
        ----------
        load : LoadStep, optional
            The step as an object, instead of by keywords.
        normal_force, approach, force, shift, spring, force_x, ..., roll : optional
            See :class:`LoadStep`.
        progress : callable or bool, optional
            See :meth:`NormalProblem.solve`.
        warn : bool, default True
            Whether the warnings of the step are also issued through ``warnings``, each kind once per location.

        Returns
        -------
        StepResult
            The result, whose fields are available until the next step; see :meth:`StepResult.keep`.

        Raises
        ------
        NotFinite, NegativeOrNotFinite, NotPositive, ApproachBeyondMeanGap, UnsupportedByModel, BeyondFrictionCapacity, EmptyContact,
        GridTooShort, NotConverged
        """
    @staticmethod
    def step_all(histories: Sequence[History], loads: Sequence[LoadStep], *, return_exceptions: bool = False, warn: bool = True) -> list[tuple[int, Any]]:
        """
        Takes one step of each of several histories in parallel. A history whose step fails is unchanged, and the others take
        their steps.

        Parameters
        ----------
        histories : sequence of History
            The histories, each listed once.
        loads : sequence of LoadStep
            One load per history.
        return_exceptions : bool, default False
            Whether the errors of failed steps are returned instead of raised.
        warn : bool, default True
            Whether the warnings of the steps are also issued through ``warnings``, each kind once per location.

        Returns
        -------
        list of (int, StickslipError)
            Indices and errors of the histories whose step failed; empty unless ``return_exceptions`` is true.

        Raises
        ------
        ArgumentType, Length
        ValueError
            If a history is listed twice.
        StickslipError
            If steps failed, after all steps: the error of the first failed history. Its message contains the index of this history
            and the number of failed steps, and its attribute ``failures`` is the list of all indices and errors.
        """
    @property
    def steps(self, /) -> int:
        """
        Number of steps since the start.
        """
    def stiffness(self, /, *, next_step: bool = False) -> ContactStiffness:
        """
        Returns the derivatives of the forces and the moment with respect to approach, shift and twist.

        Parameters
        ----------
        next_step : bool, default False
            If true, ``tangential.loading`` and ``by_approach`` are derivatives of the next step, which starts from the
            present state. Otherwise they are derivatives of the last step. In the next step, all stick cells resist
            fully, including cells that came into contact in the last step, and cells at their limit continue to slip. A
            simulation that continues to shear the contact under the same normal load needs these derivatives.

        Raises
        ------
        OutdatedSolution
            If the friction limits, the gap or the relative displacement have changed since the last step. Take a step first,
            with a normal load after a change of the gap.
        NotConverged
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Ratio of stick cells to contact cells after the last step, zero without contact.
        """
    @property
    def tangential_force(self, /) -> tuple[float, float]:
        """
        Tangential force that body 2 exerts on body 1 along x and y.
        """
    def to_bytes(self, /) -> bytes:
        """
        Returns the state as bytes, with all data that the next step needs except the bodies.
        """
    @property
    def traction(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Shear traction on body 1 along x and y (pressures), read-only copies.
        """
    @property
    def twist(self, /) -> float:
        """
        Rotation of body 2 relative to body 1 since the start (radians, positive from x to y).
        """
    @property
    def zones(self, /) -> NDArray[uint8]:
        """
        Zone of each cell: 0 separated, 1 stick, 2 slip. A read-only copy.

        The array also compares equal to the names of the zones; see :attr:`TangentialSolution.zones`.
        """

@final
class Iteration:
    """
    One step of an iteration, as passed to a progress callback.

    The residual and the number of free entries are the most recently measured values.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def double_precision_products(self, /) -> int:
        """
        Number of products with the operator in double precision so far.
        """
    @property
    def free(self, /) -> int:
        """
        Number of entries strictly between their bounds: contact cells, or cells that stick.
        """
    @property
    def iteration(self, /) -> int:
        """
        Number of conjugate-gradient steps so far.
        """
    @property
    def residual(self, /) -> float:
        """
        Largest complementarity residual, relative to the largest displacement.
        """
    @property
    def single_precision_products(self, /) -> int:
        """
        Number of products in single precision so far.
        """

@final
class JaegerSuperposition:
    """
    Jaeger's superposition: the traction of a contact under one force as the difference of two pressures.

    Parameters
    ----------
    full, stick : NormalSolution
        The contact under its load W, and the contact of the same bodies under the load W - F / mu for a tangential
        force F. The contact area under the second load is the stick zone.
    pair : ElasticPair or two Materials
        The bodies. The coupling between pressure and traction of different materials is neglected.
    friction : float
        Coefficient of friction mu (dimensionless), not negative.

    Raises
    ------
    NegativeOrNotFinite, GridMismatch, BoundaryMismatch, MaterialMismatch, NotConverged, EmptyContact,
    OutdatedSolution
    """
    def __new__(cls, /, full: NormalSolution, stick: NormalSolution, pair: ElasticPair | tuple[Material, Material], friction: float) -> JaegerSuperposition: ...
    def __repr__(self, /) -> str: ...
    @property
    def force(self, /) -> float:
        """
        The tangential force, mu times the difference of the two loads.
        """
    @property
    def grid(self, /) -> Grid:
        """
        Grid of the traction.
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
        Zone of each cell; see :attr:`TangentialSolution.zones`.
        """

@final
class KalkerCoefficients:
    """
    Kalker's creepage and spin coefficients, which give the forces of an elliptic contact that rolls along x. The
    creepages are so small that the contact sticks everywhere except at its trailing edge.

    With the semi-axes a along x and b along y, c = sqrt(a b), and the shear modulus G of two equal bodies, creepages
    xi along x and eta along y and the spin phi cause on body 1 F_x = G c^2 C11 xi, F_y = G c^2 (C22 eta + c C23 phi)
    and M = G c^3 (C32 eta + c C33 phi). The values were computed with this package and are accurate to about 0.1 %
    (C33 to 0.3 %). Kalker (1990), table E.3.

    Parameters
    ----------
    ratio : float
        a/b, from 1/16 to 16.
    poisson_ratio : float
        Poisson's ratio of both bodies, from 0 to 1/2. For different bodies with zero Dundurs' beta, it is the ratio
        of the single body with the same compliance, and G is twice the modulus of that body.

    Raises
    ------
    NotPositive, BelowMinimum, PoissonRatio
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, ratio: float, *, poisson_ratio: float) -> KalkerCoefficients: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def c11(self, /) -> float:
        """
        Coefficient of the force along x due to the creepage along x.
        """
    @property
    def c22(self, /) -> float:
        """
        Coefficient of the force along y due to the creepage along y.
        """
    @property
    def c23(self, /) -> float:
        """
        Coefficient of the force along y due to the spin.
        """
    @property
    def c32(self, /) -> float:
        """
        Coefficient of the moment due to the creepage along y, -C23.
        """
    @property
    def c33(self, /) -> float:
        """
        Coefficient of the moment due to the spin.
        """

@final
class Kernel:
    """
    Two bodies with a user-defined response, in place of the material pair of a :class:`HalfSpace`. A kernel is created by
    :meth:`isotropic`, :meth:`tabulated` or :meth:`operators`. Kernels cannot be pickled, nor can bodies that use them.

    Examples
    --------
    >>> import stickslip as ss
    >>> rigid, steel = ss.Material.rigid(), ss.Material(210e9, 0.3)
    >>> coated = ss.ElasticPair(steel.coated([ss.layers.Layer(400e9, 0.25, thickness=2e-6)]), rigid)
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
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __repr__(self, /) -> str: ...
    @staticmethod
    def isotropic(near: ElasticPair, thickness: float, response: Any) -> Kernel:
        """
        Creates bodies whose response is isotropic in the plane of the surface.

        Parameters
        ----------
        near : ElasticPair
            The homogeneous half-spaces that give the response to waves much shorter than the thickness. Their response
            must agree with ``response`` to 1e-10 for k > 20 / thickness. Hardness and moduli are taken from this pair.
            Grids that are periodic along both axes use ``response`` unchanged.
        thickness : float
            Thickness of the outermost layer (a length), positive.
        response : callable
            A function of the wave number k > 0 (one over a length, a float). It returns the displacements under waves of
            traction of that wave number (lengths over pressures, not multiplied by k): normal due to pressure, along and
            across the wave due to traction, and the coupling. It is called many times, under the GIL, on many threads. If
            the function raises an exception, its value counts as NaN, which is rejected, and the exception is passed to
            `sys.unraisablehook`; Ctrl-C there interrupts the main thread.

        Raises
        ------
        NotPositive, NotFinite, UnsupportedForCoatings
        """
    @staticmethod
    def operators(near: ElasticPair, grid: Grid, operators: dict[str, Any], *, lower_bounds: dict[str, Any] | None = None) -> Kernel:
        """
        Creates bodies from operators on the cells of a grid, which compute displacements from tractions, for any
        boundary.

        A contact is solved on all cells of the grid, without a window or coarser grids. A problem uses the operator with
        the fewest directions among those that have all required directions. Normal problems require "z"; tangential
        problems require "x", "y" or both. If ``near`` is coupled, all three directions are solved simultaneously.
        Rolling, ranks, dense matrices, edges inside the cells and stresses are not available for such bodies.

        Parameters
        ----------
        near : ElasticPair
            Homogeneous half-spaces that approximate the bodies for wavelengths of a few cells. Their inverse
            preconditions the solves: a better approximation gives faster convergence to the same solution. The pair also
            provides hardness and moduli, and determines whether pressure and traction are coupled.
        grid : Grid
            The cells.
        operators : dict
            Callables or :class:`~stickslip.cgm.LinearOperator` objects, symmetric and positive, by the directions that
            they couple, such as "z", "xy" or "xyz". A callable receives an array of tractions of shape (directions, ny,
            nx), where the z direction is the pressure. It returns the displacements of body 1 relative to body 2 in the
            same shape and order (lengths). A LinearOperator has the same number of unknowns;
            :class:`~stickslip.dense.DenseOperator` accepts the compliance matrix of a finite-element code. On a grid that
            is periodic along both axes, uniform tractions must cause no displacement. An operator is rejected as not
            symmetric if the work of each of two test fields on the displacements of the other differs by more than 1e-9 of
            the energies. The mean of a matrix and its transpose, ``(matrix + matrix.T) / 2``, is symmetric to round-off.
        lower_bounds : dict, optional
            Lower bounds on the smallest eigenvalues of the callables, by name; 0 by default. Errors are certified with
            these bounds. Without a bound, coupled contacts cannot be solved and the stiffness is not available. A
            LinearOperator provides its own bound.

        Raises
        ------
        UnsupportedForCoatings, IncompleteKernel, RepeatedDirection, NotPositive, NotFinite, UnsupportedByModel, BelowMinimum, Memory

        Notes
        -----
        A callable runs under the GIL, for a large grid on a thread of the package. An exception in it ends the solve,
        which raises the exception again; solvers and histories remain unchanged.

        Examples
        --------
        A bed of springs, in which each cell deforms by 0.5 under unit pressure:

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
        The pair from which hardness and moduli are taken, marked as the pair of this kernel.
        """
    @staticmethod
    def tabulated(near: ElasticPair, sides: Sequence[float] | NDArray[Any], coefficients: dict[str, Any]) -> Kernel:
        """
        Creates bodies from their influence coefficients, for non-periodic grids.

        Parameters
        ----------
        near : ElasticPair
            Homogeneous bodies from which hardness and moduli are taken.
        sides : (float, float)
            Sides of a cell along x and y (lengths), equal to those of the grids.
        coefficients : dict
            Arrays of shape (ny, nx) by the name of a component, such as "zz". An entry is the displacement at the centre
            of a cell that is j cells further along y and i cells further along x than a cell with unit traction (lengths
            over pressures). The displacements at distances of the other sign follow from the parity. The components "xy",
            "zx" and "zy" are zero by default; "yx", "xz" and "yz" follow from them.

        Raises
        ------
        NotPositive, Length, Sample, UnsupportedForCoatings
        """

@final
class Layer:
    """
    An elastic, isotropic layer bonded to the layer or body below it.

    Parameters
    ----------
    youngs_modulus : float
        Young's modulus (a pressure), positive.
    poisson_ratio : float
        Poisson's ratio, in (-1, 0.5].
    thickness : float
        Thickness (a length), positive, in the same unit as the sides of the grid and the gap. Numbers have no unit: on a grid
        in millimetres, a coating of 5 micrometres has the thickness 5e-3. It is given by keyword only, because a thickness
        exchanged with Poisson's ratio would be another valid layer.

    Raises
    ------
    NotPositive, PoissonRatio

    Examples
    --------
    >>> import stickslip as ss
    >>> oxide = ss.layers.Layer(380e9, 0.22, thickness=5e-6)
    >>> anodised = ss.Material(70e9, 0.33).coated([oxide])
    >>> anodised.layers[0].thickness
    5e-06
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __hash__(self, /) -> int:
        """
        Equal layers have equal hashes.
        """
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, youngs_modulus: float, poisson_ratio: float, *, thickness: float) -> Layer: ...
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
    def __array__(self, /, dtype: Any | None = None, copy: bool | None = None) -> Any: ...
    def __array_function__(self, /, function: Any, _types: Any, arguments: Any, options: dict[str, Any]) -> Any:
        """
        Implements other NumPy functions of the heights, in the same way.
        """
    def __array_ufunc__(self, /, ufunc: Any, method: str, *inputs: Any, **kwargs: Any) -> Any:
        """
        Implements NumPy functions of the heights. Operands of different units are rejected.
        """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def form(self, /) -> Field:
        """
        The removed form (lengths).
        """
    @property
    def heights(self, /) -> Field:
        """
        The remaining heights (lengths).
        """

@disjoint_base
class LinearOperator:
    """
    A linear operator from tractions to displacements, with one number per cell.

    It is created by :meth:`HalfSpace.operator`, :meth:`HalfSpace.preconditioner`, :class:`stickslip.fft.Convolution`,
    :class:`stickslip.dense.DenseOperator` or :func:`stickslip.cgm.identity`.
    """
    def __call__(self, /, x: Any) -> NDArray[float64]: ...
    def __repr__(self, /) -> str: ...
    def apply(self, /, x: Any, out: Any | None = None) -> NDArray[float64]:
        """
        Applies the operator to an array with one number per cell, which is read in place.

        Parameters
        ----------
        x : array_like
            Tractions (pressures), one number per cell. The axes of an array of xarray are brought into the order (y, x).
        out : ndarray, optional
            Output array, C-contiguous, of type float64, not overlapping ``x``.

        Returns
        -------
        ndarray of the shape of ``x``
            Displacements (lengths).
        """
    @property
    def cells(self, /) -> int:
        """
        Number of unknowns.
        """
    @property
    def eigenvalue_bound(self, /) -> EigenvalueBound:
        """
        Origin of the lower bound: "proven", "stated" (by a user-defined operator), "estimated" (stiff coatings on long
        grids), or "unknown", in which case the bound is zero.
        """
    @property
    def lower_bound(self, /) -> float:
        """
        Lower bound on the smallest eigenvalue.
        """

@final
class LoadPath:
    """
    A cycle of a tangential load in the plane, given by the values (x, y) at the ends of its steps. The caller uses these
    values as forces or as shifts. A path is a sequence of pairs.

    Parameters
    ----------
    steps : sequence of pairs of float, or array_like of shape (n, 2)
        The values (x, y) at the ends of the steps (forces or lengths). The columns of a table of pandas are recognised by the
        names x and y.

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
        Returns the values of the given number of consecutive cycles.
        """
    @staticmethod
    def ellipse(amplitudes: Sequence[float] | NDArray[Any], phase: float, steps: int) -> LoadPath:
        """
        Returns a path around an ellipse with the amplitudes (A_x, A_y): A_x sin(2 pi t) along x and A_y sin(2 pi t +
        phase) along y, with the phase in radians. The number of steps must be a multiple of four. Each amplitude is half of
        the stroke along its axis (zero to peak).
        """
    @property
    def end(self, /) -> tuple[float, float]:
        """
        Value at the end of a cycle, where the next cycle starts.
        """
    @staticmethod
    def sine(amplitude: Sequence[float] | NDArray[Any], steps: int) -> LoadPath:
        """
        Returns a sinusoidal path along a line: the amplitude (x, y) times sin(2 pi t). The path goes from zero to the
        amplitude, to its negative, and back to zero. The number of steps must be a multiple of four. A path along x has
        the amplitude (a, 0). The amplitude is half of the stroke (zero to peak).
        """
    @property
    def steps(self, /) -> NDArray[float64]:
        """
        Values of one cycle, of shape (steps, 2).
        """
    @staticmethod
    def triangle(amplitude: Sequence[float] | NDArray[Any], steps: int) -> LoadPath:
        """
        Returns a path back and forth along a line at a constant rate. The number of steps must be a multiple of four. The
        amplitude is half of the stroke (zero to peak).
        """

@final
class LoadStep:
    """
    Load prescribed at the end of a step of a history. A quantity without a keyword is held: the pressure, the
    shift, the twist and the relative displacement.

    A held shift does not hold the tangential force, which decreases if a lower pressure or less friction cannot
    carry it. If pressure and traction are solved simultaneously, a step without a normal load holds the normal
    force instead of the pressure. After a change of the gap, prescribe the normal load again in every step;
    otherwise the pressure of the old gap is held.

    Parameters
    ----------
    normal_force, approach : float, optional
        The normal force (not negative) or the approach of the bodies from the datum of the gap (a length, positive
        when they move together). At most one of the two may be given; without either, the pressure is held.
    force, shift : pair of float, optional
        Components along x and y, of either sign, as totals since the start of the history: the force that body 2
        exerts on body 1, or the shift (lengths). The shift is the rigid motion of body 2 relative to body 1 far
        from the contact, the relative rigid tangential displacement.
    spring : Spring, optional
        Springs along both axes that drag body 2: ``Spring(position=(x, y), stiffness=...)``, with the position of their far
        ends (lengths since the start of the history) and their stiffness (a force over a length, positive). The force is
        stiffness (position - shift). A later step without a spring holds the shift, not the far end.
    force_x, force_y, shift_x, shift_y : float, optional
        Force or shift along one axis.
    spring_x, spring_y : Spring, optional
        Spring along one axis: ``Spring(position=..., stiffness=...)``, with a length and a force over a length.
    twist : float, optional
        Rotation of body 2 relative to body 1 since the start (radians, positive from x to y). Only the vector model
        supports a twist.
    relative_displacement : float, optional
        Factor by which the pattern of the relative displacement of the history is multiplied; held by default.
    roll : stickslip.history.Rolling, optional
        Rolling during the step: the memory of the particles moves through the contact while body 2 creeps over body 1.
        Along an axis with a prescribed force, the creepage follows from the force. A shift, a spring or a twist is not
        allowed in such a step. Normal load, gap and friction may change in the same step.

    Examples
    --------
    >>> import stickslip
    >>> press = stickslip.LoadStep(normal_force=100.0)
    >>> drag = stickslip.LoadStep(shift_x=1e-6)
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, *, normal_force: float | None = None, approach: float | None = None, force: Sequence[float] | NDArray[Any] | None = None, shift: Sequence[float] | NDArray[Any] | None = None, spring: Spring | None = None, force_x: float | None = None, force_y: float | None = None, shift_x: float | None = None, shift_y: float | None = None, spring_x: Spring | None = None, spring_y: Spring | None = None, twist: float | None = None, relative_displacement: float | None = None, roll: Rolling | None = None) -> LoadStep: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @staticmethod
    def of(load: TangentialLoad) -> LoadStep:
        """
        Returns a step with the tangential load and its twist only; the pressure is held.
        """

@final
class LoopPoint:
    """
    Point of the force-shift loop.
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
    The force-shift loop of a cycle, from its start to the end of each step: a sequence of :class:`LoopPoint`, and arrays
    with one number per point. Vectors are (x, y).
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
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns arrays by name, with one entry per element; a vector becomes one array per component with the endings
        ``_x``, ``_y`` and ``_z``, and stresses have endings such as ``_xx``.
        """
    def to_frame(self, /) -> Any:
        """
        Returns the arrays of :meth:`to_dict` as columns of a :class:`pandas.DataFrame` (requires pandas).
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
        The theory assumes small rotations. A twist in degrees is not detected, and gives almost the moment of sliding.

    Raises
    ------
    NotPositive, NotFinite
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, hertz: HertzSphere, *, friction: float, twist: float) -> LubkinTorsion: ...
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
        Moment about the normal on body 1 (a force times a length), with the sign of the twist; (16/3) G a^3 beta
        for small twists.
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
        Radius c of the stick disc (a length), positive, from beta = (mu p_0 / 2G) (K - E) with the complete elliptic
        integrals of the parameter 1 - c^2/a^2.
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Fraction of the contact area that sticks, c^2/a^2.
        """
    def traction(self, /, r: ArrayLike) -> Any:
        """
        Returns the traction q on body 1 (a pressure, with the sign of the twist) at the distance r from the centre,
        along the circle of that radius from x to y: q_x = -q y/r, q_y = q x/r. The traction is zero outside the
        contact.
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
        The hardness (a pressure), positive; none by default. It is used only for a warning if the pressure of a
        solution exceeds it. To limit the pressure, pass ``hardness`` to the problem.

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
        Equal materials have equal hashes.
        """
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, youngs_modulus: float, poisson_ratio: float, *, hardness: float | None = None) -> Material: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def coated(self, /, layers: Sequence[Layer]) -> Material:
        """
        Returns this body with layers bonded on top of it and of its existing layers, outermost first. On a rigid body,
        the layers are elastic layers on a rigid base. The moduli of a coated body are the moduli of the body below the
        layers. A hardness that was set earlier is kept.

        Parameters
        ----------
        layers : sequence of Layer
            The layers; at most eight in total.

        Raises
        ------
        TooManyLayers
        """
    @staticmethod
    def from_shear_modulus(shear_modulus: float, poisson_ratio: float) -> Material:
        """
        Creates a material from its shear modulus (a pressure) instead of Young's modulus.
        """
    @property
    def hardness(self, /) -> float:
        """
        The stated hardness (a pressure); infinite if it is not stated.
        """
    @property
    def is_coated(self, /) -> bool:
        """
        Whether the body is coated.
        """
    @property
    def is_rigid(self, /) -> bool:
        """
        Whether the body is rigid.
        """
    @property
    def layers(self, /) -> list[Layer]:
        """
        The layers of a coated body, outermost first.
        """
    def plane_strain_under(self, /, stress: float) -> float:
        """
        Returns the strain along x, stress (1 - nu^2) / E, of a body that cannot contract along y under a stress along x
        (a pressure). Stress and strain are positive in tension.
        """
    @property
    def poisson_ratio(self, /) -> float:
        """
        Poisson's ratio; zero for a rigid body.
        """
    @staticmethod
    def rigid() -> Material:
        """
        Returns a body that does not deform.
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
class MaterialRatio:
    """
    The areal material ratio curve (Abbott-Firestone curve) of a surface, and the parameters of its core, peaks and valleys
    according to ISO 25178-2. Heights are relative to the mean, and ratios are fractions, not percentages.

    The equivalent straight line is a least-squares line through the 40 % of the points in which the curve is flattest, that
    is, where the secant over 40 % of the material ratio has the smallest height difference. The core is the part between the
    heights of this line at the material ratios 0 and 1.

    Parameters
    ----------
    heights : Field or topography
        The heights (lengths). Missing heights (NaN) have no weight.

    Raises
    ------
    Sample, Undetermined, NotFinite, Memory

    Examples
    --------
    >>> import numpy as np, stickslip as ss
    >>> grid = ss.Grid(1000, 1, 0.002, 1.0)
    >>> ramp = ss.surface.MaterialRatio(ss.Field(grid, grid.x[None, :]))  # heights from -1 to 1, uniformly distributed
    >>> round(ramp.Sk, 9), ramp.Spk, ramp.Svk, round(float(ramp.height(0.75)), 9)
    (2.0, 0.0, 0.0, -0.5)
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, heights: Field | ArrayLike) -> MaterialRatio: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def Sk(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`core_height`.
        """
    @property
    def Smr1(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`peak_material_ratio`.
        """
    @property
    def Smr2(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`valley_material_ratio`.
        """
    @property
    def Spk(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`reduced_peak_height`.
        """
    @property
    def Svk(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`reduced_valley_depth`.
        """
    @property
    def core_height(self, /) -> float:
        """
        Core height (a length): the height difference of the equivalent straight line.
        """
    def height(self, /, material_ratio: ArrayLike) -> Any:
        """
        Returns the inverse areal material ratio Smc(p): the heights above the mean (lengths) at material ratios from 0 to 1.

        Raises
        ------
        ArgumentRange
            If a ratio is not from 0 to 1, as a ratio in per cent.
        """
    def material_ratio(self, /, height: ArrayLike) -> Any:
        """
        Returns the areal material ratio Smr(c): the fraction of the points that are at least as high as each of the given
        heights above the mean (lengths).
        """
    @property
    def measured_points(self, /) -> int:
        """
        Number of measured heights, on which the parameters are based.
        """
    @property
    def peak_material_ratio(self, /) -> float:
        """
        Material ratio that separates the peaks from the core (a fraction).
        """
    @property
    def reduced_peak_height(self, /) -> float:
        """
        Reduced peak height (a length): the height of a right triangle with the area of the peaks above the core.
        """
    @property
    def reduced_valley_depth(self, /) -> float:
        """
        Reduced valley depth (a length): the height of a right triangle with the area of the valleys below the core.
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns the numbers by name; a pair (x, y) becomes two numbers with the endings ``_x`` and ``_y``. The numbers of
        an object with the same method have its name as the prefix.
        """
    def to_series(self, /) -> Any:
        """
        Returns the numbers of :meth:`to_dict` as a :class:`pandas.Series` (requires pandas).
        """
    @property
    def valley_material_ratio(self, /) -> float:
        """
        Material ratio that separates the core from the valleys (a fraction).
        """

@final
class MindlinDeresiewicz:
    """
    A sphere in partial slip: a constant normal load, and a tangential force along x with any history.

    From zero to the first reversal, the solution is :class:`CattaneoMindlin`. Every reversal adds twice that solution
    for half of the change of force since the reversal. When the force returns to the value of an earlier reversal, it
    closes a loop, and the contact continues as if the loop had not occurred. This is the solution of the scalar
    model, with traction along x only. The coupling between pressure and traction of dissimilar bodies is neglected.
    Mindlin and Deresiewicz (1953); Jaeger (1998); Johnson (1985), 7.52-7.57.

    Parameters
    ----------
    hertz : HertzSphere
        The normal contact.
    friction : float
        Coefficient of friction mu (dimensionless), not negative.
    path : sequence of float
        Successive values of the tangential force on body 1 along x, starting from zero (forces, of either sign, at
        most mu W). The force of an empty path is zero.

    Raises
    ------
    NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, hertz: HertzSphere, *, friction: float, path: Sequence[float] | NDArray[Any]) -> MindlinDeresiewicz: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def amplitude(self, /) -> float:
        """
        Largest magnitude F_0 of the force so far.
        """
    def displacement(self, /, x: ArrayLike, y: ArrayLike) -> Any:
        """
        Returns the tangential displacement u_x of body 1 relative to body 2 (a length), anywhere in the plane, by the
        superposition of the class description.
        """
    @property
    def dissipated_energy(self, /) -> float:
        """
        Energy dissipated along the whole path (a force times a length, not negative).
        """
    @property
    def energy_per_cycle(self, /) -> float:
        """
        Energy dissipated in one full cycle of the force between F_0 and -F_0 (a force times a length), (4/5) mu W
        delta_0 (1 - c/a)^3 (1 + 3 c/a + c^2/a^2) with c = a (1 - F_0 / (mu W))^(1/3).
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
        Returns the slip u_x - delta_x (a length): the motion of the surface of body 1 over that of body 2 since
        before the first loading; zero outside the contact and wherever the surfaces have never slipped.
        """
    @property
    def stick_radius(self, /) -> float:
        """
        Radius of the disc that has not slipped since the last reversal of the force (a length). It is a (1 - |F| /
        (mu W))^(1/3) during the first loading, and a (1 - |F - F_n| / (2 mu W))^(1/3) after a reversal at F_n.
        """
    def traction(self, /, r: ArrayLike) -> Any:
        """
        Returns the traction on body 1 along x (a pressure) at the distance r from the centre, by the superposition of
        the class description. The traction is zero outside the contact.
        """

@final
class MindlinFullStick:
    """
    A contact circle in full stick under a tangential force along x.

    For a sphere, this is the limit of :class:`CattaneoMindlin` for large friction. Under a :class:`FlatPunch` of bodies
    whose pressure and traction are uncoupled, it is valid up to sliding. The circle moves along x only, for any nu. The
    coupling between pressure and traction of dissimilar bodies is neglected. Mindlin (1949); Johnson (1985), 3.82 and
    section 7.2.

    Parameters
    ----------
    pair : ElasticPair or two Materials
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
    def __new__(cls, /, pair: ElasticPair | tuple[Material, Material], *, contact_radius: float, force: float) -> MindlinFullStick: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def contact_radius(self, /) -> float:
        """
        Radius a of the contact circle (a length).
        """
    def displacement(self, /, x: ArrayLike, y: ArrayLike) -> Any:
        """
        Returns the tangential displacement of body 1 relative to body 2 along x (a length, with the sign of the
        force), anywhere in the plane. Inside the contact it is the shift. Outside, at the distance r and the angle
        theta, it is F / (4 pi G a) ((2 - nu) s + nu sin(s) cos(s) cos(2 theta)), with sin(s) = a/r.
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
        Shift F (2 - nu) / (8 G a) (a length): the rigid motion of body 2 relative to body 1, with the sign of the
        force.
        """
    def traction(self, /, r: ArrayLike) -> Any:
        """
        Returns the traction F / (2 pi a sqrt(a^2 - r^2)) on body 1 along x (a pressure, with the sign of the force)
        at the distance r from the centre. It grows without bound towards the edge; at the edge and outside, the
        function returns zero.
        """

@final
class Minimum:
    """
    Constrained minimum of a quadratic form.
    """
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def multiplier(self, /) -> float:
        """
        Multiplier of the prescribed total; zero without a total.
        """
    @property
    def report(self, /) -> Report:
        """
        Report of the solve.
        """
    @property
    def x(self, /) -> NDArray[float64]:
        """
        The unknowns, as a read-only view.
        """

@final
class NoSlipPunch:
    """
    A flat-ended round punch pressed without any slip, as for infinite friction.

    If pressure and traction are coupled (Dundurs' beta is not zero), sticking makes the contact stiffer by the factor
    artanh(beta) / beta. Mossakovskii (1954); Borodich & Keer, Proc. R. Soc. Lond. A 460 (2004) 507.

    Parameters
    ----------
    pair : ElasticPair or two Materials
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
    def __new__(cls, /, pair: ElasticPair | tuple[Material, Material], *, radius: float, load: float) -> NoSlipPunch: ...
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
    A sphere pressed by a growing load without any slip: every point that has come into contact sticks.

    Without coupling between pressure and traction, the solution is that of Hertz. Spence, Proc. R. Soc. Lond. A 305
    (1968) 55.

    Parameters
    ----------
    pair : ElasticPair or two Materials
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
    def __new__(cls, /, pair: ElasticPair | tuple[Material, Material], *, radius: float, load: float) -> NoSlipSphere: ...
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
        Exactly one of the two: the normal force (not negative), or the approach of the bodies from the datum of the gap
        (a length, positive when they move together). On a grid that is periodic along x and y, the approach is the mean
        initial gap minus the mean gap under load, and must be less than the mean initial gap.
    hardness : Hardness, float or array_like of shape (ny, nx), optional
        The largest pressure that the cells can carry; no limit by default.
    settings : Settings, optional
        Method, tolerance and limits; ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        See :class:`Settings`; these arguments take precedence over ``settings``.

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
    >>> hertz = stickslip.analytical.HertzSphere(bodies.pair, radius=3.5e-3, load=100.0)
    >>> bool(abs(contact.pressure.max() / hertz.max_pressure - 1.0) < 2e-3)
    True
    """
    def __getnewargs_ex__(self, /) -> tuple[tuple[Any, ...], dict[str, Any]]: ...
    def __new__(cls, /, bodies: HalfSpace, gap: Field | ArrayLike, *, force: float | None = None, approach: float | None = None, hardness: Hardness | float | ArrayLike | None = None, settings: Settings | None = None, tolerance: float | None = None, method: Method | str | None = None, max_iterations: int | None = None, time_limit: float | None = None) -> NormalProblem: ...
    def __repr__(self, /) -> str: ...
    def solve(self, /, *, progress: Any | None = None, warn: bool = True) -> NormalSolution:
        """
        Solves the problem once.

        Parameters
        ----------
        progress : callable or bool, optional
            A function that is called with an :class:`Iteration` before each product. If it returns ``False``, the solve is
            cancelled and raises ``NotConverged``, whose report has the status "cancelled". All other results, such as ``None``,
            continue the solve, and an exception in the function ends it. ``True`` shows a progress bar of tqdm.
        warn : bool, default True
            Whether the warnings of the solution are also issued through ``warnings``, each kind once per location.

        Returns
        -------
        NormalSolution

        Raises
        ------
        NotConverged
            The exception has the attributes ``report`` and ``last_iterate``.
        """
    def solver(self, /) -> NormalSolver:
        """
        Returns a solver of this problem, which keeps its buffers and starts each solve from the last solution.
        """

@final
class NormalSolution:
    """
    Pressure, gap and approach of a normal contact. Arrays are read-only views of the memory of this object. Two objects
    are equal if their solutions are equal and their units do not differ, even if the iterations differed.
    """
    def __eq__(self, other: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def approach(self, /) -> float:
        """
        Approach of the bodies from the datum of the initial gap (a length). On a grid that is periodic along x and y, it
        is the mean initial gap minus the mean gap under load.
        """
    @property
    def boundary(self, /) -> Boundary:
        """
        Boundary condition at the edge of the grid.
        """
    @property
    def cell_value(self, /) -> CellValue:
        """
        Meaning of the value of a cell.
        """
    @property
    def centre_of_pressure(self, /) -> tuple[float, float] | None:
        """
        Point where the normal force acts (lengths); ``None`` without contact.
        """
    @property
    def contact(self, /) -> NDArray[bool_]:
        """
        Mask of the cells in contact, booleans of shape (ny, nx): cells with positive pressure. The properties
        ``contact_cells`` and ``contact_area`` count these cells. A read-only copy.
        """
    @property
    def contact_area(self, /) -> float:
        """
        Contact area from counting cells. The property ``mean_pressure``, the stick ratio and the areas of spots are
        based on this area of the discrete contact. Its relative excess is about 0.3 times the ratio of cell side to
        contact radius.
        """
    @property
    def contact_area_corrected(self, /) -> float:
        """
        Contact area minus the excess of cell counting along the perimeter. This area should be compared with theory and
        with other grids; its error is smaller than the error of ``contact_area`` by a factor of about four (Yastrebov,
        Anciaux & Molinari 2017).
        """
    @property
    def contact_cells(self, /) -> int:
        """
        Number of contact cells.
        """
    @property
    def contact_extent(self, /) -> tuple[float, float] | None:
        """
        Sides of the bounding box of the contact along x and y (lengths); ``None`` without contact.
        """
    @property
    def discretisation_estimate(self, /) -> float | None:
        """
        Estimate of the discretisation error of the pressure: the sum of the absolute differences from the exact cell
        means, relative to the sum of the pressure; ``None`` without contact, or for one slab of a distributed grid.
        """
    def displacement(self, /, bodies: HalfSpace) -> NDArray[float64]:
        """
        Computes the normal displacement of all cells due to the pressure, summed over both bodies (lengths, positive into
        each body), shape (ny, nx). The cost is one product.
        """
    def edges(self, /) -> Edges:
        """
        Returns the edge of the contact inside the cells, and the pressure there.
        """
    def elastic_energy(self, /, bodies: HalfSpace) -> float:
        """
        Computes the elastic energy of the normal contact (a force times a length). The cost is one product.
        """
    @property
    def force(self, /) -> float:
        """
        Normal force, the integral of the pressure.
        """
    @property
    def gap(self, /) -> NDArray[float64]:
        """
        Gap under load (lengths), shape (ny, nx): zero in the contact up to the residual, negative in cells that yield.
        """
    @property
    def grid(self, /) -> Grid:
        """
        Grid of the fields.
        """
    @property
    def mean_pressure(self, /) -> float:
        """
        Ratio of normal force to contact area; zero without contact.
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
        Termination, cost and error bound of the solve.
        """
    @property
    def spots(self, /) -> ContactSpots:
        """
        The individual contact spots. With distributed bodies, the call is collective.
        """
    def stiffness(self, /, bodies: HalfSpace) -> NormalStiffness:
        """
        Computes the normal stiffness, the derivative of the force with respect to the approach (a force over a length).
        The cost is one solve on the contact cells.
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Warnings about a result that might mislead; empty if there are none.
        """
    @property
    def unit(self, /) -> str | None:
        """
        Unit of the gap from which the solution was computed; ``None`` if it is not known, as in the parts of coupled and adaptive
        solutions.
        """
    @property
    def yielded_cells(self, /) -> int:
        """
        Number of cells at their hardness.
        """

@final
class NormalSolver:
    """
    Solves normal contacts on one grid repeatedly, each time from the last solution. The arguments are those of
    :class:`NormalProblem`; load and gap may change between calls.

    One thread at a time may use a solver. The memory of a solution is reused once the caller has dropped it.

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
    @property
    def gap(self, /) -> NDArray[float64]:
        """
        The gap before loading of the next solve (lengths), as last set; a read-only copy.
        """
    def chain(self, /, solution: NormalSolution, sensitivities: Sequence[Sensitivity], *, tolerance: float | None = None) -> list[Sensitivity]:
        """
        Continues sensitivities of a tangential contact through the normal contact that supplies its pressure.

        The results also contain the derivatives with respect to the gap and the normal load. The derivatives with respect to
        the modulus include the change of the pressure.

        Parameters
        ----------
        solution : NormalSolution
            The solution of the present problem of this solver.
        sensitivities : sequence of Sensitivity
            Results of :meth:`TangentialSolver.sensitivities`.
        tolerance : float, optional
            Relative residual at which a linear problem counts as solved; 1e-11 by default.

        Returns
        -------
        list of Sensitivity

        Raises
        ------
        UnsupportedByModel
            If a sensitivity has no derivative with respect to the pressure, or was chained before.
        OutdatedSolution
            If a sensitivity was computed for another pressure, or the solution for another problem of this solver.
        GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch, NotPositive, EmptyContact, NotFinite, NotConverged
            See :meth:`sensitivity`.

        Examples
        --------
        >>> import stickslip
        >>> from stickslip.sensitivity import Functional
        >>> grid = stickslip.Grid.square(48, 0.3e-3)
        >>> steel = stickslip.Material(213e9, 0.29)
        >>> bodies = stickslip.HalfSpace(grid, (steel, steel))
        >>> presser = stickslip.NormalSolver(bodies, stickslip.surface.sphere(grid, 3.5e-3), force=100.0)
        >>> normal = presser.solve()
        >>> shearer = stickslip.TangentialProblem(bodies, normal, 0.5, shift_x=1.5e-6).solver()
        >>> found = shearer.sensitivities(shearer.solve(), [Functional.tangential_force("x")])
        >>> [chained] = presser.chain(normal, found)
        >>> chained.normal_load > 0.0 and chained.friction_coefficient > 0.0
        True
        """
    def reset(self, /) -> None:
        """
        Discards the last solution, so that the next solve starts like the first.
        """
    def sensitivities(self, /, solution: NormalSolution, functionals: Sequence[Functional], *, tolerance: float | None = None, poisson_ratio: bool = False) -> list[Sensitivity]:
        """
        Computes the sensitivities of several functionals, in their order. They share the responses to prescribed
        forces. The options and the exceptions are those of :meth:`sensitivity`.
        """
    def sensitivity(self, /, solution: NormalSolution, functional: Functional, *, tolerance: float | None = None, poisson_ratio: bool = False) -> Sensitivity:
        """
        Computes the derivatives of a functional with respect to the input of the problem: gap, loads, friction and
        moduli.

        The derivatives of all cells together cost about one linear solve on the contact cells (the adjoint). The
        sets of contact, stick and slip cells are constant in the derivatives.

        Parameters
        ----------
        solution : NormalSolution
            The solution of the present problem of this solver.
        functional : Functional
            The functional; see :class:`stickslip.sensitivity.Functional`.
        tolerance : float, optional
            Relative residual at which a linear problem counts as solved; 1e-11 by default.
        poisson_ratio : bool, default False
            Whether to compute the derivatives with respect to Poisson's ratios of tangential and coupled contacts,
            which require further operators. Normal contacts always have them.

        Returns
        -------
        Sensitivity

        Raises
        ------
        GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch
            If the solution belongs to other bodies, or if weights have a different grid.
        UnsupportedByModel
            If the functional depends on a quantity that the problem does not have.
        BelowMinimum, Sample, NotPositive, Tolerance
            If a number of the functional or the tolerance is invalid.
        EmptyContact
            If no cell carries pressure under a prescribed force.
        NotFinite
            If a number of the functional is not finite, if a periodic contact is closed everywhere, or if the contact
            cannot resist a change of the prescribed force, as in sliding.
        NotConverged
            If the solution has not converged, or if a linear solve fails.
        """
    def set_gap(self, /, gap: Field | ArrayLike) -> None:
        """
        Sets the gap of the next solve, for example after wear.

        Raises
        ------
        GapUnderLoad
            If the gap is the gap of the last solution, which is the gap under load.
        ValueError
            If the unit of the gap differs from that of the earlier gaps.
        """
    def set_load(self, /, *, force: float | None = None, approach: float | None = None) -> None:
        """
        Sets the load of the next solve.
        """
    @property
    def settings(self, /) -> Settings:
        """
        Settings of the next solve; assignable.
        """
    @settings.setter
    def settings(self, /, settings: Settings) -> None: ...
    def solve(self, /, *, force: float | None = None, approach: float | None = None, gap: Field | ArrayLike | None = None, progress: Any | None = None, warn: bool = True) -> NormalSolution:
        """
        Solves for the given load and gap; an omitted load or gap keeps its last value.

        The arguments set the problem of the solver. They remain set if the solve fails or is cancelled; invalid arguments
        leave it unchanged.

        Parameters
        ----------
        force, approach : float, optional
            At most one of the two; see :class:`NormalProblem`.
        gap : Field or array_like of shape (ny, nx), optional
            The gap before loading (lengths); copied. Its unit, if any, must be that of the earlier gaps.
        progress, warn : optional
            See :meth:`NormalProblem.solve`.

        Returns
        -------
        NormalSolution

        Raises
        ------
        GridMismatch, Shape, Sample, NegativeOrNotFinite, NotFinite, ApproachBeyondMeanGap, BeyondHardness
            If the load or the gap is invalid; both are then unchanged.
        ValueError
            If the unit of the gap differs from that of the earlier gaps; load and gap are then unchanged.
        NotConverged
            The exception has the attributes ``report`` and ``last_iterate``.
        """

@final
class NormalStiffness:
    """
    Derivative of the normal force with respect to the approach (a force over a length), with a bound on its
    relative error. The set of contact cells is fixed. On a sphere the derivative is 2 E* a (Hertz).
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __float__(self, /) -> float: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def bound(self, /) -> float:
        """
        Bound on the relative error of the linear solve; infinite if pressure and traction are solved simultaneously. It
        excludes the effect of errors of the pressure.
        """
    @property
    def value(self, /) -> float:
        """
        Value of the derivative (a force over a length); zero without contact.
        """

@final
class Persson:
    """
    A nominally flat rough surface pressed on a half-space: the fraction of the area in real contact.

    The contact fraction is erf((sqrt(pi)/2) kappa P), where P = mean_pressure / (E* rms_slope) is the reduced
    pressure. For light loads it is kappa P. The coefficient kappa is sqrt(8/pi) in Persson's theory (the default) and
    sqrt(2 pi) in the theory of Bush, Gibson and Thomas; simulations give 2.0 to 2.2. The fraction is a mean over
    infinite surfaces whose shortest waves are resolved. Persson (2001); Bush, Gibson and Thomas (1975).

    Parameters
    ----------
    pair : ElasticPair or two Materials
        The bodies.
    rms_slope : float
        Root mean square of the gradient (Sdq, dimensionless), positive: for an isotropic surface, sqrt(2) times the
        rms slope of profiles.
    mean_pressure : float
        Ratio of the load to the nominal area, positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair | tuple[Material, Material], *, rms_slope: float, mean_pressure: float) -> Persson: ...
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
        Returns the contact fraction of any surface at a reduced pressure P (not negative) for a coefficient kappa
        (positive; both dimensionless).
        """
    @property
    def contact_fraction(self, /) -> float:
        """
        Fraction of the nominal area in real contact.
        """
    @property
    def mean_pressure(self, /) -> float:
        """
        Mean pressure, the ratio of the load to the nominal area.
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
        Returns the fraction of the real contact area that sticks. It is the ratio of the contact area under 1 - f of
        the load to the contact area under the full load, with f = |mean_traction| / (mu mean_pressure). Ciavarella,
        J. Appl. Mech. 65 (1998) 998; Jaeger, J. Tribology 120 (1998) 677.

        Parameters
        ----------
        friction : float
            Coefficient of friction mu (dimensionless), not negative.
        mean_traction : float
            Ratio of the tangential force to the nominal area, of either sign.

        Raises
        ------
        NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
        """
    def with_area_coefficient(self, /, area_coefficient: float) -> Persson:
        """
        Returns the same contact with a different coefficient kappa (dimensionless, positive).
        """

@final
class Plane:
    """
    Stress, and displacement if requested, at the cell centres of a plane below the surface. Arrays are views, except for
    derived stresses, which are new arrays.
    """
    def __repr__(self, /) -> str: ...
    @property
    def body(self, /) -> Body:
        """
        The body that contains the plane.
        """
    @property
    def depth(self, /) -> float:
        """
        Depth below the surface of the body (a length).
        """
    @property
    def displacement(self, /) -> tuple[NDArray[float64], NDArray[float64], NDArray[float64]] | None:
        """
        Displacement along x, y and z (lengths); ``None`` if it was not requested.
        """
    def get(self, /, ix: int, iy: int) -> Stress | None:
        """
        Returns the stress of a cell, given by column and row, or ``None`` outside the grid.
        """
    @property
    def grid(self, /) -> Grid:
        """
        Grid of the plane.
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
        Warnings about values that might mislead; empty if there are none. A plane nearer to the surface than a cell
        side has a warning if shear tractions end at the edge of a contact.
        """
    @property
    def z(self, /) -> float:
        """
        Position along z (a length), negative in body two.
        """

@final
class Planes:
    """
    Stresses on planes at chosen depths below the surface of each body, computed by fast Fourier transforms. In
    coated bodies the planes may lie in the layers or below them. The kernels of a depth are created at its first
    solve and kept.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    depths : array_like
        Depths below the surface of each body (lengths), not negative.
    displacements : bool, default False
        Whether displacements are also computed.

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
    >>> hertz = stickslip.analytical.HertzSphere(bodies.pair, radius=5.0, load=100.0)
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
        Depths of the planes (lengths).
        """
    def solve(self, /, index: int, body: Body | str, tractions: Any, *, uniform_stress: Stress | None = None, warn: bool = True) -> Plane:
        """
        Computes the plane at the depth with this index in a body. A negative index counts from the end. For the
        tractions, see :func:`at_points`.

        Parameters
        ----------
        uniform_stress : Stress, optional
            Bulk stress that is added; see :func:`at_points`.
        warn : bool, default True
            Whether :attr:`Plane.warnings` are also issued through ``warnings``, each kind once per location.

        Raises
        ------
        IndexError
            If the index is out of range.
        RigidBody, Memory, GridMismatch, BoundaryMismatch, MaterialMismatch, Sample
        """
    def solve_all(self, /, body: Body | str, tractions: Any, *, uniform_stress: Stress | None = None, warn: bool = True) -> list[Plane]:
        """
        Computes the planes of all depths in a body; see :meth:`solve`.
        """
    def write_vti(self, /, path: str | PathLike[str], body: Body | str, tractions: Any, *, uniform_stress: Stress | None = None) -> None:
        """
        Writes the stresses of all depths in a body as a volume for ParaView; see :meth:`solve`.
        """

@final
class PopovLimitingShape:
    """
    The limiting shape of a paraboloid of revolution worn by small oscillations at a constant approach, when wear has
    ceased.

    The stick disc of radius c does not wear. The ring around it wears until it carries no pressure and the surfaces
    just touch there. The wear law determines how fast this shape is reached, but not the shape itself. The solution
    is exact if Dundurs' beta is zero and the stick disc remains round. Popov (2014).

    Parameters
    ----------
    pair : ElasticPair or two Materials
        The bodies.
    radius : float
        Radius R of the paraboloid before wear, whose gap is r^2 / 2R (a length), positive.
    approach : float
        Approach d of the bodies (a length), positive.
    stick_radius : float
        Radius c of the stick disc (a length), not negative, at most the contact radius sqrt(R d) before wear; zero
        means gross sliding.

    Raises
    ------
    NotPositive, NegativeOrNotFinite, BelowMinimum
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair | tuple[Material, Material], *, radius: float, approach: float, stick_radius: float) -> PopovLimitingShape: ...
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
        Returns the remaining pressure (E*/pi) (2 s / R + (d - c^2/R) / s), with s = sqrt(c^2 - r^2), at the distance
        r from the centre, or zero outside the stick disc. The pressure grows without bound towards the edge of the
        disc.
        """
    def profile(self, /, r: ArrayLike) -> Any:
        """
        Returns the gap without load (a length) at the distance r from the centre, zero at the centre: in the ring
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
        Returns the wear depth (a length), summed over the bodies, at the distance r from the centre: positive in the
        ring, zero elsewhere.
        """
    @property
    def worn_radius(self, /) -> float:
        """
        Radius within which the surfaces are worn (a length), larger than the contact radius before wear.
        """
    @property
    def worn_volume(self, /) -> float:
        """
        Worn volume (a length cubed), summed over the bodies.
        """

@final
class PowerSpectrum:
    """
    The radial average of the power spectrum of a periodic surface.

    Parameters
    ----------
    heights : Field or topography
        The heights (lengths), without missing values.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, heights: Field | ArrayLike) -> PowerSpectrum: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def modes(self, /) -> NDArray[uint64]:
        """
        Number of wave vectors in each ring; q and -q are counted separately.
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
    Principal stresses, the largest first, with their unit vectors.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def directions(self, /) -> list[list[float]]:
        """
        Unit vectors of the principal stresses, in the same order.
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
        Half-sides along x and y (lengths), positive.

    Raises
    ------
    NotPositive
    """
    def __new__(cls, /, a: float, b: float) -> Rectangle: ...
    def __repr__(self, /) -> str: ...
    def pair_tensor(self, /, pair: ElasticPair | tuple[Material, Material], x: float, y: float) -> Tensor:
        """
        Returns the coefficients of a pair at a position relative to the centre (lengths).
        """
    def tensor(self, /, material: Material, x: float, y: float) -> Tensor:
        """
        Returns the coefficients of a body at a position relative to the centre (lengths).
        """

@final
class Region:
    """
    Region of the surface where contact may occur, in the coordinates of the gap. Its static methods create a region.

    The grid of an :class:`AdaptiveProblem` covers only the part of the region where the bodies touch. Along a periodic
    axis, it covers the whole region.

    Examples
    --------
    >>> import stickslip as ss
    >>> ss.adaptive.Region.rectangle((-1e-3, 1e-3), (-1e-3, 1e-3))
    Region.rectangle((-0.001, 0.001), (-0.001, 0.001))
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def boundary(self, /) -> Boundary:
        """
        Boundary condition at the edge of the grids.
        """
    @staticmethod
    def line(x: Sequence[float] | NDArray[Any], datum: float) -> Region:
        """
        Creates a part of a line contact in plane strain. All forces are per unit length.

        Parameters
        ----------
        x : (float, float)
            Start and end along x (lengths).
        datum : float
            The datum of :meth:`Boundary.periodic_along_y` (a length), at least the length of the line.

        Raises
        ------
        NotFinite, NotPositive, BelowMinimum
        """
    @staticmethod
    def periodic(x: Sequence[float] | NDArray[Any], y: Sequence[float] | NDArray[Any]) -> Region:
        """
        Creates a rectangle of periodic surroundings. The gap must have these periods.

        Parameters
        ----------
        x, y : (float, float)
            Start and end along x and along y (lengths).

        Raises
        ------
        NotFinite, NotPositive
        """
    @staticmethod
    def rectangle(x: Sequence[float] | NDArray[Any], y: Sequence[float] | NDArray[Any]) -> Region:
        """
        Creates a rectangle with these ends. The bodies extend beyond it.

        Parameters
        ----------
        x, y : (float, float)
            Start and end along x and along y (lengths).

        Raises
        ------
        NotFinite, NotPositive
        """
    @property
    def x(self, /) -> tuple[float, float]:
        """
        Start and end along x (lengths).
        """
    @property
    def y(self, /) -> tuple[float, float] | None:
        """
        Start and end along y (lengths); ``None`` for a line.
        """

@final
class RelativeDisplacement:
    """
    A displacement of body 1 relative to body 2 that is not caused by the contact, such as bulk strain or thermal
    expansion. Fields with a unit raise an error where the gap has another unit.

    Parameters
    ----------
    along_x, along_y : Field or array_like of shape (ny, nx)
        Displacements of body 1 relative to body 2 along x and y (lengths, of either sign). A single number is rejected; for a
        strain use :meth:`bulk_strain`.
    grid : Grid, optional
        Grid of the arrays; required for arrays, because only Fields have their own grid.

    Raises
    ------
    GridMismatch, Sample, ArgumentType
    ValueError
        If the fields have different units.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, along_x: Field | ArrayLike, along_y: Field | ArrayLike, *, grid: Grid | None = None) -> RelativeDisplacement: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @staticmethod
    def bulk_strain(grid: Grid, strain: Sequence[Sequence[float]] | NDArray[Any]) -> RelativeDisplacement:
        """
        Returns the displacement due to a uniform strain ``[[xx, xy], [yx, yy]]``, the strain of body 1 minus the strain
        of body 2 (dimensionless, positive in tension). It is zero at the origin of the grid.
        The components xy and yx must be equal, each half of the engineering shear strain; a rotation is a twist.
        The rows and columns of a table of pandas or an array of xarray are recognised by the labels x and y.
        """
    @property
    def fields(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Components along x and y (lengths).
        """
    @property
    def unit(self, /) -> str | None:
        """
        Unit of the fields; ``None`` if it is not known.
        """

@final
class Report:
    """
    Termination, cost and error bound of a solve.

    All error measures are recomputed from a fresh product with the returned iterate, whatever the status.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def double_precision_products(self, /) -> int:
        """
        Number of products with the operator in double precision, including the final check.
        """
    @property
    def duality_gap(self, /) -> float:
        """
        Certified bound on the squared relative error in the energy norm.
        """
    @property
    def eigenvalue_bound(self, /) -> EigenvalueBound:
        """
        Origin of the bound on the smallest eigenvalue, on which :attr:`duality_gap` depends.

        "proven" is a computed bound. "stated" is given by the caller with a user-defined operator. "estimated" is an estimate
        on the safe side, for stiff coatings on long grids. With "unknown", no bound is available, and the error bound
        decreases only with the square root of the residual.
        """
    @property
    def energy_error_bound(self, /) -> float:
        """
        Certified bound on the relative error in the energy norm, the square root of the duality gap.
        On a periodic grid under a prescribed approach or shift, the bound is relative to the contact under the computed
        force and excludes the error of this force.
        """
    @property
    def history(self, /) -> list[Iteration]:
        """
        All iterates whose residual was measured, in order.
        """
    @property
    def is_converged(self, /) -> bool:
        """
        Whether the tolerance was reached.
        """
    @property
    def iterations(self, /) -> int:
        """
        Number of conjugate-gradient steps.
        """
    @property
    def load_error(self, /) -> float:
        """
        Relative error of the prescribed total; zero if no total is prescribed.
        """
    @property
    def products(self, /) -> int:
        """
        Number of products in both precisions.
        """
    @property
    def residual(self, /) -> float:
        """
        Largest complementarity residual, relative to the largest displacement.
        """
    @property
    def single_precision_products(self, /) -> int:
        """
        Number of products in single precision.
        """
    @property
    def status(self, /) -> Status:
        """
        Reason for the end of the iteration.
        """
    @property
    def time(self, /) -> float:
        """
        Wall time of the solve (s).
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns the numbers by name; a pair (x, y) becomes two numbers with the endings ``_x`` and ``_y``. The numbers of
        an object with the same method have its name as the prefix.
        """
    def to_series(self, /) -> Any:
        """
        Returns the numbers of :meth:`to_dict` as a :class:`pandas.Series` (requires pandas).
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
        Displacement of the body itself along x, y and z (lengths), not relative to the other body.
        """
    @property
    def stress(self, /) -> Stress:
        """
        Stress at the point.
        """

@final
class PointResults:
    """
    Displacements and stresses at points: a sequence of :class:`PointResult`, and arrays with one number per point, in the
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
        Displacement of the body itself along x, y and z (lengths), not relative to the other body.
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
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns arrays by name, with one entry per element; a vector becomes one array per component with the endings
        ``_x``, ``_y`` and ``_z``, and stresses have endings such as ``_xx``.
        """
    def to_frame(self, /) -> Any:
        """
        Returns the arrays of :meth:`to_dict` as columns of a :class:`pandas.DataFrame` (requires pandas).
        """
    @property
    def von_mises(self, /) -> NDArray[float64]:
        """
        Von Mises' equivalent stress (pressures).
        """

@final
class Rolling:
    """
    Rolling of the bodies in a step of a history: the number of cells, the edge where particles enter the contact, and the
    creepage of body 2 over body 1. Without creepage and spin, the bodies roll freely.

    Parameters
    ----------
    cells : int
        Number of cells by which the particles of both surfaces move through the contact, one or more; a step with zero cells raises
        :class:`~stickslip.errors.NotPositive`. The grid must
        extend by this number of cells ahead of and behind the contact; otherwise the step raises
        :class:`~stickslip.errors.GridTooShort`. The entry rule needs the slope of the gap two cells further ahead. If
        the grid ends before, this slope is one-sided.
    creepage : pair of float, optional
        The creepages along x and y, the motion of body 2 over body 1 per unit length rolled (dimensionless, default
        zero). A positive creepage causes a positive force. Kalker and CONTACT define creepage and spin as motions
        of body 1 over body 2, with the opposite sign. Along an axis with a prescribed force, the creepage follows
        from the force and must not be given here.
    creepage_x, creepage_y : float, optional
        Creepage along one axis.
    spin : float, default 0
        Rotation of body 2 relative to body 1 about the origin of the grid per unit length rolled (one over a length,
        positive from x to y). It requires the vector model.
    leading_edge : LeadingEdge or str, default "plus_x"
        The edge where particles enter the contact.

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
    Bodies, normal contact, friction and controls of steady rolling.

    At least one creepage, force, spin or moment is required. The creepage is zero along an axis without a given creepage or
    force.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    normal : NormalSolution
        A solved normal contact of these bodies.
    friction : Friction, float or array_like of shape (ny, nx)
        Coulomb friction; a number or an array is the coefficient of friction (dimensionless, not negative).
    creepage, creepage_x, creepage_y : pair of float, float, optional
        The creepages, the motion of body 2 over body 1 per unit length rolled (dimensionless). A positive creepage
        causes a positive force. Kalker and CONTACT define creepage and spin as motions of body 1 over body 2, with
        the opposite sign.
    force, force_x, force_y : pair of float, float, optional
        The tangential force that body 2 exerts on body 1, less than the friction capacity; the creepage follows from it.
    spin : float, default 0
        Rotation of body 2 relative to body 1 about the origin of the grid per unit length rolled (one over a length,
        positive from x to y).
    moment : float, optional
        The moment on body 1 about the origin of the grid (a force times a length, positive from x to y), less than the
        friction capacity. It replaces the spin, which follows from it.
    leading_edge : LeadingEdge or str, default "plus_x"
        The edge where particles enter the contact.
    step : int, default 1
        Number of cells that a particle passes in a step. Longer steps cost less and are less accurate. The grid
        must extend by this number of cells ahead of the contact; otherwise the problem raises
        :class:`~stickslip.errors.GridTooShort`. The entry rule needs the slope of the gap two cells further ahead. If
        the grid ends before, this slope is one-sided.
    entry_rule : EntryRule or str, default "since_touch"
        Rule for the motion of cells that enter the contact; "whole_step", the rule of CONTACT, is less accurate.
    slip_corrections : int, default 0
        Number of corrections of the direction of slip. Two corrections raise the order of convergence of the forces
        under spin from 1 to between 1.5 and 2.
    settings : Settings, optional
        Method, tolerance and limits; ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        See :class:`Settings`; these arguments take precedence over ``settings``.

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
    >>> a = stickslip.analytical.HertzSphere(bodies.pair, radius=1.0, load=1.0).contact_radius
    >>> abs(rolling.force[0] / (a * a * 1e-5) / 4.12 - 1.0) < 0.02  # Kalker's coefficient C11
    True
    """
    def __getnewargs_ex__(self, /) -> tuple[tuple[Any, ...], dict[str, Any]]: ...
    def __new__(cls, /, bodies: HalfSpace, normal: NormalSolution, friction: Friction | float | ArrayLike, *, creepage: Sequence[float] | NDArray[Any] | None = None, creepage_x: float | None = None, creepage_y: float | None = None, force: Sequence[float] | NDArray[Any] | None = None, force_x: float | None = None, force_y: float | None = None, spin: float | None = None, moment: float | None = None, leading_edge: LeadingEdge | str | None = None, step: int | None = None, entry_rule: EntryRule | str | None = None, slip_corrections: int | None = None, settings: Settings | None = None, tolerance: float | None = None, method: Method | str | None = None, max_iterations: int | None = None, time_limit: float | None = None) -> RollingProblem: ...
    def __repr__(self, /) -> str: ...
    def solve(self, /, *, progress: Any | None = None, warn: bool = True) -> RollingSolution:
        """
        Solves the problem once; see :meth:`NormalProblem.solve`. The warnings that the normal solution also has are not issued
        again; the attribute ``warnings`` of the result lists them.
        """
    def solver(self, /) -> RollingSolver:
        """
        Returns a solver of this problem, which keeps its buffers and starts each solve from the last solution.
        """

@final
class RollingSolution:
    """
    Traction, slip, zones, creepage and dissipation of steady rolling. Vectors are (x, y). Arrays are read-only views of
    the memory of this object, except for the zones and the dissipation, which are read-only copies.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def creepage(self, /) -> tuple[float, float]:
        """
        The creepages along x and y, prescribed or caused by the force (dimensionless).
        """
    @property
    def dissipation_per_area(self, /) -> NDArray[float64]:
        """
        Energy dissipated by slip in each cell per area and per length rolled (a pressure). The cells are fixed in the contact,
        and the particles of both surfaces pass through them. The value of a cell is therefore not the wear of a particle. In
        each passage, a particle loses the wear coefficient times the sum of the values over the cells of its line along the
        rolling direction, times their side along this line. Add this depth to whole lines of the gap. A wheel with the
        circumference U makes L/U passages over the length L. The laws of :mod:`stickslip.wear` reject this array, because they
        divide energies by the area of a cell. Between bodies of the same material, the integral of this energy is less than the
        work; the difference decreases with the cell size.
        """
    @property
    def force(self, /) -> tuple[float, float]:
        """
        Tangential force that body 2 exerts on body 1 along x and y.
        """
    @property
    def grid(self, /) -> Grid:
        """
        Grid of the fields.
        """
    @property
    def moment(self, /) -> float:
        """
        Moment about z, at the origin of the grid, on body 1 (a force times a length, positive from x to y).
        """
    @property
    def report(self, /) -> Report:
        """
        Termination, cost and error bound of the solve.
        """
    @property
    def slip(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Slip of the surface of body 1 over the surface of body 2 along x and y per unit length rolled (dimensionless),
        averaged over the step that brought the particles to the cell. It is opposite to the traction in slip cells and
        zero elsewhere.
        """
    @property
    def spin(self, /) -> float:
        """
        The spin, prescribed or caused by the moment (one over a length, positive from x to y).
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Ratio of stick cells to contact cells; zero without contact.
        """
    @property
    def traction(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Traction on body 1 along x and y (pressures); zero outside the contact.
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Warnings about a result that might mislead; empty if there are none.
        """
    @property
    def work(self, /) -> float:
        """
        Work of creepages and spin per unit length rolled (a force). The displacement of a particle due to the spin is
        evaluated at the midpoint of its path, and so is the moment in this work. Between bodies of the same material,
        all of the work is dissipated. Between bodies of different materials, the pressure also does work, which is not
        included.
        """
    @property
    def zones(self, /) -> NDArray[uint8]:
        """
        Zone of each cell, a uint8 array of shape (ny, nx) with the values of :class:`Zone`: 0 separated, 1 stick, 2 slip.

        The array also compares equal to the names of the zones; see :attr:`TangentialSolution.zones`.
        """

@final
class RollingSolver:
    """
    Solves for successive creepages, forces or spins, each time from the last solution; created by
    :meth:`RollingProblem.solver`.
    """
    def __new__(cls, /, *_arguments: Any, **_options: Any) -> RollingSolver: ...
    def __repr__(self, /) -> str: ...
    def creep_forces(self, /, points: ArrayLike, *, progress: Any | None = None, warn: bool = True) -> CreepForces:
        """
        Computes the loads at all points of a creep curve, or of a creep surface row by row. Each solve starts from the
        solution of the previous point. The last point remains prescribed. All points are checked before the first solve.
        After Ctrl-C, the point whose solve was ended remains prescribed.

        Any exception after the first solve has the attribute ``partial`` with the :class:`CreepForces` of the points solved
        before, also ``KeyboardInterrupt``.

        Parameters
        ----------
        points : array_like of shape (n, 3)
            Points ``(creepage_x, creepage_y, spin)`` (dimensionless, dimensionless, one over a length). Consecutive
            points should be close to each other. The columns of a table of pandas are recognised by these names.
        progress : callable or bool, optional
            A function that is called with the :class:`CreepForce` of each solved point. It ends the call by returning
            ``False``, as in :meth:`NormalProblem.solve`. ``True`` shows a progress bar of the points.
        warn : bool, default True
            Whether the warnings of the points are also issued through ``warnings``. Each kind is issued once, for the last
            point that has it.

        Returns
        -------
        CreepForces
            The points with their loads, as a sequence and as arrays.

        Raises
        ------
        NotFinite, UnsupportedByModel
            If any of the points is invalid; the solver is then unchanged.
        NotConverged
            At the first point that fails or is cancelled, which remains prescribed.
        """
    @property
    def friction(self, /) -> Friction:
        """
        The friction of the next solve, as last set, with its ``max_shear_stress``.
        """
    @property
    def friction_capacity(self, /) -> float:
        """
        Largest tangential force that friction can carry: the integral of the friction limit.
        """
    @property
    def report(self, /) -> Report:
        """
        Report of the last solve.
        """
    def reset(self, /) -> None:
        """
        Discards the last solution, so that the next solve starts like the first.
        """
    def set_friction(self, /, friction: Friction | float | ArrayLike) -> None:
        """
        Sets the friction of the next solve. A law or a coefficient replaces the last law, with its ``max_shear_stress``. A
        coefficient alone has none; a warning is issued if the last law had one.
        """
    def set_normal_load(self, /, *, normal_force: float | None = None, approach: float | None = None) -> None:
        """
        Sets the normal load of the next solve, and computes the pressure starting from the last pressure. The normal
        solver must have been set by :meth:`set_normal_solver`.

        Parameters
        ----------
        normal_force, approach : float, optional
            Exactly one of the two; see ``force`` and ``approach`` of :class:`NormalProblem`.

        Raises
        ------
        UnsupportedByModel
            Without a normal solver.
        NegativeOrNotFinite, NotFinite, NotConverged, EmptyContact, GridTooShort, BeyondFrictionCapacity, BeyondFrictionMoment
            The solver is unchanged after an exception.
        """
    def set_normal_solver(self, /, solver: NormalSolver) -> None:
        """
        Sets the normal solver that computes the pressure for a new load. The solver is copied, with its gap, hardness and
        settings.

        This call does not change the pressure. :meth:`set_normal_load` solves for the pressure over the gap of ``solver``, which
        therefore need not have solved before. Its gap may differ from that of the present pressure, for example after wear.
        Grid, boundary, cell values and materials must be equal.

        Raises
        ------
        GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch
        ValueError
            If the unit of its gap differs from that of the earlier gaps.
        """
    def set_pressure(self, /, pressure: NormalSolution | Field | ArrayLike) -> None:
        """
        Sets the pressure of the next solve. A field contains no gap and therefore requires a solver with
        ``entry_rule="whole_step"``.

        Raises
        ------
        UnsupportedByModel, GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch, NotConverged, Sample, EmptyContact,
        GridTooShort, NotFinite, BeyondFrictionCapacity, BeyondFrictionMoment
            The pressure is unchanged after an exception.
        ValueError
            If the unit of its gap differs from that of the earlier gaps.
        """
    @property
    def settings(self, /) -> Settings:
        """
        Settings of the next solve; assignable.
        """
    @settings.setter
    def settings(self, /, settings: Settings) -> None: ...
    def solve(self, /, *, creepage: Sequence[float] | NDArray[Any] | None = None, creepage_x: float | None = None, creepage_y: float | None = None, force: Sequence[float] | NDArray[Any] | None = None, force_x: float | None = None, force_y: float | None = None, spin: float | None = None, moment: float | None = None, progress: Any | None = None, warn: bool = True) -> RollingSolution:
        """
        Solves for the given creepages, forces, spin or moment. Omitted arguments keep their last values.

        The arguments set the problem of the solver. They remain set if the solve fails or is cancelled; invalid arguments
        leave it unchanged.

        Parameters
        ----------
        creepage, creepage_x, creepage_y, force, force_x, force_y, spin, moment : optional
            See :class:`RollingProblem`. A creepage or force along an axis replaces the last one along that axis only, and a
            spin or moment replaces the last spin or moment.
        progress, warn : optional
            See :meth:`NormalProblem.solve`.

        Returns
        -------
        RollingSolution

        Raises
        ------
        NotFinite, UnsupportedByModel, BeyondFrictionCapacity, BeyondFrictionMoment
            If the prescribed values are invalid; they are then unchanged.
        NotConverged
            The exception has the attributes ``report`` and ``last_iterate``.
        """
    def stiffness(self, /) -> list[list[float]]:
        """
        Returns the derivatives of the forces along x and y and the moment (rows) with respect to the creepages along x
        and y and the spin (columns) at the last solution. The entries are forces; the column of the spin and the row of
        the moment each add a factor of length. Stick cells follow the change and slip cells remain at their limits.
        Before the first solve, all cells stick, and the entries are Kalker's coefficients times G a b and powers of a
        length.

        Raises
        ------
        OutdatedSolution
            If a load, the pressure or the friction has changed since the last solve.
        NotConverged
            If the last solve has not converged, or if a column does not converge.
        """

@final
class RoughSphere:
    """
    A rough sphere pressed on a half-space: the fraction of the Hertz circle in real contact.

    At a pressure p of the smooth sphere, the fraction erf((sqrt(pi)/2) kappa p / (E* rms_slope)) of the area is in
    contact; the result is the mean of this fraction over the Hertz circle. It is valid if the heights of the
    roughness are small compared with the approach and its wavelengths are small compared with the circle. The default
    of kappa is 2. The solution follows Müser (2016).

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
    def __new__(cls, /, hertz: HertzSphere, *, rms_slope: float) -> RoughSphere: ...
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
        Returns the relative contact area of any rough sphere at a reduced pressure P (not negative) for a coefficient
        kappa (positive; both dimensionless).
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
        Ratio of the real contact area to the area of the Hertz circle, between 0 and 1.
        """
    @property
    def rms_slope(self, /) -> float:
        """
        Root mean square of the gradient (dimensionless).
        """
    def with_area_coefficient(self, /, area_coefficient: float) -> RoughSphere:
        """
        Returns the same contact with a different coefficient kappa (dimensionless, positive), for example one of the
        values listed in :class:`Persson`.
        """

@final
class RoughSurface:
    """
    A generated rough surface.
    """
    def __array__(self, /, dtype: Any | None = None, copy: bool | None = None) -> Any: ...
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def array(self, /) -> NDArray[float64]:
        """
        Read-only array of the heights, without a copy.
        """
    @property
    def heights(self, /) -> Field:
        """
        The heights (lengths), with zero mean.
        """
    @property
    def iterations(self, /) -> int:
        """
        Number of iterations for a prescribed skewness or kurtosis.
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
    pair : ElasticPair or two Materials
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
    def __new__(cls, /, pair: ElasticPair | tuple[Material, Material], *, flat: float, radius: float, load: float) -> RoundedPunch: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def half_width(self, /) -> float:
        """
        Half-width of the contact (a length).
        """
    def pressure(self, /, x: ArrayLike) -> Any:
        """
        Returns the pressure at the distance x from the middle, or zero outside the contact.
        """

@final
class SelfAffine:
    """
    Parameters of self-affine roughness. With a given cut-off wavelength, the surface does not change when the grid is
    refined.

    Parameters
    ----------
    rms_height, rms_slope : float
        Exactly one of the two: the root mean square of the heights (a length) or of the gradient (dimensionless).
    hurst : float, default 0.8
        The Hurst exponent H, in [0, 1]; the fractal dimension is 3 - H.
    longest_wavelength : float, optional
        Upper end of the spectrum (a length); the longer side of the grid by default.
    roll_off_wavelength : float, optional
        Wavelength at which the plateau of the spectrum ends and the spectrum begins to fall (a length). The default is
        the longest wavelength, without a plateau.
    cut_off_wavelength : float, optional
        Lower end of the spectrum (a length), at least two cells; by default eight times the longer side of a cell.
    amplitudes : Amplitudes or str, default "exact"
        "exact" gives each wave the amplitude of the spectrum, and only its phase is random; "gaussian" scatters the
        amplitudes too, as filtered white noise does.
    cropped : bool, default False
        Whether the surface is the middle of a larger surface and therefore not periodic.
    skewness, kurtosis : float, optional
        Skewness and kurtosis of the heights (Gaussian heights have kurtosis 3). By default they follow from the phases.
    seed : int
        Seed of the random numbers, not negative; required. Each seed gives a different surface, and equal seeds give equal
        surfaces.

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
    def __new__(cls, /, *, rms_height: float | None = None, rms_slope: float | None = None, hurst: float | None = None, longest_wavelength: float | None = None, roll_off_wavelength: float | None = None, cut_off_wavelength: float | None = None, amplitudes: Amplitudes | str | None = None, cropped: bool = False, skewness: float | None = None, kurtosis: float | None = None, seed: int) -> SelfAffine: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def generate(self, /, grid: Grid) -> RoughSurface:
        """
        Generates the surface on a grid.

        Raises
        ------
        NotPositive, NotFinite, Hurst, BelowMinimum, NoWaveInBand, HeightMomentsNotReached, Memory
        """
    def generate_on(self, /, bodies: HalfSpace) -> Field:
        """
        Generates the heights on the grid of bodies (lengths).
        """

@final
class PvdWriter:
    """
    A time series of images for ParaView, listed in a PVD file. An existing file is replaced.

    Parameters
    ----------
    path : path_like
        The PVD file, whose name ends in ``.pvd``. The images are written to the same folder. Both are complete after each call of
        :meth:`write`, so that the writer needs no ``with`` and no ``close``.

    Raises
    ------
    ArgumentRange
        If the path does not end in ``.pvd``.
    """
    def __len__(self, /) -> int: ...
    def __new__(cls, /, path: str | PathLike[str]) -> PvdWriter: ...
    def __repr__(self, /) -> str: ...
    def write(self, /, time: float, fields: Any, *, grid: Grid | None = None) -> None:
        """
        Writes fields and vectors at a given time as :func:`stickslip.io.vti.write` does, and adds them to the list.
        """

@final
class Sensitivity:
    """
    Derivatives of a functional with respect to the input of a contact, at fixed sets of contact, stick and slip cells.

    A derivative is ``None`` if the problem does not have this input. Derivatives with respect to fields are per value of a
    cell, and zero outside the contact.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def contact_modulus(self, /) -> float | None:
        """
        Derivative with respect to the contact modulus E*, if all moduli of both bodies change in proportion at constant
        Poisson's ratios. ``None`` for steps of histories.
        """
    @property
    def friction(self, /) -> Field | None:
        """
        Derivative with respect to the coefficient of friction of each cell. It is zero in cells that do not slip, and in
        cells at the largest shear stress of the friction.
        """
    @property
    def friction_coefficient(self, /) -> float | None:
        """
        Derivative with respect to a uniform coefficient of friction, the sum over all cells.
        """
    @property
    def gap(self, /) -> Field | None:
        """
        Derivative with respect to the gap of each cell.
        """
    @property
    def normal_load(self, /) -> float | None:
        """
        Derivative with respect to the prescribed normal force or approach.
        """
    @property
    def poisson_ratio(self, /) -> tuple[float, float] | None:
        """
        Derivatives with respect to Poisson's ratio of each body at constant Young's moduli. ``None`` for coatings and
        kernels. For tangential and coupled contacts also ``None`` on ranks and without ``poisson_ratio=True``.
        """
    @property
    def pressure(self, /) -> Field | None:
        """
        Derivative with respect to the pressure of each cell, for a tangential contact.
        """
    @property
    def report(self, /) -> Report:
        """
        Termination and cost of the linear problem of this functional. The report excludes the responses to prescribed
        forces, which all functionals share. The time is not measured.
        """
    @property
    def tangential_load(self, /) -> tuple[float | None, float | None]:
        """
        Derivatives with respect to the prescribed loads along x and y: forces, shifts, or positions of the far ends of
        springs.
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns the numbers by name; a pair (x, y) becomes two numbers with the endings ``_x`` and ``_y``, and Poisson's
        ratios of the bodies have the endings ``_1`` and ``_2``. Fields are not included.
        """
    def to_series(self, /) -> Any:
        """
        Returns the numbers of :meth:`to_dict` as a series of pandas, which must be installed.
        """
    @property
    def twist(self, /) -> float | None:
        """
        Derivative with respect to the prescribed twist (per radian).
        """
    @property
    def value(self, /) -> float:
        """
        Value of the functional.
        """

@final
class Settings:
    """
    Method, tolerance and limits of an iteration. Every problem, solver and history accepts them together as ``settings``,
    or individually by the same keywords.

    Parameters
    ----------
    tolerance : float, default 1e-8
        Upper limit for the certified error in the energy norm, relative to the norm of the solution, and for the largest residual.
        A tolerance of 0.1 permits errors of forces, areas and stick ratios of tens of per cent, without a warning.
    method : Method or str, default "active_set"
        "active_set", or "polonsky_keer" for problems with one unknown per cell.
    max_iterations : int, default 10000
        Maximum number of conjugate-gradient steps.
    time_limit : float, optional
        Maximum wall time of a solve (s).

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
        Maximum number of conjugate-gradient steps.
        """
    @property
    def method(self, /) -> Method:
        """
        Method of the iteration.
        """
    @property
    def time_limit(self, /) -> float | None:
        """
        Maximum wall time (s), or ``None``.
        """
    @property
    def tolerance(self, /) -> float:
        """
        Tolerance of the error.
        """

@final
class SpencePressing:
    """
    The stick zone of bodies of different materials that are pressed together by a growing load alone.

    The surfaces slip inwards near the rim of the contact and stick within k times its radius or half-width. Shear does
    not change the pressure here (one-way coupling). Spence, J. Elasticity 5 (1975) 297, and for plane
    contacts Proc. Camb. Phil. Soc. 73 (1973) 249; Johnson (1985), section 5.4. The solution is created by :meth:`round` or
    :meth:`plane`.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @staticmethod
    def plane(pair: ElasticPair | tuple[Material, Material], friction: float) -> SpencePressing:
        """
        Returns the solution for a cylinder or strip in plane strain with this coefficient of friction (dimensionless, not
        negative).
        """
    @staticmethod
    def round(pair: ElasticPair | tuple[Material, Material], friction: float) -> SpencePressing:
        """
        Returns the solution for a body of revolution with this coefficient of friction (dimensionless, not negative).
        """
    @property
    def stick_radius(self, /) -> float:
        """
        Ratio k of the radius or half-width of the stick zone to that of the contact, in [0, 1]: one without coupling,
        zero without friction.
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
        Area of the spot (a length squared).
        """
    @property
    def cells(self, /) -> int:
        """
        Number of cells of the spot.
        """
    @property
    def centroid(self, /) -> tuple[float, float]:
        """
        Mean position of the cells (lengths).
        """
    @property
    def load(self, /) -> float:
        """
        Force that the spot carries.
        """
    @property
    def max_pressure(self, /) -> float:
        """
        Largest pressure in the spot.
        """
    @property
    def mean_pressure(self, /) -> float:
        """
        Ratio of load to area.
        """
    @property
    def perimeter(self, /) -> float:
        """
        Length of the edge of the spot along the sides of cells.
        """
    @property
    def stick_ratio(self, /) -> float | None:
        """
        Ratio of stick cells to all cells of the spot; ``None`` without a tangential contact.
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns the numbers by name; a pair (x, y) becomes two numbers with the endings ``_x`` and ``_y``. The numbers of
        an object with the same method have its name as the prefix.
        """
    def to_series(self, /) -> Any:
        """
        Returns the numbers of :meth:`to_dict` as a :class:`pandas.Series` (requires pandas).
        """

@final
class State:
    """
    A state of a history, which can be restored, continued or saved. It contains gap, friction and settings, but not
    the bodies. Arrays are read-only views of the memory of this object, except for the zones, which are read-only copies.
    Vectors are (x, y). The guide page ``embedding`` states the number of bytes per cell.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
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
        Boundary condition at the edge of the grid.
        """
    @property
    def contact(self, /) -> NDArray[bool_]:
        """
        Mask of the cells in contact, booleans of shape (ny, nx): cells with positive pressure. A read-only copy.
        """
    @property
    def coupling(self, /) -> Coupling:
        """
        Coupling between pressure and traction in the model.
        """
    @property
    def accumulated_dissipation(self, /) -> NDArray[float64]:
        """
        Energy that each cell dissipated in the steps since the start (not negative). The array contains its grid.
        """
    @property
    def friction(self, /) -> Friction:
        """
        The friction of the history.
        """
    @staticmethod
    def from_bytes(bytes: bytes | bytearray | memoryview) -> State:
        """
        Restores a state from its bytes.
        """
    @property
    def unit(self, /) -> str | None:
        """
        Unit of the gap of the history; ``None`` if it is not known. Bytes, files and pickles do not contain it.
        """
    @property
    def unloaded_gap(self, /) -> NDArray[float64]:
        """
        The gap before loading (lengths), as last set, plus the yielded depth.
        """
    @property
    def gap_as_set(self, /) -> NDArray[float64]:
        """
        The gap before loading (lengths), as last set, without the yielded depth; a read-only copy.
        """
    @property
    def grid(self, /) -> Grid:
        """
        Grid of the fields.
        """
    @property
    def hardness(self, /) -> Hardness | None:
        """
        The largest pressure of the cells; ``None`` if it is not limited.
        """
    @property
    def is_friction_new(self, /) -> bool:
        """
        Whether the friction limits in the contact have changed since the last step.
        """
    @property
    def is_pressure_stale(self, /) -> bool:
        """
        Whether the pressure was computed for an earlier gap.
        """
    @property
    def moment(self, /) -> float:
        """
        Moment about z, at the origin of the grid, on body 1 (a force times a length, positive from x to y).
        """
    @property
    def normal(self, /) -> NormalSolution:
        """
        The normal solution, which shares the memory of the state.
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
        Number of steps since the start.
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Ratio of stick cells to contact cells after the last step, zero without contact.
        """
    @property
    def tangential_force(self, /) -> tuple[float, float]:
        """
        Tangential force that body 2 exerts on body 1 along x and y.
        """
    def to_bytes(self, /) -> bytes:
        """
        Returns the state as bytes, which later versions of the same minor series (such as 0.1) can read.
        """
    @property
    def entry_rule(self, /) -> EntryRule:
        """
        Rule for the part of the motion of a step that a cell follows if it comes into contact within the step.
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
        Yielded depth of the surfaces since the start (lengths, not negative); ``None`` without a permanent set.
        """
    @property
    def zones(self, /) -> NDArray[uint8]:
        """
        Zone of each cell: 0 separated, 1 stick, 2 slip.

        The array also compares equal to the names of the zones; see :attr:`TangentialSolution.zones`.
        """

@final
class Statistics:
    """
    Height and slope parameters of a surface according to ISO 25178-2. Heights are relative to their mean, and are neither
    filtered nor levelled.

    Parameters
    ----------
    heights : Field or topography
        The heights (lengths). Missing heights (NaN) have no weight: slopes use pairs of measured neighbours, the developed
        area uses groups of four measured neighbours, and the spectral slope is NaN.

    Raises
    ------
    Sample, Undetermined, NotFinite

    Examples
    --------
    >>> import numpy as np, stickslip as ss
    >>> grid = ss.Grid.square(64, 64.0)
    >>> wave = ss.Field(grid, np.tile(2.0 * np.cos(2.0 * np.pi * grid.x / 8.0), (64, 1)))
    >>> found = ss.surface.Statistics(wave)
    >>> round(found.Sq, 6), round(found.Sku, 6), found.measured_points
    (1.414214, 1.5, 4096)
    """
    @property
    def Sa(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`arithmetic_mean_height`.
        """
    @property
    def Sdq(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`finite_difference_rms_slope`.
        """
    @property
    def Sdr(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`developed_area_ratio`.
        """
    @property
    def Sku(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`kurtosis`.
        """
    @property
    def Sp(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`highest_peak`.
        """
    @property
    def Sq(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`rms_height`.
        """
    @property
    def Ssk(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`skewness`.
        """
    @property
    def Sv(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`deepest_valley`.
        """
    @property
    def Sz(self, /) -> float:
        """
        ISO 25178-2 name of :attr:`height_range`.
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
        Root mean square gradient Sdq, from the differences of neighbouring heights along x and y.
        """
    @property
    def height_range(self, /) -> float:
        """
        Sum of the highest peak and the deepest valley, Sz (a length).
        """
    @property
    def highest_peak(self, /) -> float:
        """
        Highest peak Sp above the mean (a length).
        """
    @property
    def kurtosis(self, /) -> float:
        """
        Kurtosis Sku; 3 for Gaussian heights.
        """
    @property
    def mean_height(self, /) -> float:
        """
        Mean height (a length).
        """
    @property
    def measured_points(self, /) -> int:
        """
        Number of measured heights, on which the parameters are based.
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
        Root mean square slope from the spectrum, for a periodic surface.
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        Returns the numbers by name; a pair (x, y) becomes two numbers with the endings ``_x`` and ``_y``. The numbers of
        an object with the same method have its name as the prefix.
        """
    def to_series(self, /) -> Any:
        """
        Returns the numbers of :meth:`to_dict` as a :class:`pandas.Series` (requires pandas).
        """

@final
class StepErrorEstimate:
    """
    Difference between the result of one step and the result of the same load in two steps.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def dissipated_energy(self, /) -> float:
        """
        Difference of the dissipated energy.
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
        Sum of the magnitudes of the traction differences, relative to the sum of the friction limits.
        """

@final
class StepResult:
    """
    Results of a step of a history: numbers and fields. The fields are available as long as the step is the last step of
    the history, even if a later step fails. A restored state and a failed attempt of :class:`AdaptiveSteps` end this time.
    The method :meth:`keep` copies the fields permanently. Vectors are (x, y).
    """
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def approach(self, /) -> float:
        """
        Approach at the end of the step (a length).
        """
    @property
    def creepage(self, /) -> tuple[float, float] | None:
        """
        The creepages along x and y of a rolling step, prescribed or caused by the force (dimensionless); ``None`` without
        rolling.
        """
    @property
    def dissipation(self, /) -> NDArray[float64]:
        """
        Energy dissipated in each cell, from its traction at the end of the step (forces times lengths, not negative).
        """
    @property
    def energy(self, /) -> EnergyBalance:
        """
        Work, elastic energy and dissipation of the step.
        """
    @property
    def grid(self, /) -> Grid:
        """
        Grid of the fields.
        """
    @property
    def is_gross_slip(self, /) -> bool:
        """
        Whether the whole contact is at its friction limit.
        """
    def keep(self, /) -> StepResult:
        """
        Returns the same result with a copy of the fields, which remain available when the history continues.
        """
    @property
    def dissipation_midpoint(self, /) -> NDArray[float64]:
        """
        Energy dissipated in each cell, computed from the mean of its tractions before and after the step (forces times
        lengths). Its sum closes the energy balance; see :attr:`EnergyBalance.dissipated_energy_midpoint`.
        """
    @property
    def moment(self, /) -> float:
        """
        Moment about z at the end of the step (a force times a length, positive from x to y).
        """
    @property
    def normal_force(self, /) -> float:
        """
        Normal force at the end of the step.
        """
    @property
    def normal_report(self, /) -> Report | None:
        """
        Report of the normal solve; ``None`` if the pressure was held constant.
        """
    @property
    def shift(self, /) -> tuple[float, float]:
        """
        Shift at the end of the step since the start, along x and y (lengths): the rigid motion of body 2 relative to
        body 1.
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
        Ratio of stick cells to contact cells at the end of the step.
        """
    @property
    def tangential_force(self, /) -> tuple[float, float]:
        """
        Tangential force on body 1 along x and y at the end of the step.
        """
    @property
    def tangential_report(self, /) -> Report | None:
        """
        Report of the tangential solve; ``None`` before the first contact.
        """
    @property
    def twist(self, /) -> float:
        """
        Rotation at the end of the step (radians, positive from x to y).
        """
    @property
    def warnings(self, /) -> list[Warning]:
        """
        Warnings of the step: ``no_contact``, ``contact_at_edge``, ``beyond_hardness``, ``stale_pressure``,
        ``single_load_step``, ``held_shift_lost_force``, and the warnings about contacts and zones of too few cells. Warnings about contact spots
        are in ``history.normal.warnings``, because a step does not search for spots.
        """

@final
class Stress:
    """
    The symmetric stress tensor at a point (pressures), tensile positive, with z into body 1. Stresses can be added,
    subtracted and multiplied by numbers.

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
        Adds a stress.
        """
    def __eq__(self, value: object, /) -> bool: ...
    def __mul__(self, factor: object, /) -> Stress:
        """
        Multiplies the stress by a number.
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
        Subtracts a stress.
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
        Principal stresses with their directions.
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
    One influence coefficient for all distances between cells of a grid.

    Parameters
    ----------
    grid : Grid
        The cells.
    pair : ElasticPair or two Materials
        The two bodies.
    component : Component or str
        Direction of the displacement first, direction of the traction second.
    """
    def __new__(cls, /, grid: Grid, pair: ElasticPair | tuple[Material, Material], component: Component | str) -> Table: ...
    def __repr__(self, /) -> str: ...
    @property
    def component(self, /) -> Component:
        """
        Component of the table.
        """
    def get(self, /, i: int, j: int) -> float | None:
        """
        Returns the coefficient at a distance in cells along x and y, of either sign, or ``None`` outside the table.
        """
    @property
    def size(self, /) -> tuple[int, int]:
        """
        Number of distances along x and y, of one sign.
        """

@final
class TangentialEdges:
    """
    The edges of a contact in partial slip and of its stick zone.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def contact(self, /) -> Edges:
        """
        The edge of the contact.
        """
    @property
    def grid(self, /) -> Grid:
        """
        Grid of the cells.
        """
    @property
    def mean_traction(self, /) -> NDArray[float64]:
        """
        Means of the traction over the cells, shape (ny, nx).
        """
    @property
    def peak_traction(self, /) -> float:
        """
        The largest traction at the centre of a cell (a pressure).
        """
    @property
    def slip_area(self, /) -> float:
        """
        Contact area minus stick area.
        """
    @property
    def stick(self, /) -> Edges:
        """
        The edge of the stick zone.
        """
    @property
    def stick_area(self, /) -> float:
        """
        Area of the stick zone, with the covered parts of the cells at its edge (a length squared).
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Ratio of stick area to contact area.
        """
    @property
    def traction(self, /) -> NDArray[float64]:
        """
        Magnitude of the traction at the centres of the cells (a pressure), shape (ny, nx).
        """

@final
class TangentialLoad:
    """
    A tangential load from rest, given by at least one keyword.

    An axis without a keyword uses the same type of control as the other axis, with the value zero. The scalar model
    supports a load along one axis only; the vector model supports any load.

    Parameters
    ----------
    force, shift : pair of float, optional
        Components along x and y, of either sign: the force that body 2 exerts on body 1, or the shift (lengths).
        The shift is the rigid motion of body 2 relative to body 1 far from the contact, the relative rigid
        tangential displacement.
    spring : Spring, optional
        Springs along both axes that drag body 2: ``Spring(position=(x, y), stiffness=...)``, with the position of their far
        ends (lengths) and their stiffness (a force over a length, positive). The force is stiffness (position - shift).
    force_x, force_y, shift_x, shift_y : float, optional
        Force or shift along one axis.
    spring_x, spring_y : Spring, optional
        Spring along one axis: ``Spring(position=..., stiffness=...)``, with a length and a force over a length.
    twist : float, default 0
        Rotation of body 2 relative to body 1 about the origin of the grid (radians, positive from x to y). Only the
        vector model supports a twist.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, *, force: Sequence[float] | NDArray[Any] | None = None, shift: Sequence[float] | NDArray[Any] | None = None, spring: Spring | None = None, force_x: float | None = None, force_y: float | None = None, shift_x: float | None = None, shift_y: float | None = None, spring_x: Spring | None = None, spring_y: Spring | None = None, twist: float | None = None) -> TangentialLoad: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def control(self, /, axis: Axis | str) -> tuple[str, Any]:
        """
        Returns the control along an axis: ``("force", value)``, ``("shift", value)`` or
        ``("spring", Spring(position=..., stiffness=...))``.
        """

@final
class TangentialProblem:
    """
    Bodies, pressure, friction and tangential load of one monotonic step from the unsheared state.

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
        The tangential load; see :class:`TangentialLoad`. A load is required. With a relative displacement, the default is zero
        force.
    model : TangentialModel or str, default "scalar"
        "scalar" computes the traction along the axis of the load, "vector" both components. Give "vector" for bodies of different
        materials: with the coupling "one_way", "scalar" omits the tractions across the axis, and the stick radius of a pressed ball
        is then too large, several times for a small friction coefficient.
    coupling : Coupling or str, default "one_way"
        Coupling for bodies of different materials: "one_way" includes the tangential displacements due to pressure,
        "neglected" omits them. "full" raises ``CoupledMaterials`` for such bodies, because the pressure is given.
        A :class:`CoupledProblem` or a history with the coupling "full" accepts them. Bodies of
        the same material are not coupled, and accept every value.
    relative_displacement : RelativeDisplacement, optional
        A displacement of body 1 relative to body 2 that is not caused by the contact. It grows proportionally to the
        load; none by default.
    settings : Settings, optional
        Method, tolerance and limits; ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        See :class:`Settings`; these arguments take precedence over ``settings``.

    Raises
    ------
    NotConverged, Sample, GridMismatch, BoundaryMismatch, MaterialMismatch, CoupledMaterials, ObliqueLoad, UnsupportedByModel,
    NotFinite, EmptyContact, BeyondFrictionCapacity, Tolerance, IterationLimit
    ValueError
        If the units of the gap of the normal solution and of the relative displacement differ.

    Examples
    --------
    >>> import stickslip
    >>> grid = stickslip.Grid.square(64, 0.3e-3)
    >>> steel = stickslip.Material(213e9, 0.29)
    >>> bodies = stickslip.HalfSpace(grid, (steel, steel))
    >>> ball = stickslip.surface.sphere(grid, 3.5e-3)
    >>> normal = stickslip.NormalProblem(bodies, ball, force=100.0).solve()
    >>> shear = stickslip.TangentialProblem(bodies, normal, 0.5, force_x=20.0).solve()
    >>> hertz = stickslip.analytical.HertzSphere(bodies.pair, radius=3.5e-3, load=100.0)
    >>> exact = stickslip.analytical.CattaneoMindlin(hertz, friction=0.5, force=20.0)
    >>> abs(shear.stick_ratio - exact.stick_ratio) < 0.02
    True
    """
    def __getnewargs_ex__(self, /) -> tuple[tuple[Any, ...], dict[str, Any]]: ...
    def __new__(cls, /, bodies: HalfSpace, pressure: NormalSolution | Field | ArrayLike, friction: Friction | float | ArrayLike, load: TangentialLoad | None = None, *, force: Sequence[float] | NDArray[Any] | None = None, shift: Sequence[float] | NDArray[Any] | None = None, spring: Spring | None = None, force_x: float | None = None, force_y: float | None = None, shift_x: float | None = None, shift_y: float | None = None, spring_x: Spring | None = None, spring_y: Spring | None = None, twist: float | None = None, model: TangentialModel | str | None = None, coupling: Coupling | str | None = None, relative_displacement: RelativeDisplacement | None = None, settings: Settings | None = None, tolerance: float | None = None, method: Method | str | None = None, max_iterations: int | None = None, time_limit: float | None = None) -> TangentialProblem: ...
    def __repr__(self, /) -> str: ...
    @property
    def friction_capacity(self, /) -> float:
        """
        Largest tangential force that friction can carry: the integral of the friction limit.
        """
    def solve(self, /, *, progress: Any | None = None, warn: bool = True) -> TangentialSolution:
        """
        Solves the problem once; see :meth:`NormalProblem.solve`. The warnings that the normal solution also has are not issued
        again; the attribute ``warnings`` of the result lists them.
        """
    def solver(self, /) -> TangentialSolver:
        """
        Returns a solver of this problem, which keeps its buffers and starts each solve from the last solution.
        """

@final
class TangentialSolution:
    """
    Traction, slip, zones and shift of a tangential contact. Vectors are (x, y); in the scalar model, the component across
    the load is zero. Arrays are read-only views of the memory of this object, except for the zones, which are read-only copies. Two
    objects are equal if their solutions are equal, even if the iterations differed.
    """
    def __eq__(self, other: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def axis(self, /) -> Axis | None:
        """
        The axis of the load in the scalar model; ``None`` in the vector model.
        """
    @property
    def boundary(self, /) -> Boundary:
        """
        Boundary condition at the edge of the grid.
        """
    @property
    def cell_value(self, /) -> CellValue:
        """
        Meaning of the value of a cell.
        """
    @property
    def discretisation_estimate(self, /) -> float | None:
        """
        Estimate of the discretisation error of the tractions: the sum over the cells of the magnitudes of the differences
        from the exact means, relative to the sum of the magnitudes of the tractions; ``None`` without traction, or for
        one slab of a distributed grid.
        """
    def displacement(self, /, bodies: HalfSpace) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Computes the displacement of body 1 relative to body 2 due to the tractions along x and y, for all cells
        (lengths). The cost is one product.
        """
    @property
    def dissipated_energy(self, /) -> float:
        """
        Energy dissipated by the step (a force times a length), not negative.
        """
    def edges(self, /, normal: NormalSolution, friction: Friction | float | ArrayLike) -> TangentialEdges:
        """
        Returns the edges of the contact and of the stick zone inside the cells, for the pressure and the friction of the
        problem.

        Raises
        ------
        OutdatedSolution
            If this solution was computed for a different pressure or friction.
        MaterialMismatch
            If the materials differ.
        """
    def elastic_energy(self, /, bodies: HalfSpace) -> float:
        """
        Computes the elastic energy of shear (a force times a length). The cost is one product.
        """
    @property
    def force(self, /) -> tuple[float, float]:
        """
        Tangential force that body 2 exerts on body 1 along x and y.
        """
    @property
    def grid(self, /) -> Grid:
        """
        Grid of the fields.
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
        Termination, cost and error bound of the solve.
        """
    @property
    def shift(self, /) -> tuple[float, float]:
        """
        Shift along x and y (lengths): the rigid motion of body 2 relative to body 1 far from the contact, with the sign
        of the force.
        """
    @property
    def slip(self, /) -> tuple[NDArray[float64], NDArray[float64]]:
        """
        Slip of the surface of body 1 over the surface of body 2 along x and y (lengths); exactly zero in stick cells.
        """
    @property
    def slip_area(self, /) -> float:
        """
        Area of the slip zone, from counting cells.
        """
    def spots(self, /, normal: NormalSolution) -> ContactSpots:
        """
        Returns the contact spots of the underlying normal contact, with their stick ratios.

        Raises
        ------
        OutdatedSolution
            If this solution was computed for a different pressure.
        MaterialMismatch
            If the materials differ.
        """
    @property
    def stick_area(self, /) -> float:
        """
        Area of the stick zone, from counting cells.
        """
    @property
    def stick_ratio(self, /) -> float:
        """
        Ratio of stick area to contact area, from counting cells.
        """
    def stiffness(self, /, bodies: HalfSpace) -> TangentialStiffness:
        """
        Computes the tangential stiffness, for continued loading and at reversal.
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
        Warnings about a result that might mislead; empty if there are none.
        """
    @property
    def zones(self, /) -> NDArray[uint8]:
        """
        Zone of each cell, a uint8 array of shape (ny, nx) with the values of :class:`Zone`: 0 separated, 1 stick, 2 slip.

        The array compares equal to these numbers, to members of :class:`Zone` and to their names: ``zones == "stick"`` is the
        mask of the stick zone.
        """

@final
class TangentialSolver:
    """
    Solves tangential contacts repeatedly, each time from the last solution; created by :meth:`TangentialProblem.solver`.
    Load, friction and pressure may change between calls. Slip is not carried over from one solve to the next.
    """
    def __new__(cls, /, *_arguments: Any, **_options: Any) -> TangentialSolver: ...
    def __repr__(self, /) -> str: ...
    @property
    def friction(self, /) -> Friction:
        """
        The friction of the next solve, as last set, with its ``max_shear_stress``.
        """
    @property
    def friction_capacity(self, /) -> float:
        """
        Largest tangential force that friction can carry: the integral of the friction limit.
        """
    def reset(self, /) -> None:
        """
        Discards the last solution, so that the next solve starts like the first.
        """
    def sensitivities(self, /, solution: TangentialSolution, functionals: Sequence[Functional], *, tolerance: float | None = None, poisson_ratio: bool = False) -> list[Sensitivity]:
        """
        Computes the sensitivities of several functionals, in their order. They share the responses to prescribed
        forces. The options and the exceptions are those of :meth:`sensitivity`.
        """
    def sensitivity(self, /, solution: TangentialSolution, functional: Functional, *, tolerance: float | None = None, poisson_ratio: bool = False) -> Sensitivity:
        """
        Computes the derivatives of a functional with respect to the input of the problem: gap, loads, friction and
        moduli.

        The derivatives of all cells together cost about one linear solve on the contact cells (the adjoint). The
        sets of contact, stick and slip cells are constant in the derivatives.

        Parameters
        ----------
        solution : TangentialSolution
            The solution of the present problem of this solver.
        functional : Functional
            The functional; see :class:`stickslip.sensitivity.Functional`.
        tolerance : float, optional
            Relative residual at which a linear problem counts as solved; 1e-11 by default.
        poisson_ratio : bool, default False
            Whether to compute the derivatives with respect to Poisson's ratios of tangential and coupled contacts,
            which require further operators. Normal contacts always have them.

        Returns
        -------
        Sensitivity

        Raises
        ------
        GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch
            If the solution belongs to other bodies, or if weights have a different grid.
        UnsupportedByModel
            If the functional depends on a quantity that the problem does not have.
        BelowMinimum, Sample, NotPositive, Tolerance
            If a number of the functional or the tolerance is invalid.
        EmptyContact
            If no cell carries pressure under a prescribed force.
        NotFinite
            If a number of the functional is not finite, if a periodic contact is closed everywhere, or if the contact
            cannot resist a change of the prescribed force, as in sliding.
        NotConverged
            If the solution has not converged, or if a linear solve fails.
        """
    def set_friction(self, /, friction: Friction | float | ArrayLike) -> None:
        """
        Sets the friction of the next solve. A law or a coefficient replaces the last law, with its ``max_shear_stress``. A
        coefficient alone has none; a warning is issued if the last law had one.
        """
    def set_pressure(self, /, pressure: NormalSolution | Field | ArrayLike) -> None:
        """
        Sets the pressure of the next solve.

        Raises
        ------
        ValueError
            If the unit of its gap differs from that of the earlier gaps or of the relative displacement.
        """
    def set_relative_displacement(self, /, relative: RelativeDisplacement) -> None:
        """
        Sets the relative displacement of the next solve.

        Raises
        ------
        GridMismatch
        ValueError
            If its unit differs from that of the earlier relative displacements or of the gap of the normal solution.
        """
    @property
    def settings(self, /) -> Settings:
        """
        Settings of the next solve; assignable.
        """
    @settings.setter
    def settings(self, /, settings: Settings) -> None: ...
    def solve(self, /, load: TangentialLoad | None = None, *, force: Sequence[float] | NDArray[Any] | None = None, shift: Sequence[float] | NDArray[Any] | None = None, spring: Spring | None = None, force_x: float | None = None, force_y: float | None = None, shift_x: float | None = None, shift_y: float | None = None, spring_x: Spring | None = None, spring_y: Spring | None = None, twist: float | None = None, progress: Any | None = None, warn: bool = True) -> TangentialSolution:
        """
        Solves for the given load. Omitted arguments keep their last values.

        The arguments set the problem of the solver. They remain set if the solve fails or is cancelled; invalid arguments
        leave it unchanged.

        Parameters
        ----------
        load, force, shift, spring, force_x, ..., twist : optional
            See :class:`TangentialProblem`. A force, shift or spring along an axis replaces the last one along that axis only, and a
            twist replaces the last twist. A ``load`` replaces all of them.
        progress, warn : optional
            See :meth:`NormalProblem.solve`.

        Returns
        -------
        TangentialSolution

        Raises
        ------
        NotFinite, NotPositive, ObliqueLoad, UnsupportedByModel, BeyondFrictionCapacity
            If the load is invalid; it is then unchanged.
        NotConverged
            The exception has the attributes ``report`` and ``last_iterate``.
        """

@final
class TangentialStiffness:
    """
    Derivatives of the tangential forces along x and y and of the moment (rows) with respect to the shifts along x
    and y and the twist (columns), for continued loading and at its reversal. The sets of stick and slip cells are
    fixed, and the pressure is constant unless it is solved simultaneously. The first two rows and columns are
    forces over lengths; the last diagonal entry is a moment over radians, and the other entries are forces over
    radians. An entry is NaN if the model does not have the load or the motion. Such entries are those of the
    direction across the axis and of the twist in the scalar model, and of the twist on periodic grids.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def bound(self, /) -> float:
        """
        Bound on the errors, relative to the square root of the product of the diagonal entries of the row and the
        column, for the twist about the centre of the contact; infinite if pressure and traction are solved
        simultaneously. It excludes the effect of errors of pressure and traction.
        """
    @property
    def loading(self, /) -> list[list[float]]:
        """
        Derivative of the forces of the last step with respect to the motions at its end, if the motion continues in its
        direction. Stick cells follow the motion, and slip cells stay at their friction limit. In the vector model the
        traction of slip cells turns with the slip. On a ball under a constant normal load, the derivative is 8 G* a (1
        - F / (mu W))^(1/3) (Cattaneo and Mindlin).

        Cells that came into contact in the step follow the motion only partially. After a step that presses a ball from
        zero load, the derivative is about two thirds of Mindlin's stiffness 8 G* a, although all cells stick.
        ``history.stiffness(next_step=True)`` computes the derivative for the next step, in which these cells resist
        fully.
        """
    @property
    def reversal(self, /) -> list[list[float]]:
        """
        Derivative for a reversal of the motion, at which all contact cells stick. For a circular contact it is
        Mindlin's stiffness 8 G* a.
        """
    def in_series_with(self, /, springs: Sequence[float] | NDArray[Any]) -> TangentialStiffness:
        """
        Returns the stiffness in series with springs along x and y (forces over lengths).
        """

@final
class Tensor:
    """
    The nine influence coefficients at a point, with the direction of the displacement first and that of the traction
    second (lengths over pressures).
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __repr__(self, /) -> str: ...
    @property
    def rows(self, /) -> list[list[float]]:
        """
        The coefficients as rows; the row is the direction of the displacement.
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
    Operator that computes displacements along x, y and z from tractions along x, y and z; created by
    :meth:`HalfSpace.tensor_operator`. One thread at a time may use it.
    """
    def __repr__(self, /) -> str: ...
    def apply(self, /, tractions: Sequence[Any]) -> tuple[NDArray[float64], NDArray[float64], NDArray[float64]]:
        """
        Applies the operator to three arrays that are read in place: tractions along x, y and z (pressures). Returns the
        displacements along x, y and z (lengths).
        """
    @property
    def cells(self, /) -> int:
        """
        Number of cells of each component.
        """

@final
class VermeulenJohnson:
    """
    Creep forces of an elliptic contact that rolls along x without spin, from the creep curve of Vermeulen and Johnson
    with the initial slope of Kalker.

    Let f be the force without slip, from :class:`KalkerCoefficients`, and x = |f| / (mu P). The force along f has the
    magnitude mu P (1 - (1 - x/3)^3), and mu P for x of 3 or more. The force of this approximation is a few per cent
    below the computed force. The solution is valid for equal bodies and for bodies whose Dundurs' beta is zero. Vermeulen and
    Johnson (1964); Johnson (1985), section 8.4.

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
    def __new__(cls, /, hertz: HertzEllipse, *, friction: float, creepage: Sequence[float] | NDArray[Any]) -> VermeulenJohnson: ...
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
        Ratio x of the force without slip to the friction limit (dimensionless); 3 or more if the whole contact slips.
        """

@final
class Warning:
    """
    A warning about a converged solution that might mislead.

    The attribute ``kind`` is the name of the warning: ``no_contact``, ``contact_at_edge``, ``unresolved_spots``,
    ``single_row_of_cells``, ``contact_spans_grid``, ``beyond_hardness``, ``stale_pressure``, ``underresolved_contact``,
    ``underresolved_stick_zone``, ``underresolved_slip_zone``, ``single_load_step``, ``stress_at_edge``,
    ``discretisation_error``, ``approach_beyond_grid``, ``shift_beyond_grid``,
    ``large_bulk_strain``, ``large_twist``, ``large_creepage``, ``large_friction``, ``low_hardness``,
    ``hardness_beyond_modulus``, ``low_shear_stress``, ``shear_stress_beyond_modulus``, ``low_pressure``,
    ``large_gap_change``, ``closed_gap``, ``negative_wear``, ``large_contact_radius``, ``pressure_beyond_modulus``, ``periodic_seam``,
    ``not_converged``, ``steep_surface``, ``held_shift_lost_force``, ``unused_relative_displacement``,
    ``repeated_loop``, ``open_cycle``, ``neglected_lift``, ``neglected_traction``, ``coating_beyond_grid``,
    ``coating_below_cell`` or ``accuracy_not_reached``. The names of the warnings of a solution are ``[warning.kind
    for warning in solution.warnings]``. A comparison of a warning with a string raises a ``ValueError``.
    """
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self, /) -> int:
        """
        Equal warnings have equal hashes.
        """
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    def __str__(self, /) -> str: ...
    @property
    def cells(self, /) -> int | None:
        """
        Number of affected cells; ``None`` if the warning does not count cells.
        """
    @property
    def kind(self, /) -> str:
        """
        Name of the warning.
        """
    @property
    def message(self, /) -> str:
        """
        Text of the warning, with a remedy.
        """

@final
class WaveResponse:
    """
    Displacements of the surface of two bodies under a wave of traction (lengths over pressures), returned by
    :meth:`ElasticPair.response <stickslip.ElasticPair.response>`.
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __repr__(self, /) -> str: ...
    @property
    def across(self, /) -> float:
        """
        Tangential displacement across the wave vector due to traction across it.
        """
    @property
    def along(self, /) -> float:
        """
        Tangential displacement along the wave vector due to traction along it.
        """
    @property
    def coupling(self, /) -> float:
        """
        Normal displacement due to traction along the wave vector, and displacement along the wave vector due to pressure,
        up to a factor i.
        """
    @property
    def normal(self, /) -> float:
        """
        Normal displacement due to pressure.
        """

@final
class Westergaard:
    """
    A surface with waves along x that is pressed on a half-space, in plane strain.

    The gap is amplitude (1 - cos(2 pi x / lambda)), with the wavelength lambda. Contact forms strips of half-width
    a about every crest, up to the pressure p* of full contact. Westergaard (1939); Johnson (1985), section 13.2.

    Parameters
    ----------
    pair : ElasticPair or two Materials
        The bodies.
    amplitude : float
        Amplitude of the waves, half their height (a length), positive.
    wavelength : float
        Wavelength lambda (a length), positive.
    mean_pressure : float
        Ratio of the load to the nominal area, positive.

    Raises
    ------
    NotPositive
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, pair: ElasticPair | tuple[Material, Material], *, amplitude: float, wavelength: float, mean_pressure: float) -> Westergaard: ...
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
        Approach of the mean planes of the two surfaces since first touch (a length): amplitude R (1 - ln(R)) with R =
        mean_pressure / p*; in full contact, the amplitude.
        """
    @property
    def contact_fraction(self, /) -> float:
        """
        Fraction of the nominal area in contact, 2 a / lambda.
        """
    @property
    def contact_half_width(self, /) -> float:
        """
        Half-width of a contact strip, a = (lambda/pi) arcsin(sqrt(mean_pressure / p*)) (a length); half the
        wavelength in full contact.
        """
    @property
    def full_contact_pressure(self, /) -> float:
        """
        Lowest mean pressure of full contact, p* = pi E* amplitude / lambda.
        """
    def gap(self, /, x: ArrayLike) -> Any:
        """
        Returns the gap between the surfaces (a length) at the distance x from a crest; zero in the contact, positive
        outside.
        """
    @property
    def is_full_contact(self, /) -> bool:
        """
        Whether the surfaces touch everywhere, that is, whether the mean pressure is at least p*.
        """
    @property
    def max_pressure(self, /) -> float:
        """
        Pressure at the crests: 2 sqrt(mean_pressure p*); in full contact mean_pressure + p*.
        """
    @property
    def mean_pressure(self, /) -> float:
        """
        Mean pressure, the ratio of the load to the nominal area.
        """
    @property
    def pair(self, /) -> ElasticPair:
        """
        The bodies.
        """
    def pressure(self, /, x: ArrayLike) -> Any:
        """
        Returns the pressure at the distance x from a crest: 2 p* cos(pi x / lambda) sqrt(sin^2(pi a / lambda) -
        sin^2(pi x / lambda)), zero outside the contact; in full contact mean_pressure + p* cos(2 pi x / lambda).
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

    The traction is mu times the difference between the pressure and the pressure under 1 - f of the load, with f =
    |mean_traction| / (mu mean_pressure). The contact strips under 1 - f of the load stick. A full contact sticks
    everywhere, under a uniform traction, as long as 1 - f of the load causes full contact. The solution is exact for
    every nu, except that the coupling between pressure and traction of dissimilar bodies is neglected. Ciavarella,
    Int. J. Solids Struct. 35 (1998) 2349; Jaeger, J. Tribology 120 (1998) 677.

    Parameters
    ----------
    contact : Westergaard
        The normal contact.
    friction : float
        Coefficient of friction mu (dimensionless), not negative.
    mean_traction : float
        Tangential force on body 1 along x per nominal area, of either sign, at most mu mean_pressure.

    Raises
    ------
    NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
    """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __new__(cls, /, contact: Westergaard, *, friction: float, mean_traction: float) -> WestergaardPartialSlip: ...
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
        Mean traction on body 1, positive along +x: the tangential force per nominal area.
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
        Returns the traction on body 1 along x (a pressure, with the sign of the mean traction) at the distance x from
        a crest, or zero outside the contact.
        """

@final
class WithoutOutliers:
    """
    A surface without its outliers.
    """
    def __array__(self, /, dtype: Any | None = None, copy: bool | None = None) -> Any: ...
    def __array_function__(self, /, function: Any, _types: Any, arguments: Any, options: dict[str, Any]) -> Any:
        """
        Implements other NumPy functions of the heights, in the same way.
        """
    def __array_ufunc__(self, /, ufunc: Any, method: str, *inputs: Any, **kwargs: Any) -> Any:
        """
        Implements NumPy functions of the heights. Operands of different units are rejected.
        """
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, tuple[str, str, bytes]]: ...
    def __repr__(self, /) -> str: ...
    @property
    def heights(self, /) -> Field:
        """
        The heights (lengths), with NaN at the outliers; missing heights remain missing.
        """
    def interpolated(self, /) -> Field:
        """
        Returns the heights (lengths) with interpolated heights at the outliers, as by :func:`fill_missing`. Heights that were
        missing before remain missing.

        Raises
        ------
        Undetermined
            If no measured height remains.
        NotConverged
        """
    @property
    def outlier_cells(self, /) -> int:
        """
        Number of outliers.
        """
    @property
    def outliers(self, /) -> NDArray[bool_]:
        """
        Mask of the outliers, booleans of shape (ny, nx).
        """

def _from_bytes(kind: type, *arguments: Any) -> Any:
    """
    Restores objects with their own byte format; called by pickle.
    """

def _restore(kind: str, version: str, bytes: bytes) -> Any:
    """
    Restores an object; called by pickle. A pickle can only be read by the version that wrote it. Histories have
    their own byte format, which later versions can also read.
    """

def archard(coefficient: Field | ArrayLike, pressure: Field | ArrayLike, slip_distance: Field | ArrayLike, *, depth: Field | ArrayLike | None = None, grid: Grid | None = None) -> NDArray[float64]:
    """
    Computes the wear depth by Archard's law, ``coefficient * pressure * slip_distance`` (lengths).

    Parameters
    ----------
    coefficient : float, Field or array_like of shape (ny, nx)
        Volume removed per normal force and sliding distance, of one body or of both together (one over a pressure, 1/Pa in SI
        units; 1 mm3/(N m) is 1e-9 1/Pa), not negative.
    pressure, slip_distance : Field or array_like of shape (ny, nx)
        Pressure, and the length of the slip path of each cell under this pressure (lengths), not negative, in a step or a
        cycle.
    depth : Field or array_like of shape (ny, nx), optional
        Depth removed earlier (lengths), to which the result is added; zero by default.
    grid : Grid, optional
        The grid of arrays; not required, because the law does not depend on the size of the cells.

    Returns
    -------
    ndarray of shape (ny, nx)
        Wear depths (lengths).

    Raises
    ------
    NegativeOrNotFinite, Sample, GridMismatch, NotFinite
    Shape
        If an array does not have one entry per cell. A single number, such as a total energy, is rejected too.
    ValueError
        If the units of the slip and of the earlier depth differ.
    TypeError
        If the pressure or the slip is an array of the energies of cells.
    """

def asc_parse(bytes: bytes | bytearray | memoryview) -> Field:
    """
    Reads a surface from the bytes of an ASC file (lengths in metres).
    """

def asc_read(path: str | PathLike[str]) -> Field:
    """
    Reads a surface from an ASC file (lengths in metres).
    """

def at_points(bodies: HalfSpace, body: Body | str, tractions: Any, points: ArrayLike, *, uniform_stress: Stress | None = None) -> PointResults:
    """
    Computes stress and displacement at points of a body without a coating, by summing over all cells. If there are more
    than 2048 loaded cells and more than three points, distant cells are summed in blocks. For coated bodies, and on grids
    that are periodic along x and y, use :class:`Planes`.

    The tractions are uniform on each cell. Values at depth zero are the limits from inside the body.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    body : Body or str
        "one" or "two".
    tractions : solution, (normal, shear), State, History, array_like or (array_like, (array_like, array_like))
        The tractions of a solution of any kind or of a pair of a normal and a tangential solution, or fields: a pressure,
        or a pressure and the tractions along x and y.
    points : array_like of shape (n, 3)
        Points ``(x, y, depth)`` (lengths), with the depth below the surface of the body. The columns of a table of pandas are
        recognised by these names.
    uniform_stress : Stress, optional
        A uniform stress of the body, such as a bulk stress, which is added to the stress of the tractions everywhere;
        none by default. Displacements are due to the tractions only.

    Returns
    -------
    PointResults
        The results at the points, as a sequence and as arrays.

    Raises
    ------
    Sample, GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch, RigidBody, Memory, Ranks
    UnsupportedForCoatings
        If the body is coated.
    DivergentPeriodicSum
        If the grid is periodic along x and y.
    """

def bisinusoidal(grid: Grid, amplitude: float, wavelengths: Sequence[float] | NDArray[Any]) -> Field:
    """
    Returns the gap ``amplitude * (1 - cos(2 pi x / wavelengths[0]) * cos(2 pi y / wavelengths[1]))`` under a product
    of waves (lengths), zero on its crests.
    """

def cone(grid: Grid, slope: float) -> Field:
    """
    Returns the gap ``slope * r`` under a cone; the slope is the tangent of the angle between cone and plane.
    """

def crop(heights: Field | ArrayLike, columns: tuple[int, int], rows: tuple[int, int]) -> Field:
    """
    Returns the part of a surface in the half-open ranges of columns ``columns[0]`` to ``columns[1]`` and of rows
    ``rows[0]`` to ``rows[1]``, on a separate grid centred on the origin.

    Raises
    ------
    Range
    """

def csv_parse(bytes: bytes | bytearray | memoryview, *, cell: Sequence[float] | NDArray[Any] | None = None, size: Sequence[float] | NDArray[Any] | None = None, missing: float | None = None, skip_rows: int = 0, skip_columns: int = 0, without_labels: bool = False, unit: str | None = None, height_unit: str | None = None) -> Field:
    """
    Reads a field from the bytes of a text file that contains a matrix; see :func:`read`. The bytes of a compressed file are
    ``gzip.open(path).read()``.
    """

def csv_read(path: str | PathLike[str], *, cell: Sequence[float] | NDArray[Any] | None = None, size: Sequence[float] | NDArray[Any] | None = None, missing: float | None = None, skip_rows: int = 0, skip_columns: int = 0, without_labels: bool = False, unit: str | None = None, height_unit: str | None = None) -> Field:
    """
    Reads a field from a text file that contains a matrix.

    A cell is missing (NaN) if it is empty, consists of stars, or is one of these words in upper or lower case: ``nan``,
    ``BAD``, ``No Data``, ``no_data``, ``no-data``, ``N/A``, ``#N/A``, ``NA``, ``null``, ``none``, ``void``, ``invalid``,
    ``missing`` and ``--``. Any other text is rejected with its line and column. Numbers may be in quotes.
    Numbers that may be labels are also rejected: a first row or column 0, 1, 2, ..., also as 0.0, 1.0, 2.0, ... next to
    other decimals, and evenly spaced coordinates in the first row and column. Nine or more coordinates in the first row or
    column alone are also rejected, unless another row or column is evenly spaced, as on an inclined surface. Fewer
    coordinates are read as heights: skip them by ``skip_rows=1`` or ``skip_columns=1``.

    Parameters
    ----------
    path : path_like
        The file.
    cell, size : pair of float
        Side lengths of a cell or of the grid; exactly one of the two is required.
    missing : float, optional
        The value that marks a missing point (default: the value that a comment states, or none). Other values that may be
        such marks, as -9999 or any magnitude from 1e30, are rejected; NaN states that all numbers are heights. Read a file with
        several marks in this way, and replace the marks in its array. The comment consists of
        a name, then ``=``, ``:`` or a space, and a number, as ``# NODATA_value -9999``. The name is ``missing``, ``missing
        value``, ``no data``, ``no data value``, ``bad value``, ``invalid value``, ``void`` or ``void value``, in upper or
        lower case, with any separators between words or none.
    skip_rows : int, default 0
        Number of rows before the matrix.
    skip_columns : int, default 0
        Number of columns to skip at the start of each row, such as names or row numbers.
    without_labels : bool, default False
        Whether a first row or column with numbers that may be labels contains heights; if not, it is rejected.
    unit : str, optional
        The unit of the lengths of the file, which the surface keeps, such as ``"um"``.
    height_unit : str, optional
        The unit of the heights of the file, if it differs; the heights are converted to ``unit``.

    Raises
    ------
    File, Format, NotPositive
    ValueError
        If a name is not a unit of length, or if the header of the file states another unit, as ``# Z[nm]``.
    TypeError
        If ``height_unit`` is given without ``unit``.
    """

def csv_to_bytes(field: Field | ArrayLike) -> bytes:
    """
    Returns a field as the text of a matrix, without its unit and cell sides.
    """

def csv_write(path: str | PathLike[str], field: Field | ArrayLike) -> None:
    """
    Writes a field to a text file as a matrix. The file contains neither the unit nor the cell sides: give them again on reading
    by ``unit=`` and ``cell=``.
    """

def cylinder(grid: Grid, radius: float) -> Field:
    """
    Returns the gap ``x^2 / (2 radius)`` under a cylinder of this radius (a length) whose axis is along y.
    """

def ellipsoid(grid: Grid, radius_x: float, radius_y: float) -> Field:
    """
    Returns the gap ``x^2 / (2 radius_x) + y^2 / (2 radius_y)`` under a paraboloid with these radii of curvature
    (lengths).
    """

def energy(coefficient: Field | ArrayLike, energy: Field | ArrayLike, *, depth: Field | ArrayLike | None = None, grid: Grid | None = None) -> NDArray[float64]:
    """
    Computes the wear depth by the energy law, ``coefficient * energy / cell area`` (lengths).

    Parameters
    ----------
    coefficient : float, Field or array_like of shape (ny, nx)
        Volume removed per dissipated energy, of one body or of both together (one over a pressure, 1/Pa in SI units; 1 mm3/J
        is 1e-9 1/Pa), not negative.
    energy : Field or array_like of shape (ny, nx)
        Energy dissipated in each cell in a step or a cycle (forces times lengths), not negative.
    depth : optional
        See :func:`archard`.
    grid : Grid, optional
        Grid that gives the area of a cell. It is required for an array that does not contain its grid. The dissipation of a
        cycle, a step, a history and a state contains it; a grid with other cells is then rejected.

    Returns
    -------
    ndarray of shape (ny, nx)
        Wear depths (lengths).

    Raises
    ------
    NegativeOrNotFinite, Sample, GridMismatch, NotFinite
    Shape
        If an array does not have one entry per cell. A single number, such as a total energy, is rejected too.
    ValueError
        If the units of the energies and of the earlier depth differ.
    TypeError
        If an array contains energies per area.
    """

def fill_missing(heights: Field | ArrayLike) -> Filled:
    """
    Fills missing heights, which are NaN, with the smoothest surface through the rim of each hole (Laplace's equation).

    Raises
    ------
    Sample
        If a height is infinite.
    Undetermined
        If all heights are missing.
    NotConverged
    """

def flat_punch(grid: Grid, radius: float, recess: float) -> Field:
    """
    Returns the gap under a flat punch of this radius: zero in cells whose centre is below the punch, and the recess
    in all other cells (lengths). The recess only has to be deeper than the displacements.
    """

def gap_between(upper: Field | ArrayLike, lower: Field | ArrayLike) -> Field:
    """
    Returns the gap between two rough bodies that touch at one point. Heights are positive outwards from their body; both
    surfaces are given as viewed from body 1. Both surfaces must have the same unit.
    """

def gap_from_heights(heights: Field | ArrayLike) -> Field:
    """
    Returns the gap of a rough body against a flat body: the largest height minus each height (lengths, non-negative).
    """

def gaussian_filter(heights: Field | ArrayLike, *, s: float | None = None, l: float | None = None, periodic: bool = False, along: str = "xy") -> Filtered:
    """
    Removes short waves, long waves or both from a surface with Gaussian filters (ISO 16610-61; along lines ISO 16610-21).

    The mean of a filter transmits half of a wave whose length equals the nesting index, and the fraction
    2^(-(index/length)^2) of a wave of any other length. Missing heights (NaN) have no weight and remain missing;
    therefore filter before :func:`fill_missing`. Near an edge or a hole, the mean is taken over the existing heights;
    heights within half a nesting index of the edge or hole are affected. Level the surface before filtering.

    Parameters
    ----------
    heights : Field or topography
        The heights (lengths).
    s, l : float, optional
        Nesting indices, that is, cut-off wavelengths (lengths). The S filter removes shorter waves, such as noise; the L
        filter removes longer waves, the waviness. With both, the result is the S-L surface.
    periodic : bool, default False
        Whether the surface continues periodically beyond its edges.
    along : "xy", "x" or "y", default "xy"
        Whether heights are averaged over the area ("xy") or along one axis only.

    Raises
    ------
    NotPositive, BelowMinimum
        If a nesting index is not positive, shorter than two cells or longer than the surface, or if the index of the S
        filter exceeds the index of the L filter.
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
    Returns the identity operator.
    """

def inverted(heights: Field | ArrayLike) -> Field:
    """
    Returns the heights turned upside down (lengths).
    """

def level(heights: Field | ArrayLike, form: Any) -> Levelled:
    """
    Removes a form from a surface by least squares.

    Parameters
    ----------
    heights : Field or topography
        The heights (lengths).
    form : "mean", "plane" or int
        The form; a number is the degree of a polynomial in x and y.

    Raises
    ------
    Degree, Sample, Undetermined
    """

def linear_stick_ratio(*, load: float, friction: float, force: float) -> float:
    """
    Returns the stick ratio of a nominally flat rough contact under light loads, 1 - |force| / (friction load), or zero
    without friction.

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
    Returns the number of cycles whose wear by Archard's law can be removed in one update before the pressure oscillates
    with growing amplitude: ``1.16 h / (E* k s)`` on square cells of side h (0.90 on a periodic grid), with the wear
    coefficient k and the slip s.

    Parameters
    ----------
    bodies : HalfSpace
        The two bodies and the grid.
    coefficient : float, Field or array_like of shape (ny, nx)
        Coefficient of :func:`archard` for both bodies together (one over a pressure). For the energy law, pass its
        coefficient times the coefficient of friction.
    slip_distance : Field or array_like of shape (ny, nx)
        Length of the slip path of each cell in one cycle (lengths), not negative: :attr:`Cycle.slip_distance`.

    Returns
    -------
    float
        The limit, not rounded; infinite without slip. For fewer than half of these cycles, no pattern of pressure changes
        sign. To multiply a depth, use :meth:`CycleJump.cycles`, which remains below this limit and is never infinite.

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
        The symmetric operator C; a callable receives an array of the unknowns and returns its product with C.
    linear : array_like
        The linear term, one number per unknown: a flat array, or a Field or an array of shape (ny, nx) on the grid of the operator.
    lower, upper : float or array_like, optional
        Bounds of the unknowns; zero and infinity by default.
    total : float, optional
        Sum of the unknowns; free by default.
    spring : (far_end, compliance), optional
        A spring that replaces the total: the multiplier is ``far_end - compliance * sum(x)``.
    diagonal : float or array_like, optional
        Non-negative numbers that are added to the diagonal of C; none by default.
    preconditioner : LinearOperator, optional
        An approximation of the inverse of C without ``diagonal``; none by default.
    lower_bound : float, default 0
        A lower bound on the smallest eigenvalue of the operator, if the operator is a callable. The error bound is
        computed from it.
    start : array_like, optional
        Initial iterate; zero by default.
    settings : Settings, optional
        Method, tolerance and limits; ``Settings()`` by default.
    tolerance, method, max_iterations, time_limit : optional
        See :class:`Settings`; these arguments take precedence over ``settings``.
    progress : callable or bool, optional
        See :meth:`NormalProblem.solve`.

    Returns
    -------
    Minimum

    Raises
    ------
    Length, Sample, Bounds, Total, Method, Tolerance, IterationLimit, NotConverged
    GridMismatch
        If a field or the preconditioner is on a grid that differs from that of the operator, or if the grids of two fields differ.
    Shape
        If an array does not have the shape of this grid, for example because the array is transposed.

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
    Returns the heights with x mirrored, as for a body that is turned over.
    """

def npy_grid(path: str | PathLike[str], *, cell: Sequence[float] | NDArray[Any] | None = None, size: Sequence[float] | NDArray[Any] | None = None) -> Grid:
    """
    Returns the grid of an NPY file without reading its samples.
    """

def npy_parse(bytes: bytes | bytearray | memoryview, *, cell: Sequence[float] | NDArray[Any] | None = None, size: Sequence[float] | NDArray[Any] | None = None, missing: float | None = None, unit: str | None = None, height_unit: str | None = None) -> Field:
    """
    Reads a field from the bytes of an NPY file; see :func:`read`.
    """

def npy_read(path: str | PathLike[str], *, cell: Sequence[float] | NDArray[Any] | None = None, size: Sequence[float] | NDArray[Any] | None = None, missing: float | None = None, unit: str | None = None, height_unit: str | None = None) -> Field:
    """
    Reads a field from an NPY file.

    Parameters
    ----------
    path : path_like
        The file.
    cell, size : pair of float
        Side lengths of a cell or of the grid; exactly one of the two is required.
    missing : float, optional
        The value that marks a missing point (default: none). Other values that may be such marks, as -9999, are rejected by the
        rule of :func:`stickslip.io.csv.read`. NaN states that all numbers are heights.
    unit : str, optional
        The unit of the lengths of the file, which the surface keeps, such as ``"um"``.
    height_unit : str, optional
        The unit of the heights of the file, if it differs; the heights are converted to ``unit``.

    Raises
    ------
    File, Format, NotPositive
    ValueError
        If a name is not a unit of length.
    TypeError
        If ``height_unit`` is given without ``unit``.
    """

def npy_to_bytes(field: Field | ArrayLike) -> bytes:
    """
    Returns a field as the bytes of an NPY file.
    """

def npy_write(path: str | PathLike[str], field: Field | ArrayLike) -> None:
    """
    Writes a field to an NPY file.
    """

def num_threads() -> int:
    """
    Returns the number of threads of a solve.
    """

def paraboloid(grid: Grid, curvatures: Sequence[float] | NDArray[Any]) -> Field:
    """
    Returns the gap ``(k_xx x^2 + 2 k_xy x y + k_yy y^2) / 2`` under a paraboloid with the curvatures
    ``(k_xx, k_xy, k_yy)`` (one over lengths). No principal curvature may be negative.
    """

def read(path: str | PathLike[str]) -> Field:
    """
    Reads a surface from a file whose format is given by its extension: ASC, SDF, SUR, X3P or XYZ. Lengths are in metres,
    except for XYZ, where they are in the unit of the file; :func:`stickslip.io.xyz.read` accepts this unit.
    """

def remove_outliers(heights: Field | ArrayLike, *, threshold: float = ..., radius: int = ...) -> WithoutOutliers:
    """
    Removes outliers from a surface: points that are not typical of the heights around them, such as spikes of an optical
    instrument.

    The deviation of a point is its height minus the median of the means of pairs. A pair consists of two measured points on
    opposite sides of the point, so a tilt causes no deviation. A point is an outlier if its absolute deviation exceeds
    ``threshold`` times the larger of two scales, also relative to the pairs without larger outliers. The first scale is 1.4826
    times the median of the absolute deviations of all points (Hampel, 1974). The second scale follows from the deviations
    around the point, because all points along an edge, ridge or groove deviate, whereas an outlier deviates alone. ISO 25178-2
    defines outliers and leaves the method open.

    Parameters
    ----------
    heights : Field or topography
        The heights (lengths); NaN marks missing heights.
    threshold : float, default 6
        Threshold in estimated standard deviations. The value 3 removes about 0.3 % of normally distributed independent
        heights. The default removes no points of smooth surfaces such as spheres, waves, steps, ramps and cones.
    radius : int, default 2
        Largest distance of the points of a pair along each axis, in cells, at least 1. A group of more than ``2 * radius``
        outliers counts as an edge. An outlier next to an edge must exceed the deviation at the edge several times.

    Returns
    -------
    WithoutOutliers
        ``heights`` contains NaN at the outliers; ``interpolated()`` contains interpolated heights there.

    Raises
    ------
    NegativeOrNotFinite, BelowMinimum, Sample

    Examples
    --------
    >>> import numpy as np, stickslip as ss
    >>> grid = ss.Grid.square(32, 32.0)
    >>> heights = np.tile(np.sin(0.3 * grid.x), (32, 1))
    >>> heights[5, 7] += 40.0
    >>> cleaned = ss.surface.remove_outliers(ss.Field(grid, heights))
    >>> cleaned.outlier_cells, bool(np.isnan(cleaned.heights[5, 7])), bool(abs(cleaned.interpolated()[5, 7]) < 1.0)
    (1, True, True)
    """

def resample(heights: Field | ArrayLike, grid: Grid) -> Field:
    """
    Interpolates a surface at the cell centres of another grid, with cubic interpolation along x and y. The sides of the grid
    are in the unit of the heights.

    Raises
    ------
    Sample, BeyondSamples, Memory
    ValueError
        If the whole grid is smaller than one cell of the heights, as a grid in another unit would be.
    """

def sdf_parse(bytes: bytes | bytearray | memoryview) -> Field:
    """
    Reads a surface from the bytes of an SDF file (lengths in metres).
    """

def sdf_read(path: str | PathLike[str]) -> Field:
    """
    Reads a surface from an SDF file (lengths in metres).
    """

def sdf_to_bytes(field: Field | ArrayLike, *, unit: str | None = None) -> bytes:
    """
    Returns a surface as the bytes of an SDF file (lengths in metres); see :func:`write`.
    """

def sdf_write(path: str | PathLike[str], field: Field | ArrayLike, *, unit: str | None = None) -> None:
    """
    Writes a surface to an SDF file (lengths in metres).

    Parameters
    ----------
    path : path_like
        The file.
    field : Field or topography
        The surface, in metres.
    unit : str, optional
        The unit of a surface that states none: ``"m"``.

    Raises
    ------
    File
    ValueError
        If the unit of the surface is not known or is not the metre.
    """

def set_num_threads(threads: int) -> None:
    """
    Sets the number of threads of all later solves in this process; running solves are not affected.

    Results are bitwise identical for any number of threads. The default is the environment variable
    ``RAYON_NUM_THREADS``, or the number of cores if it is not set. With one thread, all work runs on the calling thread
    and no other thread is started.

    Parameters
    ----------
    threads : int
        Number of threads, from 1 to 1024. For the number of cores give ``os.cpu_count()``.

    Raises
    ------
    ArgumentType, ArgumentRange

    Examples
    --------
    >>> import stickslip
    >>> stickslip.set_num_threads(2)
    >>> stickslip.num_threads()
    2
    """

def sinusoidal(grid: Grid, amplitude: float, wavelength: float) -> Field:
    """
    Returns the gap ``amplitude * (1 - cos(2 pi x / wavelength))`` under straight waves (lengths), zero on their
    crests.
    """

def sphere(grid: Grid, radius: float) -> Field:
    """
    Returns the gap under a sphere of this radius (a length): the paraboloid ``(x^2 + y^2) / (2 radius)`` of Hertz's
    theory. Gaps are lengths and zero where the shape touches the plane.
    """

def sum(fields: Sequence[Field | ArrayLike]) -> Field:
    """
    Returns the sum of fields on one grid, cell by cell: the gap between two bodies is the sum of both shapes. All
    surfaces must have the same unit.
    """

def sur_parse(bytes: bytes | bytearray | memoryview) -> Field:
    """
    Reads a surface from the bytes of a SUR file (lengths in metres).
    """

def sur_read(path: str | PathLike[str]) -> Field:
    """
    Reads a surface from a SUR file (lengths in metres).
    """

def threshold_energy(coefficient: Field | ArrayLike, threshold: float, accumulated: Field | ArrayLike, energy: Field | ArrayLike, *, depth: Field | ArrayLike | None = None, grid: Grid | None = None) -> NDArray[float64]:
    """
    Computes the wear depth by the energy law with a threshold: the increase of ``coefficient * max(0, accumulated / cell
    area - threshold)`` in a step or a cycle (lengths).

    Parameters
    ----------
    coefficient : float, Field or array_like of shape (ny, nx)
        See :func:`energy`.
    threshold : float
        The energy per area up to which there is no wear, not negative.
    accumulated, energy : Field or array_like of shape (ny, nx)
        Energies dissipated in each cell (forces times lengths, not negative): ``accumulated`` since the start, including
        this step or cycle, and ``energy`` in this step or cycle alone.
    depth : optional
        See :func:`archard`.
    grid : Grid, optional
        Grid that gives the area of a cell. It is required for an array that does not contain its grid. The dissipation of a
        cycle, a step, a history and a state contains it; a grid with other cells is then rejected.

    Returns
    -------
    ndarray of shape (ny, nx)
        Wear depths (lengths).

    Raises
    ------
    NegativeOrNotFinite, Sample, GridMismatch, NotFinite
    Shape
        If an array does not have one entry per cell. A single number, such as a total energy, is rejected too.
    ValueError
        If the units of the energies and of the earlier depth differ.
    TypeError
        If an array contains energies per area.
    """

def vti_to_bytes(fields: Any, *, grid: Grid | None = None) -> bytes:
    """
    Returns fields as the bytes of a VTI file for ParaView; see :func:`write`.
    """

def vti_write(path: str | PathLike[str], fields: Any, *, grid: Grid | None = None) -> None:
    """
    Writes fields to a VTI file (image data) for ParaView.

    Parameters
    ----------
    path : path_like
        The file, whose name ends in ``.vti``; an existing file is replaced.
    fields : dict, solution, State, History, Field or surface
        Fields by name; a pair of fields is a vector. For other objects, all their fields are written: ``gap`` is the gap under
        load, and ``unloaded_gap`` the gap before loading. ``zones`` contains the numbers 0 separated, 1 stick and 2 slip,
        because a VTI file stores no names.
    grid : Grid, optional
        Grid of the fields of a dictionary; required if they are arrays.

    Raises
    ------
    ArgumentRange
        If the path does not end in ``.vti``. :func:`to_bytes` returns the content for other paths.
    ValueError
        If the fields have different units.
    """

def x3p_parse(bytes: bytes | bytearray | memoryview) -> Field:
    """
    Reads a surface from the bytes of an X3P file (lengths in metres).
    """

def x3p_read(path: str | PathLike[str]) -> Field:
    """
    Reads a surface from an X3P file (lengths in metres).
    """

def xyz_parse(bytes: bytes | bytearray | memoryview, *, missing: float | None = None, skip_rows: int = 0, unit: str | None = None, height_unit: str | None = None) -> Field:
    """
    Reads a surface from the bytes of an XYZ file (lengths in the unit of the file); see :func:`read`.
    """

def xyz_read(path: str | PathLike[str], *, missing: float | None = None, skip_rows: int = 0, unit: str | None = None, height_unit: str | None = None) -> Field:
    """
    Reads a surface from an XYZ file (lengths in the unit of the file).

    Parameters
    ----------
    path : path_like
        The file.
    missing : float, optional
        The height that marks a missing point (default: the value that a comment states, or none). Other heights that may be
        such marks, as -9999, are rejected by the rule of :func:`stickslip.io.csv.read`. NaN states that all numbers are heights.
    skip_rows : int, default 0
        Number of lines before the points.
    unit : str, optional
        The unit of the lengths of the file, which the surface keeps, such as ``"um"``.
    height_unit : str, optional
        The unit of the heights of the file, if it differs; the heights are converted to ``unit``.

    Raises
    ------
    File, Format
    ValueError
        If a name is not a unit of length, or if the header of the file states another unit, as ``# X[um] Y[um] Z[nm]``.
    TypeError
        If ``height_unit`` is given without ``unit``.
    """

