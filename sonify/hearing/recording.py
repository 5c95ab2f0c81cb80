"""Analysis of a recording: rising tone, spectral lines and noise bands."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import soundfile
from scipy.signal import butter, resample_poly, sosfiltfilt

from sonify.hearing.audio_source import (
    Source,
    Truncation,
    pieces,
    source_of,
    stretch,
    truncation_of,
)
from sonify.hearing.settling.detector import SettlingRun, strongest_tone
from sonify.hearing.spectral_lines import SpectralLine, find_spectral_lines
from sonify.scene_errors import InputError

LONGEST, AFTER = 120.0, 6.0
"""Greatest length of the analysed part of a recording [s], and the length of its part
after the end of a run or after the loudest second [s]."""
SHORTEST, SLOWEST = 0.2, 1000
"""Least length [s] and least sample rate [Hz] of a recording."""
ENVELOPE_FROM, ENVELOPE_RATE = 700.0, 2000
"""Lower frequency limit of the envelope [Hz], and its sample rate [Hz]."""
FOREIGN = {
    ".3gp",
    ".aac",
    ".amr",
    ".m4a",
    ".m4v",
    ".mkv",
    ".mov",
    ".mp4",
    ".webm",
    ".wma",
}
"""Suffixes of phone and camera files that libsndfile cannot read."""


class RecordingError(InputError):
    """Error for a recording that cannot be analysed; the message is one line.

    Examples
    --------
    >>> from sonify import listen
    >>> listen("missing.wav")
    Traceback (most recent call last):
    sonify.hearing.recording.RecordingError: missing.wav: not a readable sound file: No such file or directory
    """


@dataclass(frozen=True, kw_only=True)
class Heard:
    """Analysis of a sound without knowledge of its scene.

    Attributes
    ----------
    duration : float
        Length of the sound [s].
    sample_rate : int
        Sample rate of the sound [Hz].
    start : float
        Start of the analysed part in the file [s].
    tone : SettlingRun or None
        The rising tone; None if there is none or if it was not searched for.
    carriers : list of SpectralLine
        Spectral lines and noise bands, sorted by decreasing level.
    missing : float
        Missing length of a truncated file according to its header [s].
    truncation : Truncation or None
        Lengths of a truncated file; None for a complete file.

    Examples
    --------
    >>> from sonify import Heard
    >>> heard = Heard(duration=2.0, sample_rate=48000, start=0.0, tone=None, carriers=[])
    >>> heard.lines
    []
    """

    duration: float
    sample_rate: int
    start: float
    tone: SettlingRun | None
    carriers: list[SpectralLine]
    missing: float = 0.0
    truncation: Truncation | None = None

    @property
    def lines(self) -> list[SpectralLine]:
        """The spectral lines without the noise bands."""
        return [carrier for carrier in self.carriers if not carrier.reach]


def listen(
    sound: Source | str | Path,
    end: float | None = None,
    tones: bool = True,
    begin: float = 0.0,
) -> Heard:
    """Analyse a sound; the memory use does not depend on its length.

    Parameters
    ----------
    sound : Source, str or Path
        A source, or a file of any sample rate and format that libsndfile reads.
    end : float, optional
        End of the run in the source [s]. In a long sound, spectral lines are
        sought only before it; by default around the loudest second.
    tones : bool
        Search for the strongest rising tone in the whole source.
    begin : float
        Start of the source in its file [s], added to all times of the result.

    Returns
    -------
    Heard
        Spectral lines, noise bands and rising tone.

    Raises
    ------
    RecordingError
        If the file is unreadable, too short or silent, has too low a sample rate, or
        contains nonfinite samples.

    Examples
    --------
    >>> from sonify import listen
    >>> [round(line.frequency) for line in listen("coin.wav").lines]  # doctest: +SKIP
    [4310, 8120]
    """
    samples, rate, start, duration = read(sound, end)
    truncation = truncation_of(sound)
    start += begin
    with ThreadPoolExecutor() as pool:  # the array code releases the lock of Python
        tone = pool.submit(strongest_tone, source_of(sound)) if tones else None
        found = find_spectral_lines(samples, rate, start)
    rising = tone.result() if tone else None
    return Heard(
        duration=duration,
        sample_rate=rate,
        start=start,
        tone=rising and rising.later(begin),
        carriers=found,
        missing=truncation.announced - duration
        if truncation and truncation.announced
        else 0.0,
        truncation=truncation,
    )


def read(sound: Source | str | Path, end: float | None = None):
    """Return samples (n,) of the loudest channel, their rate [Hz] and start [s], and
    the duration [s].

    For a long sound, the samples are those before its `end` [s] or around the loudest
    second. Raises RecordingError if the file is unreadable, too short or silent, has
    too low a sample rate, or contains nonfinite samples."""
    source = source_of(sound)
    name = str(getattr(source, "path", "the sound"))
    try:
        rate = source.sample_rate
        (start, stop) = _part(source, end)
        channels = stretch(source, start, stop)
    except (soundfile.LibsndfileError, OSError) as error:
        raise RecordingError(
            f"{name}: not a readable sound file: {_reason(name, error)}"
        ) from None
    if not np.isfinite(channels).all():
        raise RecordingError(f"{name}: contains samples that are not finite")
    if rate < SLOWEST:
        raise RecordingError(
            f"{name}: sample rate too low, {rate} Hz; at least {SLOWEST} Hz are required"
        )
    samples = channels[
        :, np.argmax(np.square(channels, dtype=float).sum(axis=0))
    ].astype(float)
    if len(samples) < SHORTEST * rate:
        raise RecordingError(
            f"{name}: too short, {len(samples) / rate:.3g} s; at least {SHORTEST:g} s are required"
        )
    if not np.ptp(samples):
        raise RecordingError(f"{name}: silent")
    return samples - samples.mean(), rate, start / rate, source.frames / rate


def envelope(samples, rate) -> tuple[np.ndarray, float]:
    """Return the squared sound above ENVELOPE_FROM minus its mean, and its sample rate
    [Hz]."""
    high = sosfiltfilt(
        butter(4, ENVELOPE_FROM, "highpass", fs=rate, output="sos"), samples
    )
    down = max(rate // ENVELOPE_RATE, 1)
    square = resample_poly(high * high, 1, down)
    return square - square.mean(), rate / down


def _part(source, end):
    """Return the first frame of the analysed part and the frame after the last."""
    rate = source.sample_rate
    most = int(LONGEST * source.sample_rate)
    if source.frames <= most:
        return 0, source.frames
    if end is None:
        end = float(
            np.argmax(
                [
                    np.square(second, dtype=float).sum()
                    for second in pieces(source, rate)
                ]
            )
        )
    stop = min(int((end + AFTER) * rate), source.frames)
    return max(stop - most, 0), max(stop, most)


def _reason(path, error):
    """Return the reason why a file cannot be read, or a suggestion for its
    conversion."""
    try:
        open(path, "rb").close()
    except OSError as refusal:
        return refusal.strerror
    if Path(path).suffix.lower() in FOREIGN:
        return (
            f"convert it first, e.g. ffmpeg -i {Path(path).name} {Path(path).stem}.wav"
        )
    return " ".join(str(getattr(error, "error_string", None) or error.args[-1]).split())
