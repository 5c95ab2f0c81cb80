"""Ensembles of the chaotic final part of a motion, repeated from slightly perturbed
states."""

from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from dynamics import Motion, simulate
from dynamics.compliant.compliant_motion import CompliantMotion, simulate_from
from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION
from sonify.claims.air import final_loss_shares
from sonify.claims.shares import Share, share_of
from sonify.claims.two_way import losses_above_flat, two_way_part, two_way_start
from sonify.runtime.progress import Watch, ignore_progress
from sonify.scene import Scene


class Quantity(NamedTuple):
    """Values (n,) of a quantity in an ensemble; NaN in runs without it."""

    name: str
    unit: str
    values: np.ndarray

    @property
    def summary(self) -> dict[str, Any]:
        """Median, full range and number of the values that exist."""
        known = self.values[np.isfinite(self.values)]
        low, middle, high = (
            np.percentile(known, [0, 50, 100]) if len(known) else [np.nan] * 3
        )
        return {
            "name": self.name,
            "unit": self.unit,
            "median": float(middle),
            "low": float(low),
            "high": float(high),
            "count": len(known),
        }

    def __str__(self) -> str:
        found = self.summary
        if not found["count"]:
            return f"{self.name}: in no run"
        some = f", in {found['count']} of {len(self.values)}"
        return (
            f"{self.name}: {found['median']:.4g} ({found['low']:.4g} to {found['high']:.4g}) "
            f"{self.unit}{some if found['count'] < len(self.values) else ''}"
        )


@dataclass(frozen=True, kw_only=True)
class Ensemble:
    """Results of the repeated final part of a motion."""

    quantities: tuple[Quantity, ...]
    claims: dict[str, np.ndarray]
    """Mask (n,) of the runs in which each claim holds, by the text of the claim."""

    @property
    def shares(self) -> dict[str, Share]:
        """The share of the runs in which each claim holds, by the text of the claim."""
        return {claim: share_of(holds) for claim, holds in self.claims.items()}

    def lines(self) -> list[str]:
        """Return one line for each quantity and claim."""
        claims = (
            f"{claim}: {share.draw_count_text}" for claim, share in self.shares.items()
        )
        return [*map(str, self.quantities), *claims]

    def record(self) -> dict[str, Any]:
        """Return the content of ensemble.json."""
        return {
            "quantities": [one.summary for one in self.quantities],
            "claims": {claim: share._asdict() for claim, share in self.shares.items()},
        }


def repeat_final_part(
    scene: Scene,
    motion: Motion,
    count: int,
    watch: Watch = ignore_progress,
) -> Ensemble:
    """Repeat the chaotic final part of a motion from perturbed states.

    The part begins at the onset of two-way coupling with the table. A motion without
    two-way coupling is repeated from the release.

    Parameters
    ----------
    scene, motion
        A scene and its motion.
    count : int
        Number of repetitions.
    watch : Watch
        Receives the progress.
    """
    # Relative standard deviation of the perturbed angular velocities
    relative_perturbation = 1e-5
    random = np.random.default_rng(1)
    found = two_way_part(motion) if "two-way" in motion.finding_groups else None
    begin = found[1] + two_way_start(found[0]) if found else 0.0
    repeated: list[Motion] = []
    for i in range(count):
        factors = 1 + relative_perturbation * random.standard_normal(3)
        if found:
            repeated.append(repeat_two_way_part(scene, found[0], factors))
        else:
            table = motion.plan.surface_modes
            repeated.append(repeat_from_release(scene, factors, table))
        watch((i + 1) / count)
    return ensemble_results(repeated, begin)


def repeat_from_release(scene: Scene, factors: np.ndarray, table: Any) -> Motion:
    """Return the motion with the released angular velocities multiplied by `factors` (3,).

    `table` contains the modes of the table, or is None.
    """
    omega = tuple(np.multiply(scene.release.omega, factors).tolist())
    perturbed = replace(scene, release=replace(scene.release, omega=omega))
    return simulate(perturbed, surface_modes=table).rolling


def repeat_two_way_part(
    scene: Scene, part: CompliantMotion, factors: np.ndarray
) -> CompliantMotion:
    """Return the motion from the onset of two-way coupling.

    Its initial angular velocities are multiplied by `factors` (3,).
    """
    start = two_way_start(part)
    state = part.at([start])[0]
    state[5:8] *= factors
    force = part.force([start])[0]
    span = scene.numerics.time_limit - start
    return simulate_from(part.plan, part.model, state, force, span, FLAT_INCLINATION)


def ensemble_results(motions: list[Motion], begin: float) -> Ensemble:
    """Return the results of repeated motions that start at the time `begin` [s]."""
    losses = np.array([losses_above_flat(one) for one in motions])
    first = np.full((len(motions), 2), np.nan)
    for i, one in enumerate(motions):
        if losses[i]:
            t = max(one.contact_losses[0].t, 0.0)
            first[i] = one.t[-1] - t, one.at([t])[0, 1]
    shares = [final_loss_shares(one) for one in motions]
    impacts = np.array([share["contact"] for share in shares])
    table = np.array([share["table"] for share in shares])
    quantities = (
        Quantity(
            "end of the motion", "s", begin + np.array([m.t[-1] for m in motions])
        ),
        Quantity("losses of contact", "", losses.astype(float)),
        Quantity("first loss before the end", "s", first[:, 0]),
        Quantity("inclination at the first loss", "rad", first[:, 1]),
        Quantity("share of impacts in the last tenth of the energy", "", impacts),
        Quantity("share of the table in the last tenth of the energy", "", table),
    )
    claims = {
        "contact is lost": losses > 0,
        "impacts take most of the last tenth of the energy": np.array(
            [max(share, key=share.__getitem__) == "contact" for share in shares]
        ),
        "the air lifts the disk": np.array(
            [one.rolling_outcome.name == "AIRBORNE" for one in motions]
        ),
    }
    return Ensemble(quantities=quantities, claims=claims)
