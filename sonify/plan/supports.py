"""Modes of the disk on each kind of support, and on its contact during a run."""

from dataclasses import dataclass, replace

import numpy as np

from dynamics import Motion
from modal import Modes, Support, UnsolvableError, eigenmodes
from sonify.plan import sentences
from sonify.plan.plan import Decision
from sonify.scene import Scene


@dataclass(frozen=True, kw_only=True)
class SupportStep:
    """Modes of a disk on its contact at a time `t` [s] and an inclination [rad].

    `modes` is None if the contact is too stiff to be modelled by springs.
    """

    name: str
    t: float
    inclination: float
    modes: Modes | None


def modes_over_run(scene: Scene, motion: Motion, below: float) -> list[SupportStep]:
    """Return the modes below `below` [Hz] at the release, in the middle and at the end
    of a motion.

    The list is empty unless the support is the contact.
    """
    if scene.support.kind != "contact":
        return []
    min_contact_degrees = 1e-5  # below it the contact is not a single ellipse
    names = ("release", "middle", "end")
    found = []
    for name, t in zip(names, np.linspace(0, motion.t[-1], len(names)), strict=True):
        degrees = max(float(np.degrees(motion.at([t])[0, 1])), min_contact_degrees)
        support = replace(scene.support, inclination_deg=degrees)
        try:
            modes = eigenmodes(scene, below, support)
        except UnsolvableError:
            modes = None
        inclination = float(np.radians(degrees))
        found.append(
            SupportStep(name=name, t=float(t), inclination=inclination, modes=modes)
        )
    return found


def support_comparison(scene: Scene, modes: Modes, below: float) -> Decision:
    """Return the comparison of the lowest modes on the contact with those on two other
    supports.

    The other supports, the paper's patch and the free disk, are solved at accuracy
    "draft"."""
    draft = scene.replace("numerics.accuracy=draft")
    modes_by_support = {"contact": modes}
    for kind in ("patch", "free"):
        modes_by_support[kind] = eigenmodes(draft, below, Support(kind=kind))
    lowest = []
    for kind, found in modes_by_support.items():
        frequencies = ", ".join(f"{f:.0f}" for f in found.frequency[:6])
        lowest.append(f"{kind}: {frequencies or 'none'}")
    return Decision(
        subject="lowest modes by support [Hz]",
        choice="; ".join(lowest),
        reason=sentences.SUPPORT_COMPARISON_REASON,
    )
