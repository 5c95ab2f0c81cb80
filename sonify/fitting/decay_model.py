"""SCENE -> DECLINE: precession rate as a function of the time left, for given shares of
dissipation.

A disk in steady motion with a fixed centre loses energy slowly: dE(beta)/dt = -P(beta). The power P
is the sum of three laws: contour friction, P = rolling m g R Omega; the air film, P = air P_film;
and the other laws of the scene, P = law P_law.
"""

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
"""Names of the shares: contour friction, the air film, and the other laws of the scene."""
MIN_TIME_LEFT = 2e-3
"""Time before the end down to which a solved motion is tabulated [s]."""
SOLVED_TIME_COUNT = 4000
"""Number of times in the table of a solved motion."""
PHASES_PER_TURN = 8
"""Phases per turn in the table of a solved motion."""
MOTION_TOLERANCE = 1e-12
"""Relative tolerance of a solved motion; it corresponds to 1e-2 of a turn in a thousand."""
TURNS_PER_BLOCK = 16
"""Number of turns over which a solved motion is averaged, as for a sound."""
NUTATION_SMOOTHING = np.hanning(2 * PHASES_PER_TURN + 1)[1:-1] / PHASES_PER_TURN
"""Weights of a running mean over two turns, which removes the nutation between them."""
SUM_LINE = "their sum"
"""Name of the spectral line at the sum of the precession and nutation rates."""
NUTATION_INCLINATIONS = (0.005, 0.02, 0.08, 0.3)
"""Inclinations at which the nutation rate is computed [rad]."""
MIN_ROLLING_SHARE = 1e-12
"""Least share of contour friction, for a disk without any dissipation."""
MIN_FILM_POWER_SHARE = 1e-7
"""Share of contour friction that replaces the power of a squeezed film. Without it, the disk would
never reach the table, and the end would depend on inaudible details."""
MIN_AIR_SHARE = 1e-3
"""A film of a smaller share is left out of the solved motion."""
LAW_EXPONENTS = {
    "power_coefficient": 1,
    "air_viscosity": 1,
    "boundary_layer_viscosity": 2,
    "viscous_moment": 1,
    "viscous_force": 1,
}
"""Constants of the scene's other laws, and the power of the share `law` that multiplies each."""
MIN_INCLINATION = 1e-7
"""Least inclination of the table [rad]."""
INCLINATION_COUNT = 600
"""Number of inclinations in the table, evenly spaced in the logarithm."""
MIN_TIME_EXPONENT = 0.49
"""Least exponent of the time left as a power of the inclination below the table. It is 1/2 with the
arms of the paper, and would be 0 under a squeezed film alone."""


def neglected_parts(scene: Scene) -> list[str]:
    """Return sentences on the parts of a scene that no `Decline` includes.

    Their loss is attributed to the fitted shares.
    """
    from dynamics.compliant.two_way_onset import may_be_two_way  # loads SciPy

    means = "what it takes counts as rolling, air or law, whose intervals need not hold the truth: no verdict is told"
    found = {
        "the table acts back": may_be_two_way(scene),
        "the table is wavy": scene.imperfection is not None,
    }
    return [f"{what}: {means}" for what, here in found.items() if here]


def has_film(scene: Scene) -> bool:
    """Return True if the scene has an air film with a known law."""
    return scene.disk.shape == "solid" and scene.air.film != "none" and scene.air.pressure > 0


class Decline:
    """Steady decline of the disk of a scene, seen in one spectral line."""

    ahead = np.zeros((2, 1))
    """Times left (k,) [s], ascending, and the turns (k,) of a solved motion in excess of the steady
    one."""
    own: np.ndarray | None = None
    """Shares (3,) for which that motion was solved; None for steady motion."""

    faster = 0.0
    """log(solved rate / steady rate) (b,) at the times left of the tabulated inclinations."""

    def __init__(self, scene: Scene):
        self.scene = scene
        self.disk = scene.disk
        self._known: dict[bytes, np.ndarray] = {}
        self._solved: dict[bytes, dict[str, Decline]] = {}
        law = disk_constants(self.disk, Friction(mu_static=1.0, mu_dynamic=1.0))
        steepest = 0.9 * atan((1 + 4 * law.h**2 / (3 * law.K)) / (2 * law.h)) if law.h else 1.2
        self.beta = np.geomspace(MIN_INCLINATION, min(steepest, 1.2), INCLINATION_COUNT)
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
            self.powers[1] = np.maximum(self.powers[1], MIN_FILM_POWER_SHARE * self.powers[0])

    @property
    def has_film(self) -> bool:
        """True if the disk has an air film with a known law."""
        return bool(self.powers[1].any())

    @property
    def has_law(self) -> bool:
        """True if the scene has other laws of dissipation."""
        return bool(self.powers[2].any())

    @cached_property
    def left_out(self) -> list[str]:
        """Sentences on the parts of the scene that are not included."""
        return neglected_parts(self.scene)

    @cached_property
    def _slope(self):
        return CubicSpline(np.log(self.beta), self.energy).derivative()(
            np.log(self.beta)
        )  # dE/d(log beta)

    @cached_property
    def lines(self) -> dict[str, "Decline"]:
        """The decline as seen in each spectral line, by name.

        The lines are the precession rate, its double, the nutation rate, and the sum of precession
        and nutation, which a tilting disk radiates.
        """
        ratios = {"its double": 2.0, "nutation": self._nutation, SUM_LINE: 1.0 + self._nutation}
        return {"precession": self} | {name: self._heard(ratio) for name, ratio in ratios.items()}

    def _heard(self, ratio):
        other = copy(self)
        other.rate = self.rate * ratio
        return other

    @cached_property
    def _nutation(self):
        """Nutations per turn of the contact (b,), from short motions without losses."""
        found = [self._nutations(beta) for beta in NUTATION_INCLINATIONS]
        return np.interp(np.log(self.beta), np.log(NUTATION_INCLINATIONS), found)

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
        """Return the time left [s] (b,) at every inclination for shares (3,) of the LAWS.

        The last result is cached.
        """
        key = np.asarray(shares, float).tobytes()
        if key not in self._known:
            self._known.clear()
            rate = self._passing(shares)  # below the table a power of the inclination
            growth = max(np.log(rate[1] / rate[0]) / self._step, MIN_TIME_EXPONENT)
            self._known[key] = self._integral(rate) + rate[0] / growth
        return self._known[key]

    @property
    def _step(self):
        return np.log(self.beta[1] / self.beta[0])

    def _passing(self, shares):
        """Return d(time left)/d(log inclination) [s] (b,)."""
        power = np.maximum(
            np.asarray(shares, float) @ self.powers, MIN_ROLLING_SHARE * self.powers[0]
        )
        return self._slope / power * self.disk.time_unit

    def _integral(self, rate):
        """Return the integral (b,) of a rate (b,) over the log inclination, by cubic interpolation."""
        padded = np.concatenate(
            [[_extrapolated_value(rate[:4])], rate, [_extrapolated_value(rate[:-5:-1])]]
        )
        each = 13 * (padded[1:-2] + padded[2:-1]) - padded[:-3] - padded[3:]
        return self._step / 24 * np.append(0.0, np.cumsum(each))

    def _left_at(self, inclination, shares):
        """Return the time left [s] at an inclination [rad]; below the table it is a power law."""
        time = self.left(shares)
        growth = np.log(time[1] / time[0]) / self._step
        below = min(inclination / self.beta[0], 1.0) ** growth
        return float(np.interp(inclination, self.beta, time) * below)

    def course(self, shares) -> np.ndarray:
        """Return the times left [s], the remaining periods and their rate [Hz], as (3, b).

        The periods are counted down to the flattest inclination. For a line of a solved motion, the
        shares of that motion replace those given.
        """
        shares = shares if self.own is None else self.own
        time = self.left(shares)
        turned = self._integral(self.rate * self._passing(shares))
        return (
            self._overtaken(time, turned)
            if self.ahead.any()
            else np.array([time, turned, self.rate])
        )

    def _overtaken(self, time, turned):
        """Return the course of a steady motion plus the excess turns of the solved one."""
        left = self.ahead[0]
        left = np.concatenate([time[time < left[0]], left, time[time > left[-1]]])
        turned = _turn_spline(time, turned, self.rate)(np.log(left)) - np.interp(left, *self.ahead)
        rate = np.gradient(turned, left)
        if rate.min() <= 0:
            raise ValueError("the solved motion is far from every steady one")
        return np.array([left, turned, rate])

    def turns(self, left, shares) -> tuple[np.ndarray, np.ndarray]:
        """Return the remaining periods and their rate [Hz] at times left (k,) [s] > 0."""
        time, turned, rate = self.course(shares)
        spline = _turn_spline(time, turned, rate)
        within = np.log(np.clip(left, time[0], time[-1]))
        return spline(within), spline.derivative()(within) / np.exp(within)

    def frequency(self, left, shares) -> np.ndarray:
        """Return the rate of the periods [Hz] at times left (k,) [s] > 0, smoothed over slips."""
        return np.exp(
            np.interp(np.log(left), np.log(self.left(shares)), np.log(self.rate) + self.faster)
        )

    def inclination(self, left, shares) -> np.ndarray:
        """Return the inclination [rad] at times left (k,) [s]."""
        return np.exp(np.interp(np.log(left), np.log(self.left(shares)), np.log(self.beta)))

    def solved(self, shares) -> dict[str, "Decline"]:
        """Return the spectral lines, corrected by a solved motion with shares (3,) of the LAWS.

        Unlike in steady motion, its centre moves and it slips. The lines are cached. Raises
        ValueError if the motion cannot be solved.
        """
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
            SUM_LINE: lambda t: turned(t) + nutated(t),
        }
        found = {
            name: self.lines[name]._along(count, motion.t[-1], end, shares)
            for name, count in counts.items()
        }
        return {name: line for name, line in found.items() if line is not None}

    def _along(self, count, last, end, shares):
        """Return this line with the count of periods of a solved motion, `count(t)`.

        The motion ends at the time `last`, and the decline at `end`.
        """
        left = np.geomspace(end, max(end - last, MIN_TIME_LEFT), SOLVED_TIME_COUNT)
        steady = self.turns(left, shares)[0]
        even = np.arange(steady[0], steady[-1], -1 / PHASES_PER_TURN)
        left = np.interp(even, steady[::-1], left[::-1])
        excess = count(np.clip(end - left, 0.0, last)) + even
        here = np.isfinite(excess)
        other = copy(self)
        left = left[here]
        excess = excess[here]
        other.own = np.array(shares, float)
        other.ahead = np.array([left, convolve1d(excess, NUTATION_SMOOTHING, mode="nearest")])[
            :, ::-1
        ]
        other.faster = np.interp(
            self.left(shares), *_log_rate_ratios(left, excess, self.frequency(left, shares))
        )
        return other

    def _scene_of(self, rolling, air, law):
        scene = self.scene
        arms = {
            arm: law * vars(scene.friction)[arm]
            for arm in ("arm_nutation", "arm_rolling", "arm_pivoting")
        }
        own = {
            name: law**power * vars(scene.dissipation)[name]
            for name, power in LAW_EXPONENTS.items()
        }
        return replace(
            scene,
            friction=replace(scene.friction, **arms),
            dissipation=replace(
                scene.dissipation,
                contour_moment=rolling * self.disk.weight * self.disk.radius,
                **own,
            ),
            air=replace(scene.air, film="acts", viscosity=air * scene.air.viscosity)
            if air > MIN_AIR_SHARE
            else replace(scene.air, film="none"),
            contact=replace(scene.contact, law="rigid"),
            surface=Surface(),
            numerics=replace(scene.numerics, tolerance=MOTION_TOLERANCE),
        )


def _turn_spline(time, turned, rate):
    """Return the cubic Hermite spline of the turns (b,) over the log time, with given rates (b,)."""
    return CubicHermiteSpline(np.log(time), turned, rate * time)


def _extrapolated_value(near):
    """Return the value before the first of four equidistant values, extrapolated by a cubic."""
    return 4 * near[0] - 6 * near[1] + 4 * near[2] - near[3]


def _log_rate_ratios(left, excess, frequency):
    """Return the middles (b,) [s] of blocks of turns, ascending, and log(solved / steady rate)
    there.

    The rate follows from the slope of the excess turns (k,) over the times left (k,), with a Hann
    window, relative to the `frequency` (k,) [Hz].
    """
    size = TURNS_PER_BLOCK * PHASES_PER_TURN
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
