"""FILE or RENDERED SOUND -> SOURCE: samples that can be read again and again, from any place on, block by block."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Protocol

import numpy as np
import soundfile

PROMISED = re.compile(r"(?:data|SSND|Data Size) *: *(\d+) \(should be (\d+)\)")
"""What libsndfile notes of WAV, AIFF and AU files whose length is not that of their header [bytes]."""
UNKNOWN = 0x7FFF0000
"""So long is a file said to be whose length was not known when its header was written [bytes]."""
BLOCK = 1 << 16
"""So many samples are read from a file at once."""


class Source(Protocol):
    """What can be heard: `frames` samples at `sample_rate` [Hz].

    Every call of `blocks` begins anew, and nothing of the source changes by it; whoever has heard enough stops reading.
    """

    @property
    def sample_rate(self) -> int: ...

    @property
    def frames(self) -> int: ...

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Yield (k, channels): the samples from number `start` on to the last, in pieces of any length."""
        ...


@dataclass(frozen=True)
class SoundFile:
    """The source in a file of any format that libsndfile reads. Raises soundfile.LibsndfileError for any other."""

    path: str | Path

    @cached_property
    def _header(self):
        return soundfile.info(self.path)

    @property
    def sample_rate(self) -> int:
        """Samples a second [Hz]."""
        return self._header.samplerate

    @property
    def frames(self) -> int:
        """Number of samples in each channel."""
        return self._header.frames

    @property
    def missing(self) -> float:
        """How much more the header promises than the file holds, over what it holds: 0 unless the file was cut off."""
        promised = PROMISED.search(self._header.extra_info)
        said, held = map(int, promised.groups()) if promised else (0, 0)
        return max(said / held - 1, 0.0) if held and said < UNKNOWN else 0.0

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Yield (k, channels), float32: the samples from number `start` on."""
        with soundfile.SoundFile(self.path) as file:
            file.seek(min(start, file.frames))
            yield from file.blocks(BLOCK, dtype="float32", always_2d=True)


def source_of(sound: Source | str | Path) -> Source:
    """Return a source as it is, and that in a file for a path."""
    return SoundFile(sound) if isinstance(sound, (str, Path)) else sound


def stretch(source: Source, start: int, stop: int) -> np.ndarray:
    """Return the samples (stop - start, channels) from `start` up to `stop`, or up to the last."""
    parts, left = [], stop - start
    for block in source.blocks(start):
        parts.append(block[:left])
        left -= len(parts[-1])
        if left <= 0:
            break
    return np.concatenate(parts) if parts else np.zeros((0, 1))


def pieces(source: Source, step: int, overlap: int = 0, start: int = 0) -> Iterator[np.ndarray]:
    """Yield (step + overlap, channels): the samples from `start` on in pieces that begin `step` apart, zeros after the
    last sample. Memory is that of one piece and one block."""
    held = np.zeros((0, 1))
    for block in source.blocks(start):
        held = np.concatenate([held, block]) if len(held) else block
        while len(held) >= step + overlap:
            yield held[: step + overlap]
            held = held[step:]
    while len(held):
        yield np.pad(held[: step + overlap], ((0, max(step + overlap - len(held), 0)), (0, 0)))
        held = held[step:]
