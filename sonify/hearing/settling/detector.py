"""Detect disks and coins that come to rest in a recording, and their rate laws."""

import math
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from sonify.hearing.audio_source import AudioSource, overlapping_pieces
from sonify.hearing.settling.candidates import (
    Candidate,
    rising_margin,
    settling_candidates,
    tone_candidates,
)
from sonify.hearing.settling.ends import knee
from sonify.hearing.settling.joint_region import (
    JointRegion,
    joint_region,
    region_of_law,
)
from sonify.hearing.settling.onset_strength import (
    FRAME_RATE,
    Frames,
    OnsetStrength,
    onset_strength,
    tone_strength,
    waveform_of,
)
from sonify.hearing.settling.prediction_score import (
    independent_samples,
    predicted_gain,
)
from sonify.hearing.settling.settings import SETTLING
from sonify.hearing.settling.settling_law import SettlingLaw
from sonify.hearing.settling.tone_ridge import ToneRidge, tone_ridge
from sonify.runtime.progress import Watch, ignore_progress
from sonify.scene_errors import InputError

MIN_LENGTH_S = 0.4
"""Minimum length of a sound that is searched."""
PIECE_SPACING_S = 60
"""Time between the beginnings of the pieces in which a long sound is searched."""


@dataclass(frozen=True, kw_only=True)
class SettlingRun(SettlingLaw):
    """A disk or coin that comes to rest in a sound, and the evidence for it.

    The attributes of `SettlingLaw` describe its rate.

    Attributes
    ----------
    kind : str
        "tone" if it is detected in the sound itself, "repetition" if in the power of
        bands.
    events_per_turn : int
        2 if successive bursts alternate in strength, otherwise 1. The number of turns
        may be wrong by a factor of two.
    score : float
        Q, the margin with which the law predicts held-out parts of the sound better
        than steady, slowing or otherwise rising rates.
    certain : bool
        True if the score, or the mean score of two windows, exceeds the scores of other
        sounds.
    bands : tuple of (float, float)
        Bands in which the run is detected [Hz].
    law_scores : dict
        Scores of the disk and of the rival laws.
    false_alarm : float
        Expected number of events of this score in a sound of this length without a
        disk.
    """

    kind: str
    events_per_turn: int
    score: float
    certain: bool
    bands: tuple[tuple[float, float], ...]
    law_scores: dict[str, float]
    false_alarm: float = 0.0

    def __repr__(self) -> str:
        return f"SettlingRun({self.kind} {self._words}, score {self.score:.1f})"


def strongest_tone(sound: AudioSource) -> SettlingLaw | None:
    """Return the law of the tone that explains most octaves of frequency in the sound of
    one known disk, or None.

    The tone must merely stand out, because the resonances of a table shift its phase;
    its law is not compared with those of other sounds."""
    laws = []
    for begin, samples, (first_end, last_end) in _searched_pieces(sound):
        ridge = tone_ridge(samples, sound.sample_rate)
        if ridge and _rises(ridge) and first_end <= ridge.law[0] < last_end:
            laws.append(SettlingLaw.of_ridge(ridge).later(begin))

    def explained_octaves(law: SettlingLaw) -> float:
        assert law.ridge is not None, "the law is that of a ridge"
        return law.ridge.law[1] * law.ridge.octaves

    return max(laws, key=explained_octaves, default=None)


def settling_runs(
    sound: AudioSource, watch: Watch = ignore_progress
) -> list[SettlingRun]:
    """Return the disks and coins that come to rest in a sound of any length.

    They are the `settling_events` that do not overlap an event of higher score, in
    order of time.
    """
    events = settling_events(sound, watch)
    return sorted(non_overlapping_runs(events), key=lambda run: run.start)


def settling_events(
    sound: AudioSource, watch: Watch = ignore_progress
) -> list[SettlingRun]:
    """Return the events of disks and coins that come to rest in a sound of any length.

    The tone and the repetition of one disk are two events. No event is found in a sound
    shorter than 0.4 s.

    Parameters
    ----------
    sound : AudioSource
        The sound; its loudest channel is searched.
    watch : callable, optional
        Called with the share of the sound that is searched.

    Raises
    ------
    InputError
        If the sound contains nonfinite samples.
    """
    rate = sound.sample_rate
    hours = sound.frames / rate / 3600
    runs = []
    with ThreadPoolExecutor(1) as pool:  # the array code releases the GIL
        for begin, samples, span in _searched_pieces(sound):
            bursts = pool.submit(repetitions, samples, rate, span)
            found = tones(samples, rate, span) + bursts.result()
            runs += [run.later(begin) for run in found]
            watch(min((begin + PIECE_SPACING_S) * rate / sound.frames, 1.0))
    return [
        replace(run, false_alarm=false_alarms_per_hour(run.score) * hours)
        for run in runs
    ]


def _searched_pieces(
    sound: AudioSource,
) -> Iterator[tuple[float, np.ndarray, tuple[float, float]]]:
    """Yield the beginning [s] and the samples (n,) of each piece of a sound, and the
    time span in the piece [s] in which its runs end."""
    overlap = 10  # s
    lead = 8.5  # s, in which no run ends, because the piece before contains this end
    rate = sound.sample_rate
    if sound.frames < MIN_LENGTH_S * rate:
        return
    channel = _loudest_channel(sound)
    for number, piece in enumerate(
        overlapping_pieces(sound, PIECE_SPACING_S * rate, overlap * rate)
    ):
        begin = number * PIECE_SPACING_S
        samples = piece[: sound.frames - begin * rate, channel]
        if not np.isfinite(samples).all():
            raise InputError(
                f"the sound contains samples that are not finite, after {begin} s"
            )
        last = (begin + PIECE_SPACING_S + overlap) * rate >= sound.frames
        first_end = lead if number else 0
        last_end = math.inf if last else PIECE_SPACING_S + lead
        yield begin, samples, (first_end, last_end)
        if last:
            break


def _loudest_channel(sound: AudioSource) -> int:
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
    span: tuple[float, float],
) -> list[SettlingRun]:
    """Return the runs of the kind "tone" in samples (n,) that end within a time span
    [s].

    The parts before and after a tone are searched too.
    """
    ridge = tone_ridge(samples, rate)
    if ridge is None:
        return []
    run = _tone_run(samples, rate, ridge, can_be_cut=math.isinf(span[1]))
    if run is None:
        return []
    end = ridge.law[0]
    before = samples[: int(ridge.time[0] * rate)]
    after = int((end + 0.1) * rate)
    found = [run] if span[0] <= end < span[1] else []
    if len(before) > MIN_LENGTH_S * rate:
        found += tones(before, rate, (span[0], min(span[1], end)))
    if len(samples) - after > MIN_LENGTH_S * rate:
        later = (span[0] - after / rate, span[1] - after / rate)
        found += [
            run.later(after / rate) for run in tones(samples[after:], rate, later)
        ]
    return found


def _rises(ridge: ToneRidge) -> bool:
    """Return True if a ridge is long enough and rises, from the band of the waveform."""
    min_octaves = 2.0  # of the remaining time; sounds without a disk reach 1.7
    min_rise = 0.5  # octaves
    rise = ridge.law[1] * np.ptp(np.log2(ridge.law[0] - ridge.time))
    is_long = ridge.octaves >= min_octaves and rise >= min_rise
    return bool(is_long and _last_time_in_band(ridge) >= min(SETTLING.window_lengths))


def _last_time_in_band(ridge: ToneRidge) -> float:
    """Return the time [s] at which a tone leaves the band of the waveform, at the latest
    20 ms before its end."""
    min_stop_time = 0.02  # s
    end, exponent, height = ridge.law
    highest = 0.9 * SETTLING.waveform_band[1]
    return float(end - max((2**height / highest) ** (1 / exponent), min_stop_time))


def _tone_run(
    samples: np.ndarray, rate: float, ridge: ToneRidge, can_be_cut: bool
) -> SettlingRun | None:
    """Return the run of a ridge, or None if it is not sufficient evidence of a disk.

    If it `can_be_cut`, the end of the law may be missing in the samples."""
    if not _rises(ridge):
        return None
    waveform = waveform_of(samples, rate)
    onsets = tone_strength(waveform)
    stop = min(int(_last_time_in_band(ridge) * FRAME_RATE), len(waveform))
    heard = [
        candidate
        for candidate in tone_candidates(waveform, onsets, stop)
        if is_heard(candidate) and not is_bouncing(candidate)
    ]
    if not heard:
        return None
    start = heard[0].window.first / FRAME_RATE
    length = len(samples) / rate
    stop_of_sound = length if can_be_cut and ridge.law[0] > length else None
    region = region_of_law(ridge.law, ridge.errors, start, stop_of_sound)
    return _run_of_candidates(heard, onsets, region, ridge)


def repetitions(
    samples: np.ndarray,
    rate: float,
    span: tuple[float, float],
) -> list[SettlingRun]:
    """Return the runs of the kind "repetition" in samples (n,) that end within a time
    span [s]."""
    frames = Frames(samples, rate)
    onsets = onset_strength(frames)
    candidates = settling_candidates(frames, onsets, span)
    bouncing = [candidate for candidate in candidates if is_bouncing(candidate)]
    heard = [
        candidate
        for candidate in candidates
        if is_heard(candidate) and not _is_near_bouncing_body(candidate, bouncing)
    ]
    groups = _groups_of_overlapping(heard)
    runs = [_run_of_group(group, frames, onsets) for group in groups]
    return [run for run in runs if run is not None]


def is_heard(candidate: Candidate) -> bool:
    """Return True if a candidate is sufficient evidence of a disk."""
    min_rising_margin = 2.0  # over other rising rates
    min_slope = -0.8  # of pulse levels [dB] against 20 log10 of the remaining time
    max_slope = 0.65
    law = candidate.law
    first_rate = law.turns * law.shape.first_rate / candidate.window.seconds
    clear = candidate.score > SETTLING.min_clear_score
    slow = first_rate <= SETTLING.max_initial_rate
    return (
        candidate.score > SETTLING.min_detected_score
        and rising_margin(candidate.scores) > min_rising_margin
        and candidate.slope <= max_slope
        and (clear or (slow and candidate.slope >= min_slope))
    )


def is_bouncing(candidate: Candidate) -> bool:
    """Return True if the law and the levels of a candidate are those of a bouncing body.

    For a constant restitution, exponent and slope are 1; the exponent is less if the last
    bounces are lost in noise."""
    min_exponent = 0.6
    min_slope = 0.65
    max_slope = 1.5
    is_steep = candidate.law.shape.exponent >= min_exponent
    return is_steep and min_slope <= candidate.slope <= max_slope


def _is_near_bouncing_body(candidate: Candidate, bouncing: list[Candidate]) -> bool:
    """Return True if a bouncing candidate of higher score overlaps a candidate or is
    close to it."""
    max_distance = 0.4  # s
    return any(
        other.score > candidate.score
        and other.window.overlaps(candidate.window, max_distance * FRAME_RATE)
        for other in bouncing
    )


def _groups_of_overlapping(candidates: list[Candidate]) -> list[list[Candidate]]:
    """Group the candidates whose windows overlap; each group belongs to a run, best
    candidate first."""
    groups: list[list[Candidate]] = []
    for candidate in candidates:
        for group in groups:
            if candidate.window.overlaps(group[0].window):
                group.append(candidate)
                break
        else:
            groups.append([candidate])
    return groups


def _run_of_group(
    group: list[Candidate], frames: Frames, onsets: OnsetStrength
) -> SettlingRun | None:
    """Return the run of a group of candidates, or None if its law is not admissible."""
    best = group[0]
    near = [
        candidate
        for candidate in group
        if abs(candidate.window.end - best.window.end) <= 0.3 * FRAME_RATE
    ]
    max_score_loss = 3.0  # of a window with a drop, to the best window
    if not best.window.shows_end:
        near = [one for one in near if one.score >= best.score - max_score_loss]
    last = max(near, key=lambda candidate: candidate.window.drop or 0.0).window
    power = frames.power.sum(axis=1)
    stop = last.end
    if last.shows_end:
        stop = int(min(knee(power, last.end), _end_before_drop(near)))
    region = joint_region(onsets, best.channel, stop, not last.shows_end)
    if region is None:
        return None
    run = _run_of_candidates(near, onsets, region)
    begins_slowly = run.rate(run.start) <= SETTLING.max_initial_rate
    return run if begins_slowly or best.score > SETTLING.min_clear_score else None


def _end_before_drop(candidates: list[Candidate]) -> float:
    """Return the mean end of the laws of candidates [frames] if all of them end clearly
    before the drop of the best one, which is then that of another sound; otherwise
    infinity."""
    min_gap = 0.03 * FRAME_RATE
    drop = candidates[0].window.end
    ends = [one.end_of_law for one in candidates if one.window.end == drop]
    return round(np.mean(ends)) if max(ends) < drop - min_gap else math.inf


def _run_of_candidates(
    candidates: list[Candidate],
    onsets: OnsetStrength,
    region: JointRegion,
    ridge: ToneRidge | None = None,
) -> SettlingRun:
    """Return the run of candidates of one end, the best first."""
    best = candidates[0]
    exponent, t_end, rate = region.estimates() if ridge is None else region.limits()
    return SettlingRun(
        kind="tone" if ridge else "repetition",
        start=region.start,
        t_end=t_end,
        exponent=exponent,
        rate_at_1s=rate,
        events_per_turn=events_per_turn(onsets, best),
        score=float(best.score),
        certain=_is_certain(candidates),
        bands=(onsets.bands[best.channel],),
        region=region,
        law_scores={name: float(score) for name, score in best.scores.items()},
        ridge=ridge,
    )


def _is_certain(group: list[Candidate]) -> bool:
    """Return True if a score, or the mean score of two windows of different length,
    exceeds the scores of sounds without a disk."""
    min_agreeing_score = 13.0
    best = group[0]
    others = [
        candidate.score
        for candidate in group
        if abs(candidate.window.seconds - best.window.seconds) > 0.01
    ]
    mean = (best.score + max(others)) / 2 if others else -math.inf
    return bool(best.score > SETTLING.min_certain_score or mean > min_agreeing_score)


def false_alarms_per_hour(score: float) -> float:
    """Return the expected number of events per hour that reach a score in sounds
    without a disk."""
    above = (score - SETTLING.min_detected_score) / SETTLING.false_alarm_decay
    return SETTLING.false_alarms_per_hour * math.exp(-above)


def events_per_turn(onsets: OnsetStrength, candidate: Candidate) -> int:
    """Return 2 if the bursts of a candidate alternate in strength, otherwise 1."""
    min_gain = 2.0  # of the log likelihood
    window = candidate.window
    values = onsets.values[candidate.channel][:, window.frames]
    law = candidate.law
    half = replace(law, turns=law.turns / 2, harmonics=2 * law.harmonics)
    gain = predicted_gain(values, half) - predicted_gain(values, law)
    scale = onsets.scales_ms[candidate.channel]
    gain *= math.prod(independent_samples(values, scale, law))
    return 2 if gain > min_gain else 1
