"""Claim: the rates of a motion are those of its nutation, its precession and its slips.

Source: footnote 3, figures 4 (b) and 6 of the paper.
Oracle: the zeros of omega_1, the linear theory of steady motion, counts of turns and slips.
"""

import numpy as np
import pytest
from scenes import scene, whirling

from dynamics import simulate, theory
from dynamics.rates import halves, nutation_frequency, precession_frequency, slips


@pytest.fixture(scope="module")
def motion():
    return simulate(scene())


def test_peaks_of_the_load_are_not_doubled_by_the_corners_of_the_nutation_moment(motion):
    """Between its slips the disk nutates twice through omega_1 = 0 for each peak of the load."""
    t, frequency = nutation_frequency(motion)
    turns = np.array([s.t for s in motion.transitions if s.guard == "nutation reverses"])
    for start, stop in ((2.2, 3.2), (6.5, 7.0), (11.0, 11.5)):
        reversals = turns[(turns > start) & (turns < stop)]
        by_zeros = (len(reversals) - 1) / 2 / (reversals[-1] - reversals[0])
        assert np.mean(frequency[(t > start) & (t < stop)]) == pytest.approx(by_zeros, rel=0.02)


def test_f_hat_reaches_2_5_at_tau_214_6(motion):
    t, frequency = nutation_frequency(motion)
    chi = motion.disk.time_unit
    reached = t[np.argmax(frequency * chi >= 2.5)] / chi
    assert reached == pytest.approx(214.6, abs=2.0)


def test_nutation_over_precession_is_near_0_8(motion):
    t, nutation = nutation_frequency(motion)
    ratio = nutation / precession_frequency(motion)[1]
    late = (t > 2.0) & (t < 17.0)
    assert np.median(ratio[late]) == pytest.approx(0.8, abs=0.04)


def test_ratio_of_small_nutations_at_small_inclination():
    steady = whirling(0.01, numerics={"time_limit": 1.0})
    flat = simulate(steady)
    _, ratio = theory.flat_limit(flat.disk.aspect, flat.disk.gyration)
    in_plane = steady.release.omega[2] * flat.disk.time_unit
    square = theory.steady_nutation_squared(np.pi / 2 - 0.01, in_plane, flat.disk.aspect, flat.disk.gyration)
    precession = np.diff(flat.at([0.0, 1.0])[:, 0])[0] * flat.disk.time_unit
    assert np.sqrt(square) / abs(precession) == pytest.approx(ratio, abs=2e-3)


def test_the_mean_precession_counts_turns(motion):
    t, frequency = precession_frequency(motion)
    here = (t > 5) & (t < 15)
    counted = np.ptp(motion.at([5.0, 15.0])[:, 0]) / (2 * np.pi)
    assert np.trapezoid(frequency[here], t[here]) == pytest.approx(counted, rel=0.03)


def test_slips_come_a_hundred_times_as_often_towards_the_end(motion):
    gaps = np.diff(slips(motion))
    assert len(gaps) > 100
    assert np.median(gaps[:20]) > 100 * np.median(gaps[-20:])


def test_what_many_ask_of_the_same_times_is_told_from_memory_and_stays_the_motions_own(motion):
    """Oracle: times of the same values that someone may change, which are evaluated anew."""
    t = halves(motion)
    for ask in (motion.force, motion.energy):
        told = ask(t)
        assert np.array_equal(told, ask(t.copy()))
        told[:] = 0.0
        assert np.array_equal(ask(t), ask(t.copy()))
    assert np.array_equal(t[::2], motion.t)
    with pytest.raises(ValueError, match="read-only"):
        t[0] = 1.0
