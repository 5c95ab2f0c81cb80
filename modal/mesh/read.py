"""Volume meshes made elsewhere, as meshio reads them: brought to a scikit-fem mesh, or refused with a reason."""

import sys
from contextlib import redirect_stderr, redirect_stdout
from threading import get_ident

import numpy as np
import scipy.sparse as sp
from scipy.sparse.csgraph import connected_components
from skfem import CellBasis, MeshTet1
from skfem.io.meshio import from_meshio

from modal.mesh.hexahedron import VTK_HEXAHEDRON27

SUPPORTED = {"tetra", "tetra10", "hexahedron", "hexahedron20", "hexahedron27"}
LARGEST, SMALLEST = 2.0, 1e-3
"""Diameters [m] beyond which the unit of length is doubted: millimetres read as metres are a thousandfold too large."""
FLAT = 1e-13
"""Least volume over that of the median cell, both where they are integrated: cells may shrink towards an edge."""
SIDES = {"quad8": ("quad", 4), "quad9": ("quad", 4), "triangle6": ("triangle", 3)}
"""Sides with nodes in the middle of their edges -> what they are without, and their corners."""


def read_mesh(path):
    """The scikit-fem mesh of a file, checked, its centre of mass at the origin; ValueError if it won't do."""
    mesh = read_checked(path)[0]
    basis = CellBasis(mesh, mesh.elem())
    x = basis.global_coordinates()
    return mesh.translated(tuple(-(np.asarray(x) * basis.dx).sum(axis=(1, 2)) / basis.dx.sum()))


class Hushed:
    """A stream without what this thread writes; what others write goes on."""

    def __init__(self, stream):
        self._stream, self._thread = stream, get_ident()

    def write(self, text: str) -> int:
        """Write, if this is another thread."""
        return len(text) if get_ident() == self._thread else self._stream.write(text)

    def __getattr__(self, name):
        return getattr(self._stream, name)


def read_checked(path):
    """The scikit-fem mesh of a file where it stands, checked, and the points (k, 3) of its sets of nodes by name."""
    import meshio

    try:
        with redirect_stdout(Hushed(sys.stdout)), redirect_stderr(Hushed(sys.stderr)):  # meshio tells lines of its own
            file = meshio.read(path)
    except MemoryError:
        raise
    except (Exception, SystemExit) as error:  # a broken file makes its readers give up in any way
        why = "" if isinstance(error, SystemExit) else f", {error or type(error).__name__}"
        raise ValueError(f"{path}: no mesh that can be read{why}") from error
    kinds = {block.type for block in file.cells if block.dim == 3}
    if not kinds:
        raise ValueError(
            f"{path}: no volume cells, only {sorted(file.cells_dict)}: mesh the volume, not just its surface"
        )
    if len(kinds) > 1 or not kinds <= SUPPORTED:
        raise ValueError(f"{path}: cells {sorted(kinds)}; known is one of {sorted(SUPPORTED)} at a time")
    for block in file.cells:
        if not np.isin(block.data, np.arange(len(file.points))).all():
            raise ValueError(f"{path}: no mesh that can be read, a cell has a node that is none of {len(file.points)}")
    mesh = from_meshio(understood(file))
    check_mesh(mesh, path)
    return mesh, {name: file.points[numbers] for name, numbers in (file.point_sets or {}).items()}


def understood(file):
    """The meshio mesh with 27-node hexahedra for those of 20 nodes, and its sides by their corners alone."""
    import meshio

    points, cells = file.points, []
    for block in file.cells:
        kind, numbers = block.type, block.data
        if kind == "hexahedron20":
            kind, (points, numbers) = "hexahedron27", completed(points, numbers)
        elif kind in SIDES:
            kind, corners = SIDES[kind]
            numbers = numbers[:, :corners]
        cells.append((kind, numbers))
    kept = {name: getattr(file, name) for name in ("cell_data", "cell_sets", "point_sets", "field_data")}
    return meshio.Mesh(points, cells, **kept)


def completed(points, cells):
    """Points (p, 3) and cells (c, 27) from cells (c, 20): in the middles of faces and cells their 20 functions' values.

    In the middle of a face they are -1/4 at its corners, 1/2 on its edges; in that of the cell -1/4 and 1/4.
    """
    lattice = np.array(VTK_HEXAHEDRON27)
    sides = [np.flatnonzero((lattice[:20] == place)[:, place != 1].all(axis=1)) for place in lattice[20:26]]
    faces = cells[:, sides].reshape(-1, 8)
    _, first, face = np.unique(np.sort(faces[:, :4], axis=1), axis=0, return_index=True, return_inverse=True)
    on_faces = np.einsum("n,cnx->cx", [-1 / 4] * 4 + [1 / 2] * 4, points[faces[first]])
    inside = np.einsum("n,cnx->cx", [-1 / 4] * 8 + [1 / 4] * 12, points[cells])
    numbers = len(points) + face.reshape(-1, 6), len(points) + len(first) + np.arange(len(cells))[:, None]
    return np.vstack([points, on_faces, inside]), np.hstack([cells, *numbers])


def check_mesh(mesh, name):
    """ValueError if the unit of length is implausible, cells are flat or folded, or there are several bodies."""
    used = np.unique(mesh.t)
    if not np.isfinite(mesh.p[:, used]).all():
        raise ValueError(f"{name}: points that are not finite")
    size = np.ptp(mesh.p[:, used], axis=1).max()
    if not SMALLEST < size < LARGEST:
        raise ValueError(f"{name}: {size:g} m across: lengths are in metres; were millimetres meant?")
    with np.errstate(divide="ignore", invalid="ignore"):
        volume = mesh.mapping().detDF(CellBasis(mesh, mesh.elem()).X)
    flat = np.abs(volume).min(axis=1) <= FLAT * np.median(np.abs(volume))
    folded = (volume > 0).any(axis=1) & (volume < 0).any(axis=1)
    signs = np.sign(volume.mean(axis=1)) if not isinstance(mesh, MeshTet1) else np.ones(1)
    for what, bad in (("flat or folded", flat | folded), ("numbered inside out", signs != np.sign(signs.sum() or 1))):
        if bad.any():
            raise ValueError(f"{name}: {bad.sum()} of {mesh.nelements} cells are {what}, the first is {bad.argmax()}")
    corners = mesh.t
    pairs = np.concatenate([corners[[0, i]] for i in range(1, len(corners))], axis=1)
    graph = sp.coo_matrix((np.ones(pairs.shape[1]), pairs), shape=(mesh.p.shape[1],) * 2)
    bodies = len(np.unique(connected_components(graph, directed=False)[1][used]))
    if bodies > 1:
        raise ValueError(f"{name}: {bodies} bodies that share no node: merge them or mesh one")


def patch_facets(mesh, support, name=None):
    """Facets of the patch: a named boundary of the mesh, or those of the lateral surface within angle and height."""
    if name is not None:
        if name not in (mesh.boundaries or {}):
            raise ValueError(f"the mesh has no surface {name!r}, only {sorted(mesh.boundaries or {})}")
        return np.asarray(mesh.boundaries[name])
    radius = np.hypot(*mesh.p[:2]).max()
    facets = mesh.boundary_facets()
    x, y, z = mesh.p[:, mesh.facets[:, facets]]
    low, high = mesh.p[2].min(), mesh.p[2].max()
    height = support.height or high - low
    bottom = low if support.position == "bottom" else (low + high - height) / 2
    on_rim = (np.hypot(x, y) > 0.99 * radius).all(axis=0) & (np.ptp(z, axis=0) > 1e-6 * radius)
    inside = np.abs(np.arctan2(y.mean(axis=0), x.mean(axis=0))) <= np.deg2rad(support.half_angle_deg) + 1e-9
    z = z.mean(axis=0)
    found = facets[on_rim & inside & (z > bottom) & (z < bottom + height)]
    if not len(found):
        angle = support.half_angle_deg
        raise ValueError(
            f"no facet of the mesh lies on the patch of +-{angle:g} degrees: refine there or name a surface"
        )
    return found
