"""Both parts of a time step on a table with modes; regular for a flat disk.

The scheme conserves or dissipates energy. The rim touches the table in the horizontal
direction e in which the gap without heights is smallest. There, the gap is G = z - R n.e
+ H (1 - c) - sum q_m w_m - r, where n is the axis, c = n_z, and r the sum of the heights
of table and edge. With e and the mode shapes w_m at both ends of a step h, and ~ for the
mean of both ends,

    dG = dz - u.dn - sum w~ dq + T,    u = (R e~, H),    T = -R n~.de - sum q~ dw - dr,

exactly. T + dr is of third order, because G + r is a minimum. With U = 2/5 K (-G)^2.5 and the
difference quotient N = -dU/dG, the force N on the centre, the torque N u x n~ and the
forces -N w~ on the modes do the work N (dG - T). Kinetic energy + m g z + U + the
energy of the modes therefore changes only by -N T. This error is compensated by scaling
the velocities of the disk. If the contact jumps to another wave of the table, the gap
changes to that at the new place before the step, at a constant state.

K is the stiffness at the current inclination. Within a step it is linear in s =
sin(beta), and g = dU/ds acts as the torque g/s~ n~_xy x n~ does in normal.py. The rest of
its change, at a constant gap, is balanced by the kinetic energy of the disk. The
horizontal force of the inclined table, which would do little work, is neglected.
"""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.law.tabulated import LAW_COLUMNS
from dynamics.compliant.stepping.contact_energy import (
    current_law,
    hertz_stiffness_slope,
    law_interval,
    mean_force,
    square_root_of_approach,
)
from dynamics.compliant.stepping.normal import MAX_ITERATIONS
from dynamics.compliant.stepping.state_layout import (
    STATE,
    CompiledModel,
    LawCubics,
    ModelConstants,
)
from dynamics.compliant.stepping.table_modes import (
    CONTACT,
    ContactModes,
    advance_modes,
    angle_between,
    mode_work_sums,
    predict_free_motion,
    track_contact,
)
from dynamics.compliant.stepping.tangential import step_tangential
from dynamics.numba_kernels import kernel
from dynamics.stepping_core.rim_modes import disk_twist_rate
from dynamics.stepping_core.rotation import rotation_change
from dynamics.stepping_core.vectors import AnyVector, Triple, dot, plus, times, vector


@kernel
def update_gap_stiffness(
    y: np.ndarray, model: CompiledModel, modes: ContactModes
) -> None:
    """Update the contact stiffness to the current inclination; see above."""
    K0 = modes.contact[CONTACT.gap_stiffness]
    K1 = current_law(y, model.law, LAW_COLUMNS.hertz_stiffness)
    modes.contact[CONTACT.gap_stiffness] = K1
    root = square_root_of_approach(y[STATE.gap])
    if root > 0 and K0 > 0:
        add_kinetic_energy(y, model.constants, modes, 0.4 * (K0 - K1) * root**5)


class ContactMove(NamedTuple):
    """Move of the contact along the rim in a step h, found from the motion without force."""

    axis: tuple[float, float, float]
    """Axis of the disk at the end of the step, as far as it is known."""
    angle: float
    """Direction from the centre to the contact [rad]."""
    turn: float
    """Rotation of this direction in the step [rad]; `jumped` if it is too large."""
    jumped: bool
    direction: tuple[float, float]
    """Mean e~ of the directions e at both ends of the step, and their difference."""
    direction_change: tuple[float, float]
    twist_change: float
    """Rotation of the disk about its axis [rad]."""
    table_path: float
    """Path length on the table at the end of the step [m]."""
    height: float
    """Sum r of the heights of table and edge, and its change [m]."""
    rise: float
    mode_sums: tuple[float, float, float, float]
    """D, E, P, S of `mode_work_sums`."""


class GapStart(NamedTuple):
    """Disk and gap at the start of a step."""

    velocity: tuple[float, float, float]
    axis: tuple[float, float, float]
    momentum: tuple[float, float, float]
    """Angular momentum [kg m^2/s]."""
    sine: float
    """Sine of the inclination, at least that of MIN_CONTACT_INCLINATION."""
    stiffness: float
    """Stiffness K of the contact [N/m^1.5], and its derivative dK/ds."""
    stiffness_slope: float
    loss: float
    """Loss coefficient c, divided by the length of the step [1/m]."""
    gap: float
    """Gap G [m], and the root of the approach."""
    root: float


class GapEnd(NamedTuple):
    """Disk and gap at the end of a step with a trial of the normal force."""

    mean_fall: float
    """Vertical velocity of the centre at mid-step [m/s]."""
    mean_momentum: tuple[float, float, float]
    """Angular momentum at mid-step [kg m^2/s]."""
    axis: tuple[float, float, float]
    axis_change: float
    """Sum of the changes of the components of the axis since the previous trial."""
    gap: float
    """Gap G [m], its change by T, and the root of the approach."""
    gap_error: float
    root: float
    stiffness: float
    """Stiffness K of the contact [N/m^1.5], and its derivative dK/ds in the step."""
    stiffness_slope: float
    torque: float
    """g = dU/ds [N m]."""
    elastic_force: float
    """Difference quotient -dU/dG [N], and its product with the factor of the loss."""
    damped_force: float


@kernel
def find_contact(
    y: np.ndarray, model: CompiledModel, modes: ContactModes, h: float
) -> ContactMove:
    """Return the `ContactMove` of a step h; a contact that jumps is moved before the step."""
    # largest rotation [rad] of a rolling contact in one step; beyond it, the contact has jumped
    max_rolling_turn = 0.3
    constants = model.constants
    velocity = vector(y, STATE.velocity)
    n = vector(y, STATE.axis)
    L = vector(y, STATE.angular_momentum)
    axis = plus(n, rotation_change(n, times(h / (2 * constants.diametral_inertia), L)))
    predict_free_motion(modes, h)
    before = modes.contact[CONTACT.angle]
    twist_change = h * disk_twist_rate(constants, n, L)
    modes.contact[CONTACT.twist_angle] += twist_change
    table_path = y[STATE.table_path] + h * (
        velocity[1] * np.cos(before) - velocity[0] * np.sin(before)
    )
    turned = angle_between(np.arctan2(n[1], n[0]), before)
    edge_path = y[STATE.edge_path] + constants.radius * (turned - twist_change)
    half_length = current_law(y, model.law, LAW_COLUMNS.half_length)
    angle, height, path_change = track_contact(
        modes,
        constants,
        (y[0] + h * velocity[0], y[1] + h * velocity[1]),
        axis,
        (model.table, model.rim, table_path, edge_path, half_length),
    )
    turn = abs(angle_between(before, angle))
    jumped = turn > max_rolling_turn
    if jumped:
        move_contact_along_rim(y, constants, modes, angle, height)
        before = angle
        predict_free_motion(modes, h)
    rise = height - y[STATE.roughness_heights] - y[STATE.roughness_heights + 1]
    sines = np.sin(before), np.sin(angle)
    cosines = np.cos(before), np.cos(angle)
    return ContactMove(
        axis,
        angle,
        turn,
        jumped,
        ((cosines[0] + cosines[1]) / 2, (sines[0] + sines[1]) / 2),
        (cosines[1] - cosines[0], sines[1] - sines[0]),
        twist_change,
        table_path + path_change,
        height,
        rise,
        mode_work_sums(modes, h),
    )


@kernel
def gap_at_start(
    y: np.ndarray, law: LawCubics, modes: ContactModes, h: float
) -> GapStart:
    """Return the `GapStart` of a step h."""
    sine = max(y[STATE.sin_inclination], MIN_CONTACT_INCLINATION)
    return GapStart(
        vector(y, STATE.velocity),
        vector(y, STATE.axis),
        vector(y, STATE.angular_momentum),
        sine,
        modes.contact[CONTACT.gap_stiffness],
        hertz_stiffness_slope(
            law, int(y[STATE.law_interval]), y[STATE.law_fraction], sine
        ),
        current_law(y, law, LAW_COLUMNS.loss_coefficient) / h,
        y[STATE.gap],
        square_root_of_approach(y[STATE.gap]),
    )


@kernel
def momentum_at_mid_step(
    L: AnyVector,
    move: ContactMove,
    constants: ModelConstants,
    t: AnyVector,
    N: float,
    stiffening: float,
    h: float,
) -> Triple:
    """Return the angular momentum [kg m^2/s] at mid-step, under the force N and the torque g.

    L is that at the start of the step, t the mean axis and `stiffening` the ratio g/s~.
    """
    R = constants.core_radius
    H = constants.core_depth
    e0, e1 = move.direction
    return (
        L[0] + h / 2 * (N * (R * e1 * t[2] - H * t[1]) + stiffening * t[1] * t[2]),
        L[1] + h / 2 * (N * (H * t[0] - R * e0 * t[2]) - stiffening * t[0] * t[2]),
        L[2] + h / 2 * N * R * (e0 * t[1] - e1 * t[0]),
    )


@kernel
def gap_change_and_part(
    n: AnyVector,
    a: AnyVector,
    q: AnyVector,
    move: ContactMove,
    constants: ModelConstants,
    N: float,
    dz: float,
) -> tuple[float, float]:
    """Return dG and T [m] of a step in which the axis n changes by q to a.

    N is the normal force and dz the change in height of the centre [m].
    """
    R = constants.core_radius
    H = constants.core_depth
    e0, e1 = move.direction
    c0, c1 = move.direction_change
    D, E, P, S = move.mode_sums
    T = -R * ((n[0] + a[0]) * c0 + (n[1] + a[1]) * c1) / 2 - (P - S * N) - move.rise
    dgap = dz - R * (e0 * q[0] + e1 * q[1]) - H * q[2] - (D - E * N) + T
    return dgap, T


@kernel
def gap_at_end(
    start: GapStart,
    move: ContactMove,
    constants: ModelConstants,
    axis: AnyVector,
    N: float,
    torque: float,
    stiffness_slope: float,
    h: float,
) -> GapEnd:
    """Return the `GapEnd` of a step h under the normal force N.

    The axis at the end of the step, the torque g and dK/ds are those of the previous trial.
    """
    # relative change of the stiffness in one step, above which it changes after the step
    max_stiffness_change = 0.25
    mean_fall = start.velocity[2] + h / (2 * constants.mass) * (N - constants.weight)
    t = times(0.5, plus(start.axis, axis))
    sine = max(np.sqrt(axis[0] * axis[0] + axis[1] * axis[1]), MIN_CONTACT_INCLINATION)
    stiffening = 2 * torque / (start.sine + sine)
    M = momentum_at_mid_step(start.momentum, move, constants, t, N, stiffening, h)
    q = rotation_change(start.axis, times(h / (2 * constants.diametral_inertia), M))
    a = plus(start.axis, q)
    axis_change = abs(a[0] - axis[0]) + abs(a[1] - axis[1]) + abs(a[2] - axis[2])
    dgap, T = gap_change_and_part(start.axis, a, q, move, constants, N, h * mean_fall)
    gap = start.gap + dgap
    root = square_root_of_approach(gap)
    ds = 2 * (t[0] * q[0] + t[1] * q[1]) / (start.sine + sine)
    if abs(stiffness_slope * ds) > max_stiffness_change * start.stiffness:
        stiffness_slope = 0.0
    stiffness = start.stiffness + stiffness_slope * ds
    force = mean_force(start.root, root, start.gap, gap)
    elastic_force = (start.stiffness + stiffness) / 2 * force
    return GapEnd(
        mean_fall,
        M,
        a,
        axis_change,
        gap,
        T,
        root,
        stiffness,
        stiffness_slope,
        0.2 * (start.root**5 + root**5) * stiffness_slope,
        elastic_force,
        elastic_force * (1 - start.loss * dgap),
    )


@kernel
def next_normal_force(
    start: GapStart,
    move: ContactMove,
    end: GapEnd,
    constants: ModelConstants,
    N: float,
    other_force: float,
    other_error: float,
    h: float,
) -> float:
    """Return the next trial of the normal force after N and `other_force`.

    In a hard impact Newton's method alternates around the solution, which the secant
    between both forces approaches; where the dashpot pulls, both are of no use.
    """
    E = move.mode_sums[1]
    R = constants.core_radius
    W = 1 / constants.mass + R * R / constants.diametral_inertia
    error = max(0.0, end.damped_force) - N
    stiffness_slope = end.stiffness * (start.root / 2 + end.root)
    resistance = stiffness_slope * (h * h / 4 * W + E / 2)
    resistance += start.loss * end.elastic_force * (h * h / 2 * W + E)
    newton_change = error / (1 + resistance) if end.damped_force > 0 else error
    alternates = error * other_error < 0
    if alternates and end.damped_force <= 0:
        return (N + other_force) / 2
    if alternates and 2 * abs(error) > abs(other_error):
        return N - error * (N - other_force) / (error - other_error)
    return max(0.0, N + newton_change)


@kernel
def solve_normal_force(
    y: np.ndarray,
    start: GapStart,
    move: ContactMove,
    constants: ModelConstants,
    h: float,
) -> tuple[bool, float, GapEnd]:
    """Return True if there is a normal force for a step h, the force, and its `GapEnd`."""
    # tolerance of the normal force, divided by the sum of force and weight, and of the axis
    tolerance = 1e-12
    R = constants.core_radius
    N = max(
        0.0,
        3 * (y[STATE.normal_force] - y[STATE.previous_forces])
        + y[STATE.previous_forces + 1],
    )
    other_force = N  # of the previous trial
    other_error = 0.0
    torque = 0.4 * start.root**5 * start.stiffness_slope
    slope = start.stiffness_slope
    end = gap_at_end(start, move, constants, move.axis, N, torque, slope, h)
    for _ in range(MAX_ITERATIONS - 2):
        force = next_normal_force(
            start, move, end, constants, N, other_force, other_error, h
        )
        other_force = N
        other_error = max(0.0, end.damped_force) - N
        N = force
        torque = end.torque
        end = gap_at_end(
            start, move, constants, end.axis, N, torque, end.stiffness_slope, h
        )
        scale = N + constants.weight
        if (
            abs(max(0.0, end.damped_force) - N) <= tolerance * scale
            and end.axis_change < tolerance
            and abs(end.torque - torque) <= tolerance * R * scale
        ):
            return True, N, end
    return False, N, end


@kernel
def step_normal_with_modes(
    y: np.ndarray, model: CompiledModel, modes: ContactModes, h: float
) -> bool:
    """Advance the state y and the modes by the normal part of a step h.

    Returns False if the normal force has no solution.
    """
    constants = model.constants
    update_gap_stiffness(y, model, modes)
    move = find_contact(y, model, modes, h)
    start = gap_at_start(y, model.law, modes, h)
    solved, N, end = solve_normal_force(y, start, move, constants, h)
    if not solved:
        return False
    n = start.axis
    a = end.axis
    y[STATE.contact_loss] += (end.elastic_force - N) * (end.gap - start.gap)
    turned = np.arctan2(n[0] * a[1] - n[1] * a[0], n[0] * a[0] + n[1] * a[1])
    y[STATE.edge_path] += constants.radius * (turned - move.twist_change)
    table_loss, body_loss = advance_modes(modes, N, h)
    y[STATE.table_loss] += table_loss
    y[STATE.body_loss] += body_loss
    velocity = (start.velocity[0], start.velocity[1], end.mean_fall)
    for k in range(3):
        y[STATE.position + k] += h * velocity[k]
        y[STATE.axis + k] = a[k]
        y[STATE.angular_momentum + k] = 2 * end.mean_momentum[k] - start.momentum[k]
    y[STATE.velocity + 2] = 2 * end.mean_fall - start.velocity[2]
    y[STATE.table_path] = move.table_path
    y[STATE.roughness_heights] = move.height
    y[STATE.roughness_heights + 1] = 0.0
    if not move.jumped:
        y[STATE.path_speed] = constants.core_radius * move.turn / h
    modes.contact[CONTACT.angle] = move.angle
    modes.contact[CONTACT.gap_stiffness] = end.stiffness
    y[STATE.previous_forces + 1] = y[STATE.previous_forces]
    y[STATE.previous_forces] = y[STATE.normal_force]
    y[STATE.normal_force] = N
    y[STATE.gap] = end.gap
    add_kinetic_energy(y, constants, modes, N * end.gap_error)
    y[STATE.sin_inclination] = np.sqrt(a[0] * a[0] + a[1] * a[1])
    y[STATE.law_interval], y[STATE.law_fraction] = law_interval(
        model.law, max(y[STATE.sin_inclination], MIN_CONTACT_INCLINATION)
    )
    return True


@kernel
def move_contact_along_rim(
    y: np.ndarray,
    constants: ModelConstants,
    modes: ContactModes,
    angle: float,
    height: float,
) -> None:
    """Move the contact to another place of the rim, at a constant state of disk and table.

    The new place is that of `shape_after`. The gap there is usually larger, and the
    difference of the contact energies is dissipated; otherwise the disk supplies it.
    """
    stiffness = modes.contact[CONTACT.gap_stiffness]
    released = 0.4 * stiffness * square_root_of_approach(y[STATE.gap]) ** 5
    down = y[6] * np.cos(angle) + y[7] * np.sin(angle)
    lowest = (
        y[2] - constants.core_radius * down + constants.core_depth * (1 - y[8]) - height
    )
    for m in range(len(modes.amplitude)):
        modes.shape_before[m] = modes.shape_after[m]
        lowest -= modes.amplitude[m] * modes.shape_after[m]
    y[STATE.gap] = lowest
    y[STATE.roughness_heights] = height
    y[STATE.roughness_heights + 1] = 0.0
    released -= 0.4 * stiffness * square_root_of_approach(lowest) ** 5
    if released > 0:
        y[STATE.contact_loss] += released
    else:
        add_kinetic_energy(y, constants, modes, released)


@kernel
def step_tangential_with_modes(
    y: np.ndarray, model: CompiledModel, modes: ContactModes, h: float
) -> None:
    """Advance the state y by the tangential part of a step h.

    Away from the lowest point of the rim, t and d are not exactly the principal
    directions of the mobility. The velocities are scaled to compensate for the energy
    error of the midpoint rule.
    """
    constants = model.constants
    energy_before = kinetic_energy(y, constants) + stored_and_lost_energy(y)
    angle = modes.contact[CONTACT.angle]
    given = step_tangential(y, model, modes, np.cos(angle), np.sin(angle), h)
    energy = kinetic_energy(y, constants) + stored_and_lost_energy(y)
    add_kinetic_energy(y, constants, modes, energy_before - energy - given)


@kernel
def stored_and_lost_energy(y: np.ndarray) -> float:
    """Return the energy of springs and squeezed air plus that lost so far."""
    springs = (
        y[STATE.spring_stiffness] * y[STATE.spring_stretch] ** 2
        + y[STATE.spring_stiffness + 1] * y[STATE.spring_stretch + 1] ** 2
    )
    return (
        springs / 2
        + y[STATE.squeezed_air_energy]
        + y[STATE.creep_loss]
        + y[STATE.slip_loss]
        + y[STATE.moment_loss]
        + y[STATE.film_loss]
    )


@kernel
def kinetic_energy(y: np.ndarray, constants: ModelConstants) -> float:
    """Return the kinetic energy of the disk."""
    v = vector(y, STATE.velocity)
    L = vector(y, STATE.angular_momentum)
    spin = dot(vector(y, STATE.axis), L)
    turning = dot(L, L) / constants.diametral_inertia
    turning += constants.inverse_inertia_excess * spin * spin
    return (constants.mass * dot(v, v) + turning) / 2


@kernel
def add_kinetic_energy(
    y: np.ndarray, constants: ModelConstants, modes: ContactModes, work: float
) -> None:
    """Add `work` to the kinetic energy of the disk by scaling its velocities.

    If the kinetic energy is insufficient, the modes supply the rest. The remainder is
    recorded as STATE.energy_deficit, which ends the motion. This happens only if an
    almost flat disk jumps to another wave of the table. A disk without kinetic energy
    dissipates a positive work.
    """
    energy = kinetic_energy(y, constants)
    change = max(work, -energy) if energy > 0 else 0.0
    scale = np.sqrt(1 + change / energy) if energy > 0 else 0.0
    for i in range(3):
        y[STATE.velocity + i] *= scale
        y[STATE.angular_momentum + i] *= scale
    missing = change - work
    mode_energy = 0.0
    if missing > 0:
        for m in range(len(modes.amplitude)):
            mode_energy += modes.velocity[m] ** 2 / 2
    if mode_energy > 0:
        scale = np.sqrt(max(0.0, 1 - missing / mode_energy))
        for m in range(len(modes.amplitude)):
            modes.velocity[m] *= scale
        missing -= min(missing, mode_energy)
    y[STATE.contact_loss] -= missing
    y[STATE.energy_deficit] += max(missing, 0.0)
