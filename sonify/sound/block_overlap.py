"""Join successive blocks of rows with the rows that precede them."""

from collections.abc import Callable

import numpy as np


def overlapping_blocks(
    count: int, first: np.ndarray | float | None = None
) -> Callable[[np.ndarray], np.ndarray]:
    """Return a function that prepends to each block (k, ...) the `count` rows before
    it.

    Before the first block all rows equal `first`, by default the first row of that
    block."""
    past = None

    def extend(rows: np.ndarray) -> np.ndarray:
        nonlocal past
        if past is None:
            earlier = rows[0] if first is None else first
            past = np.broadcast_to(earlier, (count, *rows.shape[1:]))
        extended = np.concatenate([past, rows])
        past = extended[len(rows) :]
        return extended

    return extend
