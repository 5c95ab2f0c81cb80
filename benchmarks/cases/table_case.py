"""Define the benchmark of a table with one mode of order 1 (a rocking plate) under a
weight moving along a circle.

The motion is steady from the start: z = q_c + i q_s = A e^{i O t} solves z'' + 2 zeta w
z' + w^2 z = -(P/M) e^{i O t} with A = -(P/M)/(w^2 - O^2 + 2 i zeta w O). In the
rotating frame the weight has a constant height, so that the contact force equals the
weight for any load. The result of a method is z e^{-i O t}/A at the end; the exact
value is 1."""

from functools import cache

import numpy as np
from numba import njit

from benchmarks.cases.contact_case import without_creep
from benchmarks.cases.elastic_steady_motion import steady_state
from benchmarks.timed_runs import Answer, Failure
from dynamics.compliant.law.tabulated import TabulatedLaw
from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.state_conversion import columns, preloaded_compliant_state
from dynamics.compliant.stepping.model import CompliantModel
from dynamics.disk import Friction
from dynamics.observables import precession_rate
from dynamics.surface import ModesSurface, SurfaceMode
from modal.tabletop.solve import table_modes_listed_in_scene
from sonify.scene import load_scene
from sonify.sound.oscillators import OscillatorBank

MODE_OMEGA = 2 * np.pi * 10.0
"""Angular frequency of the mode [rad/s]."""

DAMPING_RATIO = 0.05

SPEED_RATIO = 0.8
"""Ratio of the angular velocity of the weight to the angular frequency of the mode."""

CONTACT_OMEGA = SPEED_RATIO * MODE_OMEGA
"""Angular velocity of the weight [rad/s]."""

MASS = 1.0
"""Modal mass [kg]."""

RADIUS = 1.0
"""Radius of the circle [m]."""

LOAD = 0.1
"""Mass of the weight [kg]."""

GRAVITY = 10.0
"""Gravity [m/s^2]."""

DURATION = 2.5
"""Duration [s]; errors of the initial state decay to exp(-8) during it."""

PLATE_INERTIA = MASS * RADIUS**2
"""Moment of inertia of the plate [kg m^2].

In the engines the mode is a plate on two hinges in its surface, under a ball without
friction. The ball slides vertically on an arm that rotates steadily. """

SPRING = PLATE_INERTIA * MODE_OMEGA**2
"""Stiffness of the hinges of the plate [N m/rad]."""

DAMPER = 2 * DAMPING_RATIO * MODE_OMEGA * PLATE_INERTIA
"""Damping of the hinges of the plate [N m s/rad]."""

BALL_RADIUS = 0.02
"""Radius of the ball [m]."""

PLATE_HALF_THICKNESS = 0.05
"""Half thickness of the plate [m]."""

ARM_INERTIA = 10.0
"""Moment of inertia of the arm [kg m^2]; drag slows it by 1e-5. The tolerance of SAP is
relative to all momenta."""

NEGLIGIBLE_INERTIA = 1e-6
"""Mass [kg] or moment of inertia [kg m^2] of bodies that should have none."""
PLATE_HALF_WIDTH = (3 * RADIUS**2 - PLATE_HALF_THICKNESS**2) ** 0.5
"""Half width [m] of a plate with mass and inertia of the mode; PyBullet computes the
inertia from the shape."""


def amplitude(
    load=LOAD * GRAVITY / MASS, w=MODE_OMEGA, omega=CONTACT_OMEGA, zeta=DAMPING_RATIO
):
    """Return the amplitude A for a `load`, the weight divided by the modal mass
    [m/s^2]."""
    return -load / (w**2 - omega**2 + 2j * zeta * w * omega)


def answer(z: complex, steps: int) -> Answer:
    """Return z exp(-i Omega t)/A at the end. Raises Failure if it is not finite."""
    ratio = z * np.exp(-1j * CONTACT_OMEGA * DURATION) / amplitude()
    if not np.isfinite(ratio):
        raise Failure("not finite")
    return Answer((ratio,), steps)


def initial_state() -> tuple[np.ndarray, np.ndarray, float]:
    """Return the angles of the plate about x and y [rad], their rates [1/s], and the
    height of the ball [m]."""
    A = amplitude()
    angles, rates = (
        np.array([z.imag, -z.real]) / RADIUS for z in (A, 1j * CONTACT_OMEGA * A)
    )
    return angles, rates, A.real + BALL_RADIUS


def answer_from_angles(angles, steps: int) -> Answer:
    """Return the result from the angles of the plate about x and y [rad] at the end."""
    return answer(complex(-angles[1], angles[0]) * RADIUS, steps)


def exact_hold(rate: float) -> Answer:
    """Solve the mode by our steps for one-way coupling, which are exact for a piecewise
    linear force."""
    n = round(DURATION * rate)
    bank = OscillatorBank(
        np.full(2, MODE_OMEGA / (2 * np.pi)),
        np.full(2, DAMPING_RATIO * MODE_OMEGA),
        rate,
    )
    turning = np.exp(1j * CONTACT_OMEGA * np.arange(n + 1) / rate)
    force = -LOAD * GRAVITY / MASS * np.column_stack([turning.real, turning.imag])
    moving = np.array([amplitude(), 1j * CONTACT_OMEGA * amplitude()])
    bank.state = bank.observable_state(
        np.column_stack([moving.real, moving.imag]), force[0]
    )
    bank.advance(force)
    moved = np.einsum("ij...,j...->i...", bank.back, bank.state) + bank.late * force[-1]
    return answer(moved[0] @ [1, 1j], n)


def textbook_steps(step, rate: float) -> Answer:
    """Solve the mode under the same force by a compiled textbook step of
    `oscillator_steps`."""
    n = round(DURATION * rate)
    force = (
        -LOAD * GRAVITY / MASS * np.exp(1j * CONTACT_OMEGA * np.arange(n + 1) / rate)
    )
    position = amplitude()
    velocity = 1j * CONTACT_OMEGA * position
    end = _stepped(
        compiled_step(step),
        position,
        velocity,
        force,
        MODE_OMEGA,
        DAMPING_RATIO * MODE_OMEGA,
        1 / rate,
    )
    return answer(end, n)


@cache
def compiled_step(step):
    """Return a step compiled by numba."""
    return njit(step)


@njit
def _stepped(step, z, v, force, w, d, h):
    for i in range(len(force) - 1):
        z, v = step(z, v, force[i], force[i + 1], w, d, h)
    return z


def two_way_disk(
    rate: float, inclination: float = 5e-4, heavier: float = 1e5
) -> Answer:
    """Solve the mode by our two-way steps, with the published disk as the weight.

    The disk rolls steadily at SPEED_RATIO. The modal mass is `heavier` times the mass
    of the disk, so that the mode hardly decelerates the disk. `rate` is the number of
    steps per ten periods of the mode."""
    scene = load_scene("published")  # with a sharp edge
    disk = scene.disk
    start = steady_state(contact_law(scene), inclination)
    w = start[7] / np.sin(inclination) / SPEED_RATIO
    mode = SurfaceMode(
        order=1,
        frequency=w / (2 * np.pi),
        damping_ratio=DAMPING_RATIO,
        modal_mass=heavier * disk.mass,
    )
    table = TabulatedLaw(law=contact_law(scene))
    without_creep(table)
    known = table_modes_listed_in_scene(
        ModesSurface(modes=(mode,)), disk, 2 * mode.frequency
    )
    steps = rate * w / MODE_OMEGA
    model = CompliantModel(
        tabulated_law=table,
        friction=Friction(mu_static=10.0, mu_dynamic=10.0),
        modes=known,
        rate=steps,
    )
    y = preloaded_compliant_state(model, start)
    waves = model.supporting_modes(y)
    n = round(DURATION * rate)
    *_, last = model.run(y, n, n / steps, modes=waves)
    found = columns(model, last.state[-1:])
    omega = float(precession_rate(found)[0])
    z = waves.amplitude @ [1, 1j] * mode.modal_mass**-0.5
    within = np.cos(inclination) - disk.aspect * np.sin(
        inclination
    )  # the contact is inside the circle of the mode
    expected = within * amplitude(disk.weight / mode.modal_mass, w, omega)
    return Answer((z * np.exp(-1j * (found[0, 0] + np.pi / 2)) / expected,), n)
