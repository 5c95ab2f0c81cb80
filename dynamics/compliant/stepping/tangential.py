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

The air film (film/forces.py) opposes omega_3, and its pressure acts on the face and on the
table below it, against the velocity with which they separate. The pressure on a falling
disk is a force at its centre of pressure. In flight, the film has its present gap, and
its resistance to heave and tilt is that of two forces, at its centre of pressure and at
the low point of the rim; the latter vanishes where the gap closes. The compressed air
stores at most the energy of the film in the current state; the rest is dissipated. It
exerts no pressure when no energy is stored.

The modes of the table are loaded by forces at points instead of the pressure. With its
variance v, along one direction, a mode with the wave number k is loaded by the factor
exp(-k^2 v/2) too much; v is at most R^2/6, that of a level disk. The small moment of the
drag does not act on the modes, and the film does not act on the modes of the disk.
"""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.law.tabulated import LAW_COLUMNS
from dynamics.compliant.stepping.contact_energy import current_law
from dynamics.compliant.stepping.state_layout import (
    STATE,
    CompiledModel,
    LawCubics,
    ModelConstants,
)
from dynamics.compliant.stepping.table_modes import ContactModes
from dynamics.film.film_kernels import (
    compressed_air_impulse,
    film_capacity,
    film_loads,
    film_opening,
)
from dynamics.numba_kernels import kernel
from dynamics.stepping_core.resistance import (
    limited_arm_kernel,
    resistance_to,
    resisted_directions,
)
from dynamics.stepping_core.table_shapes import store_table_shapes
from dynamics.stepping_core.vectors import AnyVector, Triple, dot, vector


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
    sine: float
    """Sine of the inclination, above zero."""


class FilmPressure(NamedTuple):
    """Drag of the film, and forces that replace its pressure."""

    drag: float
    """Moment against the precession [N m], at the rate of a closed film with this gap."""
    low_resistance: float
    """Resistance to separation at the low point [kg/s]; 0 for a closed film."""
    resistance: float
    """Resistance to separation at the centre of pressure of a falling disk [kg/s]."""
    span: float
    """Distance of that centre from the low point [m]."""
    lift: float
    """Lift of the compressed air [N], and its distance from the low point [m]."""
    lift_place: float


class FilmLine(NamedTuple):
    """Diameter through the low point of the rim, on which the film presses on both faces."""

    place: PlaceOfContact
    span: float
    """Distance from the low point to the centre of pressure of a falling disk [m]."""


@kernel
def step_tangential(
    y: np.ndarray,
    model: CompiledModel,
    modes: "ContactModes | None",
    d0: float,
    d1: float,
    h: float,
) -> float:
    """Advance y by the tangential part of a step h at a contact in direction d.

    Returns the kinetic energy [J] that the film gives to the modes of the table.
    """
    constants = model.constants
    law = model.law
    m = constants.mass
    J = constants.diametral_inertia
    R = constants.core_radius
    H = constants.core_depth
    down = y[6] * d0 + y[7] * d1
    c = y[8]
    s = max(y[STATE.sin_inclination], 1e-9)
    reach = R - down * (R * down / (1 + c) + H)
    rise = R * down + H * c + constants.fillet
    place = PlaceOfContact(d0, d1, down, reach, rise, s)
    update_spring_stiffness(y, model.law)
    e = constants.inverse_inertia_excess
    apply_resisting_moments(y, model, place, h)
    if constants.has_spin_friction > 0:
        apply_spin_friction(y, model, place, h)
    given = 0.0
    if constants.film.turning > 0:
        given = apply_film_impulses(y, constants, modes, place, h)
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
    return given


@kernel
def update_spring_stiffness(y: np.ndarray, law: LawCubics) -> None:
    """Update the stiffness of the springs to the current inclination; see above."""
    for side in range(2):
        k = current_law(y, law, LAW_COLUMNS.stiffness_1 + side)
        q = y[STATE.spring_stretch + side]
        before = y[STATE.spring_stiffness + side]
        y[STATE.spring_stretch + side] = q * min(1.0, before / k)
        y[STATE.spring_stiffness + side] = k
        y[STATE.creep_loss] += (
            before * q * q - k * y[STATE.spring_stretch + side] ** 2
        ) / 2


@kernel
def apply_bowl_force(y: np.ndarray, constants: ModelConstants, h: float) -> None:
    """Advance the velocity under the restoring force of a concave table by a time h."""
    rate, east, north = constants.bowl
    if rate > 0:
        y[3] -= h * rate * (y[0] + east)
        y[4] -= h * rate * (y[1] + north)


@kernel
def contact_velocity(
    y: np.ndarray, constants: ModelConstants, place: PlaceOfContact
) -> tuple[float, float]:
    """Return the velocities of the disk at the contact along t and d."""
    d0, d1, down, reach, rise, _ = place
    J = constants.diametral_inertia
    momentum = vector(y, STATE.angular_momentum)
    spin = constants.inverse_inertia_excess * dot(momentum, vector(y, STATE.axis))
    wd = (y[9] * d0 + y[10] * d1) / J + spin * down
    wt = (y[10] * d0 - y[9] * d1) / J
    ut = y[4] * d0 - y[3] * d1 + reach * (y[11] / J + spin * y[8]) + rise * wd
    return ut, y[3] * d0 + y[4] * d1 - rise * wt


@kernel
def advance_springs(
    y: np.ndarray,
    constants: ModelConstants,
    velocity: tuple[float, float],
    mobility: tuple[float, float],
    lengths: tuple[float, float],
    h: float,
) -> tuple[float, float]:
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
def limit_stretch(
    qt: float, qd: float, kt: float, kd: float, limit: float
) -> tuple[float, float]:
    """Return the spring stretch, reduced so that the force is at most `limit`."""
    keep = min(1.0, limit / max(np.sqrt((kt * qt) ** 2 + (kd * qd) ** 2), 1e-300))
    return keep * qt, keep * qd


@kernel
def project_on_friction_circle(
    pt: float, pd: float, Ct: float, Cd: float, limit: float, trial_force: float
) -> tuple[float, float]:
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
def apply_resisting_moments(
    y: np.ndarray, model: CompiledModel, place: PlaceOfContact, h: float
) -> None:
    """Apply the resisting moments, power laws and viscous loads as impulses."""
    constants = model.constants
    powers = model.powers
    J = constants.diametral_inertia
    e = constants.inverse_inertia_excess
    loss = STATE.moment_loss
    arms = constants.arm_nutation, constants.arm_rolling, constants.arm_pivoting
    axes = resisted_directions(place.d0, place.d1)
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
        a = diameter_through_contact(y, place)
        s = place.sine
        rate = abs(dot(vector(y, STATE.angular_momentum), a)) / (J * s)
        growth = 1.0 if powers[i, 1] == 1 else rate ** (powers[i, 1] - 1)
        size = h * powers[i, 0] * growth / s
        apply_angular_impulse(y, a, size, 0.0, J, e, loss, constants.friction_is_fitted)


@kernel
def diameter_through_contact(y: np.ndarray, place: PlaceOfContact) -> Triple:
    """Return e_3, the upward unit vector along the diameter through the contact."""
    return -y[8] * place.d0, -y[8] * place.d1, place.sine


@kernel
def apply_spin_friction(
    y: np.ndarray, model: CompiledModel, place: PlaceOfContact, h: float
) -> None:
    """Apply the moment by which the contact ellipse resists pivoting as an impulse."""
    constants = model.constants
    law = model.law
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
def film_pressure(
    constants: ModelConstants, gap: float, eps: float, rate: float
) -> FilmPressure:
    """Return the `FilmPressure` at a precession rate [rad/s].

    `gap` is the mean gap over the radius, and `eps` the tilt over this gap.
    """
    drag, fall, lever, tip, lift = film_loads(constants.film, gap, rate)
    heave = 0.0
    if eps < 1.0:
        across, falling, levers, heaving = film_opening(eps)
        drag *= across
        heave = heaving * fall
        fall *= falling
        lever *= levers
    radius = constants.radius
    lever /= radius
    place = radius * tip / lift if lift > 0 else 0.0
    # the pressure of the compressed air vanishes with the square of the tilt
    lift *= eps * eps / radius
    return FilmPressure(
        drag, heave / radius**2, lever * lever * fall, 1 / lever, lift, place
    )


@kernel
def apply_film_impulses(
    y: np.ndarray,
    constants: ModelConstants,
    modes: "ContactModes | None",
    place: PlaceOfContact,
    h: float,
) -> float:
    """Apply drag, pressure of the fall and pressure of the compressed air as impulses.

    While the disk is in flight, they are those of the open film at its present gap. Returns
    the kinetic energy [J] given to the modes of the table.
    """
    J = constants.diametral_inertia
    s = place.sine
    gap = s + max(y[STATE.gap], 0.0) / constants.radius
    a = diameter_through_contact(y, place)
    # the offset avoids division by zero
    rate = dot(vector(y, STATE.angular_momentum), a) / (J * s) + 1e-30
    film = film_pressure(constants, gap, s / gap, rate)
    drag_per_rate = h * film.drag / (rate * gap)
    apply_angular_impulse(y, a, 0.0, drag_per_rate, J, 0.0, STATE.film_loss, 0.0)
    line = FilmLine(place, film.span)
    store_film_shapes(y, modes, line)
    given = 0.0
    if film.low_resistance > 0:
        given += resist_separation(
            y, constants, modes, line, 0.0, h * film.low_resistance
        )
    given += resist_separation(
        y, constants, modes, line, film.span, h * film.resistance
    )
    if film.lift > 0:
        given += press_compressed_air(
            y, constants, modes, line, film.lift_place, h * film.lift
        )
    stored_energy = min(
        y[STATE.squeezed_air_energy], film_capacity(constants.film, gap, rate)
    )
    y[STATE.film_loss] = (
        y[STATE.film_loss] + y[STATE.squeezed_air_energy] - stored_energy
    )
    y[STATE.squeezed_air_energy] = stored_energy
    return given


def film_forces_on_table(
    y: np.ndarray, constants: ModelConstants
) -> list[tuple[float, float]]:
    """Return the forces [N] of a closed film on a table at rest, and their distances from
    the low point of the rim [m]."""
    if constants.film.turning == 0:
        return []
    axis = vector(y, STATE.axis)
    s = float(np.hypot(axis[0], axis[1]))
    reach = constants.core_radius * axis[2] - constants.core_depth * s
    place = PlaceOfContact(axis[0] / s, axis[1] / s, s, reach, 0.0, s)
    a = diameter_through_contact(y, place)
    rate = dot(vector(y, STATE.angular_momentum), a) / (constants.diametral_inertia * s)
    film = film_pressure(constants, s, 1.0, rate)
    v, _ = face_velocity_and_mobility(y, constants, place, reach - film.span)
    return [(-film.resistance * v, film.span), (film.lift, film.lift_place)]


@kernel
def press_compressed_air(
    y: np.ndarray,
    constants: ModelConstants,
    modes: "ContactModes | None",
    line: FilmLine,
    offset: float,
    impulse: float,
) -> float:
    """Apply at most the given impulse of the compressed air at a point of both faces.

    The air does at most the work of its energy. Returns the kinetic energy [J] given to the
    modes of the table.
    """
    v, mobility = separation_and_mobility(y, constants, modes, line, offset)
    impulse, work = compressed_air_impulse(
        impulse, v, mobility, y[STATE.squeezed_air_energy]
    )
    y[STATE.squeezed_air_energy] = max(0.0, y[STATE.squeezed_air_energy] - work)
    return push_apart(y, constants, modes, line, offset, impulse)


@kernel
def resist_separation(
    y: np.ndarray,
    constants: ModelConstants,
    modes: "ContactModes | None",
    line: FilmLine,
    offset: float,
    resistance: float,
) -> float:
    """Resist the separation of both faces at a point; see `separation_and_mobility`.

    `resistance` [kg] is the impulse divided by the velocity, if it were constant. Returns
    the kinetic energy [J] given to the modes of the table.
    """
    v, mobility = separation_and_mobility(y, constants, modes, line, offset)
    impulse = v / mobility * np.expm1(-resistance * mobility)
    y[STATE.film_loss] -= impulse * (v + impulse * mobility / 2)
    return push_apart(y, constants, modes, line, offset, impulse)


@kernel
def store_film_shapes(
    y: np.ndarray, modes: "ContactModes | None", line: FilmLine
) -> None:
    """Store the shapes of the table modes below the centre of pressure as `film_shape`."""
    if modes is None:
        return
    arm = line.place.reach - line.span
    store_table_shapes(
        modes.table,
        modes.table.is_fixed * y[0] + arm * line.place.d0,
        modes.table.is_fixed * y[1] + arm * line.place.d1,
        np.zeros((3, 4)),
        np.zeros((3, 4)),
        modes.film_shape,
    )


@kernel
def table_shape(modes: ContactModes, m: int, share: float) -> float:
    """Return the shape of mode m of the table, linear between low point and centre of
    pressure; 0 for a mode that does not move.

    Along a line, a force is equivalent to its two parts at the ends of the line.
    """
    if modes.compliance[m] == 0:
        return 0.0
    return modes.shape_before[m] + share * (modes.film_shape[m] - modes.shape_before[m])


@kernel
def separation_and_mobility(
    y: np.ndarray,
    constants: ModelConstants,
    modes: "ContactModes | None",
    line: FilmLine,
    offset: float,
) -> tuple[float, float]:
    """Return the velocity [m/s] with which both faces separate at a point, and its mobility
    [1/kg].

    The point is at the distance `offset` [m] from the low point.
    """
    v, mobility = face_velocity_and_mobility(
        y, constants, line.place, line.place.reach - offset
    )
    if modes is None:
        return v, mobility
    for m in range(len(modes.amplitude) - len(modes.rim)):
        shape = table_shape(modes, m, offset / line.span)
        v -= shape * modes.velocity[m]
        mobility += shape * shape
    return v, mobility


@kernel
def push_apart(
    y: np.ndarray,
    constants: ModelConstants,
    modes: "ContactModes | None",
    line: FilmLine,
    offset: float,
    impulse: float,
) -> float:
    """Apply an impulse [N s] upwards to the face and downwards to the table; see
    `separation_and_mobility`.

    Returns the kinetic energy [J] given to the modes of the table.
    """
    push_face(y, constants, line.place, line.place.reach - offset, impulse)
    given = 0.0
    if modes is None:
        return given
    for m in range(len(modes.amplitude) - len(modes.rim)):
        change = -impulse * table_shape(modes, m, offset / line.span)
        given += change * (modes.velocity[m] + change / 2)
        modes.velocity[m] += change
    return given


@kernel
def face_velocity_and_mobility(
    y: np.ndarray, constants: ModelConstants, place: PlaceOfContact, arm: float
) -> tuple[float, float]:
    """Return the upward velocity of a point of the face, and its mobility [1/kg].

    The point is at the distance `arm` [m] from the centre towards the contact.
    """
    J = constants.diametral_inertia
    v = y[5] - arm * (y[10] * place.d0 - y[9] * place.d1) / J
    return v, 1 / constants.mass + arm * arm / J


@kernel
def push_face(
    y: np.ndarray,
    constants: ModelConstants,
    place: PlaceOfContact,
    arm: float,
    impulse: float,
) -> None:
    """Apply an upward impulse at a point of the face; see `face_velocity_and_mobility`."""
    y[5] += impulse / constants.mass
    y[9] += arm * impulse * place.d1
    y[10] -= arm * impulse * place.d0


@kernel
def apply_angular_impulse(
    y: np.ndarray,
    a: AnyVector,
    size: float,
    per_rate: float,
    J: float,
    e: float,
    cause: int,
    fitted: float,
) -> None:
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
    turn = -resistance_to(rate, size + per_rate * abs(rate), abs(rate) / mobility)
    for i in range(3):
        y[STATE.angular_momentum + i] += turn * a[i]
    y[cause] -= turn * (rate + turn * mobility / 2)
