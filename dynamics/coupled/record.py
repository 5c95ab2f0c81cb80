"""Rows that a long motion writes down, and what they say between their instants."""

from tempfile import TemporaryFile
from weakref import finalize

import numpy as np

from .compiled import outermost

NODES = 6
"""Rows that a polynomial between them goes through."""


class Record:
    """Rows (n, width) of doubles in a nameless file that goes with its last reader: the memory stays as it is.

    It begins with the rows `first`.
    """

    def __init__(self, first):
        self._file, self._width, self._rows = TemporaryFile(), first.shape[1], 0  # noqa: SIM115, closed below
        finalize(self, self._file.close)
        self.append(first)

    def append(self, rows) -> None:
        """Write rows (k, width). Raises OSError when the disk is full."""
        self._file.write(np.ascontiguousarray(rows, dtype=float).tobytes())
        self._rows += len(rows)

    def rows(self) -> np.ndarray:
        """Return all rows so far, (n, width), which may only be read."""
        if not self._rows:
            return np.empty((0, self._width))
        self._file.flush()
        return np.asarray(np.memmap(self._file, float, "r", shape=(self._rows, self._width)))


@outermost
def between(rows, x, derivative):
    """Return (k, width): at places x (k,), in rows, the polynomial through the NODES nearest rows, or its derivative.

    It depends on no other place asked for.
    """
    n, width = rows.shape
    nodes = min(NODES, n)
    out, weight = np.zeros((x.size, width)), np.empty(nodes)
    for k in range(x.size):
        first = min(max(int(np.floor(x[k])) + 1 - nodes // 2, 0), n - nodes)
        u = x[k] - first
        for i in range(nodes):
            value, slope = 1.0, 0.0
            for j in range(nodes):
                if j != i:
                    slope = (slope * (u - j) + value) / (i - j)
                    value *= (u - j) / (i - j)
            weight[i] = slope if derivative else value
        for i in range(nodes):
            for c in range(width):
                out[k, c] += weight[i] * rows[first + i, c]
    return out
