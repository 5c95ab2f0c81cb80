"""Detect disks and coins that come to rest in a recording, and their rate laws."""

import math
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from sonify.hearing.audio_source import Source, overlapping_pieces
from sonify.hearing.settling.candidates import (
    Candidate,
    candidates_of,
    tone_candidates,
)
from sonify.hearing.settling.ends import knee
from sonify.hearing.settling.joint_region import (
    Estimate,
    JointRegion,
    joint_region,
    region_of_law,
)
from sonify.hearing.settling.onset_strength import (
    FRAME_RATE,
    Frames,
    OnsetStrength,
    frames_of,
    onset_strength,
    tone_strength,
    waveform_of,
)
from sonify.hearing.settling.prediction_score import (
    independent_samples,
    predicted_gain,
)
from sonify.hearing.settling.settings import KNOWN_DISK_SETTINGS, SettlingSettings
from sonify.hearing.settling.tone_ridge import ToneRidge, tone_ridge
from sonify.scene_errors import InputError

MIN_LENGTH_S = 0.4
"""Minimum length of a sound that is searched."""
PIECE_SPACING_S = 60
"""Time between the beginnings of the pieces in which a long sound is searched."""
PIECE_OVERLAP_S = 10
"""Time shared by neighbouring pieces."""
PIECE_LEAD_S = 8.5
"""Initial part of a later piece in which no run may end, because the piece before it
contains the same end."""


@dataclass(frozen=True)
class SettlingRun:
    """A disk or coin that comes to rest, with times in s, rates in Hz and 95 %
    intervals.

    Attributes
    ----------
    kind : str
        "tone" if it is detected in the sound itself, "repetition" if in the power of
        bands.
    start, t_end, exponent, rate_at_1s : float, Estimate, Estimate, Estimate
        Start of the best window, and the law rate ~ (t_end - t)^-exponent; the rate is
        that one second before the end, or at the start if that is later.
    events_per_turn : int
        2 if successive bursts alternate in strength, otherwise 1. The number of turns
        may be wrong by a factor of two.
    score : float
        Q, the margin with which the law predicts held-out parts of the sound better
        than steady, slowing or otherwise rising rates.
    certain : bool
        True if the score, or the mean score of two windows, exceeds the scores of other
        sounds.
    false_alarm : float
        Expected number of events of this score in a sound of this length without a
        disk.
    bands : tuple of (float, float)
        Bands in which the run is detected [Hz].
    region : JointRegion
        Laws that the windows of this end admit.
    law_scores : dict
        Scores of the disk and of the rival laws.
    ridge : ToneRidge or None
        Ridge of a tone.
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
    ridge: ToneRidge | None = None

    def turns_left(self, time: np.ndarray) -> np.ndarray:
        """Return the number of turns (or bursts) between times [s] and the end."""
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
        """Return the run shifted to later times by `seconds`."""
        return replace(
            self,
            start=self.start + seconds,
            t_end=self.t_end.later(seconds),
            region=self.region.later(seconds),
            ridge=self.ridge and self.ridge.later(seconds),
        )


def strongest_tone(sound: Source) -> SettlingRun | None:
    """Return the event of the kind "tone" whose law explains most octaves of frequency in
    the sound of a known disk, or None."""
    events = settling_events(sound, KNOWN_DISK_SETTINGS, kinds=("tone",))
    return max(events, key=lambda event: event.ridge.explained_octaves, default=None)


def settling_runs(
    sound: Source,
    settings: SettlingSettings | None = None,
    watch: Callable[[float], None] = lambda share: None,
) -> list[SettlingRun]:
    """Return the disks and coins that come to rest in a sound of any length.

    They are the `settling_events` that do not overlap an event of higher score, in
    order of time.
    """
    events = settling_events(sound, settings, watch=watch)
    return sorted(non_overlapping_runs(events), key=lambda run: run.start)


def settling_events(
    sound: Source,
    settings: SettlingSettings | None = None,
    kinds: tuple[str, ...] = ("tone", "repetition"),
    watch: Callable[[float], None] = lambda share: None,
) -> list[SettlingRun]:
    """Return the events of disks and coins that come to rest in a sound of any length.

    The tone and the repetition of one disk are two events.

    Parameters
    ----------
    sound : Source
        The sound; its loudest channel is searched.
    settings : SettlingSettings, optional
        Thresholds.
    kinds : tuple of str, optional
        Kinds of the events that are searched.
    watch : callable, optional
        Called with the share of the sound that is searched.

    Returns
    -------
    list of SettlingRun
        Empty if none is detected or the sound is shorter than 0.4 s.

    Raises
    ------
    InputError
        If the sound contains nonfinite samples.
    """
    settings = settings or SettlingSettings()
    rate = sound.sample_rate
    if sound.frames < MIN_LENGTH_S * rate:
        return []
    runs = []
    with ThreadPoolExecutor(1) as pool:  # the array code releases the GIL
        for begin, samples, span in _searched_pieces(sound):
            here, *others = (
                partial(SEARCH_BY_KIND[kind], samples, rate, settings, span)
                for kind in kinds
            )
            parallel_searches = [pool.submit(search) for search in others]
            found = [here(), *(search.result() for search in parallel_searches)]
            runs += [run.later(begin) for group in found for run in group]
            watch(min((begin + PIECE_SPACING_S) * rate / sound.frames, 1.0))
    hours = sound.frames / rate / 3600
    return [
        replace(run, false_alarm=false_alarms_per_hour(run.score, settings) * hours)
        for run in runs
    ]


def _searched_pieces(
    sound: Source,
) -> Iterator[tuple[float, np.ndarray, tuple[float, float]]]:
    """Yield the beginning [s] and the samples (n,) of each piece of a sound, and the
    time span in the piece [s] in which its runs end."""
    rate = sound.sample_rate
    channel = _loudest_channel(sound)
    for number, piece in enumerate(
        overlapping_pieces(sound, PIECE_SPACING_S * rate, PIECE_OVERLAP_S * rate)
    ):
        begin = number * PIECE_SPACING_S
        samples = piece[: sound.frames - begin * rate, channel]
        if not np.isfinite(samples).all():
            raise InputError(
                f"the sound contains samples that are not finite, after {begin} s"
            )
        last = (begin + PIECE_SPACING_S + PIECE_OVERLAP_S) * rate >= sound.frames
        first_end = PIECE_LEAD_S if number else 0
        last_end = math.inf if last else PIECE_SPACING_S + PIECE_LEAD_S
        if len(samples) >= MIN_LENGTH_S * rate:
            yield begin, samples, (first_end, last_end)
        if last:
            break


def _loudest_channel(sound):
    """Return the index of the channel with the largest energy."""
    energy = 0.0
    for block in sound.blocks():
        if block.shape[1] == 1:
            return 0
        energy = energy + np.square(block, dtype=float).sum(axis=0)
    return int(np.argmax(energy))


def non_overlapping_runs(runs: list[SettlingRun]) -> list[SettlingRun]:
    """Return the runs that do not overlap a run of higher score, the best first."""
    kept: list[SettlingRun] = []
    for run in sorted(runs, key=lambda run: -run.score):
        if all(
            run.start >= other.t_end.high or other.start >= run.t_end.high
            for other in kept
        ):
            kept.append(run)
    return kept


def tones(
    samples: np.ndarray,
    rate: float,
    settings: SettlingSettings,
    span: tuple[float, float],
) -> list[SettlingRun]:
    """Return the runs of the kind "tone" in samples (n,) that end within a time span
    [s].

    Unless the settings exclude it, the parts before and after a tone are searched too. The
    false alarms are per hour.
    """
    ridge = tone_ridge(samples, rate)
    run = _tone_run(samples, rate, ridge, settings) if ridge else None
    if run is None:
        return []
    end = ridge.law[0]
    before = samples[: max(int(ridge.time[0] * rate), 0)]
    after = int((end + 0.1) * rate)
    found = [run] if span[0] <= end < span[1] else []
    if not settings.has_several_tones:
        return found
    found += (
        tones(before, rate, settings, span) if len(before) > MIN_LENGTH_S * rate else []
    )
    if len(samples) - after > MIN_LENGTH_S * rate:
        later = (span[0] - after / rate, span[1] - after / rate)
        found += [
            run.later(after / rate)
            for run in tones(samples[after:], rate, settings, later)
        ]
    return found


def _tone_run(samples, rate, ridge, settings):
    """Return the run of a ridge, or None if it is not sufficient evidence of a disk."""
    if (
        ridge.octaves < settings.min_tone_octaves
        or ridge.rise < settings.min_tone_rise_octaves
    ):
        return None
    waveform = waveform_of(samples, rate, settings)
    onsets = tone_strength(waveform, settings)
    end, exponent, height = ridge.law
    highest = 0.9 * settings.waveform_band[1]
    stop = end - max(
        (2**height / highest) ** (1 / exponent), settings.min_tone_stop_time
    )
    stop = min(int(stop * FRAME_RATE), len(waveform))
    candidates = tone_candidates(waveform, onsets, stop, settings)
    heard = [
        candidate
        for candidate in candidates
        if is_heard(candidate, settings) and not is_bouncing(candidate, settings)
    ]
    if not heard:
        return None
    start = heard[0].window.first / FRAME_RATE
    region = region_of_law(ridge.law, ridge.errors, start, settings)
    estimates = (
        Estimate(value, low, high)
        for low, value, high in (
            region.exponents.tolist(),
            region.ends.tolist(),
            region.rates.tolist(),
        )
    )
    return _run_of_candidates(heard, onsets, region, estimates, settings, ridge)


def repetitions(
    samples: np.ndarray,
    rate: float,
    settings: SettlingSettings,
    span: tuple[float, float],
) -> list[SettlingRun]:
    """Return the runs of the kind "repetition" in samples (n,) that end within a time
    span [s].

    Their false alarms are per hour.
    """
    frames = frames_of(samples, rate, settings)
    onsets = onset_strength(frames, settings)
    candidates = candidates_of(frames, onsets, settings, span)
    bouncing = [
        candidate for candidate in candidates if is_bouncing(candidate, settings)
    ]
    heard = [
        candidate
        for candidate in candidates
        if is_heard(candidate, settings)
        and not _is_near_bouncing_body(candidate, bouncing, settings)
    ]
    runs = [
        _run_of_group(group, frames, onsets, settings)
        for group in _groups_of_overlapping(heard)
    ]
    return [run for run in runs if run is not None]


SEARCH_BY_KIND = {"tone": tones, "repetition": repetitions}
"""Search for each kind of event."""


def is_heard(candidate: Candidate, settings: SettlingSettings) -> bool:
    """Return True if a candidate is sufficient evidence of a disk."""
    low, high = settings.pulse_slopes
    clear = candidate.score > settings.min_clear_score
    slow = candidate.first_rate <= settings.max_initial_rate
    return (
        candidate.score > settings.min_detected_score
        and candidate.rising_margin > settings.min_rising_margin
        and candidate.slope <= high
        and (clear or (slow and candidate.slope >= low))
    )


def is_bouncing(candidate: Candidate, settings: SettlingSettings) -> bool:
    """Return True if the law and the levels of a candidate are those of a bouncing
    body."""
    low, high = settings.bounce_slopes
    return (
        candidate.exponent >= settings.min_bounce_exponent
        and low <= candidate.slope <= high
    )


def _is_near_bouncing_body(candidate, bouncing, settings):
    """Return True if a bouncing candidate of higher score overlaps a candidate or is
    close to it."""
    near = settings.max_bounce_distance * FRAME_RATE
    return any(
        other.score > candidate.score
        and other.window.first < candidate.window.end + near
        and candidate.window.first < other.window.end + near
        for other in bouncing
    )


def _groups_of_overlapping(candidates: list[Candidate]) -> list[list[Candidate]]:
    """Group the candidates whose windows overlap; each group belongs to a run, best
    candidate first."""
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


def _run_of_group(
    group: list[Candidate],
    frames: Frames,
    onsets: OnsetStrength,
    settings: SettlingSettings,
):
    """Return the run of a group of candidates, or None if its law is not admissible."""
    best = group[0]
    near = [
        candidate
        for candidate in group
        if abs(candidate.window.end - best.window.end) <= 0.3 * FRAME_RATE
    ]
    end = max(near, key=lambda candidate: candidate.window.drop).window.end
    power = frames.power.sum(axis=1)
    region = joint_region(onsets, best.channel, knee(power, end), settings)
    if region is None:
        return None
    run = _run_of_candidates(near, onsets, region, region.estimates(settings), settings)
    begins_slowly = run.rate(run.start) <= settings.max_initial_rate
    return run if begins_slowly or best.score > settings.min_clear_score else None


def _run_of_candidates(candidates, onsets, region, estimates, settings, ridge=None):
    """Return the run of candidates of one end, the best first."""
    best = candidates[0]
    exponent, t_end, rate = estimates
    return SettlingRun(
        kind=onsets.kind,
        start=region.start,
        t_end=t_end,
        exponent=exponent,
        rate_at_1s=rate,
        events_per_turn=events_per_turn(onsets, best, settings),
        score=float(best.score),
        certain=_is_certain(candidates, settings),
        false_alarm=false_alarms_per_hour(best.score, settings),
        bands=(onsets.bands[best.channel],),
        region=region,
        law_scores={name: float(score) for name, score in best.scores.items()},
        ridge=ridge,
    )


def _is_certain(group, settings):
    """Return True if a score, or the mean score of two windows of different length,
    exceeds the scores of sounds without a disk."""
    best = group[0]
    others = [
        candidate.score
        for candidate in group
        if abs(candidate.window.seconds - best.window.seconds) > 0.01
    ]
    agreeing = (
        bool(others) and (best.score + max(others)) / 2 > settings.min_agreeing_score
    )
    return bool(best.score > settings.min_certain_score or agreeing)


def false_alarms_per_hour(score: float, settings: SettlingSettings) -> float:
    """Return the expected number of events per hour that reach a score in sounds
    without a disk."""
    above = (score - settings.min_detected_score) / settings.false_alarm_decay
    return settings.false_alarms_per_hour * math.exp(-above)


def events_per_turn(
    onsets: OnsetStrength, candidate: Candidate, settings: SettlingSettings
) -> int:
    """Return 2 if the bursts of a candidate alternate in strength, otherwise 1."""
    window = candidate.window
    values = onsets.values[candidate.channel, window.first : window.stop]
    law = candidate.law
    half = replace(law, turns=law.turns / 2, harmonics=2 * law.harmonics)
    gain = predicted_gain(values, half) - predicted_gain(values, law)
    gain *= independent_samples(values, onsets.scales_ms[candidate.channel], law)
    return 2 if gain > settings.min_alternation_gain else 1
