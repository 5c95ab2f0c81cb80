"""Losses of contact of a motion."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np


class ContactLoss(NamedTuple):
    """Loss of contact: start and duration [s], and largest height [m] of the edge."""

    t: float
    duration: float
    height: float


class ContactLosses(Sequence[ContactLoss]):
    """Losses of contact as an array (n, 3): start [s], duration [s], height [m]."""

    def __init__(self, array: np.ndarray) -> None:
        self.array = array

    def __len__(self) -> int:
        return len(self.array)

    def __getitem__(self, i: Any) -> Any:
        return (
            ContactLosses(self.array[i])
            if isinstance(i, slice)
            else ContactLoss(*self.array[i].tolist())
        )

    def __repr__(self) -> str:
        return f"Losses({len(self)}, {self.array[:, 1].sum():.4g} s in all)"
