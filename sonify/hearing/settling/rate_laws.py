"""Families of rate laws within a window, over the relative time x from 0 to 1.

A shape is the phase as a function of x, from 0 at the beginning to 1 at the end of the
window; `ratio` is the ratio of the last to the first rate."""

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import chain
from threading import Lock
from typing import Any

import numpy as np

from dynamics.numba_kernels import njit
from sonify.hearing.settling.settings import SETTLING

FAMILY_CODES = {
    "disk": 0,
    "linear": 1,
    "exponential": 2,
    "slowing disk": 3,
    "slowing linear": 4,
    "slowing exponential": 5,
}
"""Code of each family in compiled functions."""


@dataclass(frozen=True)
class Shape:
    """Rate law with its family, the ratio of the last to the first rate, and the
    exponent of a disk."""

    family: str
    ratio: float
    exponent: float = 0.0

    def phase(self, x: float | np.ndarray) -> Any:
        """Return the phase (n,) at relative times x (n,)."""
        x = np.asarray(x, dtype=float)
        ratio = self.ratio
        if self.family.startswith("slowing "):
            rising = replace(self, family=self.family.removeprefix("slowing "))
            return 1 - rising.phase(1 - x)
        if self.family == "disk":
            left = distance_to_end(ratio, self.exponent)
            if abs(self.exponent - 1) < 1e-6:
                return np.log((left + 1) / (left + 1 - x)) / np.log((left + 1) / left)
            power = 1 - self.exponent
            begin = (left + 1) ** power
            return (begin - (left + 1 - x) ** power) / (begin - left**power)
        if abs(ratio - 1) < 1e-9:
            return x
        if self.family == "linear":
            return (x + (ratio - 1) * x * x / 2) / ((1 + ratio) / 2)
        return (ratio**x - 1) / (ratio - 1)

    def time(self, phase: np.ndarray) -> np.ndarray:
        """Return the relative times (n,) at a phase (n,)."""
        return places(
            FAMILY_CODES[self.family], self.ratio, self.exponent or 0.5, phase
        )

    @property
    def first_rate(self) -> float:
        """Ratio of the initial to the mean rate."""
        return (self.phase(1e-6) - self.phase(0.0)) / 1e-6


@dataclass(frozen=True)
class Law:
    """Shape with its number of turns in a window, number of harmonics and log
    likelihood."""

    shape: Shape
    turns: float
    harmonics: int
    likelihood: float


def distance_to_end(ratio: float, exponent: float) -> float:
    """Return the time from the end of the window to that of the disk, divided by the
    length of the window."""
    return 1 / (ratio ** (1 / exponent) - 1)


@njit(cache=True, nogil=True)
def places(code: int, ratio: float, exponent: float, phases: np.ndarray) -> np.ndarray:
    """Return the relative times (n,), from 0 to 1, at phases (n,)."""
    slowing = code >= 3
    family = code - 3 if slowing else code
    uniform = family > 0 and abs(ratio - 1) < 1e-9
    logarithmic = abs(exponent - 1) < 1e-6
    left = 1 / (ratio ** (1 / exponent) - 1) if family == 0 else 0.0
    power = 1 - exponent
    begin = (left + 1) ** power
    span = begin - left**power
    curvature = (ratio - 1) / 2
    found = np.empty(len(phases))
    for k in range(len(phases)):
        phase = 1 - phases[k] if slowing else phases[k]
        if uniform:
            x = phase
        elif family == 0 and logarithmic:
            x = (left + 1) * (1 - (left / (left + 1)) ** phase)
        elif family == 0:
            x = left + 1 - (begin - phase * span) ** (1 / power)
        elif family == 1:
            x = (math.sqrt(1 + 2 * curvature * phase * (1 + ratio)) - 1) / (
                2 * curvature
            )
        else:
            x = math.log1p(phase * (ratio - 1)) / math.log(ratio)
        found[k] = 1 - x if slowing else x
    return found


def covering_shapes(
    family: str,
    ratios: list[float] | np.ndarray,
    exponents: list[float] | np.ndarray,
    distance: float,
) -> list[Shape]:
    """Return a greedy choice of shapes that has a member near every law of a family.

    `distance` is the largest rms difference of the phases.
    """
    candidates = [Shape(family, ratio, n) for n in exponents for ratio in ratios]
    x = np.linspace(0, 1, 257)
    phases = np.array([shape.phase(x) for shape in candidates])
    squares = np.sum(np.square(phases), axis=1)
    distances = np.sqrt(
        np.maximum(squares[:, None] + squares - 2 * phases @ phases.T, 0) / len(x)
    )
    near = distances < distance
    uncovered = np.ones(len(candidates), dtype=bool)
    chosen = []
    while uncovered.any():
        best = int(np.argmax(near[:, uncovered].sum(axis=1)))
        chosen.append(candidates[best])
        uncovered &= ~near[best]
    return sorted(chosen, key=lambda shape: (shape.exponent, shape.ratio))


@dataclass(frozen=True, eq=False)
class ShapeSet:
    """Shapes that are searched together: families by name, and the first shape of each."""

    shapes: tuple[Shape, ...]
    names: tuple[str, ...]
    begins: np.ndarray


_choosing_shapes = Lock()
"""Held by the thread that chooses shapes; those that need the same ones wait for it."""


def families(
    distance: float,
    only: str | None = None,
    min_ratio: float = SETTLING.rate_ratios[0],
) -> ShapeSet:
    """Return the searched shapes of the disk and its four rivals, or of `only` one
    family.

    `distance` is their spacing, as in `covering_shapes`, and `min_ratio` the minimum
    ratio of the rates of a disk.
    """
    with _choosing_shapes:
        return _families(distance, only, min_ratio)


@lru_cache
def _families(distance: float, only: str | None, min_ratio: float) -> ShapeSet:
    every = ("disk", "flat", "slowing", "linear", "exponential")
    names = every if only is None else (only,)
    shapes = [_shapes_of_family(name, distance, min_ratio) for name in names]
    begins = np.cumsum([0, *map(len, shapes[:-1])])
    return ShapeSet(tuple(chain(*shapes)), names, begins)


@lru_cache
def _shapes_of_family(name: str, distance: float, min_ratio: float) -> list[Shape]:
    """Return the searched shapes of a family; see `families`."""
    high = SETTLING.rate_ratios[1]
    steady = SETTLING.max_steady_ratio
    if name == "slowing":  # mirrored laws are at the same distances from each other
        rising = chain.from_iterable(
            _shapes_of_family(mirrored, distance, min_ratio)
            for mirrored in ("disk", "linear", "exponential")
        )
        return [replace(shape, family=f"slowing {shape.family}") for shape in rising]
    if name == "disk":
        ratios = np.geomspace(min_ratio, high, 40)
        exponents = np.linspace(*SETTLING.exponents, 18)
        return covering_shapes("disk", ratios, exponents, distance)
    if name == "flat":
        ratios = np.geomspace(1 / steady, steady, 31)
        return covering_shapes("linear", ratios, [0.0], distance)
    return covering_shapes(name, np.geomspace(steady, high, 60), [0.0], distance)
