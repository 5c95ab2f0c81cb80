"""Findings on a rattling disk: losses of contact and their cause, impacts, and
sound."""

from dataclasses import replace
from typing import cast

import numpy as np
from scipy.signal import welch

from dynamics import Motion, Outcome
from dynamics.compliant.law.unevenness import (
    precession_rate_exponent,
    restitution_of_patch,
)
from dynamics.disk import GRAVITY
from dynamics.rattling.rattling_motion import (
    RattlingMotion,
    effective_restitution,
    solve_rattling_motion,
)
from modal import Modes
from sonify.claims.contact import micro_flights
from sonify.claims.finding import Finding, Measured, finding
from sonify.claims.limits import MODE_BAND_HALF_WIDTH
from sonify.claims.literature import energy_lost_by_cause
from sonify.scene import Scene
from sonify.sound.pressure import Sound

FITTED_INSTANT_COUNT = 400
"""Number of instants in the fit of the precession rate."""


def rattling_findings(
    scene: Scene, motion: Motion, modes: Modes, sound: Sound
) -> list[Finding]:
    """Return the findings on a rattling motion and its sound; none on other motions."""
    if "rattling" not in motion.finding_groups:
        return []
    return findings_on_rattling(scene, cast(RattlingMotion, motion), modes, sound)


def findings_on_rattling(
    scene: Scene, motion: RattlingMotion, modes: Modes, sound: Sound
) -> list[Finding]:
    """Return the findings on a rattling motion and its sound."""
    found = [disk_rattles(motion)]
    if motion.contact_losses:
        found.append(micro_flights(motion))
    found.append(impacts_end_it(motion))
    rough = scene.roughness
    ended = motion.outcome is Outcome.AT_REST
    if rough is not None and ended:
        found.append(rate_follows_unevenness(rough.exponent, motion))
        if rough.exponent == 1.0:  # heights without a preferred scale, H = 0
            found.append(rate_is_that_of_the_table(scene, motion))
    if len(modes) and np.any(modes.frequency < sound.sample_rate / 2):
        found.append(free_modes_are_heard(sound, modes))
    return found


@finding(needs=("motion", "contact law"), at_least=0.2)
def disk_rattles(motion: RattlingMotion) -> Measured:
    """The share of the time without contact.

    The margin assumes that the flights are independent events.
    """
    lasts = motion.contact_losses.array[:, 1]
    margin = 2 * np.sqrt(np.sum(lasts**2)) / motion.t[-1]
    model = motion.model
    release = float(motion.state[0, 1])
    speed = float(np.sqrt(GRAVITY * max(model.roughness_rms, model.depth(release))))
    details = {
        "impacts_per_second": motion.impact_rate,
        "curvature_number": model.curvature_number(release),
        "rms_over_depth": model.roughness_rms / model.depth(release),
        "effective_restitution": effective_restitution(model, release, speed),
    }
    return Measured(motion.open_share, margin, details)


def open_share_without_modes(scene: Scene, motion: Motion) -> Measured:
    """Return the share of the time without contact that vanishes in a motion without the
    disk modes.

    The motion is repeated from the release without these modes and without roughness.
    The margin assumes that the flights are independent events."""
    max_repeated_duration = 0.4  # s
    if not motion.contact_losses:
        return Measured(0.0)
    motion = cast(RattlingMotion, motion)
    until = min(float(motion.t[-1]), max_repeated_duration)
    numerics = replace(scene.numerics, time_limit=until)
    with_all, margin_with_all = open_share_until(motion, until)
    body = replace(scene.contact, body="rigid")
    rigid = solve_rattling_motion(motion.plan.part(numerics=numerics, contact=body))
    without_modes, margin_without_modes = open_share_until(rigid, until)
    smooth_rms = 1e-12  # m; too small to affect a contact
    smooth = scene.roughness and replace(
        scene.roughness, rms=smooth_rms, rms_edge=0.0, profile=None, profile_edge=None
    )
    even = solve_rattling_motion(motion.plan.part(numerics=numerics, roughness=smooth))
    without_roughness, _ = open_share_until(even, until)
    opens = "vibration" if without_modes < with_all / 2 else "unevenness"
    details = {
        "open_share": with_all,
        "open_share_without_modes": without_modes,
        "open_share_without_roughness": without_roughness,
        "until": until,
    }
    cause = opens if without_roughness < with_all / 2 else "neither"
    vanishes = margin = 0.0
    if with_all:
        vanishes = 1 - without_modes / with_all
        margin = np.hypot(margin_with_all, margin_without_modes) / with_all
    return Measured(vanishes, margin, details, fields={"cause": cause})


def open_share_until(motion: RattlingMotion, until: float) -> tuple[float, float]:
    """Return the share of the time without contact up to `until` [s], and its
    margin."""
    begin, lasts = motion.contact_losses.array[:, :2].T
    inside = np.clip(np.minimum(begin + lasts, until) - begin, 0.0, None)
    return float(inside.sum() / until), float(2 * np.sqrt(np.sum(inside**2)) / until)


@finding(needs=("sound", "modes"), at_least=0.5)
def free_modes_are_heard(sound: Sound, modes: Modes) -> Measured:
    """The share of the sound power near the frequencies of the modes.

    The margin is the change of the share if the bands are half or twice as wide.
    """
    min_heard_frequency = 100.0  # Hz
    welch_length = 8192  # samples
    pressure = np.concatenate([block[:, 0] for block in sound.pressure.blocks()])
    length = min(welch_length, len(pressure))
    frequency, power = welch(pressure, sound.sample_rate, nperseg=length)
    audible = frequency > min_heard_frequency
    distance = np.abs(frequency[:, None] / modes.frequency - 1).min(axis=1)
    shares = []
    for factor in (0.5, 1.0, 2.0):
        near = audible & (distance < factor * MODE_BAND_HALF_WIDTH)
        shares.append(float(power[near].sum() / power[audible].sum()))
    return Measured(shares[1], max(shares) - min(shares))


@finding(needs=("motion", "contact law"), at_least=0.5)
def impacts_end_it(motion: RattlingMotion) -> Measured:
    """The share of the energy loss in the compression of the contacts.

    The margin is the relative error of the energy balance.
    """
    taken = energy_lost_by_cause(motion)
    total = sum(taken.values())
    start, end = motion.energy(motion.t[[0, -1]])
    return Measured(taken["contact"] / total, abs(start - end - total) / total)


@finding(needs=("motion", "contact law"), tolerance=0.05)
def rate_follows_unevenness(
    spectrum_exponent: float, motion: RattlingMotion
) -> Measured:
    """The exponent n of the precession rate ~ (t_end - t)^-n.

    The expected value follows from the spectrum of the unevenness. The margin is the
    change of n if the first or the last third of the motion is excluded."""
    expected = precession_rate_exponent(spectrum_exponent)
    t = np.linspace(0.0, motion.t[-1], FITTED_INSTANT_COUNT, endpoint=False)
    inclination = motion.inclination(t)
    third = len(t) // 3
    value = precession_exponent(t, inclination)
    others = [
        precession_exponent(t[part], inclination[part])
        for part in (slice(third, None), slice(0, -third))
    ]
    margin = max(abs(other - value) for other in others)
    return Measured(value, margin, fields={"at_least": expected, "at_most": expected})


@finding(
    needs=("scene", "motion", "contact law"), at_least=1.0, at_most=1.0, tolerance=0.25
)
def rate_is_that_of_the_table(scene: Scene, motion: RattlingMotion) -> Measured:
    """The ratio of the precession rate to that of a disk slowed by impacts alone.

    The latter, f = (g/s)^(1/4)/(pi sqrt(k (t_end - t))), is independent of radius and
    mass of the disk. The value is the median over the last second."""
    left = np.linspace(0.05, 1.0, FITTED_INSTANT_COUNT)
    left = left[left < motion.t[-1]]
    inclination = motion.inclination(motion.t[-1] - left)
    disk = scene.disk
    moment = disk.gyration / 4 + disk.aspect**2 / 3
    rate = np.sqrt(GRAVITY / (moment * disk.radius * inclination)) / (2 * np.pi)
    rms = motion.model.roughness_rms
    k = impact_coefficient(motion.model.constants.damping_ratio)
    curve = (GRAVITY / rms) ** 0.25 / (np.pi * np.sqrt(k * left))
    two_sigma_scatter = 0.08  # over seeds of the heights
    details = {"rate_at_1s": (GRAVITY / rms) ** 0.25 / (np.pi * np.sqrt(k))}
    return Measured(np.median(rate / curve), two_sigma_scatter, details)


def impact_coefficient(damping_ratio: float) -> float:
    """Return k of d beta/dt = -k sqrt(g s)/R for contacts with a damping ratio.

    Mean values of simulated motions are interpolated in log k and the logarithm of the
    relative energy loss per impact."""
    # restitution and k; tests/stepping/test_rattling_disk.py integrates the motions
    means = ((0.793, 0.44), (0.523, 0.68), (0.370, 0.785), (0.1, 0.83))
    restitution, k = np.array(means).T
    loss = np.log(1 - restitution**2)
    log_k = np.log(k)
    slope = (log_k[1] - log_k[0]) / (loss[1] - loss[0])
    x = np.log(1 - restitution_of_patch(damping_ratio) ** 2)
    return float(np.exp(np.interp(x, loss, log_k) + slope * min(x - loss[0], 0.0)))


def precession_exponent(t: np.ndarray, inclination: np.ndarray) -> float:
    """Return n of the precession rate ~ (t_end - t)^-n for inclinations (k,) [rad] at
    times (k,) [s].

    The rate is proportional to the inverse square root of the inclination; t_end is
    fitted."""
    logarithm = np.log(inclination)
    span = t[-1] - t[0]
    best = (np.inf, 0.0)
    for end in t[-1] + span * np.geomspace(1e-4, 3.0, 300):
        line, rest, *_ = np.polyfit(np.log(end - t), logarithm, 1, full=True)
        best = min(best, (float(rest[0]), float(line[0]) / 2))
    return best[1]
