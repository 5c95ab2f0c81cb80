"""Claim: for any damping the oscillators are exact if the force is linear between samples and
knots.

Source: the solution of q'' + 2 d q' + w^2 q = g. Oracle: matrix exponentials of the augmented
system (Van Loan 1978) for each interval between samples and knots, which share no formula with the
code.
"""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

from sonify.sound.oscillators import Knots, OscillatorBank, empty_knots

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


@pytest.mark.parametrize(
    ("frequency", "decay"),
    [(0.0, 1.0), (4000.0, 1.0), (-1.0, 1.0), (100.0, -1.0), (np.nan, 1.0)],
)
def test_what_is_out_of_range_is_refused(frequency, decay):
    with pytest.raises(ValueError, match=r"frequencies|decay"):
        OscillatorBank([frequency], [decay], RATE)


def test_no_modes_are_no_sound():
    assert OscillatorBank([], [], RATE).advance(np.zeros((11, 0))).shape == (10, 0)
