"""Scenes for the tests of the motion: the published one, with the changes a test asks for; and how
a motion ends."""

from math import degrees, inf, pi, sin, sqrt

import numpy as np
import pytest

from dynamics import Motion, MotionScene, Outcome
from dynamics.air import Air
from dynamics.disk import Disk, Friction, Release
from dynamics.dissipation import Dissipation
from dynamics.face_contact import MIN_FALL_SPEED
from dynamics.guards import FALL_RATE_THRESHOLD
from dynamics.motion import MotionBase
from dynamics.motion_plan import plan_motion
from dynamics.simulation import solve_rolling_motion
from dynamics.solver_settings import Numerics
from dynamics.steady_motion import steady_precession

RADIUS = 0.03755


def smooth_toy(*changes):
    """Return the shipped toy on a plane, rigid, smooth table, with a rigid contact, and changes."""
    from sonify import load_scene

    sections = ("surface", "support", "roughness", "contact.law")
    return load_scene("toy").replace(dict.fromkeys(sections), *changes)


def bare_toy():
    """Return the smooth toy, slowed by contour friction and air alone."""
    arms = ("arm_nutation", "arm_rolling", "arm_pivoting")
    return smooth_toy(
        *(f"friction.{arm}=0" for arm in arms),
        "dissipation.contour_moment=1e-5",
        "air.film='acts'",
    )


def roll(moved, loads=None, watch=lambda t, inclination, doing: None) -> Motion:
    """Return the motion of a scene until the rolling contact is lost for the first time."""
    plan = plan_motion(moved)
    return solve_rolling_motion(plan.with_own_law(loads) if loads else plan, watch)


def scene(
    numerics=None, disk=None, release=None, dissipation=None, air=None, **friction
) -> MotionScene:
    """Return the published scene (7.1), (7.3), (7.4) with changes; `k1`, `k2`, `k3` are arms over
    the radius."""
    body = Disk(
        **{"radius": RADIUS, "thickness": 0.0128, "mass": 0.4387} | (disk or {})
    )
    law = {
        "mu_static": 0.5,
        "mu_dynamic": 0.3,
        "k1": 1e-4,
        "k2": 8e-4,
        "k3": 8e-3,
    } | friction
    for arm, k in (
        ("arm_nutation", "k1"),
        ("arm_rolling", "k2"),
        ("arm_pivoting", "k3"),
    ):
        law[arm] = law.pop(k) * body.radius
    start = {
        "inclination_deg": 32.70422048691768,
        "omega": (0.0, 0.0, -1 / body.time_unit),
    } | (release or {})
    return MotionScene(
        disk=body,
        friction=Friction(**law),
        release=Release(**start),
        numerics=Numerics(**(numerics or {})),
        dissipation=Dissipation(**(dissipation or {})),
        air=air or Air(film="none"),
    )


def conservative(**changes) -> MotionScene:
    """Return a disk that rolls without any loss."""
    return scene(
        **{"mu_static": inf, "mu_dynamic": inf, "k1": 0.0, "k2": 0.0, "k3": 0.0}
        | changes
    )


def whirling(inclination, disk=None, **changes) -> MotionScene:
    """Return a disk released in the steady motion with a fixed centre at `inclination` [rad],
    without moments."""
    body = conservative(disk=disk).disk
    rate = steady_precession(inclination, body.aspect, body.gyration) / body.time_unit
    in_plane = rate * sin(inclination)
    release = {
        "inclination_deg": degrees(inclination),
        "omega": (0.0, body.aspect * in_plane, in_plane),
    }
    return conservative(release=release, disk=disk, **changes)


class Attitudes(MotionBase):
    """A motion without a film, known by its states (n, 11) at times (n,) [s] alone."""

    film = None
    rolling_outcome = Outcome.ROLLING_ON

    def __init__(self, disk: Disk, state, t=None, **attributes):
        self.disk = disk
        self.state = state
        self.t = np.arange(len(state)) if t is None else t
        vars(self).update(attributes)

    @property
    def loads(self):
        """The columns (n, 5) of `film_loads` at all times."""
        return self.film_loads(self.t, self.state)


def energy_spread(motion) -> float:
    """Return by how much energy and dissipated work together change, relative to the first energy."""
    total = motion.energy(motion.t) + motion.state[:, 10]
    return np.ptp(total) / total[0]


def rolling_motion(scene: MotionScene, **options) -> Motion:
    """Return the motion of a scene up to the loss of the rolling contact."""
    return roll(scene, **options).rolling


def proves_its_outcome(motion, limit) -> bool:
    """Tell whether the last state is what the outcome says; KeyError where a motion ended for want
    of a solution."""
    (_, beta, *_) = motion.state[-1]
    nutation = motion.state[-1, 5] * motion.disk.time_unit
    limit_of_fall = pytest.approx(FALL_RATE_THRESHOLD, rel=1e-9)
    falls = motion.events and nutation / sqrt(beta) == limit_of_fall
    return {
        Outcome.ROLLING_ON: motion.t[-1] == pytest.approx(limit, rel=1e-12),
        Outcome.SETTLED: beta < 1e-8,
        Outcome.SANK: falls and motion.events[0].speed < MIN_FALL_SPEED,
        Outcome.FELL: falls and motion.events[0].speed >= MIN_FALL_SPEED,
        Outcome.LIFTED_OFF: motion.normal_load(motion.t[-1])[0]
        == pytest.approx(0, abs=1e-9),
        Outcome.AIRBORNE: motion.normal_load(motion.t[-1])[0]
        == pytest.approx(0, abs=1e-9),
        Outcome.UPRIGHT: beta == pytest.approx(pi / 2, rel=1e-9),
    }[motion.rolling_outcome]
