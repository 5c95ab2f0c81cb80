"""RATTLING DISK -> FINDINGS: losses of contact and their cause, impacts, and what is heard."""

from dataclasses import replace

import numpy as np
from scipy.signal import welch

from dynamics import Outcome
from dynamics.compliant.law.unevenness import rate_exponent
from dynamics.disk import GRAVITY
from dynamics.rattling.rattling_motion import RattlingMotion, solve_rattling_motion
from modal import Modes
from sonify.claims.contact import micro_flights
from sonify.claims.finding import Finding, Measured, finding, register_judge
from sonify.claims.literature import energy_taken
from sonify.scene import Scene
from sonify.sound.pressure import Sound

MIN_RATTLING_SHARE = 0.2
"""Share of time without contact from which a disk is said to rattle."""
EXPONENT_TOLERANCE = 0.05
"""Largest difference between the exponents of the precession rate in theory and in a motion."""
FIT_SAMPLES = 400
"""Number of instants to which the law of the precession rate is fitted."""
MAX_COMPARED_TIME = 0.4
"""Longest time [s] for which a motion is solved again without modes or roughness."""
SMOOTH_RMS = 1e-12
"""Root mean square of heights [m] that no contact feels."""
LAST_SECOND = 0.05, 1.0
"""Time left [s] over which the precession rate is compared with its law."""
RATE_SCATTER = 0.08
"""Two standard deviations of the median rate over motions that differ in the seed of the
heights."""
IMPACT_COEFFICIENTS = ((1 - 0.8**2, 0.46), (1 - 0.5**2, 0.69), (1 - 0.3**2, 0.81))
"""Energy that an impact loses, over its own, and k of d beta/dt = -k sqrt(g s)/R, as means of
motions; see tests/compliant/test_rattling_disk.py."""
SCALE_FREE_EXPONENT = 1.0
"""Exponent of the power spectrum of heights without a preferred scale, H = 0."""
MODE_BAND = 0.03
"""Largest relative distance of the sound of a mode from its frequency."""
MIN_HEARD_FREQUENCY = 100.0
"""Lowest frequency [Hz] of the sound that is divided among the modes."""
WELCH_LENGTH = 8192
"""Samples of one section of the estimated spectrum."""


def rattling_findings(
    scene: Scene, motion: RattlingMotion, modes: Modes, sound: Sound
) -> list[Finding]:
    """Return the findings on a motion with contact anywhere on the rim, and on its sound."""
    found = [disk_rattles(motion)]
    if motion.contact_losses:
        found.append(micro_flights(motion))
        if scene.roughness is not None:
            found.append(vibration_opens_contact(scene, motion))
    found.append(impacts_end_it(motion))
    if scene.roughness is not None and motion.outcome in (Outcome.SETTLED, Outcome.AIRBORNE):
        found.append(rate_follows_unevenness(scene.roughness.exponent, motion))
        if scene.roughness.exponent == SCALE_FREE_EXPONENT and not scene.roughness.grain:
            found.append(rate_is_that_of_the_table(scene, motion))
    if len(modes) and np.any(modes.frequency < sound.sample_rate / 2):
        found.append(free_modes_are_heard(sound, modes))
    return found


@finding(
    "The disk rattles: it flies from crest to crest of the unevenness",
    "of the time without contact",
    "an uneven table opens the contact where the curvature of its heights exceeds that of the rim",
    needs=("motion", "contact law"),
    at_least=MIN_RATTLING_SHARE,
)
def disk_rattles(motion: RattlingMotion):
    """The share of the time without contact.

    Flights count as independent events in its margin.
    """
    lasts = motion.contact_losses.array[:, 1]
    margin = 2 * np.sqrt(np.sum(lasts**2)) / motion.t[-1]
    details = {
        "impacts_per_second": motion.impact_rate,
        "curvature_number": motion.model.curvature_number(float(motion.state[0, 1])),
        "rms_over_depth": motion.model.roughness_rms / motion.model.depth(motion.state[0, 1]),
    }
    return Measured(motion.open_share, margin, details)


@register_judge(needs=("scene", "motion", "contact law"))
def vibration_opens_contact(scene: Scene, motion: RattlingMotion) -> Finding:
    """The share of the open time that vanishes without the modes of the disk.

    The motion is solved again from the release without these modes, and without roughness. The
    margin takes the flights as independent events.
    """
    until = min(float(motion.t[-1]), MAX_COMPARED_TIME)
    limit = f"numerics.time_limit={until}"
    with_all, margin = open_share_until(motion, until)
    rigid = solve_rattling_motion(scene.replace(limit, "contact.body=rigid"))
    without_modes, own_margin = open_share_until(rigid, until)
    smooth = scene.roughness and replace(
        scene.roughness, rms=SMOOTH_RMS, rms_edge=0.0, profile=None, profile_edge=None
    )
    even = solve_rattling_motion(scene.replace(limit).part(roughness=smooth))
    without_roughness, _ = open_share_until(even, until)
    opens = "vibration" if without_modes < with_all / 2 else "unevenness"
    return Finding(
        key="vibration_opens_contact",
        claim="Vibration of the disk breaks the contact",
        value=1 - without_modes / with_all if with_all else 0.0,
        unit="of the open time, which vanishes without the modes of the disk",
        at_least=0.5,
        margin=float(np.hypot(margin, own_margin) / with_all) if with_all else 0.0,
        details={
            "open_share": with_all,
            "open_share_without_modes": without_modes,
            "open_share_without_roughness": without_roughness,
            "until": until,
        },
        cause=opens if without_roughness < with_all / 2 else "neither",
        needs=("scene", "motion", "contact law"),
        source="section 8: vibrations that the contact force excites break the contact",
    )


def open_share_until(motion: RattlingMotion, until: float) -> tuple[float, float]:
    """Return the share of the time up to `until` [s] without contact, and its margin."""
    begin, lasts = motion.contact_losses.array[:, :2].T
    inside = np.clip(np.minimum(begin + lasts, until) - begin, 0.0, None)
    return float(inside.sum() / until), float(2 * np.sqrt(np.sum(inside**2)) / until)


@register_judge(needs=("sound", "modes"))
def free_modes_are_heard(sound: Sound, modes: Modes) -> Finding:
    """The share of the sound power near the frequencies of the modes.

    The margin is the change with bands of half and of twice the width.
    """
    pressure = np.concatenate([block[:, 0] for block in sound.pressure.blocks()])
    length = min(WELCH_LENGTH, len(pressure))
    frequency, power = welch(pressure, sound.sample_rate, nperseg=length)
    audible = frequency > MIN_HEARD_FREQUENCY
    shares = []
    for width in (MODE_BAND / 2, MODE_BAND, 2 * MODE_BAND):
        distance = np.abs(frequency[:, None] / modes.frequency - 1).min(axis=1)
        near = audible & (distance < width)
        shares.append(float(power[near].sum() / power[audible].sum()))
    return Finding(
        key="free_modes_are_heard",
        claim="What is heard are the modes of the disk",
        value=shares[1],
        unit=f"of the sound power above {MIN_HEARD_FREQUENCY:g} Hz, within "
        f"{MODE_BAND:.0%} of the frequencies of the modes",
        at_least=0.5,
        margin=max(shares) - min(shares),
        needs=("sound", "modes"),
        source="recorded coins: their lines while rolling are those of the free coin within 0.3 %",
    )


@finding(
    "Impacts bring the disk to rest",
    "of the energy lost, in the dashpots of the contacts",
    "thousands of small impacts on the crests of an uneven table",
    needs=("motion", "contact law"),
    at_least=0.5,
)
def impacts_end_it(motion: RattlingMotion):
    """The share of the energy loss in the compression of the contacts.

    The margin is the energy that the balance does not explain.
    """
    taken = energy_taken(motion)
    total = sum(taken.values())
    start, end = motion.energy(motion.t[[0, -1]])
    return Measured(taken["contact"] / total, abs(start - end - total) / total)


@register_judge(needs=("motion", "contact law"))
def rate_follows_unevenness(spectrum_exponent: float, motion: RattlingMotion) -> Finding:
    """The exponent n of the precession rate ~ (t_end - t)^-n, and that of the unevenness.

    The margin is the change of the exponent if the first or the last third is left out.
    """
    expected = rate_exponent(spectrum_exponent)
    t = np.linspace(0.0, motion.t[-1], FIT_SAMPLES + 1)[:-1]
    inclination = motion.inclination(t)
    third = FIT_SAMPLES // 3
    value = fitted_exponent(t, inclination)
    others = [
        fitted_exponent(t[part], inclination[part])
        for part in (slice(third, None), slice(0, -third))
    ]
    return Finding(
        key="rate_follows_unevenness",
        claim="The precession rate rises as the spectrum of the unevenness demands",
        value=value,
        unit="exponent n of the precession rate ~ (t_end - t)^-n",
        at_least=expected,
        at_most=expected,
        tolerance=EXPONENT_TOLERANCE,
        margin=max(abs(other - value) for other in others),
        needs=("motion", "contact law"),
        source="n = (2 - H)/(4 - H) for a power spectrum k^-(1 + 2H) of the heights",
    )


@register_judge(needs=("scene", "motion", "contact law"))
def rate_is_that_of_the_table(scene: Scene, motion: RattlingMotion) -> Finding:
    """The precession rate times the root of the time left, over that of impacts alone.

    In f = (g/s)^(1/4)/(pi sqrt(k (t_end - t))) neither radius nor mass of the disk appears. The
    value is the median over the last second.
    """
    left = np.linspace(*LAST_SECOND, FIT_SAMPLES)
    left = left[left < motion.t[-1]]
    inclination = motion.inclination(motion.t[-1] - left)
    disk = scene.disk
    moment = disk.gyration / 4 + disk.aspect**2 / 3
    rate = np.sqrt(GRAVITY / (moment * disk.radius * inclination)) / (2 * np.pi)
    rms = motion.model.roughness_rms
    k = impact_coefficient(motion.model.constants.damping_ratio)
    curve = (GRAVITY / rms) ** 0.25 / (np.pi * np.sqrt(k * left))
    return Finding(
        key="rate_is_that_of_the_table",
        claim="Disks of any size share one curve of the precession rate on this table",
        value=float(np.median(rate / curve)),
        unit="precession rate over that of impacts alone, which depends on the rms of the heights "
        "and the restitution, median over the last second",
        at_least=1.0,
        at_most=1.0,
        tolerance=0.25,
        margin=RATE_SCATTER,
        details={"rate_at_1s": float((GRAVITY / rms) ** 0.25 / (np.pi * np.sqrt(k)))},
        needs=("scene", "motion", "contact law"),
        source="d beta/dt = -k sqrt(g s)/R for impacts on unevenness without a preferred scale",
    )


def impact_coefficient(damping_ratio: float) -> float:
    """Return k of d beta/dt = -k sqrt(g s)/R for contacts of a damping ratio.

    Interpolates the means of motions with the restitutions 0.3, 0.5 and 0.8 in the logarithms of k
    and of the energy that a single impact loses.
    """
    restitution = np.exp(-np.pi * damping_ratio / np.sqrt(1 - damping_ratio**2))
    loss, k = np.log(IMPACT_COEFFICIENTS).T
    slope = (k[1] - k[0]) / (loss[1] - loss[0])
    x = np.log(1 - restitution**2)
    return float(np.exp(np.interp(x, loss, k) + slope * min(x - loss[0], 0.0)))


def fitted_exponent(t: np.ndarray, inclination: np.ndarray) -> float:
    """Return n of the precession rate ~ (t_end - t)^-n for inclinations (k,) [rad] at times (k,)
    [s].

    The rate is proportional to the inverse root of the inclination. The end is the one of the best
    fit.
    """
    logarithm = np.log(inclination)
    span = t[-1] - t[0]
    best = (np.inf, 0.0)
    for end in t[-1] + span * np.geomspace(1e-4, 3.0, 300):
        line, rest, *_ = np.polyfit(np.log(end - t), logarithm, 1, full=True)
        best = min(best, (float(rest[0]), float(line[0]) / 2))
    return best[1]
