"""Claim: the event-driven driver, which knows no mechanics, finds every event of a system in its order, at its time.

Source: the bouncing ball, Goebel, Sanfelice & Teel (2012), example 1.1. Oracle: its closed form: impacts at geometric
intervals, which pile up at a finite time.
"""

import numpy as np
import pytest

from dynamics.hybrid import CASCADE, Arc, Switch, drive

HEIGHT, RESTITUTION = 1.0, 0.5


class Ball:
    """A ball under gravity 1 that keeps the part RESTITUTION of its speed at every impact; states (height, speed)."""

    def begin(self, y):
        return Switch("flight", y)

    def advance(self, y, regime, span):
        height, speed = y
        landing = speed + np.sqrt(speed**2 + 2 * height)
        t = min(landing, span)
        series = np.array([[[height, speed], [speed, -1.0], [-0.5, 0.0]]])
        end = [0.0, speed - t] if landing <= span else [height + speed * t - t * t / 2, speed - t]
        return Arc(np.array([t]), series, end, "impact" if landing <= span else None)

    def switch(self, y, regime, guard):
        assert guard == "impact"
        return Switch(regime, [0.0, -RESTITUTION * y[1]])


def impacts(n):
    """Return the times of the first n impacts: t_1 (1 + 2 e + 2 e^2 + ...)."""
    intervals = np.r_[1.0, 2 * RESTITUTION ** np.arange(1, n)]
    return np.sqrt(2 * HEIGHT) * np.cumsum(intervals)


def test_impacts_and_energy_are_those_of_the_closed_form():
    path, ended = drive(Ball(), [HEIGHT, 0.0], 4.0)
    exact = impacts(10)[impacts(10) < 4.0]
    assert ended is None
    assert path.t == 4.0
    assert {(event.before, event.after, event.guard) for event in path.crossings} == {("flight", "flight", "impact")}
    assert [event.t for event in path.crossings] == pytest.approx(exact, rel=1e-14)
    energy = [block[0, 0, 0] + block[0, 0, 1] ** 2 / 2 for block in path.coefficients]
    assert energy == pytest.approx(HEIGHT * RESTITUTION ** (2 * np.arange(len(exact) + 1)), rel=1e-13)


def test_where_impacts_pile_up_time_stands_still_and_the_end_has_a_name():
    path, ended = drive(Ball(), [HEIGHT, 0.0], 10.0)
    assert ended == CASCADE
    assert path.t == pytest.approx(np.sqrt(2 * HEIGHT) * (1 + RESTITUTION) / (1 - RESTITUTION), rel=1e-14)
    assert [event.t for event in path.crossings][:40] == pytest.approx(impacts(40), rel=1e-14)
