"""Verdict on impacts for a disk that is detected only by its bursts.

Impacts on an uneven table reduce the inclination as d beta/dt = -c sqrt(g/R)
(beta/beta_1)^q, so that the rate rises as (t_end - t)^-n with 1 - q = 1/(2 n) and n =
(2 - H)/(4 - H) for a power spectrum k^-(1 + 2 H) of the heights. Contour friction gives
n = 1/3, and an air film a smaller n."""

from copy import copy
from typing import TYPE_CHECKING, Any

import numpy as np

from dynamics.disk import GRAVITY
from sonify.fitting.decay_model import (
    FITTED_LAWS,
    DecayModel,
    has_film,
    neglected_parts,
)
from sonify.fitting.least_squares import Fit, LineRates
from sonify.fitting.line_selection import (
    Judged,
    RecordedRun,
    fit_same_disk,
    with_model_error,
)
from sonify.fitting.settings import FIT
from sonify.hearing.recording_errors import RecordingError
from sonify.hearing.settling.settings import SETTLING

if TYPE_CHECKING:
    from sonify.hearing.settling.joint_region import Estimate, JointRegion
    from sonify.scene import Scene


def judge_sound(decay: DecayModel, sound: RecordedRun) -> Judged:
    """Return the result for a sound, from the phase of a tone or from the law of its
    bursts.

    The bursts decide if no tone can be tracked, or if the rate rises more steeply than
    with contour friction and no other law of the scene explains it. Raises
    RecordingError if neither tone nor bursts can be tracked."""
    has_bursts = sound.run.kind == "repetition"
    try:
        judged = fit_same_disk(decay, sound)
    except RecordingError:
        if not has_bursts:
            raise
        return judge_bursts(decay, sound)
    own_law = judged.fitted_shares().get("law")
    explained = own_law is not None and own_law.inner[0] <= 1.0 <= own_law.inner[1]
    if has_bursts and not explained:
        bursts = judge_bursts(decay, sound)
        if bursts.verdict != "cannot tell":
            return bursts
    return with_model_error(judged)


def judge_bursts(decay: DecayModel, sound: RecordedRun) -> Judged:
    """Return the result of a fit of the law of impacts to the run of a sound.

    The limits of the other laws are those at which one of them would dissipate all of the
    power at an inclination of the run."""
    run = sound.run
    region = run.region
    name = "its double" if run.events_per_turn == 2 else "precession"
    line = decay.line_models[name]
    fall = np.sqrt(GRAVITY / decay.disk.radius)

    def loss_coefficient(rate: float | np.ndarray, exponent: float | np.ndarray) -> Any:
        beta = _inclination_at_rate(line, rate)
        return 2 * exponent * beta / (run.reference_time * fall)

    with_impacts = _line_with_impacts(decay, line, region)
    best = loss_coefficient(region.best_rate, region.best_exponent)
    cells = loss_coefficient(region.rates, region.exponents)
    least_error = SETTLING.exponent_resolution / region.best_exponent * best
    low = cells.min() - least_error
    high = cells.max() + least_error
    fitted = _fit_of_impacts(sound, with_impacts, (low, best, high))
    ridge = sound.ridges[0]
    remaining = np.maximum(region.best_end - ridge.time, FIT.unused_end_duration)
    # earlier rates do not depend on the end
    heard_rates = ridge.frequency[remaining > run.t_end.high - run.t_end.low]
    verdict, reason = _verdict(decay, run.exponent)
    return Judged(
        run=run,
        signal="repetition",
        line=name,
        model="steady",
        decay=with_impacts,
        stream=None,
        fit=fitted,
        explained=True,
        verdict=verdict,
        reason=reason,
        limits=_limits(decay.scene, with_impacts, heard_rates, high),
    )


def _fit_of_impacts(
    sound: RecordedRun, with_impacts: DecayModel, loss: tuple[float, float, float]
) -> Fit:
    """Return the fit with the lower limit, the best value and the upper limit of the
    coefficient of impacts."""
    low, best, high = loss
    run = sound.run
    end = run.region.best_end
    shares = np.array([0.0, 0.0, best])
    draws = np.zeros((FIT.bootstrap_draws, 4))
    random = np.random.default_rng(0)
    draws[:, 0] = _draws_with_interval(end, run.t_end.low, run.t_end.high, random)
    draws[:, 3] = _draws_with_interval(best, low, high, random)
    ridge = sound.ridges[0]
    remaining = np.maximum(end - ridge.time, FIT.unused_end_duration)
    return Fit(
        free=(2,),
        ends=np.array([end]),
        shares=shares,
        draws=draws,
        heard=(LineRates(with_impacts, ridge, ridge.frequency),),
        residual=np.log(ridge.frequency / with_impacts.frequency(remaining, shares)),
        sigma=ridge.error / ridge.frequency,
    )


def _inclination_at_rate(line: DecayModel, rate: float | np.ndarray) -> Any:
    """Return the inclinations [rad] of a line at its frequencies [Hz]."""
    return np.interp(-rate, -line.rate, line.beta)


def _line_with_impacts(
    decay: DecayModel, line: DecayModel, region: "JointRegion"
) -> DecayModel:
    """Return a copy of a line whose third power is that of the best law of impacts of a
    joint region."""
    fall = np.sqrt(GRAVITY / decay.disk.radius)
    with_impacts = copy(line)
    with_impacts.third_share_name = "impacts"
    power = line.powers.copy()
    beyond = line.beta / _inclination_at_rate(line, region.best_rate)
    steepness = 1 - 1 / (2 * region.best_exponent)
    power[2] = (
        line.energy_slope / line.beta * beyond**steepness * fall * decay.disk.time_unit
    )
    with_impacts.powers = power
    return with_impacts


def _limits(
    scene: "Scene", line: DecayModel, rates: np.ndarray, coefficient: float
) -> dict[str, float]:
    """Return by law the limit at which it would dissipate all of the power.

    Impacts dissipate the power at the `coefficient`; `rates` [Hz] are those heard.
    """
    covered = (line.beta >= _inclination_at_rate(line, rates.max())) & (
        line.beta <= _inclination_at_rate(line, rates.min())
    )
    return {
        name: float(
            coefficient * np.min(line.powers[2, covered] / line.powers[number, covered])
        )
        for number, name in enumerate(FITTED_LAWS[:2])
        if name == "rolling" or has_film(scene)
    }


def _draws_with_interval(
    value: float, low: float, high: float, random: np.random.Generator
) -> np.ndarray:
    """Return random draws (d,) with a given median and 95 % interval."""
    normal = random.standard_normal(FIT.bootstrap_draws) / 1.96
    return value + np.where(normal < 0, normal * (value - low), normal * (high - value))


def _verdict(decay: DecayModel, exponent: "Estimate") -> tuple[str, str]:
    """Return the verdict that follows from the interval of an exponent, and its
    reason."""
    contour_exponent = 1 / 3
    max_impact_exponent = 0.6  # for H = -1, ever steeper short waves
    found = f"n is between {exponent.low:.2f} and {exponent.high:.2f}"
    is_undetermined = exponent.high - exponent.low > SETTLING.max_exponent_interval
    if is_undetermined or exponent.low <= contour_exponent <= exponent.high:
        return (
            "cannot tell",
            f"{found}: both contour friction, 1/3, and impacts, 1/2, are possible",
        )
    if exponent.high < contour_exponent:
        return (
            "cannot tell",
            f"{found}: both an air film and contour friction dissipate energy",
        )
    if exponent.low > max_impact_exponent:
        return (
            "not this scene",
            f"{found}: neither contour friction nor impacts explain so steep a rise",
        )
    if neglected_parts(decay.scene):
        return "cannot tell", found
    lowest, highest = (
        _slope_of_heights(min(n, max_impact_exponent))
        for n in (exponent.high, exponent.low)
    )
    return "impacts", (
        f"{found}: contour friction, 1/3, is excluded; impacts give n = (2 - H)/(4 - H), "
        f"so the Hurst exponent H of the heights is between {lowest:.1f} and {highest:.1f}"
    )


def _slope_of_heights(exponent: float) -> float:
    """Return H of the power spectrum k^-(1 + 2 H) of heights for an exponent n of the
    rate."""
    return (2 - 4 * exponent) / (1 - exponent)
