"""Pickling of all values without changes, and of histories whose continuation is bitwise identical."""

import concurrent.futures
import copy
import multiprocessing
import pickle

import numpy as np
import pytest

import stickslip as ss
from conftest import FORCE


def same(value):
    return pickle.loads(pickle.dumps(value))


def test_values_round_trip(scene):
    bulk = ss.tangential.RelativeDisplacement.bulk_strain(scene.grid, [[1e-3, 0.0], [0.0, 0.0]])
    for value in [
        scene.grid,
        ss.Material(1.0, 0.3, hardness=0.1),
        ss.Material.rigid(),
        ss.Material(1.0, 0.3).coated([ss.layers.Layer(2.0, 0.2, thickness=0.1)]),
        scene.bodies.pair,
        ss.Boundary.periodic_along_y(3.0),
        scene.ball,
        ss.Settings(tolerance=1e-5, time_limit=2.5),
        ss.LoadStep(normal_force=1.0, shift_x=2.0, spring_y=ss.Spring(position=1.0, stiffness=2.0), twist=0.1),
        ss.LoadStep(force_x=1.0, roll=ss.history.Rolling(2, creepage_y=0.1)),
        ss.history.Rolling(2, creepage=(0.1, 0.2), spin=0.3, leading_edge="minus_y"),
        ss.TangentialLoad(force=(1.0, 2.0)),
        ss.Friction(0.3, max_shear_stress=5.0),
        ss.Friction(scene.ball),
        ss.normal.Hardness(3.0),
        ss.history.LoadPath.ellipse((1.0, 2.0), 0.3, 8),
        ss.surface.SelfAffine(rms_height=1.0, seed=7),
        bulk,
    ]:
        assert same(value) == value and type(same(value)) is type(value)
        assert copy.deepcopy(value) == value
    assert same(ss.Axis.X) is ss.Axis.X
    bodies = same(scene.bodies)
    assert (bodies.grid, bodies.pair, bodies.boundary) == (scene.grid, scene.bodies.pair, scene.bodies.boundary)


def test_bulk_strain_round_trips_with_strain(scene):
    bulk = ss.tangential.RelativeDisplacement.bulk_strain(scene.grid, [[1e-3, 0.0], [0.0, 0.0]])
    bodies = ss.HalfSpace(scene.grid, scene.bodies.pair, boundary="periodic")
    for relative in (bulk, same(bulk), copy.deepcopy(bulk)):
        # On a periodic grid the field would be discontinuous, because fields without a strain must be periodic.
        with pytest.raises(ss.errors.Sample, match="bulk strain at .* is 0.001"):
            ss.TangentialProblem(bodies, scene.ball, 0.5, force_x=0.0, model="vector", relative_displacement=relative)


def test_closed_forms_and_statistics_round_trip(scene):
    pair, hertz = scene.bodies.pair, scene.hertz
    forms = ss.analytical
    line, ellipse = forms.HertzLine(pair, radius=0.01, load=1e4), forms.HertzEllipse(pair, radius_x=1e-2, radius_y=2e-2, load=100.0)
    waves, cone = forms.Westergaard(pair, amplitude=1e-6, wavelength=1e-3, mean_pressure=1e7), forms.Cone(pair, slope=0.01, load=10.0)
    made = [
        hertz, line, ellipse, waves, cone, forms.CattaneoMindlin(hertz, friction=0.5, force=20.0), forms.CattaneoMindlinLine(line, friction=0.5, force=1e3),
        forms.CattaneoMindlinEllipse(ellipse, friction=0.5, force=20.0), forms.ConePartialSlip(cone, friction=0.5, force=1.0), forms.FlatPunch(pair, radius=1e-3, load=10.0),
        forms.Carter(line, friction=0.3, creepage=1e-4), forms.BentallJohnson(line, friction=0.01), forms.KalkerCoefficients(0.5, poisson_ratio=0.3),
        forms.VermeulenJohnson(ellipse, friction=0.3, creepage=(1e-3, 2e-3)),
        forms.LubkinTorsion(hertz, friction=0.5, twist=1e-3), forms.Persson(pair, rms_slope=0.1, mean_pressure=1e9),
        forms.MindlinDeresiewicz(hertz, friction=0.5, path=[30.0, -30.0, 10.0]), forms.MindlinFullStick(pair, contact_radius=1e-3, force=1.0),
        forms.NoSlipPunch(pair, radius=1e-3, load=10.0), forms.NoSlipSphere(pair, radius=1e-2, load=10.0), forms.SpencePressing.round(pair, 0.3),
        forms.RoughSphere(hertz, rms_slope=0.1), forms.RoundedPunch(pair, flat=1e-3, radius=1e-2, load=1e4), forms.WestergaardPartialSlip(waves, friction=0.5, mean_traction=1e6),
        forms.PopovLimitingShape(pair, radius=3.5e-3, approach=1e-6, stick_radius=1e-5), ss.surface.Statistics(scene.ball),
        ss.surface.MaterialRatio(scene.ball), ss.surface.Autocorrelation(scene.ball), ss.NormalProblem(
            scene.bodies, scene.ball, force=FORCE).solve().spots,
    ]  # fmt: skip
    assert {type(form) for form in made} >= {form for form in vars(forms).values() if isinstance(form, type)}
    for value in made:
        back = same(value)
        assert back == value and repr(back) == repr(value) and type(back) is type(value) and copy.deepcopy(value) == value
    assert np.array_equal(same(made[-1]).labels, made[-1].labels)


def test_problems_round_trip_with_identical_solutions(scene):
    bulk = ss.tangential.RelativeDisplacement.bulk_strain(scene.grid, [[1e-6, 0.0], [0.0, 0.0]])
    contact = scene.normal()
    mu = np.full(scene.grid.shape, 0.5)
    grid = ss.Grid.square(16, 0.3)
    bodies = ss.HalfSpace(grid, (ss.Material(70e3, 0.33), ss.Material(210e3, 0.3)))
    for problem in [
        ss.NormalProblem(scene.bodies, scene.ball, force=FORCE, hardness=2e9, tolerance=1e-6),
        ss.NormalProblem(scene.bodies, scene.ball.array, approach=1e-6),
        ss.TangentialProblem(scene.bodies, contact, mu, force=(10.0, 5.0), model="vector", coupling="neglected"),
        ss.TangentialProblem(scene.bodies, contact.pressure, 0.5, shift_y=1e-7, model="vector", relative_displacement=bulk),
        ss.CoupledProblem(bodies, ss.surface.sphere(grid, 3.5), 0.1, normal_force=60.0, force_x=1.0, tolerance=1e-6),
    ]:
        for back in (same(problem), copy.deepcopy(problem)):
            assert type(back) is type(problem) and back.solve() == problem.solve()


def test_materials_hash_consistently_with_equality():
    steel = ss.Material(210e9, 0.3)
    for value in (steel, ss.ElasticPair(steel, ss.Material.rigid())):
        assert hash(value) == hash(same(value)) and len({value, same(value)}) == 1
    assert ss.Material(1.0, 0.0) == ss.Material(1.0, -0.0) and hash(ss.Material(1.0, 0.0)) == hash(ss.Material(1.0, -0.0))
    assert len({steel, ss.Material(210e9, 0.3, hardness=1e9), ss.Material(210e9, 0.31)}) == 3


def test_solutions_compare_without_time(scene):
    grid = ss.Grid.square(16, 0.3)
    bodies = ss.HalfSpace(grid, (ss.Material(70e3, 0.33), ss.Material(210e3, 0.3)))
    for problem in (
        ss.NormalProblem(scene.bodies, scene.ball, force=FORCE),
        ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, force_x=20.0),
        ss.CoupledProblem(bodies, ss.surface.sphere(grid, 3.5), 0.1, normal_force=60.0),
    ):
        one, two = problem.solve(), problem.solve()
        assert one.report != two.report  # at least the times differ
        assert one == two and not one != two
    assert scene.normal() != ss.NormalProblem(scene.bodies, scene.ball, force=FORCE * (1.0 + 1e-9)).solve()


def test_solutions_round_trip_bitwise(scene):
    contact = scene.normal()
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=20.0).solve()
    assert same(contact) == contact and same(shear) == shear
    assert np.array_equal(same(contact).pressure, contact.pressure)
    assert same(contact).report == contact.report


def test_surfaces_round_trip(scene):
    rough = ss.surface.SelfAffine(rms_height=1e-6, seed=3).generate(scene.grid)
    measured = rough.heights.array.copy()
    measured[3, 4] = np.nan
    field = ss.Field(scene.grid, measured, "um")
    made = [
        (rough, ["heights", "array", "rms_slope", "kurtosis", "iterations"]),
        (ss.surface.PowerSpectrum(rough.heights), ["wave_numbers", "values", "modes", "moments"]),
        (ss.surface.level(field, "plane"), ["heights", "form"]),
        (ss.surface.fill_missing(field), ["heights", "filled_cells"]),
        (ss.surface.gaussian_filter(field, s=2e-5), ["heights", "short_waves", "long_waves", "valid_range"]),
    ]
    for value, attributes in made:
        for back in (same(value), copy.deepcopy(value)):
            assert type(back) is type(value) and repr(back) == repr(value)
            for name in attributes:
                ours, theirs = getattr(back, name), getattr(value, name)
                assert (ours is None) == (theirs is None)
                if theirs is not None:
                    assert np.array_equal(np.asarray(ours), np.asarray(theirs), equal_nan=True), name
                    assert getattr(ours, "unit", None) == getattr(theirs, "unit", None)
    assert same(rough) == rough and same(made[1][0]) == made[1][0]


def test_edges_and_stiffnesses_round_trip(scene):
    contact = scene.normal()
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=20.0).solve()
    edges = shear.edges(contact, 0.5)
    stiffness = ss.stiffness.ContactStiffness(scene.bodies, contact, 0.5, shear)
    for value in (contact.edges(), edges, edges.stick, stiffness.normal):
        assert same(value) == value == copy.deepcopy(value) and repr(same(value)) == repr(value)
    assert np.array_equal(same(edges).stick.outline, edges.stick.outline)
    # The scalar model has no derivatives across its axis, which are NaN.
    for value in (stiffness, stiffness.tangential):
        assert repr(same(value)) == repr(value)
    assert np.array_equal(same(stiffness).tangential.loading, stiffness.tangential.loading, equal_nan=True)


def test_results_return_from_processes(scene):
    contact = scene.normal()
    rough = ss.surface.SelfAffine(rms_height=1e-6, seed=3)
    with concurrent.futures.ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
        assert pool.submit(rough.generate, scene.grid).result(timeout=120) == rough.generate(scene.grid)
        assert pool.submit(contact.edges).result(timeout=120) == contact.edges()


def test_coupled_solutions_round_trip():
    grid = ss.Grid.square(16, 0.3)
    bodies = ss.HalfSpace(grid, (ss.Material(70e3, 0.33), ss.Material(210e3, 0.3)))
    contact = ss.CoupledProblem(bodies, ss.surface.sphere(grid, 3.5), 0.1, normal_force=60.0).solve()
    back = same(contact)
    assert back.normal == contact.normal and back.tangential == contact.tangential and back.report == contact.report
    assert same(contact.normal) == contact.normal


def test_histories_continue_bitwise_identically(scene, tmp_path):
    history = scene.history(model="vector")
    history.step(normal_force=FORCE)
    step = history.step(force=(20.0, 10.0))
    cycle = ss.history.Cycle(history)
    history.step(force=(10.0, 10.0))
    cycle.add(history)
    history.save(tmp_path / "history")
    copies = [
        same(history),
        ss.History.from_bytes(scene.bodies, history.to_bytes()),
        ss.History.load(scene.bodies, tmp_path / "history"),
        ss.History.from_state(scene.bodies, same(history.state())),
    ]
    numbers = same(history.last_step)
    assert numbers.tangential_force == history.last_step.tangential_force and np.array_equal(numbers.slip[0], history.last_step.slip[0])
    assert same(cycle).points == cycle.points
    history.step(force=(-20.0, 5.0))
    for other in copies:
        other.step(force=(-20.0, 5.0))
        assert other.to_bytes() == history.to_bytes()
    with pytest.raises(RuntimeError, match="keep"):
        pickle.dumps(step)


@pytest.mark.parametrize("name", dir(ss.errors))
def test_exceptions_round_trip_with_numbers(scene, name):
    kind = getattr(ss.errors, name)
    numbers = {"report": scene.normal().report, "last_iterate": scene.normal(), "sides": [1.0, 2.0], "value": 0.1}
    error = kind("what is wrong")
    for attribute in kind.__dict__.get("__annotations__", {}):
        setattr(error, attribute, numbers.get(attribute, attribute))
    back = same(error)
    assert type(back) is kind and str(back) == str(error) and vars(back) == vars(error)


def test_not_converged_round_trips_with_report_and_iterate(scene):
    with pytest.raises(ss.NotConverged) as stopped:
        scene.normal(max_iterations=1)
    back = same(stopped.value)
    assert back.report == stopped.value.report and back.last_iterate == stopped.value.last_iterate


def test_minimum_round_trips_also_as_last_iterate(scene):
    bed = np.array([1.0, 2.0, 400.0])
    found = ss.cgm.minimise(lambda x: bed * x, [-1.0, -1.0, -1.0], total=2.0, lower_bound=1.0)
    with pytest.raises(ss.NotConverged) as stopped:
        ss.cgm.minimise(lambda x: bed * x, [-1.0, -1.0, -1.0], lower_bound=1.0, max_iterations=1)
    error = same(stopped.value)
    assert error.report == stopped.value.report and np.isnan(error.last_iterate.multiplier)
    assert same(found).multiplier == found.multiplier != 0.0
    for minimum, back in [(found, same(found)), (stopped.value.last_iterate, error.last_iterate)]:
        assert type(back) is type(minimum) and back.report == minimum.report
        assert back.x.shape == (3,) and np.array_equal(back.x, minimum.x) and not minimum.x.flags.writeable


def test_reports_warnings_and_results_round_trip(scene):
    contact = ss.NormalProblem(scene.bodies, scene.ball, force=0.01).solve()
    [response] = ss.subsurface.at_points(scene.bodies, "one", contact, [(0.0, 0.0, 1e-5)])
    history = scene.history()
    history.step(normal_force=FORCE)
    error = ss.history.AdaptiveSteps(history, 0.01).error(history, ss.LoadStep(force_x=10.0))
    for value in [
        contact.report,
        *contact.report.history,
        *contact.warnings,
        *contact.spots,
        response,
        response.stress,
        response.stress.principal,
        error,
        ss.history.Cycle(history).points,
        ss.history.Cycle(history).points[0],
        ss.subsurface.at_points(scene.bodies, "one", contact, [(0.0, 0.0, 1e-5)] * 3),
    ]:
        assert same(value) == value and type(same(value)) is type(value)


def test_pickle_of_different_version_is_rejected(scene):
    restore, (kind, version, content) = scene.grid.__reduce__()
    assert version == ss.__version__ and restore(kind, version, content) == scene.grid
    with pytest.raises(ValueError, match="cannot be read"):
        restore(kind, "0.0.1", content)
    with pytest.raises(ValueError):
        restore("NormalSolution", version, content)
