"""What the methods for a table are asked for: one mode of order 1, a plate that rocks, under a weight that goes round.

Steady from the first instant: z = q_c + i q_s = A e^{i O t} solves z'' + 2 zeta w z' + w^2 z = -(P/M) e^{i O t},
A = -(P/M)/(w^2 - O^2 + 2 i zeta w O). In the turning frame the weight stays at one height, so that the contact
force is the weight, however heavy the load. An answer is z e^{-i O t}/A at the end: exactly 1.
"""

from functools import cache
from types import SimpleNamespace

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
from modal import surface_modes
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


def amplitude(load=LOAD * GRAVITY / MASS, w=W, omega=OMEGA, zeta=ZETA):
    """Return A of a weight over the modal mass."""
    return -load / (w**2 - omega**2 + 2j * zeta * w * omega)


def answer(z: complex, steps: int, at: float = SPAN) -> Answer:
    """Return z exp(-i Omega t)/A. Raises Failure where it is not finite."""
    ratio = z * np.exp(-1j * OMEGA * at) / amplitude()
    if not np.isfinite(ratio):
        raise Failure("not finite")
    return Answer((ratio,), steps)


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
    known = surface_modes(SimpleNamespace(disk=disk, surface=ModesSurface(modes=(mode,)), numerics=scene.numerics))
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
