"""Event-driven integration of a system that switches between regimes; it knows no mechanics.

A system offers three calls:
  begin(y) -> Switch                      the regime at the start,
  advance(y, regime, span) -> Arc         the flow until a guard falls through zero, or for part of the span,
  switch(y, regime, guard) -> Switch      what follows when a guard has fired.
"""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np


class StalledError(ArithmeticError):
    """The flow cannot be followed any further from a state, however short the steps."""


class Arc(NamedTuple):
    """A stretch of one regime: ends of its n pieces, Taylor coefficients (n, order + 1, k), end state, guard fired.

    `passed` are the changes of regime that an integrator decides itself and goes on: the number of pieces before each,
    the guard, and the regime after it.
    """

    times: np.ndarray
    coefficients: np.ndarray
    end: list
    guard: str | None
    passed: tuple[tuple[int, str, Any], ...] = ()


class Step(NamedTuple):
    """A short step taken in closed form within a regime: its duration and Taylor coefficients (order + 1, k).

    `is_sure`: every guard is known to stay positive along it.
    """

    regime: Any
    duration: float
    coefficients: np.ndarray
    is_sure: bool = False

    @property
    def end(self) -> list:
        """The state at the end of the step, (k,)."""
        return self.at(self.duration)

    def at(self, t: float) -> list:
        """Return the state (k,) after t."""
        return (t ** np.arange(len(self.coefficients)) @ self.coefficients).tolist()


class Switch(NamedTuple):
    """What follows an event: the regime, the state and the closed steps to it; or how the motion `ended`."""

    regime: Any
    state: list
    steps: tuple[Step, ...] = ()
    ended: str | None = None


class Crossing(NamedTuple):
    """One change of regime: when, from, to, and the guard that fired."""

    t: float
    before: Any
    after: Any
    guard: str


@dataclass
class Path:
    """The solution so far: breakpoints, one Taylor polynomial and one regime for each piece, and the crossings."""

    t: float = 0.0
    times: list = field(default_factory=lambda: [np.zeros(1)])
    coefficients: list = field(default_factory=list)
    regimes: list = field(default_factory=list)
    crossings: list = field(default_factory=list)

    def extend(self, times, coefficients, regime, passed=()) -> Any:
        """Append pieces that end at `times` (n,), counted from the present end; return the regime of the last.

        `passed` are the changes of regime on the way, as in `Arc`.
        """
        times, done = self.t + times, 0
        for pieces, guard, after in passed:
            self.regimes.append((regime, pieces - done))
            self.crossings.append(Crossing(float(times[pieces - 1]), regime, after, guard))
            regime, done = after, pieces
        self.times.append(times)
        self.coefficients.append(coefficients)
        self.regimes.append((regime, len(times) - done))
        self.t = float(times[-1])
        return regime


MOST_AT_ONCE = 100
"""Changes of regime that may follow one another while time stands still; more is the outcome `CASCADE`."""
CASCADE, STALLED = "cascade", "stalled"


def drive(system, y, span, watch=lambda t, y: None) -> tuple[Path, str | None]:
    """Integrate `system` from y over at most `span`; return the path and what ended it, None for the span.

    `watch(t, state)` is called after every arc. More than MOST_AT_ONCE switches that take no time end it as CASCADE, a
    StalledError after the first instant as STALLED.
    """
    path = Path()
    regime, y = _take(path, system.begin(y))
    try:
        return path, _follow(system, path, regime, y, span, watch)
    except StalledError:
        if not path.t:
            raise
        return path, STALLED


def _follow(system, path, regime, y, span, watch) -> str | None:
    """Extend the path from y in `regime` to its end; return what ended it."""
    at_once = 0
    while path.t < span:
        start = path.t
        arc = system.advance(y, regime, span - path.t)
        regime, y = path.extend(arc.times, arc.coefficients, regime, arc.passed), arc.end
        watch(path.t, y)
        if arc.guard is None:
            continue
        before, switch = regime, system.switch(y, regime, arc.guard)
        now = path.t + sum(step.duration for step in switch.steps if step.regime == before)
        regime, y = _take(path, switch)
        if switch.ended:
            return switch.ended
        path.crossings.append(Crossing(now, before, regime, arc.guard))
        at_once = at_once + 1 if path.t == start else 0
        if at_once > MOST_AT_ONCE:
            return CASCADE
    return None


def _take(path, switch):
    """Append the closed steps of a switch; return its regime and state."""
    for step in switch.steps:
        path.extend(np.array([step.duration]), step.coefficients[None], step.regime)
    return switch.regime, switch.state
