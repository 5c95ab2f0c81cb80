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

from dynamics.compliant.law.height_profile import Profile, mean_height
from dynamics.compliant.law.tabulated import LAW_COLUMNS
from dynamics.compliant.stepping.contact_energy import (
    current_law,
    hertz_stiffness_slope,
    law_column,
    law_interval,
    mean_force,
    square_root_of_approach,
)
from dynamics.compliant.stepping.state_layout import (
    STATE,
    CompiledModel,
    LawCubics,
    ModelConstants,
)
from dynamics.numba_kernels import kernel
from dynamics.stepping_core.rotation import rotation_change
from dynamics.stepping_core.vectors import (
    AnyVector,
    Triple,
    cross,
    dot,
    plus,
    times,
    vector,
)

MAX_ITERATIONS = 40
"""Largest number of iterations for the normal force in one step."""


@kernel
def contact_moves(displacement: float) -> bool:
    """Return False if the contact is stationary in a step with this displacement [m]."""
    max_stationary_displacement = 1e-10
    return abs(displacement) > max_stationary_displacement


@kernel
def height_at_step_end(
    profile: Profile, path: float, moved: float, half: float, before: float
) -> float:
    """Return the height after a step, which is unchanged if the contact is stationary."""
    return mean_height(profile, path + moved, half) if contact_moves(moved) else before


@kernel
def mean_slope(y0: float, y1: float, dx: float) -> float:
    """Return the mean slope of heights along a path; 0 if the contact is stationary."""
    return (y1 - y0) / dx if contact_moves(dx) else 0.0


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
def contact_frame(constants: ModelConstants, axis: Triple) -> ContactFrame:
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


class StepStart(NamedTuple):
    """Disk and contact at the start of a step."""

    axis: tuple[float, float, float]
    momentum: tuple[float, float, float]
    """Angular momentum L [kg m^2/s]."""
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
    frame: ContactFrame
    """Directions of the contact at mid-step."""


@kernel
def step_start(y: np.ndarray, model: CompiledModel, h: float) -> StepStart:
    """Return the `StepStart` of a step h."""
    constants = model.constants
    law = model.law
    axis = vector(y, STATE.axis)
    momentum = vector(y, STATE.angular_momentum)
    quarter_turn = times(h / (2 * constants.diametral_inertia) / 2, momentum)
    sine = y[STATE.sin_inclination]
    root = square_root_of_approach(y[STATE.gap])
    return StepStart(
        axis,
        momentum,
        sine,
        axis[2],
        dot(momentum, axis),
        current_law(y, law, LAW_COLUMNS.hertz_stiffness),
        hertz_stiffness_slope(
            law, int(y[STATE.law_interval]), y[STATE.law_fraction], sine
        ),
        current_law(y, law, LAW_COLUMNS.loss_coefficient) / h,
        current_law(y, law, LAW_COLUMNS.half_length),
        y[STATE.roughness_heights],
        y[STATE.roughness_heights + 1],
        y[STATE.gap],
        root,
        0.4 * root**5,
        contact_frame(constants, plus(axis, rotation_change(axis, quarter_turn))),
    )


@kernel
def path_changes(
    frame: ContactFrame,
    constants: ModelConstants,
    velocity: AnyVector,
    momentum: AnyVector,
    spin_along: float,
    spin_up: float,
    h: float,
) -> tuple[float, float]:
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
def mean_spin(
    constants: ModelConstants,
    start: StepStart,
    mean_momentum: AnyVector,
    axis: AnyVector,
) -> float:
    """Return e/2 times the mean of L.n at both ends of a step; `axis` is that at its end."""
    momentum = start.momentum
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
def rolling_moment(
    frame: ContactFrame, N: float, table_slope: float, edge_slope: float
) -> float:
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
def midpoint_velocities(
    y: np.ndarray,
    constants: ModelConstants,
    frame: ContactFrame,
    load: ContactLoad,
    A: AnyVector,
    h: float,
) -> tuple[Triple, Triple]:
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


class StepEnd(NamedTuple):
    """Disk at the end of a step with a trial of the load."""

    velocity: tuple[float, float, float]
    """Velocity at mid-step [m/s]."""
    momentum: tuple[float, float, float]
    """Angular momentum at mid-step [kg m^2/s]."""
    axis: tuple[float, float, float]
    axis_sum: tuple[float, float, float]
    """Sum of the axes at both ends of the step."""
    sine: float
    """Sine s1 of the inclination, and its change from s0."""
    sine_change: float
    inverse_sine_sum: float
    """1/(s0 + s1)"""
    arm: float
    """Arm f of the normal force [m]."""
    path_change: float
    """Advance of the contact along the path and along the edge [m]."""
    edge_path_change: float


class HeightsAtEnd(NamedTuple):
    """Heights at the end of a step [m], and the advances [m] for which they were evaluated."""

    table_height: float
    edge_height: float
    path_change: float
    edge_path_change: float


class ContactEnd(NamedTuple):
    """Contact at the end of a step with a trial of the load."""

    law_interval: int
    """Interval of the tabulated law, and the position in it."""
    law_fraction: float
    stiffness: float
    """Stiffness K1 of the contact [N/m^1.5]."""
    gap_change: float
    """Change dG of the gap [m], and the root r1 of the approach at the end."""
    heights: HeightsAtEnd
    """Heights that the gap includes."""
    root: float
    elastic_force: float
    """Difference quotient -dU/dG [N]."""
    torque: float
    """Difference quotient g = dU/ds [N m]."""


@kernel
def end_without_load(
    y: np.ndarray, constants: ModelConstants, start: StepStart, h: float
) -> StepEnd:
    """Return the `StepEnd` with the axis of the frame and the velocities at the start.

    The sum of the axes and the sines are twice those of the frame at mid-step.
    """
    frame = start.frame
    axis = frame.axis
    velocity = vector(y, STATE.velocity)
    spin = constants.inverse_inertia_excess * start.axial_momentum
    path_change, edge_path_change = path_changes(
        frame,
        constants,
        velocity,
        start.momentum,
        spin * frame.sine,
        spin * axis[2],
        h,
    )
    return StepEnd(
        velocity,
        start.momentum,
        axis,
        times(2, axis),
        frame.sine,
        0.0,
        0.5 / frame.sine,
        constants.core_radius - constants.core_depth * frame.sine / axis[2],
        path_change,
        edge_path_change,
    )


@kernel
def end_under_load(
    y: np.ndarray,
    constants: ModelConstants,
    start: StepStart,
    load: ContactLoad,
    axis_sum: AnyVector,
    h: float,
) -> StepEnd:
    """Return the `StepEnd` under a `ContactLoad`; the sum of the axes is an estimate."""
    frame = start.frame
    V, M = midpoint_velocities(y, constants, frame, load, axis_sum, h)
    q = rotation_change(start.axis, times(h / (2 * constants.diametral_inertia), M))
    a = plus(start.axis, q)
    A = plus(start.axis, a)
    sine = np.sqrt(a[0] * a[0] + a[1] * a[1])
    inverse_sine_sum = 1 / (start.sine + sine)
    arm = constants.core_radius - constants.core_depth * (start.sine + sine) / (
        start.cosine + a[2]
    )
    spin = mean_spin(constants, start, M, a)
    path_change, edge_path_change = path_changes(
        frame,
        constants,
        V,
        M,
        spin * (A[0] * frame.d0 + A[1] * frame.d1),
        spin * A[2],
        h,
    )
    return StepEnd(
        V,
        M,
        a,
        A,
        sine,
        (A[0] * q[0] + A[1] * q[1]) * inverse_sine_sum,
        inverse_sine_sum,
        arm,
        path_change,
        edge_path_change,
    )


@kernel
def heights_at_end(
    y: np.ndarray, model: CompiledModel, start: StepStart, end: StepEnd
) -> HeightsAtEnd:
    """Return the `HeightsAtEnd` of a step."""
    return HeightsAtEnd(
        height_at_step_end(
            model.table,
            y[STATE.table_path],
            end.path_change,
            start.half_length,
            start.table_height,
        ),
        height_at_step_end(
            model.rim,
            y[STATE.edge_path],
            end.edge_path_change,
            start.half_length,
            start.edge_height,
        ),
        end.path_change,
        end.edge_path_change,
    )


@kernel
def contact_load(
    start: StepStart, end: StepEnd, heights: HeightsAtEnd, N: float, torque: float
) -> ContactLoad:
    """Return the `ContactLoad` of the normal force N and the torque g."""
    table_slope = mean_slope(start.table_height, heights.table_height, end.path_change)
    edge_slope = mean_slope(
        start.edge_height, heights.edge_height, end.edge_path_change
    )
    return ContactLoad(
        N,
        (N * end.arm + torque) * end.axis_sum[2] * end.inverse_sine_sum / 2,
        rolling_moment(start.frame, N, table_slope, edge_slope),
        table_slope,
    )


@kernel
def initial_force(
    y: np.ndarray, start: StepStart, heights: HeightsAtEnd
) -> tuple[float, float]:
    """Return estimates of the normal force N and the torque g.

    They follow from the gap without heights, which is smoother than the force.
    """
    dgap = (
        3 * (y[STATE.gap_change_and_part] - y[STATE.gap_change_and_part + 1])
        + y[STATE.gap_change_and_part + 2]
        - (heights.table_height - start.table_height)
        - (heights.edge_height - start.edge_height)
    )
    root = square_root_of_approach(start.gap + dgap)
    force = mean_force(start.root, root, start.gap, start.gap + dgap)
    N = max(0.0, start.stiffness * force * (1 - start.loss * dgap))
    return N, (start.energy + 0.4 * root**5) / 2 * start.stiffness_slope


@kernel
def mean_stiffness_slope(
    law: LawCubics,
    start: StepStart,
    end: StepEnd,
    contact_stiffness: float,
    interval: int,
    fraction: float,
) -> float:
    """Return the difference quotient of the stiffness by s, or the mean of dK/ds."""
    # Relative change of sin(beta) below which the mean of dK/ds replaces its
    # difference quotient
    min_relative_sine_change = 1e-4
    if abs(end.sine_change) > min_relative_sine_change * start.sine:
        return (contact_stiffness - start.stiffness) / end.sine_change
    end_slope = hertz_stiffness_slope(law, interval, fraction, end.sine)
    return (start.stiffness_slope + end_slope) / 2


@kernel
def contact_at_end(
    law: LawCubics, start: StepStart, end: StepEnd, heights: HeightsAtEnd, h: float
) -> ContactEnd:
    """Return the `ContactEnd` of a step h."""
    i, u = law_interval(law, end.sine)
    stiffness = law_column(law, i, u, LAW_COLUMNS.hertz_stiffness)
    dgap = (
        h * end.velocity[2]
        - end.arm * end.sine_change
        - (heights.table_height - start.table_height)
        - (heights.edge_height - start.edge_height)
    )
    root = square_root_of_approach(start.gap + dgap)
    elastic_force = (
        (start.stiffness + stiffness)
        / 2
        * mean_force(start.root, root, start.gap, start.gap + dgap)
    )
    slope = mean_stiffness_slope(law, start, end, stiffness, i, u)
    torque = (start.energy + 0.4 * root**5) / 2 * slope
    return ContactEnd(i, u, stiffness, dgap, heights, root, elastic_force, torque)


@kernel
def force_correction(
    constants: ModelConstants,
    start: StepStart,
    end: StepEnd,
    contact: ContactEnd,
    N: float,
    h: float,
) -> float:
    """Return the Newton correction of the normal force N [N]."""
    damped_force = contact.elastic_force * (1 - start.loss * contact.gap_change)
    error = max(0.0, damped_force) - N
    W = 1 / constants.mass + (end.arm * end.axis_sum[2]) ** 2 / (
        4 * constants.diametral_inertia
    )
    stiffness = contact.stiffness * (start.root / 2 + contact.root)
    correction = error / (
        1
        + stiffness * (h * h / 4 * W)
        + h * h / 2 * start.loss * contact.elastic_force * W
    )
    return max(correction, -N)


@kernel
def finish_step(
    y: np.ndarray,
    model: CompiledModel,
    start: StepStart,
    end: StepEnd,
    contact: ContactEnd,
    load: ContactLoad,
    h: float,
) -> None:
    """Write the state at the end of a step under the final `ContactLoad`.

    The change of the load since `end` changes velocities and axis to first order.
    """
    constants = model.constants
    law = model.law
    V, M = midpoint_velocities(y, constants, start.frame, load, end.axis_sum, h)
    M0, M1, M2 = end.momentum
    change = (M[0] - M0, M[1] - M1, M[2] - M2)
    q = cross(times(h / (2 * constants.diametral_inertia), change), end.axis_sum)
    ds = (end.axis_sum[0] * q[0] + end.axis_sum[1] * q[1]) * end.inverse_sine_sum
    dgap = contact.gap_change + (h * (V[2] - end.velocity[2]) - end.arm * ds)
    u = contact.law_fraction + law.intervals_per_unit * ds / end.sine
    K1 = law_column(law, contact.law_interval, u, LAW_COLUMNS.hertz_stiffness)
    root = square_root_of_approach(start.gap + dgap)
    elastic_force = (
        (start.stiffness + K1)
        / 2
        * mean_force(start.root, root, start.gap, start.gap + dgap)
    )
    y[STATE.contact_loss] += (elastic_force - load.N) * dgap
    for k in range(3):
        y[STATE.position + k] += h * V[k]
        y[STATE.velocity + k] = 2 * V[k] - y[STATE.velocity + k]
        y[STATE.axis + k] = end.axis[k] + q[k]
        y[STATE.angular_momentum + k] = 2 * M[k] - start.momentum[k]
    y[STATE.table_path] += end.path_change
    y[STATE.edge_path] += end.edge_path_change
    y[STATE.gap_change_and_part + 2] = y[STATE.gap_change_and_part + 1]
    y[STATE.gap_change_and_part + 1] = y[STATE.gap_change_and_part]
    y[STATE.gap_change_and_part] = (
        dgap
        + (contact.heights.table_height - start.table_height)
        + (contact.heights.edge_height - start.edge_height)
    )
    y[STATE.normal_force] = load.N
    y[STATE.path_speed] = abs(end.path_change) / h
    y[STATE.gap] = start.gap + dgap
    y[STATE.roughness_heights] = contact.heights.table_height
    y[STATE.roughness_heights + 1] = contact.heights.edge_height
    y[STATE.sin_inclination] = end.sine + ds
    y[STATE.law_interval] = contact.law_interval
    y[STATE.law_fraction] = u


@kernel
def step_normal(y: np.ndarray, model: CompiledModel, h: float) -> bool:
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
    constants = model.constants
    start = step_start(y, model, h)
    end = end_without_load(y, constants, start, h)
    heights = HeightsAtEnd(start.table_height, start.edge_height, np.inf, np.inf)
    N = 0.0
    torque = 0.0
    for iteration in range(MAX_ITERATIONS):
        moved = max(
            abs(end.path_change - heights.path_change),
            abs(end.edge_path_change - heights.edge_path_change),
        )
        if iteration < max_height_evaluations and moved > height_update_distance:
            heights = heights_at_end(y, model, start, end)
        if iteration == 0:
            N, torque = initial_force(y, start, heights)
        load = contact_load(start, end, heights, N, torque)
        end = end_under_load(y, constants, start, load, end.axis_sum, h)
        contact = contact_at_end(model.law, start, end, heights, h)
        next_load = contact_load(start, end, heights, N, torque)
        torque_error = abs(contact.torque - torque) + abs(next_load.roll - load.roll)
        torque = contact.torque
        correction = force_correction(constants, start, end, contact, N, h)
        error = max(abs(correction), torque_error / constants.core_radius)
        converged = error <= final_newton_tolerance * (N + constants.weight)
        N += correction
        if converged:
            load = contact_load(start, end, heights, N, torque)
            finish_step(y, model, start, end, contact, load, h)
            return True
    return False
