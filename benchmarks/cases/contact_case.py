"""Define benchmark problems of the elastic contact: a lossless impact, steady rolling
on roughness, and three hazards.

All problems have the disk and the table of the scene `granite`. The impact has a closed
form. The result of the rolling disk is the rms of its normal force above 200 Hz."""

from functools import cache

import numpy as np
from numba import njit
from scipy.integrate import trapezoid
from scipy.interpolate import CubicSpline
from scipy.signal import welch

from benchmarks.cases.elastic_steady_motion import steady_state
from benchmarks.timed_runs import Answer, Failure
from dynamics.compliant.law.linear_response import (
    MIN_VIBRATION_FREQUENCY,
    SAMPLES_PER_KNOT,
    MotionBlock,
    linear_contact_force_blocks,
)
from dynamics.compliant.law.linearised import mobility
from dynamics.compliant.law.roughness import (
    edge_profile,
    shift_of_contact,
    table_profile,
)
from dynamics.compliant.law.sections import Roughness
from dynamics.compliant.law.tabulated import LAW_COLUMNS, TabulatedLaw
from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.state_conversion import (
    energy,
    inclination,
    preloaded_compliant_state,
)
from dynamics.compliant.stepping.model import CompliantModel
from dynamics.compliant.stepping.state_layout import STATE
from dynamics.disk import Friction
from dynamics.stepping_core.end_reasons import EndReason
from sonify.scene import load_scene

IMPACT_SPEED = 0.02
"""Normal speed at the start of the impact [m/s]."""

IMPACT_INCLINATION = 0.3
"""Inclination of the disk during the impact [rad]."""

ROLLING_INCLINATION = 0.1
"""Inclination of the rolling disk [rad]."""

ROLLING_DURATION = 0.6
"""Duration of the rolling [s]."""

TRANSIENT_DURATION = 0.1
"""Initial part of the rolling excluded from the rms of the force [s]."""

ROUGHNESS_RMS = 1e-8
"""Rms height of table and edge [m]."""

FORCE_SAMPLE_RATE = 1e5
"""Rate of the recorded mean forces of the full model [1/s]."""

ROLLING_FRICTION = Friction(mu_static=10.0, mu_dynamic=10.0)
NO_FRICTION = Friction(mu_static=0.0, mu_dynamic=0.0)


@cache
def contact_table(loss_factor: float = 0.02) -> TabulatedLaw:
    """Return the tabulated contact law of the scene `granite` with another loss
    factor."""
    scene = load_scene("granite").replace(f"contact.loss_factor={loss_factor}")
    return TabulatedLaw(law=contact_law(scene))


def without_creep(law: TabulatedLaw):
    """Return a tabulated law with creep lengths increased by 1e9, which suppresses
    tangential creep."""
    factors = np.where(
        np.isin(
            np.arange(len(LAW_COLUMNS)),
            (LAW_COLUMNS.relaxation_length_1, LAW_COLUMNS.relaxation_length_2),
        ),
        1e9,
        1.0,
    )
    law.__dict__["spline"] = CubicSpline(law.grid, law.spline(law.grid) * factors)


@cache
def height_profiles(rms: float):
    """Return the height profiles of table and edge."""
    rough = Roughness(rms=rms)
    return table_profile(rough), edge_profile(rough, contact_table().law.disk.radius)


@cache
def hertz_impact() -> tuple[float, float]:
    """Return K/m [1/(s^2 m^0.5)] of the impact, and its largest approach (5 m v^2/4
    K)^0.4 [m]."""
    law = contact_table().law
    over_mass = float(
        law.stiffness(IMPACT_INCLINATION)
        * mobility(law.disk, IMPACT_INCLINATION, law.rolling_fillet)[0, 2, 2]
    )
    return over_mass, (5 * IMPACT_SPEED**2 / (4 * over_mass)) ** 0.4


@cache
def lossless_table() -> TabulatedLaw:
    """Return the tabulated law of a contact without loss."""
    return TabulatedLaw(law=contact_table().law, damping=0.0)


def full_model_impact(rate: float) -> Answer:
    """Return the ratios of largest approach to the exact one and of energy after to
    energy before the impact.

    They are computed by the full model."""
    model = CompliantModel(
        tabulated_law=lossless_table(), friction=NO_FRICTION, rate=rate
    )
    vars(model)["constants"] = model.constants._replace(weight=0.0)
    start = np.zeros(11)
    start[1] = IMPACT_INCLINATION
    y = preloaded_compliant_state(model, start, (0.0, 0.0, 1e-12))
    y[5] = -IMPACT_SPEED
    before = energy(model, y[None])[0]
    state = np.concatenate([piece.state for piece in model.run(y, 1, 4e-4)])
    return Answer(
        (
            -state[:, STATE.gap].min() / hertz_impact()[1],
            energy(model, state[-1:])[0] / before,
        ),
        len(state),
    )


def explicit_impact(step, rate: float) -> Answer:
    """Return the ratios of `full_model_impact` by explicit steps in one dimension,
    which are faster than steps of the disk."""
    stiffness, exact_approach = hertz_impact()
    approach, energy_ratio, steps = step(IMPACT_SPEED, 1 / rate, stiffness)
    return Answer((approach / exact_approach, energy_ratio), steps)


@njit
def leap_frog(v, h, stiffness):
    """Return largest approach, energy ratio (after to before) and number of leap-frog
    steps of the impact."""
    x = 0.0
    largest = 0.0
    initial_speed = v
    n = 0
    while x >= 0:
        v -= h / 2 * stiffness * x**1.5
        x += h * v
        v -= h / 2 * stiffness * max(x, 0.0) ** 1.5
        largest = max(largest, x)
        n += 1
    return largest, (v / initial_speed) ** 2, n


@njit
def explicit_euler(v, h, stiffness):
    """Return largest approach, energy ratio (after to before) and number of explicit
    Euler steps of the impact."""
    x = 0.0
    largest = 0.0
    initial_speed = v
    n = 0
    while x >= 0:
        speed_change = h * stiffness * x**1.5
        x += h * v
        v -= speed_change
        largest = max(largest, x)
        n += 1
    return largest, (v / initial_speed) ** 2, n


def full_model_rms(
    rate: float, beta: float = ROLLING_INCLINATION, rms: float = ROUGHNESS_RMS
) -> Answer:
    """Return the rms of the force above AUDIBLE [N] by the full model. Raises Failure
    if the solution ends early."""
    model = CompliantModel(
        tabulated_law=contact_table(),
        friction=ROLLING_FRICTION,
        profiles=height_profiles(rms),
        rate=rate,
    )
    y = preloaded_compliant_state(model, steady_state(contact_table().law, beta))
    steps_per_force = max(1, round(rate / FORCE_SAMPLE_RATE))
    pieces = list(model.run(y, steps_per_force, ROLLING_DURATION))
    if pieces[-1].end_reason != EndReason.CONTINUES:
        raise Failure(
            "the equation for the force has no solution: several contacts at once"
        )
    force = np.concatenate([piece.force[:, 2] for piece in pieces])
    return _audible_rms(force, rate / steps_per_force, int(ROLLING_DURATION * rate))


def filter_rms(
    rate: float, beta: float = ROLLING_INCLINATION, rms: float = ROUGHNESS_RMS
) -> Answer:
    """Return the rms of the force above AUDIBLE [N] by the linear filter along the
    steady motion."""
    disk = contact_table().law.disk
    knots = int(ROLLING_DURATION * rate / SAMPLES_PER_KNOT)
    t = SAMPLES_PER_KNOT / rate * np.arange(knots + 1)
    one = np.ones(knots + 1)
    w2, w3 = steady_state(contact_table().law, beta)[6:8]
    turned = abs(w2 - w3 / np.tan(beta)) * t
    path = contact_table().law.place(beta).radius * turned
    edge = disk.radius * turned
    course = MotionBlock(
        t,
        beta * one,
        disk.weight * one,
        one > 0,
        path,
        edge,
        np.zeros((knots + 1, 2)),
        0 * t,
        np.zeros(2),
    )
    try:
        force = np.concatenate(
            list(
                linear_contact_force_blocks(
                    contact_table(), [course], rate, height_profiles(rms)
                )
            )
        )[:, 1]
    except ValueError as error:
        raise Failure("a resonance turns too far in a step") from error
    return _audible_rms(force, rate, len(force))


def _audible_rms(force, rate, steps):
    """Return the rms [N] above AUDIBLE of a force sampled at `rate`, without its
    initial transient."""
    f, power = welch(
        force[int(TRANSIENT_DURATION * rate) :], rate, nperseg=int(rate / 25)
    )
    audible = f > MIN_VIBRATION_FREQUENCY
    return Answer((float(np.sqrt(trapezoid(power[audible], f[audible]))),), steps)


def relative_inclination(loss_factor: float, creeps: bool) -> Answer:
    """Return the ratio of the inclinations after 1.5 s with a step and with half of it.

    The smooth published disk slips once. Without creep the tangential springs keep
    their deformation.
    """
    found = []
    for rate in (4e5, 8e5):
        scene = load_scene("published")
        law = TabulatedLaw(law=contact_table(loss_factor).law)
        if not creeps:
            without_creep(law)
        model = CompliantModel(tabulated_law=law, friction=scene.friction, rate=rate)
        start = [
            0,
            np.radians(scene.release.inclination_deg),
            0,
            0,
            0,
            *scene.release.omega,
            0,
            0,
            0,
        ]
        *_, last = model.run(
            preloaded_compliant_state(model, np.array(start)), 100, 1.5
        )
        found.append(inclination(last.state[-1:])[0])
    return Answer((found[0] / found[1],), int(1.5 * 4e5))


def relative_energy(beta: float, rate: float = 4e5) -> Answer:
    """Return the ratio of final energy plus losses to initial energy in 0.01 s of
    smooth steady motion."""
    model = CompliantModel(
        tabulated_law=contact_table(), friction=ROLLING_FRICTION, rate=rate
    )
    y = preloaded_compliant_state(model, steady_state(contact_table().law, beta))
    first = energy(model, y[None])[0]
    *_, last = model.run(y, 1, 0.01, beta / 2)
    if last.end_reason != EndReason.CONTINUES:
        raise Failure("stops: below 5e-8 rad one ellipse is not the contact")
    lost = last.state[-1, STATE.contact_loss : STATE.film_loss].sum()
    return Answer(
        ((energy(model, last.state[-1:])[0] + lost) / first,), len(last.state)
    )


def contact_shift(rms: float) -> float:
    """Return rms(z'') R/beta of the rolling disk, a measure of the shift of the contact
    along the edge by roughness."""
    law = contact_table().law
    half = law.semi_axes(np.array([ROLLING_INCLINATION]), law.disk.weight)[0]
    return float(
        shift_of_contact(
            Roughness(rms=rms), np.array([ROLLING_INCLINATION]), half, law.disk.radius
        )[0]
    )
