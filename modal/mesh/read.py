"""Read user volume meshes and convert them to scikit-fem, or report why they cannot be
used."""

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import scipy.sparse as sp
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree
from skfem import CellBasis, Mesh, MeshTet1
from skfem.io.meshio import from_meshio

from modal.mesh.disk_axis import turned_to_z
from modal.mesh.files import read_mesh_file
from modal.mesh.hexahedron import VTK_HEXAHEDRON27
from modal.mesh.tetrahedra import (
    SHAPE_OF_CELLS,
    tetrahedra_of_cells,
    triangles_of_quadrilaterals,
)

if TYPE_CHECKING:
    import meshio

    from modal.modes import Support

KEPT_CELLS = {"tetra", "tetra10", "hexahedron", "hexahedron20", "hexahedron27"}
"""meshio's names of the volume cells that are not divided into tetrahedra."""
MAX_DISK_SIZE = 5.0
"""Largest size of a disk [m]; a larger one is taken for one in millimetres."""
MAX_TABLE_SIZE = 20.0
"""Largest size of a table [m]."""


def read_mesh(path: str | Path) -> Mesh:
    """Return the scikit-fem mesh of a disk, with its centre of mass at the origin and
    its axis along z.

    Raises ValueError if the mesh cannot be used.
    """
    mesh = read_checked(path, MAX_DISK_SIZE)
    basis = CellBasis(mesh, mesh.elem())
    x = basis.global_coordinates()
    return turned_to_z(
        mesh.translated(
            tuple(-(np.asarray(x) * basis.dx).sum(axis=(1, 2)) / basis.dx.sum())
        ),
        path,
    )


def read_checked(path: str | Path, max_size: float) -> Mesh:
    """Return the checked scikit-fem mesh of a file, at most `max_size` [m] large.

    Its boundaries are the named surfaces and sets of nodes of the file. The mesh is
    neither translated nor turned. Raises ValueError if the mesh cannot be used.
    """
    import meshio

    file = read_mesh_file(path)
    points, kind, cells = points_and_volume_cells(file, path)
    cell_data = {}
    if {block.type for block in file.cells if block.dim == 3} == {kind}:
        for name in file.cell_data:
            if name.startswith("skfem:"):  # boundaries written by scikit-fem
                cell_data[name] = [volume_data(file, name)]
    used, numbers = np.unique(cells, return_inverse=True)
    numbers = numbers.reshape(cells.shape)
    mesh = from_meshio(
        meshio.Mesh(points[used], [(kind, numbers)], cell_data=cell_data)
    )
    check_mesh(mesh, path, max_size)
    named = mesh.boundaries or {}
    for name, sides in named_sides(file).items():
        named[name] = matching_facets(mesh, points, sides)
    for name, nodes in (file.point_sets or {}).items():
        named.setdefault(name, facets_between(mesh, file.points[nodes]))
    return mesh.with_boundaries(named)


def volume_data(file: "meshio.Mesh", name: str) -> np.ndarray:
    """Return the cell data of all volume cells of a meshio mesh."""
    blocks = zip(file.cells, file.cell_data[name], strict=True)
    return np.concatenate([data for block, data in blocks if block.dim == 3])


def points_and_volume_cells(
    file: "meshio.Mesh", path: str | Path
) -> tuple[np.ndarray, str, np.ndarray]:
    """Return the points (p, 3) of a meshio mesh, one type of cell, and its cells (c, n).

    Cells of mixed types, wedges and pyramids are divided into tetrahedra, and
    hexahedra with 20 nodes are converted to 27 nodes. Raises ValueError if there are no
    volume cells, or if they cannot be converted.
    """
    blocks = [block for block in file.cells if block.dim == 3]
    if not blocks:
        others = ", ".join(sorted(file.cells_dict))
        raise ValueError(
            f"{path}: no volume cells{others and f', only {others}'}; mesh the volume, not "
            "just its surface, and save all of its cells"
        )
    kinds = sorted({block.type for block in blocks})
    is_linear = [kind in SHAPE_OF_CELLS.values() for kind in kinds]
    if not SHAPE_OF_CELLS.keys() >= set(kinds) or len(set(is_linear)) > 1:
        raise ValueError(
            f"{path}: its cells are {' and '.join(kinds)}; save tetrahedra, hexahedra, "
            "wedges or pyramids, either all linear or all of second order"
        )
    for block in file.cells:
        if not np.isin(block.data, np.arange(len(file.points))).all():
            raise ValueError(
                f"{path}: not a readable mesh: a cell has a node number outside 0 to "
                f"{len(file.points) - 1}",
            )
    cells = {
        kind: np.concatenate([block.data for block in blocks if block.type == kind])
        for kind in kinds
    }
    if len(kinds) > 1 or kinds[0] not in KEPT_CELLS:
        points, tetrahedra = tetrahedra_of_cells(file.points, list(cells.items()))
        return points, "tetra" if is_linear[0] else "tetra10", tetrahedra
    if kinds[0] == "hexahedron20":
        points, numbers = hexahedra27_from_20(file.points, cells[kinds[0]])
        return points, "hexahedron27", numbers
    return file.points, kinds[0], cells[kinds[0]]


def named_sides(file: "meshio.Mesh") -> dict[str, list[np.ndarray]]:
    """Return the corners of the sides in each named surface of a meshio mesh, as a list
    of arrays (k, 3) or (k, 4).

    Names are those of sets of cells, and of physical groups of Gmsh. The list of a
    group without sides is empty.
    """
    selections = dict(file.cell_sets)
    groups = file.cell_data.get("gmsh:physical", [])
    surface_groups = set()
    for name, (tag, dimension) in file.field_data.items() if groups else ():
        if dimension == 2:
            surface_groups.add(name)
            selections[name] = [np.flatnonzero(found == tag) for found in groups]
    named: dict[str, list[np.ndarray]] = {name: [] for name in surface_groups}
    for name, selection in selections.items():
        if name.startswith("gmsh:"):
            continue
        for block, rows in zip(file.cells, selection, strict=False):
            corner_count = {"tri": 3, "qua": 4}.get(block.type[:3])
            if corner_count and rows is not None and len(rows):
                named.setdefault(name, []).append(block.data[rows, :corner_count])
    return named


def matching_facets(
    mesh: Mesh, points: np.ndarray, sides: list[np.ndarray]
) -> np.ndarray:
    """Return the facets (k,) of a mesh at the corners of sides.

    `sides` is a list of node numbers (k, 3) or (k, 4) of `points`. On a mesh of
    tetrahedra, quadrilaterals are cut like the cells.
    """
    count = len(mesh.facets)
    corners = np.zeros((0, count), int)
    for side in sides:
        cut = triangles_of_quadrilaterals(side) if side.shape[1] > count else side
        if cut.shape[1] == count:
            corners = np.vstack([corners, cut])
    distance, number = cKDTree(mesh.p.T).query(points[corners])
    on_mesh = (distance <= 1e-9 * np.ptp(mesh.p, axis=1).max()).all(axis=1)
    known = np.sort(mesh.facets, axis=0).T
    wanted = np.sort(number[on_mesh], axis=1)
    _, place = np.unique(np.concatenate([known, wanted]), axis=0, return_inverse=True)
    place = place.ravel()
    return np.flatnonzero(np.isin(place[: len(known)], place[len(known) :]))


def facets_between(mesh: Mesh, points: np.ndarray) -> np.ndarray:
    """Return the boundary facets (k,) with all corners among the points (n, 3)."""
    facets = mesh.boundary_facets()
    distance, _ = cKDTree(points).query(mesh.p.T)
    is_near = distance <= 1e-9 * np.ptp(mesh.p, axis=1).max()
    return facets[is_near[mesh.facets[:, facets]].all(axis=0)]


def hexahedra27_from_20(
    points: np.ndarray, cells: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return points (p, 3) and cells (c, 27) for cells (c, 20).

    The additional nodes in the middle of faces and cells are interpolated by the 20
    shape functions. Their weights are -1/4 for corners and 1/2 for edge nodes in the
    middle of a face, and -1/4 and 1/4 in the middle of a cell.
    """
    lattice = np.array(VTK_HEXAHEDRON27)
    sides = [
        np.flatnonzero((lattice[:20] == node)[:, node != 1].all(axis=1))
        for node in lattice[20:26]
    ]
    faces = cells[:, sides].reshape(-1, 8)
    face_corners = np.sort(faces[:, :4], axis=1)
    _, first, face = np.unique(
        face_corners, axis=0, return_index=True, return_inverse=True
    )
    on_faces = np.einsum("n,cnx->cx", [-1 / 4] * 4 + [1 / 2] * 4, points[faces[first]])
    inside = np.einsum("n,cnx->cx", [-1 / 4] * 8 + [1 / 4] * 12, points[cells])
    face_numbers = len(points) + face.reshape(-1, 6)
    inside_numbers = len(points) + len(first) + np.arange(len(cells))[:, None]
    return np.vstack([points, on_faces, inside]), np.hstack(
        [cells, face_numbers, inside_numbers]
    )


def check_mesh(mesh: Mesh, name: str | Path, max_size: float) -> None:
    """Raise ValueError if a mesh cannot be used.

    Reasons are a size below a millimetre or above `max_size` [m], degenerate cells, and several bodies.
    The volumes of the cells are compared at the quadrature points; cells may shrink
    towards an edge.
    """
    min_size = 1e-3  # m
    min_volume_ratio = 1e-13  # of the smallest to the median cell
    used = np.unique(mesh.t)
    if not np.isfinite(mesh.p[:, used]).all():
        raise ValueError(f"{name}: some points are not finite")
    size = np.ptp(mesh.p[:, used], axis=1).max()
    if size > max_size:
        raise ValueError(
            f"{name}: its size is {size:g} m, and at most {max_size:g} m are allowed; lengths "
            "must be in metres; are they in millimetres?",
        )
    if size < min_size:
        raise ValueError(
            f"{name}: its size is {size:g} m, and at least {min_size:g} m are needed; lengths "
            "must be in metres"
        )
    with np.errstate(divide="ignore", invalid="ignore"):
        volume = mesh.mapping().detDF(CellBasis(mesh, mesh.elem()).X)
    flat = np.abs(volume).min(axis=1) <= min_volume_ratio * np.median(np.abs(volume))
    folded = (volume > 0).any(axis=1) & (volume < 0).any(axis=1)
    signs = (
        np.sign(volume.mean(axis=1)) if not isinstance(mesh, MeshTet1) else np.ones(1)
    )
    inverted = signs != np.sign(signs.sum() or 1)
    for fault, bad in (
        ("flat or folded", flat | folded),
        ("numbered inside out", inverted),
    ):
        if bad.any():
            raise ValueError(
                f"{name}: {bad.sum()} of {mesh.nelements} cells are {fault}; the first one is "
                f"{bad.argmax()}",
            )
    corners = mesh.t
    pairs = np.concatenate([corners[[0, i]] for i in range(1, len(corners))], axis=1)
    graph = sp.coo_matrix(
        (np.ones(pairs.shape[1]), pairs), shape=(mesh.p.shape[1],) * 2
    )
    bodies = len(np.unique(connected_components(graph, directed=False)[1][used]))
    if bodies > 1:
        raise ValueError(
            f"{name}: {bodies} bodies without common nodes; merge them or mesh only one"
        )


def patch_facets(mesh: Mesh, support: "Support", name: str | None = None) -> np.ndarray:
    """Return the facets of a named boundary of the mesh; without a name, those within
    the arc and the height of the patch."""
    if name is not None:
        if name not in (mesh.boundaries or {}):
            raise ValueError(
                f"the mesh has no surface {name!r}, only {sorted(mesh.boundaries or {})}",
            )
        found = np.asarray(mesh.boundaries[name])
        if not len(found):
            raise ValueError(f"the surface {name!r} contains no complete facet")
        return found
    radius = np.hypot(*mesh.p[:2]).max()
    facets = mesh.boundary_facets()
    x, y, z = mesh.p[:, mesh.facets[:, facets]]
    low = mesh.p[2].min()
    high = mesh.p[2].max()
    height = support.height or high - low
    bottom = low if support.position == "bottom" else (low + high - height) / 2
    on_rim = (np.hypot(x, y) > 0.99 * radius).all(axis=0) & (
        np.ptp(z, axis=0) > 1e-6 * radius
    )
    angle = np.arctan2(y.mean(axis=0), x.mean(axis=0))
    within_angle = np.abs(angle) <= np.deg2rad(support.half_angle_deg) + 1e-9
    middle = z.mean(axis=0)
    found = facets[
        on_rim & within_angle & (middle > bottom) & (middle < bottom + height)
    ]
    if not len(found):
        raise ValueError(
            f"no facet of the mesh lies on the patch of +-{support.half_angle_deg:g} degrees; "
            "refine the mesh there or name a surface"
        )
    return found
