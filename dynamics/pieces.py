"""Piecewise polynomials, and their values at few times or at many."""

from functools import cache

import numpy as np

MANY = 2048
"""Times from which on it is faster to load numba, which also lets go of Python's lock."""


class Pieces:
    """Polynomials (m,) on the p stretches between `x` (p + 1,), of coefficients `c` (order + 1, p, m), highest power
    first. In memory they stand piece by piece, and within a piece as heyoka has them, those of a quantity together."""

    def __init__(self, c, x):
        self.c, self.x = c, x
        self._terms = np.ascontiguousarray(c[::-1].transpose(1, 2, 0))

    def __call__(self, at, piece) -> np.ndarray:
        """Return the polynomials of the pieces (k,) at `at` (k,): (m, k); term by term from the lowest power on."""
        since = at - self.x[piece]
        if len(since) >= MANY:
            return _compiled()(self._terms, since, piece)
        powers = np.multiply.accumulate([np.ones_like(since), *[since] * (len(self.c) - 1)]).T
        return np.add.accumulate(self._terms[piece] * powers[:, None], axis=2)[..., -1].T


@cache
def _compiled():
    from numba import njit

    return njit(cache=True, nogil=True)(_sums)


def _sums(terms, since, piece):
    out, powers = np.empty((terms.shape[1], len(since))), np.empty(terms.shape[2])
    for n in range(len(since)):
        power = 1.0
        for k in range(len(powers)):
            powers[k] = power
            power *= since[n]
        for m in range(len(out)):
            total = 0.0
            for k in range(len(powers)):
                total += terms[piece[n], m, k] * powers[k]
            out[m, n] = total
    return out
