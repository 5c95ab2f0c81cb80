"""Self-checks: every run checks its own numbers and writes the results to run.json."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from math import inf
from typing import Any

import numpy as np

from dynamics import Disk, Motion
from dynamics.rattling.rattling_motion import RattlingMotion
from modal import Modes
from sonify.claims.finding import JUDGES, Judge, Need
from sonify.scene import Scene
from sonify.sound.pressure import Sound


@dataclass(frozen=True, kw_only=True)
class Check:
    """One number that must be within `tolerance` of `expected`; `source` gives the reason.

    A `one_sided` check has no lower limit. `key` is the name of the checking function and is the
    same in every version.
    """

    key: str
    name: str
    value: float
    expected: float = 0.0
    tolerance: float = 0.0
    source: str
    one_sided: bool = False

    def __repr__(self):
        return f"Check({self.key}: {'ok' if self.passed else 'FAILED'}, {self.value:.4g}, {self.expectation})"

    @property
    def passed(self) -> bool:
        """Return True if the value is within the tolerance; a NaN fails."""
        excess = self.value - self.expected
        return bool((excess if self.one_sided else abs(excess)) <= self.tolerance)

    @property
    def expectation(self) -> str:
        """The range in words."""
        if self.one_sided:
            return f"at most {self.expected + self.tolerance:g}"
        return f"{self.expected:g} ± {self.tolerance:g}"


def check(name: str, source: str, needs: tuple[Need, ...], **ends: Any):
    """Turn a function that returns a value into one that returns a `Check`."""

    def decorator(function: Callable[..., float]) -> Callable[..., Check]:
        @wraps(function)
        def judge(*arguments, **options) -> Check:
            value = float(function(*arguments, **options))
            return Check(key=function.__name__, value=value, name=name, source=source, **ends)

        JUDGES[function.__name__] = Judge(judge, needs)
        return judge

    return decorator


@check(
    "energy and dissipated energy add up",
    "dE/dt is the power of friction and resisting moments, (3.2), (3.3)",
    needs=("motion",),
    tolerance=1e-8,
)
def energy_balance(motion: Motion):
    """The largest change of energy plus dissipated energy, relative to its initial value."""
    total = motion.energy(motion.t) + motion.state[:, 10]
    return np.abs(total / total[0] - 1).max()


@check(
    "energy balance",
    "the energy and the losses of a rattling disk, step by step: the error is of second order",
    needs=("motion",),
    tolerance=1.0,
)
def rattling_energy_balance(motion: RattlingMotion):
    """The largest change of energy plus losses over the initial energy, over its limit.

    The limit is 4e-5 for a million steps per second; 0.4e-5 to 2.3e-5 were measured.
    """
    total = motion.energy(motion.t) + motion.state[:, 10]
    limit = 4e-5 * (1e6 / motion.model.rate) ** 2
    return np.abs(total / total[0] - 1).max() / limit


@check(
    "dissipated energy never falls",
    "no power of (3.2), (3.3) is ever negative; sums of steps that are exact to 1e-12 each",
    needs=("motion",),
    tolerance=1e-9,
)
def dissipation_never_falls(motion: Motion):
    """The largest decrease of the dissipated energy between any two instants, over the initial
    energy.
    """
    return motion.largest_regain() / float(motion.energy(0.0)[0])


@check(
    "the friction force stays on its cone",
    "|F| <= mu_s N rolling, |F| = mu_d N sliding, section 3",
    needs=("motion",),
    tolerance=1e-6,
)
def friction_cone(motion: Motion):
    """The largest excess of |F|/N over the static coefficient in rolling, or its largest distance
    from the dynamic coefficient in sliding.
    """
    return motion.friction_excess()


@check(
    "the table never pulls",
    "Phi > 0 while there is contact, section 4",
    needs=("motion",),
)
def pushing_contact(motion: Motion, resolution: float = 1e-5):
    """The share of the time in which the normal force pulls, or vanishes outside the losses of
    contact.

    The forces of an elastic contact are interpolated means over `resolution` [s]. A force counts as
    zero only if it is also zero one `resolution` before and after.
    """
    t = motion.t[:-1]
    around = [
        motion.force(np.clip(t + shift, 0.0, motion.t[-1]))[:, 2]
        for shift in (-resolution, 0.0, resolution)
    ]
    losses = np.reshape(
        [(loss.t, loss.t + loss.duration) for loss in motion.contact_losses], (-1, 2)
    )
    in_a_loss = np.searchsorted(losses[:, 0], t, "right") > np.searchsorted(losses[:, 1], t)
    pulls = (np.min(around, axis=0) < 0) | ((np.max(around, axis=0) <= 0) & ~in_a_loss)
    return np.sum(np.diff(motion.t)[pulls]) / motion.t[-1]


@check(
    "the modes solve their eigenvalue problem",
    "K phi = w^2 M phi",
    needs=("modes",),
    tolerance=1e-6,
)
def mode_residuals(modes: Modes):
    """The largest |phi - w^2 K^-1 M phi| / |phi| of the modes."""
    return modes.residual.max(initial=0.0)


@check(
    "no frequency may be wrong by as much as itself",
    "distance between two meshes or bases",
    needs=("modes",),
    expected=1.0,
    one_sided=True,
)
def mode_errors(modes: Modes):
    """The largest estimated relative error of a frequency."""
    return modes.error.max(initial=0.0)


@check(
    "the elastic model weighs what the disk weighs",
    "mass of the scene",
    needs=("modes",),
    expected=1.0,
    tolerance=1e-3,
)
def discrete_mass(modes: Modes, disk: Disk):
    """The mass of the elastic model over that of the disk."""
    return modes.mass / disk.mass


@check(
    "no sample of sound.wav is clipped, all are finite",
    "a PCM file holds -1 to 1",
    needs=("sound",),
    expected=1.0,
    one_sided=True,
)
def no_sample_clipped(sound: Sound):
    """The peak of sound.wav over full scale; infinite if a sample of the pressure is not finite."""
    return sound.peak / sound.full_scale if sound.finite else inf


def motion_checks(scene: Scene, motion: Motion) -> list[Check]:
    """Return every check of a motion."""
    rattles = isinstance(motion, RattlingMotion)
    balance = [
        rattling_energy_balance(motion) if rattles else energy_balance(motion),
        dissipation_never_falls(motion),
    ]
    return [*balance, friction_cone(motion), pushing_contact(motion)]


def mode_checks(scene: Scene, modes: Modes) -> list[Check]:
    """Return every check of the modes."""
    return [mode_residuals(modes), mode_errors(modes), discrete_mass(modes, scene.disk)]


def all_checks(scene: Scene, motion: Motion, modes: Modes, sound: Sound) -> list[Check]:
    """Return every check of a run."""
    return [*motion_checks(scene, motion), *mode_checks(scene, modes), no_sample_clipped(sound)]
