"""What the methods for a table are asked for: one mode of order 1, a plate that rocks, under a weight that goes round.

Steady from the first instant: z = q_c + i q_s = A e^{i O t} solves z'' + 2 zeta w z' + w^2 z = -(P/M) e^{i O t},
A = -(P/M)/(w^2 - O^2 + 2 i zeta w O). In the turning frame the weight stays at one height, so that the contact
force is the weight, however heavy the load. An answer is z e^{-i O t}/A at the end: exactly 1.
"""

from types import SimpleNamespace

import numpy as np
from numba import njit
from scipy.interpolate import CubicSpline

from dynamics.coupled.from_scene import contact_law
from dynamics.coupled.full import Compliant
from dynamics.coupled.handover import columns, release
from dynamics.coupled.table import LENGTH1, LENGTH2, LawTable
from dynamics.coupled.waves import Q
from dynamics.disk import Friction
from dynamics.rates import precession_rate
from dynamics.steady import steady_precession
from dynamics.surface import ModesSurface, SurfaceMode
from modal import surface_modes
from sonify.charts.records import Answer, Failure
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
    """Steps of the textbooks, compiled, under the same force."""
    n = round(SPAN * rate)
    return answer(step(amplitude(), 1j * OMEGA * amplitude(), 1 / rate, n, W, ZETA, OMEGA, LOAD * GRAVITY / MASS), n)


@njit(cache=True)
def semi_implicit_euler(z, v, h, n, w, zeta, omega, load):
    """The velocity from the old place, the place from the new velocity."""
    for i in range(n):
        v += h * (-load * np.exp(1j * omega * i * h) - 2 * zeta * w * v - w * w * z)
        z += h * v
    return z


@njit(cache=True)
def newmark(z, v, h, n, w, zeta, omega, load):
    """Newmark's method of average acceleration."""
    a = -load - 2 * zeta * w * v - w * w * z
    for i in range(1, n + 1):
        z, v = z + h * v + h * h / 4 * a, v + h / 2 * a
        a = (-load * np.exp(1j * omega * i * h) - 2 * zeta * w * v - w * w * z) / (1 + h * zeta * w + h * h / 4 * w * w)
        z, v = z + h * h / 4 * a, v + h / 2 * a
    return z


def with_the_disk(rate: float, inclination: float = 5e-4, heavier: float = 1e5) -> Answer:
    """Our steps of a table that acts back: the published disk is the weight, rolls steadily on a mode `heavier` than
    itself, which hardly slows it, and turns at X of its frequency; `rate` is in steps per 0.1 s of the mode."""
    scene = load_scene("published").replace("contact.law=elastic")
    disk, steady = scene.disk, steady_precession(inclination, scene.disk.aspect, scene.disk.gyration)
    turning, w3 = steady / scene.disk.time_unit, steady / scene.disk.time_unit * np.sin(inclination)
    w = turning / X
    mode = SurfaceMode(order=1, frequency=w / (2 * np.pi), damping_ratio=ZETA, modal_mass=heavier * disk.mass)
    table = LawTable(law=contact_law(scene))
    creepless = np.where(np.isin(np.arange(7), (LENGTH1, LENGTH2)), 1e9, 1.0)
    table.__dict__["spline"] = CubicSpline(table.grid, table.spline(table.grid) * creepless)
    known = surface_modes(SimpleNamespace(disk=disk, surface=ModesSurface(modes=(mode,)), numerics=scene.numerics))
    steps = rate * w / W
    model = Compliant(table=table, friction=Friction(mu_static=10.0, mu_dynamic=10.0), modes=known, rate=steps)
    y = release(model, np.array([0.0, inclination, 0, 0, 0, 0, disk.aspect * w3, w3, 0, 0, 0]))
    waves, n = model.waves(y), round(SPAN * rate)
    *_, last = model.run(y, n, n / steps, waves=waves)
    found = columns(model, last.state[-1:])
    omega = float(precession_rate(found)[0])
    z = waves.state[:, Q] @ [1, 1j] * mode.modal_mass**-0.5
    within = np.cos(inclination) - disk.aspect * np.sin(inclination)  # the contact lies within the circle of the mode
    expected = within * amplitude(disk.weight / mode.modal_mass, w, omega)
    return Answer((z * np.exp(-1j * (found[0, 0] + np.pi / 2)) / expected,), n)
