"""Claim: audible beats at a known number per turn are found with their rates, and nothing else is.

Source: sonify/hearing/beats.py; modulation thresholds of Viemeister (1979). Oracle: noise modulated
here with known phases, rates and depths.
"""

import numpy as np
import pytest
from tracks import track

from sonify.hearing.audible_levels import audible_levels
from sonify.hearing.beats import detectable_depth, find_beats, find_bursts

RATE = 48000
SECONDS = 8.0
END = 8.5
"""Time [s] at which the turning rate would diverge."""


def turns(time):
    """Return the turns of a contact whose rate is 10 Hz one second before END, ~ left^-1/2."""
    return 20.0 * (np.sqrt(END) - np.sqrt(END - np.minimum(time, SECONDS)))


def rate(time):
    return 10.0 / np.sqrt(END - time)


def beating(depth, per_turn, phase=turns, level=0.02):
    t = np.arange(int(SECONDS * RATE)) / RATE
    noise = np.random.default_rng(2).standard_normal(len(t))
    envelope = 1 + depth * np.cos(2 * np.pi * per_turn * phase(t))
    return track(level * envelope * noise)


def always(begin, end):
    return True


@pytest.mark.parametrize("per_turn", [1, 2, 3])
def test_beats_have_the_rates_with_which_they_were_made(per_turn):
    found = find_beats(beating(0.6, per_turn), turns, SECONDS, always)
    assert found.per_turn == per_turn
    first, last = (
        per_turn * rate(np.linspace(*span, 50)).mean()
        for span in ((found.begin, found.begin + 0.72), (found.end - 0.1, found.end))
    )
    assert found.first == pytest.approx(first, rel=0.1)
    assert found.last == pytest.approx(last, rel=0.1)
    assert found.factor > 2.5


def test_steady_noise_has_no_beats():
    assert find_beats(beating(0.0, 1), turns, SECONDS, always) is None


def test_a_modulation_too_weak_to_be_heard_does_not_beat():
    """A depth of 3 % is below the threshold of 5.6 %; one of 20 % at the same rate is above."""
    assert find_beats(beating(0.03, 2), turns, SECONDS, always) is None
    assert find_beats(beating(0.2, 2), turns, SECONDS, always) is not None


def test_a_modulation_that_does_not_follow_the_turns_is_not_one_of_the_disk():
    def other(time):
        return turns(time) * 1.37

    assert find_beats(beating(0.6, 1, other), turns, SECONDS, always) is None


def test_a_sound_below_the_threshold_of_hearing_does_not_beat():
    for level, heard in ((0.02, True), (1e-7, False)):
        sound = beating(0.6, 2, level=level)
        levels = audible_levels(sound, SECONDS)
        found = find_beats(sound, turns, SECONDS, levels.audible_between)
        assert (found is not None) == heard


def test_silence_does_not_beat():
    assert find_beats(track(np.zeros(4 * RATE)), turns, 4.0, always) is None


def test_the_threshold_of_modulation_is_that_of_the_literature():
    """About 5 % up to 50 Hz, and 50 % at 500 Hz."""
    assert detectable_depth(5.0) == pytest.approx(0.05, abs=0.01)
    assert detectable_depth(500.0) == pytest.approx(0.5, abs=0.05)


def knocks(rising):
    """Return 3 s of noise bursts of 3 ms in steady noise, with a jitter of a twentieth of a turn, and
    their instants [s]: from 12 Hz at 3 s before their end as left^-1/2, or steadily at 20 Hz."""
    draw = np.random.default_rng(5)
    t = np.arange(3 * RATE) / RATE
    scale = 2 * 12 * np.sqrt(3.0)
    count = np.arange(1, int(scale * np.sqrt(3.0)) - 2)
    at = 3.0 - (np.sqrt(3.0) - count / scale) ** 2 if rising else np.arange(60) / 20.0
    at = at + 0.05 * np.gradient(at) * draw.standard_normal(len(at))
    at = at[(at > 0) & (at < 2.99)]
    sound = 3e-4 * draw.standard_normal(len(t))
    for begin in at:
        inside = (t >= begin) & (t < begin + 0.003)
        sound[inside] += 0.02 * draw.standard_normal(inside.sum())
    return sound, at


def test_bursts_that_do_not_keep_the_phase_of_the_turns_are_searched_as_in_a_recording():
    sound, _ = knocks(rising=True)
    found = find_bursts(track(sound), 3.0)
    first, last = (
        12 * np.sqrt(3.0 / (3.0 - at)) for at in (found.begin + 0.05, found.end)
    )
    assert found.first == pytest.approx(first, rel=0.15)
    assert found.last == pytest.approx(last, rel=0.2)
    assert find_bursts(track(knocks(rising=False)[0]), 3.0) is None
