"""Define benchmark motions of the rolling disk with reference values, dimensionless as
in the paper.

A state is (inclination, omega_1, omega_2, omega_3, slip_1, slip_2).
"""

import json
from importlib import resources
from math import pi, sin, sqrt
from typing import NamedTuple

from benchmarks.timed_runs import Answer, relative_error
from dynamics.equations import DiskConstants
from dynamics.kinematics import energy
from dynamics.steady_motion import squared_rate_times_inclination

PUBLISHED_LAW = DiskConstants(
    h=0.0128 / 0.0751, K=1.0, mu_static=0.5, mu_dynamic=0.3, k1=1e-4, k2=8e-4, k3=8e-3
)
"""Parameters (7.1) and (7.3) of the paper, with the misprint of (7.2) corrected."""

PUBLISHED_RELEASE = (pi / 2 - 1, 0.0, 0.0, -1.0, 0.0, 0.0)
"""Initial state (7.4) of the paper."""

NUTATION_ARMS = (1e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1, 0.2)
"""Ratios k1/R, from the published one to values at which the nutation sticks."""

PIVOTING_ARMS = (0.008, 0.02, 0.05, 0.1, 0.2, 0.5)
"""Ratios k3/R, from the published one to values at which the pivoting sticks."""

SMALL_INCLINATIONS = (0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10)
"""Initial inclinations [rad] of nearly flat rolling disks."""

EASY_SPAN = 1.0
"""Dimensionless time during which the published disk only rolls; every method must
first agree with the reference on it."""


class Case(NamedTuple):
    """Parameters, time span and initial state of a motion with known final inclination
    and energy."""

    name: str
    law: DiskConstants
    span: float
    start: tuple[float, ...] = PUBLISHED_RELEASE

    @property
    def reference(self) -> tuple[float, float]:
        """Final inclination and energy from the shipped reference data."""
        return references()[self.name][f"{self.span:g}"]

    @property
    def error(self):
        """Function that returns the larger relative error of (inclination, energy)."""
        return relative_error(self.reference)


def references() -> dict:
    """Return the reference data {case: {span: [inclination, energy]}}; the file states
    their origin."""
    text = (resources.files("benchmarks") / "references" / "motion.json").read_text(
        "utf-8"
    )
    return json.loads(text)["cases"]


def published(span: float = 50.0) -> Case:
    """Return the case of the paper, in which the disk alternates between rolling and
    sliding and no rotation sticks."""
    return Case("published", PUBLISHED_LAW, span)


def conservative(span: float = 10.0) -> Case:
    """Return the case of pure rolling without losses: no resisting moments, high
    friction, exact reference."""
    return Case(
        "conservative",
        PUBLISHED_LAW._replace(mu_static=1.0, mu_dynamic=1.0, k1=0.0, k2=0.0, k3=0.0),
        span,
    )


def sticking(span: float = 40.0) -> Case:
    """Return the case k1/R = 0.01, in which the nutation sticks from tau = 27.5595 to
    28.3098."""
    return Case("sticking", PUBLISHED_LAW._replace(k1=0.01), span)


def nutation_arm(k1: float) -> Case:
    """Return the case of the published disk with another k1/R; for k1/R >= 0.01 the
    nutation sticks."""
    return Case(f"k1 = {k1:g}", PUBLISHED_LAW._replace(k1=k1), 30.0)


def pivoting_arm(k3: float) -> Case:
    """Return the case of the published disk with another k3/R; for k3/R >= 0.2 the
    pivoting sticks."""
    return Case(f"k3 = {k3:g}", PUBLISHED_LAW._replace(k3=k3), 12.0)


def nearly_flat(inclination: float) -> Case:
    """Return the case of a disk that rolls at a small inclination for 1.4 nutation
    periods.

    Its precession is 10 % faster than in steady motion."""
    law = PUBLISHED_LAW._replace(mu_static=10.0, mu_dynamic=10.0, k1=0.0)
    in_plane = (
        1.1
        * sqrt(squared_rate_times_inclination(law.h, law.K) / inclination)
        * sin(inclination)
    )
    start = (inclination, 0.0, law.h * in_plane, in_plane, 0.0, 0.0)
    return Case(f"inclination {inclination:g}", law, 5.0 * sqrt(inclination), start)


def scaled(state) -> list:
    """Return a state in the variables of `dynamics.regime`.

    They are r = sqrt(inclination), angular velocity and slip divided by r, and five
    quadratures that are initially zero."""
    r = sqrt(state[0])
    return [r, *(x / r for x in state[1:]), *[0.0] * 5]


def answer_of(state, law: DiskConstants, steps: int) -> Answer:
    """Return the answer (inclination and energy (6.1)) of a state."""
    return Answer(
        (float(state[0]), float(energy(state[0], state[1:4], state[4:6], law))), steps
    )


def answer_of_scaled(y, law: DiskConstants, steps: int) -> Answer:
    """Return inclination and energy (6.1) of a state in the variables of
    `dynamics.regime`."""
    r = y[0]
    return answer_of((r * r, *(r * x for x in y[1:6])), law, steps)
