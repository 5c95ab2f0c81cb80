"""Normal part of a time step: gravity, contact energy and loss.

The scheme conserves or dissipates energy for every step length. Let v and L be the
velocity and the angular momentum, n the axis, J1 and J2 the moments of inertia, e =
1/J2 - 1/J1, and let ~ denote the mean of both ends of a step h:

    dz = h v~,  dn = (h/J1) L~ x n~,  m dv = h (F - m g),  dL = h T.

Then |n| is constant. With w~ = L~/J1 + e (L.n)~ n~ the kinetic energy changes by
exactly h (F.v~ + T.w~), since d(L.n) = h T.n~.

The gap is G = z - R s + H (1 - c) - z_t(path) - z_r(edge) with s = |n_xy| = sin(beta),
where R and H are those of the circle of the centres of the fillet. Its energy is U =
2/5 K(s) (-G)^2.5. The difference quotients N = -dU/dG, g = dU/ds, m_t = dz_t/dpath and
m_r = dz_r/dedge, with f = R - H (s0 + s1)/(c0 + c1), satisfy exactly

    dU = -N dG + g ds,    dG = dz - f ds - m_t dpath - m_r dedge.

The path lengths advance by dpath = h (t.v~ + a.w~) and dedge = h b.w~. The force N (e3
- m_t t) and the torque (N f + g)/s~ n~_xy x n~ - N (m_t a + m_r b) therefore do the
work -dU, and kinetic energy + m g z + U is conserved.

The contact loss increases N by the factor 1 - c dG/h, and N is never negative. Both
dissipate energy: c N (dG)^2/h, or the remaining U when the contact opens. The balance
holds once the scalar equation for N is solved.
"""

import numpy as np

from dynamics.compliant.law.height_profile import mean_height
from dynamics.compliant.law.tabulated import LAW_COLUMNS
from dynamics.compliant.stepping.contact_energy import (
    approach_root,
    current_law,
    law_column,
    law_interval,
    law_slope,
    mean_force,
)
from dynamics.compliant.stepping.state_layout import STATE
from dynamics.compliant.stepping.vectors import cross, dot, plus, times, vector
from dynamics.numba_kernels import kernel

MAX_ITERATIONS = 40
"""Largest number of iterations for the normal force in one step."""


@kernel
def rotation_change(n, b):
    """Return the change m - n of the vector n that satisfies m - n = b x (m + n)."""
    k0, k1, k2 = cross(b, n)
    b0, b1, b2 = b
    q = 2 / (1 + b0 * b0 + b1 * b1 + b2 * b2)
    m0 = q * (k0 + b1 * k2 - b2 * k1)
    m1 = q * (k1 + b2 * k0 - b0 * k2)
    m2 = q * (k2 + b0 * k1 - b1 * k0)
    return m0, m1, m2


@kernel
def contact_moves(displacement):
    """Return False if the contact is stationary in a step with this displacement [m]."""
    max_stationary_displacement = 1e-10
    return abs(displacement) > max_stationary_displacement


@kernel
def height_at_step_end(profile, path, moved, half, before):
    """Return the height after a step, which is unchanged if the contact is stationary."""
    return mean_height(profile, path + moved, half) if contact_moves(moved) else before


@kernel
def mean_slope(y0, y1, dx):
    """Return the mean slope of heights along a path; 0 if the contact is stationary."""
    return (y1 - y0) / dx if contact_moves(dx) else 0.0


@kernel
def midpoint_velocities(y, constants, N, turn, roll, height_slope, A, reach, d0, d1, h):
    """Return velocity and angular momentum at mid-step under the force N.

    A is the sum of the axes at both ends of the step.
    """
    step_over_2m = h / (2 * constants.mass)
    V = (
        y[3] + step_over_2m * N * height_slope * d1,
        y[4] - step_over_2m * N * height_slope * d0,
        y[5] + step_over_2m * (N - constants.weight),
    )
    M = (
        y[9] + h / 2 * (turn * A[1] + roll * d0),
        y[10] + h / 2 * (roll * d1 - turn * A[0]),
        y[11] - h / 2 * N * height_slope * reach,
    )
    return V, M


@kernel
def step_normal(y, constants, law, table, rim, h):
    """Advance y by the normal part of a step h; return False if there is no solution."""
    # Relative error of force and torque below which one more Newton step is
    # sufficient. The energy of an impact is then conserved to 1e-12.
    final_newton_tolerance = 3e-6
    # Change of the estimated path length [m] above which heights are evaluated again.
    # It does not affect the energy balance, because the slopes are difference
    # quotients.
    height_update_distance = 1e-9
    # Largest number of evaluations of the heights in one step
    max_height_evaluations = 3
    # Relative change of sin(beta) below which the mean of dK/ds replaces its
    # difference quotient
    min_relative_sine_change = 1e-4
    m = constants.mass
    J = constants.diametral_inertia
    R = constants.core_radius
    H = constants.core_depth
    weight = constants.weight
    step_over_2J = h / (2 * J)
    inverse_inertia = 1 / J
    e = constants.inverse_inertia_excess
    n = vector(y, STATE.axis)
    L = vector(y, STATE.angular_momentum)
    L0, L1, L2 = L
    # start of the step: contact energy, stiffness K and its loss
    s0 = y[STATE.sin_inclination]
    c0 = n[2]
    axial_momentum = dot(L, n)
    i = int(y[STATE.law_interval])
    u = y[STATE.law_fraction]
    K0 = current_law(y, law, LAW_COLUMNS.hertz_stiffness)
    dK = law_slope(law, i, u, LAW_COLUMNS.hertz_stiffness) * law.intervals_per_unit / s0
    loss = current_law(y, law, LAW_COLUMNS.loss_coefficient) / h
    half_length = current_law(y, law, LAW_COLUMNS.half_length)
    zt0 = y[STATE.roughness_heights]
    zr0 = y[STATE.roughness_heights + 1]
    gap0 = y[STATE.gap]
    r0 = approach_root(y[STATE.gap])
    U0 = 0.4 * r0**5
    # directions d (to the contact) and t (path) at mid-step; a = reach e3 - lever d, b = -(R/s) d
    p = plus(n, rotation_change(n, times(step_over_2J / 2, L)))
    p0, p1, p2 = p
    sp = np.sqrt(p0 * p0 + p1 * p1)
    d0 = p0 / sp
    d1 = p1 / sp
    reach = R * p2 - H * sp
    rim_lever = constants.radius / sp
    lever = reach * p2 / sp
    # initial estimate from the gap without heights, which is smoother than the force
    N = 0.0
    g = 0.0
    predicted_gap_change = (
        3 * (y[STATE.gap_changes] - y[STATE.gap_changes + 1]) + y[STATE.gap_changes + 2]
    )
    A = times(2, p)
    inverse_sine_sum = 0.5 / sp
    arm = R - H * sp / p2
    wd = (L0 * d0 + L1 * d1) * inverse_inertia + e * axial_momentum * sp
    dpath = h * (
        d0 * y[4]
        - d1 * y[3]
        + reach * (L2 * inverse_inertia + e * axial_momentum * p2)
        - lever * wd
    )
    dedge = -h * rim_lever * wd
    zt1 = zt0
    zr1 = zr0
    mt = 0.0
    mr = 0.0
    read_path = np.inf
    read_edge = np.inf
    iterations_left = MAX_ITERATIONS
    converged = False
    while not converged:
        if iterations_left == 0:
            return False
        iterations_left -= 1
        if (
            iterations_left >= MAX_ITERATIONS - max_height_evaluations
            and max(abs(dpath - read_path), abs(dedge - read_edge))
            > height_update_distance
        ):
            read_path = dpath
            read_edge = dedge
            zt1 = height_at_step_end(
                table, y[STATE.table_path], dpath, half_length, zt0
            )
            zr1 = height_at_step_end(rim, y[STATE.edge_path], dedge, half_length, zr0)
            mt = mean_slope(zt0, zt1, dpath)
            mr = mean_slope(zr0, zr1, dedge)
            if iterations_left == MAX_ITERATIONS - 1:
                dgap = predicted_gap_change - (zt1 - zt0) - (zr1 - zr0)
                r1 = approach_root(gap0 + dgap)
                N = max(
                    0.0, K0 * mean_force(r0, r1, gap0, gap0 + dgap) * (1 - loss * dgap)
                )
                g = (U0 + 0.4 * r1**5) / 2 * dK
        turn = (N * arm + g) * A[2] * inverse_sine_sum / 2
        roll = N * (mt * lever + mr * rim_lever)
        V, M = midpoint_velocities(y, constants, N, turn, roll, mt, A, reach, d0, d1, h)
        M0, M1, M2 = M
        q = rotation_change(n, times(step_over_2J, M))
        a = plus(n, q)
        a0, a1, a2 = a
        A = plus(n, a)
        s1 = np.sqrt(a0 * a0 + a1 * a1)
        inverse_sine_sum = 1 / (s0 + s1)
        arm = R - H * (s0 + s1) / (c0 + a2)
        ds = (A[0] * q[0] + A[1] * q[1]) * inverse_sine_sum
        mean = (
            e
            / 4
            * (
                axial_momentum
                + (2 * M0 - L0) * a0
                + (2 * M1 - L1) * a1
                + (2 * M2 - L2) * a2
            )
        )
        wd = (M0 * d0 + M1 * d1) * inverse_inertia + mean * (A[0] * d0 + A[1] * d1)
        dedge = -h * rim_lever * wd
        dpath = h * (
            d0 * V[1]
            - d1 * V[0]
            + reach * (M2 * inverse_inertia + mean * A[2])
            - lever * wd
        )
        i, u = law_interval(law, s1)
        K1 = law_column(law, i, u, LAW_COLUMNS.hertz_stiffness)
        dK1 = (
            law_slope(law, i, u, LAW_COLUMNS.hertz_stiffness)
            * law.intervals_per_unit
            / s1
        )
        dgap = h * V[2] - arm * ds - (zt1 - zt0) - (zr1 - zr0)
        r1 = approach_root(gap0 + dgap)
        elastic_force = (K0 + K1) / 2 * mean_force(r0, r1, gap0, gap0 + dgap)
        error = max(0.0, elastic_force * (1 - loss * dgap)) - N
        stiffness_slope = (
            (K1 - K0) / ds
            if abs(ds) > min_relative_sine_change * s0
            else (dK + dK1) / 2
        )
        previous_g = g
        g = (U0 + 0.4 * r1**5) / 2 * stiffness_slope
        W = 1 / m + (arm * A[2]) ** 2 / (4 * J)
        stiffness = K1 * (r0 / 2 + r1)
        correction = error / (
            1 + stiffness * (h * h / 4 * W) + h * h / 2 * loss * elastic_force * W
        )
        correction = max(correction, -N)
        mt = mean_slope(zt0, zt1, dpath)
        mr = mean_slope(zr0, zr1, dedge)
        torque_error = abs(g - previous_g) + abs(
            N * (mt * lever + mr * rim_lever) - roll
        )
        converged = max(abs(correction), torque_error / R) <= final_newton_tolerance * (
            N + weight
        )
        N += correction
    turn = (N * arm + g) * A[2] * inverse_sine_sum / 2
    roll = N * (mt * lever + mr * rim_lever)
    previous_V2 = V[2]
    V, M = midpoint_velocities(y, constants, N, turn, roll, mt, A, reach, d0, d1, h)
    change = M[0] - M0, M[1] - M1, M[2] - M2
    q = cross(times(step_over_2J, change), A)
    ds = (A[0] * q[0] + A[1] * q[1]) * inverse_sine_sum
    dgap += h * (V[2] - previous_V2) - arm * ds
    u += law.intervals_per_unit * ds / s1
    elastic_force = (
        (K0 + law_column(law, i, u, LAW_COLUMNS.hertz_stiffness))
        / 2
        * mean_force(r0, approach_root(gap0 + dgap), gap0, gap0 + dgap)
    )
    y[STATE.contact_loss] += (elastic_force - N) * dgap
    for k in range(3):
        y[STATE.position + k] += h * V[k]
        y[STATE.velocity + k] = 2 * V[k] - y[STATE.velocity + k]
        y[STATE.axis + k] = a[k] + q[k]
        y[STATE.angular_momentum + k] = 2 * M[k] - L[k]
    y[STATE.table_path] += dpath
    y[STATE.edge_path] += dedge
    y[STATE.gap_changes + 2] = y[STATE.gap_changes + 1]
    y[STATE.gap_changes + 1] = y[STATE.gap_changes]
    y[STATE.gap_changes] = dgap + (zt1 - zt0) + (zr1 - zr0)
    y[STATE.normal_force] = N
    y[STATE.path_speed] = abs(dpath) / h
    y[STATE.gap] = gap0 + dgap
    y[STATE.roughness_heights] = zt1
    y[STATE.roughness_heights + 1] = zr1
    y[STATE.sin_inclination] = s1 + ds
    y[STATE.law_interval] = i
    y[STATE.law_fraction] = u
    return True
