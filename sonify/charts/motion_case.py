"""The motions that every method is asked for, and what they must answer: dimensionless as in the paper.

A state is (inclination, omega_1, omega_2, omega_3, slip_1, slip_2).
"""

import json
from importlib import resources
from math import pi, sqrt
from typing import NamedTuple

from dynamics.equations import Law
from dynamics.motion import energy
from sonify.charts.records import Answer, relative

PUBLISHED = Law(h=0.0128 / 0.0751, K=1.0, mu_static=0.5, mu_dynamic=0.3, k1=1e-4, k2=8e-4, k3=8e-3)
"""(7.1), (7.3), with the misprint of (7.2) corrected."""
RELEASED = (pi / 2 - 1, 0.0, 0.0, -1.0, 0.0, 0.0)
"""(7.4)."""
EASY = 1.0
"""Up to here the published disk only rolls: the stretch on which every method must prove itself."""


class Case(NamedTuple):
    """A law, and the time until which the motion of RELEASED is asked for; inclination and energy are known there."""

    name: str
    law: Law
    span: float

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
    """The paper's case: nothing sticks, slips begin and end."""
    return Case("published", PUBLISHED, span)


def sticking(span: float = 40.0) -> Case:
    """The case k1/R = 0.01: the nutation sticks from tau = 27.5595 to 28.3098."""
    return Case("sticking", PUBLISHED._replace(k1=0.01), span)


def strong(span: float = 5.0) -> Case:
    """The case k1/R = 0.05: the nutation sticks early, first at tau = 1.51."""
    return Case("strong", PUBLISHED._replace(k1=0.05), span)


def pivoting(span: float = 30.7) -> Case:
    """The case k3/R = 0.1: the pivoting sticks at tau = 30.66, shortly before the disk falls flat."""
    return Case("pivoting", PUBLISHED._replace(k3=0.1), span)


def scaled(state) -> list:
    """Return a state as `dynamics.regime` integrates it: (sqrt(inclination), omega and slip over it, quadratures)."""
    r = sqrt(state[0])
    return [r, *(x / r for x in state[1:]), *[0.0] * 5]


def answer_of(state, law: Law, steps: int) -> Answer:
    """Return inclination and energy (6.1) of a state."""
    return answer_of_scaled(scaled(state), law, steps)


def answer_of_scaled(y, law: Law, steps: int) -> Answer:
    """Return inclination and energy (6.1) of a state as `dynamics.regime` has it."""
    return Answer((float(y[0] ** 2), float(energy(y, law))), steps)
