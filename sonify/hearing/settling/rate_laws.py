"""FAMILIES OF RATE: how the rate of turns changes within a window, x from 0 to 1.

A shape is the phase over x, 0 at the beginning and 1 at the end of the window; `ratio` is the last
rate over the first."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from sonify.hearing.settling.settings import SettlingSettings

STEPS = 1024


@dataclass(frozen=True)
class Shape:
    """One law of the rate: its family, the ratio of last to first rate, and the exponent of a
    disk."""

    family: str
    ratio: float
    exponent: float = 0.0

    def phase(self, x):
        """Return the phase (n,) at places x (n,) of the window."""
        return phase(self.family, self.ratio, self.exponent, x)

    def time(self, phase):
        """Return the places (n,) of the window at a phase (n,)."""
        return time(self.family, self.ratio, self.exponent, phase)

    @property
    def first_rate(self):
        """The rate at the beginning over the mean rate."""
        return (self.phase(1e-6) - self.phase(0.0)) / 1e-6


@dataclass(frozen=True)
class Law:
    """A shape with its number of turns in a window, the harmonics fitted and the log likelihood."""

    shape: Shape
    turns: float
    harmonics: int
    likelihood: float


def distance_to_end(ratio, exponent):
    """Return the time from the end of the window to that of the disk, over the window."""
    return 1 / (ratio ** (1 / exponent) - 1)


def phase(family, ratio, exponent, x):
    """Return the phase at places x of the window."""
    x = np.asarray(x, dtype=float)
    if family.startswith("slowing "):
        return 1 - phase(family.removeprefix("slowing "), ratio, exponent, 1 - x)
    if family == "disk":
        left = distance_to_end(ratio, exponent)
        if abs(exponent - 1) < 1e-6:
            return np.log((left + 1) / (left + 1 - x)) / np.log((left + 1) / left)
        power = 1 - exponent
        return ((left + 1) ** power - (left + 1 - x) ** power) / ((left + 1) ** power - left**power)
    if family == "linear" and abs(ratio - 1) > 1e-9:
        return (x + (ratio - 1) * x * x / 2) / ((1 + ratio) / 2)
    if family == "exponential" and abs(ratio - 1) > 1e-9:
        return (ratio**x - 1) / (ratio - 1)
    return x


def time(family, ratio, exponent, phase):
    """Return the places of the window at a phase."""
    y = np.asarray(phase, dtype=float)
    if family.startswith("slowing "):
        return 1 - time(family.removeprefix("slowing "), ratio, exponent, 1 - y)
    if family == "disk":
        left = distance_to_end(ratio, exponent)
        if abs(exponent - 1) < 1e-6:
            return (left + 1) * (1 - (left / (left + 1)) ** y)
        power = 1 - exponent
        begin = (left + 1) ** power
        return left + 1 - (begin - y * (begin - left**power)) ** (1 / power)
    if family == "linear" and abs(ratio - 1) > 1e-9:
        curvature = (ratio - 1) / 2
        return (np.sqrt(1 + 4 * curvature * y * (1 + ratio) / 2) - 1) / (2 * curvature)
    if family == "exponential" and abs(ratio - 1) > 1e-9:
        return np.log1p(y * (ratio - 1)) / np.log(ratio)
    return y


def covering_shapes(family: str, ratios, exponents, distance: float) -> list[Shape]:
    """Return shapes such that every law of a family is near one of them, chosen greedily."""
    candidates = [Shape(family, ratio, n) for n in exponents for ratio in ratios]
    x = np.linspace(0, 1, 257)
    phases = np.array([shape.phase(x) for shape in candidates])
    squares = np.sum(np.square(phases), axis=1)
    apart = np.sqrt(np.maximum(squares[:, None] + squares - 2 * phases @ phases.T, 0) / len(x))
    near = apart < distance
    uncovered = np.ones(len(candidates), dtype=bool)
    chosen = []
    while uncovered.any():
        best = int(np.argmax(near[:, uncovered].sum(axis=1)))
        chosen.append(candidates[best])
        uncovered &= ~near[best]
    return sorted(chosen, key=lambda shape: (shape.exponent, shape.ratio))


@dataclass(frozen=True, eq=False)
class ShapeSet:
    """Shapes of a family that are searched together."""

    shapes: tuple[Shape, ...]


@lru_cache
def families(settings: SettlingSettings, distance: float) -> dict[str, ShapeSet]:
    """Return the shapes of all families that are searched, the disk and its four rivals, so far
    apart."""
    low, high = settings.rate_ratios
    disk_ratios = np.geomspace(low, high, 40)
    exponents = np.linspace(*settings.exponents, 18)
    rising = np.geomspace(settings.steady_ratio, high, 60)
    steady = np.geomspace(1 / settings.steady_ratio, settings.steady_ratio, 31)
    slowing = covering_shapes("slowing disk", disk_ratios, exponents, distance)
    slowing += covering_shapes("slowing linear", rising, [0.0], distance)
    slowing += covering_shapes("slowing exponential", rising, [0.0], distance)
    found = {
        "disk": covering_shapes("disk", disk_ratios, exponents, distance),
        "flat": covering_shapes("linear", steady, [0.0], distance),
        "slowing": slowing,
        "linear": covering_shapes("linear", rising, [0.0], distance),
        "exponential": covering_shapes("exponential", rising, [0.0], distance),
    }
    return {name: ShapeSet(tuple(shapes)) for name, shapes in found.items()}
