"""Place of the contact on the table, and the edge on which a disk rolls, in SI units."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from dynamics.disk import Disk
from dynamics.kinematics import contact_arms, contact_place


def contact_reach(
    inclination: ArrayLike, disk: Disk, fillet: float = 0.0
) -> np.ndarray:
    """Return the horizontal distance (k,) [m] of the contact from the centre.

    It is positive towards the contact on the lower side of the disk. The inclinations
    (k,) are in rad; `fillet` is the radius [m] of the edge on which the disk rolls.
    """
    return -disk.radius * _arms(inclination, disk, fillet)[1]


def centre_height(
    inclination: ArrayLike, disk: Disk, fillet: float = 0.0
) -> np.ndarray:
    """Return the height (k,) [m] of the centre above the contact; see `contact_reach`."""
    return disk.radius * _arms(inclination, disk, fillet)[0]


def contact_position(state: np.ndarray, disk: Disk, fillet: float = 0.0) -> np.ndarray:
    """Return the positions (k, 2) [m] of the contact on the table for states (k, 11).

    They are relative to the centre of the disk at the release. The contact lies along
    a_2, a quarter turn ahead of the precession angle.
    """
    ahead = state[:, 0] + np.pi / 2
    along = np.column_stack([np.cos(ahead), np.sin(ahead)])
    return state[:, 3:5] + contact_reach(state[:, 1], disk, fillet)[:, None] * along


def edge_profile(disk: Disk, fillet: float, segments: int) -> np.ndarray:
    """Return points (n, 2) [m] of the lower edge from the face to the lateral surface.

    The columns are the distances from the axis and from the middle plane. A sharp edge
    is one point, a rounded edge consists of `segments` chords.
    """
    tilt = np.linspace(0.0, np.pi / 2, segments + 1 if fillet else 1)
    place = contact_place(np.cos(tilt), np.sin(tilt), disk.aspect, fillet / disk.radius)
    radius, depth = np.broadcast_arrays(place.radius, place.depth, tilt)[:2]
    return disk.radius * np.column_stack([radius, depth])


def _arms(inclination: Any, disk: Disk, fillet: float) -> tuple[Any, Any]:
    beta = np.asarray(inclination, dtype=float)
    return contact_arms(np.cos(beta), np.sin(beta), disk.aspect, fillet / disk.radius)
