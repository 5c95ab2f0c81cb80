"""Claim: the content of a file, and never its name, determines how a recording is read; its length is
that of the sound; a file that cannot be read has one sentence with the reason and a remedy.

Source: RFC 9639 (FLAC), ISO 11172-3 (MP3), the specifications of CAF and RF64; files as recorders,
phones and pipes write them. Oracle: the samples that were written, or the same sound in a file whose
header is complete; `shlex.split` for commands.
"""

import os
import shlex
import struct
import sys
import threading
import zipfile
from pathlib import Path

import numpy as np
import pytest
import soundfile
from sound_files import DECODER_DELAY, FORMATS, read_mp3, written

from sonify.hearing.audio_source import (
    Recording,
    SoundFile,
    read_samples,
    source_of,
    source_of_file,
)
from sonify.hearing.mp3 import frame_header
from sonify.hearing.recording import RecordingError
from sonify.hearing.recording_errors import conversion_advice
from sonify.hearing.recording_files import recording_files
from sonify.hearing.true_lengths import PatchedFile

RATE = 24_000
FLAC_LENGTHS = (4096, 3 * 4096, 3 * 4096 + 1, 72_000, 100)
"""Numbers of samples; libFLAC writes blocks of 4096 samples."""


def noise(count, channels=1):
    """Return noise (count, channels) in whole steps of 16 bits."""
    random = np.random.default_rng(count)
    return random.integers(-9000, 9000, (count, channels)) / 2**15


def all_samples(path):
    return read_samples(SoundFile(path), 0, 10**12)


def flac_bytes(path, count, channels=1):
    """Write noise as FLAC and return its bytes and the position of the number of samples."""
    soundfile.write(path, noise(count, channels), RATE, format="FLAC", subtype="PCM_16")
    return bytearray(path.read_bytes()), 18


def without_flac_length(data, at):
    """Return the bytes of a FLAC file whose header states 0 samples, as behind a pipe."""
    fields = struct.unpack_from(">Q", data, at)[0]
    struct.pack_into(">Q", data, at, fields >> 36 << 36)
    return bytes(data)


@pytest.mark.parametrize("channels", [1, 2])
@pytest.mark.parametrize("count", FLAC_LENGTHS)
@pytest.mark.parametrize("tag", [b"", b"ID3\x04\0\0\0\0\x01\0" + bytes(128)])
def test_flac_that_states_no_length_has_all_samples(tmp_path, count, channels, tag):
    path = tmp_path / "pipe"
    data, at = flac_bytes(path, count, channels)
    path.write_bytes(tag + without_flac_length(data, at))
    assert soundfile.SoundFile(path).frames != count, "the header states no length"
    found = SoundFile(path)
    assert found.frames == count
    assert found.truncation is None
    assert np.array_equal(all_samples(path), noise(count, channels).astype("f4"))
    middle = read_samples(found, count // 2, count)
    assert np.array_equal(middle, noise(count, channels)[count // 2 :].astype("f4"))


@pytest.mark.parametrize("stated", [0, 72_000, 10**9, 50])
@pytest.mark.parametrize("share", [0.999, 0.5, 0.2])
def test_cut_flac_has_every_complete_block(tmp_path, stated, share):
    """Only the block that was cut is missing, whatever the header states."""
    path = tmp_path / "cut.flac"
    data, at = flac_bytes(path, 72_000)
    fields = struct.unpack_from(">Q", data, at)[0]
    struct.pack_into(">Q", data, at, fields >> 36 << 36 | stated)
    path.write_bytes(data[: int(share * len(data))])
    found = SoundFile(path)
    assert found.frames % 4096 == 0
    assert share * 72_000 - 4096 <= found.frames <= share * 72_000 + 4096
    assert np.array_equal(
        all_samples(path)[:, 0], noise(72_000)[: found.frames, 0].astype("f4")
    )
    if stated < found.frames:
        assert found.truncation is None, "the header does not show it"
    else:
        assert found.truncation.held == found.frames / RATE
        assert found.truncation.announced == stated / RATE


def test_flac_without_a_block_has_no_samples(tmp_path):
    path = tmp_path / "empty.flac"
    data, _ = flac_bytes(path, 4096)
    path.write_bytes(data[: data.index(b"\xff\xf8")])
    assert SoundFile(path).frames == 0


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    [
        "take",
        "take.wav",
        "take.mp3",
        "take.xyz",
        "take.raw",
        "take.flac",
        "take.txt",
        "take.au",
    ],
)
@pytest.mark.parametrize("kind", FORMATS)
def test_the_name_of_a_file_does_not_change_what_is_read(tmp_path, kind, name):
    right = tmp_path / f"right.{kind}"
    data = written(right)
    wrong = tmp_path / name
    wrong.write_bytes(data)
    assert np.array_equal(all_samples(wrong), all_samples(right))
    assert SoundFile(wrong).truncation is None


@pytest.mark.parametrize("name", ["take.mpga", "take.wav", "take"])
@pytest.mark.parametrize("kind", ["constant.mp3", "variable.mp3"])
def test_mp3_without_a_length_is_read_whole_under_any_name(tmp_path, kind, name):
    """Bytes before the first frame, as in a stream that was joined, do not matter."""
    path = tmp_path / kind
    data = written(path)
    bare = data[frame_header(data, 0).length :]
    frames = read_mp3(path).frames
    for before in (
        b"",
        bytes(5000),
        b"ID3\x03\0\0\0\0\0\x10" + bytes(16),
        bare[200:300],
    ):
        other = tmp_path / name
        other.write_bytes(before + bare)
        found = SoundFile(other)
        assert found.frames == frames * 1152 - DECODER_DELAY
        assert len(all_samples(other)) == found.frames
        assert found.truncation is None


def test_mp3_in_a_wav_file_is_read_whole(tmp_path):
    data = written(tmp_path / "variable.mp3")
    bare = data[frame_header(data, 0).length :]
    layout = struct.pack(
        "<HHIIHHHHIHHH", 0x55, 1, 48_000, 8000, 1, 0, 12, 1, 2, 1, 1, 1393
    )
    chunks = b"fmt " + struct.pack("<I", len(layout)) + layout
    chunks += b"data" + struct.pack("<I", len(bare)) + bare
    path = tmp_path / "sound.wav"
    path.write_bytes(b"RIFF" + struct.pack("<I", 4 + len(chunks)) + b"WAVE" + chunks)
    frames = read_mp3(tmp_path / "variable.mp3").frames
    assert soundfile.info(path).subtype == "MPEG_LAYER_III"
    assert SoundFile(path).frames == frames * 1152 - DECODER_DELAY


def caf_of_unknown_length(path):
    soundfile.write(path, noise(RATE), RATE, format="CAF", subtype="PCM_16")
    data = bytearray(path.read_bytes())
    at = data.index(b"data") + 4
    length = struct.unpack_from(">Q", data, at)[0]
    struct.pack_into(">q", data, at, -1)
    return bytes(data[: at + 8 + length])


def rf64_of_unknown_length(path, size):
    soundfile.write(path, noise(RATE), RATE, format="RF64", subtype="PCM_16")
    samples = path.read_bytes()[-2 * RATE :]
    sizes = b"ds64" + struct.pack("<IQQQI", 28, size, size, size, 0)
    form = b"fmt " + struct.pack("<IHHIIHH", 16, 1, 1, RATE, 2 * RATE, 2, 16)
    head = b"RF64\xff\xff\xff\xffWAVE" + sizes + form
    return head + b"data\xff\xff\xff\xff" + samples


def wav_with_size(path, size):
    soundfile.write(path, noise(RATE), RATE, format="WAV", subtype="PCM_16")
    data = bytearray(path.read_bytes())
    at = data.index(b"data") + 4
    struct.pack_into("<I", data, at, size)
    struct.pack_into("<I", data, 4, min(size + at - 4, 2**32 - 1))
    return bytes(data)


@pytest.mark.parametrize(
    "content",
    [
        caf_of_unknown_length,
        lambda path: rf64_of_unknown_length(path, 0),
        lambda path: rf64_of_unknown_length(path, 2**64 - 1),
        lambda path: wav_with_size(path, 2**32 - 1),
        lambda path: wav_with_size(path, 2**31 - 1),
        lambda path: wav_with_size(path, 0),
        lambda path: wav_with_size(path, 0)[:4] + bytes(4) + wav_with_size(path, 0)[8:],
    ],
    ids=[
        "caf",
        "rf64 of 0",
        "rf64 of -1",
        "wav of -1",
        "wav of 2 GB",
        "wav of 0",
        "wav without any size",
    ],
)
def test_what_a_pipe_or_a_crash_left_without_a_length_is_read_whole(tmp_path, content):
    path = tmp_path / "sound"
    path.write_bytes(content(path))
    found = SoundFile(path)
    assert found.frames == RATE
    assert np.array_equal(all_samples(path), noise(RATE).astype("f4"))
    assert found.truncation is None


def test_sound_that_cannot_be_sought_is_read_from_any_sample(tmp_path):
    """GSM 6.10, the format of old voice recorders, has no seek function in libsndfile."""
    path = tmp_path / "voice.wav"
    soundfile.write(path, 0.2 * np.sin(np.arange(16_000) / 9), 8000, "GSM610")
    whole = all_samples(path)
    assert len(whole) >= 16_000
    assert np.array_equal(read_samples(SoundFile(path), 9000, 9500), whole[9000:9500])


@pytest.mark.skipif(
    sys.platform == "win32", reason="Windows has no named pipes in folders"
)
@pytest.mark.parametrize("kind", ["wav", "flac", "constant.mp3", "ogg"])
def test_a_pipe_is_read_once_and_used_many_times(tmp_path, kind):
    right = tmp_path / f"right.{kind}"
    data = written(right)
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    writer = threading.Thread(target=pipe.write_bytes, args=(data,))
    writer.start()
    source = source_of(pipe)
    for _ in range(2):
        assert np.array_equal(read_samples(source, 0, 10**12), all_samples(right))
    writer.join()
    assert source.truncation is None


def test_patched_bytes_replace_those_of_the_file(tmp_path):
    """Reads of any length at any position show the replaced bytes."""
    path = tmp_path / "bytes"
    path.write_bytes(bytes(range(60)))
    expected = bytearray(range(60))
    expected[10:14] = b"abcd"
    expected[58:60] = b"yz"
    with path.open("rb") as file:
        patched = PatchedFile(file, {10: b"abcd", 58: b"yz"})
        for start in range(60):
            for count in (1, 2, 3, 7, 60):
                assert patched.seek(start) == start
                assert patched.read(count) == expected[start : start + count]
        assert patched.seek(-5, os.SEEK_CUR) == 55
        assert patched.seek(-100, os.SEEK_CUR) == 55, "as lseek, which refuses"
        assert patched.seek(-60, os.SEEK_END) == 0
        assert patched.tell() == 0


CONTAINERS = {
    "m4a": b"\0\0\0\x1cftypM4A \0\0\0\0M4A mp42isom",
    "mp4": b"\0\0\0\x20ftypisom\0\0\2\0isomiso2mp41",
    "mov": b"\0\0\0\x14ftypqt  \0\0\2\0qt  ",
    "old mov": b"\0\0\0\x08wide\0\0\x10\0mdat",
    "3gp": b"\0\0\0\x18ftyp3gp4\0\0\2\0",
    "webm": b"\x1a\x45\xdf\xa3\x9f\x42\x86\x81\x01",
    "wma": bytes.fromhex("3026b2758e66cf11a6d900aa0062ce6c"),
    "amr": b"#!AMR\n\x3c\x91\x17",
    "amr-wb": b"#!AMR-WB\n\x24\x91",
    "aac": b"\xff\xf1\x50\x80\x02\x1f\xfc",
    "ac3": b"\x0b\x77\x4e\x1e\x10\x40",
    "avi": b"RIFF\x10\0\0\0AVI LIST",
    "flv": b"FLV\x01\x05\0\0\0\x09",
    "mpg": b"\0\0\x01\xba\x44\0\x04",
    "ts": (b"G" + bytes([1] * 187)) * 3,
    "ape": b"MAC \x96\x0f\0\0",
    "wv": b"wvpk\x12\x34\0\0",
    "speex": b"OggS\0\2" + bytes(20) + b"\1\x50Speex   1.2",
}
"""First bytes of containers that libsndfile does not read."""


@pytest.mark.parametrize("suffix", [".m4a", "", ".wav", ".au", ".vox", ".mp3"])
@pytest.mark.parametrize("kind", CONTAINERS)
def test_a_container_is_recognised_by_content_and_its_conversion_suggested(
    tmp_path, monkeypatch, kind, suffix
):
    monkeypatch.chdir(tmp_path)
    name = f"New  Recording 5's{suffix}"
    Path(name).write_bytes(CONTAINERS[kind] + bytes(range(1, 256)) * 20)
    with pytest.raises(RecordingError, match="convert it first") as refused:
        source_of(name)
    message = str(refused.value)
    assert message.startswith(f"{name}: not a readable sound file: ")
    target = (
        "New  Recording 5's_converted.wav"
        if suffix == ".wav"
        else "New  Recording 5's.wav"
    )
    command = message.partition("e.g. ")[2]
    assert shlex.split(command) == ["ffmpeg", "-i", name, target]


def test_the_command_names_the_path_as_given():
    """ffmpeg takes `-a` for an option and `12:30` for an address."""
    for given, source in {
        "takes/New Recording 5.m4a": "takes/New Recording 5.m4a",
        "./a.m4a": "./a.m4a",
        "../a.b/c": "../a.b/c",
        "-a.m4a": "./-a.m4a",
        "12:30.m4a": "./12:30.m4a",
        '$HOME `a` "b".m4a': '$HOME `a` "b".m4a',
    }.items():
        words = shlex.split(conversion_advice(given).partition("e.g. ")[2])
        assert words[:3] == ["ffmpeg", "-i", source]
        assert words[3] == source.removesuffix(".m4a") + ".wav"


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"", "the file is empty"),
        (b"\x89PNG\r\n\x1a\n" + bytes(range(256)), "if it contains sound, convert it"),
        (b"This is not a sound.", "neither sound nor a table with a column 'Time"),
        (b"RIFF\x24\0\0\0WAVEfmt ", "convert it first"),
    ],
)
def test_other_files_have_their_reason(tmp_path, content, reason):
    path = tmp_path / "take.wav"
    path.write_bytes(content)
    with pytest.raises(RecordingError, match=reason) as refused:
        source_of(path)
    assert str(refused.value).startswith(f"{path}: not a readable sound file: ")
    assert "\n" not in str(refused.value)


def takes_and_others(folder):
    """Fill a folder with recordings under right and wrong names, and with other files."""
    soundfile.write(folder / "b.wav", noise(RATE), RATE, "PCM_16")
    data, _ = flac_bytes(folder / "take without suffix", 5000)
    (folder / "c.txt").write_bytes(data)
    rows = "".join(f"{k / 8000}\t{k % 7}\n" for k in range(500))
    (folder / "a.tsv").write_text("Time (s)\tRecording (a.u.)\n" + rows)
    with zipfile.ZipFile(folder / "d", "w") as archive:
        archive.writestr("Raw data.csv", "Time (s)\tRecording (a.u.)\n" + rows)
    (folder / "New Recording 5.m4a").write_bytes(CONTAINERS["m4a"] + bytes(50))
    (folder / "voice.wav").write_bytes(CONTAINERS["amr"] + bytes(50))
    with zipfile.ZipFile(folder / "take.xlsx", "w") as archive:
        archive.writestr("xl/workbook.xml", "<workbook/>")
    (folder / "notes.txt").write_text("the free disk")  # `free` as in a container
    (folder / "other.csv").write_text("a,b\n1,2\n")
    (folder / "empty.wav").touch()
    (folder / "inner").mkdir()


def test_a_folder_has_its_recordings_by_content_and_the_rest_is_said(tmp_path):
    takes_and_others(tmp_path)
    said = []
    found = recording_files([tmp_path], said.append)
    names = ["a.tsv", "b.wav", "c.txt", "d", "take without suffix"]
    assert [path.name for path in found] == names
    *advice, others = said
    assert [line.partition(": skipped; ")[0] for line in advice] == [
        str(tmp_path / name)
        for name in ("New Recording 5.m4a", "take.xlsx", "voice.wav")
    ]
    assert "ffmpeg" in advice[0]
    assert "CSV" in advice[1]
    assert "voice_converted.wav" in advice[2]
    assert others.startswith(f"{tmp_path}: skipped, no recordings: ")
    listed = others.partition("recordings: ")[2].split(", ")
    assert listed == ["empty.wav", "inner (a folder)", "notes.txt", "other.csv"]
    for path in found:
        kind = Recording if path.name in ("a.tsv", "d") else SoundFile
        assert isinstance(source_of_file(path), kind)


def test_a_folder_without_recordings_says_what_is_in_it(tmp_path):
    (tmp_path / "New Recording 5.m4a").write_bytes(CONTAINERS["m4a"])
    with pytest.raises(RecordingError, match="a folder without recordings") as refused:
        recording_files([tmp_path])
    assert "New Recording 5.m4a: skipped; convert it first, e.g. ffmpeg" in str(
        refused.value
    )
    with pytest.raises(RecordingError, match="No such file"):
        recording_files([tmp_path / "absent.wav"])
