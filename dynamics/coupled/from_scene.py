"""SCENE -> LAW of its elastic contact, and what is wrong with it.

A scene with such a contact has the sections `material`, `contact` and `roughness` besides those of `MotionScene`.
"""

from functools import lru_cache
from math import radians

import numpy as np

from .contact import LEAST_INCLINATION, ContactLaw
from .resonance import rate_needed
from .sections import require_seen
from .table import LawTable


def contact_law(scene) -> ContactLaw:
    """Return the law of the elastic contact of a scene. Raises ValueError where its fillet does not fit."""
    return scene.contact.law_of(scene.disk, scene.material)


def law_table(scene, kind: type[LawTable] = LawTable, moves: float = 0.0) -> LawTable:
    """Return that law by table, with what the edge of the disk yields where the scene has it bend, but for its modes
    below `moves` [Hz]; threads share it."""
    return _tabulated(kind, contact_law(scene), edge_of(scene), moves)


def edge_of(scene):
    """Return the `Edge` of the disk of a scene that has it bend, or None."""
    return getattr(scene, "edge", None) if scene.contact.body == "elastic" else None


@lru_cache(maxsize=16)
def _tabulated(kind, law, edge, moves):
    return kind(law=law, edge=edge, moves=moves)


def last_inclination(scene) -> float:
    """Return the inclination [rad] at which the motion of a disk on its elastic contact ends."""
    return max(scene.numerics.stopping_inclination(scene.disk), LEAST_INCLINATION)


def acts_back(scene) -> bool:
    """Return whether the table of a scene, which may say nothing on it, moves with the disk."""
    return getattr(getattr(scene, "surface", None), "action", "sound") == "motion"


def step_rate(scene) -> float:
    """Return the steps [1/s] of the full model: those of the accuracy, or more where the contact is stiffer."""
    return scene.numerics.contact_rate or max(scene.numerics.level.contact_rate, stiffest(scene))


def stiffest(scene) -> float:
    """Return the least steps [1/s] that the full model can take down to its last inclination, on a table that moves or
    is wavy to any: there the disk passes through all before it rests."""
    moves = acts_back(scene) or getattr(scene, "imperfection", None)
    least = LEAST_INCLINATION if moves else last_inclination(scene)
    return float(rate_needed(contact_law(scene), np.array([least]))[0])


def check(scene) -> None:
    """Raise ValueError, in one line, where the elastic contact of a scene cannot be solved."""
    law, beta = contact_law(scene), radians(scene.release.inclination_deg)
    if scene.roughness is not None:
        from .roughness import check as check_roughness  # Numba, which a smooth contact does not need

        require_seen(scene.roughness, float(law.semi_axes(beta, scene.disk.weight)[0]))
        check_roughness(scene.roughness, scene.disk.radius)
    if beta <= last_inclination(scene):
        raise ValueError(f"release.inclination_deg = {scene.release.inclination_deg:g}: ends before it begins")
    rate = scene.numerics.contact_rate
    if rate is not None and rate < (least := stiffest(scene)):
        raise ValueError(
            f"numerics.contact_rate = {rate:g}: too low for so stiff a contact, must be at least {least:.4g} 1/s"
        )
