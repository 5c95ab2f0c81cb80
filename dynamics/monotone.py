"""Does a piecewise polynomial ever fall? Asked of every point of every piece, not only of their ends."""

import numpy as np


def largest_fall(c, x) -> float:
    """Return max (p(s) - p(t)) over s < t, for the pieces c (order + 1, n), highest power first, between x (n + 1,).

    A polynomial rises where the Bernstein coefficients of its slope are positive (Farouki 2012, section 5.1). Only in
    the pieces where some are not are the extrema, the roots of the slope, looked for.
    """
    from scipy.special import comb  # loads slowly

    powers = c[::-1] * np.diff(x) ** np.arange(len(c))[:, None]
    slopes = powers[1:] * np.arange(1, len(c))[:, None]
    i, j = np.indices((len(slopes), len(slopes)))
    bernstein = comb(i, j) / comb(len(slopes) - 1, j) @ slopes
    doubtful = np.flatnonzero((bernstein < 0).any(axis=0))
    turns = {k: _inner_roots(slopes[:, k]) for k in doubtful}
    where = np.concatenate([np.arange(len(x), dtype=float), *(k + s for k, s in turns.items())])
    inner = [np.polynomial.polynomial.polyval(s, powers[:, k]) for k, s in turns.items()]
    values = np.concatenate([powers[0], powers[:, -1:].sum(axis=0), *inner])[np.argsort(where, kind="stable")]
    return float(np.max(np.maximum.accumulate(values) - values))


def _inner_roots(powers):
    """Return the real roots in (0, 1) of the polynomial with these coefficients, lowest first."""
    roots = np.polynomial.polynomial.polyroots(np.trim_zeros(powers, "b"))
    real = roots.real[np.abs(roots.imag) < 1e-6]
    return real[(real > 0) & (real < 1)]
