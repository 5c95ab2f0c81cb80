"""Claim: page and picture files show how a lifted disk lands, and only then offer to play it slowly.

Source: the landing solved by dynamics/landing. Oracle: the motion itself, evaluated at the times that the
page contains.
"""

import numpy as np
import pytest
from page_arrays import decoded
from scenes import whirling

from dynamics import Air, simulate
from sonify.report.page_data import (
    MAX_STORED_LANDING_TIMES,
    encoded_landing,
    encoded_motion,
)


@pytest.fixture(scope="module")
def motion():
    return simulate(whirling(0.01, air=Air(film="acts")))


def test_the_page_contains_the_landing_with_its_first_milliseconds(motion):
    encoded = encoded_motion(motion)
    t = decoded(encoded["t"])
    assert np.all(np.diff(t) > 0)
    begin = motion.rolling.t[-1]
    landing = t[t > begin]
    assert len(landing) == MAX_STORED_LANDING_TIMES
    assert landing[-1] == motion.t[-1]
    assert np.sum(landing < begin + 0.03) >= MAX_STORED_LANDING_TIMES // 2 - 1
    inclination = decoded(encoded["inclination"])
    assert inclination == pytest.approx(motion.inclination(t), rel=1e-6, abs=1e-12)
    assert inclination[-1] < 0.01 * inclination[t <= begin][-1]


def test_the_page_contains_the_gap_that_slow_motion_shows(motion):
    """The lift of the film opens it to micrometres; at the end the disk is down again."""
    landing = encoded_landing(motion)
    t, gap = decoded(landing["t"]), decoded(landing["gap"])
    solved = motion.landing
    begin = motion.rolling.t[-1]
    assert t[-1] == begin + solved.t[-1]
    since = np.minimum(t - begin, solved.t[-1])
    assert gap == pytest.approx(1e6 * solved.clearance(since), rel=1e-6)
    highest = 1e6 * solved.clearance(solved.t).max()
    assert highest * 0.99 < gap.max() <= highest
    assert gap.max() > 1.0


def test_a_motion_without_a_landing_is_encoded_to_its_end():
    rolling = simulate(whirling(0.01, numerics={"time_limit": 0.2}))
    assert rolling.landing is None
    assert decoded(encoded_motion(rolling)["t"])[-1] == rolling.t[-1]
    assert encoded_landing(rolling) is None
