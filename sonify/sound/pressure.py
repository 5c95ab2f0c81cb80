"""SOUND: the pressure at the listener, by cause, which can be read again and again, from any place
on."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import chain
from tempfile import TemporaryFile
from weakref import finalize

import numpy as np

from dynamics import Outcome
from sonify.sound.audible_modes import RingDown
from sonify.sound.playback import Copy, audible, energy_below, loudness

STEMS = ("heave", "tilt", "ringing_smooth", "ringing_jumps")
"""The disk moves up and down as a whole; it tilts; its modes follow the smooth force; they ring
after its jumps. These sound in every scene; a scene may have more."""
COLUMNS = ("pressure", *STEMS)
LISTENING_PEAK_DB = -1.0
"""Peak of sound.wav relative to full scale [dB]."""
MOST_IN_MEMORY = 1 << 27
"""A sound of more bytes lies in a nameless file in the system's temporary folder."""
BLOCK = 1 << 16
"""Samples read at once."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Track:
    """One column of a sound [Pa]: `frames` samples at `sample_rate` [Hz]; a source for everything
    in sonify.hearing.

    What `others` hear of the same are its further channels.
    """

    sample_rate: int
    columns: object
    column: int
    name: str = "pressure"
    others: "tuple[Track, ...]" = ()

    def __repr__(self):
        return f"Track({self.name}, {self.frames} samples at {self.sample_rate} Hz)"

    @property
    def frames(self) -> int:
        """Number of samples."""
        return len(self.columns)

    @property
    def channels(self) -> int:
        """Number of listeners."""
        return 1 + len(self.others)

    def read(self, first: int = 0, last: int | None = None) -> np.ndarray:
        """Return the samples (k,) of the first listener from number `first` up to `last`, or to the
        end."""
        return self.columns[first:last][:, self.column]

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Yield (k, channels), float32: the samples from number `start` on; every call begins
        anew."""
        for first in range(start, self.frames, BLOCK):
            block = np.zeros((min(BLOCK, self.frames - first), self.channels), np.float32)
            for channel, track in enumerate((self, *self.others)):
                part = track.read(first, first + len(block))
                block[: len(part), channel] = part
            yield block


@dataclass(frozen=True, kw_only=True, eq=False)
class Sound:
    """What is heard of the scene `name`, as rendered.

    `columns` (n, 1 + s) [Pa], float32, are the pressure and its causes, of these `names` (s,); they
    are read by slices of rows. `modes_heard` is the number of modes that sound. `source_end` [s] is
    when the end of the motion, its `outcome`, reaches the listener; from then on the modes ring as
    `ringing` states. `energy` (e,) [J] is that of the modes at `energy_time` (e,) [s], in the time
    of the motion; that of the modes of an elastic table is `table_energy` (e,) [J]. `others` are
    what further listeners hear; where the sound is `turned`, the last column is the pressure at an
    ear a quarter turn round the disk, for audible.wav."""

    name: str
    sample_rate: int
    columns: "np.ndarray | Scratch"
    modes_heard: int
    source_end: float
    outcome: Outcome
    ringing: RingDown
    energy_time: np.ndarray
    energy: np.ndarray
    table_energy: np.ndarray | None = None
    names: tuple[str, ...] = STEMS
    others: "tuple[Sound, ...]" = ()
    turned: bool = False

    @property
    def pressure(self) -> Track:
        """The pressure at the listener [Pa]."""
        return self.track("pressure")

    @property
    def stems(self) -> dict[str, Track]:
        """The causes of the pressure [Pa], by name; they add up to it."""
        return {name: self.track(name) for name in self.names}

    def track(self, name: str) -> Track:
        """Return the pressure or one of its causes by its name. Raises ValueError for another
        one."""
        if name not in (tracks := ("pressure", *self.names)):
            raise ValueError(f"there is no track {name!r}: it is one of {', '.join(tracks)}")
        return self._track(
            name, tracks.index(name), tuple(other.track(name) for other in self.others)
        )

    def _track(self, name, column, others=()):
        return Track(
            name=name,
            sample_rate=self.sample_rate,
            columns=self.columns,
            column=column,
            others=others,
        )

    @property
    def samples(self) -> int:
        """Number of samples."""
        return len(self.columns)

    @property
    def duration(self) -> float:
        """Length [s]."""
        return self.samples / self.sample_rate

    @cached_property
    def _peaks(self):
        starts = range(0, self.samples, BLOCK)
        own = [[np.abs(column).max() for column in self.columns[n : n + BLOCK].T] for n in starts]
        return np.max([*own, *(other._peaks for other in self.others)], axis=0).astype(float)

    @property
    def peak(self) -> float:
        """The greatest pressure, of either sign [Pa]."""
        return float(self._peaks[0])

    @property
    def stem_peak(self) -> dict[str, float]:
        """The greatest pressure of each cause [Pa]."""
        return dict(zip(self.names, self._peaks[1 : 1 + len(self.names)].tolist(), strict=True))

    @property
    def finite(self) -> bool:
        """Whether every sample is a finite number."""
        return bool(np.isfinite(self._peaks).all())

    @property
    def full_scale(self) -> float:
        """The pressure [Pa] that 1.0 in sound.wav stands for."""
        return self.peak / 10 ** (LISTENING_PEAK_DB / 20) or 1.0

    @property
    def gain_db(self) -> float:
        """Gain from pascal in pressure.wav to sound.wav [dB]."""
        return float(-20 * np.log10(self.full_scale))

    @property
    def copy(self) -> Copy:
        """What sound.wav holds: the pressure over its `full_scale`."""
        return Copy(track=self.pressure, full_scale=self.full_scale)

    @cached_property
    def audible(self) -> Copy:
        """What audible.wav holds: the pressure A-weighted and made loud, for two ears at least."""
        beside = (self._track("beside", 1 + len(self.names)),) if self.turned else ()
        return audible(replace(self.pressure, others=beside or self.pressure.others))

    @cached_property
    def loudness(self) -> tuple[float | str, float | str]:
        """The loudness of sound.wav and of audible.wav by BS.1770 [LUFS], or why there is none."""
        return loudness(self.copy), loudness(self.audible)

    @cached_property
    def low_share(self) -> tuple[float, ...]:
        """The shares of the energy of the pressure below 100 and below 300 Hz, which small
        loudspeakers hardly play."""
        return energy_below(self.pressure, 100.0, 300.0)

    def __repr__(self):
        recorded = f"{self.duration:.3f} s at {self.sample_rate} Hz"
        return f"Sound({recorded}, peak {self.peak:.3g} Pa, {self.modes_heard} modes)"


class Scratch:
    """Rows (n, width) in a nameless file that goes with the last reader; scratch[first:last] reads
    them."""

    def __init__(self, width: int):
        self._file = TemporaryFile()  # noqa: SIM115, closed below
        self._rows = 0
        self._width = width
        finalize(self, self._file.close)

    def append(self, rows):
        """Write rows (k, width), float32. Raises OSError when the disk is full."""
        self._file.write(rows.tobytes())
        self._file.flush()  # what is read is the file
        self._rows += len(rows)

    def __len__(self):
        return self._rows

    def __getitem__(self, rows: slice):
        first, last, _ = rows.indices(self._rows)
        width = self._width
        count = max(last - first, 0)
        if not count:
            return np.empty((0, width), np.float32)
        return np.memmap(
            self._file, np.float32, "r", offset=4 * width * first, shape=(count, width)
        )


def kept(rows: Iterator[np.ndarray], count: int) -> "np.ndarray | Scratch":
    """Return `count` rows that come in blocks (k, width), float32: as an array, or on disk where
    they are too many."""
    first = next(rows)
    if first.itemsize * first.shape[1] * count <= MOST_IN_MEMORY:
        return np.concatenate(
            [block.T for block in (first, *rows)], axis=1
        ).T  # a column is read at once
    scratch = Scratch(first.shape[1])
    for block in chain([first], rows):
        scratch.append(block)
    return scratch


def with_sum(stems) -> np.ndarray:
    """Return pressure and stems (k, 1 + s), float32, of stems (k, s) [Pa]: rounded, their sum in
    double precision and rounded."""
    stems = stems.astype(np.float32)
    return np.column_stack([sum(stem.astype(float) for stem in stems.T).astype(np.float32), stems])
