"""Modes of table and disk under the contact, and the search for the contact.

The table rises by W = sum q_m w_m(x, y), with shapes w_m of unit modal mass. Each mode
obeys q'' = -k q - c q' - N w~, where ~ denotes the mean of both ends of a step h. In
the midpoint rule, k and c are chosen such that frequency and decay are exact for every
step. The energy (q'^2 + k q^2)/2 changes by the work -N w~ dq minus h c q'~^2. The
modes of the disk, which lower the rim by q w, obey the same equation (see
rim_modes.py).
"""

from typing import NamedTuple

import numpy as np
from scipy.interpolate import make_interp_spline

from dynamics.compliant.law.height_profile import mean_rim_height
from dynamics.compliant.stepping.rim_modes import (
    NO_RIM_MODES,
    RimModes,
    evaluate_rim_ripple,
    rim_shapes,
    store_rim_shapes,
)
from dynamics.compliant.stepping.round_table import (
    RoundTable,
    round_deflection,
    round_table,
    store_round_shapes,
    store_round_slopes,
)
from dynamics.compliant.stepping.state_layout import STATE, STATE_SLICES, first_indices
from dynamics.numba_kernels import kernel

RIM_SCAN_POINTS = 48
"""Number of points in a scan of the whole rim for minima of the gap."""


class ContactLayout(NamedTuple):
    """First index of each quantity in `ContactModes.contact`."""

    angle: int
    """Direction from the centre to the contact [rad]."""
    steps_to_scan: int
    """Number of steps until the next scan of the rim."""
    gap_stiffness: int
    """Contact stiffness K [N/m^1.5]."""
    flat_steps: int
    """Number of steps for which the disk has been flat."""
    minimum_count: int
    """Number of minima of the gap."""
    twist_angle: int
    """Rotation of the disk about its axis [rad]."""
    minimum_angles: int
    """Directions of the minima of the gap [rad]; the last entries."""


CONTACT, _ = first_indices(ContactLayout)


class ContactModes(NamedTuple):
    """Shapes, constants and state of m modes: t of the table, then d of the disk.

    Attributes
    ----------
    coefficients : (a, b, t) array
        Spline coefficients of the shapes of the t table modes.
    knots_x, knots_y : arrays
        Knots of the splines [m].
    round_shapes : RoundTable
        Shapes of the modes of a round table, in place of the splines.
    place : (2,) array
        Position [m] in the frame of the shapes of the origin (`table_is_fixed` = 1) or
        of the centre of the disk (`table_is_fixed` = 0).
    table_is_fixed : float
        0 if the mode shapes move with the disk, like those of modes given by numbers;
        else 1.
    stiffness, damping : (m,) arrays
        Constants k [1/s^2] and c [1/s] of the modes.
    compliance : (m,) array
        1/(1 + h c/2 + h^2 k/4) for the step h.
    rim : (d, 6) array
        Fields of the `RimModes` of the disk.
    amplitude, velocity : (m,) arrays
        State of the modes.
    shape_before, shape_after : (m,) arrays
        Mode shapes at the contact at the start and at the end of the step.
    free_change : (m,) array
        Change of the amplitudes in a step without contact force.
    contact : array
        Data of the contact; see `ContactLayout`.
    """

    coefficients: np.ndarray
    knots_x: np.ndarray
    knots_y: np.ndarray
    round_shapes: RoundTable
    place: np.ndarray
    table_is_fixed: float
    stiffness: np.ndarray
    damping: np.ndarray
    compliance: np.ndarray
    rim: np.ndarray
    amplitude: np.ndarray
    velocity: np.ndarray
    shape_before: np.ndarray
    shape_after: np.ndarray
    free_change: np.ndarray
    contact: np.ndarray


def modes_at_rest(modes, h: float, body: RimModes) -> ContactModes:
    """Return table modes (`modal.SurfaceModes`) and disk modes at rest for steps h [s].

    Without table modes, there are no disk modes.
    """
    if modes is None or not len(modes.frequency):
        nothing = np.zeros(0)
        return _at_rest(
            np.zeros((0, 0, 0)),
            nothing,
            nothing,
            round_shapes=round_table(None),
            place=np.zeros(2),
            table_is_fixed=1.0,
            stiffness=nothing,
            damping=nothing,
            compliance=nothing,
            rim=np.column_stack(NO_RIM_MODES),
        )
    decay = np.append(modes.decay_rate, body.decay)
    squared = np.append((2 * np.pi * modes.frequency) ** 2, body.squared)
    pole = -decay + 1j * np.sqrt(squared - decay**2 + 0j)
    midpoint = 2 / h * np.tanh(pole * h / 2)
    k = np.abs(midpoint) ** 2
    c = -2 * midpoint.real
    # copies, because read-only arrays have a different Numba type
    return _at_rest(
        *(np.array(part, order="C") for part in (modes.coefficients, *modes.knots)),
        round_shapes=round_table(modes.round_shapes),
        place=np.array(modes.place, dtype=float),
        table_is_fixed=float(modes.mass > 0),  # modes given by numbers have no mass
        stiffness=k,
        damping=c,
        compliance=1 / (1 + h * c / 2 + h * h * k / 4),
        rim=np.column_stack(body),
    )


def _at_rest(coefficients, knots_x, knots_y, **constants):
    """Return `ContactModes` whose amplitudes and velocities are zero."""
    max_gap_minima = 4  # number of minima of the gap that are tracked
    m = len(constants["stiffness"])
    return ContactModes(
        coefficients,
        knots_x,
        knots_y,
        **constants,
        amplitude=np.zeros(m),
        velocity=np.zeros(m),
        shape_before=np.zeros(m),
        shape_after=np.zeros(m),
        free_change=np.zeros(m),
        contact=np.zeros(CONTACT.minimum_angles + max_gap_minima),
    )


def wavy_table(imperfection, y, constants) -> ContactModes:
    """Return a rigid wavy table as one constant mode; raise the disk onto it.

    The height is amplitude (r/R)^n cos(n theta), where R is the radius of the contact
    circle of a flat disk, and r is measured from the centre of the disk. The angle is
    measured from the crest under the initial contact. The disk is that of the state y.
    """
    n = imperfection.order
    R = constants.core_radius
    horizontal = y[STATE.axis : STATE.axis + 2]
    sine = np.hypot(*horizontal)
    a = horizontal / sine
    reach = R * y[STATE.axis + 2] - constants.core_depth * sine
    x = np.linspace(-constants.radius, constants.radius, 4 + 8 * n)
    height = (
        imperfection.amplitude
        * (((x[:, None] + 1j * x) * (a[0] - 1j * a[1]) / R) ** n).real
    )
    spline = make_interp_spline(x, make_interp_spline(x, height).c, axis=1)
    modes = _at_rest(
        np.ascontiguousarray(spline.c.T[:, :, None]),
        spline.t,
        spline.t,
        round_shapes=round_table(None),
        place=np.zeros(2),
        table_is_fixed=0.0,
        stiffness=np.zeros(1),
        damping=np.zeros(1),
        compliance=np.zeros(1),
        rim=np.column_stack(NO_RIM_MODES),
    )
    modes.amplitude[:] = 1.0
    modes.contact[CONTACT.angle] = np.arctan2(a[1], a[0])
    store_table_shapes(
        modes,
        *(reach * a),
        np.zeros((3, 4)),
        np.zeros((3, 4)),
        modes.shape_before,
    )
    y[2] += modes.shape_before[0]
    return modes


@kernel
def cubic_basis(knots, x, out):
    """Write four cubic B-splines at x and two derivatives to `out` (3, 4).

    Returns the index of the first spline.
    """
    n = knots.size - 4
    x = min(max(x, knots[3]), knots[n])
    i = min(max(int((x - knots[3]) / (knots[n] - knots[3]) * (n - 3)) + 3, 3), n - 1)
    while x < knots[i]:
        i -= 1
    while i < n - 1 and x >= knots[i + 1]:
        i += 1
    a = 1 / (knots[i + 1] - knots[i])
    b0 = 1 / (knots[i + 1] - knots[i - 1])
    b1 = 1 / (knots[i + 2] - knots[i])
    c0 = 1 / (knots[i + 1] - knots[i - 2])
    c1 = 1 / (knots[i + 2] - knots[i - 1])
    c2 = 1 / (knots[i + 3] - knots[i])
    l0 = (knots[i + 1] - x) * a
    l1 = (x - knots[i]) * a
    q0 = (knots[i + 1] - x) * b0 * l0
    q2 = (x - knots[i]) * b1 * l1
    q1 = 1 - q0 - q2
    out[0, 0] = (knots[i + 1] - x) * c0 * q0
    out[0, 3] = (x - knots[i]) * c2 * q2
    out[0, 1] = (x - knots[i - 2]) * c0 * q0 + (knots[i + 2] - x) * c1 * q1
    out[0, 2] = 1 - out[0, 0] - out[0, 1] - out[0, 3]
    out[1, 0] = -3 * c0 * q0
    out[1, 3] = 3 * c2 * q2
    out[1, 1] = 3 * (c0 * q0 - c1 * q1)
    out[1, 2] = 3 * (c1 * q1 - c2 * q2)
    d0 = -2 * b0 * l0
    d1 = 2 * (b0 * l0 - b1 * l1)
    d2 = 2 * b1 * l1
    out[2, 0] = -3 * c0 * d0
    out[2, 3] = 3 * c2 * d2
    out[2, 1] = 3 * (c0 * d0 - c1 * d1)
    out[2, 2] = 3 * (c1 * d1 - c2 * d2)
    return i - 3


@kernel
def store_table_shapes(modes, x, y, bx, by, shapes):
    """Store the table mode shapes at (x, y) [m] in `shapes`."""
    if modes.round_shapes.mode_index.size > 0:
        store_round_shapes(
            modes.round_shapes, x + modes.place[0], y + modes.place[1], shapes
        )
        return
    i = cubic_basis(modes.knots_x, x + modes.place[0], bx)
    j = cubic_basis(modes.knots_y, y + modes.place[1], by)
    count = modes.coefficients.shape[2]
    for m in range(count):
        shapes[m] = 0.0
    for a in range(4):
        for b in range(4):
            share = bx[0, a] * by[0, b]
            row = modes.coefficients[i + a, j + b]
            for m in range(count):
                shapes[m] += share * row[m]


@kernel
def store_table_slopes(modes, x, y, bx, by, slopes):
    """Store the slopes (2, t) of the table mode shapes along x and y at (x, y) [m]."""
    if modes.round_shapes.mode_index.size > 0:
        store_round_slopes(
            modes.round_shapes, x + modes.place[0], y + modes.place[1], slopes
        )
        return
    i = cubic_basis(modes.knots_x, x + modes.place[0], bx)
    j = cubic_basis(modes.knots_y, y + modes.place[1], by)
    slopes[:] = 0.0
    for a in range(4):
        for b in range(4):
            row = modes.coefficients[i + a, j + b]
            for m in range(row.size):
                slopes[0, m] += bx[1, a] * by[0, b] * row[m]
                slopes[1, m] += bx[0, a] * by[1, b] * row[m]


@kernel
def table_deflection(modes, x, y, bx, by, out):
    """Write W at (x, y), its gradient and its derivatives xx, xy, yy to `out` (6,).

    W is the deflection at the end of a step without contact force.
    """
    if modes.round_shapes.mode_index.size > 0:
        round_deflection(
            modes.round_shapes,
            modes.amplitude,
            modes.free_change,
            x + modes.place[0],
            y + modes.place[1],
            out,
        )
        return
    i = cubic_basis(modes.knots_x, x + modes.place[0], bx)
    j = cubic_basis(modes.knots_y, y + modes.place[1], by)
    out[:] = 0.0
    for a in range(4):
        for b in range(4):
            row = modes.coefficients[i + a, j + b]
            value = 0.0
            for m in range(row.size):
                value += row[m] * (modes.amplitude[m] + modes.free_change[m])
            out[0] += bx[0, a] * by[0, b] * value
            out[1] += bx[1, a] * by[0, b] * value
            out[2] += bx[0, a] * by[1, b] * value
            out[3] += bx[2, a] * by[0, b] * value
            out[4] += bx[1, a] * by[1, b] * value
            out[5] += bx[0, a] * by[2, b] * value


@kernel
def angle_between(before, after):
    """Return the signed angle [rad] from one direction to another, in [-pi, pi]."""
    return after - before - 2 * np.pi * np.rint((after - before) / (2 * np.pi))


@kernel
def evaluate_gap(modes, constants, centre, axis, angle, scratch):
    """Evaluate table and rim at an angle of a disk with an axis n and a centre (x, y).

    The deflection of the table and its derivatives are written to scratch[6], those of
    the rim to scratch[7]. Returns cosine and sine of the angle, the reach from the
    centre [m], and n.e.
    """
    x, y = centre
    n0, n1, n2 = axis
    c = np.cos(angle)
    s = np.sin(angle)
    down = n0 * c + n1 * s
    reach = constants.core_radius * n2 - down * constants.core_depth
    table_deflection(
        modes,
        x + reach * c,
        y + reach * s,
        scratch[0:3, 0:4],
        scratch[3:6, 0:4],
        scratch[6],
    )
    evaluate_rim_ripple(
        modes,
        angle - modes.contact[CONTACT.twist_angle],
        down,
        n2,
        scratch[7],
    )
    return c, s, reach, down


@kernel
def find_gap_minima(modes, constants, centre, axis, scratch):
    """Scan the whole rim for minima of the gap; store as many as there is space for.

    The scan begins at the contact, so that it is the same in all directions. A minimum
    near the contact is replaced by the contact.
    """
    # range of table heights along the rim, divided by R sin(beta), above which it is bent
    bent_table_ratio = 1e-3
    # angle [rad] from the contact below which a minimum of the gap is the contact itself
    same_contact_angle = 3 * np.pi / RIM_SCAN_POINTS
    level_scan_interval = 256  # steps between two scans on a nearly level table
    bent_scan_interval = 16  # steps between two scans on a bent table
    R = constants.core_radius
    max_count = len(modes.contact) - CONTACT.minimum_angles
    contact = modes.contact[CONTACT.angle]
    highest = -np.inf
    lowest = np.inf
    count = 0
    previous = 0.0
    current = 0.0
    for n in range(RIM_SCAN_POINTS + 2):
        _, _, _, down = evaluate_gap(
            modes,
            constants,
            centre,
            axis,
            contact + 2 * np.pi * n / RIM_SCAN_POINTS,
            scratch,
        )
        risen = scratch[6, 0] + scratch[7, 0]
        highest = max(highest, risen)
        lowest = min(lowest, risen)
        value = risen + R * down
        if n > 1 and current >= previous and current > value and count < max_count:
            turn = angle_between(0.0, 2 * np.pi * (n - 1) / RIM_SCAN_POINTS)
            is_other = abs(turn) > same_contact_angle
            modes.contact[CONTACT.minimum_angles + count] = (
                contact + turn if is_other else contact
            )
            count += 1
        previous = current
        current = value
    modes.contact[CONTACT.minimum_count] = count
    bends = highest - lowest > bent_table_ratio * R * np.sqrt(
        axis[0] * axis[0] + axis[1] * axis[1]
    )
    modes.contact[CONTACT.steps_to_scan] = (
        bent_scan_interval if bends else level_scan_interval
    )


@kernel
def track_contact(modes, constants, centre, axis, rough, scratch):
    """Find the contact of a disk with an axis n and a centre (x, y) on the table.

    One Newton step updates each minimum of the gap without heights; the lowest one with
    heights is the contact. It does not follow the minima of the rough gap: between them
    it would jump, and the dashpot would take each jump for an approach.
    While the disk is almost parallel to the table below it, the opposite side of the
    rim may become the lowest in any step, and the whole rim is scanned every time.
    `rough` contains the height profiles of table and edge, their path lengths [m] at
    the previous contact, and the half-length of the ellipse. The mode shapes at the
    contact are stored as `shape_after`. Returns the direction [rad], the sum of the
    heights of table and edge [m], and the path length from the previous contact [m].
    """
    # curvature of the gap along the rim, divided by that on a level table, below which the disk
    # is almost parallel to the table
    min_curvature_ratio = 0.5
    field = scratch[6]
    rim_field = scratch[7]
    R = constants.core_radius
    n0, n1, n2 = axis
    level_curvature = R * np.sqrt(n0 * n0 + n1 * n1)
    x = modes.table_is_fixed * centre[0]
    y = modes.table_is_fixed * centre[1]
    modes.contact[CONTACT.steps_to_scan] -= 1
    if modes.contact[CONTACT.steps_to_scan] < 0:
        find_gap_minima(modes, constants, (x, y), axis, scratch)
    last = modes.contact[CONTACT.angle]
    lowest_gap = -np.inf
    contact_angle = last
    for n in range(int(modes.contact[CONTACT.minimum_count])):
        angle = modes.contact[CONTACT.minimum_angles + n]
        c, s, reach, down = evaluate_gap(modes, constants, (x, y), axis, angle, scratch)
        down = R * down  # height and slope of the rim
        side = R * (n1 * c - n0 * s)
        slope = side + reach * (field[2] * c - field[1] * s) + rim_field[1]
        bend = reach**2 * (field[3] * s * s - 2 * field[4] * s * c + field[5] * c * c)
        bend += rim_field[2] - reach * (field[1] * c + field[2] * s)
        curvature = down - bend
        if curvature < min_curvature_ratio * level_curvature:
            modes.contact[CONTACT.steps_to_scan] = 0
        step = slope / max(curvature, 0.1 * level_curvature + 1e-300)
        step = min(max(step, -0.1), 0.1)
        modes.contact[CONTACT.minimum_angles + n] = angle + step
        height = mean_rim_height(
            rough, reach, constants.radius, angle_between(last, angle)
        )
        value = field[0] + rim_field[0] + height + down + step * slope / 2
        if value > lowest_gap:
            lowest_gap = value
            contact_angle = angle + step
    c = np.cos(contact_angle)
    s = np.sin(contact_angle)
    reach = R * n2 - (n0 * c + n1 * s) * constants.core_depth
    store_table_shapes(
        modes,
        x + reach * c,
        y + reach * s,
        scratch[0:3, 0:4],
        scratch[3:6, 0:4],
        modes.shape_after,
    )
    store_rim_shapes(
        modes.rim,
        contact_angle - modes.contact[CONTACT.twist_angle],
        n0 * c + n1 * s,
        n2,
        modes.shape_after,
    )
    turn = angle_between(last, contact_angle)
    return contact_angle, mean_rim_height(rough, reach, R, turn), reach * turn


@kernel
def predict_free_motion(modes, h):
    """Store the change of each amplitude in a step without contact force."""
    for m in range(len(modes.amplitude)):
        q = modes.amplitude[m]
        v = modes.velocity[m]
        modes.free_change[m] = (
            h * modes.compliance[m] * (v - h / 2 * modes.stiffness[m] * q)
        )


@kernel
def mode_work_sums(modes, h):
    """Return D, E, P, S in the mode sums sum w~ dq = D - E N and sum q~ dw = P - S N."""
    D = 0.0
    E = 0.0
    P = 0.0
    S = 0.0
    for m in range(len(modes.amplitude)):
        mean = (modes.shape_before[m] + modes.shape_after[m]) / 2
        change = modes.shape_after[m] - modes.shape_before[m]
        compliance = h * h / 2 * modes.compliance[m] * mean
        D += mean * modes.free_change[m]
        E += compliance * mean
        P += change * (modes.amplitude[m] + modes.free_change[m] / 2)
        S += change * compliance / 2
    return D, E, P, S


@kernel
def advance_modes(modes, N, h):
    """Advance the modes by a step h under the force N; return their energy losses.

    The losses are those of the table modes and of the disk modes.
    """
    lost = 0.0
    total = 0.0
    first = len(modes.amplitude) - len(modes.rim)
    for m in range(len(modes.amplitude)):
        mean = (modes.shape_before[m] + modes.shape_after[m]) / 2
        change = modes.free_change[m] - h * h / 2 * modes.compliance[m] * mean * N
        modes.amplitude[m] += change
        modes.velocity[m] = 2 * change / h - modes.velocity[m]
        modes.shape_before[m] = modes.shape_after[m]
        total += modes.damping[m] * change * change / h
        if m < first:
            lost = total
    return lost, total - lost


@kernel
def mode_energies(modes):
    """Return the energies of the table modes and of the disk modes [J]."""
    energy = 0.0
    total = 0.0
    first = len(modes.amplitude) - len(modes.rim)
    for m in range(len(modes.amplitude)):
        q = modes.amplitude[m]
        v = modes.velocity[m]
        total += (v * v + modes.stiffness[m] * q * q) / 2
        if m < first:
            energy = total
    return energy, total - energy


def set_steady_mode_response(contact_modes: ContactModes, modes, model, y) -> None:
    """Set the modes to their steady response to a steadily precessing contact force.

    Each mode is excited by the Fourier series of its shape around the rim, without free
    vibration.
    """
    if modes is None or not len(contact_modes.amplitude):
        return
    constants = model.constants
    n = y[STATE_SLICES.axis]
    s = np.hypot(n[0], n[1])
    start = np.arctan2(n[1], n[0])
    reach = constants.core_radius * n[2] - constants.core_depth * s
    axis_rate = (
        np.cross(y[STATE_SLICES.angular_momentum], n) / constants.diametral_inertia
    )
    turning = axis_rate[:2] @ np.array([-n[1], n[0]]) / s**2
    angle = start + 2 * np.pi * np.arange(RIM_SCAN_POINTS) / RIM_SCAN_POINTS
    centre = contact_modes.table_is_fixed * y[:2] + modes.place
    east, north = centre[:, None] + reach * np.array([np.cos(angle), np.sin(angle)])
    below = rim_shapes(model.disk_modes, angle, np.arctan2(s, n[2]))
    shapes = np.hstack([modes.at(east, north), below])
    rate = 1j * turning * np.fft.fftfreq(RIM_SCAN_POINTS, 1 / RIM_SCAN_POINTS)[:, None]
    k = contact_modes.stiffness
    c = contact_modes.damping
    responses = (
        -y[STATE.normal_force]
        * np.fft.fft(shapes, axis=0)
        / RIM_SCAN_POINTS
        / (k + c * rate + rate**2)
    )
    contact_modes.contact[CONTACT.angle] = start
    amplitude = responses.sum(axis=0).real
    contact_modes.amplitude[:] = amplitude
    contact_modes.velocity[:] = (rate * responses).sum(axis=0).real
    contact_modes.shape_before[:] = shapes[0]
    y[STATE.table_mode_energy], y[STATE.disk_mode_energy] = mode_energies(contact_modes)
    y[2] += amplitude @ shapes[0]
