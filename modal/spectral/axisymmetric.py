"""Compute the modes of an axisymmetric solid, with degenerate cosine and sine modes for
every order n >= 1."""

from collections.abc import Sequence
from math import pi
from typing import Any

import numpy as np

from modal.accuracy import ACCURACY_LEVELS
from modal.elements import sample
from modal.elements.unfold import whole_mesh
from modal.mesh.half_disk import MeshSize, cells_of_blocks, rim_blocks
from modal.mesh.sector import extrude, hexahedra, sector
from modal.modes import Modes, Support
from modal.spectral.basis import Plate, RitzProblem
from modal.spectral.p_refinement import (
    Eigenpairs,
    all_eigenpairs,
    displacement_amplitudes,
)
from modal.spectral.ritz import gauss_grid, translation_mass


def displacement_at_angles(
    amplitude: Sequence[np.ndarray] | np.ndarray, n: int, angle: np.ndarray, odd: bool
) -> np.ndarray:
    """Return the cylindrical displacement (..., 3) at angles (q,) [rad] from amplitudes
    (3, ..., q) of order n.

    It is that of the sine partner if `odd`, and of the cosine mode otherwise.
    """
    c = np.cos(n * angle)
    s = np.sin(n * angle)
    factors = (s, -c, s) if odd else (c, s, c)
    return np.stack([a * f for a, f in zip(amplitude, factors, strict=True)], axis=-1)


def sine_partner_flags(pairs: Eigenpairs) -> tuple[bool, ...]:
    """Return a flag for each member of a pair: False for the cosine mode, True for its
    sine partner.

    A torsional mode is single and counts as a sine partner, because its u_theta is even
    in theta.
    """
    return (False, True) if pairs.problem.n else (pairs.problem.family == "torsional",)


def cosine_participation(plate: Plate, pairs: Eigenpairs) -> np.ndarray:
    """Return the participations (k, 6) of the cosine modes, see `Modes`."""
    n = pairs.problem.n
    rho, zeta, radial_weight, axial_weight = gauss_grid(plate, n, pairs.size)
    a, b, w = displacement_amplitudes(pairs, rho, zeta)
    weight = plate.density * np.outer(radial_weight, axial_weight)
    r = rho[:, None] * plate.radius
    h = zeta * plate.thickness / 2
    zero = 0 * a
    if n == 0:
        work = [zero, zero, w, zero, zero, r * b]
    elif n == 1:
        work = [a - b, zero, zero, zero, h * (a - b) - r * w, zero]
    else:
        work = [zero] * 6
    return np.einsum("fkrz,rz->kf", work, weight)


def family_name(problem: RitzProblem) -> str:
    """Return the name of the family of the modes of a `RitzProblem`, see `Modes`."""
    if problem.family == "torsional":
        return "torsional"
    return "extensional" if problem.even > 0 else "flexural"


def mode_columns(
    plate: Plate, pairs: Eigenpairs, odd: bool, drawing_nodes: tuple[Any, ...]
) -> dict[str, np.ndarray]:
    """Return the arrays (k, ...) of `Modes` for one problem; `drawing_nodes` is from
    `drawing_mesh`."""
    p = pairs.problem
    n = p.n
    k = len(pairs.values)
    participation = cosine_participation(plate, pairs)
    if odd:
        participation = participation[:, [1, 0, 2, 4, 3, 5]] * [1, 1, 1, -1, 1, -1]
    angle = sample.rim_angles()
    rim = displacement_amplitudes(pairs, np.ones(1), -np.ones(1))[..., 0]
    r, _, theta = sample.face_grid(1.0, plate.hole)
    faces = displacement_amplitudes(pairs, r, np.array([-1.0, 1.0]))[2].transpose(
        0, 2, 1
    )
    around = np.sin(n * theta) if odd else np.cos(n * theta)
    node_angle, (rho, at_rho), (zeta, at_zeta) = drawing_nodes
    inside = displacement_amplitudes(pairs, rho, zeta)[..., at_rho, at_zeta]
    cylindrical = displacement_at_angles(inside, n, node_angle, odd)
    return {
        "frequency": np.sqrt(pairs.values) / (2 * pi),
        "order": np.full(k, n),
        "family": np.full(k, family_name(p)),
        "parity": np.full(k, "odd" if odd else "even"),
        "pair": np.arange(k),
        "participation": participation,
        "rim_shape": displacement_at_angles(
            np.broadcast_to(rim, (3, k, len(angle))),
            n,
            angle,
            odd,
        ),
        "face_shape": faces[..., None] * around,
        "residual": pairs.residual,
        "error": pairs.error.sum(axis=0),
        "displacement": sample.polar_components(
            cylindrical, -node_angle
        ),  # Cartesian components
    }


def drawing_mesh_split(highest_order: int, mode_count: int) -> int:
    """Return the number of parts into which cell edges of the `drawing_mesh` are split.

    The cells resolve waves of the highest order, unless the displacements of all modes
    would require too much memory.
    """
    max_bytes = 4e8
    bytes_unsplit = 800 * 3 * 8  # 800 nodes with three displacements each
    affordable = (max_bytes / (bytes_unsplit * max(mode_count, 1))) ** (1 / 3)
    return max(1, min(1 + highest_order // 6, int(affordable)))


def drawing_mesh(
    plate: Plate, split: int
) -> tuple[np.ndarray, np.ndarray, tuple[Any, ...]]:
    """Return nodes (p, 3) [m], cells and node coordinates of a mesh of the whole plate.

    Every cell edge is split into `split` parts. The node coordinates are the angles
    (p,) [rad] and the distinct relative radii and heights, both with the index (p,) of
    each node in them.
    """
    size = MeshSize(width=pi / 8, depth=0.38, rings=1, split=split)
    if plate.hole:
        blocks = rim_blocks(np.linspace(0, pi, 17), 1 - plate.hole)
        heights = np.linspace(0, plate.thickness / 2, size.split + 1)
        mesh = hexahedra(extrude(cells_of_blocks(blocks, size) * plate.radius, heights))
    else:
        mesh = sector(plate.radius, plate.thickness, Support(kind="free"), size).mesh
    points, cells, _ = whole_mesh(
        mesh.doflocs.T, mesh.dofs.element_dofs.T, quarter=True
    )
    x, y, z = points.T
    rho = np.clip(np.hypot(x, y) / plate.radius, plate.hole, 1).round(12)
    zeta = np.clip(2 * z / plate.thickness, -1, 1).round(12)
    indexed_rho = np.unique(rho, return_inverse=True)
    indexed_zeta = np.unique(zeta, return_inverse=True)
    return points, cells, (np.arctan2(y, x), indexed_rho, indexed_zeta)


def plate_modes(plate: Plate, below: float, accuracy: str = "standard") -> Modes:
    """Compute the elastic modes of an axisymmetric plate.

    Parameters
    ----------
    plate : Plate
        The plate.
    below : float
        Exclusive upper limit of the frequencies [Hz].
    accuracy : {"draft", "standard", "reference"}, optional
        Accuracy of the solver.

    Returns
    -------
    Modes
        Modes below `below`; may be empty.

    Raises
    ------
    KeyError
        If the accuracy is unknown.

    Examples
    --------
    >>> from modal import Material, Plate
    >>> steel = Material(young=195e9, poisson=0.28)
    >>> plate = Plate(radius=0.05, thickness=0.002, material=steel, density=7800.0)
    >>> plate_modes(plate, 2e3, "draft").order.tolist()
    [2, 2, 0]
    """
    limit = below
    found: list[Eigenpairs] = []
    while not found:
        found = all_eigenpairs(plate, limit, ACCURACY_LEVELS[accuracy].free_error)
        limit *= 2
    highest_order = max(pairs.problem.n for pairs in found)
    mode_count = sum(
        len(sine_partner_flags(pairs)) * len(pairs.values) for pairs in found
    )
    split = drawing_mesh_split(highest_order, mode_count)
    points, cells, drawing_nodes = drawing_mesh(plate, split)
    parts = []
    for number, pairs in enumerate(found):
        for odd in sine_partner_flags(pairs):
            part = mode_columns(plate, pairs, odd, drawing_nodes)
            parts.append(part | {"pair": 1000 * number + part["pair"]})
    columns = {
        name: np.concatenate([part[name] for part in parts]) for name in parts[0]
    }
    columns = {
        name: value[columns["frequency"] < below] for name, value in columns.items()
    }
    return sample.sorted_modes(
        columns,
        plate.material,
        plate.radius,
        points,
        cells,
        plate.inner_radius,
        mass=translation_mass(plate, found[0].size),
        method="Fourier and polynomials",
        unknowns=sum(len(pairs.vectors) for pairs in found),
    )
