"""Motion of a disk from the loss of its rolling contact to rest, or to rolling again."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from dynamics.contact_losses import ContactLosses
from dynamics.disk import Disk
from dynamics.kinematics import (
    ContactPlace,
    centre_velocity,
    contact_place_in_metres,
    turned_over,
)
from dynamics.landing import MAX_BOUNCE_ENERGY_ERROR
from dynamics.landing.equations import (
    LOSSES,
    Geometry,
    LandingModel,
    LandingState,
)
from dynamics.landing.solution import Landing, LandingEnd, solve_landing
from dynamics.landing.stop import contact_half_arc
from dynamics.motion import (
    CAUSES,
    COLUMNS,
    FILM_COLUMNS,
    FindingGroup,
    MotionBase,
    MotionEvent,
    Outcome,
    Transition,
    read_only,
    times_within,
)

MAX_BANDWIDTH = 1e5
"""Highest frequency [Hz] at which the force of a landing is sampled."""
TOUCH = "touches the asperities"
"""Kind of the event in which the low point of the rim meets the table again."""


@dataclass(frozen=True, kw_only=True, eq=False)
class LandingMotion(MotionBase):
    """A solved landing as a `Motion`; its time begins at the loss of the rolling contact.

    Parameters
    ----------
    solution : Landing
        The solution.
    start : ndarray, (11,)
        The COLUMNS at the start.
    rolling_fillet : float
        Radius of the edge [m] on which the disk rolled; 0 for a sharp edge.
    cause : str
        What ended the rolling contact, as the kind of an event.
    plan : MotionPlan, optional
        The decisions of the whole motion.
    """

    solution: Landing
    start: np.ndarray
    rolling_fillet: float
    cause: str
    plan: Any = None

    def __repr__(self) -> str:
        """Return a one-line summary."""
        return f"Motion({self.t[-1]:.6g} s, {self.outcome.name}, landing)"

    @property
    def model(self) -> LandingModel:
        """Disk, film and stop."""
        return self.solution.model

    @property
    def disk(self) -> Disk:
        """The disk."""
        return self.model.disk

    @property
    def outcome(self) -> Outcome:
        """AT_REST, STALLED after too many time steps, or ROLLING_ON at the time limit or where
        the disk rolls again."""
        outcomes = {
            LandingEnd.REST: Outcome.AT_REST,
            LandingEnd.STEP_LIMIT: Outcome.STALLED,
        }
        return outcomes.get(self.solution.end, Outcome.ROLLING_ON)

    @property
    def rolling_outcome(self) -> Outcome:
        """The same as `outcome`: the disk does not roll."""
        return self.outcome

    @property
    def finding_groups(self) -> tuple[FindingGroup, ...]:
        """No findings on the rolling contact apply to a motion that begins without it."""
        return ()

    @property
    def max_energy_error(self) -> float:
        """Largest relative error of the energy balance, that of a disk which bounces."""
        return MAX_BOUNCE_ENERGY_ERROR

    @property
    def rolls_on(self) -> bool:
        """True if the disk rolls steadily on one rim at the end."""
        return self.solution.end is LandingEnd.ROLLS

    @property
    def integrator(self) -> str:
        """Name of the integrator."""
        return "LSODA (landing)"

    @property
    def film(self) -> None:
        """None: the wedge of a rolling disk has ended; `model.film` acts."""
        return None

    @property
    def transitions(self) -> tuple[Transition, ...]:
        """No change of regime."""
        return ()

    @cached_property
    def contact_losses(self) -> ContactLosses:
        """Losses of contact: times in which the lowest point is above the asperities."""
        height = self.clearance(self.t)
        is_open = np.concatenate([[0], (height > 0).astype(int), [0]])
        begin, end = (np.flatnonzero(np.diff(is_open) == sign) for sign in (1, -1))
        last = np.minimum(end, len(self.t) - 1)
        highest = [height[i:j].max() for i, j in zip(begin, end, strict=True)]
        rows = np.column_stack([self.t[begin], self.t[last] - self.t[begin], highest])
        return ContactLosses(np.reshape(rows, (-1, 3)))

    @cached_property
    def t(self) -> np.ndarray:
        """Breakpoints (n,) [s] of the solution."""
        return read_only(self.solution.path.x)

    @property
    def t_end(self) -> float:
        """Time [s] at which the disk is at rest, or of the time limit."""
        return float(self.t[-1])

    def _states(self, t: ArrayLike) -> np.ndarray:
        """Return the states (k, 20) in the order of `LandingState` at times t (k,) [s]."""
        return self.solution.path(times_within(t, self.t[-1]))

    def at(self, t: ArrayLike) -> np.ndarray:
        """Return the state at times t; see `Motion.at`."""
        states = self._states(t)
        before = np.searchsorted(self.t, np.atleast_1d(t), "right") - 1
        near = np.interp(np.atleast_1d(t), self.t, self._precession)
        rows = map(self._columns, states.tolist(), before.tolist(), near.tolist())
        return np.reshape(list(rows), (-1, len(COLUMNS)))

    @cached_property
    def _precession(self) -> np.ndarray:
        """Precession (n,) [rad] at the breakpoints, continuous through whole turns."""
        angle = np.array([precession_angle(at) for at in self._geometry])
        return self.start[0] + np.unwrap(angle) - angle[0]

    @cached_property
    def _signed_precession(self) -> np.ndarray:
        """Precession (n,) [rad] at the breakpoints that is part of `LandingState.turned`."""
        side = np.array([at.side for at in self._geometry[1:]])
        return np.append(0.0, np.cumsum(side * np.diff(self._precession)))

    @cached_property
    def _geometry(self) -> list[Geometry]:
        """Geometry at each of the breakpoints."""
        return [self.model.geometry(y) for y in self.solution.path(self.t).tolist()]

    def _columns(self, y: list[float], before: int, near: float) -> list[float]:
        """Return the COLUMNS of a state (20,) whose precession is close to `near` [rad].

        They belong to the face that was the lower one at the start. If it is the upper
        one, the inclination is above pi/2. `before` is the breakpoint before the state.
        """
        at = self.model.geometry(y)
        side = at.side
        angle = precession_angle(at)
        precession = angle + 2 * np.pi * np.round((near - angle) / (2 * np.pi))
        advance = side * (precession - self._precession[before])
        spin = self.start[2] + y[12] - self._signed_precession[before] - advance
        inclination = np.arctan2(at.slope, side * at.cosine)
        omega = side * at.E_p, side * at.spin, -at.E_q
        slip = (side * speed for speed in self._slip(y, at))
        lost = self.start[10] + sum(y[LOSSES])
        return [precession, inclination, spin, *y[8:10], *omega, *slip, lost]

    def _slip(self, y: list[float], at: Geometry) -> tuple[float, float]:
        """Return the slip velocity [m/s] of the low point of the lower face in a state (20,)."""
        ux, uy = at.direction_x, at.direction_y
        vx, vy = y[10:12]
        centre = ux * vy - uy * vx, -ux * vx - uy * vy
        place = contact_place_in_metres(
            self.disk, self.rolling_fillet, at.cosine, at.slope
        )
        return centre_to_slip(centre, (at.E_p, at.spin, -at.E_q), place)

    def rolling_columns(self) -> np.ndarray:
        """Return the COLUMNS (11,) at the end, with respect to the face that is the lower one."""
        (y,) = self._states(self.t_end).tolist()
        at = self.model.geometry(y)
        last = len(self.t) - 1
        columns = np.array(self._columns(y, last, self._precession[last]))
        return columns if at.side > 0 else turned_over(columns)

    def force(self, t: ArrayLike) -> np.ndarray:
        """Return friction along a_1, a_2 and normal force (k, 3) [N] of the rims."""
        return np.reshape(
            [self._force_row(y) for y in self._states(t).tolist()], (-1, 3)
        )

    def _force_row(self, y: list[float]) -> list[float]:
        """Return the force (3,) [N] in a state (20,)."""
        model = self.model
        at = model.geometry(y)
        loads = model.loads(at)
        rim = model.rim_loads(y, at, loads)
        normal = loads.stop.force + loads.upper_stop.force
        return [at.side * rim.force_q, -at.side * rim.force_u, normal]

    def film_loads(self, t: ArrayLike, state: np.ndarray) -> np.ndarray:
        """Return the loads of the film, and what distributes the force of the stop.

        See `Motion.film_loads`. The moments contain the difference between those of the
        ring and those of the same force at the low point.
        """
        rows = [self._film_row(y) for y in self._states(t).tolist()]
        return np.reshape(rows, (-1, len(FILM_COLUMNS)))

    def _film_row(self, y: list[float]) -> list[float]:
        """Return the FILM_COLUMNS of a state (20,)."""
        model = self.model
        at = model.geometry(y)
        film, along, across, stop, upper = model.loads(at)
        disk = self.disk
        raising = along * at.cosine + disk.thickness / 2 * film * at.slope
        raising -= 2 * model.lever * upper.force * at.slope  # acts at the upper rim
        at_low_point = -disk.radius * (stop.force + upper.force)
        turning = stop.along + upper.along - at_low_point
        moment_1 = -at.side * (raising + at.cosine * turning)
        moment_3 = across + stop.across + upper.across
        arc = contact_half_arc(at.gap, model.stop.radius * at.slope)
        return [model.film_gap(at), film, moment_1, moment_3, arc]

    def film_gap(self, t: ArrayLike) -> np.ndarray:
        """Return the mean gap (k,) [m] of the film at times t (k,) [s]."""
        model = self.model
        return np.array(
            [model.film_gap(model.geometry(y)) for y in self._states(t).tolist()]
        )

    def clearance(self, t: ArrayLike) -> np.ndarray:
        """Return the height (k,) [m] of the lowest point of both rims above the asperities."""
        radius = self.model.stop.radius
        at = [self.model.geometry(y) for y in self._states(t).tolist()]
        return np.array(
            [min(one.gap, one.upper_gap) - radius * one.slope for one in at]
        )

    def bandwidth(self, state: np.ndarray) -> np.ndarray:
        """Return the highest frequency (k,) [Hz] of the force that matters to the sound: that
        of the stop, or MAX_BANDWIDTH."""
        stiffness = 2 * np.pi * self.model.stop.stiffness
        frequency = np.sqrt(stiffness / self.disk.mass) / (2 * np.pi)
        return np.full(len(state), min(frequency, MAX_BANDWIDTH))

    def energy(self, t: ArrayLike) -> np.ndarray:
        """Return kinetic, potential and stored energy (k,) [J] at times t (k,) [s]."""
        return np.array([self.model.energy(y) for y in self._states(t).tolist()])

    def energy_lost(self, t: ArrayLike) -> dict[str, np.ndarray]:
        """Return the energy (k,) [J] lost to each of CAUSES up to times t (k,) [s]."""
        return _by_cause(self._states(t))

    def dissipation(self, t: ArrayLike) -> dict[str, np.ndarray]:
        """Return the power (k,) [W] dissipated by each of CAUSES at times t (k,) [s]."""
        rows = [self.model.rates(0.0, y) for y in self._states(t).tolist()]
        return _by_cause(np.reshape(rows, (-1, len(LandingState._fields))))

    def largest_energy_gain_error(self) -> float:
        """Return the largest decrease [J] of the dissipated energy; see `Motion`."""
        lost = self.solution.path(self.t)[:, LOSSES].sum(axis=1)
        return float(np.max(np.maximum.accumulate(lost) - lost))

    def friction_excess(self) -> float:
        """Return 0: the friction of the rims never exceeds its limit."""
        return 0.0

    def tensile_time(self) -> float:
        """Return the time [s] in which the dashpots of the asperities pull the disk."""
        return float(np.diff(self.t) @ (self.force(self.t[:-1])[:, 2] < 0))

    def regime(self, t: ArrayLike) -> np.ndarray:
        """Return 'land' for each of the times t (k,) [s]."""
        return np.full(len(times_within(t, self.t[-1])), "land")

    @cached_property
    def events(self) -> tuple[MotionEvent, ...]:
        """The start, each touch of the asperities, and the rest."""
        begin = MotionEvent(0.0, self.cause, 0.0, float(self.energy(0.0)[0]))
        touches = tuple(self._touches())
        return begin, *touches, *self._end()

    def _touches(self) -> Iterator[MotionEvent]:
        """Yield the touches after the low point was once clearly above the asperities."""
        clear = 1e-7  # m; a lower clearance is a numerical dwell of the contact
        height = self.clearance(self.t)
        first = int(np.argmax(height > clear))
        if height[first] <= clear:
            return
        before = (
            np.flatnonzero((height[first:-1] > 0) & (height[first + 1 :] <= 0)) + first
        )
        for i in before:
            share = height[i] / (height[i] - height[i + 1])
            t = self.t[i] + share * (self.t[i + 1] - self.t[i])
            at = self.model.geometry(self._states(t)[0].tolist())
            speed = self.model.stop.radius * at.tip - at.opening
            yield MotionEvent(float(t), TOUCH, speed, float(self.energy(t)[0]))

    def _end(self) -> Iterator[MotionEvent]:
        """Yield the rest, and the predicted touch of a disk that sinks on its cushion; or
        the rim on which the disk rolls again.
        """
        t = self.t_end
        energy = float(self.energy(t)[0])
        if self.rolls_on:
            at = self.model.geometry(self._states(t)[0].tolist())
            other = "its other rim" if at.side < 0 else "the same rim"
            yield MotionEvent(t, f"rolls again on {other}", 0.0, energy)
        if self.solution.end is not LandingEnd.REST:
            return
        if self.model.geometry(self._states(t)[0].tolist()).slope > 0.5:
            yield MotionEvent(t, "stands still on its edge", 0.0, energy)
            return
        if self.clearance(t)[0] <= 0:
            yield MotionEvent(t, "rests on the asperities", 0.0, energy)
            return
        film = self.model.film
        assert film is not None  # a disk rests on a cushion
        gap = float(self.film_gap(t)[0])
        weight = self.disk.weight
        yield MotionEvent(
            t, "rests on a cushion of air", film.sink_rate(gap, weight), energy
        )
        height = self.model.stop.height
        if height > 0:
            sunk = t + float(film.sink_time(gap, height, weight))
            yield MotionEvent(
                sunk, "has sunk to the asperities", film.sink_rate(height, weight), 0.0
            )


def centre_to_slip(centre: Any, omega: Any, place: ContactPlace) -> tuple[Any, Any]:
    """Return the slip velocity from the velocity of the centre: `centre_velocity` inverted."""
    rolling = centre_velocity((0.0, 0.0), omega, place)
    return centre[0] - rolling[0], centre[1] - rolling[1]


def precession_angle(at: Geometry) -> float:
    """Return the precession [rad] within half a turn, of the face that began as the lower one."""
    return float(np.arctan2(at.side * at.direction_x, -at.side * at.direction_y))


def _by_cause(states: np.ndarray) -> dict[str, np.ndarray]:
    """Return losses, or their rates, (k,) by cause, in states or rates (k, 20)."""
    squeezing, swirling, striking, shearing, rubbing, resisting = states[:, LOSSES].T
    found = dict.fromkeys(CAUSES, np.zeros(len(states)))
    return found | {
        "contact": striking,
        "film": squeezing + swirling + shearing,
        "slip": rubbing,
        "moments": resisting,
    }


def solve_landing_motion(
    model: LandingModel,
    columns: np.ndarray,
    fillet: float,
    cause: str,
    time_limit: float,
    clearance: float = 0.0,
    rise: float = 0.0,
    plan: Any = None,
    **limits: Any,
) -> LandingMotion:
    """Solve the landing of a disk from the columns of the motion that ends.

    Parameters
    ----------
    model : LandingModel
        Disk, film and stop.
    columns : ndarray, (11,)
        The COLUMNS of the motion at the start.
    fillet : float
        Radius of the edge [m] on which the disk rolled.
    cause : str
        What ended the rolling contact, as the kind of an event.
    time_limit : float
        Longest duration [s].
    clearance : float, optional
        Height of the low point above the asperities at the start [m].
    rise : float, optional
        Vertical velocity of the low point at the start [m/s].
    plan : MotionPlan, optional
        The decisions of the whole motion.
    **limits
        Options `may_roll`, `max_rolling_inclination` and `max_steps` of `solve_landing`.

    Returns
    -------
    LandingMotion
        The motion.

    Raises
    ------
    ArithmeticError
        If the integrator fails.
    """
    start = landing_state(model, columns, fillet, clearance, rise)
    landing = solve_landing(model, start, time_limit, **limits)
    return LandingMotion(
        solution=landing, start=columns, rolling_fillet=fillet, cause=cause, plan=plan
    )


def landing_state(
    model: LandingModel,
    columns: np.ndarray,
    fillet: float,
    clearance: float = 0.0,
    rise: float = 0.0,
) -> LandingState:
    """Return the state of a disk in the last columns (11,) of its rolling motion.

    The low point is at the height `clearance` [m] and rises by `rise` [m/s].
    """
    precession, inclination = columns[:2]
    c, s = np.cos(precession), np.sin(precession)
    cosine, sine = np.cos(inclination), np.sin(inclination)
    place = contact_place_in_metres(model.disk, fillet, cosine, sine)
    omega = columns[5:8]
    along, across = centre_velocity(columns[8:10], omega, place)
    p = np.array([cosine * s, -cosine * c, sine])
    q = np.array([c, s, 0.0])
    turn_x, turn_y, turn_z = omega[0] * p - omega[2] * q
    state = LandingState(
        height=place.e - model.disk.thickness / 2 + clearance,
        axis_x=-sine * s,
        axis_y=sine * c,
        axis_z=cosine,
        rise=place.f * omega[0] + rise,
        turn_x=turn_x,
        turn_y=turn_y,
        turn_z=turn_z,
        x=columns[3],
        y=columns[4],
        speed_x=along * c - across * s,
        speed_y=along * s + across * c,
        turned=0.0,
        axial_rate=omega[1],
    )
    return LandingState(*map(float, state))
