"""Findings on the claims of the paper about the motion and the modes of the disk."""

from functools import lru_cache
from math import inf

import numpy as np

from dynamics import Motion
from dynamics.motion import force_at_ends_and_middles
from dynamics.observables import (
    nutation_end_time,
    nutation_frequency,
    precession_rate,
    slip_start_times,
)
from dynamics.solver_settings import MAX_AUDIBLE_FREQUENCY
from modal import Modes
from sonify.claims.finding import (
    Finding,
    Measured,
    finding,
    median_with_margin,
    rise_from_first_tenth,
)
from sonify.claims.reference_scenes import is_paper_scene
from sonify.scene import Scene

PAPER_FORCING_FREQUENCY = 2.5
"""Frequency of the normal force in figure 4, in units of 1/chi."""
PAPER_FORCING_FREQUENCY_TIME = 214.6
"""Time at which figure 4 reaches PAPER_FORCING_FREQUENCY, in units of chi."""


@finding(needs=("motion",), at_least=2.0)
def repeated_slips(motion: Motion) -> Measured:
    """The number of changes from rolling to sliding; rounding may change it by one."""
    return Measured(len(slip_start_times(motion)), 1.0)


@finding(needs=("motion",), at_least=1e-9)
def contact_kept(motion: Motion) -> Measured:
    """The smallest ratio of normal force to weight at the ends and middles of all
    pieces.

    It is 0 if contact is lost, also where the last force is zero only up to
    rounding."""
    rounding = 1e-9
    load = force_at_ends_and_middles(motion)[:, 2] / motion.disk.weight
    min_load = float(load.min())
    if motion.contact_losses or abs(min_load) < rounding:
        return Measured(0.0)
    return Measured(min_load, load[::2].min() - min_load)


@finding(needs=("motion",), at_least=1.5)
def load_frequency_rises(motion: Motion) -> Measured:
    """The ratio of the frequencies of the normal force in the last and first tenths of
    its peaks."""
    rise = rise_from_first_tenth(nutation_frequency(motion)[1])
    return rise._replace(details=nutation_end_times(motion))


def nutation_end_times(motion: Motion) -> dict[str, float]:
    """Return the times [s] at which nutation and motion end; empty if they end
    together."""
    end = nutation_end_time(motion)
    if end is None:
        return {}
    return {"nutates_until": end, "motion_ends": float(motion.t[-1])}


@finding(needs=("motion",), at_most=PAPER_FORCING_FREQUENCY_TIME, tolerance=0.5)
def load_frequency_reached(motion: Motion) -> Measured:
    """The first time, in units of chi of (4.5), at which the normal force has the
    frequency 2.5/chi."""
    chi = motion.disk.time_unit
    time, frequency = nutation_frequency(motion)
    reached = time[chi * frequency >= PAPER_FORCING_FREQUENCY]
    first = reached[0] / chi if len(reached) else inf
    return Measured(first, 1 / PAPER_FORCING_FREQUENCY, nutation_end_times(motion))


@finding(needs=("motion",), at_most=0.0, tolerance=1e-12)
def energy_falls(motion: Motion) -> Measured:
    """The greatest increase of energy between successive instants, relative to the
    initial energy.

    An increase is uncertain by the error of the energy balance."""
    gain = np.diff(motion.energy(motion.t)).max() / motion.energy(motion.t[:1])[0]
    rounding = 16 * np.finfo(float).eps
    error = motion.max_energy_error or rounding
    return Measured(gain, error if gain > rounding else rounding)


@finding(needs=("motion",), at_least=1.0)
def sliding_costs_more(motion: Motion) -> Measured:
    """The median ratio of the power lost in a slide to that in the adjacent rolling.

    The greater of the powers before and after the slide counts.
    """
    power, slides = powers_by_regime(motion)
    around = np.maximum(power[slides - 1], power[slides + 1])
    return median_with_margin(power[slides] / around)


@lru_cache(maxsize=1)
def powers_by_regime(motion: Motion) -> tuple[np.ndarray, np.ndarray]:
    """Return the mean power lost [W] in each interval of rolling or sliding, and
    indices of slides.

    The indices include only slides between two intervals of rolling.
    """
    sliding = np.char.startswith(
        motion.regime((motion.t[1:] + motion.t[:-1]) / 2), "slide"
    )
    edges = np.concatenate([[0], np.flatnonzero(np.diff(sliding)) + 1, [len(sliding)]])
    power = np.diff(motion.state[edges, 10]) / np.diff(motion.t[edges])
    first_slide = 2 if sliding[0] else 1
    return power, np.arange(first_slide, len(power) - 1, 2)


@finding(needs=("modes",), at_least=4.0)
def audible_modes(modes: Modes) -> Measured:
    """The number of modes in the audible range."""
    low, high = audible_range = (20.0, MAX_AUDIBLE_FREQUENCY)  # Hz
    distance = np.abs(np.subtract.outer(modes.frequency, audible_range)).min(axis=1)
    uncertain = distance < modes.error * modes.frequency
    inside = (modes.frequency >= low) & (modes.frequency <= high)
    return Measured(int(inside.sum()), int(uncertain.sum()))


@finding(needs=("motion",), at_most=0.1)
def centre_comes_to_rest(motion: Motion) -> Measured:
    """The ratio of the extents of the path of the centre in the last and first fifths
    of the time."""
    t = np.linspace(0, motion.t[-1], 20001)
    path = motion.at(t)[:, 3:5]
    extent = extent_ratio(path)
    return Measured(extent, abs(extent - extent_ratio(path[::2])))


def extent_ratio(path: np.ndarray) -> float:
    """Return the ratio of the extents of the last and first fifths of a path (k, 2)."""
    fifth = len(path) // 5
    return np.ptp(path[-fifth:], axis=0).max() / np.ptp(path[:fifth], axis=0).max()


@finding(needs=("motion",), at_least=0.0, tolerance=0.05)
def no_singularity(motion: Motion) -> Measured:
    """The exponent of the precession rate as a power of the remaining time."""
    min_remaining_time = max(4 * (motion.t_end - motion.t[-1]), motion.t_end * 1e-4)
    time_left = np.geomspace(
        min_remaining_time,
        min(max(motion.t_end / 20, 4 * min_remaining_time), motion.t_end),
        400,
    )
    rate = np.abs(precession_rate(motion.at(motion.t_end - time_left)))
    (exponent, _), covariance = np.polyfit(np.log(time_left), np.log(rate), 1, cov=True)
    return Measured(exponent, 2 * covariance[0, 0] ** 0.5)


def nutates_while_declining(motion: Motion) -> bool:
    """Return True if the disk nutates while its inclination falls to a quarter.

    The frequency of a steady motion then doubles."""
    time, _ = nutation_frequency(motion)
    if not len(time):
        return False
    first, last = motion.inclination(time[[0, -1]])
    return bool(last <= first / 4)


def stays_in_contact(motion: Motion) -> bool:
    """Return True if the disk touches the table for most of the time, so that it rolls
    or slides."""
    open_time = sum(loss.duration for loss in motion.contact_losses)
    return bool(open_time < motion.t[-1] / 2)


def allows_end_fit(motion: Motion) -> bool:
    """Return True if a motion comes close enough to inclination 0 for a power-law fit
    of its end."""
    return 16 * (motion.t_end - motion.t[-1]) <= motion.t_end


def motion_findings(scene: Scene, motion: Motion) -> list[Finding]:
    """Return the findings on the motion.

    Claims about rolling and sliding require a disk that stays in contact, and a power
    of sliding requires rolling before and after it. Claims about the frequency of the
    normal force require a disk that nutates while it declines; its time in figure 4
    refers to the scene of the paper alone. Claims about the end require a disk that
    settles."""
    rolls = stays_in_contact(motion)
    claims = [repeated_slips] if rolls else []
    claims.append(contact_kept)
    if nutates_while_declining(motion):
        claims.append(load_frequency_rises)
        if is_paper_scene(scene):
            claims.append(load_frequency_reached)
    claims.append(energy_falls)
    if rolls and len(powers_by_regime(motion)[1]):
        claims.append(sliding_costs_more)
    if motion.rolling_outcome.name == "SETTLED":
        claims.append(centre_comes_to_rest)
        if allows_end_fit(motion):
            claims.append(no_singularity)
    return [claim(motion) for claim in claims]


def mode_findings(modes: Modes) -> list[Finding]:
    """Return the findings on the modes."""
    return [audible_modes(modes)]


def motion_and_mode_findings(
    scene: Scene, motion: Motion, modes: Modes
) -> list[Finding]:
    """Return the findings on the motion and the modes of a run."""
    return motion_findings(scene, motion) + mode_findings(modes)
