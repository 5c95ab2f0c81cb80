"""Steady motions in closed form, as the solver and the plan need them; `theory` reaches them by another way."""

from math import cos, sin, sqrt


def flat_square(h: float, K: float) -> float:
    """Return Omega^2 beta of a steady motion with a fixed centre as beta -> 0: the limit of `steady_precession`."""
    return (1 + 4 / K) / (1 + 4 * h * h / (3 * K))


def steady_precession(beta: float, h: float, K: float) -> float:
    """Return the dimensionless precession rate of the steady motion with a fixed centre at inclination `beta` [rad].

    It is what the second of (5.3) leaves of w2 = h w3, w3 = Omega sin(beta), dw1/dtau = 0, without a moment; h = H/R,
    K = k^2. Raises ValueError where the disk is so thick or so steep that there is none.
    """
    lever, inertia = cos(beta) - h * sin(beta), (1 + 4 * h * h / (3 * K)) * cos(beta) - 2 * h * sin(beta)
    return sqrt((1 + 4 / K) * lever / (sin(beta) * inertia))
