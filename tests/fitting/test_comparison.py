"""Claim: the numbers that `fit` compares between a recording and a simulated sound are right.

Source: the definition of level, line and decay. Oracle: bursts of two lines of known frequency and
decay, and noise of known spectrum.
"""

from types import SimpleNamespace

import numpy as np
import pytest
from settling_sounds import clicks, settling_phase, times_of_phase, with_noise

from sonify.fitting import comparison
from sonify.fitting.comparison import numbers_of_run, simulated_numbers, sound_numbers
from sonify.hearing.audio_source import Recording
from sonify.hearing.settling.detector import settling_runs

RATE = 48000
TIME = np.arange(RATE) / RATE


def test_lines_and_their_decay_between_bursts_are_given_back():
    """A burst every 40 ms rings a line that decays at 100 1/s and one that decays at 60 1/s."""
    random = np.random.default_rng(0)
    sound = 1e-4 * random.standard_normal(RATE)
    for first in range(0, RATE, RATE // 25):
        age = TIME[: RATE - first]
        for frequency, decay in ((5000.0, 100.0), (12000.0, 60.0)):
            phase = 2 * np.pi * frequency * age + random.uniform(0, 6)
            sound[first:] += np.exp(-decay * age) * np.sin(phase)
    numbers = sound_numbers(Recording(samples=sound, sample_rate=RATE), 0.0, 1.0)
    lines = sorted(numbers["lines"], key=lambda line: line["frequency"]["value"])
    assert [line["frequency"]["value"] for line in lines] == pytest.approx(
        [5000, 12000], abs=5
    )
    assert [line["decay_rate"]["value"] for line in lines] == pytest.approx(
        [100, 60], rel=0.15
    )


def test_the_bands_of_white_noise_differ_by_their_widths():
    noise = np.random.default_rng(0).standard_normal(RATE)
    numbers = sound_numbers(Recording(samples=noise, sample_rate=RATE), 0.0, 1.0)
    assert not numbers["lines"]
    for band in numbers["bands"]:
        expected = 10 * np.log10((band["to"] - band["from"]) / 5500)
        assert band["value"] == pytest.approx(expected, abs=0.5)


@pytest.mark.filterwarnings("error::RuntimeWarning")
def test_the_decay_of_bursts_with_silence_between_them_is_finite():
    """A running mean of the power is negative by rounding in silence after a loud burst."""
    sound = np.zeros(RATE)
    age = TIME[: RATE // 50]
    for first in range(0, RATE, RATE // 10):
        sound[first : first + len(age)] = np.exp(-300 * age) * np.sin(
            2 * np.pi * 5000 * age
        )
    (line,) = sound_numbers(Recording(samples=sound, sample_rate=RATE), 0.0, 1.0)[
        "lines"
    ]
    assert np.isfinite([line["decay_rate"][name] for name in ("low", "high")]).all()


@pytest.mark.slow
def test_bursts_are_compared_with_bursts_and_turns_with_turns(monkeypatch):
    """Two bursts of different strength per turn: a recording and a simulation with the same sound
    have equal numbers; only the simulation knows the turns without doubt.
    """
    random = np.random.default_rng(5)
    end = 1.9
    bursts = 24.0
    phase = lambda t: settling_phase(t, 0.5, end, bursts)  # noqa: E731
    times = times_of_phase(phase, 0.2, end - 0.01, 0.01, random)
    levels = np.where(np.arange(len(times)) % 2, 1.0, 0.4)
    sound = with_noise(clicks(times, levels, end + 0.4, random, 0.004), 30, random)
    record = Recording(samples=sound, sample_rate=RATE)
    t = np.linspace(0, end, 3000)
    turned = np.pi * (phase(t) - phase(0.0))
    motion = SimpleNamespace(
        t=t, state=turned[:, None], at=lambda at: np.interp(at, t, turned)[:, None]
    )
    motion.rolling = motion
    solved = SimpleNamespace(
        motion=motion, sound=SimpleNamespace(pressure=record, source_end=end)
    )
    monkeypatch.setattr(comparison, "solve", lambda scene: solved)
    (run,) = settling_runs(record)
    assert run.events_per_turn == 2
    measured = numbers_of_run(record, run)
    simulated = simulated_numbers(None, measured["seconds"])
    for key in ("rate_at_1s", "exponent", "events_per_turn"):
        assert simulated[key] == pytest.approx(measured[key])
    assert measured["rate_at_1s"]["value"] == pytest.approx(bursts, rel=0.05)
    turns = measured["turns_at_1s"]
    assert simulated["turns_at_1s"]["value"] == pytest.approx(bursts / 2, rel=0.02)
    assert turns["value"] == pytest.approx(bursts / 2, rel=0.05)
    assert turns["low"] < simulated["turns_at_1s"]["value"] < turns["high"]
    silent = Recording(
        samples=1e-9 * random.standard_normal(len(sound)), sample_rate=RATE
    )
    solved.sound.pressure = silent
    unheard = simulated_numbers(None, measured["seconds"])
    assert unheard["rate_at_1s"]["value"] is None
    assert unheard["turns_at_1s"] == simulated["turns_at_1s"]
    assert unheard["exponent"]["value"] == pytest.approx(0.5, abs=0.02)
