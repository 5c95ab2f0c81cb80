"""True lengths for sound files whose header states none, or one that was not reached.

A program that writes to a pipe cannot return to the header. FLAC then states 0 samples,
CAF a length of -1 and RF64 a length of 0 or -1; a recorder that stops without power
leaves a length of 0 in WAV. libsndfile does not decode the last samples of the first and
refuses the others. The length of a FLAC file is found by decoding: the largest stated
number whose last sample libsndfile decodes. Source: RFC 9639 (FLAC); Apple Core Audio
Format Specification 1.0; EBU Tech 3306 (RF64)."""

from bisect import bisect_left
from collections.abc import Callable, Iterator, Mapping
from io import SEEK_CUR, SEEK_END, SEEK_SET
from struct import calcsize, pack, unpack
from typing import BinaryIO, NamedTuple

UNKNOWN_SIZE = 2**64 - 1
"""Size in a header of 64 bits that states none."""
FLAC_LENGTH_BITS = 36
"""Number of bits for the number of samples in the header of a FLAC file."""


class PatchedFile:
    """Open binary file in which some bytes are replaced, by their position.

    The file has no name, because soundfile takes the format of some files from it."""

    def __init__(self, file: BinaryIO, replaced: Mapping[int, bytes]):
        self._file = file
        self._replaced = replaced
        file.seek(0)

    def read(self, count: int) -> bytes:
        """Return the next `count` bytes, or those up to the end of the file."""
        first = self._file.tell()
        data = self._file.read(count)
        for position, new in self._replaced.items():
            at = position - first
            if -len(new) < at < len(data):
                changed = bytearray(max(-at, 0)) + data
                shift = max(-at, 0)
                changed[at + shift : at + shift + len(new)] = new
                data = bytes(changed[shift : shift + len(data)])
        return data

    def seek(self, offset: int, whence: int = SEEK_SET) -> int:
        """Move to a position and return it.

        The position remains the same if the new one is invalid, as with a file that
        libsndfile opens itself; an error here cannot reach libsndfile."""
        position = self._file.tell()
        if whence == SEEK_CUR:
            offset += position
        if whence == SEEK_END:
            offset += self._file.seek(0, SEEK_END)
        is_valid = 0 <= offset < 2**63
        return self._file.seek(offset if is_valid else position)

    def tell(self) -> int:
        """Return the position."""
        return self._file.tell()


class FlacHeader(NamedTuple):
    """Number of samples in the header of a FLAC file (0 if it states none).

    `place` is the position [bytes] of eight bytes `fields` of the header, which contain the
    number."""

    announced: int
    place: int
    fields: int

    def patch(self, samples: int) -> dict[int, bytes]:
        """Return the bytes of a header that states a number of samples, by position."""
        return {
            self.place: pack(
                ">Q", self.fields >> FLAC_LENGTH_BITS << FLAC_LENGTH_BITS | samples
            )
        }


def audio_start(file: BinaryIO) -> int:
    """Return the position of the first byte after the ID3 tags at the start of a file."""
    header_size = 10  # bytes, of the tag and of its copy at the end
    start = 0
    while True:
        file.seek(start)
        head = file.read(header_size)
        if len(head) < header_size or not head.startswith(b"ID3"):
            return start
        a, b, c, d = head[6:]
        has_footer = bool(head[5] & 0x10)
        start += (a << 21 | b << 14 | c << 7 | d) + header_size * (1 + has_footer)


def patched_sizes(file: BinaryIO) -> dict[int, bytes]:
    """Return the missing sizes of a CAF, RF64 or WAV file, by their position.

    They follow from the length of the file."""
    file.seek(0)
    head = file.read(12)
    if head.startswith(b"caff"):
        return _patched_caf_sizes(file)
    if head.startswith(b"RF64") and head.endswith(b"WAVE"):
        return _patched_rf64_sizes(file)
    if head.startswith(b"RIFF") and head.endswith(b"WAVE"):
        return _patched_wav_size(file, 8 + unpack("<I", head[4:8])[0])
    return {}


def _chunks_of_file(
    file: BinaryIO, first: int, form: str
) -> Iterator[tuple[bytes, int, int]]:
    """Yield name, size and position of the content of each chunk of a file.

    `form` is the binary form of the head of a chunk, its name and its size."""
    at = first
    head_size = calcsize(form)
    while True:
        file.seek(at)
        head = file.read(head_size)
        if len(head) < head_size:
            return
        name, size = unpack(form, head)
        yield name, size, at + head_size
        at += head_size + size + (size & 1 if form.startswith("<") else 0)


def _patched_caf_sizes(file: BinaryIO) -> dict[int, bytes]:
    for name, size, content in _chunks_of_file(file, 8, ">4sQ"):
        if name == b"data":
            length = file.seek(0, SEEK_END)
            return (
                {content - 8: pack(">Q", length - content)}
                if size == UNKNOWN_SIZE
                else {}
            )
    return {}


def _patched_wav_size(file: BinaryIO, stated_length: int) -> dict[int, bytes]:
    """Return the size of the sound in a file whose header was never completed; the
    stated length of the file then ends before the sound."""
    max_size = 2**32 - 1  # bytes
    for name, size, content in _chunks_of_file(file, 12, "<4sI"):
        if name == b"data":
            held = min(file.seek(0, SEEK_END) - content, max_size)
            is_missing = size == 0 and stated_length <= content
            return {content - 4: pack("<I", held)} if is_missing else {}
    return {}


def _patched_rf64_sizes(file: BinaryIO) -> dict[int, bytes]:
    max_size = 2**32 - 1  # bytes; the size of a chunk is then in the chunk ds64
    sizes = None
    bytes_per_frame = 1
    for name, size, content in _chunks_of_file(file, 12, "<4sI"):
        file.seek(content)
        if name == b"ds64":
            sizes = content
            stated = unpack("<QQQ", file.read(24))[1]
        elif name == b"fmt ":
            bytes_per_frame = max(unpack("<12xH", file.read(14))[0], 1)
        elif name == b"data":
            length = file.seek(0, SEEK_END)
            if sizes is None or size < max_size or stated not in (0, UNKNOWN_SIZE):
                return {}
            held = length - content
            return {sizes: pack("<QQQ", length - 8, held, held // bytes_per_frame)}
    return {}


def flac_header(file: BinaryIO) -> FlacHeader | None:
    """Return the number of samples that a FLAC file states; None for other files."""
    start = audio_start(file)
    file.seek(start)
    head = file.read(26)
    if len(head) < 26 or not head.startswith(b"fLaC"):
        return None
    fields = unpack(">Q", head[18:])[0]
    return FlacHeader(fields & (1 << FLAC_LENGTH_BITS) - 1, start + 18, fields)


def largest_flac_length(holds: Callable[[int], bool]) -> int:
    """Return the largest number for which `holds` is true, as for all smaller ones."""
    upper = 1
    while upper < 1 << FLAC_LENGTH_BITS and holds(upper):
        upper *= 2
    return bisect_left(range(1, upper), True, key=lambda count: not holds(count))
