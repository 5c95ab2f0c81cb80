"""Both parts of a time step on a table with modes; regular for a flat disk.

The scheme conserves or dissipates energy. The rim touches the table in the horizontal
direction e of the smallest gap G = z - R n.e + H (1 - c) - sum q_m w_m - r. Here n is
the axis, c = n_z, and r the sum of the heights of table and edge. With e and the mode
shapes w_m at both ends of a step h, and ~ for the mean of both ends,

    dG = dz - u.dn - sum w~ dq + T,    u = (R e~, H),    T = -R n~.de - sum q~ dw - dr,

exactly. T is of third order, because G is a minimum. With U = 2/5 K (-G)^2.5 and the
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

import numpy as np

from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.law.tabulated import LAW_COLUMNS
from dynamics.compliant.stepping.contact_energy import (
    current_law,
    law_interval,
    law_slope,
    mean_force,
    square_root_of_approach,
)
from dynamics.compliant.stepping.normal import MAX_ITERATIONS, rotation_change
from dynamics.compliant.stepping.rim_modes import disk_twist_rate
from dynamics.compliant.stepping.state_layout import STATE
from dynamics.compliant.stepping.table_modes import (
    CONTACT,
    advance_modes,
    angle_between,
    mode_work_sums,
    predict_free_motion,
    track_contact,
)
from dynamics.compliant.stepping.tangential import step_tangential_at
from dynamics.compliant.stepping.vectors import dot, plus, times, vector
from dynamics.numba_kernels import kernel


@kernel
def update_gap_stiffness(y, constants, modes, law):
    """Update the contact stiffness to the current inclination; see above."""
    K0 = modes.contact[CONTACT.gap_stiffness]
    K1 = current_law(y, law, LAW_COLUMNS.hertz_stiffness)
    modes.contact[CONTACT.gap_stiffness] = K1
    root = square_root_of_approach(y[STATE.gap])
    if root > 0 and K0 > 0:
        add_kinetic_energy(y, constants, modes, 0.4 * (K0 - K1) * root**5)


@kernel
def step_normal_with_modes(y, constants, law, table, rim, modes, scratch, h):
    """Advance the state y and the modes by the normal part of a step h.

    Returns False if the normal force has no solution.
    """
    # largest rotation [rad] of a rolling contact in one step; beyond it, the contact has jumped
    max_rolling_turn = 0.3
    # relative change of the stiffness in one step, above which it changes after the step
    max_stiffness_change = 0.25
    # tolerance of the normal force, divided by the sum of force and weight, and of the axis
    tolerance = 1e-12
    m = constants.mass
    J = constants.diametral_inertia
    R = constants.core_radius
    H = constants.core_depth
    weight = constants.weight
    step_over_2J = h / (2 * J)
    i = int(y[STATE.law_interval])
    u = y[STATE.law_fraction]
    update_gap_stiffness(y, constants, modes, law)
    K0 = modes.contact[CONTACT.gap_stiffness]
    K1 = K0
    s0 = max(y[STATE.sin_inclination], MIN_CONTACT_INCLINATION)
    dK = law_slope(law, i, u, LAW_COLUMNS.hertz_stiffness) * law.intervals_per_unit / s0
    loss = current_law(y, law, LAW_COLUMNS.loss_coefficient) / h
    v0, v1, v2 = vector(y, STATE.velocity)
    n = vector(y, STATE.axis)
    n0, n1, n2 = n
    L = vector(y, STATE.angular_momentum)
    a0, a1, a2 = plus(n, rotation_change(n, times(step_over_2J, L)))
    predict_free_motion(modes, h)
    previous_angle = modes.contact[CONTACT.angle]
    twist_change = h * disk_twist_rate(constants, n, L)
    modes.contact[CONTACT.twist_angle] += twist_change
    table_path = y[STATE.table_path] + h * (
        v1 * np.cos(previous_angle) - v0 * np.sin(previous_angle)
    )
    turned = angle_between(np.arctan2(n1, n0), previous_angle)
    edge_path = y[STATE.edge_path] + constants.radius * (turned - twist_change)
    half_length = current_law(y, law, LAW_COLUMNS.half_length)
    rough = (table, rim, table_path, edge_path, half_length)
    x0 = y[0] + h * v0
    x1 = y[1] + h * v1
    angle, height, path_change = track_contact(
        modes, constants, x0, x1, a0, a1, a2, rough, scratch
    )
    turn = abs(angle_between(previous_angle, angle))
    jumped = turn > max_rolling_turn
    if jumped:
        jump_to_contact(y, constants, modes, angle, height)
        previous_angle = angle
        v0, v1, v2 = vector(y, STATE.velocity)
        L = vector(y, STATE.angular_momentum)
        predict_free_motion(modes, h)
    rise = height - y[STATE.roughness_heights] - y[STATE.roughness_heights + 1]
    D, E, P, S = mode_work_sums(modes, h)
    e0 = (np.cos(previous_angle) + np.cos(angle)) / 2
    e1 = (np.sin(previous_angle) + np.sin(angle)) / 2
    c0 = np.cos(angle) - np.cos(previous_angle)
    c1 = np.sin(angle) - np.sin(previous_angle)
    W = 1 / m + R * R / J
    gap0 = y[STATE.gap]
    r0 = square_root_of_approach(y[STATE.gap])
    N = max(
        0.0,
        3 * (y[STATE.normal_force] - y[STATE.previous_forces])
        + y[STATE.previous_forces + 1],
    )
    gap = gap0
    M = L
    V2 = v2
    elastic_force = 0.0
    T = 0.0
    g = 0.4 * r0**5 * dK
    other_force = N  # of the previous iteration
    other_error = 0.0
    iterations_left = MAX_ITERATIONS
    while iterations_left > 0:
        iterations_left -= 1
        V2 = v2 + h / (2 * m) * (N - weight)
        t0 = (n0 + a0) / 2
        t1 = (n1 + a1) / 2
        t2 = (n2 + a2) / 2
        s1 = max(np.sqrt(a0 * a0 + a1 * a1), MIN_CONTACT_INCLINATION)
        stiffening = 2 * g / (s0 + s1)
        M = (
            L[0] + h / 2 * (N * (R * e1 * t2 - H * t1) + stiffening * t1 * t2),
            L[1] + h / 2 * (N * (H * t0 - R * e0 * t2) - stiffening * t0 * t2),
            L[2] + h / 2 * N * R * (e0 * t1 - e1 * t0),
        )
        q0, q1, q2 = rotation_change(n, times(step_over_2J, M))
        axis_error = abs(n0 + q0 - a0) + abs(n1 + q1 - a1) + abs(n2 + q2 - a2)
        a0 = n0 + q0
        a1 = n1 + q1
        a2 = n2 + q2
        T = -R * ((n0 + a0) * c0 + (n1 + a1) * c1) / 2 - (P - S * N) - rise
        dgap = h * V2 - R * (e0 * q0 + e1 * q1) - H * q2 - (D - E * N) + T
        gap = gap0 + dgap
        r1 = square_root_of_approach(gap)
        ds = 2 * (t0 * q0 + t1 * q1) / (s0 + s1)
        if abs(dK * ds) > max_stiffness_change * K0:
            dK = 0.0
        K1 = K0 + dK * ds
        previous_g = g
        g = 0.2 * (r0**5 + r1**5) * dK
        elastic_force = (K0 + K1) / 2 * mean_force(r0, r1, gap0, gap)
        damped_force = elastic_force * (1 - loss * dgap)
        error = max(0.0, damped_force) - N
        if (
            iterations_left < MAX_ITERATIONS - 1
            and abs(error) <= tolerance * (N + weight)
            and axis_error < tolerance
            and abs(g - previous_g) <= tolerance * R * (N + weight)
        ):
            break
        stiffness_slope = K1 * (r0 / 2 + r1)
        resistance = stiffness_slope * (h * h / 4 * W + E / 2)
        resistance += loss * elastic_force * (h * h / 2 * W + E)
        newton_change = error / (1 + resistance) if damped_force > 0 else error
        # In a hard impact Newton's method alternates around the solution, which the secant between
        # both forces approaches; where the dashpot pulls, both are of no use.
        alternates = error * other_error < 0
        if alternates and damped_force <= 0:
            next_force = (N + other_force) / 2
        elif alternates and 2 * abs(error) > abs(other_error):
            next_force = N - error * (N - other_force) / (error - other_error)
        else:
            next_force = max(0.0, N + newton_change)
        other_force = N
        other_error = error
        N = next_force
    if iterations_left == 0:
        return False
    y[STATE.contact_loss] += (elastic_force - N) * (gap - gap0)
    turned = np.arctan2(n0 * a1 - n1 * a0, n0 * a0 + n1 * a1)
    y[STATE.edge_path] += constants.radius * (turned - twist_change)
    table, body = advance_modes(modes, N, h)
    y[STATE.table_loss] += table
    y[STATE.body_loss] += body
    V = (v0, v1, V2)
    a = (a0, a1, a2)
    for k in range(3):
        y[STATE.position + k] += h * V[k]
        y[STATE.axis + k] = a[k]
        y[STATE.angular_momentum + k] = 2 * M[k] - L[k]
    y[5] = 2 * V2 - v2
    y[STATE.table_path] = table_path + path_change
    y[STATE.roughness_heights] = height
    y[STATE.roughness_heights + 1] = 0.0
    if not jumped:
        y[STATE.path_speed] = R * turn / h
    modes.contact[CONTACT.angle] = angle
    modes.contact[CONTACT.gap_stiffness] = K1
    y[STATE.previous_forces + 1] = y[STATE.previous_forces]
    y[STATE.previous_forces] = y[STATE.normal_force]
    y[STATE.normal_force] = N
    y[STATE.gap] = gap
    add_kinetic_energy(y, constants, modes, N * T)
    y[STATE.sin_inclination] = np.sqrt(a0 * a0 + a1 * a1)
    y[STATE.law_interval], y[STATE.law_fraction] = law_interval(
        law, max(y[STATE.sin_inclination], MIN_CONTACT_INCLINATION)
    )
    return True


@kernel
def jump_to_contact(y, constants, modes, angle, height):
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
def step_tangential_with_modes(y, constants, powers, law, modes, h):
    """Advance the state y by the tangential part of a step h.

    Away from the lowest point of the rim, t and d are not exactly the principal
    directions of the mobility. The velocities are scaled to compensate for the energy
    error of the midpoint rule.
    """
    energy_before = kinetic_energy(y, constants) + stored_and_lost_energy(y)
    angle = modes.contact[CONTACT.angle]
    step_tangential_at(y, constants, powers, law, np.cos(angle), np.sin(angle), h)
    add_kinetic_energy(
        y,
        constants,
        modes,
        energy_before - kinetic_energy(y, constants) - stored_and_lost_energy(y),
    )


@kernel
def stored_and_lost_energy(y):
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
def kinetic_energy(y, constants):
    """Return the kinetic energy of the disk."""
    v = vector(y, STATE.velocity)
    L = vector(y, STATE.angular_momentum)
    spin = dot(vector(y, STATE.axis), L)
    turning = dot(L, L) / constants.diametral_inertia
    turning += constants.inverse_inertia_excess * spin * spin
    return (constants.mass * dot(v, v) + turning) / 2


@kernel
def add_kinetic_energy(y, constants, modes, work):
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
