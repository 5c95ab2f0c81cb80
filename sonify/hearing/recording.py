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
    loudest_channel,
    overlapping_pieces,
    read_samples,
    source_of,
    truncation_of,
)
from sonify.hearing.settling.detector import SettlingRun, strongest_tone
from sonify.hearing.spectral_lines import SpectralLine, find_spectral_lines
from sonify.scene_errors import InputError

MAX_ANALYSED_LENGTH_S = 120.0
"""Maximum length of the part of a recording in which spectral lines are sought."""
ANALYSED_LENGTH_AFTER_END_S = 6.0
"""Length of the analysed part after the end of a run or after the loudest second."""
MIN_ENVELOPE_FREQUENCY_HZ = 700.0
"""Corner frequency of the high-pass filter before the envelope detector."""
UNSUPPORTED_SUFFIXES = {
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
        sought only before the end, or around the loudest second if it is not given.
    tones : bool
        Search for the strongest rising tone in the whole source.
    begin : float
        Start of the source in its file [s]; it is added to all times of the result.

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
    with ThreadPoolExecutor() as pool:  # the array code releases the GIL
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
    min_length = 0.2  # s
    min_sample_rate = 1000  # Hz
    source = source_of(sound)
    name = str(getattr(source, "path", "the sound"))
    try:
        rate = source.sample_rate
        start, stop = _analysed_part(source, end)
        channels = read_samples(source, start, stop)
    except (soundfile.LibsndfileError, OSError) as error:
        raise RecordingError(
            f"{name}: not a readable sound file: {_read_failure_reason(name, error)}"
        ) from None
    if not np.isfinite(channels).all():
        raise RecordingError(f"{name}: contains samples that are not finite")
    if rate < min_sample_rate:
        raise RecordingError(
            f"{name}: sample rate too low, {rate} Hz; at least {min_sample_rate} Hz are required"
        )
    samples = loudest_channel(channels).astype(float)
    if len(samples) < min_length * rate:
        raise RecordingError(
            f"{name}: too short, {len(samples) / rate:.3g} s; at least {min_length:g} s are required"
        )
    if not np.ptp(samples):
        raise RecordingError(f"{name}: silent")
    return samples - samples.mean(), rate, start / rate, source.frames / rate


def envelope(samples, rate) -> tuple[np.ndarray, float]:
    """Return the squared envelope of the sound above 700 Hz without its mean, and its
    sample rate [Hz]."""
    envelope_rate = 2000  # Hz
    high = sosfiltfilt(
        butter(4, MIN_ENVELOPE_FREQUENCY_HZ, "highpass", fs=rate, output="sos"), samples
    )
    down = max(rate // envelope_rate, 1)
    square = resample_poly(high * high, 1, down)
    return square - square.mean(), rate / down


def _analysed_part(source, end):
    """Return the first frame of the analysed part and the frame after its last one."""
    rate = source.sample_rate
    max_frames = int(MAX_ANALYSED_LENGTH_S * rate)
    if source.frames <= max_frames:
        return 0, source.frames
    if end is None:
        seconds = overlapping_pieces(source, rate)
        energies = [np.square(second, dtype=float).sum() for second in seconds]
        end = float(np.argmax(energies))
    stop = min(int((end + ANALYSED_LENGTH_AFTER_END_S) * rate), source.frames)
    return max(stop - max_frames, 0), max(stop, max_frames)


def _read_failure_reason(path, error):
    """Return the reason why a file cannot be read, or a suggestion for its
    conversion."""
    try:
        open(path, "rb").close()
    except OSError as refusal:
        return refusal.strerror
    if Path(path).suffix.lower() in UNSUPPORTED_SUFFIXES:
        return (
            f"convert it first, e.g. ffmpeg -i {Path(path).name} {Path(path).stem}.wav"
        )
    return " ".join(str(getattr(error, "error_string", None) or error.args[-1]).split())
