"""Define the record of the modes of a table and splines of their shapes on its top
face."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import ceil

import numpy as np
from scipy.interpolate import NdBSpline, make_interp_spline

from modal.modes import ModeList


@dataclass(frozen=True, kw_only=True, repr=False)
class SurfaceModes(ModeList):
    """The m elastic modes of a table in ascending order of frequency.

    The shape w is the upward displacement of the top face at unit modal mass
    [kg^-1/2].

    Attributes
    ----------
    frequency, decay_rate : ndarray, shape (m,)
        Frequency [Hz] and decay rate [1/s]: a mode rings as exp(-decay_rate t) sin(2 pi
        frequency t).
    order : ndarray of int, shape (m,)
        Number of waves around the centre of a plate or the contact circle; -1 for a
        table without an axis.
    points : ndarray, shape (p, 2)
        Points of the top face [m].
    weights : ndarray, shape (p,)
        Quadrature weights [m^2] for integrals over the top face.
    face : ndarray, shape (m, p)
        w at `points`.
    knots, coefficients : pair of ndarray, and ndarray of shape (a, b, m)
        Tensor-product splines of w in x and y, on a rectangle that contains all contact
        points.
    radius : float
        Radius of a round table [m], or 0 for other tables.
    place : ndarray, shape (2,)
        Position of the disk at the release [m].
    residual, error : ndarray, shape (m,)
        Residual of the eigenpair and relative error of the frequency, as in `Modes`.
    mass : float
        Mass of the discrete model [kg].
    method : str
        Method of computation.
    unknowns : int
        Number of unknowns of the discrete model.

    Examples
    --------
    >>> from modal import surface_modes
    >>> from sonify import load_scene
    >>> mode = "{order=2, frequency=600.0, damping_ratio=0.02, modal_mass=1.0}"
    >>> scene = load_scene("published").replace("surface.kind=modes", f"surface.modes=[{mode}]")
    >>> surface_modes(scene).order.tolist()
    [2, 2]
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

    def at(
        self, x: np.ndarray, y: np.ndarray, slope: tuple[int, int] = (0, 0)
    ) -> np.ndarray:
        """Return the mode shapes at points of the top face.

        Parameters
        ----------
        x, y : ndarray, shape (k,)
            Points [m]; outside the rectangle of the splines, the value at the nearest
            point of the rectangle is used.
        slope : pair of int, optional
            Orders of the derivatives along x and y.

        Returns
        -------
        ndarray, shape (k, m)
            Deflection w [kg^-1/2], or its derivative.
        """
        return spline_values(self.knots, self.coefficients, x, y, slope)

    def select(self, indices: Sequence[int] | np.ndarray) -> "SurfaceModes":
        """Return a selection of the modes.

        Parameters
        ----------
        indices : sequence of int, shape (k,), or ndarray of bool, shape (m,)
            Indices in the desired order, or a mask.

        Returns
        -------
        SurfaceModes
            The selected modes.
        """
        kept = self.as_indices(indices)
        per_mode = ("frequency", "decay_rate", "order", "face", "residual", "error")
        arrays = {name: getattr(self, name)[kept] for name in per_mode}
        return replace(self, **arrays, coefficients=self.coefficients[:, :, kept])

    def compliance(self, radius: float = 0.0) -> float:
        """Return the largest static deflection under 1 N at 16 points of a circle
        around `place`.

        Parameters
        ----------
        radius : float, optional
            Radius of the circle [m].

        Returns
        -------
        float
            Contribution of these modes to the deflection [m].
        """
        angle = np.arange(16) * np.pi / 8
        circle = radius * np.array([np.cos(angle), np.sin(angle)])
        x, y = self.place[:, None] + circle
        deflection = (self.at(x, y) ** 2 / (2 * np.pi * self.frequency) ** 2).sum(
            axis=1
        )
        return float(deflection.max(initial=0.0))


def fit_splines(
    shape: Callable[[np.ndarray, np.ndarray], np.ndarray],
    low: np.ndarray,
    high: np.ndarray,
    shortest_wave: float,
) -> tuple[tuple[np.ndarray, np.ndarray], np.ndarray]:
    """Return knots and coefficients of splines that interpolate shape(x (k,), y (k,))
    -> (m, k).

    The corners of the rectangle are `low` and `high` (2,) [m]. With 16 samples per
    shortest wavelength [m], the error of cubic splines is 1e-4 of the amplitude.
    """
    samples_per_wave = 16
    x, y = (
        np.linspace(
            start, end, 4 + ceil((end - start) * samples_per_wave / shortest_wave)
        )
        for start, end in zip(low, high, strict=True)
    )
    values = shape(*(grid.ravel() for grid in np.meshgrid(x, y, indexing="ij")))
    grid_values = np.moveaxis(values.reshape(len(values), len(x), len(y)), 0, 2)
    along_x = make_interp_spline(x, grid_values, axis=0)
    along_y = make_interp_spline(y, along_x.c, axis=1)
    return (along_x.t, along_y.t), np.ascontiguousarray(np.moveaxis(along_y.c, 0, 1))


def spline_values(
    knots: tuple[np.ndarray, np.ndarray],
    coefficients: np.ndarray,
    x: np.ndarray,
    y: np.ndarray,
    slope: tuple[int, int] = (0, 0),
) -> np.ndarray:
    """Return the values (k, m) of the splines, or of their derivatives of orders
    `slope`, at x, y (k,) [m]."""
    inside = [np.clip(u, t[0], t[-1]) for u, t in zip((x, y), knots, strict=True)]
    return NdBSpline(knots, coefficients, 3)(  # cubic
        np.column_stack(inside), nu=slope
    )
