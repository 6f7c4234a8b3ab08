"""Steady and transient rolling with prescribed creepages, forces and moments, compared with Carter and Kalker."""

import pickle

import numpy as np
import pytest

import stickslip as ss
from stickslip.history import Rolling
from stickslip.rolling import CreepForces, RollingProblem

FRICTION = 0.3


class Ball:
    """Ball that rolls on a plane of the same material, with unit shear modulus and unit load."""

    def __init__(self, cells=24):
        body = ss.Material.from_shear_modulus(1.0, 0.25)
        self.bodies = ss.HalfSpace(ss.Grid.square(cells, 3.0), (body, body))
        gap = ss.surface.sphere(self.bodies.grid, 1.0)
        self.normal = ss.NormalProblem(self.bodies, gap, force=1.0).solve()
        self.radius = ss.analytical.HertzSphere(self.bodies.pair, radius=1.0, load=1.0).contact_radius

    def problem(self, **options):
        return RollingProblem(self.bodies, self.normal, FRICTION, **options)

    def history(self, **options):
        gap = ss.surface.sphere(self.bodies.grid, 1.0)
        history = ss.History(self.bodies, gap, FRICTION, model="vector", **options)
        history.step(normal_force=1.0)
        return history


@pytest.fixture(scope="module")
def ball():
    return Ball()


def test_rolling_cylinder_matches_carter():
    steel = ss.Material(210e3, 0.3)
    hertz = ss.analytical.HertzLine(ss.ElasticPair(steel, steel), radius=10.0, load=100.0)
    side = 2.5 * hertz.half_width
    grid = ss.Grid(128, 1, side / 128, 1.0)
    bodies = ss.HalfSpace(grid, (steel, steel), boundary=ss.Boundary.periodic_along_y(side))
    normal = ss.NormalProblem(bodies, ss.surface.cylinder(grid, 10.0), force=100.0).solve()
    slides_at = ss.analytical.Carter(hertz, friction=FRICTION, creepage=0.0).sliding_creepage
    exact = ss.analytical.Carter(hertz, friction=FRICTION, creepage=0.4 * slides_at)
    assert exact.force == pytest.approx(0.64 * FRICTION * 100.0)
    assert exact.stick_half_width == pytest.approx(0.6 * hertz.half_width)
    rolling = RollingProblem(bodies, normal, FRICTION, creepage_x=0.4 * slides_at).solve()
    assert rolling.force[0] == pytest.approx(exact.force, abs=1e-4 * FRICTION * 100.0)
    assert rolling.stick_ratio == pytest.approx(0.6, abs=0.02)
    difference = np.abs(rolling.traction[0][0] - exact.traction(grid.x)).sum()
    assert difference < 0.02 * np.abs(rolling.traction[0]).sum()


def test_rolling_small_creepages_match_kalker(ball):
    solver = ball.problem(creepage_x=0.0).solver()
    stiffness = np.array(solver.stiffness())
    unit = ball.radius**2
    assert stiffness[0, 0] / unit == pytest.approx(4.12, rel=0.02)
    assert stiffness[1, 1] / unit == pytest.approx(3.67, rel=0.02)
    assert stiffness[1, 2] / ball.radius**3 == pytest.approx(1.47, rel=0.02)
    small = 1e-6 * np.array([1.0, -2.0, 0.5])
    rolling = solver.solve(creepage=small[:2], spin=small[2])
    found = np.array([*rolling.force, rolling.moment])
    assert found == pytest.approx(stiffness @ small, abs=1e-3 * np.abs(found).max())


def test_rolling_creep_forces_match_closed_forms(ball):
    coefficients = ss.analytical.KalkerCoefficients(1.0, poisson_ratio=0.25)
    assert (coefficients.c11, coefficients.c22, coefficients.c23) == pytest.approx((4.12, 3.67, 1.47), rel=5e-3)
    hertz = ss.analytical.HertzEllipse(ball.bodies.pair, radius_x=1.0, radius_y=1.0, load=1.0)
    curve = ss.analytical.VermeulenJohnson(hertz, friction=FRICTION, creepage=(0.06, 0.03))
    assert curve.coefficients == coefficients
    linear = np.hypot(coefficients.c11 * 0.06, coefficients.c22 * 0.03) * ball.radius**2 / FRICTION
    assert curve.relative_creepage == pytest.approx(linear)
    assert curve.force == pytest.approx(ball.problem(creepage=(0.06, 0.03)).solve().force, rel=0.04)
    # Rollers of aluminium and steel roll freely.
    pair = ss.ElasticPair(ss.Material(70e3, 0.33), ss.Material(210e3, 0.3))
    line = ss.analytical.HertzLine(pair, radius=10.0, load=100.0)
    free = ss.analytical.BentallJohnson(line, friction=0.01)
    assert free.creepage == pytest.approx(0.9148 * pair.dundurs_beta * line.half_width / 10.0, rel=1e-4)
    x = np.linspace(-line.half_width, line.half_width, 2001)[1:-1]
    lost = -(free.traction(x) * free.slip(x)).sum() * (x[1] - x[0])
    assert lost == pytest.approx(free.dissipation, rel=1e-3)


def test_rolling_prescribed_force_gives_creepage(ball):
    solver = ball.problem(force=(0.1, 0.05)).solver()
    rolling = solver.solve()
    assert rolling.force == pytest.approx((0.1, 0.05), rel=1e-8)
    by_creepage = solver.solve(creepage=rolling.creepage)
    assert by_creepage.force == pytest.approx(rolling.force, rel=1e-6)
    assert solver.report.is_converged and rolling.report.is_converged
    mixed = solver.solve(force_x=0.1, creepage_y=0.02)
    assert mixed.force[0] == pytest.approx(0.1, rel=1e-8) and mixed.creepage[1] == 0.02


def test_rolling_solver_keeps_last_values_of_omitted_arguments(ball):
    solver = ball.problem(creepage=(0.05, 0.02), spin=0.1, tolerance=1e-8).solver()

    def controls(rolling):
        return (*rolling.creepage, rolling.spin)

    assert controls(solver.solve(creepage_x=0.01)) == (0.01, 0.02, 0.1)
    assert controls(solver.solve(spin=0.2)) == (0.01, 0.02, 0.2)
    assert controls(solver.solve()) == (0.01, 0.02, 0.2)
    forced = solver.solve(force_x=0.05)
    assert forced.force[0] == pytest.approx(0.05, rel=1e-6) and controls(forced)[1:] == (0.02, 0.2)
    turned = solver.solve(moment=0.0)
    assert turned.force[0] == pytest.approx(0.05, rel=1e-6) and turned.creepage[1] == 0.02 and abs(turned.moment) < 1e-6
    assert controls(solver.solve(creepage=(0.0, 0.01), spin=0.0)) == (0.0, 0.01, 0.0)
    # Rejected arguments change nothing.
    with pytest.raises(ss.errors.NotFinite):
        solver.solve(creepage_x=np.nan, spin=0.3)
    assert controls(solver.solve(creepage_y=0.02)) == (0.0, 0.02, 0.0)
    # The last point of a creep curve, or the point that was cancelled, remains prescribed.
    solver.creep_forces([(0.01, 0.0, 0.1), (0.02, 0.0, 0.2)])
    assert controls(solver.solve(creepage_y=0.01)) == (0.02, 0.01, 0.2)
    with pytest.raises(ss.NotConverged):
        solver.creep_forces([(0.01, 0.0, 0.1), (0.02, 0.0, 0.3), (0.03, 0.0, 0.4)], progress=lambda point: False)
    assert controls(solver.solve(creepage_y=0.02)) == (0.02, 0.02, 0.3)
    with pytest.raises(ss.errors.NotFinite):
        solver.creep_forces([(0.5, 0.0, 0.0), (np.inf, 0.0, 0.0)])
    assert controls(solver.solve(creepage_y=0.01)) == (0.02, 0.01, 0.3)


def test_coupled_rolling_solver_keeps_last_values_of_omitted_arguments(ball):
    gap = ss.surface.sphere(ball.bodies.grid, 1.0)
    problem = ss.rolling.CoupledRollingProblem(
        ball.bodies, gap, FRICTION, normal_force=1.0, creepage=(0.05, 0.02), spin=0.1
    )
    solver = problem.solver()

    def controls(solution):
        return (*solution.rolling.creepage, solution.rolling.spin)

    assert controls(solver.solve(creepage_x=0.01)) == (0.01, 0.02, 0.1)
    lighter = solver.solve(normal_force=0.8)
    assert controls(lighter) == (0.01, 0.02, 0.1) and lighter.normal.force == pytest.approx(0.8)
    assert controls(solver.solve(normal_force=1.0, spin=0.2)) == (0.01, 0.02, 0.2)
    with pytest.raises(ss.errors.NotFinite):
        solver.solve(creepage_x=np.nan, spin=0.3)
    assert controls(solver.solve(creepage_y=0.0)) == (0.01, 0.0, 0.2)


def test_rolling_friction_can_change_between_solves(ball):
    solver = ball.problem(force=(0.1, 0.05)).solver()
    before = solver.solve()
    solver.set_friction(2.0 * FRICTION)
    after = solver.solve()
    assert after.force == pytest.approx(before.force, rel=1e-8)
    assert np.hypot(*after.creepage) < np.hypot(*before.creepage) and after.stick_ratio > before.stick_ratio
    with pytest.raises(ss.BeyondFrictionCapacity):
        solver.set_friction(1e-3)
    solver.reset()
    assert solver.solve().creepage == pytest.approx(after.creepage, rel=1e-6)


def test_rolling_prescribed_moment_gives_spin(ball):
    by_spin = ball.problem(spin=0.1).solve()
    by_moment = ball.problem(moment=by_spin.moment).solve()
    assert by_moment.moment == pytest.approx(by_spin.moment, rel=1e-6)
    assert by_moment.spin == pytest.approx(0.1, rel=1e-5)


def test_rolling_work_equals_dissipation(ball):
    def missing(rolling):
        motion = (*rolling.creepage, rolling.spin)
        # The spin displaces a particle by the displacement at the midpoint of its path, half a cell ahead.
        moment = rolling.moment + 0.5 * rolling.grid.dx * rolling.force[1]
        assert rolling.work == pytest.approx(np.dot(motion, (*rolling.force, moment)))
        return 1.0 - rolling.dissipation_per_area.sum() * rolling.grid.cell_area / rolling.work

    given = {"creepage": (0.1, 0.05), "spin": 0.02}
    rolling = ball.problem(**given).solve()
    # The deficit decreases with the cell size.
    assert 0.0 < missing(Ball(48).problem(**given).solve()) < 0.6 * missing(rolling) < 0.12
    against = -sum(q * s for q, s in zip(rolling.traction, rolling.slip, strict=True))
    assert rolling.dissipation_per_area == pytest.approx(against) and (against >= 0.0).all()
    assert (against[rolling.zones != ss.Zone.SLIP] == 0.0).all()


def test_rolling_leading_edge_and_step_are_respected(ball):
    along_x = ball.problem(creepage_x=0.1).solve()
    along_y = ball.problem(creepage_y=0.1, leading_edge="plus_y").solve()
    assert along_y.traction[1].T == pytest.approx(along_x.traction[0], abs=1e-6)
    back = ball.problem(creepage_x=0.1, leading_edge=ss.rolling.LeadingEdge.MINUS_X).solve()
    assert back.traction[0][:, ::-1] == pytest.approx(along_x.traction[0], abs=1e-6)
    coarse = ball.problem(creepage_x=0.1, step=2).solve()
    plain = ball.problem(creepage_x=0.1, entry_rule="whole_step").solve()
    assert len({along_x.force[0], coarse.force[0], plain.force[0]}) == 3
    assert plain.force[0] > along_x.force[0]
    assert [edge.axis for edge in ss.rolling.LeadingEdge] == ["x", "x", "y", "y"]


def test_creep_curve_reaches_sliding(ball):
    points = np.zeros((11, 3))
    points[:, 0] = 0.03 * np.arange(11)
    solver = ball.problem(creepage_x=0.0).solver()
    curve = solver.creep_forces(points)
    force_x, force_y = curve.force
    assert force_x[0] == 0.0 and curve.stick_ratio[-1] == 0.0
    # The contact slides, but not exactly along x.
    assert 0.999 * FRICTION < force_x[-1] < FRICTION
    assert (np.diff(force_x, 2) <= 1e-9).all() and np.abs(force_y).max() < 1e-8
    assert (np.diff(curve.stick_ratio) <= 0.0).all() and (curve.creepage[0] == points[:, 0]).all()
    assert len(curve) == 11 and [point.force[0] for point in curve] == list(force_x)
    assert (curve[3].spin, curve[3].moment) == (curve.spin[3], curve.moment[3])
    assert pickle.loads(pickle.dumps(curve)) == curve and pickle.loads(pickle.dumps(curve[3])) == curve[3]
    # The last point remains prescribed.
    assert solver.solve().creepage == (points[-1, 0], 0.0)
    assert isinstance(solver.creep_forces([]), CreepForces) and len(solver.creep_forces(np.empty((0, 3)))) == 0


def test_rolling_problem_round_trips(ball):
    problem = ball.problem(force_x=0.1, creepage_y=0.01, moment=0.01, leading_edge="minus_x", step=2, tolerance=1e-6)
    again = pickle.loads(pickle.dumps(problem)).solve()
    solution = problem.solve()
    assert (again.traction[0] == solution.traction[0]).all() and again.spin == solution.spin != 0.0


def test_rolling_solutions_round_trip(ball):
    rolling = ball.problem(creepage=(1e-3, 2e-3), spin=0.1).solve(warn=False)
    gap = ss.surface.sphere(ball.bodies.grid, 1.0)
    problem = ss.rolling.CoupledRollingProblem(ball.bodies, gap, FRICTION, normal_force=1.0, creepage_x=1e-3)
    coupled = problem.solve(warn=False)
    both = pickle.loads(pickle.dumps(coupled))
    assert both.report == coupled.report == pickle.loads(pickle.dumps(coupled.report)) and both.normal == coupled.normal
    for back, value in [(pickle.loads(pickle.dumps(rolling)), rolling), (both.rolling, coupled.rolling)]:
        assert repr(back) == repr(value) and back.report == value.report
        assert (back.creepage, back.spin, back.force, back.moment, back.work) == (
            value.creepage, value.spin, value.force, value.moment, value.work
        )  # fmt: skip
        for name in ("traction", "slip", "zones", "dissipation_per_area"):
            assert np.array_equal(getattr(back, name), getattr(value, name))


def test_rolling_rejected_input_leaves_solver_unchanged(ball):
    solver = ball.problem(creepage_x=0.05).solver()
    before = solver.solve()
    with pytest.raises(ss.BeyondFrictionCapacity) as caught:
        solver.solve(force_x=0.31)
    assert (caught.value.force, caught.value.limit) == pytest.approx((0.31, 0.3))
    with pytest.raises(ss.errors.NotFinite, match="creepage"):
        solver.solve(creepage=(0.0, np.nan))
    with pytest.raises(ss.errors.BeyondFrictionMoment, match="moment 1.0"):
        solver.solve(moment=1.0)
    with pytest.raises(ss.errors.NotFinite):
        solver.creep_forces([(0.2, 0.0, 0.0), (np.inf, 0.0, 0.0)])
    with pytest.raises(TypeError, match="one of creepage and force along x"):
        solver.solve(creepage_x=0.1, force_x=0.1)
    with pytest.raises(TypeError, match="a spin or a moment"):
        solver.solve(spin=0.1, moment=0.1)
    with pytest.raises(TypeError, match="creepage must be a pair"):
        solver.solve(creepage=0.1)
    with pytest.raises(TypeError, match=r"\(creepage_x, creepage_y, spin\)"):
        solver.creep_forces([(0.1, 0.0)])
    after = solver.solve()
    assert after.creepage == before.creepage == (0.05, 0.0)
    assert after.force == pytest.approx(before.force, rel=1e-7)


def test_rolling_invalid_contacts_are_rejected(ball):
    with pytest.raises(ss.errors.NotPositive, match="step"):
        ball.problem(step=0, creepage_x=0.0)
    with pytest.raises(ValueError, match="leading_edge must be one of 'plus_x'"):
        ball.problem(leading_edge="x")
    with pytest.raises(ss.errors.Method):
        ball.problem(method="polonsky_keer", creepage_x=0.0)
    with pytest.raises(ss.NotConverged) as caught:
        ball.problem(creepage_x=0.1, max_iterations=1).solve()
    assert isinstance(caught.value.last_iterate, ss.rolling.RollingSolution)
    # The contact reaches the edge of the grid, where particles would enter.
    flat = ss.NormalProblem(ball.bodies, np.zeros((24, 24)), force=1.0).solve(warn=False)
    with pytest.raises(ss.errors.GridTooShort, match="1 cell ahead of the contact, but the grid has 0: extend the grid there by at least 1 cell$"):
        RollingProblem(ball.bodies, flat, FRICTION, creepage_x=0.0)


def test_rolling_history_reaches_steady_state(ball):
    motion = {"creepage": (0.05, 0.02), "spin": 0.01}
    history, last = ball.history(), 0.0
    for _ in range(120):
        step = history.step(roll=Rolling(1, **motion))
        last, before = step.tangential_force[0], last
        assert last > before - 1e-6 and step.creepage == (0.05, 0.02)
    steady = ball.problem(**motion).solve()
    assert step.tangential_force == pytest.approx(steady.force, rel=1e-6)
    assert step.moment == pytest.approx(steady.moment, rel=1e-6)
    assert (history.zones == steady.zones).all()
    energy = step.energy
    assert abs(energy.residual) < 1e-9 * energy.work
    # The motion of each step is the creepage times a cell.
    assert step.shift == pytest.approx((120 * 0.05 * ball.bodies.grid.dx, 120 * 0.02 * ball.bodies.grid.dx))


def test_rolling_step_with_force_gives_creepage(ball):
    history = ball.history()
    held = history.step(force_x=0.1)
    assert held.creepage is None
    for _ in range(120):
        step = history.step(force_x=0.1, roll=Rolling(1, creepage_y=0.02))
    assert step.tangential_force[0] == pytest.approx(0.1, rel=1e-9) and step.creepage[1] == 0.02
    steady = ball.problem(force_x=0.1, creepage_y=0.02).solve()
    assert step.creepage == pytest.approx(steady.creepage, rel=1e-6)
    kept = pickle.loads(pickle.dumps(step.keep()))
    assert kept.creepage == step.creepage


def test_rolling_step_accepts_all_forms_of_load(ball):
    back = Rolling(2, creepage=(-0.1, 0.0), leading_edge="minus_x")
    ahead = Rolling(2, creepage_x=0.1, leading_edge=ss.rolling.LeadingEdge.PLUS_X)
    one, other = ball.history(), ball.history()
    load = ss.LoadStep(roll=back)
    one.step(load)
    other.step(roll=ahead)
    assert one.traction[0][:, ::-1] == pytest.approx(-other.traction[0], abs=1e-6)
    assert load == ss.LoadStep(roll=Rolling(2, creepage_x=-0.1, leading_edge="minus_x")) != ss.LoadStep(roll=ahead)
    assert repr(load) == "LoadStep(roll=Rolling(2, creepage=(-0.1, 0), spin=0, leading_edge='minus_x'))"
    # Adaptive steps and batches accept the same loads as histories.
    assert ss.History.step_all([one], [load]) == []
    with pytest.raises(ss.errors.UnsupportedByModel, match="adaptive"):
        ss.history.AdaptiveSteps(one, 0.05).step(one, load)


def test_rolling_failed_step_leaves_history_unchanged(ball):
    history = ball.history()
    before = history.to_bytes()
    for given, error in [
        ({"roll": Rolling(0)}, ss.errors.NotPositive),
        ({"roll": Rolling(20)}, ss.errors.GridTooShort),
        ({"roll": Rolling(1, creepage_x=np.nan)}, ss.errors.NotFinite),
        ({"roll": Rolling(1, spin=np.inf)}, ss.errors.NotFinite),
        ({"roll": Rolling(1), "shift_x": 0.1}, ss.errors.UnsupportedByModel),
        ({"roll": Rolling(1), "twist": 0.1}, ss.errors.UnsupportedByModel),
        ({"roll": Rolling(1, creepage_x=0.1), "force_x": 0.1}, ss.errors.UnsupportedByModel),
    ]:
        with pytest.raises(error):
            history.step(**given)
        assert history.to_bytes() == before
    with pytest.raises(TypeError, match="one of creepage and creepage_x along x"):
        Rolling(1, creepage=(0.1, 0.0), creepage_x=0.1)
    with pytest.raises(TypeError, match="a load or its keywords"):
        history.step(ss.LoadStep(force_x=0.1), roll=Rolling(1))


def test_rolling_solutions_convert_to_datasets_and_images(ball):
    pytest.importorskip("xarray")
    bodies, normal = ball.bodies, ball.normal
    rolling = ball.problem(creepage_x=1e-3, spin=0.1).solve(warn=False)
    dataset = ss.io.to_xarray(rolling)
    for name, values in [("traction_x", rolling.traction[0]), ("slip_y", rolling.slip[1]), ("dissipation_per_area", rolling.dissipation_per_area)]:
        assert np.array_equal(dataset[name], values) and dataset[name].attrs["long_name"]
    numbers = {"creepage_x": 1e-3, "creepage_y": 0.0, "spin": 0.1, "force_x": rolling.force[0], "work": rolling.work}
    assert {name: dataset.attrs[name] for name in numbers} == numbers
    both = ss.io.to_xarray((normal, rolling))
    assert both.attrs["normal_force"] == normal.force and np.array_equal(both.pressure, normal.pressure)
    assert both.attrs["force_x"] == rolling.force[0] and np.array_equal(both.zones, rolling.zones)
    gap = ss.surface.sphere(bodies.grid, 1.0)
    problem = ss.rolling.CoupledRollingProblem(bodies, gap, FRICTION, normal_force=1.0, creepage_x=1e-3)
    coupled = problem.solve(warn=False)
    both = ss.io.to_xarray(coupled)
    assert np.array_equal(both.pressure, coupled.normal.pressure) and np.array_equal(both.traction_x, coupled.rolling.traction[0])

    names = {"traction": rolling.traction, "slip": rolling.slip, "zones": rolling.zones, "dissipation_per_area": rolling.dissipation_per_area}
    assert ss.io.vti.to_bytes(rolling) == ss.io.vti.to_bytes(names, grid=bodies.grid)
    image = ss.io.vti.to_bytes(coupled)
    assert all(f'Name="{name}"'.encode() in image for name in ("pressure", "traction", "dissipation_per_area"))


def test_coupled_rolling_solver_rejects_force_beyond_friction_before_solve(ball):
    gap = ss.surface.sphere(ball.bodies.grid, 1.0)
    solver = ss.rolling.CoupledRollingProblem(ball.bodies, gap, FRICTION, normal_force=1.0, force_x=0.5 * FRICTION).solver()
    with pytest.raises(ss.errors.BeyondFrictionCapacity):
        solver.set_normal_load(normal_force=0.4)
    with pytest.raises(ss.errors.BeyondFrictionCapacity):
        ss.rolling.CoupledRollingProblem(ball.bodies, gap, FRICTION, normal_force=1.0, force_x=1.1 * FRICTION)


def test_rolling_solver_accepts_new_loads(ball):
    gap = ss.surface.sphere(ball.bodies.grid, 1.0)
    solver = ball.problem(creepage_x=0.02).solver()
    with pytest.raises(ss.errors.UnsupportedByModel, match="set a normal solver first"):
        solver.set_normal_load(normal_force=0.8)
    solver.set_normal_solver(ss.NormalSolver(ball.bodies, gap, force=1.0))
    solver.set_normal_load(normal_force=0.8)
    assert solver.friction_capacity == pytest.approx(0.8 * FRICTION)
    light = ss.NormalProblem(ball.bodies, gap, force=0.8).solve()
    expected = RollingProblem(ball.bodies, light, FRICTION, creepage_x=0.02).solve()
    assert solver.solve().force == pytest.approx(expected.force, abs=1e-6)
    assert expected.warnings == []
    solver.set_pressure(ball.normal)
    assert solver.solve().force == pytest.approx(ball.problem(creepage_x=0.02).solve().force, abs=1e-6)
    with pytest.raises(ss.errors.UnsupportedByModel, match="gap"):
        solver.set_pressure(ball.normal.pressure)
    with pytest.raises(ss.errors.EmptyContact):
        solver.set_normal_load(normal_force=0.0)
