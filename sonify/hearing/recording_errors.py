"""Reasons why a file cannot be read as a recording, and what helps."""

import os
import shlex
from pathlib import Path

from sonify.scene_errors import InputError

CONTAINER_SIGNATURES = (
    (4, b"ftyp"),  # MPEG-4, QuickTime, 3GP
    (4, b"moov"),  # QuickTime
    (4, b"mdat"),
    (4, b"wide"),
    (4, b"free"),
    (4, b"skip"),
    (0, b"\x1a\x45\xdf\xa3"),  # Matroska, WebM
    (0, b"\x30\x26\xb2\x75\x8e\x66\xcf\x11"),  # Windows Media
    (0, b"#!AMR"),
    (0, b"ADIF"),
    (0, b"\x0b\x77"),  # AC-3
    (0, b"FLV\x01"),
    (0, b".RMF"),
    (0, b".ra\xfd"),
    (0, b"\x00\x00\x01\xba"),  # MPEG program stream
    (8, b"AVI "),
    (8, b"QLCM"),
    (0, b"MAC "),
    (0, b"wvpk"),
    (0, b"TTA1"),
    (0, b"TTA2"),
    (0, b"MPCK"),
    (0, b"MP+"),
    (0, b"tBaK"),
    (0, b"ajkg"),
    (0, b"OFR "),
    (0, b"DSD "),
    (0, b"FRM8"),
)
"""Positions [bytes] and signatures of containers of sound that libsndfile cannot
read."""


class RecordingError(InputError):
    """Error for a recording that cannot be analysed; the message is one line.

    Examples
    --------
    >>> from sonify import listen
    >>> listen("missing.wav")
    Traceback (most recent call last):
    sonify.hearing.recording_errors.RecordingError: missing.wav: not a readable sound file: No such file or directory
    """


def is_container(head: bytes) -> bool:
    """Return True if the first bytes of a file are those of a container of sound that
    libsndfile cannot read."""
    packet_length = 188  # bytes, of an MPEG transport stream
    is_transport_stream = head[:1] == b"G" == head[packet_length : packet_length + 1]
    is_aac_frame = head[:1] == b"\xff" and head[1:2] in (
        b"\xf0",
        b"\xf1",
        b"\xf8",
        b"\xf9",
    )
    return (
        is_transport_stream
        or is_aac_frame
        or any(head.startswith(mark, at) for at, mark in CONTAINER_SIGNATURES)
    )


def conversion_advice(path: str | Path) -> str:
    """Return the advice to convert a file, with a command that a shell accepts.

    The command contains the path as given. A prefix `./` keeps ffmpeg from taking it for
    an option or an address."""
    source = str(path)
    if source.startswith("-") or (":" in source and not os.path.isabs(source)):
        source = os.path.join(os.curdir, source)
    stem, suffix = os.path.splitext(source)
    target = f"{stem}_converted.wav" if suffix.lower() == ".wav" else f"{stem}.wav"
    return (
        f"convert it first, e.g. ffmpeg -i {shlex.quote(source)} {shlex.quote(target)}"
    )


def unreadable(path: str | Path, reason: str) -> RecordingError:
    """Return the error for a file that is no readable recording."""
    return RecordingError(f"{path}: not a readable sound file: {reason}")
