"""Compute rigid-body accelerations and modal forcing of the disk due to the contact
force.

The axes of the patch frame are (-e3, -e1, e2) of (2.1): x points to the contact, and z
is the axis of the disk.
"""

from collections.abc import Callable

import numpy as np
from scipy.interpolate import CubicSpline

from dynamics import Disk
from dynamics.kinematics import turned_over
from dynamics.landing.equations import OTHER_FACE_COSINE
from dynamics.motion import FILM_COLUMNS
from modal import Modes
from sonify.scene import Scene


def in_patch_frame(force: np.ndarray, inclination: np.ndarray) -> np.ndarray:
    """Rotate forces (k, 3) along a_1, a_2, a_3 into the patch frame (2.1) at
    inclinations (k,) [rad]."""
    along, across, normal = np.asarray(force).T
    s = np.sin(inclination)
    c = np.cos(inclination)
    return np.stack([c * across - s * normal, -along, s * across + c * normal], axis=1)


def from_lower_face(
    force: np.ndarray, state: np.ndarray, film: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return force (k, 3), states (k, 11) and film loads (k, 5) relative to the lower face.

    A disk that has turned over has an inclination above pi/2 and touches the table with its
    other rim. Turned about the direction to its contact, the same body is inclined by less
    than pi/2, and its lower rim is the one of which the modes are known."""
    is_turned_over = np.cos(state[:, 1]) < OTHER_FACE_COSINE
    if not is_turned_over.any():
        return force, state, film
    force, state, film = force.copy(), state.copy(), film.copy()
    force[is_turned_over, :2] *= -1
    state[is_turned_over] = turned_over(state[is_turned_over])
    film[is_turned_over, FILM_COLUMNS.index("moment_1")] *= -1
    return force, state, film


def rigid_acceleration(contact_force: np.ndarray, disk: Disk) -> np.ndarray:
    """Return the acceleration (k, 6) of the rigid disk due to contact forces (k, 3)
    [N].

    The columns are the acceleration of the centre [m/s^2] and the angular acceleration
    [rad/s^2] in the patch frame, with the inertia (2.4) and the force at (R, 0, -L/2).
    Two effects are neglected. The resisting moments (3.3) are below 1 % of the moment
    of the force, and the sound of their sign changes is 40 dB below that of a slip of
    the paper's disk. The centrifugal and gyroscopic loads vary slowly and soon become
    small."""
    moment = np.cross([disk.radius, 0.0, -disk.thickness / 2], contact_force)
    return np.hstack([contact_force, moment]) / inertia(disk)


def inertia(disk: Disk) -> np.ndarray:
    """Return the diagonal (6,) of the mass matrix (2.4) in the patch frame.

    It contains the mass [kg] for each translation and the moments of inertia [kg m^2]
    about x, y, z."""
    about_diameter = disk.mass * (
        disk.radius**2 * disk.gyration / 4 + disk.thickness**2 / 12
    )
    about_axis = disk.mass * disk.radius**2 * disk.gyration / 2
    return np.array([disk.mass] * 3 + [about_diameter, about_diameter, about_axis])


def turning_acceleration(
    force: np.ndarray, inclination: np.ndarray, film: np.ndarray, disk: Disk
) -> np.ndarray:
    """Return the angular acceleration (k, 3) [rad/s^2] of the rigid disk in the patch
    frame.

    It is due to contact forces (k, 3) [N] on the lower rim and to the moments in the columns
    (k, 5) of `Motion.film_loads`, at inclinations (k,) [rad] of up to pi/2."""
    local = in_patch_frame(force, inclination)
    turn = local @ rigid_acceleration(np.eye(3), disk)[:, 3:]
    _, _, moment_1, moment_3, _ = film.T
    turn[:, :2] -= np.column_stack([moment_3, moment_1]) / inertia(disk)[3:5]
    return turn


def heave_and_tilt_accelerations(
    force: np.ndarray, attitude: np.ndarray, film: np.ndarray, disk: Disk, *ears: float
) -> np.ndarray:
    """Return the sound-radiating accelerations (k, 1 + e) [m/s^2] of the rigid disk.

    The first column is the heave, which is 0 when the force equals the weight. The
    others are the accelerations of the rim at the azimuths `ears` [rad] due to tilting.
    The shapes are `force` (k, 3) [N] and `attitude` (k, 3) [rad]; `film` (k, 5) contains
    the columns of `Motion.film_loads`."""
    turn = turning_acceleration(force, attitude[:, 1], film, disk)
    azimuth = listener_azimuth(attitude)
    tilts = [
        turn[:, 0] * np.sin(azimuth + ear) - turn[:, 1] * np.cos(azimuth + ear)
        for ear in ears
    ]
    heave = (force[:, 2] + film[:, 1] - disk.weight) / disk.mass
    return np.stack([heave, *(disk.radius * tilt for tilt in tilts)], axis=1)


def listener_azimuth(
    attitude: np.ndarray, turning_with_body: bool = False
) -> np.ndarray:
    """Return the azimuth (k,) [rad] of the table's x axis in the patch frame or the
    body frame.

    The patch lies along a_2, a quarter turn ahead of the precession angle; a free body
    also rotates by the spin angle."""
    return -(
        attitude[:, 0] + np.pi / 2 + (attitude[:, 2] if turning_with_body else 0.0)
    )


def modal_forcing_function(
    modes: Modes, scene: Scene
) -> Callable[[np.ndarray, np.ndarray], np.ndarray]:
    """Return a function of force and attitude that computes the modal forcing.

    It has the form forcing(force (k, 3) [N], attitude (k, 3) [rad]) -> g (k, m).

    The forcing is g in q'' + 2 d q' + w^2 q = g.

    A disk held at its `patch` moves with the contact: g = -participation . rigid
    acceleration, and the force itself does no work on the modes. On a `free` disk the
    force acts at the current contact point: g = shape . force. With the support
    `contact` the motion of the contact point drives the disk as if it were held there;
    for an elastic contact see `_modal_forcing_of_springs`."""
    if scene.support.kind != "free":
        per_newton = forcing_per_newton(modes, scene)
        return lambda force, attitude: np.einsum(
            "kc,cm->km", in_patch_frame(force, attitude[:, 1]), per_newton
        )
    shape = _rim_spline(modes)
    return lambda force, attitude: np.einsum(
        "kmc,kc->km",
        shape(-attitude[:, 2]),
        in_patch_frame(force, attitude[:, 1]),
        optimize=True,
    )


def arc_shares(half_arc: np.ndarray, order: np.ndarray) -> np.ndarray:
    """Return the share (k, m) of a force that modes of the orders (m,) receive.

    The force acts on an arc of the rim, and its density is that of a plane face pressed
    into springs, cos(phi) - cos(a) with the `half_arc` a (k,) [rad]. For a point, a = 0,
    the share is 1.
    """
    if not half_arc.any():
        return np.ones((1, 1))
    a = np.maximum(half_arc, MIN_HALF_ARC)[:, None]
    n = np.asarray(order, dtype=float)
    n = np.where(n == 1, 1 + 1e-6, np.where(n == 0, 1e-6, n))
    near = np.sin((n - 1) * a) / (n - 1) + np.sin((n + 1) * a) / (n + 1)
    moment = near - 2 * np.cos(a) * np.sin(n * a) / n
    shares = moment / (2 * (np.sin(a) - a * np.cos(a)))
    return np.where(half_arc[:, None] > MIN_HALF_ARC, shares, 1.0)


MIN_HALF_ARC = 1e-2
"""Half an arc [rad] that counts as a point; the error is n^2 a^2/10."""


def forcing_per_newton(modes: Modes, scene: Scene) -> np.ndarray:
    """Return the modal forcing (3, m) due to 1 N along x, y, z of the patch.

    For a free disk it is the root mean square around the rim."""
    if scene.support.kind == "free":
        return np.sqrt(np.mean(modes.rim_shape**2, axis=1)).T
    by_support = -rigid_acceleration(np.eye(3), scene.disk) @ modes.participation.T
    if scene.support.kind == "contact" and scene.contact.law == "elastic":
        return _modal_forcing_of_springs(modes, scene.disk, by_support)
    return by_support


def _modal_forcing_of_springs(
    modes: Modes, disk: Disk, by_support: np.ndarray
) -> np.ndarray:
    """Return the modal forcing (3, m) if the rigid vibration on the contact is a
    separate stem.

    The force is then that of the contact springs, which does work on the elastic part
    of a shape, that is, the shape minus its rigid part. Predominantly rigid modes
    belong to the other stem and are not forced."""
    rigid_share = np.square(modes.participation) @ (1 / inertia(disk))
    return (by_support + modes.rim_shape[:, 0].T) * (rigid_share < 0.5)


def _rim_spline(modes: Modes) -> CubicSpline:
    """Return a periodic cubic spline of the displacement (k, m, 3) of the bottom edge
    at angles (k,)."""
    angle = np.append(modes.rim_angle, modes.rim_angle[0] + 2 * np.pi)
    closed = np.concatenate([modes.rim_shape, modes.rim_shape[:, :1]], axis=1)
    return CubicSpline(angle, closed.swapaxes(0, 1), bc_type="periodic")
