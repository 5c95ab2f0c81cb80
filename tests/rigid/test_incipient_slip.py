"""Claim: three accelerations determine the slip acceleration in every direction, and all directions
with parallel acceleration are found.

Source: (4.6) and (5.3), rational in the slip direction. Oracle: the balance laws solved separately
for each direction; the sign changes of udot x s on a fine circle.
"""

import math

import numpy as np
import pytest

from dynamics.dissipation import Resistance
from dynamics.equations import DiskConstants
from dynamics.incipient_slip import slip_acceleration
from dynamics.regime import FLOAT_FORMULAS, Branch, Regime

LOADS = Resistance(((0.01, 1.0),), 0.02, 0.03, False)


def cases():
    """Yield random states, sliding regimes and laws, some with sticking rotations and some with
    loads."""
    draw = np.random.default_rng(5)
    for i in range(60):
        y = [
            math.sqrt(draw.uniform(0.01, 1.2)),
            *draw.normal(size=3),
            *draw.normal(size=2) * (i % 3),
            *[0.0] * 5,
        ]
        law = DiskConstants(
            draw.uniform(0, 1),
            draw.choice([1.0, 2.0]),
            0.5,
            draw.uniform(0.05, 2),
            *draw.uniform(0, 0.05, 3),
        )
        regime = Regime(
            True, tuple(draw.random(3) < 0.3), tuple(draw.choice([-1.0, 1.0], 3))
        )
        yield y, regime, Branch.of(regime, law, LOADS if i % 2 else None), law


def accelerations(y, regime, branch, law, angles):
    slip = y[0] * y[4], y[0] * y[5]
    for angle in angles:
        yield FLOAT_FORMULAS.contact_with_friction_along(
            y, slip, (math.cos(angle), math.sin(angle)), branch, regime.senses, law
        )


ROUNDING = 100 * np.finfo(float).eps
"""Relative rounding error of about two hundred operations, each in error by at most half an
epsilon."""


def bar(push, inertia):
    """Return a bound on the rounding error, with cancellation in the terms and in the inertia."""
    return ROUNDING * (
        1
        + sum(map(abs, push[2:]))
        / abs(inertia)
        * (1 + (abs(push.a) + abs(push.b)) / abs(inertia))
    )


@pytest.mark.parametrize("added", [0j, 0.3 - 0.2j])
def test_every_direction_follows_from_three(added):
    for y, regime, branch, law in cases():
        push = slip_acceleration(y, branch, regime.senses, law).with_added_rate(added)
        angles = np.linspace(-3, 3, 7)
        for angle, contact in zip(
            angles, accelerations(y, regime, branch, law, angles), strict=True
        ):
            near = bar(push, contact.inertia)
            assert push.acceleration_along(angle, 0.0) == pytest.approx(
                contact.du1 + added.real, abs=near
            )
            assert push.acceleration_along(angle, math.pi / 2) == pytest.approx(
                contact.du2 + added.imag, abs=near
            )


def test_every_direction_along_its_own_acceleration_is_found():
    grid = np.linspace(-math.pi, math.pi, 1001)
    several = 0
    for y, regime, branch, law in cases():
        push = slip_acceleration(y, branch, regime.senses, law)
        found = np.array(
            sorted(math.remainder(nu, 2 * math.pi) for nu in push.aligned_directions())
        )
        solved = list(accelerations(y, regime, branch, law, grid))
        across = np.array(
            [
                c.du2 * math.cos(nu) - c.du1 * math.sin(nu)
                for c, nu in zip(solved, grid, strict=True)
            ]
        )
        solvable = np.array([c.inertia > 0 for c in solved])
        turns = np.flatnonzero(
            ((across[1:] > 0) != (across[:-1] > 0)) & solvable[1:] & solvable[:-1]
        )
        for turn in turns:
            assert ((found > grid[turn] - 1e-9) & (found < grid[turn + 1] + 1e-9)).any()
        assert len(found) >= len(turns) > 0
        several += len(turns) > 2
        for nu, contact in zip(
            found, accelerations(y, regime, branch, law, found), strict=True
        ):
            across = contact.du2 * math.cos(nu) - contact.du1 * math.sin(nu)
            assert across == pytest.approx(0.0, abs=bar(push, contact.inertia))
    assert several


def test_the_direction_that_stops_a_slip_points_against_it():
    """In these directions, on either side, the acceleration has no component across the slip."""
    for y, regime, branch, law in cases():
        axis = math.atan2(y[5], y[4])
        push = slip_acceleration(y, branch, regime.senses, law)
        for angle in push.directions_parallel_to(axis):
            contact = next(accelerations(y, regime, branch, law, [angle]))
            across = contact.du2 * math.cos(axis) - contact.du1 * math.sin(axis)
            assert across == pytest.approx(0.0, abs=bar(push, contact.inertia))
