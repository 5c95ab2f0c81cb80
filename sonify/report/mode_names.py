"""What a mode is, in words."""

from typing import TYPE_CHECKING

import numpy as np

from modal.modes import Modes

if TYPE_CHECKING:
    from modal.tabletop.record import SurfaceModes  # loads slowly

SWING = 0.97
"""A mode of a held disk of which so much is motion of the stiff disk is called a swing."""


def caption(modes: Modes, i, held=False):
    """Number, frequency, T60 and shape of mode i."""
    time = f", T60 {modes.decay_time[i]:.2g} s" if modes.decay_rate[i] > 0 else ""
    return f"{i + 1}: {modes.frequency[i]:.0f} Hz{time}\n{shape_in_words(modes, i, held)}"


def shape_in_words(modes: Modes, i, held=False):
    """Family and order of mode i; a swing about the patch that holds a disk has no order."""
    if held and stiff_share(modes, i) > SWING:
        return f"swing, {'in' if modes.family[i] == 'extensional' else 'out of'} plane"
    return f"{modes.family[i]}, {f'{modes.parity[i]}, ' if modes.partner[i] >= 0 else ''}order {modes.order[i]}"


def table_caption(table: "SurfaceModes", i) -> str:
    """Number, frequency and order of mode i of a table; a table without an axis has no orders."""
    return f"{i + 1}: {table.frequency[i]:.0f} Hz" + (
        f", order {table.order[i]}" if table.order[i] >= 0 else ""
    )


def stiff_share(modes: Modes, i) -> float:
    """Return the share of the mean square of a rim's motion, in mode i, that the six motions of a
    stiff rim make up."""
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
