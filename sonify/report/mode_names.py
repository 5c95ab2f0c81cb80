"""Descriptions of modes in words."""

from typing import TYPE_CHECKING

import numpy as np

from modal.modes import Modes

if TYPE_CHECKING:
    from modal.tabletop.record import SurfaceModes  # slow import

MIN_RIGID_SHARE = 0.97
"""Share of rigid motion above which a mode of a held disk is called a swing."""


def mode_caption(modes: Modes, i, held=False):
    """Return number, frequency [Hz], T60 [s] and shape of mode i."""
    time = f", T60 {modes.decay_time[i]:.2g} s" if modes.decay_rate[i] > 0 else ""
    return f"{i + 1}: {modes.frequency[i]:.0f} Hz{time}\n{shape_name(modes, i, held)}"


def shape_name(modes: Modes, i, held=False):
    """Return family and order of mode i; a swing of a disk about its patch has no order."""
    if held and rigid_motion_share(modes, i) > MIN_RIGID_SHARE:
        return f"swing, {'in' if modes.family[i] == 'extensional' else 'out of'} plane"
    return f"{modes.family[i]}, {f'{modes.parity[i]}, ' if modes.partner[i] >= 0 else ''}order {modes.order[i]}"


def table_caption(table: "SurfaceModes", i) -> str:
    """Return number, frequency [Hz] and order of mode i of a table.

    The modes of a table without an axis of symmetry have no order.
    """
    return f"{i + 1}: {table.frequency[i]:.0f} Hz" + (
        f", order {table.order[i]}" if table.order[i] >= 0 else ""
    )


def rigid_motion_share(modes: Modes, i) -> float:
    """Return the share of six rigid-body motions in the mean square rim motion of mode i."""
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
    basis = np.reshape(motions, (6, -1)).T
    return float(1 - np.linalg.lstsq(basis, shape)[1][0] / (shape @ shape))
