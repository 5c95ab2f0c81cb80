"""Claim: a disk that rolls upright on both rims is slowed by its rolling resistance alone.

Source: dynamics/landing/straight_rolling.py. Oracle: the closed form of a cylinder with a constant
resisting moment; the balance of energy.
"""

import numpy as np
import pytest

from dynamics import Disk
from dynamics.landing.equations import LOSSES, LandingModel, LandingState
from dynamics.landing.rim_friction import RimFriction
from dynamics.landing.stop import stop_below
from dynamics.landing.straight_rolling import JOIN_DURATION, roll_straight, steady_part

DISK = Disk(radius=0.03755, thickness=0.0128, mass=0.4387)
SPIN, ARM = -12.0, 3e-5


def model_of(arm):
    stop = stop_below(DISK.radius, DISK.mass, 0.8)
    return LandingModel(DISK, None, stop, RimFriction(0.3, (0.0, arm, 1e-4)))


def upright(spin):
    """Return the state of an upright disk that rolls without slip."""
    zeros = dict.fromkeys(LandingState._fields, 0.0)
    return LandingState(
        **zeros
        | {
            "height": DISK.radius - DISK.thickness / 2,
            "axis_x": -1.0,
            "speed_y": DISK.radius * spin,
            "axial_rate": spin,
        }
    )


def test_it_stands_still_after_the_time_of_the_closed_form():
    model = model_of(ARM)
    found = roll_straight(model, upright(SPIN), 1e4)
    slowing = ARM * DISK.weight / (1.5 * DISK.mass * DISK.radius**2)
    stop = abs(SPIN) / slowing
    end = LandingState(*found.states[-1])
    assert found.rests
    assert found.t[-1] == pytest.approx(stop + JOIN_DURATION)
    assert end.axial_rate == pytest.approx(0.0, abs=1e-9)
    assert end.y == pytest.approx(DISK.radius * SPIN * stop / 2, rel=1e-6)
    assert end.turned == pytest.approx(SPIN * stop / 2, rel=1e-6)


@pytest.mark.parametrize("arm", [0.0, ARM])
def test_all_lost_energy_is_in_a_ledger(arm):
    model = model_of(arm)
    found = roll_straight(model, upright(SPIN), 20.0)
    energy = np.array([model.energy(y) for y in found.states.tolist()])
    assert np.ptp(energy + found.states[:, LOSSES].sum(axis=1)) < 1e-9 * energy[0]
    assert not found.rests
    assert found.t[-1] == pytest.approx(20.0)


def test_the_steady_part_rolls_without_slip_and_keeps_its_momentum():
    slipping = upright(SPIN)._replace(speed_y=0.0)
    steady = LandingState(*steady_part(model_of(ARM), list(slipping)))
    assert steady.speed_y == pytest.approx(DISK.radius * steady.axial_rate)
    assert steady.axial_rate == pytest.approx(SPIN / 3)  # C = m R^2/2 of 3 m R^2/2
