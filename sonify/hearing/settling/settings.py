"""Settings of the detector of settling disks and coins."""

from dataclasses import dataclass


@dataclass(frozen=True)
class SettlingSettings:
    """Criteria for the detection of a disk that comes to rest; times are in seconds."""

    max_frequency_per_rate: float = 0.45
    """Highest analysed frequency, relative to the sample rate."""
    waveform_band: tuple[float, float] = (20.0, 450.0)
    """Band of the waveform in which a tone is scored [Hz]."""
    window_lengths: tuple[float, ...] = (0.3, 0.45, 0.7, 1.05, 1.6, 2.4, 3.6)
    """Lengths of the windows that are tried."""

    exponents: tuple[float, float] = (0.15, 1.0)
    """Range of the exponent n of a disk, rate ~ (t_end - t)^-n."""
    rate_ratios: tuple[float, float] = (1.8, 40.0)
    """Range of the ratio of the last to the first rate within a window."""
    min_rate_ratio_without_end: float = 1.5
    """Minimum ratio if the sound stops before the end of the disk."""
    max_steady_ratio: float = 1.35
    """Largest factor by which a steady rate may change within a window."""
    min_turns: float = 8.0
    """Minimum number of turns, or bursts, within a window."""
    min_initial_rate: float = 5.0
    """Minimum rate at the beginning of a window [Hz]."""
    max_harmonics: int = 4
    """Largest number of fitted harmonics of the rate."""
    shape_distance: float = 0.006
    """Distance of neighbouring shapes in the search, as the rms difference of the
    relative phase."""
    coarse_distance: float = 0.015
    """Distance of neighbouring shapes in a first, coarse search of all windows."""
    min_likelihood_for_rivals: float = 10.0
    """Minimum log likelihood of a disk in the coarse search for which rival laws are
    tested."""

    max_upright_rate: float = 12.0
    """Largest rate of an upright disk [Hz], that of a coin with a radius of 7 mm."""
    min_admitted_likelihood: float = 0.7
    """Minimum log likelihood of a window that contributes to the intervals, relative to
    that of the best window."""
    exponent_resolution: float = 0.010
    """Minimum half-width of the interval of the exponent, before widening, of a run
    detected in the power of bands."""
    max_exponent_interval: float = 0.3
    """Largest width of the interval of a determined exponent."""

    min_detected_score: float = 15.75
    """Minimum score of a detected run."""
    false_alarms_per_hour: float = 1.5
    """Expected number of false detections per hour of eventful sound, from one
    detection in 480 clips of 5 s that were block-shuffled or phase-randomised; it is
    the same at sample rates of 44.1 and 8 kHz."""
    false_alarms_per_hour_range: tuple[float, float] = (0.04, 8.4)
    """95 % interval of this number."""
    false_alarm_decay: float = 3.2
    """Increase of the score by which the number of false detections falls by a factor
    of e: the upper 95 % limit for 25 detections above a score of 11 in the same
    clips."""
    min_certain_score: float = 20.25
    """Minimum score of a certain run."""
    min_clear_score: float = 40.0
    """Score above which the levels may rise more steeply towards the end and the
    initial rate of the window is not limited."""
    max_initial_rate: float = 40.0
    """Largest initial rate of other runs [Hz]. The pitch of a voice is above 80 Hz, and
    the detector may find half of it; a faster disk would already have been detected."""


SETTLING = SettlingSettings()
"""Settings of all detections."""
