"""FORCE -> MODES: what a contact force does to the disk as a rigid body, and to its elastic modes.

The frame of the patch, x towards the contact and z along the axis, is (-e3, -e1, e2) of (2.1).
"""

import numpy as np
from scipy.interpolate import CubicSpline

from dynamics import Disk
from modal import Modes
from sonify.scene import Scene


def in_patch_frame(force, inclination) -> np.ndarray:
    """Return forces (k, 3) along a_1, a_2, a_3 at inclinations (k,) [rad] as (k, 3) along x, y, z of the patch;
    (2.1)."""
    along, across, normal = np.asarray(force).T
    s, c = np.sin(inclination), np.cos(inclination)
    return np.stack([c * across - s * normal, -along, s * across + c * normal], axis=1)


def rigid_acceleration(push, disk: Disk) -> np.ndarray:
    """Return the acceleration (k, 6) that contact forces (k, 3) [N] cause: of the centre [m/s^2], angular [rad/s^2].

    Both in the frame of the patch; inertia by (2.4), force at (R, 0, -L/2). The resisting moments (3.3) are left out:
    they are below 1 % of the moment of the force, and where they change their sign it rings 40 dB below a slip of the
    published disk. So are the centrifugal and gyroscopic loads, which are slow and soon gone.
    """
    turn = np.cross([disk.radius, 0.0, -disk.thickness / 2], push)
    return np.hstack([push, turn]) / inertia(disk)


def inertia(disk: Disk) -> np.ndarray:
    """Return (6,): three times the mass [kg], and the moments of inertia [kg m^2] about x, y, z of the patch; (2.4)."""
    about_diameter = disk.mass * (disk.radius**2 * disk.gyration / 4 + disk.thickness**2 / 12)
    about_axis = disk.mass * disk.radius**2 * disk.gyration / 2
    return np.array([disk.mass] * 3 + [about_diameter, about_diameter, about_axis])


def rigid_sources(force, attitude, disk: Disk, *ears: float) -> np.ndarray:
    """Return (k, 1 + e) [m/s^2]: the heave of the disk, and the acceleration by tilting of its rim towards the azimuth
    [rad] of each of the `ears` (e,).

    At rest the force is the weight and the heave is 0. `force` (k, 3) [N], `attitude` (k, 3) [rad].
    """
    turn = in_patch_frame(force, attitude[:, 1]) @ rigid_acceleration(np.eye(3), disk)[:, 3:]
    azimuth = listener_azimuth(attitude, turning_with_body=False)
    tilts = [turn[:, 0] * np.sin(azimuth + ear) - turn[:, 1] * np.cos(azimuth + ear) for ear in ears]
    return np.stack([(force[:, 2] - disk.weight) / disk.mass, *(disk.radius * tilt for tilt in tilts)], axis=1)


def listener_azimuth(attitude, turning_with_body: bool) -> np.ndarray:
    """Return the azimuth (k,) [rad] of the table's x axis in the frame of the patch, or in that of the free body.

    The patch lies a quarter turn ahead of the precession, along a_2; the free body turns by the spin more.
    """
    return -(attitude[:, 0] + np.pi / 2 + (attitude[:, 2] if turning_with_body else 0.0))


def modal_drive(modes: Modes, scene: Scene):
    """Return drive(force (k, 3) [N], attitude (k, 3) [rad]) -> the right-hand sides (k, m) of q'' + 2 d q' + w^2 q = g.

    A disk held by its `patch` moves with the contact, g = -participation . rigid acceleration, and the force does no
    work on the modes itself; on a `free` one the force acts where the contact is at the moment, g = shape . force.
    A disk on its `contact` is driven like a held one, by what keeps the contact point at rest; but see `_on_springs`.
    """
    if scene.support.kind != "free":
        per_newton = drive_per_newton(modes, scene)
        return lambda force, attitude: np.einsum("kc,cm->km", in_patch_frame(force, attitude[:, 1]), per_newton)
    shape = _rim(modes)
    return lambda force, attitude: np.einsum(
        "kmc,kc->km", shape(-attitude[:, 2]), in_patch_frame(force, attitude[:, 1]), optimize=True
    )


def drive_per_newton(modes: Modes, scene: Scene) -> np.ndarray:
    """Return (3, m): what 1 N along x, y, z of the patch drives; on a free disk its root mean square round the rim."""
    if scene.support.kind == "free":
        return np.sqrt(np.mean(modes.rim_shape**2, axis=1)).T
    by_the_base = -rigid_acceleration(np.eye(3), scene.disk) @ modes.participation.T
    if scene.support.kind == "contact" and scene.contact.law == "elastic":
        return _on_springs(modes, scene.disk, by_the_base)
    return by_the_base


def _on_springs(modes, disk, by_the_base):
    """(3, m): what drives the modes where a stem of its own has the vibration of the rigid disk on its contact.

    The force then is that of the springs, and does work on the elastic part of a shape, all of it less the rigid part.
    The modes that are mostly rigid are that stem, and not driven.
    """
    rigid = np.square(modes.participation) @ (1 / inertia(disk))
    return (by_the_base + modes.rim_shape[:, 0].T) * (rigid < 0.5)


def _rim(modes):
    """The displacement (k, m, 3) of the bottom edge at angles (k,), periodic cubic splines through `rim_shape`."""
    angle = np.append(modes.rim_angle, modes.rim_angle[0] + 2 * np.pi)
    closed = np.concatenate([modes.rim_shape, modes.rim_shape[:, :1]], axis=1)
    return CubicSpline(angle, closed.swapaxes(0, 1), bc_type="periodic")
