"""Selection of signal and spectral line, fit of the decay, and verdict on the cause."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import product

import numpy as np
from scipy.signal import resample_poly

from sonify.fitting.decay_model import LAWS, DecayModel
from sonify.fitting.least_squares import (
    TINY,
    Fit,
    LineRates,
    ToneSignal,
    Value,
    combine_motions,
    fit,
    fit_to_rates,
    line_rates,
)
from sonify.fitting.phase_demodulation import Rates
from sonify.fitting.settings import FIT
from sonify.hearing.audio_source import Source
from sonify.hearing.recording import (
    MIN_ENVELOPE_FREQUENCY_HZ,
    RecordingError,
    envelope,
    read,
)
from sonify.hearing.settling.detector import (
    SettlingRun,
    non_overlapping_runs,
    settling_events,
)

MAIN_LINES = ("precession", "its double", "nutation")
"""Spectral lines that may be the loudest tone."""


@dataclass(frozen=True, kw_only=True)
class Sound:
    """A recording, the time `end` [s] at which its disk comes to rest, and candidate
    `ridges` of its rate.

    The ridges are those of the tone and of the repetition of the disk. `recorded` is True
    for a sound with the high-pass filter of a recorder."""

    name: str
    samples: np.ndarray
    rate: float
    start: float
    end: float
    ridges: tuple[Rates, ...]
    recorded: bool = True
    run: SettlingRun | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class Judged:
    """Fit of the LAWS to one or more sounds, and the verdict.

    `signal` is "tone" or "envelope", `line` the spectral line, and `model` "steady" or
    "solved". `verdict` is "rolling", "air", "both", "impacts", "not this scene" or
    "cannot tell", with a `reason` if it depends on the exponent of the rate. If the
    rates are not `explained` by any motion, the line may be wrong. `limits` are upper
    limits of the shares that were not fitted, by name."""

    sounds: tuple[Sound, ...]
    signal: str
    line: str
    model: str
    decay: DecayModel
    streams: list[ToneSignal]
    fit: Fit
    explained: bool
    verdict: str
    reason: str = ""
    limits: Mapping[str, float] = field(default_factory=dict)

    @property
    def has_measured_rates(self) -> bool:
        """True if rates were tracked; bursts give only the law of the rate."""
        return bool(self.streams)

    @property
    def contour_fits(self) -> bool:
        """True if contour friction and film explain almost all dissipation."""
        return (
            2 not in self.fit.free
            or shares_of_power(self.decay, self.fit)["law"][0] < FIT.absent_power_share
        )

    def without_samples(self) -> "Judged":
        """Return a copy without the samples of the sounds."""
        none = np.zeros(0)
        sounds = tuple(replace(sound, samples=none) for sound in self.sounds)
        return replace(
            self,
            sounds=sounds,
            streams=[replace(one, samples=none) for one in self.streams],
        )

    def values(self) -> dict[str, Value]:
        """Return the fitted shares `rolling`, `air` and `law`, by name."""
        return self.fit.values()


def detect_run(
    source: Source, name: str, recorded: bool = True, begin: float = 0.0
) -> Sound:
    """Return the sound of a source with the detected run of a disk.

    `begin` is the time [s] of the first sample in its file. Raises RecordingError with
    a one-line message if no disk is detected or the sound cannot be fitted."""
    samples, rate, start, duration = read(source)
    if duration < FIT.min_recording_length:
        raise RecordingError(
            f"{name}: too short, {duration:.3g} s; at least {FIT.min_recording_length:g} s are required"
        )
    heard = settling_events(source)
    runs = non_overlapping_runs(heard)
    if not runs:
        raise RecordingError(f"{name}: no disk or coin that comes to rest was detected")
    if (
        len(runs) > 1
        and runs[1].score > FIT.min_second_disk_score_ratio * runs[0].score
    ):
        raise RecordingError(
            f"{name}: the recording contains a second run, ending at "
            f"{begin + runs[1].t_end.value:.2f} s; choose one with --from and --to"
        )
    if start:
        samples, rate, start, _ = read(source, runs[0].t_end.value)
    same_disk = [
        event.later(begin)
        for event in heard
        if event is runs[0]
        or abs(event.t_end.value - runs[0].t_end.value) < FIT.max_end_difference
    ]
    _check_not_clipped(samples, name)
    run = runs[0].later(begin)
    return Sound(
        name=name,
        samples=samples,
        rate=rate,
        start=start + begin,
        end=run.t_end.value,
        ridges=tuple(_ridge_of(event) for event in same_disk),
        recorded=recorded,
        run=run,
    )


def _check_not_clipped(samples, name):
    share = np.abs(samples) / np.abs(samples).max()
    top = share > 1 - 1e-6
    below = (share > FIT.near_peak_level) & (share <= 1 - 1e-6)
    runs = top.copy()
    for i in range(1, FIT.clipped_run_length):
        runs[:-i] &= top[i:]
    if (
        runs.sum()
        > max(FIT.clipped_sample_share * len(samples), FIT.clipped_run_length)
        and top.sum() > below.sum()
    ):
        raise RecordingError(
            f"{name}: clipped, {top.mean():.1%} of its samples are at full scale; record at a lower "
            f"level"
        )


def fit_same_disk(
    decay: DecayModel, sounds: list[Sound], correct: bool = True
) -> Judged:
    """Return the result for sounds of the same disk.

    Raises RecordingError if no line can be tracked. With `correct`, the steady motion
    is refined by solved motions, unless it fits well and the solved motions fit much
    worse."""
    lines = _tracks_of_sounds(decay, sounds)
    best = max(lines, key=lambda track: track.score)
    correct = correct and not _is_steady_sufficient(best, decay)
    first = _refined_tracks(
        _best_tracks(lines, FIT.likely_score_share) if correct else [],
        decay,
        FIT.first_block_lengths,
    )
    second = _refined_tracks(
        _best_tracks(first, FIT.second_score_share), decay, FIT.second_block_lengths
    )
    nearest = _best_tracks(first + second, 1.0)[:1]
    found = _refined_tracks(nearest, decay, FIT.final_block_lengths) or nearest
    if any(
        track.fit.spread <= FIT.equivalent_fit_ratio * best.fit.spread
        for track in found
    ):
        best = min(found, key=lambda track: track.fit.spread)
    same = [
        track
        for track in lines + found
        if (track.signal, track.line) == (best.signal, best.line)
    ]
    one = (
        _mean_of_equivalent_fits([track.fit for track in same], decay)
        if best.model == "solved"
        else best.fit
    )
    explained = not correct or one.spread < max(
        FIT.unexplained_spread, FIT.equivalent_fit_ratio * np.median(one.sigma)
    )
    if not explained:
        others = [
            track.fit
            for track in lines
            if (track.signal, track.line) != (best.signal, best.line)
        ]
        one = combine_motions([best.fit, *others])
    return Judged(
        sounds=tuple(sounds),
        signal=best.signal,
        line=best.line,
        model=best.model,
        decay=best.decay,
        streams=best.streams,
        fit=one,
        explained=explained,
        verdict="not this scene"
        if one.spread > FIT.wrong_scene_spread
        else verdict_of(decay, one),
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class Track:
    """Fit of a decay to one line in one signal of the sounds.

    The score includes the other lines, both in this signal and in `other_signals`."""

    signal: str
    line: str
    model: str
    lines: dict[str, DecayModel]
    streams: list[ToneSignal]
    other_signals: list[list[ToneSignal]]
    fit: Fit

    @property
    def decay(self) -> DecayModel:
        """Decay with the rate of this line."""
        return self.lines[self.line]

    @cached_property
    def score(self) -> float:
        """Evidence for the track.

        It is the sum of the evidence of all lines at their expected rates, the
        agreement of this line with its decay and a bonus for the precession line, minus
        a penalty for an implausible film."""
        one = self.fit
        signals = product((self.streams, *self.other_signals), self.lines.values())
        seen = sum(
            _evidence(
                line,
                streams,
                one.ends,
                one.shares,
                FIT.block_lengths[-1],
                FIT.neutral_spread,
            )
            for streams, line in signals
        )
        near = (
            len(one.residual)
            / FIT.block_overlap
            * np.log(FIT.neutral_spread / max(one.spread, FIT.min_rate_error))
        )
        return float(
            seen
            + near
            + FIT.precession_bonus * (self.line == "precession")
            - FIT.air_penalty * max(one.shares[1] - FIT.max_air_factor, 0)
        )


def _evidence(line, streams, ends, shares, length, near=FIT.max_rate_deviation):
    """Return the evidence for a line, the sum of log(1 + signal-to-noise ratio) over
    blocks near it.

    `near` is the largest relative deviation from the expected rate. The noise is a
    median, which neighbouring lines do not affect."""
    found = 0.0
    for one in line_rates(line, streams, ends, shares, length, noise_of=np.median):
        found += (
            np.log1p(one.rates.clear[np.abs(one.rates.missed) < near]).sum()
            / FIT.block_overlap
        )
    return found


def _tracks_of_sounds(decay, sounds):
    """Return the tracks of the sounds, at most one for each signal and line.

    Each common ridge is assigned to each of MAIN_LINES in turn. For each assignment,
    lines are fitted in order of their evidence until a fit succeeds. Raises
    RecordingError if none succeeds."""
    enveloped = all(sound.rate > 2 * MIN_ENVELOPE_FREQUENCY_HZ for sound in sounds)
    signals = ("tone", "envelope") if enveloped else ("tone",)
    streams = {
        signal: [tone_signal(sound, signal) for sound in sounds] for signal in signals
    }
    ends = np.array([sound.end for sound in sounds])
    found = {}
    for number, name in product(
        range(min(len(sound.ridges) for sound in sounds)), MAIN_LINES
    ):
        ridges = [sound.ridges[number] for sound in sounds]
        try:
            moved, shares = _initial_guess(decay, decay.lines[name], ridges, ends)
        except ValueError:
            continue
        heard = {
            (signal, line): _evidence(
                decay.lines[line],
                streams[signal],
                moved,
                shares,
                FIT.block_lengths[0],
            )
            for signal, line in product(signals, MAIN_LINES)
        }
        best_first = sorted(heard, key=heard.__getitem__, reverse=True)
        tracks = (
            _track(decay, streams, *pair, moved, shares)
            for pair in best_first
            if heard[pair]
        )
        track = next((track for track in tracks if track is not None), None)
        if track is not None:
            place = track.signal, track.line
            found[place] = max(
                found.get(place, track), track, key=lambda track: track.score
            )
    if not found:
        name = sounds[0].name
        disk = decay.scene.name
        raise RecordingError(f"{name}: no tone matches a decay of the disk '{disk}'")
    return list(found.values())


def _track(decay, streams, signal, line, ends, shares):
    """Return the track of a line in a signal, fitted from a guess of ends and shares.

    Returns None if the fit fails or its end is too far from the guess.
    """
    try:
        one = fit(
            decay.lines[line],
            streams[signal],
            ends,
            shares,
            _fitted_laws(decay),
            FIT.block_lengths[:4],
        )
    except ValueError:
        return None
    if np.abs(one.ends - ends).max() > FIT.max_fitted_end_distance:
        return None
    other_signals = [sounds for other, sounds in streams.items() if other != signal]
    head = {"signal": signal, "line": line, "model": "steady", "lines": decay.lines}
    return Track(**head, streams=streams[signal], other_signals=other_signals, fit=one)


def _fitted_laws(decay):
    """Return the indices of the fitted laws.

    The other laws of the scene are fitted if it has no contour friction.
    """
    other = decay.has_law and not decay.scene.dissipation.contour_moment
    return (0, *([1] if decay.has_film else []), *([2] if other else []))


def shares_with_scene_laws(decay: DecayModel, shares) -> np.ndarray:
    """Return the shares (3,), with 1 for the other laws of a scene that has contour
    friction."""
    return np.array(
        [*shares[:2], 1.0 if decay.scene.dissipation.contour_moment else shares[2]]
    )


def tone_signal(sound: Sound, signal: str) -> ToneSignal:
    """Return the signal of a sound in which a tone is demodulated."""
    if signal == "envelope":
        samples, rate = envelope(sound.samples, sound.rate)
    else:
        down = max(int(sound.rate // FIT.tone_rate), 1)
        samples = resample_poly(sound.samples, 1, down)
        rate = sound.rate / down
    return ToneSignal(
        samples=samples,
        rate=rate,
        first=sound.start,
        filtered=sound.recorded and signal == "tone",
    )


def _ridge_of(event):
    """Return the rates of an event, along its ridge or at 200 times of its law."""
    if event.ridge:
        time = event.ridge.time
        frequency = event.ridge.frequency
    else:
        end = event.t_end.value
        time = end - np.geomspace(end - event.start, FIT.unused_end_duration, 200)
        frequency = event.rate(time)
    return Rates(time, frequency, FIT.ridge_error * frequency, 1 + 0 * time, 0 * time)


def _initial_guess(decay, line, ridges, ends):
    """Return the ends and shares for which a line is closest to the ridges.

    Each fitted law is tried alone, and then the first two together.
    """
    heard = tuple(
        LineRates(i, line, ridge, ridge.frequency) for i, ridge in enumerate(ridges)
    )
    sought = _fitted_laws(decay)
    tried = []
    for some in (*((law,) for law in sought), sought[:2]):
        start = np.zeros(3)
        start[list(some)] = np.array(FIT.initial_shares)[list(some)]
        tried.append(
            fit_to_rates(heard, ends, shares_with_scene_laws(decay, start), some)
        )
    return min(tried, key=lambda one: one[2])[:2]


def _best_tracks(tracks, share):
    """Return the tracks whose score is at least `share` times the best one."""
    return [
        track
        for track in tracks
        if track.score >= share * max(one.score for one in tracks)
    ]


def _is_steady_sufficient(track, decay):
    """Return True if the steady motion fits well and the solved motions fit much
    worse."""
    far_worse_spread = FIT.far_worse_ratio * track.fit.spread
    return track.fit.spread < FIT.slip_spread and all(
        one.fit.spread > far_worse_spread
        for one in _refined_tracks([track], decay, FIT.first_block_lengths)
    )


def _refined_tracks(tracks, decay, lengths):
    """Return tracks refined by successive solved motions until their shares converge.

    Each motion is solved with the shares of the previous fit; `lengths` are the turns
    per block."""
    found = []
    for track in tracks:
        for length in lengths:
            try:
                lines, one = _refit(track, decay, length)
            except (
                ValueError,
                ArithmeticError,
                KeyError,
            ):  # the motion does not exist or has no such line
                break
            moved = np.abs(one.shares - track.fit.shares)
            track = replace(track, model="solved", lines=lines, fit=one)
            found.append(track)
            share_errors = np.hypot(
                one.draws[:, len(one.ends) :].std(axis=0),
                _share_errors_of_missing_power(decay, one),
            )
            if (moved <= FIT.converged_change * share_errors).all():
                break
    return found


def _refit(track, decay, length):
    """Return the lines of the motion solved with the shares of a track, and the new
    fit.

    If this fit fails, the motion is solved with shares fitted to the measured rates.
    """
    one = track.fit

    def fitted(lines, ends, shares):
        line = lines[track.line]
        min_share = FIT.min_initial_share
        return lines, fit(
            line, track.streams, ends, shares, one.free, (length,), min_share
        )

    lines = decay.solved(one.shares)
    try:
        return fitted(lines, one.ends, one.shares)
    except ValueError:
        heard = tuple(h._replace(line=lines[track.line]) for h in one.heard)
        ends, shares, _ = fit_to_rates(heard, one.ends, one.shares, one.free)
        return fitted(decay.solved(shares), ends, shares)


def _mean_of_equivalent_fits(fits, decay):
    """Return the mean of the fits that explain the sounds about equally well.

    The motions of these fits slip at different times. The bootstrap draws include the
    uncertainty due to the `unknown_power_share`.
    """
    as_much = max(len(one.residual) for one in fits) / FIT.equivalent_fit_ratio
    fits = sorted(
        (one for one in fits if len(one.residual) >= as_much),
        key=lambda one: one.spread,
    )
    one = combine_motions(
        [one for one in fits if one.spread <= FIT.equivalent_fit_ratio * fits[0].spread]
    )
    draws = one.draws.copy()
    draws[:, len(one.ends) :] += _share_errors_of_missing_power(
        decay, one
    ) * np.random.default_rng(0).standard_normal((len(draws), 3))
    return replace(one, draws=draws)


def with_model_error(judged: Judged) -> Judged:
    """Return the result with the error of the film law included in its draws.

    An error of the film power by `film_error` is compensated by the other laws.
    """
    one = judged.fit
    power, fall = _powers_by_law(judged.decay, one)
    error = (
        FIT.film_error
        * one.shares[1]
        * (power[1] @ fall)
        / np.maximum(power @ fall, TINY)
    )
    error[[law for law in range(3) if law not in one.free]] = 0.0
    draws = one.draws.copy()
    moved = np.random.default_rng(1).standard_normal(len(draws))
    draws[:, len(one.ends) :] += np.outer(moved, error * [-1.0, 1.0, -1.0])
    fit_with_error = replace(one, draws=draws)
    return replace(judged, fit=fit_with_error)


def _share_errors_of_missing_power(decay, one):
    """Return the uncertainty of each fitted share (3,) due to the
    `unknown_power_share`."""
    power, fall = _powers_by_law(decay, one)
    unknown = (
        FIT.unknown_power_share
        * (one.shares @ power @ fall)
        / np.maximum(power @ fall, TINY)
    )
    return np.where(np.isin(range(3), one.free), unknown, 0.0)


def _powers_by_law(decay, one):
    """Return the power of each of the LAWS (3, 60) at inclinations covered by the
    sound.

    The weights (60,) of the inclinations are also returned; they are energy
    differences, because the energy is proportional to the inclination."""
    remaining = np.concatenate([one.ends[h.sound] - h.rates.time for h in one.heard])
    beta = np.geomspace(
        *decay.inclination(
            np.clip([remaining.min(), remaining.max()], 1e-3, None), one.shares
        ),
        60,
    )
    return np.array(
        [np.interp(beta, decay.beta, p) for p in decay.powers]
    ), np.gradient(beta)


def shares_of_power(decay: DecayModel, one: Fit) -> dict[str, tuple[float, float]]:
    """Return the 95 % interval of the share of each of the LAWS in the lost energy.

    The energy is that lost during the part of the motion covered by the sound.
    """
    power, fall = _powers_by_law(decay, one)
    each = np.clip(one.draws[:, len(one.ends) :, None] * power, 0, None)
    share = (each / np.maximum(each.sum(axis=1, keepdims=True), TINY) * fall).sum(
        axis=2
    ) / fall.sum()
    low, high = np.percentile(share, [2.5, 97.5], axis=0)
    return {name: (float(low[i]), float(high[i])) for i, name in enumerate(LAWS)}


def verdict_of(decay: DecayModel, one: Fit) -> str:
    """Return "rolling", "air" or "both" if 95 % of the draws agree, otherwise "cannot
    tell".

    The verdict is also "cannot tell" if the model neglects parts of the scene.
    """
    if decay.neglected:
        return "cannot tell"
    share = shares_of_power(decay, one)
    if 2 in one.free and share.pop("law")[1] > FIT.absent_power_share:
        return "cannot tell"
    share = {name: share[name] for name in ("rolling", "air")}
    present = {
        name for name, (low, _) in share.items() if low > FIT.present_power_share
    }
    absent = {
        name for name, (_, high) in share.items() if high < FIT.absent_power_share
    }
    if len(present) == 2:
        return "both"
    return (
        next(iter(present)) if len(present) == 1 and len(absent) == 1 else "cannot tell"
    )
