"""Table modes that a scene specifies by numbers, in the form required by the motion."""

from dataclasses import dataclass
from math import ceil, pi

import numpy as np
from scipy.interpolate import NdBSpline, make_interp_spline

from dynamics.compliant.law.table_receptance import shapes_on_circle
from dynamics.surface import ModesSurface

MAX_TABLE_FREQUENCY = 24e3  # Hz; `modal.surface_modes` has the same limit


@dataclass(frozen=True, kw_only=True, eq=False)
class TableModes:
    """Table modes of unit modal mass, with the attributes of `modal.SurfaceModes`.

    Attributes
    ----------
    frequency, decay_rate : (m,) arrays
        Frequency [Hz] and decay rate [1/s] of each mode.
    order : (m,) array of int
        Number of waves around the contact circle.
    knots : two arrays
        Knots [m] of the cubic splines along x and y.
    coefficients : (a, b, m) array
        Spline coefficients of the upward mode shapes [kg^-1/2].
    place : (2,) array
        Position [m] of the disk centre in the frame of the splines.
    mass : float
        Mass of the table [kg]; 0, because the scene does not specify it.
    round_shapes : None
        The shapes are splines.
    """

    frequency: np.ndarray
    decay_rate: np.ndarray
    order: np.ndarray
    knots: tuple[np.ndarray, np.ndarray]
    coefficients: np.ndarray
    place: np.ndarray
    mass: float = 0.0
    round_shapes: None = None

    def at(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Return the mode shapes (k, m) at points x, y (k,) [m].

        Points outside the rectangle are moved to its boundary.
        """
        inside = [
            np.clip(at, knots[0], knots[-1])
            for at, knots in zip(
                (x, y),
                self.knots,
                strict=True,
            )
        ]
        return NdBSpline(self.knots, self.coefficients, 3)(  # cubic
            np.column_stack(inside)
        )

    def compliance(self, radius: float = 0.0) -> float:
        """Return the largest static deflection [m/N] on a circle of `radius` [m]."""
        shapes = shapes_on_circle(self, self.place, radius, count=16)
        deflection = (shapes**2 / (2 * pi * self.frequency) ** 2).sum(axis=1)
        return float(deflection.max(initial=0.0))


def modes_from_numbers(surface: ModesSurface, radius: float) -> TableModes:
    """Return the table modes below MAX_TABLE_FREQUENCY under a disk of `radius` [m].

    The shapes are (r/R)^n cos(n theta) and (r/R)^n sin(n theta), divided by sqrt(modal
    mass), as splines with 16 values per shortest wave at the radius of the disk.
    `modal.surface_modes` computes the same values.
    """
    below = [mode for mode in surface.modes if mode.frequency < MAX_TABLE_FREQUENCY]
    members = []
    for mode in sorted(below, key=lambda mode: mode.frequency):
        members.append((mode, 0))
        if mode.order:
            members.append((mode, 1))
    order = np.array([mode.order for mode, _ in members], dtype=int)
    quarter_turn = pi / 2 * np.array([sine for _, sine in members])
    amplitude = np.array([mode.modal_mass for mode, _ in members]) ** -0.5
    shortest_wave = 2 * pi * radius / max(order.max(initial=1), 1)
    side = np.linspace(-radius, radius, 4 + ceil(2 * radius * 16 / shortest_wave))
    x, y = (part.ravel() for part in np.meshgrid(side, side, indexing="ij"))
    distance = np.hypot(x, y)
    around = np.multiply.outer(order, np.arctan2(y, x)) - quarter_turn[:, None]
    shapes = amplitude[:, None] * (distance / radius) ** order[:, None] * np.cos(around)
    values = np.moveaxis(shapes.reshape(len(members), len(side), len(side)), 0, 2)
    along_x = make_interp_spline(side, values, axis=0)
    along_y = make_interp_spline(side, along_x.c, axis=1)
    return TableModes(
        frequency=np.array([mode.frequency for mode, _ in members]),
        decay_rate=np.array(
            [2 * pi * mode.frequency * mode.damping_ratio for mode, _ in members]
        ),
        order=order,
        knots=(along_x.t, along_y.t),
        coefficients=np.ascontiguousarray(np.moveaxis(along_y.c, 0, 1)),
        place=np.zeros(2),
    )
