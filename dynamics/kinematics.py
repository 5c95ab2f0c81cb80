"""Dimensionless kinematics of a disk on a plane, for scalars and arrays."""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from dynamics.disk import Disk


def precession_rate(w3: Any, cos_a: Any) -> Any:
    """Return the precession rate d theta/dt from the angular velocity along e_3 (2.3)."""
    return w3 / cos_a


def contact_arms(sin_a: Any, cos_a: Any, h: Any, fillet: Any = 0.0) -> tuple[Any, Any]:
    """Return the vertical and horizontal distances e, f (4.9) of centre and contact."""
    if fillet == 0:
        return h * sin_a + cos_a, h * cos_a - sin_a
    core = h - fillet
    rim = 1 - fillet
    return core * sin_a + rim * cos_a + fillet, core * cos_a - rim * sin_a


class ContactPlace(NamedTuple):
    """Position of the contact on the disk, divided by R.

    Attributes
    ----------
    radius, depth
        Distance from the axis and from the middle plane.
    e, f
        Vertical and horizontal distances from the centre (4.9).
    """

    radius: Any
    depth: Any
    e: Any
    f: Any


def contact_place(sin_a: Any, cos_a: Any, h: Any, fillet: Any = 0.0) -> ContactPlace:
    """Return the position of the contact on an edge with the radius `fillet`.

    With R = 1, its distance is 1 - fillet (1 - sin beta) from the axis and h - fillet
    (1 - cos beta) from the middle plane.
    """
    arms = contact_arms(sin_a, cos_a, h, fillet)
    if fillet == 0:
        return ContactPlace(1.0, h, *arms)
    return ContactPlace(1 - fillet * (1 - cos_a), h - fillet * (1 - sin_a), *arms)


def contact_place_in_metres(
    disk: "Disk", fillet: float, sin_a: Any, cos_a: Any
) -> ContactPlace:
    """Return the `contact_place` [m] on an edge with the radius `fillet` [m]."""
    place = contact_place(sin_a, cos_a, disk.aspect, fillet / disk.radius)
    return ContactPlace(*(disk.radius * length for length in place))


def centre_velocity(slip: Any, omega: Any, place: ContactPlace) -> tuple[Any, Any]:
    """Return the velocity of the centre along a_1, a_2 from the slip velocity (2.5)."""
    w1, w2, w3 = omega
    return slip[0] + place.radius * w2 - place.depth * w3, slip[1] - place.e * w1


def turned_over(columns: np.ndarray) -> np.ndarray:
    """Return the COLUMNS (..., 11) of a motion relative to the other face of the disk.

    The axis of the disk is reversed; the direction to the contact is the same.
    """
    other = np.array(columns, dtype=float)
    other[..., 0] += np.pi
    other[..., 1] = np.pi - other[..., 1]
    other[..., [2, 5, 6, 8, 9]] *= -1
    return other


def energy(
    beta: Any, omega: Any, slip: Any, constants: Any, position: Any = (0.0, 0.0)
) -> Any:
    """Return the dimensionless energy (6.1) with its two misprints corrected.

    It is zero for a disk at rest in the middle of its table. `position` is the
    horizontal position of the centre.
    """
    sin_a = np.cos(beta)
    cos_a = np.sin(beta)
    place = contact_place(sin_a, cos_a, constants.h, constants.fillet)
    v1, v2 = centre_velocity(slip, omega, place)
    w1, w2, w3 = omega
    v3 = place.f * w1
    rotation = (constants.K / 4 + constants.h**2 / 3) * (
        w1 * w1 + w3 * w3
    ) + constants.K / 2 * w2 * w2
    # e - h, without cancellation
    height = (1 - constants.fillet) * cos_a - 2 * (
        constants.h - constants.fillet
    ) * np.sin(beta / 2) ** 2
    if constants.bowl:
        x, y = position
        height = height + constants.bowl / 2 * (
            (x + constants.bowl_x) ** 2 + (y + constants.bowl_y) ** 2
        )
    return (v1 * v1 + v2 * v2 + v3 * v3 + rotation) / 2 + (constants.K + 4) / 4 * height
