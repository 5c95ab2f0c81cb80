"""Score a rate law by its prediction of the parts of a window that were left out of
the fit."""

import math
from itertools import pairwise

import numpy as np
from scipy.fft import irfft, rfft
from scipy.optimize import brentq

from sonify.hearing.settling.rate_laws import Law


def phase_at_frames(count: int, law: Law) -> np.ndarray:
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
    cross-validation, averaged over components.

    Each part of the window `values` (components, frames) is predicted from the other
    parts.
    """
    return float(part_gains(values, law).sum())


def part_gains(values: np.ndarray, law: Law) -> np.ndarray:
    """Return the contributions (parts,) of the parts of a window to `predicted_gain`."""
    part_count = 5
    count = values.shape[1]
    values = values.T
    columns = harmonic_columns(phase_at_frames(count, law), law.harmonics)
    cuts = np.round(np.linspace(0, count, part_count + 1)).astype(int)
    parts = [slice(*pair) for pair in pairwise(cuts)]
    grams = np.array([columns[part].T @ columns[part] for part in parts])
    rights = np.array([columns[part].T @ values[part] for part in parts])
    gram = grams.sum(axis=0)
    right = rights.sum(axis=0)
    ridge = 1e-6 * count * np.eye(len(gram))
    found = np.empty(part_count)
    for i, part in enumerate(parts):
        fitted = np.linalg.solve(gram - grams[i] + ridge, right - rights[i])
        mean = (right - rights[i])[0] / (gram - grams[i])[0, 0]
        residual = np.sum(np.square(values[part] - columns[part] @ fitted), axis=0)
        variance = np.sum(np.square(values[part] - mean), axis=0)
        gains = np.log((variance + 1e-9) / (residual + 1e-9))
        found[i] = float(gains.mean()) / (2 * part_count)
    return found


def without_harmonics(
    values: np.ndarray, phases: np.ndarray, harmonics: int
) -> np.ndarray:
    """Return a window (components, frames) without the harmonics of phases (frames,)
    [turns]."""
    columns = harmonic_columns(phases, harmonics)
    return values - (columns @ np.linalg.lstsq(columns, values.T)[0]).T


def correlation_length(residual: np.ndarray) -> float:
    """Return the correlation length [frames] of the residual (components, frames) of a
    window.

    It is the sum of the squared autocorrelation, that is, the number of frames per
    independent estimate of a power."""
    max_lag = 100  # frames
    spectrum = rfft(residual, 2 * residual.shape[1], axis=1)
    power = np.square(np.abs(spectrum)).sum(axis=0)
    correlation = irfft(power)[:max_lag]
    if correlation[0] <= 0:
        return 1.0
    return float(1 + 2 * np.sum(np.square(correlation[1:] / correlation[0])))


def independent_samples(
    values: np.ndarray, scale_ms: float, law: Law
) -> tuple[float, float]:
    """Return the number of independent samples per component of a window (components,
    frames) for a law, and the number of independent components."""
    length = values.shape[1]
    residual = without_harmonics(values, phase_at_frames(length, law), law.harmonics)
    frames_per_sample = max(scale_ms, correlation_length(residual))
    if len(values) == 1:
        return length / frames_per_sample, 1.0
    noise, components = noise_at_rates(residual, law)
    # without a disk, the values themselves are noise, which components may share
    _, components_without_disk = noise_at_rates(
        values - values.mean(axis=1, keepdims=True), law
    )
    return (
        length / max(frames_per_sample, noise),
        min(components, components_without_disk),
    )


def single_component_score(score: float, components: float, harmonics: int) -> float:
    """Return the score of one component that is as improbable in noise as a score of
    several independent components.

    The log likelihood gain of noise has a gamma distribution, with a degree of freedom
    for each harmonic of each component; the Chernoff bounds of the two tails are
    equal."""
    if components <= 1 or score <= 0:
        return score

    def tail(value: float, degrees: float) -> float:
        return value - degrees * math.log1p(value / degrees)

    wanted = tail(score, components * harmonics)
    return float(brentq(lambda value: tail(value, harmonics) - wanted, 0.0, score))


def time_at_rates(law: Law, bins: int) -> np.ndarray:
    """Return the share of time (bins,) that a law and its harmonics spend at each whole
    number of turns per window from 1 on."""
    step_count = 2000
    phases = law.turns * law.shape.phase(np.linspace(0, 1, step_count + 1))
    rates = np.diff(phases) * step_count
    harmonic_rates = np.outer(np.arange(1, law.harmonics + 1), rates)
    turns = np.rint(harmonic_rates).astype(int).ravel()
    counts = np.bincount(np.clip(turns, 1, bins), minlength=bins + 1)[1:]
    return counts / counts.sum()


def noise_at_rates(residual: np.ndarray, law: Law) -> tuple[float, float]:
    """Return the power density of a residual (components, frames) at the rates of a law
    and its harmonics, relative to the mean density, and the number of components that
    are independent there.

    Each rate counts by the time that the law spends at it. The number of components is
    their squared number over the sum of their squared coherences, of which the bias of
    a finite number of frequencies is subtracted."""
    count = len(residual)
    spectrum = rfft(residual, axis=1)[:, 1:]
    power = np.square(np.abs(spectrum))
    weights = time_at_rates(law, spectrum.shape[1])
    bins = max(1 / float(np.sum(np.square(weights))), 2.0)
    power_at_rates = power @ weights
    noise = power_at_rates / np.maximum(power.mean(axis=1), 1e-12)
    unit = np.sqrt(weights / np.maximum(power_at_rates, 1e-12)[:, None]) * spectrum
    coherence = np.square(np.abs(unit @ unit.conj().T))
    coherence = np.clip((coherence - 1 / bins) / (1 - 1 / bins), 0, 1)
    return float(noise.mean()), count**2 / float(coherence.sum())
