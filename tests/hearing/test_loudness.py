"""Claim: levels, A-weighting, threshold and loudness follow the standards.

Source: IEC 61672-1, table 3 (A-weighting at nominal frequencies, +-0.05 dB of rounding), ISO
226:2003, table 1 and ITU-R BS.1770. Oracle: the values printed in these
tables; a sine of known pressure.
"""

from itertools import pairwise

import numpy as np
import pytest
import soundfile

from dynamics.a_weighting import a_weighting_db
from sonify.hearing.audio_source import (
    BLOCK_SIZE,
    SoundFile,
    overlapping_pieces,
    read_samples,
)
from sonify.hearing.loudness import (
    ISO_226_THRESHOLD_DB,
    audibility,
    band_levels,
    loudness_lufs,
)
from sonify.hearing.spectrogram import spectrogram

RATE = 48000


def tone(path, frequency, pascal, seconds=2.0):
    t = np.arange(int(seconds * RATE)) / RATE
    soundfile.write(
        path, pascal * np.sqrt(2) * np.sin(2 * np.pi * frequency * t), RATE, "FLOAT"
    )
    return path


@pytest.mark.parametrize(
    ("frequency", "expected"),
    [
        (10, -70.4),
        (31.62, -39.4),
        (100, -19.1),
        (251.19, -8.6),
        (1000, 0.0),
        (3981.07, 1.0),
        (10000, -2.5),
        (19952.6, -9.3),
    ],
)
def test_a_weighting(frequency, expected):
    assert a_weighting_db(frequency) == pytest.approx(expected, abs=0.06)


@pytest.mark.parametrize(
    ("frequency", "threshold"), [(20, 78.5), (1000, 2.4), (3150, -6.0), (12500, 12.3)]
)
def test_a_tone_at_the_threshold_is_just_heard(tmp_path, frequency, threshold):
    assert ISO_226_THRESHOLD_DB[frequency] == threshold
    path = tone(tmp_path / "tone.wav", frequency, 20e-6 * 10 ** (threshold / 20))
    heard = audibility(path)
    assert np.median(heard.above_threshold) == pytest.approx(
        0, abs=2.5
    )  # a neighbouring band leaks at 20 Hz
    louder = audibility(tone(path, frequency, 20e-6 * 10 ** ((threshold + 20) / 20)))
    assert np.median(louder.above_threshold - heard.above_threshold) == pytest.approx(
        20, abs=0.1
    )


def test_a_pascal_is_94_db(tmp_path):
    seen = spectrogram(tone(tmp_path / "tone.wav", 1000.0, 1.0), 0.125)
    assert seen.level_db(20e-6).max() == pytest.approx(93.98, abs=0.02)
    assert band_levels(seen).max(axis=0) == pytest.approx(93.98, abs=0.05)
    assert audibility(tmp_path / "tone.wav").a_weighted == pytest.approx(
        93.98, abs=0.05
    )


def test_loudness_of_a_full_scale_tone(tmp_path):
    """A 997 Hz sine of peak 0 dBFS in one channel reads -3.01 LKFS (BS.1770, note to annex 1)."""
    assert loudness_lufs(
        tone(tmp_path / "tone.wav", 997.0, 1 / np.sqrt(2), 5.0)
    ) == pytest.approx(-3.01, abs=0.1)


def test_a_long_file_is_seen_in_a_bounded_number_of_places(tmp_path):
    path = tone(tmp_path / "long.wav", 1000.0, 1.0, 60.0)
    seen = spectrogram(path, 0.02, columns=100)
    assert len(seen.time) <= 100
    assert seen.level_db(20e-6).max(axis=0) == pytest.approx(93.98, abs=0.02)


@pytest.mark.parametrize("seconds", [1 / RATE, 0.001, 0.1])
def test_a_file_shorter_than_the_window_is_seen_in_it(tmp_path, seconds):
    seen = spectrogram(tone(tmp_path / "short.wav", 1000.0, 1.0, seconds), 0.2)
    assert np.isfinite(seen.power).all()
    assert len(seen.time) == 1


class InBlocks:
    """An audio source that yields samples (n, c) in uneven blocks."""

    sample_rate = RATE

    def __init__(self, samples, sizes=(1, 7000, 333)):
        self.samples = samples
        self.frames = len(samples)
        self.sizes = sizes

    def blocks(self, start=0):
        edges = np.cumsum([start, *self.sizes * (1 + self.frames // sum(self.sizes))])
        return (self.samples[a:b] for a, b in pairwise(edges) if a < self.frames)


@pytest.mark.parametrize(
    ("step", "overlap", "start"),
    [(1000, 0, 0), (1000, 3000, 17), (50_000, 5, 0), (8, 90_000, 3)],
)
def test_pieces_are_the_samples_however_they_come(step, overlap, start):
    samples = np.random.default_rng(0).normal(size=(60_001, 2))
    source = InBlocks(samples)
    padded = np.pad(samples, ((0, 100_000), (0, 0)))
    for reading in range(2):  # the second search finds the results of the first
        for i, piece in enumerate(overlapping_pieces(source, step, overlap, start)):
            assert np.array_equal(
                piece, padded[start + i * step :][: step + overlap]
            ), reading
            if i > 100:
                break
        else:
            assert start + (i + 1) * step >= len(samples)
    assert np.array_equal(
        read_samples(source, start, start + step), samples[start : start + step]
    )


def test_a_file_and_its_samples_look_and_sound_the_same(tmp_path):
    samples = (
        np.random.default_rng(1)
        .normal(scale=0.1, size=(3 * BLOCK_SIZE + 5, 2))
        .astype(np.float32)
    )
    soundfile.write(tmp_path / "noise.wav", samples, RATE, "FLOAT")
    file = SoundFile(tmp_path / "noise.wav")
    blocks = InBlocks(samples)
    assert (file.sample_rate, file.frames) == (RATE, len(samples))
    assert np.array_equal(
        read_samples(file, 100, BLOCK_SIZE + 200), samples[100 : BLOCK_SIZE + 200]
    )
    for options in (
        {"window": 0.02},
        {"window": 0.3, "span": (1.0, 2.5)},
        {"window": 0.01, "columns": 20},
    ):
        seen = spectrogram(blocks, **options)
        true = spectrogram(file, **options)
        np.testing.assert_allclose(seen.power, true.power, rtol=1e-5, atol=0)
        assert np.array_equal(seen.time, true.time)
    assert loudness_lufs(blocks) == pytest.approx(loudness_lufs(file))


def test_the_power_in_a_window_is_that_of_a_transform_written_out(tmp_path):
    """Oracle: the sum |sum w x exp(-i w t)|^2 of one window, term by term."""
    samples = np.random.default_rng(2).normal(size=(RATE // 10, 1))
    seen = spectrogram(InBlocks(samples), 0.01)
    size = 480
    column = 7
    bin_ = 31
    n = np.arange(size)
    window = 0.5 - 0.5 * np.cos(2 * np.pi * n / size)
    wave = np.exp(-2j * np.pi * seen.frequency[bin_] * n / RATE)
    value = window @ (samples[column * size // 4 :][:size, 0] * wave)
    assert seen.time[column] == pytest.approx((column * size // 4 + size / 2) / RATE)
    assert seen.power[bin_, column] == pytest.approx(
        2 * abs(value) ** 2 / window.sum() ** 2, rel=1e-5
    )
