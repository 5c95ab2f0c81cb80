"""Settings of the detector of settling disks and coins."""

from dataclasses import dataclass
from math import inf


@dataclass(frozen=True)
class Resolution:
    """Minimum half-widths of the intervals of exponent, end [s] and relative rate, before
    widening."""

    exponent: float
    end: float
    rate: float


@dataclass(frozen=True)
class SettlingSettings:
    """Criteria for the detection of a disk that comes to rest; times are in seconds."""

    band_edges: tuple[float, ...] = (
        700,
        1000,
        1400,
        2000,
        2800,
        4000,
        5600,
        8000,
        11200,
        16000,
        21000,
    )
    """Edges of the bands in which the power is analysed [Hz]."""
    max_frequency_per_rate: float = 0.45
    """Highest analysed frequency, relative to the sample rate."""
    min_bright_frequency: float = 4000.0
    """Frequency [Hz] above which the bands are also averaged separately."""
    waveform_band: tuple[float, float] = (20.0, 450.0)
    """Band of the waveform in which a tone is scored [Hz]."""
    min_tone_octaves: float = 2.0
    """Minimum number of octaves of the remaining time in which a tone has peaks; sounds
    without a disk reach 1.7."""
    min_tone_rise_octaves: float = 0.5
    """Minimum number of octaves by which a tone rises."""
    min_tone_stop_time: float = 0.02
    """Minimum time between the windows of a tone and its end."""
    floor_db: float = 40.0
    """Level below the running mean at which the power of a band is cut off [dB]."""
    scales_ms: tuple[int, ...] = (3, 6, 12, 24)
    """Burst durations for which the onset strength is computed [ms]."""
    waveform_scale_ms: int = 8
    """Time per independent sample of the waveform [ms]."""

    min_drop_db: float = 8.0
    """Minimum drop of the power at the end of a window [dB]."""
    ends_per_block: int = 6
    """Number of ends that are tried in each block; those with the largest drops are
    chosen."""
    block_length: float = 5.0
    """Length of the blocks in which ends are ranked."""
    early_stop_time: float = 0.04
    """Time by which the second window of each end stops before the first."""
    window_lengths: tuple[float, ...] = (0.3, 0.45, 0.7, 1.05, 1.6, 2.4, 3.6)
    """Lengths of the windows that are tried."""

    exponents: tuple[float, float] = (0.15, 1.0)
    """Range of the exponent n of a disk, rate ~ (t_end - t)^-n."""
    rate_ratios: tuple[float, float] = (1.8, 40.0)
    """Range of the ratio of the last to the first rate within a window."""
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
    searched_window_count: int = 12
    """Number of best windows of the coarse search that are searched again in each
    block."""
    searched_channel_count: int = 3
    """Number of channels that are searched again in each of these windows."""
    min_score_for_refinement: float = 6.0
    """Minimum estimated score of a window that is refined and tried with an earlier
    stop."""
    refined_window_count: int = 6
    """Number of best windows that are refined."""

    end_range_ms: tuple[int, int] = (-2, 80)
    """Range of the tested end times of a law, measured from the start of the final fall
    of the level [ms]."""
    max_upright_rate: float = 12.0
    """Largest rate of an upright disk [Hz], that of a coin with a radius of 7 mm."""
    min_admitted_likelihood: float = 0.7
    """Minimum log likelihood of a window that contributes to the intervals, relative to
    that of the best window."""
    min_admitted_length: float = 0.7
    """Minimum length of such a window, relative to that of the best window; shorter
    windows contain less information."""
    max_exponent_interval: float = 0.3
    """Largest width of the interval of a determined exponent."""
    interval_factor: float = 1.16
    """Factor by which the ranges over all windows are widened, from simulations with
    known laws."""
    resolution: Resolution = Resolution(exponent=0.010, end=0.006, rate=0.006)
    """Resolution of a run detected in the power of bands; the resolution of the end also
    includes the last interval between bursts."""
    tone_resolution: Resolution = Resolution(exponent=0.001, end=0.002, rate=0.002)
    """Resolution of a tone, which is added to twice its standard errors."""

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
    min_alternation_gain: float = 2.0
    """Minimum gain in log likelihood by bursts of alternating strength, above which each
    turn has two bursts."""
    min_certain_score: float = 20.25
    """Minimum score of a certain run."""
    min_agreeing_score: float = 13.0
    """Minimum mean score of two windows with the same end that make a run certain."""
    min_rising_margin: float = 2.0
    """Minimum margin in the log likelihood of a detected disk over other rising rates."""
    pulse_slopes: tuple[float, float] = (-0.8, 0.65)
    """Range of the slope of pulse levels [dB] against 20 log10 of the remaining
    time."""
    min_clear_score: float = 40.0
    """Score above which the levels may rise more steeply towards the end and the
    initial rate of the window is not limited."""
    max_initial_rate: float = 40.0
    """Largest initial rate of other runs [Hz]. The pitch of a voice is above 80 Hz, and
    the detector may find half of it; a faster disk would already have been detected."""
    min_bounce_exponent: float = 0.6
    """Minimum exponent of a bouncing body; it is 1 for a constant restitution, and less
    if the last bounces are lost in noise."""
    bounce_slopes: tuple[float, float] = (0.65, 1.5)
    """Range of the slope of pulse levels of a bouncing body, which is 1 for a constant
    restitution."""
    max_bounce_distance: float = 0.4
    """Largest time between a bouncing body and the runs that it explains."""
    has_several_tones: bool = True
    """True to search the parts before and after a tone for further tones."""


KNOWN_DISK_SETTINGS = SettlingSettings(
    min_detected_score=-inf,
    min_rising_margin=-inf,
    min_clear_score=-inf,
    pulse_slopes=(-inf, inf),
    min_bounce_exponent=inf,
    has_several_tones=False,
)
"""Settings for the sound of one known disk, in which a tone must merely stand out. The
resonances of a table shift the phase of a tone and lower its score."""
