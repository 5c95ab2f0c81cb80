"""DISK -> MODES: `eigenmodes(scene)`, which chooses the method that suits the support."""

from math import pi

from . import axisymmetric, held
from .modes import Modes
from .spectral import Plate

BELOW = 24000.0
"""Modes at or above this frequency [Hz] are left out unless asked for."""


def density(disk) -> float:
    """Mass over volume of a solid disk [kg/m^3]; ValueError for a shell."""
    if disk.shape != "solid":
        raise ValueError(f"disk.shape = {disk.shape!r}: elastic modes are computed for a solid disk only")
    return disk.mass / (pi * disk.radius**2 * disk.thickness)


def check(disk, support):
    """ValueError if the patch does not fit on the disk."""
    if support.kind == "patch" and (support.height or 0) > disk.thickness:
        raise ValueError(f"support.height = {support.height:g} must not exceed disk.thickness = {disk.thickness:g}")


def eigenmodes(scene, below=BELOW) -> Modes:
    """The elastic `Modes` below the frequency `below` [Hz] of the disk of a scene.

    Reads scene.disk (radius, thickness [m], mass [kg], shape), scene.material, scene.support and, if there is one,
    scene.numerics.accuracy ("draft", "standard" or "reference"). Raises ValueError if the disk is a shell or the patch
    is taller than the disk.
    """
    check(scene.disk, scene.support)
    accuracy = getattr(getattr(scene, "numerics", None), "accuracy", "standard")
    disk, rho = scene.disk, density(scene.disk)
    if scene.support.kind == "free":
        plate = Plate(radius=disk.radius, thickness=disk.thickness, material=scene.material, density=rho)
        return axisymmetric.plate_modes(plate, below, accuracy)
    return held.held_modes(disk, scene.material, scene.support, rho, below, accuracy)
