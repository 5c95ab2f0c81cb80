"""Conversion between the columns of a Motion and the state of the compliant model, and the energy
of that state.
"""

import numpy as np

from dynamics.compliant.law.height_profile import mean_height
from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.law.linearised import inertias
from dynamics.compliant.law.tabulated import (
    HALF_LENGTH,
    HERTZ_STIFFNESS,
    RELAXATION_LENGTH_1,
    RELAXATION_LENGTH_2,
    STIFFNESS_1,
    STIFFNESS_2,
)
from dynamics.compliant.stepping import state_layout as at
from dynamics.film.forces import squeezed_air_energy
from dynamics.motion import CAUSES
from dynamics.switching import ImpossibleContactError


def released_state(model, state, force=None) -> np.ndarray:
    """Return the state of a compliant model at the columns of a Motion, with the springs loaded by
    a force.

    The springs keep their force by creep, so that no free vibration is excited. A given slip
    remains.

    Parameters
    ----------
    model : CompliantModel
        Disk and contact.
    state : (11,) array
        COLUMNS of a Motion.
    force : (3,) array, optional
        Friction along a_1 and a_2 and the normal force [N]; default: the weight alone.

    Returns
    -------
    (STATE_SIZE,) array
        State in the layout of state.py.
    """
    law = model.table.law
    theta = state[0]
    beta = state[1]
    slip = state[8:10]
    f1, f2, N = (0.0, 0.0, law.disk.weight) if force is None else force
    R = law.disk.radius
    H = law.disk.thickness / 2
    (J1, J2) = inertias(law.disk)
    c = model.table.columns(np.array([beta]))[0]
    a1 = np.array([np.cos(theta), np.sin(theta), 0.0])
    a2 = np.array([-np.sin(theta), np.cos(theta), 0.0])
    n = np.sin(beta) * a2 + [0, 0, np.cos(beta)]
    e3 = [0, 0, np.sin(beta)] - np.cos(beta) * a2
    w1, w2, w3 = state[5:8]
    speed = abs(R * (w2 - w3 / np.tan(beta)) + slip[0])
    deflection = np.array([-f1 / c[STIFFNESS_1], -f2 / c[STIFFNESS_2]])  # along a_1, a_2
    delta = (N / c[HERTZ_STIFFNESS]) ** (2 / 3)
    if not slip.any():
        slip = deflection * speed / c[[RELAXATION_LENGTH_1, RELAXATION_LENGTH_2]]
    y = np.zeros(at.STATE_SIZE)
    y[at.ROUGHNESS_HEIGHTS : at.ROUGHNESS_HEIGHTS + 2] = [
        mean_height(p, -R * state[2], c[HALF_LENGTH]) for p in model.profiles
    ]
    y[0], y[1] = state[3:5]
    y[2] = (
        R * np.sin(beta)
        - 2 * H * np.sin(beta / 2) ** 2
        - delta
        + y[at.ROUGHNESS_HEIGHTS : at.ROUGHNESS_HEIGHTS + 2].sum()
    )
    y[at.VELOCITY : at.AXIS] = slip @ [a1, a2] + np.cross(
        w1 * a1 + w2 * n + w3 * e3,
        H * n + R * e3,
    )
    y[at.AXIS : at.ANGULAR_MOMENTUM] = n
    y[at.ANGULAR_MOMENTUM : at.SPRING_STRETCH] = J1 * (w1 * a1 + w3 * e3) + J2 * w2 * n
    y[at.SPRING_STRETCH : at.SPRING_STRETCH + 2] = deflection * [-1, 1]  # along t = -a_1, d = a_2
    y[at.SPRING_STIFFNESS : at.SPRING_STIFFNESS + 2] = c[STIFFNESS_1 : STIFFNESS_2 + 1]
    y[at.NORMAL_FORCE] = N
    y[at.PREVIOUS_FORCES : at.PREVIOUS_FORCES + 2] = N
    y[at.GAP] = -delta
    y[[at.TABLE_PATH, at.EDGE_PATH]] = -R * state[2]
    y[at.SQUEEZED_AIR_ENERGY] = squeezed_air_energy(
        np.sin(beta), w3 / np.sin(beta), *model.constants[at.FILM_NUMBER : at.FILM_SLIP + 1]
    )
    return y


def limit_energy(model, y, most: float) -> None:
    """Slow down a disk in the state y (STATE_SIZE,) to a total energy of at most `most` [J].

    All velocities shrink by one factor, which preserves rolling. Springs and table keep their
    energy. Raises ImpossibleContactError if the kinetic energy is too small.
    """
    excess = float(energy(model, y[None])[0]) - most
    if excess <= 0:
        return
    still = y.copy()
    still[at.VELOCITY : at.AXIS] = 0.0
    still[at.ANGULAR_MOMENTUM : at.SPRING_STRETCH] = 0.0
    kinetic = most + excess - float(energy(model, still[None])[0])
    if excess >= kinetic:
        raise ImpossibleContactError(
            f"to bend the table under the disk takes {excess:.3g} J, more than the {kinetic:.3g} "
            f"J of its motion"
        )
    slower = np.sqrt(1 - excess / kinetic)
    y[at.VELOCITY : at.AXIS] *= slower
    y[at.ANGULAR_MOMENTUM : at.SPRING_STRETCH] *= slower


def inclination(y) -> np.ndarray:
    """Return the inclinations (n,) [rad] of states (n, STATE_SIZE); accurate for the smallest
    angles.
    """
    return np.arctan2(np.hypot(y[:, at.AXIS], y[:, at.AXIS + 1]), y[:, at.AXIS + 2])


def energy(model, y) -> np.ndarray:
    """Return the total energy (n,) [J] of states (n, STATE_SIZE); zero for the disk lying flat.

    It is the sum of kinetic, potential and elastic energy, and the energies of table modes, disk
    modes and squeezed air.
    """
    y = np.ascontiguousarray(y.T)
    (J1, J2) = inertias(model.table.law.disk)
    disk = model.table.law.disk
    v = y[at.VELOCITY : at.AXIS]
    n = y[at.AXIS : at.ANGULAR_MOMENTUM]
    L = y[at.ANGULAR_MOMENTUM : at.SPRING_STRETCH]
    moved = (
        disk.mass * (v * v).sum(axis=0)
        + (L * L).sum(axis=0) / J1
        + (1 / J2 - 1 / J1) * (L * n).sum(axis=0) ** 2
    )
    x = np.log(np.maximum(np.hypot(n[0], n[1]), np.sin(MIN_CONTACT_INCLINATION)))
    moved += 0.8 * model.table.stiffness(x) * np.sqrt(np.maximum(0.0, -y[at.GAP])) ** 5
    moved += (
        y[at.SPRING_STIFFNESS : at.SPRING_STIFFNESS + 2]
        * y[at.SPRING_STRETCH : at.SPRING_STRETCH + 2] ** 2
    ).sum(axis=0)
    return (
        moved / 2
        + model.constants[at.WEIGHT] * (y[2] - y[at.TABLE_RISE])
        + y[at.TABLE_MODE_ENERGY]
        + y[at.DISK_MODE_ENERGY]
        + y[at.SQUEEZED_AIR_ENERGY]
    )


def columns(model, y) -> np.ndarray:
    """Return the COLUMNS (n, 11) of a Motion at states (n, STATE_SIZE); the precession is in (-pi,
    pi].
    """
    disk = model.table.law.disk
    (J1, J2) = inertias(model.table.law.disk)
    beta = inclination(y)
    y = np.ascontiguousarray(y.T)
    R = disk.radius
    H = disk.thickness / 2
    s = np.sin(beta)
    c = np.cos(beta)
    d0 = y[at.AXIS] / s
    d1 = y[at.AXIS + 1] / s
    L = y[at.ANGULAR_MOMENTUM : at.SPRING_STRETCH]
    w1 = (L[0] * d1 - L[1] * d0) / J1
    w2 = (y[at.AXIS : at.ANGULAR_MOMENTUM] * L).sum(axis=0) / J2
    w3 = (L[2] * s - (L[0] * d0 + L[1] * d1) * c) / J1
    u1 = y[3] * d1 - y[4] * d0 - R * w2 + H * w3
    u2 = y[3] * d0 + y[4] * d1 + (R * s + H * c) * w1
    lost = y[at.ENERGY_LOSSES : at.ENERGY_LOSSES + len(CAUSES)].sum(axis=0)
    return np.column_stack(
        [np.arctan2(-d0, d1), beta, -y[at.EDGE_PATH] / R, y[0], y[1], w1, w2, w3, u1, u2, lost]
    )
