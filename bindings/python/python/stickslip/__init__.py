"""Normal and stick-slip contact of smooth and rough elastic bodies, with error bounds.

Two elastic bodies are pressed together and loaded tangentially. The package computes the pressure and the contact area,
then the shear traction, the stick zone and the slip zone under Coulomb friction, for one load or a history of loads.

>>> import stickslip as ss
>>> grid = ss.Grid.square(128, 0.4e-3)                  # 128 x 128 cells on a square of side 0.4 mm; SI units
>>> steel = ss.Material(213e9, 0.29)
>>> bodies = ss.HalfSpace(grid, (steel, steel))
>>> ball = ss.surface.sphere(grid, 3.5e-3)              # the gap before loading
>>> normal = ss.NormalProblem(bodies, ball, force=100.0).solve()
>>> tangential = ss.TangentialProblem(bodies, normal, 0.5, force_x=20.0).solve()
>>> round(tangential.stick_ratio, 2), normal.pressure.shape
(0.71, (128, 128))

Any consistent system of units can be used. The z axis points into body 1, and pressure is positive in compression.
Traction and tangential force are those that body 2 exerts on body 1. The shift is the rigid motion of body 2 relative to
body 1 far from the contact (the relative rigid tangential displacement). Twist, creepage and spin are motions of body 2
relative to body 1, opposite to the creepage of Kalker and CONTACT. Slip is the motion of the surface of body 1 over the
surface of body 2. Fields are arrays of shape (ny, nx), x fastest.

Arrays of solutions are read-only views of their memory, and arrays of histories are read-only copies. Every argument that
accepts a field accepts an array, which is copied, or a :class:`Field`, which is created once and shared. ``help(Field)`` states
the rules for units, for masked arrays, and for the labels of pandas and xarray. The GIL is released during solves.
Ctrl-C ends a solve at its next product and leaves the state of solvers and histories unchanged.

A contact consists of a :class:`Grid`, two :class:`Material` objects in a :class:`HalfSpace`, and a gap: a shape of
:mod:`~stickslip.surface` or an array. :class:`NormalProblem` solves normal contact. :class:`TangentialProblem` solves one
tangential load step under a given pressure. :class:`CoupledProblem` solves both simultaneously for different materials.
:class:`History` computes a load history step by step, and
:class:`rolling.RollingProblem <stickslip.rolling.RollingProblem>` computes steady rolling.
:class:`adaptive.AdaptiveProblem <stickslip.adaptive.AdaptiveProblem>` solves a contact to a required accuracy on a grid that
it chooses. Use ``help`` on a class for its parameters, units, defaults and exceptions.

The submodules correspond to the modules of the Rust crate: :mod:`~stickslip.adaptive`, :mod:`~stickslip.analytical`,
:mod:`~stickslip.cgm`, :mod:`~stickslip.coupled`, :mod:`~stickslip.dense`, :mod:`~stickslip.edges`, :mod:`~stickslip.errors`,
:mod:`~stickslip.fft`, :mod:`~stickslip.history`, :mod:`~stickslip.influence`, :mod:`~stickslip.io`,
:mod:`~stickslip.layers`, :mod:`~stickslip.normal`, :mod:`~stickslip.rolling`, :mod:`~stickslip.sensitivity`,
:mod:`~stickslip.stiffness`, :mod:`~stickslip.subsurface`, :mod:`~stickslip.surface`, :mod:`~stickslip.tangential`,
:mod:`~stickslip.wear`; :mod:`~stickslip.plot` draws with matplotlib.
"""

from . import (
    adaptive,
    analytical,
    cgm,
    coupled,
    dense,
    edges,
    errors,
    fft,
    history,
    influence,
    io,
    layers,
    normal,
    plot,
    rolling,
    sensitivity,
    stiffness,
    subsurface,
    surface,
    tangential,
    wear,
)
from ._enums import Axis, CellValue, Coupling, EigenvalueBound, Method, Status, TangentialModel, Zone
from ._spring import Spring
from ._stickslip import (
    Boundary,
    ContactSpots,
    CoupledProblem,
    CoupledSolution,
    CoupledSolver,
    ElasticPair,
    Field,
    Friction,
    Grid,
    HalfSpace,
    History,
    Iteration,
    Kernel,
    LoadStep,
    Material,
    NormalProblem,
    NormalSolution,
    NormalSolver,
    Report,
    Settings,
    Spot,
    TangentialLoad,
    TangentialProblem,
    TangentialSolution,
    TangentialSolver,
    __version__,
    num_threads,
    set_num_threads,
)
from ._stickslip import Warning as Warning  # noqa: A004 (not in `__all__`: `import *` keeps the builtin)
from .errors import (
    BeyondFrictionCapacity,
    BeyondHardness,
    ContactWarning,
    EmptyContact,
    NotConverged,
    StickslipError,
)

__all__ = [
    "Axis",
    "BeyondFrictionCapacity",
    "BeyondHardness",
    "Boundary",
    "CellValue",
    "ContactSpots",
    "ContactWarning",
    "CoupledProblem",
    "CoupledSolution",
    "CoupledSolver",
    "Coupling",
    "EigenvalueBound",
    "ElasticPair",
    "EmptyContact",
    "Field",
    "Friction",
    "Grid",
    "HalfSpace",
    "History",
    "Iteration",
    "Kernel",
    "LoadStep",
    "Material",
    "Method",
    "NormalProblem",
    "NormalSolution",
    "NormalSolver",
    "NotConverged",
    "Report",
    "Settings",
    "Spot",
    "Spring",
    "Status",
    "StickslipError",
    "TangentialLoad",
    "TangentialModel",
    "TangentialProblem",
    "TangentialSolution",
    "TangentialSolver",
    "Zone",
    "__version__",
    "adaptive",
    "analytical",
    "cgm",
    "coupled",
    "dense",
    "edges",
    "errors",
    "fft",
    "history",
    "influence",
    "io",
    "layers",
    "normal",
    "plot",
    "rolling",
    "sensitivity",
    "num_threads",
    "set_num_threads",
    "stiffness",
    "subsurface",
    "surface",
    "tangential",
    "wear",
]


def __dir__() -> list[str]:
    return [*__all__, "Warning"]
