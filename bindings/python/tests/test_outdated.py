"""No call returns results of a rejected step or of an earlier input, and ``progress`` cancels every call by ``False``."""

import numpy as np
import pytest

import stickslip as ss

from conftest import FORCE, Scene


def cancel_after(count):
    """Returns a callback that returns ``None`` until a certain call, and ``False`` from this call."""
    calls = []

    def progress(stage):
        calls.append(stage)
        return False if len(calls) > count else None

    return progress, calls


def pressed(scene, **options):
    history = scene.history(**options)
    history.step(normal_force=FORCE)
    return history


@pytest.fixture
def small():
    return Scene(32)


def test_restored_history_has_no_last_step(small, tmp_path):
    history = small.history()
    with pytest.raises(ss.errors.NoLastStep):
        history.last_step
    history.step(normal_force=FORCE)
    before = history.state()
    step = history.step(force_x=30.0)
    assert history.last_step.shift == history.shift
    history.save(tmp_path / "history")
    restored = [
        ss.History.from_state(small.bodies, before),
        ss.History.from_bytes(small.bodies, history.to_bytes()),
        ss.History.load(small.bodies, tmp_path / "history"),
    ]
    history.set_state(before)
    for other in [*restored, history]:
        with pytest.raises(ss.errors.NoLastStep, match="make a step first"):
            other.last_step
    with pytest.raises(RuntimeError, match="its state was set: call keep"):
        step.slip
    assert step.tangential_force[0] == pytest.approx(30.0)


def test_cycle_of_retried_steps_equals_cycle_of_accepted_steps(small):
    history, direct = pressed(small), pressed(small)
    cycle, expected = ss.history.Cycle(history), ss.history.Cycle(direct)
    depth = np.zeros(small.grid.shape)
    for force in (20.0, 40.0, -20.0, -40.0, 0.0):
        before = history.state()
        history.step(force_x=0.9 * force)
        history.set_state(before)
        with pytest.raises(ss.errors.NoLastStep):
            cycle.add(history)
        step = history.step(force_x=force)
        cycle.add(history)
        depth = ss.wear.energy(1e-13, step.dissipation, depth=depth, grid=small.grid)
        direct.step(force_x=force)
        expected.add(direct)
    assert cycle.energy == expected.energy and cycle.points == expected.points and cycle.energy.dissipated_energy > 0.0
    assert np.allclose(depth.sum() * small.grid.cell_area, 1e-13 * cycle.energy.dissipated_energy)


def test_error_estimate_leaves_no_last_step(small):
    history = pressed(small)
    cycle, steps = ss.history.Cycle(history), ss.history.AdaptiveSteps(history, 0.01)
    steps.error(history, ss.LoadStep(force_x=30.0))
    with pytest.raises(ss.errors.NoLastStep):
        cycle.add(history)
    taken = steps.step(history, ss.LoadStep(force_x=30.0), cycle=cycle)
    assert cycle.steps == taken and history.last_step.shift == history.shift


def test_stiffness_of_history_requires_step_after_change(small):
    history = pressed(small)
    history.step(force_x=20.0)
    expected = history.stiffness()
    history.set_friction(0.5)
    assert history.stiffness() == expected
    history.set_friction(0.45)
    assert history.state().is_friction_new and not history.state().is_pressure_stale
    for next_step in (False, True):
        with pytest.raises(ss.errors.OutdatedSolution, match="the friction changed since the last solution") as caught:
            history.stiffness(next_step=next_step)
        assert caught.value.changed == "the friction" and caught.value.quantity == "stiffness"
    history.step(force_x=20.0)
    assert history.stiffness() != expected
    history.set_gap(np.maximum(history.gap_as_set, 1e-8))
    with pytest.raises(ss.errors.OutdatedSolution, match="the gap changed .*: take a step with a prescribed normal load first"):
        history.stiffness()
    history.step(normal_force=FORCE, force_x=20.0)
    history.stiffness(next_step=True)


def test_gap_under_load_is_no_gap_before_loading(small):
    history, solver = pressed(small), ss.NormalProblem(small.bodies, small.ball, force=FORCE).solver()
    solution = solver.solve()
    depth = ss.wear.archard(1e-14, solution.pressure, np.full(small.grid.shape, 1e-6))
    for owner, loaded in ((solver, solution.gap), (history, history.normal.gap)):
        for gap in (loaded, loaded + depth):
            with pytest.raises(ss.errors.GapUnderLoad, match="give the gap before loading"):
                owner.set_gap(gap)
    solver.set_gap(solver.gap + depth)
    history.set_gap(history.gap_as_set + depth)


@pytest.fixture
def rolling(small):
    return ss.rolling.RollingProblem(small.bodies, small.normal(), 0.5, creepage_x=1e-4).solver()


def test_stiffness_of_rolling_requires_solve_after_change(small, rolling):
    sticking = rolling.stiffness()
    rolling.set_friction(0.4)
    assert rolling.stiffness() == sticking
    rolling.solve()
    assert rolling.stiffness() != sticking
    rolling.set_friction(0.45)
    with pytest.raises(ss.errors.OutdatedSolution, match="the friction"):
        rolling.stiffness()
    rolling.solve()
    worn = ss.NormalProblem(small.bodies, ss.surface.sphere(small.grid, 4e-3), force=FORCE).solver()
    rolling.set_normal_solver(worn)
    assert rolling.stiffness()
    rolling.set_normal_load(normal_force=0.9 * FORCE)
    with pytest.raises(ss.errors.OutdatedSolution, match="the pressure"):
        rolling.stiffness()
    with pytest.raises(ss.NotConverged):
        rolling.solve(progress=lambda _: False)
    with pytest.raises(ss.NotConverged):
        rolling.stiffness()

    problem = ss.rolling.CoupledRollingProblem(small.bodies, small.ball, 0.5, normal_force=FORCE, creepage_x=1e-4)
    coupled = problem.solver()
    coupled.solve()
    coupled.stiffness()
    coupled.set_gap(ss.surface.sphere(small.grid, 4e-3))
    with pytest.raises(ss.errors.OutdatedSolution, match="the gap"):
        coupled.stiffness()


@pytest.mark.parametrize("cells", [48, 96])  # on the calling thread, and in the pool
@pytest.mark.parametrize("answer", [False, np.bool_(False)])
def test_progress_false_cancels_every_call(cells, answer):
    scene = Scene(cells)
    normal = scene.normal()
    history = pressed(scene)
    before = history.to_bytes()
    creepage = ss.rolling.RollingProblem(scene.bodies, normal, 0.5, creepage_x=1e-4)
    calls = [
        ss.NormalProblem(scene.bodies, scene.ball, force=FORCE).solve,
        ss.NormalProblem(scene.bodies, scene.ball, force=FORCE).solver().solve,
        ss.TangentialProblem(scene.bodies, normal, 0.5, force_x=20.0).solve,
        creepage.solve,
        creepage.solver().solve,
        lambda **options: history.step(force_x=20.0, **options),
        lambda **options: history.press(normal_force=120.0, tolerance=0.01, **options),
        lambda **options: ss.cgm.minimise(scene.bodies.operator("zz"), -np.ones(scene.grid.cells), lower=0.0, **options),
    ]
    for call in calls:
        with pytest.raises(ss.NotConverged) as caught:
            call(progress=lambda stage: answer)
        assert caught.value.report.status == "cancelled"
    assert history.to_bytes() == before
    for go_on in (None, True, 0, "no"):
        assert history.step(force_x=20.0, progress=lambda stage: go_on).tangential_force[0] == pytest.approx(20.0)


def test_cancelled_solve_keeps_iterate_and_calls_back_no_more(small):
    progress, calls = cancel_after(3)
    with pytest.raises(ss.NotConverged) as caught:
        small_problem = ss.NormalProblem(small.bodies, small.ball, force=FORCE)
        small_problem.solve(progress=progress)
    assert len(calls) == 4 and caught.value.last_iterate.pressure.max() > 0.0


def test_input_of_cancelled_solve_is_kept_and_invalid_input_is_not(small):
    solver = ss.NormalSolver(small.bodies, small.ball, force=FORCE)
    solver.solve()
    with pytest.raises(ss.errors.NotConverged):
        solver.solve(force=50.0, progress=lambda iteration: False)
    assert solver.solve().force == pytest.approx(50.0)
    with pytest.raises(ss.errors.NegativeOrNotFinite):
        solver.solve(force=-1.0)
    assert solver.solve().force == pytest.approx(50.0)


@pytest.mark.parametrize("cells", [24, 96])
def test_cancelled_creep_curve_keeps_finished_points(cells):
    scene = Scene(cells, 0.4e-3)
    problem = ss.rolling.RollingProblem(scene.bodies, scene.normal(), 0.5, creepage_x=1e-4)
    points = [(1e-4 * k, 0.0, 0.0) for k in range(1, 8)]
    whole = problem.solver().creep_forces(points)
    progress, calls = cancel_after(3)
    with pytest.raises(ss.NotConverged) as caught:
        problem.solver().creep_forces(points, progress=progress)
    partial = caught.value.partial
    assert isinstance(partial, ss.rolling.CreepForces) and list(partial) == list(whole)[:4] == calls
    assert caught.value.report.status == "cancelled"

    seen = []
    assert problem.solver().creep_forces(points, progress=seen.append) == whole and seen == list(whole)
    with pytest.raises(ZeroDivisionError) as raised:
        problem.solver().creep_forces(points, progress=lambda point: 1 / 0)
    assert list(raised.value.partial) == list(whole)[:1]
    with pytest.raises(ss.errors.NotFinite) as invalid:
        problem.solver().creep_forces([*points, (np.inf, 0.0, 0.0)])
    assert len(invalid.value.partial) == 0


def test_progress_bar_counts_points(capsys):
    pytest.importorskip("tqdm")
    scene = Scene(24, 0.4e-3)
    problem = ss.rolling.RollingProblem(scene.bodies, scene.normal(), 0.5, creepage_x=1e-4)
    problem.solver().creep_forces([(1e-4 * k, 0.0, 0.0) for k in range(1, 6)], progress=True)
    assert "5/5" in capsys.readouterr().err


def test_reports_of_coupled_solves_convert_to_dictionaries():
    grid = ss.Grid.square(24, 3.0)
    bodies = ss.HalfSpace(grid, (ss.Material(1.0, 0.3), ss.Material.rigid()))
    ball = ss.surface.sphere(grid, 10.0)
    report = ss.CoupledProblem(bodies, ball, 0.3, normal_force=0.1, force_x=0.01).solve().report
    found = report.to_dict()
    assert found["work_products"] == report.work.products and found["is_converged"] is True
    assert found["normal_status"] == report.normal.status and found["pressure_error_bound"] == report.pressure_error_bound
    assert found["error_bounds_traction" if report.error_bounds else "error_bounds"] in (None, *(report.error_bounds or ()))
    rolling = ss.rolling.CoupledRollingProblem(bodies, ball, 0.3, normal_force=0.1, creepage_x=1e-3).solve().report
    assert rolling.to_dict()["passes"] == rolling.passes and "rolling_residual" in rolling.to_dict()
