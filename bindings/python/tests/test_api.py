"""Completeness of the Python package with respect to the crate, agreement of stubs and module, and docstrings."""

import ast
import builtins
import importlib
import inspect
import pathlib
import pkgutil
import re
import subprocess
import sys

import numpy as np
import pytest

import stickslip as ss
from stickslip import _stickslip

HERE = pathlib.Path(__file__).parent

# Items of the crate that have a different name in Python.
ELSEWHERE = {
    "enum Error": "errors.StickslipError",
    "enum io::Place": "errors.Format",
    "struct SystemError": "errors.File",
    "enum normal::NormalControl": "LoadStep",  # normal_force= and approach=
    "enum normal::NormalLoad": "NormalProblem",  # force= and approach=
    "enum tangential::TangentialControl": "TangentialLoad",  # force=, shift=, spring= of each axis
    "enum tangential::PressureSource": "TangentialProblem",  # a solution or a field
    "enum history::wear::Coefficient": "wear.archard",  # a number or an array
    "enum rolling::RollingControl": "rolling.RollingProblem",  # creepage_x= and force_x=
    "enum rolling::SpinControl": "rolling.RollingProblem",  # spin= and moment=
    "enum surface::Form": "surface.level",  # 'mean', 'plane' or a degree
    "struct surface::GaussianFilter": "surface.gaussian_filter",  # s=, l=, periodic=, along=
    "struct surface::OutlierFilter": "surface.remove_outliers",  # threshold=, radius=
    "enum io::Sides": "io.npy.read",  # cell= or size=
    "enum io::vti::Array": "io.vti.write",  # a field or a pair of fields
    "struct io::csv::Options": "io.csv.read",  # missing=, skip_rows= and others
    "struct io::npy::Options": "io.npy.read",  # missing=
    "struct io::xyz::Options": "io.xyz.read",  # missing= and skip_rows=
    "struct edges::EdgeCell": "edges.Edges",  # arrays: cells, covered, is_fitted
    "struct history::StepFailures": "History.step_all",  # a list of indices and errors
    "struct sensitivity::Weights": "sensitivity.Functional.weighted",  # keywords
    "struct subsurface::Tractions": "subsurface.at_points",  # a solution or fields
    "enum cgm::Total": "cgm.minimise",  # total= and spring=
    "struct cgm::Problem": "cgm.minimise",
    "struct cgm::Bounds": "cgm.minimise",  # lower= and upper=
    "struct cgm::NonNegative": "cgm.minimise",
    "struct cgm::Interval": "cgm.minimise",
    "fn cgm::minimise_with": "cgm.minimise",  # progress= and start=
    "fn subsurface::at_points_observed": "subsurface.at_points",  # Ctrl-C
    "trait Operator": "cgm.LinearOperator",  # or any callable
    "struct ElasticOperator": "cgm.LinearOperator",
    "struct ElasticPreconditioner": "cgm.LinearOperator",
    "struct Identity": "cgm.identity",
    "trait cgm::Constraint": "cgm.minimise",
    "struct kernel::CoefficientTable": "Kernel.tabulated",  # a dictionary of arrays
    "struct kernel::Kernel": "Kernel",
    "struct kernel::Operators": "Kernel.operators",  # a dictionary
    "struct layers::Response": "layers.WaveResponse",
    "struct adaptive::Estimate": "adaptive.AdaptiveSolution",  # a dictionary
    "struct adaptive::SampledGap": "adaptive.AdaptiveProblem",  # a Field, and interpolation=
    "trait adaptive::GapFunction": "adaptive.AdaptiveProblem",  # a callable
}
# Items that are missing in Python, each with the reason.
WITHOUT = {
    "enum ErrorKind": "exceptions are grouped by their Python base classes",
    "struct history::HistoryBuilder": "keywords of History",
    "struct normal::NormalProblemBuilder": "keywords of NormalProblem",
    "struct tangential::TangentialProblemBuilder": "keywords of TangentialProblem",
    "struct coupled::CoupledProblemBuilder": "keywords of CoupledProblem",
    "struct rolling::RollingProblemBuilder": "keywords of rolling.RollingProblem",
    "struct rolling::CoupledRollingProblemBuilder": "keywords of rolling.CoupledRollingProblem",
    "struct adaptive::AdaptiveProblemBuilder": "keywords of adaptive.AdaptiveProblem",
    "type Result": "exceptions",
    "struct Solver": "each kind of contact has its class",
    "trait Contact": "generics of Rust",
    "fn disable_global_pool": "the package does it",
    "struct Layout": "how sums are cut: of operators written in Rust",
    "struct cgm::Workspace": "buffers of the generic engine, which a call holds itself",
    "struct cgm::Disc": "of minima with several components a cell: engine generics",
    "struct cgm::AbsBound": "of minima with several components a cell: engine generics",
    "struct cgm::NormBound": "of minima with several components a cell: engine generics",
    "trait cgm::Ball": "engine generics",
    "trait cgm::ConstraintSet": "engine generics",
    "struct fft::CirculantInverse": "made by HalfSpace.preconditioner",
    "struct Scratch": "buffers, which an operator holds itself",
    "struct stiffness::StiffnessWorkspace": "buffers, which Python manages",
    "struct ranks::Threads": "ranks are those of a communicator: HalfSpace.distributed",
    "struct ranks::CommunicationStats": "as ranks::Threads",
    "enum ranks::RankFailure": "as ranks::Threads",
    "trait ranks::Ranks": "as ranks::Threads",
    "trait TryClone": "copies of what Python holds are Python's",
    "struct kernel::ResponseTensor": "of responses with a direction, in Rust alone",
}
# Methods with the same Python equivalent in all types, by patterns of their names.
ALIKE = {
    "new": "the class",
    "of": "the class",
    "builder": "keywords of the class",
    "(.*_)?observed": "progress= and Ctrl-C",
    "set_settings": "settings may be assigned",
    ".*_into|into_.*|as_(mut_)?slice|(try_)?new_solution|try_.*|(try_)?workspace": "memory, which Python manages",
    "len|iter|is_empty": "sequences of Python",
}
# Methods that have a different name in Python or are missing.
METHODS = {
    "ContactSpots": {"label": "labels"},
    "ElasticPair": {"stands_for_kernel": "Kernel.pair"},
    "Error": {"kind": "the Python base class of an exception"},
    "SystemError": {"code": "errno", "kind": "errno"},
    "kernel::CoefficientTable": dict.fromkeys(["get", "sides", "size", "with"], "arrays of NumPy"),
    "kernel::Kernel": {"orthotropic": "in Rust alone", "with_long_wave_limit": "in Rust alone"},
    "kernel::Operators": {"with": "a dictionary", "on": "the argument grid"},
    "Field": {
        **dict.fromkeys(["from_fn", "from_indices", "from_vec", "constant", "zeros"], "Field(grid, samples)"),
        **dict.fromkeys(["add_scaled", "minus", "scaled", "map"], "arithmetic, and NumPy"),
        "rows": "array",
    },
    "Grid": {"position": "x[ix], y[iy]"},
    "HalfSpace": {
        **dict.fromkeys(["read_npy", "write_npy", "write_pvti"], "NumPy, of Grid.rows"),
        **dict.fromkeys(["integral_of", "max_of", "mean_of", "min_of"], "allreduce of the communicator"),
        **dict.fromkeys(["level", "power_spectrum", "statistics", "traffic"], "of shared bodies, in Rust alone"),
        "with_boundary": "HalfSpace(boundary=)",
        "with_cell_value": "HalfSpace(cell_value=)",
        "tensor_preconditioner": "of minima with several components a cell: engine generics",
    },
    "adaptive::AdaptiveSolution": {"estimate": "estimates[quantity]", "position": "x[ix], y[iy]"},
    "adaptive::SampledGap": {"samples": "the Field"},
    "cgm::Problem": {"totals": "of minima with several components a cell: engine generics"},
    "cgm::Settings": {"check": "the class"},
    "dense::DenseOperator": {"from_rows": "the class"},
    "history::History": {
        "sensitivities_with": "sensitivities",
        "stiffness_with": "stiffness",
    },
    "history::LoadPath": {"table": "the class"},
    "history::LoadStep": {
        "hold": "LoadStep()",
        "normal": "normal_force= and approach=",
        "tangential": "force_x= and others",
    },
    "history::State": {"from_slabs": "History.save and load"},
    "influence::Component": {"is_odd": "of kernels, for code in Rust"},
    "influence::Table": {"sample": "get"},
    "io::csv::Options": {"parse": "io.csv.parse", "read": "io.csv.read"},
    "io::npy::Options": {"parse": "io.npy.parse", "read": "io.npy.read"},
    "io::xyz::Options": {"parse": "io.xyz.parse", "read": "io.xyz.read"},
    "normal::Hardness": {"per_cell": "the class", "uniform": "the class"},
    "subsurface::Plane": {"map": "arrays of NumPy", "stresses": "arrays of NumPy"},
    "subsurface::Planes": {"through": "solve of each in turn"},
    "subsurface::Tractions": {"with_traction": "(pressure, (x, y))"},
    "surface::Autocorrelation": {"of_periodic": "periodic="},
    "surface::OutlierFilter": {"apply": "the function"},
    "surface::GaussianFilter": {
        **dict.fromkeys(["apply", "sl"], "the function"),
        **dict.fromkeys(["along_x", "along_y"], "along="),
        "valid_range": "Filtered.valid_range",
    },
    "tangential::Friction": {"cap": "max_shear_stress", "coulomb": "the class", "per_cell": "the class"},
    "tangential::TangentialLoad": {"along": "force_x= and others"},
}  # fmt: skip


EVERYTHING = (HERE / "crate_items.txt").read_text().splitlines()
ITEMS = [item for item in EVERYTHING if not item.startswith("method ")]


def named(path):
    """Returns the object with this path in the package, or ``None``."""
    target = ss
    for name in path.replace("::", ".").split("."):
        target = getattr(target, name, None)
    return target


def reached(path):
    return named(path) is not None


def types_with_methods():
    """Returns the types of the crate that exist in Python, each with its Python equivalent and its methods."""
    found = {}
    for item in sorted(set(EVERYTHING) - set(ITEMS)):
        owner, _, method = item.split(" ")[1].rpartition("::")
        [of_type] = {f"struct {owner}", f"enum {owner}"} & set(ITEMS)
        if of_type not in WITHOUT:
            found.setdefault((owner, ELSEWHERE.get(of_type, owner)), []).append(method)
    return found


METHODS_OF_TYPES = types_with_methods()


@pytest.mark.parametrize(("owner", "path"), METHODS_OF_TYPES)
def test_package_methods_cover_crate_or_list_reason(owner, path):
    item, reasons = named(path), METHODS.get(owner, {})
    try:
        keywords = set(inspect.signature(item).parameters)
    except ValueError:  # without a constructor
        keywords = set()
    for method in METHODS_OF_TYPES[owner, path]:
        is_keyword = method.removeprefix("with_") in keywords
        if method in reasons:
            assert not hasattr(item, method), f"{owner}::{method} is there after all"
        elif not any(re.fullmatch(pattern, method) for pattern in ALIKE):
            assert hasattr(item, method) or is_keyword, f"{owner}::{method} is missing"


@pytest.mark.parametrize("item", ITEMS)
def test_package_items_cover_crate_or_list_reason(item):
    if item in WITHOUT:
        assert not reached(item.split(" ")[1]), "it is there after all"
        return
    path = ELSEWHERE.get(item, item.split(" ")[1])
    assert reached(path), f"stickslip.{path} is missing"


def test_exception_lists_are_up_to_date():
    assert (set(ELSEWHERE) | set(WITHOUT)) <= set(ITEMS)
    methods = {f"method {owner}::{method}" for owner, reasons in METHODS.items() for method in reasons}
    assert methods <= set(EVERYTHING)


def test_error_variants_have_exception_classes():
    source = (HERE.parents[2] / "src" / "error" / "mod.rs").read_text()
    body = source.split("pub enum Error {")[1].split("\n}")[0]
    variants = [
        line.strip().split("{")[0].split("(")[0].strip(" ,")
        for line in body.splitlines()
        if line.startswith("    ") and line[4].isupper()
    ]
    assert len(variants) > 40
    for variant in variants:
        assert issubclass(getattr(ss.errors, variant), ss.StickslipError)


def test_enumerations_have_names_accepted_by_module():
    from stickslip import _enums

    names = ["Axis", "TangentialModel", "Coupling", "CellValue", "EntryRule", "LeadingEdge", "Method", "Body", "Amplitudes"]
    for name in [*names, "Component", "Interpolation", "Quantity", "AdaptiveStatus"]:
        assert all(str(member) == member.value for member in getattr(_enums, name))
    assert ss.Settings(method=ss.Method.POLONSKY_KEER) == ss.Settings(method="polonsky_keer")


def public(module):
    return {name: getattr(module, name) for name in dir(module) if not name.startswith("_")}


def test_modules_list_only_their_own_names():
    beside = {ss: ["Warning"], ss.surface: ["sum"]}  # named like a builtin
    for module in (ss, ss.history, ss.surface, ss.plot):
        assert dir(module) == sorted([*module.__all__, *beside.get(module, [])])
        assert all(hasattr(module, name) for name in dir(module))
    assert all(issubclass(getattr(ss.errors, name), Exception) for name in dir(ss.errors)) and len(dir(ss.errors)) > 50
    import stickslip.history.wear as wear

    assert wear is ss.wear is ss.history.wear


def test_star_import_shadows_no_builtin():
    for found in pkgutil.walk_packages(ss.__path__, "stickslip."):
        if not found.name.split(".")[-1].startswith("_"):
            module = importlib.import_module(found.name)
            names = getattr(module, "__all__", [name for name in vars(module) if not name.startswith("_")])
            assert not set(names) & set(dir(builtins)), found.name
    assert not set(ss.__all__) & set(dir(builtins))
    assert issubclass(ss.Warning, object) and ss.surface.sum and {"Warning"} < set(dir(ss)) and "sum" in dir(ss.surface)


STUBS = ast.parse((pathlib.Path(_stickslip.__file__).parent / "_stickslip.pyi").read_text())


def test_stubs_have_docstrings_of_module():
    def checked(nodes, owner):
        for node in nodes:
            item = getattr(owner, getattr(node, "name", ""), None)
            if item is None or node.name.startswith("_"):
                continue
            setters = [ast.unparse(decorator).endswith(".setter") for decorator in getattr(node, "decorator_list", [])]
            if not any(setters):
                stub = ast.get_docstring(node)
                assert stub is not None and inspect.cleandoc(item.__doc__).split() == stub.split(), node.name
                seen.append(node.name)
            if isinstance(node, ast.ClassDef):
                checked(node.body, item)

    seen = []
    checked(STUBS.body, _stickslip)
    assert len(seen) > 500


def test_stubs_state_array_dtypes(scene):
    text = ast.unparse(STUBS)
    assert "-> NDArray[Any]" not in text and "ndarray" not in text.replace("ndarray of", "").replace(": ndarray", "")
    history = scene.history()
    history.step(normal_force=100.0)
    cycle = ss.history.Cycle(history)
    objects = [scene.grid, scene.ball, scene.normal(), history, history.state(), history.spots, cycle, cycle.points]
    for node in STUBS.body:
        for item in (item for item in objects if type(item).__name__ == getattr(node, "name", "")):
            for member in node.body:
                returns = ast.unparse(member.returns) if getattr(member, "returns", None) else ""
                stated = re.fullmatch(r"(?:tuple\[)?NDArray\[(\w+)\].*", returns)
                if stated and any(ast.unparse(decorator) == "property" for decorator in member.decorator_list):
                    value = getattr(item, member.name)
                    first = value[0] if isinstance(value, tuple) else value
                    assert first is None or first.dtype == getattr(np, stated[1]), member.name


def test_grids_and_bodies_with_equal_content_compare_and_hash_equal(scene):
    grid, pair = ss.Grid.square(64, 0.3e-3), scene.bodies.pair
    assert grid == scene.grid and hash(grid) == hash(scene.grid) and len({grid, scene.grid, ss.Grid.square(64, 1.0)}) == 2
    bodies = ss.HalfSpace(grid, pair)
    assert bodies == scene.bodies and {scene.bodies: "known"}[bodies] == "known"
    others = [
        ss.HalfSpace(ss.Grid.square(64, 1.0), pair),
        ss.HalfSpace(grid, pair, boundary="periodic"),
        ss.HalfSpace(grid, (ss.Material(1.0, 0.3), ss.Material.rigid())),
    ]
    assert all(other != bodies for other in others)


def test_public_items_have_docstrings():
    undocumented = []
    for name, item in public(_stickslip).items():
        if not item.__doc__:
            undocumented.append(name)
        if inspect.isclass(item):
            undocumented += [f"{name}.{member}" for member, value in public(item).items() if not value.__doc__]
    assert not undocumented


def test_classes_state_their_module():
    for name, item in public(_stickslip).items():
        if inspect.isclass(item):
            assert getattr(importlib.import_module(item.__module__), name) is item


def test_repr_is_one_readable_line(scene):
    contact = scene.normal()
    history = scene.history()
    step = history.step(normal_force=100.0, force_x=10.0)
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=20.0)
    for item in [
        scene.grid, scene.bodies, scene.bodies.pair, scene.ball, contact, contact.report, contact.spots, shear,
        shear.solve(), history, step, step.energy, history.state(), ss.Settings(), scene.hertz, history.friction,
        ss.history.Cycle(history), ss.LoadStep(force_x=1.0), contact.stiffness(scene.bodies), history.stiffness(),
    ]:  # fmt: skip
        text = repr(item)
        assert type(item).__name__ in text and " object at " not in text and len(text.splitlines()) == 1


def test_sequences_iterate_over_typed_entries(tmp_path):
    pytest.importorskip("mypy")
    code = tmp_path / "typed.py"
    code.write_text(
        "import stickslip as ss\n"
        "def forces(contact: ss.NormalSolution, cycle: ss.history.Cycle, found: ss.subsurface.PointResults) -> list[float]:\n"
        "    parts = [[spot.load for spot in contact.spots], [point.twist for point in cycle.points]]\n"
        "    return sum(parts, [response.stress.xx for response in found])\n"
    )
    # The command runs next to the package, which is then found without being installed.
    command = [sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent", str(code)]
    answer = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert answer.returncode == 0, answer.stdout[-5000:]


def test_stubs_pass_strict_type_check():
    pytest.importorskip("mypy")
    command = [sys.executable, "-m", "mypy.stubtest", "stickslip._stickslip"]
    answer = subprocess.run(command, capture_output=True, text=True)
    assert answer.returncode == 0, answer.stdout[-5000:]
