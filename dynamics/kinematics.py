"""Kinematics of a disk in contact with the plane, dimensionless; for scalars and arrays."""

import numpy as np


def precession_rate(w3, cos_a):
    """Return the precession rate d theta/dt from the angular velocity along e_3 (2.3)."""
    return w3 / cos_a


def contact_arms(sin_a, cos_a, h):
    """Return e and f of (4.9): vertical and horizontal distance of centre and contact, over R."""
    return h * sin_a + cos_a, h * cos_a - sin_a


def centre_velocity(slip, omega, e, h):
    """Return the velocity of the centre along a_1, a_2 from the slip velocity (2.5)."""
    w1, w2, w3 = omega
    return slip[0] + w2 - h * w3, slip[1] - e * w1


def energy(beta, omega, slip, law):
    """Return the dimensionless energy (6.1) with its two misprints corrected; zero at rest."""
    sin_a = np.cos(beta)
    cos_a = np.sin(beta)
    e, f = contact_arms(sin_a, cos_a, law.h)
    v1, v2 = centre_velocity(slip, omega, e, law.h)
    w1, w2, w3 = omega
    v3 = f * w1
    rotation = (law.K / 4 + law.h**2 / 3) * (w1 * w1 + w3 * w3) + law.K / 2 * w2 * w2
    height = cos_a - 2 * law.h * np.sin(beta / 2) ** 2  # e - h, without cancellation
    return (v1 * v1 + v2 * v2 + v3 * v3 + rotation) / 2 + (law.K + 4) / 4 * height
