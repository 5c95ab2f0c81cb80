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

from typing import NamedTuple

import numpy as np

from dynamics.compliant.law.height_profile import mean_height
from dynamics.compliant.law.tabulated import LAW_COLUMNS
from dynamics.compliant.stepping.contact_energy import (
    current_law,
    law_column,
    law_interval,
    law_slope,
    mean_force,
    square_root_of_approach,
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


class StepStart(NamedTuple):
    """Contact at the start of a step."""

    sine: float
    """Sine s0 of the inclination; `cosine` is c0 = n_z."""
    cosine: float
    axial_momentum: float
    """Angular momentum L.n about the axis [kg m^2/s]."""
    stiffness: float
    """Stiffness K0 of the Hertz contact [N/m^1.5], and its derivative dK/ds."""
    stiffness_slope: float
    loss: float
    """Loss coefficient c, divided by the length of the step [1/m]."""
    half_length: float
    """Half the length of the contact, over which heights are averaged [m]."""
    table_height: float
    """Heights of table and edge at the contact [m]."""
    edge_height: float
    gap: float
    """Gap G [m], the root r0 of the approach and the energy over K, 2/5 (-G)^2.5."""
    root: float
    energy: float


@kernel
def step_start(y, law, axis, momentum, h):
    """Return the contact at the start of a step h."""
    sine = y[STATE.sin_inclination]
    slope = law_slope(
        law,
        int(y[STATE.law_interval]),
        y[STATE.law_fraction],
        LAW_COLUMNS.hertz_stiffness,
    )
    root = square_root_of_approach(y[STATE.gap])
    return StepStart(
        sine,
        axis[2],
        dot(momentum, axis),
        current_law(y, law, LAW_COLUMNS.hertz_stiffness),
        slope * law.intervals_per_unit / sine,
        current_law(y, law, LAW_COLUMNS.loss_coefficient) / h,
        current_law(y, law, LAW_COLUMNS.half_length),
        y[STATE.roughness_heights],
        y[STATE.roughness_heights + 1],
        y[STATE.gap],
        root,
        0.4 * root**5,
    )


class ContactFrame(NamedTuple):
    """Directions and levers of the contact at mid-step; a = reach e3 - lever d, b = -(R/s) d."""

    axis: tuple[float, float, float]
    sine: float
    d0: float
    """Direction d to the contact, d0 e1 + d1 e2."""
    d1: float
    reach: float
    rim_lever: float
    lever: float


@kernel
def contact_frame(constants, axis):
    """Return the frame of the contact of a disk with an `axis` (3,)."""
    R = constants.core_radius
    H = constants.core_depth
    p0, p1, p2 = axis
    sine = np.sqrt(p0 * p0 + p1 * p1)
    reach = R * p2 - H * sine
    return ContactFrame(
        axis,
        sine,
        p0 / sine,
        p1 / sine,
        reach,
        constants.radius / sine,
        reach * p2 / sine,
    )


@kernel
def path_changes(frame, constants, velocity, momentum, spin_along, spin_up, h):
    """Return the advance of the contact along the path and along the edge [m] in a step.

    `spin_along` and `spin_up` are the components of the spin e (L.n) n along d and up.
    """
    inverse_inertia = 1 / constants.diametral_inertia
    wd = (
        momentum[0] * frame.d0 + momentum[1] * frame.d1
    ) * inverse_inertia + spin_along
    dpath = h * (
        frame.d0 * velocity[1]
        - frame.d1 * velocity[0]
        + frame.reach * (momentum[2] * inverse_inertia + spin_up)
        - frame.lever * wd
    )
    return dpath, -h * frame.rim_lever * wd


@kernel
def mean_spin(constants, start, momentum, mean_momentum, axis):
    """Return e/2 times the mean of L.n at both ends of a step; `axis` is that at its end."""
    return (
        constants.inverse_inertia_excess
        / 4
        * (
            start.axial_momentum
            + (2 * mean_momentum[0] - momentum[0]) * axis[0]
            + (2 * mean_momentum[1] - momentum[1]) * axis[1]
            + (2 * mean_momentum[2] - momentum[2]) * axis[2]
        )
    )


@kernel
def rolling_moment(frame, N, table_slope, edge_slope):
    """Return the moment of the force N about d on slopes of table and edge."""
    return N * (table_slope * frame.lever + edge_slope * frame.rim_lever)


class ContactLoad(NamedTuple):
    """Load of the contact at mid-step."""

    N: float
    """Normal force [N]."""
    turn: float
    """Moment about the horizontal diameter, divided by the sum of the axes [N m]."""
    roll: float
    """Moment about the direction to the contact [N m]."""
    height_slope: float
    """Mean slope of the table."""


@kernel
def midpoint_velocities(y, constants, frame, load, A, h):
    """Return velocity and angular momentum at mid-step under a `ContactLoad`.

    A is the sum of the axes at both ends of the step.
    """
    N, turn, roll, height_slope = load
    step_over_2m = h / (2 * constants.mass)
    V = (
        y[3] + step_over_2m * N * height_slope * frame.d1,
        y[4] - step_over_2m * N * height_slope * frame.d0,
        y[5] + step_over_2m * (N - constants.weight),
    )
    M = (
        y[9] + h / 2 * (turn * A[1] + roll * frame.d0),
        y[10] + h / 2 * (roll * frame.d1 - turn * A[0]),
        y[11] - h / 2 * N * height_slope * frame.reach,
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
    J = constants.diametral_inertia
    R = constants.core_radius
    H = constants.core_depth
    step_over_2J = h / (2 * J)
    n = vector(y, STATE.axis)
    L = vector(y, STATE.angular_momentum)
    start = step_start(y, law, n, L, h)
    p = plus(n, rotation_change(n, times(step_over_2J / 2, L)))
    frame = contact_frame(constants, p)
    # initial estimate from the gap without heights, which is smoother than the force
    N = 0.0
    g = 0.0
    predicted_gap_change = (
        3 * (y[STATE.gap_changes] - y[STATE.gap_changes + 1]) + y[STATE.gap_changes + 2]
    )
    A = times(2, p)
    inverse_sine_sum = 0.5 / frame.sine
    arm = R - H * frame.sine / p[2]
    spin = constants.inverse_inertia_excess * start.axial_momentum
    dpath, dedge = path_changes(
        frame,
        constants,
        vector(y, STATE.velocity),
        L,
        spin * frame.sine,
        spin * p[2],
        h,
    )
    zt1 = start.table_height
    zr1 = start.edge_height
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
                table,
                y[STATE.table_path],
                dpath,
                start.half_length,
                start.table_height,
            )
            zr1 = height_at_step_end(
                rim, y[STATE.edge_path], dedge, start.half_length, start.edge_height
            )
            mt = mean_slope(start.table_height, zt1, dpath)
            mr = mean_slope(start.edge_height, zr1, dedge)
            if iterations_left == MAX_ITERATIONS - 1:
                dgap = (
                    predicted_gap_change
                    - (zt1 - start.table_height)
                    - (zr1 - start.edge_height)
                )
                r1 = square_root_of_approach(start.gap + dgap)
                force = mean_force(start.root, r1, start.gap, start.gap + dgap)
                N = max(0.0, start.stiffness * force * (1 - start.loss * dgap))
                g = (start.energy + 0.4 * r1**5) / 2 * start.stiffness_slope
        turn = (N * arm + g) * A[2] * inverse_sine_sum / 2
        roll = rolling_moment(frame, N, mt, mr)
        V, M = midpoint_velocities(
            y, constants, frame, ContactLoad(N, turn, roll, mt), A, h
        )
        mid_momentum = M
        q = rotation_change(n, times(step_over_2J, M))
        a = plus(n, q)
        A = plus(n, a)
        s1 = np.sqrt(a[0] * a[0] + a[1] * a[1])
        inverse_sine_sum = 1 / (start.sine + s1)
        arm = R - H * (start.sine + s1) / (start.cosine + a[2])
        ds = (A[0] * q[0] + A[1] * q[1]) * inverse_sine_sum
        spin = mean_spin(constants, start, L, M, a)
        dpath, dedge = path_changes(
            frame,
            constants,
            V,
            M,
            spin * (A[0] * frame.d0 + A[1] * frame.d1),
            spin * A[2],
            h,
        )
        i, u = law_interval(law, s1)
        K1 = law_column(law, i, u, LAW_COLUMNS.hertz_stiffness)
        dgap = (
            h * V[2] - arm * ds - (zt1 - start.table_height) - (zr1 - start.edge_height)
        )
        r1 = square_root_of_approach(start.gap + dgap)
        elastic_force = (
            (start.stiffness + K1)
            / 2
            * mean_force(start.root, r1, start.gap, start.gap + dgap)
        )
        error = max(0.0, elastic_force * (1 - start.loss * dgap)) - N
        if abs(ds) > min_relative_sine_change * start.sine:
            stiffness_slope = (K1 - start.stiffness) / ds
        else:
            slope = law_slope(law, i, u, LAW_COLUMNS.hertz_stiffness)
            end_slope = slope * law.intervals_per_unit / s1
            stiffness_slope = (start.stiffness_slope + end_slope) / 2
        previous_g = g
        g = (start.energy + 0.4 * r1**5) / 2 * stiffness_slope
        W = 1 / constants.mass + (arm * A[2]) ** 2 / (4 * J)
        stiffness = K1 * (start.root / 2 + r1)
        correction = error / (
            1 + stiffness * (h * h / 4 * W) + h * h / 2 * start.loss * elastic_force * W
        )
        correction = max(correction, -N)
        mt = mean_slope(start.table_height, zt1, dpath)
        mr = mean_slope(start.edge_height, zr1, dedge)
        torque_error = abs(g - previous_g) + abs(
            rolling_moment(frame, N, mt, mr) - roll
        )
        converged = max(abs(correction), torque_error / R) <= final_newton_tolerance * (
            N + constants.weight
        )
        N += correction
    turn = (N * arm + g) * A[2] * inverse_sine_sum / 2
    roll = rolling_moment(frame, N, mt, mr)
    previous_V2 = V[2]
    V, M = midpoint_velocities(
        y, constants, frame, ContactLoad(N, turn, roll, mt), A, h
    )
    change = (
        M[0] - mid_momentum[0],
        M[1] - mid_momentum[1],
        M[2] - mid_momentum[2],
    )
    q = cross(times(step_over_2J, change), A)
    ds = (A[0] * q[0] + A[1] * q[1]) * inverse_sine_sum
    dgap += h * (V[2] - previous_V2) - arm * ds
    u += law.intervals_per_unit * ds / s1
    elastic_force = (
        (start.stiffness + law_column(law, i, u, LAW_COLUMNS.hertz_stiffness))
        / 2
        * mean_force(
            start.root,
            square_root_of_approach(start.gap + dgap),
            start.gap,
            start.gap + dgap,
        )
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
    y[STATE.gap_changes] = dgap + (zt1 - start.table_height) + (zr1 - start.edge_height)
    y[STATE.normal_force] = N
    y[STATE.path_speed] = abs(dpath) / h
    y[STATE.gap] = start.gap + dgap
    y[STATE.roughness_heights] = zt1
    y[STATE.roughness_heights + 1] = zr1
    y[STATE.sin_inclination] = s1 + ds
    y[STATE.law_interval] = i
    y[STATE.law_fraction] = u
    return True
