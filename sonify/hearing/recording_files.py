"""Recordings in folders; files of other kinds are skipped with a notice."""

from collections.abc import Callable, Iterable
from pathlib import Path

import soundfile

from sonify.hearing.audio_source import UNRECOGNISED_FORMAT, AudioSource, SoundFile
from sonify.hearing.phyphox import advice_on_table, may_contain_table
from sonify.hearing.recording_errors import (
    conversion_advice,
    is_container,
    unreadable,
)


def recording_files(
    paths: Iterable[str | Path], notice: Callable[[str], None] = lambda line: None
) -> list[Path]:
    """Return the recordings in `paths`; a folder is replaced by its recordings in
    order.

    The content of a file determines whether it is a recording. The skipped files of a
    folder are passed to `notice`, in one line for each file that can be converted and in
    one line for all others. Raises RecordingError if a path does not exist or a folder
    contains no recordings.
    """
    found: list[Path] = []
    for path in map(Path, paths):
        found += _recordings_in_folder(path, notice) if path.is_dir() else [path]
    for path in found:
        if not path.exists():
            raise unreadable(path, "No such file or directory")
    return found


def _recordings_in_folder(folder: Path, notice: Callable[[str], object]) -> list[Path]:
    """Return the recordings in a folder in order."""
    recordings = []
    lines = []
    others = []
    for path in sorted(folder.iterdir()):
        if path.is_dir():
            others.append(f"{path.name} (a folder)")
            continue
        try:
            advice = advice_on_file(path) if path.is_file() else ""
        except OSError as error:
            others.append(f"{path.name} ({error.strerror})")
            continue
        if advice is None:
            recordings.append(path)
        elif advice:
            lines.append(f"{path}: skipped; {advice}")
        else:
            others.append(path.name)
    if others:
        lines.append(f"{folder}: skipped, no recordings: {', '.join(others)}")
    if not recordings:
        raise unreadable(folder, "; ".join(["a folder without recordings", *lines]))
    for line in lines:
        notice(line)
    return recordings


def advice_on_file(path: Path) -> str | None:
    """Return None for a recording, otherwise what turns the file into one; the text is
    empty if nothing does.

    Raises OSError if the file is unreadable."""
    sound = SoundFile(path)
    try:
        with sound.open():
            return None
    except soundfile.LibsndfileError as error:
        is_recognised = error.code != UNRECOGNISED_FORMAT
    if may_contain_table(sound.head):
        with sound.stream() as file:
            return advice_on_table(file)
    if is_container(sound.head) or (is_recognised and sound.head):
        return conversion_advice(path)
    return ""


def is_recording(source: AudioSource) -> bool:
    """Return False for files written by this program, whose sounds have no high-pass
    filter."""
    if not isinstance(source, SoundFile):
        return True
    own_note = "eulers-disk-sonify"  # start of the software note of sonify.sound.wav
    with source.open() as file:
        return not file.software.startswith(own_note)
