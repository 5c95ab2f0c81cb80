"""Dimensionless constants of the disk, friction and table of a scene."""

from math import isfinite

from dynamics.equations import DiskConstants, disk_constants


def scene_constants(scene) -> DiskConstants:
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


def _pivoting_polynomials(contact, disk, material, mu_dynamic) -> tuple[float, ...]:
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
