"""Event-driven integration of a system that switches between regimes; it knows no mechanics.

A system offers three calls:
  begin(y) -> Switch                      the regime at the start,
  advance(y, regime, span) -> Arc         the flow until a guard falls through zero, or for part of the span,
  switch(y, regime, guard) -> Switch      what follows when a guard has fired.
"""

from dataclasses import dataclass, field
from itertools import repeat
from typing import Any, NamedTuple

import numpy as np


class StalledError(ArithmeticError):
    """The flow cannot be followed any further from a state, however short the steps."""


class Arc(NamedTuple):
    """A stretch of one regime: ends of its n pieces, Taylor coefficients (n, order + 1, k), end state, guard fired.

    `passed` are the changes of regime that an integrator decides itself and goes on: the number of pieces before each,
    the guard, and the regime after it. `origin` (k,), where there is one, is still to be added to the coefficients, not
    to the end.
    """

    times: np.ndarray
    coefficients: np.ndarray
    end: list
    guard: str | None
    passed: tuple[tuple[int, str, Any], ...] = ()
    origin: list | None = None

    def until(self, span: float) -> "Arc":
        """Return the part of it before `span`."""
        if self.times[-1] <= span:
            return self
        n = int(np.searchsorted(self.times, span))
        last = Step(None, span - (self.times[n - 1] if n else 0.0), self.coefficients[n])
        passed = tuple(change for change in self.passed if change[0] <= n)
        end = [a + b for a, b in zip(last.end, self.origin or repeat(0.0), strict=False)]
        return Arc(np.append(self.times[:n], span), self.coefficients[: n + 1], end, None, passed, self.origin)


class Step(NamedTuple):
    """A short step taken in closed form within a regime: its duration and Taylor coefficients (order + 1, k)."""

    regime: Any
    duration: float
    coefficients: np.ndarray

    @property
    def end(self) -> list:
        """The state at the end of the step, (k,)."""
        return self.at(self.duration)

    def at(self, t: float) -> list:
        """Return the state (k,) after t."""
        return (t ** np.arange(len(self.coefficients)) @ self.coefficients).tolist()


class Switch(NamedTuple):
    """What follows an event: the regime, the state and the closed steps to it; or how the motion `ended`.

    `ahead` is the flow from there, where it had to be integrated to know.
    """

    regime: Any
    state: list
    steps: tuple[Step, ...] = ()
    ended: str | None = None
    ahead: Arc | None = None


class Crossing(NamedTuple):
    """One change of regime: when, from, to, and the guard that fired."""

    t: float
    before: Any
    after: Any
    guard: str


@dataclass
class Path:
    """The solution so far: breakpoints, the coefficients of the pieces (n, order + 1, k) and their regimes, arc by arc,
    and the crossings."""

    t: float = 0.0
    times: list = field(default_factory=lambda: [np.zeros(1)])
    coefficients: list = field(default_factory=list)
    regimes: list = field(default_factory=list)
    crossings: list = field(default_factory=list)

    def extend(self, times, coefficients, regime, passed=(), origin=None) -> Any:
        """Append pieces that end at `times` (n,), counted from the present end; return the regime of the last.

        `passed` and `origin` are those of an `Arc`.
        """
        times, done = self.t + times, 0
        for pieces, guard, after in passed:
            self.regimes.append((regime, pieces - done))
            self.crossings.append(Crossing(float(times[pieces - 1]), regime, after, guard))
            regime, done = after, pieces
        self.times.append(times)
        if origin:
            coefficients[:, 0] += origin
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
    start = system.begin(y)
    _take(path, start)
    try:
        return path, _follow(system, path, start, span, watch)
    except StalledError:
        if not path.t:
            raise
        return path, STALLED


def _follow(system, path, switch, span, watch) -> str | None:
    """Extend the path from what `switch` leads to, to its end; return what ended it."""
    at_once = 0
    while path.t < span:
        start, regime, y = path.t, switch.regime, switch.state
        arc = switch.ahead.until(span - start) if switch.ahead else system.advance(y, regime, span - start)
        regime, y = path.extend(arc.times, arc.coefficients, regime, arc.passed, arc.origin), arc.end
        watch(path.t, y)
        if arc.guard is None:
            switch = Switch(regime, y)
            continue
        switch = system.switch(y, regime, arc.guard)
        now = path.t + sum(step.duration for step in switch.steps if step.regime == regime)
        _take(path, switch)
        if switch.ended:
            return switch.ended
        path.crossings.append(Crossing(now, regime, switch.regime, arc.guard))
        at_once = at_once + 1 if path.t == start else 0
        if at_once > MOST_AT_ONCE:
            return CASCADE
    return None


def _take(path, switch) -> None:
    """Append the closed steps of a switch."""
    for step in switch.steps:
        path.extend(np.array([step.duration]), step.coefficients[None], step.regime)
