"""Evaluation of piecewise polynomials, compiled for long arrays of times."""

from functools import cache

import numpy as np

MIN_COMPILED_TIMES = 2048
"""Number of times from which the compiled evaluation, which also releases the GIL, is faster."""


class PiecewisePolynomials:
    """Polynomials of m quantities on p pieces.

    Parameters
    ----------
    c : ndarray, (order + 1, p, m)
        Coefficients, highest power first.
    x : ndarray, (p + 1,)
        Breakpoints.
    """

    def __init__(self, c, x):
        self.c = c
        self.x = x
        # Piece by piece and quantity by quantity, in which order they are read.
        self._terms = np.ascontiguousarray(c[::-1].transpose(1, 2, 0))

    def __call__(self, at, piece) -> np.ndarray:
        """Return the values (m, k) of pieces (k,) at `at` (k,), summed from the lowest power."""
        offset = at - self.x[piece]
        if len(offset) >= MIN_COMPILED_TIMES:
            return _compiled_sums()(self._terms, offset, piece)
        powers = np.multiply.accumulate([np.ones_like(offset), *[offset] * (len(self.c) - 1)]).T
        return np.add.accumulate(self._terms[piece] * powers[:, None], axis=2)[..., -1].T


@cache
def _compiled_sums():
    """Return `_sums`, compiled on the first call."""
    from numba import njit

    return njit(cache=True, nogil=True)(_sums)


def _sums(terms, offset, piece):
    """Return polynomials (m, n) at offsets (n,) from the starts of pieces (n,)."""
    out = np.empty((terms.shape[1], len(offset)))
    powers = np.empty(terms.shape[2])
    for n in range(len(offset)):
        power = 1.0
        for k in range(len(powers)):
            powers[k] = power
            power *= offset[n]
        for m in range(len(out)):
            total = 0.0
            for k in range(len(powers)):
                total += terms[piece[n], m, k] * powers[k]
            out[m, n] = total
    return out
