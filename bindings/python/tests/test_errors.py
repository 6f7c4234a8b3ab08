"""Rejected calls: the exception, its numbers, and unchanged states."""

import errno
import math
import os
import pickle
import warnings

import numpy as np
import pytest

import stickslip as ss
from conftest import FORCE, Scene


@pytest.mark.parametrize(
    ("call", "name", "numbers"),
    [
        (lambda scene: ss.Grid(0, 3, 1.0, 1.0), "GridSize", {"nx": 0, "ny": 3}),
        (lambda scene: ss.Grid.square(3, -1.0), "NotPositive", {"value": -1.0}),
        (lambda scene: ss.Grid(2**40, 2**40, 1.0, 1.0) and ss.Field(ss.Grid(2**30, 2**30, 1.0, 1.0), 0.0), None, {}),
        (lambda scene: ss.Material(1.0, 0.7), "PoissonRatio", {"value": 0.7}),
        (lambda scene: ss.ElasticPair(ss.Material.rigid(), ss.Material.rigid()), "BothRigid", {}),
        (lambda scene: ss.Friction(-0.1), "NegativeOrNotFinite", {"value": -0.1}),
        (lambda scene: ss.Settings(tolerance=2.0), "Tolerance", {"value": 2.0}),
        (lambda scene: ss.Settings(max_iterations=0), "IterationLimit", {}),
        (lambda scene: ss.NormalProblem(scene.bodies, scene.ball, force=math.nan), "NegativeOrNotFinite", {}),
        (
            lambda scene: ss.NormalProblem(scene.bodies, scene.ball, force=1e-300),
            "ExtremeNumber",
            {"least": 1e-130, "most": 1e130},
        ),
        (lambda scene: ss.NormalProblem(scene.bodies, np.zeros((3, 4)), force=1.0), "Shape", {"found": (3, 4)}),
        (
            lambda scene: ss.NormalProblem(scene.bodies, ss.Field(ss.Grid.square(4, 1.0), 0.0), force=1.0),
            "GridMismatch",
            {"found_cells": [4, 4], "expected_cells": [64, 64]},
        ),
        (
            lambda scene: ss.NormalProblem(scene.bodies, np.full(scene.grid.shape, math.nan), force=1.0),
            "Sample",
            {"index": 0},
        ),
        (
            lambda scene: ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, force_x=60.0),
            "BeyondFrictionCapacity",
            {"force": 60.0, "limit": pytest.approx(50.0)},
        ),
        (
            lambda scene: ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, force=(1.0, 2.0)),
            "ObliqueLoad",
            {"x": 1.0, "y": 2.0},
        ),
        (
            lambda scene: ss.TangentialProblem(scene.bodies, np.zeros(scene.grid.shape), 0.5, force_x=1.0),
            "EmptyContact",
            {},
        ),
        (lambda scene: ss.history.LoadPath.sine((1.0, 0.0), 6), "StepsPerCycle", {"steps": 6}),
        (lambda scene: ss.history.LoadPath([]), "EmptyPath", {}),
        (lambda scene: ss.surface.SelfAffine(rms_slope=0.1, hurst=2.0, seed=0).generate(scene.grid), "Hurst", {"value": 2.0}),
        (lambda scene: ss.surface.crop(scene.ball, (3, 3), (0, 1)), "Range", {"start": 3, "end": 3, "count": 64}),
        (lambda scene: ss.io.asc.parse(b"nonsense"), "Format", {"file": None}),
        (lambda scene: ss.io.read("/nowhere.sdf"), "File", {"path": "/nowhere.sdf"}),
        (lambda scene: ss.dense.DenseOperator(np.ones((2, 2))).minimise([-1.0, -1.0]), "NotPositiveDefinite", {}),
        (lambda scene: ss.history.State.from_bytes(b""), "Format", {}),
    ],
)
def test_invalid_input_raises_specific_exception_with_numbers(scene, call, name, numbers):
    if name is None:
        with pytest.raises((ss.StickslipError, MemoryError)):
            call(scene)
        return
    with pytest.raises(ss.StickslipError) as refused:
        call(scene)
    assert type(refused.value).__name__ == name
    for attribute, number in numbers.items():
        assert getattr(refused.value, attribute) == number
    copy = pickle.loads(pickle.dumps(refused.value))
    assert type(copy) is type(refused.value) and str(copy) == str(refused.value)
    assert set(vars(copy)) == set(vars(refused.value))


def test_invalid_input_is_value_error_and_file_error_is_os_error():
    with pytest.raises(ValueError, match="Poisson"):
        ss.Material(1.0, 0.7)
    with pytest.raises(OSError, match="nowhere"):
        ss.io.npy.read("/nowhere.npy", cell=(1.0, 1.0))


@pytest.mark.parametrize("path", ["/nowhere/heights.sdf", "."])
def test_file_error_has_errno_of_system(path, tmp_path):
    number = errno.ENOENT if path != "." else errno.EISDIR
    with pytest.raises(OSError) as refused:
        ss.io.sdf.read(path)
    back = pickle.loads(pickle.dumps(refused.value))
    for error in (refused.value, back):
        assert (error.errno, error.filename) == (number, path)
        assert os.strerror(number) in error.strerror == error.problem and str(error).startswith(path)


def test_wrong_type_or_name_message_states_valid_choices(scene):
    with pytest.raises(TypeError, match="force= or approach="):
        ss.NormalProblem(scene.bodies, scene.ball)
    with pytest.raises(TypeError, match="not both"):
        ss.NormalProblem(scene.bodies, scene.ball, force=1.0, approach=1.0)
    with pytest.raises(ValueError, match="'active_set', 'polonsky_keer'"):
        scene.normal(method="newton")
    with pytest.raises(TypeError, match="one of force, shift and spring along x"):
        ss.LoadStep(force_x=1.0, shift=(1.0, 0.0))
    with pytest.raises(TypeError, match="not both"):
        scene.history().step(ss.LoadStep(), force_x=1.0)
    with pytest.raises(TypeError, match="Field"):
        ss.surface.Statistics(np.zeros((3, 3)))
    with pytest.raises(ValueError, match="periodic_along_y"):
        ss.HalfSpace(scene.grid, scene.bodies.pair, boundary="closed")


def test_not_converged_has_report_and_last_iterate(scene):
    with pytest.raises(ss.NotConverged) as stopped:
        scene.normal(max_iterations=1)
    report = stopped.value.report
    assert report.status == ss.Status.ITERATION_LIMIT and not report.is_converged
    iterate = stopped.value.last_iterate
    assert isinstance(iterate, ss.NormalSolution) and iterate.report == report
    assert iterate.force == pytest.approx(FORCE) and (iterate.pressure >= 0.0).all()
    history = scene.history(max_iterations=1)
    with pytest.raises(ss.NotConverged) as stopped:
        history.step(normal_force=FORCE)
    assert stopped.value.last_iterate is None and history.steps == 0


def test_history_failed_step_leaves_state_unchanged(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    before = history.to_bytes()
    with pytest.raises(ss.BeyondFrictionCapacity):
        history.step(force_x=60.0)
    with pytest.raises(ss.errors.NotFinite):
        history.step(shift_x=math.inf)
    with pytest.raises(ss.errors.Sample):
        history.set_gap(np.full(scene.grid.shape, math.nan))
    assert history.to_bytes() == before


def test_history_failed_step_leaves_previous_fields_readable(scene):
    history, other = scene.history(), scene.history()
    for contact in (history, other):
        contact.step(normal_force=FORCE)
    step, of_other = history.step(force_x=30.0), other.step(force_x=30.0)
    slip = step.slip_distance
    with pytest.raises(ss.BeyondFrictionCapacity):
        history.step(force_x=60.0)
    assert np.array_equal(step.slip_distance, slip)
    loads = [ss.LoadStep(force_x=60.0), ss.LoadStep(force_x=20.0)]
    [(place, error)] = ss.History.step_all([history, other], loads, return_exceptions=True)
    assert place == 0 and isinstance(error, ss.BeyondFrictionCapacity)
    assert np.array_equal(step.keep().slip_distance, slip)
    with pytest.raises(RuntimeError, match="keep"):
        of_other.slip_distance
    adaptive = ss.history.AdaptiveSteps(Scene(16).history(), 0.01)
    for attempt in (adaptive.step, adaptive.error):
        with pytest.raises(ss.errors.GridMismatch):
            attempt(history, ss.LoadStep(force_x=20.0))
    assert np.array_equal(step.slip_distance, slip)


def test_adaptive_steps_rejected_keep_fields_and_failed_replace_them():
    history = Scene(16).history()
    history.step(normal_force=FORCE)
    step = history.step(force_x=30.0)
    slip, before = step.slip_distance, history.to_bytes()
    adaptive = ss.history.AdaptiveSteps(history, 1e-9)
    for load, kind in [(ss.LoadStep(force_x=math.nan), ss.errors.NotFinite), (ss.LoadStep(force_x=60.0), ss.BeyondFrictionCapacity)]:
        for attempt in (adaptive.step, adaptive.error):
            with pytest.raises(kind):
                attempt(history, load)
    assert np.array_equal(step.slip_distance, slip) and np.array_equal(step.keep().slip_distance, slip)
    with pytest.raises(ss.errors.StepTooLong):
        adaptive.step(history, ss.LoadStep(normal_force=150.0, force_x=-20.0))
    with pytest.raises(RuntimeError, match="has taken a further step, or its state was set: call keep"):
        step.slip_distance
    assert history.to_bytes() == before
    with pytest.raises(ss.errors.NoLastStep, match="make a step first"):
        history.last_step


def test_invalid_point_reports_index_and_invalid_pressure_reports_row_and_column(scene):
    points = np.full((5000, 3), 1e-5)
    for index, axis, value in [(4000, 2, -1e-5), (4999, 0, math.nan)]:
        wrong = points.copy()
        wrong[index, axis] = value
        with pytest.raises(ss.errors.Sample, match=f"point at index {index} ") as refused:
            ss.subsurface.at_points(scene.bodies, "one", scene.normal(), wrong)
        assert (refused.value.index, refused.value.row, refused.value.column) == (index, None, None)
    pressure = np.zeros(scene.grid.shape)
    pressure[3, 5] = math.nan
    for asked in (points, np.empty((0, 3))):
        with pytest.raises(ss.errors.Sample, match="pressure at row 3, column 5") as refused:
            ss.subsurface.at_points(scene.bodies, "one", pressure, asked)
        assert (refused.value.row, refused.value.column) == (3, 5)


def test_solver_rejected_load_keeps_previous_load(scene):
    solver = ss.NormalSolver(scene.bodies, scene.ball, force=FORCE)
    with pytest.raises(ss.errors.NegativeOrNotFinite):
        solver.solve(force=-1.0)
    with pytest.raises(ss.errors.Tolerance):
        solver.settings = ss.Settings(tolerance=5.0)
    assert solver.settings.tolerance == 1e-8
    assert solver.solve().force == pytest.approx(FORCE)


def test_permanent_set_requires_hardness():
    grid = ss.Grid.square(24, 0.3e-3)
    steel = ss.Material(213e9, 0.29)
    bodies, ball = ss.HalfSpace(grid, (steel, steel)), ss.surface.sphere(grid, 3.5e-3)
    with pytest.raises(ValueError, match="permanent_set=True has no effect without a hardness: .* hardness="):
        ss.History(bodies, ball, 0.5, permanent_set=True)
    history = ss.History(bodies, ball, 0.5, hardness=2e9, permanent_set=True)
    history.step(normal_force=100.0, warn=False)
    assert history.state().yielded.max() > 0.0


def test_solver_sets_load_and_gap_together_or_neither():
    grid = ss.Grid.square(16, 1.0)
    bodies = ss.HalfSpace(grid, (ss.Material(1.0, 0.3), ss.Material.rigid()), boundary="periodic")
    waves = ss.surface.bisinusoidal(grid, 0.01, (1.0, 1.0))
    deep = ss.surface.bisinusoidal(grid, 0.1, (1.0, 1.0))
    solver = ss.NormalSolver(bodies, waves, approach=0.005)
    before = solver.solve().pressure
    for load, gap in [({"force": -1.0}, deep), ({"approach": 1.0}, deep), ({"force": 1.0}, np.full((16, 16), math.nan))]:
        with pytest.raises(ss.StickslipError):
            solver.solve(**load, gap=gap)
        assert solver.solve().approach == 0.005
        assert np.allclose(solver.solve().pressure, before, rtol=0.0, atol=1e-6 * before.max())
    # The approach is valid for the new gap, but not for the previous gap.
    assert solver.solve(approach=0.05, gap=deep).approach == 0.05
    assert solver.solve(approach=0.005, gap=waves).approach == 0.005


def test_warnings_are_objects_and_issued_by_default(scene):
    tiny = ss.NormalProblem(scene.bodies, scene.ball, force=0.01)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        contact = tiny.solve(warn=False)
        with pytest.raises(ss.ContactWarning):
            tiny.solve()
    remark, coarse = contact.warnings
    assert repr(contact).endswith("converged, 2 warnings)")
    assert coarse.kind == "discretisation_error" and "1 %" in coarse.message
    assert remark.kind == "unresolved_spots" and "refine the grid" in repr(remark)
    with pytest.warns(ss.ContactWarning, match="refine the grid") as caught:
        tiny.solve()
    assert caught[0].filename == __file__
    assert {warning.message.kind for warning in caught} == {"discretisation_error", "unresolved_spots"}
    history = scene.history()
    history.step(normal_force=FORCE)
    history.set_gap(scene.ball + 1e-9)
    with pytest.warns(ss.ContactWarning, match="old gap"):
        history.step(force_x=1.0)
    history.set_gap(scene.ball + 2e-9)
    with pytest.warns(ss.ContactWarning, match="old gap"):
        ss.History.step_all([history], [ss.LoadStep(force_x=2.0)])
    history.set_gap(scene.ball + 3e-9)
    with pytest.warns(ss.ContactWarning, match="old gap"):
        ss.history.AdaptiveSteps(history, 0.1).step(history, ss.LoadStep(force_x=3.0))


def test_warning_kind_is_issued_once_per_location():
    grid = ss.Grid.square(24, 1.0)
    bodies = ss.HalfSpace(grid, (ss.Material(1.0, 0.3), ss.Material.rigid()))
    x, y = np.meshgrid(grid.x, grid.y)
    solver = ss.NormalSolver(bodies, (x - 0.3) ** 2 / 4.0 + y**2 / 4.0, force=0.0)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("default")
        counts = {remark.cells for force in (0.01, 0.02, 0.03) for remark in solver.solve(force=force).warnings}
        assert len(counts) == 3 and len(caught) == 1  # three texts, one warning
        solver.solve(force=0.025)
        assert [warning.lineno for warning in caught] == sorted({warning.lineno for warning in caught}) and len(caught) == 2
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        for force in (0.01, 0.02, 0.03):
            solver.solve(force=force)
        assert len({str(warning.message) for warning in caught}) == 3


def test_held_shift_that_loses_force_is_warned_about(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    history.step(force_x=0.4 * FORCE)
    with pytest.warns(ss.ContactWarning, match="decreased by .* % under a held shift"):
        step = history.step(normal_force=0.3 * FORCE)
    assert "held_shift_lost_force" in [remark.kind for remark in step.warnings]


def test_inconsistent_length_units_are_warned_about(scene):
    # Heights in micrometres on a grid in millimetres.
    problem = ss.NormalProblem(scene.bodies, scene.ball * 1e3, force=FORCE)
    kinds = {remark.kind for remark in problem.solve(warn=False).warnings}
    assert {"large_contact_radius", "steep_surface"} <= kinds


def test_fretting_loop_warns_at_line_of_caller(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    history.set_gap(scene.ball + 1e-9)
    loop = ss.history.FrettingLoop(ss.history.LoadPath.sine((1.0, 0.0), 4), lambda force: ss.LoadStep(force=force))
    with pytest.warns(ss.ContactWarning, match="old gap") as caught:
        loop.run(history, 1)
    assert {warning.filename for warning in caught} == {__file__}


def test_fretting_loop_warns_about_cycles_not_steps(scene):
    def kinds(amplitude, steps):
        """Returns the kinds of warnings of single steps and of the cycle; only the latter are issued."""
        history = scene.history()
        history.step(normal_force=FORCE)
        path = ss.history.LoadPath.sine((amplitude, 0.0), steps)
        remarks = set()
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            observer = lambda history, cycle: remarks.update(remark.kind for remark in history.last_step.warnings)
            cycle = ss.history.FrettingLoop(path, lambda force: ss.LoadStep(force=force)).run(history, 1, observer).last
        messages = [str(warning.message) for warning in caught]
        assert messages == [remark.message for remark in cycle.warnings]
        # The first cycle does not close.
        return remarks, [remark.kind for remark in cycle.warnings if remark.kind != "open_cycle"]

    # After a reversal the slip ring is narrow, but not during the whole cycle.
    assert kinds(40.0, 24) == ({"underresolved_slip_zone"}, [])
    assert kinds(2.0, 8) == ({"underresolved_slip_zone"}, ["underresolved_slip_zone"])


def test_fretting_loop_warns_only_if_last_cycle_is_open(scene):
    for cycles in (1, 3):
        history = scene.history()
        history.step(normal_force=FORCE)
        loop = ss.history.FrettingLoop(ss.history.LoadPath.sine((40.0, 0.0), 24), lambda force: ss.LoadStep(force=force))
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            loop.run(history, cycles)
        assert any("from a closed loop" in str(warning.message) for warning in caught) == (cycles == 1)


def test_operator_exception_ends_solve():
    def broken(x):
        raise KeyError("broken")

    with pytest.raises(KeyError, match="broken"):
        ss.cgm.minimise(broken, [-1.0, -1.0])
