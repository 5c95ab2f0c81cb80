"""Event-driven integration of hybrid systems, which switch between regimes; without mechanics.

Examples
--------
A ball falls from height 1 under gravity 1 and keeps half of its speed at each impact. Its impacts
are at sqrt(2) (1, 2, 2.5, ...).

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
from itertools import repeat
from typing import Any, NamedTuple, Protocol

import numpy as np


class StalledError(ArithmeticError):
    """The flow cannot be integrated beyond a state, even with the shortest steps."""


class Arc(NamedTuple):
    """The flow within one regime, as a piecewise polynomial.

    Parameters
    ----------
    times : ndarray, (n,)
        Ends of the n pieces, from the start of the arc.
    coefficients : ndarray, (n, order + 1, k)
        Taylor coefficients of the state (k,) in each piece, lowest power first.
    end : list, (k,)
        State at the end.
    guard : str or None
        The guard that ended the arc, if one did.
    passed : tuple of (int, str, regime)
        Changes of regime that the integrator decided itself: the number of pieces before each, the
        guard, and the regime after it.
    origin : list, (k,), or None
        Constant to be added to the coefficients, but not to `end`.
    """

    times: np.ndarray
    coefficients: np.ndarray
    end: list
    guard: str | None
    passed: tuple[tuple[int, str, Any], ...] = ()
    origin: list | None = None

    def until(self, span: float) -> "Arc":
        """Return the part of the arc before `span`."""
        if self.times[-1] <= span:
            return self
        n = int(np.searchsorted(self.times, span))
        begin = self.times[n - 1] if n else 0.0
        last = Step(None, span - begin, self.coefficients[n])
        end = [a + b for a, b in zip(last.end, self.origin or repeat(0.0), strict=False)]
        return Arc(
            times=np.append(self.times[:n], span),
            coefficients=self.coefficients[: n + 1],
            end=end,
            guard=None,
            passed=tuple(change for change in self.passed if change[0] <= n),
            origin=self.origin,
        )


class Step(NamedTuple):
    """A short closed-form step within a regime: duration and Taylor coefficients (order + 1, k)."""

    regime: Any
    duration: float
    coefficients: np.ndarray

    @property
    def end(self) -> list:
        """The state (k,) at the end of the step."""
        return self.at(self.duration)

    def at(self, t: float) -> list:
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
    ahead : Arc or None
        The flow after the event, where it was integrated to decide the regime.
    """

    regime: Any
    state: list
    steps: tuple[Step, ...] = ()
    ended: str | None = None
    ahead: Arc | None = None


class System(Protocol):
    """A hybrid system, as `run_events` integrates it; states are lists (k,)."""

    def begin(self, y: list) -> Switch:
        """Return the regime at the start."""

    def advance(self, y: list, regime: Any, span: float) -> Arc:
        """Integrate until a guard falls through zero, or for at most `span`."""

    def switch(self, y: list, regime: Any, guard: str) -> Switch:
        """Return the regime that follows when `guard` has fallen through zero."""


class Crossing(NamedTuple):
    """A change of regime: time, regimes before and after, and the guard that fell to zero."""

    t: float
    before: Any
    after: Any
    guard: str


@dataclass
class Path:
    """The solution up to time t: a piecewise polynomial, its regimes and the changes of regime.

    Parameters
    ----------
    t : float
        End of the last piece.
    times, coefficients : list of ndarray
        Breakpoints (n,) and Taylor coefficients (n, order + 1, k) of the pieces, by arc.
    regimes : list of (regime, int)
        Consecutive regimes with their numbers of pieces.
    crossings : list of Crossing
        The changes of regime, in order of time.
    """

    t: float = 0.0
    times: list = field(default_factory=lambda: [np.zeros(1)])
    coefficients: list = field(default_factory=list)
    regimes: list = field(default_factory=list)
    crossings: list = field(default_factory=list)

    def extend(self, times, coefficients, regime, passed=(), origin=None) -> Any:
        """Append pieces that end at `times` (n,) after the current end; return the last regime.

        `passed` and `origin` are those of an `Arc`.
        """
        times = self.t + times
        pieces_before = 0
        for pieces, guard, after in passed:
            self.regimes.append((regime, pieces - pieces_before))
            self.crossings.append(Crossing(float(times[pieces - 1]), regime, after, guard))
            regime = after
            pieces_before = pieces
        self.times.append(times)
        if origin:
            coefficients[:, 0] += origin
        self.coefficients.append(coefficients)
        self.regimes.append((regime, len(times) - pieces_before))
        self.t = float(times[-1])
        return regime


EVENT_CASCADE = "cascade"
"""End of a motion whose regime changes without end at one instant."""
STALLED = "stalled"
"""End of a motion that becomes too stiff to integrate."""


def run_events(
    system: System,
    y: list,
    span: float,
    watch: Callable[[float, list], None] = lambda t, y: None,
    max_switches_at_once: int = 100,
) -> tuple[Path, str | None]:
    """Integrate a hybrid system.

    Parameters
    ----------
    system : System
        The system.
    y : list, (k,)
        State at time 0.
    span : float
        Longest duration.
    watch : callable
        Progress callback `watch(t, state)`, called after every arc.
    max_switches_at_once : int
        Changes of regime that may follow each other without time passing.

    Returns
    -------
    path : Path
        The solution.
    guard : str or None
        The guard that ended it: EVENT_CASCADE after too many switches at one instant, STALLED after a
        `StalledError` that is not raised at time 0, None at the end of `span`.
    """
    path = Path()
    start = system.begin(y)
    _append_steps(path, start)
    try:
        return path, _integrate(system, path, start, span, watch, max_switches_at_once)
    except StalledError:
        if not path.t:
            raise
        return path, STALLED


def _integrate(system: System, path, switch, span, watch, max_switches_at_once) -> str | None:
    """Extend a path from a switch to its end; return the guard that ended it."""
    switches_at_once = 0
    while path.t < span:
        start = path.t
        regime = switch.regime
        remaining = span - start
        ahead = switch.ahead
        arc = ahead.until(remaining) if ahead else system.advance(switch.state, regime, remaining)
        regime = path.extend(arc.times, arc.coefficients, regime, arc.passed, arc.origin)
        y = arc.end
        watch(path.t, y)
        if arc.guard is None:
            switch = Switch(regime, y)
            continue
        switch = system.switch(y, regime, arc.guard)
        t = path.t + sum(step.duration for step in switch.steps if step.regime == regime)
        _append_steps(path, switch)
        if switch.ended:
            return switch.ended
        path.crossings.append(Crossing(t, regime, switch.regime, arc.guard))
        switches_at_once = switches_at_once + 1 if path.t == start else 0
        if switches_at_once > max_switches_at_once:
            return EVENT_CASCADE
    return None


def _append_steps(path, switch) -> None:
    """Append the closed-form steps of a switch to a path."""
    for step in switch.steps:
        path.extend(np.array([step.duration]), step.coefficients[None], step.regime)
