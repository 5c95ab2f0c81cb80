"""Kalker's creep coefficients for an ellipse elongated along the rolling direction."""

import numpy as np

AXIS_RATIOS = np.arange(1, 11) / 10
"""Ratios b/a of the semi-axes tabulated by Kalker."""
POISSON_RATIOS = np.array([0.0, 0.25, 0.5])
"""Poisson's ratios tabulated by Kalker."""
KALKER_C11 = np.array(
    [
        [10.7, 6.96, 5.57, 4.84, 4.37, 4.06, 3.82, 3.65, 3.51, 3.40],
        [11.7, 7.78, 6.34, 5.57, 5.10, 4.78, 4.54, 4.36, 4.22, 4.12],
        [12.9, 8.82, 7.34, 6.57, 6.11, 5.80, 5.58, 5.42, 5.30, 5.20],
    ]
)
"""Coefficients along the rolling direction: Kalker (1990), table E3; Kalker (1967).

Rows are for POISSON_RATIOS, columns for AXIS_RATIOS.
"""
KALKER_C22 = np.array(
    [
        [10.7, 6.96, 5.57, 4.84, 4.37, 4.06, 3.82, 3.65, 3.51, 3.40],
        [12.8, 8.14, 6.40, 5.48, 4.90, 4.50, 4.21, 3.99, 3.81, 3.67],
        [16.0, 9.79, 7.51, 6.31, 5.56, 5.04, 4.67, 4.39, 4.16, 3.98],
    ]
)
"""Coefficients across the rolling direction, in the same layout and from the same sources."""


def creep_coefficients(
    ratio: np.ndarray, poisson: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return Kalker's C11 and C22 at ratios b/a (k,) in (0, 1] and a Poisson's ratio.

    Steady creepages u/V cause the forces G a b C u/V. b/a C is interpolated linearly in
    b/a, and 1/C quadratically in Poisson's ratio, as recommended by Kalker. Below b/a =
    0.1 the asymptote is scaled to match the table.
    """
    ratio = np.asarray(ratio, dtype=float)
    return (
        _interpolate(KALKER_C11, 0, ratio, poisson),
        _interpolate(KALKER_C22, 1, ratio, poisson),
    )


def slender_creep_coefficients(
    ratio: float | np.ndarray, poisson: float
) -> tuple[float | np.ndarray, float | np.ndarray]:
    """Return the asymptotes of C11 and C22 for b/a -> 0 of Kalker (1967).

    Their relative error is 4 % at b/a = 0.1.
    """
    log = np.log(16 / ratio**2)
    more = 3 - np.log(4)
    along = log - 2 * poisson
    across = (1 - poisson) * log + 2 * poisson
    return 2 * np.pi / ratio / along * (1 + more / along), (
        2 * np.pi / ratio / across * (1 + (1 - poisson) * more / across)
    )


def _interpolate(
    tabulated: np.ndarray, side: int, ratio: np.ndarray, poisson: float
) -> np.ndarray:
    """Return C11 (`side` 0) or C22 (`side` 1) from its table or its asymptote."""
    rows = [
        np.interp(ratio, AXIS_RATIOS, AXIS_RATIOS * row) / ratio for row in tabulated
    ]
    weights = [_lagrange_polynomial(i, poisson) for i in range(len(tabulated))]
    inside = 1 / sum(weight / row for weight, row in zip(weights, rows, strict=True))
    smallest = AXIS_RATIOS[0]
    first = 1 / sum(
        weight / row[0] for weight, row in zip(weights, tabulated, strict=True)
    )
    excess = first / slender_creep_coefficients(smallest, poisson)[side] - 1
    slender = slender_creep_coefficients(np.minimum(ratio, smallest), poisson)[side]
    outside = slender * (1 + excess * ratio / smallest)
    return np.where(ratio < smallest, outside, inside)


def _lagrange_polynomial(i: int, x: float) -> float:
    """Return the quadratic that is 1 at POISSON_RATIOS[i] and 0 at the others."""
    p, q = np.delete(POISSON_RATIOS, i)
    own = POISSON_RATIOS[i]
    return (x - p) * (x - q) / ((own - p) * (own - q))
