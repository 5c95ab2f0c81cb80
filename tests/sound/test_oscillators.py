"""Claim: for any damping the oscillators are exact if the force is linear between samples and
knots.

Source: the solution of q'' + 2 d q' + w^2 q = g. Oracle: matrix exponentials of the augmented
system (Van Loan 1978) for each interval between samples and knots, which share no formula with the
code; a closed form for the convergence order.
"""

from itertools import pairwise

import numpy as np
import pytest
from arithmetic import gamma
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

from sonify.sound.oscillators import Knots, OscillatorBank, empty_knots, free_response

RATE = 8000.0
FREQUENCY = np.array([5.0, 100.0, 1000.0, 3999.0, 200.0, 300.0, 300.0, 40.0])
DECAY = np.array(
    [
        0.0,
        0.5,
        50.0,
        3.0,
        2 * np.pi * 200,
        2 * np.pi * 300 * (1 - 1e-9),
        2 * np.pi * 900,
        1e4,
    ]
)
"""Decay rates [1/s]: zero, small and large; then critical, just subcritical, overdamped and heavily
overdamped."""


def exact(frequency, decay, g, knots, h):
    """Accelerations (k + 1,) at the samples of g, from matrix exponentials over each linear piece
    of the force."""
    w = 2 * np.pi * frequency
    M = np.array(
        [[0, 1, 0, 0], [-w * w, -2 * decay, 1, 0], [0, 0, 0, 1], [0, 0, 0, 0.0]]
    )
    x = np.zeros(2)
    out = []

    def follow(x, duration, begin, end):
        return (expm(M * duration) @ [*x, begin, (end - begin) / duration])[:2]

    for n, (now, then) in enumerate(pairwise(g)):
        out.append(now - w * w * x[0] - 2 * decay * x[1])
        inside = np.flatnonzero(knots.interval == n)
        smooth = now
        risen = 0.0
        end = then - knots.jump[inside].sum()
        left = h
        for j in inside:
            line = smooth + (end - smooth) * knots.since[j] / (
                knots.since[j] + knots.until[j]
            )
            x = follow(x, knots.since[j], smooth + risen, line + knots.bend[j] + risen)
            smooth = line + knots.bend[j]
            risen = risen + knots.jump[j]
            left = knots.until[j]
        x = follow(x, left, smooth + risen, end + risen)
    return np.array(out)


def some_force(m, k=60, seed=0):
    rng = np.random.default_rng(seed)
    g = np.repeat(rng.normal(size=(k + 1, 1)).cumsum(axis=0), m, axis=1)
    g[0] = 0
    h = 1 / RATE
    knots = Knots(
        interval=np.array([7, 7, 20, 41]),
        since=np.array([0.3, 0.5, 0.45, 1e-4]) * h,
        until=np.array([0.7, 0.2, 0.55, 0.9999]) * h,
        jump=np.outer([1.0, -0.4, 2.0, -3.0], np.ones(m)),
        bend=np.outer([0.3, 0.2, -0.5, 1e-4], np.ones(m)),
    )
    return g, knots


def test_exact_at_every_damping_through_jumps_and_corners():
    g, knots = some_force(len(FREQUENCY))
    found = OscillatorBank(FREQUENCY, DECAY, RATE).advance(g, knots)
    for m, (frequency, decay) in enumerate(zip(FREQUENCY, DECAY, strict=True)):
        one = Knots(
            knots.interval, knots.since, knots.until, knots.jump[:, m], knots.bend[:, m]
        )
        expected = exact(frequency, decay, g[:, m], one, 1 / RATE)
        assert np.abs(found[:, m] - expected).max() <= 1e-10 * np.abs(expected).max()


@settings(max_examples=40, deadline=None)
@given(st.floats(1.0, 3990.0), st.floats(0.0, 1e5), st.integers(0, 1000))
def test_exact_for_any_oscillator(frequency, decay, seed):
    g = np.random.default_rng(seed).normal(size=(30, 1))
    g[0] = 0
    expected = exact(frequency, decay, g[:, 0], empty_knots(1), 1 / RATE)
    found = OscillatorBank([frequency], [decay], RATE).advance(g)[:, 0]
    assert np.abs(found - expected).max() <= 1e-9 * np.abs(expected).max()


def test_blocks_of_any_size_give_the_same_samples():
    g, knots = some_force(len(FREQUENCY))
    whole = OscillatorBank(FREQUENCY, DECAY, RATE).advance(g, knots)
    for sizes in ([1] * 60, [7, 1, 12, 40], [20, 40], [3, 57], [5, 6, 7, 42]):
        bank = OscillatorBank(FREQUENCY, DECAY, RATE)
        parts = []
        start = 0
        for size in sizes:
            here = (knots.interval >= start) & (knots.interval < start + size)
            part = Knots(
                knots.interval[here] - start, *(field[here] for field in knots[1:])
            )
            parts.append(bank.advance(g[start : start + size + 1], part))
            start += size
        assert np.array_equal(np.vstack(parts), whole)


def test_one_force_for_all_is_that_force_for_each():
    g, knots = some_force(len(FREQUENCY))
    each = OscillatorBank(FREQUENCY, DECAY, RATE).advance(g, knots)
    one = Knots(*knots[:3], knots.jump[:, :1], knots.bend[:, :1])
    out = np.empty_like(each)
    assert OscillatorBank(FREQUENCY, DECAY, RATE).advance(g[:, :1], one, out) is out
    assert np.array_equal(out, each)


def test_never_grows():
    rng = np.random.default_rng(1)
    frequency = rng.uniform(1, 3999, 200)
    bank = OscillatorBank(
        frequency, np.where(np.arange(200) % 2, 0.0, rng.uniform(0, 1e5, 200)), RATE
    )
    bank.set_steady_state(np.ones(200))
    acceleration = bank.advance(np.zeros((200001, 200)))
    assert np.abs(acceleration).max() <= 1 + 1e-6


def test_rings_at_its_frequency_and_decays_at_its_rate():
    frequency = 440.0
    decay = 3.0
    bank = OscillatorBank([frequency], [decay], RATE)
    bank.set_steady_state(np.ones(1))
    g = np.zeros((8001, 1))
    g[0] = 1.0
    let_go = Knots(
        np.zeros(1, int),
        np.zeros(1),
        np.full(1, 1 / RATE),
        -np.ones((1, 1)),
        np.zeros((1, 1)),
    )
    found = bank.advance(g, let_go)[:, 0]
    t = np.arange(8000) / RATE
    w = 2 * np.pi * frequency
    swing = np.sqrt(w**2 - decay**2)
    expected = -np.exp(-decay * t) * (
        np.cos(swing * t) - decay / swing * np.sin(swing * t)
    )
    assert found[0] == pytest.approx(
        0, abs=gamma(20)
    )  # the force vanishes after sample 0
    assert np.abs(found - expected)[1:].max() < 1e-9


@pytest.mark.parametrize(("exactly", "order"), [(True, 2.0), (False, 1.0)])
def test_order_through_jumps_is_two_and_only_one_if_they_are_moved_to_samples(
    exactly, order
):
    """The response to a smooth force with one jump agrees with the closed form to the stated order.

    The jump occurs in the middle of a step of 1/200 of the duration, and hence also in the middle
    of a step of one third, one ninth or one 27th of that length.
    """
    w = 2 * np.pi * 50.0
    d = 20.0
    end = 0.05
    v = 2 * np.pi * 30.0
    at = end * 56.5 / 200

    def answer(t):  # to sin(v t) from rest at 0, and to a unit step at `at`
        z = 1 / (w * w - v * v + 2j * d * v)
        c, s = free_response(w, d, t)
        q0 = -z.imag
        v0 = -v * z.real
        sine = -(v**2) * (z * np.exp(1j * v * t)).imag
        return (
            sine
            + (-(w**2) * (c + d * s) + 2 * d * w**2 * s) * q0
            + (-2 * d * c - (w**2 - 2 * d**2) * s) * v0
        )

    def after_step(t):
        c, s = free_response(w, d, t)
        return c - d * s

    expected = answer(end) + after_step(end - at)
    errors = []
    steps = [200, 600, 1800, 5400]
    for k in steps:
        h = end / k
        n = int(at / h)
        time = np.arange(k + 2) * h
        where = at if exactly else (n + 1) * h
        until = max((n + 1) * h - where, 0.0)
        knots = Knots(
            np.array([n]),
            np.array([h - until]),
            np.array([until]),
            np.ones((1, 1)),
            np.zeros((1, 1)),
        )
        g = np.sin(v * time) + (np.arange(k + 2) > n)
        errors.append(
            abs(
                OscillatorBank([w / 2 / np.pi], [d], 1 / h).advance(g[:, None], knots)[
                    k, 0
                ]
                - expected
            )
        )
    assert -np.polyfit(np.log(steps), np.log(errors), 1)[0] == pytest.approx(
        order, abs=0.1
    )


@pytest.mark.parametrize(
    ("frequency", "decay"),
    [(0.0, 1.0), (4000.0, 1.0), (-1.0, 1.0), (100.0, -1.0), (np.nan, 1.0)],
)
def test_what_is_out_of_range_is_refused(frequency, decay):
    with pytest.raises(ValueError, match=r"frequencies|decay"):
        OscillatorBank([frequency], [decay], RATE)


def test_no_modes_are_no_sound():
    assert OscillatorBank([], [], RATE).advance(np.zeros((11, 0))).shape == (10, 0)
