"""Conversion between the columns of a Motion and the state of the compliant model, and the energy
of that state.
"""

import numpy as np

from dynamics.compliant.law.height_profile import mean_height
from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.law.linearised import inertias
from dynamics.compliant.law.tabulated import LAW_COLUMNS
from dynamics.compliant.stepping.state_layout import ENERGY_LOSSES, STATE, STATE_SIZE
from dynamics.film.forces import squeezed_air_energy
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
    deflection = np.array(
        [-f1 / c[LAW_COLUMNS.stiffness_1], -f2 / c[LAW_COLUMNS.stiffness_2]]
    )  # along a_1, a_2
    delta = (N / c[LAW_COLUMNS.hertz_stiffness]) ** (2 / 3)
    if not slip.any():
        slip = (
            deflection
            * speed
            / c[[LAW_COLUMNS.relaxation_length_1, LAW_COLUMNS.relaxation_length_2]]
        )
    y = np.zeros(STATE_SIZE)
    y[STATE.roughness_heights : STATE.roughness_heights + 2] = [
        mean_height(p, -R * state[2], c[LAW_COLUMNS.half_length]) for p in model.profiles
    ]
    y[0], y[1] = state[3:5]
    y[2] = (
        R * np.sin(beta)
        - 2 * H * np.sin(beta / 2) ** 2
        - delta
        + y[STATE.roughness_heights : STATE.roughness_heights + 2].sum()
    )
    y[STATE.velocity : STATE.axis] = slip @ [a1, a2] + np.cross(
        w1 * a1 + w2 * n + w3 * e3,
        H * n + R * e3,
    )
    y[STATE.axis : STATE.angular_momentum] = n
    y[STATE.angular_momentum : STATE.spring_stretch] = J1 * (w1 * a1 + w3 * e3) + J2 * w2 * n
    y[STATE.spring_stretch : STATE.spring_stretch + 2] = deflection * [
        -1,
        1,
    ]  # along t = -a_1, d = a_2
    y[STATE.spring_stiffness : STATE.spring_stiffness + 2] = c[
        LAW_COLUMNS.stiffness_1 : LAW_COLUMNS.stiffness_2 + 1
    ]
    y[STATE.normal_force] = N
    y[STATE.previous_forces : STATE.previous_forces + 2] = N
    y[STATE.gap] = -delta
    y[[STATE.table_path, STATE.edge_path]] = -R * state[2]
    film = model.constants
    y[STATE.squeezed_air_energy] = squeezed_air_energy(
        np.sin(beta), w3 / np.sin(beta), film.film_number, film.film_ambient, film.film_slip
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
    still[STATE.velocity : STATE.axis] = 0.0
    still[STATE.angular_momentum : STATE.spring_stretch] = 0.0
    kinetic = most + excess - float(energy(model, still[None])[0])
    if excess >= kinetic:
        raise ImpossibleContactError(
            f"to bend the table under the disk takes {excess:.3g} J, more than the {kinetic:.3g} "
            f"J of its motion"
        )
    slower = np.sqrt(1 - excess / kinetic)
    y[STATE.velocity : STATE.axis] *= slower
    y[STATE.angular_momentum : STATE.spring_stretch] *= slower


def inclination(y) -> np.ndarray:
    """Return the inclinations (n,) [rad] of states (n, STATE_SIZE); accurate for the smallest
    angles.
    """
    return np.arctan2(np.hypot(y[:, STATE.axis], y[:, STATE.axis + 1]), y[:, STATE.axis + 2])


def energy(model, y) -> np.ndarray:
    """Return the total energy (n,) [J] of states (n, STATE_SIZE); zero for the disk lying flat.

    It is the sum of kinetic, potential and elastic energy, and the energies of table modes, disk
    modes and squeezed air.
    """
    y = np.ascontiguousarray(y.T)
    (J1, J2) = inertias(model.table.law.disk)
    disk = model.table.law.disk
    v = y[STATE.velocity : STATE.axis]
    n = y[STATE.axis : STATE.angular_momentum]
    L = y[STATE.angular_momentum : STATE.spring_stretch]
    moved = (
        disk.mass * (v * v).sum(axis=0)
        + (L * L).sum(axis=0) / J1
        + (1 / J2 - 1 / J1) * (L * n).sum(axis=0) ** 2
    )
    x = np.log(np.maximum(np.hypot(n[0], n[1]), np.sin(MIN_CONTACT_INCLINATION)))
    moved += 0.8 * model.table.stiffness(x) * np.sqrt(np.maximum(0.0, -y[STATE.gap])) ** 5
    moved += (
        y[STATE.spring_stiffness : STATE.spring_stiffness + 2]
        * y[STATE.spring_stretch : STATE.spring_stretch + 2] ** 2
    ).sum(axis=0)
    return (
        moved / 2
        + model.constants.weight * (y[2] - y[STATE.table_rise])
        + y[STATE.table_mode_energy]
        + y[STATE.disk_mode_energy]
        + y[STATE.squeezed_air_energy]
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
    d0 = y[STATE.axis] / s
    d1 = y[STATE.axis + 1] / s
    L = y[STATE.angular_momentum : STATE.spring_stretch]
    w1 = (L[0] * d1 - L[1] * d0) / J1
    w2 = (y[STATE.axis : STATE.angular_momentum] * L).sum(axis=0) / J2
    w3 = (L[2] * s - (L[0] * d0 + L[1] * d1) * c) / J1
    u1 = y[3] * d1 - y[4] * d0 - R * w2 + H * w3
    u2 = y[3] * d0 + y[4] * d1 + (R * s + H * c) * w1
    lost = y[ENERGY_LOSSES].sum(axis=0)
    return np.column_stack(
        [np.arctan2(-d0, d1), beta, -y[STATE.edge_path] / R, y[0], y[1], w1, w2, w3, u1, u2, lost]
    )
