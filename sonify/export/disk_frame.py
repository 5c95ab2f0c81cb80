"""Axes and contact point of the moving disk."""

import numpy as np

from dynamics import Disk
from dynamics.contact_geometry import contact_position
from sonify.sound.modal_forcing import in_patch_frame


def patch_frame(state: np.ndarray, inclination: np.ndarray) -> np.ndarray:
    """Return the axes (k, 3, 3) of the patch frame for states (k, 11); (2.1).

    The x axis points to the contact, and the z axis is the axis of the disk.
    """
    c = np.cos(state[:, 0])
    s = np.sin(state[:, 0])
    zero = 0 * inclination
    table = [(c, -s, zero), (s, c, zero), (zero, zero, 1 + zero)]
    return np.stack(
        [in_patch_frame(np.stack(axis, axis=1), inclination) for axis in table], axis=2
    )


def contact_points(state: np.ndarray, disk: Disk, fillet: float = 0.0) -> np.ndarray:
    """Return the contact points (k, 3) [m] on the table for states (k, 11)."""
    position = contact_position(state, disk, fillet)
    return np.column_stack([position, np.zeros(len(position))])
