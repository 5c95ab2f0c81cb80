"""Claim: spectral lines are found with their drift, with error estimates that contain the truth,
and are distinguished from their sidebands.

Source: least squares and the jackknife over segments. Oracle: synthetic tones and noise bands of
known drift; a tone with amplitude modulation of increasing rate.
"""

import numpy as np
import pytest
import soundfile
from scipy.linalg import hankel
from scipy.signal import butter, firwin, lfilter, oaconvolve, sosfilt

from sonify import load_scene
from sonify.claims.resonance_matching import nearest_resonance, resonances
from sonify.hearing.ring_down import _poles, decaying_lines, free_ringing
from sonify.hearing.spectral_lines import (
    MAX_SIDEBAND_OFFSET_HZ,
    _peak_pairs,
    find_spectral_lines,
)
from sonify.hearing.time_frequency import local_maxima

RATE, LENGTH = 16000, 12.0
TIME = np.arange(int(LENGTH * RATE)) / RATE


def made(seed, drift, bandwidth):
    """Return samples of a random line in noise, its centre [Hz] and its drift [cents/s]."""
    random = np.random.default_rng(seed)
    middle = random.uniform(900, 5000)
    drift = drift * random.uniform(-1, 1)
    phase = (
        2 * np.pi * np.cumsum(middle * 2 ** (drift * (TIME - LENGTH / 2) / 1200)) / RATE
    )
    low = butter(1, bandwidth or 1.0, fs=RATE, output="sos")
    wide = random.standard_normal((2, len(TIME)))
    shape = sosfilt(low, wide, axis=1) if bandwidth else np.ones((2, 1))
    sound = (shape * [np.cos(phase), np.sin(phase)]).sum(axis=0)
    noise = (
        sound.std() * 10 ** random.uniform(-2, 0.15) * random.standard_normal(len(TIME))
    )
    return sound + noise, middle, drift


@pytest.mark.slow
@pytest.mark.parametrize(("drift", "bandwidth"), [(0.0, 0.0), (25.0, 0.0), (25.0, 8.0)])
def test_twice_the_errors_hold_the_truth(drift, bandwidth):
    """Twice a normal error covers 95 %; fewer than 25 of 30 has a probability below 2 %."""
    inside = []
    for seed in range(30):
        samples, middle, rate = made(seed, drift, bandwidth)
        one = find_spectral_lines(samples, RATE)[0]
        there = middle * 2 ** (rate * ((one.begin + one.end) / 2 - LENGTH / 2) / 1200)
        inside.append(
            (
                abs(one.frequency - there) < 2 * one.error,
                abs(one.drift - rate) < 2 * one.drift_error,
            )
        )
    assert (np.sum(inside, axis=0) >= 25).all()


@pytest.mark.parametrize(
    ("drift", "course"), [(20.0, "rises"), (-20.0, "falls"), (0.0, "steady")]
)
def test_a_carrier_that_moves_is_not_called_steady(drift, course):
    phase = 2 * np.pi * np.cumsum(1700 * 2 ** (drift * TIME / 1200)) / RATE
    noise = 0.1 * np.random.default_rng(1).standard_normal(len(TIME))
    found = find_spectral_lines(np.cos(phase) + noise, RATE)
    assert [one.course for one in found] == [course]


def test_sidebands_are_told_from_carriers():
    """A tone of 1500 Hz, modulated at 60 to 96 Hz, and an unmodulated tone of 2500 Hz."""
    swing = 1 + 0.5 * np.cos(2 * np.pi * 60 * TIME * (1 + TIME / 40))
    noise = 0.01 * np.random.default_rng(0).standard_normal(len(TIME))
    found = find_spectral_lines(
        swing * np.cos(2 * np.pi * 1500 * TIME)
        + 0.3 * np.cos(2 * np.pi * 2500 * TIME)
        + noise,
        RATE,
    )
    assert [one.frequency for one in found] == pytest.approx([1500, 2500], rel=1e-5)
    assert found[0].sidebands == pytest.approx((78.0,), rel=0.02)
    assert found[1].sidebands == ()


def pair(low, high, seed=0):
    """Return two tones with given frequencies (n,) [Hz] in noise."""
    sound = sum(np.cos(2 * np.pi * np.cumsum(course) / RATE) for course in (low, high))
    return sound + 0.03 * np.random.default_rng(seed).standard_normal(len(TIME))


@pytest.mark.parametrize("exponent", [0.3, 0.5, 1.0])
def test_a_silent_carrier_is_told_by_its_sidebands(exponent):
    """A mode shape that is odd about the contact has a drive factor that oscillates about zero.

    In the last 3 s the mode rings freely.
    """
    swing = 120 * (LENGTH - TIME + 1) ** -exponent
    rolls = TIME < LENGTH - 3
    ringing = np.cos(2 * np.pi * 2261 * TIME)
    sound = np.where(rolls, pair(2261 - swing, 2261 + swing), ringing)
    one, other = sorted(
        find_spectral_lines(sound, RATE), key=lambda carrier: carrier.begin
    )
    assert (one.heard, other.heard, other.rates) == (False, True, None)
    assert one.frequency == pytest.approx(2261, abs=2 * one.error)
    assert one.error < 0.2
    assert one.course == "steady"
    assert one.rates == pytest.approx(swing[[0, int((LENGTH - 3) * RATE)]], rel=0.15)
    assert other.frequency == pytest.approx(2261, abs=2 * other.error)


@pytest.mark.parametrize("falling", [0.0, -1.0, -3.0, -12.0])
def test_two_carriers_that_do_not_mirror_each_other_stay_two(falling):
    """One line rises by 6 Hz/s; the two would be sidebands only if the other fell by 6 Hz/s."""
    found = find_spectral_lines(pair(2200 + falling * TIME, 2300 + 6 * TIME), RATE)
    middles = [2200 + falling * LENGTH / 2, 2300 + 6 * LENGTH / 2]
    assert sorted(one.frequency for one in found) == pytest.approx(middles, abs=2.0)
    assert all(one.heard and not one.sidebands for one in found)
    assert [one.course for one in sorted(found, key=lambda one: one.frequency)][
        1
    ] == "rises"
    assert len(find_spectral_lines(pair(2200 - 6 * TIME, 2300 + 6 * TIME), RATE)) == 1


def test_of_many_peaks_as_speech_has_only_near_ones_are_compared():
    """The work is linear in the number of peaks; all pairs of an hour would take hours."""
    few, many = (
        np.array([[0] * n, 60.0 * np.arange(n), [20] * n]) for n in (1000, 2000)
    )
    assert (
        1900
        < _peak_pairs(many).shape[1] - _peak_pairs(few).shape[1]
        <= 1000 * 2 * MAX_SIDEBAND_OFFSET_HZ / 60
    )


def band(drift, seed):
    """Return a drifting noise band [cents/s] in white noise.

    Half the power of the band is within about 80 cents of 1800 Hz.
    """
    rng = np.random.default_rng(seed)
    keeps = np.exp(-2 * np.pi * 1800 * (2 ** (80 / 1200) - 1) / RATE)
    turns = np.cumsum(1800 * 2 ** (drift * (TIME - LENGTH / 2) / 1200)) / RATE
    slow = lfilter(
        [1.0],
        [1.0, -keeps],
        rng.standard_normal((2, len(TIME))) * np.sqrt(1 - keeps**2),
    )
    return (
        slow[0] * np.cos(2 * np.pi * turns)
        - slow[1] * np.sin(2 * np.pi * turns)
        + 0.3 * rng.standard_normal(len(TIME))
    )


@pytest.mark.parametrize("drift", [-40.0, 0.0, 20.0, 60.0])
def test_the_drift_of_a_band_of_noise_is_told_with_its_error(drift):
    """No peak of the band is a spectral line, even if it lasts long; a separate line is one."""
    missed = []
    for seed in range(4):
        sound = band(drift, seed) + np.cos(2 * np.pi * 4000 * TIME)
        line, *bands = find_spectral_lines(sound, RATE)
        assert (line.frequency, line.reach) == (pytest.approx(4000, abs=0.1), 0)
        assert all(40 < one.reach < 200 for one in bands)
        assert sum(one.end - one.begin for one in bands) > 0.7 * LENGTH
        middles = [(one.begin + one.end) / 2 - LENGTH / 2 for one in bands]
        away = [
            1200 * np.log2(one.frequency / 1800) - drift * at
            for one, at in zip(bands, middles, strict=True)
        ]
        missed += [(one.drift - drift) / one.drift_error for one in bands]
        missed += [
            x / (1200 / np.log(2) * one.error / 1800)
            for x, one in zip(away, bands, strict=True)
        ]
    assert (
        np.sqrt(np.mean(np.square(missed))) < 2
    )  # errors estimated with seven degrees of freedom
    assert np.max(np.abs(missed)) < 6


def test_noise_has_no_carriers():
    assert (
        find_spectral_lines(np.random.default_rng(0).standard_normal(8 * RATE), RATE)
        == []
    )


@pytest.mark.parametrize("rate", [44100, 48000])
@pytest.mark.parametrize("edges", [(None, 15000.0), (5000.0, None), (3000.0, 8000.0)])
def test_the_edge_of_a_filter_is_no_carrier(rate, edges):
    """White noise in a band with edges of a few hertz or a few hundred."""
    low, high = edges
    noise = np.random.default_rng(0).standard_normal(10 * rate)
    for taps in (1001, 4001):
        kind = "lowpass" if low is None else "highpass" if high is None else "bandpass"
        corner = high if low is None else low if high is None else edges
        filtered = oaconvolve(
            noise, firwin(taps, corner, fs=rate, pass_zero=kind), mode="same"
        )
        assert find_spectral_lines(filtered, rate) == []


@pytest.mark.parametrize("quality", [0.8, 0.6])
def test_the_edge_of_the_band_of_a_codec_is_no_carrier(tmp_path, quality):
    """MP3 at 96 and 160 kb/s."""
    noise = 0.2 * np.random.default_rng(0).standard_normal(441000)
    path = tmp_path / "noise.mp3"
    soundfile.write(
        path, noise, 44100, compression_level=quality, bitrate_mode="CONSTANT"
    )
    decoded, rate = soundfile.read(path)
    assert find_spectral_lines(decoded, rate) == []


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(20))
def test_the_decay_rates_of_a_close_pair_are_found(seed):
    """Two lines 3 to 200 Hz apart with amplitude decay rates of 2 to 18 1/s, at 20 to 50 dB."""
    random = np.random.default_rng(seed)
    time = np.arange(int(0.8 * 44100)) / 44100
    frequency = random.uniform(3e3, 15e3) + np.array([0, random.uniform(3, 200)])
    decay = random.uniform(2, 18, 2)
    amplitude = random.uniform(0.4, 1, 2)
    pair = (
        amplitude
        * np.exp(-np.outer(time, decay))
        * np.cos(2 * np.pi * np.outer(time, frequency) + random.uniform(0, 6, 2))
    )
    noise = 10 ** (-random.uniform(20, 50) / 20) * random.standard_normal(len(time))
    lines = sorted(
        decaying_lines(pair.sum(axis=1) + noise, 44100), key=lambda line: line.frequency
    )
    assert [line.frequency for line in lines] == pytest.approx(frequency, abs=0.1)
    assert [line.decay_rate for line in lines] == pytest.approx(decay, rel=0.1)


@pytest.mark.parametrize("noise", [1e-9, 1e-3, 0.1, 0.5, 3.0])
@pytest.mark.parametrize("count", [0, 1, 3, 10])
def test_the_poles_are_those_of_the_complete_singular_value_decomposition(noise, count):
    """The oracle computes all singular vectors, and the median of all values."""
    random = np.random.default_rng(count)
    size = 301
    pole = np.exp(random.uniform(-0.02, 0, count) + 1j * random.uniform(-2, 2, count))
    parts = random.uniform(0.3, 1, count) * pole ** np.arange(size)[:, None]
    white = random.standard_normal((2, size))
    signal = parts.sum(axis=1) + noise * (white[0] + 1j * white[1])
    vectors, values, _ = np.linalg.svd(hankel(signal[:150], signal[149:]))
    limit = max(6 * np.median(values), 0.01 * values[0])
    kept = vectors[:, : np.count_nonzero(values[:8] > limit)]
    expected = np.linalg.eigvals(np.linalg.pinv(kept[:-1]) @ kept[1:])
    found = _poles(signal)
    assert len(found) == len(expected)
    assert np.sort_complex(found) == pytest.approx(np.sort_complex(expected), abs=1e-9)


@pytest.mark.parametrize("seed", [0, 2, 3])
def test_a_steady_band_of_noise_does_not_ring(seed):
    """A line rings freely only if its decay rate exceeds the error; the ring does."""
    random = np.random.default_rng(seed)
    time = np.arange(44100) / 44100
    taps = firwin(2001, [7950, 8050], fs=44100, pass_zero=False)
    band = oaconvolve(random.standard_normal(46100), taps, mode="valid")
    ring = 0.3 * np.cos(2 * np.pi * 5000 * time) * np.exp(-8 * time)
    lines = decaying_lines(band + ring, 44100)
    assert any(line.frequency == pytest.approx(5000, abs=1) for line in lines)
    for line in lines:
        assert line.decay_rate > line.decay_error > 0


def test_the_free_ringing_begins_after_the_strike_and_ends_before_the_next():
    time = np.arange(44100) / 44100
    ring = np.cos(2 * np.pi * 5000 * time) * np.exp(-5 * time)
    sound = np.concatenate([np.zeros(8820), ring[:17640], 0.9 * ring])
    part = free_ringing(sound, 44100)
    assert part.start / 44100 == pytest.approx(0.28, abs=0.011)
    assert part.stop / 44100 == pytest.approx(0.6, abs=0.011)


def test_carriers_are_matched_to_modes_and_contact():
    """The toy on granite has a free mode at 10.6 kHz; its contact resonance passes 2 kHz.

    The recorded line at 5.04 kHz matches neither.
    """
    known = resonances(load_scene("granite"))
    rate = 44100
    t = np.arange(4 * rate) / rate
    mode = next(f for of, f in known if of == "disk")
    sound = sum(np.cos(2 * np.pi * f * t) for f in (mode, 2000.0, 5040.0))
    found = find_spectral_lines(
        sound + 0.01 * np.random.default_rng(0).standard_normal(len(t)), rate
    )
    of = {
        round(one.frequency): match and match.of
        for one in found
        for match in [nearest_resonance(one, known)]
    }
    assert of == {round(mode): "disk", 2000: "contact", 5040: None}


def test_a_local_maximum_is_the_vertex_of_a_parabola_and_the_first_of_equals():
    """Parabolas with known vertices; a plateau counts once, at its first bin."""
    bins = np.arange(20.0)
    vertices = np.array([3.0, 7.4, 11.75])
    level = -((bins - vertices[:, None]) ** 2)
    row, column, offset = local_maxima(level)
    assert row.tolist() == [0, 1, 2]
    assert column + offset == pytest.approx(vertices, abs=1e-12)
    assert local_maxima(level, min_level=1.0)[0].size == 0
    plateau = np.array([[0.0, 1.0, 1.0, 0.0]])
    assert local_maxima(plateau)[1].tolist() == [1]
