"""Claim: several takes of one disk together give intervals that contain the truth, and a take that
determines little changes nothing.

Source: generalised least squares, with errors enlarged by the scatter of the takes. Oracle:
synthetic rates of known law, whose noise is that of blocks that overlap by half; weighted means in
closed form.
"""

from dataclasses import replace

import numpy as np
import pytest
from scenes import bare_toy

from sonify.fitting.decay_model import DecayModel
from sonify.fitting.least_squares import (
    Fit,
    LineRates,
    _Problem,
    _with_intervals,
    pool_fits,
)
from sonify.fitting.line_selection import Judged, verdict_of
from sonify.fitting.phase_demodulation import Rates
from sonify.fitting.result import pool_judged
from sonify.fitting.settings import FIT

TRUTH = np.array([9.9e-5, 1.0, 0.0])
"""Shares of contour friction, film and other laws."""
END = 12.0  # s
FOLDERS = 40


@pytest.fixture(scope="module")
def decay():
    return DecayModel(bare_toy())


def rates_of_take(decay, first, last, noise, random):
    """Return rates between two remaining times [s], one per half block.

    `noise` is the relative error of a block; adjacent blocks share half of their sound.
    """
    half_block = FIT.block_lengths[-1] / FIT.block_overlap  # turns
    remaining = np.geomspace(first, last, 4000)
    turned, _ = decay.turns(remaining, TRUTH)
    places = np.arange(turned[-1], turned[0], half_block)
    remaining = np.interp(places, turned[::-1], remaining[::-1])[::-1]
    rate = decay.frequency(remaining, TRUTH)
    halves = random.standard_normal(len(rate) + 1)
    relative = noise * (halves[1:] + halves[:-1]) / 2**0.5
    nothing = np.zeros_like(rate)
    return Rates(END - remaining, rate * (1 + relative), noise * rate, nothing, nothing)


def fitted(decay, rates, start):
    """Return the fit of contour friction and film to rates, from initial shares (3,)."""
    heard = LineRates(decay, rates, rates.frequency)
    problem = _Problem(heard, np.array(start), (0, 1), filtered=False)
    return _with_intervals(problem, problem.solve(END, final=True).x)


def folder_of_takes(decay, seed):
    """Return the fits of two takes that determine both shares and of one that is short and noisy."""
    random = np.random.default_rng([7, seed])
    fits = []
    for kind in ("clear", "clear", "poor"):
        clear = kind == "clear"
        first = random.uniform(*((5.0, 9.0) if clear else (2.5, 3.5)))
        noise = 10 ** random.uniform(*((-3.2, -2.2) if clear else (-1.9, -1.5)))
        rates = rates_of_take(decay, first, random.uniform(0.03, 0.1), noise, random)
        start = TRUTH * random.uniform(0.5, 1.5, 3)
        fits.append(fitted(decay, rates, start))
    return fits


def test_the_intervals_of_forty_folders_of_three_takes_contain_the_truth(decay):
    """At least 34 of 40 intervals of 95 % hold the truth, with a probability of 98.6 %; the poor
    take often cannot tell, but all together always do."""
    held = np.zeros(2)
    verdicts = []
    poor = []
    for seed in range(FOLDERS):
        fits = folder_of_takes(decay, seed)
        poor.append(verdict_of(decay, fits[-1]))
        together = pool_fits(fits)
        values = together.fitted_shares()
        for i, name in enumerate(("rolling", "air")):
            held[i] += values[name].low <= TRUTH[i] <= values[name].high
            assert values[name].low < values[name].value < values[name].high
        verdicts.append(verdict_of(decay, together))
    assert (held >= 34).all(), held
    assert verdicts == ["both"] * FOLDERS
    assert poor.count("cannot tell") > FOLDERS / 4


def made_fit(decay, shares, covariance, seed):
    """Return a fit with normal draws of exactly this mean and covariance of the two shares."""
    random = np.random.default_rng(seed)
    normal = random.standard_normal((FIT.bootstrap_draws, 2))
    normal -= normal.mean(axis=0)
    normal @= np.linalg.inv(np.linalg.cholesky(np.cov(normal.T, bias=True)).T)
    drawn = shares + normal @ np.linalg.cholesky(covariance).T
    rates = rates_of_take(decay, 7.0, 0.05, 1e-3, random)
    return Fit(
        free=(0, 1),
        ends=np.array([END]),
        shares=np.append(shares, 0.0),
        draws=np.column_stack([END + normal[:, 0], drawn, np.zeros(len(drawn))]),
        heard=(LineRates(decay, rates, rates.frequency),),
        residual=np.zeros(len(rates.time)),
        sigma=np.ones(len(rates.time)),
    )


def test_a_take_that_determines_a_combination_contributes_only_this(decay):
    """The errors of friction and film of each take have another correlation. The mean with inverse
    covariances as weights is the oracle; the order of the takes is irrelevant."""
    unit = np.diag([1e-5, 0.1])
    shapes = (
        np.array([[1.0, -0.99], [-0.99, 1.0]]),
        np.array([[1.0, 0.5], [0.5, 1.0]]),
        np.array([[400.0, -380.0], [-380.0, 400.0]]),
    )
    covariances = [unit @ shape @ unit for shape in shapes]
    shares = np.array([[9.0e-5, 1.1], [1.0e-4, 1.02], [1.6e-4, 0.3]])
    fits = [
        made_fit(decay, *pair, seed)
        for seed, pair in enumerate(zip(shares, covariances, strict=True))
    ]
    weights = np.linalg.inv(covariances)
    expected = np.linalg.solve(
        weights.sum(axis=0), np.sum(weights @ shares[..., None], 0)
    )
    together = pool_fits(fits)
    assert together.shares[:2] == pytest.approx(expected[:, 0], rel=1e-9)
    assert pool_fits(fits[::-1]).shares == pytest.approx(together.shares, rel=1e-9)
    deviations = (shares - expected[:, 0])[..., None]
    scatter = np.sum(deviations.transpose(0, 2, 1) @ weights @ deviations) / 4
    error = np.sqrt(np.diag(np.linalg.inv(weights.sum(axis=0))) * max(scatter, 1.0))
    assert together.draws[:, 3:5].std(axis=0) == pytest.approx(error, rel=0.1)


def test_a_take_with_three_possible_motions_does_not_pull_the_others(decay):
    """Its value is the mean of the motions, far from all draws, and most motions alone have small
    errors. The first of them alone was once the error of the take, and the interval of all takes
    ended at their mean."""
    clear = [
        made_fit(decay, np.array(shares), np.diag([1e-6, 0.1]) ** 2, seed)
        for seed, shares in enumerate(([1.009e-4, 0.84], [9.93e-5, 0.96]))
    ]
    motions = [
        made_fit(decay, np.array(shares), np.diag(errors) ** 2, seed)
        for seed, (shares, errors) in enumerate(
            (
                ([-5.8e-4, 0.5], [2e-6, 0.2]),
                ([2.8e-3, -0.5], [3e-4, 60.0]),
                ([-6.1e-4, -1.0], [4e-6, 0.2]),
            ),
            start=3,
        )
    ]
    draws = np.concatenate([one.draws for one in motions])
    unsure = replace(motions[0], shares=np.array([5.5e-4, 0.7, 0.0]), draws=draws)
    alone = pool_fits(clear).fitted_shares()
    together = pool_fits([*clear, unsure])
    assert verdict_of(decay, together) == "both"
    for name, value in together.fitted_shares().items():
        assert value.low < value.value < value.high
        assert value.value == pytest.approx(alone[name].value, rel=0.02)
        assert value.high - value.low < 1.1 * (alone[name].high - alone[name].low)


def judged(verdict, explained, one, decay):
    """Return the result for a take; only what the takes together need is meaningful."""
    return Judged(
        run=None,
        signal="tone",
        line="precession",
        model="solved",
        decay=decay,
        stream=None,
        fit=one,
        explained=explained,
        verdict=verdict,
    )


def test_a_take_that_no_motion_explains_is_left_out(decay):
    """Without an explained take, all remain; the error of the film law is not averaged."""
    error = np.diag([1e-6, 0.02]) ** 2
    good = [made_fit(decay, TRUTH[:2], error, seed) for seed in (1, 2)]
    far = made_fit(decay, np.array([3e-4, 0.0]), error, 3)
    takes = [judged("both", True, one, decay) for one in good]
    for wrong in (
        judged("cannot tell", False, far, decay),
        judged("not this scene", True, far, decay),
    ):
        found, pool = pool_judged([wrong, *takes])
        assert found is decay
        assert pool.shares == pytest.approx(TRUTH)
        assert len(pool.ends) == 2
        alone = pool_judged([wrong])[1]
        assert alone is far
    width = [np.ptp(pool_judged(group)[1].draws[:, -2]) for group in (takes, takes * 8)]
    assert width[1] > 0.9 * width[0]
