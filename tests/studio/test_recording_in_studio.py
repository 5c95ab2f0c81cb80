"""Claim: the studio says of a recording when the disk stopped, what slowed it and how certain this
is, offers each run in it, and plays its end as loud as a run.

Source: the studio's how-to in docs/how_to.md. Oracle: made records of `sonify listen` and fits; the
loudness of the decoded sound by BS.1770.
"""

import json
from types import SimpleNamespace

import numpy as np
import pytest
import soundfile
from page_arrays import decoded_track, with_gain

from sonify.fitting.least_squares import Value
from sonify.hearing.audio_source import Recording
from sonify.hearing.loudness import loudness_lufs
from sonify.hearing.settling.joint_region import Estimate
from sonify.studio.recording_summary import (
    AIR_EXPONENTS,
    ROLLING_EXPONENT,
    VERDICTS,
    cause_sentence,
    certainty_sentence,
    runs_in_file,
    summary_of_fit,
    summary_of_runs,
    write_recording,
)
from sonify.studio.worker import span_fault

EXPONENT = {"value": 0.31, "low": 0.292, "high": 0.331}


def heard_run(score, start, end, low, high):
    """Return a run as in heard.json."""
    return {
        "exponent": EXPONENT,
        "score": score,
        "start": start,
        "t_end": {"value": end, "low": low, "high": high},
        "false_alarm": 2e-5,
        "certain": score > 20,
    }


def test_one_run_has_three_sentences(tmp_path):
    record = {"runs": [heard_run(30, 2.0, 18.69, 18.5, 18.8)]}
    (tmp_path / "heard.json").write_text(json.dumps(record))
    stopped, slowed, certainty = summary_of_runs(runs_in_file(tmp_path))
    assert stopped == "It stopped at 18.69 s (18.50 to 18.80 s)."
    assert slowed.startswith("Rolling friction together with the air explains")
    assert "n = 0.31 (0.29 to 0.33)" in slowed
    assert certainty.startswith("The detection of the disk is certain: ")
    assert "2e-05 such events" in certainty
    assert "less than once in a million times" in certainty_sentence(True, 2e-20)


@pytest.mark.parametrize(
    ("low", "high", "causes"),
    [
        (0.15, 0.20, "The air, perhaps with some rolling friction, explains"),
        (0.20, 0.30, "The air, perhaps with some rolling friction, explains"),
        (0.25, 0.32, "Rolling friction together with the air explains"),
        (0.30, 0.36, "Rolling friction, perhaps with some help of the air, explains"),
        (0.20, 0.36, "The recording does not show"),
        (0.30, 0.50, "The recording does not show"),
        (0.15, 1.00, "The recording does not show"),
        (0.42, 0.53, "Impacts explain"),
        (0.90, 1.00, "Neither friction, air nor impacts explain"),
    ],
)
def test_the_exponent_names_the_causes_that_it_does_not_exclude(low, high, causes):
    """The exponents of the causes are those of docs/theory.md, n = 1 / (b + 2)."""
    assert pytest.approx((1 / (4 + 2), 1 / (2.5 + 2))) == AIR_EXPONENTS
    assert pytest.approx(1 / (1 + 2)) == ROLLING_EXPONENT
    assert cause_sentence((low + high) / 2, low, high).startswith(causes)


def test_an_undetermined_exponent_has_a_plain_sentence():
    sentence = cause_sentence(None, 0.15, 1.0)
    assert sentence.startswith("The recording does not show what slowed it, because")


def test_several_runs_are_offered_the_most_certain_first(tmp_path):
    """A run whose end is missing ends where it was last heard."""
    runs = [heard_run(5, 1.0, None, 9.5, 12.0), heard_run(30, 11.0, 20.2, 20.1, 20.3)]
    (tmp_path / "heard.json").write_text(json.dumps({"runs": runs}))
    found = runs_in_file(tmp_path)
    assert [(run["start"], run["end"]) for run in found] == [(11.0, 20.2), (1.0, 9.5)]
    assert summary_of_runs(found) == ["The file contains 2 runs; choose one."]
    assert summary_of_runs([]) == ["No disk or coin that comes to rest was detected."]


def judged_run(verdict, explained=True):
    """Return a fit of a run to the scene granite."""
    end = Value(value=3.456, low=3.44, high=3.47, inner=(3.45, 3.46))
    return SimpleNamespace(
        verdict=verdict,
        explained=explained,
        decay=SimpleNamespace(scene=SimpleNamespace(name="granite")),
        fit=SimpleNamespace(parameter=lambda number: end),
        run=SimpleNamespace(
            certain=False,
            false_alarm=0.01,
            exponent=Estimate(**EXPONENT),
            t_end=Estimate(value=3.5, low=3.4, high=3.6),
        ),
    )


@pytest.mark.parametrize("verdict", VERDICTS)
def test_a_verdict_that_names_a_cause_is_the_second_sentence(verdict):
    stopped, slowed, certainty = summary_of_fit(judged_run(verdict))
    assert stopped == "It stopped at 3.46 s (3.44 to 3.47 s)."
    assert slowed == VERDICTS[verdict]
    assert "probable" in certainty


@pytest.mark.parametrize(
    ("verdict", "explained", "neglected", "needed"),
    [
        ("cannot tell", True, (), "a longer or less noisy recording is needed"),
        ("cannot tell", False, (), "a radius and a thickness like those of your disk"),
        ("not this scene", True, (), "no motion of the disk of the scene granite"),
        ("cannot tell", True, ["the table is wavy: no"], "a smooth, rigid table"),
    ],
)
def test_a_fit_without_a_cause_states_what_is_needed(
    verdict, explained, neglected, needed
):
    """The exponent, which does not depend on the scene, names the cause; so does the detector
    the end, if no motion explains the rates."""
    judged = judged_run(verdict, explained)
    stopped, slowed, _ = summary_of_fit(judged, neglected)
    assert stopped == (
        "It stopped at 3.46 s (3.44 to 3.47 s)."
        if explained
        else "It stopped at 3.50 s (3.40 to 3.60 s)."
    )
    assert slowed.startswith("Rolling friction together with the air explains")
    assert needed in slowed


@pytest.mark.parametrize(
    ("span", "fault"),
    [
        ((0.0, np.inf), ""),
        ((2.0, 2.5), ""),
        ((3.0, np.inf), "from = 3: must be less than the duration of the sound, 3 s"),
        ((2.0, 1.0), "to = 1: must be greater than from = 2"),
    ],
)
def test_a_span_without_sound_is_one_line(span, fault):
    assert span_fault(span, 3.0) == fault


def test_the_player_gets_the_end_of_a_recording_at_the_loudness_of_a_run(tmp_path):
    """The stereo file is quiet noise of 45 s; the disk stops at 40 s, and 30 s up to 42 s are kept."""
    rate = 8000
    noise = 1e-3 * np.random.default_rng(1).standard_normal((45 * rate, 2))
    noise[:, 0] *= 0.1
    soundfile.write(tmp_path / "recording.wav", noise, rate, "FLOAT")
    write_recording(tmp_path / "recording.wav", tmp_path / "data.json", 40.0)
    data = json.loads((tmp_path / "data.json").read_text())
    assert (data["start"], data["duration"], data["source_end"]) == (12.0, 42.0, 40.0)
    sounds = data["sounds"]
    samples = decoded_track(sounds["tracks"]["recording"])
    kept = noise[12 * rate : 42 * rate, 1]
    assert samples * sounds["full_scale"] == pytest.approx(
        kept, abs=sounds["full_scale"] * 2**-15
    )
    audible = with_gain(sounds["audible"], kept, rate)
    heard = loudness_lufs(Recording(samples=audible, sample_rate=rate))
    assert heard == pytest.approx(-18.0, abs=0.3)
