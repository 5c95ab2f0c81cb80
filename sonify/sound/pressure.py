"""Store the sound pressure at the listener and its stems."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import chain
from tempfile import TemporaryFile
from typing import TYPE_CHECKING, Literal
from weakref import finalize

import numpy as np

from dynamics import Outcome
from sonify.hearing.audio_source import BLOCK_SIZE
from sonify.hearing.loudness import Audibility, audibility
from sonify.sound.audible_modes import RingDown
from sonify.sound.mastering import MasteredTrack, master_copy
from sonify.sound.playback import (
    ScaledTrack,
    WeightedTrack,
    audible_copy,
    energy_below,
    loudness,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Dynamics = Literal["compressed", "natural"]
STEMS = ("heave", "tilt", "ringing_smooth", "ringing_jumps")
"""Stems of every scene: heave and tilt of the rigid disk, and ringing of its modes due
to the smooth part of the force and to its jumps. A scene may have further stems."""
MAX_BYTES_IN_MEMORY = 1 << 27
"""Size [bytes] above which a sound is stored in an unnamed temporary file."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Track:
    """One column of a sound [Pa], which sonify.hearing can analyse as an audio source.

    It has `frames` samples at `sample_rate` [Hz]. `others` contains the same column at
    further listeners, the additional channels, and has the same length."""

    sample_rate: int
    columns: "np.ndarray | ScratchFile"
    column: int
    name: str = "pressure"
    others: "tuple[Track, ...]" = ()

    def __repr__(self) -> str:
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
        """Return the samples (k,) `first` to `last` (default: the end) of the first
        listener."""
        return self.columns[first:last][:, self.column]

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Return a new iterator over float32 blocks (k, channels), beginning at sample
        `start`."""
        for first in range(start, self.frames, BLOCK_SIZE):
            last = first + BLOCK_SIZE
            tracks = (self, *self.others)
            yield np.column_stack([track.read(first, last) for track in tracks])


@dataclass(frozen=True, kw_only=True, eq=False)
class SummedTrack:
    """The sum of several tracks [Pa], rounded to float32; an audio source like them."""

    tracks: tuple[Track, ...]

    @property
    def sample_rate(self) -> int:
        """Sample rate [Hz]."""
        return self.tracks[0].sample_rate

    @property
    def frames(self) -> int:
        """Number of samples."""
        return self.tracks[0].frames

    @property
    def channels(self) -> int:
        """Number of listeners."""
        return self.tracks[0].channels

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Return a new iterator over float32 blocks (k, channels), beginning at sample
        `start`."""
        for parts in zip(*(track.blocks(start) for track in self.tracks), strict=True):
            yield np.sum(parts, axis=0, dtype=float).astype(np.float32)


@dataclass(frozen=True, kw_only=True, eq=False)
class Sound:
    """The rendered sound of a scene.

    Attributes
    ----------
    name : str
        Name of the scene.
    sample_rate : int
        [Hz]
    columns : ndarray or ScratchFile, shape (n, 1 + s)
        Pressure and its stems [Pa], float32, read by slices of rows.
    source_end : float
        Time [s] at which the sound of the end of the rolling motion reaches the listener;
        the landing and the ring-down of the modes follow.
    outcome : Outcome
        Outcome of the motion.
    ringing : RingDown
        Frequencies and decay rates of the modes after the motion.
    energy_time : ndarray, shape (e,)
        Times [s] of the energies, without the propagation delay.
    energy : ndarray, shape (e,)
        Energy [J] of the modes of the disk.
    table_energy : ndarray, shape (e,), or None
        Energy [J] of the modes of an elastic table.
    names : tuple of str, length s
        Names of the stems.
    others : tuple of Sound
        Sounds of the same length at further listeners.
    has_second_ear : bool
        True if one more column contains the pressure at a second ear, a quarter turn
        around the disk, for audible.wav.
    dynamics : str
        Dynamics of audible.wav, "compressed" or "natural".
    """

    name: str
    sample_rate: int
    columns: "np.ndarray | ScratchFile"
    source_end: float
    outcome: Outcome
    ringing: RingDown
    energy_time: np.ndarray
    energy: np.ndarray
    table_energy: np.ndarray | None = None
    names: tuple[str, ...] = STEMS
    others: "tuple[Sound, ...]" = ()
    has_second_ear: bool = False
    dynamics: Dynamics = "compressed"

    @property
    def pressure(self) -> Track:
        """The pressure at the listener [Pa]."""
        return self.track("pressure")

    @property
    def stems(self) -> dict[str, Track]:
        """Stems [Pa] by name; their sum is the pressure."""
        return {name: self.track(name) for name in self.names}

    def plot(self) -> "Figure":
        """Return a matplotlib figure of the pressure over time and its spectrogram."""
        from sonify.sound.plotting import plot_sound  # matplotlib is slow to import

        return plot_sound(self)

    def track(self, name: str) -> Track:
        """Return the pressure or a stem by name; raises ValueError for other names."""
        if name not in (tracks := ("pressure", *self.names)):
            raise ValueError(
                f"there is no track {name!r}; choose one of {', '.join(tracks)}"
            )
        return self._track(
            name, tracks.index(name), tuple(other.track(name) for other in self.others)
        )

    def _track(self, name: str, column: int, others: tuple[Track, ...] = ()) -> Track:
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
    def _column_peaks(self) -> np.ndarray:
        starts = range(0, self.samples, BLOCK_SIZE)
        own = [
            np.array(
                [np.abs(column).max() for column in self.columns[n : n + BLOCK_SIZE].T]
            )
            for n in starts
        ]
        return np.max(
            [*own, *(other._column_peaks for other in self.others)], axis=0
        ).astype(float)

    @property
    def peak(self) -> float:
        """Largest magnitude of the pressure [Pa]."""
        return float(self._column_peaks[0])

    @property
    def stem_peaks(self) -> dict[str, float]:
        """Largest magnitude of each stem [Pa] by name."""
        return dict(
            zip(
                self.names,
                self._column_peaks[1 : 1 + len(self.names)].tolist(),
                strict=True,
            )
        )

    @property
    def is_finite(self) -> bool:
        """True if every sample is a finite number."""
        return bool(np.isfinite(self._column_peaks).all())

    @property
    def full_scale(self) -> float:
        """Pressure [Pa] represented by 1.0 in sound.wav."""
        listening_peak_db = -1.0  # relative to full scale
        return self.peak / 10 ** (listening_peak_db / 20) or 1.0

    @property
    def gain_db(self) -> float:
        """Gain from pascal in pressure.wav to sound.wav [dB]."""
        return float(-20 * np.log10(self.full_scale))

    @property
    def playback_copy(self) -> ScaledTrack:
        """Content of sound.wav: the pressure divided by `full_scale`."""
        return ScaledTrack(track=self.pressure, full_scale=self.full_scale)

    @cached_property
    def stem_audibility(self) -> dict[str, Audibility]:
        """Audibility of each stem over time, by name."""
        return {name: audibility(stem) for name, stem in self.stems.items()}

    @cached_property
    def inaudible_stems(self) -> tuple[str, ...]:
        """Names of the stems that stay below the threshold of hearing at all
        listeners."""
        return tuple(
            name
            for name, heard in self.stem_audibility.items()
            if heard.above_threshold.max() <= 0
            and all(name in other.inaudible_stems for other in self.others)
        )

    @property
    def stem_files(self) -> dict[str, Track | SummedTrack]:
        """Content of stems/*.wav by name: each audible stem, and the sum of all others
        as "rest"; together they add up to the pressure."""
        stems = self.stems
        inaudible = tuple(stems.pop(name) for name in self.inaudible_stems)
        rest = {"rest": SummedTrack(tracks=inaudible)} if inaudible else {}
        return {**stems, **rest}

    @cached_property
    def audible_uncompressed(self) -> ScaledTrack:
        """A-weighted, amplified pressure with natural dynamics; two ears if
        `has_second_ear`."""
        return audible_copy(self._audible_source)

    @cached_property
    def audible(self) -> MasteredTrack | ScaledTrack:
        """Content of audible.wav: `audible_uncompressed`, or a master with compressed
        dynamics."""
        return (
            self.audible_uncompressed
            if self.dynamics == "natural"
            else master_copy(self._audible_source)
        )

    @property
    def a_weighted(self) -> WeightedTrack:
        """A-weighted pressure [Pa], from which audible.wav is made."""
        return WeightedTrack(track=self._audible_source)

    @property
    def _audible_source(self) -> Track:
        if not self.has_second_ear:
            return self.pressure
        second_ear = self._track("second_ear", 1 + len(self.names))
        return replace(self.pressure, others=(second_ear,))

    @cached_property
    def loudness(self) -> tuple[float | str, float | str]:
        """Loudness [LUFS] of sound.wav and audible.wav by BS.1770, or the reason why it
        is undefined."""
        return loudness(self.playback_copy), loudness(self.audible)

    @cached_property
    def low_frequency_shares(self) -> tuple[float, ...]:
        """Fractions of the energy below 100 Hz and below 300 Hz, where small
        loudspeakers are weak."""
        return energy_below(self.pressure, 100.0, 300.0)

    def __repr__(self) -> str:
        recorded = f"{self.duration:.3f} s at {self.sample_rate} Hz"
        return f"Sound({recorded}, peak {self.peak:.3g} Pa, {len(self.ringing.frequency)} modes)"


class ScratchFile:
    """Rows (n, width) in an unnamed temporary file that is deleted with the object."""

    def __init__(self, width: int) -> None:
        self._file = TemporaryFile()  # noqa: SIM115, closed below
        self._rows = 0
        self._width = width
        finalize(self, self._file.close)

    def append(self, rows: np.ndarray) -> None:
        """Write rows (k, width), float32. Raises OSError if the disk is full."""
        self._file.write(rows.tobytes())
        self._file.flush()  # readers read the file, not the buffer
        self._rows += len(rows)

    def __len__(self) -> int:
        return self._rows

    def __getitem__(self, rows: slice) -> np.ndarray:
        first, last, _ = rows.indices(self._rows)
        width = self._width
        count = max(last - first, 0)
        if not count:
            return np.empty((0, width), np.float32)
        return np.memmap(
            self._file, np.float32, "r", offset=4 * width * first, shape=(count, width)
        )


def collect_rows(rows: Iterator[np.ndarray], count: int) -> "np.ndarray | ScratchFile":
    """Return `count` rows from float32 blocks (k, width) as an array, or as a
    ScratchFile if large."""
    first = next(rows)
    if first.itemsize * first.shape[1] * count <= MAX_BYTES_IN_MEMORY:
        return np.concatenate(
            [block.T for block in (first, *rows)], axis=1
        ).T  # columns are contiguous, for fast reading
    scratch = ScratchFile(first.shape[1])
    for block in chain([first], rows):
        scratch.append(block)
    return scratch


def pressure_and_stems(stems: np.ndarray) -> np.ndarray:
    """Return pressure and stems (k, 1 + s) as float32 from stems (k, s) [Pa].

    The rounded stems are summed in double precision and then rounded."""
    stems = stems.astype(np.float32)
    return np.column_stack(
        [sum(stem.astype(float) for stem in stems.T).astype(np.float32), stems]
    )
