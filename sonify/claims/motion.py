"""FINDINGS: every claim of the paper as a function of what was solved; a "no" is a result, not a failure."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from inspect import signature
from math import inf

import numpy as np

from dynamics import Motion
from dynamics.numerics import HIGHEST_HEARD
from dynamics.rates import halves, nutation_frequency, precession_rate, slips
from modal import Modes

HEARING = (20.0, HIGHEST_HEARD)
"""What is called audible [Hz]."""
SEEN = 1e-4
"""Of a bar, which is said to six digits, a tolerance that is told."""
FIGURE_4 = 2.5, 214.6
"""The frequency of the normal force that the paper names, over 1/chi, and when its disk reaches it, over chi."""


@dataclass(frozen=True, kw_only=True)
class Finding:
    """A claim, what was found, and the range in which the claim holds, give or take `tolerance`.

    `margin` is by how much the value may be wrong towards the nearest end of that range, its bar, as far as the method
    or the plan can tell. `key` is the name of its function, the same in every version.
    """

    key: str
    claim: str
    value: float
    unit: str
    at_least: float = -inf
    at_most: float = inf
    tolerance: float = 0.0
    margin: float = 0.0
    source: str

    def __repr__(self):
        return f"Finding({self.key}: {self.answer}, {self.value:.5g} {self.unit})"

    @property
    def holds(self) -> bool:
        """Whether the claim stands."""
        return bool(self.at_least - self.tolerance <= self.value <= self.at_most + self.tolerance)

    @property
    def near(self) -> bool:
        """Whether the claim's bar is within the margin of the value: another run may answer differently."""
        bars = np.array([self.at_least - self.tolerance, self.at_most + self.tolerance])
        return bool(self.margin > 0 and (np.abs(self.value - bars) <= self.margin).any())

    @property
    def answer(self) -> str:
        """The answer in words."""
        return ("yes" if self.holds else "no") + ", near its bar" * self.near

    @property
    def measured(self) -> str:
        """The value, no finer than its margin, and that."""
        if not (self.margin > 0 and np.isfinite([self.value, self.margin]).all()):
            return f"{self.value:.4g}"
        digits, coarse = -int(np.floor(np.log10(self.margin))), float(f"{self.margin:.1g}")
        shown = round(self.value, digits) + 0.0
        return f"{shown:.{digits}f} ± {coarse:g}" if 0 <= digits <= 6 else f"{shown:.6g} ± {coarse:g}"

    @property
    def expectation(self) -> str:
        """The range in words."""
        if self.at_least == self.at_most:
            return f"{self.at_least:.6g} ± {self.tolerance:.2g}"
        bars = {word: bar for word, bar in (("at least", self.at_least), ("at most", self.at_most)) if np.isfinite(bar)}
        about = f" ± {self.tolerance:g}" if self.tolerance > SEEN * max(map(abs, bars.values()), default=0) else ""
        return " and ".join(f"{word} {bar:g}{about}" for word, bar in bars.items())


def finding(claim: str, unit: str, source: str, **bars: float):
    """Make a function that returns a value, or value and margin, or these and what is told behind the unit, return the
    Finding of it."""

    def found(key: str, value: float, margin: float = 0.0, told: str = "") -> Finding:
        value, margin, unit_told = float(value), float(margin), unit + told
        return Finding(key=key, claim=claim, value=value, margin=margin, unit=unit_told, source=source, **bars)

    return judging(Finding, found)


def judging(kind: type, made: Callable):
    """Make a function return what is `made`, a Finding or Check, of its name and of what it found."""

    def decorator(function: Callable) -> Callable:
        @wraps(function)
        def judge(*arguments, **options):
            found = function(*arguments, **options)
            return made(function.__name__, *(found if isinstance(found, tuple) else (found,)))

        judge.__dict__["__signature__"] = signature(function).replace(return_annotation=kind)  # hangs_on reads it
        return judge

    return decorator


@finding("The disk goes from rolling to sliding again and again", "transitions", "section 1 of the paper", at_least=2.0)
def repeated_slips(motion: Motion):
    """The number of changes from rolling to sliding; one more or less at the end is a matter of digits."""
    return len(slips(motion)), 1.0


@finding("The normal force is never zero", "least normal force / weight", "section 7, figure 4 (a)", at_least=1e-9)
def contact_kept(motion: Motion):
    """The least normal force over the weight, on two points a piece, the last instant included."""
    load = motion.force(halves(motion))[:, 2] / motion.disk.weight
    return 0.0 if motion.contact_losses else float(load.min()), load[::2].min() - load.min()


@finding(
    "The frequency of the normal force rises as the disk declines",
    "last tenth of the peaks / first tenth",
    "section 7, figure 4 (b)",
    at_least=1.5,
)
def load_frequency_rises(motion: Motion):
    """The frequency of the normal force late in the motion over that early in it."""
    frequency = nutation_frequency(motion)[1]
    tenth = max(len(frequency) // 10, 1)
    (early, about), (late, on) = (median(part) for part in (frequency[:tenth], frequency[-tenth:]))
    return late / early, late / early * float(np.hypot(about / early, on / late))


@finding(
    "The frequency of the normal force reaches f = 2.5 (36 Hz for the paper's disk)",
    "chi from the release until it does, inf if it never does",
    "figure 4 (b), read in quadruple precision; footnote 3",
    at_most=FIGURE_4[1],
    tolerance=0.5,
)
def load_frequency_reached(motion: Motion):
    """The time, in units of chi of (4.5), at which the frequency of the normal force first is FIGURE_4 / chi."""
    chi, level = motion.disk.time_unit, FIGURE_4[0]
    time, frequency = nutation_frequency(motion)
    reached = time[chi * frequency >= level]
    return reached[0] / chi if len(reached) else inf, 1 / level


@finding(
    "The energy falls monotonically",
    "greatest gain between two instants / energy at the start",
    "sections 6.3 and 7, figure 3 (b)",
    at_most=0.0,
    tolerance=1e-12,
)
def energy_falls(motion: Motion):
    """The greatest gain of energy from one solved instant to the next over that at the start, but for rounding."""
    return np.diff(motion.energy(motion.t)).max() / motion.energy(motion.t[:1])[0], 16 * np.finfo(float).eps


@finding(
    "Sliding dissipates more than rolling",
    "power in a slide / the greater of those before and after, median",
    "section 7, figure 3 (b)",
    at_least=1.0,
)
def sliding_costs_more(motion: Motion):
    """The power lost in a slide over the greater of those in the rolling around it, median."""
    power, slides = _powers(motion)
    around = np.maximum(power[slides - 1], power[slides + 1])
    return median(power[slides] / around)


def _powers(motion):
    """Mean power [W] of what is lost in each stretch of rolling or sliding, and which are slides between others."""
    sliding = np.char.startswith(motion.regime((motion.t[1:] + motion.t[:-1]) / 2), "slide")
    edges = np.concatenate([[0], np.flatnonzero(np.diff(sliding)) + 1, [len(sliding)]])
    power = np.diff(motion.state[edges, 10]) / np.diff(motion.t[edges])
    return power, np.arange(2 if sliding[0] else 1, len(power) - 1, 2)


@finding(
    "At least four modes of vibration are in the audible range", "modes from 20 Hz to 20 kHz", "section 8", at_least=4.0
)
def audible_modes(modes: Modes):
    """The number of modes between the limits of hearing."""
    low, high = HEARING
    off = np.abs(np.subtract.outer(modes.frequency, HEARING)).min(axis=1) < modes.error * modes.frequency
    return np.sum((modes.frequency >= low) & (modes.frequency <= high)), off.sum()


@finding(
    "The motion of the centre diminishes until it is almost negligible",
    "extent of the path, last fifth / first fifth",
    "section 7, figure 5",
    at_most=0.1,
)
def centre_comes_to_rest(motion: Motion):
    """The extent of the path of the centre in the last fifth of the time over that in the first."""
    t = np.linspace(0, motion.t[-1], 20001)
    path = motion.at(t)[:, 3:5]
    extent, coarser = (_late_over_early(part) for part in (path, path[::2]))
    return extent, abs(extent - coarser)


def _late_over_early(path):
    """The extent of a path (k, 2) in its last fifth over that in its first."""
    fifth = len(path) // 5
    return float(np.ptp(path[-fifth:], axis=0).max() / np.ptp(path[:fifth], axis=0).max())


@finding(
    "There is no finite-time singularity: the precession rate stays finite",
    "exponent of the precession rate in the time left (negative: it diverges)",
    "section 7",
    at_least=0.0,
    tolerance=0.05,
)
def no_singularity(motion: Motion):
    """The exponent of the precession rate as a power of the time left."""
    least = max(4 * (motion.t_end - motion.t[-1]), motion.t_end * 1e-4)
    left = np.geomspace(least, min(max(motion.t_end / 20, 4 * least), motion.t_end), 400)
    rate = np.abs(precession_rate(motion.at(motion.t_end - left)))
    (exponent, _), covariance = np.polyfit(np.log(left), np.log(rate), 1, cov=True)
    return exponent, 2 * covariance[0, 0] ** 0.5


def median(values, independent: float = 1.0) -> tuple[float, float]:
    """Return the median of values (n,) and twice its standard error, 1.25 sigma/sqrt(n), from their quartiles; of the
    values this share is `independent`."""
    low, middle, high = np.percentile(values, [25, 50, 75])
    return float(middle), float(2 * 1.25 * (high - low) / 1.349 / np.sqrt(max(independent * len(values), 1.0)))


def motion_findings(motion: Motion) -> list[Finding]:
    """The claims about the rigid motion that it can judge: on the frequency of the normal force where it has peaks, on
    sliding where there is rolling before and after, on the end where it has settled."""
    loads = [load_frequency_rises, load_frequency_reached] if len(nutation_frequency(motion)[0]) else []
    slides = [sliding_costs_more] if len(_powers(motion)[1]) else []
    ends = [centre_comes_to_rest, no_singularity] if motion.outcome.name == "SETTLED" else []
    claims = [repeated_slips, contact_kept, *loads, energy_falls, *slides, *ends]
    return [claim(motion) for claim in claims]


def mode_findings(modes: Modes) -> list[Finding]:
    """The claims that the modes alone can judge."""
    return [audible_modes(modes)]


def all_findings(motion: Motion, modes: Modes) -> list[Finding]:
    """Every claim of the paper that this run can judge."""
    return [*motion_findings(motion), *mode_findings(modes)]
