"""Axes of a sweep, which define the values of the scene keys for each run number."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from math import isfinite, log2, prod
from typing import Annotated, Any, Literal

import numpy as np
from annotated_types import Ge, Le

from sonify.scene_errors import InputError

MODE_SECTIONS = ("disk", "material", "support", "surface", "numerics", "audio")
"""Sections on which the modes depend; their axes come first, so that successive runs
share modes."""


@dataclass(frozen=True, kw_only=True)
class Samples:
    """Settings for points sampled in the box of the axes, as an alternative to a
    grid."""

    method: Literal["latin", "sobol"]
    """Sampling method: Latin hypercube or scrambled Sobol sequence."""
    n: Annotated[int, Ge(1), Le(2**30)]
    """Number of points; a power of two for a Sobol sequence."""
    seed: Annotated[int, Ge(0)] = 0
    """Seed of the random number generator; equal seeds give equal points."""

    def __post_init__(self) -> None:
        if self.method == "sobol" and not log2(self.n).is_integer():
            below = 2 ** int(log2(self.n))
            raise ValueError(
                f"n = {self.n}: must be a power of two for Sobol points, such as {below} or {2 * below}"
            )

    def unit_cube_points(self, dimensions: int) -> np.ndarray:
        """Return the sampled points (n, dimensions) with coordinates in [0, 1)."""
        from scipy.stats import qmc

        draw = qmc.Sobol if self.method == "sobol" else qmc.LatinHypercube
        return draw(dimensions, seed=np.random.default_rng(self.seed)).random(self.n)


@dataclass(frozen=True, kw_only=True)
class Axis:
    """Axis of a sweep: scene keys that vary together.

    The keys take either the n entries of `values`, or n points from `ends[0]` to
    `ends[1]`. Each entry is a tuple with one value per key."""

    keys: tuple[str, ...]
    n: int
    values: tuple[tuple[Any, ...], ...] = ()
    ends: tuple[tuple[Any, ...], ...] = ()
    log: bool = False

    @property
    def entries(self) -> list[dict[str, Any]]:
        """The listed points of the axis, or both ends of its range; each maps the keys to
        their values."""
        return [
            dict(zip(self.keys, entry, strict=True))
            for entry in self.values or self.ends
        ]

    def at(self, share: float) -> tuple[Any, ...]:
        """Return the values of the keys at the fraction `share` of the axis, in [0, 1]."""
        if self.values:
            return self.values[min(int(share * self.n), self.n - 1)]
        if share in (0.0, 1.0):
            return self.ends[int(share)]
        return tuple(
            a * (b / a) ** share if self.log else a + (b - a) * share
            for a, b in zip(*self.ends, strict=True)
        )

    def step(self, k: int) -> tuple[Any, ...]:
        """Return the values of the keys at step k < n.

        Whole values are returned as integers if all ends are integers.
        """
        if self.values:
            return self.values[k]
        inside = self.at(k / max(self.n - 1, 1))
        whole = all(isinstance(end, int) for end in chain(*self.ends))
        if whole and all(float(value).is_integer() for value in inside):
            return tuple(map(int, inside))
        return inside


@dataclass(frozen=True, kw_only=True)
class Points:
    """Points of all runs; each point maps scene keys to values.

    The points form a grid whose last axis varies fastest, or are drawn according to
    `samples`."""

    axes: tuple[Axis, ...]
    samples: Samples | None = None

    @property
    def keys(self) -> list[str]:
        """Scene keys of all axes."""
        return [key for axis in self.axes for key in axis.keys]

    @cached_property
    def _points_in_unit_cube(self) -> np.ndarray:
        """Sampled points of all runs (count, axes) with coordinates in [0, 1)."""
        assert self.samples
        return self.samples.unit_cube_points(len(self.axes))

    @property
    def count(self) -> int:
        """Number of runs."""
        if self.samples is None:
            return prod(axis.n for axis in self.axes)
        return self.samples.n

    def __getitem__(self, run: int) -> dict[str, Any]:
        if self.samples is None:
            steps = np.unravel_index(run, [axis.n for axis in self.axes])
            return self.point(
                axis.step(int(k)) for axis, k in zip(self.axes, steps, strict=True)
            )
        return self.point(
            axis.at(share)
            for axis, share in zip(
                self.axes, self._points_in_unit_cube[run], strict=True
            )
        )

    def point(self, values_of_axes: Iterable[tuple[Any, ...]]) -> dict[str, Any]:
        """Return the values by key of a point, given by the values of each axis."""
        values = chain.from_iterable(values_of_axes)
        return dict(zip(self.keys, values, strict=True))


def points_of(axes: dict[str, Any], samples: Samples | None) -> Points:
    """Return the points defined by the axes of a sweep file.

    Raises InputError if an axis is empty or reversed, or if two axes share a key.
    """
    if not axes:
        raise InputError(
            'axes: missing; give the keys that vary, such as "friction.mu_static" = [0.3, 0.4]'
        )
    least = {"n": 2} if samples else {}
    found = [
        axis_of(name, least | given if isinstance(given, dict) else given)
        for name, given in axes.items()
    ]
    found.sort(key=lambda axis: not _changes_modes(axis))
    points = Points(axes=tuple(found), samples=samples)
    if twice := [key for key in points.keys if points.keys.count(key) > 1]:
        raise InputError(f"axes.{twice[0]}: varies on more than one axis")
    return points


def axis_of(name: str, given: Any) -> Axis:
    """Parse one axis of a sweep file: `"key" = [...]` or `"key, key" = {from, to, n,
    scale}`."""
    keys = tuple(key.strip() for key in name.split(","))
    if isinstance(given, list):
        if not given:
            raise InputError(f"axes.{name} = []: must have at least one value")
        return Axis(
            keys=keys,
            n=len(given),
            values=tuple(one_value_per_key(name, keys, value) for value in given),
        )
    if not isinstance(given, dict):
        raise InputError(
            f"axes.{name} = {given!r}: must be a list of values, or {{ from, to, n, scale }}"
        )
    return range_axis(name, keys, given)


def range_axis(name: str, keys: tuple[str, ...], given: dict[str, Any]) -> Axis:
    """Parse an axis of a sweep file given as a range."""
    if unknown := given.keys() - {"from", "to", "n", "scale"}:
        raise InputError(
            f"axes.{name}.{min(unknown)}: unknown key; known: from, to, n, scale"
        )
    if missing := [key for key in ("from", "to", "n") if key not in given]:
        raise InputError(f"axes.{name}.{missing[0]}: missing")
    n = given["n"]
    scale = given.get("scale", "linear")
    if not _is_finite_number(n) or n != int(n) or n < 1:
        raise InputError(f"axes.{name}.n = {n!r}: must be a whole number of at least 1")
    if scale not in ("linear", "log"):
        raise InputError(f"axes.{name}.scale = {scale!r}: must be 'linear' or 'log'")
    ends = tuple(one_value_per_key(name, keys, given[end]) for end in ("from", "to"))
    for low, high in zip(*ends, strict=True):
        if not (_is_finite_number(low) and _is_finite_number(high)):
            raise InputError(
                f"axes.{name}: from = {low!r}, to = {high!r}: must be finite numbers; give other "
                f"values as a list"
            )
        if not (low < high or (n == 1 and low == high)):
            raise InputError(
                f"axes.{name}: from = {low:g} must be less than to = {high:g}"
            )
        if scale == "log" and low <= 0:
            raise InputError(
                f"axes.{name}: from = {low:g} must be greater than 0 on a logarithmic scale"
            )
    return Axis(keys=keys, n=int(n), ends=ends, log=scale == "log")


def one_value_per_key(name: str, keys: tuple[str, ...], value: Any) -> tuple[Any, ...]:
    """Return one value per key, from a list of values or from a single shared value."""
    if len(keys) == 1 or not isinstance(value, list):
        return (value,) * len(keys)
    if len(value) != len(keys):
        raise InputError(
            f"axes.{name} = {value!r}: must have {len(keys)} values, one for each key"
        )
    return tuple(value)


def _is_finite_number(value: Any) -> bool:
    return (
        isinstance(value, int | float)
        and not isinstance(value, bool)
        and isfinite(value)
    )


def _changes_modes(axis: Axis) -> bool:
    return any(key.partition(".")[0] in MODE_SECTIONS for key in axis.keys)
