"""Tracks of samples in memory."""

import numpy as np

from sonify.sound.pressure import Track


def track(samples, rate=48_000):
    """Return a track of samples (n,) or (n, channels)."""
    columns = np.asarray(samples, np.float32).reshape(len(samples), -1)
    others = tuple(
        Track(sample_rate=rate, columns=columns, column=i)
        for i in range(1, columns.shape[1])
    )
    return Track(sample_rate=rate, columns=columns, column=0, others=others)
