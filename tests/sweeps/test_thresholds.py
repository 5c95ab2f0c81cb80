"""Claim: a verdict names the quantity that decides it and the value at which the answer changes,
with an interval that contains the true value in 95 % of all samples, and none where there is none.

Source: sonify/sweeps/thresholds.py. Oracle: draws made here with a known threshold; a bootstrap.
"""

import numpy as np
import pytest
from scipy.special import expit

from sonify.sweeps.axes import points_of
from sonify.sweeps.thresholds import (
    MIN_DRAWS,
    claim_verdict,
    groups_of,
    logistic_fit,
    positions,
)

RANGES = {
    "roughness.rms_edge": {"from": 1e-8, "to": 1e-7, "scale": "log"},
    "release.inclination_deg": {"from": 20.0, "to": 40.0},
    "surface.edge": ["free", "supported", "clamped"],
    "surface.sag": [0.0005, 0.001, 0.002],
    "roughness.seed": list(range(64)),
}


def axes():
    from sonify.sweeps.axes import Samples

    return list(points_of(RANGES, Samples(method="latin", n=1)).axes)


def draws(seed, n=128):
    """Return the positions (n, 5) in the ranges, the values by axis, and the generator."""
    random = np.random.default_rng(seed)
    place = random.random((n, len(RANGES)))
    columns = {
        axis.keys[0]: np.array([axis.at(share)[0] for share in place[:, k]])
        for k, axis in enumerate(axes())
    }
    return columns, random


def place_of(key, columns):
    (axis,) = (axis for axis in axes() if axis.keys[0] == key)
    return positions(axis, columns[key])


def logistic_answers(seed, middle, slope, n=128):
    columns, random = draws(seed, n)
    x = place_of("roughness.rms_edge", columns)
    return columns, x, random.random(n) < expit(slope * (x - middle))


@pytest.mark.slow
@pytest.mark.parametrize("slope", [8.0, -20.0])
def test_the_interval_contains_the_true_threshold_in_95_percent_of_all_samples(slope):
    """Of 100 samples, 95 +- 2.2; four standard deviations are allowed below."""
    inside = 0
    for seed in range(100):
        _, x, yes = logistic_answers(seed, 0.4, slope)
        fit = logistic_fit(x, yes)
        low = -np.inf if fit.low is None else fit.low
        high = np.inf if fit.high is None else fit.high
        inside += low < 0.4 < high
        assert fit.rises == (slope > 0)
    assert inside >= 86


@pytest.mark.slow
def test_the_interval_is_that_of_a_bootstrap():
    _, x, yes = logistic_answers(3, 0.4, 8.0, n=256)
    fit = logistic_fit(x, yes)
    random = np.random.default_rng(1)
    again = []
    for _ in range(100):
        some = random.integers(0, len(x), len(x))
        again.append(logistic_fit(x[some], yes[some]).middle)
    low, high = np.percentile(again, [2.5, 97.5])
    width = fit.high - fit.low
    assert fit.low == pytest.approx(low, abs=0.3 * width)
    assert fit.high == pytest.approx(high, abs=0.3 * width)


@pytest.mark.slow
def test_a_deterministic_threshold_is_between_the_draws_on_both_sides():
    inside = 0
    for seed in range(50):
        columns, _ = draws(seed)
        x = place_of("roughness.rms_edge", columns)
        fit = logistic_fit(x, x > 0.37)
        gap = x[x < 0.37].max(), x[x > 0.37].min()
        assert gap[0] < fit.middle < gap[1]
        assert fit.high - fit.low < 0.12
        inside += fit.low < 0.37 < fit.high
    assert inside >= 44


def test_the_deciding_axis_and_its_threshold_are_found_among_others():
    columns, _, yes = logistic_answers(6, 0.4, 25.0)
    found = claim_verdict(axes(), columns, yes)
    assert found.answer == "threshold"
    assert found.dependence.axis.keys == ("roughness.rms_edge",)
    assert found.threshold.rises
    assert found.threshold.low < 10**-7.6 < found.threshold.high
    assert [group.share.draws for group in found.dependence.groups] == [
        int(np.sum(np.floor(5 * place_of("roughness.rms_edge", columns)) == k))
        for k in range(5)
    ]
    assert found.dependence.groups[0].words == "1e-08 to 1.58e-08"


def test_a_claim_that_fails_above_a_value_has_a_falling_threshold():
    columns, _, yes = logistic_answers(5, 0.4, 25.0)
    found = claim_verdict(axes(), columns, ~yes)
    assert (found.answer, found.threshold.rises) == ("threshold", False)


def test_no_axis_decides_random_answers():
    """At most one sample in twenty has a significant axis: of 100, 5 +- 2.2."""
    alarms = 0
    for seed in range(100):
        columns, random = draws(seed)
        found = claim_verdict(axes(), columns, random.random(128) < 0.6)
        alarms += found.answer != "undecided"
    assert alarms <= 13


@pytest.mark.parametrize(("holds", "answer"), [(True, "yes"), (False, "no")])
def test_equal_answers_have_no_threshold(holds, answer):
    columns, _ = draws(1)
    found = claim_verdict(axes(), columns, np.full(128, holds))
    assert (found.answer, found.dependence, found.threshold) == (answer, None, None)
    assert found.share.minority == 0


def test_few_draws_decide_nothing():
    columns, _ = draws(1, n=MIN_DRAWS - 1)
    yes = place_of("roughness.rms_edge", columns) > 0.5
    assert claim_verdict(axes(), columns, yes).answer == "undecided"
    assert claim_verdict(axes(), columns, np.full(len(yes), True)).answer == "undecided"


def test_few_draws_with_another_answer_decide_nothing():
    """7 of 64 draws are too few to name what decides, and too many to be exceptions."""
    columns, _ = draws(1, n=64)
    x = place_of("roughness.rms_edge", columns)
    found = claim_verdict(axes(), columns, x >= np.sort(x)[-7])
    assert (found.answer, found.dependence, found.share.holds) == ("undecided", None, 7)


def test_rare_exceptions_do_not_change_an_answer():
    columns, _ = draws(1, n=512)
    found = claim_verdict(axes(), columns, np.arange(512) < 5)
    assert (found.answer, found.share.holds) == ("no", 5)


@pytest.mark.parametrize("key", ["surface.sag", "surface.edge"])
def test_listed_values_have_answers_but_no_threshold(key):
    columns, random = draws(2)
    last = max(columns[key])
    yes = (columns[key] == last) ^ (random.random(128) < 0.05)
    found = claim_verdict(axes(), columns, yes)
    assert (found.answer, found.threshold) == ("threshold", None)
    assert found.dependence.axis.keys == (key,)
    assert found.dependence.groups[-1].share.low > 0.5
    assert found.dependence.groups[0].share.high < 0.5


def test_a_dependence_without_a_change_of_the_answer_has_no_threshold():
    columns, random = draws(4, n=512)
    x = place_of("release.inclination_deg", columns)
    found = claim_verdict(axes(), columns, random.random(512) < 0.1 + 0.3 * x)
    assert (found.answer, found.threshold) == ("depends", None)
    assert found.dependence.axis.keys == ("release.inclination_deg",)


def test_many_listed_values_are_divided_into_fifths():
    (axis,) = (axis for axis in axes() if axis.keys == ("roughness.seed",))
    index, words = groups_of(axis, np.arange(64.0))
    assert words == ["0 to 12", "13 to 25", "26 to 38", "39 to 51", "52 to 63"]
    assert list(np.bincount(index)) == [13, 13, 13, 13, 12]
