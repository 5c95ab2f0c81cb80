"""Claim: the table below a moving contact has the static response and the free decay of its modes,
and its shape is that at the azimuth of the contact.

Source: dynamics/compliant/law/driven_table.py. Oracle: closed forms of a damped oscillator.
"""

from types import SimpleNamespace

import numpy as np
import pytest

from dynamics.compliant.law.driven_table import (
    advance_table,
    driven_table,
    set_contact_circle,
)

STEP = 1e-5  # s
FREQUENCY = np.array([300.0, 1100.0])
DECAY = np.array([20.0, 60.0])


def modes(order=0):
    """Return modes with the shapes cos(order azimuth) at any radius."""

    def at(x, y):
        azimuth = np.arctan2(y, x)
        return np.column_stack([np.cos(order * azimuth), 2 * np.cos(order * azimuth)])

    return SimpleNamespace(frequency=FREQUENCY, decay_rate=DECAY, at=at)


def table_under(order=0):
    table = driven_table(modes(order), STEP)
    set_contact_circle(table, modes(order), [0.0, 0.0], 0.03)
    table.at_contact[:] = table.shapes[0]
    return table


def test_a_constant_force_lowers_the_table_by_its_static_response():
    table = table_under()
    table.force[0] = 2.0
    for _ in range(60_000):  # the slowest decay takes 5,000 steps
        advance_table(table, 0.0)
    omega = 2 * np.pi * FREQUENCY
    static = -2.0 * np.sum(np.array([1.0, 4.0]) / omega**2)
    assert table.deflection[0] == pytest.approx(static, rel=1e-4)


def test_free_modes_decay_with_their_own_frequency():
    table = table_under()
    omega = np.sqrt((2 * np.pi * FREQUENCY) ** 2 - DECAY**2)

    def exact(step):
        t = step * STEP
        return np.exp(-DECAY * t) * np.cos(omega * t)

    table.earlier_amplitude[:] = exact(-1)
    table.amplitude[:] = exact(0)
    for _ in range(1000):
        advance_table(table, 0.0)
    assert table.amplitude == pytest.approx(exact(1000), abs=1e-9)


@pytest.mark.parametrize("azimuth", [0.3, 2 * np.pi - 0.3, -0.3, 40.0])
def test_the_shape_is_that_at_the_azimuth_of_the_contact(azimuth):
    """Linear interpolation between 512 azimuths is right to (2 pi/512)^2/8 of the shape."""
    table = table_under(order=1)
    advance_table(table, azimuth)
    shape = np.cos(azimuth) * np.array([1.0, 2.0])
    assert table.at_contact == pytest.approx(shape, abs=4e-5)


def test_a_rigid_table_does_not_move():
    table = driven_table(None, STEP)
    table.force[0] = 5.0
    assert advance_table(table, 1.0) == 0.0
