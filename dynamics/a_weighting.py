"""The A-weighting of sound levels."""

import numpy as np
from numpy.typing import ArrayLike


def a_weighting_db(frequency: ArrayLike) -> np.ndarray:
    """Return the A-weighting [dB] at frequencies [Hz], relative to that at 1 kHz.

    The poles are those of IEC 61672-1, annex E.
    """
    f2 = np.square(np.asarray(frequency, float))
    a = 20.598997**2
    b = 107.65265**2
    c = 737.86223**2
    d = 12194.217**2
    gain = d * f2 * f2 / ((f2 + a) * np.sqrt((f2 + b) * (f2 + c)) * (f2 + d))
    return np.asarray(20 * np.log10(np.maximum(gain, 1e-15)) + 1.9997)
