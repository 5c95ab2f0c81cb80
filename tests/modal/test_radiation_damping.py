"""Claim: the radiation damping of a mode follows from its shape on the faces.

Source: Rayleigh's integral. Oracle: the radiation resistance of a baffled piston, rho c A (1 -
J_1(2 k a)/(k a)); monopole and dipole for long waves; Lamb's disk without a baffle; the integral as
a double sum over points.
"""

from dataclasses import replace

import numpy as np
import pytest
from scipy.special import j1

from modal import Material, Plate, plate_modes, radiation_decay, with_radiation
from modal.radiation import AIR_DENSITY, BOTTOM_FACE, SOUND_SPEED, TOP_FACE, directivity

RADIUS = 0.03755
STEEL = Material(young=195e9, poisson=0.28, loss_factor=2e-4)


@pytest.fixture(scope="module")
def modes():
    return plate_modes(
        Plate(radius=RADIUS, thickness=0.0128, material=STEEL, density=7737.27), 23e3
    )


def test_two_faces_moving_as_pistons(modes):
    pistons = replace(modes, face_shape=np.ones_like(modes.face_shape))
    ka = 2 * np.pi * modes.frequency / SOUND_SPEED * RADIUS
    resistance = AIR_DENSITY * SOUND_SPEED * np.pi * RADIUS**2 * (1 - j1(2 * ka) / ka)
    assert radiation_decay(pistons) == pytest.approx(2 * resistance / 2, rel=1e-6)


def test_each_face_takes_its_part(modes):
    assert radiation_decay(modes, (TOP_FACE,)) + radiation_decay(
        modes, (BOTTOM_FACE,)
    ) == pytest.approx(radiation_decay(modes))
    still = modes.face_shape.copy()
    still[:, TOP_FACE] = 0
    assert (
        np.abs(radiation_decay(replace(modes, face_shape=still), (TOP_FACE,))).max()
        == 0
    )


def slowed(modes, frequency, shape):
    """Return the first mode with another frequency [Hz] and face motion (a, b)."""
    one = {
        name: getattr(modes, name)[:1] for name in ("decay_rate", "order", "partner")
    }
    face = np.broadcast_to(shape, modes.face_shape[:1].shape).copy()
    return replace(modes, frequency=np.array([frequency]), face_shape=face, **one)


def test_long_waves_hear_the_volume_flow_of_each_face(modes):
    """A baffled monopole has P = rho w^2 Q^2/(4 pi c) with the peak flow Q = w_mean A v."""
    shape = (1 - (modes.face_radius / RADIUS) ** 2)[:, None] + 0 * modes.face_angle
    slow = slowed(modes, 20.0, shape)
    flow = np.pi * RADIUS**2 / 2
    power = AIR_DENSITY * (2 * np.pi * 20.0) ** 2 * flow**2 / (4 * np.pi * SOUND_SPEED)
    assert radiation_decay(slow)[0] == pytest.approx(2 * power, rel=1e-3)


@pytest.mark.parametrize("turn", [np.cos, np.sin])
def test_long_waves_hear_a_tilt_as_a_dipole(modes, turn):
    """For w = x/a the integral of |D|^2 over a half space is (2 pi/3) k^2 (pi a^3/4)^2.

    D = k sin(t) cos(p) int w x dA.
    """
    slow = slowed(
        modes, 20.0, np.outer(modes.face_radius / RADIUS, turn(modes.face_angle))
    )
    rate = 2 * np.pi * 20.0
    square = 2 * np.pi / 3 * (rate / SOUND_SPEED) ** 2 * (np.pi * RADIUS**3 / 4) ** 2
    power = AIR_DENSITY * rate**2 / (8 * np.pi**2 * SOUND_SPEED) * square
    assert radiation_decay(slow)[0] == pytest.approx(2 * power, rel=1e-3)


def test_without_a_baffle_a_heaving_disk_radiates_as_much_less_as_said(modes):
    """Lamb (1932), section 102: for long waves a free disk has 8 rho c pi a^2 (k a)^4/(27 pi^2)."""
    ka = 0.1
    slow = slowed(modes, ka * SOUND_SPEED / (2 * np.pi * RADIUS), 1.0)
    free = 8 * AIR_DENSITY * SOUND_SPEED * np.pi * RADIUS**2 * ka**4 / (27 * np.pi**2)
    assert radiation_decay(slow)[0] / (free / 2) == pytest.approx(
        27 * np.pi**2 / (8 * ka**2), rel=0.01
    )


def test_hankel_transforms_are_the_integral_summed_point_by_point(modes):
    sine = np.array([0.2, 0.7, 1.0])
    azimuth = np.array([0.3, 2.1])
    parts = directivity(modes, sine)
    order = np.arange(parts.shape[1])
    turns = np.stack(
        [np.cos(np.outer(order, azimuth)), np.sin(np.outer(order, azimuth))]
    )
    ours = np.einsum("pnmfc,pna,n->mfca", parts, turns, 1j**order)
    area = modes.face_weight[:, None] * 2 * np.pi / len(modes.face_angle)
    k = 2 * np.pi * modes.frequency / SOUND_SPEED
    phase = np.cos(azimuth[:, None] - modes.face_angle)
    path = np.einsum("m,c,r,at->mcart", k, sine, modes.face_radius, phase)
    summed = np.einsum("mfrt,mcart,rt->mfca", modes.face_shape, np.exp(1j * path), area)
    assert ours == pytest.approx(summed, abs=1e-6 * np.abs(summed).max())


def test_orders_that_the_face_angles_do_not_show_do_not_radiate(modes):
    """On 64 angles cos 60 theta appears as cos 4 theta, which radiates.

    cos 32 theta has no resolved partner.
    """
    assert len(modes.face_angle) == 64
    for order in (4, 31, 32, 60):
        shape = np.cos(order * modes.face_angle) + 0 * modes.face_radius[:, None]
        decay = radiation_decay(
            replace(slowed(modes, 20e3, shape), order=np.array([order]))
        )[0]
        assert (decay > 0) == (order < 32)


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
