"""Score a rate law by its prediction of the parts of a window that were left out of
the fit."""

from itertools import pairwise

import numpy as np
from scipy.fft import irfft, rfft

from sonify.hearing.settling.rate_laws import Law


def law_phases(count: int, law: Law) -> np.ndarray:
    """Return the phase (count,) of a law [turns] in the frames of a window."""
    return law.turns * law.shape.phase((np.arange(count) + 0.5) / count)


def harmonic_columns(phases: np.ndarray, harmonics: int) -> np.ndarray:
    """Return a constant and harmonics, (frames, 1 + 2 harmonics), of a phase (frames,)
    [turns]."""
    angles = 2 * np.pi * phases[:, None] * np.arange(1, harmonics + 1)
    return np.concatenate(
        [np.ones((len(phases), 1)), np.cos(angles), np.sin(angles)], axis=1
    )


def predicted_gain(values: np.ndarray, law: Law) -> float:
    """Return the log likelihood gain per sample of a law over a constant, by
    cross-validation.

    Each part of the window `values` (frames,) is predicted from the other parts.
    """
    part_count = 5
    count = len(values)
    columns = harmonic_columns(law_phases(count, law), law.harmonics)
    cuts = np.round(np.linspace(0, count, part_count + 1)).astype(int)
    parts = [slice(*pair) for pair in pairwise(cuts)]
    grams = np.array([columns[part].T @ columns[part] for part in parts])
    rights = np.array([columns[part].T @ values[part] for part in parts])
    gram = grams.sum(axis=0)
    right = rights.sum(axis=0)
    ridge = 1e-6 * count * np.eye(len(gram))
    gain = 0.0
    for part, own_gram, own_right in zip(parts, grams, rights, strict=True):
        fitted = np.linalg.solve(gram - own_gram + ridge, right - own_right)
        mean = (right - own_right)[0] / (gram - own_gram)[0, 0]
        residual = np.sum(np.square(values[part] - columns[part] @ fitted))
        variance = np.sum(np.square(values[part] - mean))
        gain += np.log((variance + 1e-9) / (residual + 1e-9)) / (2 * part_count)
    return float(gain)


def correlation_length(values: np.ndarray, phases: np.ndarray, harmonics: int) -> float:
    """Return the correlation length [frames] of a window without the harmonics of the
    given phases.

    It is the sum of the squared autocorrelation, that is, the number of frames per
    independent estimate of a power."""
    max_lag = 100  # frames
    columns = harmonic_columns(phases, harmonics)
    residual = values - columns @ np.linalg.lstsq(columns, values)[0]
    spectrum = rfft(residual, 2 * len(residual))
    correlation = irfft(spectrum.real**2 + spectrum.imag**2)[:max_lag]
    if correlation[0] <= 0:
        return 1.0
    return float(1 + 2 * np.sum(np.square(correlation[1:] / correlation[0])))


def independent_samples(values: np.ndarray, scale_ms: float, law: Law) -> float:
    """Return the number of independent samples in a window (frames,) for a law."""
    phases = law_phases(len(values), law)
    return len(values) / max(
        scale_ms, correlation_length(values, phases, law.harmonics)
    )
