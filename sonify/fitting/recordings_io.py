"""PATHS -> SOURCES: sound files, phyphox exports, and folders of recordings."""

import csv
import io
import re
import zipfile
from pathlib import Path

import numpy as np
import soundfile

from sonify.fitting.synthetic import Recording
from sonify.hearing.audio_source import SoundFile, Source
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
"""File suffixes that are read from a folder."""
TIME = re.compile(r"time.*\((m?s)\)", re.IGNORECASE)
LEAST_ROWS = 100
OWN_NOTE = "eulers-disk-sonify"
"""Beginning of the note in sound files written by this program (`sonify.sound.wav`)."""


def recording_files(paths) -> list[Path]:
    """Return the files that paths name; a folder gives its recordings in order.

    Raises RecordingError if there is none.
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
                f"{path}: no take in this folder; they end in {', '.join(RECORDING_SUFFIXES)}"
            )
        found += inside
    return found


def source_of_file(path: Path) -> Source | Path:
    """Return the source of a file: a sound file, or a phyphox table of amplitude against time.

    Raises RecordingError for an invalid table.
    """
    if path.suffix.lower() not in {".csv", ".zip"}:
        return SoundFile(path)
    try:
        tables = _table_texts(path)
    except (OSError, zipfile.BadZipFile, UnicodeDecodeError) as error:
        raise RecordingError(
            f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}"
        ) from None
    found = [made for text in tables if (made := _table_samples(text, path)) is not None]
    if not found:
        raise RecordingError(
            f"{path}: holds no table with a column 'Time (s)' or 'Time (ms)' and an amplitude "
            f"beside it"
        )
    return max(found, key=lambda recording: recording.frames)


def is_recorded(path: Path) -> bool:
    """Return True unless the file was written by this program, whose sounds pass no high-pass."""
    try:
        with SoundFile(path).open() as file:
            return not file.software.startswith(OWN_NOTE)
    except (soundfile.LibsndfileError, OSError):
        return True


def _table_texts(path):
    """Return the texts of the tables in a file."""
    if path.suffix.lower() == ".csv":
        return [path.read_text(encoding="utf-8-sig")]
    with zipfile.ZipFile(path) as archive:
        names = [name for name in archive.namelist() if name.lower().endswith(".csv")]
        return [archive.read(name).decode("utf-8-sig") for name in names]


def _table_samples(text, path):
    """Return the amplitudes of a table with evenly spaced times; None if it has none."""
    separator = max(",;\t", key=text.partition("\n")[0].count)
    rows = csv.reader(io.StringIO(text), delimiter=separator)
    head = [name.strip() for name in next(rows, [])]
    unit = next((TIME.match(name) for name in head if TIME.match(name)), None)
    if unit is None or len(head) < 2:
        return None
    time = head.index(unit.string)
    amplitude = next(i for i in range(len(head)) if i != time)
    comma = separator == ";"
    cells = [(row[time], row[amplitude]) for row in rows if len(row) > max(time, amplitude)]
    try:
        t, x = np.array(
            [[float(c.replace(",", ".") if comma else c) for c in pair] for pair in cells]
        ).T
    except ValueError:
        raise RecordingError(f"{path}: a row of its table is not two numbers") from None
    if not np.isfinite([t, x]).all() or not (np.diff(t) > 0).all():
        raise RecordingError(
            f"{path}: its time does not rise from row to row, or a cell is not finite"
        )
    if len(t) < LEAST_ROWS:
        raise RecordingError(f"{path}: {len(t)} rows: at least {LEAST_ROWS} are needed")
    even = np.linspace(t[0], t[-1], len(t))
    second = 1e3 if unit[1].lower() == "ms" else 1.0
    return Recording(
        samples=np.interp(even, t, x), sample_rate=round((len(t) - 1) / (t[-1] - t[0]) * second)
    )
