"""DISK -> MODES: `eigenmodes(scene)`, which chooses the method that suits the support."""

from math import pi, radians
from typing import Any, Protocol

from modal import held, on_contact
from modal.elements.elastic import mode_count
from modal.mesh.sector import patch_edge
from modal.mesh.symmetry import check_held
from modal.modes import Material, Modes, Support, UnsolvableError
from modal.one_thread import one_blas_thread
from modal.spectral import axisymmetric
from modal.spectral.basis import Plate

BELOW = 24000.0
"""Modes at or above this frequency [Hz] are left out unless asked for."""


LONGEST = 50
"""Thickness over radius beyond which a disk is a rod, for which these meshes and bases are not made."""
MOST = 600
"""Modes beyond which none are sought: they would take minutes to solve and hours to hear out."""


def density(disk: Any) -> float:
    """Mass over volume of a disk [kg/m^3]; ValueError for a shell whose wall is not given."""
    return disk.mass / (pi * (disk.radius**2 - inner_radius(disk) ** 2) * disk.thickness)


def inner_radius(disk: Any) -> float:
    """Radius of the hole [m], 0 for a solid disk; ValueError for a shell whose wall is not given."""
    if disk.shape == "solid":
        return 0.0
    if not getattr(disk, "wall", None):
        raise ValueError(
            f"disk.shape = {disk.shape!r}: elastic modes need disk.wall, the thickness of its wall in the radius, "
            "or disk.shape = 'solid'"
        )
    return disk.radius - disk.wall


def check(disk: Any, support: Support):
    """ValueError if the disk has no volume or is a rod, if the patch does not fit on it or leaves a rigid body free to
    move, or if it is a shell that is not to be free."""
    inner_radius(disk)
    if disk.thickness > LONGEST * disk.radius:
        raise ValueError(f"disk.thickness = {disk.thickness:g} must not exceed {LONGEST} times disk.radius")
    if support.kind != "free" and disk.shape != "solid":
        raise ValueError(f"support.kind = {support.kind!r}: a disk of disk.shape = {disk.shape!r} must be 'free'")
    if support.kind == "patch" and (support.height or 0) > disk.thickness:
        raise ValueError(f"support.height = {support.height:g} must not exceed disk.thickness = {disk.thickness:g}")
    if support.kind == "patch":
        check_held(patch_edge(disk.radius, disk.thickness, support), support.held)


class ElasticScene(Protocol):
    """What `eigenmodes` reads of a scene, besides its numerics.accuracy ("draft", "standard" or "reference") where it
    has one, and of a disk on its contact the sections `contact` and `release`. The disk has radius, thickness [m], mass
    [kg], shape and, of a shell, the wall [m]."""

    @property
    def disk(self) -> Any: ...
    @property
    def material(self) -> Material: ...
    @property
    def support(self) -> Support: ...


@one_blas_thread
def eigenmodes(scene: ElasticScene, below: float = BELOW, support: Support | None = None) -> Modes:
    """The elastic `Modes` below the frequency `below` [Hz] of the disk of a scene, on another `support` where one is
    given: with Support(kind="free") those of the free disk, which a contact that moves along its rim drives.

    Raises ValueError if the patch is taller than the disk or leaves a rigid body free to move, if a shell has no wall
    or is held, or if `below` is not positive; UnsolvableError if there are more than about MOST modes, if the patch is
    lost in round-off, or if the disk has no elastic contact to stand on.
    """
    support = support or scene.support
    if not below > 0:
        raise ValueError(f"below = {below:g} must be a frequency above 0 Hz")
    check(scene.disk, support)
    plate, sought = free_plate(scene), below * (on_contact.APART if support.kind == "contact" else 1.0)
    count = mode_count(plate, sought)
    if count > MOST:
        raise UnsolvableError(
            f"disk, material: so soft or so large a disk has some {count:.0f} modes or more below {sought:g} Hz; "
            f"no more than {MOST} can be sought: take a stiffer or smaller disk, or lower audio.sample_rate"
        )
    accuracy = getattr(getattr(scene, "numerics", None), "accuracy", "standard")
    if support.kind == "free":
        return axisymmetric.plate_modes(plate, below, accuracy)
    if support.kind == "contact":
        inclination, suspension = standing(scene, support)
        return on_contact.contact_modes(plate, suspension, inclination, below, accuracy)
    return held.held_modes(plate, support, below, accuracy)


def free_plate(scene: ElasticScene) -> Plate:
    """The disk of a scene, its edge free."""
    disk = scene.disk
    size = {"radius": disk.radius, "thickness": disk.thickness, "inner_radius": inner_radius(disk)}
    return Plate(**size, material=scene.material, density=density(disk))


def standing(scene: Any, support: Support) -> tuple[float, Any]:
    """The inclination [rad] at which a disk stands on its contact, and the springs there. UnsolvableError if none."""
    inclination = radians(support.inclination_deg or scene.release.inclination_deg)
    try:
        return inclination, scene.contact.suspension(scene, inclination)
    except ValueError as error:
        raise UnsolvableError(f"support.kind = 'contact': {error}") from None
