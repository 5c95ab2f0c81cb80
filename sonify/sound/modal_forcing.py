"""FORCE -> MODES: accelerations of the rigid disk by the contact force, and the forcing of its
elastic modes.

The frame of the patch has x towards the contact and z along the axis: (-e3, -e1, e2) of (2.1).
"""

import numpy as np
from scipy.interpolate import CubicSpline

from dynamics import Disk
from modal import Modes
from sonify.scene import Scene


def in_patch_frame(force, inclination) -> np.ndarray:
    """Rotate forces (k, 3) along a_1, a_2, a_3 into the frame of the patch, at inclinations (k,)
    [rad]; (2.1)."""
    along, across, normal = np.asarray(force).T
    s = np.sin(inclination)
    c = np.cos(inclination)
    return np.stack([c * across - s * normal, -along, s * across + c * normal], axis=1)


def rigid_acceleration(contact_force, disk: Disk) -> np.ndarray:
    """Return the acceleration (k, 6) of the rigid disk by contact forces (k, 3) [N].

    Columns: acceleration of the centre [m/s^2] and angular acceleration [rad/s^2], both in the
    frame of the patch; inertia by (2.4), force at (R, 0, -L/2). Two effects are neglected. The
    resisting moments (3.3) are below 1 % of the moment of the force, and 40 dB below a slip of the
    published disk where they change sign. The centrifugal and gyroscopic loads vary slowly and
    decay soon."""
    moment = np.cross([disk.radius, 0.0, -disk.thickness / 2], contact_force)
    return np.hstack([contact_force, moment]) / inertia(disk)


def inertia(disk: Disk) -> np.ndarray:
    """Return the mass [kg] three times, and the moments of inertia [kg m^2] about x, y, z of the
    patch, (6,); (2.4)."""
    about_diameter = disk.mass * (disk.radius**2 * disk.gyration / 4 + disk.thickness**2 / 12)
    about_axis = disk.mass * disk.radius**2 * disk.gyration / 2
    return np.array([disk.mass] * 3 + [about_diameter, about_diameter, about_axis])


def rigid_sources(force, attitude, disk: Disk, *ears: float) -> np.ndarray:
    """Return the accelerations (k, 1 + e) [m/s^2] of the rigid disk that radiate.

    The first column is the heave: 0 at rest, where the force is the weight. The others are the
    accelerations by tilting of the rim towards each of the `ears`, azimuths [rad]. `force` (k, 3)
    [N], `attitude` (k, 3) [rad]."""
    turn = in_patch_frame(force, attitude[:, 1]) @ rigid_acceleration(np.eye(3), disk)[:, 3:]
    azimuth = listener_azimuth(attitude, turning_with_body=False)
    tilts = [
        turn[:, 0] * np.sin(azimuth + ear) - turn[:, 1] * np.cos(azimuth + ear) for ear in ears
    ]
    heave = (force[:, 2] - disk.weight) / disk.mass
    return np.stack([heave, *(disk.radius * tilt for tilt in tilts)], axis=1)


def listener_azimuth(attitude, turning_with_body: bool) -> np.ndarray:
    """Return the azimuth (k,) [rad] of the table's x axis in the frame of the patch or the body.

    The patch is a quarter turn ahead of the precession, along a_2; the free body also turns by the
    spin."""
    return -(attitude[:, 0] + np.pi / 2 + (attitude[:, 2] if turning_with_body else 0.0))


def modal_drive(modes: Modes, scene: Scene):
    """Return forcing(force (k, 3) [N], attitude (k, 3) [rad]) -> g (k, m) in q'' + 2 d q' + w^2 q =
    g.

    A disk held by its `patch` moves with the contact: g = -participation . rigid acceleration, and
    the force does no work on the modes itself. On a `free` disk the force acts at the present
    contact point: g = shape . force. A disk on its `contact` is driven like a held one, by the
    motion of the contact point; for an elastic contact see `_forcing_on_springs`."""
    if scene.support.kind != "free":
        per_newton = forcing_per_newton(modes, scene)
        return lambda force, attitude: np.einsum(
            "kc,cm->km", in_patch_frame(force, attitude[:, 1]), per_newton
        )
    shape = _rim_spline(modes)
    return lambda force, attitude: np.einsum(
        "kmc,kc->km", shape(-attitude[:, 2]), in_patch_frame(force, attitude[:, 1]), optimize=True
    )


def forcing_per_newton(modes: Modes, scene: Scene) -> np.ndarray:
    """Return the modal forcing (3, m) by 1 N along x, y, z of the patch; for a free disk the rms
    round the rim."""
    if scene.support.kind == "free":
        return np.sqrt(np.mean(modes.rim_shape**2, axis=1)).T
    by_support = -rigid_acceleration(np.eye(3), scene.disk) @ modes.participation.T
    if scene.support.kind == "contact" and scene.contact.law == "elastic":
        return _forcing_on_springs(modes, scene.disk, by_support)
    return by_support


def _forcing_on_springs(modes, disk, by_support):
    """Return the forcing (3, m) if a separate stem contains the vibration of the rigid disk on its
    contact.

    The force is then that of the springs, and does work on the elastic part of a shape: the shape
    minus its rigid part. Modes that are mostly rigid belong to the other stem and are not
    driven."""
    rigid_share = np.square(modes.participation) @ (1 / inertia(disk))
    return (by_support + modes.rim_shape[:, 0].T) * (rigid_share < 0.5)


def _rim_spline(modes):
    """Return a periodic cubic spline of the bottom edge's displacement (k, m, 3) at angles (k,)."""
    angle = np.append(modes.rim_angle, modes.rim_angle[0] + 2 * np.pi)
    closed = np.concatenate([modes.rim_shape, modes.rim_shape[:, :1]], axis=1)
    return CubicSpline(angle, closed.swapaxes(0, 1), bc_type="periodic")
