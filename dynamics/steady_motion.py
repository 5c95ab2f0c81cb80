"""Closed forms of steady motion for the solver and the plan.

`theory` derives them independently.
"""

from math import atan, cos, sin, sqrt


def flat_square(h: float, K: float) -> float:
    """Return the limit of Omega^2 beta as beta -> 0 in steady motion with a fixed centre."""
    return (1 + 4 / K) / (1 + 4 * h * h / (3 * K))


def steady_precession(beta: float, h: float, K: float) -> float:
    """Return the dimensionless precession rate Omega of steady motion with a fixed centre.

    It solves the second of (5.3) without moments for w2 = h w3, w3 = Omega sin(beta), dw1/dtau = 0;
    beta is the inclination [rad], h = H/R, K = k^2. Raises ValueError if the disk is too thick or
    too steep for such a motion.
    """
    lever = cos(beta) - h * sin(beta)
    inertia = (1 + 4 * h * h / (3 * K)) * cos(beta) - 2 * h * sin(beta)
    if lever * inertia <= 0:
        raise ValueError(f"no steady motion with a fixed centre at an inclination of {beta:g} rad")
    return sqrt((1 + 4 / K) * lever / (sin(beta) * inertia))


def steepest_steady(h: float, K: float) -> float:
    """Return the inclination [rad] below which `steady_precession` exists (lever and inertia >
    0)."""
    return atan(min(1 / h, (1 + 4 * h * h / (3 * K)) / (2 * h)))
