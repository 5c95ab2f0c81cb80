"""A disk that rolls straight on, upright on both rims: a cylinder on its lateral surface.

Only the rolling resistance, of the constant arm k_2, slows it down:

    (m R^2 + C) n' = -k_2 W sign(n),          v = R n,

where n is the angular velocity about the axis. Its position and its losses are quadratic in
time, and the disk stands still at |n|/|n'|. The vibration of its contacts, which would need
thousands of time steps per second, has ended before.
"""

from typing import NamedTuple

import numpy as np

from dynamics.landing.equations import LandingModel, LandingState

MAX_VIBRATION_SHARE = 1e-6
"""Largest energy of all motion but straight rolling, over the energy, that is neglected."""
JOIN_DURATION = 1e-6
"""Time [s] in which the vibration ends."""
POINT_COUNT = 100
"""Number of points of the solution."""


class StraightRolling(NamedTuple):
    """The solution from its second point on; the first one is the state before.

    Attributes
    ----------
    t : ndarray, (k,)
        Times [s] since the state before.
    states, rates : ndarray, (k, 20)
        States in the order of `LandingState`, and their rates.
    rests : bool
        True if the disk stands still at the end.
    """

    t: np.ndarray
    states: np.ndarray
    rates: np.ndarray
    rests: bool


def steady_part(model: LandingModel, y: list[float]) -> list[float]:
    """Return a state (20,) without its vibration and its creep: the disk rolls straight on.

    The angular momentum about the line of contact is kept.
    """
    at = model.geometry(y)
    disk = model.disk
    ux, uy = at.direction_x, at.direction_y
    glide = disk.mass * disk.radius * (ux * y[11] - uy * y[10])
    spin = (glide + model.axial_inertia * at.spin) / _rolling_inertia(model)
    speed = disk.radius * spin
    across = -uy * speed, ux * speed
    still = 0.0, 0.0, 0.0, 0.0
    return [*y[:4], *still, *y[8:10], *across, y[12], at.side * spin, *y[14:]]


def _rolling_inertia(model: LandingModel) -> float:
    """Return the moment of inertia [kg m^2] about the line of contact."""
    return model.disk.mass * model.disk.radius**2 + model.axial_inertia


def rolls_straight(model: LandingModel, y: list[float]) -> bool:
    """Return whether a disk in a state (20,) rolls straight on, upright on both rims."""
    at = model.geometry(y)
    if max(at.gap, at.upper_gap) >= model.stop.radius * at.slope:
        return False
    energy = model.energy(y)
    vibration = energy - model.energy(steady_part(model, y))
    return vibration < MAX_VIBRATION_SHARE * energy


def roll_straight(
    model: LandingModel, y: list[float], time_limit: float
) -> StraightRolling:
    """Solve the motion of a disk that rolls straight on until it stands still.

    Parameters
    ----------
    model : LandingModel
        The disk.
    y : list of float, (20,)
        Its state, in which `rolls_straight`.
    time_limit : float
        Longest duration [s], above JOIN_DURATION.

    Returns
    -------
    StraightRolling
        The solution.
    """
    start = LandingState(*steady_part(model, y))
    lost = model.energy(y) - model.energy(start)
    start = start._replace(striking=start.striking + max(lost, 0.0))
    disk = model.disk
    resistance = model.friction.arms[1] * disk.weight
    spin = start.axial_rate
    left = time_limit - JOIN_DURATION
    slowing = resistance / _rolling_inertia(model)
    rests = abs(spin) <= slowing * left
    duration = abs(spin) / slowing if rests else left
    now = np.linspace(0, duration, POINT_COUNT)
    rate = -np.sign(spin) * slowing
    factor = 1 + rate * now / spin  # of all speeds
    advance = now * (1 + factor) / 2
    states = np.tile(np.array(start), (POINT_COUNT, 1))
    rates = np.zeros_like(states)
    columns = LandingState._fields.index
    for place, speed in (
        ("x", start.speed_x),
        ("y", start.speed_y),
        ("turned", spin),
    ):
        states[:, columns(place)] += speed * (JOIN_DURATION + advance)
        rates[:, columns(place)] = speed * factor
    for name in ("speed_x", "speed_y", "axial_rate"):
        states[:, columns(name)] *= factor
        rates[:, columns(name)] = getattr(start, name) * rate / spin
    states[:, columns("resisting")] += resistance * abs(spin) * advance
    rates[:, columns("resisting")] = resistance * abs(spin) * factor
    return StraightRolling(JOIN_DURATION + now, states, rates, rests)
