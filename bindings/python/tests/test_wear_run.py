"""Wear over many cycles: limits, endings, resumption and interruption of ``wear.run``, and progress of loops."""

import copy
import os
import pickle
import signal
import subprocess
import sys

import numpy as np
import pytest

import stickslip as ss

FORCE, COEFFICIENT = 100.0, 1e-13
TIMEOUT = 120

GRID = ss.Grid.square(32, 0.3e-3)
STEEL = ss.Material(213e9, 0.29)
BODIES = ss.HalfSpace(GRID, (STEEL, STEEL))


def load(shift):
    return ss.LoadStep(normal_force=FORCE, shift=shift)


def loop(amplitude=1e-6, steps=8):
    return ss.history.FrettingLoop(ss.history.LoadPath.triangle((amplitude, 0.0), steps), load)


def history():
    history = ss.History(BODIES, ss.surface.sphere(GRID, 3.5e-3), 0.5, tolerance=1e-6)
    history.step(normal_force=FORCE)
    return history


def five_percent(history):
    return 0.05 * history.approach


LAW = ss.wear.EnergyLaw(COEFFICIENT)


def test_wear_agrees_with_loop_written_by_hand():
    worn, by_hand = history(), history()
    result = ss.wear.run(worn, loop(), LAW, 2000, largest_depth=five_percent, settling=2, max_residual=0.2)

    cycle, done, depth = ss.history.Cycle(by_hand), 0, np.zeros(GRID.shape)
    while True:
        loop().cycle(by_hand, cycle)
        if cycle.cyclic_residual > 0.2:
            loop().cycle(by_hand, cycle)
        if done == 2000:
            break
        of_cycle = ss.wear.energy(COEFFICIENT, cycle.dissipation, grid=GRID)
        limits = {"largest_depth": five_percent(by_hand), "cycles_left": 2000 - done, "max_residual": 0.2}
        jump = ss.wear.CycleJump(BODIES, cycle, of_cycle, **limits).cycles()
        depth = depth + jump * of_cycle
        by_hand.set_gap(by_hand.gap_as_set + jump * of_cycle)
        done += jump
    assert np.array_equal(result.depth, depth) and worn.to_bytes() == by_hand.to_bytes()
    assert result.ending == ss.wear.WearEnding.CYCLE_LIMIT == "cycle_limit" and result.cycles == 2000
    assert np.allclose(worn.gap_as_set, ss.surface.sphere(GRID, 3.5e-3) + depth, rtol=0, atol=1e-18)


def yielded_history():
    history = ss.History(BODIES, ss.surface.sphere(GRID, 3.5e-3), 0.5, hardness=2e9, permanent_set=True, tolerance=1e-6)
    history.step(normal_force=FORCE)
    return history


def test_permanent_set_counts_once_over_several_jumps():
    worn = yielded_history()
    loop().cycle(worn, ss.history.Cycle(worn))
    before = worn.state()
    assert before.yielded.max() > 0.01 * before.approach
    found = ss.wear.run(worn, loop(), ss.wear.EnergyLaw(1e-40), 50, largest_jump=10).history
    assert list(found.jump) == [10] * 5 + [0]
    assert np.allclose(found.approach, before.approach, rtol=1e-5)
    assert np.allclose(worn.state().yielded, before.yielded, rtol=0, atol=1e-4 * before.yielded.max())
    assert np.allclose(worn.gap_as_set, before.gap_as_set, rtol=0, atol=1e-18)


def test_wear_with_permanent_set_agrees_with_loop_written_by_hand():
    limits = {"largest_depth": five_percent, "largest_jump": 100, "settling": 1, "max_residual": 0.99}
    worn, by_hand = yielded_history(), yielded_history()
    result = ss.wear.run(worn, loop(), LAW, 500, **limits)
    cycle, done, depth = ss.history.Cycle(by_hand), 0, np.zeros(GRID.shape)
    while True:
        loop().cycle(by_hand, cycle)
        if done == 500:
            break
        of_cycle = ss.wear.energy(COEFFICIENT, cycle.dissipation, grid=GRID)
        jump = ss.wear.CycleJump(BODIES, cycle, of_cycle, largest_depth=five_percent(by_hand), max_residual=0.99).cycles()
        jump = min(jump, 100, 500 - done)
        depth = depth + jump * of_cycle
        by_hand.set_gap(ss.surface.sphere(GRID, 3.5e-3) + depth)
        done += jump
    # The gaps differ by round-off, and the solves by their tolerance.
    assert len(result.history) > 5 and np.allclose(result.depth, depth, rtol=0, atol=1e-6 * depth.max())
    assert worn.approach == pytest.approx(by_hand.approach, rel=1e-6)
    assert np.allclose(worn.state().yielded, by_hand.state().yielded, rtol=0, atol=1e-6 * by_hand.state().yielded.max())

    first = ss.wear.run(yielded_history(), loop(), LAW, 500, progress=lambda _: False, **limits)
    restored = first.snapshot.restored(BODIES)
    rest = ss.wear.run(restored, loop(), LAW, 500, resume=first.snapshot, **limits)
    assert np.array_equal(rest.depth, result.depth) and restored.approach == worn.approach


def test_histories_are_consistent():
    worn = history()
    result = ss.wear.run(worn, loop(5e-6), LAW, 300, largest_depth=five_percent)
    found = result.history
    assert found.cycles[0] == 0 and found.cycles[-1] == 300 == found.jump.sum() and found.jump[-1] == 0
    assert np.array_equal(np.diff(found.cycles), found.jump[:-1]) and found.cycles.dtype.kind == "i"
    # Energy and volume are sums over the cycles. The energy law links them.
    assert np.allclose(np.diff(found.dissipated_energy), found.jump[:-1] * found.energy_per_cycle[:-1], rtol=1e-12)
    assert np.allclose(found.worn_volume, COEFFICIENT * found.dissipated_energy, rtol=1e-10)
    assert found.worn_volume[-1] == pytest.approx(result.depth.sum() * GRID.cell_area)
    assert found.max_depth[-1] == result.depth.max()
    assert np.allclose(found.normal_force, FORCE, rtol=1e-5)
    # In gross slip the amplitude of the force is the sliding force. The contact of a worn ball grows.
    assert np.allclose(found.force_amplitude_x, 0.5 * FORCE, rtol=1e-3) and np.allclose(found.shift_amplitude_x, 5e-6)
    assert (found.cyclic_residual <= 0.05).all() and found.contact_area[-1] > 1.05 * found.contact_area[0]
    assert np.allclose(np.pi * found.contact_radius**2, found.contact_area)
    assert list(found.to_dict()) == list(ss.wear.WearHistory.__dataclass_fields__)
    assert len(found) == len(found.cycles) and repr(result).startswith("WearResult(cycles=300, ending='cycle_limit'")


def test_full_stick_jumps_over_all_cycles_at_once():
    result = ss.wear.run(history(), loop(1e-10), LAW, 10**9, largest_depth=1e-9, max_depth=1e-9)
    assert list(result.history.cycles) == [0, 10**9] and result.history.worn_volume[-1] == 0.0
    assert result.last.regime == ss.history.Regime.FULL_STICK and result.ending == "cycle_limit"


def test_depth_and_jumps_are_limited():
    result = ss.wear.run(history(), loop(), LAW, 10**6, max_depth=2e-8, largest_depth=3e-9)
    found = result.history
    assert result.ending == ss.wear.WearEnding.DEPTH and result.cycles < 10**6
    first = LAW(history(), result.last).max()
    assert 2e-8 <= found.max_depth[-1] < 2e-8 + 2.0 * first
    assert (np.diff(found.max_depth) <= 3e-9 * (1.0 + 1e-12)).all()
    short = ss.wear.run(history(), loop(), LAW, 100, largest_jump=30)
    assert list(short.history.jump) == [30, 30, 30, 10, 0]


def test_archard_law_agrees_with_energy_law_by_friction():
    one = ss.wear.run(history(), loop(), LAW, 500)
    other = ss.wear.run(history(), loop(), ss.wear.ArchardLaw(0.5 * COEFFICIENT), 500)
    assert np.allclose(one.depth, other.depth, rtol=1e-3, atol=1e-4 * one.depth.max())


def test_stopped_run_resumes_with_identical_results(tmp_path):
    whole = ss.wear.run(history(), loop(), LAW, 3000, largest_depth=five_percent)
    seen = []

    def stop(snapshot):
        seen.append(snapshot.cycles)
        return len(seen) < 3

    first = ss.wear.run(history(), loop(), LAW, 3000, largest_depth=five_percent, progress=stop)
    assert first.ending == ss.wear.WearEnding.STOPPED and first.cycles == seen[-1] and len(seen) == 3
    file = tmp_path / "snapshot.npz"
    first.snapshot.save(file)
    assert [path.name for path in tmp_path.iterdir()] == ["snapshot.npz"]
    for snapshot in (first.snapshot, pickle.loads(pickle.dumps(first.snapshot)), ss.wear.WearSnapshot.load(file)):
        restored = snapshot.restored(BODIES)
        rest = ss.wear.run(restored, loop(), LAW, 3000, largest_depth=five_percent, resume=snapshot)
        assert np.array_equal(rest.depth, whole.depth) and rest.cycles == 3000
        for name, column in whole.history.to_dict().items():
            assert np.array_equal(column, rest.history.to_dict()[name]), name


def test_complete_run_continues_with_more_cycles():
    worn = history()
    first = ss.wear.run(worn, loop(), LAW, 1000, snapshot_every=400, largest_jump=100)
    assert [snapshot.cycles for snapshot in first.snapshots] == [400, 800]
    rest = ss.wear.run(worn, loop(), LAW, 1500, resume=first.snapshot, largest_jump=100)
    assert list(rest.history.cycles) == list(range(0, 1501, 100))
    middle = first.snapshots[0]
    from_middle = ss.wear.run(middle.restored(BODIES), loop(), LAW, 1000, resume=middle, largest_jump=100)
    assert np.array_equal(from_middle.depth, first.depth)


def test_failure_leaves_history_in_state_after_last_jump():
    worn, calls = history(), []

    def law(history, cycle):
        calls.append(history.to_bytes())
        if len(calls) == 3:
            raise ZeroDivisionError("from the law")
        return LAW(history, cycle)

    with pytest.raises(ZeroDivisionError, match="from the law") as caught:
        ss.wear.run(worn, loop(), law, 3000, largest_depth=five_percent)
    snapshot = caught.value.snapshot
    assert len(snapshot.history) == 2 and snapshot.cycles == snapshot.history.jump.sum()
    assert worn.state().to_bytes() == snapshot.state.to_bytes()
    # The law fails once only.
    rest = ss.wear.run(worn, loop(), law, 3000, largest_depth=five_percent, resume=snapshot)
    whole = ss.wear.run(history(), loop(), LAW, 3000, largest_depth=five_percent)
    assert np.array_equal(rest.depth, whole.depth)


def test_arguments_and_limits_are_checked():
    for name, value in (("cycles", -1), ("cycles", 10.7), ("settling", 0), ("largest_jump", 0), ("snapshot_every", 0), ("max_depth", -1.0)):
        arguments = {"cycles": 10, name: value}
        with pytest.raises(ss.errors.ArgumentRange, match=name) as caught:
            ss.wear.run(history(), loop(), LAW, **arguments)
        assert caught.value.argument == name
    with pytest.raises(ss.errors.NoWholeCycle):
        ss.wear.run(history(), loop(), ss.wear.EnergyLaw(1e-9), 10)
    with pytest.raises(ss.errors.CycleNotClosed):
        ss.wear.run(history(), loop(), LAW, 10, settling=1, max_residual=1e-12)
    assert ss.wear.run(history(), loop(), LAW, 0).cycles == 0


@pytest.mark.parametrize("law", [ss.wear.EnergyLaw, lambda coefficient: ss.wear.ThresholdEnergyLaw(coefficient, 0.0)])
def test_cycle_that_removes_more_than_largest_depth_is_rejected(law):
    for limit in (1e-25, lambda history: 1e-25):
        sentence = r"a cycle removes up to \S+, more than largest_depth, which is 1e-25 \(\S+ cycles\): give a larger largest_depth"
        with pytest.raises(ss.errors.NoWholeCycle, match=sentence) as caught:
            ss.wear.run(history(), loop(), law(COEFFICIENT), 10, largest_depth=limit)
        assert 0.0 < caught.value.cycles < 1.0 and caught.value.snapshot.cycles == 0
    # The stability of the worn gap is the smaller limit.
    with pytest.raises(ss.errors.NoWholeCycle, match="a cycle removes more than the limit, which is .*: reduce the wear") as caught:
        ss.wear.run(history(), loop(), law(1e-9), 10, largest_depth=1e-6)
    assert 0.0 < caught.value.cycles < 1.0


def test_history_out_of_contact_is_rejected():
    apart = ss.History(BODIES, ss.surface.sphere(GRID, 3.5e-3), 0.5)
    with pytest.raises(ss.errors.EmptyContact, match="press it by a step with a normal load before the run"):
        ss.wear.run(apart, loop(), LAW, 10)
    assert apart.steps == 0


def per_cell(history, cycle):
    return LAW(history, cycle)


def test_snapshot_resumes_with_its_law_and_loop_only():
    worn = history()
    first = ss.wear.run(worn, loop(), LAW, 100)
    before = worn.to_bytes()
    with pytest.raises(ss.errors.ArgumentRange, match="cycles must be at least 100, .* got 99"):
        ss.wear.run(worn, loop(), LAW, 99, resume=first.snapshot)
    coefficients = np.full(GRID.shape, COEFFICIENT)
    others = [ss.wear.EnergyLaw(2e-13), ss.wear.ArchardLaw(COEFFICIENT), ss.wear.EnergyLaw(coefficients), per_cell]
    for law in others:
        with pytest.raises(ss.errors.SnapshotMismatch, match=r"law of the snapshot is EnergyLaw\(coefficient=1e-13\), got") as caught:
            ss.wear.run(worn, loop(), law, 200, resume=first.snapshot)
        assert caught.value.argument == "law"
    heavier = ss.history.FrettingLoop(loop()._path, lambda shift: ss.LoadStep(normal_force=2.0 * FORCE, shift=shift))
    for other in (loop(2e-6), loop(steps=12), heavier):
        with pytest.raises(ss.errors.SnapshotMismatch, match="the loop of the snapshot is 8 steps") as caught:
            ss.wear.run(worn, other, LAW, 200, resume=first.snapshot)
        assert caught.value.argument == "loop"
    assert worn.to_bytes() == before
    # Limits are choices of a run.
    rest = ss.wear.run(worn, loop(), ss.wear.EnergyLaw(np.float64(COEFFICIENT)), 200, resume=first.snapshot, settling=5)
    assert rest.cycles == 200
    by_name = ss.wear.run(history(), loop(), per_cell, 50)
    assert by_name.snapshot.law == f"{__name__}.per_cell"


def test_history_that_differs_from_snapshot_is_rejected():
    snapshot = ss.wear.run(history(), loop(), LAW, 100).snapshot
    others = {"friction": history(), "settings": history(), "hardness": None, "model": None}
    others["friction"].set_friction(0.2)
    others["settings"].settings = ss.Settings(tolerance=1e-7)
    for name, argument in (("hardness", {"hardness": 5e9}), ("model", {"axis": "y"})):
        others[name] = ss.History(BODIES, ss.surface.sphere(GRID, 3.5e-3), 0.5, tolerance=1e-6, **argument)
    for name, other in others.items():
        before = other.to_bytes()
        with pytest.raises(ss.errors.SnapshotMismatch, match=f"the {name} of the snapshot .* resume.restored") as caught:
            ss.wear.run(other, loop(), LAW, 200, resume=snapshot)
        assert caught.value.argument == name and other.to_bytes() == before
    assert ss.wear.run(history(), loop(), LAW, 200, resume=snapshot).cycles == 200


def test_digest_of_loop_contains_exact_loads():
    worn = history()
    snapshot = ss.wear.run(worn, loop(), LAW, 100).snapshot
    heavier = ss.history.FrettingLoop(
        loop()._path, lambda shift: ss.LoadStep(normal_force=np.nextafter(FORCE, 2.0 * FORCE), shift=shift)
    )
    with pytest.raises(ss.errors.SnapshotMismatch, match="the loop of the snapshot"):
        ss.wear.run(worn, heavier, LAW, 200, resume=snapshot)


def test_axes_of_the_depth_of_a_law_are_recognised_by_name():
    xarray = pytest.importorskip("xarray")

    def turned(history, cycle):
        return xarray.DataArray(LAW(history, cycle), dims=("y", "x")).transpose("x", "y")

    by_name, depth = (ss.wear.run(history(), loop(), law, 100).depth for law in (turned, LAW))
    assert np.array_equal(by_name, depth) and not np.array_equal(depth, depth.T)


def test_depth_of_a_law_on_a_different_grid_is_rejected():
    other = ss.Grid.square(32, 1.0)
    with pytest.raises(ss.errors.GridMismatch):
        ss.wear.run(history(), loop(), lambda history, cycle: ss.Field(other, LAW(history, cycle)), 100)
    same = ss.wear.run(history(), loop(), lambda history, cycle: ss.Field(GRID, LAW(history, cycle)), 100)
    assert np.array_equal(same.depth, ss.wear.run(history(), loop(), LAW, 100).depth)


def test_arguments_of_wrong_type_are_named():
    worn = history()
    before = worn.to_bytes()
    wrong = [
        ("loop", "must be a FrettingLoop, got an object of the class EnergyLaw", (worn, LAW, loop(), 10), {}),
        ("history", "must be a History, got an object of the class FrettingLoop", (loop(), worn, LAW, 10), {}),
        ("law", "got an object of the class float", (worn, loop(), 1e-13, 10), {}),
        ("law", "got the class EnergyLaw: give .* EnergyLaw\\(coefficient\\)", (worn, loop(), ss.wear.EnergyLaw, 10), {}),
        ("cycles", "must be a whole number, got an object of the class str", (worn, loop(), LAW, "10"), {}),
        ("cycles", "must be a whole number, got None", (worn, loop(), LAW, None), {}),
        ("largest_jump", "must be a whole number", (worn, loop(), LAW, 10), {"largest_jump": ""}),
        ("max_depth", "must be a number", (worn, loop(), LAW, 10), {"max_depth": "1e-6"}),
        ("max_depth", "must be a number", (worn, loop(), LAW, 10), {"max_depth": True}),
        ("max_residual", "must be a number", (worn, loop(), LAW, 10), {"max_residual": True}),
        ("max_residual", "must be a number", (worn, loop(), LAW, 10), {"max_residual": None}),
        ("progress", "got an object of the class int", (worn, loop(), LAW, 10), {"progress": 5}),
        ("resume", "must be a WearSnapshot, got an object of the class str", (worn, loop(), LAW, 10), {"resume": "a.npz"}),
    ]
    for name, message, arguments, keywords in wrong:
        with pytest.raises(ss.errors.ArgumentType, match=f"^{name} .*{message}") as caught:
            ss.wear.run(*arguments, **keywords)
        assert caught.value.argument == name
    for value in (5, 1.0, -0.1, float("nan")):
        with pytest.raises(ss.errors.ArgumentRange, match=f"max_residual must be at least 0 and less than 1, got {value}:"):
            ss.wear.run(worn, loop(), LAW, 10, max_residual=value)
    for value in (float("nan"), float("inf")):
        with pytest.raises(ss.errors.ArgumentRange, match="cycles must be a whole number") as caught:
            ss.wear.run(worn, loop(), LAW, value)
        assert caught.value.argument == "cycles"
    assert worn.to_bytes() == before


def test_file_without_a_snapshot_is_named(tmp_path):
    file, whole = tmp_path / "wrong.npz", tmp_path / "whole.npz"
    ss.wear.run(history(), loop(), LAW, 10).snapshot.save(whole)
    content = whole.read_bytes()
    np.savez(tmp_path / "other.npz", a=1.0)
    damaged = bytearray(content)
    damaged[len(content) // 2] ^= 255
    others = [b"", b"text", content[:1000], content[:-30], bytes(damaged), (tmp_path / "other.npz").read_bytes()]
    for bytes_of_file in others:
        file.write_bytes(bytes_of_file)
        with pytest.raises(ss.errors.Format, match="wrong.npz: the file is not a snapshot") as caught:
            ss.wear.WearSnapshot.load(file)
        assert caught.value.file == str(file)
    np.save(tmp_path / "array.npy", np.zeros(3))
    with pytest.raises(ss.errors.Format, match="array.npy"):
        ss.wear.WearSnapshot.load(tmp_path / "array.npy")
    with pytest.raises(FileNotFoundError):
        ss.wear.WearSnapshot.load(tmp_path / "absent.npz")


def test_load_function_without_return_is_rejected():
    def forgotten(shift):
        ss.LoadStep(normal_force=FORCE, shift=shift)

    worn, path = history(), loop()._path
    before = worn.to_bytes()
    without = ss.history.FrettingLoop(path, forgotten)
    message = "load function .*forgotten must return a LoadStep, got None: end it with return LoadStep"
    for call in (
        lambda: without.run(worn, 2),
        lambda: without.cycle(worn, ss.history.Cycle(worn)),
        lambda: ss.wear.run(worn, without, LAW, 100),
    ):
        with pytest.raises(TypeError, match=message):
            call()
    with pytest.raises(TypeError, match="got an object of the class tuple"):
        ss.history.FrettingLoop(path, lambda shift: shift).run(worn, 2)
    assert worn.to_bytes() == before


def test_cycle_rejects_history_on_other_bodies():
    pressed = history()
    cycle = ss.history.Cycle(pressed)
    soft = ss.Material(100e9, 0.29)
    for bodies, error in (
        (ss.HalfSpace(GRID, (soft, soft)), ss.errors.MaterialMismatch),
        (ss.HalfSpace(GRID, (STEEL, STEEL), boundary="periodic"), ss.errors.BoundaryMismatch),
    ):
        other = ss.History(bodies, ss.surface.sphere(GRID, 3.5e-3), 0.5)
        other.step(normal_force=FORCE, warn=False)
        other.step(force_x=20.0, warn=False)
        with pytest.raises(error, match="history of the cycle"):
            cycle.add(other)
    assert cycle.steps == 0
    with pytest.raises(ss.errors.StepOutOfOrder, match="after it is accepted"):
        cycle.add(pressed)


def test_rejected_step_stays_in_cycle_unless_cycle_is_copied():
    pressed = history()
    cycle = ss.history.Cycle(pressed)
    before, kept = pressed.state(), copy.copy(cycle)
    pressed.step(force_x=45.0)
    cycle.add(pressed)
    pressed.set_state(before)
    pressed.step(force_x=20.0)
    with pytest.raises(ss.errors.StepOutOfOrder):
        cycle.add(pressed)
    kept.add(pressed)
    assert np.allclose(kept.points.force[0], [0.0, 20.0], atol=1e-6)


def test_state_replaces_settings_friction_hardness_and_model():
    target = history()
    source = ss.History(
        BODIES, ss.surface.sphere(GRID, 3.5e-3), 0.3, model="vector", hardness=5e9, settings=ss.Settings(tolerance=1e-7)
    )
    target.set_state(source.state())
    assert target.friction == ss.Friction(0.3) and target.settings == source.settings and target.axis is None
    assert target.state().hardness == source.state().hardness is not None


def test_ctrl_c_ends_wear_with_state_after_last_jump(tmp_path):
    code = """
import sys
sys.path.insert(0, {tests!r})
import test_wear_run as t
import stickslip as ss, os
worn = t.history()
def progress(snapshot):
    print("jump", snapshot.cycles, flush=True)
try:
    ss.wear.run(worn, t.loop(steps=400), t.LAW, 10**7, largest_jump=1, progress=progress)
except KeyboardInterrupt as error:
    same = worn.state().to_bytes() == error.snapshot.state.to_bytes()
    print("interrupted", error.snapshot.cycles == error.snapshot.history.jump.sum() > 0, same)
"""
    code = code.format(tests=os.path.dirname(__file__))
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    for _ in range(3):
        assert process.stdout.readline().startswith("jump")
    process.send_signal(signal.SIGINT)
    rest, _ = process.communicate(timeout=TIMEOUT)
    assert rest.splitlines()[-1] == "interrupted True True"


def test_loop_reports_progress_and_stops():
    seen = []
    outcome = loop().run(history(), 4, progress=lambda done, cycle: seen.append((done, cycle.steps)))
    assert seen == [(1, 8), (2, 8), (3, 8), (4, 8)] and outcome.ending == "cycle_limit"
    stopped = loop().run(history(), 4, progress=lambda done, cycle: np.bool_(done < 2))
    assert stopped.cycles == 2 and stopped.ending == "stopped" and stopped.last.steps == 8


def test_progress_bars_count_cycles(capsys):
    loop().run(history(), 3, progress=True)
    assert "3/3" in capsys.readouterr().err
    ss.wear.run(history(), loop(), LAW, 700, progress=True)
    assert "700/700" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("law", "found"),
    [
        (lambda history, cycle: 1e-12, "the number 1e-12"),
        (lambda history, cycle: np.array(1e-12), "the number 1e-12"),
        (lambda history, cycle: None, "None"),
        (lambda history, cycle: np.zeros(32), r"an array of shape \(32,\)"),
    ],
)
def test_law_without_depth_of_each_cell_is_rejected(law, found):
    worn = history()
    before = worn.to_bytes()
    with pytest.raises(ss.errors.Shape, match=rf"wear law must return an array of shape .* = \(32, 32\), got {found}: ") as caught:
        ss.wear.run(worn, loop(), law, 5)
    assert caught.value.expected == GRID.shape and worn.to_bytes() == before


def test_jump_rejects_single_depth():
    worn = history()
    cycle = ss.history.Cycle(worn)
    loop().cycle(worn, cycle)
    with pytest.raises(ss.errors.ArgumentType, match="depth must be a Field or an array .*, got the number 1e-12"):
        ss.wear.CycleJump(BODIES, cycle, 1e-12)


def test_loop_without_contact_does_not_become_steady():
    unpressed = ss.History(BODIES, ss.surface.sphere(GRID, 3.5e-3), 0.5)
    path = ss.history.LoadPath.triangle((1e-6, 0.0), 8)
    free = ss.history.FrettingLoop(path, lambda shift: ss.LoadStep(shift=shift), until_steady=1e-3)
    with pytest.warns(ss.ContactWarning), pytest.raises(ss.EmptyContact, match="no step of cycle 1 is in contact.*normal load"):
        free.run(unpressed, 10)
    # A loop that presses the bodies itself, and lifts them at its end, has contact.
    lifting = ss.history.FrettingLoop(
        path, lambda shift: ss.LoadStep(normal_force=FORCE * (shift[0] != 0.0), shift=shift), until_steady=1e-3
    )
    assert lifting.run(unpressed, 10).ending == ss.history.StopReason.STEADY


def test_snapshots_follow_jumps_unless_jumps_are_limited():
    whole = ss.wear.run(history(), loop(), LAW, 1000, snapshot_every=100)
    assert len(whole.snapshots) < len(whole.history) <= 6
    limited = ss.wear.run(history(), loop(), LAW, 1000, snapshot_every=100, largest_jump=100)
    intervals = [snapshot.cycles // 100 for snapshot in limited.snapshots]
    assert intervals == list(range(1, 11))


def test_missing_normal_load_of_loops_is_warned_of_with_remedy():
    path = ss.history.LoadPath.triangle((1e-6, 0.0), 8)
    held = ss.history.FrettingLoop(path, lambda shift: ss.LoadStep(shift=shift))
    with pytest.warns(ss.ContactWarning, match="no cell carries pressure .*: prescribe a positive normal force, or an approach"):
        held.run(ss.History(BODIES, ss.surface.sphere(GRID, 3.5e-3), 0.5), 1)
    with pytest.warns(ss.ContactWarning, match="kept the pressure, which belongs to the old gap: prescribe the normal load again"):
        ss.wear.run(history(), held, LAW, 100)
    assert "Every step must prescribe the normal load" in " ".join(ss.wear.run.__doc__.split())
