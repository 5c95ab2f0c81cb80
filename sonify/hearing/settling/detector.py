"""SOUND -> SETTLING RUNS: when disks or coins came to rest in it, by which law, and how certain
that is."""

import math
from dataclasses import dataclass, replace

import numpy as np

from sonify.hearing.audio_source import Source, pieces
from sonify.hearing.settling.candidates import Candidate, candidates_of
from sonify.hearing.settling.ends import knee
from sonify.hearing.settling.joint_region import Estimate, JointRegion, joint_region
from sonify.hearing.settling.onset_strength import (
    FRAME_RATE,
    Frames,
    OnsetStrength,
    frames_of,
    onset_strength,
)
from sonify.hearing.settling.prediction_score import correlation_length, law_phases, predicted_gain
from sonify.hearing.settling.rate_laws import Law
from sonify.hearing.settling.settings import SettlingSettings
from sonify.scene_errors import InputError

SHORTEST = 0.4  # s
PIECE = 60  # s
OVERLAP = 6  # s, shared by neighbouring pieces
LEAD = 4.5  # s of a piece that serve only to look back from ends


@dataclass(frozen=True)
class SettlingRun:
    """A disk or coin that comes to rest. Times in seconds of the sound, rates in Hz, intervals of
    95 %.

    Attributes
    ----------
    kind : str
        "tone" if it is heard in the sound itself, "repetition" if in the power of bands.
    start, t_end, exponent, rate_at_1s : float, Estimate, Estimate, Estimate
        Beginning of the best window, and the law rate ~ (t_end - t)^-exponent; the rate is that one
        second before the end, or at the start if that is later.
    events_per_turn : int
        2 if successive bursts alternate, as two per turn would; else 1. The number of turns may be
        off by two.
    score : float
        Q, how much better the law predicts unseen parts of the sound than steady, slowing or
        otherwise rising rates.
    certain : bool
        Whether the score, or that of two windows, is clear of what other sounds reach.
    false_alarm : float
        Expected number of events this strong in a sound of this length without a disk.
    bands : tuple of (float, float)
        Bands in which it is heard [Hz].
    region : JointRegion
        The laws that all windows of this end admit.
    """

    kind: str
    start: float
    t_end: Estimate
    exponent: Estimate
    rate_at_1s: Estimate
    events_per_turn: int
    score: float
    certain: bool
    false_alarm: float
    bands: tuple[tuple[float, float], ...]
    region: JointRegion
    law_scores: dict[str, float]

    def turns_left(self, time: np.ndarray) -> np.ndarray:
        """Return the turns, or bursts, from times [s] to the end of the law."""
        reference = min(1.0, self.t_end.value - self.start)
        left = np.maximum(self.t_end.value - np.asarray(time), 1e-6) / reference
        turns = self.rate_at_1s.value * reference
        exponent = self.region.best_exponent
        if abs(exponent - 1) < 1e-3:
            return turns * np.log(left * 1e6)
        return turns * left ** (1 - exponent) / (1 - exponent)

    def rate(self, time: np.ndarray) -> np.ndarray:
        """Return the rate [Hz] of the law at times before the end [s]."""
        reference = min(1.0, self.t_end.value - self.start)
        left = (self.t_end.value - np.asarray(time)) / reference
        return self.rate_at_1s.value * left**-self.region.best_exponent

    def later(self, seconds: float) -> "SettlingRun":
        """Return the run so much later [s]."""
        return replace(
            self,
            start=self.start + seconds,
            t_end=self.t_end.later(seconds),
            region=self.region.later(seconds),
        )


def settling_runs(sound: Source, settings: SettlingSettings | None = None) -> list[SettlingRun]:
    """Return the disks and coins that come to rest in a sound of any length, in the memory of one
    piece.

    Parameters
    ----------
    sound : Source
        The sound; its loudest channel is searched.
    settings : SettlingSettings, optional
        Thresholds.

    Returns
    -------
    list of SettlingRun
        In order of time; empty if none is heard or the sound is shorter than 0.4 s.

    Raises
    ------
    InputError
        If the sound holds samples that are not finite.
    """
    settings = settings or SettlingSettings()
    rate = sound.sample_rate
    length = sound.frames / rate
    if length < SHORTEST:
        return []
    channel = _loudest_channel(sound)
    runs = []
    for number, piece in enumerate(pieces(sound, PIECE * rate, OVERLAP * rate)):
        begin = number * PIECE
        samples = piece[: sound.frames - begin * rate, channel]
        if not np.isfinite(samples).all():
            raise InputError(f"the sound holds samples that are not finite, after {begin} s")
        last = (begin + PIECE + OVERLAP) * rate >= sound.frames
        span = (LEAD if number else 0, len(samples) / rate if last else PIECE + LEAD)
        if len(samples) >= SHORTEST * rate:
            found = runs_of_frames(frames_of(samples, rate, settings), settings, span)
            runs += [run.later(begin) for run in found]
        if last:
            break
    hours = length / 3600
    counted = [
        replace(run, false_alarm=false_alarms_per_hour(run.score, settings) * hours)
        for run in _apart(runs)
    ]
    return sorted(counted, key=lambda run: run.start)


def _loudest_channel(sound):
    """The number of the channel of the largest energy."""
    energy = 0.0
    for block in sound.blocks():
        if block.shape[1] == 1:
            return 0
        energy = energy + np.square(block, dtype=float).sum(axis=0)
    return int(np.argmax(energy))


def _apart(runs):
    """Of runs that overlap in time, that of the highest score."""
    kept: list[SettlingRun] = []
    for run in sorted(runs, key=lambda run: -run.score):
        if all(run.start >= other.t_end.high or other.start >= run.t_end.high for other in kept):
            kept.append(run)
    return kept


def runs_of_frames(
    frames: Frames, settings: SettlingSettings, span: tuple[float, float]
) -> list[SettlingRun]:
    """Return the runs in frames of a sound that end within a span of time [s]; their false alarms
    are per hour."""
    onsets = onset_strength(frames, settings)
    candidates = candidates_of(frames, onsets, settings, span)
    bouncing = [candidate for candidate in candidates if is_bouncing(candidate, settings)]
    heard = [
        candidate
        for candidate in candidates
        if is_heard(candidate, settings) and not _explained(candidate, bouncing, settings)
    ]
    runs = [_run(group, frames, onsets, settings) for group in _groups(heard)]
    return [run for run in runs if run is not None]


def is_heard(candidate: Candidate, settings: SettlingSettings) -> bool:
    """Return True if a candidate alone is evidence of a disk."""
    low, high = settings.pulse_slopes
    clear = candidate.score > settings.clear_score
    slow = candidate.first_rate <= settings.fastest_beginning
    return (
        candidate.score > settings.heard_score
        and candidate.rising_margin > settings.least_rising_margin
        and candidate.slope <= high
        and (clear or (slow and candidate.slope >= low))
    )


def is_bouncing(candidate: Candidate, settings: SettlingSettings) -> bool:
    """Return True if the law and the levels of a candidate are those of a bouncing body."""
    low, high = settings.bounce_slopes
    return candidate.exponent >= settings.bounce_exponent and low <= candidate.slope <= high


def _explained(candidate, bouncing, settings):
    """Whether a better bouncing candidate overlaps a candidate, or nearly does."""
    near = settings.bounce_separation * FRAME_RATE
    return any(
        other.score > candidate.score
        and other.window.first < candidate.window.end + near
        and candidate.window.first < other.window.end + near
        for other in bouncing
    )


def _groups(candidates: list[Candidate]) -> list[list[Candidate]]:
    """Candidates, the best first, that belong to one run each: their windows overlap."""
    groups: list[list[Candidate]] = []
    for candidate in candidates:
        for group in groups:
            best = group[0].window
            if candidate.window.first < best.end and best.first < candidate.window.end:
                group.append(candidate)
                break
        else:
            groups.append([candidate])
    return groups


def _run(group: list[Candidate], frames: Frames, onsets: OnsetStrength, settings: SettlingSettings):
    """The run of candidates of one end."""
    best = group[0]
    near = [
        candidate
        for candidate in group
        if abs(candidate.window.end - best.window.end) <= 0.3 * FRAME_RATE
    ]
    end = max(near, key=lambda candidate: candidate.window.drop).window.end
    power = (
        np.square(frames.waveform)
        if onsets.kinds[best.channel] == "tone"
        else frames.power.sum(axis=1)
    )
    region = joint_region(onsets, best.channel, knee(power, end), settings)
    if region is None:
        return None
    exponent, t_end, rate = region.estimates(onsets.kinds[best.channel], settings)
    run = SettlingRun(
        kind=onsets.kinds[best.channel],
        start=region.start,
        t_end=t_end,
        exponent=exponent,
        rate_at_1s=rate,
        events_per_turn=events_per_turn(onsets, best, settings),
        score=float(best.score),
        certain=_certain(near, settings),
        false_alarm=false_alarms_per_hour(best.score, settings),
        bands=(onsets.bands[best.channel],),
        region=region,
        law_scores={name: float(score) for name, score in best.scores.items()},
    )
    begins_slowly = run.rate(run.start) <= settings.fastest_beginning
    return run if begins_slowly or best.score > settings.clear_score else None


def _certain(group, settings):
    """Whether one score, or the mean of two windows of different length, is clear of other
    sounds."""
    best = group[0]
    others = [
        candidate.score
        for candidate in group
        if abs(candidate.window.seconds - best.window.seconds) > 0.01
    ]
    agreeing = bool(others) and (best.score + max(others)) / 2 > settings.agreeing_score
    return bool(best.score > settings.certain_score or agreeing)


def false_alarms_per_hour(score: float, settings: SettlingSettings) -> float:
    """Return the expected number of events per hour that reach a score in eventful sound without a
    disk."""
    above = (score - settings.heard_score) / settings.false_alarm_decay
    return settings.false_alarms_per_hour * math.exp(-above)


def events_per_turn(onsets: OnsetStrength, candidate: Candidate, settings: SettlingSettings) -> int:
    """Return 2 if the bursts of a candidate alternate in strength, as two per turn would, else
    1."""
    window = candidate.window
    values = onsets.values[candidate.channel, window.first : window.stop]
    law = candidate.law
    memory = correlation_length(values, law_phases(len(values), law), law.harmonics)
    independent = len(values) / max(onsets.scales_ms[candidate.channel], memory)
    half = Law(law.shape, law.turns / 2, 2 * law.harmonics, law.likelihood)
    alternation = independent * (predicted_gain(values, half) - predicted_gain(values, law))
    return 2 if alternation > settings.alternation_score else 1
