"""Recordings as the fit reads them."""

from sonify.hearing.audio_source import (
    AudioSource,
    Recording,
    SoundFile,
    source_of_file,
)
from sonify.hearing.recording_files import recording_files

__all__ = ["Recording", "is_recording", "recording_files", "source_of_file"]

OWN_SOFTWARE_NOTE = "eulers-disk-sonify"
"""Start of the software note in sound files written by this program
(`sonify.sound.wav`)."""


def is_recording(source: AudioSource) -> bool:
    """Return False for files written by this program, whose sounds have no high-pass
    filter."""
    if not isinstance(source, SoundFile):
        return True
    with source.open() as file:
        return not file.software.startswith(OWN_SOFTWARE_NOTE)
