"""Frame counts of MP3 files, and copies with a corrected header.

libsndfile reads the length from the Xing or Info header, or estimates it from the first
frame; it refuses files that do not begin with a frame. This module counts the frames of
the file. Source: ISO 11172-3 and 13818-3, section 2.4; the Xing and LAME headers."""

from dataclasses import dataclass
from struct import pack, unpack_from
from typing import BinaryIO, NamedTuple

from sonify.hearing.true_lengths import audio_start

SEARCHED_LENGTH = 1 << 16
"""Length after the tags of a file in which its first frame is sought [bytes]."""

KILOBITS = {
    1: (0, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320),
    2: (0, 8, 16, 24, 32, 40, 48, 56, 64, 80, 96, 112, 128, 144, 160),
}
"""Bit rates of layer III [kbit/s] in MPEG-1 and MPEG-2."""
SAMPLE_RATES = {
    3: (44100, 48000, 32000),
    2: (22050, 24000, 16000),
    0: (11025, 12000, 8000),
}
"""Sample rates [Hz] by the version bits of a frame, for MPEG-1, 2 and 2.5."""


class FrameHeader(NamedTuple):
    """Length [bytes], samples, sample rate [Hz] and size of the side data [bytes] of a
    layer III frame."""

    length: int
    samples: int
    sample_rate: int
    side_size: int

    @property
    def kind(self) -> tuple[int, int]:
        """Properties that all frames of a file share."""
        return self.samples, self.sample_rate


@dataclass(frozen=True)
class Mp3:
    """Number of complete frames in a file, number of `announced` frames, and samples
    per frame.

    `announced` is the number in the header, or None if the header states none.
    `content` is a copy of the frames with the true number in its header, or None if the
    file itself has it."""

    frames: int
    announced: int | None
    samples: int
    content: bytes | None

    @property
    def missing_frames(self) -> int:
        """Number of missing frames; some encoders count the header as a frame."""
        announced = self.announced or 0
        return announced - self.frames if self.frames < announced - 1 else 0


def mp3_frames(file: BinaryIO) -> Mp3 | None:
    """Return the frames of an open file, or None if it is not an MP3 file."""
    tags_end = audio_start(file)
    file.seek(tags_end)
    offset = _first_frame_position(file.read(SEARCHED_LENGTH))
    if offset is None:
        return None
    file.seek(tags_end + offset)
    data = file.read()
    header = frame_header(data, 0)
    assert header is not None, "the offset is that of a frame"
    place = _find_length_header(data, header)
    begin = 0 if place is None else header.length
    frames, end = _count_frames(data, begin, header.kind)
    if place is None:
        whole = _length_header_frame(data[:4], header, frames) + data[:end]
        return Mp3(frames, None, header.samples, whole)
    flags = unpack_from(">I", data, place + 4)[0]
    announced = unpack_from(">I", data, place + 8)[0] if flags & 1 else None
    content = data[:end] if offset else None
    if frames != announced:
        content = _with_lengths(data[:end], place, flags, frames, end)
    return Mp3(frames, announced, header.samples, content)


def frame_header(data: bytes, at: int) -> FrameHeader | None:
    """Return the header of the frame at a position, or None if there is none."""
    if at + 4 > len(data):
        return None
    word = unpack_from(">I", data, at)[0]
    version = word >> 19 & 3
    layer = word >> 17 & 3
    rate = word >> 12 & 15
    frequency = word >> 10 & 3
    if (
        word >> 21 != 0x7FF
        or version == 1
        or layer != 1
        or not 0 < rate < 15
        or frequency == 3
    ):
        return None
    first = version == 3
    samples = 1152 if first else 576
    sample_rate = SAMPLE_RATES[version][frequency]
    bits = 1000 * KILOBITS[1 if first else 2][rate]
    mono = word >> 6 & 3 == 3
    side_size = {
        (True, False): 32,
        (True, True): 17,
        (False, False): 17,
        (False, True): 9,
    }[first, mono]
    return FrameHeader(
        samples // 8 * bits // sample_rate + (word >> 9 & 1),
        samples,
        sample_rate,
        side_size,
    )


def _first_frame_position(data: bytes) -> int | None:
    """Return the position of the first frame, or None if there is none.

    Two more frames of its kind follow it, or the end of the data."""
    at = data.find(b"\xff")
    while at >= 0:
        if _begins_frames(data, at):
            return at
        at = data.find(b"\xff", at + 1)
    return None


def _begins_frames(data: bytes, at: int) -> bool:
    """Return True if three frames of one kind begin at a position, or fewer up to the
    end of the data."""
    first = frame_header(data, at)
    header = first
    for _ in range(2):
        if header is None or first is None or header.kind != first.kind:
            return False
        at += header.length
        if at >= len(data):
            return True
        header = frame_header(data, at)
    if header is None or first is None:
        return False
    return header.kind == first.kind


def _find_length_header(data: bytes, header: FrameHeader) -> int | None:
    """Return the position of the Xing or LAME header in the first frame, or None if
    there is none."""
    place = 4 + header.side_size
    return (
        place
        if data[place : place + 4] in (b"Xing", b"Info") and place + 12 <= len(data)
        else None
    )


def _count_frames(data: bytes, begin: int, kind: tuple[int, int]) -> tuple[int, int]:
    """Return the number of complete frames of a kind after `begin`, and the end of the
    last one."""
    frames = 0
    at = end = begin
    while at < len(data):
        header = frame_header(data, at)
        if header is None or header.kind != kind:
            at = data.find(b"\xff", at + 1)
            if at < 0:
                break
            continue
        at += header.length
        if at <= len(data):
            frames += 1
            end = at
    return frames, end


def _length_header_frame(start: bytes, header: FrameHeader, frames: int) -> bytes:
    """Return a silent frame that announces a number of frames; it starts with the bytes
    `start`."""
    word = unpack_from(">I", start)[0] | 1 << 16  # without a checksum
    frame = (
        pack(">I", word) + bytes(header.side_size) + b"Xing" + pack(">II", 1, frames)
    )
    return frame.ljust(header.length, b"\0")


def _with_lengths(
    data: bytes, place: int, flags: int, frames: int, length: int
) -> bytes:
    """Return the data with the numbers of frames and bytes written into the header at
    `place`.

    The final padding in the header is set to 0.
    """
    changed = bytearray(data)
    at = place + 8
    if flags & 1:
        changed[at : at + 4] = pack(">I", frames)
        at += 4
    if flags & 2:
        changed[at : at + 4] = pack(">I", length)
        at += 4
    if flags & 4:  # start of each hundredth of the time, in 256ths of the file
        changed[at : at + 100] = bytes(256 * k // 100 for k in range(100))
        at += 100
    at += 4 if flags & 8 else 0
    if data[at : at + 4] in (b"LAME", b"Lavf", b"Lavc"):
        changed[at + 22] &= 0xF0
        changed[at + 23] = 0
    return bytes(changed)
