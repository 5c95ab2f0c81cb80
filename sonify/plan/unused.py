"""Keys that a scene sets although no stage of its run reads them."""

from collections.abc import Callable, Iterator
from dataclasses import MISSING, fields, is_dataclass
from math import inf
from typing import Any

from dynamics import MotionPlan
from dynamics.film.wedge import hole_share
from sonify.scene import SIZE_KEYS, Scene


def has_elastic_contact(plan: MotionPlan) -> bool:
    """Return True if the contact is elastic from the release onwards or may become
    so."""
    return plan.contact.kind != "rigid" or plan.may_be_two_way


def is_solved_in_full(plan: MotionPlan) -> bool:
    """Return True if time-stepping with a compliant contact starts at the release."""
    return plan.contact.kind in ("full", "many")


def has_no_spectrum(scene: Scene) -> bool:
    """Return True if no surface heights are generated from a power spectrum.

    In this case the table has a measured profile, and the edge is measured or smooth.
    """
    heights = scene.roughness
    return (
        heights is not None and heights.profile is not None and heights.edge_rms == 0.0
    )


def has_no_film(scene: Scene) -> bool:
    """Return True if no air film can exist, as in a vacuum or without a flat face."""
    return scene.air.pressure == 0.0 or hole_share(scene) >= 1


def is_rattling(plan: MotionPlan) -> bool:
    """Return True if the contact model allows contacts anywhere on the rim."""
    return plan.contact.kind == "many"


def has_all_material_values(scene: Scene) -> bool:
    """Return True if the scene specifies every value that `material.name` would
    provide."""
    material = scene.document["material"]
    size = SIZE_KEYS & set(scene.document["disk"])
    return len(size) == 2 and {"young", "poisson", "loss_factor"} <= set(material)


PATCH_KEYS = "support.half_angle_deg support.height support.position support.held"
SPECTRUM_KEYS = "roughness.shortest roughness.longest roughness.exponent roughness.seed"
ROUGHNESS_KEYS = (
    f"roughness.rms roughness.rms_edge {SPECTRUM_KEYS} roughness.loss "
    "roughness.profile roughness.profile_edge"
)


UNUSED_KEY_RULES: tuple[tuple[str, Callable[[Scene, MotionPlan], bool]], ...] = (
    (
        "friction.mu_dynamic",
        lambda scene, plan: scene.friction.mu_static == inf and not is_rattling(plan),
    ),
    (
        "friction.mu_static roughness.loss",
        lambda scene, plan: is_rattling(plan),
    ),
    ("material.name", lambda scene, plan: has_all_material_values(scene)),
    ("support.inclination_deg", lambda scene, plan: scene.support.kind != "contact"),
    (PATCH_KEYS, lambda scene, plan: scene.support.kind != "patch"),
    (
        "support.position",
        lambda scene, plan: scene.support.height in (None, scene.disk.thickness),
    ),
    (
        "surface.action",
        lambda scene, plan: (
            scene.surface.kind == "infinite" and not plan.rolls_on_roughness
        ),
    ),
    (
        "dissipation.power_exponent",
        lambda scene, plan: scene.dissipation.power_coefficient == 0.0,
    ),
    (
        "dissipation.air_density",
        lambda scene, plan: scene.dissipation.boundary_layer_viscosity == 0.0,
    ),
    (
        "contact.loss_factor",
        lambda scene, plan: (
            not has_elastic_contact(plan) and scene.support.kind != "contact"
        ),
    ),
    (
        "contact.young contact.poisson",
        lambda scene, plan: (
            not has_elastic_contact(plan)
            and scene.support.kind != "contact"
            and scene.friction.arm_pivoting != "contact"
        ),
    ),
    (
        "surface.hole",
        lambda scene, plan: (
            plan.film_decision.film is None
            or scene.surface.hole <= 2 * scene.disk.inner_radius
        ),
    ),
    ("surface.diameter", lambda scene, plan: not scene.surface.sag),
    (
        "surface.place",
        lambda scene, plan: scene.surface.kind == "rigid" and not scene.surface.sag,
    ),
    (
        "contact.body",
        lambda scene, plan: (
            not has_elastic_contact(plan) or scene.disk.shape != "solid"
        ),
    ),
    (
        ROUGHNESS_KEYS,
        lambda scene, plan: plan.contact.kind == "rigid",
    ),
    (SPECTRUM_KEYS, lambda scene, plan: has_no_spectrum(scene)),
    ("roughness.loss", lambda scene, plan: scene.numerics.contact == "filter"),
    ("air.film air.viscosity", lambda scene, plan: has_no_film(scene)),
    (
        "audio.distance audio.elevation_deg",
        lambda scene, plan: bool(scene.audio.listeners),
    ),
    (
        "numerics.integrator numerics.tolerance",
        lambda scene, plan: is_solved_in_full(plan),
    ),
    (
        "numerics.final_inclination",
        lambda scene, plan: (
            (scene.surface.action == "motion" and not plan.filter_is_two_way)
            or scene.imperfection is not None
        ),
    ),
    ("numerics.contact", lambda scene, plan: plan.contact.kind == "rigid"),
    (
        "numerics.contact_rate",
        lambda scene, plan: not plan.may_be_two_way and not is_solved_in_full(plan),
    ),
)
"""Keys, and the condition under which no stage reads them; tests/plan/test_unused_keys.py checks
them."""


def unused_keys(scene: Scene, plan: MotionPlan) -> tuple[str, ...]:
    """Return the keys with non-default values that have no effect on the run of a
    scene.

    Parameters
    ----------
    scene : Scene
        Scene whose document sets the keys.
    plan : MotionPlan
        The decisions of its motion.

    Returns
    -------
    tuple of str
        Full names such as "roughness.rms", in the order of the document.
    """
    return tuple(
        key
        for key in keys_set_by_scene(scene)
        if any(
            key in keys.split() and is_unread(scene, plan)
            for keys, is_unread in UNUSED_KEY_RULES
        )
    )


def unused_keys_notice(scene: Scene, plan: MotionPlan) -> str:
    """Return the sentence that names the unused keys of a scene, or "" if there are
    none."""
    unused = ", ".join(unused_keys(scene, plan))
    return f"unused: {unused} (no effect on this run)" if unused else ""


def keys_set_by_scene(scene: Scene) -> Iterator[str]:
    """Yield the keys that a scene sets to non-default values."""
    sections = vars(scene)
    for name, given in scene.document.items():
        if is_dataclass(sections[name]):
            values = vars(sections[name])
            defaults = {
                field.name: default_of(field) for field in fields(sections[name])
            }
            yield from (
                f"{name}.{key}" for key in given if values[key] != defaults[key]
            )


def default_of(field: Any) -> Any:
    """Return the default of a field of a section; MISSING if the key is required."""
    return (
        field.default if field.default_factory is MISSING else field.default_factory()
    )
