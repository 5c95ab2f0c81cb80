"""Claim: from a truncated sound file exactly the available sound is decoded, and one line states
its duration.

Source: ISO 11172-3 and 13818-3 (MP3 frames), the header of Xing and LAME, RFC 3533 (Ogg),
libsndfile's notes on WAV. Oracle: the samples of the whole file, decoded before truncation; the
fraction of bytes kept.
"""

import json
from io import BytesIO

import numpy as np
import pytest
import soundfile
from click.testing import CliRunner
from disk_recordings import recording
from scenes import bare_toy
from sound_files import DECODER_DELAY, FORMATS, LENGTH, read_mp3, written

from sonify.__main__ import main
from sonify.fitting.decay_model import DecayModel
from sonify.hearing.audio_source import SoundFile, ends_with_last_page, read_samples
from sonify.hearing.mp3 import frame_header
from sonify.hearing.recording import listen


@pytest.mark.parametrize("kind", FORMATS)
@pytest.mark.parametrize("share", [0.35, 0.8])
def test_a_cut_file_has_the_samples_that_are_there(tmp_path, kind, share):
    path = tmp_path / f"sound.{kind}"
    data = written(path)
    whole = SoundFile(path)
    assert whole.truncation is None
    assert whole.frames == pytest.approx(LENGTH * 48_000, abs=1)
    true = read_samples(whole, 0, whole.frames)
    path.write_bytes(data[: int(share * len(data))])
    cut = SoundFile(path)
    samples = read_samples(cut, 0, 10**9)
    assert len(samples) == cut.frames
    held = cut.frames / 48_000
    assert held == pytest.approx(
        share * LENGTH, abs=1.1 if kind in ("ogg", "opus") else 0.15
    ), "pages last a second"
    beyond = 2000  # the last frame of a lossy file fades into the next
    assert np.abs(samples[:-beyond] - true[: len(samples) - beyond]).max() < 1e-4
    assert cut.truncation.held == held
    if kind in ("ogg", "opus"):
        assert cut.truncation.announced is None
        assert str(cut.truncation).endswith(
            "s of sound, and the header states no length"
        )
    else:
        assert cut.truncation.announced == pytest.approx(LENGTH, abs=0.03)
    later = read_samples(cut, 20_000, 21_000)
    assert np.array_equal(later, samples[20_000:21_000])


@pytest.mark.parametrize("kind", ["constant.mp3", "variable.mp3"])
@pytest.mark.parametrize(("rate", "channels"), [(48_000, 1), (44_100, 2), (22_050, 1)])
def test_an_mp3_file_without_a_header_is_as_long_as_its_frames(
    tmp_path, kind, rate, channels
):
    """libsndfile derives the length from the bit rate of the first frame and reads no further."""
    path = tmp_path / kind
    data = written(path, rate, channels)
    assert read_mp3(path).frames == read_mp3(path).announced
    bare = data[frame_header(data, 0).length :]
    samples = frame_header(bare, 0).samples
    for share in (1.0, 0.4):
        path.write_bytes(bare[: int(share * len(bare))])
        found = SoundFile(path)
        assert (found.truncation, read_mp3(path).announced) == (None, None)
        assert found.frames == read_mp3(path).frames * samples - DECODER_DELAY
        assert found.frames / rate == pytest.approx(share * LENGTH, abs=0.15)
        assert len(read_samples(found, 0, 10**9)) == found.frames


def test_a_tag_before_the_first_frame_and_what_is_no_frame_are_left_out(tmp_path):
    path = tmp_path / "constant.mp3"
    data = written(path)
    frames = read_mp3(path).frames
    tag = b"ID3\x04\0\0" + bytes([0, 0, 2, 0]) + b"\xff\xfb" * 128
    path.write_bytes(tag + data + b"TAG" + b"\xff" * 125)
    assert (read_mp3(path).frames, read_mp3(path).announced) == (frames, frames)
    path.write_bytes(b"RIFF" + bytes(100))
    assert read_mp3(path) is None


def test_an_ogg_file_ends_with_a_whole_last_page(tmp_path):
    path = tmp_path / "sound.ogg"
    data = written(path)
    assert ends_with_last_page(BytesIO(data))
    for end in (len(data) - 1, data.rfind(b"OggS"), 20):
        assert not ends_with_last_page(BytesIO(data[:end]))


@pytest.mark.slow
def test_listen_says_in_one_line_how_much_is_there(tmp_path):
    """The reported tone and end are those of the available part."""
    path = tmp_path / "variable.mp3"
    data = written(path)
    path.write_bytes(data[: int(0.35 * len(data))])
    held = SoundFile(path).frames / 48_000
    asked = CliRunner().invoke(
        main, ["listen", str(path), "--out", str(tmp_path / "out")]
    )
    assert asked.exit_code == 0, asked.output
    (line,) = asked.stderr.splitlines()
    assert line.startswith(
        f"{path}: the file is truncated: it contains {held:.3f} s of sound, "
    )
    assert "states 8.0" in line
    told = json.loads((tmp_path / "out" / "heard.json").read_text())
    assert told["duration"] == told["truncation"]["held"] == held
    assert told["truncation"]["announced"] == pytest.approx(LENGTH, abs=0.03)
    assert told["missing"] == pytest.approx(LENGTH - held, abs=0.03)
    (carrier,) = [c for c in told["carriers"] if c["level"] > 20]
    assert carrier["frequency"] == pytest.approx(900, abs=1)
    assert carrier["end"] <= held
    path.write_bytes(data)
    assert listen(path).truncation is None


@pytest.mark.slow
def test_fit_takes_only_what_is_there(tmp_path):
    """A disk comes to rest at 8 s; the rest is noise, and its last part is truncated."""
    rate = 16_000
    take = recording(
        DecayModel(bare_toy()),
        [1e-4, 0, 0],
        noise=0.3,
        rate=rate,
        end=8.0,
        duration=16.0,
    )
    path = tmp_path / "constant.mp3"
    soundfile.write(path, take, rate, **FORMATS["constant.mp3"])
    data = path.read_bytes()
    path.write_bytes(data[: int(0.6 * len(data))])
    held = SoundFile(path).frames / rate
    assert held == pytest.approx(0.6 * 16, abs=0.15)
    asked = CliRunner().invoke(main, ["fit", str(path), "--out", str(tmp_path / "out")])
    assert asked.exit_code == 0, asked.output
    lines = [line for line in asked.stderr.splitlines() if "truncated" in line]
    assert len(lines) == 1
    assert f"it contains {held:.3f} s of sound, and the header states 16.0" in lines[0]
    told = json.loads((tmp_path / "out" / "fit.json").read_text())["files"][0]
    assert told["truncation"]["held"] == held
    assert told["truncation"]["announced"] == pytest.approx(16, abs=0.1)
    assert told["t_end"]["value"] == pytest.approx(8.0, abs=0.03)
