"""Contact law and step rate of a scene."""

from typing import TYPE_CHECKING, Any

import numpy as np

from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION, ContactLaw
from dynamics.compliant.law.linearised import required_step_rate
from dynamics.compliant.law.tabulated import TabulatedLaw

if TYPE_CHECKING:
    from dynamics.sections import MotionScene


def contact_law(scene: "MotionScene") -> ContactLaw:
    """Return the elastic contact law of a scene.

    Raises ValueError if its fillet does not fit the disk.
    """
    return scene.contact.contact_law(scene.disk, scene.material)


def tabulated_contact_law(
    scene: "MotionScene",
    kind: type[TabulatedLaw] = TabulatedLaw,
    max_moving_frequency: float = 0.0,
) -> TabulatedLaw:
    """Return the tabulated contact law of a scene.

    If the disk is elastic, it includes the flexibility of the edge without the modes
    below `max_moving_frequency` [Hz].
    """
    return kind(
        law=contact_law(scene),
        edge=scene_edge_flexibility(scene),
        max_moving_frequency=max_moving_frequency,
    )


def scene_edge_flexibility(scene: "MotionScene") -> Any:
    """Return the `modal.Edge` of the disk if its body is elastic, else None."""
    return scene.elastic_edge if scene.contact.body == "elastic" else None


def final_contact_inclination(final_inclination: float) -> float:
    """Return the final inclination [rad] of a disk on its elastic contact."""
    return max(final_inclination, MIN_CONTACT_INCLINATION)


def step_rate(scene: "MotionScene", final_inclination: float) -> float:
    """Return the steps per second of the full model.

    The rate is that of the accuracy level, or a higher one for a stiff contact.
    """
    return scene.numerics.contact_rate or max(
        scene.numerics.level.contact_rate,
        min_step_rate(scene, final_inclination),
    )


def min_step_rate(scene: "MotionScene", final_inclination: float) -> float:
    """Return the smallest admissible step rate [1/s] of the full model.

    It is determined by the last inclination. On a coupled or wavy table, the disk
    passes through all inclinations before it comes to rest.
    """
    in_steps = scene.numerics.contact != "filter"
    moves = (scene.surface.action == "motion" and in_steps) or scene.imperfection
    min_inclination = (
        MIN_CONTACT_INCLINATION
        if moves
        else final_contact_inclination(final_inclination)
    )
    return float(required_step_rate(contact_law(scene), np.array([min_inclination]))[0])


def reason_against_rattling(scene: "MotionScene") -> str:
    """Return the reason why the disk of a scene cannot be solved as rattling, or ""."""
    if scene.contact.law == "rigid":
        return "requires contact.law = 'elastic'"
    if scene.surface.hole:
        return "surface.hole is not supported; its film is that of a rolling disk"
    ring_in_air = scene.disk.inner_radius > 0 and scene.air.pressure > 0
    if ring_in_air and scene.air.film != "none" and scene.numerics.contact != "many":
        return "the film of a ring is that of a rolling disk; it requires air.film = 'none'"
    others = [
        name
        for name, value in vars(scene.dissipation).items()
        if name not in ("contour_moment", "power_exponent", "air_density") and value
    ]
    if others:
        return f"dissipation.{others[0]} is not supported; only contour_moment is"
    heights = scene.roughness
    greatest = scene.disk.thickness / 10
    if heights is not None and max(heights.rms or 0.0, heights.edge_rms) > greatest:
        return (
            f"roughness.rms must be at most a tenth of disk.thickness, {greatest:g} m"
        )
    return ""
