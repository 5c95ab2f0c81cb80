"""Conversion between COLUMNS of a Motion and states of the compliant model."""

from typing import TYPE_CHECKING

import numpy as np

from dynamics.compliant.law.height_profile import height_at
from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.law.tabulated import LAW_COLUMNS
from dynamics.compliant.stepping.state_layout import (
    ENERGY_LOSSES,
    STATE,
    STATE_SIZE,
    STATE_SLICES,
)
from dynamics.film.forces import squeezed_air_energy
from dynamics.stepping_core.body import (
    angular_momentum,
    body_axes,
    kinetic_and_bowl_energy,
    relative_columns,
    rolling_velocity,
)
from dynamics.switching import ImpossibleContactError

if TYPE_CHECKING:
    from dynamics.compliant.stepping.model import CompliantModel


def preloaded_compliant_state(
    model: "CompliantModel", state: np.ndarray, force: np.ndarray | None = None
) -> np.ndarray:
    """Return the state of a compliant model with springs preloaded by a force.

    If the given slip is zero, the slip is set to the creep that keeps the spring forces
    constant, so that no free vibration is excited.

    Parameters
    ----------
    model : "CompliantModel"
        Disk and contact.
    state : (11,) array
        COLUMNS of a Motion.
    force : (3,) array, optional
        Friction along a_1 and a_2 and the normal force [N]; default: the weight alone.

    Returns
    -------
    (STATE_SIZE,) array
        State in the layout of state_layout.py.
    """
    law = model.tabulated_law.law
    beta = state[1]
    slip = state[8:10]
    if force is None:
        force = np.array([0.0, 0.0, law.disk.weight])
    N = force[2]
    place = law.place(beta)
    c = model.tabulated_law.columns(np.array([beta]))[0]
    axes = body_axes(state[0], beta)
    omega = state[5:8]
    speed = abs(place.radius * (omega[1] - omega[2] / np.tan(beta)) + slip[0])
    deflection = np.array(
        [-force[0] / c[LAW_COLUMNS.stiffness_1], -force[1] / c[LAW_COLUMNS.stiffness_2]]
    )  # along a_1, a_2
    delta = (N / c[LAW_COLUMNS.hertz_stiffness]) ** (2 / 3)
    if not slip.any():
        slip = (
            deflection
            * speed
            / c[[LAW_COLUMNS.relaxation_length_1, LAW_COLUMNS.relaxation_length_2]]
        )
    y = np.zeros(STATE_SIZE)
    y[STATE_SLICES.roughness_heights] = [
        height_at(p, -law.disk.radius * state[2], c[LAW_COLUMNS.half_length])
        for p in model.profiles
    ]
    y[:2] = state[3:5]
    fixed = model.constants
    y[2] = (
        fixed.core_radius * np.sin(beta)
        - 2 * fixed.core_depth * np.sin(beta / 2) ** 2
        - delta
        + y[STATE_SLICES.roughness_heights].sum()
    )
    lever = place.depth * axes[2] + place.radius * axes[3]
    rolling = rolling_velocity(omega, axes, lever)
    y[STATE_SLICES.velocity] = slip @ axes[:2] + rolling
    y[STATE_SLICES.axis] = axes[2]
    y[STATE_SLICES.angular_momentum] = angular_momentum(fixed, omega, axes)
    y[STATE_SLICES.spring_stretch] = deflection * [-1, 1]  # along t = -a_1, d = a_2
    y[STATE_SLICES.spring_stiffness] = c[
        LAW_COLUMNS.stiffness_1 : LAW_COLUMNS.stiffness_2 + 1
    ]
    y[STATE.normal_force] = N
    y[STATE_SLICES.previous_forces] = N
    y[STATE.gap] = -delta
    y[[STATE.table_path, STATE.edge_path]] = -law.disk.radius * state[2]
    y[STATE.squeezed_air_energy] = squeezed_air_energy(
        np.sin(beta),
        omega[2] / np.sin(beta),
        fixed.film.number,
        fixed.film.ambient,
        fixed.film.slip,
        fixed.film.bowl,
    )
    return y


def limit_energy(model: "CompliantModel", y: np.ndarray, max_energy: float) -> None:
    """Limit the total energy of a state y (STATE_SIZE,) to `max_energy` [J].

    All velocities are multiplied by one factor, which preserves rolling. The energies
    of the springs and the table do not change. Raises ImpossibleContactError if the
    kinetic energy is too small.
    """
    excess = float(energy(model, y[None])[0]) - max_energy
    if excess <= 0:
        return
    still = y.copy()
    still[STATE_SLICES.velocity] = 0.0
    still[STATE_SLICES.angular_momentum] = 0.0
    kinetic = max_energy + excess - float(energy(model, still[None])[0])
    if excess >= kinetic:
        raise ImpossibleContactError(
            f"bending the table under the disk requires {excess:.3g} J, more than the kinetic "
            f"energy of {kinetic:.3g} J"
        )
    slower = np.sqrt(1 - excess / kinetic)
    y[STATE_SLICES.velocity] *= slower
    y[STATE_SLICES.angular_momentum] *= slower


def inclination(y: np.ndarray) -> np.ndarray:
    """Return the inclinations (n,) [rad] of states (n, STATE_SIZE)."""
    horizontal = np.hypot(y[:, STATE.axis], y[:, STATE.axis + 1])
    return np.arctan2(horizontal, y[:, STATE.axis + 2])


def energy(model: "CompliantModel", y: np.ndarray) -> np.ndarray:
    """Return the total energy (n,) [J] of states (n, STATE_SIZE).

    It is the sum of kinetic, potential and elastic energy, and of the energies of table
    modes, disk modes and squeezed air. It is zero for a disk at rest flat on the table.
    """
    y = np.ascontiguousarray(y.T)
    fixed = model.constants
    n = y[STATE_SLICES.axis]
    moved = 2 * kinetic_and_bowl_energy(
        fixed,
        y[STATE_SLICES.position],
        y[STATE_SLICES.velocity],
        n,
        y[STATE_SLICES.angular_momentum],
    )
    x = np.log(np.maximum(np.hypot(n[0], n[1]), np.sin(MIN_CONTACT_INCLINATION)))
    moved += (
        0.8
        * model.tabulated_law.stiffness(x)
        * np.sqrt(np.maximum(0.0, -y[STATE.gap])) ** 5
    )
    moved += (
        y[STATE_SLICES.spring_stiffness] * y[STATE_SLICES.spring_stretch] ** 2
    ).sum(axis=0)
    return (
        moved / 2
        + fixed.weight * y[2]
        + y[STATE.table_mode_energy]
        + y[STATE.disk_mode_energy]
        + y[STATE.squeezed_air_energy]
    )


def columns(model: "CompliantModel", y: np.ndarray) -> np.ndarray:
    """Return the COLUMNS (n, 11) of a Motion at states (n, STATE_SIZE).

    The precession is in (-pi, pi].
    """
    beta = inclination(y)
    y = np.ascontiguousarray(y.T)
    n = y[STATE_SLICES.axis]
    relative = relative_columns(
        model.constants,
        model.tabulated_law.law.place(beta),
        y[STATE_SLICES.velocity],
        n,
        y[STATE_SLICES.angular_momentum],
    )
    return np.column_stack(
        [
            np.arctan2(-n[0], n[1]),
            beta,
            -y[STATE.edge_path] / model.constants.radius,
            y[0],
            y[1],
            *relative,
            y[ENERGY_LOSSES].sum(axis=0),
        ]
    )
