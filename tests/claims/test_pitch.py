"""Claim: what a listener hears rising is the tone, the beats or the noise band, whichever rises most
beyond its own least rise; each can come out yes, no and undecided.

Source: sonify/claims/pitch.py. Oracle: parts and noise bands with given frequencies; noise with a
band that is made here.
"""

import numpy as np
import pytest
from scipy.signal import butter, sosfilt

from sonify.claims.pitch import RisingPart, carrier_rises, pitch_rises
from sonify.claims.surface_summary import complete_answers
from sonify.hearing.noise_band import NoiseBand, noise_band_to_end
from sonify.sound.pressure import Track

RATE = 48000


def part(name, factor, margin=0.01, per_turn=0):
    least = 1.2 if name == "band" else 2.0
    return RisingPart(name, 100.0, 100.0 * factor, margin, least, per_turn)


@pytest.mark.parametrize(
    ("factors", "cause", "verdict"),
    [
        ({"tone": 6.0, "band": 1.1}, "tone", "yes"),
        ({"beats": 5.0, "band": 1.02}, "beats", "yes"),
        ({"beats": 1.3, "band": 1.5}, "band", "yes"),
        ({"tone": 1.3, "beats": 1.1, "band": 1.1}, "band", "no"),
        ({"tone": 1.99}, "tone", "undecided"),
        ({"tone": 0.4, "band": 0.7}, "tone", "no"),
    ],
)
def test_the_part_that_rises_most_beyond_its_least_rise_decides(
    factors, cause, verdict
):
    found = pitch_rises([part(name, factor) for name, factor in factors.items()])
    assert (found.cause, found.verdict) == (cause, verdict)
    assert found.value == pytest.approx(factors[cause])
    assert found.at_least == (1.2 if cause == "band" else 2.0)
    for name, factor in factors.items():
        assert found.details[f"{name}_to"] == pytest.approx(100 * factor)
        assert found.details[f"{name}_at_least"] > 1


def test_a_certain_rise_decides_before_an_uncertain_one():
    found = pitch_rises([part("tone", 3.0, margin=0.9), part("band", 1.3)])
    assert (found.cause, found.verdict) == ("band", "yes")


def test_the_answer_names_the_part_its_course_and_its_least_rise():
    found = pitch_rises(
        [
            RisingPart("band", 3200.0, 3210.0, 0.01, 1.2),
            RisingPart("beats", 22.5, 112.2, 0.01, 2.0, 2),
        ]
    )
    assert complete_answers([found])["does the pitch rise"] == (
        "yes: the beats, 2 per turn, rise from 22 to 112 per second (4.99-fold, limit 2); the "
        "noise band stays at 3210 Hz (1.00-fold, limit 1.2)"
    )


def test_a_sound_in_which_nothing_is_audible_says_so():
    silent = pitch_rises([], audible=False)
    assert silent.verdict == "no"
    assert complete_answers([silent])["does the pitch rise"] == "no: nothing is audible"
    unknown = pitch_rises([])
    assert unknown.verdict == "undecided"
    assert complete_answers([unknown])["does the pitch rise"] == (
        "undecided: no audible tone, beats or noise band stands out"
    )


def test_a_band_that_rises_at_the_very_end_rises():
    """The median of the last tenth of a long sound misses it: 11 s of 109 s."""
    t = np.arange(200.0)
    late = np.where(t > 190, 1.5, 1.0)
    assert carrier_rises(NoiseBand(t, 1700 * late)).verdict == "yes"
    for last in (0.9, 1.0):
        steady = NoiseBand(t, 1700 * last ** (t / 200))
        assert carrier_rises(steady).verdict == "no"


def test_the_band_is_followed_up_to_the_end():
    """A band that rises 1.5-fold in the last second of ten."""
    t = np.arange(10 * RATE) / RATE
    draw = np.random.default_rng(1)
    sound = 1e-3 * draw.standard_normal(len(t))
    for begin, end, middle in ((0, 9, 1700.0), (9, 9.5, 2000.0), (9.5, 10, 2600.0)):
        sos = butter(
            2, [0.95 * middle, 1.05 * middle], "bandpass", fs=RATE, output="sos"
        )
        inside = (t >= begin) & (t < end)
        sound[inside] += sosfilt(sos, draw.standard_normal(inside.sum()))
    source = Track(sample_rate=RATE, columns=sound[:, None], column=0)
    found = noise_band_to_end(source, 0.0, 10.0, 0.5)
    assert found.time[-1] > 9.9
    assert found.frequency[-3:] == pytest.approx(2600.0, rel=0.03)
    assert carrier_rises(found).value == pytest.approx(2600 / 1700, rel=0.05)


@pytest.mark.parametrize("duration", [0.3, 0.05, 0.001])
def test_a_sound_shorter_than_its_intervals_has_as_many_as_its_windows_allow(duration):
    """The intervals at the end are shorter than the hop of the windows; warnings are errors."""
    noise = np.random.default_rng(3).normal(size=RATE)
    source = Track(sample_rate=RATE, columns=noise[:, None], column=0)
    found = noise_band_to_end(source, 0.1, 0.1 + duration, 0.5)
    assert np.all(np.diff(found.time) > 0)
    assert len(found.time) == len(found.frequency)
