"""Define the record of the modes of a table, and two forms of their shapes: splines over
the top face, or waves around the centre of a round table."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import ceil

import numpy as np
from scipy.interpolate import CubicSpline, NdBSpline, PPoly, make_interp_spline

from modal.modes import ModeList


@dataclass(frozen=True, kw_only=True, eq=False)
class RoundShapes:
    """Shapes w = g(s) cos(n theta) rho^n, or with the sine, of a round table.

    Here rho is the distance from the centre divided by the radius, and s = rho^2. The
    functions g are smooth at the centre and cubic within each of c cells of equal width
    in rho. Both modes of a pair have the same g, so that the table is exactly isotropic.

    Attributes
    ----------
    radius : float
        Radius of the table [m].
    starts : ndarray, shape (c + 1,)
        Values of s at the ends of the cells.
    pieces : ndarray, shape (4, c, m)
        Coefficients of g [kg^-1/2] in powers of s - starts, highest first.
    order : ndarray of int, shape (m,)
        Number n of waves around the centre.
    is_sine : ndarray of bool, shape (m,)
        True for sin(n theta), False for cos(n theta).
    """

    radius: float
    starts: np.ndarray
    pieces: np.ndarray
    order: np.ndarray
    is_sine: np.ndarray

    def at(
        self, x: np.ndarray, y: np.ndarray, slope: tuple[int, int] = (0, 0)
    ) -> np.ndarray:
        """Return the shapes (k, m) at points x, y (k,) [m], or their first derivatives.

        Points outside the table are moved to its rim.
        """
        z = (np.asarray(x) + 1j * np.asarray(y)) / self.radius
        z = (z / np.maximum(abs(z), 1.0))[:, None]
        s = abs(z[:, 0]) ** 2
        wave = z**self.order
        member = np.where(self.is_sine, -1j, 1.0)  # its real part selects the member
        g = PPoly(self.pieces, self.starts)
        if slope == (0, 0):
            return g(s) * (wave * member).real
        along = {(1, 0): (z.real, 1.0), (0, 1): (z.imag, 1j)}
        if slope not in along:
            raise ValueError(f"slope = {slope!r}: must be (0, 0), (1, 0) or (0, 1)")
        coordinate, direction = along[slope]
        # n z^(n - 1) is 0 for n = 0, also at the centre
        steeper = self.order * z ** np.maximum(self.order - 1, 0) * direction
        change = 2 * coordinate * g(s, 1) * wave + g(s) * steeper
        return (change * member).real / self.radius

    def select(self, kept: np.ndarray) -> "RoundShapes":
        """Return the shapes with the indices `kept` (k,)."""
        return replace(
            self,
            pieces=self.pieces[:, :, kept],
            order=self.order[kept],
            is_sine=self.is_sine[kept],
        )


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
        points; without knots if there are `round_shapes`.
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
    round_shapes : RoundShapes or None
        Shapes of a round plate, in place of the splines.

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
    round_shapes: RoundShapes | None = None

    def at(
        self, x: np.ndarray, y: np.ndarray, slope: tuple[int, int] = (0, 0)
    ) -> np.ndarray:
        """Return the mode shapes at points of the top face.

        Parameters
        ----------
        x, y : ndarray, shape (k,)
            Points [m]; outside a round plate or the rectangle of the splines, the value
            at the nearest point of its edge is used.
        slope : pair of int, optional
            Orders of the derivatives along x and y; at most 1 in all for a round plate.

        Returns
        -------
        ndarray, shape (k, m)
            Deflection w [kg^-1/2], or its derivative.
        """
        if self.round_shapes is not None:
            return self.round_shapes.at(x, y, slope)
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
        waves = self.round_shapes
        return replace(
            self,
            **arrays,
            coefficients=self.coefficients[:, :, kept],
            round_shapes=None if waves is None else waves.select(kept),
        )

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


def fit_round_shapes(
    profile: Callable[[np.ndarray], np.ndarray],
    radius: float,
    shortest_wave: float,
    order: np.ndarray,
    is_sine: np.ndarray,
) -> RoundShapes:
    """Return `RoundShapes` from profile(rho (k,)) -> (m, k), the shapes along one radius.

    With 48 samples per shortest wavelength [m], the error of cubic splines is 1e-5 of the
    amplitude. The functions g = profile / rho^n are evaluated near the centre in place of
    the centre itself.
    """
    samples_per_wave = 48
    lowest_rho = 1e-4
    count = 4 + ceil(radius * samples_per_wave / shortest_wave)
    rho = np.linspace(0.0, 1.0, count + 1)
    rho[0] = lowest_rho
    values = profile(rho) / rho ** order[:, None]
    spline = CubicSpline(rho**2, values, axis=1)
    return RoundShapes(
        radius=radius,
        starts=spline.x,
        pieces=np.ascontiguousarray(spline.c),
        order=order,
        is_sine=is_sine,
    )


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
