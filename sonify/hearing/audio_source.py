"""Audio sources: samples that can be read repeatedly, in blocks and from any
position."""

import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cached_property
from io import SEEK_END, BytesIO
from pathlib import Path
from typing import BinaryIO, Protocol

import numpy as np
import soundfile

from sonify.hearing.mp3 import Mp3, mp3_frames
from sonify.hearing.phyphox import may_contain_table, read_table
from sonify.hearing.recording_errors import (
    conversion_advice,
    is_container,
    unreadable,
)
from sonify.hearing.true_lengths import (
    FlacHeader,
    PatchedFile,
    flac_header,
    largest_flac_length,
    patched_sizes,
)
from sonify.scene_errors import InputError

LENGTH_MISMATCH_NOTE = re.compile(
    r"(?:data|SSND|Data Size) *: *(\d+) \(should be (\d+)\)"
)
"""Note of libsndfile on WAV, AIFF and AU files whose length differs from that in their
header [bytes]."""
BLOCK_SIZE = 1 << 16
"""Number of samples read from a file at a time."""
UNRECOGNISED_FORMAT = 1
"""Code of the error of libsndfile for a file of unknown format."""


class AudioSource(Protocol):
    """An audio source with `frames` samples at `sample_rate` [Hz].

    Each call of `blocks` is independent; a caller may stop reading at any time.
    """

    @property
    def sample_rate(self) -> int: ...

    @property
    def frames(self) -> int: ...

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Yield the samples from number `start` on in blocks (k, channels) of any
        length."""
        ...


@dataclass(frozen=True)
class Truncation:
    """Actual length [s] of a truncated file, and the length in its header [s] (None if
    the header states none)."""

    held: float
    announced: float | None

    def __str__(self) -> str:
        announced = (
            "the header states no length"
            if self.announced is None
            else f"the header states {self.announced:.3f} s"
        )
        return f"the file is truncated: it contains {self.held:.3f} s of sound, and {announced}"


@dataclass(frozen=True, kw_only=True, eq=False)
class Recording:
    """Audio source from samples (n,) in memory."""

    samples: np.ndarray
    sample_rate: int
    name: str = "the sound"

    @property
    def frames(self) -> int:
        """Number of samples."""
        return len(self.samples)

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Yield blocks (k, 1) of samples, beginning with sample number `start`."""
        for first in range(start, self.frames, BLOCK_SIZE):
            yield self.samples[first : first + BLOCK_SIZE, None]


@dataclass(frozen=True)
class SoundFile:
    """Source in a file of any format that libsndfile reads.

    The content of the file determines its format, and its name does not. In a truncated
    file, only the decodable samples are used. Raises soundfile.LibsndfileError for other
    files."""

    path: str | Path

    @cached_property
    def _pipe_content(self) -> bytes | None:
        """Content of a pipe, which can be read only once; None for other files."""
        path = Path(self.path)
        return path.read_bytes() if path.is_fifo() else None

    def stream(self) -> BinaryIO:
        """Return the open binary file. Raises OSError if it is unreadable."""
        return (
            open(self.path, "rb")
            if self._pipe_content is None
            else BytesIO(self._pipe_content)
        )

    @cached_property
    def _mp3_frames(self) -> Mp3 | None:
        """Frames of an MP3 file, or of MP3 in a WAV file; None for other files.

        libsndfile opens a file first, unless it begins like an MP3 file."""
        with self.stream() as file:
            head = file.read(3)
            if head != b"ID3" and not (head[:1] == b"\xff" and head[1:2] >= b"\xe0"):
                try:
                    with soundfile.SoundFile(PatchedFile(file, {})) as known:
                        if known.subtype != "MPEG_LAYER_III":
                            return None
                except soundfile.LibsndfileError as error:
                    if error.code != UNRECOGNISED_FORMAT or is_container(self.head):
                        return None
            return mp3_frames(file)

    @cached_property
    def head(self) -> bytes:
        """First 4096 bytes of the file."""
        with self.stream() as file:
            return file.read(4096)

    @cached_property
    def _flac(self) -> FlacHeader | None:
        with self.stream() as file:
            return flac_header(file)

    @cached_property
    def _replaced_header_bytes(self) -> dict[int, bytes]:
        """Replaced bytes of the header of the file, by position."""
        flac = self._flac
        if flac is None:
            with self.stream() as file:
                return patched_sizes(file)

        def is_decodable(count: int) -> bool:
            """Return True if sample number `count`, from 1, can be decoded."""
            with (
                suppress(soundfile.LibsndfileError),
                self._open_patched(flac.patch(count)) as sound,
            ):
                sound.seek(max(count - 1, 0))
                return len(sound.read(1)) == 1
            return False

        if is_decodable(flac.announced) and not is_decodable(flac.announced + 1):
            return {}
        return flac.patch(largest_flac_length(is_decodable))

    @contextmanager
    def _open_patched(
        self, replaced: dict[int, bytes]
    ) -> Iterator[soundfile.SoundFile]:
        """Yield the open sound in the file with some bytes replaced."""
        with self.stream() as file:
            content = PatchedFile(file, replaced)
            with soundfile.SoundFile(content) as sound:
                yield sound

    @contextmanager
    def open(self) -> Iterator[soundfile.SoundFile]:
        """Yield the open sound; a missing or incorrect length in its header is
        replaced."""
        if self._mp3_frames is None or self._mp3_frames.content is None:
            with self._open_patched(self._replaced_header_bytes) as sound:
                yield sound
            return
        with soundfile.SoundFile(BytesIO(self._mp3_frames.content)) as sound:
            yield sound

    @cached_property
    def _header(self) -> tuple[int, int, str, str]:
        with self.open() as file:
            return file.samplerate, file.frames, file.format, file.extra_info

    @property
    def sample_rate(self) -> int:
        """Samples per second [Hz]."""
        return self._header[0]

    @cached_property
    def frames(self) -> int:
        """Number of decodable samples in each channel."""
        search_block_size = 1 << 10  # samples
        announced = self._header[1]
        with suppress(soundfile.LibsndfileError), self.open() as file:
            file.seek(max(announced - 1, 0))
            if not announced or len(file.read(1)):
                return announced
        with self.open() as file:
            held = 0
            with suppress(soundfile.LibsndfileError):  # end of the decodable samples
                while part := len(file.read(search_block_size)):
                    held += part
        return held

    @cached_property
    def truncation(self) -> Truncation | None:
        """Truncation of the file; None if its format does not show that it is
        truncated."""
        unknown_length = 0x7FFF0000  # bytes, in the header of a stream
        rate, announced, kind, notes = self._header
        held = self.frames / rate
        if self._mp3_frames is not None:
            missing = self._mp3_frames.missing_frames * self._mp3_frames.samples / rate
            return Truncation(held, held + missing) if missing else None
        if kind == "OGG":
            with self.stream() as file:
                return None if ends_with_last_page(file) else Truncation(held, None)
        if self._flac is not None:
            announced = self._flac.announced
        if self.frames < announced:
            return Truncation(held, announced / rate)
        noted = LENGTH_MISMATCH_NOTE.search(notes)
        announced_bytes, actual_bytes = map(int, noted.groups()) if noted else (0, 0)
        return (
            Truncation(held, held * announced_bytes / actual_bytes)
            if 0 < actual_bytes < announced_bytes < unknown_length
            else None
        )

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Yield the samples from number `start` on in float32 blocks (k, channels).

        Raises RecordingError if a part cannot be decoded."""
        left = self.frames - start
        with self.open() as file:
            if start:
                _seek_or_read_to(file, min(start, self.frames))
            while left > 0:
                count = min(BLOCK_SIZE, left)
                try:
                    block = file.read(count, dtype="float32", always_2d=True)
                except soundfile.LibsndfileError as error:
                    raise unreadable(self.path, error.error_string) from None
                left -= len(block)
                yield block
                if not len(block):
                    break


def _seek_or_read_to(file: soundfile.SoundFile, start: int) -> None:
    """Move from the start of a sound to a sample; read up to it if it is not seekable."""
    if file.seekable():
        file.seek(start)
        return
    while start > 0 and (count := len(file.read(min(start, BLOCK_SIZE)))):
        start -= count


def ends_with_last_page(file: BinaryIO) -> bool:
    """Return True if the last page of an open Ogg file is complete and marked as the end
    (RFC 3533)."""
    max_page_length = 65_307  # bytes
    size = file.seek(0, SEEK_END)
    file.seek(max(size - 2 * max_page_length, 0))
    tail = file.read()
    at = tail.rfind(b"OggS")
    if at < 0 or at + 27 > len(tail):
        return False
    lengths = tail[at + 27 : at + 27 + tail[at + 26]]
    whole = at + 27 + tail[at + 26] + sum(lengths) <= len(tail)
    return whole and bool(tail[at + 5] & 4)


def source_of(sound: AudioSource | str | Path) -> AudioSource:
    """Return `sound` itself if it is a source, otherwise the source in the file at this
    path.

    Raises RecordingError if the file contains neither sound nor a table of amplitude
    against time."""
    return source_of_file(sound) if isinstance(sound, (str, Path)) else sound


def source_of_file(path: str | Path) -> SoundFile | Recording:
    """Return the sound in a file, or the table of amplitude against time, as determined
    by its content.

    Raises RecordingError with the reason, and with what helps, for other files."""
    sound = SoundFile(path)
    try:
        with sound.open():
            return sound
    except soundfile.LibsndfileError as error:
        fault = error
    except OSError as error:
        raise unreadable(path, error.strerror or str(error)) from None
    if may_contain_table(sound.head):
        with sound.stream() as file:
            table = read_table(file, path)
        return Recording(
            samples=table.samples, sample_rate=table.sample_rate, name=str(path)
        )
    if not sound.head:
        raise unreadable(path, "the file is empty")
    advice = conversion_advice(path)
    if is_container(sound.head):
        raise unreadable(path, advice)
    reason = " ".join(fault.error_string.split()).removesuffix(".")
    if fault.code == UNRECOGNISED_FORMAT:
        advice = f"if it contains sound, {advice}"
    raise unreadable(path, f"{reason}; {advice}")


@dataclass(frozen=True)
class Excerpt:
    """Part of a source from frame `first` up to frame `last`, as a source."""

    source: AudioSource
    first: int
    last: int

    @property
    def sample_rate(self) -> int:
        """Samples per second [Hz]."""
        return self.source.sample_rate

    @property
    def frames(self) -> int:
        """Number of samples in each channel."""
        return self.last - self.first

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Yield the samples from number `start` on in blocks (k, channels)."""
        left = self.frames - start
        if left <= 0:
            return
        for block in self.source.blocks(self.first + start):
            yield block[:left]
            left -= len(block)
            if left <= 0:
                return


def excerpt(source: AudioSource, begin: float, end: float) -> AudioSource:
    """Return the part of a source between two times [s], or the source itself if they
    include all of it.

    Raises InputError if the part is outside the sound or ends before it starts."""
    rate = source.sample_rate
    duration = source.frames / rate
    if not begin < duration:
        raise InputError(
            f"--from = {begin:g}: must be less than the duration of the sound, "
            f"{duration:g} s"
        )
    if not end > begin:
        raise InputError(f"--to = {end:g}: must be greater than --from = {begin:g}")
    first = min(max(round(begin * rate), 0), source.frames)
    last = (
        source.frames if end * rate >= source.frames else max(round(end * rate), first)
    )
    return (
        source if (first, last) == (0, source.frames) else Excerpt(source, first, last)
    )


def read_samples(source: AudioSource, start: int, stop: int) -> np.ndarray:
    """Return the samples (stop - start, channels) from `start` up to `stop` or the last
    sample."""
    parts = list(Excerpt(source, start, stop).blocks())
    return np.concatenate(parts) if parts else np.zeros((0, 1))


def loudest_channel(samples: np.ndarray) -> np.ndarray:
    """Return the channel (n,) with the largest energy of samples (n, channels)."""
    return samples[:, np.argmax(np.square(samples, dtype=float).sum(axis=0))]


def overlapping_pieces(
    source: AudioSource, step: int, overlap: int = 0, start: int = 0
) -> Iterator[np.ndarray]:
    """Yield the samples from `start` on in overlapping pieces (step + overlap,
    channels).

    The starts of the pieces are `step` samples apart; the last piece is padded with
    zeros. Only one piece and one block are in memory."""
    size = step + overlap
    held = np.zeros((0, 1))
    for block in source.blocks(start):
        held = np.concatenate([held, block]) if len(held) else block
        while len(held) >= size:
            yield held[:size]
            held = held[step:]
    while len(held):
        yield np.pad(held[:size], ((0, max(size - len(held), 0)), (0, 0)))
        held = held[step:]


def truncation_of(sound: AudioSource | str | Path) -> Truncation | None:
    """Return the `truncation` of a sound file, or None for any other source."""
    source = source_of(sound)
    return source.truncation if isinstance(source, SoundFile) else None


def name_of(source: AudioSource) -> str:
    """Return the path of a source in a file, or the name of a recording in memory."""
    if isinstance(source, Excerpt):
        return name_of(source.source)
    if isinstance(source, SoundFile):
        return str(source.path)
    return source.name if isinstance(source, Recording) else "the sound"
