"""Claim: the random search ends at the law that made the events, and is no worse than its start.

Source: sonify/hearing/settling/refinement.py. Oracle: events made by a known law of a disk.
"""

import numpy as np
import pytest

from sonify.hearing.settling.rate_laws import Law, Shape
from sonify.hearing.settling.refinement import laws_near, ratio_range, refine
from sonify.hearing.settling.settings import SETTLING

LENGTH = 3000  # frames of 1 ms
TRUE = Shape("disk", 2.5, 0.4)
TURNS = 60.0


def events():
    """Return one component (1, frames) that peaks once per turn of the true law, with noise."""
    x = (np.arange(LENGTH) + 0.5) / LENGTH
    phase = 2 * np.pi * TURNS * TRUE.phase(x)
    noise = 0.3 * np.random.default_rng(2).standard_normal(LENGTH)
    return (np.exp(2 * np.cos(phase)) / 2 + noise)[None]


def test_the_search_ends_at_the_true_law():
    start = Law(Shape("disk", 2.3, 0.4), TURNS + 0.5, 1, 0.0)
    found = refine(events(), 4.0, [start], 1.3)
    x = np.linspace(0, 1, 200)
    deviation = found.turns * found.shape.phase(x) - TURNS * TRUE.phase(x)
    assert np.std(deviation) < 0.05  # turns
    assert found.turns == pytest.approx(TURNS, abs=0.2)


def test_the_true_law_is_the_most_likely_of_those_near_it():
    left = LENGTH / (TRUE.ratio ** (1 / TRUE.exponent) - 1)
    tried, exponents, first_rates, likelihood = laws_near(
        events(), 4.0, (left, TRUE.exponent, TURNS), (0.3 * left, 3 * left)
    )
    best = likelihood.argmax()
    assert likelihood[best] - likelihood[0] < 20
    assert tried[best] == pytest.approx(left, rel=0.5)
    assert exponents[best] == pytest.approx(TRUE.exponent, abs=0.15)
    assert first_rates[0] == pytest.approx(TURNS / LENGTH * TRUE.first_rate, rel=1e-3)


def test_rates_of_each_family_stay_in_its_range():
    steady = SETTLING.max_steady_ratio
    assert ratio_range(TRUE, 1.3) == (1.3, SETTLING.rate_ratios[1])
    assert ratio_range(Shape("linear", 1.0), 1.3) == (1 / steady, steady)
    assert ratio_range(Shape("exponential", 3.0), 1.3)[0] == steady
