"""Boundary elements of two half-spaces that touch in an ellipse, for Poisson's ratio 0."""

import numpy as np


def elliptical_elements(ratio, rows):
    """Return centres x and y (n,) and sides of the rectangular elements of an ellipse with semi-axes 1
    and `ratio`, and the matrix (n, n) of the growth of the displacement along x.

    An entry is the difference between the displacements at the two ends of an element that a unit
    traction on another element causes, with 1/r as the influence of a point.
    """
    dx = 2 / 32
    dy = 2 * ratio / rows
    x, y = np.meshgrid(
        dx * (np.arange(32) + 0.5) - 1,
        dy * (np.arange(rows) + 0.5) - ratio,
        indexing="ij",
    )
    inside = np.hypot(x, y / ratio) < 1
    x = x[inside]
    y = y[inside]

    def displaced(x, y):
        """Return the integral of 1/r over an element."""
        corners = [
            (x + i * dx / 2, y + j * dy / 2, i * j) for i in (1, -1) for j in (1, -1)
        ]
        return sum(
            s * (u * np.arcsinh(v / abs(u)) + v * np.arcsinh(u / abs(v)))
            for u, v, s in corners
        )

    along = x[:, None] - x
    across = y[:, None] - y
    grown = (displaced(along, across) - displaced(along + dx, across)) / np.pi
    return x, y, dx, dy, grown
