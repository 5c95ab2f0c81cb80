"""Contact law, table coupling and step rate of a scene, and the validation of its contact.

The scene has the sections `material`, `contact` and `roughness` in addition to those of
`MotionScene`.
"""

from functools import lru_cache
from math import radians

import numpy as np

from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION, ContactLaw
from dynamics.compliant.law.linearised import required_step_rate
from dynamics.compliant.law.sections import require_resolved_waves
from dynamics.compliant.law.tabulated import LawTable
from dynamics.film.activation import final_inclination


def contact_law(scene) -> ContactLaw:
    """Return the elastic contact law of a scene. Raises ValueError if its fillet does not fit the
    disk.
    """
    return scene.contact.law_of(scene.disk, scene.material)


def law_table(scene, kind: type[LawTable] = LawTable, moves: float = 0.0) -> LawTable:
    """Return the tabulated contact law of a scene, with the flexibility of the edge if the disk is
    elastic.

    The modes below `moves` [Hz] are not part of this flexibility. The tables are cached and shared
    by threads.
    """
    return _tabulated(kind, contact_law(scene), edge_flexibility(scene), moves)


def edge_flexibility(scene):
    """Return the `Edge` of the disk of a scene if the disk is elastic, else None."""
    return scene.edge if scene.contact.body == "elastic" else None


@lru_cache(maxsize=16)
def _tabulated(kind, law, edge, moves):
    return kind(law=law, edge=edge, moves=moves)


def final_contact_inclination(scene) -> float:
    """Return the final inclination [rad] of a disk on its elastic contact."""
    return max(final_inclination(scene), MIN_CONTACT_INCLINATION)


def is_two_way(scene) -> bool:
    """Return True if the scene asks for a table that moves with the disk (default: False)."""
    return scene.surface.action == "motion"


def step_rate(scene) -> float:
    """Return the steps per second of the full model: that of the accuracy, or more for a stiff
    contact.
    """
    return scene.numerics.contact_rate or max(
        scene.numerics.level.contact_rate,
        min_step_rate(scene),
    )


def min_step_rate(scene) -> float:
    """Return the smallest step rate [1/s] of the full model down to its last inclination.

    On a table that moves or is wavy the disk passes through all inclinations before it rests.
    """
    moves = is_two_way(scene) or scene.imperfection
    least = MIN_CONTACT_INCLINATION if moves else final_contact_inclination(scene)
    return float(required_step_rate(contact_law(scene), np.array([least]))[0])


def check_rattling(scene) -> None:
    """Raise ValueError with one line if a scene cannot have contact anywhere on the rim."""
    many = scene.numerics.contact == "many"
    if scene.contact.restitution is not None and not many:
        raise ValueError(
            f"contact.restitution = {scene.contact.restitution:g}: needs numerics.contact = 'many'"
        )
    grain = scene.roughness is not None and scene.roughness.grain
    if grain and scene.numerics.contact not in ("many", "auto"):
        raise ValueError("roughness.grain = true: needs numerics.contact = 'many'")
    obstacle = rattling_obstacle(scene)
    if obstacle and (many or grain):
        raise ValueError(f"numerics.contact = 'many': {obstacle}")


def rattling_obstacle(scene) -> str:
    """Return why a scene cannot have contact anywhere on the rim; "" if it can."""
    if scene.contact.law == "rigid":
        return "needs contact.law = 'elastic'"
    if scene.surface.action == "motion":
        return "needs surface.action = 'sound'"
    others = [
        name
        for name, value in vars(scene.dissipation).items()
        if name not in ("contour_moment", "power_exponent", "air_density") and value
    ]
    if others:
        return f"dissipation.{others[0]} does not act on it; only contour_moment does"
    heights = scene.roughness
    greatest = scene.disk.thickness / 10
    if heights is not None and max(heights.rms or 0.0, heights.edge_rms) > greatest:
        return f"roughness.rms must be at most a tenth of disk.thickness, {greatest:g} m"
    return ""


def check_contact(scene) -> None:
    """Raise ValueError with one line if the elastic contact of a scene cannot be solved."""
    law = contact_law(scene)
    beta = radians(scene.release.inclination_deg)
    if scene.roughness is not None:
        from dynamics.compliant.law.roughness import (
            check_roughness,  # Numba, which a smooth contact does not need
        )

        require_resolved_waves(scene.roughness, float(law.semi_axes(beta, scene.disk.weight)[0]))
        check_roughness(scene.roughness, scene.disk.radius)
    if beta <= final_contact_inclination(scene):
        raise ValueError(
            f"release.inclination_deg = {scene.release.inclination_deg:g}: ends before it begins"
        )
    rate = scene.numerics.contact_rate
    if rate is not None and rate < (least := min_step_rate(scene)):
        raise ValueError(
            f"numerics.contact_rate = {rate:g}: too low for so stiff a contact, must be at least "
            f"{least:.4g} 1/s"
        )
