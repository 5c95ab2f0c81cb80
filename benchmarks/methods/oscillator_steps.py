"""Advance an oscillator q'' + 2 d q' + w^2 q = g by one step of textbook methods.

step(q, v, g0, g1, w, d, h) returns (q, v) after a step of h [s]; g0 and g1 are the
forces at both ends, w and d are in 1/s. All steps are linear, so that their matrices
describe them completely."""

import numpy as np

from sonify.sound.oscillators import free_response, step_and_ramp_responses


def zero_order_hold(q, v, g0, g1, w, d, h):
    """Step exactly for the constant force g0."""
    return first_order_hold(q, v, g0, g0, w, d, h)


def first_order_hold(q, v, g0, g1, w, d, h):
    """Step exactly for a force that is linear from g0 to g1."""
    c, s = free_response(w, d, h)
    step, ramp = step_and_ramp_responses(w, d, h)
    rise = (g1 - g0) / h
    return (
        (c + d * s) * q + s * v + step * g0 + ramp * rise,
        -w * w * s * q + (c - d * s) * v + s * g0 + step * rise,
    )


def impulse_invariant(q, v, g0, g1, w, d, h):
    """Step exactly for impulses h g0 at the samples."""
    return zero_order_hold(q, v + h * g0, 0.0, 0.0, w, d, h)


def bilinear(q, v, g0, g1, w, d, h):
    """Step by the trapezoidal rule (Tustin): unconditionally stable, with detuned
    frequencies."""
    det = 1 + d * h + (w * h / 2) ** 2
    v1 = ((1 - d * h - (w * h / 2) ** 2) * v - w * w * h * q + h * (g0 + g1) / 2) / det
    return q + h * (v + v1) / 2, v1


def explicit_euler(q, v, g0, g1, w, d, h):
    """Step with the rates at the start; unstable unless d > w^2 h/2."""
    return q + h * v, v + h * (g0 - w * w * q - 2 * d * v)


def semi_implicit_euler(q, v, g0, g1, w, d, h):
    """Step the position with the new velocity (symplectic Euler): stable for w h <
    2."""
    v1 = v + h * (g0 - w * w * q - 2 * d * v)
    return q + h * v1, v1


def verlet(q, v, g0, g1, w, d, h):
    """Step by velocity Verlet with half explicit, half implicit damping; stable for w h
    < 2."""
    half = v + h / 2 * (g0 - w * w * q - 2 * d * v)
    q1 = q + h * half
    return q1, (half + h / 2 * (g1 - w * w * q1)) / (1 + d * h)


def runge_kutta_4(q, v, g0, g1, w, d, h):
    """Step by the classical Runge-Kutta method with a linear force: stable for w h <
    2.83 without damping."""

    def rate(q, v, g):
        return v, g - w * w * q - 2 * d * v

    middle = (g0 + g1) / 2
    a, b = rate(q, v, g0)
    a2, b2 = rate(q + h / 2 * a, v + h / 2 * b, middle)
    a3, b3 = rate(q + h / 2 * a2, v + h / 2 * b2, middle)
    a4, b4 = rate(q + h * a3, v + h * b3, g1)
    return q + h / 6 * (a + 2 * a2 + 2 * a3 + a4), v + h / 6 * (
        b + 2 * b2 + 2 * b3 + b4
    )


STEPS = {
    "exact, zero-order hold": zero_order_hold,
    "exact, first-order hold": first_order_hold,
    "impulse-invariant": impulse_invariant,
    "bilinear": bilinear,
    "Verlet": verlet,
    "semi-implicit Euler": semi_implicit_euler,
    "explicit Euler": explicit_euler,
    "Runge-Kutta 4": runge_kutta_4,
}


def matrices(step, w, d, h) -> np.ndarray:
    """Return the matrices (2, 4, m) of a step of m oscillators, from (q, v, g0, g1) to
    (q, v)."""
    one = np.ones_like(w)
    zero = np.zeros_like(w)
    units = [[one if i == j else zero for i in range(4)] for j in range(4)]
    return np.array(
        [[x + zero for x in step(*unit, w, d, h)] for unit in units]
    ).swapaxes(0, 1)


def growth_and_tuning(step, w, d, h):
    """Return the ratios (m,) of growth per free step and of frequency to their exact
    values."""
    free = np.moveaxis(matrices(step, w, d, h)[:, :2], -1, 0)
    eigenvalues = np.linalg.eigvals(free)
    largest = eigenvalues[np.arange(len(w)), np.abs(eigenvalues).argmax(axis=1)]
    return np.abs(largest) * np.exp(d * h), np.abs(np.angle(largest)) / (
        np.sqrt(w * w - d * d) * h
    )


def static_gain(step, w, d, h):
    """Return the ratio (m,) of the static displacement under a constant force to the
    exact one."""
    table = matrices(step, w, d, h)
    free = np.moveaxis(table[:, :2], -1, 0)
    steady = table[:, 2:].sum(axis=1).T
    return w * w * np.linalg.solve(np.eye(2) - free, steady[..., None])[:, 0, 0]
