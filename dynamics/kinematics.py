"""Kinematics of a disk that touches the plane, dimensionless as in the paper; for scalars and arrays of any kind."""

import numpy as np


def precession_rate(w3, cos_a):
    """Return d theta/dt from the angular velocity along e_3 (2.3), in its unit."""
    return w3 / cos_a


def arms(sin_a, cos_a, h):
    """Return e and f of (4.9): how high the centre lies above the contact, and how far to its side, over the radius."""
    return h * sin_a + cos_a, h * cos_a - sin_a


def centre_velocity(slip, omega, e, h):
    """Return the velocity of the centre along a_1, a_2 from that of the contact point (2.5)."""
    w1, w2, w3 = omega
    return slip[0] + w2 - h * w3, slip[1] - e * w1


def energy(beta, omega, slip, law):
    """Return the dimensionless energy (6.1), with its two errata corrected, zero at rest on the plane; all (...)."""
    sin_a, cos_a = np.cos(beta), np.sin(beta)
    e, f = arms(sin_a, cos_a, law.h)
    v1, v2 = centre_velocity(slip, omega, e, law.h)
    w1, w2, w3 = omega
    v3 = f * w1
    turning = (law.K / 4 + law.h**2 / 3) * (w1 * w1 + w3 * w3) + law.K / 2 * w2 * w2
    height = cos_a - 2 * law.h * np.sin(beta / 2) ** 2  # e - h without cancellation
    return (v1 * v1 + v2 * v2 + v3 * v3 + turning) / 2 + (law.K + 4) / 4 * height
