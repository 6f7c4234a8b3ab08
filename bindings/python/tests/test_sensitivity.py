"""Sensitivities: central differences of solves, arguments, errors and pickles."""

import copy
import pickle

import numpy as np
import pytest

import stickslip as ss
from stickslip.sensitivity import Functional

RADIUS, MODULUS, FRICTION, FORCE = 10.0, 210e3, 0.4, 100.0  # mm and MPa
CELLS = 32
TIGHT = {"tolerance": 1e-13}
# Relative step of differences, within which no cell changes its set, and their largest deviation from the derivative.
STEP, DEVIATION = 1e-6, 1e-6


def pair(modulus=1.0, poisson_ratios=(0.3, 0.2)):
    """Two bodies whose moduli are a common multiple of given moduli."""
    moduli = (MODULUS * modulus, 0.5 * MODULUS * modulus)
    return tuple(ss.Material(own, ratio) for own, ratio in zip(moduli, poisson_ratios))


GRID = ss.Grid.square(CELLS, 0.8)
BALL = ss.surface.sphere(GRID, RADIUS)
BODIES = ss.HalfSpace(GRID, pair())
E = BODIES.pair.contact_modulus


def difference(value, at, step=STEP):
    """Returns the central difference of a function with a relative step."""
    return (value(at * (1.0 + step)) - value(at * (1.0 - step))) / (2.0 * step * at)


def near(expected):
    return pytest.approx(expected, rel=DEVIATION)


def pressed(force=FORCE, gap=BALL, modulus=1.0, poisson_ratios=(0.3, 0.2)):
    bodies = ss.HalfSpace(GRID, pair(modulus, poisson_ratios))
    solver = ss.NormalSolver(bodies, gap, force=force, **TIGHT)
    return solver, solver.solve(warn=False)


@pytest.mark.parametrize(
    "functional", [Functional.pressure_norm(8.0), Functional.rms_pressure(), Functional.elastic_energy(), Functional.approach()]
)
def test_normal_derivatives_match_differences(functional):
    solver, contact = pressed()
    found = solver.sensitivity(contact, functional)

    def value(**change):
        solver, contact = pressed(**change)
        return solver.sensitivity(contact, functional).value

    assert found.normal_load == near(difference(lambda force: value(force=force), FORCE))
    assert found.contact_modulus * E == near(difference(lambda modulus: value(modulus=modulus), 1.0))
    expected = difference(lambda ratio: value(poisson_ratios=(ratio, 0.2)), 0.3)
    assert found.poisson_ratio[0] == near(expected)

    def lifted(height):
        gap = BALL.array.copy()
        gap[CELLS // 2, CELLS // 2 + 2] += height - 1e-5
        return value(gap=gap)

    assert found.gap[CELLS // 2, CELLS // 2 + 2] == near(difference(lifted, 1e-5, step=1e-3))
    assert found.pressure is None and found.friction is None and found.tangential_load == (None, None)
    assert found.value == value()


def sheared(friction=FRICTION, force=FORCE, modulus=1.0, **load):
    presser, normal = pressed(force=force, modulus=modulus)
    bodies = ss.HalfSpace(GRID, pair(modulus))
    problem = ss.TangentialProblem(bodies, normal, friction, **(load or {"force_x": 20.0}), **TIGHT)
    solver = problem.solver()
    return presser, normal, solver, solver.solve(warn=False)


def test_tangential_derivatives_match_differences():
    functionals = [Functional.shift("x"), Functional.dissipated_energy(), Functional.stick_force("x")]
    presser, normal, solver, tangential = sheared()
    alone = solver.sensitivities(tangential, functionals)
    assert [found.normal_load for found in alone] == [None] * 3 and all(found.gap is None for found in alone)
    chained = presser.chain(normal, alone)

    def values(**change):
        _, _, solver, tangential = sheared(**change)
        return np.array([found.value for found in solver.sensitivities(tangential, functionals)])

    assert [found.value for found in chained] == list(values()) and values()[0] == tangential.shift[0]

    def check(found, expected):
        assert found == [near(one) for one in expected]

    check([found.friction_coefficient for found in chained], difference(lambda mu: values(friction=mu), FRICTION))
    check([found.tangential_load[0] for found in chained], difference(lambda force: values(force_x=force), 20.0))
    check([found.normal_load for found in chained], difference(lambda force: values(force=force), FORCE))
    check([found.contact_modulus * E for found in chained], difference(lambda modulus: values(modulus=modulus), 1.0))
    for found in chained:
        assert np.asarray(found.friction).sum() == pytest.approx(found.friction_coefficient)
        assert found.tangential_load[1] is None and found.twist is None and found.gap.shape == (CELLS, CELLS)


def test_force_at_prescribed_shift_matches_differences():
    def found(**change):
        presser, normal, solver, tangential = sheared(**{"shift_x": 1e-3, **change})
        [chained] = presser.chain(normal, [solver.sensitivity(tangential, Functional.tangential_force("x"))])
        return chained

    own = found()
    assert own.friction_coefficient == near(difference(lambda mu: found(friction=mu).value, FRICTION))
    assert own.contact_modulus * E == near(difference(lambda modulus: found(modulus=modulus).value, 1.0))
    assert own.tangential_load[0] == near(difference(lambda shift: found(shift_x=shift).value, 1e-3))
    # A contact that slides carries the friction limit.
    sliding = found(shift_x=1.0)
    assert sliding.friction_coefficient == pytest.approx(FORCE, rel=1e-9)
    assert sliding.contact_modulus * E == pytest.approx(0.0, abs=1e-9 * FRICTION * FORCE)


def coupled(friction=FRICTION, force=FORCE, modulus=1.0, poisson_ratios=(0.3, 0.2), **load):
    bodies = ss.HalfSpace(GRID, pair(modulus, poisson_ratios))
    load = load or {"force_x": 20.0}
    solver = ss.CoupledProblem(bodies, BALL, friction, normal_force=force, **load, **TIGHT).solver()
    return solver, solver.solve(warn=False)


def test_coupled_derivatives_match_differences():
    functionals = [Functional.approach(), Functional.shift("x"), Functional.elastic_energy()]
    solver, contact = coupled()
    found = solver.sensitivities(contact, functionals, poisson_ratio=True)

    def values(**change):
        solver, contact = coupled(**change)
        return np.array([found.value for found in solver.sensitivities(contact, functionals)])

    def check(found, expected):
        assert found == [near(one) for one in expected]

    check([one.friction_coefficient for one in found], difference(lambda mu: values(friction=mu), FRICTION))
    check([one.normal_load for one in found], difference(lambda force: values(force=force), FORCE))
    check([one.tangential_load[0] for one in found], difference(lambda force: values(force_x=force), 20.0))
    check([one.contact_modulus * E for one in found], difference(lambda modulus: values(modulus=modulus), 1.0))
    check([one.poisson_ratio[1] for one in found], difference(lambda ratio: values(poisson_ratios=(0.3, ratio)), 0.2))
    assert all(one.poisson_ratio is None for one in solver.sensitivities(contact, functionals))


def test_derivatives_of_step_match_differences():
    functionals = [Functional.tangential_force("x"), Functional.dissipated_energy(), Functional.normal_force()]
    steel = ss.Material(MODULUS, 0.3)
    bodies = ss.HalfSpace(GRID, (steel, steel))

    def stepped(friction=FRICTION, shift=1e-3, force=FORCE):
        history = ss.History(bodies, BALL, FRICTION, **TIGHT)
        history.step(normal_force=80.0, shift_x=5e-4, warn=False)
        history.set_friction(friction)
        load = ss.LoadStep(normal_force=force, shift_x=shift)
        history.step(load, warn=False)
        return history, load

    def values(**change):
        history, load = stepped(**change)
        return np.array([found.value for found in history.sensitivities(load, functionals)])

    history, load = stepped()
    found = history.sensitivities(load, functionals)
    assert history.sensitivity(load, functionals[0]) == found[0]
    for name, derivative, at in (
        ("friction", [one.friction_coefficient for one in found], FRICTION),
        ("shift", [one.tangential_load[0] for one in found], 1e-3),
        ("force", [one.normal_load for one in found], FORCE),
    ):
        expected = difference(lambda value: values(**{name: value}), at)
        assert derivative == [pytest.approx(one, rel=DEVIATION, abs=1e-9) for one in expected]
    assert found[2].normal_load == near(1.0) and found[0].contact_modulus is None
    with pytest.raises(TypeError, match="load must be a LoadStep, got float"):
        history.sensitivity(1.0, functionals[0])
    with pytest.raises(ss.errors.UnsupportedByModel, match="step without rolling"):
        history.sensitivity(ss.LoadStep(roll=ss.history.Rolling(1)), functionals[0])
    with pytest.raises(ss.errors.NoLastStep):
        ss.History(bodies, BALL, FRICTION).sensitivity(load, functionals[0])


def test_weights_are_derivatives_of_misfit():
    target = 1000.0

    def misfit(force):
        return ((pressed(force=force)[1].pressure - target) ** 2).sum()

    solver, contact = pressed()
    weights = 2.0 * (contact.pressure - target)
    found = solver.sensitivity(contact, Functional.weighted(pressure=weights, grid=GRID))
    # Cells without contact keep their pressure of zero.
    assert found.normal_load == near(difference(misfit, FORCE))
    assert found == solver.sensitivity(contact, Functional.weighted(pressure=ss.Field(GRID, weights)))
    twice = Functional.weighted(pressure=2.0 * weights, approach=3.0, grid=GRID)
    expected = 2.0 * found.normal_load + 3.0 * solver.sensitivity(contact, Functional.approach()).normal_load
    assert solver.sensitivity(contact, twice).normal_load == pytest.approx(expected)


def test_pairs_of_weights_are_sequences_or_arrays():
    _, _, solver, tangential = sheared()
    area = np.full((2, CELLS, CELLS), GRID.cell_area) * np.array([1.0, 0.0])[:, None, None]
    expected = solver.sensitivity(tangential, Functional.tangential_force("x"))
    fields = tuple(ss.Field(GRID, part) for part in area)
    for pair in (area, list(area), tuple(area), fields, (GRID.cell_area, ss.Field(GRID, 0.0))):
        found = solver.sensitivity(tangential, Functional.weighted(traction=pair, grid=GRID))
        assert found.value == pytest.approx(expected.value)
        assert np.allclose(found.friction, expected.friction, atol=1e-9 * np.abs(expected.friction).max())
    shift = solver.sensitivity(tangential, Functional.weighted(shift=(2.0, 5.0)))
    assert shift.value == 2.0 * tangential.shift[0]
    slip = solver.sensitivity(tangential, Functional.weighted(slip=fields))
    assert slip.value == pytest.approx(GRID.cell_area * tangential.slip[0].sum())


def test_results_are_fields_numbers_and_report():
    presser, normal, solver, tangential = sheared()
    found = solver.sensitivity(tangential, Functional.shift("x"))
    for field in (found.pressure, found.friction):
        assert isinstance(field, ss.Field) and field.grid == GRID
        array = np.asarray(field)
        assert array.shape == (CELLS, CELLS) and not array.flags.writeable
        assert np.shares_memory(array, np.asarray(field))
    assert np.shares_memory(found.friction.array, found.friction.array)
    assert found.report.is_converged and found.report.products > 0 and found.report.residual < 1e-11
    [chained] = presser.chain(normal, [found])
    assert chained.report.products > found.report.products and chained.pressure == found.pressure
    numbers = chained.to_dict()
    assert numbers["tangential_load_x"] == chained.tangential_load[0] and numbers["tangential_load_y"] is None
    assert numbers["poisson_ratio_1"] is None and "gap" not in numbers
    [normal_only] = presser.sensitivities(normal, [Functional.approach()])
    assert normal_only.to_dict()["poisson_ratio_2"] == normal_only.poisson_ratio[1]
    for value in (found, chained, normal_only, Functional.shift("y")):
        text = repr(value)
        assert type(value).__name__ in text and len(text.splitlines()) == 1 and " object at " not in text
    assert presser.sensitivities(normal, []) == [] and presser.chain(normal, []) == []


def test_to_series_has_numbers():
    pytest.importorskip("pandas")
    solver, contact = pressed()
    series = solver.sensitivity(contact, Functional.approach()).to_series()
    assert series["value"] == contact.approach and series.name == "Sensitivity"


def functionals():
    weights = np.linspace(0.0, 1.0, CELLS * CELLS).reshape(CELLS, CELLS)
    return [
        Functional.pressure_norm(3),
        Functional.rms_pressure(),
        Functional.elastic_energy(),
        Functional.normal_force(),
        Functional.approach(),
        Functional.tangential_force("x"),
        Functional.shift(ss.Axis.Y),
        Functional.stick_force("y"),
        Functional.dissipated_energy(),
        Functional.weighted(pressure=weights, traction=(weights, 0.0), slip=(0.0, weights), approach=2.0, shift=(1, 2), grid=GRID),
    ]  # fmt: skip


def test_functionals_compare_and_round_trip():
    own = functionals()
    for index, functional in enumerate(own):
        assert pickle.loads(pickle.dumps(functional)) == functional == functionals()[index]
        assert all(functional != other for other in own[:index])
    assert repr(own[5]) == "Functional.tangential_force('x')" and repr(own[0]) == "Functional.pressure_norm(3)"
    assert Functional.rms_pressure() == Functional.pressure_norm(2.0)


def test_sensitivities_round_trip():
    presser, normal, solver, tangential = sheared()
    alone = solver.sensitivity(tangential, Functional.shift("x"), poisson_ratio=True)
    assert len(alone.poisson_ratio) == 2
    for found in (alone, *presser.chain(normal, [alone]), presser.sensitivity(normal, Functional.approach())):
        for copied in (pickle.loads(pickle.dumps(found)), copy.deepcopy(found)):
            assert copied == found and copied.to_dict() == found.to_dict() and copied.report == found.report
    # A restored sensitivity can be continued.
    assert presser.chain(normal, [pickle.loads(pickle.dumps(alone))]) == presser.chain(normal, [alone])


@pytest.mark.parametrize(
    ("call", "kind", "message"),
    [
        (lambda: Functional.pressure_norm("a"), TypeError, "exponent must be a real number, got text"),
        (lambda: Functional.shift("z"), ValueError, "axis must be one of 'x', 'y'"),
        (lambda: Functional.shift(1), TypeError, "axis must be one of 'x', 'y'"),
        (lambda: Functional.weighted(pressure=np.ones((2, 3)), grid=GRID), ss.errors.Shape, r"pressure has shape \(2, 3\)"),
        (lambda: Functional.weighted(pressure=np.ones((CELLS, CELLS))), TypeError, "give grid="),
        (lambda: Functional.weighted(traction=3.0, grid=GRID), TypeError, r"traction must be a pair \(x, y\) of fields, got float"),
        (lambda: Functional.weighted(slip=[BALL], grid=GRID), TypeError, r"slip must be a pair \(x, y\) of fields, got list"),
        (lambda: Functional.weighted(slip=(BALL, "a"), grid=GRID), TypeError, "slip must be real numbers, got text"),
        (lambda: Functional.weighted(shift=1.0), TypeError, r"shift must be a pair \(x, y\) of weights, got float"),
        (lambda: Functional.weighted(approach=1j), TypeError, "approach must be a real number, got complex"),
        (lambda: Functional(), TypeError, "Functional"),
    ],
)
def test_wrong_functionals_are_rejected(call, kind, message):
    with pytest.raises(kind, match=message):
        call()


def test_wrong_arguments_are_rejected():
    presser, normal, solver, tangential = sheared()
    errors = ss.errors
    with pytest.raises(TypeError, match="is not an instance of 'Functional'\nwhile processing 'functional'"):
        presser.sensitivity(normal, "approach")
    with pytest.raises(TypeError, match="is not an instance of 'NormalSolution'\nwhile processing 'solution'"):
        presser.sensitivity(tangential, Functional.approach())
    with pytest.raises(TypeError, match="(?s)while processing 'functionals'"):
        presser.sensitivities(normal, Functional.approach())
    with pytest.raises(errors.Tolerance, match="tolerance"):
        presser.sensitivity(normal, Functional.approach(), tolerance=-1.0)
    with pytest.raises(TypeError, match="tolerance must be a real number, got text"):
        presser.sensitivity(normal, Functional.approach(), tolerance="a")
    with pytest.raises(errors.BelowMinimum, match="exponent"):
        presser.sensitivity(normal, Functional.pressure_norm(0.5))
    with pytest.raises(errors.UnsupportedByModel, match="tangential or coupled"):
        presser.sensitivity(normal, Functional.shift("x"))
    with pytest.raises(errors.UnsupportedByModel, match="normal or coupled"):
        solver.sensitivity(tangential, Functional.approach())
    with pytest.raises(errors.UnsupportedByModel, match="chain each sensitivity of a tangential contact once"):
        presser.chain(normal, presser.sensitivities(normal, [Functional.approach()]))
    with pytest.raises(errors.Sample, match="weights of the pressures at row 0, column 1"):
        weights = np.ones((CELLS, CELLS))
        weights[0, 1] = np.nan
        presser.sensitivity(normal, Functional.weighted(pressure=weights, grid=GRID))
    other = ss.Grid.square(16, 0.8)
    with pytest.raises(errors.GridMismatch, match="weights of the pressures"):
        presser.sensitivity(normal, Functional.weighted(pressure=ss.Field(other, 1.0)))
    bodies = ss.HalfSpace(other, pair())
    foreign = ss.NormalProblem(bodies, ss.surface.sphere(other, RADIUS), force=FORCE).solve(warn=False)
    with pytest.raises(errors.GridMismatch):
        presser.sensitivity(foreign, Functional.approach())
    presser.set_load(force=0.0)
    with pytest.raises(errors.EmptyContact):
        presser.sensitivity(presser.solve(warn=False), Functional.approach())
