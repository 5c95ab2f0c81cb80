"""Settings of the fit of recordings."""

from dataclasses import dataclass


@dataclass(frozen=True)
class FitSettings:
    """Thresholds and step sizes of the fit; times are in seconds, frequencies in hertz."""

    tone_rate: int = 4000
    """Sample rate of the signal in which a tone is demodulated [Hz]."""
    min_recording_length: float = 1.5
    """Minimum length of a recording [s]."""
    min_second_disk_score_ratio: float = 1 / 3
    """Minimum score of a second disk, relative to the best score."""
    max_end_difference: float = 0.5
    """Largest difference [s] between the ends of a tone and of a run of the same
    disk."""
    max_fitted_end_distance: float = 8.0
    """Largest distance of the fitted end from that of the run [s]."""
    neutral_spread: float = 0.05
    """Relative spread of the rates of a track that does not change its score."""
    precession_bonus: float = 5.0
    """Bonus of the precession line in the score, because the contact usually sounds
    once per turn."""
    likely_score_share: float = 0.5
    """Share of the best score above which tracks are refined by a solved motion."""
    second_score_share: float = 0.7
    """Share of the best score above which tracks are refined by a second solved
    motion."""
    max_air_factor: float = 2.0
    """Largest plausible factor on the theoretical power of the film."""
    air_penalty: float = 20.0
    """Penalty in the score per unit of a factor above `max_air_factor`."""
    min_initial_share: float = 1e-4
    """Minimum initial share of a refined search, in its unit."""
    first_block_lengths: tuple[float, ...] = (8.0,)
    """Turns per block for the first solved motion of likely tracks."""
    second_block_lengths: tuple[float, ...] = (12.0,)
    """Turns per block for the second solved motion."""
    final_block_lengths: tuple[float, ...] = (16.0,) * 4
    """Turns per block for the solved motions of the best track."""
    converged_change: float = 0.25
    """Largest change of converged shares, in standard deviations."""
    equivalent_fit_ratio: float = 2.0
    """Largest ratio of spreads, and of numbers of blocks, of two equivalent fits; a
    fit with a larger spread is much worse."""
    slip_spread: float = 2.5e-3
    """Spread of the rates due to slips; a steady motion with a smaller spread may
    be kept."""
    far_worse_ratio: float = 4.0
    """Ratio of the spread of the solved to that of the steady motion above which
    the latter is kept."""
    unknown_power_share: float = 0.004
    """Share of the power that the model may miss; for a hoop, the precession
    overestimates the power by 0.7 %, and the nutation not at all."""
    film_error: float = 0.06
    """Relative error of the power of the film; a thin-wedge law changes the share
    `rolling` by up to 8 %."""
    unexplained_spread: float = 0.01
    """Spread above which a motion does not explain the rates, unless noise explains
    the spread."""
    wrong_scene_spread: float = 0.03
    """Spread above which the recorded motion does not belong to the scene."""
    initial_shares: tuple[float, float, float] = (1e-4, 1.0, 1.0)
    """Initial shares of the LAWS."""
    ridge_error: float = 0.03
    """Relative error that the initial search assumes for the rates of a ridge."""
    clipped_sample_share: float = 1e-3
    """Minimum share of samples at full scale in a clipped sound."""
    clipped_run_length: int = 3
    """Minimum length of the runs of samples at full scale in a clipped sound."""
    near_peak_level: float = 0.98
    """Share of full scale; an unclipped tone has more samples between it and full
    scale than at full scale."""
    absent_power_share: float = 0.1
    """Share of the lost power below which a law is absent, at the upper limit of
    its interval."""
    present_power_share: float = 0.02
    """Share of the lost power above which a law is present, at the lower limit of
    its interval."""

    block_lengths: tuple[float, ...] = (8.0, 10.0, 12.0, 16.0, 16.0)
    """Turns per block in successive rounds; short blocks tolerate a poor initial
    guess, and long blocks reduce the noise."""
    rough_tolerance: float = 1e-4
    """Relative tolerance of the solution in all rounds but the last."""
    final_tolerance: float = 1e-8
    """Relative tolerance of the solution in the last round."""
    min_rate_error: float = 2e-4
    """Minimum relative error of the rate of a block; it allows for deviations from
    steady motion."""
    bootstrap_draws: int = 400
    """Number of bootstrap draws of the residuals."""
    min_bootstrap_run_blocks: int = 4
    """Minimum number of blocks per run of residuals in the bootstrap; adjacent blocks
    are correlated."""
    max_bootstrap_run_count: int = 8
    """Number of runs into which the residuals are divided if the runs are long
    enough."""
    unused_end_duration: float = 0.01
    """Length of the final part of the motion that is not used [s]."""
    high_pass_corner: float = 50.0
    """Corner frequency of the high-pass filter of a recorder, and its uncertainty
    [Hz]."""
    max_corner_factor: float = 4.0
    """Largest corner frequency, in units of `high_pass_corner`."""
    phase_derivative_step: float = 1e-3
    """Relative step of the remaining time in the numerical derivative of the
    phase."""
    share_units: tuple[float, float, float] = (1e-5, 0.05, 0.05)
    """Minimum units of the shares of the LAWS in the search."""

    bins_per_turn: int = 24
    """Number of means per turn."""
    max_rate_deviation: float = 0.15
    """Largest relative deviation from the expected rate that the phase slope can
    measure."""
    min_tone_to_noise: float = 4.0
    """Minimum ratio of tone power to noise power in a clear block."""
    max_blocks: int = 300
    """Largest number of blocks of a sound."""
    block_overlap: int = 2
    """Number of blocks that cover each instant."""
    min_clear_block_share: float = 0.5
    """Minimum share of clear blocks in a tone; in noise and speech, a tenth of the
    blocks are clear."""

    min_time_left: float = 2e-3
    """Minimum remaining time [s] at which a solved motion is tabulated."""
    solved_time_count: int = 4000
    """Number of times in the table of a solved motion."""
    phases_per_turn: int = 8
    """Phases per turn in the table of a solved motion."""
    motion_tolerance: float = 1e-12
    """Relative tolerance of a solved motion, which gives an error of 0.01 turns in
    1000 turns."""
    turns_per_block: int = 16
    """Number of turns over which a solved motion is averaged, as in the analysis of
    a sound."""
    nutation_inclinations: tuple[float, ...] = (0.005, 0.02, 0.08, 0.3)
    """Inclinations at which the nutation rate is computed [rad]."""
    min_rolling_share: float = 1e-12
    """Minimum total dissipation, as a share of contour friction."""
    min_film_power_share: float = 1e-7
    """Minimum power of the film, as a share of contour friction; without this limit, the
    disk would never reach the table, and the end would depend on inaudible
    details."""
    min_air_share: float = 1e-3
    """Share below which the film is omitted from the solved motion."""
    min_inclination: float = 1e-7
    """Minimum tabulated inclination [rad]."""
    inclination_count: int = 600
    """Number of tabulated inclinations, evenly spaced in the logarithm."""
    min_time_exponent: float = 0.49
    """Minimum exponent of the remaining time as a power of inclinations below the
    tabulated ones. It is 1/2 with the arms of the paper, and would be 0 for a
    squeezed film alone."""

    contour_exponent: float = 1 / 3
    """Exponent of the rate of a disk slowed by contour friction."""
    max_impact_exponent: float = 0.6
    """Exponent for H = -1, an unevenness with increasingly steep short waves."""

    comparison_parts: int = 4
    """Number of parts of a run; their scatter gives the intervals."""
    max_compared_lines: int = 6
    """Largest number of spectral lines that are compared; the strongest are
    chosen."""
    line_half_width: float = 150.0
    """Half-width of the band around a line [Hz]."""
    line_power_averaging_time: float = 0.01
    """Averaging time [s] for the power of a line, longer than the beats of a pair
    of modes."""
    min_amplitude_fall: float = 0.5
    """Minimum fall of the logarithm of the amplitude that counts as a decay."""
    min_fall_count: int = 5
    """Minimum number of falls from which a decay rate is determined."""
    loudness_window: float = 0.1
    """Window for the level over time [s]."""

    wrong_radius_factors: tuple[float, float] = (0.9, 1.1)
    """Factors on the radius for which every fit is repeated."""
    min_parallel_recordings: int = 3
    """Minimum number of recordings that are distributed to worker processes."""


FIT = FitSettings()
"""Settings of all fits."""
