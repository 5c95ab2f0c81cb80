"""Claim: audible.wav is a master of -18 LUFS below -1 dBTP with compressed dynamics, for sounds of
scenes and for awkward ones, unless the natural dynamics are requested.

Source: ITU-R BS.1770-4; EBU R 128. Oracle: a meter with the filter coefficients of the standard; an
exact interpolation of the samples; the settings in run.json.
"""

import json
from functools import cache

import numpy as np
import pytest
import soundfile
from click.testing import CliRunner
from scipy.signal import lfilter, resample
from tracks import track

from sonify import load_scene, run, solve
from sonify.__main__ import main
from sonify.hearing.audio_source import BLOCK_SIZE
from sonify.scene_errors import InputError
from sonify.sound.mastering import (
    CompressedTrack,
    MasteredTrack,
    Mastering,
    loudest_window,
    master_copy,
    true_peak_dbtp,
)
from sonify.sound.playback import (
    AUDIBLE_COPY_LOUDNESS_LUFS,
    ScaledTrack,
    WeightedTrack,
    audible_copy,
)
from sonify.sound.wav import write_sound

RATE = 48000
SHELF = (
    [1.53512485958697, -2.69169618940638, 1.19839281085285],
    [1.0, -1.69065929318241, 0.73248077421585],
)
HIGH_PASS = ([1.0, -2.0, 1.0], [1.0, -1.99004745483398, 0.99007225036621])
"""Coefficients of the two filters at 48 kHz, BS.1770-4, tables 1 and 2."""


def measured_loudness(samples):
    """Return the integrated loudness [LUFS] of samples (n, channels) at 48 kHz; BS.1770-4, annex 1."""
    weighted = lfilter(*HIGH_PASS, lfilter(*SHELF, samples, axis=0), axis=0)
    block = int(0.4 * RATE)
    starts = range(0, len(samples) - block + 1, block // 4)
    power = np.array(
        [np.square(weighted[n : n + block]).mean(axis=0).sum() for n in starts]
    )
    level = -0.691 + 10 * np.log10(np.maximum(power, 1e-30))
    gated = power[level > -70]
    threshold = -0.691 + 10 * np.log10(gated.mean()) - 10
    return -0.691 + 10 * np.log10(power[level > max(threshold, -70)].mean())


def measured_true_peak(samples):
    """Return the true peak [dBTP] of samples (n, channels) by Fourier interpolation at 4 times."""
    padded = np.pad(samples, ((0, -len(samples) % 1024 + 1024), (0, 0)))
    return 20 * np.log10(np.abs(resample(padded, 4 * len(padded), axis=0)).max())


def whole(source):
    """Return all samples (n, channels) of a source."""
    return np.concatenate(list(source.blocks()))


def noise(seconds, channels=1, seed=1):
    """Return white noise (n, channels)."""
    return np.random.default_rng(seed).standard_normal((int(seconds * RATE), channels))


def click_after_noise(level_db, seconds=6.0):
    """Return noise of that level with a click of 1 a second before the end."""
    samples = 10 ** (level_db / 20) * noise(seconds)
    samples[-RATE] = 1.0
    return samples


def ringing():
    """Return a mode of 3 kHz that decays by 26 dB a second."""
    t = np.arange(8 * RATE) / RATE
    return np.sin(2 * np.pi * 3000 * t) * np.exp(-3 * t)


SOUNDS = {
    "click after near silence": lambda: click_after_noise(-80),
    "click after less": lambda: click_after_noise(-120),
    "long near silence": lambda: click_after_noise(-90, 30.0),
    "faint noise of two ears": lambda: 1e-6 * noise(3.0, 2),
    "rising noise": lambda: (
        noise(12.0) * np.exp(np.arange(12 * RATE) / RATE / 2)[:, None]
    ),
    "one gating block": lambda: noise(0.4),
    "one gating block and a half": lambda: (
        noise(0.46) * np.linspace(1, 0, 22080)[:, None]
    ),
    "ringing": ringing,
    "tone": lambda: np.sin(np.arange(2 * RATE) * 2 * np.pi * 440 / RATE),
    "one loud ear": lambda: noise(3.0, 2) * [1.0, 1e-3],
}


@pytest.mark.slow
@pytest.mark.parametrize("name", SOUNDS)
def test_an_awkward_sound_has_the_loudness_and_the_peak(name):
    samples = whole(master_copy(track(SOUNDS[name]())))
    assert measured_loudness(samples) == pytest.approx(-18.0, abs=0.5)
    assert measured_true_peak(samples) < -1.0


@cache
def sound_of_scene(name):
    """Return the sound of a scene that is solved in a few seconds."""
    brief = {
        "published": "numerics.time_limit=20.0",
        "hoop": "numerics.time_limit=1.5",
        "coin-polished": "numerics.time_limit=0.45",
    }
    return solve(load_scene(name).replace("numerics.accuracy=draft", brief[name])).sound


@pytest.mark.slow
@pytest.mark.parametrize("name", ["published", "hoop", "coin-polished"])
def test_the_file_of_a_scene_has_the_loudness_and_the_peak(name, tmp_path):
    sound = sound_of_scene(name)
    write_sound(sound, tmp_path)
    samples, rate = soundfile.read(tmp_path / "audible.wav", always_2d=True)
    assert (rate, len(samples)) == (RATE, sound.samples)
    assert measured_loudness(samples) == pytest.approx(-18.0, abs=0.5)
    assert measured_true_peak(samples) < -1.0
    assert measured_loudness(samples) == pytest.approx(sound.audible.loudness, abs=0.2)
    write_sound(sound, tmp_path / "again")
    again = (tmp_path / "again" / "audible.wav").read_bytes()
    assert again == (tmp_path / "audible.wav").read_bytes()


@pytest.mark.slow
def test_the_dynamics_are_compressed():
    """The levels of half-second windows spread at most 0.6 times as far as with natural dynamics."""
    sound = sound_of_scene("published")
    spreads = []
    for copy in (sound.audible_uncompressed, sound.audible):
        samples = whole(copy)[: int(sound.source_end * RATE)]
        windows = samples[: len(samples) // 24000 * 24000].reshape(-1, 24000 * 2)
        level = 10 * np.log10(np.square(windows).mean(axis=1))
        spreads.append(np.ptp(np.percentile(level, [10, 95])))
    assert spreads[1] < 0.6 * spreads[0]


def test_the_compressor_has_its_ratio():
    """A step of 18 dB becomes one of 6 dB, and one of 60 dB is reduced by no more than 24 dB."""
    tone = np.sin(2 * np.pi * 1000 * np.arange(RATE) / RATE)
    for step, left in ((18.0, 6.0), (60.0, 36.0)):
        source = track(np.concatenate([10 ** (-step / 20) * tone, tone]))
        settings = Mastering()
        weighted = WeightedTrack(track=source)
        loudest = loudest_window(weighted, settings)
        assert loudest == pytest.approx(0.5, rel=0.02)
        samples = whole(
            CompressedTrack(track=weighted, loudest=loudest, settings=settings)
        )
        faint, loud = (
            samples[n : n + RATE // 4].std() for n in (RATE // 2, 3 * RATE // 2)
        )
        assert 20 * np.log10(loud / faint) == pytest.approx(left, abs=0.1)


def test_the_limiter_leaves_what_is_below_its_limit():
    tone = 0.5 * np.sin(2 * np.pi * 1000 * np.arange(RATE) / RATE)
    tone[RATE // 2] = 40.0
    source = track(tone)
    limited = whole(MasteredTrack(track=source, gain=1.0, settings=Mastering()))[:, 0]
    reach = round(2 * 0.005 * RATE) + 40
    away = np.abs(np.arange(RATE) - RATE // 2) > reach
    assert np.array_equal(limited[away], source.read()[away])
    assert measured_true_peak(limited[:, None]) < -1.0


@pytest.mark.parametrize("length", [1, 10, 480, 4000, 19199])
def test_a_short_sound_passes_and_has_its_peak_at_the_limit(length):
    samples = whole(master_copy(track(noise(1.0)[:length])))
    assert len(samples) == length
    assert -3.0 < measured_true_peak(samples) < -1.0


def test_silence_and_a_single_click_pass():
    assert not whole(master_copy(track(np.zeros(RATE)))).any()
    click = np.zeros(4 * RATE)
    click[RATE] = 1.0
    heard = master_copy(track(click))
    assert measured_true_peak(whole(heard)) < -1.0
    assert heard.loudness < -18.0  # too sparse; run.json states the loudness


@pytest.mark.parametrize("rate", [8000, 44100, 96000])
def test_other_sample_rates_have_the_loudness_too(rate):
    heard = master_copy(track(noise(2.0), rate))
    assert heard.loudness == pytest.approx(-18.0, abs=0.05)
    assert true_peak_dbtp(heard) < -1.0


def test_blocks_begin_anew_and_anywhere():
    for cached in (1 << 23, 0):
        heard = master_copy(track(click_after_noise(-60)))
        heard = MasteredTrack(
            track=heard.track,
            gain=heard.gain,
            settings=heard.settings,
            max_cached=cached,
        )
        samples = whole(heard)
        assert len(samples) == 6 * RATE
        for start in (0, 70_000, BLOCK_SIZE, 6 * RATE - 1):
            assert np.array_equal(
                np.concatenate(list(heard.blocks(start))), samples[start:]
            )


def test_the_size_of_the_pressure_does_not_matter():
    samples = click_after_noise(-60)
    one, other = (whole(master_copy(track(size * samples))) for size in (1.0, 2.0**-30))
    assert other == pytest.approx(one, abs=1e-6)


@pytest.mark.slow
def test_the_record_states_the_chain(tmp_path):
    scene = load_scene("published").replace(
        "numerics.accuracy=draft", "numerics.time_limit=1.0"
    )
    for dynamics, loudness in (("compressed", -18.0), ("natural", None)):
        result = run(scene, tmp_path / dynamics, dynamics=dynamics)
        record = json.loads((tmp_path / dynamics / "run.json").read_text("utf-8"))[
            "sound"
        ]
        chain = record["audible_chain"]
        samples, _ = soundfile.read(tmp_path / dynamics / "audible.wav", always_2d=True)
        assert chain["dynamics"] == dynamics
        assert record["audible_true_peak_dbtp"] == pytest.approx(
            measured_true_peak(samples), abs=0.3
        )
        assert record["audible_loudness_lufs"] == pytest.approx(
            measured_loudness(samples), abs=0.3
        )
        if loudness:
            assert record["audible_loudness_lufs"] == pytest.approx(loudness, abs=0.05)
            settings = {key: chain[key] for key in vars(Mastering())}
            copy = master_copy(result.sound._audible_source, Mastering(**settings))
            assert np.array_equal(whole(copy), whole(result.sound.audible))
            assert 20 * np.log10(copy.gain) == pytest.approx(chain["gain_db"])
        else:
            assert chain["loudness_lufs"] == AUDIBLE_COPY_LOUDNESS_LUFS
            copy = audible_copy(result.sound._audible_source)
            assert isinstance(copy, ScaledTrack)
            assert np.abs(whole(copy) - samples).max() <= 2**-16  # half a step


def test_unknown_dynamics_are_one_line(tmp_path):
    with pytest.raises(
        InputError, match="dynamics = 'loud': must be compressed or natural"
    ):
        run("published", tmp_path / "out", dynamics="loud")
    told = CliRunner().invoke(
        main, ["run", "--dynamics", "loud", "--out", str(tmp_path / "out")]
    )
    assert told.exit_code == 2
    assert told.stderr.startswith(
        "sonify: Invalid value for '--dynamics': 'loud' is not one of"
    )
    assert told.stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == []
