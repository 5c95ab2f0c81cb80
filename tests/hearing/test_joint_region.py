"""Claim: the region of a law is its interval of two standard errors, with the rate one second before
the end, and shifts with its recording.

Source: sonify/hearing/settling/joint_region.py. Oracle: the power law of the rate, evaluated.
"""

import numpy as np
import pytest

from sonify.hearing.settling.joint_region import Estimate, region_of_law
from sonify.hearing.settling.settings import SETTLING

END, EXPONENT, RATE = 5.0, 0.4, 12.0
LAW = np.array([END, EXPONENT, np.log2(RATE)])
ERRORS = np.array([0.01, 0.02, 0.03])


def rate(t):
    return RATE * (END - t) ** -EXPONENT


def test_a_long_run_states_the_rate_one_second_before_its_end():
    region = region_of_law(LAW, ERRORS, start=1.0)
    exponent, end, height = region.limits()
    assert region.reference_time == 1.0
    assert height.value == pytest.approx(rate(END - 1))
    assert (exponent.value, end.value) == (EXPONENT, END)
    assert end.half_width == pytest.approx(2 * 0.01 + 0.002)
    assert exponent.half_width == pytest.approx(2 * 0.02 + 0.001)
    assert np.log2(height.high / height.value) == pytest.approx(
        2 * 0.03 + np.log2(1.002), abs=0.06
    )


def test_a_short_run_states_the_rate_at_its_start():
    region = region_of_law(LAW, ERRORS, start=4.4)
    assert region.reference_time == pytest.approx(0.6)
    assert region.best_rate == pytest.approx(rate(4.4))


def test_a_missing_end_has_limits_and_no_value():
    region = region_of_law(LAW, ERRORS, start=1.0, stop=4.5)
    _, end, height = region.estimates()
    assert end.value is None
    assert end.low == 4.5
    assert end.high > END
    assert height.value == pytest.approx(rate(3.5))


def test_a_later_region_is_shifted():
    region = region_of_law(LAW, ERRORS, start=1.0, stop=4.5).later(10.0)
    assert (region.best_end, region.start, region.missing_from) == (15.0, 11.0, 14.5)
    assert Estimate(None, 1.0, 2.0).later(3.0) == Estimate(None, 4.0, 5.0)


def test_an_exponent_with_a_wide_interval_is_not_determined():
    wide = np.array([0.01, SETTLING.max_exponent_interval, 0.03])
    exponent = region_of_law(LAW, wide, start=1.0).estimates()[0]
    assert exponent.value is None
    assert exponent.low < EXPONENT < exponent.high
