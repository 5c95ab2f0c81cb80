"""SOUNDS -> WHAT SLOWED THE DISK: where the tone is sought first, in which signal and line it is followed, the fit."""

from dataclasses import dataclass, replace
from functools import cached_property
from math import inf

import numpy as np
from scipy.signal import resample_poly

from sonify.fitting.decline import LAWS, Decline
from sonify.fitting.estimate import FLOOR, LENGTHS, Fit, Heard, Value, fit, solved_near, tracked
from sonify.fitting.phase import Rates
from sonify.hearing.recording import ENVELOPE_FROM, RecordingError, envelope, read
from sonify.hearing.rising_tone import RisingTone, rising_tone
from sonify.hearing.source import Source

TONE_RATE = 4000
"""Samples a second [Hz] in which the tone is followed."""
NEAR, USUAL, RIVALS = 0.05, 5.0, 2
"""A block speaks for a line by the logarithm of this over the spread of the fit; the contact is usually heard once in a
turn; so many of the best tracks are tried along a solved motion."""
RIDGE_ERROR = 0.03
"""Relative error of the ridge of a spectrogram, from which the search begins."""
SHORTEST = 2.0
"""A sound that is shorter [s] tells of no decline."""
CLIPPED, RUN = 1e-3, 3
"""A sound is clipped if this share of it, in runs of so many samples, is at its greatest value."""
ABSENT, PRESENT = 0.1, 0.02
"""A law is absent if, at the upper end of its interval, it takes less than this share of the power that was lost; and
present if it takes at least that at the lower end."""


@dataclass(frozen=True, kw_only=True)
class Sound:
    """A sound that was read, and the rising tone that stands out in it; it may have passed a recorder's high-pass."""

    name: str
    samples: np.ndarray
    rate: float
    start: float
    tones: dict[str, RisingTone]
    recorded: bool = True


@dataclass(frozen=True, kw_only=True, eq=False)
class Judged:
    """What sounds tell together: the `fit` of the LAWS to their `signal` (tone, envelope), heard as a `line` of the
    decline, of the `model` steady or solved; `verdict` is one of rolling, air, both, cannot tell."""

    sounds: tuple[Sound, ...]
    signal: str
    line: str
    model: str
    decline: Decline
    streams: list[Heard]
    fit: Fit
    verdict: str

    @property
    def contour_fits(self) -> bool:
        """Whether contour friction and film alone explain the sounds: the scene's other law takes little."""
        return 2 not in self.fit.free or shares_of_power(self.decline, self.fit)["law"][0] < ABSENT

    def values(self) -> dict[str, Value]:
        """Return `rolling`, `air` and `law`, the share of the scene's other laws: those that were sought."""
        return self.fit.values()


def heard(source: Source, name: str, wanted=("tone", "envelope"), recorded: bool = True) -> Sound:
    """Return a sound with the rising tones in the signals `wanted`. Raises RecordingError for one that cannot be
    fitted, in one line."""
    samples, rate, start, _ = read(source)
    if len(samples) < SHORTEST * rate:
        raise RecordingError(f"{name}: {len(samples) / rate:.3g} s long: at least {SHORTEST:g} s of a disk are needed")
    _refuse_clipped(samples, name)
    signals = {"tone": lambda: (samples, rate)}
    if rate > 2 * ENVELOPE_FROM:
        signals["envelope"] = lambda: envelope(samples, rate)
    tones = {kind: tone for kind in wanted if kind in signals and (tone := rising_tone(*signals[kind]())) is not None}
    if not tones:
        raise RecordingError(f"{name}: no tone rises in it towards an end")
    end = max(tone.end for tone in tones.values())
    after = samples[int((end + 1.0) * rate) :]
    if len(after) > 4 * rate and np.abs(after).max() > 0.1 * np.abs(samples).max():
        again = rising_tone(after, rate)
        if again is not None:
            raise RecordingError(
                f"{name}: a second disk ends at {start + end + 1.0 + again.end:.2f} s: cut the file between them"
            )
    return Sound(name=name, samples=samples, rate=rate, start=start, tones=tones, recorded=recorded)


def _refuse_clipped(samples, name):
    top = np.abs(samples) > np.abs(samples).max() * (1 - 1e-6)
    runs = top.copy()
    for i in range(1, RUN):
        runs[:-i] &= top[i:]
    if runs.sum() > max(CLIPPED * len(samples), RUN):
        raise RecordingError(
            f"{name}: clipped: {top.mean():.1%} of its samples are at full scale; record it more quietly"
        )


def judge(decline: Decline, sounds: list[Sound], correct: bool = True) -> Judged:
    """Return what sounds of the same disk tell. Raises RecordingError if none of them can be followed.

    `correct` by a solved motion where that explains the sounds better than steady ones do.
    """
    tracks = _tracks(decline, sounds)
    rivals = [_again(track) for track in sorted(tracks, key=lambda track: -track.score)[:RIVALS]]
    if correct:
        rivals += [track for rival in rivals if (track := _corrected(rival)) is not None]
    best = max(rivals, key=lambda track: track.score)
    return Judged(
        sounds=tuple(sounds),
        signal=best.signal,
        line=best.line,
        model=best.model,
        decline=best.decline,
        streams=best.streams,
        fit=best.fit,
        verdict=verdict_of(best.decline, best.fit),
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class Track:
    """The fit of contour friction and film to one signal of the sounds, heard as one line of the decline."""

    signal: str
    line: str
    model: str
    lines: dict[str, Decline]
    streams: list[Heard]
    fit: Fit

    @property
    def decline(self) -> Decline:
        """The decline as it is heard in this line."""
        return self.lines[self.line]

    @cached_property
    def score(self) -> float:
        """How much speaks for it: the tones of all lines that are where they should be, and how near they are."""
        seen = [
            tracked(decline, stream, end, self.fit.shares, LENGTHS[-1]).evidence
            for decline in self.lines.values()
            for stream, end in zip(self.streams, self.fit.ends, strict=True)
        ]
        near = len(self.fit.residual) * np.log(NEAR / max(self.fit.spread, FLOOR))
        return float(sum(seen) + near + USUAL * (self.line == "precession"))


def _tracks(decline, sounds):
    """The tracks of the sounds as every line of the decline, in every signal that they have in common."""
    lines, found = decline.lines(), []
    for signal in ("tone", "envelope"):
        if not all(signal in sound.tones for sound in sounds):
            continue
        streams = [stream(sound, signal) for sound in sounds]
        for line, heard_as in lines.items():
            try:
                ends, shares = _guess(heard_as, sounds, signal)
                one = fit(heard_as, streams, ends, base(decline, shares), _free(decline), LENGTHS[:3])
            except ValueError:
                continue
            found.append(Track(signal=signal, line=line, model="steady", lines=lines, streams=streams, fit=one))
    if not found:
        name, disk = sounds[0].name, decline.scene.name
        raise RecordingError(f"{name}: its tone cannot be followed by a decline of the disk '{disk}'")
    return found


def _free(decline):
    """The laws that are sought: the scene's other law too where it stands in place of contour friction."""
    other = decline.has_law and not decline.scene.dissipation.contour_moment
    return (0, *([1] if decline.has_film else []), *([2] if other else []))


def base(decline: Decline, shares) -> np.ndarray:
    """Return shares with that of the scene's other laws: beside contour friction in the same scene, they are known."""
    return np.array([*shares[:2], 1.0 if decline.scene.dissipation.contour_moment else shares[2]])


def stream(sound: Sound, signal: str) -> Heard:
    """Return the signal of a sound in which its tone is followed."""
    if signal == "envelope":
        samples, rate = envelope(sound.samples, sound.rate)
    else:
        down = max(int(sound.rate // TONE_RATE), 1)
        samples, rate = resample_poly(sound.samples, 1, down), sound.rate / down
    return Heard(samples=samples, rate=rate, first=sound.start, filtered=sound.recorded and signal == "tone")


def _guess(decline, sounds, signal):
    """Ends and shares that are near the ridges of the spectrograms."""
    tones = [sound.tones[signal] for sound in sounds]
    ends = np.array([sound.start + tone.end for sound, tone in zip(sounds, tones, strict=True)])
    ridges = [
        Rates(sound.start + tone.time, tone.frequency, RIDGE_ERROR * tone.frequency, tone.level)
        for sound, tone in zip(sounds, tones, strict=True)
    ]
    best = (inf, ends, np.array([1e-4, 0.0, 0.0]))
    for shares in ([1e-4, 0, 0], [1e-4, 1.0, 0], [0, 1.0, 0], [0, 0, 1.0]):
        if (shares[1] and not decline.has_film) or (shares[2] and not decline.has_law):
            continue
        shares = np.array(shares, float)
        nothing = [Heard(samples=np.zeros(0), rate=1.0, first=0.0)] * len(sounds)
        try:
            moved, found, cost = solved_near(
                decline, nothing, ridges, ends, shares, tuple(np.flatnonzero(shares).tolist())
            )
        except ValueError:
            continue
        best = min(best, (cost, moved, found), key=lambda one: one[0])
    return best[1:]


def _again(track):
    """The track fitted in long blocks."""
    one = fit(track.decline, track.streams, track.fit.ends, track.fit.shares, track.fit.free, LENGTHS[2:])
    return replace(track, fit=one)


def _corrected(track):
    """The track along a motion solved with the shares found, twice; None where that cannot be solved."""
    lines, one, free = track.lines, track.fit, _free(track.decline)
    try:
        for _ in range(2):
            solved = lines[track.line].solved(one.shares)
            one = fit(solved, track.streams, one.ends, one.shares, free, LENGTHS[3:])
    except (ValueError, ArithmeticError):
        return None
    return replace(track, model="solved", lines=lines | {track.line: solved}, fit=one)


def shares_of_power(decline: Decline, one: Fit) -> dict[str, tuple[float, float]]:
    """Return for each of the LAWS the least and greatest share, in 95 %, of the energy that was lost while heard."""
    left = np.concatenate([end - h.time for end, h in zip(one.ends, one.heard, strict=True)])
    beta = np.geomspace(*decline.inclination(np.clip([left.min(), left.max()], 1e-3, None), one.shares), 60)
    power = np.array([np.interp(beta, decline.beta, p) for p in decline.powers])
    fall = np.gradient(beta)  # energy goes with the inclination
    each = one.draws[:, len(one.ends) :, None] * power
    share = (np.clip(each, 0, None) / np.clip(each, 0, None).sum(axis=1, keepdims=True) * fall).sum(axis=2) / fall.sum()
    low, high = np.percentile(share, [2.5, 97.5], axis=0)
    return {name: (float(low[i]), float(high[i])) for i, name in enumerate(LAWS)}


def verdict_of(decline: Decline, one: Fit) -> str:
    """Return rolling, air or both, where 95 % of what is as likely as the fit agrees on it; else cannot tell."""
    share = shares_of_power(decline, one)
    if 2 in one.free and share.pop("law")[1] > ABSENT:
        return "cannot tell"
    share = {name: share[name] for name in ("rolling", "air")}
    present = {name for name, (low, _) in share.items() if low > PRESENT}
    absent = {name for name, (_, high) in share.items() if high < ABSENT}
    if len(present) == 2:
        return "both"
    return next(iter(present)) if len(present) == 1 and len(absent) == 1 else "cannot tell"
