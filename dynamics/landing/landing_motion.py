"""Motion of a nearly flat disk from the loss of its rolling contact to rest."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from dynamics.disk import Disk
from dynamics.kinematics import ContactPlace, centre_velocity, contact_place
from dynamics.landing.equations import LandingModel, LandingState
from dynamics.landing.solution import Landing, solve_landing
from dynamics.landing.stop import contact_half_arc
from dynamics.motion import (
    CAUSES,
    COLUMNS,
    FILM_COLUMNS,
    ForceJumps,
    MotionBase,
    MotionEvent,
    Outcome,
    Transition,
    read_only,
    times_within,
)

MAX_LANDING_INCLINATION = 0.05
"""Largest inclination [rad] at which a landing is solved; terms of its order are dropped."""


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
        """AT_REST, or ROLLING_ON at the time limit."""
        return Outcome.AT_REST if self.solution.is_at_rest else Outcome.ROLLING_ON

    @property
    def integrator(self) -> str:
        """Name of the integrator."""
        return "LSODA (landing)"

    @property
    def film(self) -> None:
        """None: the wedge of a rolling disk has ended; `model.film` acts."""
        return None

    @property
    def solves_contact(self) -> bool:
        """False, because the contact no longer vibrates."""
        return False

    @property
    def moves_table(self) -> bool:
        """False, because the table does not move."""
        return False

    @property
    def transitions(self) -> tuple[Transition, ...]:
        """No change of regime."""
        return ()

    @property
    def contact_losses(self) -> tuple[()]:
        """No loss of a rolling contact."""
        return ()

    @property
    def jumps(self) -> ForceJumps:
        """No jump of the force."""
        return ForceJumps(np.zeros(0), np.zeros((0, 3)), np.zeros((0, 3)))

    @cached_property
    def t(self) -> np.ndarray:
        """Breakpoints (n,) [s] of the solution."""
        return read_only(self.solution.path.x)

    @property
    def t_end(self) -> float:
        """Time [s] at which the disk is at rest, or of the time limit."""
        return float(self.t[-1])

    def _states(self, t: ArrayLike) -> np.ndarray:
        """Return the states (k, 16) in the order of `LandingState` at times t (k,) [s]."""
        return self.solution.path(times_within(t, self.t[-1]))

    def at(self, t: ArrayLike) -> np.ndarray:
        """Return the state at times t; see `Motion.at`."""
        states = self._states(t)
        rows = [
            self._columns(y, before)
            for y, before in zip(states.tolist(), self._turned_before(t), strict=True)
        ]
        return np.reshape(rows, (-1, len(COLUMNS)))

    @cached_property
    def _precession(self) -> np.ndarray:
        """Precession (n,) [rad] at the breakpoints, continuous through whole turns."""
        states = self.solution.path(self.t)
        angle = np.arctan2(states[:, 1], -states[:, 2])
        return self.start[0] + np.unwrap(angle) - angle[0]

    def _turned_before(self, t: ArrayLike) -> np.ndarray:
        """Return a precession (k,) [rad] within half a turn of the one at times t (k,) [s]."""
        return np.interp(np.atleast_1d(t), self.t, self._precession)

    def _columns(self, y: list[float], near: float) -> list[float]:
        """Return the COLUMNS of a state (16,) whose precession is close to `near` [rad]."""
        at = self.model.geometry(y)
        angle = np.arctan2(at.direction_x, -at.direction_y)
        precession = angle + 2 * np.pi * np.round((near - angle) / (2 * np.pi))
        cosine = np.sqrt(1 - at.slope**2)
        omega = -at.tip / cosine, y[11], at.turn
        spin = self.start[2] + y[10] - (precession - self.start[0])
        c, s = np.cos(precession), np.sin(precession)
        centre = y[8] * c + y[9] * s, y[9] * c - y[8] * s
        slip = centre_to_slip(
            centre, omega, low_point(self.disk, self.rolling_fillet, at.slope)
        )
        lost = self.start[10] + sum(y[12:])
        inclination = np.arcsin(at.slope)
        return [precession, inclination, spin, y[6], y[7], *omega, *slip, lost]

    def force(self, t: ArrayLike) -> np.ndarray:
        """Return the force (k, 3) [N] of the asperities, without friction."""
        loads = (
            self.model.loads(self.model.geometry(y)) for y in self._states(t).tolist()
        )
        return np.reshape([[0.0, 0.0, load.stop.force] for load in loads], (-1, 3))

    def film_loads(self, t: ArrayLike, state: np.ndarray) -> np.ndarray:
        """Return the loads of the film, and what distributes the force of the stop.

        See `Motion.film_loads`. The moments contain the difference between those of the
        ring and those of the same force at the low point.
        """
        rows = [self._film_row(y) for y in self._states(t).tolist()]
        return np.reshape(rows, (-1, len(FILM_COLUMNS)))

    def _film_row(self, y: list[float]) -> list[float]:
        """Return the FILM_COLUMNS of a state (16,)."""
        model = self.model
        at = model.geometry(y)
        film, along, across, stop = model.loads(at)
        cosine = np.sqrt(1 - at.slope**2)
        disk = self.disk
        raising = along * cosine + disk.thickness / 2 * film * at.slope
        at_low_point = -disk.radius * stop.force
        moment_1 = -raising - cosine * (stop.along - at_low_point)
        arc = contact_half_arc(at.gap, model.stop.radius * at.slope)
        return [model.film_gap(at), film, moment_1, across + stop.across, arc]

    def steady_load(self, t: ArrayLike) -> np.ndarray:
        """Return the normal force (k,) [N] at times t (k,) [s]."""
        return self.force(t)[:, 2]

    def steady_nutation(self, t: ArrayLike) -> np.ndarray:
        """Return omega_1 (k,) [rad/s] at times t (k,) [s]."""
        return self.at(t)[:, 5]

    def film_gap(self, t: ArrayLike) -> np.ndarray:
        """Return the mean gap (k,) [m] of the film at times t (k,) [s]."""
        model = self.model
        return np.array(
            [model.film_gap(model.geometry(y)) for y in self._states(t).tolist()]
        )

    def clearance(self, t: ArrayLike) -> np.ndarray:
        """Return the height (k,) [m] of the low point of the rim above the asperities."""
        radius = self.model.stop.radius
        at = [self.model.geometry(y) for y in self._states(t).tolist()]
        return np.array([where.gap - radius * where.slope for where in at])

    def bandwidth(self, state: np.ndarray) -> np.ndarray:
        """Return the highest frequency (k,) [Hz] of the force: that of the stop."""
        stop = self.model.stop
        stiffness = 2 * np.pi * stop.stiffness
        return np.full(len(state), np.sqrt(stiffness / self.disk.mass) / (2 * np.pi))

    def energy(self, t: ArrayLike) -> np.ndarray:
        """Return kinetic, potential and stored energy (k,) [J] at times t (k,) [s]."""
        return np.array([self.model.energy(y) for y in self._states(t).tolist()])

    def energy_lost(self, t: ArrayLike) -> dict[str, np.ndarray]:
        """Return the energy (k,) [J] lost to each of CAUSES up to times t (k,) [s]."""
        states = self._states(t)
        lost = dict.fromkeys(CAUSES, np.zeros(len(states)))
        film = states[:, 12] + states[:, 13] + states[:, 15]
        return lost | {"contact": states[:, 14], "film": film}

    def dissipation(self, t: ArrayLike) -> dict[str, np.ndarray]:
        """Return the power (k,) [W] dissipated by each of CAUSES at times t (k,) [s]."""
        rows = [self.model.rates(0.0, y) for y in self._states(t).tolist()]
        rates = np.reshape(rows, (-1, len(LandingState._fields)))
        power = dict.fromkeys(CAUSES, np.zeros(len(rates)))
        film = rates[:, 12] + rates[:, 13] + rates[:, 15]
        return power | {"contact": rates[:, 14], "film": film}

    def largest_energy_gain_error(self) -> float:
        """Return the largest decrease [J] of the dissipated energy; see `Motion`."""
        lost = self.solution.path(self.t)[:, 12:].sum(axis=1)
        return float(np.max(np.maximum.accumulate(lost) - lost))

    def friction_excess(self) -> float:
        """Return 0: there is no friction."""
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
        return begin, *touches, *self._rest()

    def _touches(self):
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

    def _rest(self):
        """Yield the rest, and the predicted touch of a disk that sinks on its cushion."""
        if not self.solution.is_at_rest:
            return
        t = self.t_end
        energy = float(self.energy(t)[0])
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


def low_point(disk: Disk, fillet: float, slope: float) -> ContactPlace:
    """Return the place of the low point [m] of a disk with the slope sin(beta)."""
    R = disk.radius
    place = contact_place(np.sqrt(1 - slope**2), slope, disk.aspect, fillet / R)
    return ContactPlace(*(R * length for length in place))


def solve_landing_motion(
    model: LandingModel,
    columns: np.ndarray,
    fillet: float,
    cause: str,
    time_limit: float,
    clearance: float = 0.0,
    plan: Any = None,
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
    plan : MotionPlan, optional
        The decisions of the whole motion.

    Returns
    -------
    LandingMotion
        The motion.

    Raises
    ------
    ValueError
        If the inclination exceeds MAX_LANDING_INCLINATION.
    ArithmeticError
        If the integrator fails.
    """
    precession, inclination = columns[:2]
    if not inclination <= MAX_LANDING_INCLINATION:
        raise ValueError(
            f"inclination = {inclination:g}: must be at most {MAX_LANDING_INCLINATION:g} rad"
        )
    place = low_point(model.disk, fillet, np.sin(inclination))
    omega = columns[5:8]
    along, across = centre_velocity(columns[8:10], omega, place)
    c, s = np.cos(precession), np.sin(precession)
    slope = np.sin(inclination)
    tip = -omega[0] * np.cos(inclination)
    start = LandingState(
        height=place.e - model.disk.thickness / 2 + clearance,
        slope_x=slope * s,
        slope_y=-slope * c,
        rise=place.f * omega[0],
        tip_x=tip * s + omega[2] * c,
        tip_y=-tip * c + omega[2] * s,
        x=columns[3],
        y=columns[4],
        speed_x=along * c - across * s,
        speed_y=along * s + across * c,
        turned=0.0,
        axial_rate=omega[1],
    )
    landing = solve_landing(model, LandingState(*map(float, start)), time_limit)
    return LandingMotion(
        solution=landing, start=columns, rolling_fillet=fillet, cause=cause, plan=plan
    )
