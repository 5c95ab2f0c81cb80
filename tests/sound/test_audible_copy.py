"""Claim: the copy for small loudspeakers is the A-weighted pressure, amplified by a constant gain,
and every file describes its content.

Source: IEC 61672-1, annex E; ITU-R BS.1770-4; EBU R 128. Oracle: the weighting in closed form;
sines of known loudness and true peak; readers other than the writer.
"""

import re
import wave
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
import soundfile
from scipy.signal import resample_poly, sosfreqz
from tracks import track

from dynamics import Outcome
from sonify.hearing.loudness import a_weighting_db, loudness_lufs
from sonify.sound.audible_modes import RingDown
from sonify.sound.playback import (
    AUDIBLE_COPY_LOUDNESS_LUFS,
    MAX_TRUE_PEAK_RATIO,
    a_weighting,
    audible_copy,
    energy_below,
    true_peak,
)
from sonify.sound.pressure import STEMS, Sound, pressure_and_stems
from sonify.sound.wav import write_sound

RATE = 48000


def sine(frequency, seconds=2.0, size=1.0, phase=0.0):
    return size * np.sin(
        2 * np.pi * frequency * np.arange(int(seconds * RATE)) / RATE + phase
    )


@pytest.mark.parametrize("rate", [8000, 44100, 48000, 192000])
def test_the_filter_weighs_as_the_standard_at_any_sample_rate(rate):
    """The error is within class 1 of IEC 61672-1, table 3: 1 dB from 20 Hz (there 2.5 dB) to 4 kHz,
    and 0.1 dB up to a quarter of the sample rate."""
    frequency = np.geomspace(20, rate / 3, 200)
    apart = 20 * np.log10(
        np.abs(sosfreqz(a_weighting(rate), worN=frequency, fs=rate)[1])
    ) - a_weighting_db(frequency)
    assert np.abs(apart).max() < 0.5
    assert np.abs(apart[frequency < rate / 4]).max() < 0.1


def test_a_tone_of_1_khz_keeps_its_level_and_one_of_100_hz_loses_19_db():
    for frequency, loss in ((1000.0, 0.0), (100.0, -19.1)):  # IEC 61672-1, table 3
        heard = audible_copy(track(sine(frequency, size=0.02)))
        weighted = np.concatenate(list(heard.blocks()))[RATE // 2 :] * heard.full_scale
        assert 20 * np.log10(weighted.std() * 2**0.5 / 0.02) == pytest.approx(
            loss, abs=0.1
        )


def test_any_sound_comes_out_as_loud():
    for size in (1e-6, 1.0, 1e3):
        assert loudness_lufs(
            audible_copy(track(sine(440.0, size=size)))
        ) == pytest.approx(AUDIBLE_COPY_LOUDNESS_LUFS, abs=0.01)


def test_a_click_is_held_below_the_true_peak_by_its_gain():
    click = np.zeros(4 * RATE)
    click[RATE] = 1.0
    heard = audible_copy(track(click))
    assert 20 * np.log10(true_peak(heard)) == pytest.approx(-1.0, abs=1e-6)
    assert loudness_lufs(heard) < AUDIBLE_COPY_LOUDNESS_LUFS


def test_a_true_peak_lies_between_the_samples():
    """BS.1770-4, annex 2: a sine at a quarter of the sample rate, sampled 45 degrees off its
    crests, reads 3 dB low."""
    source = track(sine(RATE / 4, phase=np.pi / 4))
    assert np.abs(source.read()).max() == pytest.approx(0.5**0.5, rel=1e-6)
    assert 20 * np.log10(true_peak(source)) == pytest.approx(0.0, abs=0.2)


def test_a_true_peak_is_found_in_whichever_part_it_is_and_no_quiet_part_can_hold_it():
    """The search skips parts so quiet that even the sum of all absolute filter weights cannot raise
    them to the peak."""
    oversampling = 4
    weights = (
        np.abs(resample_poly(np.eye(1, 401, 200)[0], oversampling, 1))
        .reshape(-1, oversampling)
        .sum(axis=0)
    )
    assert weights.max() < MAX_TRUE_PEAK_RATIO
    quiet = sine(RATE / 4, 4.0, 0.5)
    crest = sine(RATE / 4, 0.1, phase=np.pi / 4)
    for n in (0, 70_000, 150_000):
        samples = quiet.copy()
        samples[n : n + len(crest)] = crest
        assert true_peak(track(samples)) == pytest.approx(
            np.abs(resample_poly(samples, oversampling, 1)).max(), rel=1e-6
        )


def test_silence_and_a_tenth_of_a_second_pass():
    assert not np.any(list(audible_copy(track(np.zeros(RATE))).blocks()))
    assert true_peak(audible_copy(track(sine(1000.0, 0.1)))) == pytest.approx(
        10 ** (-1 / 20), rel=1e-6
    )


def test_blocks_begin_anew_and_anywhere():
    heard = audible_copy(track(sine(300.0, 4.0)))
    whole = np.concatenate(list(heard.blocks()))
    assert np.array_equal(np.concatenate(list(heard.blocks(70_000))), whole[70_000:])


def test_the_energy_is_where_the_tones_are():
    both = track(sine(50.0) + sine(1000.0, size=0.5))
    assert energy_below(both, 100.0, 300.0, 2000.0) == pytest.approx(
        [0.8, 0.8, 1.0], abs=1e-3
    )


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sound")
    parts = np.column_stack([sine(f, size=0.01) for f in (50.0, 100.0, 1000.0, 2000.0)])
    ringing = RingDown(
        frequency=np.zeros(0),
        decay_rate=np.zeros(0),
        decay_rate_without_film=np.zeros(0),
    )
    none = {
        "source_end": 1.0,
        "energy_time": np.zeros(0),
        "energy": np.zeros(0),
    }
    none |= {"ringing": ringing, "outcome": Outcome.SETTLED}
    sound = Sound(
        name="four sines", sample_rate=RATE, columns=pressure_and_stems(parts), **none
    )
    write_sound(sound, folder)
    return SimpleNamespace(path=folder, sound=sound)


def test_every_file_says_what_it_is(folder):
    for name in (
        "pressure",
        "sound",
        "audible",
        *(f"stems/{name}" for name in STEMS),
    ):
        with soundfile.SoundFile(folder.path / f"{name}.wav") as file:
            assert (
                file.title
                == f"Euler's disk, four sines: {name.removeprefix('stems/').replace('_', ' ')}"
            )
            assert file.software.startswith("eulers-disk-sonify")
            scale = float(re.search(r"1\.0 = (\S+) pascal", file.comment).group(1))
            true = {
                "sound": folder.sound.full_scale,
                "audible": folder.sound.audible.full_scale,
            }.get(name, 1.0)
            assert scale == pytest.approx(true, rel=1e-5)
            assert ("not the pressure" in file.comment) == (name == "audible")


@pytest.mark.parametrize("outcome", Outcome)
def test_every_file_says_that_the_end_is_missing_where_it_is(folder, tmp_path, outcome):
    """For a motion that came to rest no file reports a missing end."""
    write_sound(replace(folder.sound, outcome=outcome), tmp_path)
    comments = [soundfile.SoundFile(path).comment for path in tmp_path.rglob("*.wav")]
    assert len(comments) == 3 + len(folder.sound.names)
    for comment in comments:
        assert (
            (outcome.sentence in comment)
            == ("its end is missing" in comment)
            == (outcome not in (Outcome.SETTLED, Outcome.SANK, Outcome.AT_REST))
        )


def test_other_programs_read_the_files(folder):
    for name, width in (("sound", 3), ("audible", 2)):
        with wave.open(str(folder.path / f"{name}.wav")) as file:
            assert (file.getframerate(), file.getsampwidth(), file.getnframes()) == (
                RATE,
                width,
                folder.sound.samples,
            )
