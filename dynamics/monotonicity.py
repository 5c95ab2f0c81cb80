"""Largest decrease of a piecewise polynomial, including extrema inside the pieces."""

import numpy as np


def largest_decrease(c: np.ndarray, x: np.ndarray) -> float:
    """Return the maximum of p(s) - p(t) over s < t for a piecewise polynomial p.

    Its coefficients are c (order + 1, n), highest power first, and its breakpoints x (n
    + 1,). A piece increases if the Bernstein coefficients of its derivative are
    positive (Farouki 2012, section 5.1); in the other pieces the roots of the
    derivative are computed.
    """
    from scipy.special import comb  # loads slowly

    powers = c[::-1] * np.diff(x) ** np.arange(len(c))[:, None]
    slopes = powers[1:] * np.arange(1, len(c))[:, None]
    i, j = np.indices((len(slopes), len(slopes)))
    bernstein = comb(i, j) / comb(len(slopes) - 1, j) @ slopes
    doubtful = np.flatnonzero((bernstein < 0).any(axis=0))
    places = [np.arange(len(x), dtype=float)]
    values = [powers[0], powers[:, -1:].sum(axis=0)]
    for k in doubtful:
        extrema = _inner_roots(slopes[:, k])
        places.append(k + extrema)
        values.append(np.polynomial.polynomial.polyval(extrema, powers[:, k]))
    order = np.argsort(np.concatenate(places), kind="stable")
    in_order = np.concatenate(values)[order]
    return float(np.max(np.maximum.accumulate(in_order) - in_order))


def _inner_roots(powers: np.ndarray) -> np.ndarray:
    """Return the real roots in (0, 1) of a polynomial, given from its lowest power."""
    roots = np.polynomial.polynomial.polyroots(np.trim_zeros(powers, "b"))
    real = roots.real[np.abs(roots.imag) < 1e-6]
    return real[(real > 0) & (real < 1)]
