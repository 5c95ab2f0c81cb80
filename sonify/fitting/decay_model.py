"""Precession rate of a disk as a function of the remaining time, for given shares of
dissipation.

A disk in steady motion with a fixed centre loses energy slowly: dE(beta)/dt = -P(beta).
The power P is the sum of three laws: contour friction, P = rolling m g R Omega; the air
film, P = air P_film; and the other laws of the scene, P = law P_law."""

from collections.abc import Callable
from copy import copy
from dataclasses import replace
from functools import cached_property
from math import atan

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.interpolate import CubicHermiteSpline, CubicSpline
from scipy.ndimage import convolve1d

from dynamics import plan_motion, simulate
from dynamics.disk import Friction, Release
from dynamics.dissipation import Dissipation, resistance_of
from dynamics.equations import disk_constants
from dynamics.film.wedge import film_of_scene, hole_share
from dynamics.kinematics import energy
from dynamics.observables import nutation_peaks, nutations_per_turn
from dynamics.quasi_steady import steady_power
from dynamics.scene_constants import scene_constants
from dynamics.steady_motion import steady_precession
from dynamics.surface import Surface
from sonify.fitting.settings import FIT
from sonify.scene import Scene

FITTED_LAWS = ("rolling", "air", "law")
"""Names of the shares: contour friction, the air film, and the other laws of the
scene."""
NUTATION_SMOOTHING = np.hanning(2 * FIT.phases_per_turn + 1)[1:-1] / FIT.phases_per_turn
"""Weights of a running mean over two turns, which removes the nutation."""
SUM_LINE = "their sum"
"""Name of the spectral line at the sum of the precession and nutation rates."""
LAW_EXPONENTS = {
    "power_coefficient": 1,
    "air_viscosity": 1,
    "boundary_layer_viscosity": 2,
    "viscous_moment": 1,
    "viscous_force": 1,
}
"""Exponent of the share `law` in the factor on each constant of the scene's other
laws."""


def neglected_parts(scene: Scene) -> list[str]:
    """Return sentences on the parts of a scene that `DecayModel` neglects.

    Their dissipation is attributed to the fitted shares.
    """
    means = (
        "its dissipation is attributed to rolling, air or law, and their intervals may not contain the "
        "true values; no verdict is given"
    )
    found = {
        "the table may affect the motion": plan_motion(scene).may_be_two_way,
        "the table is wavy": scene.imperfection is not None,
    }
    return [f"{what}: {means}" for what, here in found.items() if here]


def rigid_table(scene: Scene) -> Surface:
    """Return a rigid table with the shape of the table of a scene."""
    table = scene.surface
    if not table.curvature:
        return Surface(hole=table.hole)
    return Surface(
        sag=table.sag, diameter=table.diameter, place=table.place, hole=table.hole
    )


def has_film(scene: Scene) -> bool:
    """Return True if the scene has an air film with a known law."""
    return hole_share(scene) < 1 and scene.air.film != "none" and scene.air.pressure > 0


class DecayModel:
    """Quasi-steady decay of the motion of a disk, with the rate of one spectral
    line."""

    energy_slope: np.ndarray
    """Derivative (b,) of the energy with respect to the log inclination."""

    excess_turns = np.zeros((2, 1))
    """Ascending remaining times (k,) [s], and the turns (k,) of a solved motion in
    excess of those of the steady motion."""
    solved_shares: np.ndarray | None = None
    """Shares (3,) for which the solved motion was computed; None for steady motion."""

    third_share_name = "law"
    """Name of the third share, for the other laws of the scene or for impacts."""

    log_rate_ratio = 0.0
    """log(solved rate / steady rate) (b,) at the remaining times of the tabulated
    inclinations."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.disk = scene.disk
        self._solved: dict[bytes, dict[str, DecayModel]] = {}
        law = disk_constants(self.disk, Friction(mu_static=1.0, mu_dynamic=1.0))
        steepest = (
            0.9 * atan((1 + 4 * law.h**2 / (3 * law.K)) / (2 * law.h)) if law.h else 1.2
        )
        min_inclination = 1e-7
        inclination_count = 600
        self.beta = np.geomspace(min_inclination, min(steepest, 1.2), inclination_count)
        log_beta = np.log(self.beta)
        rate = np.array([steady_precession(b, law.h, law.K) for b in self.beta])
        w3 = rate * np.sin(self.beta)
        spin = (0.0, law.h * w3, w3)
        stored = energy(self.beta, spin, (0.0, 0.0), law)
        self.energy_slope = CubicSpline(log_beta, stored).derivative()(log_beta)
        self.rate = rate / self.disk.time_unit / (2 * np.pi)
        weight_moment = self.disk.weight * self.disk.radius
        contour = resistance_of(Dissipation(contour_moment=weight_moment), self.disk)
        contour_power = np.array([steady_power(b, law, contour) for b in self.beta])
        film_power = np.zeros(len(self.beta))
        if has_film(scene):
            film = film_of_scene(scene)
            film_power = film.rotation_and_fall_powers(self.beta, spin)[0]
            # without this limit, the disk would never reach the table, and the end would
            # depend on inaudible details
            film_power = np.maximum(film_power, 1e-7 * contour_power)
        own = resistance_of(replace(scene.dissipation, contour_moment=0.0), self.disk)
        own_law = scene_constants(scene)
        own_power = [steady_power(b, own_law, own) for b in self.beta]
        self.powers = np.array([contour_power, film_power, own_power])

    @cached_property
    def line_models(self) -> dict[str, "DecayModel"]:
        """The decay with the rate of each spectral line, by name.

        The lines are at the precession rate, twice this rate, the nutation rate, and
        the sum of precession and nutation rates, which a tilting disk radiates."""
        ratios: dict[str, float | np.ndarray] = {
            "its double": 2.0,
            "nutation": self._nutation_frequency_ratio,
            SUM_LINE: 1.0 + self._nutation_frequency_ratio,
        }
        lines = {"precession": self}
        for name, ratio in ratios.items():
            lines[name] = copy(self)
            lines[name].rate = self.rate * ratio
        return lines

    @cached_property
    def _nutation_frequency_ratio(self) -> np.ndarray:
        """Nutations per turn of the contact (b,), from short motions without losses."""
        inclinations = [0.005, 0.02, 0.08, 0.3]  # rad
        found = [self._nutation_frequency_ratio_at(beta) for beta in inclinations]
        return np.interp(np.log(self.beta), np.log(inclinations), found)

    def _nutation_frequency_ratio_at(self, beta: float) -> float:
        turns = float(np.interp(beta, self.beta, self.rate))
        w3 = 2 * np.pi * turns * np.sin(beta)
        release = Release(
            inclination_deg=float(np.degrees(1.02 * beta)),
            omega=(0.0, self.disk.aspect * w3, w3),
        )
        scene = self._scene_with_shares(0.0, 0.0, 0.0)
        motion = simulate(
            replace(
                scene,
                friction=Friction(mu_static=10.0, mu_dynamic=10.0),
                release=release,
                numerics=replace(scene.numerics, time_limit=12 / turns),
            )
        ).rolling
        return float(np.median(nutations_per_turn(motion)))

    def remaining_time(self, shares: list[float] | np.ndarray) -> np.ndarray:
        """Return the remaining time (b,) [s] at every inclination for shares (3,) of
        the FITTED_LAWS."""
        # below the tabulated inclinations, the time is a power of the inclination; the
        # exponent is 1/2 with the arms of the paper, and 0 for a squeezed film alone
        min_exponent = 0.49
        rate = self._time_per_log_inclination(shares)
        growth = max(
            np.log(rate[1] / rate[0]) / self._log_inclination_step, min_exponent
        )
        return self._integral_over_log_inclination(rate) + rate[0] / growth

    @property
    def _log_inclination_step(self) -> float:
        return np.log(self.beta[1] / self.beta[0])

    def _time_per_log_inclination(self, shares: list[float] | np.ndarray) -> np.ndarray:
        """Return d(remaining time)/d(log inclination) (b,) [s]."""
        min_power = 1e-12 * self.powers[0]
        power = np.maximum(np.asarray(shares, float) @ self.powers, min_power)
        return self.energy_slope / power * self.disk.time_unit

    def _integral_over_log_inclination(self, rate: np.ndarray) -> np.ndarray:
        """Return the integral (b,) of a rate (b,) over the log inclination, by cubic
        interpolation."""
        ends = _extrapolated_value(rate[:4]), _extrapolated_value(rate[:-5:-1])
        padded = np.concatenate([ends[:1], rate, ends[1:]])
        each = 13 * (padded[1:-2] + padded[2:-1]) - padded[:-3] - padded[3:]
        return self._log_inclination_step / 24 * np.append(0.0, np.cumsum(each))

    def _remaining_time_at(self, inclination: float, shares: np.ndarray) -> float:
        """Return the remaining time [s] at an inclination [rad], extrapolated by a
        power law."""
        time = self.remaining_time(shares)
        growth = np.log(time[1] / time[0]) / self._log_inclination_step
        below = min(inclination / self.beta[0], 1.0) ** growth
        return float(np.interp(inclination, self.beta, time) * below)

    def course(self, shares: list[float] | np.ndarray) -> np.ndarray:
        """Return remaining times [s], remaining periods and their rate [Hz] as an array
        (3, b).

        The periods are counted down to the lowest inclination. For a line of a solved
        motion, the shares of that motion replace the given ones."""
        shares = shares if self.solved_shares is None else self.solved_shares
        time = self.remaining_time(shares)
        turned = self._integral_over_log_inclination(
            self.rate * self._time_per_log_inclination(shares)
        )
        if not self.excess_turns.any():
            return np.array([time, turned, self.rate])
        remaining = self.excess_turns[0]
        remaining = np.concatenate(
            [time[time < remaining[0]], remaining, time[time > remaining[-1]]]
        )
        turned = _turn_spline(time, turned, self.rate)(np.log(remaining)) - np.interp(
            remaining, *self.excess_turns
        )
        rate = np.gradient(turned, remaining)
        if rate.min() <= 0:
            raise ValueError("the solved motion is far from any steady motion")
        return np.array([remaining, turned, rate])

    def turns(
        self, remaining: np.ndarray, shares: list[float] | np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the remaining periods and their rate [Hz] at remaining times (k,) > 0
        [s]."""
        time, turned, rate = self.course(shares)
        spline = _turn_spline(time, turned, rate)
        within = np.log(np.clip(remaining, time[0], time[-1]))
        return spline(within), spline.derivative()(within) / np.exp(within)

    def frequency(
        self, remaining: np.ndarray, shares: list[float] | np.ndarray
    ) -> np.ndarray:
        """Return the rate of the periods (k,) [Hz] at remaining times (k,) > 0 [s],
        smoothed over slips."""
        return self.frequency_law(shares)(remaining)

    def frequency_law(
        self, shares: list[float] | np.ndarray
    ) -> Callable[[np.ndarray], np.ndarray]:
        """Return `frequency` as a function of the remaining times (k,) > 0 [s]."""
        return self._interpolant(shares, np.log(self.rate) + self.log_rate_ratio)

    def inclination(self, remaining: np.ndarray, shares: np.ndarray) -> np.ndarray:
        """Return the inclination (k,) [rad] at remaining times (k,) [s]."""
        return self._interpolant(shares, np.log(self.beta))(remaining)

    def _interpolant(
        self, shares: list[float] | np.ndarray, logarithm: np.ndarray
    ) -> Callable[[np.ndarray], np.ndarray]:
        """Return a quantity, given by its logarithm (b,) at the tabulated inclinations,
        as a function of the remaining time."""
        log_time = np.log(self.remaining_time(shares))
        return lambda remaining: np.exp(
            np.interp(np.log(remaining), log_time, logarithm)
        )

    def solved_line_models(self, shares: np.ndarray) -> dict[str, "DecayModel"]:
        """Return the spectral lines of a solved motion with shares (3,) of the FITTED_LAWS, by
        name.

        In contrast to steady motion, the centre moves and the disk slips. The lines are
        cached. Raises ValueError if the motion cannot be solved."""
        key = np.asarray(shares, float).tobytes()
        if key not in self._solved:
            self._solved[key] = self._solved_lines(shares)
        return self._solved[key]

    def _solved_lines(self, shares: np.ndarray) -> "dict[str, DecayModel]":
        motion = simulate(self._scene_with_shares(*map(float, shares))).rolling
        end = motion.t[-1] + self._remaining_time_at(
            motion.at(motion.t[-1:])[0, 1], shares
        )
        peaks = nutation_peaks(motion)

        def turned(t: np.ndarray) -> np.ndarray:
            return np.abs(motion.at(t)[:, 0]) / (2 * np.pi)

        def nutated(t: np.ndarray) -> np.ndarray:
            return np.interp(t, peaks, np.arange(len(peaks)), left=np.nan, right=np.nan)

        counts = {
            "precession": turned,
            "its double": lambda t: 2 * turned(t),
            "nutation": nutated,
            SUM_LINE: lambda t: turned(t) + nutated(t),
        }
        return {
            name: self.line_models[name]._of_solved_motion(
                count, motion.t[-1], end, shares
            )
            for name, count in counts.items()
        }

    def _of_solved_motion(
        self,
        count: Callable[[np.ndarray], np.ndarray],
        last: float,
        end: float,
        shares: np.ndarray,
    ) -> "DecayModel":
        """Return this line with the number of periods `count(t)` of a solved motion.

        The solved motion ends at the time `last` [s], and the decay at `end` [s].
        """
        min_remaining_time = 2e-3  # s
        time_count = 4000
        remaining = np.geomspace(end, max(end - last, min_remaining_time), time_count)
        steady = self.turns(remaining, shares)[0]
        evenly_spaced = np.arange(steady[0], steady[-1], -1 / FIT.phases_per_turn)
        remaining = np.interp(evenly_spaced, steady[::-1], remaining[::-1])
        excess = count(np.clip(end - remaining, 0.0, last)) + evenly_spaced
        here = np.isfinite(excess)
        other = copy(self)
        remaining = remaining[here]
        excess = excess[here]
        other.solved_shares = np.array(shares, float)
        other.excess_turns = np.array(
            [remaining, convolve1d(excess, NUTATION_SMOOTHING, mode="nearest")]
        )[:, ::-1]
        other.log_rate_ratio = np.interp(
            self.remaining_time(shares),
            *_log_solved_to_steady_rates(
                remaining, excess, self.frequency(remaining, shares)
            ),
        )
        return other

    def _scene_with_shares(self, rolling: float, air: float, law: float) -> Scene:
        min_air = 1e-3  # a smaller share of the film is omitted
        tolerance = 1e-12  # an error of 0.01 turns in 1000 turns
        scene = self.scene
        arms = {}
        for arm in ("arm_nutation", "arm_rolling", "arm_pivoting"):
            given = vars(scene.friction)[arm]
            arms[arm] = given if given == "contact" else law * given
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
            if air > min_air
            else replace(scene.air, film="none"),
            contact=replace(scene.contact, law="rigid", restitution=None),
            roughness=None,
            surface=rigid_table(scene),
            numerics=replace(scene.numerics, contact="auto", tolerance=tolerance),
        )


def _turn_spline(
    time: np.ndarray, turned: np.ndarray, rate: np.ndarray
) -> CubicHermiteSpline:
    """Return the cubic Hermite spline of turns (b,) over the log time, with given rates
    (b,)."""
    return CubicHermiteSpline(np.log(time), turned, rate * time)


def _extrapolated_value(near: np.ndarray) -> float:
    """Extrapolate four equidistant values by a cubic to the point before the first."""
    return 4 * near[0] - 6 * near[1] + 4 * near[2] - near[3]


def _log_solved_to_steady_rates(
    remaining: np.ndarray, excess: np.ndarray, frequency: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the ascending centres (b,) [s] of blocks of turns, and log(rate of the
    solved motion / rate of the steady motion) (b,).

    The difference of the rates is the Hann-weighted slope of `excess` (k,), the turns
    of the solved motion in excess of those of the steady motion, over the `remaining`
    times (k,). `frequency` (k,) [Hz] is the rate of the steady motion."""
    turns_per_block = 16
    size = turns_per_block * FIT.phases_per_turn
    window = np.sin(np.pi * (np.arange(size) + 0.5) / size) ** 2
    remaining, excess, frequency = (
        sliding_window_view(x, size)[:: size // 4]
        for x in (remaining, excess, frequency)
    )
    middle = remaining @ window / window.sum()
    since = (middle[:, None] - remaining) * window
    slope = (
        np.sum(since * excess, axis=1)
        / np.sum(since * -remaining, axis=1)
        / (frequency @ window / window.sum())
    )
    return middle[::-1], np.log1p(np.clip(slope, -0.5, 0.5))[::-1]
