"""SCENE -> DECLINE: how fast the contact of a disk goes round so long before the end, whatever
shares slow it.

A disk in steady motion with a fixed centre loses energy slowly: dE(beta)/dt = -P(beta), with the
power of contour friction, P = rolling m g R Omega, of the film of air, P = air P_film, and of the
other laws of a scene, P = law P_law."""

from copy import copy
from dataclasses import replace
from functools import cached_property
from math import atan

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.interpolate import CubicHermiteSpline, CubicSpline
from scipy.ndimage import convolve1d

from dynamics import simulate
from dynamics.disk import Friction, Release
from dynamics.dissipation import Dissipation, resistance_of
from dynamics.equations import disk_constants
from dynamics.film.wedge import film_under
from dynamics.kinematics import energy
from dynamics.observables import nutation_peaks, nutations_per_turn
from dynamics.quasi_steady import steady_power
from dynamics.steady_motion import steady_precession
from dynamics.surface import Surface
from sonify.scene import Scene

LAWS = ("rolling", "air", "law")
"""What slows a disk: contour friction, the film, and whatever else its scene names."""
LEAST_LEFT, SOLVED, PLACES = 2e-3, 4000, 8
"""A solved motion is told to so little time left [s], from a table of so many times, in so many
places a turn."""
TOLERANCE = 1e-12
"""Relative tolerance of a motion that is averaged so: 1e-2 of a turn in a thousand."""
BLOCK = 16
"""Turns over which a solved motion is averaged, as a sound is."""
SMOOTH = np.hanning(2 * PLACES + 1)[1:-1] / PLACES
"""Means over a turn or two: what a nutation adds to the turns in between is no change of their
rate."""
SUM = "their sum"
"""The line that is heard as often as disk and contact turn and nutate together."""
NUTATING = (0.005, 0.02, 0.08, 0.3)
"""Inclinations [rad] at which the nutation is solved."""
LEAST_ROLLING = 1e-12
"""A disk that nothing slows is slowed by so small a share of contour friction."""
SQUEEZED = 1e-7
"""A film that is squeezed takes as little as so much contour friction, which is next to nothing:
with none at all the disk would stay on it, and the end would hang on what cannot be heard."""
LEAST_AIR = 1e-3
"""A film of less than this share is none."""
FACTORS = {
    "power_coefficient": 1,
    "air_viscosity": 1,
    "boundary_layer_viscosity": 2,
    "viscous_moment": 1,
    "viscous_force": 1,
}
"""What a share of the scene's other laws multiplies, besides the arms of its friction: this power
of it."""
FLATTEST, POINTS = 1e-7, 600
"""The least inclination [rad] that is tabulated, and how many are, evenly in the logarithm."""
LEAST_GROWTH = 0.49
"""Below the table the time left goes at least with this power of the inclination: with 1/2 under
the paper's arm, and with none under a film that is squeezed, which alone would never let the disk
down."""


def left_out(scene: Scene) -> list[str]:
    """Return what of a scene no decline has, as sentences: its shares then stand for more than
    their names say."""
    from dynamics.compliant.two_way_onset import may_be_two_way  # loads SciPy

    means = "what it takes counts as rolling, air or law, whose intervals need not hold the truth: no verdict is told"
    found = {
        "the table acts back": may_be_two_way(scene),
        "the table is wavy": scene.imperfection is not None,
    }
    return [f"{what}: {means}" for what, here in found.items() if here]


def has_film(scene: Scene) -> bool:
    """Return whether there is air under the disk of a scene whose film is known."""
    return scene.disk.shape == "solid" and scene.air.film != "none" and scene.air.pressure > 0


class Decline:
    """The steady decline of the disk of a scene. Shown by tests/fitting/test_fit.py."""

    ahead = np.zeros((2, 1))
    """Times left (k,) [s], rising, and how many turns more than in steady motion were made up to
    then (k,)."""
    own: np.ndarray | None = None
    """The shares (3,) with which that motion was solved."""

    faster = 0.0
    """log(rate solved / steady) (b,) at every inclination that a steady motion has so long before
    the end."""

    def __init__(self, scene: Scene):
        self.scene = scene
        self.disk = scene.disk
        self._known: dict[bytes, np.ndarray] = {}
        self._solved: dict[bytes, dict[str, Decline]] = {}
        law = disk_constants(self.disk, Friction(mu_static=1.0, mu_dynamic=1.0))
        steepest = 0.9 * atan((1 + 4 * law.h**2 / (3 * law.K)) / (2 * law.h)) if law.h else 1.2
        self.beta = np.geomspace(FLATTEST, min(steepest, 1.2), POINTS)
        rate = np.array([steady_precession(b, law.h, law.K) for b in self.beta])
        w3 = rate * np.sin(self.beta)
        self.energy = energy(self.beta, (0.0, law.h * w3, w3), (0.0, 0.0), law)
        self.rate = rate / self.disk.time_unit / (2 * np.pi)
        contour = resistance_of(
            Dissipation(contour_moment=self.disk.weight * self.disk.radius), self.disk
        )
        film = film_under(self.disk, scene.air) if has_film(scene) else None
        own = resistance_of(replace(scene.dissipation, contour_moment=0.0), self.disk)
        own_law = disk_constants(self.disk, scene.friction)
        self.powers = np.array(
            [
                [steady_power(b, law, contour) for b in self.beta],
                film.powers(self.beta, (0.0, law.h * w3, w3))[0] if film else 0 * self.beta,
                [steady_power(b, own_law, own) for b in self.beta],
            ]
        )
        if film:
            self.powers[1] = np.maximum(self.powers[1], SQUEEZED * self.powers[0])

    @property
    def has_film(self) -> bool:
        """Whether there is air under this disk whose film is known."""
        return bool(self.powers[1].any())

    @property
    def has_law(self) -> bool:
        """Whether the scene names another resistance than contour friction and the film."""
        return bool(self.powers[2].any())

    @cached_property
    def left_out(self) -> list[str]:
        """What of the scene it does not have."""
        return left_out(self.scene)

    @cached_property
    def _slope(self):
        return CubicSpline(np.log(self.beta), self.energy).derivative()(
            np.log(self.beta)
        )  # dE/d(log beta)

    @cached_property
    def lines(self) -> dict[str, "Decline"]:
        """The decline as it is heard: once or twice in a turn of the contact, once in a nutation,
        and as often as both together, where the tilting disk nutates."""
        ratios = {"its double": 2.0, "nutation": self._nutation, SUM: 1.0 + self._nutation}
        return {"precession": self} | {name: self._heard(ratio) for name, ratio in ratios.items()}

    def _heard(self, ratio):
        other = copy(self)
        other.rate = self.rate * ratio
        return other

    @cached_property
    def _nutation(self):
        """How often the disk nutates in a turn of the contact (b,): from short motions without
        losses."""
        found = [self._nutations(beta) for beta in NUTATING]
        return np.interp(np.log(self.beta), np.log(NUTATING), found)

    def _nutations(self, beta):
        turns = float(np.interp(beta, self.beta, self.rate))
        w3 = 2 * np.pi * turns * np.sin(beta)
        release = Release(
            inclination_deg=float(np.degrees(1.02 * beta)), omega=(0.0, self.disk.aspect * w3, w3)
        )
        numerics = replace(self.scene.numerics, time_limit=12 / turns)
        scene = replace(
            self._scene_of(0.0, 0.0, 0.0), friction=Friction(mu_static=10.0, mu_dynamic=10.0)
        )
        motion = simulate(replace(scene, release=release, numerics=numerics))
        return float(np.median(nutations_per_turn(motion)))

    def left(self, shares) -> np.ndarray:
        """Return the time left [s] (b,) at every inclination, for shares (3,) of the LAWS; the last
        is remembered."""
        key = np.asarray(shares, float).tobytes()
        if key not in self._known:
            self._known.clear()
            rate = self._passing(shares)  # below the table a power of the inclination
            growth = max(np.log(rate[1] / rate[0]) / self._step, LEAST_GROWTH)
            self._known[key] = self._integral(rate) + rate[0] / growth
        return self._known[key]

    @property
    def _step(self):
        return np.log(self.beta[1] / self.beta[0])

    def _passing(self, shares):
        """d(time left)/d(log inclination) [s] (b,)."""
        power = np.maximum(np.asarray(shares, float) @ self.powers, LEAST_ROLLING * self.powers[0])
        return self._slope / power * self.disk.time_unit

    def _integral(self, rate):
        """The integral (b,) of a rate (b,) over the logarithm of the inclination: of cubics through
        four points."""
        padded = np.concatenate([[_beyond(rate[:4])], rate, [_beyond(rate[:-5:-1])]])
        each = 13 * (padded[1:-2] + padded[2:-1]) - padded[:-3] - padded[3:]
        return self._step / 24 * np.append(0.0, np.cumsum(each))

    def _left_at(self, inclination, shares):
        """The time left [s] at an inclination [rad], below the table as a power of it."""
        time = self.left(shares)
        growth = np.log(time[1] / time[0]) / self._step
        below = min(inclination / self.beta[0], 1.0) ** growth
        return float(np.interp(inclination, self.beta, time) * below)

    def course(self, shares) -> np.ndarray:
        """Return times left [s], the periods still to come up to the flattest inclination, and how
        many there are a second [Hz], (3, b): of a solved motion, where this is a line of one, with
        its own shares."""
        shares = shares if self.own is None else self.own
        time = self.left(shares)
        turned = self._integral(self.rate * self._passing(shares))
        return (
            self._overtaken(time, turned)
            if self.ahead.any()
            else np.array([time, turned, self.rate])
        )

    def _overtaken(self, time, turned):
        """The course of a steady motion, and what a solved one is ahead of it."""
        left = self.ahead[0]
        left = np.concatenate([time[time < left[0]], left, time[time > left[-1]]])
        turned = _spline(time, turned, self.rate)(np.log(left)) - np.interp(left, *self.ahead)
        rate = np.gradient(turned, left)
        if rate.min() <= 0:
            raise ValueError("the solved motion is far from every steady one")
        return np.array([left, turned, rate])

    def turns(self, left, shares) -> tuple[np.ndarray, np.ndarray]:
        """Return the same periods, and how many there are a second [Hz], at times left (k,) [s] >
        0."""
        time, turned, rate = self.course(shares)
        spline = _spline(time, turned, rate)
        within = np.log(np.clip(left, time[0], time[-1]))
        return spline(within), spline.derivative()(within) / np.exp(within)

    def frequency(self, left, shares) -> np.ndarray:
        """Return periods a second [Hz] at times left (k,) [s] > 0, smoothed over slips."""
        return np.exp(
            np.interp(np.log(left), np.log(self.left(shares)), np.log(self.rate) + self.faster)
        )

    def inclination(self, left, shares) -> np.ndarray:
        """Return the inclination [rad] at times left (k,) [s]."""
        return np.exp(np.interp(np.log(left), np.log(self.left(shares)), np.log(self.beta)))

    def solved(self, shares) -> dict[str, "Decline"]:
        """Return the lines corrected by a solved motion: its centre moves, which no steady motion's
        does, and it slips.

        The motion is that of the scene, with shares (3,) of the LAWS; the lines are remembered.
        Raises ValueError where it cannot be solved."""
        key = np.asarray(shares, float).tobytes()
        if key not in self._solved:
            self._solved[key] = self._lines_of(shares)
        return self._solved[key]

    def _lines_of(self, shares):
        motion = simulate(self._scene_of(*map(float, shares)))
        end = motion.t[-1] + self._left_at(motion.at(motion.t[-1:])[0, 1], shares)
        peaks = nutation_peaks(motion)

        def turned(t):
            return np.abs(motion.at(t)[:, 0]) / (2 * np.pi)

        def nutated(t):
            return np.interp(t, peaks, np.arange(len(peaks)), left=np.nan, right=np.nan)

        counts = {
            "precession": turned,
            "its double": lambda t: 2 * turned(t),
            "nutation": nutated,
            SUM: lambda t: turned(t) + nutated(t),
        }
        found = {
            name: self.lines[name]._along(count, motion.t[-1], end, shares)
            for name, count in counts.items()
        }
        return {name: line for name, line in found.items() if line is not None}

    def _along(self, count, last, end, shares):
        """The line as `count(t)` (k,) has it in a motion up to the time `last`; None where that
        says little."""
        left = np.geomspace(end, max(end - last, LEAST_LEFT), SOLVED)
        steady = self.turns(left, shares)[0]
        even = np.arange(steady[0], steady[-1], -1 / PLACES)
        left = np.interp(even, steady[::-1], left[::-1])
        excess = count(np.clip(end - left, 0.0, last)) + even
        here = np.isfinite(excess)
        other = copy(self)
        left = left[here]
        excess = excess[here]
        other.own = np.array(shares, float)
        other.ahead = np.array([left, convolve1d(excess, SMOOTH, mode="nearest")])[:, ::-1]
        other.faster = np.interp(
            self.left(shares), *_slopes(left, excess, self.frequency(left, shares))
        )
        return other

    def _scene_of(self, rolling, air, law):
        scene = self.scene
        arms = {
            arm: law * vars(scene.friction)[arm]
            for arm in ("arm_nutation", "arm_rolling", "arm_pivoting")
        }
        own = {name: law**power * vars(scene.dissipation)[name] for name, power in FACTORS.items()}
        return replace(
            scene,
            friction=replace(scene.friction, **arms),
            dissipation=replace(
                scene.dissipation,
                contour_moment=rolling * self.disk.weight * self.disk.radius,
                **own,
            ),
            air=replace(scene.air, film="acts", viscosity=air * scene.air.viscosity)
            if air > LEAST_AIR
            else replace(scene.air, film="none"),
            contact=replace(scene.contact, law="rigid"),
            surface=Surface(),
            numerics=replace(scene.numerics, tolerance=TOLERANCE),
        )


def _spline(time, turned, rate):
    """The cubic of turns (b,) over the logarithm of times (b,) between which there are so many a
    second (b,)."""
    return CubicHermiteSpline(np.log(time), turned, rate * time)


def _beyond(near):
    """What comes before the first of four values on a cubic."""
    return 4 * near[0] - 6 * near[1] + 4 * near[2] - near[3]


def _slopes(left, excess, frequency):
    """Middles (b,) [s] of blocks of even turns, rising, and log(solved / steady) there, of the
    slope of what is turned in excess (k,) at times left (k,) [s] over the `frequency` (k,) [Hz],
    with a Hann window."""
    size = BLOCK * PLACES
    window = np.sin(np.pi * (np.arange(size) + 0.5) / size) ** 2
    left, excess, frequency = (
        sliding_window_view(x, size)[:: size // 4] for x in (left, excess, frequency)
    )
    middle = left @ window / window.sum()
    since = (middle[:, None] - left) * window
    slope = (
        np.sum(since * excess, axis=1)
        / np.sum(since * -left, axis=1)
        / (frequency @ window / window.sum())
    )
    return middle[::-1], np.log1p(np.clip(slope, -0.5, 0.5))[::-1]
