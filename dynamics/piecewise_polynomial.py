"""Evaluate piecewise polynomials, with compiled code for long arrays of times."""

from functools import cache
from typing import Any

import numpy as np


class PiecewisePolynomials:
    """Polynomials of m quantities on p pieces.

    Parameters
    ----------
    c : ndarray, (order + 1, p, m)
        Coefficients, highest power first.
    x : ndarray, (p + 1,)
        Breakpoints.
    """

    def __init__(self, c: np.ndarray, x: np.ndarray) -> None:
        self.c = c
        self.x = x
        # ordered by piece, quantity and power, as they are read
        self._terms = np.ascontiguousarray(c[::-1].transpose(1, 2, 0))

    def __call__(self, at: np.ndarray, piece: np.ndarray) -> np.ndarray:
        """Return the values (m, k) at times `at` (k,) in the pieces `piece` (k,)."""
        # from here on, the compiled evaluation, which releases the GIL, is faster
        min_compiled_times = 2048
        offset = at - self.x[piece]
        if len(offset) >= min_compiled_times:
            return _compiled_piece_values()(self._terms, offset, piece)
        powers = np.multiply.accumulate(
            [np.ones_like(offset), *[offset] * (len(self.c) - 1)]
        ).T
        return np.add.accumulate(self._terms[piece] * powers[:, None], axis=2)[
            ..., -1
        ].T


@cache
def _compiled_piece_values() -> Any:
    """Return `_piece_values`, compiled on the first call."""
    from dynamics.numba_kernels import njit

    return njit(cache=True, nogil=True)(_piece_values)


def _piece_values(
    terms: np.ndarray, offset: np.ndarray, piece: np.ndarray
) -> np.ndarray:
    """Return the values (m, n) of pieces (n,) at offsets (n,) from their starts."""
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
