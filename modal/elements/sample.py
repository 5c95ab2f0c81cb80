"""Sample modes on fixed grids of rim and faces, and interpolate finite-element
fields."""

from typing import TYPE_CHECKING, Any

import numpy as np
import scipy.sparse as sp

from modal.modes import Body, Modes

if TYPE_CHECKING:
    from modal.modes import Material


def rim_angles() -> np.ndarray:
    """Return the equally spaced angles (k,) [rad] of `Modes.rim_shape`."""
    return equally_spaced_angles(128)


def equally_spaced_angles(count: int) -> np.ndarray:
    """Return angles (count,) [rad] from 0 on around the whole circumference."""
    return np.arange(count) * 2 * np.pi / count


def face_grid(
    radius: float, inner: float = 0.0
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the grid of `Modes.face_shape`.

    It consists of Gauss radii [m], weights [m^2] of int f r dr, and equally spaced
    angles [rad]."""
    radius_count = 16
    angle_count = 64
    node, weight = np.polynomial.legendre.leggauss(radius_count)
    r = (radius + inner) / 2 + node * (radius - inner) / 2
    return r, weight * (radius - inner) / 2 * r, equally_spaced_angles(angle_count)


def sample_points(radius: float) -> tuple[np.ndarray, np.ndarray]:
    """Return sample points [m] of the rim (n, 2) and of a face without a hole (a b,
    2)."""
    angle = rim_angles()
    r, _, theta = face_grid(radius)
    rim = radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    x = np.outer(r, np.cos(theta))
    y = np.outer(r, np.sin(theta))
    face = np.stack([x, y], axis=-1)
    return rim, face.reshape(-1, 2)


def partner_indices(pair: np.ndarray) -> np.ndarray:
    """Return the index (m,) of the other mode with the same pair number, or -1 if there
    is none."""
    same = pair[:, None] == pair[None, :]
    np.fill_diagonal(same, False)
    return np.where(same.any(axis=1), same @ np.arange(len(pair)), -1)


def sorted_modes(
    columns: dict[str, np.ndarray],
    material: "Material",
    radius: float,
    points: np.ndarray,
    cells: np.ndarray,
    inner: float = 0.0,
    cell_type: str = "hexahedron27",
    **about: Any,
) -> Modes:
    """Return `Modes`, sorted by frequency, from columns (m, ...) by name.

    The columns are all fields of `Modes` with one entry per mode except the decay rate.
    Shapes are sampled on the grids for the radii `radius` and `inner` [m]; `face_shape`
    may have the shape (m, 2, a b). A further column is the `displacement` (m, p, 3) of
    the nodes. The optional column `pair`, the number of the degenerate pair, replaces
    `partner`.
    """
    ascending = np.lexsort((columns["parity"] == "odd", columns["frequency"]))
    fields: dict[str, Any] = {
        name: np.asarray(value)[ascending] for name, value in columns.items()
    }
    for name in ("family", "parity"):
        fields[name] = tuple(fields[name].tolist())
    displacement = fields.pop("displacement")
    r, weight, angle = face_grid(radius, inner)
    fields["face_shape"] = fields["face_shape"].reshape(-1, 2, len(r), len(angle))
    return Modes(
        partner=partner_indices(fields.pop("pair", np.arange(len(ascending)))),
        **fields,
        decay_rate=np.pi * fields["frequency"] * material.loss_factor,
        rim_angle=rim_angles(),
        face_radius=r,
        face_weight=weight,
        face_angle=angle,
        body=Body(
            points=points, cells=cells, cell_type=cell_type, displacement=displacement
        ),
        **about,
    )


def quadratic_shape_functions(x: np.ndarray) -> np.ndarray:
    """Return the Lagrange polynomials (..., 3) with the nodes 0, 1/2, 1 at x (...)."""
    at_start = (1 - x) * (1 - 2 * x)
    at_middle = 4 * x * (1 - x)
    at_end = x * (2 * x - 1)
    return np.stack([at_start, at_middle, at_end], axis=-1)


def quadratic_shape_slopes(x: np.ndarray) -> np.ndarray:
    """Return the derivatives (..., 3) of `quadratic_shape_functions`."""
    return np.stack([4 * x - 3, 4 - 8 * x, 4 * x - 1], axis=-1)


def locate_in_cells(
    points: np.ndarray, cells: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the biquadratic cell (n,) that contains each point (n, 2), and its
    coordinates (n, 2) in it.

    The cells (q, 3, 3, 2) are given by their nodes, and the coordinates are those of
    the unit square. The nearest cells are searched first; all cells are searched if the
    point is outside of them. Points outside all cells, beyond an approximated arc, are
    assigned the nearest coordinates in a cell.
    """
    first_candidate_count = 6
    tolerance = 1e-9  # relative to the size of the cell
    distance = np.linalg.norm(points[:, None] - cells[None, :, 1, 1], axis=2)
    size = np.linalg.norm(cells[:, 2, 2] - cells[:, 0, 0], axis=1)
    order = np.argsort(distance / size, axis=1)
    cell, coordinates, miss = nearest_cell(
        points, cells, order[:, :first_candidate_count]
    )
    missed = miss > tolerance * size[cell]
    cell[missed], coordinates[missed], _ = nearest_cell(
        points[missed], cells, order[missed]
    )
    return cell, coordinates


def nearest_cell(
    points: np.ndarray, cells: np.ndarray, candidates: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the nearest of the candidate cells (n, c) to each point (n, 2).

    The result consists of the cell (n,), the coordinates (n, 2) in it, clipped to the
    unit square, and the distance (n,). Newton's method is applied to all candidates.
    """
    newton_iterations = 7
    nodes = cells[candidates]
    coordinates = np.full((*candidates.shape, 2), 0.5)
    for _ in range(newton_iterations):
        image, jacobian = map_from_unit_square(nodes, coordinates)
        residual = (points[:, None] - image)[..., None]
        step = np.linalg.solve(jacobian + 1e-300 * np.eye(2), residual)[..., 0]
        coordinates = np.clip(coordinates + step, -0.5, 1.5)
    coordinates = np.clip(coordinates, 0, 1)
    miss = np.linalg.norm(
        map_from_unit_square(nodes, coordinates)[0] - points[:, None], axis=2
    )
    rows = np.arange(len(points))
    best = miss.argmin(axis=1)
    return candidates[rows, best], coordinates[rows, best], miss[rows, best]


def map_from_unit_square(
    nodes: np.ndarray, coordinates: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return points (n, c, 2) and Jacobians (n, c, 2, 2) of coordinates (n, c, 2) in
    biquadratic cells.

    The cells are given by their nodes (n, c, 3, 3, 2), and the coordinates are those of
    the unit square.
    """
    u, v = np.moveaxis(coordinates, -1, 0)
    in_u = quadratic_shape_functions(u)
    in_v = quadratic_shape_functions(v)
    point, along_u, along_v = (
        np.einsum("nci,ncj,ncijx->ncx", of_u, of_v, nodes)
        for of_u, of_v in (
            (in_u, in_v),
            (quadratic_shape_slopes(u), in_v),
            (in_u, quadratic_shape_slopes(v)),
        )
    )
    return point, np.stack([along_u, along_v], axis=-1)


def interpolation_matrix(
    points: np.ndarray, cells: np.ndarray, numbers: np.ndarray, count: int
) -> sp.csr_matrix:
    """Return the sparse matrix (n, count) from nodal values to values at points (n, 2).

    `numbers` (q, 3, 3) are the node numbers of the biquadratic cells (q, 3, 3, 2).
    """
    cell, coordinates = locate_in_cells(points, cells)
    along_u, along_v = (quadratic_shape_functions(coordinates[:, i]) for i in (0, 1))
    weight = along_u[:, :, None] * along_v[:, None, :]
    rows = np.repeat(np.arange(len(points)), 9)
    return sp.csr_matrix(
        (weight.ravel(), (rows, numbers[cell].ravel())),
        shape=(len(points), count),
    )


def polar_components(shape: np.ndarray, angle: np.ndarray) -> np.ndarray:
    """Return radial, tangential and axial components (..., k, 3) of Cartesian
    displacements at angles (k,) [rad]."""
    c = np.cos(angle)
    s = np.sin(angle)
    x, y, z = np.moveaxis(shape, -1, 0)
    return np.stack([c * x + s * y, c * y - s * x, z], axis=-1)


def strongest_order(rim_shape: np.ndarray) -> np.ndarray:
    """Return the dominant circumferential order (m,) of rim shapes (m, k, 3)."""
    power = (np.abs(np.fft.rfft(rim_shape, axis=1)) ** 2).sum(axis=2)
    power[:, 0] /= 2
    return power.argmax(axis=1)
