"""Claim: the sampled contact force is the solved one, with its jumps at their exact times, and ends
without a blow.

Source: `Motion.force` and `Motion.jumps`. Oracle: the motion evaluated between the samples; the
weight.
"""

from types import SimpleNamespace

import numpy as np
import pytest
from arithmetic import gamma

from dynamics import simulate
from dynamics.observables import precession_rate
from sonify.sound.fades import raised_cosine
from sonify.sound.force import LOW_PASS_HALF_WIDTH, ForceSampler, final_contact_rate

RATE = 48000


@pytest.fixture(scope="module")
def cut_off(scene):
    return simulate(scene.replace("numerics.time_limit=1.0"))


def between(force, t):
    """The force at t (k,) inside a block, composed from samples, bends and jumps as in the
    oscillators."""
    knots = np.sort(np.concatenate([force.t, force.jump_time]))
    n = np.searchsorted(force.t, force.jump_time, side="left") - 1
    at_jump = np.empty_like(force.bend)
    for j, time in enumerate(force.jump_time):
        previous = (
            force.jump_time[j - 1]
            if j and force.jump_time[j - 1] > force.t[n[j]]
            else force.t[n[j]]
        )
        value = at_jump[j - 1] if previous > force.t[n[j]] else force.smooth[n[j]]
        part = (time - previous) / (force.t[n[j] + 1] - previous)
        at_jump[j] = value + part * (force.smooth[n[j] + 1] - value) + force.bend[j]
    values = np.vstack([force.smooth, at_jump])[
        np.argsort(np.concatenate([force.t, force.jump_time]), kind="stable")
    ]
    smooth = np.column_stack(
        [np.interp(t, knots, values[:, i]) for i in range(values.shape[1])]
    )
    levels = np.vstack(
        [force.steps[:1], force.steps[0] + np.cumsum(force.jump, axis=0)]
    )
    return smooth + levels[np.searchsorted(force.jump_time, t, side="right")]


def test_samples_are_the_solved_force(motion):
    force = ForceSampler(motion, RATE).block(1000, 200000)
    assert np.abs(force.samples - motion.force(force.t)).max() < 1e-11


def test_jumps_are_those_of_the_motion(motion):
    sampler = ForceSampler(motion, RATE)
    force = sampler.block(0, int(18 * RATE))
    inside = motion.jumps.t <= force.t[-1]
    assert np.array_equal(force.jump_time, motion.jumps.t[inside])
    assert np.array_equal(
        force.jump, (motion.jumps.after - motion.jumps.before)[inside]
    )


def test_the_smooth_part_is_continuous(motion):
    sampler = ForceSampler(motion, RATE)
    at = motion.jumps.t[(motion.jumps.t > 0.01) & (motion.jumps.t < 18)]
    apart = (
        sampler._continuous_part(at + 1e-9)[1] - sampler._continuous_part(at - 1e-9)[1]
    )
    assert (
        np.abs(apart).max()
        < 1e-5 * motion.disk.weight
        < 0.01 * np.abs(motion.jumps.after - motion.jumps.before).max()
    )


def test_between_samples_the_error_falls_as_the_square_of_the_step_through_all_jumps(
    motion,
):
    errors = []
    rates = np.array([4000, 8000, 16000, 32000])
    t = np.sort(
        np.concatenate(
            [
                np.random.default_rng(0).uniform(2.0, 9.0, 20000),
                motion.jumps.t[2:40] + 1e-7,
            ]
        )
    )
    t = t[(t > 2.0) & (t < 9.0)]
    for rate in rates:
        sampler = ForceSampler(motion, rate)
        force = sampler.block(int(1.9 * rate), int(7.2 * rate))
        errors.append(np.abs(between(force, t) - motion.force(t)).max())
    slope = -np.polyfit(np.log2(rates), np.log2(errors), 1)[0]
    assert slope == pytest.approx(2.0, abs=0.1)


def test_blocks_of_any_size_give_the_same_samples(motion):
    sampler = ForceSampler(motion, RATE)
    first = int(19.2 * RATE)
    whole = sampler.block(first, 12000)
    parts = [sampler.block(first + start, 1500) for start in range(0, 12000, 1500)]
    assert np.allclose(
        np.vstack([part.smooth[:-1] for part in parts]),
        whole.smooth[:-1],
        rtol=0,
        atol=1e-9,
    )
    assert np.array_equal(
        np.concatenate([part.jump_time for part in parts]), whole.jump_time
    )
    assert np.allclose(
        np.vstack([part.bend for part in parts]), whole.bend, rtol=0, atol=1e-9
    )


def test_a_settled_disk_rests_on_its_weight_and_gets_there_without_a_blow(
    motion, scene
):
    sampler = ForceSampler(motion, RATE, rest=[np.nan, np.nan, scene.disk.weight])
    last = int(motion.t[-1] * RATE)
    force = sampler.block(last - 50, 500)
    after = force.t > motion.t[-1] + (LOW_PASS_HALF_WIDTH + 1) / RATE
    size = (
        np.abs(motion.jumps.after - motion.jumps.before).sum(axis=0).max()
    )  # the steps accumulate and are subtracted
    assert force.samples[after, 2] == pytest.approx(
        scene.disk.weight, rel=0, abs=gamma(2 * len(motion.jumps.t)) * size
    )
    assert np.ptp(force.samples[after], axis=0).max() <= gamma(20) * size
    swing = np.ptp(motion.force(np.linspace(19.0, 19.3, 20000))[:, 2])
    assert np.abs(np.diff(force.samples[:, 2])).max() < swing
    assert np.abs(ForceSampler(motion, RATE).rest[2] / scene.disk.weight - 1) < 1e-2


def test_what_turns_faster_than_the_samples_leaves_no_alias(motion):
    """At a sample rate of 8 kHz, a load that turns with the contact is kept up to 4 kHz and
    suppressed above."""

    def turning(force, attitude, film):
        return np.stack([np.cos(attitude[:, 0]), np.sin(attitude[:, 0])], axis=1)

    load = ForceSampler(motion, 8000, channels=turning).block(
        int(18.5 * 8000), int(0.9 * 8000)
    )
    state = motion.at(np.minimum(load.t, motion.t[-1]))
    rate = np.abs(state[:, 7] / np.sin(state[:, 1])) / (2 * np.pi)
    size = np.hypot(*load.samples.T)
    assert np.abs(size[rate < 2500] - 1).max() < 0.02
    assert size[rate > 6000].max() < 0.1


def test_a_motion_that_is_cut_off_keeps_its_last_force(cut_off):
    force = ForceSampler(cut_off, RATE).block(int(1.0 * RATE) - 10, 100)
    expected = cut_off.force([cut_off.t[-1]])[0]
    size = np.abs(cut_off.jumps.after - cut_off.jumps.before).sum(axis=0) + np.abs(
        expected
    )
    assert (
        np.abs(force.samples[-50:] - expected)
        <= gamma(2 * len(cut_off.jumps.t) + 20) * size
    ).all()


def test_before_the_motion_the_force_is_its_first(motion):
    force = ForceSampler(motion, RATE, start=-0.01).block(0, 100)
    assert np.abs(force.samples - motion.force([0.0])[0]).max() < 1e-11


def test_a_disk_that_stands_still_at_its_last_instant_is_not_silent(motion):
    """On waves the disk may stand still at its last instant.

    The end is then as short as for a disk that turns at half the steady rate, 2/(chi sqrt(beta)); a
    rigid motion ends with its own rate.
    """
    assert final_contact_rate(motion) == abs(
        precession_rate(motion.at(motion.t[-1:]))[0]
    )
    state = np.zeros((1, 11))
    state[0, 1] = 1e-5
    still = SimpleNamespace(
        t=np.array([0.0, 1.0]), at=lambda t: state, disk=motion.disk
    )
    assert final_contact_rate(still) == pytest.approx(
        1 / (motion.disk.time_unit * 1e-5**0.5), rel=1e-9
    )


def test_channels_may_turn_with_the_attitude(motion):
    def turning(force, attitude, film):
        angle = attitude[:, 0]
        return np.stack(
            [force[:, 2] * np.cos(angle), force[:, 2] * np.sin(angle)], axis=1
        )

    force = ForceSampler(motion, RATE, channels=turning).block(0, 4 * RATE)
    expected = turning(motion.force(force.t), motion.at(force.t)[:, :3], None)
    assert np.abs(force.samples - expected).max() < 1e-11


def test_every_fade_is_the_same_raised_cosine():
    """Oracle: (1 - cos(pi x))/2, and the constant values outside."""
    share = np.linspace(-0.5, 1.5, 41)
    inside = (1 - np.cos(np.pi * np.clip(share, 0, 1))) / 2
    assert raised_cosine(share) == pytest.approx(inside, abs=1e-15)
