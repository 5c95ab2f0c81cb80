"""Solve the landing of a nearly flat disk until it is at rest."""

from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicHermiteSpline

from dynamics.landing.equations import LandingModel, LandingState

RELATIVE_TOLERANCE = 1e-9
ABSOLUTE_TOLERANCE = LandingState(
    height=1e-13,
    slope_x=1e-12,
    slope_y=1e-12,
    rise=1e-9,
    tip_x=1e-9,
    tip_y=1e-9,
    x=1e-12,
    y=1e-12,
    speed_x=1e-9,
    speed_y=1e-9,
    turned=1e-9,
    axial_rate=1e-9,
    squeezing=1e-13,
    swirling=1e-13,
    striking=1e-13,
    shearing=1e-13,
)
LEVEL_TILT = 0.01
"""Tilt eps of a disk that counts as level: the gap at its rim is uniform within 1 %."""
MAX_KINETIC_SHARE = 1e-3
"""Kinetic over potential energy of a disk that sinks quasi-statically on its cushion."""
REST_ENERGY_SHARE = 1e-6
"""Share of the initial energy with which a disk on its asperities counts as resting."""
POINTS_PER_STEP = 4
"""Number of pieces of cubic polynomials per time step."""


class Landing(NamedTuple):
    """A solved landing.

    Attributes
    ----------
    model : LandingModel
        The model.
    path : CubicHermiteSpline
        State (k, 16) at times (k,) [s] since the start, in the order of `LandingState`.
    is_at_rest : bool
        False if the landing was cut at the time limit.
    """

    model: LandingModel
    path: Any
    is_at_rest: bool


def solve_landing(
    model: LandingModel, start: LandingState, time_limit: float
) -> Landing:
    """Solve the equations until the disk rests on its cushion of air or on the asperities.

    Parameters
    ----------
    model : LandingModel
        Disk, film and stop.
    start : LandingState
        State at the start.
    time_limit : float
        Longest duration [s].

    Returns
    -------
    Landing
        The solution.

    Raises
    ------
    ArithmeticError
        If the integrator fails.
    """
    rests = _rest_guard(model, start)
    found = solve_ivp(
        model.rates,
        (0.0, time_limit),
        start,
        method="LSODA",
        rtol=RELATIVE_TOLERANCE,
        atol=np.array(ABSOLUTE_TOLERANCE),
        dense_output=True,
        events=rests,
    )
    if found.status < 0:
        raise ArithmeticError(
            f"the landing of the disk cannot be solved: {found.message}"
        )
    share = np.arange(POINTS_PER_STEP) / POINTS_PER_STEP
    steps = np.diff(found.t)
    inner = (found.t[:-1, None] + steps[:, None] * share).ravel()
    times = np.append(inner, found.t[-1])
    states = found.sol(times).T
    rates = np.array(
        [model.rates(t, y) for t, y in zip(times, states.tolist(), strict=True)]
    )
    return Landing(model, CubicHermiteSpline(times, states, rates), found.status == 1)


def _rest_guard(model: LandingModel, start: LandingState) -> Any:
    """Return a function of time and state that falls through zero when the disk rests."""
    weight = model.disk.weight
    released = model.energy(start)
    sag = weight / (2 * np.pi * model.stop.stiffness)

    def rests(t: float, y: np.ndarray) -> float:
        at = model.geometry(np.asarray(y).tolist())
        on_stop = excess_energy(y) / (REST_ENERGY_SHARE * released) - 1
        if model.film is None:
            return on_stop
        gap = model.film_gap(at)
        radius = model.film.radius
        tilt = radius * at.slope / (LEVEL_TILT * gap) - 1
        sink = model.film.sink_rate(gap, weight)
        unsteady = abs(at.opening / sink + 1) / 0.1 - 1
        kinetic = model.disk.mass * at.opening**2 / 2
        fast = kinetic / (MAX_KINETIC_SHARE * weight * gap) - 1
        return min(on_stop, max(tilt, unsteady, fast))

    def excess_energy(y: np.ndarray) -> float:
        """Return the energy above that of a disk which lies still on the asperities, without its glide."""
        still = [*y[:8], 0.0, 0.0, y[10], 0.0]
        return model.energy(still) + weight * sag / 2

    rests.terminal = True  # type: ignore[attr-defined]
    rests.direction = -1  # type: ignore[attr-defined]
    return rests
