"""Time steps of a disk with springs all round its rim.

A step is half a free flight, the impulse of the contacts, and half a free flight. The flight is
exact: the centre falls, the disk turns as a symmetric top, and its modes ring. The rim rests on
points with springs whose force is linear in the depth and whose sum is Hertz's force of the smooth
contact. Adjacent points in contact form a patch. A dashpot acts on the mean approach speed of a
patch, weighted by the depth, because dashpots of single points would resist rolling.
"""

from typing import NamedTuple

import numpy as np
from numba import njit

from dynamics.numba_kernels import outermost
from dynamics.rattling import film_force
from dynamics.rattling.film_force import AirFilm, film_capacity, film_pressure

kernel = njit(error_model="numpy")

CENTRE = 0
"""Position of the centre in the state [m]."""
VELOCITY = 3
"""Velocity of the centre [m/s]."""
AXIS = 6
"""Unit vector along the axis of the disk, upwards."""
MARK = 9
"""Unit vector from the centre to the point of the rim with the angle zero."""
MOMENTUM = 12
"""Angular momentum about the centre [kg m^2/s]."""
STATE_SIZE = 15
IMPULSE = 0
"""Impulse of the contact force since the start along x, y, z [N s]."""
CONTACT_LOSS = 3
"""Energy lost to the dashpots [J]."""
SLIP_LOSS = 4
"""Energy lost to friction [J]."""
MOMENT_LOSS = 5
"""Energy lost to the resisting moment [J]."""
STORED = 6
"""Elastic energy of the springs [J]."""
OPEN_TIME = 7
"""Time without contact [s]."""
BODY_LOSS = 8
"""Energy lost by the damping of the modes [J]."""
OPEN_SINCE = 9
"""Time at which the contact was last lost [s]; negative while there is contact."""
GREATEST_GAP = 10
"""Greatest height of the lowest point of the rim above the table since the contact was lost [m]."""
FILM_LOSS = 11
"""Energy lost to the air film [J]."""
AIR_ENERGY = 12
"""Energy of the compressed air in the film [J]."""
FLIGHT_LIFT = 13
"""Impulse of the film's pressure since the contact was lost [N s]."""
RECORD_SIZE = 14
TORQUE = 3
"""First of the three torques about the centre in a sum of contact forces."""
LOAD_SIZE = 6
ELASTIC, DASHPOT, FRICTION, RESISTANCE, FILM = range(5)
"""Rows of an array (5, 6) of the force [N] and the torque about the centre [N m] of springs,
dashpots, friction, resisting moment and air film."""
CREEP_COEFFICIENT = 4.5
"""Kalker's coefficient of the longitudinal creep of a circle, near that of a long ellipse."""
SLIP_LIMIT = 0.25
"""Largest impulse of friction in a step over mass times slip velocity: friction stops no slip
faster."""
MIN_UPRIGHT = 0.05
"""Cosine of the inclination below which the disk stands upright."""
MIN_AIRBORNE_TIME = 2e-3
"""Shortest loss of contact [s] after which the air film may carry the disk."""
MIN_AIRBORNE_LIFT = 0.5
"""Mean pressure of the film in a loss of contact, over the weight, from which it carries the
disk."""
CONTINUES, LIES_FLAT, STANDS_UPRIGHT, JUMPS, FLOATS = range(5)
"""Reasons for which the steps end."""


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
        Damping ratio of a patch that carries a rigid disk.
    friction : float
        Coefficient of sliding friction.
    contour_moment : float
        Moment that resists the rolling of the contact under the weight [N m].
    arms : (3,) tuple of float
        Resisting moments against the rotation about a_1, a_2 and the vertical, over the normal
        force [m].
    film : AirFilm
        The air film under the disk.
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
    arms: tuple[float, float, float]
    film: AirFilm


class Edge(NamedTuple):
    """Lower edge of the disk: p points with the heights of the unevenness, and m modes.

    Attributes
    ----------
    heights : (p,) array
        Heights [m] of table minus edge.
    angles : (2, p) array
        Cosine and sine of the angles of the points.
    axial, radial : (m, p) arrays
        Displacement along the axis and the radius by modes of unit modal mass [kg^-1/2], averaged
        over the free vibration in a step: times sin(x)/x with x = w h/2.
    place_factor : (m,) array
        x/tan(x): gives the mean of the displacements at both ends of the step.
    frequency, decay : (m,) arrays
        Angular frequency [rad/s] and decay rate [1/s] of the edge.
    highest : (1 + m,) array
        Greatest height [m], and greatest displacement by each mode [kg^-1/2].
    """

    heights: np.ndarray
    angles: np.ndarray
    axial: np.ndarray
    radial: np.ndarray
    place_factor: np.ndarray
    frequency: np.ndarray
    decay: np.ndarray
    highest: np.ndarray


@kernel
def rotate(state, place, x, y, z, angle):
    """Rotate a vector of the state about the unit vector (x, y, z) by an angle [rad]."""
    c = np.cos(angle)
    s = np.sin(angle)
    a = state[place]
    b = state[place + 1]
    d = state[place + 2]
    along = (1 - c) * (a * x + b * y + d * z)
    state[place] = c * a + s * (y * d - z * b) + along * x
    state[place + 1] = c * b + s * (z * a - x * d) + along * y
    state[place + 2] = c * d + s * (x * b - y * a) + along * z


@kernel
def fly(disk, gravity, edge, motion, propagator, h):
    """Advance the disk and its modes without contact by a time h, exactly."""
    state = motion.disk
    ring = motion.modes
    for i in range(3):
        state[CENTRE + i] += h * state[VELOCITY + i]
    state[CENTRE + 2] -= 0.5 * gravity * h * h
    state[VELOCITY + 2] -= gravity * h
    momentum_x = state[MOMENTUM]
    momentum_y = state[MOMENTUM + 1]
    momentum_z = state[MOMENTUM + 2]
    size = np.sqrt(momentum_x**2 + momentum_y**2 + momentum_z**2)
    if size > 0:
        axial = (
            momentum_x * state[AXIS] + momentum_y * state[AXIS + 1] + momentum_z * state[AXIS + 2]
        )
        own = (1 / disk.axial_inertia - 1 / disk.diametral_inertia) * axial * h
        rotate(state, MARK, state[AXIS], state[AXIS + 1], state[AXIS + 2], own)
        turn = size / disk.diametral_inertia * h
        x = momentum_x / size
        y = momentum_y / size
        z = momentum_z / size
        rotate(state, MARK, x, y, z, turn)
        rotate(state, AXIS, x, y, z, turn)
    for j in range(ring.shape[0]):
        place = ring[j, 0]
        speed = ring[j, 1]
        ring[j, 0] = propagator[j, 0] * place + propagator[j, 1] * speed
        ring[j, 1] = propagator[j, 2] * place + propagator[j, 3] * speed
        squared = edge.frequency[j] ** 2
        motion.record[BODY_LOSS] += (
            squared * (place**2 - ring[j, 0] ** 2) + speed**2 - ring[j, 1] ** 2
        ) / 2


@kernel
def write_velocity(disk, motion, out):
    """Write velocity, angular velocity and the velocities of the modes to `out` (6 + m,)."""
    state = motion.disk
    axial = 0.0
    for i in range(3):
        out[i] = state[VELOCITY + i]
        axial += state[MOMENTUM + i] * state[AXIS + i]
    extra = (1 / disk.axial_inertia - 1 / disk.diametral_inertia) * axial
    for i in range(3):
        out[TORQUE + i] = state[MOMENTUM + i] / disk.diametral_inertia + extra * state[AXIS + i]
    for j in range(motion.modes.shape[0]):
        out[LOAD_SIZE + j] = motion.modes[j, 1]


@kernel
def add_force(load, x, y, z, arm_x, arm_y, arm_z):
    """Add a force at an arm from the centre to a sum of force and torque (6,)."""
    load[0] += x
    load[1] += y
    load[2] += z
    load[TORQUE] += arm_y * z - arm_z * y
    load[TORQUE + 1] += arm_z * x - arm_x * z
    load[TORQUE + 2] += arm_x * y - arm_y * x


class MotionState(NamedTuple):
    """State of a rattling disk.

    Attributes
    ----------
    disk : (15,) array
        Position, velocity, axis, mark and angular momentum.
    modes : (m, 2) array
        Displacement [kg^1/2 m] and velocity of each mode.
    record : (14,) array
        Sums since the start.
    """

    disk: np.ndarray
    modes: np.ndarray
    record: np.ndarray


class RimGeometry(NamedTuple):
    """Position of the rim in space.

    Attributes
    ----------
    mark_2 : (3,) array
        Unit vector from the centre to the point of the rim at the angle pi/2.
    upright : float
        Cosine of the inclination.
    sine : float
        Sine of the inclination, at least 1e-6.
    inclination : float
        Inclination [rad], at least 1e-6.
    height : float
        Height of the centre of the lower face above the table [m].
    tilt : float
        Height of the centre of the lower face above its lowest point [m].
    """

    mark_2: np.ndarray
    upright: float
    sine: float
    inclination: float
    height: float
    tilt: float


class Contacts(NamedTuple):
    """Forces and places of all contacts.

    Attributes
    ----------
    load : (5, 6) array
        Force and torque by origin.
    pull : (2, m) array
        Force of springs and dashpots on each mode.
    depth, speed : (p,) arrays
        Mean depth [m] and approach speed [m/s] of the points that were examined.
    """

    load: np.ndarray
    pull: np.ndarray
    depth: np.ndarray
    speed: np.ndarray


@kernel
def rim_geometry(disk, state, mark_2):
    """Return the RimGeometry of a state, which keeps the array `mark_2`."""
    mark_2[0] = state[AXIS + 1] * state[MARK + 2] - state[AXIS + 2] * state[MARK + 1]
    mark_2[1] = state[AXIS + 2] * state[MARK] - state[AXIS] * state[MARK + 2]
    mark_2[2] = state[AXIS] * state[MARK + 1] - state[AXIS + 1] * state[MARK]
    sine = np.hypot(state[MARK + 2], mark_2[2])
    upright = state[AXIS + 2]
    return RimGeometry(
        mark_2,
        upright,
        max(sine, 1e-6),
        max(np.arctan2(sine, upright), 1e-6),
        state[CENTRE + 2] - disk.half_thickness * upright,
        disk.radius * sine,
    )


@kernel
def point_depth(disk, edge, motion, rim, i):
    """Return the depth [m] of point i of the rim in the table; negative above it."""
    rise = edge.angles[0, i] * motion.disk[MARK + 2] + edge.angles[1, i] * rim.mark_2[2]
    depth = edge.heights[i] - rim.height - disk.radius * rise
    for j in range(edge.frequency.size):
        shape = edge.axial[j, i] * rim.upright + edge.radial[j, i] * rise
        depth -= motion.modes[j, 0] * edge.place_factor[j] * shape
    return depth


@kernel
def point_speed(disk, edge, motion, rim, velocity, i):
    """Return the speed [m/s] at which point i of the rim approaches the table."""
    state = motion.disk
    c = edge.angles[0, i]
    s = edge.angles[1, i]
    rise = c * state[MARK + 2] + s * rim.mark_2[2]
    arm_x = disk.radius * (c * state[MARK] + s * rim.mark_2[0])
    arm_y = disk.radius * (c * state[MARK + 1] + s * rim.mark_2[1])
    speed = -velocity[2]
    speed -= velocity[TORQUE] * (arm_y - disk.half_thickness * state[AXIS + 1])
    speed += velocity[TORQUE + 1] * (arm_x - disk.half_thickness * state[AXIS])
    for j in range(edge.frequency.size):
        shape = edge.axial[j, i] * rim.upright + edge.radial[j, i] * rise
        speed -= velocity[LOAD_SIZE + j] * shape
    return speed


@kernel
def mean_depth(depth, travel):
    """Return the mean of the depth while it is positive, in a step in which it changes by `travel`.

    The work of a spring then equals the change of its energy also in the step in which it makes or
    loses contact.
    """
    travel = abs(travel)
    if depth >= travel / 2:
        return depth
    if depth <= -travel / 2:
        return 0.0
    return (depth + travel / 2) ** 2 / (2 * travel)


@kernel
def press_patch(disk, edge, motion, rim, velocity, stiffness, step, left, points, contacts):
    """Add the forces of a patch of adjacent points from the point `left` on."""
    state = motion.disk
    count = edge.heights.size
    depth_sum = 0.0
    speed_sum = 0.0
    deepest = 0.0
    cosine = 0.0
    sine = 0.0
    for place in range(left, left + points):
        i = place % count
        depth = contacts.depth[i]
        depth_sum += depth
        speed_sum += depth * contacts.speed[i]
        deepest = max(deepest, depth)
        cosine += depth * edge.angles[0, i]
        sine += depth * edge.angles[1, i]
    cosine *= disk.radius / depth_sum
    sine *= disk.radius / depth_sum
    centre_x = cosine * state[MARK] + sine * rim.mark_2[0] - disk.half_thickness * state[AXIS]
    centre_y = cosine * state[MARK + 1] + sine * rim.mark_2[1]
    centre_y -= disk.half_thickness * state[AXIS + 1]
    centre_z = cosine * state[MARK + 2] + sine * rim.mark_2[2] - disk.half_thickness * rim.upright
    mobility = 1 / disk.mass + disk.radius**2 / disk.diametral_inertia
    dashpot = 2 * disk.damping_ratio * np.sqrt(stiffness * points / mobility)
    spring = stiffness * depth_sum
    damping = max(dashpot * speed_sum / depth_sum, -spring)
    add_force(contacts.load[ELASTIC], 0.0, 0.0, spring, centre_x, centre_y, centre_z)
    add_force(contacts.load[DASHPOT], 0.0, 0.0, damping, centre_x, centre_y, centre_z)
    for j in range(edge.frequency.size):
        shape = 0.0
        for place in range(left, left + points):
            i = place % count
            rise = edge.angles[0, i] * state[MARK + 2] + edge.angles[1, i] * rim.mark_2[2]
            own = edge.axial[j, i] * rim.upright + edge.radial[j, i] * rise
            shape += contacts.depth[i] / depth_sum * own
        contacts.pull[ELASTIC, j] += spring * shape
        contacts.pull[DASHPOT, j] += damping * shape
    slip_x = velocity[0] + velocity[4] * centre_z - velocity[5] * centre_y
    slip_y = velocity[1] + velocity[5] * centre_x - velocity[3] * centre_z
    slip = np.hypot(slip_x, slip_y)
    if slip > 0 and disk.friction > 0 and spring + damping > 0:
        # The contact runs round the rim at the rate w_3/sin(beta).
        speed = disk.radius * np.hypot(velocity[3], velocity[4]) / rim.sine
        ellipse = 2 * deepest * np.sqrt(disk.radius / rim.inclination * disk.fillet)
        creep = CREEP_COEFFICIENT * disk.shear_modulus * ellipse * slip / max(speed, slip)
        limit = disk.friction * (spring + damping)
        push = creep / np.sqrt(1 + (creep / limit) ** 2)
        push = min(push, SLIP_LIMIT * disk.mass / step * slip)
        push_x = -push * slip_x / slip
        push_y = -push * slip_y / slip
        add_force(contacts.load[FRICTION], push_x, push_y, 0.0, centre_x, centre_y, centre_z)


@kernel
def press_rim(disk, edge, motion, rim, velocity, change, step, contacts):
    """Write the forces of all patches and return their elastic energy [J].

    `velocity` (6 + m,) is the mean velocity in the step, and `change` (6 + m,) the change that
    separates the depths at its ends from those of a uniform motion.
    """
    travel = abs(velocity[2])
    travel += (abs(velocity[3]) + abs(velocity[4])) * (disk.radius + disk.half_thickness)
    reach = 0.0
    for j in range(edge.frequency.size):
        travel += edge.highest[1 + j] * abs(velocity[LOAD_SIZE + j])
        reach += edge.highest[1 + j] * abs(motion.modes[j, 0])
    travel *= step
    room = edge.highest[0] + reach + travel - rim.height + rim.tilt
    if room <= 0:
        return 0.0
    count = edge.heights.size
    cell = 2 * np.pi / count
    curvature_radius = disk.radius / rim.inclination
    stiffness = disk.modulus * (curvature_radius * disk.fillet) ** 0.25
    stiffness *= cell * disk.radius / np.sqrt(2 * curvature_radius)
    half = np.pi
    if room < 2 * rim.tilt:
        half = 2 * np.arcsin(np.sqrt(room / (2 * rim.tilt)))
    lowest = np.arctan2(-rim.mark_2[2], -motion.disk[MARK + 2])
    first = int(np.floor((lowest - half) / cell)) - 1
    number = min(int(2 * half / cell) + 4, count)
    points = 0
    left = first
    squares = 0.0
    for m in range(number + 1):
        i = (first + m) % count
        depth = 0.0
        if m < number:
            own = point_depth(disk, edge, motion, rim, i)
            squares += max(own, 0.0) ** 2
            if own > -travel:
                speed = point_speed(disk, edge, motion, rim, velocity, i)
                own += step / 4 * point_speed(disk, edge, motion, rim, change, i)
                depth = mean_depth(own, speed * step)
                contacts.depth[i] = depth
                contacts.speed[i] = speed
        if depth > 0:
            if points == 0:
                left = first + m
            points += 1
        elif points > 0:
            press_patch(disk, edge, motion, rim, velocity, stiffness, step, left, points, contacts)
            points = 0
    return stiffness * squares / 2


@kernel
def clear(contacts):
    """Set all forces to zero."""
    for i in range(contacts.load.shape[0]):
        for j in range(contacts.load.shape[1]):
            contacts.load[i, j] = 0.0
    for i in range(contacts.pull.shape[0]):
        for j in range(contacts.pull.shape[1]):
            contacts.pull[i, j] = 0.0


@kernel
def add_sample(motion, share, row):
    """Add a share of state, record and modes to a row of the samples."""
    for i in range(STATE_SIZE):
        row[i] += share * motion.disk[i]
    for i in range(RECORD_SIZE):
        row[STATE_SIZE + i] += share * motion.record[i]
    for j in range(motion.modes.shape[0]):
        row[STATE_SIZE + RECORD_SIZE + 2 * j] += share * motion.modes[j, 0]
        row[STATE_SIZE + RECORD_SIZE + 2 * j + 1] += share * motion.modes[j, 1]


@kernel
def add_resistance(disk, weight, motion, rim, velocity, energy, step, load):
    """Add the torque of the springs' change with the inclination, and the resisting moments.

    The springs stiffen as the fourth root of the inclination. The contour moment resists the
    rolling of the contact at the rate w_3/sin(beta). All moments are proportional to the normal
    force; those of the arms stop no rotation faster than within a step.
    """
    axis_x = motion.disk[AXIS]
    axis_y = motion.disk[AXIS + 1]
    lean = energy / (4 * rim.inclination * rim.sine)
    load[ELASTIC, TORQUE] += lean * axis_y
    load[ELASTIC, TORQUE + 1] -= lean * axis_x
    normal = load[ELASTIC, 2] + load[DASHPOT, 2]
    against = velocity[3] * axis_x + velocity[4] * axis_y
    against = against * rim.upright - velocity[5] * rim.sine**2
    moment = disk.contour_moment * normal / weight / rim.sine**2 * np.sign(against)
    load[RESISTANCE, TORQUE] = -moment * axis_x * rim.upright
    load[RESISTANCE, TORQUE + 1] = -moment * axis_y * rim.upright
    load[RESISTANCE, TORQUE + 2] = moment * rim.sine**2
    d1 = axis_x / rim.sine
    d2 = axis_y / rim.sine
    directions = ((d2, -d1, 0.0), (d1, d2, 0.0), (0.0, 0.0, 1.0))
    for arm, direction in zip(disk.arms, directions):  # noqa: B905 - unknown to Numba
        rate = 0.0
        for i in range(3):
            rate += velocity[3 + i] * direction[i]
        most = abs(rate) * disk.diametral_inertia / step
        resistance = min(arm * max(normal, 0.0), most) * np.sign(rate)
        for i in range(3):
            load[RESISTANCE, TORQUE + i] -= resistance * direction[i]


@kernel
def add_film(disk, motion, rim, velocity, step, load, pressure):
    """Add the forces of the air film; return the work [J] of its compressed air.

    `pressure` (3, 3) is memory for its loads.
    """
    axis = motion.disk[AXIS : AXIS + 3]
    stored = motion.record[AIR_ENERGY]
    work = film_pressure(disk.film, disk, axis, rim.sine, velocity, stored, step, pressure)
    x, y, z = pressure[film_force.FORCE]
    arm_x, arm_y, arm_z = pressure[film_force.ARM]
    add_force(load[FILM], x, y, z, arm_x, arm_y, arm_z)
    for i in range(3):
        load[FILM, TORQUE + i] += pressure[film_force.TORQUE, i]
    return work


@kernel
def write_change(disk, motion, contacts, h, out):
    """Write the change of all velocities by the forces in a time h to `out` (6 + m,)."""
    load = contacts.load
    axis = motion.disk[AXIS : AXIS + 3]
    axial = 0.0
    for i in range(3):
        out[i] = 0.0
        out[TORQUE + i] = 0.0
        for origin in range(load.shape[0]):
            out[i] += h / disk.mass * load[origin, i]
            out[TORQUE + i] += h / disk.diametral_inertia * load[origin, TORQUE + i]
            axial += h * load[origin, TORQUE + i] * axis[i]
    extra = (1 / disk.axial_inertia - 1 / disk.diametral_inertia) * axial
    for i in range(3):
        out[TORQUE + i] += extra * axis[i]
    for j in range(motion.modes.shape[0]):
        out[LOAD_SIZE + j] = h * (contacts.pull[ELASTIC, j] + contacts.pull[DASHPOT, j])


@kernel
def kick(disk, motion, contacts, before, change, h):
    """Change momentum and modes by the forces in a time h, and record impulse and losses.

    `before` and `change` (6 + m,) are the velocities before the change and the change.
    """
    state = motion.disk
    record = motion.record
    load = contacts.load
    for i in range(LOAD_SIZE):
        mean = before[i] + change[i] / 2
        record[CONTACT_LOSS] -= h * load[DASHPOT, i] * mean
        record[SLIP_LOSS] -= h * load[FRICTION, i] * mean
        record[MOMENT_LOSS] -= h * load[RESISTANCE, i] * mean
        record[FILM_LOSS] -= h * load[FILM, i] * mean
    for i in range(3):
        for origin in range(load.shape[0]):
            state[VELOCITY + i] += h / disk.mass * load[origin, i]
            state[MOMENTUM + i] += h * load[origin, TORQUE + i]
            record[IMPULSE + i] += h * load[origin, i]
    for j in range(motion.modes.shape[0]):
        mean = before[LOAD_SIZE + j] + change[LOAD_SIZE + j] / 2
        record[CONTACT_LOSS] -= h * contacts.pull[DASHPOT, j] * mean
        motion.modes[j, 1] += change[LOAD_SIZE + j]


@kernel
def write_propagator(edge, h, out):
    """Write the matrix of each mode's free motion over a time h to `out` (m, 4)."""
    for j in range(edge.frequency.size):
        d = edge.decay[j]
        w = np.sqrt(edge.frequency[j] ** 2 - d * d)
        c = np.cos(w * h)
        s = np.sin(w * h)
        fade = np.exp(-d * h)
        out[j, 0] = fade * (c + d / w * s)
        out[j, 1] = fade * s / w
        out[j, 2] = -fade * s * (w * w + d * d) / w
        out[j, 3] = fade * (c - d / w * s)


@kernel
def floats(record, now, weight):
    """Return True if the air film carries the disk since the contact was lost."""
    lasts = now - record[OPEN_SINCE]
    if record[OPEN_SINCE] < 0 or lasts < MIN_AIRBORNE_TIME:
        return False
    return record[FLIGHT_LIFT] > MIN_AIRBORNE_LIFT * weight * lasts


@outermost
def step_rattling_disk(
    disk, edge, gravity, last_tilt, step, per_sample, motion, begin, samples, flights
):
    """Advance a rattling disk and write a sample after every `per_sample` steps.

    Parameters
    ----------
    disk : RattlingDisk
        Disk and contact.
    edge : Edge
        Its lower edge and the unevenness.
    gravity : float
        Acceleration of gravity [m/s^2].
    last_tilt : float
        Height [m] of the raised side of the rim over its diameter at which the disk lies flat.
    step : float
        Time step [s].
    per_sample : int
        Steps between two samples.
    motion : MotionState
        State of the disk and of its modes, and the sums since the start, updated in place.
    begin : float
        Time [s] of the first step.
    samples : (n, 29 + 2 m) array
        Receives state, record and edge.
    flights : (f, 3) array
        Receives begin [s], duration [s] and height [m] of each loss of contact that ended; f is at
        least half the number of steps.

    Returns
    -------
    tuple of int
        Number of samples and of flights written, and the reason for the end.
    """
    mode_count = edge.frequency.size
    propagator = np.empty((mode_count, 4))
    write_propagator(edge, step / 2, propagator)
    count = edge.heights.size
    contacts = Contacts(
        np.zeros((5, LOAD_SIZE)), np.zeros((2, mode_count)), np.zeros(count), np.zeros(count)
    )
    mark_2 = np.empty(3)
    before = np.empty(LOAD_SIZE + mode_count)
    mean = np.empty(LOAD_SIZE + mode_count)
    change = np.empty(LOAD_SIZE + mode_count)
    record = motion.record
    highest = edge.highest[0]
    weight = disk.mass * gravity
    pressure = np.zeros((3, 3))
    has_film = disk.film.turning > 0
    losses = 0
    for sample in range(samples.shape[0]):
        for repeat in range(1, per_sample + 1):
            fly(disk, gravity, edge, motion, propagator, step / 2)
            now = begin + (sample * per_sample + repeat) * step
            rim = rim_geometry(disk, motion.disk, mark_2)
            write_velocity(disk, motion, before)
            for i in range(before.size):
                change[i] = 0.0
                mean[i] = before[i]
            clear(contacts)
            record[STORED] = press_rim(disk, edge, motion, rim, mean, change, step, contacts)
            if contacts.load[ELASTIC, 2] > 0:
                # The forces with the mean velocity and depth in the step conserve energy.
                write_change(disk, motion, contacts, step, change)
                for i in range(before.size):
                    mean[i] = before[i] + change[i] / 2
                clear(contacts)
                press_rim(disk, edge, motion, rim, mean, change, step, contacts)
                add_resistance(disk, weight, motion, rim, mean, record[STORED], step, contacts.load)
            touches = contacts.load[ELASTIC, 2] > 0
            if has_film:
                work = add_film(disk, motion, rim, before, step, contacts.load, pressure)
                left = max(record[AIR_ENERGY] - work, 0.0)
                rate = np.hypot(before[3], before[4]) / rim.sine
                kept = min(left, film_capacity(disk.film, rim.sine, rate))
                record[FILM_LOSS] += record[AIR_ENERGY] - kept
                record[AIR_ENERGY] = kept
            if touches and contacts.load[ELASTIC, 2] + contacts.load[DASHPOT, 2] > 1e-6 * weight:
                if record[OPEN_SINCE] >= 0:
                    flights[losses, 0] = record[OPEN_SINCE]
                    flights[losses, 1] = now - record[OPEN_SINCE]
                    flights[losses, 2] = record[GREATEST_GAP]
                    losses += 1
                    record[OPEN_SINCE] = -1.0
            else:
                if record[OPEN_SINCE] < 0:
                    record[OPEN_SINCE] = now
                    record[GREATEST_GAP] = 0.0
                    record[FLIGHT_LIFT] = 0.0
                record[OPEN_TIME] += step
                record[FLIGHT_LIFT] += step * contacts.load[FILM, 2]
                record[GREATEST_GAP] = max(record[GREATEST_GAP], rim.height - rim.tilt)
            if repeat == per_sample:
                for i in range(samples.shape[1]):
                    samples[sample, i] = 0.0
                add_sample(motion, 0.5, samples[sample])
            if touches or has_film:
                write_change(disk, motion, contacts, step, change)
                kick(disk, motion, contacts, before, change, step)
            if repeat == per_sample:
                add_sample(motion, 0.5, samples[sample])
            fly(disk, gravity, edge, motion, propagator, step / 2)
            if rim.tilt < last_tilt:
                return sample, losses, LIES_FLAT
            if rim.upright < MIN_UPRIGHT:
                return sample, losses, STANDS_UPRIGHT
            if record[OPEN_SINCE] >= 0 and record[GREATEST_GAP] > max(rim.tilt, 10 * highest):
                return sample, losses, JUMPS
            if floats(record, now, weight):
                return sample, losses, FLOATS
    return samples.shape[0], losses, CONTINUES
