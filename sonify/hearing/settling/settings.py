"""The thresholds of the detector, each with its meaning."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Resolution:
    """Half widths below which no interval falls before it is widened: exponent, end [s], rate over
    itself."""

    exponent: float
    end: float
    rate: float


@dataclass(frozen=True)
class SettlingSettings:
    """Numbers that decide what counts as a disk coming to rest. Times are in seconds."""

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
    """Edges of the bands in which the power is followed [Hz]; bands above the Nyquist frequency are
    left out."""
    bright_from: float = 4000.0
    """Bands from this frequency on also form an average of their own [Hz]."""
    waveform_band: tuple[float, float] = (20.0, 450.0)
    """The sound itself, as opposed to its power, is searched for a tone in this band [Hz]."""
    floor_db: float = 40.0
    """The power of a band is not followed further below its running mean than this [dB]."""
    scales_ms: tuple[int, ...] = (3, 6, 12, 24)
    """Durations of a burst for which the onset strength is computed [ms]."""
    waveform_scale_ms: int = 8
    """Duration over which neighbouring samples of the waveform count as one independent sample
    [ms]."""

    heard_drop_db: float = 8.0
    """A window may end only where the power drops by this much [dB]."""
    ends_per_block: int = 6
    """Number of ends tried per block of `block` seconds, those with the largest drop."""
    block: float = 5.0
    """Length of the blocks in which ends are ranked."""
    early_stop: float = 0.04
    """Each end is tried again with a window that stops this much earlier."""
    window_lengths: tuple[float, ...] = (0.3, 0.45, 0.7, 1.05, 1.6, 2.4, 3.6)
    """Lengths of the windows tried."""

    exponents: tuple[float, float] = (0.15, 1.0)
    """Range of the exponent n of a disk, rate ~ (t_end - t)^-n."""
    rate_ratios: tuple[float, float] = (1.8, 40.0)
    """Range of the ratio of the last rate to the first within a window."""
    steady_ratio: float = 1.35
    """A rate that changes by less than this factor counts as steady."""
    least_turns: float = 8.0
    """Least number of turns, or bursts, within a window."""
    least_rate: float = 5.0
    """Least rate at the beginning of a window [Hz]."""
    most_harmonics: int = 4
    """Largest number of harmonics of the rate that are fitted."""
    shape_distance: float = 0.006
    """Distance of neighbouring shapes of the search, rms of the phase over the phase of the
    window."""
    coarse_distance: float = 0.015
    """The same in a first, coarse search of all windows."""
    rivals_from: float = 10.0
    """Rival laws are searched where a disk reaches this log likelihood in the coarse search."""
    searched_windows: int = 12
    """Number of windows of a block that are searched again, the best of the coarse search."""
    searched_channels: int = 3
    """Number of channels of such a window that are searched again."""
    refined_from: float = 6.0
    """Windows are refined, and tried with an earlier stop, if the first estimate of the score reaches
    this."""
    refined_windows: int = 6
    """Number of best windows that are refined."""

    end_range_ms: tuple[int, int] = (-2, 80)
    """Ends of a disk are tried from this to this time after the level begins to fall for good
    [ms]."""
    tone_end_range_ms: tuple[int, int] = (-30, 250)
    """The same for a tone, which may leave its band before the end [ms]."""
    fastest_standing: float = 12.0
    """A disk may stand upright only while its rate is below this [Hz], that of a coin with a radius
    of 7 mm."""
    admitted_share: float = 0.7
    """A window contributes to the intervals if its log likelihood is this share of the best
    one's."""
    admitted_length: float = 0.7
    """It contributes only if it is this long, over the best window; shorter ones are parts of it
    that tell less."""
    widest_exponent: float = 0.3
    """The exponent is called not determined if its interval is wider than this."""
    interval_factor: float = 1.16
    """Factor by which the ranges over all windows are widened, from simulated takes of known
    law."""
    repetition_resolution: Resolution = Resolution(exponent=0.014, end=0.006, rate=0.006)
    """Resolution of a run heard in the power of bands; the last interval of bursts is added to that
    of the end."""
    tone_resolution: Resolution = Resolution(exponent=0.025, end=0.025, rate=0.02)
    """The same of a tone, which leaves its band before it ends."""

    heard_score: float = 15.75
    """A run is heard from this score on."""
    false_alarms_per_hour: float = 4.4
    """Expected false events that are heard per hour of eventful sound: 3 in 480 clips of 5 s that
    were block-shuffled or phase-randomised."""
    false_alarms_per_hour_range: tuple[float, float] = (0.9, 13.0)
    """Interval of that number, 95 %."""
    false_alarm_decay: float = 3.2
    """The number of false events falls by a factor of e for this much more score; from the same
    clips."""
    alternation_score: float = 2.0
    """Bursts count as two per turn if they are predicted better by this log likelihood when they
    may alternate."""
    certain_score: float = 20.25
    """A run is certain from this score on."""
    agreeing_score: float = 13.0
    """Two windows of one end whose scores average at least this make a run certain."""
    least_rising_margin: float = 2.0
    """A run is heard only if a disk predicts better than other rising rates by this log
    likelihood."""
    pulse_slopes: tuple[float, float] = (-0.8, 0.65)
    """Range of the slope of the pulse levels [dB] against 20 log10 of the time left."""
    clear_score: float = 40.0
    """From this score on, the levels may rise more steeply towards the end, and the rate at the
    beginning of the window is free."""
    fastest_beginning: float = 40.0
    """Greatest rate at the beginning of other runs [Hz]. The pitch of a voice is above 80 Hz, and
    the detector may find half of it; a disk that turns faster has been heard before."""
    bounce_exponent: float = 0.6
    """A bouncing body has an exponent of at least this; 1 for a constant restitution, less where
    its last bounces are lost in noise."""
    bounce_slopes: tuple[float, float] = (0.65, 1.5)
    """Range of the slope of pulse levels of a bouncing body; 1 for a constant restitution."""
    bounce_separation: float = 0.4
    """A bouncing body explains every run that is less than this time away from it."""
