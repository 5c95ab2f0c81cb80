"""Claim: a table that vibrates acts back on the disk, in steps that cannot gain energy.

Source: the docstrings of waving.py and waves.py; the wave drag of a steady precession over one mode. Oracle: energies
of the states, the closed form of a driven oscillator, an independent program for one case.
"""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from dynamics.coupled.from_scene import contact_law
from dynamics.coupled.full import Compliant
from dynamics.coupled.handover import columns, energy, release
from dynamics.coupled.march import FLAT
from dynamics.coupled.state import LOSSES
from dynamics.coupled.table import LENGTH1, LENGTH2, LOSS, LawTable
from dynamics.disk import Friction
from dynamics.rates import precession_rate
from dynamics.steady import steady_precession
from dynamics.surface import ModesSurface, SurfaceMode
from modal import surface_modes
from sonify import SceneError, load_scene
from sonify.claims.halt import halt
from sonify.plan.solvable import solvable, solve_motion

GRIPS = Friction(mu_static=10.0, mu_dynamic=10.0)


@pytest.fixture(scope="module")
def elastic():
    return load_scene("published").replace("contact.law=elastic")


def standing(scene, rate, friction, *modes, damps=True):
    """Return the model of a disk without creep on a table of modes (order, frequency, damping ratio, modal mass)."""
    names = "order", "frequency", "damping_ratio", "modal_mass"
    surface = ModesSurface(modes=tuple(SurfaceMode(**dict(zip(names, mode, strict=True))) for mode in modes))
    table, scale = LawTable(law=contact_law(scene)), np.ones(7)
    scale[[LENGTH1, LENGTH2]], scale[LOSS] = 1e9, float(damps)
    table.__dict__["spline"] = CubicSpline(table.grid, table.spline(table.grid) * scale)
    known = surface_modes(SimpleNamespace(disk=scene.disk, surface=surface, numerics=scene.numerics))
    return Compliant(table=table, friction=friction, rate=rate, modes=known)


def steady(disk, beta):
    """Return the columns of the steady motion with a fixed centre, and its precession rate [rad/s]."""
    rate = steady_precession(beta, disk.aspect, disk.gyration) / disk.time_unit
    w3 = rate * np.sin(beta)
    return np.array([0.0, beta, 0, 0, 0, 0, disk.aspect * w3, w3, 0, 0, 0]), rate


def run(model, y, every, stop):
    """Return the energy at first, times, states, losses of contact, and why it stopped."""
    waves = model.waves(y)
    first = energy(model, y[None])[0]
    pieces = list(model.run(y, every, stop, waves=waves))
    t, state = (np.concatenate([getattr(p, name) for p in pieces]) for name in ("t", "state"))
    return first, t, state, [loss for p in pieces for loss in p.losses], pieces[-1].why


@pytest.mark.parametrize("damping", [0.0, 0.05])
def test_energy_is_kept_and_never_gained(elastic, damping):
    """On a soft table, through losses of contact and places where the rim stands on two waves at once."""
    modes = (2, 600.0, damping, 0.5), (3, 900.0, damping, 0.8), (0, 300.0, damping, 2.0)
    model = standing(elastic, 2e5, elastic.friction, *modes, damps=damping > 0)
    y = release(model, steady(elastic.disk, 4e-4)[0])
    first, _, state, losses, _ = run(model, y, 1, 0.05)
    now, lost = energy(model, state), state[:, LOSSES : LOSSES + 5].sum(axis=1)
    assert losses
    assert np.abs(now + lost - first).max() < 1e-10 * first
    assert np.diff(np.append(first, now)).max() < 1e-12 * first


@pytest.mark.parametrize("x", [0.5, 0.8, 1.4])
def test_wave_drag(elastic, x):
    """A steady precession at x = n Omega/w gives a mode 2 zeta w M (n Omega a)^2, a its amplitude under the weight.

    With a = m g/(M w^2)/((1 - x^2)^2 + (2 zeta x)^2)^0.5; cosine and sine together have it at every instant.
    """
    n, zeta, mass, beta = 2, 0.02, 20.0, 2e-3
    start, rate = steady(elastic.disk, beta)
    w = n * rate / x
    model = standing(elastic, 2e5, GRIPS, (n, w / (2 * np.pi), zeta, mass), damps=True)
    y = release(model, start)
    span = 6 / (zeta * w)
    _, t, state, _, _ = run(model, y, 20, span + 0.1)
    late = t > span
    power = np.polyfit(t[late], state[late, LOSSES + 4], 1)[0]
    omega = np.abs(precession_rate(columns(model, state[late]))).mean()
    here = n * omega / w
    amplitude = elastic.disk.weight / (mass * w**2) / np.hypot(1 - here**2, 2 * zeta * here)
    assert power == pytest.approx(2 * zeta * w * mass * (n * omega * amplitude) ** 2, rel=0.05)


@pytest.mark.slow
def test_the_halt_on_one_mode(elastic):
    """From the published motion at tau = 250, another program loses contact at 0.933(10) s and is flat at 0.958(10) s.

    Both programs are sensitive to steps and stiffness by as much as that, so that 0.02 s may lie between them.
    """
    motion, t0 = solve_motion(elastic.replace("contact.law=rigid")), 250 * elastic.disk.time_unit
    model = standing(elastic, 4e5, elastic.friction, (2, 600.0, 0.02, 1.0))
    y = release(model, motion.at([t0])[0], motion.force([t0])[0])
    first, t, state, losses, why = run(model, y, 4, 2.0)
    assert why == FLAT
    assert losses[0].t == pytest.approx(0.933, abs=0.02)
    beta = columns(model, state)[:, 1]
    assert t[np.flatnonzero(beta > 1e-5)[-1]] == pytest.approx(0.958, abs=0.02)
    assert np.abs(energy(model, state) + state[:, LOSSES : LOSSES + 5].sum(axis=1) - first).max() < 1e-9 * first


TABLE = (
    "surface={kind='modes', action='motion', modes=[{order=2, frequency=600.0, damping_ratio=0.02, modal_mass=1.0}]}"
)


def test_what_is_not_solved_is_refused_in_one_line(elastic):
    for change in ("contact.law=rigid", "roughness.rms=1e-8", "numerics.contact=filter"):
        with pytest.raises(SceneError, match=r"surface\.action = 'motion' with .*") as caught:
            solvable(elastic.replace(TABLE, change), None)
        assert len(str(caught.value).splitlines()) == 1
    with pytest.raises(ValueError, match="needs the surface_modes"):
        solve_motion(elastic.replace(TABLE))


def test_a_heavy_table_is_a_rigid_one(elastic):
    """A thousand times the mass: the motion is that on the elastic contact alone, within its vibration."""
    low = "release.inclination_deg=0.2", "release.omega=[0.0, 0.0, 1.8]", "numerics.time_limit=0.05"
    scene = elastic.replace(*low, "numerics.contact=full", "numerics.contact_rate=2e5")
    heavy = scene.replace(TABLE.replace("modal_mass=1.0", "modal_mass=1e5"))
    motion, alone = solve_motion(heavy, table=surface_modes(heavy)), solve_motion(scene)
    t = np.linspace(0, 0.05, 50)
    assert motion.at(t)[:, 1] == pytest.approx(alone.at(t)[:, 1], rel=2e-3)
    assert motion.table_energy(t).max() < 1e-3 * motion.energy(t).max()


@pytest.mark.slow
def test_the_map_of_halts():
    """A light mode breaks the contact and brings the halt forward; a heavy one does neither, to the creep of 1 %."""
    light, heavy = halt(2.0, 0.02, 2 * np.pi * 300, 2), halt(1e4, 0.02, 2 * np.pi * 300, 2)
    assert light.contact_lost
    assert light.advanced > 0.1
    assert not heavy.contact_lost
    assert abs(heavy.advanced) < 0.1 * light.advanced
    for wrong in ((0.0, 0.02, 1900.0, 2), (1.0, 1.0, 1900.0, 2), (1.0, 0.02, -1.0, 2), (1.0, 0.02, 1e6, 2)):
        with pytest.raises(ValueError, match=r"halt: mass|w_over_n"):
            halt(*wrong)
