"""Compute the elastic modes of a table by the method appropriate to its kind."""

from collections.abc import Callable
from math import ceil, pi
from typing import Any

import numpy as np

from modal.accuracy import ACCURACY_LEVELS, ModesAccuracyLevel
from modal.blas_threads import one_blas_thread
from modal.elements.elastic import bending_wave_number, estimated_mode_count
from modal.modes import DEFAULT_HIGHEST_FREQUENCY, UnsolvableError
from modal.radiation import SOUND_SPEED
from modal.solve import MAX_MODE_COUNT
from modal.spectral.axisymmetric import sine_partner_flags
from modal.spectral.basis import Plate
from modal.spectral.p_refinement import (
    Eigenpairs,
    all_eigenpairs,
    displacement_amplitudes,
)
from modal.tabletop.record import SurfaceModes, fit_round_shapes, fit_splines


@one_blas_thread
def surface_modes(scene: Any, below: float = DEFAULT_HIGHEST_FREQUENCY) -> SurfaceModes:
    """Compute the elastic modes of the table of a scene.

    Parameters
    ----------
    scene : Scene
        Scene with the sections surface and numerics and, unless the table is a plate,
        disk.radius [m].
    below : float, optional
        Exclusive upper limit of the frequencies [Hz].

    Returns
    -------
    SurfaceModes
        Modes of the table; none if it is rigid or infinite.

    Raises
    ------
    ValueError
        If the mesh of the table cannot be used.
    UnsolvableError
        If there are more than about 600 modes.

    Examples
    --------
    >>> from sonify import load_scene
    >>> len(surface_modes(load_scene("published")))
    0
    """
    surface = scene.surface
    disk = scene.disk
    level = ACCURACY_LEVELS[scene.numerics.accuracy]
    if surface.kind == "mesh":
        # slow import of mesh input
        from modal.tabletop.meshed import table_on_mesh

        return table_on_mesh(surface, disk.radius, below, level.max_table_unknowns)
    if surface.kind == "plate":
        return round_plate_modes(surface, below, level)
    return table_modes_listed_in_scene(surface, disk, below)


def round_plate_modes(
    surface: Any, below: float, level: ModesAccuracyLevel
) -> SurfaceModes:
    """Return the `SurfaceModes` of a round plate, computed by the Ritz method.

    The shapes are w(r) cos n theta and w(r) sin n theta.
    """
    plate = Plate(
        radius=surface.radius,
        thickness=surface.thickness,
        material=surface,
        density=surface.density,
        edge=surface.edge,
        ring_radius=surface.ring_radius or 0.0,
        ring_stiffness=surface.ring_stiffness or 0.0,
    )
    count = estimated_mode_count(plate, below)
    if count > MAX_MODE_COUNT:
        raise UnsolvableError(
            f"surface: such a soft or large table has at least about {count:.0f} modes "
            f"below {below:g} Hz, but at most {MAX_MODE_COUNT} can be computed; "
            "use kind = 'infinite' with a loss factor"
        )
    found = all_eigenpairs(plate, below, level.free_error)
    members = [(pairs, odd) for pairs in found for odd in sine_partner_flags(pairs)]
    frequency = np.concatenate(
        [np.sqrt(p.values) / (2 * pi) for p, _ in members] or [np.zeros(0)]
    )
    ascending = np.argsort(frequency, kind="stable")

    def profile(rho: np.ndarray) -> np.ndarray:
        parts = [
            displacement_amplitudes(pairs, rho, np.ones(1))[2, ..., 0]
            for pairs, _ in members
        ]
        return np.concatenate(parts or [np.zeros((0, len(rho)))])[ascending]

    def sorted_values(
        values_of_pairs: Callable[[Eigenpairs], np.ndarray],
    ) -> np.ndarray:
        return np.concatenate(
            [values_of_pairs(p) for p, _ in members] or [np.zeros(0)]
        )[ascending]

    order = sorted_values(lambda p: np.full(len(p.values), p.problem.n)).astype(int)
    odd_members = [np.full(len(pairs.values), odd) for pairs, odd in members]
    is_sine = np.concatenate(odd_members or [np.zeros(0, bool)])[ascending]

    def shape(r: np.ndarray, theta: np.ndarray) -> np.ndarray:
        distinct, position = np.unique(
            (r / plate.radius).round(12), return_inverse=True
        )
        turn = np.multiply.outer(order, theta) - pi / 2 * is_sine[:, None]
        return profile(distinct)[:, position] * np.cos(turn)

    shortest_wave = (
        2 * pi / bending_wave_number(surface, plate.thickness, plate.density, below)
    )
    return SurfaceModes(
        frequency=frequency[ascending],
        decay_rate=pi * frequency[ascending] * surface.loss_factor,
        order=order,
        **sample_face(shape, plate.radius, shortest_wave, below),
        knots=(np.zeros(0), np.zeros(0)),
        coefficients=np.zeros((0, 0, len(order))),
        round_shapes=fit_round_shapes(
            profile, plate.radius, shortest_wave, order, is_sine
        ),
        radius=plate.radius,
        place=np.array(surface.place),
        residual=sorted_values(lambda p: p.residual),
        error=sorted_values(lambda p: p.error.sum(axis=0)),
        mass=plate.mass,
        method="Fourier and polynomials",
        unknowns=sum(len(pairs.vectors) for pairs in found),
    )


def table_modes_listed_in_scene(surface: Any, disk: Any, below: float) -> SurfaceModes:
    """Return the `SurfaceModes` specified in the scene, or no modes for other kinds of
    table.

    The shapes are r^n cos n theta and r^n sin n theta divided by sqrt(modal mass), with
    r = 1 at the radius of the disk, and move with the disk. Only the area of the circle
    radiates, because the shapes outside it are unknown.
    """
    known = surface.modes if surface.kind == "modes" else ()
    radius = disk.radius
    kept = sorted(
        (mode for mode in known if mode.frequency < below),
        key=lambda mode: mode.frequency,
    )
    members = []
    for mode in kept:
        members.append((mode, False))
        if mode.order:
            members.append((mode, True))
    order = np.array([mode.order for mode, _ in members], int)
    odd = np.array([is_odd for _, is_odd in members], bool)
    amplitude = np.array([mode.modal_mass for mode, _ in members]) ** -0.5

    def shape(r: np.ndarray, theta: np.ndarray) -> np.ndarray:
        phase = np.multiply.outer(order, theta) - pi / 2 * odd[:, None]
        return amplitude[:, None] * (r / radius) ** order[:, None] * np.cos(phase)

    def shape_at(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return shape(np.hypot(x, y), np.arctan2(y, x))

    shortest_wave = 2 * pi * radius / max(order.max(initial=1), 1)
    corner = np.array([radius, radius])
    knots, coefficients = fit_splines(shape_at, -corner, corner, shortest_wave)
    return SurfaceModes(
        frequency=np.array([mode.frequency for mode, _ in members]),
        decay_rate=np.array(
            [2 * pi * mode.frequency * mode.damping_ratio for mode, _ in members]
        ),
        order=order,
        **sample_face(shape, radius, shortest_wave, below),
        knots=knots,
        coefficients=coefficients,
        radius=0.0,
        place=np.zeros(2),
        residual=np.zeros(len(members)),
        error=np.zeros(len(members)),
        mass=0.0,
        method="given by numbers",
        unknowns=0,
    )


def sample_face(
    shape: Callable[[np.ndarray, np.ndarray], np.ndarray],
    radius: float,
    shortest_wave: float,
    below: float,
) -> dict[str, Any]:
    """Return points, weights and face of `SurfaceModes` for a round table.

    The function shape(r (k,), theta (k,)) -> (m, k) returns the mode shapes, and
    `shortest_wave` [m] is their shortest wavelength. The points are Gauss points in the
    radius and equally spaced angles, with a few points more than required by shapes and
    sound paths.
    """
    spare_points = 16
    # of the product of shape and sound path
    waves_around_rim = radius * 2 * pi * (below / SOUND_SPEED + 1 / shortest_wave)
    node, share = np.polynomial.legendre.leggauss(
        spare_points + ceil(waves_around_rim / 2)
    )
    angle_count = ceil(waves_around_rim) + spare_points
    theta = np.arange(angle_count) * 2 * pi / angle_count
    r, angle = (
        grid.ravel()
        for grid in np.meshgrid(radius * (1 + node) / 2, theta, indexing="ij")
    )
    return {
        "points": np.column_stack([r * np.cos(angle), r * np.sin(angle)]),
        "weights": r * np.repeat(radius / 2 * share, len(theta)) * theta[1],
        "face": shape(r, angle),
    }
