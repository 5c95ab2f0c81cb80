"""Compute the modes of a body on a user's volume mesh, free or held on a named surface
or an arc.

The mesh is translated so that its centre of mass is the origin, and turned so that the
axis of the disk is z. Every cell is divided into eight, and the errors are estimated by comparison
with the original mesh.
"""

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from math import inf, pi
from pathlib import Path
from typing import Any

import numpy as np
from skfem import (
    ElementHex1,
    ElementHex2,
    ElementTetP1,
    ElementTetP2,
    MeshHex1,
    MeshHex2,
    MeshTet1,
    MeshTet2,
)

from modal.elements.elastic import Solid, assemble_solid, lowest_eigenpairs
from modal.elements.mirrors import mirror_symmetries, symmetry_bases
from modal.elements.patch import rigid_body_shift
from modal.elements.user_mesh_error import (
    FLAT_FACE_EXTRAPOLATION_FACTOR,
    relative_errors,
)
from modal.elements.user_mesh_modes import mesh_modes_record
from modal.mesh.read import patch_facets, read_mesh
from modal.mesh.sector import hexahedra
from modal.mesh.symmetry import admissible_displacements, check_no_rigid_motion
from modal.mesh.tetrahedra import TETRAHEDRON_PARTS
from modal.modes import DEFAULT_HIGHEST_FREQUENCY, Material, Modes, Support


@dataclass(frozen=True, kw_only=True)
class DiscreteBody:
    """A body discretised on a mesh with quadratic geometry."""

    solid: Solid
    """Nodes, cells and matrices."""
    element: Any
    """scikit-fem element of the displacement."""
    held: np.ndarray
    """Mask (p,) of the nodes on held facets."""


@dataclass(frozen=True, kw_only=True)
class SolvedBody:
    """Elastic eigenpairs of a body on a user's mesh."""

    body: DiscreteBody
    """Solved discretisation."""
    values: np.ndarray
    """Eigenvalues (k,) [1/s^2], ascending."""
    shapes: np.ndarray
    """Shapes (k, p, 3) of unit modal mass."""
    residual: np.ndarray
    """Residuals (k,) of the pairs."""
    error: np.ndarray
    """Estimated relative errors (k,) of the frequencies."""
    divided: bool
    """True if every cell was divided into eight."""


def linear_and_quadratic_elements(mesh: Any) -> tuple[Any, Any]:
    """Return the linear and the quadratic Lagrange element for the cells of a mesh."""
    if mesh.t.shape[0] == 4:
        return ElementTetP1(), ElementTetP2()
    return ElementHex1(), ElementHex2()


def nodes_of_subcells(element: Any) -> list[np.ndarray]:
    """Return the nodes (8, 3, n) of the eight parts of an element's reference cell in
    reference coordinates."""
    nodes = element.doflocs
    if len(nodes) == 27:
        offsets = np.array(list(np.ndindex(2, 2, 2)))[:, None]
        return (nodes + offsets).transpose(0, 2, 1) / 2
    corners = nodes[np.array(TETRAHEDRON_PARTS)]
    barycentric = np.column_stack([1 - nodes.sum(axis=1), nodes])
    return np.einsum("nk,tkx->txn", barycentric, corners)


def discretise(
    mesh: Any,
    facets: np.ndarray,
    element: Any,
    part_nodes: Sequence[np.ndarray],
    material: Material,
    density: float,
) -> DiscreteBody:
    """Return the `DiscreteBody` on a mesh with each cell divided into parts.

    `part_nodes` (q, 3, n) are the nodes of the q parts in reference coordinates. Linear
    elements have straight sides, because on curved cells they would resist rigid
    rotations.
    """
    nodes = np.concatenate([mesh.mapping().F(x).transpose(1, 2, 0) for x in part_nodes])
    is_tetrahedral = mesh.t.shape[0] == 4
    linear_type, quadratic_type = (
        (MeshTet1, MeshTet2) if is_tetrahedral else (MeshHex1, MeshHex2)
    )
    parts_mesh = hexahedra(nodes, linear_type, quadratic_type)
    if len(element.doflocs) == len(parts_mesh.t):
        parts_mesh = linear_type(
            parts_mesh.doflocs[:, : parts_mesh.t.max() + 1], parts_mesh.t
        )
    solid = assemble_solid(parts_mesh, element, material, density, intorder=4)
    count = solid.cells.shape[1]
    on_facets = np.concatenate([nodes_on_facets(mesh, facets, x) for x in part_nodes])
    held = np.zeros(len(solid.points), bool)
    held[solid.cells[on_facets[:, :count]]] = True
    return DiscreteBody(solid=solid, element=element, held=held)


def nodes_on_facets(mesh: Any, facets: np.ndarray, nodes: np.ndarray) -> np.ndarray:
    """Return the mask (c, n) of the nodes of each cell on the given facets of the mesh.

    `nodes` (3, n) are in reference coordinates.
    """
    cell = mesh.elem.refdom
    distances = []
    for corners in cell.facets:
        p = cell.p[:, list(corners)]
        normal = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
        distances.append(np.abs(normal @ (nodes - p[:, :1])))
    on_plane = np.array(distances) < 1e-9
    return (np.isin(mesh.t2f, facets).T.astype(int) @ on_plane) > 0


def elastic_eigenpairs(
    body: DiscreteBody, components: Sequence[str], below: float, shift: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return eigenvalues (k,), shapes (k, p, 3) and residuals (k,) of the elastic modes
    below `below` [Hz].

    The eigenvalues are ascending. The symmetry classes of the mesh are solved
    separately, two concurrently. Raises ArithmeticError if the number of rigid-body
    modes is not six for a free body or zero for a held one.
    """
    solid = body.solid

    def solve_class(basis: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        k, m = (basis.T @ matrix @ basis for matrix in (solid.stiffness, solid.mass))
        values, vectors, residual = lowest_eigenpairs(
            k,
            m,
            (2 * pi * below) ** 2,
            shift,
            first_count=16,
        )
        return values, (basis @ vectors).T, residual

    bases = symmetry_bases(
        body, admissible_displacements(solid.points, body.held, components)
    )
    with ThreadPoolExecutor(2) as pool:
        solved = list(pool.map(solve_class, bases))
    values, shapes, residual = (
        np.concatenate(arrays) for arrays in zip(*solved, strict=True)
    )
    rigid = np.count_nonzero(values < 1e-6 * abs(shift))
    expected = 6 if shift else 0
    if rigid != expected:
        raise ArithmeticError(f"{rigid} rigid-body modes were found, not {expected}")
    elastic = np.argsort(values, kind="stable")[rigid:]
    return (
        values[elastic],
        shapes[elastic].reshape(-1, len(solid.points), 3),
        residual[elastic],
    )


def solve_body(
    mesh: Any,
    facets: np.ndarray,
    components: Sequence[str],
    material: Material,
    density: float,
    below: float,
    max_unknowns: float,
    edge_error_ratio: float,
) -> SolvedBody:
    """Compute the modes of a body with quadratic elements and estimate their errors.

    Every cell is divided into eight, unless a symmetry class would then have more than
    `max_unknowns` unknowns; in that case the original mesh is used, and the errors are
    estimated from linear elements. The `components` are held on the `facets`; without
    facets the body is free. `edge_error_ratio` is a parameter of `relative_errors`.
    Raises ValueError if the held components do not prevent all rigid-body motions.
    """
    linear, quadratic = linear_and_quadratic_elements(mesh)
    whole_cell = [quadratic.doflocs.T]
    given = discretise(mesh, facets, quadratic, whole_cell, material, density)
    if len(facets):
        check_no_rigid_motion(given.solid.points[given.held], components)
    divided = 8 * 3 * len(given.solid.points) <= max_unknowns * 2 ** len(
        mirror_symmetries(given)
    )
    if divided:
        part_nodes = nodes_of_subcells(quadratic)
        fine = discretise(mesh, facets, quadratic, part_nodes, material, density)
        coarse = given
    else:
        part_nodes = whole_cell
        fine = given
        coarse = discretise(mesh, facets, linear, whole_cell, material, density)
    shift = 0.0
    if not len(facets):
        size = np.ptp(fine.solid.points, axis=0)
        shift = rigid_body_shift(size.max() / 2, size[2], material, density)
    values, shapes, residual = elastic_eigenpairs(fine, components, below, shift)
    error = relative_errors(
        mesh,
        facets,
        fine,
        coarse,
        part_nodes,
        (values, shapes),
        shift,
        edge_error_ratio,
    )
    return SolvedBody(
        body=fine,
        values=values,
        shapes=shapes,
        residual=residual,
        error=error,
        divided=divided,
    )


def mesh_modes(
    path: str | Path,
    material: Material,
    density: float,
    support: Support,
    below: float = DEFAULT_HIGHEST_FREQUENCY,
    patch: str | None = None,
    refine: bool = True,
) -> Modes:
    """Compute the elastic modes of a disk on a volume mesh from a file.

    Elements are quadratic. The frequencies are those of the body as meshed:
    `Modes.error` does not include the effect of straight mesh edges on a round body.
    Cells of several types, wedges and pyramids are divided into tetrahedra. A disk
    whose axis is not z is turned by the smallest angle; its moments of inertia and its
    flat faces determine the axis. A mesh along y is thus turned about x.

    Parameters
    ----------
    path : str or Path
        Universal file (.unv, .uff) or file in a format supported by meshio, such as
        .msh of Gmsh or .inp of Abaqus, with lengths in metres.
    material : Material
        Elastic constants and losses.
    density : float
        Density [kg/m^3].
    support : Support
        Kind and position of the support.
    below : float, optional
        Exclusive upper limit of the frequencies [Hz].
    patch : str, optional
        Name of a surface of the mesh (physical group, or set of sides or nodes). By
        default angle and height of `support` define the patch.
    refine : bool, optional
        If True, divide every cell into eight, which takes about 20 to 50 times as long.
        If False, `Modes.error` is estimated from linear elements, which is far too high
        for bodies without singularities.

    Returns
    -------
    Modes
        Modes below `below`; may be empty.

    Raises
    ------
    ValueError
        If the mesh cannot be used, if the axis of the disk cannot be determined, if the
        patch is empty, or if the held components do not prevent all rigid-body motions.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> import meshio
    >>> from modal import Material, Support, mesh_modes
    >>> base = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    >>> corners = 0.02 * np.array([*base, *[(x, y, 1) for x, y, _ in base]])
    >>> cube = meshio.Mesh(corners, {"hexahedron": [list(range(8))]})
    >>> steel = Material(name="steel")
    >>> free = Support(kind="free")
    >>> with TemporaryDirectory() as folder:
    ...     path = Path(folder) / "cube.vtk"
    ...     cube.write(path)
    ...     len(mesh_modes(path, steel, 7850.0, free, below=80e3))
    2
    """
    mesh = read_mesh(path)
    facets = (
        np.zeros(0, int)
        if support.kind == "free"
        else patch_facets(mesh, support, patch)
    )
    solved = solve_body(
        mesh,
        facets,
        support.held,
        material,
        density,
        below,
        max_unknowns=inf if refine else 0,
        edge_error_ratio=FLAT_FACE_EXTRAPOLATION_FACTOR,
    )
    return mesh_modes_record(solved, material)
