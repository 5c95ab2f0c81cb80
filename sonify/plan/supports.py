"""SUPPORTS: what each way of holding a disk predicts, and how the modes of a disk on its contact
move over the run."""

from dataclasses import dataclass, replace

import numpy as np

from dynamics import Motion
from modal import Modes, Support, UnsolvableError, eigenmodes
from sonify.plan.plan import Decision
from sonify.scene import Scene

LOWEST_DEG = 1e-5
"""Below this inclination [degrees] one ellipse no longer is the contact."""
NAMED = 6
"""Frequencies that are named of each support."""


@dataclass(frozen=True, kw_only=True)
class Standing:
    """The modes of a disk on its contact at one instant [s] and inclination [rad]; None where that
    is too stiff for springs."""

    name: str
    t: float
    inclination: float
    modes: Modes | None


def over_the_run(scene: Scene, motion: Motion, below: float) -> list[Standing]:
    """Return the modes below `below` [Hz] at the release, in the middle and at the end; none of
    another support."""
    if scene.support.kind != "contact":
        return []
    found = []
    for name, t in zip(("release", "middle", "end"), np.linspace(0, motion.t[-1], 3), strict=True):
        degrees = max(float(np.degrees(motion.at([t])[0, 1])), LOWEST_DEG)
        try:
            modes = eigenmodes(scene, below, replace(scene.support, inclination_deg=degrees))
        except UnsolvableError:
            modes = None
        found.append(
            Standing(name=name, t=float(t), inclination=float(np.radians(degrees)), modes=modes)
        )
    return found


def compared(scene: Scene, modes: Modes, below: float) -> Decision:
    """Return what the paper's patch and the free disk predict beside the modes on the contact, by a
    draft of them."""
    draft = scene.replace("numerics.accuracy=draft")
    others = {kind: eigenmodes(draft, below, Support(kind=kind)) for kind in ("patch", "free")}
    lowest = {
        kind: ", ".join(f"{f:.0f}" for f in found.frequency[:NAMED]) or "none"
        for kind, found in ({"contact": modes} | others).items()
    }
    return Decision(
        subject="lowest modes by support [Hz]",
        choice="; ".join(f"{kind}: {frequencies}" for kind, frequencies in lowest.items()),
        reason="on its contact a disk swings as a whole, as on the paper's patch, but on springs "
        "that stiffen as it "
        "falls; its other modes hardly differ from those of the free disk",
    )
