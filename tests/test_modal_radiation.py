"""Claim: the damping of a mode by the sound it radiates follows from its shape on the faces.

Source: Rayleigh's integral. Oracle: radiation resistance of a baffled piston, rho c A (1 - J_1(2 k a)/(k a)).
"""

from dataclasses import replace

import numpy as np
import pytest
from scipy.special import j1

from modal import Material, Plate, plate_modes, radiation_decay, with_radiation
from modal.radiation import AIR_DENSITY, SOUND_SPEED

RADIUS = 0.03755
STEEL = Material(young=195e9, poisson=0.28, loss_factor=2e-4)


@pytest.fixture(scope="module")
def modes():
    return plate_modes(Plate(radius=RADIUS, thickness=0.0128, material=STEEL, density=7737.27), 23e3)


def test_two_faces_moving_as_pistons(modes):
    pistons = replace(modes, face_shape=np.ones_like(modes.face_shape))
    ka = 2 * np.pi * modes.frequency / SOUND_SPEED * RADIUS
    resistance = AIR_DENSITY * SOUND_SPEED * np.pi * RADIUS**2 * (1 - j1(2 * ka) / ka)
    assert radiation_decay(pistons) == pytest.approx(2 * resistance / 2, rel=1e-6)


def test_radiation_alone_gives_a_loss_factor_of_1e_4_at_10_6_khz(modes):
    loss_factor = radiation_decay(modes) / (np.pi * modes.frequency)
    assert loss_factor[0] == pytest.approx(1.08e-4, rel=0.02)
    assert loss_factor[0] == pytest.approx(loss_factor[1], rel=1e-9)


def test_both_losses_together_let_the_first_mode_ring_for_0_7_seconds(modes):
    assert with_radiation(modes).decay_time[0] == pytest.approx(0.67, abs=0.03)


def test_decay_rates_measured_elsewhere_replace_the_computed_ones(modes):
    assert modes.with_decay(3.0).decay_time == pytest.approx(6.9078 / 3.0, rel=1e-4)
    with pytest.raises(ValueError, match="negative"):
        modes.with_decay(-1.0)
