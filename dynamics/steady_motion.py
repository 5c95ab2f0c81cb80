"""Closed-form solutions for steady motion."""

from math import atan2, cos, pi, sin, sqrt, tan

from dynamics.equations import DiskConstants


def squared_rate_times_inclination(h: float, K: float) -> float:
    """Return lim Omega^2 beta for beta -> 0 in steady motion with a fixed centre."""
    return (1 + 4 / K) / (1 + 4 * h * h / (3 * K))


def steady_precession(beta: float, h: float, K: float, fillet: float = 0.0) -> float:
    """Return the dimensionless rate Omega of steady motion with a fixed centre.

    It solves the second of (5.3) without moments for the velocities of `steady_omega`;
    beta is the inclination [rad], h = H/R, K = k^2, and `fillet` the radius of the edge
    divided by R. Raises ValueError if the disk is too thick or too steep for such a
    motion.
    """
    lever = (1 - fillet) * cos(beta) - (h - fillet) * sin(beta)
    ratio = contact_height_to_radius_ratio(beta, h, fillet)
    inertia = (1 + 4 * h * h / (3 * K)) * cos(beta) - 2 * ratio * sin(beta)
    if lever * inertia <= 0:
        raise ValueError(
            f"no steady motion with a fixed centre at an inclination of {beta:g} rad"
        )
    return sqrt((1 + 4 / K) * lever / (sin(beta) * inertia))


def contact_height_to_radius_ratio(beta: float, h: float, fillet: float = 0.0) -> float:
    """Return the ratio of the distances of the contact from the middle plane and the axis.

    It equals omega_2/omega_3 in rolling with a fixed centre.
    """
    return (h - fillet * (1 - cos(beta))) / (1 - fillet * (1 - sin(beta)))


def steady_omega(beta: float, constants: DiskConstants) -> tuple[float, float, float]:
    """Return the dimensionless angular velocity of steady motion with a fixed centre.

    See `steady_precession`.
    """
    w3 = steady_precession(beta, constants.h, constants.K, constants.fillet) * sin(beta)
    return (
        0.0,
        contact_height_to_radius_ratio(beta, constants.h, constants.fillet) * w3,
        w3,
    )


def max_steady_inclination(h: float, K: float, fillet: float = 0.0) -> float:
    """Return the inclination [rad] below which `steady_precession` has a solution.

    Its lever and its inertia are positive there.
    """
    lever = atan2(1 - fillet, h - fillet)
    inertia = 0.0
    step = pi / 4
    while step > 1e-17:  # bisection for tan(beta) depth/radius = (1 + 4 h^2/3K)/2
        middle = inertia + step
        if 2 * contact_height_to_radius_ratio(middle, h, fillet) * tan(
            middle
        ) < 1 + 4 * h * h / (3 * K):
            inertia = middle
        step /= 2
    return min(lever, inertia)
