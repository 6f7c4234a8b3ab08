"""Warnings of ``wear.run``: negligible wear, and limits of the depth in another unit."""

import warnings

import numpy as np
import pytest

import stickslip as ss
from test_wear_run import COEFFICIENT, GRID, LAW, five_percent, history, loop

SHORT_RUN = 30


def issued(law=LAW, cycles=SHORT_RUN, amplitude=1e-6, **limits):
    """Returns the warnings of a run, as pairs of kind and sentence, and its result."""
    worn = history()
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = ss.wear.run(worn, loop(amplitude), law, cycles, **limits)
    return [(warning.message.kind, str(warning.message)) for warning in caught], result


def largest_energy():
    """Returns the largest energy per area of a short run."""
    return issued()[1].dissipation.max() / GRID.cell_area


@pytest.mark.parametrize("law", [ss.wear.EnergyLaw(1e-25), ss.wear.EnergyLaw(3e-21), lambda history, cycle: np.zeros(GRID.shape)])
def test_negligible_wear_gives_warning(law):
    [(kind, sentence)], result = issued(law)
    assert kind == "negligible_wear" and result.depth.max() <= 1e-10 * result.history.approach[-1]
    assert sentence.startswith(f"the largest worn depth after 30 cycles is {result.depth.max():.3g} at a displacement of ")
    assert sentence.endswith("check the unit of the coefficient of wear, and of a threshold")
    # Bodies that stick dissipate nothing.
    assert "negligible_wear" not in dict(issued(law, amplitude=1e-12)[0])


@pytest.mark.parametrize("law", [
    LAW,
    ss.wear.EnergyLaw(0.0),
    ss.wear.EnergyLaw(np.zeros(GRID.shape)),
    ss.wear.ArchardLaw(0.0),
    ss.wear.ThresholdEnergyLaw(0.0, 1e15),
])
def test_intended_depth_of_law_gives_no_warning(law):
    assert issued(law)[0] == []


def test_single_cycle_is_counted_in_the_singular():
    [(_, sentence)], _ = issued(ss.wear.EnergyLaw(1e-25), cycles=1)
    assert sentence.startswith("the largest worn depth after 1 cycle is ")


def test_energy_far_below_threshold_gives_warning_with_ratio():
    energy = largest_energy()
    for ratio in (0.5, 0.011):
        assert issued(ss.wear.ThresholdEnergyLaw(COEFFICIENT, energy / ratio))[0] == []
    [(kind, sentence)], result = issued(ss.wear.ThresholdEnergyLaw(COEFFICIENT, energy / 0.0052))
    assert kind == "negligible_wear" and not result.depth.any()
    assert "which is 0.0052 of the threshold: check the unit of the threshold" in sentence
    # The coefficient is checked below and just above the threshold too.
    for ratio in (0.5, 1.000001):
        [(_, sentence)], _ = issued(ss.wear.ThresholdEnergyLaw(1e-25, energy / ratio))
        assert "unit of the coefficient of wear" in sentence
    assert issued(ss.wear.ThresholdEnergyLaw(COEFFICIENT, energy / 1.000001))[0] == []


@pytest.mark.parametrize("name", ["largest_depth", "max_depth"])
def test_limit_far_beyond_approach_gives_warning(name):
    approach = history().approach
    [(kind, sentence)], _ = issued(**{name: 0.5})
    assert kind == f"ineffective_{name}"
    start = f"{name} is 0.5 at a displacement of "
    assert sentence.startswith(start) and sentence.endswith(", so that it hardly limits the wear: check its unit, or omit it")
    displacement = float(sentence.removeprefix(start).split(",")[0])
    assert 0.99 * approach < displacement <= approach
    for limit in (990.0 * approach, float("inf") if name == "max_depth" else None):
        assert issued(**{name: limit})[0] == []


def test_both_limits_far_beyond_approach_give_one_warning_each():
    assert [kind for kind, _ in issued(largest_depth=0.5, max_depth=20)[0]] == ["ineffective_largest_depth", "ineffective_max_depth"]
    assert issued(largest_depth=five_percent)[0] == []


def test_integer_beyond_the_largest_float_is_rejected():
    with pytest.raises(ss.errors.ArgumentRange, match="max_depth must fit in a float, got a larger integer") as caught:
        issued(max_depth=10**400)
    assert caught.value.argument == "max_depth"


def test_warning_as_exception_contains_snapshot():
    worn = history()
    before = worn.to_bytes()
    with warnings.catch_warnings():
        warnings.simplefilter("error", ss.ContactWarning)
        with pytest.raises(ss.ContactWarning, match="max_depth is 1 at") as caught:
            ss.wear.run(worn, loop(), LAW, 10, max_depth=1.0)
    assert caught.value.kind == "ineffective_max_depth" and caught.value.snapshot.cycles == 0 and worn.to_bytes() == before
