"""Settings that several stages of the fit of recordings share."""

from dataclasses import dataclass


@dataclass(frozen=True)
class FitSettings:
    """Thresholds and step sizes of the fit; times are in seconds, frequencies in hertz."""

    block_lengths: tuple[float, ...] = (8.0, 10.0, 12.0, 16.0, 16.0)
    """Turns per block in successive rounds; short blocks tolerate a poor initial
    guess, and long blocks reduce the noise."""
    block_overlap: int = 2
    """Number of blocks that cover each instant."""
    bins_per_turn: int = 24
    """Number of means per turn of a demodulated tone."""
    phases_per_turn: int = 8
    """Phases per turn in the table of a solved motion."""
    unused_end_duration: float = 0.01
    """Length of the final part of the motion that is not used [s]."""
    max_rate_deviation: float = 0.15
    """Largest relative deviation from the expected rate that the phase slope can
    measure."""
    min_rate_error: float = 2e-4
    """Minimum relative error of the rate of a block; it allows for deviations from
    steady motion."""
    bootstrap_draws: int = 400
    """Number of bootstrap draws of the residuals."""
    equivalent_fit_ratio: float = 2.0
    """Largest ratio of spreads, and of numbers of blocks, of two equivalent fits; a
    fit with a larger spread is much worse."""
    absent_power_share: float = 0.1
    """Share of the lost power below which a law is absent, at the upper limit of
    its interval."""
    line_half_width: float = 150.0
    """Half-width of the band around a spectral line that is compared [Hz]."""


FIT = FitSettings()
"""Settings of all fits."""
