"""Messages for arguments in the wrong order, and for objects of a wrong class."""

import numpy as np
import pytest

import stickslip as ss

FORCE = 100.0
STEEL = ss.Material(213e9, 0.29)
PATH = ss.history.LoadPath.triangle((1e-6, 0.0), 8)


def load(shift):
    return ss.LoadStep(normal_force=FORCE, shift=shift)


LOOP = ss.history.FrettingLoop(PATH, load)


def pressed(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    return history


@pytest.mark.parametrize(
    ("name", "call", "message"),
    [
        ("history", lambda h, c: LOOP.run(10, h), "must be a History, got an object of the class int: the order is history, cycles"),
        ("cycles", lambda h, c: LOOP.run(h, "a"), "must be a whole number, got an object of the class str"),
        ("cycles", lambda h, c: LOOP.run(h, None), "must be a whole number, got None"),
        ("observer", lambda h, c: LOOP.run(h, 2, 5), "must be a function of history and cycle, got an object of the class int"),
        ("progress", lambda h, c: LOOP.run(h, 2, progress=5), "must be a function, True or None"),
        ("history", lambda h, c: LOOP.cycle(c, h), "must be a History, got an object of the class Cycle: the order is history, cycle"),
        ("cycle", lambda h, c: LOOP.cycle(h, h), r"must be a Cycle, got an object of the class History: create one by Cycle\(history\)"),
        ("path", lambda h, c: ss.history.FrettingLoop(load, PATH), "must be a LoadPath, got .* function: .* the order is path, load"),
        ("load", lambda h, c: ss.history.FrettingLoop(PATH, ss.LoadStep()), "must be a function .*, got .* LoadStep: give a function"),
        ("load", lambda h, c: ss.history.FrettingLoop(PATH, ss.LoadStep), "must be a function .*, got the class LoadStep"),
        ("until_steady", lambda h, c: ss.history.FrettingLoop(PATH, load, until_steady="a"), "must be a number in"),
    ],
)
def test_arguments_of_loop_are_named(scene, name, call, message):
    history = pressed(scene)
    before = history.to_bytes()
    with pytest.raises(ss.errors.ArgumentType, match=f"^{name} {message}") as caught:
        call(history, ss.history.Cycle(history))
    assert caught.value.argument == name and history.to_bytes() == before


def test_number_of_cycles_must_be_whole(scene):
    history = pressed(scene)
    for cycles in (-1, 2.5):
        with pytest.raises(ss.errors.ArgumentRange, match=f"cycles must be a whole number of at least 0, got {cycles}"):
            LOOP.run(history, cycles)
    assert LOOP.run(history, 1.0).cycles == 1


@pytest.mark.parametrize(
    "call",
    [
        lambda scene, contact: ss.TangentialProblem(contact, scene.bodies, 0.5, force_x=1.0),
        lambda scene, contact: ss.History(scene.ball, scene.bodies, 0.5),
        lambda scene, contact: ss.CoupledProblem(scene.ball, scene.bodies, 0.5, normal_force=1.0),
        lambda scene, contact: ss.rolling.RollingProblem(contact, scene.bodies, 0.5, creepage_x=1e-3),
        lambda scene, contact: ss.History.load("history", scene.bodies),
        lambda scene, contact: ss.History.from_bytes(b"history"[:0], scene.bodies),
    ],
)
def test_bodies_that_are_not_first_are_named(scene, call):
    message = r"^bodies must be of the class HalfSpace, got \w+: the bodies are the first argument, created by HalfSpace\(grid, pair\)"
    with pytest.raises(ss.errors.ArgumentType, match=message):
        call(scene, scene.normal())


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda scene: ss.TangentialProblem(scene.bodies, 0.5, scene.normal(), force_x=1.0), "got NormalSolution: .* before friction"),
        (lambda scene: ss.TangentialProblem(scene.bodies, ss.Friction(0.5), 0.5, force_x=1.0), "pressure .*got Friction: friction .* after"),
        (lambda scene: ss.TangentialProblem(scene.bodies, pressed(scene), 0.5, force_x=1.0), "pressure .*got History: .*history.pressure"),
        (lambda scene: ss.History(scene.bodies, 0.5, scene.ball), "gap .*got the number 0.5: .*friction after the gap"),
        (lambda scene: ss.History(scene.bodies, ss.Friction(0.5), scene.ball), "gap .*got Friction: friction is given after the gap"),
        (lambda scene: ss.CoupledProblem(scene.bodies, 0.5, scene.ball, normal_force=1.0), "gap .*friction after the gap"),
        (lambda scene: ss.surface.sphere(3.5e-3, scene.grid), r"grid must be of the class Grid, got float: create a grid by Grid\("),
        (lambda scene: ss.history.Cycle(scene.bodies), r"history must be of the class History, got HalfSpace: create a history"),
        (lambda scene: ss.history.AdaptiveSteps(0.1, pressed(scene)), "history must be of the class History, got float"),
    ],
)
def test_arguments_in_wrong_order_are_named(scene, call, message):
    with pytest.raises(TypeError, match=message):
        call(scene)


@pytest.mark.parametrize(
    ("solver", "problem"),
    [
        (ss.TangentialSolver, "TangentialProblem(bodies, normal, friction, force_x=...)"),
        (ss.CoupledSolver, "CoupledProblem(bodies, gap, friction, normal_force=..., force_x=...)"),
        (ss.rolling.RollingSolver, "RollingProblem(bodies, normal, friction, creepage_x=...)"),
        (ss.rolling.CoupledRollingSolver, "CoupledRollingProblem(bodies, gap, friction, normal_force=..., creepage_x=...)"),
    ],
)
def test_solver_without_constructor_names_its_problem(scene, solver, problem):
    for arguments, keywords in (((), {}), ((scene.bodies, scene.ball, 0.5), {"force_x": 1.0})):
        with pytest.raises(TypeError) as caught:
            solver(*arguments, **keywords)
        assert str(caught.value) == f"{solver.__name__} is created from its problem, by {problem}.solver()"


def test_closed_forms_accept_two_materials(scene):
    pair = scene.bodies.pair
    assert ss.analytical.HertzSphere((STEEL, STEEL), radius=1e-3, load=1.0) == ss.analytical.HertzSphere(pair, radius=1e-3, load=1.0)
    assert ss.analytical.SpencePressing.round([STEEL, STEEL], 0.3) == ss.analytical.SpencePressing.round(pair, 0.3)
    assert ss.influence.Table(scene.grid, (STEEL, STEEL), "zz").size == ss.influence.Table(scene.grid, pair, "zz").size
    for wrong, found in ((STEEL, "Material"), (scene.bodies, "HalfSpace"), ((STEEL, 0.3), r"\(Material, float\)")):
        message = rf"^pair must be an ElasticPair or a tuple of two Materials, \(material_1, material_2\), got {found}$"
        with pytest.raises(ss.errors.ArgumentType, match=message):
            ss.analytical.HertzSphere(wrong, radius=1e-3, load=1.0)


@pytest.mark.parametrize(
    ("name", "draw", "due"),
    [
        ("solution", ss.plot.pressure_map, "a normal or coupled solution, a state or a history"),
        ("solution", ss.plot.stick_map, "a tangential, coupled or rolling solution, a state or a history"),
        ("solution", ss.plot.traction_map, "a tangential, coupled or rolling solution, a state or a history"),
        ("spots", ss.plot.spot_map, "ContactSpots, a normal or coupled solution, a history"),
        ("planes", ss.plot.stress_section, "a sequence of Plane, as returned by Planes.solve_all"),
        ("cycle", ss.plot.hysteresis, "a Cycle"),
        ("reports", ss.plot.work_precision, "a sequence of Report"),
    ],
)
def test_plots_name_objects_of_wrong_class(scene, name, draw, due):
    pytest.importorskip("matplotlib")
    for wrong in (5, None, "text", scene.grid, scene.bodies, np.zeros(scene.grid.shape), ss.History):
        with pytest.raises(ss.errors.ArgumentType, match=f"^{name} must be {due}") as caught:
            draw(wrong)
        assert caught.value.argument == name
    with pytest.raises(ss.errors.ArgumentType, match="got an object of the class NormalSolution"):
        ss.plot.stick_map(scene.normal())
    for draw in (ss.plot.pressure_map, ss.plot.stick_map, ss.plot.traction_map):
        for array in (scene.normal().pressure, scene.ball):
            with pytest.raises(ss.errors.ArgumentType, match=r"draw an array by plot\.field\(grid, array\)$"):
                draw(array)
    with pytest.raises(TypeError, match="got NormalSolution: give solution.grid, solution.pressure"):
        ss.plot.field(scene.normal())


def test_loop_of_snapshot_is_described_in_words(scene):
    snapshot = ss.wear.run(pressed(scene), LOOP, ss.wear.EnergyLaw(1e-13), 10).snapshot
    again = snapshot.restored(scene.bodies)
    shown = r"8 steps with LoadStep\(normal_force=100, shift_x=1e-06, shift_y=0\) at the largest value \(digest [0-9a-f]{16}\)"
    longer = ss.history.FrettingLoop(ss.history.LoadPath.triangle((2e-6, 0.0), 12), load)
    message = rf"the loop of the snapshot is {shown}, got 12 steps with LoadStep\(normal_force=100, shift_x=2e-06, shift_y=0\) at"
    with pytest.raises(ss.errors.SnapshotMismatch, match=message):
        ss.wear.run(again, longer, ss.wear.EnergyLaw(1e-13), 20, resume=snapshot)
    close = ss.history.FrettingLoop(PATH, lambda shift: ss.LoadStep(normal_force=np.nextafter(FORCE, 200.0), shift=shift))
    with pytest.raises(ss.errors.SnapshotMismatch, match=rf"{shown} \(the difference is in other steps, or in digits that are not shown\)"):
        ss.wear.run(again, close, ss.wear.EnergyLaw(1e-13), 20, resume=snapshot)
