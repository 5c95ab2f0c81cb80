"""Audio sources: samples that can be read repeatedly, in blocks and from any
position."""

import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from io import SEEK_END, BytesIO
from pathlib import Path
from typing import Protocol

import numpy as np
import soundfile

from sonify.hearing.mp3 import read_mp3
from sonify.scene_errors import InputError

LENGTH_MISMATCH_NOTE = re.compile(
    r"(?:data|SSND|Data Size) *: *(\d+) \(should be (\d+)\)"
)
"""Note of libsndfile on WAV, AIFF and AU files whose length differs from that in their
header [bytes]."""
BLOCK_SIZE = 1 << 16
"""Number of samples read from a file at a time."""


class Source(Protocol):
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

    def __str__(self):
        announced = (
            "the header states no length"
            if self.announced is None
            else f"the header states {self.announced:.3f} s"
        )
        return f"the file is truncated: it contains {self.held:.3f} s of sound, and {announced}"


@dataclass(frozen=True)
class SoundFile:
    """Source in a file of any format that libsndfile reads.

    In a truncated file, only the decodable samples are used. Raises
    soundfile.LibsndfileError for other files."""

    path: str | Path

    @cached_property
    def _mp3(self):
        return read_mp3(self.path) if Path(self.path).suffix.lower() == ".mp3" else None

    def open(self) -> soundfile.SoundFile:
        """Return the open file; a missing or incorrect header of an MP3 file is
        replaced."""
        mp3 = self._mp3
        wrong = mp3 is not None and mp3.frames != mp3.announced
        return soundfile.SoundFile(BytesIO(mp3.content) if wrong else self.path)

    @cached_property
    def _header(self):
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
        if self._mp3 is not None:
            if not self._mp3.is_truncated:
                return None
            missing = (
                (self._mp3.announced - self._mp3.frames) * self._mp3.samples / rate
            )
            return Truncation(held, held + missing)
        if kind == "OGG":
            return None if ends_with_its_stream(self.path) else Truncation(held, None)
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
        """Yield the samples from number `start` on in float32 blocks (k, channels)."""
        left = self.frames - start
        with self.open() as file:
            file.seek(min(start, self.frames))
            while left > 0:
                block = file.read(
                    min(BLOCK_SIZE, left), dtype="float32", always_2d=True
                )
                left -= len(block)
                yield block
                if not len(block):
                    break


def ends_with_its_stream(path: str | Path) -> bool:
    """Return True if the last page of an Ogg file is complete and marked as the end
    (RFC 3533)."""
    max_page_length = 65_307  # bytes
    with Path(path).open("rb") as file:
        size = file.seek(0, SEEK_END)
        file.seek(max(size - 2 * max_page_length, 0))
        tail = file.read()
    at = tail.rfind(b"OggS")
    if at < 0 or at + 27 > len(tail):
        return False
    lengths = tail[at + 27 : at + 27 + tail[at + 26]]
    whole = at + 27 + tail[at + 26] + sum(lengths) <= len(tail)
    return whole and bool(tail[at + 5] & 4)


def source_of(sound: Source | str | Path) -> Source:
    """Return `sound` itself if it is a source, otherwise the source in the file at this
    path."""
    return SoundFile(sound) if isinstance(sound, (str, Path)) else sound


@dataclass(frozen=True)
class Excerpt:
    """Part of a source from frame `first` up to frame `last`, as a source."""

    source: Source
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


def excerpt(source: Source, begin: float, end: float) -> Source:
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


def read_samples(source: Source, start: int, stop: int) -> np.ndarray:
    """Return the samples (stop - start, channels) from `start` up to `stop` or the last
    sample."""
    parts = list(Excerpt(source, start, stop).blocks())
    return np.concatenate(parts) if parts else np.zeros((0, 1))


def loudest_channel(samples: np.ndarray) -> np.ndarray:
    """Return the channel (n,) with the largest energy of samples (n, channels)."""
    return samples[:, np.argmax(np.square(samples, dtype=float).sum(axis=0))]


def overlapping_pieces(
    source: Source, step: int, overlap: int = 0, start: int = 0
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


def truncation_of(sound: Source | str | Path) -> Truncation | None:
    """Return the `truncation` of a sound file, or None for any other source."""
    source = source_of(sound)
    return source.truncation if isinstance(source, SoundFile) else None
