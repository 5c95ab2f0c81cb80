"""The raised cosine with which forces and sounds begin and end."""

import numpy as np


def raised_cosine(share: np.ndarray) -> np.ndarray:
    """Return a raised cosine (...) that rises from 0 to 1 over the shares 0 to 1
    (...)."""
    return np.sin(np.pi / 2 * np.clip(share, 0, 1)) ** 2
