"""Modes of table and disk under the contact, and the search for the contact.

The table rises by W = sum q_m w_m(x, y), with shapes w_m of unit modal mass. Each mode
obeys q'' = -k q - c q' - N w~, where ~ denotes the mean of both ends of a step h. In
the midpoint rule, k and c are chosen such that frequency and decay are exact for every
step. The energy (q'^2 + k q^2)/2 changes by the work -N w~ dq minus h c q'~^2. The
modes of the disk, which lower the rim by q w, obey the same equation (see
rim_modes.py).
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.interpolate import make_interp_spline

from dynamics.compliant.law.height_profile import Profile, mean_rim_height
from dynamics.compliant.stepping.state_layout import STATE, STATE_SLICES, ModelConstants
from dynamics.numba_kernels import cached, kernel
from dynamics.stepping_core.layout import first_indices
from dynamics.stepping_core.oscillators import MidpointModes, midpoint_modes
from dynamics.stepping_core.rim_modes import (
    NO_RIM_MODES,
    RimModes,
    evaluate_rim_ripple,
    rim_shapes,
    store_rim_shapes,
)
from dynamics.stepping_core.table_shapes import (
    TableShapes,
    spline_shapes,
    store_table_shapes,
    table_deflection,
    table_shapes,
)

if TYPE_CHECKING:
    from dynamics.compliant.law.sections import Imperfection
    from dynamics.stepping_core.vectors import AnyVector

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
    table : TableShapes
        Shapes of the t table modes.
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
    film_shape : (m,) array
        Shapes of the table modes below the centre of pressure of the film; 0 for the disk.
    free_change : (m,) array
        Change of the amplitudes in a step without contact force.
    contact : array
        Data of the contact; see `ContactLayout`.
    scratch : (8, 6) array
        Work array.
    """

    table: TableShapes
    stiffness: np.ndarray
    damping: np.ndarray
    compliance: np.ndarray
    rim: np.ndarray
    amplitude: np.ndarray
    velocity: np.ndarray
    shape_before: np.ndarray
    shape_after: np.ndarray
    film_shape: np.ndarray
    free_change: np.ndarray
    contact: np.ndarray
    scratch: np.ndarray


def modes_at_rest(modes: Any, h: float, body: RimModes) -> ContactModes:
    """Return table modes (`modal.SurfaceModes`) and disk modes at rest for steps h [s]."""
    decay = np.append(modes.decay_rate, body.decay)
    squared = np.append((2 * np.pi * modes.frequency) ** 2, body.squared)
    return _at_rest(table_shapes(modes), midpoint_modes(squared, decay, h), body)


def _at_rest(table: TableShapes, modes: MidpointModes, body: RimModes) -> ContactModes:
    """Return `ContactModes` whose amplitudes and velocities are zero."""
    max_gap_minima = 4  # number of minima of the gap that are tracked
    m = len(modes.stiffness)
    return ContactModes(
        table,
        *modes,
        rim=np.column_stack(body),
        amplitude=np.zeros(m),
        velocity=np.zeros(m),
        shape_before=np.zeros(m),
        shape_after=np.zeros(m),
        film_shape=np.zeros(m),
        free_change=np.zeros(m),
        contact=np.zeros(CONTACT.minimum_angles + max_gap_minima),
        scratch=np.zeros((8, 6)),
    )


def wavy_table(
    imperfection: "Imperfection", y: np.ndarray, constants: ModelConstants
) -> ContactModes:
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
    shapes = spline_shapes(
        np.ascontiguousarray(spline.c.T[:, :, None]), spline.t, is_fixed=0.0
    )
    constant = MidpointModes(np.zeros(1), np.zeros(1), np.zeros(1))
    modes = _at_rest(shapes, constant, NO_RIM_MODES)
    modes.amplitude[:] = 1.0
    modes.contact[CONTACT.angle] = np.arctan2(a[1], a[0])
    store_table_shapes(
        modes.table,
        *(reach * a),
        np.zeros((3, 4)),
        np.zeros((3, 4)),
        modes.shape_before,
    )
    y[2] += modes.shape_before[0]
    return modes


@kernel
def angle_between(before: float, after: float) -> float:
    """Return the signed angle [rad] from one direction to another, in [-pi, pi]."""
    return after - before - 2 * np.pi * np.rint((after - before) / (2 * np.pi))


@kernel
def evaluate_gap(
    modes: ContactModes,
    constants: ModelConstants,
    centre: tuple[float, float],
    axis: "AnyVector",
    angle: float,
) -> tuple[float, float, float, float]:
    """Evaluate table and rim at an angle of a disk with an axis n and a centre (x, y).

    The deflection of the table and its derivatives are written to modes.scratch[6], those
    of the rim to modes.scratch[7]. Returns cosine and sine of the angle, the reach from the
    centre [m], and n.e.
    """
    scratch = modes.scratch
    x, y = centre
    n0, n1, n2 = axis
    c = np.cos(angle)
    s = np.sin(angle)
    down = n0 * c + n1 * s
    reach = constants.core_radius * n2 - down * constants.core_depth
    table_deflection(
        modes.table,
        modes.amplitude,
        modes.free_change,
        x + reach * c,
        y + reach * s,
        (scratch[0:3, 0:4], scratch[3:6, 0:4]),
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
def find_gap_minima(
    modes: ContactModes,
    constants: ModelConstants,
    centre: tuple[float, float],
    axis: "AnyVector",
) -> None:
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
        )
        risen = modes.scratch[6, 0] + modes.scratch[7, 0]
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
def track_contact(
    modes: ContactModes,
    constants: ModelConstants,
    centre: tuple[float, float],
    axis: "AnyVector",
    rough: tuple[Profile, Profile, float, float, float],
) -> tuple[float, float, float]:
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
    scratch = modes.scratch
    field = scratch[6]
    rim_field = scratch[7]
    R = constants.core_radius
    n0, n1, n2 = axis
    level_curvature = R * np.sqrt(n0 * n0 + n1 * n1)
    x = modes.table.is_fixed * centre[0]
    y = modes.table.is_fixed * centre[1]
    modes.contact[CONTACT.steps_to_scan] -= 1
    if modes.contact[CONTACT.steps_to_scan] < 0:
        find_gap_minima(modes, constants, (x, y), axis)
    last = modes.contact[CONTACT.angle]
    lowest_gap = -np.inf
    contact_angle = last
    for n in range(int(modes.contact[CONTACT.minimum_count])):
        angle = modes.contact[CONTACT.minimum_angles + n]
        c, s, reach, down = evaluate_gap(modes, constants, (x, y), axis, angle)
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
        modes.table,
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
def predict_free_motion(modes: ContactModes, h: float) -> None:
    """Store the change of each amplitude in a step without contact force."""
    for m in range(len(modes.amplitude)):
        q = modes.amplitude[m]
        v = modes.velocity[m]
        modes.free_change[m] = (
            h * modes.compliance[m] * (v - h / 2 * modes.stiffness[m] * q)
        )


@kernel
def mode_work_sums(modes: ContactModes, h: float) -> tuple[float, float, float, float]:
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
def advance_modes(modes: ContactModes, N: float, h: float) -> tuple[float, float]:
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


@cached
def mode_energies(modes: ContactModes) -> tuple[float, float]:
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


@kernel
def table_rise(modes: ContactModes) -> float:
    """Return the upward velocity [m/s] of the modes of the table below the contact."""
    rise = 0.0
    for m in range(len(modes.amplitude) - len(modes.rim)):
        if modes.compliance[m] > 0:  # else it does not move
            rise += modes.shape_before[m] * modes.velocity[m]
    return rise


def set_steady_mode_response(
    contact_modes: ContactModes,
    modes: Any,
    model: Any,
    y: np.ndarray,
    film_forces: Sequence[tuple[float, float]] = (),
) -> None:
    """Set the modes to their steady response to steadily precessing forces.

    They are the contact force and those of the film on the table [N], each with its distance
    from the low point [m]. Each mode is excited by the Fourier series of its shape along a
    circle, without free vibration.
    """
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
    centre = contact_modes.table.is_fixed * y[:2] + modes.place
    direction = np.array([np.cos(angle), np.sin(angle)])
    east, north = centre[:, None] + reach * direction
    below = rim_shapes(model.disk_modes, angle, np.arctan2(s, n[2]))
    shapes = np.hstack([modes.at(east, north), below])
    rate = 1j * turning * np.fft.fftfreq(RIM_SCAN_POINTS, 1 / RIM_SCAN_POINTS)[:, None]
    k = contact_modes.stiffness
    c = contact_modes.damping
    dynamic_stiffness = k + c * rate + rate**2
    responses = -y[STATE.normal_force] * np.fft.fft(shapes, axis=0)
    table = slice(len(modes.frequency))
    for force, offset in film_forces:
        east, north = centre[:, None] + (reach - offset) * direction
        responses[:, table] -= force * np.fft.fft(modes.at(east, north), axis=0)
    responses = responses / RIM_SCAN_POINTS / dynamic_stiffness
    contact_modes.contact[CONTACT.angle] = start
    amplitude = responses.sum(axis=0).real
    contact_modes.amplitude[:] = amplitude
    contact_modes.velocity[:] = (rate * responses).sum(axis=0).real
    contact_modes.shape_before[:] = shapes[0]
    y[STATE.table_mode_energy], y[STATE.disk_mode_energy] = mode_energies(contact_modes)
    y[2] += amplitude @ shapes[0]
