"""What a listener hears rising: the tone, the beats or the noise band of the sound.

Each part is measured in the rendered pressure, up to the end of the motion and where it
is audible, by the detector that analyses recordings."""

from typing import NamedTuple, cast

import numpy as np

from dynamics import Motion
from sonify.claims.finding import Finding, Measured, finding, rise_from_first_tenth
from sonify.hearing.audible_levels import AudibleLevels, audible_levels
from sonify.hearing.beats import find_beats, find_bursts
from sonify.hearing.noise_band import NoiseBand, noise_band_to_end
from sonify.hearing.recording import Heard
from sonify.hearing.settling.settling_law import SettlingLaw
from sonify.scene import Scene
from sonify.sound.pressure import Sound

NOISE_BAND_INTERVAL = 0.5
"""Length of the intervals in which the noise band is measured [s]."""
OCTAVE = 2.0
"""Least rise of a tone or of beats."""
MINOR_THIRD = 1.2
"""Least rise of a noise band, a minor third."""
MIN_BAND_INTERVALS = 3
"""Least number of intervals with the noise band."""


class RisingPart(NamedTuple):
    """A part of the sound that may rise.

    Attributes
    ----------
    name : str
        "tone", "beats" or "band".
    first, last : float
        Frequency or rate [Hz] at the beginning and at the end of the audible part.
    relative_margin : float
        Relative error of the ratio of both.
    at_least : float
        Least ratio that counts as a rise.
    per_turn : int
        Number of beats per turn; 0 for other parts and where it is not known.
    """

    name: str
    first: float
    last: float
    relative_margin: float
    at_least: float
    per_turn: int = 0

    @property
    def factor(self) -> float:
        """Ratio of the last to the first frequency."""
        return self.last / self.first

    @property
    def rank(self) -> tuple[int, float]:
        """Order of the parts: those that certainly rise, then the uncertain ones, each
        by its rise relative to the least one."""
        excess = self.factor / self.at_least
        certain = abs(excess - 1) > self.relative_margin * excess
        order = 1 if not certain else 2 * int(excess > 1)
        return order, float(np.log(self.factor) / np.log(self.at_least))

    @property
    def details(self) -> dict[str, float]:
        """The numbers of the part, by name."""
        found = {
            f"{self.name}_from": self.first,
            f"{self.name}_to": self.last,
            f"{self.name}_at_least": self.at_least,
        }
        return found | ({"beats_per_turn": self.per_turn} if self.per_turn else {})


def pitch_findings(
    scene: Scene, motion: Motion, sound: Sound, heard: Heard | None
) -> list[Finding]:
    """Return the findings on what rises in the sound of a run.

    `heard` is the analysis of the sound, or None for one that cannot be analysed. A
    noise band is sought where a rough elastic contact makes one."""
    levels = audible_levels(sound.pressure, sound.source_end)
    audible = levels.audible_between(0.0, sound.source_end)
    parts = []
    band = None
    if heard is not None and audible:
        band = audible_noise_band(scene, motion, sound, heard, levels)
        found = (
            heard.tone and tone_part(heard.tone, sound, levels),
            beats_part(motion, sound, levels),
            band and band_part(band),
        )
        parts = [part for part in found if part]
    return [pitch_rises(parts, audible), *([carrier_rises(band)] if band else [])]


@finding(needs=("motion", "sound"), at_least=OCTAVE)
def pitch_rises(parts: list[RisingPart], audible: bool = True) -> Measured:
    """The greatest ratio by which the tone, the beats or the noise band rises.

    The part that exceeds its own least ratio most decides, and its name is the cause.
    """
    if not audible:
        return Measured(1.0, details={"audible": 0.0})
    if not parts:
        reason = "no audible tone, beats or noise band stands out"
        return Measured(1.0, undecided_because=reason)
    ranked = sorted(parts, key=lambda part: part.rank, reverse=True)
    best = ranked[0]
    details: dict[str, float] = {}
    for part in ranked:
        details |= part.details
    return Measured(
        best.factor,
        best.factor * best.relative_margin,
        details,
        fields={"at_least": best.at_least, "cause": best.name},
    )


def tone_part(
    tone: SettlingLaw, sound: Sound, levels: AudibleLevels
) -> RisingPart | None:
    """Return the rising tone where its third-octave band is audible; None if it hardly
    is."""
    min_frames = 10
    ridge = tone.ridge
    if ridge is None:
        return None
    inside = ridge.time < sound.source_end
    inside &= levels.at(ridge.time, ridge.frequency) > 0
    frequency = ridge.frequency[inside]
    if len(frequency) < min_frames:
        return None
    tenth = max(len(frequency) // 10, 1)
    first = float(np.median(frequency[:tenth]))
    last = float(np.median(frequency[-tenth:]))
    exponent = tone.region.best_exponent
    half_width = tone.exponent.half_width
    margin = abs(np.log(last / first)) * half_width / exponent
    return RisingPart("tone", first, last, float(margin), OCTAVE)


def beats_part(
    motion: Motion, sound: Sound, levels: AudibleLevels
) -> RisingPart | None:
    """Return the audible beats; None if there are none.

    The bursts of a disk that rattles do not keep the phase of its turns."""
    delay = sound.source_end - motion.t[-1]
    full_turn = 2 * np.pi

    def turns(time: np.ndarray) -> np.ndarray:
        inside = np.clip(time - delay, 0.0, motion.t[-1])
        return cast(np.ndarray, motion.at(inside)[:, 0] / full_turn)

    end = sound.source_end
    if "rattling" in motion.finding_groups:
        found = find_bursts(sound.pressure, end)
    else:
        found = find_beats(sound.pressure, turns, end, levels.audible_between)
    if found is None:
        return None
    return RisingPart(
        "beats",
        found.first,
        found.last,
        found.relative_margin,
        OCTAVE,
        found.per_turn,
    )


def audible_noise_band(
    scene: Scene, motion: Motion, sound: Sound, heard: Heard, levels: AudibleLevels
) -> NoiseBand | None:
    """Return the audible noise band of a rough elastic contact up to the end; None
    without one.

    Steady spectral lines are not part of it. Where the highest peak jumps, another band
    begins; the one that lasts longest counts."""
    min_duration = 1.0  # s
    max_jump = 1.25  # between intervals
    rough = scene.contact.law == "elastic" and scene.roughness is not None
    delay = sound.source_end - motion.t[-1]
    if not rough or "contact" not in motion.finding_groups:
        return None
    if motion.t[-1] < min_duration:
        return None
    lines = steady_line_frequencies(heard)
    found = noise_band_to_end(
        sound.pressure, delay, sound.source_end, NOISE_BAND_INTERVAL, lines
    )
    known = np.flatnonzero(np.isfinite(found.frequency))
    heard_there = levels.at(found.time[known], found.frequency[known]) > 0
    known = known[heard_there]
    jumps = np.abs(np.diff(np.log(found.frequency[known]))) > np.log(max_jump)
    bands = np.split(known, np.flatnonzero(jumps) + 1)
    known = max(
        bands, key=lambda band: float(np.ptp(found.time[band])) if len(band) else 0.0
    )
    if len(known) < MIN_BAND_INTERVALS:
        return None
    return NoiseBand(*(column[known] for column in found))


def steady_line_frequencies(heard: Heard) -> list[float]:
    """Return the frequencies [Hz] of the spectral lines that are long and steady."""
    min_duration_share = 0.2  # of the sound
    max_spread = 5.0  # cents
    return [
        line.frequency
        for line in heard.lines
        if line.end - line.begin > min_duration_share * heard.duration
        and line.spread < max_spread
    ]


@finding(needs=("sound",), at_least=MINOR_THIRD)
def carrier_rises(heard: NoiseBand) -> Measured:
    """The ratio of the final to the initial frequency of the noise band."""
    return band_rise(heard)


def band_part(heard: NoiseBand) -> RisingPart:
    """Return the noise band as a part of the sound."""
    rise = band_rise(heard)
    return RisingPart(
        "band",
        rise.details["from"],
        rise.details["to"],
        rise.margin / rise.value,
        MINOR_THIRD,
    )


def band_rise(heard: NoiseBand) -> Measured:
    """Return the ratio of the median frequencies of the noise band in its last three
    intervals and in the first tenth of its intervals, without those in which it is
    unknown."""
    frequency = heard.frequency[np.isfinite(heard.frequency)]
    return rise_from_first_tenth(frequency, MIN_BAND_INTERVALS)
