"""Reading of sound files, phyphox exports and folders of recordings."""

import csv
import io
import re
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import soundfile

from sonify.hearing.audio_source import BLOCK_SIZE, SoundFile, Source
from sonify.hearing.recording import RecordingError

RECORDING_SUFFIXES = (
    ".wav",
    ".flac",
    ".ogg",
    ".oga",
    ".opus",
    ".mp3",
    ".aiff",
    ".aif",
    ".w64",
    ".caf",
    ".zip",
    ".csv",
)
"""Suffixes of the files that are read from a folder."""
TIME_COLUMN_PATTERN = re.compile(r"time.*\((m?s)\)", re.IGNORECASE)
OWN_SOFTWARE_NOTE = "eulers-disk-sonify"
"""Start of the software note in sound files written by this program
(`sonify.sound.wav`)."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Recording:
    """Audio source from samples (n,) in memory."""

    samples: np.ndarray
    sample_rate: int

    @property
    def frames(self) -> int:
        """Number of samples."""
        return len(self.samples)

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Yield blocks (k, 1) of samples, beginning with sample number `start`."""
        for first in range(start, self.frames, BLOCK_SIZE):
            yield self.samples[first : first + BLOCK_SIZE, None]


def recording_files(paths) -> list[Path]:
    """Return the recordings in `paths`; a folder is replaced by its recordings in
    order.

    Raises RecordingError if a folder contains none.
    """
    found = []
    for path in map(Path, paths):
        inside = (
            sorted(p for p in path.iterdir() if p.suffix.lower() in RECORDING_SUFFIXES)
            if path.is_dir()
            else [path]
        )
        if not inside:
            raise RecordingError(
                f"{path}: no recordings in this folder; their names end in "
                f"{', '.join(RECORDING_SUFFIXES)}"
            )
        found += inside
    return found


def source_of_file(path: Path) -> Source | Path:
    """Return the source of a file: a sound file, or a phyphox table of amplitude
    against time.

    Raises RecordingError for an invalid table.
    """
    if path.suffix.lower() not in {".csv", ".zip"}:
        return SoundFile(path)
    try:
        tables = _cell_texts(path)
    except (OSError, zipfile.BadZipFile, UnicodeDecodeError) as error:
        raise RecordingError(
            f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}"
        ) from None
    found = [
        made for text in tables if (made := _table_samples(text, path)) is not None
    ]
    if not found:
        raise RecordingError(
            f"{path}: contains no table with a column 'Time (s)' or 'Time (ms)' and a column of "
            f"amplitudes"
        )
    return max(found, key=lambda recording: recording.frames)


def is_recording(path: Path) -> bool:
    """Return False for files written by this program, whose sounds have no high-pass
    filter."""
    try:
        with SoundFile(path).open() as file:
            return not file.software.startswith(OWN_SOFTWARE_NOTE)
    except (soundfile.LibsndfileError, OSError):
        return True


def _cell_texts(path):
    """Return the texts of the tables in a file."""
    if path.suffix.lower() == ".csv":
        return [path.read_text(encoding="utf-8-sig")]
    with zipfile.ZipFile(path) as archive:
        names = [name for name in archive.namelist() if name.lower().endswith(".csv")]
        return [archive.read(name).decode("utf-8-sig") for name in names]


def _table_samples(text, path):
    """Return the amplitudes of a table, resampled at equal intervals, or None if the
    text contains no such table."""
    min_row_count = 100
    separator = max(",;\t", key=text.partition("\n")[0].count)
    rows = csv.reader(io.StringIO(text), delimiter=separator)
    head = [name.strip() for name in next(rows, [])]
    unit = next(filter(None, map(TIME_COLUMN_PATTERN.match, head)), None)
    if unit is None or len(head) < 2:
        return None
    time = head.index(unit.string)
    amplitude = 0 if time else 1
    last = max(time, amplitude)

    def number(cell):
        return float(cell.replace(",", ".") if separator == ";" else cell)

    try:
        t, x = np.array(
            [
                (number(row[time]), number(row[amplitude]))
                for row in rows
                if len(row) > last
            ]
        ).T
    except ValueError:
        raise RecordingError(
            f"{path}: a row of its table does not contain two numbers"
        ) from None
    if not np.isfinite([t, x]).all() or not (np.diff(t) > 0).all():
        raise RecordingError(
            f"{path}: its times do not increase from row to row, or a cell is not finite"
        )
    if len(t) < min_row_count:
        raise RecordingError(
            f"{path}: too few rows, {len(t)}; at least {min_row_count} are required"
        )
    even = np.linspace(t[0], t[-1], len(t))
    second = 1e3 if unit[1].lower() == "ms" else 1.0
    return Recording(
        samples=np.interp(even, t, x),
        sample_rate=round((len(t) - 1) / (t[-1] - t[0]) * second),
    )
