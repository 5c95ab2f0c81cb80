"""Describe modes in words."""

from typing import TYPE_CHECKING

import numpy as np

from modal.elements.sample import polar_components
from modal.mesh.symmetry import rigid_fields
from modal.modes import Modes

if TYPE_CHECKING:
    from modal.tabletop.record import SurfaceModes  # slow import


def mode_caption(modes: Modes, i: int, held: bool = False) -> str:
    """Return a caption with number, frequency [Hz], T60 [s] and shape of mode i."""
    time = f", T60 {modes.decay_time[i]:.2g} s" if modes.decay_rate[i] > 0 else ""
    return f"{i + 1}: {modes.frequency[i]:.0f} Hz{time}\n{shape_name(modes, i, held)}"


def shape_name(modes: Modes, i: int, held: bool) -> str:
    """Return the family and the order of mode i.

    A swing of the disk about the patch that holds it has no order.
    """
    if held and rigid_motion_share(modes, i) > 0.97:
        return f"swing, {'in' if modes.family[i] == 'extensional' else 'out of'} plane"
    parity = f"{modes.parity[i]}, " if modes.partner[i] >= 0 else ""
    return f"{modes.family[i]}, {parity}order {modes.order[i]}"


def table_caption(table: "SurfaceModes", i: int) -> str:
    """Return a caption with number, frequency [Hz] and order of mode i of a table.

    Modes of a table without an axis of symmetry have no order.
    """
    order = f", order {table.order[i]}" if table.order[i] >= 0 else ""
    return f"{i + 1}: {table.frequency[i]:.0f} Hz{order}"


def rigid_motion_share(modes: Modes, i: int) -> float:
    """Return the fraction of the mean-square rim motion of mode i that rigid-body
    motions explain."""
    angle = modes.rim_angle
    rim = np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    basis = polar_components(rigid_fields(rim), angle).reshape(6, -1).T
    shape = modes.rim_shape[i].ravel()
    return float(1 - np.linalg.lstsq(basis, shape)[1][0] / (shape @ shape))
