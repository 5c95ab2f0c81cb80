"""Describe modes in words."""

from typing import TYPE_CHECKING

import numpy as np

from modal.modes import Modes

if TYPE_CHECKING:
    from modal.tabletop.record import SurfaceModes  # slow import


def mode_caption(modes: Modes, i, held=False):
    """Return a caption with number, frequency [Hz], T60 [s] and shape of mode i."""
    time = f", T60 {modes.decay_time[i]:.2g} s" if modes.decay_rate[i] > 0 else ""
    return f"{i + 1}: {modes.frequency[i]:.0f} Hz{time}\n{shape_name(modes, i, held)}"


def shape_name(modes: Modes, i, held):
    """Return the family and the order of mode i.

    A swing of the disk about the patch that holds it has no order.
    """
    if held and rigid_motion_share(modes, i) > 0.97:
        return f"swing, {'in' if modes.family[i] == 'extensional' else 'out of'} plane"
    parity = f"{modes.parity[i]}, " if modes.partner[i] >= 0 else ""
    return f"{modes.family[i]}, {parity}order {modes.order[i]}"


def table_caption(table: "SurfaceModes", i) -> str:
    """Return a caption with number, frequency [Hz] and order of mode i of a table.

    Modes of a table without an axis of symmetry have no order.
    """
    order = f", order {table.order[i]}" if table.order[i] >= 0 else ""
    return f"{i + 1}: {table.frequency[i]:.0f} Hz{order}"


def rigid_motion_share(modes: Modes, i) -> float:
    """Return the fraction of the mean-square rim motion of mode i that rigid-body
    motions explain."""
    c = np.cos(modes.rim_angle)
    s = np.sin(modes.rim_angle)
    none = 0 * modes.rim_angle
    one = none + 1
    motions = [
        (c, -s, none),
        (s, c, none),
        (none, one, none),
        (none, none, one),
        (none, none, c),
        (none, none, s),
    ]
    shape = modes.rim_shape[i].T.ravel()
    basis = np.reshape(motions, (len(motions), -1)).T
    return float(1 - np.linalg.lstsq(basis, shape)[1][0] / (shape @ shape))
