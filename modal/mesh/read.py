"""Read user volume meshes with meshio and convert them to scikit-fem, or report why
they cannot be used."""

import sys
from contextlib import redirect_stderr, redirect_stdout
from threading import get_ident

import numpy as np
import scipy.sparse as sp
from scipy.sparse.csgraph import connected_components
from skfem import CellBasis, MeshTet1
from skfem.io.meshio import from_meshio

from modal.mesh.hexahedron import VTK_HEXAHEDRON27

SUPPORTED_CELLS = {"tetra", "tetra10", "hexahedron", "hexahedron20", "hexahedron27"}
"""meshio's names of the supported volume cells."""
LINEAR_SIDE_TYPES = {
    "quad8": ("quad", 4),
    "quad9": ("quad", 4),
    "triangle6": ("triangle", 3),
}
"""Linear type that replaces each type of quadratic side, and its number of corners."""


def read_mesh(path):
    """Return the scikit-fem mesh of a file, with its centre of mass at the origin.

    Raises ValueError if the mesh cannot be used.
    """
    mesh = read_checked(path)[0]
    basis = CellBasis(mesh, mesh.elem())
    x = basis.global_coordinates()
    return mesh.translated(
        tuple(-(np.asarray(x) * basis.dx).sum(axis=(1, 2)) / basis.dx.sum())
    )


class SilencedStream:
    """Stream that discards the output of the current thread and forwards that of other
    threads."""

    def __init__(self, stream):
        self._stream = stream
        self._thread = get_ident()

    def write(self, text: str) -> int:
        """Write text unless called in the silenced thread."""
        return len(text) if get_ident() == self._thread else self._stream.write(text)

    def __getattr__(self, name):
        return getattr(self._stream, name)


def read_checked(path):
    """Return the checked scikit-fem mesh of a file and the points (k, 3) of its node
    sets by name.

    The mesh is not translated."""
    import meshio

    try:
        # meshio prints messages
        with (
            redirect_stdout(SilencedStream(sys.stdout)),
            redirect_stderr(SilencedStream(sys.stderr)),
        ):
            file = meshio.read(path)
    except MemoryError:
        raise
    except (
        Exception,
        SystemExit,
    ) as error:  # readers raise errors of any type for broken files
        reason = (
            ""
            if isinstance(error, SystemExit)
            else f": {error or type(error).__name__}"
        )
        raise ValueError(f"{path}: not a readable mesh{reason}") from error
    cell_types = {block.type for block in file.cells if block.dim == 3}
    if not cell_types:
        raise ValueError(
            f"{path}: no volume cells, only {sorted(file.cells_dict)}; mesh the volume, not just "
            f"its surface",
        )
    if len(cell_types) > 1 or not cell_types <= SUPPORTED_CELLS:
        supported = f"one of {sorted(SUPPORTED_CELLS)}"
        raise ValueError(
            f"{path}: cells {sorted(cell_types)}: all must be of the same type, {supported}",
        )
    for block in file.cells:
        if not np.isin(block.data, np.arange(len(file.points))).all():
            raise ValueError(
                f"{path}: not a readable mesh: a cell has a node number outside 0 to "
                f"{len(file.points) - 1}",
            )
    mesh = from_meshio(with_supported_cells(file))
    check_mesh(mesh, path)
    return mesh, {
        name: file.points[numbers] for name, numbers in (file.point_sets or {}).items()
    }


def with_supported_cells(file):
    """Return the meshio mesh with supported cells.

    Hexahedra with 20 nodes are converted to 27 nodes, and quadratic sides to linear
    ones.
    """
    import meshio

    points = file.points
    cells = []
    for block in file.cells:
        cell_type = block.type
        numbers = block.data
        if cell_type == "hexahedron20":
            cell_type = "hexahedron27"
            points, numbers = hexahedra27_from_20(points, numbers)
        elif cell_type in LINEAR_SIDE_TYPES:
            cell_type, corners = LINEAR_SIDE_TYPES[cell_type]
            numbers = numbers[:, :corners]
        cells.append((cell_type, numbers))
    return meshio.Mesh(
        points,
        cells,
        cell_data=file.cell_data,
        cell_sets=file.cell_sets,
        point_sets=file.point_sets,
        field_data=file.field_data,
    )


def hexahedra27_from_20(points, cells):
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


def check_mesh(mesh, name):
    """Raise ValueError if a mesh cannot be used.

    Reasons are an implausible unit of length, degenerate cells, and several bodies.
    The volumes of the cells are compared at the quadrature points; cells may shrink
    towards an edge.
    """
    min_body_size = 1e-3  # m
    max_body_size = 2.0  # m
    min_volume_ratio = 1e-13  # of the smallest to the median cell
    used = np.unique(mesh.t)
    if not np.isfinite(mesh.p[:, used]).all():
        raise ValueError(f"{name}: some points are not finite")
    size = np.ptp(mesh.p[:, used], axis=1).max()
    if not min_body_size < size < max_body_size:
        raise ValueError(
            f"{name}: its size is {size:g} m; lengths must be in metres; are they in millimetres?",
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


def patch_facets(mesh, support, name=None):
    """Return the facets of a named boundary of the mesh; without a name, those within
    the arc and the height of the patch."""
    if name is not None:
        if name not in (mesh.boundaries or {}):
            raise ValueError(
                f"the mesh has no surface {name!r}, only {sorted(mesh.boundaries or {})}",
            )
        return np.asarray(mesh.boundaries[name])
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
