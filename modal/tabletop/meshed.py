"""Compute the modes of a table on a user's mesh, held on named surfaces or sets of
nodes."""

import os
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import lru_cache
from math import ceil, pi
from typing import TYPE_CHECKING, Any, TypedDict

import numpy as np
from skfem.quadrature import get_quadrature
from skfem.refdom import RefTri

from modal.elements.elastic import bending_wave_number
from modal.elements.user_mesh import solve_body
from modal.elements.user_mesh_error import CORNER_EXTRAPOLATION_FACTOR
from modal.elements.user_mesh_modes import interpolate_on_face
from modal.mesh.read import MAX_TABLE_SIZE, read_checked
from modal.mesh.symmetry import COMPONENTS
from modal.modes import Material
from modal.radiation import SOUND_SPEED
from modal.tabletop.record import SurfaceModes, fit_splines, spline_values

if TYPE_CHECKING:
    from skfem import Mesh


class SampledFace(TypedDict):
    """Fields of `SurfaceModes` that follow from the shapes on the top face."""

    points: np.ndarray
    weights: np.ndarray
    face: np.ndarray
    knots: tuple[np.ndarray, np.ndarray]
    coefficients: np.ndarray


def table_on_mesh(
    surface: Any, contact_radius: float, below: float, max_unknowns: int
) -> SurfaceModes:
    """Return the `SurfaceModes` below a frequency [Hz] of the mesh in `surface.file`.

    The contact circle has the radius `contact_radius` [m]. Every cell is divided into
    eight unless a symmetry class would then have more than `max_unknowns` unknowns; in
    that case `error` is far too high. Raises ValueError if the mesh has no top face, if
    the disk is not on this face, or if a set is unknown or consists of single nodes.
    """
    mesh = read_checked(surface.file, MAX_TABLE_SIZE)
    top = top_face_triangles(mesh, surface.file)
    check_place(top, np.array(surface.place), contact_radius, surface.file)
    found = undamped_mesh_modes(
        surface.file,
        os.stat(surface.file).st_mtime_ns,
        Material(young=surface.young, poisson=surface.poisson),
        surface.density,
        tuple(surface.held),
        below,
        max_unknowns,
    )
    return replace(
        found,
        decay_rate=pi * found.frequency * surface.loss_factor,
        place=np.array(surface.place),
    )


@lru_cache(1)
def undamped_mesh_modes(
    file: str,
    modified: int,
    material: Material,
    density: float,
    held: tuple[str, ...],
    below: float,
    max_unknowns: int,
) -> SurfaceModes:
    """Return the undamped `SurfaceModes` of a mesh, with the disk at the origin.

    The result for the last mesh is cached, because successive tables may differ only in
    the position of the disk and the loss factor. `modified` is the time of the last
    change of the file [ns].
    """
    mesh = read_checked(file, MAX_TABLE_SIZE)
    top = top_face_triangles(mesh, file)
    facets = held_facets(mesh, held, file)
    solved = solve_body(
        mesh,
        facets,
        COMPONENTS,
        material,
        density,
        below,
        max_unknowns,
        CORNER_EXTRAPOLATION_FACTOR,
    )
    solid = solved.body.solid
    shapes = solved.shapes
    frequency = np.sqrt(solved.values) / (2 * pi)
    top_height = mesh.p[2].max()
    wave_number = bending_wave_number(material, np.ptp(mesh.p[2]), density, below)

    def shape(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        points = np.column_stack([x, y])
        return interpolate_on_face(solid, shapes[..., 2:], top_height, points)[..., 0]

    return SurfaceModes(
        frequency=frequency,
        decay_rate=np.zeros(len(frequency)),
        order=np.full(len(frequency), -1),
        **sample_top_face(shape, top, 2 * pi / wave_number, below),
        radius=0.0,
        place=np.zeros(2),
        residual=solved.residual,
        error=solved.error,
        mass=solid.total_mass,
        method="finite elements on the given mesh"
        + ", each cell divided into eight" * solved.divided,
        unknowns=3 * len(solid.points),
    )


def top_face_triangles(mesh: "Mesh", name: str) -> np.ndarray:
    """Return the top face as triangles (k, 3, 2) [m]; raises ValueError if there is
    none.

    Its facets lie at the greatest height, up to round-off.
    """
    tolerance = 1e-6  # relative to the size of the mesh
    facets = mesh.facets[:, mesh.boundary_facets()]
    height = mesh.p[2]
    is_high = height[facets] > height.max() - tolerance * np.ptp(mesh.p, axis=1).max()
    found = facets[:, is_high.all(axis=0)]
    if not found.size:
        raise ValueError(
            f"surface.file = {name!r}: no level face at its greatest height, {height.max():g} m; "
            f"z must point upwards",
        )
    corners = mesh.p[:2, found].T
    return np.concatenate(
        [corners[:, [0, i, i + 1]] for i in range(1, corners.shape[1] - 1)]
    )


def check_place(
    top: np.ndarray, place: np.ndarray, contact_radius: float, name: str
) -> None:
    """Raise ValueError if centre or contact circle of a disk at a place (2,) [m] are
    not on the top face."""
    angle = np.linspace(0, 2 * pi, 33)
    unit_circle = np.column_stack(
        [np.append(np.cos(angle), 0), np.append(np.sin(angle), 0)]
    )
    if not on_top_face(top, place + contact_radius * unit_circle).all():
        low = top.min(axis=(0, 1))
        high = top.max(axis=(0, 1))
        raise ValueError(
            f"surface.place = {place.tolist()}: a disk of radius {contact_radius:g} m at this "
            f"place is not on the top face of {name!r}, which extends from "
            f"{low[0]:g} to {high[0]:g} m in x, "
            f"{low[1]:g} to {high[1]:g} m in y; z must point upwards"
        )


def on_top_face(top: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return the mask (k,) of points (k, 2) [m] on the triangles of a top face (t, 3,
    2)."""
    sides = []
    for i in range(3):
        start = top[:, i - 1]
        sides.append(cross_product(top[:, i] - start, points[:, None] - start))
    first = top[:, 1] - top[:, 0]
    second = top[:, 2] - top[:, 0]
    orientation = np.sign(cross_product(first, second))
    return (np.array(sides) * orientation > -1e-12).all(axis=0).any(axis=1)


def cross_product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return the cross product (...,) of plane vectors (..., 2)."""
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def held_facets(mesh: "Mesh", names: Sequence[str], file: str) -> np.ndarray:
    """Return the facets (k,) of the named surfaces or sets of nodes."""
    known = mesh.boundaries or {}
    for name in names:
        if name not in known:
            raise ValueError(
                f"surface.held = {list(names)}: {file!r} has no {name!r}, only {sorted(known)}",
            )
        if not len(known[name]):
            raise ValueError(
                f"surface.held: {name!r} of {file!r} contains no complete facet; "
                f"single nodes cannot hold a solid",
            )
    return np.unique(
        np.concatenate([known[name] for name in names] or [np.zeros(0)])
    ).astype(int)


def sample_top_face(
    shape: Callable[[np.ndarray, np.ndarray], np.ndarray],
    top: np.ndarray,
    shortest_wave: float,
    below: float,
) -> SampledFace:
    """Return points, weights, face, knots and coefficients of `SurfaceModes` for a
    triangulated face.

    The function shape(x (k,), y (k,)) -> (m, k) returns the mode shapes, and
    `shortest_wave` [m] is their shortest wavelength. The quadrature is exact for
    polynomials of an order that exceeds the change of phase [rad] of a sound wave across
    a triangle; this order is limited. Between the nodes, the splines are as accurate as
    nodal interpolation.
    """
    max_quadrature_order = 19
    spare_quadrature_orders = 6
    longest_side = np.linalg.norm(top - np.roll(top, 1, axis=1), axis=2).max()
    order = min(
        max_quadrature_order,
        spare_quadrature_orders + ceil(2 * pi * below / SOUND_SPEED * longest_side),
    )
    (u, v), share = get_quadrature(RefTri, order)
    first = top[:, 1] - top[:, 0]
    second = top[:, 2] - top[:, 0]
    points = top[:, :1] + u[:, None] * first[:, None] + v[:, None] * second[:, None]
    points = points.reshape(-1, 2)
    weights = np.abs(cross_product(first, second))[:, None] * share
    knots, coefficients = fit_splines(
        shape,
        top.min(axis=(0, 1)),
        top.max(axis=(0, 1)),
        shortest_wave,
    )
    return {
        "points": points,
        "weights": weights.ravel(),
        "face": spline_values(knots, coefficients, *points.T).T,
        "knots": knots,
        "coefficients": coefficients,
    }
