"""Time steps of a disk with contact springs along its whole rim.

A step consists of free flight for half its duration, the impulse of the contacts, and
free flight for the other half. The flight is exact: the centre falls, the disk rotates
as a symmetric top, and its modes vibrate freely. Springs act at points along the rim.
The force of each is linear in its depth, and the sum is Hertz's force of the smooth
contact. Adjacent points in contact form a patch. A dashpot acts on the depth-weighted
mean approach speed of a patch, because dashpots at single points would resist rolling.

High above the table, all steps except the last one before the next sample are merged
into one.

A table with modes rises under the rim by W(x, y) = sum q_m w_m(x, y). The contact force is
the gradient of the elastic energy with respect to all coordinates of the gap: a force N
drives the modes by -N w_m and pushes the rim by (-N dW/dx, -N dW/dy, N). Between contacts
the modes vibrate freely and are advanced exactly, like those of the disk, but in one flight
from one evaluation of the table to the next. W is evaluated at nodes around the rim and
interpolated linearly. Waves above the highest mode are neglected.
"""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.stepping.round_table import RoundTable
from dynamics.compliant.stepping.state_layout import Pair, Vector, first_indices
from dynamics.compliant.stepping.table_modes import (
    store_table_shapes,
    store_table_slopes,
)
from dynamics.film.film_kernels import film_capacity
from dynamics.film.wedge import Film
from dynamics.numba_kernels import kernel, outermost
from dynamics.pivoting import (
    PIVOTING_COEFFICIENT_COUNT,
    SINE_ROOT_DEGREE,
    friction_limited_arm,
)
from dynamics.rattling.film_force import film_pressure, point_on_face

limited_arm_kernel = kernel(friction_limited_arm)

CENTRE, VELOCITY, AXIS, RIM_REFERENCE_VECTOR, MOMENTUM = range(5)
"""Rows of the state (5, 3) of the disk: position [m] and velocity [m/s] of the centre, unit
vectors along the upward axis and towards the point of the rim at angle zero, and angular
momentum about the centre [kg m^2/s]."""


class RecordLayout(NamedTuple):
    """First index of each quantity in the record, an array (RECORD_SIZE,)."""

    impulse: Vector
    """Impulse of the contact force since the start along x, y, z [N s]."""
    contact_loss: int
    """Energy lost to the dashpots since the start [J]. The fields to `disk_mode_loss` are in
    the order of CAUSES."""
    creep_loss: int
    """Zero, because creep is a part of the slip."""
    slip_loss: int
    """Energy lost to friction [J]."""
    moment_loss: int
    """Energy lost to the resisting moment [J]."""
    table_mode_loss: int
    """Energy lost by the damping of the table modes [J]."""
    film_loss: int
    """Energy lost to the air film [J]."""
    disk_mode_loss: int
    """Energy lost by the damping of the disk modes [J]."""
    spring_energy: int
    """Elastic energy of the springs [J]."""
    compressed_air_energy: int
    """Energy of the compressed air in the film [J]."""
    film_impulse: int
    """Vertical impulse of the film pressure since the start [N s]."""
    friction_impulse: Pair
    """Horizontal impulse of the friction since the start [N s]."""
    open_time: int
    """Time without contact since the start [s]."""
    flight_start: int
    """Time at which the contact was last lost [s]; negative while there is contact."""
    max_flight_height: int
    """Largest height of the lowest rim point above the table since the loss of contact [m]."""
    flight_film_impulse: int
    """Impulse of the film pressure since the loss of contact [N s]."""


RECORD, RECORD_SIZE = first_indices(RecordLayout)
ENERGY_LOSSES = slice(RECORD.contact_loss, RECORD.disk_mode_loss + 1)
"""Energies lost to each of CAUSES in the record [J]."""
ELASTIC, DASHPOT, FRICTION, RESISTANCE, FILM = range(5)
"""Rows of the forces and torques of springs, dashpots, friction, resisting moment and air film."""
BLOCK_SIZE = 32
"""Number of adjacent points of the rim that share an upper bound of their heights."""
CONTINUES, LIES_FLAT, STANDS_UPRIGHT, LIFTS_OFF, IS_AIRBORNE = range(5)
"""Reasons for ending the time steps."""


class RattlingDisk(NamedTuple):
    """Constants of the disk and of its contact in SI units.

    Attributes
    ----------
    radius, half_thickness, mass : float
        Size [m] and mass [kg].
    diametral_inertia, axial_inertia : float
        Moments of inertia about a diameter and about the axis [kg m^2].
    modulus, shear_modulus : float
        Modulus E* of the contact and shear modulus of its creep [Pa].
    fillet : float
        Radius of the rounded edge [m].
    damping_ratio : float
        Damping ratio of a rigid disk on a patch; see `restitution_of_patch`.
    friction : float
        Coefficient of sliding friction.
    contour_moment : float
        Moment that resists the rolling of the contact under the weight [N m].
    bowl : tuple of float, length 3
        Restoring acceleration of a concave table divided by the distance from its
        middle [1/s^2], and position of the origin relative to its middle [m].
    spin_friction : tuple of float, length 15
        First 1 if slip and creep in the contact resist pivoting, else 0; then the
        coefficients of `pivoting_arm` in units of the radius.
    arms : tuple of float, length 3
        Moments that resist the rotations about a_1, a_2 and the vertical, divided by
        the normal force [m].
    film : Film
        The air film under the disk in SI units; its constants are 0 without a film.
    """

    radius: float
    half_thickness: float
    mass: float
    diametral_inertia: float
    axial_inertia: float
    modulus: float
    shear_modulus: float
    fillet: float
    damping_ratio: float
    friction: float
    contour_moment: float
    bowl: tuple[float, float, float]
    spin_friction: tuple[float, ...]
    arms: tuple[float, float, float]
    film: Film


class MovingTable(NamedTuple):
    """Modes of a table, of unit modal mass, at k nodes around the rim.

    Attributes
    ----------
    coefficients : ndarray, shape (a, b, t)
        Spline coefficients of the upward mode shapes.
    knots_x, knots_y : ndarray
        Knots of the splines [m].
    round_shapes : RoundTable
        Shapes of the modes of a round table, in place of the splines.
    place : ndarray, shape (2,)
        Origin [m] in the frame of the shapes.
    is_fixed : float
        0 if the modes move with the centre of the disk, as modes given by numbers do; else 1.
    frequency, decay : ndarray, shape (t,)
        Angular frequency [rad/s] and decay rate [1/s].
    mean_factor, place_factor : ndarray, shape (t,)
        sin(x)/x with x = w h/2: average over the free vibration in a step; and x/tan(x), for
        the mean of the displacements at both ends of the step.
    shape_norm : float
        Greatest norm of the mode shapes at a point [kg^-1/2].
    shapes : ndarray, shape (k, t)
        Mode shapes at the nodes [kg^-1/2], times `mean_factor`.
    slopes : ndarray, shape (k, 2, t)
        Slopes of the mode shapes along x and y at the nodes [kg^-1/2/m], times `mean_factor`.
    known_since : ndarray, shape (k,)
        Time [s] at which the slopes of a node were last evaluated; negative if never.
    position : ndarray, shape (k, 2)
        Horizontal positions [m] at which the shapes of the nodes were evaluated.
    motion : ndarray, shape (3, k)
        Deflection [m], speed [m/s] and change of the speed in the step [m/s] of the table under
        the nodes.
    incline : ndarray, shape (k, 2)
        Slopes of the table along x and y at the nodes.
    force : ndarray, shape (2, k)
        Force [N] of springs and dashpots on the nodes.
    displacement : ndarray, shape (t,)
        Mean displacements of the modes at both ends of the step.
    work : ndarray, shape (t,)
        Work array.
    evaluated : ndarray, shape (2, k)
        Times [s] at which deflection, and slopes and speed, of a node were last evaluated.
    node : ndarray of int, shape (p,)
        Last node before each point of the rim.
    share : ndarray, shape (p,)
        Distance of each point from that node, divided by the distance of two nodes.
    """

    coefficients: np.ndarray
    knots_x: np.ndarray
    knots_y: np.ndarray
    round_shapes: RoundTable
    place: np.ndarray
    is_fixed: float
    frequency: np.ndarray
    decay: np.ndarray
    mean_factor: np.ndarray
    place_factor: np.ndarray
    shape_norm: float
    shapes: np.ndarray
    slopes: np.ndarray
    known_since: np.ndarray
    position: np.ndarray
    motion: np.ndarray
    incline: np.ndarray
    force: np.ndarray
    displacement: np.ndarray
    work: np.ndarray
    evaluated: np.ndarray
    node: np.ndarray
    share: np.ndarray


DEFLECTION, SPEED, CHANGE = range(3)
"""Rows of `MovingTable.motion`."""


class Edge(NamedTuple):
    """Lower edge of the disk, with p points and d modes.

    Attributes
    ----------
    heights : ndarray, shape (p,)
        Heights [m] of table minus edge.
    block_heights : ndarray, shape (ceil(p/BLOCK_SIZE),)
        Greatest height [m] of each block of points.
    angles : ndarray, shape (2, p)
        Cosine and sine of the angles of the points.
    axial, radial : ndarray, shape (d, p)
        Displacement along the axis and the radius by modes of unit modal mass
        [kg^-1/2], times sin(x)/x with x = w h/2, which is the average over the free
        vibration in a step.
    place_factor : ndarray, shape (d,)
        Factor x/tan(x), for the mean of the displacements at both ends of the step.
    frequency, decay : ndarray, shape (d,)
        Angular frequency [rad/s] and decay rate [1/s] of the modes.
    highest : ndarray, shape (1 + d,)
        Greatest height [m], and greatest displacement by each mode [kg^-1/2].
    """

    heights: np.ndarray
    block_heights: np.ndarray
    angles: np.ndarray
    axial: np.ndarray
    radial: np.ndarray
    place_factor: np.ndarray
    frequency: np.ndarray
    decay: np.ndarray
    highest: np.ndarray


@kernel
def rotate(vector, axis, angle):
    """Rotate a vector (3,) in place about a unit vector `axis` by an angle [rad]."""
    x, y, z = axis
    c = np.cos(angle)
    s = np.sin(angle)
    a = vector[0]
    b = vector[1]
    d = vector[2]
    along = (1 - c) * (a * x + b * y + d * z)
    vector[0] = c * a + s * (y * d - z * b) + along * x
    vector[1] = c * b + s * (z * a - x * d) + along * y
    vector[2] = c * d + s * (x * b - y * a) + along * z


@kernel
def fly(disk, gravity, edge, motion, propagator, h):
    """Advance the disk and its modes exactly by a time h without contact.

    `propagator` (4, d) is that of the modes.
    """
    state = motion.disk
    ring = motion.modes
    for i in range(3):
        state[CENTRE, i] += h * state[VELOCITY, i]
    state[CENTRE, 2] -= 0.5 * gravity * h * h
    state[VELOCITY, 2] -= gravity * h
    if disk.bowl[0] > 0:
        for i in range(2):
            state[VELOCITY, i] -= (
                h * disk.bowl[0] * (state[CENTRE, i] + disk.bowl[1 + i])
            )
    momentum = state[MOMENTUM]
    axis = state[AXIS]
    size = np.sqrt(momentum[0] ** 2 + momentum[1] ** 2 + momentum[2] ** 2)
    if size > 0:
        axial = momentum[0] * axis[0] + momentum[1] * axis[1] + momentum[2] * axis[2]
        own = (1 / disk.axial_inertia - 1 / disk.diametral_inertia) * axial * h
        rotate(state[RIM_REFERENCE_VECTOR], axis, own)
        turn = size / disk.diametral_inertia * h
        direction = (momentum[0] / size, momentum[1] / size, momentum[2] / size)
        rotate(state[RIM_REFERENCE_VECTOR], direction, turn)
        rotate(axis, direction, turn)
    lost = motion.mode_loss
    for j in range(edge.axial.shape[0]):
        place = ring[0, j]
        speed = ring[1, j]
        later = propagator[0, j] * place + propagator[1, j] * speed
        faster = propagator[2, j] * place + propagator[3, j] * speed
        squared = edge.frequency[j] ** 2
        lost[j] += (squared * (place**2 - later**2) + speed**2 - faster**2) / 2
        ring[0, j] = later
        ring[1, j] = faster


@kernel
def record_mode_losses(motion):
    """Move the energies lost by the modes of the disk since the last sample to the record."""
    for j in range(motion.mode_loss.size):
        motion.record[RECORD.disk_mode_loss] += motion.mode_loss[j]
        motion.mode_loss[j] = 0.0


@kernel
def fly_table(table, motion, propagator):
    """Advance the modes of the table exactly without contact by their propagator (4, t)."""
    place = motion.table_place
    speed = motion.table_speed
    later = table.work
    for j in range(later.size):
        later[j] = propagator[0, j] * place[j] + propagator[1, j] * speed[j]
    for j in range(later.size):
        speed[j] = propagator[2, j] * place[j] + propagator[3, j] * speed[j]
    for j in range(later.size):
        place[j] = later[j]


@kernel
def table_energy(table, motion):
    """Return the energy [J] of the modes of the table."""
    speed = motion.table_speed
    rate = table.work
    for j in range(rate.size):
        rate[j] = table.frequency[j] * motion.table_place[j]
    return (scalar_product(rate, rate) + scalar_product(speed, speed)) / 2


@kernel
def work_lost_to_damping(table, motion, gain, step):
    """Return the part [J] of the work on the table modes that damping dissipates in a step.

    The impulses that change the speeds by `gain` (t,) represent forces that act during the
    whole step, in which the displacements decay. The work of these forces is smaller than
    that of the impulses; the difference is of first order in the decay rates.
    """
    lost = table.work
    for j in range(lost.size):
        bend = table.frequency[j] ** 2 * motion.table_place[j]
        lost[j] = table.decay[j] * (gain[j] * step / 4 - bend * step**2 / 12)
    return scalar_product(gain, lost)


@kernel
def table_deflection_bound(table, motion):
    """Return an upper amplitude [m] of the table deflection until the next contact."""
    place = motion.table_place
    amplitude = table.work
    for j in range(amplitude.size):
        amplitude[j] = motion.table_speed[j] / table.frequency[j]
    squares = scalar_product(place, place) + scalar_product(amplitude, amplitude)
    return table.shape_norm * np.sqrt(squares)


@kernel
def scalar_product(a, b):
    """Return the scalar product of two arrays, as four partial sums that a processor
    evaluates in parallel."""
    s0 = 0.0
    s1 = 0.0
    s2 = 0.0
    s3 = 0.0
    whole = a.size - a.size % 4
    for i in range(0, whole, 4):
        s0 += a[i] * b[i]
        s1 += a[i + 1] * b[i + 1]
        s2 += a[i + 2] * b[i + 2]
        s3 += a[i + 3] * b[i + 3]
    for i in range(whole, a.size):
        s0 += a[i] * b[i]
    return (s0 + s1) + (s2 + s3)


class Velocities(NamedTuple):
    """Velocities, or their changes, of the disk and of m modes; t of these belong to the table.

    Attributes
    ----------
    all : ndarray, shape (6 + m,)
        All velocities in the order of the following views.
    linear, angular : ndarray, shape (3,)
        Velocity of the centre [m/s] and angular velocity [rad/s].
    modes : ndarray, shape (m,)
        Velocities of the modes of disk and table.
    table_modes : ndarray, shape (t,)
        Those of the table alone.
    """

    all: np.ndarray
    linear: np.ndarray
    angular: np.ndarray
    modes: np.ndarray
    table_modes: np.ndarray


@kernel
def zero_velocities(motion):
    """Return `Velocities` that are zero, for the modes of a `MotionState`."""
    velocities = np.zeros(6 + motion.modes.shape[1])
    modes = velocities[6:]
    table_modes = modes[motion.mode_loss.size :]
    return Velocities(velocities, velocities[:3], velocities[3:6], modes, table_modes)


@kernel
def write_velocity(disk, motion, out):
    """Write the velocities of disk and modes to `out`."""
    state = motion.disk
    axial = 0.0
    for i in range(3):
        out.linear[i] = state[VELOCITY, i]
        axial += state[MOMENTUM, i] * state[AXIS, i]
    extra = (1 / disk.axial_inertia - 1 / disk.diametral_inertia) * axial
    for i in range(3):
        out.angular[i] = (
            state[MOMENTUM, i] / disk.diametral_inertia + extra * state[AXIS, i]
        )
    for j in range(motion.modes.shape[1]):
        out.modes[j] = motion.modes[1, j]


@kernel
def add_force(contacts, cause, force, arm):
    """Add a force [N] by `cause` with an arm [m] from the centre to forces and torques."""
    x, y, z = force
    arm_x, arm_y, arm_z = arm
    contacts.force[cause, 0] += x
    contacts.force[cause, 1] += y
    contacts.force[cause, 2] += z
    contacts.torque[cause, 0] += arm_y * z - arm_z * y
    contacts.torque[cause, 1] += arm_z * x - arm_x * z
    contacts.torque[cause, 2] += arm_x * y - arm_y * x


class MotionState(NamedTuple):
    """State of a rattling disk.

    Attributes
    ----------
    disk : ndarray, shape (5, 3)
        Position, velocity, axis, reference vector of the rim, angular momentum.
    modes : ndarray, shape (2, m)
        Displacements [kg^1/2 m] and velocities of the modes of disk and table.
    record : ndarray, shape (RECORD_SIZE,)
        Sums since the start; see `RecordLayout`.
    mode_loss : ndarray, shape (d,)
        Energy lost by the damping of each mode of the disk since the last sample [J].
    table_place, table_speed : ndarray, shape (t,)
        Parts of `modes` for the table.
    """

    disk: np.ndarray
    modes: np.ndarray
    record: np.ndarray
    mode_loss: np.ndarray
    table_place: np.ndarray
    table_speed: np.ndarray


def motion_state(disk, modes, record, disk_modes) -> MotionState:
    """Return the `MotionState`; the first `disk_modes` modes are those of the disk."""
    of_table = modes[:, disk_modes:]
    return MotionState(disk, modes, record, np.zeros(disk_modes), *of_table)


class RimGeometry(NamedTuple):
    """Position of the rim in space.

    Attributes
    ----------
    axis, reference : ndarray, shape (3,)
        Axis of the disk and unit vector towards the point of the rim at angle zero.
    quarter_turn : ndarray, shape (3,)
        Unit vector from the centre to the point of the rim at the angle pi/2.
    upright : float
        Cosine of the inclination.
    sine : float
        Sine of the inclination, at least 1e-6.
    inclination : float
        Inclination [rad], at least 1e-6.
    height : float
        Height [m] above the table of the point of the axis in the plane of the edge.
    tilt : float
        Height of that point above the lowest point of the edge [m].
    """

    axis: np.ndarray
    reference: np.ndarray
    quarter_turn: np.ndarray
    upright: float
    sine: float
    inclination: float
    height: float
    tilt: float


class Contacts(NamedTuple):
    """Forces and positions of all contacts.

    Attributes
    ----------
    load : ndarray, shape (5, 6)
        Force and torque by cause, in the order of the following views.
    force, torque : ndarray, shape (5, 3)
        Force [N] and torque about the centre [N m] by cause.
    pull : ndarray, shape (2, m)
        Force of springs and dashpots on each mode.
    depth, speed, change : ndarray, shape (p,)
        Mean depth [m], approach speed [m/s] and its change in the step of the points that were
        examined.
    rise, radius, below : ndarray, shape (BLOCK_SIZE,)
        Height of the points of a block above the middle plane divided by their distance from
        the axis, that distance [m], and their distance below the middle plane [m].
    """

    load: np.ndarray
    force: np.ndarray
    torque: np.ndarray
    pull: np.ndarray
    depth: np.ndarray
    speed: np.ndarray
    change: np.ndarray
    rise: np.ndarray
    radius: np.ndarray
    below: np.ndarray


@kernel
def rim_geometry(disk, state, quarter_turn_vector):
    """Return the RimGeometry of a state; the array `quarter_turn_vector` is reused."""
    axis = state[AXIS]
    reference = state[RIM_REFERENCE_VECTOR]
    quarter_turn_vector[0] = axis[1] * reference[2] - axis[2] * reference[1]
    quarter_turn_vector[1] = axis[2] * reference[0] - axis[0] * reference[2]
    quarter_turn_vector[2] = axis[0] * reference[1] - axis[1] * reference[0]
    sine = np.hypot(reference[2], quarter_turn_vector[2])
    upright = axis[2]
    return RimGeometry(
        axis,
        reference,
        quarter_turn_vector,
        upright,
        max(sine, 1e-6),
        max(np.arctan2(sine, upright), 1e-6),
        state[CENTRE, 2] - (disk.half_thickness - disk.fillet) * upright - disk.fillet,
        (disk.radius - disk.fillet) * sine,
    )


@kernel
def point_in_space(rim, cosine, sine, below):
    """Return the vector (x, y, z) [m] from the centre of the disk to a point of it.

    `cosine` and `sine` [m] are its coordinates along the reference vector of the rim and a
    quarter turn ahead; `below` [m] is its distance below the middle plane.
    """
    axis = rim.axis
    reference = rim.reference
    turned = rim.quarter_turn
    x = cosine * reference[0] + sine * turned[0] - below * axis[0]
    y = cosine * reference[1] + sine * turned[1] - below * axis[1]
    z = cosine * reference[2] + sine * turned[2] - below * axis[2]
    return x, y, z


@kernel
def add_table(table, row, first, size, out):
    """Add a row of `MovingTable.motion` at `size` points from `first` on to `out` (p,).

    The row is interpolated linearly between the nodes.
    """
    motion = table.motion[row]
    for i in range(first, first + size):
        node = table.node[i]
        after = node + 1 if node + 1 < motion.size else 0
        out[i] += (1 - table.share[i]) * motion[node] + table.share[i] * motion[after]


@kernel
def push_nodes(table, depth, left, points, spring, damping):
    """Add the forces of a patch to the nodes of the table.

    `spring` and `damping` are the forces divided by the sum of the depths [N/m].
    """
    force = table.force
    nodes = table.known_since.size
    for m in range(left, left + points):
        i = m % depth.size
        node = table.node[i]
        after = (node + 1) % nodes
        share = table.share[i]
        force[ELASTIC, node] += (1 - share) * spring * depth[i]
        force[ELASTIC, after] += share * spring * depth[i]
        force[DASHPOT, node] += (1 - share) * damping * depth[i]
        force[DASHPOT, after] += share * damping * depth[i]


@kernel
def table_nodes_under_arc(table, first, number, points):
    """Return the first node and the number of nodes that enclose an arc of the rim.

    The arc consists of `number` points from `first` on, of `points` in all."""
    nodes = table.known_since.size
    begin = int(np.floor(first * nodes / points))
    end = int(np.floor((first + number) * nodes / points)) + 1
    return begin, min(end - begin + 1, nodes)


@kernel
def node_arm(disk, table, rim, node):
    """Return the vector (x, y, z) [m] from the centre of the disk to a node of the rim."""
    angle = 2 * np.pi * node / table.known_since.size
    c = (disk.radius - disk.fillet) * np.cos(angle)
    s = (disk.radius - disk.fillet) * np.sin(angle)
    return point_in_space(rim, c, s, disk.half_thickness - disk.fillet)


@kernel
def update_node_mode_shapes(table, node, x, y, now, basis_x, basis_y):
    """Update the mode shapes of a node that has moved to (x, y) [m]."""
    linear_time = 1e-4  # s, for which the shapes near a node are linear
    shapes = table.shapes[node]
    slopes = table.slopes[node]
    if now - table.known_since[node] > linear_time:
        table.known_since[node] = now
        store_table_shapes(table, x, y, basis_x, basis_y, shapes)
        store_table_slopes(table, x, y, basis_x, basis_y, slopes)
        for m in range(shapes.size):
            shapes[m] *= table.mean_factor[m]
            slopes[0, m] *= table.mean_factor[m]
            slopes[1, m] *= table.mean_factor[m]
    else:
        step_x = x - table.position[node, 0]
        step_y = y - table.position[node, 1]
        for m in range(shapes.size):
            shapes[m] += slopes[0, m] * step_x + slopes[1, m] * step_y
    table.position[node, 0] = x
    table.position[node, 1] = y


@kernel
def move_nodes(disk, table, motion, rim, now, begin, count):
    """Evaluate the deflection of the table at `count` nodes from `begin` on, and clear their
    forces; return the greatest deflection [m].
    """
    for m in range(table.displacement.size):
        table.displacement[m] = table.place_factor[m] * motion.table_place[m]
    basis_x = np.empty((3, 4))
    basis_y = np.empty((3, 4))
    highest = -np.inf
    for n in range(begin, begin + count):
        node = n % table.known_since.size
        table.force[ELASTIC, node] = 0.0
        table.force[DASHPOT, node] = 0.0
        if table.evaluated[0, node] != now:
            table.evaluated[0, node] = now
            x, y, _ = node_arm(disk, table, rim, node)
            x += table.is_fixed * motion.disk[CENTRE, 0]
            y += table.is_fixed * motion.disk[CENTRE, 1]
            update_node_mode_shapes(table, node, x, y, now, basis_x, basis_y)
            table.motion[DEFLECTION, node] = scalar_product(
                table.shapes[node], table.displacement
            )
        highest = max(highest, table.motion[DEFLECTION, node])
    return highest


@kernel
def write_node_speeds(
    disk, table, rim, velocity, change, is_changed, now, begin, count
):
    """Evaluate slopes and speed of the table at `count` nodes from `begin` on.

    A speed that was evaluated before the change is corrected by half of it.
    """
    for n in range(begin, begin + count):
        node = n % table.known_since.size
        incline = table.incline[node]
        is_known = is_changed and table.evaluated[1, node] == now
        if not is_known:
            table.evaluated[1, node] = now
            for i in range(2):
                incline[i] = scalar_product(table.slopes[node, i], table.displacement)
            table.motion[SPEED, node] = node_speed(disk, table, rim, velocity, node)
        if is_changed:
            gain = node_speed(disk, table, rim, change, node)
            table.motion[CHANGE, node] = gain
            if is_known:
                table.motion[SPEED, node] += gain / 2


@kernel
def node_speed(disk, table, rim, velocity, node):
    """Return the speed [m/s] at which the table rises under a node of the moving rim."""
    x, y, z = node_arm(disk, table, rim, node)
    spin_x, spin_y, spin_z = velocity.angular
    # velocity of the node relative to the mode shapes
    moved_x = table.is_fixed * velocity.linear[0] + spin_y * z - spin_z * y
    moved_y = table.is_fixed * velocity.linear[1] + spin_z * x - spin_x * z
    return (
        scalar_product(table.shapes[node], velocity.table_modes)
        + table.incline[node, 0] * moved_x
        + table.incline[node, 1] * moved_y
    )


@kernel
def push_table(disk, table, motion, rim, begin, count, contacts):
    """Add the forces on `count` nodes from `begin` on to those on the modes of the table, and their
    horizontal parts to those on the disk.
    """
    for place in range(begin, begin + count):
        node = place % table.known_since.size
        for origin in range(2):
            force = table.force[origin, node]
            if force == 0:
                continue
            pull = contacts.pull[origin, motion.mode_loss.size :]
            shapes = table.shapes[node]
            for m in range(shapes.size):
                pull[m] -= force * shapes[m]
            push_x = -force * table.incline[node, 0]
            push_y = -force * table.incline[node, 1]
            arm = node_arm(disk, table, rim, node)
            add_force(contacts, origin, (push_x, push_y, 0.0), arm)
            # modes that move with the centre exert torques only
            contacts.force[origin, 0] -= (1 - table.is_fixed) * push_x
            contacts.force[origin, 1] -= (1 - table.is_fixed) * push_y


@kernel
def write_depths(disk, edge, motion, rim, first, size, contacts):
    """Write the depths [m] of the points of a block below a table at rest.

    The block has `size` points and begins at the point `first`. Depths are negative
    above the table.
    """
    points = slice(first, first + size)
    heights = edge.heights[points]
    cosine = edge.angles[0, points]
    sine = edge.angles[1, points]
    depth = contacts.depth[points]
    rise = contacts.rise
    x = rim.reference[2]
    y = rim.quarter_turn[2]
    radius = disk.radius - disk.fillet
    for i in range(size):
        rise[i] = cosine[i] * x + sine[i] * y
    for i in range(size):
        depth[i] = heights[i] - rim.height - radius * rise[i]
    for j in range(edge.axial.shape[0]):
        axial = edge.axial[j, points]
        radial = edge.radial[j, points]
        place = motion.modes[0, j] * edge.place_factor[j]
        for i in range(size):
            depth[i] -= place * (axial[i] * rim.upright + radial[i] * rise[i])


@kernel
def write_speeds(disk, edge, motion, rim, velocity, first, size, contacts, out):
    """Write the speeds [m/s] at which points approach a table at rest to `out` (p,).

    The points are those of the last call of `write_depths`.
    """
    points = slice(first, first + size)
    speed = out[points]
    rise = contacts.rise
    radius = contacts.radius
    below = contacts.below
    for i in range(size):
        speed[i] = -velocity.linear[2]
        radius[i] = disk.radius - disk.fillet
        below[i] = disk.half_thickness - disk.fillet
    for j in range(edge.axial.shape[0]):
        axial = edge.axial[j, points]
        radial = edge.radial[j, points]
        place = motion.modes[0, j] * edge.place_factor[j]
        rate = velocity.modes[j]
        for i in range(size):
            speed[i] -= rate * (axial[i] * rim.upright + radial[i] * rise[i])
        for i in range(size):
            radius[i] += place * radial[i]
        for i in range(size):
            below[i] -= place * axial[i]
    cosine = edge.angles[0, points]
    sine = edge.angles[1, points]
    x0, y0, _ = rim.reference
    x1, y1, _ = rim.quarter_turn
    axis_x, axis_y, _ = rim.axis
    turn_x, turn_y, _ = velocity.angular
    for i in range(size):
        arm_x = radius[i] * (cosine[i] * x0 + sine[i] * x1) - below[i] * axis_x
        arm_y = radius[i] * (cosine[i] * y0 + sine[i] * y1) - below[i] * axis_y
        speed[i] = speed[i] - turn_x * arm_y + turn_y * arm_x


@kernel
def block_depth(disk, edge, rim, block):
    """Return an upper bound of the depth [m] of the points of a block.

    Disk and table are assumed undeformed.
    """
    count = edge.heights.size
    first = block * BLOCK_SIZE
    last = min(first + BLOCK_SIZE, count) - 1
    x = rim.reference[2]
    y = rim.quarter_turn[2]
    rise = min(
        edge.angles[0, first] * x + edge.angles[1, first] * y,
        edge.angles[0, last] * x + edge.angles[1, last] * y,
    )
    rise -= rim.sine * (BLOCK_SIZE * 2 * np.pi / count) ** 2 / 8
    return edge.block_heights[block] - rim.height - (disk.radius - disk.fillet) * rise


@kernel
def arc_below(edge, rim, room):
    """Return the arc of the rim less than `room` [m] above its lowest point.

    The result consists of its half-angle [rad], its first point and its number of
    points."""
    count = edge.heights.size
    cell = 2 * np.pi / count
    half = np.pi
    if room < 2 * rim.tilt:
        half = 2 * np.arcsin(np.sqrt(room / (2 * rim.tilt)))
    lowest = np.arctan2(-rim.quarter_turn[2], -rim.reference[2])
    first = int(np.floor((lowest - half) / cell)) - 1
    return half, first, min(int(2 * half / cell) + 4, count)


@kernel
def mean_penetration(depth, travel):
    """Return the mean positive depth over a step in which the depth changes by
    `travel`.

    The work of a spring then equals the change of its energy even in a step in which
    contact starts or ends.
    """
    travel = abs(travel)
    if depth >= travel / 2:
        return depth
    if depth <= -travel / 2:
        return 0.0
    return (depth + travel / 2) ** 2 / (2 * travel)


@kernel
def mean_square_end_depth(depth, travel):
    """Return the mean square of the positive depths at both ends of a step.

    `depth` is their mean, and `travel` is their difference.
    """
    first = max(depth - travel / 2, 0.0)
    last = max(depth + travel / 2, 0.0)
    return (first**2 + last**2) / 2


@kernel
def press_patch(
    disk, edge, table, motion, rim, velocity, stiffness, step, left, points, contacts
):
    """Add the forces of a patch of `points` adjacent points that begins at the point
    `left`."""
    count = edge.heights.size
    depth_sum = 0.0
    squares = 0.0
    speed_sum = 0.0
    deepest = 0.0
    fastest = 0.0
    cosine = 0.0
    sine = 0.0
    below = 0.0
    for place in range(left, left + points):
        i = place % count
        depth = contacts.depth[i]
        depth_sum += depth
        squares += depth * depth
        speed_sum += depth * contacts.speed[i]
        if depth > deepest:
            deepest = depth
            fastest = abs(contacts.speed[i])
        radius = disk.radius - disk.fillet
        for j in range(edge.axial.shape[0]):
            displacement = motion.modes[0, j] * edge.place_factor[j]
            radius += displacement * edge.radial[j, i]
            below -= depth * displacement * edge.axial[j, i]
        cosine += depth * radius * edge.angles[0, i]
        sine += depth * radius * edge.angles[1, i]
    cosine /= depth_sum
    sine /= depth_sum
    below = disk.half_thickness - disk.fillet + below / depth_sum
    centre_x, centre_y, centre_z = point_in_space(rim, cosine, sine, below)
    centre_z -= disk.fillet
    centre = (centre_x, centre_y, centre_z)
    lever = centre_x**2 + centre_y**2
    mobility = 1 / disk.mass + lever / disk.diametral_inertia
    # number of points of a parabolic patch, continuous when points are added; the factor is the
    # length of a parabola times the sum of its squares, divided by the square of its sum
    parabola_factor = 1.2
    length = parabola_factor * depth_sum**2 / squares
    dashpot = 2 * disk.damping_ratio * np.sqrt(stiffness * length / mobility)
    spring = stiffness * depth_sum
    # fraction of contact in a step in which contact starts or ends; see `mean_penetration`
    dashpot *= min(1.0, np.sqrt(2 * deepest / (fastest * step)))
    damping = max(dashpot * speed_sum / depth_sum, -spring)
    add_force(contacts, ELASTIC, (0.0, 0.0, spring), centre)
    add_force(contacts, DASHPOT, (0.0, 0.0, damping), centre)
    if table is not None:
        push_nodes(table, contacts.depth, left, points, stiffness, damping / depth_sum)
    for j in range(edge.axial.shape[0]):
        shape = 0.0
        for place in range(left, left + points):
            i = place % count
            rise = (
                edge.angles[0, i] * rim.reference[2]
                + edge.angles[1, i] * rim.quarter_turn[2]
            )
            own = edge.axial[j, i] * rim.upright + edge.radial[j, i] * rise
            shape += contacts.depth[i] / depth_sum * own
        contacts.pull[ELASTIC, j] += spring * shape
        contacts.pull[DASHPOT, j] += damping * shape
    spin_x, spin_y, spin_z = velocity.angular
    slip_x = velocity.linear[0] + spin_y * centre_z - spin_z * centre_y
    slip_y = velocity.linear[1] + spin_z * centre_x - spin_x * centre_z
    slip = np.hypot(slip_x, slip_y)
    if slip > 0 and disk.friction > 0 and spring + damping > 0:
        # the contact moves along the rim at the rate w_3/sin(beta)
        speed = disk.radius * np.hypot(spin_x, spin_y) / rim.sine
        ellipse = 2 * deepest * np.sqrt(disk.radius / rim.inclination * disk.fillet)
        # Kalker's coefficient of longitudinal creep for a circle, close to that of a long ellipse
        creep_coefficient = 4.5
        creep = (
            creep_coefficient * disk.shear_modulus * ellipse * slip / max(speed, slip)
        )
        limit = disk.friction * (spring + damping)
        push = creep / np.sqrt(1 + (creep / limit) ** 2)
        # friction impulse divided by mass times slip velocity
        max_slip_reduction = 0.25
        push = min(push, max_slip_reduction * disk.mass / step * slip)
        friction = (-push * slip_x / slip, -push * slip_y / slip, 0.0)
        add_force(contacts, FRICTION, friction, centre)


@kernel
def press_rim(
    disk, edge, table, motion, rim, velocity, change, is_changed, now, step, contacts
):
    """Write the forces of all patches and return their elastic energy [J]: that in the middle
    of the step, or, if `is_changed`, the mean of those at both ends.

    `velocity` is the mean velocity in the step, and `change` its change, by which the
    depths at both ends deviate from uniform motion; it is zero unless `is_changed`.
    """
    travel = abs(velocity.linear[2])
    travel += (abs(velocity.angular[0]) + abs(velocity.angular[1])) * (
        disk.radius + disk.half_thickness
    )
    reach = 0.0
    table_reach = 0.0
    for j in range(edge.axial.shape[0]):
        travel += edge.highest[1 + j] * abs(velocity.modes[j])
        reach += edge.highest[1 + j] * abs(motion.modes[0, j])
    if table is not None:
        speed = velocity.table_modes
        bend = motion.table_place
        travel += table.shape_norm * np.sqrt(scalar_product(speed, speed))
        table_reach = table.shape_norm * np.sqrt(scalar_product(bend, bend))
    travel *= step
    room = edge.highest[0] + reach + table_reach + travel - rim.height + rim.tilt
    if room <= 0:
        return 0.0
    count = edge.heights.size
    cell = 2 * np.pi / count
    curvature_radius = disk.radius / rim.inclination
    stiffness = disk.modulus * (curvature_radius * disk.fillet) ** 0.25
    stiffness *= cell * disk.radius / np.sqrt(2 * curvature_radius)
    _, first, number = arc_below(edge, rim, room)
    min_depth = -travel - reach - table_reach
    last = first
    nearest = -1
    place = first
    while place < first + number:
        i = place % count
        after = place + min(BLOCK_SIZE - i % BLOCK_SIZE, count - i)
        if block_depth(disk, edge, rim, i // BLOCK_SIZE) > min_depth:
            if nearest < 0:
                nearest = place - first
            last = min(after, first + number)
        place = after
    if nearest < 0:
        return 0.0
    first += nearest
    number = last - first
    begin = 0
    nodes = 0
    has_node_speeds = False
    if table is not None:
        begin, nodes = table_nodes_under_arc(table, first, number, count)
        highest = move_nodes(disk, table, motion, rim, now, begin, nodes)
        min_depth = -travel - reach - highest
    points = 0
    left = first
    squares = 0.0
    place = first
    while place < last:
        begin_of_block = place % count
        size = min(BLOCK_SIZE - begin_of_block % BLOCK_SIZE, count - begin_of_block)
        size = min(size, last - place)
        block = begin_of_block // BLOCK_SIZE
        is_near = block_depth(disk, edge, rim, block) > min_depth
        if is_near:
            write_depths(disk, edge, motion, rim, begin_of_block, size, contacts)
            if table is not None:
                add_table(table, DEFLECTION, begin_of_block, size, contacts.depth)
            deepest = -np.inf
            for i in range(begin_of_block, begin_of_block + size):
                deepest = max(deepest, contacts.depth[i])
            is_near = deepest > -travel
        if is_near:
            write_speeds(
                disk,
                edge,
                motion,
                rim,
                velocity,
                begin_of_block,
                size,
                contacts,
                contacts.speed,
            )
            if is_changed:
                write_speeds(
                    disk,
                    edge,
                    motion,
                    rim,
                    change,
                    begin_of_block,
                    size,
                    contacts,
                    contacts.change,
                )
            if table is not None:
                if not has_node_speeds:
                    has_node_speeds = True
                    write_node_speeds(
                        disk,
                        table,
                        rim,
                        velocity,
                        change,
                        is_changed,
                        now,
                        begin,
                        nodes,
                    )
                add_table(table, SPEED, begin_of_block, size, contacts.speed)
                if is_changed:
                    add_table(table, CHANGE, begin_of_block, size, contacts.change)
        ends = 1 if place + size == last else 0
        for m in range(size + ends):
            depth = 0.0
            if is_near and m < size:
                i = begin_of_block + m
                own = contacts.depth[i]
                if not is_changed:
                    squares += max(own, 0.0) ** 2
                if own > -travel:
                    if is_changed:
                        own += step / 4 * contacts.change[i]
                        squares += mean_square_end_depth(own, contacts.speed[i] * step)
                    depth = mean_penetration(own, contacts.speed[i] * step)
                    contacts.depth[i] = depth
            if depth > 0:
                if points == 0:
                    left = place + m
                points += 1
            elif points > 0:
                press_patch(
                    disk,
                    edge,
                    table,
                    motion,
                    rim,
                    velocity,
                    stiffness,
                    step,
                    left,
                    points,
                    contacts,
                )
                points = 0
        place += size
    if table is not None:
        push_table(disk, table, motion, rim, begin, nodes, contacts)
    return stiffness * squares / 2


@kernel
def clear(contacts):
    """Set all forces to zero."""
    contacts.load[:] = 0.0
    contacts.pull[:] = 0.0


@kernel
def add_half_sample(motion, row):
    """Add half of state, record and modes of the disk to a row of the samples."""
    disk = motion.disk.ravel()
    modes = disk.size + RECORD_SIZE
    for i in range(disk.size):
        row[i] += 0.5 * disk[i]
    for i in range(RECORD_SIZE):
        row[disk.size + i] += 0.5 * motion.record[i]
    for j in range(motion.mode_loss.size):
        row[modes + 2 * j] += 0.5 * motion.modes[0, j]
        row[modes + 2 * j + 1] += 0.5 * motion.modes[1, j]


@kernel
def add_resistance(disk, weight, rim, velocity, energy, step, contacts):
    """Add the resisting moments, and the torque due to the variable spring stiffness.

    The stiffness varies as the fourth root of the inclination. The contour moment
    resists the rolling of the contact at the rate w_3/sin(beta). All moments are
    proportional to the normal force; those of the arms can stop a rotation within a
    step but not reverse it.
    """
    axis_x, axis_y, _ = rim.axis
    spin_x, spin_y, spin_z = velocity.angular
    lean = energy / (4 * rim.inclination * rim.sine)
    contacts.torque[ELASTIC, 0] += lean * axis_y
    contacts.torque[ELASTIC, 1] -= lean * axis_x
    normal = contacts.force[ELASTIC, 2] + contacts.force[DASHPOT, 2]
    against = spin_x * axis_x + spin_y * axis_y
    against = against * rim.upright - spin_z * rim.sine**2
    moment = disk.contour_moment * normal / weight / rim.sine**2 * np.sign(against)
    torque = contacts.torque[RESISTANCE]
    torque[0] = -moment * axis_x * rim.upright
    torque[1] = -moment * axis_y * rim.upright
    torque[2] = moment * rim.sine**2
    d1 = axis_x / rim.sine
    d2 = axis_y / rim.sine
    directions = ((d2, -d1, 0.0), (d1, d2, 0.0), (0.0, 0.0, 1.0))
    arms = disk.arms
    if disk.spin_friction[0] > 0:
        travel = np.hypot(spin_x, spin_y) / rim.sine
        root = rim.sine ** (1 / SINE_ROOT_DEGREE)
        unit_arm = 0.0
        creep = 0.0
        for i in range(PIVOTING_COEFFICIENT_COUNT, 0, -1):
            unit_arm = unit_arm * root + disk.spin_friction[i]
            creep = creep * root + disk.spin_friction[PIVOTING_COEFFICIENT_COUNT + i]
        pivoting = limited_arm_kernel(
            unit_arm / root**4,
            creep / root**4,
            abs(spin_z),
            travel * travel,
            False,
            disk.friction,
        )
        arms = (arms[0], arms[1], disk.radius * pivoting)
    for arm, direction in zip(arms, directions):  # noqa: B905 - unknown to Numba
        rate = 0.0
        for i in range(3):
            rate += velocity.angular[i] * direction[i]
        most = abs(rate) * disk.diametral_inertia / step
        resistance = min(arm * max(normal, 0.0), most) * np.sign(rate)
        for i in range(3):
            torque[i] -= resistance * direction[i]


@kernel
def add_film(disk, motion, rim, velocity, step, contacts):
    """Add the forces of the air film; return the work [J] of its compressed air."""
    axis = rim.axis
    up_slope = (-axis[0] * axis[2] / rim.sine, -axis[1] * axis[2] / rim.sine, rim.sine)
    stored = motion.record[RECORD.compressed_air_energy]
    film = film_pressure(disk, axis, up_slope, velocity, stored, step)
    force = (film.pressure * axis[0], film.pressure * axis[1], film.pressure * axis[2])
    add_force(contacts, FILM, force, point_on_face(disk, axis, up_slope, film.place))
    for i in range(3):
        contacts.torque[FILM, i] += film.drag * up_slope[i]
    return film.work


@kernel
def write_velocity_change(disk, motion, contacts, h, out):
    """Write the velocity changes caused by the forces within a time h to `out`."""
    axis = motion.disk[AXIS]
    axial = 0.0
    for i in range(3):
        out.linear[i] = 0.0
        out.angular[i] = 0.0
        for origin in range(contacts.load.shape[0]):
            torque = contacts.torque[origin, i]
            out.linear[i] += h / disk.mass * contacts.force[origin, i]
            out.angular[i] += h / disk.diametral_inertia * torque
            axial += h * torque * axis[i]
    extra = (1 / disk.axial_inertia - 1 / disk.diametral_inertia) * axial
    for i in range(3):
        out.angular[i] += extra * axis[i]
    for j in range(motion.modes.shape[1]):
        out.modes[j] = h * (contacts.pull[ELASTIC, j] + contacts.pull[DASHPOT, j])


@kernel
def energy_of_change(contacts, change, disk_modes, h):
    """Return the kinetic energy [J] of the velocity changes of the disk and its modes.

    A quarter of it is the mean kinetic energy before and after the change less that of the
    mean velocity.
    """
    energy = 0.0
    for i in range(contacts.load.shape[1]):
        for origin in range(contacts.load.shape[0]):
            energy += h / 2 * contacts.load[origin, i] * change.all[i]
    for j in range(disk_modes):
        energy += change.modes[j] ** 2 / 2
    return energy


@kernel
def kick(disk, motion, contacts, before, change, h):
    """Apply the forces for a time h, and record impulse and losses.

    `before` and `change` are the velocities before the forces and their change.
    """
    state = motion.disk
    record = motion.record
    load = contacts.load
    for i in range(load.shape[1]):
        mean = before.all[i] + change.all[i] / 2
        record[RECORD.contact_loss] -= h * load[DASHPOT, i] * mean
        record[RECORD.slip_loss] -= h * load[FRICTION, i] * mean
        record[RECORD.moment_loss] -= h * load[RESISTANCE, i] * mean
        record[RECORD.film_loss] -= h * load[FILM, i] * mean
    for i in range(3):
        for origin in range(load.shape[0]):
            state[VELOCITY, i] += h / disk.mass * contacts.force[origin, i]
            state[MOMENTUM, i] += h * contacts.torque[origin, i]
            record[RECORD.impulse + i] += h * contacts.force[origin, i]
    record[RECORD.film_impulse] += h * contacts.force[FILM, 2]
    for i in range(2):
        record[RECORD.friction_impulse + i] += h * contacts.force[FRICTION, i]
    pull = contacts.pull[DASHPOT]
    record[RECORD.contact_loss] -= h * (
        scalar_product(pull, before.modes) + scalar_product(pull, change.modes) / 2
    )
    for j in range(motion.modes.shape[1]):
        motion.modes[1, j] += change.modes[j]


@kernel
def write_propagator(body, h, out):
    """Write the propagator of each mode of edge or table over a time h to `out` (4, k)."""
    for j in range(body.frequency.size):
        d = body.decay[j]
        w = np.sqrt(body.frequency[j] ** 2 - d * d)
        c = np.cos(w * h)
        s = np.sin(w * h)
        fade = np.exp(-d * h)
        out[0, j] = fade * (c + d / w * s)
        out[1, j] = fade * s / w
        out[2, j] = -fade * s * (w * w + d * d) / w
        out[3, j] = fade * (c - d / w * s)


@kernel
def is_carried_by_film(record, now, weight):
    """Return True if the air film has supported the disk since the loss of contact."""
    min_duration = 2e-3  # s
    min_lift = 0.5  # mean force of the film divided by the weight
    duration = now - record[RECORD.flight_start]
    if record[RECORD.flight_start] < 0 or duration < min_duration:
        return False
    return record[RECORD.flight_film_impulse] > min_lift * weight * duration


@kernel
def stays_clear(disk, edge, max_deflection, gravity, motion, rim, contacts, duration):
    """Return True if no point of the rim can touch the table within `duration` [s].

    The amplitudes of the modes bound their displacements; those of the table deflect it
    by at most `max_deflection` [m]. The lowest point of the rim falls at its present
    rate, accelerated by gravity, the rotation and the air film.
    """
    state = motion.disk
    lean = state[MOMENTUM, 0] * state[AXIS, 1] - state[MOMENTUM, 1] * state[AXIS, 0]
    lean /= disk.diametral_inertia  # rate of the cosine of the inclination
    below = disk.half_thickness - disk.fillet
    radius = disk.radius - disk.fillet
    rate = state[VELOCITY, 2] - lean * (below - radius * rim.upright / rim.sine)
    turning = 0.0
    for i in range(3):
        turning += (state[MOMENTUM, i] / disk.diametral_inertia) ** 2
    fastest = gravity + 2 * (radius + below) * turning / rim.sine
    fastest += 10 * abs(contacts.force[FILM, 2]) / disk.mass
    reach = duration**2 / 2 * fastest - min(duration * rate, 0.0)
    for j in range(edge.axial.shape[0]):
        speed = motion.modes[1, j] / edge.frequency[j]
        reach += edge.highest[1 + j] * np.hypot(motion.modes[0, j], speed)
    reach += max_deflection
    room = edge.highest[0] + reach - rim.height + rim.tilt
    if room <= 0:
        return True
    sideways = duration * radius * np.sqrt(turning)
    half, first, number = arc_below(edge, rim, room + sideways)
    reach += sideways * min(half, 1.0)
    count = edge.heights.size
    place = first
    while place < first + number:
        i = place % count
        if block_depth(disk, edge, rim, i // BLOCK_SIZE) > -reach:
            return False
        place += min(BLOCK_SIZE - i % BLOCK_SIZE, count - i)
    return True


@outermost
def step_rattling_disk(
    disk,
    edge,
    table,
    gravity,
    final_tilt,
    step,
    per_sample,
    motion,
    begin,
    samples,
    flights,
):
    """Advance a rattling disk and write a sample after every `per_sample` steps.

    Parameters
    ----------
    disk : RattlingDisk
        Disk and contact.
    edge : Edge
        Lower edge of the disk, with the unevenness.
    table : MovingTable or None
        Modes of the table; None compiles a separate version without them.
    gravity : float
        Acceleration of gravity [m/s^2].
    final_tilt : float
        `RimGeometry.tilt` [m] below which the disk lies flat.
    step : float
        Time step [s].
    per_sample : int
        Steps between two samples.
    motion : MotionState
        State of the disk and of its modes, and the sums since the start, updated in
        place.
    begin : float
        Time [s] of the first step.
    samples : ndarray, shape (n, 16 + RECORD_SIZE + 2 d)
        Receives state, record, modes of the disk and energy of those of the table.
    flights : ndarray, shape (f, 3)
        Output: start [s], duration [s] and height [m] of each loss of contact that
        ended; f is at least half the number of steps.

    Returns
    -------
    tuple of int
        Number of samples and of flights written, and the reason for the end.
    """
    upright_cosine_limit = 0.05  # cosine of the inclination of an upright disk
    mode_count = motion.modes.shape[1]
    disk_modes = motion.mode_loss.size
    propagators = np.empty((per_sample, 4, disk_modes))
    for i in range(per_sample):
        write_propagator(edge, (i + 1) * step / 2, propagators[i])
    stored = 0.0
    if table is not None:
        table_propagators = np.empty((2 * per_sample, 4, mode_count - disk_modes))
        for i in range(2 * per_sample):
            write_propagator(table, (i + 1) * step / 2, table_propagators[i])
        stored = table_energy(table, motion)
    count = edge.heights.size
    load = np.zeros((5, 6))
    contacts = Contacts(
        load,
        load[:, :3],
        load[:, 3:],
        np.zeros((2, mode_count)),
        np.zeros(count),
        np.zeros(count),
        np.zeros(count),
        np.zeros(BLOCK_SIZE),
        np.zeros(BLOCK_SIZE),
        np.zeros(BLOCK_SIZE),
    )
    quarter_turn_vector = np.empty(3)
    before = zero_velocities(motion)
    mean = zero_velocities(motion)
    change = zero_velocities(motion)
    record = motion.record
    highest = edge.highest[0]
    weight = disk.mass * gravity
    has_film = disk.film.turning > 0
    received = 0.0
    max_deflection = -1.0
    waiting = 0
    losses = 0
    for sample in range(samples.shape[0]):
        done = 0
        while done < per_sample:
            merged = 1
            left = per_sample - 1 - done
            if record[RECORD.flight_start] >= 0 and left > 1:
                rim = rim_geometry(disk, motion.disk, quarter_turn_vector)
                if max_deflection < 0:
                    max_deflection = 0.0
                    if table is not None:
                        max_deflection = table_deflection_bound(table, motion)
                if stays_clear(
                    disk,
                    edge,
                    max_deflection,
                    gravity,
                    motion,
                    rim,
                    contacts,
                    left * step,
                ):
                    merged = left
            done += merged
            duration = merged * step
            propagator = propagators[merged - 1]
            fly(disk, gravity, edge, motion, propagator, duration / 2)
            waiting += merged
            if table is not None and merged == 1:
                fly_table(table, motion, table_propagators[waiting - 1])
                waiting = 0
            now = begin + (sample * per_sample + done) * step
            rim = rim_geometry(disk, motion.disk, quarter_turn_vector)
            write_velocity(disk, motion, before)
            change.all[:] = 0.0
            mean.all[:] = before.all
            clear(contacts)
            record[RECORD.spring_energy] = 0.0
            if merged == 1:
                for is_changed in (False, True):
                    if is_changed:
                        # Forces at the mean velocity and mean depth of the step
                        # conserve energy.
                        write_velocity_change(disk, motion, contacts, step, change)
                        for i in range(before.all.size):
                            mean.all[i] = before.all[i] + change.all[i] / 2
                        clear(contacts)
                    energy = press_rim(
                        disk,
                        edge,
                        table,
                        motion,
                        rim,
                        mean,
                        change,
                        is_changed,
                        now,
                        step,
                        contacts,
                    )
                    if is_changed:
                        add_resistance(
                            disk,
                            weight,
                            rim,
                            mean,
                            record[RECORD.spring_energy],
                            step,
                            contacts,
                        )
                    record[RECORD.spring_energy] = energy
                    if contacts.force[ELASTIC, 2] <= 0:
                        break
            touches = contacts.force[ELASTIC, 2] > 0
            if has_film:
                work = add_film(disk, motion, rim, before, duration, contacts)
                left = max(record[RECORD.compressed_air_energy] - work, 0.0)
                rate = np.hypot(before.angular[0], before.angular[1]) / rim.sine
                kept = min(left, film_capacity(disk.film, rim.sine, rate))
                record[RECORD.film_loss] += record[RECORD.compressed_air_energy] - kept
                record[RECORD.compressed_air_energy] = kept
            if (
                touches
                and contacts.force[ELASTIC, 2] + contacts.force[DASHPOT, 2]
                > 1e-6 * weight
            ):
                if record[RECORD.flight_start] >= 0:
                    flights[losses, 0] = record[RECORD.flight_start]
                    flights[losses, 1] = now - record[RECORD.flight_start]
                    flights[losses, 2] = record[RECORD.max_flight_height]
                    losses += 1
                    record[RECORD.flight_start] = -1.0
            else:
                if record[RECORD.flight_start] < 0:
                    record[RECORD.flight_start] = now
                    record[RECORD.max_flight_height] = 0.0
                    record[RECORD.flight_film_impulse] = 0.0
                record[RECORD.open_time] += duration
                record[RECORD.flight_film_impulse] += duration * contacts.force[FILM, 2]
                record[RECORD.max_flight_height] = max(
                    record[RECORD.max_flight_height], rim.height - rim.tilt
                )
            if done == per_sample:
                record_mode_losses(motion)
                samples[sample] = 0.0
                if table is not None:
                    energy = table_energy(table, motion)
                    record[RECORD.table_mode_loss] += stored + received - energy
                    samples[sample, -1] = energy
                    stored = energy
                    received = 0.0
                add_half_sample(motion, samples[sample])
            if touches or has_film:
                write_velocity_change(disk, motion, contacts, duration, change)
                if done == per_sample:
                    gain = energy_of_change(contacts, change, disk_modes, duration)
                    samples[sample, motion.disk.size + RECORD.spring_energy] += gain / 4
                kick(disk, motion, contacts, before, change, duration)
            if table is not None and touches:
                max_deflection = -1.0
                gain = change.table_modes
                by_old = scalar_product(before.table_modes, gain)
                by_gain = scalar_product(gain, gain)
                received += by_old + by_gain / 2
                received -= work_lost_to_damping(table, motion, gain, step)
                if done == per_sample:  # the mean energy before and after the impulse
                    samples[sample, -1] += by_old / 2 + by_gain / 4
            if done == per_sample:
                add_half_sample(motion, samples[sample])
            fly(disk, gravity, edge, motion, propagator, duration / 2)
            waiting += merged
            if rim.tilt < final_tilt:
                return sample, losses, LIES_FLAT
            if rim.upright < upright_cosine_limit:
                return sample, losses, STANDS_UPRIGHT
            if record[RECORD.flight_start] >= 0 and record[
                RECORD.max_flight_height
            ] > max(rim.tilt, 10 * highest):
                return sample, losses, LIFTS_OFF
            if is_carried_by_film(record, now, weight):
                return sample, losses, IS_AIRBORNE
    if table is not None:
        fly_table(table, motion, table_propagators[waiting - 1])
        energy = table_energy(table, motion)
        record[RECORD.table_mode_loss] += stored + received - energy
    return samples.shape[0], losses, CONTINUES
