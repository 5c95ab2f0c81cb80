"""Self-checks of the numbers of a run, which run.json records."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from math import inf
from typing import Any

import numpy as np

from dynamics import Disk, Motion
from dynamics.landing import MAX_BOUNCE_ENERGY_ERROR
from modal import Modes
from sonify.claims.finding import JUDGE_BY_KEY, Judge, Need
from sonify.scene import Scene
from sonify.sound.pressure import Sound


@dataclass(frozen=True, kw_only=True)
class Check:
    """A number that must be within `tolerance` of `expected`, for the reason in
    `source`.

    A `one_sided` check has no lower limit. `key` is the name of the checking function
    and is the same in every version."""

    key: str
    name: str
    value: float
    expected: float = 0.0
    tolerance: float = 0.0
    source: str
    one_sided: bool = False

    def __repr__(self) -> str:
        return f"Check({self.key}: {'ok' if self.passed else 'FAILED'}, {self.value:.4g}, {self.expectation})"

    @property
    def passed(self) -> bool:
        """Return True if the value is within the tolerance; a NaN fails."""
        excess = self.value - self.expected
        return bool((excess if self.one_sided else abs(excess)) <= self.tolerance)

    @property
    def expectation(self) -> str:
        """The allowed range as text."""
        if self.one_sided:
            return f"at most {self.expected + self.tolerance:g}"
        return f"{self.expected:g} ± {self.tolerance:g}"


CHECK_BY_KEY: dict[str, Callable[..., Check]] = {}
"""Every checking function by the key of its check."""


def check(
    name: str, source: str, needs: tuple[Need, ...], **ends: Any
) -> Callable[[Callable[..., float]], Callable[..., Check]]:
    """Convert a function that returns a value to one that returns a `Check`."""

    def decorator(function: Callable[..., float]) -> Callable[..., Check]:
        @wraps(function)
        def judge(*arguments: Any, **options: Any) -> Check:
            value = float(function(*arguments, **options))
            return Check(
                key=function.__name__, value=value, name=name, source=source, **ends
            )

        CHECK_BY_KEY[function.__name__] = judge
        JUDGE_BY_KEY[function.__name__] = Judge(judge, needs)
        return judge

    return decorator


@check(
    "the sum of energy and dissipated energy is constant",
    "dE/dt is the power of friction and resisting moments, (3.2), (3.3)",
    needs=("motion",),
    tolerance=1e-8,
)
def energy_balance(motion: Motion) -> float:
    """The largest relative change of the sum of energy and dissipated energy."""
    total = motion.energy(motion.t) + motion.state[:, 10]
    return np.abs(total / total[0] - 1).max()


@check(
    "energy balance",
    "energy and losses of a rattling disk after each step; the error is of second order",
    needs=("motion",),
    tolerance=1.0,
)
def rattling_energy_balance(motion: Motion) -> float:
    """The largest change of energy plus losses, relative to the initial energy and to
    its limit `Motion.max_energy_error`."""
    total = motion.energy(motion.t) + motion.state[:, 10]
    return np.abs(total / total[0] - 1).max() / (motion.max_energy_error or 0.0)


@check(
    "dissipated energy never falls",
    "no power of (3.2), (3.3) is negative; each step is exact to 1e-12",
    needs=("motion",),
    tolerance=1e-9,
)
def dissipation_never_falls(motion: Motion) -> float:
    """The largest decrease of the dissipated energy between two instants, relative to
    the initial energy."""
    return motion.largest_energy_gain_error() / float(motion.energy(0.0)[0])


@check(
    "the friction force stays on its cone",
    "|F| <= mu_s N rolling, |F| = mu_d N sliding, section 3",
    needs=("motion",),
    tolerance=1e-6,
)
def friction_cone(motion: Motion) -> float:
    """The larger of the excess of |F|/N over mu_s in rolling and its deviation from
    mu_d in sliding."""
    return motion.friction_excess()


@check(
    "the table never pulls",
    "Phi > 0 while there is contact, section 4",
    needs=("motion",),
)
def pushing_contact(motion: Motion) -> float:
    """The share of the duration in which the normal force is tensile, or zero outside
    the losses of contact."""
    return motion.tensile_time() / motion.t[-1]


@check(
    "the modes solve their eigenvalue problem",
    "K phi = w^2 M phi",
    needs=("modes",),
    tolerance=1e-6,
)
def mode_residuals(modes: Modes) -> float:
    """The largest |phi - w^2 K^-1 M phi| / |phi| of the modes."""
    return modes.residual.max(initial=0.0)


@check(
    "the relative error of every frequency is below 1",
    "difference between two meshes or bases",
    needs=("modes",),
    expected=1.0,
    one_sided=True,
)
def mode_errors(modes: Modes) -> float:
    """The largest estimated relative error of a frequency."""
    return modes.error.max(initial=0.0)


@check(
    "the elastic model has the mass of the disk",
    "mass of the scene",
    needs=("modes",),
    expected=1.0,
    tolerance=1e-3,
)
def discrete_mass(modes: Modes, disk: Disk) -> float:
    """The ratio of the mass of the elastic model to that of the disk."""
    return modes.mass / disk.mass


@check(
    "all samples of sound.wav are finite and none is clipped",
    "a PCM file stores values from -1 to 1",
    needs=("sound",),
    expected=1.0,
    one_sided=True,
)
def no_sample_clipped(sound: Sound) -> float:
    """The ratio of the largest sample of sound.wav to full scale; infinite if a
    pressure sample is not finite."""
    if not sound.is_finite:
        return inf
    return max(np.abs(block).max() for block in sound.playback_copy.blocks())


def motion_checks(motion: Motion) -> list[Check]:
    """Return every check of a motion and of its landing."""
    rolling = motion.rolling
    balance = (
        energy_balance if rolling.max_energy_error is None else rattling_energy_balance
    )
    checks = (balance, dissipation_never_falls, friction_cone, pushing_contact)
    landing = [landing_energy_balance(motion)] if motion.landing else []
    return [*(judge(rolling) for judge in checks), *landing]


def mode_checks(scene: Scene, modes: Modes) -> list[Check]:
    """Return every check of the modes."""
    return [mode_residuals(modes), mode_errors(modes), discrete_mass(modes, scene.disk)]


@check(
    "the energy of the landing is accounted for",
    "energy and losses after each step; its error grows with the number of impacts",
    needs=("motion",),
    tolerance=MAX_BOUNCE_ENERGY_ERROR,
)
def landing_energy_balance(motion: Motion) -> float:
    """The largest change of energy plus losses after the loss of contact, relative to
    the energy at that moment."""
    late = motion.t >= motion.rolling.t[-1]
    total = (motion.energy(motion.t) + motion.state[:, 10])[late]
    return np.ptp(total) / motion.energy(motion.rolling.t[-1])[0]


def all_checks(scene: Scene, motion: Motion, modes: Modes, sound: Sound) -> list[Check]:
    """Return every check of a run."""
    return [
        *motion_checks(motion),
        *mode_checks(scene, modes),
        no_sample_clipped(sound),
    ]
