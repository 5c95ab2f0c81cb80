"""Rows in which both time-steppers store motion and energies."""

import numpy as np

from dynamics.motion import CAUSES, COLUMNS

ENERGY_COLUMN = len(COLUMNS)
"""Index of the total energy [J] in a row, after COLUMNS."""
LOSS_COLUMNS = slice(ENERGY_COLUMN + 1, ENERGY_COLUMN + 1 + len(CAUSES))
"""Indices of the energies lost to each of CAUSES [J]."""
TABLE_ENERGY_COLUMN = LOSS_COLUMNS.stop
"""Index of the energy of the table modes [J]."""
DISK_ENERGY_COLUMN = LOSS_COLUMNS.stop + 1
"""Index of the energy of the disk modes [J]."""


def motion_rows(
    columns: np.ndarray,
    energy: np.ndarray,
    lost: np.ndarray,
    table_energy: np.ndarray,
    disk_energy: np.ndarray,
) -> np.ndarray:
    """Return the rows (k, 21) of a motion.

    Parameters
    ----------
    columns : ndarray, shape (k, 11)
        COLUMNS of a Motion.
    energy, table_energy, disk_energy : ndarray, shape (k,)
        Total energy, and those of the modes of table and disk [J].
    lost : ndarray, shape (k, 7)
        Energies lost to each of CAUSES [J].
    """
    return np.column_stack([columns, energy, lost, table_energy, disk_energy])


def losses_of(layout: tuple) -> slice:  # type: ignore[type-arg]
    """Return the indices of the energies lost to each of CAUSES in a state.

    The layout of the state has seven successive fields from `contact_loss` on.
    """
    first: int = layout.contact_loss  # type: ignore[attr-defined]
    return slice(first, first + len(CAUSES))
