"""The record of the modes of a table, and their shapes on its top face."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import ceil

import numpy as np
from scipy.interpolate import NdBSpline, make_interp_spline

from modal.modes import ModeList

DEGREE = 3
"""Of the splines through the shapes."""
SAMPLED = 16
"""Values that a shape has on the length of its shortest bending wave: cubic splines then err by 1e-4 of it."""


@dataclass(frozen=True, kw_only=True, repr=False)
class SurfaceModes(ModeList):
    """m elastic modes of a table, ascending, of modal mass 1; w is the upward motion of its top face [kg^-1/2].

    frequency, decay_rate (m,) -- [Hz] and [1/s]: a mode rings as exp(-decay_rate t) sin(2 pi frequency t).
    order (m,)              -- waves round the middle of a plate or the contact circle; -1 where the table has no axis.
    points (p, 2), weights (p,), face (m, p) -- w at points [m] of the top face; sums with `weights` [m^2] integrate.
    knots (2, .), coefficients (a, b, m) -- splines of w in x and y, over the rectangle where the contact may be.
    radius, place (2,)      -- of a round table [m], 0 of any other; where the disk is at the release [m].
    residual (m,), error (m,) -- as in `Modes`.  mass [kg], method, unknowns -- of the discrete model.
    """

    frequency: np.ndarray
    decay_rate: np.ndarray
    order: np.ndarray
    points: np.ndarray
    weights: np.ndarray
    face: np.ndarray
    knots: tuple[np.ndarray, np.ndarray]
    coefficients: np.ndarray
    radius: float
    place: np.ndarray
    residual: np.ndarray
    error: np.ndarray
    mass: float
    method: str
    unknowns: int

    def at(self, x: np.ndarray, y: np.ndarray, slope: tuple[int, int] = (0, 0)) -> np.ndarray:
        """Return w (k, m) at points x, y (k,) [m] of the top face, or its derivative `slope` times along x and y.

        Points off the table have the values of the nearest place of the rectangle.
        """
        return spline_values(self.knots, self.coefficients, x, y, slope)

    def select(self, indices: Sequence[int] | np.ndarray) -> "SurfaceModes":
        """Return the modes of these indices (k,), or a mask (m,), in that order."""
        kept, of_a_mode = self.numbers(indices), ("frequency", "decay_rate", "order", "face", "residual", "error")
        own = {name: getattr(self, name)[kept] for name in of_a_mode}
        return replace(self, **own, coefficients=self.coefficients[:, :, kept])

    def compliance(self, radius: float = 0.0) -> float:
        """Return the static deflection [m] under 1 N, of the modes that there are: the greatest of 16 places on
        the circle of `radius` [m] about `place`."""
        angle = np.arange(16) * np.pi / 8
        x, y = self.place[:, None] + radius * np.array([np.cos(angle), np.sin(angle)])
        return float((self.at(x, y) ** 2 / (2 * np.pi * self.frequency) ** 2).sum(axis=1).max(initial=0.0))


def splined(shape, low, high, length):
    """Return `knots` and `coefficients` of the splines through shape(x (k,), y (k,)) -> (m, k) on the rectangle between
    two corners (2,) [m], `length` [m] being that of the shortest wave there."""
    x, y = (np.linspace(a, b, 4 + ceil((b - a) * SAMPLED / length)) for a, b in zip(low, high, strict=True))
    values = shape(*(part.ravel() for part in np.meshgrid(x, y, indexing="ij")))
    first = make_interp_spline(x, np.moveaxis(values.reshape(len(values), len(x), len(y)), 0, 2), DEGREE, axis=0)
    second = make_interp_spline(y, first.c, DEGREE, axis=1)
    return (first.t, second.t), np.ascontiguousarray(np.moveaxis(second.c, 0, 1))


def spline_values(knots, coefficients, x, y, slope=(0, 0)):
    """Return the splines, or their derivatives, at x, y (k,) [m]: (k, m)."""
    inside = [np.clip(at, t[0], t[-1]) for at, t in zip((x, y), knots, strict=True)]
    return NdBSpline(knots, coefficients, DEGREE)(np.column_stack(inside), nu=slope)
