"""Samples of a rattling disk, and the energy losses of its modes."""

from typing import TYPE_CHECKING

import numpy as np

from dynamics.numba_kernels import kernel
from dynamics.rattling.layout import RECORD, RECORD_SIZE

if TYPE_CHECKING:
    from dynamics.rattling.body import MotionState


@kernel
def record_mode_losses(motion: "MotionState") -> None:
    """Move the energies lost by the modes of the disk since the last sample to the record."""
    for j in range(motion.mode_loss.size):
        motion.record[RECORD.body_loss] += motion.mode_loss[j]
        motion.mode_loss[j] = 0.0


@kernel
def accumulate_half_weight(motion: "MotionState", row: np.ndarray) -> None:
    """Add half of state, record and modes of the disk to a row of the samples."""
    disk = motion.disk.ravel()
    modes = disk.size + RECORD_SIZE
    for i in range(disk.size):
        row[i] += 0.5 * disk[i]
    for i in range(RECORD_SIZE):
        row[disk.size + i] += 0.5 * motion.record[i]
    for j in range(motion.mode_loss.size):
        row[modes + 2 * j] += 0.5 * motion.modes[0, j]
        row[modes + 2 * j + 1] += 0.5 * motion.modes[1, j]
