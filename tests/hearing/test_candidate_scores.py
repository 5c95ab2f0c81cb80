"""Claim: a candidate counts by its margin over all rivals, and the slope of its pulses is that of
their level over the remaining time.

Source: sonify/hearing/settling/candidates.py. Oracle: margins worked out by hand; pulses whose
power is a power of the remaining time.
"""

import numpy as np
import pytest

from sonify.hearing.settling.candidates import (
    Candidate,
    Window,
    peak_level_exponent,
    rising_margin,
    score_of,
    windows_before_end,
)
from sonify.hearing.settling.onset_strength import FRAME_RATE
from sonify.hearing.settling.rate_laws import Law, Shape, distance_to_end
from sonify.hearing.settling.settings import SETTLING

SCORES = {
    "disk": 50.0,
    "flat": 10.0,
    "slowing": -4.0,
    "linear": 45.0,
    "exponential": 30.0,
}


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({}, 25.0),  # 50 - 45 + 20
        ({"linear": 0.0}, 40.0),  # 50 - 10
        ({"linear": 0.0, "flat": -3.0}, 40.0),  # 50 - 30 + 20
        ({"linear": -9.0, "exponential": -9.0, "flat": -3.0}, 50.0),  # rivals below 0
        ({"slowing": 60.0}, -10.0),
    ],
)
def test_the_score_is_the_smaller_margin(changes, expected):
    assert score_of(SCORES | changes) == expected


def test_the_margin_over_rising_rates_is_over_the_better_one():
    assert rising_margin(SCORES) == 5.0
    assert rising_margin(SCORES | {"exponential": 49.0}) == 1.0


def test_windows_stop_at_the_end_and_begin_in_the_sound():
    end = round(1.0 * FRAME_RATE)
    windows = windows_before_end(end, 12.0)
    fitting = [length for length in SETTLING.window_lengths if length <= 1.0]
    assert [window.seconds for window in windows] == pytest.approx(fitting, abs=1e-3)
    assert {window.stop for window in windows} == {end}
    assert all(window.shows_end for window in windows)
    assert min(window.first for window in windows) >= 0


def test_windows_overlap_up_to_their_ends_and_a_margin():
    early, late = Window(0, 90, 100, None), Window(150, 200, 200, 9.0)
    for one, other in ((early, late), (late, early)):
        assert not one.overlaps(other)
        assert not one.overlaps(other, 50)
        assert one.overlaps(other, 51)
    assert early.overlaps(Window(95, 120, 120, None))


LAW = Law(Shape("disk", 6.0, 0.4), turns=40.0, harmonics=3, likelihood=0.0)
WINDOW = Window(0, 2 * FRAME_RATE, 2 * FRAME_RATE, 20.0)


def remaining():
    """Return the time until the rate diverges [s] in the middle of each frame."""
    left = WINDOW.seconds * (1 + distance_to_end(6.0, 0.4))
    return left - (np.arange(WINDOW.stop) + 0.5) / FRAME_RATE


@pytest.mark.parametrize("slope", [0.0, 0.5, 1.3])
def test_the_slope_of_pulses_is_that_of_their_amplitude(slope):
    power = 1e-3 * remaining() ** (2 * slope)
    assert peak_level_exponent(power, LAW, WINDOW, 0.0) == pytest.approx(
        slope, abs=0.05
    )


def test_pulses_below_the_noise_have_no_slope():
    power = 1e-3 * remaining()
    assert peak_level_exponent(power, LAW, WINDOW, 1.0) == 0.0


def test_a_candidate_ends_where_its_rate_diverges():
    candidate = Candidate(WINDOW, 0, LAW, SCORES, 0.0)
    left = candidate.end_of_law / FRAME_RATE - WINDOW.seconds
    # the rate grows as the remaining time to -0.4, by the factor 6 within the window
    assert ((left + WINDOW.seconds) / left) ** 0.4 == pytest.approx(6.0, rel=1e-2)
