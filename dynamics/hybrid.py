"""Event-driven integration of hybrid systems, which switch between regimes.

Examples
--------
A ball falls from height 1 under gravity 1 and retains half of its speed at each impact.
The impacts occur at sqrt(2) (1, 2, 2.5, ...).

>>> import math
>>> import numpy as np
>>> from dynamics.hybrid import Arc, Switch, run_events
>>> class BouncingBall:
...     def begin(self, y):
...         return Switch("flight", y)
...
...     def advance(self, y, regime, span):
...         height, speed = y
...         landing = speed + math.sqrt(speed**2 + 2 * height)
...         t = min(landing, span)
...         coefficients = np.array([[[height, speed], [speed, -1.0], [-0.5, 0.0]]])
...         if landing <= span:
...             return Arc(np.array([t]), coefficients, [0.0, speed - t], "impact")
...         end = [height + speed * t - t * t / 2, speed - t]
...         return Arc(np.array([t]), coefficients, end, None)
...
...     def switch(self, y, regime, guard):
...         return Switch("flight", [0.0, -0.5 * y[1]])
>>> path, guard = run_events(BouncingBall(), [1.0, 0.0], span=3.6)
>>> [round(crossing.t / math.sqrt(2), 9) for crossing in path.crossings]
[1.0, 2.0, 2.5]
>>> guard is None
True
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NamedTuple, Protocol

import numpy as np

MAX_STEPS_PER_ARC = 1000
"""Largest number of steps of an integrator in one arc."""


class StalledError(ArithmeticError):
    """The flow cannot be integrated beyond a state, even with the shortest steps."""


class Arc(NamedTuple):
    """A solution between two events, as a piecewise polynomial.

    Parameters
    ----------
    times : ndarray, (n,)
        End times of the n pieces, measured from the start of the arc.
    coefficients : ndarray, (n, order + 1, k)
        Taylor coefficients of the state (k,) in each piece, lowest power first.
    end : list[Any], (k,)
        State at the end.
    guard : str or None
        The guard that ended the arc, if one did.
    regime_changes : tuple of (int, str, regime)
        Regime changes within the arc, which the integrator handled itself: the number
        of pieces before each, its guard, and the regime after it.
    """

    times: np.ndarray
    coefficients: np.ndarray
    end: list[Any]
    guard: str | None
    regime_changes: tuple[tuple[int, str, Any], ...] = ()

    def until(self, span: float) -> "Arc":
        """Return the part of the arc up to the time `span` after its start."""
        if self.times[-1] <= span:
            return self
        n = int(np.searchsorted(self.times, span))
        begin = self.times[n - 1] if n else 0.0
        last = Step(None, span - begin, self.coefficients[n])
        return Arc(
            times=np.append(self.times[:n], span),
            coefficients=self.coefficients[: n + 1],
            end=last.end,
            guard=None,
            regime_changes=tuple(
                change for change in self.regime_changes if change[0] <= n
            ),
        )


class Step(NamedTuple):
    """A short closed-form step within a regime: duration and Taylor coefficients (order + 1, k)."""

    regime: Any
    duration: float
    coefficients: np.ndarray

    @property
    def end(self) -> list[Any]:
        """The state (k,) at the end of the step."""
        return self.at(self.duration)

    def at(self, t: float) -> list[Any]:
        """Return the state (k,) at time t from the start of the step."""
        return (t ** np.arange(len(self.coefficients)) @ self.coefficients).tolist()


class Switch(NamedTuple):
    """The consequence of an event.

    Parameters
    ----------
    regime, state
        Regime and state (k,) after the event.
    steps : tuple of Step
        Closed-form steps from the event to that state.
    ended : str or None
        The guard that ends the motion, if one does.
    next_arc : Arc or None
        The arc after the event, if it was already integrated to determine the regime.
    """

    regime: Any
    state: list[Any]
    steps: tuple[Step, ...] = ()
    ended: str | None = None
    next_arc: Arc | None = None


class System(Protocol):
    """Interface of a hybrid system for `run_events`; states are lists (k,)."""

    def begin(self, y: list[Any]) -> Switch:
        """Return the regime at the start."""

    def advance(self, y: list[Any], regime: Any, span: float) -> Arc:
        """Integrate until a guard falls through zero, for at most `span`."""

    def switch(self, y: list[Any], regime: Any, guard: str) -> Switch:
        """Return the regime that follows after `guard` has fallen through zero."""


class Crossing(NamedTuple):
    """A change of regime: its time, the regimes before and after it, and the guard."""

    t: float
    before: Any
    after: Any
    guard: str


@dataclass
class Path:
    """The solution up to time t: a piecewise polynomial and its sequence of regimes.

    Parameters
    ----------
    t : float
        End of the last piece.
    times, coefficients : list[Any] of ndarray
        Breakpoints (n,) and Taylor coefficients (n, order + 1, k) of the pieces of each
        arc.
    regimes : list[Any] of (regime, int)
        Consecutive regimes, each with its number of pieces.
    crossings : list[Any] of Crossing
        The changes of regime, in order of time.
    """

    t: float = 0.0
    times: list[Any] = field(default_factory=lambda: [np.zeros(1)])
    coefficients: list[Any] = field(default_factory=list)
    regimes: list[Any] = field(default_factory=list)
    crossings: list[Any] = field(default_factory=list)

    def extend(
        self,
        times: np.ndarray,
        coefficients: np.ndarray,
        regime: Any,
        regime_changes: tuple[tuple[int, str, Any], ...] = (),
    ) -> Any:
        """Append pieces and return the last regime.

        `times` (n,) are the ends of the pieces, measured from the current end of the
        path; `regime_changes` is that of an `Arc`.
        """
        times = self.t + times
        pieces_before = 0
        for pieces, guard, after in regime_changes:
            self.regimes.append((regime, pieces - pieces_before))
            self.crossings.append(
                Crossing(float(times[pieces - 1]), regime, after, guard)
            )
            regime = after
            pieces_before = pieces
        self.times.append(times)
        self.coefficients.append(coefficients)
        self.regimes.append((regime, len(times) - pieces_before))
        self.t = float(times[-1])
        return regime


EVENT_CASCADE = "cascade"
"""End of a path with an unlimited number of regime changes at one instant."""
STALLED = "stalled"
"""End of a path that becomes too stiff to integrate."""


def run_events(
    system: System,
    y: list[Any],
    span: float,
    watch: Callable[[float, list[Any]], None] = lambda t, y: None,
) -> tuple[Path, str | None]:
    """Integrate a hybrid system.

    Parameters
    ----------
    system : System
        The system.
    y : list[Any], (k,)
        State at time 0.
    span : float
        Maximum duration.
    watch : callable
        Progress callback `watch(t, state)`, called after every arc.

    Returns
    -------
    path : Path
        The solution.
    guard : str or None
        The guard that ended it; EVENT_CASCADE after more than 100 regime changes at one
        instant, STALLED after a `StalledError` (which is
        re-raised at time 0), None at the end of `span`.
    """
    path = Path()
    start = system.begin(y)
    _append_steps(path, start)
    try:
        return path, _integrate(system, path, start, span, watch)
    except StalledError:
        if not path.t:
            raise
        return path, STALLED


def _integrate(
    system: System,
    path: Path,
    switch: Switch,
    span: float,
    watch: Callable[[float, list[Any]], None],
) -> str | None:
    """Extend a path from a switch to its end; return the guard that ended it."""
    max_switches_at_once = 100
    switches_at_once = 0
    while path.t < span:
        start = path.t
        regime = switch.regime
        remaining = span - start
        ahead = switch.next_arc
        arc = (
            ahead.until(remaining)
            if ahead
            else system.advance(switch.state, regime, remaining)
        )
        regime = path.extend(arc.times, arc.coefficients, regime, arc.regime_changes)
        y = arc.end
        watch(path.t, y)
        if arc.guard is None:
            switch = Switch(regime, y)
            continue
        switch = system.switch(y, regime, arc.guard)
        t = path.t + sum(
            step.duration for step in switch.steps if step.regime == regime
        )
        _append_steps(path, switch)
        if switch.ended:
            return switch.ended
        path.crossings.append(Crossing(t, regime, switch.regime, arc.guard))
        switches_at_once = switches_at_once + 1 if path.t == start else 0
        if switches_at_once > max_switches_at_once:
            return EVENT_CASCADE
    return None


def _append_steps(path: Path, switch: Switch) -> None:
    """Append the closed-form steps contained in a switch to a path."""
    for step in switch.steps:
        path.extend(np.array([step.duration]), step.coefficients[None], step.regime)
