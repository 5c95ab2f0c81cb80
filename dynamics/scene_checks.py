"""Validation of the contact of a scene."""

from math import radians

from dynamics.compliant.law.sections import require_resolved_waves
from dynamics.compliant.model_inputs import (
    contact_law,
    final_contact_inclination,
    min_step_rate,
    reason_against_rattling,
)
from dynamics.motion_plan import motion_basis
from dynamics.sections import MotionScene


def check_rattling(scene: MotionScene) -> None:
    """Raise ValueError if a scene requests a rattling disk that cannot be solved."""
    many = scene.numerics.contact == "many"
    if scene.contact.restitution is not None and not many:
        raise ValueError(
            f"contact.restitution = {scene.contact.restitution:g}: requires numerics.contact = 'many'"
        )
    grain = scene.roughness is not None and scene.roughness.grain
    if grain and scene.numerics.contact not in ("many", "auto"):
        raise ValueError("roughness.grain = true: requires numerics.contact = 'many'")
    obstacle = reason_against_rattling(scene)
    if obstacle and (many or grain):
        raise ValueError(f"numerics.contact = 'many': {obstacle}")


def check_contact(scene: MotionScene) -> None:
    """Raise ValueError if the elastic contact of a scene cannot be solved."""
    law = contact_law(scene)
    beta = radians(scene.release.inclination_deg)
    if scene.roughness is not None:
        from dynamics.compliant.law.roughness import check_roughness  # loads Numba

        require_resolved_waves(
            scene.roughness, float(law.semi_axes(beta, scene.disk.weight)[0])
        )
        check_roughness(scene.roughness, scene.disk.radius)
    final = motion_basis(scene).final_inclination
    if beta <= final_contact_inclination(final):
        raise ValueError(
            f"release.inclination_deg = {scene.release.inclination_deg:g}: must exceed the final inclination"
        )
    rate = scene.numerics.contact_rate
    if rate is not None and rate < (required_rate := min_step_rate(scene, final)):
        raise ValueError(
            f"numerics.contact_rate = {rate:g}: too low for the stiffness of the contact, must be at least "
            f"{required_rate:.4g} 1/s"
        )
