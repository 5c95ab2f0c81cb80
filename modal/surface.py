"""TABLE -> MODES: `surface_modes(scene)`, by the method that suits the kind of table."""

from math import ceil, pi
from typing import Any

import numpy as np

from modal.accuracy import LEVELS
from modal.elements.elastic import bending_number, mode_count
from modal.modes import UnsolvableError
from modal.one_thread import one_blas_thread
from modal.radiation import SOUND_SPEED
from modal.solve import BELOW, MOST
from modal.spectral.axisymmetric import parities
from modal.spectral.basis import Plate
from modal.spectral.converge import all_pairs, amplitudes
from modal.table import SurfaceModes, splined

SPARE = 16
"""Points of a rule for the radiation beyond those that shapes and paths need."""


@one_blas_thread
def surface_modes(scene: Any, below: float = BELOW) -> SurfaceModes:
    """The elastic `SurfaceModes` below the frequency `below` [Hz] of the table of a scene.

    It reads scene.surface, scene.numerics.accuracy and, but of a plate, scene.disk.radius [m]. None for a table that is
    rigid or infinite. Raises ValueError with a sentence for a mesh that will not do, and UnsolvableError where there
    are more than about MOST modes. tests/test_table_modes.py.
    """
    surface, disk = scene.surface, scene.disk
    level = LEVELS[getattr(getattr(scene, "numerics", None), "accuracy", "standard")]
    if surface.kind == "mesh":
        from modal.elements.table import table_on_mesh  # scikit-fem's input loads slowly

        return table_on_mesh(surface, disk.radius, below, level.table)
    return plate_table(surface, below, level) if surface.kind == "plate" else table_by_modes(surface, disk, below)


def plate_table(surface, below, level):
    """The `SurfaceModes` of a round plate, by the spectral method: shapes are w(r) cos n theta, w(r) sin n theta."""
    plate = Plate(
        radius=surface.radius,
        thickness=surface.thickness,
        material=surface,
        density=surface.density,
        edge=surface.edge,
        ring_radius=surface.ring_radius or 0.0,
        ring_stiffness=surface.ring_stiffness or 0.0,
    )
    count = mode_count(plate, below)
    if count > MOST:
        raise UnsolvableError(
            f"surface: so soft or so large a table has some {count:.0f} modes or more below {below:g} Hz; no more than "
            f"{MOST} can be sought: give it a loss, and take kind = 'infinite'"
        )
    found = all_pairs(plate, below, level.free)
    members = [(pairs, odd) for pairs in found for odd in parities(pairs)]
    frequency = np.concatenate([np.sqrt(p.values) / (2 * pi) for p, _ in members] or [np.zeros(0)])
    ascending = np.argsort(frequency, kind="stable")

    def shape(r, theta):
        r = np.minimum(r, plate.radius) / plate.radius
        distinct, which = np.unique(r.round(12), return_inverse=True)
        parts = [
            (amplitudes(plate, p, distinct, np.ones(1))[2, ..., 0][:, which])
            * (np.sin if odd else np.cos)(p.problem.n * theta)
            for p, odd in members
        ]
        return np.concatenate(parts or [np.zeros((0, len(r)))])[ascending]

    def joined(of_pairs):
        return np.concatenate([of_pairs(p) for p, _ in members] or [np.zeros(0)])[ascending]

    length = 2 * pi / bending_number(plate, below)
    return SurfaceModes(
        frequency=frequency[ascending],
        decay_rate=pi * frequency[ascending] * surface.loss_factor,
        order=joined(lambda p: np.full(len(p.values), p.problem.n)).astype(int),
        **sampled(shape, plate.radius, length, below),
        radius=plate.radius,
        place=np.array(surface.place),
        residual=joined(lambda p: p.residual),
        error=joined(lambda p: p.error.sum(axis=0)),
        mass=plate.mass,
        method="Fourier and polynomials",
        unknowns=sum(len(pairs.vectors) for pairs in found),
    )


def table_by_modes(surface, disk, below):
    """The `SurfaceModes` of a table given by numbers, if by any: w = cos n theta and sin n theta over sqrt(modal mass)
    on the contact circle, which moves with the disk, and r^n inside it. Nothing else is known: the circle alone
    radiates."""
    known, radius = getattr(surface, "modes", ()), disk.radius
    heard = sorted((mode for mode in known if mode.frequency < below), key=lambda mode: mode.frequency)
    given = [mode for mode in heard for _ in range(2 if mode.order else 1)]
    order = np.array([mode.order for mode in given], int)
    odd = np.array([sine for mode in heard for sine in (False, True)[: 2 if mode.order else 1]], bool)
    amplitude = np.array([mode.modal_mass for mode in given]) ** -0.5
    frequency = np.array([mode.frequency for mode in given])

    def shape(r, theta):
        around = np.multiply.outer(order, theta) - pi / 2 * odd[:, None]
        return amplitude[:, None] * (r / radius) ** order[:, None] * np.cos(around)

    return SurfaceModes(
        frequency=frequency,
        decay_rate=np.array([2 * pi * mode.frequency * mode.damping_ratio for mode in given]),
        order=order,
        **sampled(shape, radius, 2 * pi * radius / max(order.max(initial=1), 1), below),
        radius=0.0,
        place=np.zeros(2),
        residual=np.zeros(len(given)),
        error=np.zeros(len(given)),
        mass=0.0,
        method="given by numbers",
        unknowns=0,
    )


def sampled(shape, radius, length, below):
    """The fields points, weights, face, knots and coefficients of shape(r (k,), theta (k,)) -> (m, k) on a round table.

    `length` [m] is that of the shortest wave on it; Gauss points in the radius, even angles.
    """
    waves = radius * 2 * pi * (below / SOUND_SPEED + 1 / length)  # round the rim, of shape and path together
    node, share = np.polynomial.legendre.leggauss(SPARE + ceil(waves / 2))
    theta = np.arange(ceil(waves) + SPARE) * 2 * pi / (ceil(waves) + SPARE)
    r, at = (part.ravel() for part in np.meshgrid(radius * (1 + node) / 2, theta, indexing="ij"))
    corner = np.array([radius, radius])
    knots, coefficients = splined(lambda x, y: shape(np.hypot(x, y), np.arctan2(y, x)), -corner, corner, length)
    return {
        "points": np.column_stack([r * np.cos(at), r * np.sin(at)]),
        "weights": r * np.repeat(radius / 2 * share, len(theta)) * theta[1],
        "face": shape(r, at),
        "knots": knots,
        "coefficients": coefficients,
    }
