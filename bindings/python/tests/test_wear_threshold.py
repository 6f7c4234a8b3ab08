"""Wear laws of ``wear.run`` that depend on the energy dissipated before: the threshold law and laws of the user."""

import warnings

import numpy as np
import pytest

import stickslip as ss
from test_wear_run import BODIES, COEFFICIENT, GRID, LAW, five_percent, history, loop

# Energy per area that the cells with the largest dissipation reach within a few hundred cycles (J/m2).
THRESHOLD = 1e5
THRESHOLD_LAW = ss.wear.ThresholdEnergyLaw(COEFFICIENT, THRESHOLD)
# A law with so little wear that the gap, and with it the cycle, does not change.
UNCHANGED = 1e-30
ONE_CYCLE = {"settling": 1, "max_residual": 0.99}


def closed_cycle():
    """Returns the second cycle of a history, which equals the following cycles."""
    pressed = history()
    cycle = ss.history.Cycle(pressed)
    for _ in range(2):
        loop().cycle(pressed, cycle)
    return pressed, cycle


def test_threshold_law_agrees_with_loop_without_jumps():
    by_hand, cycles = history(), 12
    cycle, energy, depth = ss.history.Cycle(by_hand), np.zeros(GRID.shape), np.zeros(GRID.shape)
    law = ss.wear.ThresholdEnergyLaw(1e-12, 1e3)
    for _ in range(cycles):
        loop().cycle(by_hand, cycle)
        energy = energy + cycle.dissipation
        of_cycle = ss.wear.threshold_energy(1e-12, 1e3, energy, cycle.dissipation, grid=GRID)
        depth = depth + of_cycle
        by_hand.set_gap(by_hand.gap_as_set + of_cycle)
    worn = history()
    result = ss.wear.run(worn, loop(), law, cycles, largest_jump=1, **ONE_CYCLE)
    assert list(result.history.jump) == [1] * cycles + [0] and 0.0 < depth.max()
    assert np.array_equal(result.depth, depth) and np.array_equal(result.dissipation, energy)
    assert np.array_equal(worn.gap_as_set, by_hand.gap_as_set)


def test_threshold_law_with_jumps_agrees_with_short_jumps():
    coarse = ss.wear.run(history(), loop(), THRESHOLD_LAW, 2000)
    fine = ss.wear.run(history(), loop(), THRESHOLD_LAW, 2000, largest_jump=100)
    assert len(coarse.history) < len(fine.history)
    assert coarse.depth.max() == pytest.approx(fine.depth.max(), rel=0.05)
    assert coarse.history.worn_volume[-1] == pytest.approx(fine.history.worn_volume[-1], rel=0.05)
    # The depth follows from the energy of each cell.
    for result in (coarse, fine):
        beyond = np.maximum(0.0, result.dissipation / GRID.cell_area - THRESHOLD)
        assert np.allclose(result.depth, COEFFICIENT * beyond, rtol=0, atol=1e-12 * result.depth.max())
        assert result.dissipation.sum() == pytest.approx(result.history.dissipated_energy[-1], rel=1e-12)
        assert (result.depth == 0.0).any() and (result.dissipation[result.depth == 0.0] > 0.0).any()


def test_threshold_reached_within_jump_wears_remaining_cycles():
    _, cycle = closed_cycle()
    density = cycle.dissipation.max() / GRID.cell_area
    law = ss.wear.ThresholdEnergyLaw(UNCHANGED, 250.5 * density)
    result = ss.wear.run(history(), loop(), law, 1000)
    found = result.history
    crossed = np.searchsorted(found.cycles, 250.5) - 1
    assert found.cycles[crossed] < 250 and found.jump[crossed] > 400
    # Of 1000 cycles, 749.5 are beyond the threshold in the cell with the largest dissipation.
    assert result.depth.max() == pytest.approx(UNCHANGED * 749.5 * density, rel=1e-4)
    # The proportional law would give the depth of whole cycles only.
    assert np.count_nonzero(result.depth) < np.count_nonzero(result.dissipation)


def test_jump_is_limited_by_cells_that_wear_at_its_end():
    pressed, cycle = closed_cycle()
    energy, pressure = np.asarray(cycle.dissipation), np.asarray(cycle.slip_pressure)
    slips = pressure > 0.0
    rate = COEFFICIENT * energy / GRID.cell_area
    compliance = 0.5 * ss.wear.max_stable_cycles(BODIES, 1.0, np.ones(GRID.shape))
    proportional = int(compliance / (rate[slips] / pressure[slips]).max())
    # The threshold of the cell with the largest dissipation lies beyond the limit of the proportional law.
    threshold = 1.2 * proportional * energy.max() / GRID.cell_area
    law = ss.wear.ThresholdEnergyLaw(COEFFICIENT, threshold)
    first = ss.wear.run(pressed, loop(), law, 10**6, progress=lambda snapshot: False)
    jump = first.cycles
    assert jump > proportional and first.depth.max() >= 0.0

    def load(cycles):
        worn = slips & (cycles * energy > threshold * GRID.cell_area)
        return cycles * (rate[worn] / pressure[worn]).max(initial=0.0)

    # The last cell may reach the threshold within one cycle.
    assert load(jump) <= compliance * (1.0 + 1e-6) and load(jump + 2) > compliance


def test_law_without_threshold_equals_energy_law():
    one = ss.wear.run(history(), loop(), LAW, 1500, largest_depth=five_percent)
    other = ss.wear.run(history(), loop(), ss.wear.ThresholdEnergyLaw(COEFFICIENT, 0.0), 1500, largest_depth=five_percent)
    assert abs(len(one.history) - len(other.history)) <= 1
    assert np.allclose(one.depth, other.depth, rtol=0, atol=1e-3 * one.depth.max())


def test_limits_apply_to_threshold_law():
    # A cycle removes about 0.2 nm at most.
    result = ss.wear.run(history(), loop(), THRESHOLD_LAW, 10**6, max_depth=2e-8, largest_depth=3e-9)
    found = result.history
    assert result.ending == ss.wear.WearEnding.DEPTH and result.cycles < 10**6
    of_cycle = LAW(history(), result.last).max()
    assert 2e-8 <= found.max_depth[-1] < 2e-8 + 2.0 * of_cycle
    assert (np.diff(found.max_depth) <= 3e-9 * (1.0 + 1e-12)).all()
    short = ss.wear.run(history(), loop(), THRESHOLD_LAW, 100, largest_jump=30)
    assert list(short.history.jump) == [30, 30, 30, 10, 0]
    worn = history()
    with pytest.raises(ss.errors.NoWholeCycle, match="a cycle removes more than the limit.*unit of the coefficient") as caught:
        ss.wear.run(worn, loop(), ss.wear.ThresholdEnergyLaw(1e-9, 0.0), 10)
    assert 0.0 < caught.value.cycles < 1.0 and caught.value.snapshot.cycles == 0
    with pytest.raises(ss.errors.NoWholeCycle):
        ss.wear.run(worn, loop(), ss.wear.ThresholdEnergyLaw(COEFFICIENT, 0.0), 10, largest_depth=1e-16)
    with pytest.raises(ss.errors.CycleNotClosed):
        ss.wear.run(history(), loop(), THRESHOLD_LAW, 10, settling=1, max_residual=1e-12)
    with pytest.raises(ss.errors.NegativeOrNotFinite):
        ss.wear.run(worn, loop(), ss.wear.ThresholdEnergyLaw(COEFFICIENT, -1.0), 10)
    with pytest.raises(ss.errors.NegativeOrNotFinite, match="largest depth"):
        ss.wear.run(worn, loop(), THRESHOLD_LAW, 10, largest_depth=-1e-9)
    stick = ss.wear.run(history(), loop(1e-10), THRESHOLD_LAW, 10**9)
    assert list(stick.history.cycles) == [0, 10**9] and stick.last.regime == "full_stick" and not stick.depth.any()


def test_threshold_law_resumes_with_identical_results(tmp_path):
    whole = ss.wear.run(history(), loop(), THRESHOLD_LAW, 3000, largest_depth=five_percent)
    seen = []

    def stop(snapshot):
        seen.append(snapshot.cycles)
        return len(seen) < 2

    first = ss.wear.run(history(), loop(), THRESHOLD_LAW, 3000, largest_depth=five_percent, progress=stop)
    first.snapshot.save(tmp_path / "snapshot.npz")
    for snapshot in (first.snapshot, ss.wear.WearSnapshot.load(tmp_path / "snapshot.npz")):
        restored = snapshot.restored(BODIES)
        rest = ss.wear.run(restored, loop(), THRESHOLD_LAW, 3000, largest_depth=five_percent, resume=snapshot)
        assert np.array_equal(rest.depth, whole.depth) and np.array_equal(rest.dissipation, whole.dissipation)
        assert rest.snapshot.state.to_bytes() == whole.snapshot.state.to_bytes()
        for name, column in whole.history.to_dict().items():
            assert np.array_equal(column, rest.history.to_dict()[name]), name
    words = f"ThresholdEnergyLaw(coefficient=1e-13, threshold={THRESHOLD!r})"
    assert snapshot.law == words
    others = [LAW, ss.wear.ThresholdEnergyLaw(COEFFICIENT, 2e5), ss.wear.ThresholdEnergyLaw(2e-13, THRESHOLD)]
    for law in others:
        with pytest.raises(ss.errors.SnapshotMismatch, match=r"the law of the snapshot is ThresholdEnergyLaw\("):
            ss.wear.run(snapshot.restored(BODIES), loop(), law, 4000, resume=snapshot)


class RunningIn:
    """Wear law of a user whose coefficient is ten times larger after a threshold."""

    def __init__(self):
        self.seen = []

    def depth_of_jump(self, history, cycle, dissipation, cycles):
        self.seen.append(dissipation)
        after = dissipation + cycles * cycle.dissipation
        return self.total(after) - self.total(dissipation)

    @staticmethod
    def total(energy):
        density = energy / GRID.cell_area
        return 1e-14 * density + 9e-14 * np.maximum(0.0, density - THRESHOLD)


def test_law_of_user_receives_energy_of_cycles_jumped_over():
    law = RunningIn()
    result = ss.wear.run(history(), loop(), law, 2000)
    assert np.allclose(result.depth, law.total(result.dissipation), rtol=0, atol=1e-12 * result.depth.max())
    assert not law.seen[0].any() and law.seen[-1].sum() > 100.0 * result.last.energy.dissipated_energy
    # The history contains the computed cycles only.
    assert result.snapshot.state.accumulated_dissipation.sum() < 0.2 * result.dissipation.sum()
    assert result.snapshot.law == f"{__name__}.RunningIn" and isinstance(law, ss.wear.JumpLaw)
    with pytest.raises(ss.errors.ArgumentType, match="^law .*got the class RunningIn"):
        ss.wear.run(history(), loop(), RunningIn, 10)


class Forgetful:
    """Threshold law of a user that ignores the energy dissipated before."""

    def depth_of_jump(self, history, cycle, dissipation, cycles):
        return RunningIn.total(cycles * cycle.dissipation)


@pytest.mark.parametrize(("law", "is_forgetful"), [(Forgetful(), True), (RunningIn(), False), (THRESHOLD_LAW, False)])
def test_law_that_ignores_earlier_energy_gives_warning(law, is_forgetful):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        ss.wear.run(history(), loop(), law, 2000)
    remedy = "take the earlier energy from the argument dissipation of depth_of_jump"
    assert any(str(caught_warning.message).endswith(remedy) for caught_warning in caught) == is_forgetful


def test_depth_that_decreases_with_cycles_is_rejected():
    class Healing:
        def depth_of_jump(self, history, cycle, dissipation, cycles):
            return np.asarray(cycle.dissipation) / cycles

    worn = history()
    before = worn.to_bytes()
    with pytest.raises(ValueError, match="the depth of the wear law decreases with the number of cycles"):
        ss.wear.run(worn, loop(), Healing(), 10)
    assert worn.to_bytes() == before


def test_second_run_states_the_step_from_which_it_counts():
    worn = history()
    first = ss.wear.run(worn, loop(), LAW, 100)
    second = ss.wear.run(worn, loop(), LAW, 50)
    assert second.cycles == 50 and second.snapshot.first_step == first.snapshot.state.steps > 1
    assert "counted from step 1)" in repr(first) and f"counted from step {second.snapshot.first_step})" in repr(second.snapshot)
    resumed = ss.wear.run(worn, loop(), LAW, 80, resume=second.snapshot)
    assert resumed.cycles == 80 and resumed.snapshot.first_step == second.snapshot.first_step
    # The gap contains the wear of both runs.
    assert np.allclose(worn.gap_as_set, ss.surface.sphere(GRID, 3.5e-3) + first.depth + resumed.depth, rtol=0, atol=1e-18)


def test_energies_in_the_wrong_order_are_rejected(scene):
    step, total = ss.Field(scene.grid, 1.0), ss.Field(scene.grid, 3.0)
    assert np.all(ss.wear.threshold_energy(1e-13, 0.0, total, step) > 0.0)
    with pytest.raises(ss.errors.BelowMinimum, match="sum of the accumulated energy must be at least"):
        ss.wear.threshold_energy(1e-13, 0.0, step, total)
