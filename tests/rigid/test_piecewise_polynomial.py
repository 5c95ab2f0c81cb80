"""Claim: a motion evaluated at many times in one call equals the same motion evaluated at a few
times per call.

Source: `RigidMotion.at`. Oracle: scipy's PPoly, which adds the same terms in the same order.
"""

import numpy as np
from scipy.interpolate import PPoly

from dynamics.piecewise_polynomial import PiecewisePolynomials


def test_polynomials_are_those_of_scipy_to_the_rounding_of_their_terms():
    """The power, the product and the sum of each of the order + 1 terms cause at most 2 (order + 1)
    rounding errors."""
    random = np.random.default_rng(3)
    x = np.cumsum(random.uniform(0.1, 2.0, 31))
    c = random.standard_normal((21, 30, 11))
    at = np.concatenate([x[:-1], random.uniform(x[0], x[-1], 4096)])
    piece = np.searchsorted(x[:-1], at, side="right") - 1
    path = PiecewisePolynomials(c, x)
    bar = 2 * 2 * 21 * np.finfo(float).eps * PPoly(np.abs(c), x)(at)
    some = range(0, len(at), 1024)
    few = np.hstack(
        [
            path(
                at[i : i + 1024],
                piece[i : i + 1024],
            )
            for i in some
        ]
    )
    for values in (few, path(at, piece)):
        assert (np.abs(values.T - PPoly(c, x)(at)) <= bar).all()
    assert np.array_equal(path(x[:-1], np.arange(30)).T, c[-1])
