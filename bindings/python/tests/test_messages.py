"""Texts of messages and representations: the argument, the location and the remedy."""

import importlib
import inspect
import math
import re
import warnings

import numpy as np
import pytest

import stickslip as ss
from conftest import FORCE

STEEL = ss.Material(213e9, 0.29)
STEEL, OXIDE = ss.Material(213e9, 0.29), ss.layers.Layer(380e9, 0.22, thickness=5e-6)
SPRING = ss.Spring(position=1e-6, stiffness=1e7)
LOOP = ss.history.FrettingLoop(ss.history.LoadPath.sine((1e-7, 0.0), 4), lambda shift: ss.LoadStep(shift=shift))


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda scene: ss.LoadStep(force=1.0), r"force must be a pair \(x, y\), got float: .* force_x="),
        (lambda scene: ss.LoadStep(shift=(1.0, 2.0, 3.0)), r"shift must be a pair \(x, y\), got tuple of length 3: .* shift_x="),
        (lambda scene: ss.LoadStep(spring=((1.0, 2.0), 3.0)), r"spring must be a Spring, got tuple: give Spring\(position=..., stiff"),
        (lambda scene: ss.LoadStep(spring_x=(1.0, 2.0)), "spring_x or spring_y must be a Spring, got tuple"),
        (lambda scene: ss.LoadStep(spring=SPRING), r"the position of spring must be a pair \(x, y\), got float"),
        (lambda scene: ss.LoadStep(spring_y=ss.Spring(position=(1.0, 2.0), stiffness=3.0)), "position .* must be a number, got tuple"),
        (lambda scene: ss.LoadStep(spring_x=ss.Spring(position=1.0, stiffness="3")), "spring_x must be a real number, got text"),
        (lambda scene: ss.Spring(1.0, 2.0), "positional argument"),
        (lambda scene: STEEL.coated(OXIDE), r"layers must be a sequence of Layer, got Layer: give \[layer\]"),
        (lambda scene: STEEL.coated([OXIDE, 5e-6]), r"layers must be a sequence of Layer, got list with the entry 5e-06: .*Layer\("),
        (lambda scene: ss.layers.Layer(380e9, 5e-6, 0.22), "missing 1 required keyword argument: 'thickness'"),
        (lambda scene: ss.HalfSpace(scene.grid, (OXIDE, STEEL)), r"pair must be .*, got \(Layer, Material\)"),
        (lambda scene: ss.surface.level(scene.ball, "plain"), r"form must be .*, got 'plain'"),
        (lambda scene: ss.surface.level(scene.ball, -1), r"form must be .*, got -1"),
        (lambda scene: STEEL.coated(5), r"layers must be a sequence of Layer, got int"),
        (lambda scene: ss.TangentialProblem(scene.bodies, scene.ball, 0.5, force=1.0), "force must be a pair"),
        (lambda scene: scene.history().step(force=1.0), "force must be a pair"),
        (lambda scene: ss.history.LoadPath.sine(2e-6, 20), r"amplitude must be a pair \(x, y\), got float: .*\(amplitude, 0.0\)"),
        (lambda scene: ss.history.LoadPath([1.0, 2.0]), r"steps must be a sequence of pairs \(x, y\), got list of length 2"),
        (lambda scene: ss.subsurface.Planes(scene.bodies, 1e-5), r"depths must be a sequence of numbers, got float: .*\[depth\]"),
        (
            lambda scene: ss.subsurface.at_points(scene.bodies, "one", scene.ball, (0.0, 0.0, 1e-5)),
            r"points must be a sequence of \(x, y, depth\), got tuple of length 3: .*\[\(x, y, depth\)\]",
        ),
        (lambda scene: ss.surface.bisinusoidal(scene.grid, 1.0, 2.0), r"wavelengths must be a pair \(x, y\), got float"),
        (lambda scene: ss.surface.paraboloid(scene.grid, 2.0), r"curvatures must be \(k_xx, k_xy, k_yy\), got float"),
        (lambda scene: ss.surface.crop(scene.ball, 2, (0, 3)), r"columns must be a pair \(first, end\)"),
        (lambda scene: ss.io.npy.read("heights.npy", cell=1.0), r"cell must be a pair \(dx, dy\), got float"),
    ],
)
def test_wrong_pair_or_sequence_message_names_argument_and_form(scene, call, message):
    with pytest.raises(TypeError, match=message):
        call(scene)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (
            lambda scene: ss.surface.crop(scene.ball, (0, -1), (0, 3)),
            r"columns must be a pair \(first, end\) of whole numbers, got -1, which is negative",
        ),
        (lambda scene: ss.surface.crop(scene.ball, (0, 3), (np.int64(-2), 3)), "rows must be .*, got -2, which is negative"),
        (lambda scene: ss.surface.crop(scene.ball, (0, 2**70), (0, 3)), f"columns must be .*, got {2**70}, which is too large"),
        (lambda scene: ss.LoadStep(force=(-1, 10**400)), "force must be a pair .*, got 1000.*, which is too large"),
    ],
)
def test_pair_with_number_out_of_range_names_number(scene, call, message):
    with pytest.raises(ValueError, match=message):
        call(scene)


@pytest.mark.parametrize(
    ("call", "argument", "message"),
    [
        (lambda scene: ss.Grid(-1, 3, 1.0, 1.0), "nx", "must not be negative, got -1"),
        (lambda scene: ss.Grid.square(-4, 1.0), "n", "must not be negative, got -4"),
        (lambda scene: ss.Grid.square(2**70, 1.0), "n", f"is too large for a whole number, got {2**70}"),
        (lambda scene: ss.surface.SelfAffine(rms_slope=0.1, seed=-1), "seed", "must not be negative, got -1"),
        (lambda scene: ss.Settings(max_iterations=-1), "max_iterations", "must not be negative, got -1"),
        (lambda scene: ss.history.LoadPath.sine((1.0, 0.0), np.int64(-4)), "steps", "must not be negative, got -4"),
        (lambda scene: ss.history.Rolling(-2), "cells", "must not be negative, got -2"),
        (lambda scene: ss.io.csv.read("x.csv", cell=(1.0, 1.0), skip_rows=-1), "skip_rows", "must not be negative, got -1"),
        (lambda scene: scene.ball.get(-1, 0), "ix", "must not be negative, got -1"),
        (lambda scene: ss.Material(10**400, 0.3), "youngs_modulus", "is too large for a real number, got 1000"),
        (lambda scene: LOOP.run(scene.history(), -1), "cycles", "must be a whole number of at least 0, got -1"),
    ],
)
def test_number_out_of_range_message_names_argument(scene, call, argument, message):
    with pytest.raises(ss.errors.ArgumentRange, match=f"^{argument} {message}") as refused:
        call(scene)
    assert refused.value.argument == argument and isinstance(refused.value, ValueError)


@pytest.mark.parametrize(
    ("call", "argument", "message"),
    [
        (lambda scene: ss.Material(np.array([1.0, 2.0]), 0.3), "youngs_modulus", r"a real number, got an array of shape \(2,\)"),
        (lambda scene: ss.surface.sphere(scene.grid, [1.0, 2.0]), "radius", "a real number, got list of length 2"),
        (lambda scene: ss.surface.sinusoidal(scene.grid, 1.0, None), "wavelength", "a real number, got None"),
        (lambda scene: ss.surface.gaussian_filter(scene.ball, s=(1.0,)), "s", "a real number, got tuple of length 1"),
        (lambda scene: scene.history().step(normal_force=np.ones(3)), "normal_force", r"a real number, got an array of shape \(3,\)"),
        (lambda scene: ss.LoadStep(twist=scene.ball), "twist", r"a real number, got an array of shape \(64, 64\)"),
        (lambda scene: ss.Settings(tolerance="1e-8"), "tolerance", "a real number, got text"),
        (lambda scene: ss.Grid.square(4.0, 1.0), "n", r"a whole number, got 4\.0"),
        (lambda scene: ss.surface.SelfAffine(rms_slope=0.1, seed="one"), "seed", "a whole number, got str of length 3"),
        (lambda scene: ss.Grid(np.array([2, 3]), 3, 1.0, 1.0), "nx", r"a whole number, got an array of shape \(2,\)"),
    ],
)
def test_wrong_type_of_number_message_names_argument(scene, call, argument, message):
    with pytest.raises(ss.errors.ArgumentType, match=f"^{argument} must be {message}") as refused:
        call(scene)
    assert refused.value.argument == argument and isinstance(refused.value, TypeError)


@pytest.mark.parametrize(
    ("call", "quantity", "order"),
    [
        (lambda scene: ss.History(scene.bodies, 0.25, scene.ball), "gap", ", and friction after the gap"),
        (lambda scene: ss.NormalProblem(scene.bodies, 0.25, force=1.0), "gap", ""),
        (lambda scene: ss.CoupledProblem(scene.bodies, 0.25, scene.ball, normal_force=1.0), "gap", ", and friction after the gap"),
        (
            lambda scene: ss.rolling.CoupledRollingProblem(scene.bodies, np.float64(0.25), scene.ball, normal_force=1.0),
            "gap",
            ", and friction after the gap",
        ),
        (lambda scene: ss.TangentialProblem(scene.bodies, 0.25, scene.normal().pressure, force_x=1.0), "pressure", ""),
        (lambda scene: scene.history().set_gap(0.25), "gap", ""),
    ],
)
def test_number_instead_of_gap_or_pressure_is_rejected_with_remedy(scene, call, quantity, order):
    with pytest.raises(ss.errors.ArgumentType) as refused:
        call(scene)
    assert str(refused.value) == (
        f"{quantity} must be a Field or an array of shape (ny, nx), got the number 0.25: "
        f"for a uniform {quantity} give Field(grid, 0.25){order}"
    )
    assert refused.value.argument == quantity


def test_uniform_gap_is_accepted_as_field_and_on_grid_of_one_cell():
    grid = ss.Grid.square(1, 1.0)
    bodies = ss.HalfSpace(grid, (STEEL, STEEL))
    gaps = (ss.Field(grid, 0.0), np.zeros((1, 1)), [[0.0]])
    forces = [ss.NormalProblem(bodies, gap, force=2.0).solve(warn=False).pressure.sum() for gap in gaps]
    assert forces == pytest.approx([2.0, 2.0, 2.0])


@pytest.mark.parametrize(
    ("call", "argument", "message"),
    [
        (lambda scene: ss.NormalProblem(scene.ball, scene.bodies, force=1.0), "bodies", "of the class HalfSpace, got Field: the bodies are the first argument, .*"),
        (lambda scene: ss.HalfSpace(64, (STEEL, STEEL)), "grid", "of the class Grid, got int: create a grid by .*"),
        (lambda scene: ss.surface.sphere(3.5e-3, scene.grid), "grid", "of the class Grid, got float: create a grid by .*"),
        (lambda scene: ss.rolling.RollingProblem(scene.bodies, 0.5, scene.normal()), "normal", "of the class NormalSolution, got float"),
        (lambda scene: ss.analytical.HertzSphere(STEEL, radius=1.0, load=1.0), "pair", "an ElasticPair or .* Materials, .*, got Material"),
        (lambda scene: ss.analytical.CattaneoMindlin(100.0, friction=0.5, force=1.0), "hertz", "of the class HertzSphere, got float"),
        (lambda scene: ss.NormalProblem(scene.bodies, scene.ball, force=1.0, settings=1e-8), "settings", "of the class Settings, got float"),
        (lambda scene: ss.NormalProblem(scene.bodies, scene.ball, force=1.0).solve(progress=1.0), "progress", "a callable or a bool, got float"),
        (lambda scene: ss.Kernel.isotropic(scene.bodies.pair, 1e-3, 2.0), "response", "a callable, got float"),
    ],
)
def test_object_of_wrong_class_message_names_argument(scene, call, argument, message):
    with pytest.raises(ss.errors.ArgumentType, match=f"^{argument} must be {message}$") as refused:
        call(scene)
    assert refused.value.argument == argument and isinstance(refused.value, TypeError)


def test_closed_forms_reject_numbers_by_position(scene):
    pair = scene.bodies.pair
    missing = "missing {} required keyword arguments: {}"
    with pytest.raises(TypeError, match=missing.format(2, "'radius' and 'load'")):
        ss.analytical.HertzSphere(pair, 100.0, 3.5e-3)
    with pytest.raises(TypeError, match=missing.format(2, "'friction' and 'force'")):
        ss.analytical.CattaneoMindlin(scene.hertz, 20.0, 0.5)
    with pytest.raises(TypeError, match=missing.format(3, "'load', 'friction', and 'force'")):
        ss.analytical.linear_stick_ratio(100.0, 0.5, 20.0)
    with pytest.raises(TypeError, match=r"HertzSphere takes its numbers by keyword, got 5\.0 by position: give radius=, load=$"):
        ss.analytical.HertzSphere(pair, 5.0, radius=1.0, load=1.0)
    with pytest.raises(TypeError, match=r"linear_stick_ratio takes its numbers by keyword, got 5\.0 by position: give load=, fri"):
        ss.analytical.linear_stick_ratio(5.0, load=1.0, friction=0.5, force=0.1)
    ellipse = ss.analytical.HertzEllipse(pair, radius_x=1.0, radius_y=1.0, load=1.0)
    with pytest.raises(TypeError, match=r"got 0\.1 by position: give friction=, creepage=$"):
        ss.analytical.VermeulenJohnson(ellipse, 0.1, friction=0.5, creepage=(0.1, 0.0))
    signatures = {str(inspect.signature(form)) for form in (ss.analytical.HertzSphere, ss.analytical.HertzLine)}
    assert signatures == {"(pair, *, radius, load)"} and ss.analytical.HertzSphere.__doc__.startswith("A sphere or")


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda scene: ss.HalfSpace(scene.grid, STEEL, STEEL), r"pair must be .* a tuple of two Materials, .*, got Material"),
        (lambda scene: scene.history().step(100.0), "load must be a LoadStep, got float: .* normal_force="),
        (lambda scene: ss.TangentialProblem(scene.bodies, scene.ball, 0.5, 20.0), "load must be a TangentialLoad, .* force_x="),
        (lambda scene: ss.CoupledProblem(scene.bodies, scene.ball, 0.5, 20.0), "load must be a TangentialLoad, .* force_x="),
        (lambda scene: ss.history.AdaptiveSteps(scene.history(), 0.1).step(scene.history(), 1.0), "load must be a LoadStep"),
        (lambda scene: ss.NormalProblem(scene.bodies, scene.ball, 100.0), r"NormalProblem .*, got 100\.0 by position: .* force="),
        (lambda scene: ss.NormalSolver(scene.bodies, scene.ball, 100.0), r"NormalSolver .* force= or approach="),
        (lambda scene: ss.rolling.RollingProblem(scene.bodies, scene.normal(), 0.5, 20.0), "RollingProblem .* force_x="),
        (lambda scene: ss.rolling.CoupledRollingProblem(scene.bodies, scene.ball, 0.5, 20.0), "normal_force= or approach="),
        (lambda scene: ss.LoadStep(100.0), "LoadStep takes its load by keyword, .* normal_force="),
        (lambda scene: ss.TangentialLoad(100.0), "TangentialLoad takes its load by keyword, .* force_x="),
    ],
)
def test_misplaced_load_or_body_message_names_keyword(scene, call, message):
    with pytest.raises(TypeError, match=message):
        call(scene)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda scene: ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, force_x=60.0), r"force 60\.0 exceeds"),
        (lambda scene: ss.Grid.square(3, -1.0), r"got -1\.0$"),
        (lambda scene: ss.Grid.square(3, math.nan), r"got nan$"),
        (lambda scene: ss.Grid.square(3, -1e-12), r"got -1e-12$"),
        (lambda scene: ss.Grid.square(3, -1e300), r"got -1e\+300$"),
        (lambda scene: ss.Material(1.0, -math.inf), r"\(-1, 0\.5\], got -inf$"),
        (lambda scene: ss.Settings(tolerance=2.0), r"between 0 and 1, got 2\.0$"),
        (lambda scene: scene.ball - ss.Field(ss.Grid.square(64, 1e-6), 0.0), r"sides \[1\.5625e-08, 1\.5625e-08\], expected"),
        (lambda scene: ss.surface.gap_from_heights(scene.ball * math.nan), r"index 0\) is nan, but "),
        (lambda scene: ss.NormalProblem(scene.bodies, scene.ball * 0.0 - math.inf, force=1.0), r"is -inf, but "),
        (lambda scene: ss.surface.crop(scene.ball, (3, 3), (0, 1)), r"range 3\.\.3 of"),
        (lambda scene: ss.History(scene.bodies, scene.ball, 0.5).step(force=(1.0, 2.5)), r"2\.5"),
    ],
)
def test_messages_have_python_numbers(scene, call, message):
    with pytest.raises(ss.StickslipError, match=message) as refused:
        call(scene)
    assert not re.search(r"\de-?\d\b|NaN|\b0\.00000|\d{17,}", str(refused.value))


def test_report_has_python_numbers(scene):
    report = repr(scene.normal().report)
    assert re.search(r"e-\d\d,", report) and not re.search(r"e-\d,", report)


@pytest.mark.parametrize("shape", [(64,), (1, 64, 64), (3, 3)])
def test_gap_of_wrong_shape_is_rejected_with_shape(scene, shape):
    with pytest.raises(ss.errors.Shape, match=re.escape(f"gap has shape {shape}, expected (ny, nx) = (64, 64)")) as refused:
        ss.NormalProblem(scene.bodies, np.zeros(shape), force=1.0)
    assert (refused.value.quantity, refused.value.expected, refused.value.found) == ("gap", (64, 64), shape)
    with pytest.raises(ss.errors.Shape, match=r"\(64,\)"):
        scene.history().set_gap([0.0] * 64)


@pytest.mark.parametrize("kind", [complex, str, "datetime64[s]"])
def test_non_real_arrays_are_rejected(scene, kind):
    wrong = np.zeros(scene.grid.shape).astype(int).astype(kind)
    for call in (
        lambda: ss.NormalProblem(scene.bodies, wrong, force=1.0),
        lambda: ss.Field(scene.grid, wrong),
        lambda: scene.history().set_gap(wrong.tolist()),
        lambda: scene.ball + wrong,
        lambda: ss.Friction(wrong, grid=scene.grid),
        lambda: ss.Friction(wrong[0, 0], grid=scene.grid),
        lambda: scene.bodies.operator("zz").apply(wrong),
        lambda: scene.hertz.pressure(wrong),
        lambda: ss.LoadStep(force=wrong[0, :2]),
        lambda: ss.subsurface.at_points(scene.bodies, "one", scene.ball, wrong[:, :3]),
        lambda: ss.subsurface.Planes(scene.bodies, wrong[0, :3]),
    ):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with pytest.raises(TypeError, match="real numbers|of numbers|pair"):
                call()


@pytest.mark.parametrize("number", [1.0 + 0.0j, np.complex128(1.0), np.complex64(1.0), np.array(1.0 + 0.0j), "1.0"])
def test_non_real_numbers_are_rejected(scene, number):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for call in (
            lambda: ss.Material(number, 0.3),
            lambda: ss.Grid.square(4, number),
            lambda: ss.Boundary.periodic_along_y(number),
            lambda: ss.HalfSpace(scene.grid, scene.bodies.pair, boundary=("periodic_along_y", number)),
            lambda: ss.NormalProblem(scene.bodies, scene.ball, force=number),
            lambda: ss.NormalProblem(scene.bodies, scene.ball, force=1.0, hardness=number),
            lambda: ss.NormalProblem(scene.bodies, scene.ball, force=1.0, tolerance=number),
            lambda: ss.TangentialProblem(scene.bodies, scene.ball, 0.5, shift_x=number),
            lambda: ss.TangentialProblem(scene.bodies, scene.ball, number, force_x=1.0),
            lambda: ss.LoadStep(twist=number),
            lambda: ss.LoadStep(spring_x=ss.Spring(position=number, stiffness=1.0)),
            lambda: scene.history().step(normal_force=number),
            lambda: ss.analytical.HertzSphere(scene.bodies.pair, radius=1.0, load=number),
            lambda: ss.wear.energy(number, scene.ball),
            lambda: ss.surface.SelfAffine(rms_slope=number, seed=0),
            lambda: ss.subsurface.Stress(xx=number),
            lambda: ss.cgm.minimise(lambda x: x, [-1.0], lower=number),
            lambda: scene.ball * number,
        ):
            with pytest.raises((TypeError, ValueError), match="real number|boundary must|pair|numbers|operand"):
                call()
    with pytest.raises(TypeError, match="must be a real number, got (complex: give the real part|text)"):
        ss.Material(number, 0.3)
    assert ss.Material(np.float32(1.0), 0) == ss.Material(np.array(1.0), np.int64(0)) == ss.Material(1, 0)


def test_pairs_accept_lists_and_arrays(scene):
    contact = scene.normal()
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=20.0).solve()
    below = [ss.subsurface.at_points(scene.bodies, "one", both, [[0, 0, 1e-5]]) for both in ((contact, shear), [contact, shear])]
    assert below[0] == below[1]
    for kind in (list, np.array):
        springs = ss.Spring(position=kind([1e-6, 0.0]), stiffness=1e7)
        assert ss.LoadStep(spring=springs) == ss.LoadStep(spring=ss.Spring(position=(1e-6, 0.0), stiffness=1e7))
        assert ss.surface.crop(scene.ball, kind([2, 5]), kind([0, 3])).shape == (3, 3)
    assert ss.TangentialLoad(spring_x=SPRING).control("x") == ("spring", SPRING)
    bodies = ss.HalfSpace(scene.grid, list(scene.bodies.pair.bodies), boundary=["periodic_along_y", 3.0])
    assert bodies.pair == scene.bodies.pair and bodies.boundary == ss.Boundary.periodic_along_y(3.0)
    vector = [scene.ball, scene.ball.array]
    assert ss.io.vti.to_bytes({"v": vector}, grid=scene.grid) == ss.io.vti.to_bytes({"v": tuple(vector)}, grid=scene.grid)
    for force in [(1.0, 2.0), [1, 2], np.array([1.0, 2.0])]:
        assert ss.LoadStep(force=force) == ss.LoadStep(force_x=1.0, force_y=2.0)
    assert len(ss.history.LoadPath(np.ones((4, 2)))) == 4


def test_sample_message_has_row_column_and_remedy(scene):
    gap = scene.ball.array.copy()
    gap[3, 5] = math.inf
    with pytest.raises(ss.errors.Sample, match=r"gap at row 3, column 5 \(index 197\) is inf") as refused:
        ss.NormalProblem(scene.bodies, gap, force=1.0)
    assert (refused.value.row, refused.value.column, refused.value.index) == (3, 5, 197)
    assert "fill_missing" not in str(refused.value)
    gap[3, 5] = math.nan
    masked = np.ma.masked_invalid(gap)
    for given in (gap, masked):
        with pytest.raises(ss.errors.Sample, match=r"row 3, column 5 .* \(surface.fill_missing fills missing heights\)"):
            ss.NormalProblem(scene.bodies, given, force=1.0)
        with pytest.raises(ss.errors.Sample, match=r"row 3, column 5 .*; fill missing heights first \(surface\.fill_missing\)$"):
            ss.surface.gap_from_heights(ss.Field(scene.grid, given))
    holed = ss.Field(scene.grid, gap)
    for call in (
        lambda: ss.surface.gap_between(scene.ball, holed),
        lambda: ss.surface.resample(holed, ss.Grid.square(7, 0.1e-3)),
        lambda: ss.surface.PowerSpectrum(holed),
        lambda: scene.history().set_gap(holed),
    ):
        with pytest.raises(ss.errors.Sample, match=r"row 3, column 5 .*\(surface.fill_missing"):
            call()
    with pytest.raises(ss.errors.Sample, match="row 0, column 0"):
        ss.Friction(np.full(scene.grid.shape, -1.0), grid=scene.grid)
    with pytest.raises(ss.errors.Sample, match="at index 1 ") as refused:
        ss.subsurface.Planes(scene.bodies, [0.0, -1.0])
    assert refused.value.row is None and refused.value.column is None


def test_surface_instead_of_field_message_names_heights(scene):
    rough = ss.surface.SelfAffine(rms_height=1e-6, seed=0).generate(scene.grid)
    with pytest.raises(TypeError, match=r"gap is a RoughSurface, which has heights: convert them to a gap by surface.gap_from_heights"):
        ss.NormalProblem(scene.bodies, rough, force=1.0)
    with pytest.raises(TypeError, match=r"got RoughSurface: give its \.heights"):
        ss.surface.gap_from_heights(rough)


def test_subsurface_messages_state_required_arguments(scene):
    contact = scene.normal()
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=20.0).solve()
    points = [(0.0, 0.0, 1e-5)]
    with pytest.raises(TypeError, match=r"no pressure: give the normal solution too, as \(normal, shear\)"):
        ss.subsurface.at_points(scene.bodies, "one", shear, points)
    for tractions in [(contact, contact), (shear, contact)]:
        with pytest.raises(TypeError, match=r"expected \(normal, shear\)"):
            ss.subsurface.at_points(scene.bodies, "one", tractions, points)
    with pytest.raises(ValueError, match="^body must be one of 'one', 'two', or a member of stickslip.subsurface.Body, got '1'$"):
        ss.subsurface.at_points(scene.bodies, "1", contact, points)
    with pytest.raises(TypeError, match="'one', 'two', .* got int"):
        ss.subsurface.at_points(scene.bodies, 1, contact, points)
    planes = ss.subsurface.Planes(scene.bodies, [0.0, 1e-5])
    with pytest.raises(IndexError, match="no depth with index 99: the sequence has length 2"):
        planes.solve(99, "one", contact)
    assert planes.solve(-1, "one", contact).depth == 1e-5


def test_enumerations_are_in_modules_named_by_messages():
    wrong = [
        lambda: ss.Settings(method="no"),
        lambda: ss.TangentialLoad(force_x=1.0).control("no"),
        lambda: ss.surface.SelfAffine(rms_slope=0.1, amplitudes="no", seed=0),
    ]
    for call in wrong:
        with pytest.raises(ValueError) as refused:
            call()
        module, name = re.search(r"member of ([a-z.]+)\.([A-Z]\w+)", str(refused.value)).groups()
        assert hasattr(importlib.import_module(module), name)


def test_repr_of_value_evaluates_to_value(scene):
    names = {**vars(ss), **vars(ss.surface), **vars(ss.influence), **vars(ss.normal), **vars(ss.tangential)}
    for value in [
        ss.Grid(4, 3, 0.5, 0.25),
        ss.Material(210e9, 0.3),
        ss.ElasticPair(ss.Material(1.0, 0.3), ss.Material.rigid()),
        ss.Boundary.PERIODIC,
        ss.Boundary.periodic_along_y(2.5),
        ss.Settings(tolerance=1e-5, time_limit=2.5),
        ss.TangentialLoad(force=(1.0, 2.0)),
        ss.TangentialLoad(spring_x=SPRING, twist=0.1),
        ss.LoadStep(),
        ss.LoadStep(normal_force=100.0, shift_x=1e-6),
        ss.LoadStep(approach=1e-6, spring_y=ss.Spring(position=1.0, stiffness=2.0), twist=0.5, relative_displacement=2.0),
        ss.Friction(0.3, max_shear_stress=5.0),
        ss.normal.Hardness(3.0),
        ss.surface.SelfAffine(rms_slope=0.1, seed=7),
        ss.surface.SelfAffine(rms_height=1e-6, hurst=0.7, cut_off_wavelength=0.1, skewness=-1.0, kurtosis=4.5,
                              cropped=True, amplitudes="gaussian", seed=0),
    ]:  # fmt: skip
        assert eval(repr(value), names) == value


def test_repr_counts_and_rounds(scene):
    contact = scene.normal()
    assert repr(contact.spots) == "ContactSpots(1 spot)"
    assert repr(scene.grid) == "Grid(nx=64, ny=64, dx=4.6875e-06, dy=4.6875e-06)"
    assert "Boundary.NON_PERIODIC" in repr(scene.bodies)
    assert repr(ss.influence.Rectangle(1.0 / 3.0, 2e-9)) == "Rectangle(a=0.333333, b=2e-09)"
    assert repr(ss.Field(scene.grid, math.nan)) == "Field(64 x 64 cells, all NaN)"
    assert "force=100," in repr(contact)
    history = scene.history()
    history.step(normal_force=FORCE)
    energy = history.step(force_x=30.0).energy
    assert f"dissipated_energy_midpoint={energy.dissipated_energy_midpoint:.6g}," in repr(energy)
    for number in [0.0, -1.5, 1e5, 999999.7, 1e6, 1e-4, 9.99999e-5, 123456.789, -math.inf]:
        assert repr(ss.LoadStep(shift_x=number)) == f"LoadStep(shift_x={number:.6g})"


def test_repr_without_contact_states_it(scene):
    history = scene.history()
    step = history.step(shift_x=1e-6)
    cycle = ss.history.Cycle(history)
    history.step(shift_x=0.0)
    cycle.add(history)
    for free in (step, cycle):
        assert repr(free).endswith(", no contact)")
        assert [remark.kind for remark in free.warnings] == ["no_contact"]
    assert "no contact" not in repr(history.step(normal_force=FORCE))


def test_missing_normal_load_names_the_keyword_of_the_problem():
    grid = ss.Grid.square(8, 4.0)
    bodies = ss.HalfSpace(grid, (ss.Material(1.0, 0.2), ss.Material.rigid()))
    ball = ss.surface.sphere(grid, 10.0)
    with pytest.raises(TypeError, match="normal_force="):
        ss.CoupledProblem(bodies, ball, 0.3, force_x=1.0)
    with pytest.raises(TypeError, match="load by force="):
        ss.NormalProblem(bodies, ball)


@pytest.mark.parametrize(
    ("call", "argument", "found"),
    [
        (lambda scene: ss.Settings(method="no"), "method", "'no'"),
        (lambda scene: ss.NormalProblem(scene.bodies, scene.ball, force=1.0, method=3), "method", "int"),
        (lambda scene: ss.TangentialProblem(scene.bodies, scene.ball, 0.5, force_x=1.0, model="Vector"), "model", "'Vector'"),
        (lambda scene: ss.History(scene.bodies, scene.ball, 0.5, coupling="one way"), "coupling", "'one way'"),
        (lambda scene: ss.HalfSpace(scene.grid, (STEEL, STEEL), cell_value="center"), "cell_value", "'center'"),
        (lambda scene: ss.Kernel.tabulated(scene.bodies.pair, (1.0, 1.0), {"zw": np.ones((2, 2))}), "a key of coefficients", "'zw'"),
        (
            lambda scene: ss.adaptive.AdaptiveProblem(
                (STEEL, STEEL), lambda x, y: x**2 + y**2, ss.adaptive.Region.rectangle((-1.0, 1.0), (-1.0, 1.0)), force=1.0, target={"forse": 0.1}
            ),
            "a key of target",
            "'forse'",
        ),
    ],
)
def test_unknown_name_message_names_argument(scene, call, argument, found):
    error = TypeError if found == "int" else ValueError
    with pytest.raises(error, match=rf"^{argument} must be one of '.*', or a member of stickslip\.[\w.]+, got {found}$") as refused:
        call(scene)
    assert refused.value.argument == argument


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda scene: ss.layers.Layer(380e9, 0.22, 1.0, thickness=5e-6), "by position, and thickness= by keyword"),
        (lambda scene: scene.history().press(normal_force=FORCE), "by tolerance=, such as tolerance=0.01"),
        (lambda scene: ss.History.load("state"), "bodies must be of the class HalfSpace, got str: the bodies are the first argument"),
        (lambda scene: ss.History.load(scene.bodies), r"give the path after the bodies: History\.load\(bodies, path\)"),
    ],
)
def test_missing_argument_message_names_it(scene, call, message):
    with pytest.raises(TypeError, match=message):
        call(scene)


@pytest.mark.parametrize("threads", [0, -1, 10**30])
def test_number_of_threads_message_states_remedy(threads):
    before = ss.num_threads()
    message = r"must be at least 1, got -?\d: for the number of cores give os\.cpu_count\(\)" if threads <= 0 else "is too large"
    with pytest.raises(ss.errors.ArgumentRange, match=f"^threads {message}") as refused:
        ss.set_num_threads(threads)
    assert refused.value.argument == "threads" and ss.num_threads() == before


def test_modulus_in_place_of_poisson_ratio_is_named(scene):
    for call in (lambda: ss.Material(0.3, 210e9), lambda: ss.layers.Layer(0.3, 210e9, thickness=1.0)):
        with pytest.raises(ss.errors.PoissonRatio, match=r"got 210000000000\.0: the modulus precedes Poisson's ratio$"):
            call()
    with pytest.raises(ss.errors.PoissonRatio, match=r"got 0\.6$"):
        ss.Material(210e9, 0.6)


def test_coupled_materials_message_names_classes(scene):
    pair = ss.HalfSpace(scene.grid, (STEEL, ss.Material(70e9, 0.33)))
    normal = ss.NormalProblem(pair, scene.ball, force=FORCE).solve()
    message = r'use CoupledProblem or History with coupling="full", or accept the error of coupling="one_way" or "neglected"$'
    with pytest.raises(ss.errors.CoupledMaterials, match=message):
        ss.TangentialProblem(pair, normal, 0.5, force_x=1.0, coupling="full")
    # Bodies of the same material are not coupled.
    shear = [ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, force_x=20.0, coupling=name).solve() for name in ("full", "one_way")]
    assert np.array_equal(shear[0].traction[0], shear[1].traction[0])
    assert "accept every value" in ss.TangentialProblem.__doc__
