"""SOUNDS -> VERDICT: select the signal and the spectral line, fit the decline, and judge the cause."""

from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product

import numpy as np
from scipy.signal import resample_poly

from sonify.fitting.decay_model import LAWS, Decline
from sonify.fitting.least_squares import (
    BLOCK_LENGTHS,
    MIN_RATE_ERROR,
    TINY,
    UNUSED_END,
    Fit,
    LineRates,
    ToneSignal,
    Value,
    combine_motions,
    fit,
    fit_to_rates,
    line_rates,
)
from sonify.fitting.phase_demodulation import BLOCK_OVERLAP, MAX_RATE_DEVIATION, Rates
from sonify.hearing.audio_source import Source
from sonify.hearing.recording import ENVELOPE_FROM, LONGEST, RecordingError, envelope, read
from sonify.hearing.rising_tone import clearest_tone
from sonify.hearing.settling.detector import settling_runs
from sonify.hearing.settling.settings import SettlingSettings

TONE_RATE = 4000
"""Sample rate of the signal in which a tone is demodulated [Hz]."""
MIN_RECORDING_LENGTH = 1.5
"""Least length of a recording [s]."""
SECOND_RUN_SHARE = 1 / 3
"""A run is another disk if its score is at least this share of the best score."""
FAINT_TONE_SHARE = 0.8
"""Share of the thresholds of a tone that is evidence of a disk together with a faint run."""
FAINT_RUN_SCORE = 12.0
"""Score of a run that is evidence of a disk together with a faint tone."""
STRONG_TONE_FACTOR = 2.0
"""A tone alone is evidence of a disk from this multiple of its thresholds on."""
MAX_END_DIFFERENCE = 0.5
"""A tone and a run belong to the same disk if they end within this time [s]."""
MAX_FITTED_END_DISTANCE = 8.0
"""Largest distance of the fitted end from that of the run [s]."""
MAIN_LINES = ("precession", "its double", "nutation")
"""Lines that may be the loudest tone."""
NEUTRAL_SPREAD = 0.05
"""Relative spread of the rates at which a block has no weight in the score of a track."""
PRECESSION_BONUS = 5.0
"""Bonus of the precession line in the score; the contact is usually heard once per turn."""
LIKELY_SCORE_SHARE = 0.5
"""Share of the best score above which tracks are refined by a solved motion."""
SECOND_SCORE_SHARE = 0.7
"""Share of the best score above which tracks are refined by a second solved motion."""
MAX_AIR_FACTOR = 2.0
"""Largest plausible factor on the theory of the film."""
AIR_PENALTY = 20.0
"""Weight in the score of a factor in excess of it."""
INITIAL_SHARE = 1e-4
"""Initial share of a refined search, in its unit."""
FIRST_BLOCK_LENGTHS = (8.0,)
"""Turns per block of the solved motion of likely tracks."""
SECOND_BLOCK_LENGTHS = (12.0,)
"""Turns per block of the second solved motion."""
FINAL_BLOCK_LENGTHS = (16.0,) * 4
"""Turns per block of the solved motions of the best track."""
CONVERGED_CHANGE = 0.25
"""Change of the shares, in standard deviations, below which they have converged."""
EQUIVALENT_FIT_RATIO = 2.0
"""Ratio of spreads, and of numbers of blocks, within which two motions explain a sound equally
well."""
SLIP_SPREAD = 2.5e-3
"""Spread of the rates that slips cause; a steady motion with less may be kept."""
FAR_WORSE_RATIO = 4.0
"""Ratio of the spread of the solved to the steady motion from which the steady one is kept."""
UNKNOWN_POWER_SHARE = 0.004
"""Share of the power that may be lost otherwise: the precession of a hoop overestimates the power
by 0.7 %, its nutation by nothing."""
FILM_ERROR = 0.06
"""Relative error of the power of the film; a thin-wedge law changes rolling by up to 8 %."""
UNEXPLAINED_SPREAD = 0.01
"""Spread above which a motion does not explain the rates, unless noise does."""
WRONG_SCENE_SPREAD = 0.03
"""Spread above which the motion is not that of the scene."""
INITIAL_SHARES = (1e-4, 1.0, 1.0)
"""Initial shares of the LAWS."""
RIDGE_ERROR = 0.03
"""Relative error of the law of a run, with which the search starts."""
CLIPPED_SAMPLE_SHARE = 1e-3
"""Share of samples at the largest value from which a sound is clipped."""
CLIPPED_RUN_LENGTH = 3
"""Length of the runs of such samples."""
NEAR_PEAK_LEVEL = 0.98
"""Share of the largest value above which the samples of a slow tone lie, more often than at it."""
ABSENT_POWER_SHARE = 0.1
"""A law is absent if it takes less than this share of the lost power at the upper end of its
interval."""
PRESENT_POWER_SHARE = 0.02
"""A law is present if it takes more than this share at the lower end of its interval."""


@dataclass(frozen=True, kw_only=True)
class Sound:
    """A recording with the `end` [s] of the run in it and candidate ridges of its rate.

    The ridges are those of the detected run and of the rising tone. `recorded` is True if the sound
    passed a recorder's high-pass.
    """

    name: str
    samples: np.ndarray
    rate: float
    start: float
    end: float
    ridges: tuple[Rates, ...]
    recorded: bool = True


@dataclass(frozen=True, kw_only=True, eq=False)
class Judged:
    """Result for one or more sounds: the `fit` of the LAWS and its verdict.

    `signal` is "tone" or "envelope", `line` the spectral line, and `model` "steady" or "solved".
    `verdict` is "rolling", "air", "both", "not this scene" or "cannot tell". If no motion has
    `explained` the rates, another line may be the right one.
    """

    sounds: tuple[Sound, ...]
    signal: str
    line: str
    model: str
    decline: Decline
    streams: list[ToneSignal]
    fit: Fit
    explained: bool
    verdict: str

    @property
    def contour_fits(self) -> bool:
        """True if contour friction and film suffice and the scene's other law takes little."""
        return (
            2 not in self.fit.free
            or shares_of_power(self.decline, self.fit)["law"][0] < ABSENT_POWER_SHARE
        )

    def without_samples(self) -> "Judged":
        """Return a copy without the samples of the sounds."""
        none = np.zeros(0)
        sounds = tuple(replace(sound, samples=none) for sound in self.sounds)
        return replace(
            self, sounds=sounds, streams=[replace(one, samples=none) for one in self.streams]
        )

    def values(self) -> dict[str, Value]:
        """Return the fitted shares `rolling`, `air` and `law`, by name."""
        return self.fit.values()


def detect_run(source: Source, name: str, recorded: bool = True, begin: float = 0.0) -> Sound:
    """Return a sound and the run of a disk in it.

    `begin` is the time [s] of the first sample in its file. Raises RecordingError with one line if
    no disk is detected or the sound cannot be fitted.
    """
    samples, rate, start, duration = read(source)
    if duration < MIN_RECORDING_LENGTH:
        raise RecordingError(
            f"{name}: {duration:.3g} s long: at least {MIN_RECORDING_LENGTH:g} s of a disk are needed"
        )
    runs = _runs_by_score(source, SettlingSettings())
    if len(runs) > 1 and runs[1].score > SECOND_RUN_SHARE * runs[0].score:
        raise RecordingError(
            f"{name}: the recording contains a second run, ending at "
            f"{begin + runs[1].t_end.value:.2f} s; choose one with --from and --to"
        )
    if start and runs:
        samples, rate, start, _ = read(source, runs[0].t_end.value)
    start += begin
    tone = clearest_tone(samples, rate) if runs or duration <= LONGEST else None
    clear = tone is not None and tone.stands_out(1.0 if runs else FAINT_TONE_SHARE)
    alone = tone is not None and tone.stands_out(STRONG_TONE_FACTOR)
    if clear and not runs:
        faint = _runs_by_score(source, SettlingSettings(heard_score=FAINT_RUN_SCORE))
        runs = [
            run
            for run in faint
            if abs(begin + run.t_end.value - start - tone.end) < MAX_END_DIFFERENCE
        ]
    ridges = [_ridge_of_run(runs[0].later(begin))] if runs else []
    if clear:
        ridges.append(_ridge_of_tone(tone, start))
    if not runs and not alone:
        raise RecordingError(f"{name}: no disk or coin is heard coming to rest in it")
    _refuse_clipped(samples, name)
    return Sound(
        name=name,
        samples=samples,
        rate=rate,
        start=start,
        end=begin + runs[0].t_end.value if runs else start + tone.end,
        ridges=tuple(ridges),
        recorded=recorded,
    )


def _runs_by_score(source, settings):
    return sorted(settling_runs(source, settings), key=lambda run: -run.score)


def _refuse_clipped(samples, name):
    share = np.abs(samples) / np.abs(samples).max()
    top = share > 1 - 1e-6
    below = (share > NEAR_PEAK_LEVEL) & (share <= 1 - 1e-6)
    runs = top.copy()
    for i in range(1, CLIPPED_RUN_LENGTH):
        runs[:-i] &= top[i:]
    if (
        runs.sum() > max(CLIPPED_SAMPLE_SHARE * len(samples), CLIPPED_RUN_LENGTH)
        and top.sum() > below.sum()
    ):
        raise RecordingError(
            f"{name}: clipped: {top.mean():.1%} of its samples are at full scale; record it more "
            f"quietly"
        )


def judge_sounds(decline: Decline, sounds: list[Sound], correct: bool = True) -> Judged:
    """Return the result for sounds of the same disk.

    Raises RecordingError if no line can be followed. With `correct`, the steady decline is refined
    by solved motions, unless it fits well and the solved motions fit far worse.
    """
    lines = _tracks(decline, sounds)
    best = max(lines, key=lambda track: track.score)
    correct = correct and not _steady_is_enough(best, decline)
    first = _refined_tracks(
        _best_tracks(lines, LIKELY_SCORE_SHARE) if correct else [], decline, FIRST_BLOCK_LENGTHS
    )
    second = _refined_tracks(_best_tracks(first, SECOND_SCORE_SHARE), decline, SECOND_BLOCK_LENGTHS)
    nearest = _best_tracks(first + second, 1.0)[:1]
    found = _refined_tracks(nearest, decline, FINAL_BLOCK_LENGTHS) or nearest
    if any(track.fit.spread <= EQUIVALENT_FIT_RATIO * best.fit.spread for track in found):
        best = min(found, key=lambda track: track.fit.spread)
    same = [
        track for track in lines + found if (track.signal, track.line) == (best.signal, best.line)
    ]
    one = (
        _mean_of_equivalent([track.fit for track in same], decline)
        if best.model == "solved"
        else best.fit
    )
    explained = not correct or one.spread < max(
        UNEXPLAINED_SPREAD, EQUIVALENT_FIT_RATIO * np.median(one.sigma)
    )
    if not explained:
        others = [
            track.fit for track in lines if (track.signal, track.line) != (best.signal, best.line)
        ]
        one = combine_motions([best.fit, *others])
    return Judged(
        sounds=tuple(sounds),
        signal=best.signal,
        line=best.line,
        model=best.model,
        decline=best.decline,
        streams=best.streams,
        fit=one,
        explained=explained,
        verdict="not this scene" if one.spread > WRONG_SCENE_SPREAD else verdict_of(decline, one),
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class Track:
    """Fit of a decline to one line in one signal of the sounds.

    The score also counts the other lines, in this signal and in the signals `beside`.
    """

    signal: str
    line: str
    model: str
    lines: dict[str, Decline]
    streams: list[ToneSignal]
    beside: list[list[ToneSignal]]
    fit: Fit

    @property
    def decline(self) -> Decline:
        """The decline as seen in this line."""
        return self.lines[self.line]

    @cached_property
    def score(self) -> float:
        """Evidence for the track.

        It adds the evidence of all lines at their expected rates, the closeness of this line to its
        decline and a bonus for the precession line, and subtracts a penalty for an implausible
        film.
        """
        one = self.fit
        signals = product((self.streams, *self.beside), self.lines.values())
        seen = sum(
            _evidence(line, streams, one.ends, one.shares, BLOCK_LENGTHS[-1], NEUTRAL_SPREAD)
            for streams, line in signals
        )
        near = (
            len(one.residual)
            / BLOCK_OVERLAP
            * np.log(NEUTRAL_SPREAD / max(one.spread, MIN_RATE_ERROR))
        )
        return float(
            seen
            + near
            + PRECESSION_BONUS * (self.line == "precession")
            - AIR_PENALTY * max(one.shares[1] - MAX_AIR_FACTOR, 0)
        )


def _evidence(line, streams, ends, shares, length, near=MAX_RATE_DEVIATION):
    """Return the evidence for a line: the sum of log(1 + signal-to-noise) of the blocks near it.

    `near` is the largest relative distance from the expected rate. The noise is a median, so that
    neighbouring lines do not count as noise.
    """
    found = 0.0
    for one in line_rates(line, streams, ends, shares, length, noise_of=np.median):
        found += np.log1p(one.rates.clear[np.abs(one.rates.missed) < near]).sum() / BLOCK_OVERLAP
    return found


def _tracks(decline, sounds):
    """Return the tracks of the sounds, at most one for each signal and line.

    Each common ridge is tried as each line of MAIN_LINES. For each guess, lines are tried in order of
    their evidence until one can be fitted. Raises RecordingError if there is none.
    """
    enveloped = all(sound.rate > 2 * ENVELOPE_FROM for sound in sounds)
    signals = ("tone", "envelope") if enveloped else ("tone",)
    streams = {signal: [tone_signal(sound, signal) for sound in sounds] for signal in signals}
    ends = np.array([sound.end for sound in sounds])
    found = {}
    for number, name in product(range(min(len(sound.ridges) for sound in sounds)), MAIN_LINES):
        ridges = [sound.ridges[number] for sound in sounds]
        try:
            moved, shares = _initial_guess(decline, decline.lines[name], ridges, ends)
        except ValueError:
            continue
        heard = {
            (signal, line): _evidence(
                decline.lines[line], streams[signal], moved, shares, BLOCK_LENGTHS[0]
            )
            for signal, line in product(signals, MAIN_LINES)
        }
        best_first = sorted(heard, key=heard.__getitem__, reverse=True)
        tracks = (
            _track(decline, streams, *pair, moved, shares) for pair in best_first if heard[pair]
        )
        track = next((track for track in tracks if track is not None), None)
        if track is not None:
            place = track.signal, track.line
            found[place] = max(found.get(place, track), track, key=lambda track: track.score)
    if not found:
        name = sounds[0].name
        disk = decline.scene.name
        raise RecordingError(
            f"{name}: its tone cannot be followed by a decline of the disk '{disk}'"
        )
    return list(found.values())


def _track(decline, streams, signal, line, ends, shares):
    """Return the track of a line in a signal from a guess of ends and shares.

    Returns None if the fit fails or its end is too far from the guess.
    """
    try:
        one = fit(
            decline.lines[line],
            streams[signal],
            ends,
            shares,
            _fitted_laws(decline),
            BLOCK_LENGTHS[:4],
        )
    except ValueError:
        return None
    if np.abs(one.ends - ends).max() > MAX_FITTED_END_DISTANCE:
        return None
    beside = [sounds for other, sounds in streams.items() if other != signal]
    head = {"signal": signal, "line": line, "model": "steady", "lines": decline.lines}
    return Track(**head, streams=streams[signal], beside=beside, fit=one)


def _fitted_laws(decline):
    """Return the indices of the fitted laws; the scene's other law replaces contour friction."""
    other = decline.has_law and not decline.scene.dissipation.contour_moment
    return (0, *([1] if decline.has_film else []), *([2] if other else []))


def with_known_laws(decline: Decline, shares) -> np.ndarray:
    """Return shares with that of the scene's other laws, which is 1 beside contour friction."""
    return np.array([*shares[:2], 1.0 if decline.scene.dissipation.contour_moment else shares[2]])


def tone_signal(sound: Sound, signal: str) -> ToneSignal:
    """Return the signal of a sound in which a tone is demodulated."""
    if signal == "envelope":
        samples, rate = envelope(sound.samples, sound.rate)
    else:
        down = max(int(sound.rate // TONE_RATE), 1)
        samples = resample_poly(sound.samples, 1, down)
        rate = sound.rate / down
    return ToneSignal(
        samples=samples, rate=rate, first=sound.start, filtered=sound.recorded and signal == "tone"
    )


def _ridge_of_run(run):
    """Return the rates of a run at 200 times, as given by its law."""
    time = run.t_end.value - np.geomspace(run.t_end.value - run.start, UNUSED_END, 200)
    return _ridge(time, run.rate(time))


def _ridge_of_tone(tone, start):
    """Return the rates of a tone in samples that begin at the time `start` [s]."""
    return _ridge(start + tone.time, tone.frequency)


def _ridge(time, frequency):
    return Rates(time, frequency, RIDGE_ERROR * frequency, 1 + 0 * time, 0 * time)


def _initial_guess(decline, line, ridges, ends):
    """Return ends and shares for which a line is closest to the ridges.

    Each fitted law is tried alone, then the first two together.
    """
    heard = tuple(LineRates(i, line, ridge, ridge.frequency) for i, ridge in enumerate(ridges))
    sought = _fitted_laws(decline)
    tried = []
    for some in (*((law,) for law in sought), sought[:2]):
        start = np.zeros(3)
        start[list(some)] = np.array(INITIAL_SHARES)[list(some)]
        tried.append(fit_to_rates(heard, ends, with_known_laws(decline, start), some))
    return min(tried, key=lambda one: one[2])[:2]


def _best_tracks(tracks, share):
    """Return the tracks whose score is at least a share of the best score."""
    return [track for track in tracks if track.score >= share * max(one.score for one in tracks)]


def _steady_is_enough(track, decline):
    """Return True if the steady motion fits well and the solved motions fit far worse."""
    least = FAR_WORSE_RATIO * track.fit.spread
    return track.fit.spread < SLIP_SPREAD and all(
        one.fit.spread > least for one in _refined_tracks([track], decline, FIRST_BLOCK_LENGTHS)
    )


def _refined_tracks(tracks, decline, lengths):
    """Return tracks refined by successive solved motions until their shares converge.

    Each motion is solved with the shares of the previous fit; `lengths` are the turns per block.
    """
    found = []
    for track in tracks:
        for length in lengths:
            try:
                lines, one = _refit(track, decline, length)
            except (
                ValueError,
                ArithmeticError,
                KeyError,
            ):  # there is no such motion, or it has no such line
                break
            moved = np.abs(one.shares - track.fit.shares)
            track = replace(track, model="solved", lines=lines, fit=one)
            found.append(track)
            away = np.hypot(
                one.draws[:, len(one.ends) :].std(axis=0), _unknown_power_error(decline, one)
            )
            if (moved <= CONVERGED_CHANGE * away).all():
                break
    return found


def _refit(track, decline, length):
    """Return the lines of the motion solved for the shares of a track, and the new fit.

    If this fails, the motion is solved for the shares that the measured rates would give.
    """
    one = track.fit
    lines = decline.solved(track.fit.shares)
    try:
        return lines, fit(
            lines[track.line],
            track.streams,
            one.ends,
            one.shares,
            one.free,
            (length,),
            INITIAL_SHARE,
        )
    except ValueError:
        heard = tuple(h._replace(line=lines[track.line]) for h in one.heard)
        ends, shares, _ = fit_to_rates(heard, one.ends, one.shares, one.free)
        lines = decline.solved(shares)
        return lines, fit(
            lines[track.line], track.streams, ends, shares, one.free, (length,), INITIAL_SHARE
        )


def _mean_of_equivalent(fits, decline):
    """Return the mean of the fits that explain the sounds about equally well.

    They differ in the times of slips. The draws include the UNKNOWN_POWER_SHARE.
    """
    as_much = max(len(one.residual) for one in fits) / EQUIVALENT_FIT_RATIO
    fits = sorted((one for one in fits if len(one.residual) >= as_much), key=lambda one: one.spread)
    one = combine_motions(
        [one for one in fits if one.spread <= EQUIVALENT_FIT_RATIO * fits[0].spread]
    )
    draws = one.draws.copy()
    draws[:, len(one.ends) :] += _unknown_power_error(decline, one) * np.random.default_rng(
        0
    ).standard_normal((len(draws), 3))
    return replace(one, draws=draws)


def with_model_error(judged: Judged) -> Judged:
    """Return the result with the error of the film's law in its draws.

    The power of the film is uncertain by FILM_ERROR, which the other laws compensate.
    """
    one = judged.fit
    power, fall = _powers_by_law(judged.decline, one)
    error = FILM_ERROR * one.shares[1] * (power[1] @ fall) / np.maximum(power @ fall, TINY)
    error[[law for law in range(3) if law not in one.free]] = 0.0
    draws = one.draws.copy()
    moved = np.random.default_rng(1).standard_normal(len(draws))
    draws[:, len(one.ends) :] += np.outer(moved, error * [-1.0, 1.0, -1.0])
    fit_with_error = replace(one, draws=draws)
    return replace(judged, fit=fit_with_error)


def _unknown_power_error(decline, one):
    """Return the uncertainty of each fitted share (3,) due to the UNKNOWN_POWER_SHARE."""
    power, fall = _powers_by_law(decline, one)
    unknown = UNKNOWN_POWER_SHARE * (one.shares @ power @ fall) / np.maximum(power @ fall, TINY)
    return np.where(np.isin(range(3), one.free), unknown, 0.0)


def _powers_by_law(decline, one):
    """Return the power of each of the LAWS (3, 60) at inclinations covered by the sound.

    Also returns the weights (60,) of the inclinations; the energy is proportional to the
    inclination.
    """
    left = np.concatenate([one.ends[h.sound] - h.rates.time for h in one.heard])
    beta = np.geomspace(
        *decline.inclination(np.clip([left.min(), left.max()], 1e-3, None), one.shares), 60
    )
    return np.array([np.interp(beta, decline.beta, p) for p in decline.powers]), np.gradient(beta)


def shares_of_power(decline: Decline, one: Fit) -> dict[str, tuple[float, float]]:
    """Return the 95 % interval of the share of each of the LAWS in the energy lost.

    Only the part of the motion covered by the sound counts.
    """
    power, fall = _powers_by_law(decline, one)
    each = np.clip(one.draws[:, len(one.ends) :, None] * power, 0, None)
    share = (each / np.maximum(each.sum(axis=1, keepdims=True), TINY) * fall).sum(
        axis=2
    ) / fall.sum()
    low, high = np.percentile(share, [2.5, 97.5], axis=0)
    return {name: (float(low[i]), float(high[i])) for i, name in enumerate(LAWS)}


def verdict_of(decline: Decline, one: Fit) -> str:
    """Return "rolling", "air" or "both" if 95 % of the draws agree, otherwise "cannot tell".

    The verdict is also "cannot tell" if the scene has parts that no decline includes.
    """
    if decline.left_out:
        return "cannot tell"
    share = shares_of_power(decline, one)
    if 2 in one.free and share.pop("law")[1] > ABSENT_POWER_SHARE:
        return "cannot tell"
    share = {name: share[name] for name in ("rolling", "air")}
    present = {name for name, (low, _) in share.items() if low > PRESENT_POWER_SHARE}
    absent = {name for name, (_, high) in share.items() if high < ABSENT_POWER_SHARE}
    if len(present) == 2:
        return "both"
    return next(iter(present)) if len(present) == 1 and len(absent) == 1 else "cannot tell"
