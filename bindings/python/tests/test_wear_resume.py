"""Snapshots and histories that do not belong together, and laws and arguments of ``wear.run`` that are rejected."""

import pickle
import warnings

import numpy as np
import pytest

import stickslip as ss
from stickslip._arrays import EnergiesPerArea

GRID = ss.Grid.square(32, 0.3e-3)
STEEL = ss.Material(213e9, 0.29)
BODIES = ss.HalfSpace(GRID, (STEEL, STEEL))
LAW = ss.wear.EnergyLaw(1e-13)
LOOP = ss.history.FrettingLoop(
    ss.history.LoadPath.triangle((1e-6, 0.0), 8), lambda shift: ss.LoadStep(normal_force=100.0, shift=shift)
)


def pressed(radius=3.5e-3, bodies=BODIES, **options):
    history = ss.History(bodies, ss.surface.sphere(GRID, radius), 0.5, tolerance=1e-6, **options)
    history.step(normal_force=100.0)
    return history


def relative(strain):
    return ss.tangential.RelativeDisplacement.bulk_strain(GRID, [[strain, 0.0], [0.0, 0.0]])


def snapshot_of(**options):
    return ss.wear.run(pressed(**options), LOOP, LAW, 60).snapshot


def refused(history, snapshot, match):
    before = history.to_bytes()
    with pytest.raises(ss.errors.SnapshotMismatch, match=match) as caught:
        ss.wear.run(history, LOOP, LAW, 100, resume=snapshot)
    assert history.to_bytes() == before
    return caught.value.argument


def test_history_with_another_gap_is_rejected():
    snapshot = snapshot_of()
    assert refused(pressed(7e-3), snapshot, r"the gap of the snapshot differs from that of the history by 3\.\d+e-06") == "gap"
    far = pressed()
    far.set_gap(far.gap_as_set + 1e-6)
    assert refused(far, snapshot, "the gap of the snapshot") == "gap"


def test_history_with_the_gap_before_or_after_the_wear_resumes():
    worn = pressed()
    first = ss.wear.run(worn, LOOP, LAW, 60)
    for history in (worn, pressed(), first.snapshot.restored(BODIES)):
        assert ss.wear.run(history, LOOP, LAW, 100, resume=first.snapshot).cycles == 100


def test_history_with_another_entry_rule_permanent_set_or_coupling_is_rejected():
    snapshot = snapshot_of()
    message = "the entry_rule of the snapshot is since_touch, that of the history is whole_step: resume with resume.restored"
    assert refused(pressed(entry_rule="whole_step"), snapshot, message) == "entry_rule"
    of_set = snapshot_of(hardness=2e9, permanent_set=True)
    assert refused(pressed(hardness=2e9), of_set, "the permanent_set of the snapshot is True") == "permanent_set"
    assert refused(pressed(coupling="neglected"), snapshot, "the coupling of the snapshot is full") == "coupling"


def test_history_with_another_relative_displacement_is_rejected():
    step = {"normal_force": 100.0, "relative_displacement": 1.0}
    stretched = pressed(relative_displacement=relative(1e-5))
    stretched.step(**step)
    snapshot = ss.wear.run(stretched, LOOP, LAW, 60).snapshot
    warped = ss.tangential.RelativeDisplacement(ss.Field(GRID, np.ones((32, 1)) * GRID.x**3), ss.Field(GRID, 0.0))
    other = pressed(relative_displacement=warped)
    other.step(**step)
    for history in (pressed(), other):
        assert refused(history, snapshot, "the relative_displacement of the snapshot differs") == "relative_displacement"
    # The amount is part of the state, and only the pattern belongs to the history.
    half = pressed(relative_displacement=relative(1e-5))
    half.step(normal_force=100.0, relative_displacement=0.5)
    for history in (half, pressed(relative_displacement=relative(1e-5))):
        assert ss.wear.run(history, LOOP, LAW, 100, resume=snapshot).cycles == 100


def test_bodies_and_model_are_compared_before_other_properties():
    snapshot = snapshot_of()
    soft = ss.Material(100e9, 0.29)
    other = pressed(7e-3, ss.HalfSpace(GRID, (soft, soft)), model="vector")
    assert refused(other, snapshot, "the pair of the snapshot is .* a history on the bodies of the snapshot") == "pair"
    message = "the model of the snapshot is scalar along x, that of the history is vector"
    assert refused(pressed(7e-3, model="vector"), snapshot, message) == "model"


def test_resumed_run_without_further_cycles_issues_a_warning():
    first = ss.wear.run(pressed(), LOOP, LAW, 60)
    with pytest.warns(ss.errors.ContactWarning, match="already contains 60 cycles, so that no cycle is added: cycles counts from"):
        again = ss.wear.run(pressed(), LOOP, LAW, 60, resume=first.snapshot)
    assert again.cycles == 60 and np.array_equal(again.depth, first.depth)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ss.wear.run(pressed(), LOOP, LAW, 61, resume=first.snapshot)


class WithoutArea:
    def depth_of_jump(self, history, cycle, dissipation, cycles):
        return 1e-13 * cycles * cycle.dissipation


@pytest.mark.parametrize("law", [lambda history, cycle: 1e-13 * cycle.dissipation, WithoutArea()])
def test_law_that_returns_energies_is_rejected(law):
    worn = pressed()
    before = worn.to_bytes()
    with pytest.raises(TypeError, match=r"must return depths, got energies of cells: return wear\.energy\(.*cell_area"):
        ss.wear.run(worn, LOOP, law, 60)
    assert worn.to_bytes() == before


def test_gap_that_contains_energies_is_rejected():
    worn = pressed()
    step = worn.step(shift=(1e-6, 0.0))
    removed = 1e-13 * step.dissipation
    gap = worn.gap_as_set + removed
    in_metres = ss.Field(GRID, worn.gap_as_set, "m")
    for call in (
        lambda: worn.set_gap(gap),
        lambda: ss.History(BODIES, gap, 0.5),
        lambda: ss.NormalProblem(BODIES, gap, force=100.0),
        lambda: ss.Field(GRID, gap, "m"),
        lambda: in_metres + removed,
    ):
        with pytest.raises(TypeError, match=r"energies of cells: convert them to a depth by wear\.energy"):
            call()
    assert ss.Field(GRID, removed) + step.dissipation is not None


def test_energies_divided_by_the_area_of_a_cell_are_no_energies():
    worn = pressed()
    dissipation = worn.step(shift=(1e-6, 0.0)).dissipation
    by_hand = 1e-13 * dissipation / GRID.cell_area
    assert type(by_hand) is type(dissipation / (GRID.dx * GRID.dy)) is EnergiesPerArea
    assert np.allclose(by_hand, ss.wear.energy(1e-13, dissipation), rtol=1e-12, atol=0.0)
    worn.set_gap(worn.gap_as_set + by_hand)
    half = pickle.loads(pickle.dumps(dissipation / 2.0))
    assert np.allclose(ss.wear.energy(2e-13, half), by_hand, rtol=1e-12, atol=0.0)
    law = ss.wear.run(pressed(), LOOP, lambda history, cycle: 1e-13 * cycle.dissipation / GRID.cell_area, 60)
    assert np.allclose(law.depth, ss.wear.run(pressed(), LOOP, LAW, 60).depth, rtol=1e-9, atol=0.0)


def test_archard_takes_the_grid_of_the_earlier_depth():
    worn = pressed()
    step = worn.step(shift=(1e-6, 0.0))
    depth = ss.Field(GRID, 1e-9)
    added = ss.wear.archard(1e-13, worn.pressure, step.slip_distance, depth=depth)
    assert np.allclose(added, 1e-9 + ss.wear.archard(1e-13, worn.pressure, step.slip_distance), rtol=1e-12, atol=0.0)


def test_number_of_cycles_beyond_exact_numbers_is_rejected():
    for cycles in (10**23, 2**53 + 2, 1e300):
        with pytest.raises(ss.errors.ArgumentRange, match=r"cycles must be at most 2\*\*53, got") as caught:
            ss.wear.run(pressed(), LOOP, LAW, cycles)
        assert caught.value.argument == "cycles"
