"""Tangential part of a time step: creep, slip, resisting moments and air film.

The scheme conserves or dissipates energy. The midpoint rule for u' = -W p, q' = u - q
V/l, p = k q conserves kinetic energy + k q^2/2, except that creep dissipates k q~^2 V
h/l >= 0.

If p exceeds the friction limit, it is replaced by a force on the friction circle with C
p + y p = C p0, where p0 is the force without slip, C is positive and y >= 0. The slip 2
y p is parallel to p and dissipates 2 y p^2. At incipient slip the spring relaxes to the
force of dynamic friction. It sticks as soon as its stretch no longer increases. If k
increases, the force of a spring does not change; if k decreases, its stretch does not
change. Both reduce its energy.

The resisting moments are impulses against omega.a_i, at most those that stop the
rotation, so that they only dissipate kinetic energy. Friction fitted to a rough disk
includes the losses by contact and creep; the moments of rolling are therefore reduced
by this energy.

The air film (film/forces.py) opposes omega_3, and its pressure acts at the centre of
pressure of the face against the velocity there. The compressed air stores at most the
energy of the film in the current state; the rest is dissipated. It exerts no pressure
when no energy is stored.
"""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.law.tabulated import LAW_COLUMNS
from dynamics.compliant.stepping.contact_energy import current_law
from dynamics.compliant.stepping.state_layout import STATE
from dynamics.compliant.stepping.vectors import dot, vector
from dynamics.film.film_kernels import (
    compressed_air_impulse,
    film_capacity,
    film_loads,
)
from dynamics.numba_kernels import kernel
from dynamics.pivoting import friction_limited_arm

limited_arm_kernel = kernel(friction_limited_arm)


class PlaceOfContact(NamedTuple):
    """Place of the contact relative to the centre of the disk."""

    d0: float
    """Direction d to the contact, d0 e1 + d1 e2."""
    d1: float
    down: float
    """Component of the axis along d."""
    reach: float
    """Distance along d [m]."""
    rise: float
    """Depth below the centre [m]."""


@kernel
def step_tangential(y, constants, powers, law, h):
    """Advance y by the tangential part of a step h at the lowest point of the rim."""
    step_tangential_at(
        y,
        constants,
        powers,
        law,
        y[6] / y[STATE.sin_inclination],
        y[7] / y[STATE.sin_inclination],
        h,
    )


@kernel
def step_tangential_at(y, constants, powers, law, d0, d1, h):
    """Advance y by the tangential part of a step h at a contact in direction d."""
    m = constants.mass
    J = constants.diametral_inertia
    R = constants.core_radius
    H = constants.core_depth
    down = y[6] * d0 + y[7] * d1
    c = y[8]
    s = max(y[STATE.sin_inclination], 1e-9)
    reach = R - down * (R * down / (1 + c) + H)
    rise = R * down + H * c + constants.fillet
    place = PlaceOfContact(d0, d1, down, reach, rise)
    for side in range(2):
        k = current_law(y, law, LAW_COLUMNS.stiffness_1 + side)
        q = y[STATE.spring_stretch + side]
        before = y[STATE.spring_stiffness + side]
        y[STATE.spring_stretch + side] = q * min(1.0, before / k)
        y[STATE.spring_stiffness + side] = k
        y[STATE.creep_loss] += (
            before * q * q - k * y[STATE.spring_stretch + side] ** 2
        ) / 2
    e = constants.inverse_inertia_excess
    apply_resisting_moments(y, constants, powers, s, d0, d1, h)
    if constants.has_spin_friction > 0:
        apply_spin_friction(y, constants, law, place, h)
    if constants.film.turning > 0:
        apply_film_impulses(y, constants, s, d0, d1, reach, h)
    velocity = contact_velocity(y, constants, place)
    Wt = 1 / m + (reach * reach + rise * rise) / J + e * (reach * c + rise * down) ** 2
    Wd = 1 / m + rise * rise / J
    pt, pd = advance_springs(
        y,
        constants,
        velocity,
        (Wt, Wd),
        (
            current_law(y, law, LAW_COLUMNS.relaxation_length_1),
            current_law(y, law, LAW_COLUMNS.relaxation_length_2),
        ),
        h,
    )
    # the force -p acts at the position reach d - rise e3
    y[3] -= h / m * (pd * d0 - pt * d1)
    y[4] -= h / m * (pd * d1 + pt * d0)
    y[9] -= h * rise * (pt * d0 + pd * d1)
    y[10] -= h * rise * (pt * d1 - pd * d0)
    y[11] -= h * reach * pt
    y[STATE.tangential_force] = -pt
    y[STATE.tangential_force + 1] = -pd


@kernel
def apply_bowl_force(y, constants, h):
    """Advance the velocity under the restoring force of a concave table by a time h."""
    if constants.bowl_stiffness > 0:
        rate = constants.bowl_stiffness / constants.mass
        y[3] -= h * rate * (y[0] + constants.bowl_x)
        y[4] -= h * rate * (y[1] + constants.bowl_y)


@kernel
def contact_velocity(y, constants, place):
    """Return the velocities of the disk at the contact along t and d."""
    d0, d1, down, reach, rise = place
    J = constants.diametral_inertia
    momentum = vector(y, STATE.angular_momentum)
    spin = constants.inverse_inertia_excess * dot(momentum, vector(y, STATE.axis))
    wd = (y[9] * d0 + y[10] * d1) / J + spin * down
    wt = (y[10] * d0 - y[9] * d1) / J
    ut = y[4] * d0 - y[3] * d1 + reach * (y[11] / J + spin * y[8]) + rise * wd
    return ut, y[3] * d0 + y[4] * d1 - rise * wt


@kernel
def advance_springs(y, constants, velocity, mobility, lengths, h):
    """Advance the springs; return their mean forces on the contact point along t and d.

    Velocity, mobility and relaxation length of the contact are those along t and d.
    """
    ut, ud = velocity
    kt = y[STATE.spring_stiffness]
    kd = y[STATE.spring_stiffness + 1]
    N = y[STATE.normal_force]
    creep_t = h * y[STATE.path_speed] / lengths[0]
    creep_d = h * y[STATE.path_speed] / lengths[1]
    Ct = (1 + creep_t / 2) / kt + h * h / 4 * mobility[0]
    Cd = (1 + creep_d / 2) / kd + h * h / 4 * mobility[1]
    qt = y[STATE.spring_stretch]
    qd = y[STATE.spring_stretch + 1]
    limit = constants.mu_dynamic * N
    spring_energy_before = kt * qt * qt + kd * qd * qd
    pt = (qt + h / 2 * ut) / Ct
    pd = (qd + h / 2 * ud) / Cd
    trial_force = np.sqrt(pt * pt + pd * pd)
    slides = y[STATE.is_sliding] > 0
    if trial_force > (limit if slides else constants.mu_static * N):
        if not slides:
            qt, qd = limit_stretch(qt, qd, kt, kd, limit)
            pt = (qt + h / 2 * ut) / Ct
            pd = (qd + h / 2 * ud) / Cd
            trial_force = np.sqrt(pt * pt + pd * pd)
        if trial_force > limit:
            pt, pd = project_on_friction_circle(pt, pd, Ct, Cd, limit, trial_force)
        qt, qd = limit_stretch(2 * pt / kt - qt, 2 * pd / kd - qd, kt, kd, limit)
        slides = True
    else:
        slides = slides and pt * (pt / kt - qt) + pd * (pd / kd - qd) > 0
        qt = 2 * pt / kt - qt
        qd = 2 * pd / kd - qd
    if N > 0:
        y[STATE.is_sliding] = 1.0 if slides else 0.0
    y[STATE.spring_stretch] = qt
    y[STATE.spring_stretch + 1] = qd
    y[STATE.friction_excess] = max(
        y[STATE.friction_excess],
        np.sqrt(pt * pt + pd * pd) - (limit if slides else constants.mu_static * N),
    )
    creep = creep_t * pt * pt / kt + creep_d * pd * pd / kd
    work = h * (
        pt * (ut - h / 2 * mobility[0] * pt) + pd * (ud - h / 2 * mobility[1] * pd)
    )
    y[STATE.creep_loss] += creep
    y[STATE.slip_loss] += (
        work - (kt * qt * qt + kd * qd * qd - spring_energy_before) / 2 - creep
    )
    return pt, pd


@kernel
def limit_stretch(qt, qd, kt, kd, limit):
    """Return the spring stretch, reduced so that the force is at most `limit`."""
    keep = min(1.0, limit / max(np.sqrt((kt * qt) ** 2 + (kd * qd) ** 2), 1e-300))
    return keep * qt, keep * qd


@kernel
def project_on_friction_circle(pt, pd, Ct, Cd, limit, trial_force):
    """Return the force p with |p| = limit and C p + y p = C p0."""
    if limit == 0:
        return 0.0, 0.0
    y = (Ct + Cd) / 2 * (trial_force / limit - 1)
    for n in range(
        40
    ):  # Newton's method for 1/|p|, almost linear in y unless Ct and Cd differ by decades
        qt = Ct * pt / (Ct + y)
        qd = Cd * pd / (Cd + y)
        size = np.sqrt(qt * qt + qd * qd)
        if n >= 4 and abs(size - limit) <= 1e-9 * limit:
            break
        slope = (qt * qt / (Ct + y) + qd * qd / (Cd + y)) / size
        y = max(0.0, y + (size / limit - 1) * size / slope)
    return Ct * pt / (Ct + y), Cd * pd / (Cd + y)


@kernel
def apply_resisting_moments(y, constants, powers, s, d0, d1, h):
    """Apply the resisting moments, power laws (n, 2) and viscous loads as impulses."""
    J = constants.diametral_inertia
    e = constants.inverse_inertia_excess
    loss = STATE.moment_loss
    arms = constants.arm_nutation, constants.arm_rolling, constants.arm_pivoting
    axes = (-d1, d0, 0.0), (d0, d1, 0.0), (0.0, 0.0, 1.0)
    viscous = h * constants.viscous_moment
    for i in range(3):
        size = h * arms[i] * y[STATE.normal_force]
        fitted = 0.0 if i != 1 else constants.friction_is_fitted
        apply_angular_impulse(y, axes[i], size, viscous, J, e, loss, fitted)
    if constants.viscous_force > 0:
        left = max(0.0, 1 - h * constants.viscous_force / constants.mass)
        horizontal_energy = constants.mass / 2 * (y[3] * y[3] + y[4] * y[4])
        y[STATE.moment_loss] += horizontal_energy * (1 - left * left)
        y[3] = left * y[3]
        y[4] = left * y[4]
    for i in range(len(powers)):
        a = diameter_through_contact(y, s, d0, d1)
        rate = abs(dot(vector(y, STATE.angular_momentum), a)) / (J * s)
        growth = 1.0 if powers[i, 1] == 1 else rate ** (powers[i, 1] - 1)
        size = h * powers[i, 0] * growth / s
        apply_angular_impulse(y, a, size, 0.0, J, e, loss, constants.friction_is_fitted)


@kernel
def diameter_through_contact(y, s, d0, d1):
    """Return e_3, the upward unit vector along the diameter through the contact."""
    return -y[8] * d0, -y[8] * d1, s


@kernel
def apply_spin_friction(y, constants, law, place, h):
    """Apply the moment by which the contact ellipse resists pivoting as an impulse."""
    J = constants.diametral_inertia
    e = constants.inverse_inertia_excess
    spin = dot(vector(y, STATE.axis), vector(y, STATE.angular_momentum))
    pivoting = y[11] / J + e * y[8] * spin
    slides = y[STATE.is_sliding] > 0
    speed_square = y[STATE.path_speed] ** 2
    if slides:
        ut, ud = contact_velocity(y, constants, place)
        speed_square = ut * ut + ud * ud
    arm = limited_arm_kernel(
        current_law(y, law, LAW_COLUMNS.slip_arm),
        current_law(y, law, LAW_COLUMNS.creep_moment),
        abs(pivoting),
        speed_square,
        slides,
        constants.mu_dynamic,
    )
    size = h * arm * y[STATE.normal_force]
    upward = (0.0, 0.0, 1.0)
    apply_angular_impulse(y, upward, size, 0.0, J, e, STATE.moment_loss, 0.0)


@kernel
def apply_film_impulses(y, constants, s, d0, d1, reach, h):
    """Apply drag, pressure of the fall and pressure of the compressed air as impulses."""
    J = constants.diametral_inertia
    a = diameter_through_contact(y, s, d0, d1)
    # the offset avoids division by zero
    rate = dot(vector(y, STATE.angular_momentum), a) / (J * s) + 1e-30
    drag, fall, lever, tip, lift = film_loads(constants.film, s, rate)
    drag_per_rate = h * drag / (rate * s)
    apply_angular_impulse(y, a, 0.0, drag_per_rate, J, 0.0, STATE.film_loss, 0.0)
    lever /= constants.radius
    arm = reach - 1 / lever
    v, mobility = face_velocity_and_mobility(y, constants, arm, d0, d1)
    fall_impulse = v / mobility * np.expm1(-h * lever * lever * fall * mobility)
    y[STATE.film_loss] -= fall_impulse * (v + fall_impulse * mobility / 2)
    push_face(y, constants, arm, fall_impulse, d0, d1)
    lift_impulse = h * lift / constants.radius
    if lift_impulse > 0:
        arm = reach - constants.radius * tip / lift
        v, mobility = face_velocity_and_mobility(y, constants, arm, d0, d1)
        lift_impulse, work = compressed_air_impulse(
            lift_impulse, v, mobility, y[STATE.squeezed_air_energy]
        )
        y[STATE.squeezed_air_energy] = max(0.0, y[STATE.squeezed_air_energy] - work)
        push_face(y, constants, arm, lift_impulse, d0, d1)
    capacity = film_capacity(constants.film, s, rate)
    stored_energy = min(y[STATE.squeezed_air_energy], capacity)
    y[STATE.film_loss] = (
        y[STATE.film_loss] + y[STATE.squeezed_air_energy] - stored_energy
    )
    y[STATE.squeezed_air_energy] = stored_energy
    y[STATE.film_lift] = (fall_impulse + lift_impulse) / h


@kernel
def face_velocity_and_mobility(y, constants, arm, d0, d1):
    """Return the upward velocity of a point of the face, and its mobility [1/kg].

    The point is at the distance `arm` [m] from the centre in direction d.
    """
    J = constants.diametral_inertia
    v = y[5] - arm * (y[10] * d0 - y[9] * d1) / J
    return v, 1 / constants.mass + arm * arm / J


@kernel
def push_face(y, constants, arm, impulse, d0, d1):
    """Apply an upward impulse at a point of the face; see `face_velocity_and_mobility`."""
    y[5] += impulse / constants.mass
    y[9] += arm * impulse * d1
    y[10] -= arm * impulse * d0


@kernel
def apply_angular_impulse(y, a, size, per_rate, J, e, cause, fitted):
    """Apply an angular impulse along the unit vector a that at most stops the rotation.

    The impulse is `size` + `per_rate` times the rate. With `fitted` = 1 it is reduced
    by the energy that contact and creep have dissipated. `cause` is the index of the
    loss in the state.
    """
    if size == 0 and per_rate == 0:
        return
    axis = vector(y, STATE.axis)
    momentum = vector(y, STATE.angular_momentum)
    n = dot(a, axis)
    rate = dot(a, momentum) / J + e * n * dot(axis, momentum)
    mobility = 1 / J + e * n * n
    available_relief = (
        fitted * (y[STATE.contact_loss] + y[STATE.creep_loss])
        - y[STATE.relieved_friction_energy]
    )
    if fitted > 0 and available_relief > 0 and rate != 0:
        relief = min(size, available_relief / abs(rate))
        y[STATE.relieved_friction_energy] += relief * abs(rate)
        size -= relief
    turn = -np.sign(rate) * min(size + per_rate * abs(rate), abs(rate) / mobility)
    for i in range(3):
        y[STATE.angular_momentum + i] += turn * a[i]
    y[cause] -= turn * (rate + turn * mobility / 2)
