"""Modes of a body meshed elsewhere: a volume mesh that meshio reads, held on a named surface, by angle, or free.

The axis of the disk is z; the mesh is moved so that its centre of mass is the origin. It is solved with every cell cut
in eight, and what the mesh as given could not do says how wrong that is.
"""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from math import inf, pi
from pathlib import Path
from types import SimpleNamespace

import numpy as np
from skfem import ElementHex1, ElementHex2, ElementTetP1, ElementTetP2, MeshHex1, MeshHex2, MeshTet1, MeshTet2

from modal.elements.elastic import Solid, assemble, lowest
from modal.elements.given_mesh_error import LEVEL, relative_errors
from modal.elements.given_mesh_modes import record
from modal.elements.mirrors import classes, mirrors
from modal.elements.patch import shift_for
from modal.mesh.read import patch_facets, read_mesh
from modal.mesh.sector import hexahedra
from modal.mesh.symmetry import check_held, free_unknowns
from modal.modes import Material, Modes, Support

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
    finer = hexahedra(nodes, *first)
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


def pairs(level, components, below, shift):
    """Ascending values (k,), shapes (k, p, 3), residuals (k,) of the elastic pairs below `below` [Hz].

    The symmetry classes of the mesh are solved apart, two at a time, as for a disk on a patch. ArithmeticError unless
    a free body has exactly six rigid-body modes, a held one none.
    """
    solid = level.solid

    def of_class(basis):
        k, m = (basis.T @ matrix @ basis for matrix in (solid.stiffness, solid.mass))
        values, vectors, residual = lowest(k, m, (2 * pi * below) ** 2, shift, start=16)
        return values, (basis @ vectors).T, residual

    bases = classes(level, free_unknowns(solid.points, level.held, components))
    with ThreadPoolExecutor(2) as pool:
        values, shapes, residual = map(np.concatenate, zip(*pool.map(of_class, bases), strict=True))
    rigid = np.count_nonzero(values < 1e-6 * abs(shift))
    if rigid != (6 if shift else 0):
        raise ArithmeticError(f"{rigid} rigid-body modes were found, not {6 if shift else 0}")
    elastic = np.argsort(values, kind="stable")[rigid:]
    return values[elastic], shapes[elastic].reshape(-1, len(solid.points), 3), residual[elastic]


def solved(mesh, facets, components, material, density, below, most, ends):
    """The `Level` of quadratic elements that is solved, with its `pairs` and their `relative_errors`: values, shapes,
    residuals, errors.

    Every cell is cut in eight, unless a symmetry class would then have more than `most` unknowns: then the mesh is
    solved as given, and the errors are told by what linear elements could not do. Facets hold components, none a free
    body. ValueError where they leave it free to move. `ends` as in `relative_errors`.
    """
    linear, quadratic = elements(mesh)
    whole = [quadratic.doflocs.T]
    finer = coarse = level(mesh, facets, quadratic, whole, material, density)
    if len(facets):
        check_held(coarse.solid.points[coarse.held], components)
    cut = 8 * 3 * len(coarse.solid.points) <= most * 2 ** len(mirrors(coarse))
    places = parts(quadratic) if cut else whole
    if cut:
        finer = level(mesh, facets, quadratic, places, material, density)
    else:
        coarse = level(mesh, facets, linear, whole, material, density)
    size = np.ptp(finer.solid.points, axis=0)
    body = SimpleNamespace(radius=size.max() / 2, thickness=size[2], material=material, density=density)
    shift = 0.0 if len(facets) else shift_for(body, Support(kind="free"))
    values, shapes, residual = pairs(finer, components, below, shift)
    error = relative_errors(mesh, facets, finer, coarse, places, values, shapes, shift, ends)
    return finer, values, shapes, residual, error


def mesh_modes(
    path: str | Path,
    material: Material,
    density: float,
    support: Support,
    below: float = 24000.0,
    patch: str | None = None,
    refine: bool = True,
) -> Modes:
    """The `Modes` below `below` [Hz] of the volume mesh in a file; empty if it has none there.

    material -- `Material`; density [kg/m^3]; support -- `Support`, whose patch is found by its angle unless `patch`
    names a surface of the mesh (a physical group, a set). Elements are quadratic. `error` is of the body as meshed:
    what straight sides cut off a round one is not in it. The mesh with every cell cut in eight has eight times the
    unknowns, some 20 to 50 times the seconds; without `refine` it is solved as given, and `error` is told by what
    linear elements could not do, far too large where nothing is singular. ValueError, with a sentence, for a mesh that
    won't do, an empty patch, a height or angle no facet lies in, or held components that leave the body free to move.
    """
    mesh = read_mesh(path)
    facets = np.zeros(0, int) if support.kind == "free" else patch_facets(mesh, support, patch)
    most = inf if refine else 0
    finer, *found = solved(mesh, facets, support.held, material, density, below, most, LEVEL)
    return record(finer.element, finer.solid, material, *found, np.hypot(*finer.solid.points[:, :2].T).max())
