"""Deflection of an elastic table below a moving contact, in steps of a linear filter.

The modes q'' + 2 d q' + w^2 q = F advance by the centred recursion

    q(i+1) = A1 q(i) + A2 q(i-1) + B1 F(i),

with the exact poles and the exact static response. It has no delay, and a force that is
linear in the deflection needs no iteration.
"""

from typing import Any, NamedTuple

import numpy as np

from dynamics.compliant.law.table_receptance import shapes_on_circle
from dynamics.numba_kernels import kernel

INTERPOLATION_AZIMUTH_COUNT = 512
"""Number of azimuths of the contact circle between which shapes are interpolated."""


class DrivenTable(NamedTuple):
    """Modes of a table, or an infinite plate, under the varying contact force.

    Attributes
    ----------
    from_last, from_before, from_force : ndarray, (m,)
        Coefficients A1, A2 [-] and B1 [s^2] of the recursion.
    shapes : ndarray, (INTERPOLATION_AZIMUTH_COUNT + 1, m)
        Shapes round the contact circle [kg^-1/2].
    at_contact : ndarray, (m,)
        Shapes at the last place of the contact.
    amplitude, earlier_amplitude : ndarray, (m,)
        q at the last step and at the step before [m kg^1/2].
    deflection, force : ndarray, (1,)
        Height of the table at the contact [m], and varying force [N], at the last step.
    plate_mobility : float
        Mobility of an infinite plate [s/kg], or 0.
    """

    from_last: np.ndarray
    from_before: np.ndarray
    from_force: np.ndarray
    shapes: np.ndarray
    at_contact: np.ndarray
    amplitude: np.ndarray
    earlier_amplitude: np.ndarray
    deflection: np.ndarray
    force: np.ndarray
    plate_mobility: float


def driven_table(modes: Any, step: float, plate_mobility: float = 0.0) -> DrivenTable:
    """Return a table at rest.

    Parameters
    ----------
    modes : modal.SurfaceModes or None
        Modes of the table; None for a rigid table or an infinite plate.
    step : float
        Time step [s].
    plate_mobility : float
        Mobility of an infinite plate [s/kg].

    Returns
    -------
    DrivenTable
        The table; `shapes` must be set before the first step.
    """
    frequency = np.zeros(0) if modes is None else np.asarray(modes.frequency)
    decay = np.zeros(0) if modes is None else np.asarray(modes.decay_rate)
    omega = 2 * np.pi * frequency
    damped = np.sqrt(np.maximum(omega**2 - decay**2, 0.0))
    first = 2 * np.exp(-decay * step) * np.cos(damped * step)
    second = -np.exp(-2 * decay * step)
    count = len(frequency)
    return DrivenTable(
        from_last=first,
        from_before=second,
        from_force=(1 - first - second) / omega**2,
        shapes=np.zeros((INTERPOLATION_AZIMUTH_COUNT + 1, count)),
        at_contact=np.zeros(count),
        amplitude=np.zeros(count),
        earlier_amplitude=np.zeros(count),
        deflection=np.zeros(1),
        force=np.zeros(1),
        plate_mobility=plate_mobility,
    )


def set_contact_circle(
    table: DrivenTable, modes: Any, centre: Any, radius: float
) -> None:
    """Evaluate the shapes round a circle with this centre (2,) and radius [m]."""
    table.shapes[:-1] = shapes_on_circle(
        modes, centre, radius, INTERPOLATION_AZIMUTH_COUNT
    )
    table.shapes[-1] = table.shapes[0]


@kernel
def advance_table(table: DrivenTable, azimuth: float) -> float:
    """Advance the modes by one step and return the rise of the table at the contact [m].

    The contact is at `azimuth` [rad] after the step; the varying force of the last step
    acts.
    """
    count = len(table.from_last)
    if count == 0:
        return 0.0
    turn = azimuth / (2 * np.pi)
    place = (turn - np.floor(turn)) * INTERPOLATION_AZIMUTH_COUNT
    node = min(int(place), INTERPOLATION_AZIMUTH_COUNT - 1)
    part = place - node
    force = table.force[0]
    deflection = 0.0
    for m in range(count):
        q = (
            table.from_last[m] * table.amplitude[m]
            + table.from_before[m] * table.earlier_amplitude[m]
            - table.from_force[m] * table.at_contact[m] * force
        )
        table.earlier_amplitude[m] = table.amplitude[m]
        table.amplitude[m] = q
        shape = table.shapes[node, m]
        shape += part * (table.shapes[node + 1, m] - shape)
        table.at_contact[m] = shape
        deflection += shape * q
    rise = deflection - table.deflection[0]
    table.deflection[0] = deflection
    return rise
