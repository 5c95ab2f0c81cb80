"""Dimensionless constants of the disk, friction and table of a scene."""

from math import isfinite
from typing import TYPE_CHECKING

from dynamics.equations import DiskConstants, disk_constants

if TYPE_CHECKING:
    from dynamics.compliant.law.sections import Contact
    from dynamics.disk import Disk
    from dynamics.sections import MotionScene
    from modal.modes import Material


def scene_constants(scene: "MotionScene") -> DiskConstants:
    """Return the dimensionless constants of a scene.

    Raises ValueError if the fillet does not fit the disk, or if the scene does not
    determine its spin friction.
    """
    disk = scene.disk
    friction = scene.friction
    pivoting: tuple[float, ...] = ()
    if friction.arm_pivoting == "contact":
        pivoting = _pivoting_polynomials(
            scene.contact, disk, scene.material, friction.mu_dynamic
        )
    x, y = scene.surface.place
    return disk_constants(disk, friction, pivoting)._replace(
        fillet=scene.contact.rolling_fillet(disk) / disk.radius,
        bowl=scene.surface.curvature * disk.radius,
        bowl_x=x / disk.radius,
        bowl_y=y / disk.radius,
    )


def _pivoting_polynomials(
    contact: "Contact", disk: "Disk", material: "Material", mu_dynamic: float
) -> tuple[float, ...]:
    if material is None:
        raise ValueError(
            "friction.arm_pivoting = 'contact': requires the section material"
        )
    if not contact.rolling_fillet(disk):
        needed = "contact.law = 'elastic' or contact.fillet"
        raise ValueError(f"friction.arm_pivoting = 'contact': requires {needed}")
    if not isfinite(mu_dynamic):
        raise ValueError(
            "friction.arm_pivoting = 'contact': requires a finite friction.mu_dynamic"
        )
    return contact.pivoting_polynomials(disk, material)
