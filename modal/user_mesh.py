"""Modes of a body meshed elsewhere: a volume mesh that meshio reads, held on a named surface, by angle, or free.

The axis of the disk is z; the mesh is moved so that its centre of mass is the origin.
"""

from math import pi

import numpy as np
import scipy.sparse as sp
from scipy.interpolate import CloughTocher2DInterpolator, NearestNDInterpolator
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import splu
from skfem import CellBasis, ElementHex1, ElementHex2, ElementTetP1, ElementTetP2, MeshTet1
from skfem.io.meshio import from_meshio

from . import sample
from .elastic import assemble, lame, lowest, residuals
from .modes import Body, Modes
from .unfold import VTK_HEXAHEDRON27, rigid_fields

SUPPORTED = {"tetra", "tetra10", "hexahedron", "hexahedron27"}
LARGEST, SMALLEST = 2.0, 1e-3
"""Diameters [m] beyond which the unit of length is doubted: millimetres read as metres are a thousandfold too large."""
VTK = {
    "tetra": [(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2)],
    "hexahedron": VTK_HEXAHEDRON27[:8],
    "hexahedron27": VTK_HEXAHEDRON27,
}
VTK["tetra10"] = [*VTK["tetra"], (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)]
"""Twice the reference coordinates of the nodes in VTK's order."""


def read_mesh(path):
    """The scikit-fem mesh of a file, checked, its centre of mass at the origin; ValueError if it won't do."""
    import meshio

    file = meshio.read(path)
    kinds = {block.type for block in file.cells if block.dim == 3}
    if not kinds:
        raise ValueError(
            f"{path}: no volume cells, only {sorted(file.cells_dict)}: mesh the volume, not just its surface"
        )
    if len(kinds) > 1 or not kinds <= SUPPORTED:
        raise ValueError(f"{path}: cells {sorted(kinds)}; known is one of {sorted(SUPPORTED)} at a time")
    mesh = from_meshio(file)
    check_mesh(mesh, path)
    basis = CellBasis(mesh, mesh.elem())
    x = basis.global_coordinates()
    return mesh.translated(tuple(-(np.asarray(x) * basis.dx).sum(axis=(1, 2)) / basis.dx.sum()))


def check_mesh(mesh, name):
    """ValueError if the unit of length is implausible, cells are flat or folded, or there are several bodies."""
    used = np.unique(mesh.t)
    size = np.ptp(mesh.p[:, used], axis=1).max()
    if not SMALLEST < size < LARGEST:
        raise ValueError(f"{name}: {size:g} m across: lengths are in metres; were millimetres meant?")
    with np.errstate(divide="ignore", invalid="ignore"):
        volume = mesh.mapping().detDF(CellBasis(mesh, mesh.elem()).X)
    flat = np.abs(volume).min(axis=1) <= 1e-9 * np.median(np.abs(volume))
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


def element_of(mesh, promote):
    """The Lagrange element: quadratic, or if not promoted of the mesh's own degree, for linear ones lock in bending."""
    tet = mesh.t.shape[0] == 4
    if promote or mesh.elem in (ElementTetP2, ElementHex2):
        return ElementTetP2() if tet else ElementHex2()
    return ElementTetP1() if tet else ElementHex1()


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
    inside = np.abs(np.arctan2(y.mean(axis=0), x.mean(axis=0))) < np.deg2rad(support.half_angle_deg)
    z = z.mean(axis=0)
    found = facets[on_rim & inside & (z > bottom) & (z < bottom + height)]
    if not len(found):
        angle = support.half_angle_deg
        raise ValueError(
            f"no facet of the mesh lies on the patch of +-{angle:g} degrees: refine there or name a surface"
        )
    return found


def recovered_error(mesh, element, material, solid, intorder, shape):
    """Relative error of a frequency by Zienkiewicz and Zhu (1992).

    Half the energy of the strain's distance from its continuous projection over the strain energy; shape (p, 3). An
    indication, not a bound: on coarse meshes and at patch edges the projection is nearly as wrong as the strain, and
    the geometry's own error is not in it.
    """
    basis = CellBasis(mesh, element, intorder=intorder)
    cells, lam_mu = basis.element_dofs.T, lame(material)
    grad = np.stack([np.broadcast_to(f[0].grad, (3, *basis.dx.shape)) for f in basis.basis])
    value = np.stack([np.broadcast_to(np.asarray(f[0]), basis.dx.shape) for f in basis.basis])
    tensor = np.einsum("ajeq,eai->eqij", grad, shape[cells])
    strain = (tensor + tensor.swapaxes(2, 3)) / 2
    load = np.einsum("aeq,eqij,eq->eaij", value, strain, basis.dx).reshape(*cells.shape, 9)
    right = np.zeros((len(shape), 9))
    np.add.at(right, cells, load)
    local = np.einsum("aeq,beq,eq->eab", value, value, basis.dx)
    nodes = np.repeat(cells, cells.shape[1], axis=1).ravel(), np.tile(cells, (1, cells.shape[1])).ravel()
    smooth = splu(sp.csc_matrix((local.ravel(), nodes), shape=(len(shape),) * 2)).solve(right)
    gap = strain - np.einsum("aeq,eak->eqk", value, smooth[cells]).reshape(strain.shape)
    energies = [energy(e, basis.dx, *lam_mu) for e in (gap, strain)]
    return energies[0] / energies[1] / 2


def energy(strain, weight, lam, mu):
    """int lam tr(e)^2 + 2 mu e:e over cells, strain (e, q, 3, 3)."""
    trace = np.einsum("eqii->eq", strain)
    return ((lam * trace**2 + 2 * mu * np.einsum("eqij,eqij->eq", strain, strain)) * weight).sum()


def mesh_modes(path, material, density, support, below=24000.0, patch=None, promote=True) -> Modes:
    """The `Modes` below `below` [Hz] of the volume mesh in a file.

    material -- `Material`; density [kg/m^3]; support -- `Support`, whose patch is found by its angle unless `patch`
    names a surface of the mesh (a physical group, a set). Linear cells are given quadratic
    elements unless promote is False.
    ValueError, with a sentence, for a mesh that won't do, an empty patch, or a height or angle no facet lies in.
    """
    mesh = read_mesh(path)
    element, intorder = element_of(mesh, promote), 4
    solid = assemble(mesh, element, material, density, intorder)
    free = np.ones((len(solid.points), 3), bool)
    radius = np.hypot(*solid.points[:, :2].T).max()
    shift = 0.0
    if support.kind == "patch":
        basis = CellBasis(mesh, element, intorder=intorder)
        free[basis.get_dofs(patch_facets(mesh, support, patch)).all()] = False
    else:
        shift = -material.young / density * (0.4 * np.ptp(solid.points[:, 2]) / radius**2) ** 2
    index = np.flatnonzero(free.ravel())
    k, m = solid.stiffness[index][:, index], solid.mass[index][:, index]
    values, vectors = lowest(k, m, (2 * pi * below) ** 2, shift, start=16)
    rigid = np.count_nonzero(values < 1e-6 * abs(shift))
    if rigid != (6 if shift else 0):
        raise ArithmeticError(f"{rigid} rigid-body modes were found, not {6 if shift else 0}")
    values, vectors = values[rigid:], vectors[:, rigid:]
    shapes = np.zeros((len(values), 3 * len(solid.points)))
    shapes[:, index] = vectors.T
    shapes = shapes.reshape(len(values), -1, 3)
    error = [recovered_error(mesh, element, material, solid, intorder, u) for u in shapes]
    return record(element, solid, material, values, shapes, residuals(k, m, values, vectors), error, radius)


def body_of(element, solid, shapes):
    """The `Body` of the mesh, its nodes in VTK's order."""
    where = {tuple(row): i for i, row in enumerate(np.rint(2 * element.doflocs).astype(int))}
    kind = next(kind for kind, nodes in VTK.items() if set(nodes) == set(where))
    cells = solid.cells[:, [where[node] for node in VTK[kind]]]
    return Body(points=solid.points, cells=cells, cell_type=kind, displacement=shapes)


def on_face(solid, shapes, height, points):
    """Displacement (m, n, 3) at points (n, 2) of the face at a height: cubic between nodes, the nearest beyond."""
    nodes = np.flatnonzero(np.abs(solid.points[:, 2] - height) < 1e-3 * np.ptp(solid.points[:, 2]))
    known = shapes[:, nodes].transpose(1, 0, 2).reshape(len(nodes), -1)
    values = CloughTocher2DInterpolator(solid.points[nodes, :2], known)(points)
    outside = np.isnan(values[:, 0])
    values[outside] = NearestNDInterpolator(solid.points[nodes, :2], known)(points[outside])
    return values.reshape(len(points), len(shapes), 3).transpose(1, 0, 2)


def record(element, solid, material, values, shapes, residual, error, radius) -> Modes:
    """The `Modes` of solved pairs: sampled on the bottom edge and the two faces of the disk the mesh stands for."""
    angle, (r, weight, theta) = sample.rim_angles(), sample.face_grid(radius)
    low, high = solid.points[:, 2].min(), solid.points[:, 2].max()
    rim = radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    grid = np.stack([np.outer(r, np.cos(theta)).ravel(), np.outer(r, np.sin(theta)).ravel()], axis=1)
    rim_shape = sample.polar_components(on_face(solid, shapes, low, rim), angle)
    face = [on_face(solid, shapes, z, grid)[..., 2].reshape(-1, len(r), len(theta)) for z in (low, high)]
    flat = shapes.reshape(len(shapes), 3 * len(solid.points))
    axial = (shapes * [0, 0, 1]).reshape(flat.shape)
    share = np.einsum("kp,kp->k", axial, (solid.mass @ axial.T).T)
    frequency = np.sqrt(values) / (2 * pi)
    mirrored = rim_shape[:, -np.arange(len(angle))] * [1, -1, 1]
    odd = (rim_shape * mirrored).sum(axis=(1, 2)) < 0
    return Modes(
        frequency=frequency,
        decay_rate=pi * frequency * material.loss_factor,
        order=sample.strongest_order(rim_shape),
        family=tuple(np.where(share > 0.5, "flexural", "extensional").tolist()),
        parity=tuple(np.where(odd, "odd", "even").tolist()),
        partner=np.full(len(values), -1),
        participation=flat @ (solid.mass @ rigid_fields(solid.points).reshape(6, -1).T),
        rim_angle=angle,
        rim_shape=rim_shape,
        face_radius=r,
        face_weight=weight,
        face_angle=theta,
        face_shape=np.stack(face, axis=1),
        residual=residual,
        error=np.array(error),
        mass=solid.total,
        method="finite elements on the given mesh",
        unknowns=3 * len(solid.points),
        body=body_of(element, solid, shapes),
    )
