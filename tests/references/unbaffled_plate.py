"""Boundary elements for plates without a baffle; writes unbaffled_plate.json beside this file.

The pressure difference over a thin rigid plate in a plane wave is constant on each quadrilateral
panel. Its static part is that of a vortex ring (Biot-Savart), so no hypersingular integral is left;
the rest of the kernel, exp(-i k r) - 1, is integrated by points. By reciprocity, the difference
gives the sound that a plate with a given shape of vibration radiates.

python tests/references/unbaffled_plate.py    (half a minute)
"""

import json
from itertools import pairwise
from pathlib import Path

import numpy as np

ELEVATION = 45.0
"""Elevation of the distant listener above the plane of the plate [degrees]."""
SIZES = (0.3, 0.7, 1.0, 2.0, 3.0, 5.0)
"""Wave number times radius of the disk, or half the length of the rectangle."""


def disk_panels(rings, sectors):
    """Return the corners (p, 4, 2) of panels of a disk of radius 1, finer towards its edge."""
    rho = np.sin(np.linspace(0, np.pi / 2, rings + 1))
    phi = np.linspace(0, 2 * np.pi, sectors + 1)
    stretch = np.sqrt(2 * np.pi / sectors / np.sin(2 * np.pi / sectors))  # equal area
    corners = []
    for a, b in pairwise(rho):
        for f, g in pairwise(phi):
            quad = [(a, f), (b, f), (b, g), (a, g)]
            corners.append(
                [(stretch * r * np.cos(t), stretch * r * np.sin(t)) for r, t in quad]
            )
    return np.array(corners)


def rectangle_panels(width, count):
    """Return the corners (p, 4, 2) of panels of the rectangle |x| <= 1, |y| <= width, finer towards
    its edges.
    """
    x = np.sin(np.linspace(-np.pi / 2, np.pi / 2, count + 1))
    corners = []
    for a, b in pairwise(x):
        for c, d in pairwise(width * x):
            corners.append([(a, c), (b, c), (b, d), (a, d)])
    return np.array(corners)


def ring_velocity(place, corners):
    """Return the velocity (n, p) normal to the plane at points (n, 2) of vortex rings (p, 4, 2)."""
    total = np.zeros((len(place), len(corners)))
    for i in range(4):
        start = place[:, None] - corners[:, i]
        end = place[:, None] - corners[:, (i + 1) % 4]
        along = corners[:, (i + 1) % 4] - corners[:, i]
        cross = start[..., 0] * end[..., 1] - start[..., 1] * end[..., 0]
        length = np.linalg.norm(along, axis=1)
        cosines = (along * start).sum(-1) / np.linalg.norm(start, axis=-1)
        cosines -= (along * end).sum(-1) / np.linalg.norm(end, axis=-1)
        aligned = np.abs(cross) < 1e-14
        with np.errstate(
            divide="ignore", invalid="ignore"
        ):  # sides without length at the middle
            distance = (
                along[..., 1] * start[..., 0] - along[..., 0] * start[..., 1]
            ) / length
            part = cosines / length / distance / (4 * np.pi)
        total += np.where(aligned, 0.0, -part)
    return total


def panel_points(corners, count=3):
    """Return points (p, q, 2) and weights (p, q) of the panels."""
    node, share = np.polynomial.legendre.leggauss(count)
    u, v = (grid.ravel() for grid in np.meshgrid((node + 1) / 2, (node + 1) / 2))
    weight = np.outer(share, share).ravel() / 4
    shape = np.array([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v])
    points = np.einsum("iq,pic->pqc", shape, corners)
    du = np.einsum("iq,pic->pqc", np.array([-(1 - v), 1 - v, v, -v]), corners)
    dv = np.einsum("iq,pic->pqc", np.array([-(1 - u), -u, u, 1 - u]), corners)
    return points, weight * np.abs(du[..., 0] * dv[..., 1] - du[..., 1] * dv[..., 0])


def pressure_difference(corners, size):
    """Return the pressure difference (p,) on the panels in a plane wave of unit amplitude."""
    middle = corners.mean(axis=1)
    points, weights = panel_points(corners)
    matrix = ring_velocity(middle, corners).astype(complex)
    for i, place in enumerate(middle):
        r = np.maximum(np.linalg.norm(place - points, axis=-1), 1e-9)
        slope = (1 - (1 + 1j * size * r) * np.exp(-1j * size * r)) / (4 * np.pi * r**2)
        rest = slope / r  # f'(r)/r of f = (exp(-i k r) - 1)/(4 pi r)
        near = size * r < 1e-3
        rest[near] = -(size**2) / (8 * np.pi * r[near])
        matrix[i] += (weights * rest).sum(axis=1)
        own = (weights[i].sum() / np.pi) ** 0.5  # the panel itself as a disk
        matrix[i, i] += -(size**2) / 4 * own - (weights[i] * rest[i]).sum()
        matrix[i, i] += -1j * size**3 / (12 * np.pi) * weights[i].sum()
    cosine = np.sin(np.radians(ELEVATION))
    sine = np.cos(np.radians(ELEVATION))
    wave = 1j * size * cosine * np.exp(1j * size * sine * middle[:, 0])
    return np.linalg.solve(matrix, -wave)


def level(corners, size, shape):
    """Return the level [dB] of a vibrating plate without a baffle, over that in a baffle."""
    points, weights = panel_points(corners)
    area = weights.sum(axis=1)
    middle = corners.mean(axis=1)
    motion = shape(*middle.T)
    open_edge = (area * motion * pressure_difference(corners, size)).sum()
    wave = np.exp(1j * size * np.cos(np.radians(ELEVATION)) * points[..., 0])
    baffled = 2 * (weights * wave * shape(*points.transpose(2, 0, 1))).sum()
    return 20 * np.log10(abs(open_edge / baffled))


SHAPES = {
    "piston": lambda x, y: np.ones_like(x),
    "supported": lambda x, y: 1 - 1.2 * (x**2 + y**2) + 0.2 * (x**2 + y**2) ** 2,
    "rocking": lambda x, y: x,
    "saddle": lambda x, y: x**2 - y**2,
}
RECTANGLE_SHAPES = {
    "piston": lambda x, y: np.ones_like(x),
    "bow": lambda x, y: np.cos(np.pi / 2 * x) * np.cos(np.pi / 2 * y * 1.5),
}


def main():
    disk = disk_panels(18, 48)
    rectangle = rectangle_panels(2 / 3, 28)
    found = {
        "elevation_deg": ELEVATION,
        "sizes": SIZES,
        "disk": {
            n: [round(level(disk, k, s), 2) for k in SIZES] for n, s in SHAPES.items()
        },
        "rectangle": {
            n: [round(level(rectangle, k, s), 2) for k in SIZES]
            for n, s in RECTANGLE_SHAPES.items()
        },
    }
    path = Path(__file__).with_suffix(".json")
    path.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
