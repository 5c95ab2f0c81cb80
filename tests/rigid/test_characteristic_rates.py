"""Claim: the rates of a motion are those of its nutation, its precession and its slips.

Source: footnote 3, figures 4 (b) and 6 of the paper. Oracle: the zeros of omega_1, the normal force
of a rigid contact, the linear theory of steady motion, Fourier spectra of the inclination as a
function of the precession angle, counts of turns and slips.
"""

import exact_motion as exact
import numpy as np
import pytest
from scenes import conservative, roll, scene, whirling

from dynamics import plan_motion
from dynamics.observables import (
    _is_sustained,
    lossless_rolling_load,
    nutation_end_time,
    nutation_frequency,
    nutations_per_turn,
    piece_ends_and_middles,
    plotted_rates,
    precession_frequency,
    slip_start_times,
)
from modal.tabletop.solve import surface_modes
from sonify.claims.details import unit_and_details
from sonify.claims.rigid_motion import load_frequency_rises
from sonify.plan.preflight import solve_motion
from sonify.report.page_data import encoded_rates
from sonify.scene import load_scene


@pytest.fixture(scope="module")
def motion():
    return roll(scene())


def test_peaks_of_the_load_are_not_doubled_by_the_corners_of_the_nutation_moment(
    motion,
):
    """Between slips the disk nutates twice through omega_1 = 0 for each peak of the load."""
    t, frequency = nutation_frequency(motion)
    turns = np.array(
        [s.t for s in motion.transitions if s.guard == "nutation reverses"]
    )
    for start, stop in ((2.2, 3.2), (6.5, 7.0), (11.0, 11.5)):
        reversals = turns[(turns > start) & (turns < stop)]
        by_zeros = (len(reversals) - 1) / 2 / (reversals[-1] - reversals[0])
        assert np.mean(frequency[(t > start) & (t < stop)]) == pytest.approx(
            by_zeros, rel=0.02
        )


def test_nutation_over_precession_is_near_0_8(motion):
    t, _ = nutation_frequency(motion)
    late = (t > 2.0) & (t < 17.0)
    assert np.median(nutations_per_turn(motion)[late]) == pytest.approx(0.8, abs=0.04)


def test_the_nutation_of_the_published_disk_tends_to_that_of_linear_theory(motion):
    """The flat limit holds for small nutations without slips; the published motion meets both
    conditions within 3 %."""
    t, _ = nutation_frequency(motion)
    flat = exact.flat_limit(motion.disk.aspect, motion.disk.gyration)[1]
    assert flat == pytest.approx(0.791865, abs=1e-6)
    late = nutations_per_turn(motion)[(t > 17.5) & (t < 19.3)]
    assert np.median(late) == pytest.approx(flat, rel=0.03)


@pytest.mark.parametrize("inclination", [0.02, 0.1, 0.4])
def test_small_nutations_have_the_frequency_of_linear_theory(inclination):
    """A disk released 1 % steeper than its steady motion nutates about it."""
    steady = whirling(inclination)
    release = {
        "inclination_deg": float(np.degrees(1.01 * inclination)),
        "omega": steady.release.omega,
    }
    motion = roll(conservative(release=release, numerics={"time_limit": 0.5}))
    disk = motion.disk
    square = exact.steady_nutation_squared(
        np.pi / 2 - inclination,
        steady.release.omega[2] * disk.time_unit,
        disk.aspect,
        disk.gyration,
    )
    expected = np.sqrt(square) / disk.time_unit / (2 * np.pi)
    assert np.median(nutation_frequency(motion)[1]) == pytest.approx(expected, rel=0.01)


def test_of_a_disk_that_rolls_freely_the_load_is_the_normal_force():
    """Without moments and slips the acceleration of (5.3) is that of the disk; terms in omega_1
    squared are neglected."""
    motion = roll(conservative(numerics={"time_limit": 1.0}))
    t = np.linspace(0, 1.0, 2001)
    state = motion.at(t)
    turning = np.abs(state[:, 5]) < 0.02
    load = motion.force(t)[:, 2] / motion.disk.weight
    assert turning.sum() > 5
    assert lossless_rolling_load(motion.disk, state[turning]) == pytest.approx(
        load[turning], abs=1e-3
    )


def jumps(frequency):
    """Return the relative changes between neighbouring finite values."""
    both = np.isfinite(frequency[1:]) & np.isfinite(frequency[:-1])
    return np.abs(np.diff(np.log(frequency)))[both]


def test_where_the_contact_hops_the_nutation_is_drawn_while_there_is_one():
    """The nutation arm of this coin damps the nutation within half a second; the coin then hops,
    and its normal force is noise."""
    coin = load_scene("coin-polished").replace(
        "friction.arm_nutation=1e-4", "numerics.time_limit=3"
    )
    motion = solve_motion(plan_motion(coin))
    assert len(motion.contact_losses) > 100
    time, precession, nutation = plotted_rates(motion)
    drawn = np.isfinite(nutation)
    end = nutation_end_time(motion)
    assert 0.5 < end < 2.9
    assert time[drawn][-1] <= end
    assert np.count_nonzero(np.diff(drawn.astype(int)) == 1) <= 1, (
        "one line without gaps"
    )
    assert jumps(nutation).max() < 0.03
    assert np.isfinite(precession).all()
    share = nutation[drawn] / precession[drawn]
    assert (np.abs(share - np.median(share)) < 0.1).all()
    assert f"the disk nutates until {end:.4g} s" in unit_and_details(
        load_frequency_rises(motion)
    )
    assert (
        encoded_rates(motion)["nutation"]["base64"]
        != encoded_rates(motion)["precession"]["base64"]
    )


def test_a_few_peaks_that_come_by_chance_are_no_nutation():
    """A nutation of 60 periods dies; after a gap come 4 noise readings, then a nutation of 20
    periods."""
    time = np.concatenate([np.arange(60), [90, 91, 92, 93], 120 + np.arange(20)]) / 10
    expected = np.concatenate([np.ones(60, bool), np.zeros(4, bool), np.ones(20, bool)])
    assert np.array_equal(_is_sustained(time, np.full(84, 10.0)), expected)
    assert _is_sustained(time[:3], np.full(3, 10.0)).all(), (
        "a short motion has no longer stretch"
    )
    assert not len(_is_sustained(time[:0], time[:0]))


@pytest.mark.slow
def test_where_the_table_drives_the_disk_the_nutation_is_drawn_while_it_is_the_stronger():
    """A plate with position-dependent stiffness drives the disk once per turn."""
    plate = load_scene("glass-plate").replace("contact.law=rigid")
    motion = solve_motion(plan_motion(plate, surface_modes(plate)))
    time, _, nutation = plotted_rates(motion)
    end = nutation_end_time(motion)
    assert 18.0 < end < motion.t[-1] - 0.2
    assert jumps(nutation).max() < 0.05
    t = np.linspace(16.0, motion.t[-1], 200_000)
    turned = np.abs(motion.at(t)[:, 0]) / (2 * np.pi)
    for at in (16.7, 17.2, 17.6, 18.0):
        middle = np.interp(at, t, turned)
        even = np.interp(middle + np.arange(-10, 10, 1 / 32), turned, t)
        seen = np.log(motion.at(even)[:, 1])
        seen -= np.polyval(np.polyfit(even, seen, 2), even)
        share = np.fft.rfftfreq(16 * len(seen), 1 / 32)
        power = np.abs(np.fft.rfft(seen * np.hanning(len(seen)), 16 * len(seen)))
        band = (share > 0.5) & (share < 0.95)
        strongest = share[band][power[band].argmax()]
        turning = np.ptp(np.interp(even[[0, -1]], t, turned)) / np.ptp(even)
        assert np.interp(at, time, nutation) == pytest.approx(
            strongest * turning, rel=0.04
        )


def test_ratio_of_small_nutations_at_small_inclination():
    steady = whirling(0.01, numerics={"time_limit": 1.0})
    flat = roll(steady)
    _, ratio = exact.flat_limit(flat.disk.aspect, flat.disk.gyration)
    in_plane = steady.release.omega[2] * flat.disk.time_unit
    square = exact.steady_nutation_squared(
        np.pi / 2 - 0.01, in_plane, flat.disk.aspect, flat.disk.gyration
    )
    precession = np.diff(flat.at([0.0, 1.0])[:, 0])[0] * flat.disk.time_unit
    assert np.sqrt(square) / abs(precession) == pytest.approx(ratio, abs=2e-3)


def test_the_mean_precession_counts_turns(motion):
    t, frequency = precession_frequency(motion)
    here = (t > 5) & (t < 15)
    counted = np.ptp(motion.at([5.0, 15.0])[:, 0]) / (2 * np.pi)
    assert np.trapezoid(frequency[here], t[here]) == pytest.approx(counted, rel=0.03)


def test_slips_come_a_hundred_times_as_often_towards_the_end(motion):
    gaps = np.diff(slip_start_times(motion))
    assert len(gaps) > 100
    assert np.median(gaps[:20]) > 100 * np.median(gaps[-20:])


def test_what_many_ask_of_the_same_times_is_told_from_memory_and_stays_the_motions_own(
    motion,
):
    """Repeated evaluations at the same times come from a cache that callers cannot modify.

    Oracle: evaluation at a writable copy of the times, which bypasses the cache.
    """
    t = piece_ends_and_middles(motion)
    for ask in (motion.force, motion.energy):
        told = ask(t)
        assert np.array_equal(told, ask(t.copy()))
        told[:] = 0.0
        assert np.array_equal(ask(t), ask(t.copy()))
    assert np.array_equal(t[::2], motion.t)
    with pytest.raises(ValueError, match="read-only"):
        t[0] = 1.0
