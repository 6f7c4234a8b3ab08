"""Contacts that are solved to a required accuracy: closed forms, limits, interrupts and rejected calls."""

import math
import os
import pickle
import signal
import warnings

import numpy as np
import pytest

import stickslip as ss
from conftest import FORCE, RADIUS
from stickslip.adaptive import AdaptiveProblem, AdaptiveStatus, GridRecord, Quantity, Region

STEEL = ss.Material(213e9, 0.29)
PAIR = ss.ElasticPair(STEEL, STEEL)
HERTZ = ss.analytical.HertzSphere(PAIR, radius=RADIUS, load=FORCE)
A = HERTZ.contact_radius
# A square whose sides are a hundred times the contact diameter.
WIDE = Region.rectangle((-100 * A, 100 * A), (-100 * A, 100 * A))
NEAR = Region.rectangle((-2 * A, 2 * A), (-2 * A, 2 * A))


def ball(x, y):
    return (x**2 + y**2) / (2 * RADIUS)


def solved(gap=ball, region=NEAR, warn=True, **options):
    options.setdefault("force", FORCE)
    return AdaptiveProblem(PAIR, gap, region, **options).solve(warn=warn)


@pytest.mark.parametrize("target", [1e-2, 1e-3])
def test_sphere_in_wide_region_reaches_target(target):
    contact = solved(
        lambda x, y: ball(x - 37.3 * A, y + 61.7 * A), WIDE, target=dict.fromkeys(["pressure", "approach", "area"], target)
    )
    assert contact.is_reached and contact.status is AdaptiveStatus.REACHED and contact.status == "reached"
    assert abs(contact.approach / HERTZ.approach - 1.0) < target
    assert abs(contact.area / HERTZ.contact_area - 1.0) < target
    assert contact.force == pytest.approx(FORCE, rel=1e-6)
    assert contact.targets == {"pressure": target, "approach": target, "area": target}
    assert list(contact.estimates) == ["pressure", "area", "approach", "force"]
    assert all(contact.estimates[name] <= target for name in contact.targets)
    # The grid covers the contact and little else.
    sides = [cells * side for cells, side in zip(contact.grid.shape, (contact.grid.dy, contact.grid.dx))]
    assert all(2 * A < side < 4 * A for side in sides)
    assert contact.centre == pytest.approx((37.3 * A, -61.7 * A), abs=0.5 * A)
    assert "accuracy_not_reached" not in [warning.kind for warning in contact.warnings]


def test_default_target_applies_to_pressure_and_traction():
    assert AdaptiveProblem(PAIR, ball, NEAR, force=FORCE).targets == {"pressure": 0.01}
    assert AdaptiveProblem(PAIR, ball, NEAR, force=FORCE, target=0.05).targets == {"pressure": 0.05}
    sheared = AdaptiveProblem(PAIR, ball, NEAR, force=FORCE, friction=0.5, force_x=20.0)
    assert sheared.targets == {"pressure": 0.01, "traction": 0.01}


def test_arrays_are_in_coordinates_of_gap():
    contact = solved(lambda x, y: ball(x - A, y), Region.rectangle((-3 * A, 5 * A), (-2 * A, 2 * A)))
    assert contact.x.shape == (contact.grid.nx,) and contact.y.shape == (contact.grid.ny,)
    assert np.allclose(contact.x, contact.grid.x + contact.centre[0]) and np.allclose(contact.y, contact.grid.y + contact.centre[1])
    assert contact.gap.shape == contact.grid.shape and not contact.gap.flags.writeable
    assert np.allclose(contact.gap, ball(*np.meshgrid(contact.x - A, contact.y)), rtol=1e-9, atol=1e-15)
    assert contact.bodies.grid == contact.grid and contact.bodies.pair == PAIR
    assert contact.bodies.cell_value == "centre"
    again = ss.NormalProblem(contact.bodies, contact.gap, force=FORCE).solve()
    assert again.approach == pytest.approx(contact.approach, rel=1e-3)
    assert np.allclose(contact.normal.pressure, again.pressure, atol=1e-3 * again.pressure.max())


def test_prescribed_approach_returns_force():
    contact = solved(force=None, approach=HERTZ.approach, target={"force": 1e-3})
    assert contact.approach == HERTZ.approach
    assert abs(contact.force / FORCE - 1.0) < 1e-3


def test_tangential_load_returns_cattaneo_mindlin_stick_ratio():
    exact = ss.analytical.CattaneoMindlin(HERTZ, friction=0.5, force=20.0)
    targets = {Quantity.STICK_RATIO: 1e-2, "shift": 1e-2}
    contact = solved(friction=0.5, force_x=20.0, target=targets)
    assert contact.is_reached and contact.targets == {"stick_ratio": 1e-2, "shift": 1e-2}
    assert abs(contact.stick_ratio - exact.stick_ratio) < 1e-2
    assert abs(contact.tangential.shift[0] / exact.shift - 1.0) < 1e-2
    assert contact.tangential.force == pytest.approx((20.0, 0.0))
    assert contact.edges().stick_ratio == contact.stick_ratio and contact.edges().contact.area == contact.area
    assert contact.history is None and contact.tangential is contact.tangential
    by_object = solved(friction=ss.Friction(0.5), load=ss.TangentialLoad(force_x=20.0), target=targets)
    assert by_object.tangential == contact.tangential
    # The stick ratio does not depend on the direction of the force.
    oblique = solved(friction=0.5, force_x=12.0, force_y=16.0, model="vector", target={"stick_ratio": 2e-2})
    assert abs(oblique.stick_ratio - exact.stick_ratio) < 4e-2


def test_normal_contact_has_no_tangential_results():
    contact = solved()
    assert contact.tangential is contact.history is contact.stick_ratio is contact.edges() is None


def test_first_step_starts_history():
    contact = solved(friction=0.5, first_step=ss.LoadStep(normal_force=1.0, force_x=20.0), target={"stick_ratio": 1e-2})
    # Pressing and shearing in proportion causes no slip (Mindlin & Deresiewicz 1953).
    assert abs(contact.stick_ratio - 1.0) < 1e-2 and contact.tangential is None
    history = contact.history
    assert history is contact.history and history.grid == contact.grid and history.bodies == contact.bodies
    assert history.last_step.tangential_force == pytest.approx((20.0, 0.0))
    # The normal load of the problem replaces the normal load of the step.
    assert contact.force == pytest.approx(FORCE) == history.last_step.normal_force
    history.step(force_x=-20.0)
    assert history.last_step.stick_ratio < 0.9 and abs(contact.stick_ratio - 1.0) < 1e-2


def test_samples_give_same_contact_as_function():
    samples = ss.surface.sphere(ss.Grid.square(256, 4.2 * A), RADIUS)
    found = []
    for interpolation in (None, "cubic", ss.surface.Interpolation.CUBIC, "linear"):
        contact = solved(samples, interpolation=interpolation, target={"approach": 1e-2})
        assert contact.is_reached and abs(contact.approach / HERTZ.approach - 1.0) < 1e-2
        found.append(contact.approach)
    assert found[0] == found[1] == found[2] != found[3]


def test_distance_between_samples_limits_grid():
    samples = ss.surface.sphere(ss.Grid.square(256, 4.2 * A), RADIUS)
    with pytest.warns(ss.ContactWarning, match="times the required error"):
        contact = solved(samples, target=1e-5)
    assert contact.status is AdaptiveStatus.SAMPLE_SPACING and not contact.is_reached
    assert min(contact.grid.dx, contact.grid.dy) > samples.grid.dx * (1.0 - 1e-9)


def test_cell_limit_gives_warning_and_solution():
    with pytest.warns(ss.ContactWarning, match="times the required error"):
        contact = solved(target=1e-4, cell_limit=20000)
    assert contact.status is AdaptiveStatus.CELL_LIMIT and not contact.is_reached
    assert contact.grid.cells <= 20000 and contact.estimates["pressure"] > 1e-4
    assert abs(contact.approach / HERTZ.approach - 1.0) < 1e-3
    [warning] = [warning for warning in contact.warnings if warning.kind == "accuracy_not_reached"]
    assert pickle.loads(pickle.dumps(warning)) == warning
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert solved(target=1e-4, cell_limit=20000, warn=False).approach == contact.approach


def test_time_limit_gives_solution_of_first_grid():
    with pytest.warns(ss.ContactWarning, match="no error is estimated"):
        contact = solved(time_limit=0.0)
    assert contact.status == "time_limit" and len(contact.grids) == 1
    assert contact.estimates == {} and contact.targets == {"pressure": 0.01}


def test_grids_are_finer_and_finer_and_reach_progress():
    seen = []
    problem = AdaptiveProblem(PAIR, ball, NEAR, force=FORCE, target={"area": 1e-3})
    contact = problem.solve(progress=seen.append)
    assert contact.grids == seen and all(isinstance(record, GridRecord) for record in seen)
    cells = [record.grid.cells for record in seen]
    assert len(cells) > 2 and cells == sorted(cells)
    assert seen[0].estimates == {} and seen[-1].estimates == contact.estimates
    assert seen[-1].grid == contact.grid and seen[-1].centre == contact.centre
    assert problem.solve().difference(contact, "pressure") < 1e-12
    assert 0.0 < solved(target=5e-2).difference(contact, Quantity.PRESSURE) < 5e-2


def test_progress_bar_of_tqdm_is_shown(capsys):
    pytest.importorskip("tqdm")
    AdaptiveProblem(PAIR, ball, NEAR, force=FORCE).solve(progress=True)
    assert "grids" in capsys.readouterr().err


def test_line_and_periodic_region_agree_with_closed_forms():
    line = ss.analytical.HertzLine(PAIR, radius=RADIUS, load=1e5)
    width = line.half_width
    contact = solved(
        lambda x, y: x**2 / (2 * RADIUS), Region.line((-50 * width, 50 * width), 1.0), force=1e5, target={"area": 5e-3}
    )
    assert contact.grid.ny == 1 and abs(contact.area / (2 * width) - 1.0) < 5e-3
    amplitude, wavelength = 1e-6, 1e-3
    wave = ss.analytical.Westergaard(PAIR, amplitude=amplitude, wavelength=wavelength, mean_pressure=1e8)
    force = wave.mean_pressure * wavelength**2
    gap = lambda x, y: amplitude * (1.0 - np.cos(2 * np.pi * x / wavelength))  # noqa: E731
    periodic = solved(gap, Region.periodic((-0.5e-3, 0.5e-3), (-0.5e-3, 0.5e-3)), force=force, target={"area": 2e-2})
    assert periodic.grid.nx * periodic.grid.dx == pytest.approx(wavelength)
    assert abs(periodic.area / (2 * wave.contact_half_width * wavelength) - 1.0) < 2e-2


class Refused(Exception):
    pass


@pytest.mark.parametrize("threads", [1, 2])
def test_exception_in_gap_is_raised_unchanged(threads):
    error = Refused("of the gap")
    calls = []

    def gap(x, y):
        calls.append(len(x))
        if len(calls) > 3:
            raise error
        return ball(x, y)

    before = ss.num_threads()
    ss.set_num_threads(threads)
    try:
        with pytest.raises(Refused) as raised:
            solved(gap)
        assert raised.value is error and len(calls) == 4
        solved()
    finally:
        ss.set_num_threads(before)


def test_gap_receives_equal_arrays_of_one_dimension():
    seen = []

    def gap(x, y):
        seen.append((type(x), x.dtype, y.dtype, x.shape == y.shape, x.ndim, x.min() >= -2 * A, y.max() <= 2 * A))
        return ball(x, y).tolist()

    assert solved(gap).approach == solved().approach
    assert set(seen) == {(np.ndarray, np.dtype(float), np.dtype(float), True, 1, True, True)}


@pytest.mark.parametrize(
    ("gap", "kind", "message"),
    [
        (lambda x, y: 0.0, ValueError, r"gap\(x, y\) must return an array of the shape of x and y, \(\d+,\), got shape \(\)"),
        (lambda x, y: ball(x, y)[:7], ValueError, r"got shape \(7,\)"),
        (lambda x, y: ball(x, y) + 0j, TypeError, r"gap\(x, y\) must be real numbers, got complex"),
        (lambda x, y: ["zero"] * len(x), TypeError, r"gap\(x, y\) must be real numbers, got text"),
        (lambda x, y: None, (TypeError, ValueError), r"gap\(x, y\) must"),
        (lambda x, y: np.where(x > 0, math.nan, 0.0), ss.errors.Sample, r"gap\(x, y\) is nan at x = .*, y = .*, but must be finite"),
        (lambda x, y: ball(x, y) / 0.0, ss.errors.Sample, r"gap\(x, y\) is inf at"),
        (lambda x, y: np.ma.masked_greater(ball(x, y), 0.0), ss.errors.Sample, r"gap\(x, y\) is nan at"),
    ],
)  # fmt: skip
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_wrong_value_of_gap_is_rejected(gap, kind, message):
    with pytest.raises(kind, match=message):
        solved(gap)


def test_exception_in_progress_ends_solve():
    def refuse(record):
        raise Refused

    problem = AdaptiveProblem(PAIR, ball, NEAR, force=FORCE)
    with pytest.raises(Refused):
        problem.solve(progress=refuse)
    assert problem.solve().is_reached


def test_progress_false_ends_solve_with_solution_so_far():
    problem = AdaptiveProblem(PAIR, ball, NEAR, force=FORCE, target={"area": 1e-3})
    seen = []
    contact = problem.solve(progress=lambda record: seen.append(record) or len(seen) < 2, warn=False)
    assert contact.status == "cancelled" and not contact.is_reached and contact.grids == seen and len(seen) == 2
    assert problem.solve(progress=lambda record: True).is_reached


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("place", ["gap", "progress"])
def test_ctrl_c_ends_solve(threads, place):
    calls = []

    def interrupt(where):
        if where == place and not calls:
            calls.append(where)
            os.kill(os.getpid(), signal.SIGINT)

    def gap(x, y):
        interrupt("gap")
        return ball(x, y)

    problem = AdaptiveProblem(PAIR, gap, NEAR, force=FORCE, target=1e-4)
    before = ss.num_threads()
    ss.set_num_threads(threads)
    try:
        with pytest.raises(KeyboardInterrupt):
            problem.solve(progress=lambda record: interrupt("progress"))
    finally:
        ss.set_num_threads(before)
    assert calls == [place]


@pytest.mark.parametrize(
    ("call", "kind", "message"),
    [
        (lambda: Region.rectangle(1.0, (0.0, 1.0)), TypeError, r"x must be a pair \(start, end\), got float"),
        (lambda: Region.rectangle((0.0, 1.0), (0.0, 1.0, 2.0)), TypeError, r"y must be a pair \(start, end\), got tuple of length 3"),
        (lambda: Region.periodic((1.0, 0.0), (0.0, 1.0)), ss.errors.NotPositive, "side of the region along x .*got -1.0"),
        (lambda: Region.rectangle((0.0, 1.0), (0.0, math.inf)), ss.errors.NotFinite, "end of the region along y"),
        (lambda: Region.line((0.0, 2.0), 1.0), ss.errors.BelowMinimum, "datum"),
        (lambda: Region.line((0.0, 2.0), "1"), ss.errors.ArgumentType, "datum must be a real number"),
        (lambda: AdaptiveProblem(STEEL, ball, NEAR, force=1.0), TypeError, "pair must be .*got Material"),
        (lambda: AdaptiveProblem(PAIR, np.zeros((3, 3)), NEAR, force=1.0), TypeError, r"gap must be a function .*got ndarray: .*Field\("),
        (lambda: AdaptiveProblem(PAIR, ball, ((-1.0, 1.0), (-1.0, 1.0)), force=1.0), TypeError, "region"),
        (lambda: AdaptiveProblem(PAIR, ball, NEAR, 1.0), TypeError, "AdaptiveProblem .*by position: give force= or approach="),
        (lambda: AdaptiveProblem(PAIR, ball, NEAR), TypeError, "force= or approach="),
        (lambda: AdaptiveProblem(PAIR, ball, NEAR, force=1.0, approach=1.0), TypeError, "not both"),
        (lambda: solved(force=(1.0, 2.0)), ss.errors.ArgumentType, "force must be a real number, got tuple of length 2"),
        (lambda: solved(target=2.0), ss.errors.Tolerance, "target must lie strictly between 0 and 1, got 2.0"),
        (lambda: solved(target={"area": math.nan}), ss.errors.Tolerance, "target must .*got nan"),
        (lambda: solved(target={"volume": 0.1}), ValueError, "a key of target must be one of 'pressure', .*got 'volume'"),
        (lambda: solved(target={"area": "small"}), ss.errors.ArgumentType, "target must be a real number, got text"),
        (lambda: solved(target={}), ValueError, "target must contain at least one quantity"),
        (lambda: solved(target=None), TypeError, "target must be a number or a dictionary"),
        (lambda: solved(target={"shift": 0.1}), ss.errors.UnsupportedByModel, "friction"),
        (lambda: solved(interpolation="cubic"), TypeError, "interpolation applies to a gap that is a Field"),
        (lambda: solved(ss.surface.sphere(ss.Grid.square(8, 8 * A), RADIUS), interpolation="spline"), ValueError, "interpolation must"),
        (lambda: solved(friction=0.5), TypeError, "friction requires a tangential load: .*force_x="),
        (lambda: solved(force_x=1.0), TypeError, "a tangential load requires friction"),
        (lambda: solved(first_step=ss.LoadStep(force_x=1.0)), TypeError, "a tangential load requires friction"),
        (lambda: solved(friction=0.5, force_x=1.0, first_step=ss.LoadStep()), TypeError, "first_step=, not both"),
        (lambda: solved(friction=0.5, load=ss.TangentialLoad(force_x=1.0), force_x=1.0), TypeError, "not both"),
        (lambda: solved(friction=0.5, load=1.0), TypeError, "load must be a TangentialLoad"),
        (lambda: solved(friction=0.5, first_step=1.0), TypeError, "first_step"),
        (lambda: solved(friction=-0.5, force_x=1.0), ss.errors.NegativeOrNotFinite, "friction"),
        (lambda: solved(friction=np.ones((3, 3)), force_x=1.0), ss.errors.ArgumentType, "friction must be a real number"),
        (
            lambda: solved(friction=ss.Friction(np.ones((3, 3)), grid=ss.Grid.square(3, 1.0)), force_x=1.0),
            ss.errors.UnsupportedByModel, "friction that varies over cells",
        ),
        (lambda: solved(cell_limit=100), ss.errors.BelowMinimum, "limit of the cells"),
        (lambda: solved(cell_limit=-1), ss.errors.ArgumentRange, "cell_limit must not be negative"),
        (lambda: solved(time_limit=-1.0), ValueError, "time_limit must be a non-negative number of seconds, got -1"),
        (lambda: solved(force=-1.0), ss.errors.NegativeOrNotFinite, "force"),
        (lambda: solved(force=None, approach=-1e-6), ss.EmptyContact, "empty"),
        (lambda: solved(friction=0.5, force_x=60.0), ss.BeyondFrictionCapacity, "60.0"),
        (lambda: solved(ss.surface.sphere(ss.Grid.square(8, A), RADIUS)), ss.errors.BeyondSamples, "outside the samples, which extend to"),
        (lambda: solved().difference(solved(), "volume"), ValueError, "quantity must be one of"),
    ],
)  # fmt: skip
def test_wrong_argument_is_rejected(call, kind, message):
    with pytest.raises(kind, match=message):
        call()


def test_missing_sample_has_row_and_column():
    heights = ss.surface.sphere(ss.Grid.square(8, 8 * A), RADIUS).array.copy()
    heights[2, 3] = math.nan
    with pytest.raises(ss.errors.Sample, match="row 2, column 3") as refused:
        solved(ss.Field(ss.Grid.square(8, 8 * A), heights))
    assert (refused.value.row, refused.value.column) == (2, 3)


def test_problems_and_regions_round_trip():
    regions = [NEAR, Region.periodic((0, 1), [2, 3]), Region.line(np.array([0.0, 1.0]), 2.0)]
    for region in regions:
        assert pickle.loads(pickle.dumps(region)) == region and eval(repr(regions[1])) == regions[1]
    assert NEAR.x == NEAR.y == (-2 * A, 2 * A) and NEAR != WIDE and regions[2].y is None
    assert [region.boundary.name for region in regions] == ["non_periodic", "periodic", "periodic_along_y"]
    samples = ss.surface.sphere(ss.Grid.square(128, 4.2 * A), RADIUS)
    for problem in [
        AdaptiveProblem((STEEL, STEEL), ball, NEAR, approach=HERTZ.approach, target={"force": 0.02}, cell_limit=1 << 16),
        AdaptiveProblem([STEEL, STEEL], samples, NEAR, force=FORCE, interpolation="linear", friction=0.5, force_x=10.0, time_limit=60),
        AdaptiveProblem(PAIR, ball, NEAR, force=FORCE, friction=0.5, first_step=ss.LoadStep(shift_y=1e-7), model="vector"),
    ]:
        back = pickle.loads(pickle.dumps(problem))
        contact, other = problem.solve(), back.solve()
        assert back.targets == problem.targets and repr(back) == repr(problem)
        assert other.normal == contact.normal and other.stick_ratio == contact.stick_ratio
    assert pickle.loads(pickle.dumps(contact.normal)) == contact.normal
    with pytest.raises(TypeError, match="pickle"):
        pickle.dumps(contact)


def test_repr_states_status_cost_and_errors():
    contact = solved()
    assert repr(contact).startswith("AdaptiveSolution(reached, ") and "'pressure': 0.0" in repr(contact)
    assert f"after {len(contact.grids)} grids, force=100, approach={contact.approach:.6g}" in repr(contact)
    assert repr(contact.grids[0]).startswith("GridRecord(24 x 24 cells, centre=(")
    problem = AdaptiveProblem(PAIR, ball, NEAR, force=FORCE, target={"area": 1e-3})
    assert repr(problem) == "AdaptiveProblem(target={'area': 0.001})"


def test_coated_bodies_have_stick_ratio_without_edges():
    coated = ss.ElasticPair(STEEL.coated([ss.layers.Layer(400e9, 0.25, thickness=2e-6)]), STEEL)
    problem = AdaptiveProblem(coated, ball, NEAR, force=FORCE, friction=0.5, force_x=20.0, target=0.05)
    contact = problem.solve(warn=False)
    assert contact.stick_ratio == contact.tangential.stick_ratio
    assert contact.area == contact.normal.contact_area_corrected
    with pytest.raises(ss.errors.UnsupportedForCoatings):
        contact.edges()
