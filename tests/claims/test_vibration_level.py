"""Claim: the level of the vibrations in the last second is that of the rendered sound, and
decides by loudness and audibility together.

Source: sonify/claims/vibration_level.py. Oracles: the rendered sound of the whole run; tones of
known level; the threshold of hearing of ISO 226 at 1 kHz.
"""

import numpy as np
import pytest
from scipy.signal import sosfilt

from sonify import load_scene, solve
from sonify.claims.sound import weighted_power
from sonify.claims.vibration_level import (
    LEVEL_ERROR,
    FinalStems,
    final_stems,
    level_above_threshold,
    vibrations_make_sound,
    while_contact_bears,
)
from sonify.hearing.loudness import ISO_226_THRESHOLD_DB, level_db
from sonify.sound.playback import a_weighting
from sonify.sweeps.run_row import sounding_modes

RATE = 48_000


def tone(level):
    """Return 1.5 s of a tone of 1 kHz with a level [dB re 20 uPa]."""
    amplitude = np.sqrt(2) * 20e-6 * 10 ** (level / 20)
    return amplitude * np.sin(2 * np.pi * 1e3 * np.arange(1.5 * RATE) / RATE)


def judged(**levels):
    """Return the finding on stems of known levels [dB]."""
    stems = {name: tone(level) for name, level in levels.items()}
    return vibrations_make_sound(FinalStems(stems, RATE, RATE))


@pytest.mark.parametrize(
    ("levels", "louder", "verdict"),
    [
        ({"heave": 40.0, "tilt": -40.0, "table": 46.0}, 6.0, "yes"),
        ({"heave": 40.0, "tilt": -40.0, "table": 36.0}, -4.0, "no"),
        ({"heave": -40.0, "tilt": -80.0, "contact": -10.0}, 30.0, "no"),
        ({"heave": 40.0, "tilt": -40.0, "table": 40.2}, 0.2, "undecided"),
        ({"vibration": 40.0, "ringing_smooth": 43.0}, 3.0, "yes"),
    ],
)
def test_vibrations_make_the_sound_if_they_are_louder_and_audible(
    levels, louder, verdict
):
    found = judged(**levels)
    assert found.details["louder"] == pytest.approx(louder, abs=0.1)
    assert found.verdict == verdict
    assert found.value == min(found.details.values())


def test_a_tone_at_the_threshold_of_hearing_is_just_audible():
    level = ISO_226_THRESHOLD_DB[1000]
    assert level_above_threshold(tone(level), RATE) == pytest.approx(0, abs=0.5)
    assert level_above_threshold(tone(level + 20), RATE) == pytest.approx(20, abs=0.5)
    assert level_above_threshold(0 * tone(level), RATE) < -100


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "sets"),
    [
        ("published", ("air.film=acts",)),
        ("granite", ()),
        ("coin", ()),
    ],
)
def test_the_last_second_has_the_level_of_the_rendered_sound(name, sets):
    """Between the two are the absorption of the air and the start of filters and modes."""
    result = solve(load_scene(name).replace("numerics.accuracy=draft", *sets))
    sounding = sounding_modes(result.scene, result.motion.plan)
    stems = final_stems(result.scene, result.motion, sounding)
    weighted = sosfilt(a_weighting(stems.rate), sum(stems.stems.values()))[
        -stems.last :
    ]
    rendered = weighted_power(result.sound, [result.sound.pressure])
    assert level_db(np.mean(weighted**2)) == pytest.approx(
        float(level_db(rendered)), abs=LEVEL_ERROR
    )
    judged = vibrations_make_sound(stems)
    in_run = result.findings["vibrations_make_sound"]
    assert judged.details == pytest.approx(in_run.details, abs=1.0)


def test_the_sound_ends_where_the_air_carries_the_whole_disk():
    """On glass, the filter of a rough contact has no stiffness for the last 2 ms."""
    rows = np.ones((RATE, 2))
    assert while_contact_bears(rows, RATE) is rows
    rows[-100:, 1] = np.nan
    assert while_contact_bears(rows, RATE).shape == (RATE - 100, 2)
    rows[2 * RATE // 5, 0] = np.inf
    with pytest.raises(ArithmeticError, match=r"undefined 0.6 s before the end"):
        while_contact_bears(rows, RATE)
