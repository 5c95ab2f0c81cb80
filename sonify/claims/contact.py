"""Findings on an elastic contact: its noise band, contact resonance, and losses of
contact."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.signal import welch
from scipy.special import ndtr

from dynamics import Motion
from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.law.linear_response import (
    predicted_power,
    predicted_rms,
    predicted_spectrum,
)
from dynamics.compliant.law.roughness import shift_of_contact
from dynamics.compliant.law.statistical_linearisation import effective_load_factor
from dynamics.compliant.law.table_receptance import RIGID_TABLE, TableReceptance
from dynamics.compliant.law.tabulated import TabulatedLaw
from dynamics.compliant.model_selection import LIFT_OFF_FORCE_RMS
from dynamics.compliant.rough_table import scene_receptance
from sonify.claims.band_causes import (
    BandCauses,
    SteadyVibration,
    band_causes,
    film_switched_off,
    stiffness_moves_carrier,
    table_moves_carrier,
)
from sonify.claims.finding import (
    Finding,
    Measured,
    finding,
    median_with_margin,
)
from sonify.claims.limits import CERTAIN_LOSS_FORCE_RMS
from sonify.claims.literature import energy_lost_by_cause
from sonify.claims.pitch import NOISE_BAND_INTERVAL, steady_line_frequencies
from sonify.claims.reference_scenes import is_toy_on_granite
from sonify.hearing.noise_band import NoiseBand, band_centroid, noise_band
from sonify.hearing.recording import Heard
from sonify.scene import Scene
from sonify.sound.pressure import Sound
from sonify.sound.radiation import listener_of
from sonify.sound.sources.contact_vibration import VibratingDisk
from sonify.sound.sources.film import radiates_above_film

MIN_OPEN_SHARE = 1e-4
"""Smallest share of the time without contact that is attributed to vibrations and not to a
slip."""


class PredictedVibration(NamedTuple):
    """Predicted contact vibration along a motion, at equally spaced times t (k,) [s].

    Attributes
    ----------
    tabulated_law : TabulatedLaw
        Tabulated law of the contact.
    t : array (k,)
        Times [s].
    inclination, load, speed : array (k,)
        Inclination [rad], normal force without vibration [N] and speed of the contact
        point [m/s].
    rolls : array (k,)
        True while the disk rolls.
    rms : array (k,)
        Rms of the vibration N' of the normal force [N].
    power : array (k,)
        Power lost to roughness [W].
    shift : array (k,)
        rms(z'') R/beta; above 1 the disk touches the table at several points.
    load_factor : array (k,)
        Factor on the load at which the linear contact has the mean stiffness of the
        vibrating one; 1 along a rigid motion.
    receptance : TableReceptance
        Receptance of the table in the contact force.
    """

    tabulated_law: TabulatedLaw
    t: np.ndarray
    inclination: np.ndarray
    load: np.ndarray
    speed: np.ndarray
    rolls: np.ndarray
    rms: np.ndarray
    power: np.ndarray
    shift: np.ndarray
    load_factor: np.ndarray
    receptance: TableReceptance = RIGID_TABLE


def predicted_vibration(scene: Scene, motion: Motion) -> PredictedVibration:
    """Return the predicted vibration along a motion while the contact is a single
    ellipse."""
    tabulated = tabulated_law_of(scene, motion)
    t = vibration_times(motion)
    inclination, load, speed, rolls = contact_conditions(motion, t)
    rms, power, shift = np.zeros((3, len(t)))
    receptance = motion.plan.contact_receptance
    if scene.roughness is not None:
        steady = tabulated, scene.roughness, inclination, load, speed
        rms = predicted_rms(*steady, receptance=receptance)
        power = predicted_power(*steady, receptance=receptance)
        half = tabulated.law.semi_axes(inclination, load)[0]
        shift = shift_of_contact(scene.roughness, inclination, half, scene.disk.radius)
    load_factor = effective_load_factors(scene, motion, t)
    return PredictedVibration(
        tabulated,
        t,
        inclination,
        load,
        speed,
        rolls,
        rms,
        power,
        shift,
        load_factor,
        receptance,
    )


def receptance_under_roughness(scene: Scene, motion: Motion) -> TableReceptance:
    """Return the receptance of the table under the vibration that the roughness of a scene
    excites.

    It is that of the plan if the motion has this roughness. A motion of the scene without
    its roughness may have a smooth contact that moves the table only at the end; the
    vibration still yields with the table, unless surface.action = 'sound'."""
    plan = motion.plan
    if plan.scene.roughness == scene.roughness:
        return plan.contact_receptance
    if scene.surface.action == "sound":
        return RIGID_TABLE
    return scene_receptance(plan.scene, plan.surface_modes)


def tabulated_law_of(scene: Scene, motion: Motion) -> TabulatedLaw:
    """Return the tabulated contact law that the motion of a scene uses."""
    plan = motion.plan
    assert plan.tabulated_law is not None  # the contact is elastic
    return plan.series_tabulated_law if motion.solves_contact else plan.tabulated_law


def effective_load_factors(scene: Scene, motion: Motion, t: np.ndarray) -> np.ndarray:
    """Return the load factors (k,) of `PredictedVibration` at ascending times t (k,)
    [s]."""
    if scene.roughness is None or not motion.solves_contact:
        return np.ones(len(t))
    some = np.linspace(t[0], t[-1], 12)
    inclination, load, speed, _ = contact_conditions(motion, some)
    tabulated = tabulated_law_of(scene, motion)
    factor = effective_load_factor(tabulated, scene.roughness, inclination, load, speed)
    return np.interp(t, some, factor)


def contact_conditions(
    motion: Motion, t: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return inclination [rad], normal force [N] and speed of the contact point [m/s],
    and a mask of rolling, each (k,), at times t (k,) [s]."""
    state = motion.at(t)
    load = motion.steady_load(t)
    turning = state[:, 6] - state[:, 7] / np.tan(state[:, 1])
    speed = np.abs(motion.disk.radius * turning + state[:, 8])
    return (
        state[:, 1],
        np.maximum(load, 0.01 * motion.disk.weight),
        speed,
        np.char.startswith(motion.regime(t), "roll"),
    )


def force_rms_along_motion(
    scene: Scene, motion: Motion, receptance: TableReceptance
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return inclination [rad], normal force [N] and predicted rms of its vibration [N],
    and a mask of rolling, each (k,), along a motion on the roughness of the scene."""
    assert scene.roughness is not None
    t = vibration_times(motion)
    inclination, load, speed, rolls = contact_conditions(motion, t)
    tabulated = tabulated_law_of(scene, motion)
    rms = predicted_rms(
        tabulated, scene.roughness, inclination, load, speed, receptance=receptance
    )
    return inclination, load, rms, rolls


def contact_findings(
    scene: Scene, motion: Motion, sound: Sound, known: Heard | None = None
) -> tuple[list[Finding], list[str]]:
    """Return the findings on an elastic contact, and notes on several simultaneous
    contacts.

    Claims about the noise band require roughness. `known` is the analysis of the sound; its
    steady spectral lines are excluded from the noise band."""
    if scene.contact.law == "rigid" or "contact" not in motion.finding_groups:
        return [], []
    expected = predicted_vibration(scene, motion)
    marked = several_contacts_notes(expected.t, expected.shift)
    found = [contact_is_lost(motion, expected)]
    if motion.contact_losses:
        found.append(micro_flights(motion))
    rough = scene.roughness
    if rough is None:
        return found, marked
    lines = steady_line_frequencies(known) if known else []
    heard = measured_noise_band(sound, motion, expected, lines)
    if np.isfinite(heard.frequency).sum() >= 3:
        found = noise_band_findings(scene, motion, expected, heard) + found
    rms = np.hypot(rough.rms or 0.0, rough.edge_rms) / 2**0.5
    if rms and not rough.profile:
        found.append(loss_begins_at(float(rms), expected))
    return [*found, roughness_ends_it(rough.loss, motion, expected)], marked


def noise_band_findings(
    scene: Scene, motion: Motion, expected: PredictedVibration, heard: NoiseBand
) -> list[Finding]:
    """Return the findings on the noise band.

    Recorded peaks are compared with the contact that was recorded: that of the toy on
    granite."""
    if scene.surface.kind != "rigid":
        causes = causes_of_band(scene, motion, expected, heard)
        return cause_findings(causes, bool(motion.film))
    bands = radiated_bands(scene, motion, expected, heard)
    found = [carrier_is_contact(bands)]
    if motion.film:
        found.append(air_moves_carrier(bands))
    if is_toy_on_granite(scene):
        found += [
            carrier_passes_recorded_peaks(expected),
            constant_peaks_are_the_contact(expected),
        ]
    return found


def measured_noise_band(
    sound: Sound,
    motion: Motion,
    expected: PredictedVibration,
    lines: Sequence[float] = (),
) -> NoiseBand:
    """Return the noise band of the pressure while the contact is a single ellipse.

    Its times are those of the motion [s].
    """
    delay = sound.source_end - motion.t[-1]
    heard = noise_band(
        sound.pressure, delay, delay + expected.t[-1], NOISE_BAND_INTERVAL, lines
    )
    return heard._replace(time=heard.time - delay)


class RadiatedBands(NamedTuple):
    """Centre frequencies (s,) [Hz] of the noise band in selected time intervals.

    Attributes
    ----------
    heard
        Measured in the sound.
    expected
        Prediction of the linear contact along the motion, including radiation into the
        air.
    force
        Frequencies of the force N' alone, solved if the motion includes it, otherwise
        predicted.
    radiated
        Frequencies of the same force, including radiation into the air.
    """

    heard: np.ndarray
    expected: np.ndarray
    force: np.ndarray
    radiated: np.ndarray


def radiated_bands(
    scene: Scene, motion: Motion, expected: PredictedVibration, heard: NoiseBand
) -> RadiatedBands:
    """Return the measured and predicted centre frequencies of the noise band."""
    assert scene.roughness is not None, "a noise band needs roughness"
    f = np.arange(500.0, 20e3, 10.0)
    over_film = radiates_above_film(motion)
    disk = VibratingDisk(scene, listener_of(scene)) if over_film else None
    found = []
    for i in predicted_intervals(heard):
        t, inclination, softened_load, *rest = interval_conditions(
            motion, expected, heard.time[i]
        )
        force = [
            predicted_spectrum(
                expected.tabulated_law, scene.roughness, b, N, V, f, rolls=r
            )
            for b, N, V, r in zip(inclination, softened_load, *rest, strict=True)
        ]
        louder = np.ones((len(t), len(f)))
        if disk:
            louder = np.array([disk.mean_square_pressure(b, f) for b in inclination])
        solved = (
            solved_spectrum(motion, (t[0], t[-1]), f)
            if motion.solves_contact
            else np.mean(force, axis=0)
        )
        powers = np.mean(louder * force, axis=0), solved, louder.mean(axis=0) * solved
        found.append(
            [
                heard.frequency[i],
                *(band_centroid(f, power, f[power.argmax()]) for power in powers),
            ]
        )
    return RadiatedBands(*np.array(found).T)


def predicted_intervals(heard: NoiseBand) -> np.ndarray:
    """Return the indices (s,) of the intervals in which the band is predicted."""
    interval_count = 12
    known = np.flatnonzero(np.isfinite(heard.frequency))
    return known[:: max(len(known) // interval_count, 1)]


def interval_conditions(
    motion: Motion, expected: PredictedVibration, middle: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return times t (k,) [s] around the middle of an interval, and there inclination
    [rad], softened load [N], speed [m/s] and rolling, each (k,)."""
    time_count = 12
    t = middle + NOISE_BAND_INTERVAL * (
        (np.arange(time_count) + 0.5) / time_count - 0.5
    )
    inclination, load, speed, rolls = contact_conditions(
        motion, np.minimum(t, expected.t[-1])
    )
    softened_load = load * np.interp(t, expected.t, expected.load_factor)
    return t, inclination, softened_load, speed, rolls


def causes_of_band(
    scene: Scene, motion: Motion, expected: PredictedVibration, heard: NoiseBand
) -> BandCauses:
    """Return the noise band of a scene with a table, with and without its causes."""
    intervals = []
    some = predicted_intervals(heard)
    for middle in heard.time[some]:
        conditions = interval_conditions(motion, expected, middle)[1:]
        intervals.append([SteadyVibration(*at) for at in zip(*conditions, strict=True)])
    return band_causes(
        scene,
        motion,
        expected.tabulated_law,
        expected.receptance,
        intervals,
        heard.frequency[some],
    )


def cause_findings(causes: BandCauses, has_film: bool) -> list[Finding]:
    """Return the findings on what sets the noise band of a scene with a table."""
    on_rigid_table = RadiatedBands(
        causes.heard, causes.without_table, causes.complete, causes.complete
    )
    found = [
        table_moves_carrier(causes),
        carrier_is_contact(on_rigid_table),
        stiffness_moves_carrier(causes),
    ]
    if has_film:
        found.append(air_moves_carrier(causes))
    return found


def solved_spectrum(
    motion: Motion, span: tuple[float, float], f: np.ndarray
) -> np.ndarray:
    """Return the power spectral density (f,) [N^2/Hz] of the normal force in a time
    span [s], at frequencies f (f,) [Hz]."""
    sample_rate = 96e3  # 1/s
    segment_length = 4096  # samples
    t = np.arange(span[0], min(span[1], motion.t[-1]), 1 / sample_rate)
    load = motion.force(t)[:, 2]
    return np.interp(f, *welch(load, sample_rate, nperseg=min(segment_length, len(t))))


@finding(needs=("motion", "contact law", "sound"), at_least=0.98, at_most=1.02)
def carrier_is_contact(found: RadiatedBands) -> Measured:
    """The median ratio of the measured to the predicted frequency of the noise band.

    With an air film, the prediction includes the effect of the film on the radiation.
    """
    ratio = median_with_margin(found.heard / found.expected)
    return ratio._replace(
        details={"force_alone": np.median(found.force / found.expected)}
    )


@finding(needs=("motion", "contact law", "sound"), at_least=1.1)
def air_moves_carrier(found: RadiatedBands | BandCauses) -> Measured:
    """The median frequency ratio of the measured noise band to that of the contact
    force; on a table, the ratio by which the film moves the band."""
    if isinstance(found, BandCauses):
        return film_switched_off(found)
    ratio = median_with_margin(found.heard / found.force)
    return ratio._replace(
        details={"force_as_radiated": np.median(found.heard / found.radiated)}
    )


@finding(needs=("motion", "contact law"), at_least=1.0)
def carrier_passes_recorded_peaks(expected: PredictedVibration) -> Measured:
    """The time [s] during which the contact resonance is within the range of the
    recorded peak."""
    # Range of the rising spectral peak recorded from the toy on granite [Hz]
    recorded_rising_peak = (1840.0, 2280.0)
    lowest, highest = recorded_rising_peak
    frequency = contact_resonance_frequency(expected)
    when = expected.t[(frequency > lowest) & (frequency < highest)]
    span = {"from": when[0], "to": when[-1]} if len(when) else {}
    end = expected.t[-1]
    count = len(expected.t)
    return Measured(len(when) * end / count, 2 * end / count, span)


@finding(needs=("motion", "contact law"), at_least=0.5)
def constant_peaks_are_the_contact(expected: PredictedVibration) -> Measured:
    """The share of the duration in which the contact resonance is within 2 % of a
    constant peak.

    The value is the greater of the shares of the two peaks.
    """
    step = expected.t[1] - expected.t[0]
    recorded_peaks = (5040.0, 8230.0)  # Hz
    frequency = contact_resonance_frequency(expected)
    stays = [
        np.sum(np.abs(frequency / peak - 1) < 0.02) * step for peak in recorded_peaks
    ]
    return Measured(max(stays) / expected.t[-1], 2 / len(expected.t))


@finding(needs=("motion", "contact law"), at_least=MIN_OPEN_SHARE)
def contact_is_lost(motion: Motion, expected: PredictedVibration) -> Measured:
    """The share of the time without contact.

    The share is solved for an elastic contact or a motion with losses of contact.
    Otherwise it is predicted for a Gaussian vibration."""
    flights = motion.contact_losses
    solved = bool(flights) or motion.solves_contact
    if solved:
        lasts = np.array([f.duration for f in flights])
        share = lasts.sum() / motion.t[-1]
        first = flights[0].t if flights else np.inf
        # flights as independent events
        margin = 2 * np.sqrt(np.sum(lasts**2)) / motion.t[-1]
    else:
        lost = open_contact_share(expected, 1.0)
        share = lost.mean()
        first = expected.t[lost > MIN_OPEN_SHARE].min(initial=np.inf)
        # factors on the rms of N' of the filter, for rolling and for sliding
        underestimation = np.where(expected.rolls, 1.1, 1.9)
        margin = open_contact_share(expected, underestimation).mean() - share
    details = {"solved": float(solved)}
    if np.isfinite(first):
        details["first"] = first
    return Measured(share, margin, details)


def open_contact_share(
    expected: PredictedVibration, factor: float | np.ndarray
) -> np.ndarray:
    """Return the share of the time (k,) without contact, for a Gaussian vibration with
    `factor` times the predicted rms."""
    return np.where(
        expected.rms > 0,
        ndtr(-expected.load / np.maximum(factor * expected.rms, 1e-300)),
        0.0,
    )


@finding(needs=("motion", "contact law"), at_most=1e-3)
def micro_flights(motion: Motion) -> Measured:
    """The duration [s] of the longest loss of contact."""
    flights = motion.contact_losses
    longest = np.sort([f.duration for f in flights])[::-1]
    details = {"number": len(flights), "height": max(f.height for f in flights)}
    return Measured(longest[0], longest[0] - longest[len(longest) // 10], details)


@finding(needs=("motion", "contact law"), at_most=1e-7)
def loss_begins_at(rms: float, expected: PredictedVibration) -> Measured:
    """The rms height [m] at which the rms of N' reaches LIFT_OFF_FORCE_RMS times the
    weight.

    It is extrapolated in proportion to the heights.
    """
    most = expected.rms.max() / expected.tabulated_law.law.disk.weight
    margin = rms * (CERTAIN_LOSS_FORCE_RMS - LIFT_OFF_FORCE_RMS) / most
    return Measured(rms * LIFT_OFF_FORCE_RMS / most, margin)


@finding(needs=("motion", "contact law"), at_least=0.5)
def roughness_ends_it(
    loss: str, motion: Motion, expected: PredictedVibration
) -> Measured:
    """The share of roughness in the energy loss.

    It consists of the solved losses in contact and creep, or of the predicted power.
    `loss` is the key `roughness.loss`, "own" or "fitted"."""
    fitted = loss == "fitted"
    where = "in addition to friction"
    if motion.solves_contact:
        taken = energy_lost_by_cause(motion)
        share = (taken["contact"] + taken["creep"]) / sum(taken.values())
        if fitted:
            where = "as a part of friction"
    else:
        took = expected.power.mean() * expected.t[-1]
        lost = motion.state[-1, 10]
        share = took / (lost if fitted else lost + took)
        where = "included in friction" if fitted else f"{where} and to this motion"
    # error of the prediction, and differences between surfaces
    relative_margin = 0.2
    words = {"where": where, "loss": loss}
    return Measured(share, relative_margin * share, words=words)


def several_contacts_notes(t: np.ndarray, shift: np.ndarray) -> list[str]:
    """Return a note on the time from which the disk touches the table at several
    points.

    The criterion is a `shift` rms(z'') R/beta (k,) above 1 at times t (k,) [s]; the
    list is empty if it is never met."""
    late = np.flatnonzero(np.asarray(shift) > 1)
    if not len(late):
        return []
    return [
        f"From t = {t[late[0]]:.4g} s on, the disk touches the table at several places at once; "
        f"the model represents them by one ellipse."
    ]


def contact_resonance_curve(
    scene: Scene, motion: Motion, delay: float
) -> tuple[np.ndarray, np.ndarray] | None:
    """Return times (k,) [s], shifted by `delay` [s], and the contact resonance (k,)
    [Hz].

    Returns None for a rigid contact and for a motion with several simultaneous
    contacts."""
    if scene.contact.law == "rigid" or "contact" not in motion.finding_groups:
        return None
    point_count = 800  # enough for the oscillation with the nutation
    t = single_ellipse_times(motion, point_count)
    inclination, load, speed, _ = contact_conditions(motion, t)
    soft = effective_load_factors(scene, motion, t) * load
    tabulated = tabulated_law_of(scene, motion)
    return t + delay, tabulated.contact_resonance(inclination, soft, speed).frequency


def contact_resonance_frequency(expected: PredictedVibration) -> np.ndarray:
    """Return the frequency of the contact resonance (k,) [Hz] along a motion."""
    return expected.tabulated_law.contact_resonance(
        expected.inclination, expected.load_factor * expected.load, expected.speed
    ).frequency


def vibration_times(motion: Motion) -> np.ndarray:
    """Return the times (k,) [s] at which the vibration of a motion is predicted."""
    time_count = 96
    return single_ellipse_times(motion, time_count)


def single_ellipse_times(motion: Motion, count: int) -> np.ndarray:
    """Return equally spaced times (count,) [s] at which the contact of a motion is a
    single ellipse."""
    return last_single_ellipse_time(motion) * (np.arange(count) + 0.5) / count


def last_single_ellipse_time(motion: Motion) -> float:
    """Return the last time [s] at which the contact of a motion is a single ellipse."""
    steep = motion.state[:, 1] >= MIN_CONTACT_INCLINATION
    return float(motion.t[steep][-1])
