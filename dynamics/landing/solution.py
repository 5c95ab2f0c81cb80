"""Solve the motion of a disk that has lost its rolling contact."""

from collections.abc import Callable
from enum import Enum
from math import hypot
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import LSODA
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import brentq

from dynamics.landing.equations import (
    LOSSES,
    MAX_FILM_SLOPE,
    Geometry,
    LandingModel,
    LandingState,
)
from dynamics.landing.straight_rolling import (
    JOIN_DURATION,
    roll_straight,
    rolls_straight,
)

RELATIVE_TOLERANCE = 5e-11
"""Relative tolerance of the integrator. Nearly all of the error of the energy arises in the
springs of the contacts, in proportion to it; with this value, a fall with its bounces closes
to 1e-8 of the initial energy."""
ABSOLUTE_TOLERANCE = LandingState(
    height=1e-13,
    axis_x=1e-12,
    axis_y=1e-12,
    axis_z=1e-12,
    rise=1e-11,  # a disk on its cushion sinks by 0.1 um/s
    turn_x=1e-10,
    turn_y=1e-10,
    turn_z=1e-10,
    x=1e-12,
    y=1e-12,
    speed_x=1e-9,
    speed_y=1e-9,
    turned=1e-9,
    axial_rate=1e-9,
    squeezing=1e-17,  # minutes of sinking are added up
    swirling=1e-13,
    striking=1e-13,
    shearing=1e-13,
    rubbing=1e-13,
    resisting=1e-13,
)
LEVEL_TILT = 0.01
"""Tilt eps of a disk that counts as level: the gap at its rim is uniform within 1 %."""
MAX_KINETIC_SHARE = 1e-3
"""Kinetic over potential energy of a disk that sinks quasi-statically on its cushion."""
REST_ENERGY_SHARE = 1e-6
"""Share of the initial energy with which a disk on its asperities counts as resting."""
MAX_STEPS = 500_000
"""Largest number of time steps of all landings of a motion."""
POINTS_PER_STEP = 4
"""Number of pieces of cubic polynomials per time step; half of it while a disk tumbles."""
ROLLING_SPAN = 0.01
"""Time [s] in which a disk must roll without vibration before its contact counts as rigid."""
MIN_RESUMED_SLOPE = 0.02
"""Least sine of the inclination of a disk that rolls again."""
MIN_OTHER_RIM_HEIGHT = 1e-6
"""Least height [m] of the other rim above the table."""
MIN_ROLLING_LOAD = 0.1
"""Least contact force over the weight of a disk that rolls again."""
MAX_FRICTION_SHARE = 0.9
"""Largest friction over its limit of a disk that rolls again."""
MAX_RIM_SPEED = 1e-3
"""Largest vertical speed [m/s] of the low point of the rim."""


class LandingEnd(Enum):
    """What ends a landing."""

    REST = "the disk is at rest"
    ROLLS = "the disk rolls steadily on one rim"
    TIME_LIMIT = "the time limit is reached"
    STEP_LIMIT = "the number of time steps is too large"


class Landing(NamedTuple):
    """A solved landing.

    Attributes
    ----------
    model : LandingModel
        The model.
    path : CubicHermiteSpline
        State (k, 20) at times (k,) [s] since the start, in the order of `LandingState`.
    end : LandingEnd
        What ended it.
    steps : int
        Number of time steps.
    """

    model: LandingModel
    path: Any
    end: LandingEnd
    steps: int


def solve_landing(
    model: LandingModel,
    start: LandingState,
    time_limit: float,
    may_roll: bool = False,
    max_steps: int = MAX_STEPS,
    max_rolling_inclination: float = np.pi / 2,
) -> Landing:
    """Solve the equations until the disk rests on air, on its face or on its edge, or rolls again.

    Parameters
    ----------
    model : LandingModel
        Disk, film and stop.
    start : LandingState
        State at the start.
    time_limit : float
        Longest duration [s].
    may_roll : bool, optional
        True if the solution ends where the disk rolls steadily on one rim.
    max_steps : int, optional
        Largest number of time steps.
    max_rolling_inclination : float, optional
        Largest inclination [rad] at which this end is possible.

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
    solver = _solver(model, start, time_limit)
    points = POINTS_PER_STEP // 2 if may_roll else POINTS_PER_STEP
    share = np.arange(1, points + 1) / points
    times, states = [np.zeros(1)], [np.array([start])]
    rates = [np.array([model.rates(0.0, start)])]
    margin = rests(0.0, solver.y)
    span_begin, span_end = 0, ROLLING_SPAN
    end = None
    while end is None:
        message = solver.step()
        if solver.status == "failed" or solver.t == solver.t_old:
            message = message or "the time step is too short"
            raise ArithmeticError(
                f"the landing of the disk cannot be solved: {message}"
            )
        path = solver.dense_output()
        last = solver.t
        before, margin = margin, rests(last, solver.y)
        has_come_to_rest = before > 0 >= margin
        if has_come_to_rest:
            last = _zero_of(rests, path, solver.t_old, last)
        inner = solver.t_old + (last - solver.t_old) * share
        times.append(inner)
        states.append(path(inner).T)
        rates.append(_rates_of_path(path, inner))
        if has_come_to_rest:
            end = LandingEnd.REST
        elif solver.status == "finished":
            end = LandingEnd.TIME_LIMIT
        elif len(times) > max_steps:
            end = LandingEnd.STEP_LIMIT
        elif last >= span_end:
            span = np.concatenate(states[span_begin:])
            flat_enough = abs(span[-1, 3]) > np.cos(max_rolling_inclination)
            if may_roll and flat_enough and _all_in(_rolls, model, span):
                end = LandingEnd.ROLLS
            elif last + JOIN_DURATION < time_limit and _all_in(
                rolls_straight, model, span
            ):
                further = roll_straight(model, span[-1].tolist(), time_limit - last)
                times.append(last + further.t)
                states.append(further.states)
                rates.append(further.rates)
                end = LandingEnd.REST if further.rests else LandingEnd.TIME_LIMIT
            span_begin, span_end = len(states), last + ROLLING_SPAN
    return Landing(model, _spline(times, states, rates), end, len(times) - 1)


def _zero_of(rests: Any, path: Any, begin: float, end: float) -> float:
    """Return the time [s] in a step, whose states are path(t), at which `rests` is zero."""
    return brentq(lambda t: rests(t, path(t)), begin, end)


def _solver(model: LandingModel, start: LandingState, time_limit: float) -> LSODA:
    """Return an integrator."""
    tolerance = np.array(ABSOLUTE_TOLERANCE)

    def rates(t: float, y: np.ndarray) -> list[float]:
        return model.rates(t, y.tolist())  # floats of Python are faster

    first = np.array(start)
    return LSODA(rates, 0.0, first, time_limit, rtol=RELATIVE_TOLERANCE, atol=tolerance)


def _rates_of_path(path: Any, t: np.ndarray) -> np.ndarray:
    """Return the rates (k, 20) of the polynomial of a step at times t (k,) [s]."""
    powers = np.arange(1, path.yh.shape[1])
    terms = powers * ((t[:, None] - path.t) / path.h) ** (powers - 1)
    return terms @ path.yh[:, 1:].T / path.h


def _spline(
    times: list[np.ndarray], states: list[np.ndarray], rates: list[np.ndarray]
) -> CubicHermiteSpline:
    """Return the spline through the states (k, 20) and their rates (k, 20) of all steps.

    The losses never decrease; errors of the integration that let them are removed, and
    remain in the balance of energy.
    """
    y = np.concatenate(states)
    y[:, LOSSES] = np.maximum.accumulate(y[:, LOSSES])
    return CubicHermiteSpline(np.concatenate(times), y, np.concatenate(rates))


def _all_in(
    judge: Callable[[LandingModel, list[float]], bool],
    model: LandingModel,
    states: np.ndarray,
) -> bool:
    """Return whether `judge` accepts about a hundred of the states (k, 20), and the last one."""
    some = [states[-1], *states[:: len(states) // 100 + 1]]
    return all(judge(model, y.tolist()) for y in some)


def _rolls(model: LandingModel, y: list[float]) -> bool:
    """Return whether a disk in a state (20,) rolls on its lower rim alone.

    Near the table, a film may lift it, and in a vacuum the other side of its rim touches.
    """
    at = model.geometry(y)
    R = model.stop.radius
    if (
        at.slope < MIN_RESUMED_SLOPE
        or at.upper_gap <= R * at.slope + MIN_OTHER_RIM_HEIGHT
    ):
        return False
    loads = model.loads(at)
    load = loads.stop.force
    if load < MIN_ROLLING_LOAD * model.disk.weight:
        return False
    rim = model.rim_loads(y, at, loads)
    grip = (
        hypot(rim.force_u, rim.force_q)
        <= MAX_FRICTION_SHARE * model.friction.coefficient * load
    )
    return grip and abs(at.opening - R * at.tip) < MAX_RIM_SPEED


def _rest_guard(model: LandingModel, start: LandingState) -> Any:
    """Return a function of time and state (20,) that falls through zero when the disk rests."""
    weight = model.disk.weight
    released = model.energy(start)
    sag = weight / (2 * np.pi * model.stop.stiffness)
    least = REST_ENERGY_SHARE * released

    def rests(t: float, y: np.ndarray) -> float:
        state = y.tolist()
        at = model.geometry(state)
        rest = min(lying_energy(state) / least - 1, on_edge(state, at))
        if model.film is None or at.slope > MAX_FILM_SLOPE:
            return rest
        gap = model.film_gap(at)
        radius = model.film.radius
        tilt = radius * at.slope / (LEVEL_TILT * gap) - 1
        sink = model.film.sink_rate(gap, weight)
        unsteady = abs(at.opening / sink + 1) / 0.1 - 1
        kinetic = model.disk.mass * at.opening**2 / 2
        fast = kinetic / (MAX_KINETIC_SHARE * weight * gap) - 1
        return min(rest, max(tilt, unsteady, fast))

    def lying_energy(y: list[float]) -> float:
        """Return the energy above that of a disk which lies still on the asperities.

        Without friction, the disk may glide and spin.
        """
        moves = float(model.friction.coefficient > 0)
        glide = (moves * speed for speed in y[10:12])
        still = [*y[:10], *glide, y[12], moves * y[13]]
        return model.energy(still) + weight * sag / 2

    def on_edge(y: list[float], at: Geometry) -> float:
        """Return a number that is positive unless the disk stands still on both rims."""
        if max(at.gap, at.upper_gap) > model.stop.radius * at.slope:
            return 1.0
        still = [*y[:4], 0.0, 0.0, 0.0, 0.0, *y[8:10], 0.0, 0.0, y[12], 0.0]
        return (model.energy(y) - model.energy(still)) / least - 1

    return rests
