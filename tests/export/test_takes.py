"""Claim: takes are variations of a sound that differ, are trimmed, loop without a click and state
what they are; the same seed gives the same bytes.

Source: RIFF WAVE with `LIST INFO` and `smpl` chunks. Oracle: libsndfile, a reader of tags and a walk
over the chunks; the pressure that a run of the same scene writes.
"""

import re
import struct
from contextlib import contextmanager
from types import SimpleNamespace

import numpy as np
import pytest
import soundfile
from click.testing import CliRunner
from refused_commands import assert_refused
from scipy.signal import resample
from tinytag import TinyTag

from sonify import __version__, load_scene, solve
from sonify.__main__ import main
from sonify.export import takes as takes_module
from sonify.export.takes import (
    TakeContent,
    apply_fades,
    audible_range,
    export_takes,
    loop_points,
    varied_scene,
    write_take,
)
from sonify.hearing.audio_source import read_samples
from sonify.runtime.progress import Stages
from sonify.scene_errors import InputError
from sonify.sound.playback import ScaledTrack
from sonify.sound.pressure import Track

BRIEF = ("numerics.accuracy=draft", "numerics.time_limit=0.5")


def brief_scene(name="published"):
    """Return a scene whose sound is rendered in about a second."""
    return load_scene(name).replace(*BRIEF)


def chunks(path):
    """Return the chunks of a RIFF file by name; check all lengths."""
    content = path.read_bytes()
    assert (content[:4], content[8:12]) == (b"RIFF", b"WAVE")
    assert struct.unpack("<I", content[4:8])[0] == len(content) - 8
    found = {}
    at = 12
    while at < len(content):
        name, length = struct.unpack("<4sI", content[at : at + 8])
        assert at + 8 + length <= len(content)
        found[name.decode()] = content[at + 8 : at + 8 + length]
        at += 8 + length + length % 2
    assert at == len(content)
    return found


def loop_of(path):
    """Return first and last sample of the loop in the `smpl` chunk."""
    fields = struct.unpack("<15I", chunks(path)["smpl"])
    assert fields[7] == 1
    kind, begin, end, _, count = fields[10:]
    assert (kind, count) == (0, 0)  # forward, endless
    return begin, end


class Recorder(Stages):
    """Collects the shares and notes of the progress."""

    def __init__(self):
        super().__init__()
        self.reports = []

    @contextmanager
    def stage(self, name):
        """Time the stage and record its progress."""
        with super().stage(name):
            yield lambda share, note="": self.reports.append((share, note))


@pytest.fixture(scope="module")
def exported(tmp_path_factory):
    folder = tmp_path_factory.mktemp("takes")
    stages = Recorder()
    told = []
    paths = export_takes(brief_scene(), 3, 1, None, folder, stages, told.append)
    return SimpleNamespace(paths=paths, folder=folder, stages=stages, told=told)


def test_the_takes_are_numbered_and_differ(exported):
    names = ["published-01.wav", "published-02.wav", "published-03.wav"]
    assert [path.name for path in exported.paths] == names
    assert sorted(path.name for path in exported.folder.iterdir()) == names
    assert exported.told == exported.paths
    sounds = [soundfile.read(path)[0] for path in exported.paths]
    shortest = min(map(len, sounds))
    for one, other in ((0, 1), (0, 2), (1, 2)):
        pair = sounds[one][:shortest], sounds[other][:shortest]
        assert abs(np.corrcoef(*pair)[0, 1]) < 0.99


@pytest.mark.slow
def test_the_same_seed_gives_the_same_bytes_for_any_number_of_takes(exported, tmp_path):
    (again,) = export_takes(brief_scene(), 1, 1, None, tmp_path / "again")
    assert again.read_bytes()[400:] == exported.paths[0].read_bytes()[400:]
    (other,) = export_takes(brief_scene(), 1, 2, None, tmp_path / "other")
    assert other.read_bytes()[400:] != again.read_bytes()[400:]
    paths = export_takes(brief_scene(), 3, 1, None, tmp_path / "all")
    assert [p.read_bytes() for p in paths] == [p.read_bytes() for p in exported.paths]


def test_a_take_is_the_pressure_of_its_scene(exported):
    """The comment names the changes and the scale; a run with these changes has the same sound."""
    path = exported.paths[1]
    comment = TinyTag.get(path).comment
    scale = float(re.search(r"1\.0 = (\S+) pascal", comment)[1])
    changes = re.search(r"seed 1; (release\S+) (release.+)$", comment).groups()
    pressure = (
        solve(brief_scene().replace(*changes)).sound.pressure.read().astype(float)
    )
    samples, rate = soundfile.read(path)
    inner = slice(round(0.01 * rate), -round(0.03 * rate))
    part = samples[inner] * scale
    starts = np.flatnonzero(np.abs(pressure - part[0]) < 2e-7 * scale)
    nearest = min(
        np.abs(pressure[n : n + len(part)] - part).max()
        for n in starts
        if n + len(part) <= len(pressure)
    )
    assert nearest < 2e-7 * scale


def true_peak_dbtp(samples):
    """Return the true peak [dBTP] of samples (n,) or (n, channels) by Fourier interpolation to 16 times
    as many."""
    padded = np.pad(
        samples, ((1024, 1024 - len(samples) % 1024), (0, 0))[: samples.ndim]
    )
    return 20 * np.log10(np.abs(resample(padded, 16 * len(padded))).max())


def test_no_take_has_a_true_peak_above_the_limit(exported):
    for path in exported.paths:
        samples, _ = soundfile.read(path)
        assert -2.0 < true_peak_dbtp(samples) < -1.0


@pytest.mark.parametrize("rate", [44100, 96000])
def test_peaks_between_the_samples_of_a_take_stay_below_the_limit(tmp_path, rate):
    """At a quarter of the sample rate, every sample of a sine at 45 degrees is 3 dB below its peak;
    white noise and clicks between two samples have such peaks too."""
    n = np.arange(rate)
    noise = np.random.default_rng(1).standard_normal(rate)
    click = np.sinc(n - rate / 2 - 0.5)
    for shape in (np.sin(np.pi / 2 * n + np.pi / 4), noise, click):
        columns = shape.astype(np.float32)[:, None]
        sound = SimpleNamespace(
            name="made",
            sample_rate=rate,
            playback_copy=ScaledTrack(
                track=Track(sample_rate=rate, columns=columns, column=0),
                full_scale=float(np.abs(shape).max() / 10 ** (-1 / 20)),
            ),
        )
        path = tmp_path / "take.wav"
        write_take(sound, path, "made")
        samples, _ = soundfile.read(path)
        assert true_peak_dbtp(samples) < -1.0


def test_the_text_fields_are_read_by_other_programs(exported):
    for number, path in enumerate(exported.paths, 1):
        tags = TinyTag.get(path)
        assert tags.title == "Euler's disk, published"
        assert f"take {number} of 3, seed 1" in tags.comment
        assert re.search(r"1\.0 = \d\S* pascal at the listener", tags.comment)
        with soundfile.SoundFile(path) as file:
            assert file.subtype == "PCM_24"
            assert file.software.startswith(f"eulers-disk-sonify {__version__}")
        info = chunks(path)["LIST"]
        assert info.startswith(b"INFO")
        assert {b"INAM", b"ICMT", b"ISFT"} <= set(re.findall(rb"I[A-Z]{3}", info[4:]))


def test_the_loop_is_read_by_libsndfile_and_begins_and_ends_at_zero_crossings(exported):
    for path in exported.paths:
        begin, end = loop_of(path)
        samples, rate = soundfile.read(path)
        with soundfile.SoundFile(path) as file:
            log = file.extra_info
        assert re.search(rf"Start : +{begin} +End : +{end}\b", log)
        assert "should be" not in log
        assert 0 < begin < end < len(samples) - 1
        assert samples[begin - 1] < 0 <= samples[begin]
        assert samples[end] < 0 <= samples[end + 1]
        assert end + 1 - begin == pytest.approx(min(rate, len(samples) / 2), rel=0.25)
        period = struct.unpack("<3I", chunks(path)["smpl"][:12])[2]
        assert period == round(1e9 / rate)


def test_the_silence_at_both_ends_is_gone(exported):
    for path in exported.paths:
        samples, rate = soundfile.read(path)
        loud = np.flatnonzero(np.abs(samples) > np.abs(samples).max() * 0.999e-3)
        assert loud[0] <= 0.005 * rate
        assert len(samples) - loud[-1] <= 0.02 * rate + 2
        assert max(abs(samples[0]), abs(samples[-1])) < 1e-5


def test_the_progress_rises_to_the_end_in_parts_of_the_takes(exported):
    shares = [share for share, _ in exported.stages.reports]
    assert max(shares) == pytest.approx(1.0)
    assert min(shares) < 0.2
    assert all(0 <= share <= 1 for share in shares)
    assert {note[:11] for _, note in exported.stages.reports} == {
        "take 1 of 3",
        "take 2 of 3",
        "take 3 of 3",
    }


def test_the_rate_is_the_one_requested(tmp_path):
    (path,) = export_takes(brief_scene(), 1, 1, 96000, tmp_path)
    about = soundfile.info(path)
    assert (about.samplerate, about.subtype) == (96000, "PCM_24")
    begin, end = loop_of(path)
    assert end - begin == pytest.approx(96000, rel=0.25) or about.duration < 2
    for rate in (44100, 0, float("nan")):
        with pytest.raises(InputError, match="must be 48000 or 96000 for a sound"):
            export_takes(brief_scene(), 1, 1, rate, tmp_path)


def test_the_variations_are_small_and_seed_the_roughness():
    scene = load_scene("glass")
    variations = [varied_scene(scene, 1, number)[0] for number in range(1, 30)]
    steepness = [take.release.inclination_deg / 30.0 for take in variations]
    speed = [take.release.omega[2] / 24.0 for take in variations]
    for ratio in (steepness, speed):
        assert 0.98 <= min(ratio) < 0.99
        assert 1.01 < max(ratio) <= 1.02
    assert len({take.roughness.seed for take in variations}) == len(variations)
    assert varied_scene(scene, 1, 3) == varied_scene(scene, 1, 3)
    assert varied_scene(load_scene("published"), 1, 3)[0].roughness is None
    upright = load_scene("published").replace("release.inclination_deg=89.9")
    assert all(
        varied_scene(upright, 1, n)[0].release.inclination_deg < 90 for n in range(20)
    )


def tone(frequency, seconds, rate=48000):
    """Return a sine with a phase that makes no sample exactly zero."""
    return np.sin(2 * np.pi * frequency * np.arange(int(seconds * rate)) / rate + 0.01)


@pytest.mark.slow
def test_the_last_seconds_of_the_audible_copy_are_written(tmp_path):
    """The file is the end of the sound of audible.wav, with a fade where it is cut; its loudness
    and true peak are those of that copy."""
    sound = solve(brief_scene().replace("numerics.time_limit=3")).sound
    write_take(sound, tmp_path / "whole.wav", "", TakeContent(audible=True))
    write_take(sound, tmp_path / "last.wav", "", TakeContent(1.0, audible=True))
    whole, rate = soundfile.read(tmp_path / "whole.wav")
    last, _ = soundfile.read(tmp_path / "last.wav")
    assert len(last) == rate < len(whole)
    faded = round(0.1 * rate)
    assert np.array_equal(last[faded:], whole[-rate + faded :])
    assert not last[0].any()
    assert np.abs(last[:faded]).max() < np.abs(whole[-rate:][:faded]).max()
    assert true_peak_dbtp(whole) < -1.0
    copy = read_samples(sound.audible, 0, sound.audible.frames)
    assert np.abs(whole).max() == pytest.approx(np.abs(copy).max(), abs=1e-6)
    comment = TinyTag.get(tmp_path / "last.wav").comment
    assert comment.startswith("A-weighted, compressed dynamics, not in pascal")


def test_the_loop_of_a_tone_is_a_whole_number_of_periods():
    begin, end = loop_points(tone(1000, 4.0), 48000)
    assert (end + 1 - begin) % 48 == 0
    assert end + 1 - begin == pytest.approx(48000, rel=0.2)


@pytest.mark.parametrize(
    "samples",
    [np.ones(48000), np.zeros(10), tone(1000, 0.005), np.linspace(-1, 1, 48000)],
)
def test_a_sound_without_two_crossings_has_no_loop(samples):
    assert loop_points(samples, 48000) is None


def test_both_ends_are_faded_and_the_rest_is_kept():
    samples = np.ones((48000, 2))
    apply_fades(samples, 48000)
    assert (samples[0] == 0).all()
    assert (samples[-1] == 0).all()
    assert (samples[240:-960] == 1).all()
    assert (np.diff(samples[:240, 0]) > 0).all()
    short = np.ones((10, 1))
    apply_fades(short, 48000)
    assert np.isfinite(short).all()


def test_the_range_is_that_above_the_level_of_silence():
    samples = np.zeros((48000, 1))
    samples[10_000:20_000] = 1e-3 + 1e-9
    samples[15_000] = 1.0
    source = SimpleNamespace(
        sample_rate=48000, frames=48000, blocks=lambda: iter([samples])
    )
    assert audible_range(source) == (10_000 - 240, 20_000 + 960)
    silent = SimpleNamespace(
        sample_rate=48000, frames=9, blocks=lambda: iter([samples[:9]])
    )
    with pytest.raises(InputError, match="the sound is silent"):
        audible_range(silent)


def test_an_interrupted_export_leaves_whole_takes_only(tmp_path, monkeypatch):
    count = iter(range(9))
    honest = takes_module.render_sound

    def interrupted(*arguments):
        if next(count) == 1:
            raise KeyboardInterrupt
        return honest(*arguments)

    monkeypatch.setattr(takes_module, "render_sound", interrupted)
    path = tmp_path / "brief.toml"
    path.write_text(SCENE_TEXT, "utf-8")
    out = tmp_path / "takes"
    asked = ["export", "sound", str(path), "--takes", "3", "--out", str(out)]
    told = CliRunner().invoke(main, asked)
    assert told.exit_code == 130
    assert told.stderr.splitlines()[-1] == "sonify: interrupted"
    assert [file.name for file in out.iterdir()] == ["brief-01.wav"]
    assert told.stdout.split() == [str(out / "brief-01.wav")]
    assert soundfile.info(out / "brief-01.wav").frames > 1000


def test_an_interrupted_write_leaves_no_file(tmp_path, monkeypatch):
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("sonify.sound.wav._append_chunk", interrupted)
    with pytest.raises(KeyboardInterrupt):
        export_takes(brief_scene(), 1, 1, None, tmp_path / "takes")
    assert list(tmp_path.iterdir()) == []


SCENE_TEXT = """
name = "brief"
disk = { radius = 0.0375, thickness = 0.0125 }
material = { name = "brass" }
friction = { mu_static = 0.5, mu_dynamic = 0.3, arm_rolling = 3e-5, arm_pivoting = 3e-4 }
release = { inclination_deg = 30.0, omega = [0.0, 0.0, -14.0] }
numerics = { accuracy = "draft", time_limit = 0.3 }
air = { film = "none" }
"""


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("sound --takes 0", "Invalid value for '--takes': 0 is not in the range"),
        ("sound --seed -1", "Invalid value for '--seed': -1 is not in the range"),
        ("sound --rate 44100", "--rate = 44100: must be 48000 or 96000 for a sound"),
        ("sound --as gltf", "--as = 'gltf': does not apply to sound"),
        ("sound --strike 3", "--strike = 3.0: does not apply to sound"),
        ("motion --as csv --takes 3", "--takes = 3: does not apply to motion"),
        ("modes --as vtu --seed 3", "--seed = 3: does not apply to modes"),
        ("sound --last 0.1", "--last = 0.1: must be at least 0.5 s"),
        ("sound --last nan", "--last = nan: must be at least 0.5 s"),
        ("motion --as csv --audible", "--audible = True: does not apply to motion"),
        ("sound nowhere", "nowhere: no such scene"),
    ],
)
def test_wrong_arguments_are_one_line(arguments, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert_refused(["export", *arguments.split()], message)
    assert list(tmp_path.iterdir()) == []
