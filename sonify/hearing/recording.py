"""Analysis of a recording: rising tone, spectral lines and noise bands."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
import soundfile
from scipy.signal import butter, resample_poly, sosfiltfilt

from sonify.hearing.audio_source import (
    AudioSource,
    Truncation,
    loudest_channel,
    name_of,
    overlapping_pieces,
    read_samples,
    source_of,
    truncation_of,
)
from sonify.hearing.recording_errors import RecordingError, unreadable
from sonify.hearing.settling.detector import (
    SettlingRun,
    non_overlapping_runs,
    settling_events,
    strongest_tone,
)
from sonify.hearing.settling.settling_law import SettlingLaw
from sonify.hearing.spectral_lines import SpectralLine, find_spectral_lines
from sonify.runtime.progress import Watch, ignore_progress

MAX_ANALYSED_LENGTH_S = 120.0
"""Maximum length of the part of a recording in which spectral lines are sought."""
ANALYSED_LENGTH_AFTER_END_S = 6.0
"""Length of the analysed part after the end of a run or after the loudest second."""
MIN_ENVELOPE_FREQUENCY_HZ = 700.0
"""Corner frequency of the high-pass filter before the envelope detector."""


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
    tone : SettlingLaw or None
        The rising tone: of a recording, the SettlingRun of highest score; of a known
        disk, the tone that explains most octaves of frequency. None if there is none or
        if it was not searched for.
    carriers : list of SpectralLine
        Spectral lines and noise bands, sorted by decreasing level.
    missing : float
        Missing length of a truncated file according to its header [s].
    truncation : Truncation or None
        Lengths of a truncated file; None for a complete file.
    runs : list of SettlingRun
        Disks and coins that come to rest, in order of time; empty if they were not
        searched for.

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
    tone: SettlingLaw | None
    carriers: list[SpectralLine]
    missing: float = 0.0
    truncation: Truncation | None = None
    runs: list[SettlingRun] = field(default_factory=list)

    @property
    def lines(self) -> list[SpectralLine]:
        """The spectral lines without the noise bands."""
        return [carrier for carrier in self.carriers if not carrier.reach]

    def __repr__(self) -> str:
        max_rows = 7  # of runs and of spectral lines
        rows = [
            f"{self.duration:.3f} s at {self.sample_rate} Hz, analysed from {self.start:.3f} s on",
            *(f"run: {run}" for run in self.runs[:max_rows]),
            *(
                f"{'noise band' if carrier.reach else 'line'}: {carrier.frequency:.1f} Hz "
                f"from {carrier.begin:.2f} to {carrier.end:.2f} s"
                for carrier in self.carriers[:max_rows]
            ),
        ]
        if self.tone and all(run.kind != "tone" for run in self.runs):
            rows.insert(1, f"tone: {self.tone}")
        counts = {
            "runs": len(self.runs),
            "lines and noise bands": len(self.carriers),
        }
        rows += [
            f"{count - max_rows} more {name}"
            for name, count in counts.items()
            if count > max_rows
        ]
        return "\n  ".join(["Heard(", *rows]) + "\n)"


def listen(
    sound: AudioSource | str | Path,
    end: float | None = None,
    tones: bool = True,
    begin: float = 0.0,
    watch: Watch = ignore_progress,
) -> Heard:
    """Analyse a sound in which a disk may come to rest; the memory use does not depend
    on its length.

    Parameters
    ----------
    sound : AudioSource, str or Path
        A source, or a file of any sample rate and format that libsndfile reads, or an
        export of the app phyphox.
    end : float, optional
        Time in the source [s] before which spectral lines are sought in a long sound;
        by default the end of the last run, or the loudest second if there is none.
    tones : bool
        Search the whole source for disks and coins that come to rest.
    begin : float
        Start of the source in its file [s]; it is added to all times of the result.
    watch : callable, optional
        Called with the share of the sound that is searched.

    Returns
    -------
    Heard
        Spectral lines, noise bands, runs and rising tone.

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
    source = source_of(sound)
    part = read(source, end)
    events = settling_events(source, watch) if tones else []
    runs = sorted(non_overlapping_runs(events), key=lambda run: run.start)
    if end is None and runs:
        part = read(source, runs[-1].heard_until)
    rising = [event for event in events if event.kind == "tone"]
    tone = max(rising, key=lambda event: event.score, default=None)
    heard = _with_spectral_lines(source, part, begin, tone)
    return replace(heard, runs=[run.later(begin) for run in runs])


def listen_to_known_disk(
    sound: AudioSource | str | Path, end: float | None = None
) -> Heard:
    """Analyse the sound of a disk that is known to come to rest, as in a simulation.

    Its strongest rising tone need not exceed the thresholds of the detector, and no
    runs are sought. In a long sound, spectral lines are sought only before the `end`
    [s] of the run. The errors are those of `listen`.
    """
    source = source_of(sound)
    part = read(source, end)
    with ThreadPoolExecutor() as pool:  # the array code releases the GIL
        tone = pool.submit(strongest_tone, source)
        heard = _with_spectral_lines(source, part)
    return replace(heard, tone=tone.result())


def _with_spectral_lines(
    source: AudioSource,
    part: tuple[np.ndarray, int, float, float],
    begin: float = 0.0,
    tone: SettlingLaw | None = None,
) -> Heard:
    """Return the analysis of a sound that begins at a time [s] of its file, with the
    spectral lines of the `part` that `read` returned, and with the tone of the sound."""
    samples, rate, start, duration = part
    truncation = truncation_of(source)
    start += begin
    return Heard(
        duration=duration,
        sample_rate=rate,
        start=start,
        tone=tone and tone.later(begin),
        carriers=find_spectral_lines(samples, rate, start),
        missing=truncation.announced - duration
        if truncation and truncation.announced
        else 0.0,
        truncation=truncation,
    )


def read(
    sound: AudioSource | str | Path, end: float | None = None
) -> tuple[np.ndarray, int, float, float]:
    """Return samples (n,) of the loudest channel, their rate [Hz] and start [s], and
    the duration [s].

    For a long sound, the samples are those before its `end` [s] or around the loudest
    second. Raises RecordingError if the file is unreadable, too short or silent, has
    too low a sample rate, or contains nonfinite samples."""
    min_length = 0.2  # s
    min_sample_rate = 1000  # Hz
    source = source_of(sound)
    name = name_of(source)
    try:
        rate = source.sample_rate
        start, stop = _analysed_part(source, end)
        channels = read_samples(source, start, stop)
    except soundfile.LibsndfileError as error:
        raise unreadable(name, " ".join(error.error_string.split())) from None
    except OSError as error:
        raise unreadable(name, error.strerror or str(error)) from None
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


def envelope(samples: np.ndarray, rate: float) -> tuple[np.ndarray, float]:
    """Return the squared envelope of the sound above 700 Hz without its mean, and its
    sample rate [Hz]."""
    envelope_rate = 2000  # Hz
    high = sosfiltfilt(
        butter(4, MIN_ENVELOPE_FREQUENCY_HZ, "highpass", fs=rate, output="sos"), samples
    )
    down = max(rate // envelope_rate, 1)
    square = resample_poly(high * high, 1, down)
    return square - square.mean(), rate / down


def _analysed_part(source: AudioSource, end: float | None) -> tuple[int, int]:
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
