"""Claim: the reaction of the air on the vibration of disk and table, which the filter neglects, changes
the level on the mirror by a fraction of a decibel.

Source: dynamics/compliant/air_reaction.py. Oracle: the added mass and inertia of incompressible,
inviscid flow and the damping of a viscous squeeze film in closed form; a numerical solution of the
differential equation; 1 % of the impedance of the disk at 0.01 rad and 2 kHz, by an independent
program.
"""

import numpy as np
import pytest
from scipy.integrate import solve_bvp

from dynamics import Air, plan_motion
from dynamics.compliant.air_reaction import film_inertia, film_level_change
from modal import surface_modes
from sonify import load_scene
from sonify.plan.sentences import FILM_REACTION_NEGLECTED
from sonify.plan.table import film_reaction_sentence

RADIUS = 0.0375


def test_slow_inviscid_air_is_an_added_mass():
    air = Air(viscosity=1e-12)
    found = film_inertia(RADIUS, 1e-3, air, np.array([10.0]))
    assert found.mass[0] == pytest.approx(
        np.pi * air.density * RADIUS**4 / 8e-3, rel=1e-3
    )
    assert found.moment[0] == pytest.approx(
        np.pi * air.density * RADIUS**6 / 96e-3, rel=1e-3
    )


def test_a_viscous_film_is_a_dashpot():
    air = Air()
    gap, omega = 1e-5, 1.0
    found = film_inertia(RADIUS, gap, air, np.array([omega]))
    damping = 3 * np.pi * air.viscosity * RADIUS**4 / (2 * gap**3)
    assert (1j * omega * found.mass[0]).real == pytest.approx(damping, rel=1e-3)


def test_the_pressure_solves_the_equation_of_the_film():
    air = Air()
    gap, omega = 4e-4, 2 * np.pi * 3000
    q = gap / 2 * np.sqrt(1j * omega * air.density / air.viscosity)
    flow = 1 - np.tanh(q) / q
    kappa = omega / (air.sound_speed * np.sqrt(flow))
    drive = air.density * omega**2 / (gap * flow)

    def slope(r, p):
        return np.vstack([p[1], -(kappa**2) * p[0] - drive - p[1] / r])

    def ends(inner, rim):
        return np.array([inner[1], rim[0]])

    r = np.linspace(1e-6, RADIUS, 400)
    solved = solve_bvp(slope, ends, r, np.zeros((2, len(r)), complex), tol=1e-8)
    force = np.trapezoid(2 * np.pi * r * solved.sol(r)[0], r)
    found = film_inertia(RADIUS, gap, air, np.array([omega])).mass[0]
    assert force / omega**2 == pytest.approx(found, rel=1e-3)


def test_air_that_cannot_escape_is_a_spring():
    """So short a wave of the film that no air leaves its place: rho c^2 pi R^2/h."""
    air, gap, omega = Air(), 1e-5, 1e6
    trapped = Air(viscosity=1e4 * air.viscosity)
    found = film_inertia(RADIUS, gap, trapped, np.array([omega])).mass[0]
    stiffness = air.density * air.sound_speed**2 * np.pi * RADIUS**2 / gap
    assert -(omega**2) * found == pytest.approx(stiffness, rel=1e-3)


def test_a_vacuum_does_not_react():
    found = film_inertia(RADIUS, 1e-4, Air(pressure=0.0), np.array([1e4]))
    assert found.mass[0] == found.moment[0] == 0


def test_the_level_on_the_mirror_hardly_changes():
    scene = load_scene("toy")
    gap = scene.disk.radius * np.sin(0.01)
    two_kilohertz = np.array([2 * np.pi * 2000])
    loaded = film_inertia(scene.disk.radius, gap, scene.air, two_kilohertz)
    assert abs(loaded.mass[0]) / scene.disk.mass == pytest.approx(0.01, rel=0.1)
    plan = plan_motion(scene, surface_modes(scene, 20e3))
    changes = [film_level_change(plan, beta) for beta in (0.1, 0.01, 0.0012)]
    assert np.all(np.abs(changes) < 0.2)
    assert max(np.abs(changes)) > 0.1
    said = film_reaction_sentence(plan)
    assert said == FILM_REACTION_NEGLECTED.format(change=0.2)
    dense = plan_motion(scene.replace("air.density=120.0"), plan.surface_modes)
    assert abs(film_level_change(dense, 0.01)) > 1
