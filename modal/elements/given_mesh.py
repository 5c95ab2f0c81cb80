"""Modes of a body meshed elsewhere: a volume mesh that meshio reads, held on a named surface, by angle, or free.

The axis of the disk is z; the mesh is moved so that its centre of mass is the origin. The mesh is solved as given and
with every cell cut in eight: the finer frequencies are given, their distance from the coarser says how wrong they are.
"""

from dataclasses import dataclass
from math import pi
from pathlib import Path
from types import SimpleNamespace

import numpy as np
from skfem import ElementHex1, ElementHex2, ElementTetP1, ElementTetP2, MeshHex1, MeshHex2, MeshTet1, MeshTet2

from modal.elements.elastic import Solid, assemble, lowest
from modal.elements.given_mesh_modes import record
from modal.elements.mirrors import lowest_of_classes
from modal.elements.patch import shift_for
from modal.mesh.read import patch_facets, read_mesh
from modal.mesh.sector import joined
from modal.mesh.symmetry import check_held, free_unknowns
from modal.modes import Material, Modes, Support

SAFETY = 1.5
"""Errors are estimated as so many times that distance: where a patch ends, cutting cells no more than halves them."""
SPARE = 6
"""Pairs solved beyond a count asked for: Lanczos's method finds the copies of a multiple eigenvalue late."""
TETRAHEDRA = [(0, 4, 6, 7), (4, 1, 5, 8), (6, 5, 2, 9), (7, 8, 9, 3)]
TETRAHEDRA += [(4, 5, 6, 8), (4, 6, 7, 8), (5, 6, 8, 9), (6, 7, 8, 9)]
"""The eight parts of a tetrahedron by its corners and the middles of its edges."""


@dataclass(frozen=True, kw_only=True)
class Level:
    """A mesh of quadratic geometry, which nodes (p,) of its element are held, and its `Solid`."""

    solid: Solid
    element: object
    held: np.ndarray


def elements(mesh):
    """The linear and the quadratic Lagrange element of the mesh's cells."""
    return (ElementTetP1(), ElementTetP2()) if mesh.t.shape[0] == 4 else (ElementHex1(), ElementHex2())


def parts(element):
    """Reference coordinates (8, 3, n) of the nodes of the eight parts of the reference cell of an element."""
    places = element.doflocs
    if len(places) == 27:
        return (places + np.array(list(np.ndindex(2, 2, 2)))[:, None]).transpose(0, 2, 1) / 2
    corners = places[np.array(TETRAHEDRA)]
    shares = np.column_stack([1 - places.sum(axis=1), places])
    return np.einsum("nk,tkx->txn", shares, corners)


def level(mesh, facets, element, places, material, density) -> Level:
    """The `Level` whose cells are the parts of the mesh's cells at reference coordinates places (q, 3, n).

    Linear elements are given straight sides: on curved ones they would resist rotations of the body.
    """
    nodes = np.concatenate([mesh.mapping().F(x).transpose(1, 2, 0) for x in places])
    first = (MeshTet1, MeshTet2) if mesh.t.shape[0] == 4 else (MeshHex1, MeshHex2)
    finer = joined(nodes, *first)
    if len(element.doflocs) == len(finer.t):
        finer = first[0](finer.doflocs[:, : finer.t.max() + 1], finer.t)
    solid = assemble(finer, element, material, density, intorder=4)
    count = solid.cells.shape[1]
    held = np.zeros(len(solid.points), bool)
    held[solid.cells[np.concatenate([on_facets(mesh, facets, x) for x in places])[:, :count]]] = True
    return Level(solid=solid, element=element, held=held)


def on_facets(mesh, facets, places):
    """Which nodes (c, n) at reference coordinates places (3, n) of every cell lie on facets of the mesh."""
    cell = mesh.elem.refdom
    planes = [cell.p[:, list(corners)[:3]] for corners in cell.facets]
    normals = [np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]) for p in planes]
    on = np.array([np.abs(n @ (places - p[:, :1])) < 1e-9 for n, p in zip(normals, planes, strict=True)])
    return (np.isin(mesh.t2f, facets).T.astype(int) @ on) > 0


def pairs(level, components, below, shift, exactly=None, mirrored=False):
    """Values (k,), shapes (k, p, 3), residuals (k,) of the elastic pairs below `below` [Hz], or of exactly so many;
    `mirrored` solves the symmetry classes of the mesh, if it has any, apart.

    ArithmeticError unless a free body has exactly six rigid-body modes, a held one none.
    """
    solid = level.solid
    free = free_unknowns(solid.points, level.held, components)
    limit = (2 * pi * below) ** 2
    if mirrored:
        values, vectors, residual = lowest_of_classes(level, free, limit, shift)
    else:
        k, m = free.T @ solid.stiffness @ free, free.T @ solid.mass @ free
        values, vectors, residual = lowest(k, m, limit, shift, start=16, exactly=exactly and exactly + SPARE)
        values, vectors, residual = values[:exactly], free @ vectors[:, :exactly], residual[:exactly]
    rigid = np.count_nonzero(values < 1e-6 * abs(shift))
    if rigid != (6 if shift else 0):
        raise ArithmeticError(f"{rigid} rigid-body modes were found, not {6 if shift else 0}")
    shapes = vectors.T.reshape(len(values), len(solid.points), 3)
    return values[rigid:], shapes[rigid:], residual[rigid:]


def mesh_modes(
    path: str | Path,
    material: Material,
    density: float,
    support: Support,
    below: float = 24000.0,
    patch: str | None = None,
    promote: bool = True,
    refine: bool = True,
) -> Modes:
    """The `Modes` below `below` [Hz] of the volume mesh in a file; empty if it has none there.

    material -- `Material`; density [kg/m^3]; support -- `Support`, whose patch is found by its angle unless `patch`
    names a surface of the mesh (a physical group, a set). Linear cells are given quadratic elements unless promote is
    False. `error` is of the body as meshed: what straight sides cut off a round one is not in it. The finer mesh has
    eight times the unknowns, some 20 to 50 times the seconds; without `refine` the mesh is solved as given, and
    `error` is the distance between linear and quadratic elements, far too large where nothing is singular.
    ValueError, with a sentence, for a mesh that won't do, an empty patch, a height or angle no facet lies in, or held
    components that leave the body free to move.
    """
    mesh = read_mesh(path)
    free = support.kind == "free"
    facets = np.zeros(0, int) if free else patch_facets(mesh, support, patch)
    linear, quadratic = elements(mesh)
    element = quadratic if promote or mesh.elem is type(quadratic) else linear
    other = element if refine else linear if element is quadratic else quadratic
    whole = [quadratic.doflocs.T]
    finer = level(mesh, facets, element, parts(quadratic) if refine else whole, material, density)
    coarse = level(mesh, facets, other, whole, material, density)
    radius = np.hypot(*finer.solid.points[:, :2].T).max()
    thickness = np.ptp(finer.solid.points[:, 2])
    disk = SimpleNamespace(radius=radius, thickness=thickness)
    shift = shift_for(disk, material, support, density)
    if not free:
        check_held(finer.solid.points[finer.held], support.held)
    values, shapes, residual = pairs(finer, support.held, below, shift)
    rough = pairs(coarse, support.held, below, shift, exactly=max(1, len(values)) + 6 * free)[0][: len(values)]
    error = SAFETY * np.abs(np.sqrt(rough / values) - 1)
    return record(finer.element, finer.solid, material, values, shapes, residual, error, radius)
