"""What the methods for a table are asked for: one mode of order 1, a plate that rocks, under a weight that goes round.

Steady from the first instant: z = q_c + i q_s = A e^{i O t} solves z'' + 2 zeta w z' + w^2 z = -(P/M) e^{i O t},
A = -(P/M)/(w^2 - O^2 + 2 i zeta w O). In the turning frame the weight stays at one height, so that the contact
force is the weight, however heavy the load. An answer is z e^{-i O t}/A at the end: exactly 1.
"""

from functools import cache

import numpy as np
from numba import njit

from dynamics.coupled.from_scene import contact_law
from dynamics.coupled.full import Compliant
from dynamics.coupled.handover import columns, release
from dynamics.coupled.table import LawTable
from dynamics.coupled.waves import Q
from dynamics.disk import Friction
from dynamics.rates import precession_rate
from dynamics.surface import ModesSurface, SurfaceMode
from modal.surface import table_by_modes
from sonify.charts.contact_case import without_creep
from sonify.charts.records import Answer, Failure
from sonify.claims.halt import steady
from sonify.scene import load_scene
from sonify.sound.oscillators import OscillatorBank

W, ZETA, X = 2 * np.pi * 10.0, 0.05, 0.8
"""Angular frequency of the mode [rad/s], damping ratio, and rate of the contact over the frequency."""
MASS, RADIUS, LOAD, GRAVITY = 1.0, 1.0, 0.1, 10.0
"""Modal mass [kg], radius of the circle [m], mass that goes round [kg], gravity [m/s^2]."""
SPAN = 2.5
"""Time to the end [s]: what a method begins with has by then decayed to exp(-8) of itself."""
OMEGA = X * W
INERTIA = MASS * RADIUS**2
SPRING, DAMPER = INERTIA * W**2, 2 * ZETA * W * INERTIA
"""To the engines the mode is a plate on two hinges in its face, under a ball without friction that slides up and down
on an arm, which turns steadily."""
BALL, DEEP, GREAT, SMALL = 0.02, 0.05, 10.0, 1e-6
"""Radius of the ball, half thickness of the plate [m]; inertia of the arm [kg m^2], which drag slows by 1e-5; inertia
or mass of what has none. The tolerance of SAP is relative to the momentum of all there is."""
HALF = (3 * RADIUS**2 - DEEP**2) ** 0.5
"""Half width of a plate of that mass whose inertia [m] is that of the mode: PyBullet takes it from the shape."""


def amplitude(load=LOAD * GRAVITY / MASS, w=W, omega=OMEGA, zeta=ZETA):
    """Return A of a weight over the modal mass."""
    return -load / (w**2 - omega**2 + 2j * zeta * w * omega)


def answer(z: complex, steps: int) -> Answer:
    """Return z exp(-i Omega t)/A at the end. Raises Failure where it is not finite."""
    ratio = z * np.exp(-1j * OMEGA * SPAN) / amplitude()
    if not np.isfinite(ratio):
        raise Failure("not finite")
    return Answer((ratio,), steps)


def at_start() -> tuple[np.ndarray, np.ndarray, float]:
    """Return the angles of the plate about x and y [rad], their rates [1/s], and how high the ball is [m]."""
    A = amplitude()
    angles, rates = (np.array([z.imag, -z.real]) / RADIUS for z in (A, 1j * OMEGA * A))
    return angles, rates, A.real + BALL


def tilted(angles, steps: int) -> Answer:
    """Return the answer of the angles of the plate about x and y at the end."""
    return answer(complex(-angles[1], angles[0]) * RADIUS, steps)


def exact_hold(rate: float) -> Answer:
    """Our steps of a table that only sounds: exact for a force that is linear between samples."""
    bank, n = OscillatorBank(np.full(2, W / (2 * np.pi)), np.full(2, ZETA * W), rate), round(SPAN * rate)
    turning = np.exp(1j * OMEGA * np.arange(n + 1) / rate)
    force = -LOAD * GRAVITY / MASS * np.column_stack([turning.real, turning.imag])
    moving = np.array([amplitude(), 1j * OMEGA * amplitude()])
    bank.state = bank.taken(np.column_stack([moving.real, moving.imag]), force[0])
    bank.advance(force)
    return answer(bank.known(bank.state, force[-1])[0] @ [1, 1j], n)


def plain(step, rate: float) -> Answer:
    """Steps of the textbooks, compiled, under the same force; `step` as in steps.py."""
    n = round(SPAN * rate)
    force = -LOAD * GRAVITY / MASS * np.exp(1j * OMEGA * np.arange(n + 1) / rate)
    return answer(_stepped(compiled(step), amplitude(), 1j * OMEGA * amplitude(), force, W, ZETA * W, 1 / rate), n)


@cache
def compiled(step):
    """Return the compiled step."""
    return njit(step)


@njit
def _stepped(step, z, v, force, w, d, h):
    for i in range(len(force) - 1):
        z, v = step(z, v, force[i], force[i + 1], w, d, h)
    return z


def with_the_disk(rate: float, inclination: float = 5e-4, heavier: float = 1e5) -> Answer:
    """Our steps of a table that acts back: the published disk is the weight, rolls steadily on a mode `heavier` than
    itself, which hardly slows it, and turns at X of its frequency; `rate` is in steps per 0.1 s of the mode."""
    scene = load_scene("published").replace("contact.law=elastic")
    disk, start = scene.disk, steady(scene.disk, inclination)
    w = start[7] / np.sin(inclination) / X
    mode = SurfaceMode(order=1, frequency=w / (2 * np.pi), damping_ratio=ZETA, modal_mass=heavier * disk.mass)
    table = LawTable(law=contact_law(scene))
    without_creep(table)
    known = table_by_modes(ModesSurface(modes=(mode,)), disk, 2 * mode.frequency)
    steps = rate * w / W
    model = Compliant(table=table, friction=Friction(mu_static=10.0, mu_dynamic=10.0), modes=known, rate=steps)
    y = release(model, start)
    waves, n = model.waves(y), round(SPAN * rate)
    *_, last = model.run(y, n, n / steps, waves=waves)
    found = columns(model, last.state[-1:])
    omega = float(precession_rate(found)[0])
    z = waves.state[:, Q] @ [1, 1j] * mode.modal_mass**-0.5
    within = np.cos(inclination) - disk.aspect * np.sin(inclination)  # the contact lies within the circle of the mode
    expected = within * amplitude(disk.weight / mode.modal_mass, w, omega)
    return Answer((z * np.exp(-1j * (found[0, 0] + np.pi / 2)) / expected,), n)
