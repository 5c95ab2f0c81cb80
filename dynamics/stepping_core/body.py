"""The rigid disk of both time-steppers: constants, start, energy and COLUMNS."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from dynamics.disk import GRAVITY, Disk, inertias
from dynamics.kinematics import ContactPlace


def body_constants(
    disk: Disk, fillet: float, curvature: float, place: tuple[float, float]
) -> dict[str, Any]:
    """Return the constants of a disk in SI units that both time-steppers name alike.

    Parameters
    ----------
    disk : Disk
        The disk.
    fillet : float
        Radius of the rounded edge [m].
    curvature : float
        Curvature of a concave table [1/m].
    place : tuple of float
        Position [m] of the origin relative to the middle of a concave table.

    Returns
    -------
    dict
        `mass`, moments of inertia `diametral_inertia` and `axial_inertia` [kg m^2], the
        difference `inverse_inertia_excess` of their inverses, `radius`, distances
        `core_radius` and `core_depth` of the centre of the fillet from axis and middle
        plane, `fillet`, and `bowl`: restoring acceleration divided by the distance from
        the middle of a concave table [1/s^2], and position of the origin relative to it.
    """
    diametral, axial = inertias(disk)
    return {
        "mass": disk.mass,
        "diametral_inertia": diametral,
        "axial_inertia": axial,
        "inverse_inertia_excess": 1 / axial - 1 / diametral,
        "radius": disk.radius,
        "core_radius": disk.radius - fillet,
        "core_depth": disk.thickness / 2 - fillet,
        "fillet": fillet,
        "bowl": (GRAVITY * curvature, *place),
    }


def body_axes(theta: float, beta: float) -> tuple[np.ndarray, ...]:
    """Return the unit vectors a_1, a_2, e_2 and e_3 (3,) at precession theta and inclination
    beta [rad]."""
    a1 = np.array([np.cos(theta), np.sin(theta), 0.0])
    a2 = np.array([-np.sin(theta), np.cos(theta), 0.0])
    n = np.sin(beta) * a2 + [0, 0, np.cos(beta)]
    e3 = [0, 0, np.sin(beta)] - np.cos(beta) * a2
    return a1, a2, n, e3


def rolling_velocity(
    omega: Sequence[float] | np.ndarray, axes: tuple[np.ndarray, ...], lever: np.ndarray
) -> np.ndarray:
    """Return the velocity (3,) [m/s] of the centre of a disk whose contact is at rest.

    Parameters
    ----------
    omega : ndarray, shape (3,)
        Angular velocity [rad/s] along a_1, e_2 and e_3.
    axes : tuple of ndarray
        `body_axes`.
    lever : ndarray, shape (3,)
        Position [m] of the centre relative to the contact.
    """
    a1, _, axis, e3 = axes
    spin = omega[0] * a1 + omega[1] * axis + omega[2] * e3
    return np.cross(spin, lever)


def angular_momentum(
    constants: Any, omega: Sequence[float] | np.ndarray, axes: tuple[np.ndarray, ...]
) -> np.ndarray:
    """Return the angular momentum (3,) [kg m^2/s]; see `rolling_velocity`."""
    a1, _, axis, e3 = axes
    turning = constants.diametral_inertia * (omega[0] * a1 + omega[2] * e3)
    return turning + constants.axial_inertia * omega[1] * axis


def kinetic_and_bowl_energy(
    constants: Any,
    centre: np.ndarray,
    velocity: np.ndarray,
    axis: np.ndarray,
    momentum: np.ndarray,
) -> np.ndarray:
    """Return kinetic energy plus that in a bowl (k,) [J] of states with vectors (3, k)."""
    spin = (momentum * axis).sum(axis=0)
    moving = constants.mass * (velocity * velocity).sum(axis=0)
    moving += (momentum * momentum).sum(axis=0) / constants.diametral_inertia
    moving += constants.inverse_inertia_excess * spin**2
    rate, x, y = constants.bowl
    away = (centre[0] + x) ** 2 + (centre[1] + y) ** 2
    return (moving + constants.mass * rate * away) / 2


def relative_columns(
    constants: Any,
    place: ContactPlace,
    velocity: np.ndarray,
    axis: np.ndarray,
    momentum: np.ndarray,
) -> list[np.ndarray]:
    """Return the columns w1, w2, w3, u1, u2 of a Motion, (k,) each.

    Parameters
    ----------
    constants : ModelConstants or RattlingDisk
        Constants with the fields of `body_constants`.
    place : ContactPlace
        Position [m] of the contact at the inclinations of the states.
    velocity, axis, momentum : ndarray, shape (3, k)
        Velocity of the centre [m/s], axis, and angular momentum [kg m^2/s].
    """
    s = np.hypot(axis[0], axis[1])
    c = axis[2]
    d0 = axis[0] / s
    d1 = axis[1] / s
    L = momentum
    w1 = (L[0] * d1 - L[1] * d0) / constants.diametral_inertia
    w2 = (axis * L).sum(axis=0) / constants.axial_inertia
    w3 = (L[2] * s - (L[0] * d0 + L[1] * d1) * c) / constants.diametral_inertia
    u1 = velocity[0] * d1 - velocity[1] * d0 - place.radius * w2 + place.depth * w3
    u2 = velocity[0] * d0 + velocity[1] * d1 + place.e * w1
    return [w1, w2, w3, u1, u2]
