"""Ensembles of the chaotic final part of a motion, repeated from slightly perturbed
states."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dynamics import Motion, simulate
from dynamics.compliant.compliant_motion import CompliantMotion, simulate_from
from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION
from dynamics.rattling.rattling_motion import RattlingMotion
from sonify.claims.air import final_loss_shares
from sonify.claims.two_way import losses_above_flat, two_way_part, two_way_start
from sonify.scene import Scene


@dataclass(frozen=True, kw_only=True)
class Quantity:
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

    def __str__(self):
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

    def lines(self) -> list[str]:
        """Return one line for each quantity and claim."""
        from sonify.claims.shares import share_of

        claims = (
            f"{claim}: {share_of(holds).draw_count_text}"
            for claim, holds in self.claims.items()
        )
        return [*map(str, self.quantities), *claims]

    def record(self) -> dict[str, Any]:
        """Return the content of ensemble.json."""
        from sonify.claims.shares import share_of

        claims = {
            claim: share_of(holds)._asdict() for claim, holds in self.claims.items()
        }
        return {
            "quantities": [one.summary for one in self.quantities],
            "claims": claims,
        }


def repeat_final_part(
    scene: Scene,
    motion: Motion,
    count: int,
    seed: int = 1,
    watch: Callable[[float], None] = lambda share: None,
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
    seed : int
        Seed of the perturbations.
    watch : callable
        Called with the completed share.
    """
    # Relative standard deviation of the perturbed angular velocities
    relative_perturbation = 1e-5
    random = np.random.default_rng(seed)
    found = two_way_part(motion)
    rattles = isinstance(motion, RattlingMotion)
    table = motion.model.modes if isinstance(motion, RattlingMotion) else None
    repeated: list[Motion] = []
    for i in range(count):
        factors = 1 + relative_perturbation * random.standard_normal(3)
        if found is None or rattles:
            repeated.append(repeat_from_release(scene, factors, table))
        else:
            repeated.append(repeat_two_way_part(scene, found[0], factors))
        watch((i + 1) / count)
    begin = (
        0.0 if found is None or rattles else found[1] + two_way_start(scene, found[0])
    )
    return ensemble_results(repeated, begin)


def repeat_from_release(scene: Scene, factors, table: Any = None) -> Motion:
    """Return the motion with the released angular velocities multiplied by `factors` (3,).

    `table` contains the modes of a table that moves with the disk.
    """
    omega = tuple(np.multiply(scene.release.omega, factors).tolist())
    return simulate(
        replace(scene, release=replace(scene.release, omega=omega)), surface_modes=table
    )


def repeat_two_way_part(
    scene: Scene, part: CompliantMotion, factors
) -> CompliantMotion:
    """Return the motion from the onset of two-way coupling.

    Its initial angular velocities are multiplied by `factors` (3,).
    """
    start = two_way_start(scene, part)
    state = part.at([start])[0]
    state[5:8] *= factors
    span = scene.numerics.time_limit - start
    return simulate_from(
        part.model, state, part.force([start])[0], span, FLAT_INCLINATION
    )


def ensemble_results(motions: list[Motion], begin: float) -> Ensemble:
    """Return the results of repeated motions that start at the time `begin` [s]."""
    losses = np.array([losses_above_flat(one) for one in motions])
    first = np.full((len(motions), 2), np.nan)
    for i, one in enumerate(motions):
        if losses[i]:
            t = max(one.contact_losses[0].t, 0.0)
            first[i] = one.t[-1] - t, one.at([t])[0, 1]
    shares = [final_loss_shares(one) for one in motions]
    quantities = (
        Quantity(
            name="end of the motion",
            unit="s",
            values=begin + np.array([one.t[-1] for one in motions]),
        ),
        Quantity(name="losses of contact", unit="", values=losses.astype(float)),
        Quantity(name="first loss before the end", unit="s", values=first[:, 0]),
        Quantity(name="inclination at the first loss", unit="rad", values=first[:, 1]),
        Quantity(
            name="share of impacts in the last tenth of the energy",
            unit="",
            values=np.array([share["contact"] for share in shares]),
        ),
        Quantity(
            name="share of the table in the last tenth of the energy",
            unit="",
            values=np.array([share["table"] for share in shares]),
        ),
    )
    claims = {
        "contact is lost": losses > 0,
        "impacts take most of the last tenth of the energy": np.array(
            [max(share, key=lambda name: share[name]) == "contact" for share in shares]
        ),
        "the air carries the disk": np.array(
            [one.outcome.name == "AIRBORNE" for one in motions]
        ),
    }
    return Ensemble(quantities=quantities, claims=claims)
