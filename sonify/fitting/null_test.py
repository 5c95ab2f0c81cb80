"""FIT -> NULL TEST: a recording of another mechanism, with the same noise, goes through the same
ear."""

from dataclasses import dataclass, replace

import numpy as np

from sonify.fitting.decay_model import Decline
from sonify.fitting.least_squares import LENGTHS, Value, solved_near, tracked
from sonify.fitting.line_selection import Judged, Sound, heard, judge, stream
from sonify.fitting.synthetic import Recording, recording
from sonify.hearing.recording import RecordingError

OTHERS = {
    "rolling": ("air",),
    "air": ("rolling",),
    "both": ("rolling", "air"),
    "cannot tell": ("rolling", "air"),
}
"""Which mechanisms alone are put in place of what was found."""
ALONE = {"rolling": [1e-4, 0.0, 0.0], "air": [0.0, 1.0, 0.0]}
RATE, PILOT = 8000, 0.3
"""Samples a second of the recordings, and the noise of the one by which the noise is measured."""


@dataclass(frozen=True, kw_only=True)
class Null:
    """What the ear said, `verdict`, `rolling` and `air`, of a recording in which `truth` alone
    slowed the disk, as `shares` (3,) that decline most like what was heard."""

    truth: str
    shares: tuple[float, ...]
    verdict: str
    rolling: Value | None = None
    air: Value | None = None


def null_tests(decline: Decline, judged: Judged) -> list[Null]:
    """Return how the ear judges each other mechanism in a steady decline; what the disk has none of
    is left out."""
    names = [name for name in OTHERS[judged.verdict] if name == "rolling" or decline.has_film]
    return [_null(decline, judged, name) for name in names]


def _null(decline, judged, name):
    rates = judged.fit.heard[0].rates
    end = judged.fit.ends[0]
    free = tuple(np.flatnonzero(ALONE[name]).tolist())
    _, shares, _ = solved_near(judged.fit.heard[:1], [end], np.array(ALONE[name]), free)
    end -= float(rates.time.min()) - 0.5
    none = Null(truth=name, shares=tuple(shares), verdict="cannot tell")

    def made(noise):
        return recording(
            decline, shares, noise=noise, end=end, duration=end + 1.0, rate=RATE, seed=1
        )

    try:
        pilot = Sound(name="pilot", samples=made(PILOT), rate=RATE, start=0.0, tones={})
        clear = tracked(decline, stream(pilot, judged.signal), end, shares, LENGTHS[-1]).clear
        louder = float(np.sqrt(np.median(clear) / np.median(rates.clear))) if len(clear) else 1.0
        source = Recording(samples=made(PILOT * louder), sample_rate=RATE)
        sound = heard(source, "null test", (judged.signal,), judged.sounds[0].recorded)
        one = judge(decline, [sound], correct=False)
    except RecordingError:
        return none
    return replace(
        none, verdict=one.verdict, **{law: one.values().get(law) for law in ("rolling", "air")}
    )
