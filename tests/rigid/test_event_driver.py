"""Claim: the event-driven driver, which contains no mechanics, finds every event of a system in
order and at the correct time.

Source: the bouncing ball, Goebel, Sanfelice & Teel (2012), example 1.1. Oracle: closed forms. The
intervals between the ball's impacts form a geometric sequence with a finite sum.
"""

import numpy as np
import pytest

from dynamics.hybrid import EVENT_CASCADE, Arc, Switch, run_events

HEIGHT, RESTITUTION = 1.0, 0.5


class Ball:
    """A ball under gravity 1 with restitution RESTITUTION; states (height, speed)."""

    def begin(self, y):
        return Switch("flight", y)

    def advance(self, y, regime, span):
        height, speed = y
        landing = speed + np.sqrt(speed**2 + 2 * height)
        t = min(landing, span)
        series = np.array([[[height, speed], [speed, -1.0], [-0.5, 0.0]]])
        end = (
            [0.0, speed - t]
            if landing <= span
            else [height + speed * t - t * t / 2, speed - t]
        )
        return Arc(np.array([t]), series, end, "impact" if landing <= span else None)

    def switch(self, y, regime, guard):
        assert guard == "impact"
        return Switch(regime, [0.0, -RESTITUTION * y[1]])


def impacts(n):
    """Return the times of the first n impacts: t_1 (1 + 2 e + 2 e^2 + ...)."""
    intervals = np.r_[1.0, 2 * RESTITUTION ** np.arange(1, n)]
    return np.sqrt(2 * HEIGHT) * np.cumsum(intervals)


def test_impacts_and_energy_are_those_of_the_closed_form():
    path, ended = run_events(Ball(), [HEIGHT, 0.0], 4.0)
    exact = impacts(10)[impacts(10) < 4.0]
    assert ended is None
    assert path.t == 4.0
    assert {(event.before, event.after, event.guard) for event in path.crossings} == {
        ("flight", "flight", "impact")
    }
    assert [event.t for event in path.crossings] == pytest.approx(exact, rel=1e-14)
    energy = [block[0, 0, 0] + block[0, 0, 1] ** 2 / 2 for block in path.coefficients]
    assert energy == pytest.approx(
        HEIGHT * RESTITUTION ** (2 * np.arange(len(exact) + 1)), rel=1e-13
    )


def test_where_impacts_pile_up_time_stands_still_and_the_end_has_a_name():
    path, ended = run_events(Ball(), [HEIGHT, 0.0], 10.0)
    assert ended == EVENT_CASCADE
    assert path.t == pytest.approx(
        np.sqrt(2 * HEIGHT) * (1 + RESTITUTION) / (1 - RESTITUTION), rel=1e-14
    )
    assert [event.t for event in path.crossings][:40] == pytest.approx(
        impacts(40), rel=1e-14
    )


class AheadBall(Ball):
    """A ball that returns two arcs at once and passes the impact between them by itself."""

    def switch(self, y, regime, guard):
        after = super().switch(y, regime, guard)
        first = self.advance(after.state, regime, np.inf)
        second = self.advance(
            super().switch(first.end, regime, first.guard).state, regime, np.inf
        )
        times = np.append(first.times, first.times + second.times)
        series = np.concatenate([first.coefficients, second.coefficients])
        return after._replace(
            next_arc=Arc(
                times, series, second.end, second.guard, ((1, "impact", regime),)
            )
        )


@pytest.mark.parametrize("span", [2.0, 3.0, 4.0, 4.2])
def test_what_is_integrated_ahead_is_the_path_that_is_integrated_in_turn(span):
    path, ended = run_events(AheadBall(), [HEIGHT, 0.0], span)
    plain, _ = run_events(Ball(), [HEIGHT, 0.0], span)
    assert ended is None
    assert path.t == span
    assert np.concatenate(path.times) == pytest.approx(
        np.concatenate(plain.times), rel=1e-14
    )
    assert np.concatenate(path.coefficients) == pytest.approx(
        np.concatenate(plain.coefficients), abs=1e-14
    )
    assert [event.t for event in path.crossings] == pytest.approx(
        [event.t for event in plain.crossings], rel=1e-14
    )
    assert sum(n for _, n in path.regimes) == sum(map(len, path.coefficients))
