"""What the methods for an elastic contact are asked for: a lossless impact, steady rolling on roughness, three hazards.

All of the toy on granite. The impact has a closed form; the rolling disk is judged by the rms of its normal force above
200 Hz.
"""

from functools import cache

import numpy as np
from numba import njit
from scipy.integrate import trapezoid
from scipy.interpolate import CubicSpline
from scipy.signal import welch

from dynamics.coupled.filter import AUDIBLE, EVERY, Along, respond
from dynamics.coupled.from_scene import contact_law
from dynamics.coupled.full import Compliant
from dynamics.coupled.handover import energy, inclination, release
from dynamics.coupled.march import GOES
from dynamics.coupled.resonance import mobility
from dynamics.coupled.roughness import edge_profile, shift_of_contact, table_profile
from dynamics.coupled.sections import Roughness
from dynamics.coupled.state import GAP, LOSSES, WEIGHT
from dynamics.coupled.table import LENGTH1, LENGTH2, LawTable
from dynamics.disk import Friction
from sonify.charts.records import Answer, Failure
from sonify.claims.halt import steady
from sonify.scene import load_scene

SPEED, STEEP, FLAT = 0.02, 0.3, 0.1
"""Speed of the impact [m/s]; inclinations of the impact and of the rolling disk [rad]."""
SECONDS, SETTLED = 0.6, 0.1
"""Duration of the rolling, and what of it is not judged [s]."""
RMS = 1e-8
"""Of the heights of table and edge [m]."""
FORCES = 1e5
"""Mean forces a second of the full model that are judged [1/s]."""
GRIPS, FREE = Friction(mu_static=10.0, mu_dynamic=10.0), Friction(mu_static=0.0, mu_dynamic=0.0)


@cache
def table(loss_factor: float = 0.02) -> LawTable:
    """Return the law of the toy on granite."""
    scene = load_scene("granite").replace(f"contact.loss_factor={loss_factor}")
    return LawTable(law=contact_law(scene))


def without_creep(law: LawTable):
    """Make the springs of a tabulated law forget over no length."""
    factors = np.where(np.isin(np.arange(7), (LENGTH1, LENGTH2)), 1e9, 1.0)
    law.__dict__["spline"] = CubicSpline(law.grid, law.spline(law.grid) * factors)


@cache
def profiles(rms: float):
    """Return the heights of table and edge."""
    rough = Roughness(rms=rms)
    return table_profile(rough), edge_profile(rough, table().law.disk.radius)


@cache
def hertz() -> tuple[float, float]:
    """Return K/m [1/(s^2 m^0.5)] of the impact, and its greatest approach (5 m v^2/4 K)^0.4 [m]."""
    law = table().law
    over_mass = float(law.stiffness(STEEP) * mobility(law.disk, STEEP)[0, 2, 2])
    return over_mass, (5 * SPEED**2 / (4 * over_mass)) ** 0.4


@cache
def lossless() -> LawTable:
    """Return the law of a contact without loss, tabulated."""
    return LawTable(law=table().law, damping=0.0)


def impact(rate: float) -> Answer:
    """Return greatest approach over the exact one, and energy after over that before, of the full model's impact."""
    model = Compliant(table=lossless(), friction=FREE, rate=rate)
    model.constants[WEIGHT] = 0.0
    start = np.zeros(11)
    start[1] = STEEP
    y = release(model, start, (0.0, 0.0, 1e-12))
    y[5] = -SPEED
    before = energy(model, y[None])[0]
    state = np.concatenate([piece.state for piece in model.run(y, 1, 4e-4)])
    return Answer((-state[:, GAP].min() / hertz()[1], energy(model, state[-1:])[0] / before), len(state))


def explicit_impact(step, rate: float) -> Answer:
    """The same by explicit steps of the impact in one dimension, whose seconds are less than those of a disk."""
    stiffness, deepest = hertz()
    depth, kept, steps = step(SPEED, 1 / rate, stiffness)
    return Answer((depth / deepest, kept), steps)


@njit
def leap_frog(v, h, stiffness):
    """Kick, drift, kick: return greatest depth, energy after over before, steps."""
    x, most, begin, n = 0.0, 0.0, v, 0
    while x >= 0:
        v -= h / 2 * stiffness * x**1.5
        x += h * v
        v -= h / 2 * stiffness * max(x, 0.0) ** 1.5
        most, n = max(most, x), n + 1
    return most, (v / begin) ** 2, n


@njit
def explicit_euler(v, h, stiffness):
    """Both ends from the beginning: return greatest depth, energy after over before, steps."""
    x, most, begin, n = 0.0, 0.0, v, 0
    while x >= 0:
        x, v = x + h * v, v - h * stiffness * x**1.5
        most, n = max(most, x), n + 1
    return most, (v / begin) ** 2, n


def full(rate: float, beta: float = FLAT, rms: float = RMS) -> Answer:
    """Return the rms of the force above AUDIBLE [N] by the full model. Raises Failure where it ends."""
    model = Compliant(table=table(), friction=GRIPS, profiles=profiles(rms), rate=rate)
    y, every = release(model, steady(table().law.disk, beta)), max(1, round(rate / FORCES))
    pieces = list(model.run(y, every, SECONDS))
    if pieces[-1].why != GOES:
        raise Failure("the equation for the force has no solution: several contacts at once")
    return _heard(np.concatenate([piece.force[:, 2] for piece in pieces]), rate / every, int(SECONDS * rate))


def filtered(rate: float, beta: float = FLAT, rms: float = RMS) -> Answer:
    """Return the same by the linear filter along the steady motion."""
    disk, knots = table().law.disk, int(SECONDS * rate / EVERY)
    t, one = EVERY / rate * np.arange(knots + 1), np.ones(knots + 1)
    w2, w3 = steady(table().law.disk, beta)[6:8]
    path = disk.radius * abs(w2 - w3 / np.tan(beta)) * t
    course = Along(t, beta * one, disk.weight * one, one > 0, path, path, np.zeros((knots + 1, 2)))
    try:
        force = np.concatenate(list(respond(table(), [course], rate, profiles(rms))))[:, 1]
    except ValueError as error:
        raise Failure("a resonance turns too far in a step") from error
    return _heard(force, rate, len(force))


def _heard(force, rate, steps):
    f, power = welch(force[int(SETTLED * rate) :], rate, nperseg=int(rate / 25))
    return Answer((float(np.sqrt(trapezoid(power[f > AUDIBLE], f[f > AUDIBLE]))),), steps)


def undamped(loss_factor: float, creeps: bool) -> Answer:
    """Return the inclination [rad] of the published disk, smooth, after 1.5 s with a slip, over that with half the
    step; a spring that does not creep keeps what it held."""
    found = []
    for rate in (4e5, 8e5):
        scene, law = load_scene("published"), LawTable(law=table(loss_factor).law)
        if not creeps:
            without_creep(law)
        model = Compliant(table=law, friction=scene.friction, rate=rate)
        start = [0, np.radians(scene.release.inclination_deg), 0, 0, 0, *scene.release.omega, 0, 0, 0]
        *_, last = model.run(release(model, np.array(start)), 100, 1.5)
        found.append(inclination(last.state[-1:])[0])
    return Answer((found[0] / found[1],), int(1.5 * 4e5))


def flat(beta: float, rate: float = 4e5) -> Answer:
    """Return energy kept over energy at first of a smooth steady motion through a hundredth of a second."""
    model = Compliant(table=table(), friction=GRIPS, rate=rate)
    y = release(model, steady(table().law.disk, beta))
    first = energy(model, y[None])[0]
    *_, last = model.run(y, 1, 0.01, beta / 2)
    if last.why != GOES:
        raise Failure("stops: below 5e-8 rad one ellipse is not the contact")
    lost = last.state[-1, LOSSES : LOSSES + 5].sum()
    return Answer(((energy(model, last.state[-1:])[0] + lost) / first,), len(last.state))


def shift(rms: float) -> float:
    """Return rms(z'') R/beta of the rolling disk."""
    law = table().law
    half = law.semi_axes(np.array([FLAT]), law.disk.weight)[0]
    return float(shift_of_contact(Roughness(rms=rms), np.array([FLAT]), half, law.disk.radius)[0])
