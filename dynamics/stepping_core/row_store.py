"""Storage of the rows of long motions, and interpolation between rows."""

from tempfile import TemporaryFile
from weakref import finalize

import numpy as np

from dynamics.numba_kernels import outermost


class RowStore:
    """Rows (n, width) of doubles in a temporary file, which limits memory use.

    The file is deleted after its last use. `first` contains the initial rows.
    """

    def __init__(self, first: np.ndarray) -> None:
        self._file = TemporaryFile()  # noqa: SIM115, closed below
        self._width = first.shape[1]
        self._rows = 0
        finalize(self, self._file.close)
        self.append(first)

    def append(self, rows: np.ndarray) -> None:
        """Write rows (k, width). Raises OSError if the disk is full."""
        self._file.write(np.ascontiguousarray(rows, dtype=float).tobytes())
        self._rows += len(rows)

    def rows(self) -> np.ndarray:
        """Return all rows (n, width), read-only."""
        if not self._rows:
            return np.empty((0, self._width))
        self._file.flush()
        return np.asarray(
            np.memmap(self._file, float, "r", shape=(self._rows, self._width))
        )


@outermost
def interpolate_rows(rows: np.ndarray, x: np.ndarray, derivative: bool) -> np.ndarray:
    """Return values (k, width) at row positions x (k,), or their derivatives by x.

    They are those of the polynomial of degree 5 through the six nearest rows. Each
    value depends only on its own position.
    """
    n, width = rows.shape
    nodes = min(6, n)
    out = np.zeros((x.size, width))
    weight = np.empty(nodes)
    for k in range(x.size):
        first = min(max(int(np.floor(x[k])) + 1 - nodes // 2, 0), n - nodes)
        u = x[k] - first
        for i in range(nodes):
            value = 1.0
            slope = 0.0
            for j in range(nodes):
                if j != i:
                    slope = (slope * (u - j) + value) / (i - j)
                    value *= (u - j) / (i - j)
            weight[i] = slope if derivative else value
        for i in range(nodes):
            for c in range(width):
                out[k, c] += weight[i] * rows[first + i, c]
    return out
