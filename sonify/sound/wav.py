"""Write pressure and stems in pascal as 32-bit float WAV files, and copies for
listening."""

import errno
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from io import SEEK_END
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import soundfile

from sonify import __version__
from sonify.runtime.files import atomic_write, path_for_libsndfile
from sonify.runtime.progress import Watch, ignore_progress
from sonify.sound.pressure import Sound, SummedTrack, Track

if TYPE_CHECKING:
    from sonify.sound.mastering import MasteredTrack
    from sonify.sound.playback import ScaledTrack

UNFINISHED_MOTION_COMMENT = (
    "; the motion did not come to rest, and its end is missing: {}"
)
AUDIBLE_SCALE_TEXT = (
    "A-weighted and amplified for small loudspeakers, not the pressure; "
    "1.0 = {:.6g} pascal, A-weighted"
)
MASTER_SCALE_TEXT = (
    "A-weighted, with compressed dynamics, for small loudspeakers, not the pressure; "
    "1.0 = {:.6g} pascal, A-weighted, where neither compressor nor limiter acts"
)

MAX_RIFF_BYTES = 2**32 - 2**12
"""Maximum size of the samples [bytes] in a WAV file; larger files use RF64 (EBU Tech
3306), which has 64-bit lengths."""
BYTES_PER_SAMPLE = {"FLOAT": 4, "PCM_24": 3, "PCM_16": 2}


class WavFile(NamedTuple):
    """A file of a sound: its path, samples, subtype of libsndfile, and comment."""

    path: Path
    source: "Track | SummedTrack | ScaledTrack | MasteredTrack"
    subtype: str
    comment: str


def write_sound(
    sound: Sound,
    folder: str | Path,
    watch: Watch = ignore_progress,
) -> None:
    """Write sound.wav, pressure.wav, stems/*.wav [Pa] and audible.wav into `folder`.

    The comment of each file states the pressure represented by 1.0 and, if the motion
    did not come to rest, that the end is missing. The memory required does not depend
    on the duration. `watch(fraction)` is called with the completed fraction. Raises
    OSError if the disk is full."""
    write_listening_copy(sound, folder)
    write_other_sounds(sound, folder, watch)


def write_listening_copy(sound: Sound, folder: str | Path) -> Path:
    """Write sound.wav into `folder` and return its path; see `write_sound`."""
    path = Path(folder) / "sound.wav"
    comment = f"1.0 = {sound.full_scale:.6g} pascal, {sound.gain_db:.2f} dB"
    _write_files(sound, [WavFile(path, sound.playback_copy, "PCM_24", comment)])
    return path


def write_other_sounds(
    sound: Sound, folder: str | Path, watch: Watch = ignore_progress
) -> None:
    """Write all files of `write_sound` except sound.wav.

    Stems of an earlier run that would no longer add up to the pressure are removed.
    """
    folder = Path(folder)
    for name in {*sound.names, "rest"} - sound.stem_files.keys():
        (folder / "stems" / f"{name}.wav").unlink(missing_ok=True)
    pascal = "1.0 = 1 pascal at the listener"
    amplified = AUDIBLE_SCALE_TEXT if sound.dynamics == "natural" else MASTER_SCALE_TEXT
    files = [
        WavFile(folder / "pressure.wav", sound.pressure, "FLOAT", pascal),
        *(
            WavFile(folder / "stems" / f"{name}.wav", stem, "FLOAT", pascal)
            for name, stem in sound.stem_files.items()
        ),
        WavFile(
            folder / "audible.wav",
            sound.audible,
            "PCM_16",  # its noise is 80 dB below the loudness of the master
            amplified.format(sound.audible.full_scale),
        ),
    ]
    _write_files(sound, files, watch)


def _write_files(
    sound: Sound, files: list[WavFile], watch: Watch = ignore_progress
) -> None:
    """Write WavFiles; all of them appear once the last one is complete."""
    unfinished = (
        ""
        if sound.outcome.is_rest
        else UNFINISHED_MOTION_COMMENT.format(sound.outcome.sentence)
    )
    with ExitStack() as stack:
        for i, (path, source, subtype, comment) in enumerate(files):
            size = source.frames * source.channels * BYTES_PER_SAMPLE[subtype]
            form = "RF64" if size > MAX_RIFF_BYTES else "WAV"
            file = stack.enter_context(
                open_wav(path, source.sample_rate, source.channels, subtype, form)
            )
            file.title = f"Euler's disk, {sound.name}: {path.stem.replace('_', ' ')}"
            file.comment = comment + unfinished
            file.software = f"eulers-disk-sonify {__version__}"
            for block in source.blocks():
                file.write(rounded(block, subtype))
                watch((i + file.frames / source.frames) / len(files))


def rounded(samples: np.ndarray, subtype: str) -> np.ndarray:
    """Return samples rounded to the integers of a subtype, which libsndfile would round
    downwards."""
    if subtype == "FLOAT":
        return samples
    steps = 2 ** (8 * BYTES_PER_SAMPLE[subtype] - 1)
    return np.rint(samples * steps) / steps


@contextmanager
def open_wav(
    path: Path, rate: int, channels: int, subtype: str, form: str, chunk: bytes = b""
) -> Iterator[soundfile.SoundFile]:
    """Open a WAV file for writing.

    The file appears only when complete, and identical samples give identical bytes.

    `chunk` is appended as the last chunk of the file, which must not be RF64."""
    with atomic_write(path) as temporary:
        try:
            name = path_for_libsndfile(temporary)
            with soundfile.SoundFile(
                name, "w", rate, channels, subtype, format=form
            ) as file:
                yield file
        except (
            AssertionError,
            soundfile.LibsndfileError,
        ) as error:  # libsndfile reports a full disk only as a short write
            raise OSError(
                errno.ENOSPC, "could not be written in full", str(path)
            ) from error
        _clear_timestamp(temporary)
        if chunk:
            _append_chunk(temporary, chunk)


def _clear_timestamp(path: Path) -> None:
    """Clear the time stamp that libsndfile writes into the PEAK chunk of float
    files."""
    with open(path, "r+b") as file:
        stamp = file.read(4096).find(b"PEAK")
        if stamp >= 0:
            file.seek(stamp + 12)
            file.write(bytes(4))


def _append_chunk(path: Path, chunk: bytes) -> None:
    """Append a chunk of even length to a RIFF file and correct the length in its
    header."""
    with open(path, "r+b") as file:
        end = file.seek(0, SEEK_END)
        file.write(b"\0" * (end % 2) + chunk)
        length = file.tell() - 8
        file.seek(4)
        file.write(length.to_bytes(4, "little"))
