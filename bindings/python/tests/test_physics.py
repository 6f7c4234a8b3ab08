"""Comparison of the solutions of all kinds of problems with closed-form solutions."""

import itertools
import math
import signal
import warnings

import numpy as np
import pytest

import stickslip as ss
from conftest import FORCE, RADIUS


def test_normal_ball_matches_hertz(scene):
    contact = scene.normal()
    assert contact.force == pytest.approx(FORCE, rel=1e-12)
    assert contact.approach == pytest.approx(scene.hertz.approach, rel=2e-4)
    x, y = np.meshgrid(scene.grid.x, scene.grid.y)
    exact = scene.hertz.pressure(np.hypot(x, y))
    assert np.abs(contact.pressure - exact).sum() < 6e-3 * exact.sum()
    assert contact.report.is_converged and contact.report.energy_error_bound < 1e-8
    assert contact.centre_of_pressure == pytest.approx((0.0, 0.0), abs=1e-12)


def test_normal_prescribed_approach_gives_force(scene):
    contact = ss.NormalProblem(scene.bodies, scene.ball, approach=scene.hertz.approach).solve()
    assert contact.force == pytest.approx(FORCE, rel=1e-3)


def test_tangential_ball_matches_cattaneo_mindlin(scene):
    shear = ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, force_x=20.0).solve()
    exact = ss.analytical.CattaneoMindlin(scene.hertz, friction=0.5, force=20.0)
    assert shear.force == pytest.approx((20.0, 0.0), rel=1e-12)
    assert shear.shift[0] == pytest.approx(exact.shift, rel=1e-3)
    assert shear.stick_ratio == pytest.approx(exact.stick_ratio, abs=0.02)
    along_y = ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, force_y=20.0).solve()
    assert along_y.axis == ss.Axis.Y == "y"
    assert along_y.traction[1].T == pytest.approx(shear.traction[0], abs=1e-6 * shear.traction[0].max())


def test_solver_successive_loads_match_problems(scene):
    solver = ss.NormalSolver(scene.bodies, scene.ball, force=1.0)
    for force in (10.0, 100.0, 40.0):
        warm = solver.solve(force=force)
        cold = ss.NormalProblem(scene.bodies, scene.ball, force=force).solve()
        assert warm.approach == pytest.approx(cold.approach, rel=1e-8)
    tangential = ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, force_x=0.0).solver()
    ratios = [tangential.solve(force_x=force).stick_ratio for force in (0.0, 10.0, 30.0, 49.0)]
    assert ratios[0] == 1.0 and ratios == sorted(ratios, reverse=True)
    assert tangential.friction_capacity == pytest.approx(50.0)


def test_cycle_dissipation_matches_mindlin_deresiewicz(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    history.step(force_x=30.0)
    cycle = ss.history.Cycle(history)
    for force in (-30.0, 30.0):
        step = history.step(ss.LoadStep(force_x=force))
        assert step.energy.imbalance < 1e-6
        cycle.add(history)
    quarter = ss.analytical.CattaneoMindlin(scene.hertz, friction=0.5, force=30.0).energy_of_first_quarter
    assert cycle.energy.dissipated_energy == pytest.approx(4.0 * quarter, rel=0.01)
    assert cycle.regime == ss.history.Regime.PARTIAL_SLIP
    assert cycle.force_amplitude == pytest.approx((30.0, 0.0))
    exact = ss.analytical.MindlinDeresiewicz(scene.hertz, friction=0.5, path=[30.0, -30.0, 30.0])
    assert history.shift[0] == pytest.approx(exact.shift, rel=2e-3)


def test_vector_model_supports_twist(scene):
    history = scene.history(model="vector")
    history.step(normal_force=FORCE)
    step = history.step(force_x=10.0, shift_y=0.4e-6, twist=2e-3)
    assert step.moment > 0.0 and step.tangential_force[1] > 0.0
    sliding = ss.analytical.LubkinTorsion(scene.hertz, friction=0.5, twist=2e-3)
    assert step.moment < sliding.sliding_moment


def test_springs_in_series_share_motion(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    step = history.step(spring_x=ss.Spring(position=1e-6, stiffness=1e7))
    assert step.tangential_force[0] == pytest.approx(1e7 * (1e-6 - step.shift[0]), rel=1e-9)


def test_stiffness_matches_finite_difference(scene):
    contact = scene.normal()
    stiffness = contact.stiffness(scene.bodies)
    assert stiffness.value == pytest.approx(2.0 * scene.bodies.pair.contact_modulus * scene.hertz.contact_radius, rel=0.02)
    history = scene.history()
    history.step(normal_force=FORCE, force_x=0.0)
    tangential = history.stiffness().tangential
    mindlin = 8.0 * scene.bodies.pair.equivalent_shear_modulus / (2.0 - scene.bodies.pair.equivalent_poisson_ratio)
    assert tangential.reversal[0][0] == pytest.approx(mindlin * scene.hertz.contact_radius, rel=0.02)
    following = history.stiffness(next_step=True).tangential
    assert following.loading[0][0] == pytest.approx(tangential.reversal[0][0], rel=1e-9)
    assert tangential.loading[0][0] < 0.8 * following.loading[0][0]


def test_dissimilar_bodies_slip_under_normal_load():
    grid = ss.Grid.square(32, 0.3)
    pair = (ss.Material(70e3, 0.33), ss.Material(210e3, 0.3))
    bodies = ss.HalfSpace(grid, pair)
    ball = ss.surface.sphere(grid, 3.5)
    contact = ss.CoupledProblem(bodies, ball, 0.1, normal_force=60.0, force_x=1.0).solve()
    assert contact.normal.force == pytest.approx(60.0) and contact.tangential.force[0] == pytest.approx(1.0)
    assert contact.tangential.slip_area > 0.0
    solver = ss.CoupledProblem(bodies, ball, 0.1, normal_force=60.0).solver()
    solver.set_loads(ss.TangentialLoad(force_x=1.0), normal_force=60.0)
    assert solver.solve().normal.approach == pytest.approx(contact.normal.approach, rel=1e-6)
    solver.set_loads(normal_force=50.0)  # an omitted load keeps its last value
    less = solver.solve()
    assert less.normal.force == pytest.approx(50.0) and less.tangential.force[0] == pytest.approx(1.0)
    solver.set_loads(ss.TangentialLoad(force_x=2.0))
    more = solver.solve()
    assert more.normal.force == pytest.approx(50.0) and more.tangential.force[0] == pytest.approx(2.0)
    with pytest.raises(TypeError, match="give a tangential load by TangentialLoad"):
        solver.set_loads()
    with pytest.raises(ss.errors.StickslipError):
        solver.set_loads(normal_force=-1.0)
    assert solver.solve().normal.force == pytest.approx(50.0)
    most = 0.8 * contact.normal.pressure.max()
    soft = ss.CoupledProblem(bodies, ball, 0.1, normal_force=60.0, force_x=1.0, hardness=most).solve()
    assert soft.normal.pressure.max() == most and soft.normal.yielded_cells > 0
    with pytest.raises(ss.errors.CoupledMaterials) as refused:
        ss.TangentialProblem(bodies, contact.normal, 0.1, force_x=1.0, coupling="full")
    assert refused.value.beta == pytest.approx(bodies.pair.dundurs_beta)


def test_stiffness_of_dissimilar_bodies_matches_finite_difference():
    grid = ss.Grid.square(32, 0.3)
    bodies = ss.HalfSpace(grid, (ss.Material(70e3, 0.33), ss.Material(210e3, 0.3)))
    solver = ss.CoupledProblem(bodies, ss.surface.sphere(grid, 3.5), 0.3, approach=5e-3, shift_x=5e-4, tolerance=1e-10).solver()

    def forces(shift):
        solver.set_loads(ss.TangentialLoad(shift_x=shift), approach=5e-3)
        contact = solver.solve()
        return np.array([contact.normal.force, contact.tangential.force[0]])

    step = 2e-8
    normal, tangential = (forces(5e-4 + step) - forces(5e-4 - step)) / (2.0 * step)
    solver.set_loads(ss.TangentialLoad(shift_x=5e-4), approach=5e-3)
    stiffness = solver.solve().stiffness(bodies, 0.3)
    assert isinstance(stiffness, ss.stiffness.ContactStiffness)
    assert stiffness.tangential.loading[0][0] == pytest.approx(tangential, rel=1e-4)
    assert stiffness.normal_by_motion[0] == pytest.approx(normal, abs=1e-4 * stiffness.normal.value)
    with pytest.raises(ss.errors.MaterialMismatch):
        solver.solve().stiffness(ss.HalfSpace(grid, (ss.Material(70e3, 0.33), ss.Material.rigid())), 0.3)


def test_stresses_below_ball_match_hertz(scene):
    contact = scene.normal()
    depth = 0.48 * scene.hertz.contact_radius
    points = ss.subsurface.at_points(scene.bodies, "one", contact, [[0.0, 0.0, depth]])
    assert points[0].stress.max_shear == pytest.approx(0.31 * scene.hertz.max_pressure, rel=0.01)
    plane = ss.subsurface.Planes(scene.bodies, [depth], displacements=True).solve(0, ss.subsurface.Body.ONE, contact)
    assert plane.von_mises.max() == pytest.approx(0.62 * scene.hertz.max_pressure, rel=0.02)
    assert plane.displacement[2].shape == scene.grid.shape
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=20.0).solve()
    fields = ss.subsurface.at_points(scene.bodies, "two", (contact.pressure, shear.traction), [[0.0, 0.0, depth]])
    solutions = ss.subsurface.at_points(scene.bodies, "two", (contact, shear), [[0.0, 0.0, depth]])
    assert fields == solutions


def test_hardness_limits_pressure(scene):
    limit = 0.7 * scene.hertz.max_pressure
    contact = scene.normal(hardness=limit)
    assert contact.pressure.max() == limit and contact.yielded_cells > 0
    overlap = ss.normal.Hardness(limit).overlap(contact)
    assert overlap.max() > 0.0
    with pytest.raises(ss.BeyondHardness) as refused:
        ss.NormalProblem(scene.bodies, scene.ball, force=1e9, hardness=limit)
    assert refused.value.capacity == pytest.approx(limit * scene.grid.area)


def test_line_contact_matches_hertz():
    steel = ss.Material(210e3, 0.3)
    grid = ss.Grid.line(256, 0.004)
    bodies = ss.HalfSpace(grid, (steel, steel), boundary=("periodic_along_y", 50.0))
    contact = ss.NormalProblem(bodies, ss.surface.cylinder(grid, 20.0), force=200.0).solve()
    hertz = ss.analytical.HertzLine(bodies.pair, radius=20.0, load=200.0)
    assert contact.pressure.max() == pytest.approx(hertz.max_pressure, rel=1e-3)
    assert contact.approach == pytest.approx(hertz.approach(50.0), rel=1e-3)


def test_periodic_waves_match_westergaard():
    grid = ss.Grid.square(64, 1.0)
    bodies = ss.HalfSpace(grid, (ss.Material(1.0, 0.5), ss.Material.rigid()), boundary=ss.Boundary.PERIODIC)
    gap = ss.surface.sinusoidal(grid, 0.01, 1.0)
    exact = ss.analytical.Westergaard(bodies.pair, amplitude=0.01, wavelength=1.0, mean_pressure=0.01)
    contact = ss.NormalProblem(bodies, gap, force=0.01).solve()
    assert contact.contact_area == pytest.approx(exact.contact_fraction, abs=0.04)


def test_fretting_loop_becomes_steady_and_wears(scene):
    history = scene.history(tolerance=1e-6)
    path = ss.history.LoadPath.sine((1e-6, 0.0), 8)
    loop = ss.history.FrettingLoop(
        path, lambda shift: ss.LoadStep(normal_force=FORCE, shift=shift), until_steady=1e-3
    )
    outcome = loop.run(history, 5)
    assert outcome.ending == ss.history.StopReason.STEADY and outcome.cycles == 2
    depth = ss.wear.energy(1e-14, outcome.last.dissipation, grid=scene.grid)
    worn = depth.sum() * scene.grid.cell_area
    assert worn == pytest.approx(1e-14 * outcome.last.energy.dissipated_energy)
    jump = ss.wear.CycleJump(scene.bodies, outcome.last, depth, cycles_left=1e6, max_residual=1e-2).cycles()
    assert type(jump) is int and 0 < jump <= 1e6
    history.set_gap(ss.Field(scene.grid, history.gap_as_set) + ss.Field(scene.grid, jump * depth))
    assert history.step(normal_force=FORCE).approach != 0.0
    stopped = loop.run(history, 5, observer=lambda history, cycle: cycle.steps < 3)
    assert stopped.ending == "stopped" and stopped.last.steps == 3
    with pytest.raises(ss.errors.Tolerance):
        ss.history.FrettingLoop(path, loop, until_steady=2.0)


def test_cycle_jump_returns_whole_cycles_and_no_infinity(scene):
    history = scene.history(tolerance=1e-6)
    history.step(normal_force=FORCE)
    jumps = {}
    for amplitude in (1e-10, 1e-6):
        path = ss.history.LoadPath.sine((amplitude, 0.0), 8)
        cycle = ss.history.FrettingLoop(path, lambda shift: ss.LoadStep(shift=shift)).run(history, 2).last
        depth = ss.wear.archard(1e-14, history.pressure, cycle.slip_distance)
        jumps[cycle.regime] = lambda depth=depth, cycle=cycle, **limits: ss.wear.CycleJump(scene.bodies, cycle, depth, **limits)
    stick, slip = jumps[ss.history.Regime.FULL_STICK], jumps[ss.history.Regime.PARTIAL_SLIP]

    assert stick().is_unlimited and stick().cycles() is None and repr(stick()) == "CycleJump(cycles=None)"
    with pytest.raises(TypeError):
        np.zeros(scene.grid.shape) * stick().cycles()
    assert stick(cycles_left=1500.7).cycles() == 1500 and not stick(cycles_left=1500.7).is_unlimited

    limit = slip().cycles()
    worn = float(ss.wear.archard(1e-14, history.pressure, cycle.slip_distance).max())
    assert type(limit) is int and limit > 1 and repr(slip()) == f"CycleJump(cycles={limit})"
    # The unrounded limit by the largest depth is 2.5 cycles.
    assert slip(largest_depth=2.5 * worn).cycles() == 2
    assert slip(cycles_left=0.5).cycles() == slip(cycles_left=0).cycles() == 0
    with pytest.raises(ss.errors.NoWholeCycle, match="a cycle removes more than the limit, which is 0.5 cycles: reduce") as refused:
        slip(largest_depth=0.5 * worn, cycles_left=10).cycles()
    assert refused.value.cycles == pytest.approx(0.5)


def test_adaptive_steps_meet_tolerance(scene):
    history = scene.history(model="vector")
    history.step(normal_force=50.0)
    history.step(force_x=20.0)
    load = ss.LoadStep(force=(0.0, 20.0), normal_force=FORCE)
    steps = ss.history.AdaptiveSteps(history, 0.002)
    before = history.to_bytes()
    assert steps.error(history, load).traction > 0.002
    assert history.to_bytes() == before
    cycle = ss.history.Cycle(history)
    assert steps.step(history, load, cycle=cycle) == cycle.steps > 1


def test_press_with_tolerance_matches_spence():
    grid = ss.Grid.square(40, 0.3)
    bodies = ss.HalfSpace(grid, (ss.Material(70e3, 0.33), ss.Material(210e3, 0.3)))
    history = ss.History(bodies, ss.surface.sphere(grid, 3.5), 0.1)
    before = history.to_bytes()
    with pytest.raises(ss.errors.Tolerance):
        history.press(normal_force=60.0, tolerance=0.0)
    with pytest.raises(TypeError, match="not both"):
        history.press(ss.LoadStep(normal_force=60.0), normal_force=60.0, tolerance=0.05)
    assert history.to_bytes() == before
    with pytest.warns(ss.errors.ContactWarning, match="too few steps"):
        assert history.step(normal_force=60.0).stick_ratio == 1.0
    history = ss.History.from_bytes(bodies, before)
    cycle = ss.history.Cycle(history)
    iterations = []
    steps = history.press(normal_force=60.0, tolerance=0.03, cycle=cycle, progress=iterations.append)
    assert cycle.steps == steps and cycle.energy.dissipated_energy > history.last_step.energy.dissipated_energy
    pressed, alone = ss.History.from_bytes(bodies, before), []
    assert pressed.press(normal_force=60.0, tolerance=0.03, progress=alone.append) == steps
    assert pressed.to_bytes() == history.to_bytes()
    # Ctrl-C and the callback end the call in the first and in the second taking of the steps.
    assert len(iterations) > len(alone)
    for last in (1, len(alone) + 1):
        for exception, answer in ((ss.NotConverged, lambda: False), (KeyboardInterrupt, lambda: signal.raise_signal(signal.SIGINT))):
            stopped, count = ss.History.from_bytes(bodies, before), itertools.count(1)
            with pytest.raises(exception):
                stopped.press(
                    normal_force=60.0, tolerance=0.03, cycle=ss.history.Cycle(stopped), progress=lambda _: answer() if next(count) >= last else None
                )
            assert stopped.to_bytes() == before and next(count) == last + 1
    exact = ss.analytical.SpencePressing.round(bodies.pair, 0.1).stick_radius
    assert steps == 16 and history.last_step.stick_ratio**0.5 == pytest.approx(exact, abs=0.04)
    assert not [remark for remark in history.last_step.warnings if remark.kind == "single_load_step"]


def test_step_all_matches_single_steps(scene):
    balls = [ss.surface.sphere(scene.grid, radius) for radius in (2e-3, 3e-3, 4e-3)]
    histories = [ss.History(scene.bodies, ball, 0.5) for ball in balls]
    assert ss.History.step_all(histories, [ss.LoadStep(normal_force=50.0)] * 3) == []
    alone = ss.History(scene.bodies, balls[1], 0.5)
    alone.step(normal_force=50.0)
    assert alone.to_bytes() == histories[1].to_bytes()
    loads = [ss.LoadStep(force_x=force) for force in (10.0, 30.0, 20.0)]
    [(index, error)] = ss.History.step_all(histories, loads, return_exceptions=True)
    assert index == 1 and isinstance(error, ss.BeyondFrictionCapacity)
    assert histories[1].tangential_force == (0.0, 0.0) and histories[2].tangential_force == pytest.approx((20.0, 0.0))
    with pytest.raises(ss.errors.Length):
        ss.History.step_all(histories, [])
    before = histories[0].to_bytes()
    with pytest.raises(ValueError, match=r"histories\[2\] is the same object as histories\[1\]: list each history once"):
        ss.History.step_all([histories[0], alone, alone], [ss.LoadStep(force_x=5.0)] * 3)
    assert histories[0].to_bytes() == before


def test_step_all_raises_after_all_steps(scene):
    histories = [scene.history() for _ in range(4)]
    ss.History.step_all(histories, [ss.LoadStep(normal_force=50.0)] * 4)
    loads = [ss.LoadStep(force_x=force) for force in (10.0, 30.0, 20.0, 40.0)]
    message = r"^histories\[1\]: the tangential force 30\.0 exceeds .* \(2 of 4 steps failed: give return_exceptions=True for the list"
    with pytest.raises(ss.BeyondFrictionCapacity, match=message) as caught:
        ss.History.step_all(histories, loads)
    assert [index for index, _ in caught.value.failures] == [1, 3] and caught.value.force == 30.0
    assert all(isinstance(error, ss.BeyondFrictionCapacity) for _, error in caught.value.failures)
    assert str(caught.value.failures[1][1]).startswith("the tangential force 40.0")
    found = [history.tangential_force[0] for history in histories]
    assert found == pytest.approx([10.0, 0.0, 20.0, 0.0]) and [history.steps for history in histories] == [2, 1, 2, 1]


def test_step_all_rejects_wrong_lists(scene):
    history, load = scene.history(), ss.LoadStep(normal_force=50.0)
    before = history.to_bytes()
    for arguments, message in (
        ((history, load), "histories must be a sequence of History, got History: give a list"),
        (([history], load), "loads must be a sequence of LoadStep, got LoadStep: give a list with one entry for each history"),
        (([load], [history]), "histories must be a sequence of History, got LoadStep as the entry 0"),
        (([history], [{"force_x": 1.0}]), "loads must be a sequence of LoadStep, got dict as the entry 0"),
        (([history], None), "loads must be a sequence of LoadStep, got NoneType"),
    ):
        with pytest.raises(ss.errors.ArgumentType, match=message) as caught:
            ss.History.step_all(*arguments)
        assert caught.value.argument in ("histories", "loads")
    assert history.to_bytes() == before
    assert ss.History.step_all((one for one in [history]), (one for one in [load])) == []


def test_minimise_matches_explicit_matrix():
    grid = ss.Grid(12, 9, 1.0, 1.0)
    bodies = ss.HalfSpace(grid, (ss.Material(1.0, 0.3), ss.Material.rigid()))
    gap = ss.surface.sphere(grid, 20.0)
    dense = ss.dense.DenseOperator.of_half_space(bodies, "zz")
    direct = dense.minimise(gap.array, total=3.0)
    iterated = ss.cgm.minimise(bodies.operator("zz"), gap.array, total=3.0, preconditioner=bodies.preconditioner("zz"))
    contact = ss.NormalProblem(bodies, gap, force=3.0).solve()
    assert iterated.x == pytest.approx(direct.x, abs=1e-8)
    assert contact.pressure.ravel() == pytest.approx(direct.x, abs=1e-8)
    assert iterated.multiplier == pytest.approx(contact.approach, rel=1e-8)
    matrix = np.array([[dense.get(row, column) for column in range(108)] for row in range(108)])
    own = ss.cgm.minimise(lambda x: matrix @ x, gap.array, total=3.0, lower_bound=dense.lower_bound)
    assert own.x == pytest.approx(direct.x, abs=1e-8)
    added = np.linspace(0.0, 1.0, 108)
    softer = ss.cgm.minimise(bodies.operator("zz"), gap.array, total=3.0, diagonal=added)
    direct = ss.dense.DenseOperator(matrix + np.diag(added)).minimise(gap.array, total=3.0)
    assert softer.x == pytest.approx(direct.x, abs=1e-8) and softer.x != pytest.approx(own.x, abs=1e-3)
    with pytest.raises(ss.errors.StickslipError, match="diagonal"):
        ss.cgm.minimise(bodies.operator("zz"), gap.array, total=3.0, diagonal=-1.0)
    assert matrix @ gap.array.ravel() == pytest.approx(bodies.operator("zz")(gap.array).ravel(), abs=1e-12)


def test_convolution_matches_influence_coefficients():
    grid = ss.Grid(8, 6, 1.0, 1.0)
    bodies = ss.HalfSpace(grid, (ss.Material(1.0, 0.2), ss.Material.rigid()))
    table = ss.influence.Table(grid, bodies.pair, "xz")
    tensor = ss.influence.Rectangle(0.5, 0.5).pair_tensor(bodies.pair, 2.0, -1.0)
    assert table.get(2, -1) == pytest.approx(tensor.xz, rel=1e-9) and table.get(8, 0) is None
    unit = np.zeros(grid.shape)
    unit[3, 3] = 1.0
    u, v, w = bodies.tensor_operator().apply((np.zeros(grid.shape), np.zeros(grid.shape), unit))
    assert u[2, 5] == pytest.approx(tensor.xz, abs=1e-14) and w[2, 5] == pytest.approx(tensor.zz, abs=1e-14)
    convolution = ss.fft.Convolution(grid, bodies.pair, "zz")
    assert np.array_equal(convolution(unit), bodies.operator("zz")(unit))


def test_spots_are_counted_separately(scene):
    x, y = np.meshgrid(scene.grid.x, scene.grid.y)
    side = 0.07e-3
    gap = np.minimum((x - side) ** 2, (x + side) ** 2) / 2e-3 + y**2 / 2e-3
    contact = ss.NormalProblem(scene.bodies, gap, force=5.0).solve()
    spots = contact.spots
    assert len(spots) == 2 and spots[0].load + spots[-1].load == pytest.approx(5.0)
    assert set(np.unique(spots.labels)) == {0, 1, 2}
    with pytest.raises(IndexError):
        spots[2]
    shear = ss.TangentialProblem(scene.bodies, contact, 0.3, force_x=1.0).solve()
    assert 0.0 < shear.spots(contact).largest.stick_ratio < 1.0


def test_jaeger_superposition_matches_scalar_model_for_zero_poisson_ratio():
    grid = ss.Grid.square(48, 0.3e-3)
    material = ss.Material(200e9, 0.0)
    bodies = ss.HalfSpace(grid, (material, material))
    ball = ss.surface.sphere(grid, RADIUS)
    full = ss.NormalProblem(bodies, ball, force=100.0, tolerance=1e-10).solve()
    stick = ss.NormalProblem(bodies, ball, force=60.0, tolerance=1e-10).solve()
    exact = ss.tangential.JaegerSuperposition(full, stick, bodies.pair, 0.5)
    found = ss.TangentialProblem(bodies, full, 0.5, force_x=exact.force, tolerance=1e-10).solve()
    assert found.traction[0] == pytest.approx(exact.traction, abs=1e-6 * exact.traction.max())
    assert np.array_equal(found.zones, exact.zones)


def test_bulk_strain_shears_contact():
    titanium = ss.Material(115e3, 0.32)
    grid = ss.Grid.line(128, 0.01)
    bodies = ss.HalfSpace(grid, (titanium, titanium), boundary=("periodic_along_y", 50.0))
    bulk = ss.tangential.RelativeDisplacement.bulk_strain(grid, [[titanium.plane_strain_under(1.0), 0.0], [0.0, 0.0]])
    history = ss.History(bodies, ss.surface.cylinder(grid, 20.0), 0.5, relative_displacement=bulk)
    history.step(normal_force=200.0)
    history.step(force_x=0.0, relative_displacement=100.0)
    assert history.traction[0][0, 70] < -1.0 and history.traction[0][0, 57] > 1.0


def test_work_of_loads_equals_loop_area():
    titanium = ss.Material(115e3, 0.32)
    grid = ss.Grid.line(128, 0.01)
    bodies = ss.HalfSpace(grid, (titanium, titanium), boundary=("periodic_along_y", 50.0))
    bulk = ss.tangential.RelativeDisplacement.bulk_strain(grid, [[titanium.plane_strain_under(1.0), 0.0], [0.0, 0.0]])
    history = ss.History(bodies, ss.surface.cylinder(grid, 20.0), 0.5, relative_displacement=bulk)
    history.step(normal_force=200.0)
    works = {}
    for stress in (0.0, 50.0):
        cycle = ss.history.Cycle(history)
        for _ in range(2):
            cycle.begin(history)
            for force in (40.0, 0.0, -40.0, 0.0, 60.0):
                history.step(force_x=force, relative_displacement=stress * force / 60.0)
                cycle.add(history)
        force, shift = cycle.points.force[0], cycle.points.shift[0]
        area = float((0.5 * (force[1:] + force[:-1]) * np.diff(shift)).sum())
        assert cycle.work_of_loads == pytest.approx(area, rel=1e-12)
        works[stress] = cycle.work_of_loads / cycle.energy.work
    # Bulk strain also does work.
    assert works[0.0] == pytest.approx(1.0, rel=1e-9) and abs(works[50.0] - 1.0) > 0.03


def test_line_contact_stresses_match_closed_forms():
    titanium = ss.Material(115e3, 0.32)
    hertz = ss.analytical.HertzLine(ss.ElasticPair(titanium, titanium), radius=20.0, load=200.0)
    a, p0 = hertz.half_width, hertz.max_pressure
    depth = np.array([0.0, 0.5, 2.0]) * a
    xx, zz, xz = hertz.stress(0.0, depth)
    root = np.sqrt(a**2 + depth**2)
    assert zz == pytest.approx(-p0 * a / root) and not xz.any()
    assert xx == pytest.approx(-p0 / a * ((a**2 + 2.0 * depth**2) / root - 2.0 * depth))
    x = np.linspace(-2.0, 2.0, 9) * a
    assert np.array_equal(hertz.surface_stress(x), -hertz.pressure(x))
    assert isinstance(hertz.stress(0.0, a)[0], float) and hertz.stress(x[:, None], depth)[0].shape == (9, 3)
    # The largest stress is at the trailing edge with respect to the traction (Johnson 1985, section 7.2).
    shear = ss.analytical.CattaneoMindlinLine(hertz, friction=0.5, force=40.0)
    one, two = shear.surface_stress(-a)
    assert one == pytest.approx(2.0 * 0.5 * p0 * math.sqrt(0.4)) and two == pytest.approx(-one)
    assert shear.surface_stress(x)[0] == pytest.approx(shear.stress(x, 0.0)[0][0])
    assert shear.stress(x, 0.0)[1][2] == pytest.approx(-shear.traction(x), abs=1e-9)
    # Bulk stress strains the body and is included in its stress.
    stretched = shear.with_bulk_stress((30.0, 0.0))
    strained = shear.with_strain(titanium.plane_strain_under(30.0))
    assert stretched.traction(x) == pytest.approx(strained.traction(x))
    assert stretched.stress(0.0, 1e3 * a)[0][0] == pytest.approx(30.0, abs=0.5)
    assert stretched.stress(0.0, 1e3 * a)[1][0] == pytest.approx(0.0, abs=0.5)


def test_uniform_stress_is_added_to_stress_of_tractions(scene, tmp_path):
    contact = scene.normal()
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=20.0).solve()
    bulk = 2.0 * ss.subsurface.Stress(xx=100e6, yy=30e6, xz=5e6)
    assert bulk == ss.subsurface.Stress(xx=200e6) + ss.subsurface.Stress(yy=60e6, xz=10e6) and bulk * 0.5 + bulk * 0.5 == bulk
    assert bulk - bulk == ss.subsurface.Stress()
    planes = ss.subsurface.Planes(scene.bodies, [1e-5, 2e-5])
    alone = planes.solve(0, "one", (contact, shear))
    both = planes.solve(0, "one", (contact, shear), uniform_stress=bulk)
    assert both.get(20, 30) == alone.get(20, 30) + bulk
    assert both.von_mises[30, 20] == (alone.get(20, 30) + bulk).von_mises
    [first, _] = planes.solve_all("one", (contact, shear), uniform_stress=bulk)
    assert np.array_equal(first.normal_stress[0], both.normal_stress[0])
    points = [(0.0, 0.0, 1e-5), (1e-5, 2e-5, 1e-5)]
    [at, by] = (ss.subsurface.at_points(scene.bodies, "one", contact, points, **kind) for kind in ({}, {"uniform_stress": bulk}))
    assert [response.stress + bulk for response in at] == [response.stress for response in by]
    assert by.displacement[2] == pytest.approx(at.displacement[2], abs=0.0)
    for name, kind in (("alone", {}), ("both", {"uniform_stress": bulk})):
        planes.write_vti(tmp_path / name, "one", contact, **kind)
    assert (tmp_path / "alone").read_bytes() != (tmp_path / "both").read_bytes()


def test_plane_near_surface_warns_about_sheared_edge(scene):
    contact = scene.normal()
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=20.0).solve()
    planes = ss.subsurface.Planes(scene.bodies, [0.0, 2.0 * scene.grid.dx])
    with pytest.warns(ss.ContactWarning, match="edge of a sheared contact"):
        [near, deep] = planes.solve_all("one", (contact, shear))
    assert [remark.kind for remark in near.warnings] == ["stress_at_edge"] and not deep.warnings
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        planes.solve(0, "one", (contact, shear), warn=False)
        planes.solve(1, "one", (contact, shear))
        planes.solve(0, "one", contact)
        with pytest.raises(ss.ContactWarning):
            planes.solve(0, "one", (contact, shear))


def test_edges_have_sub_cell_accuracy():
    grid, body = ss.Grid.square(64, 3.0), ss.Material(2.0, 0.0)
    bodies = ss.HalfSpace(grid, (body, body), cell_value="centre")
    assert bodies.cell_value == ss.HalfSpace(*bodies.__reduce__()[1]).cell_value == "centre"
    hertz = ss.analytical.HertzSphere(bodies.pair, radius=1.0, load=4 / 3)
    exact = ss.analytical.CattaneoMindlin(hertz, friction=0.5, force=0.2)
    contact = ss.NormalProblem(bodies, ss.surface.sphere(grid, 1.0), force=4 / 3).solve()
    edges = contact.edges()
    assert abs(edges.area / hertz.contact_area - 1) < 1e-3 < abs(contact.contact_area / hertz.contact_area - 1)
    assert np.hypot(*np.moveaxis(edges.outline, 2, 0)).std() < 1e-3
    assert edges.centres.shape == grid.shape and edges.covered.shape == edges.cells.shape == edges.is_fitted.shape
    shear = ss.TangentialProblem(bodies, contact, 0.5, force_x=0.2).solve()
    assert abs(shear.edges(contact, 0.5).stick_ratio - exact.stick_ratio) < 2e-3
    assert edges.areas_of(contact.spots) == pytest.approx([edges.area])
    history = ss.History(bodies, ss.surface.sphere(grid, 1.0), 0.5)
    history.step(normal_force=4 / 3)
    history.step(force_x=0.2)
    assert abs(history.edges().stick_ratio - exact.stick_ratio) < 2e-3
    assert 1e-3 < contact.discretisation_estimate < shear.discretisation_estimate < 0.05
    with pytest.raises(ss.errors.CellValueMismatch):
        contact.displacement(ss.HalfSpace(grid, (body, body)))


def test_depths_and_fractions_out_of_range_are_rejected():
    steel = ss.Material(210e3, 0.3)
    line = ss.analytical.HertzLine((steel, steel), radius=10.0, load=100.0)
    shear = ss.analytical.CattaneoMindlinLine(line, friction=0.3, force=10.0)
    for form in (line, shear):
        with pytest.raises(ss.errors.ArgumentRange, match=r"depth must be zero or more, .*got -0\.1"):
            form.stress(0.0, [0.1, -0.1])
    grid = ss.Grid.square(32, 32.0)
    heights = ss.surface.SelfAffine(rms_height=1.0, seed=1).generate(grid).heights
    with pytest.raises(ss.errors.ArgumentRange, match=r"material_ratio must be a ratio from 0 to 1, got 10\.0"):
        ss.surface.MaterialRatio(heights).height(10.0)
    function = ss.surface.Autocorrelation(heights)
    for measure in (function.decay_length, function.texture_aspect_ratio):
        with pytest.raises(ss.errors.ArgumentRange, match="threshold must lie strictly between 0 and 1, got 20.0"):
            measure(20.0)
