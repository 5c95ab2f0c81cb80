"""The motions that every method is asked for, and what they must answer: dimensionless as in the paper.

A state is (inclination, omega_1, omega_2, omega_3, slip_1, slip_2).
"""

import json
from importlib import resources
from math import pi, sin, sqrt
from typing import NamedTuple

from dynamics.equations import Law
from dynamics.kinematics import energy
from dynamics.steady import flat_square
from sonify.charts.records import Answer, relative

PUBLISHED = Law(h=0.0128 / 0.0751, K=1.0, mu_static=0.5, mu_dynamic=0.3, k1=1e-4, k2=8e-4, k3=8e-3)
"""(7.1), (7.3), with the misprint of (7.2) corrected."""
RELEASED = (pi / 2 - 1, 0.0, 0.0, -1.0, 0.0, 0.0)
"""(7.4)."""
NUTATION_ARMS = (1e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1, 0.2)
PIVOTING_ARMS = (0.008, 0.02, 0.05, 0.1, 0.2, 0.5)
INCLINATIONS = (0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10)
"""Paths on which motions become hard: arms k1, k3 over R, inclinations [rad] at the start."""
EASY = 1.0
"""Up to here the published disk only rolls: the stretch on which every method must prove itself."""


class Case(NamedTuple):
    """A law, a time, and the state at its start; inclination and energy are known at the end."""

    name: str
    law: Law
    span: float
    start: tuple[float, ...] = RELEASED

    @property
    def reference(self) -> tuple[float, float]:
        """Inclination and energy at the end of the span, from the shipped reference data."""
        return references()[self.name][f"{self.span:g}"]

    @property
    def error(self):
        """The larger relative error of inclination and energy."""
        return relative(self.reference)


def references() -> dict:
    """Return {case: {span: [inclination, energy]}}; origin in references/motion.json itself."""
    text = (resources.files("sonify.charts") / "references" / "motion.json").read_text("utf-8")
    return json.loads(text)["cases"]


def published(span: float = 50.0) -> Case:
    """Return the paper's case, in which nothing sticks, and slips begin and end."""
    return Case("published", PUBLISHED, span)


def conservative(span: float = 10.0) -> Case:
    """Return the published disk without moments on a rough plane: it rolls for ever, which is solved exactly."""
    return Case("conservative", PUBLISHED._replace(mu_static=1.0, mu_dynamic=1.0, k1=0.0, k2=0.0, k3=0.0), span)


def sticking(span: float = 40.0) -> Case:
    """Return the case k1/R = 0.01, in which the nutation sticks from tau = 27.5595 to 28.3098."""
    return Case("sticking", PUBLISHED._replace(k1=0.01), span)


def nutation_arm(k1: float) -> Case:
    """Return the published disk with another k1/R; from 0.01 on the nutation sticks within the span."""
    return Case(f"k1 = {k1:g}", PUBLISHED._replace(k1=k1), 30.0)


def pivoting_arm(k3: float) -> Case:
    """Return the published disk with another k3/R; from 0.2 on the pivoting sticks within the span."""
    return Case(f"k3 = {k3:g}", PUBLISHED._replace(k3=k3), 12.0)


def flat(inclination: float) -> Case:
    """Return a disk that rolls all but flat, a tenth faster than steadily, over 1.4 of its nutations."""
    law = PUBLISHED._replace(mu_static=10.0, mu_dynamic=10.0, k1=0.0)
    in_plane = 1.1 * sqrt(flat_square(law.h, law.K) / inclination) * sin(inclination)
    start = (inclination, 0.0, law.h * in_plane, in_plane, 0.0, 0.0)
    return Case(f"inclination {inclination:g}", law, 5.0 * sqrt(inclination), start)


def scaled(state) -> list:
    """Return a state as `dynamics.regime` integrates it: (sqrt(inclination), omega and slip over it, quadratures)."""
    r = sqrt(state[0])
    return [r, *(x / r for x in state[1:]), *[0.0] * 5]


def answer_of(state, law: Law, steps: int) -> Answer:
    """Return inclination and energy (6.1) of a state."""
    return Answer((float(state[0]), float(energy(state[0], state[1:4], state[4:6], law))), steps)


def answer_of_scaled(y, law: Law, steps: int) -> Answer:
    """Return inclination and energy (6.1) of a state as `dynamics.regime` has it."""
    r = y[0]
    return answer_of((r * r, *(r * x for x in y[1:6])), law, steps)
