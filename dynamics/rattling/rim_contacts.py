"""Contacts along the rim of a rattling disk.

Springs act at points along the rim. The force of each is linear in its depth, and the sum
is Hertz's force of the smooth contact. Adjacent points in contact form a patch. A dashpot
acts on the depth-weighted mean approach speed of a patch, because dashpots at single
points would resist rolling.
"""

from typing import NamedTuple

import numpy as np

from dynamics.numba_kernels import kernel
from dynamics.rattling.body import (
    Velocities,
    add_force,
    point_in_space,
    scalar_product,
)
from dynamics.rattling.layout import (
    AXIS,
    DASHPOT,
    ELASTIC,
    FILM,
    FRICTION,
    MOMENTUM,
    RIM_BLOCK_POINTS,
    VELOCITY,
)
from dynamics.rattling.vibration import (
    CHANGE,
    DEFLECTION,
    SPEED,
    add_table,
    push_nodes,
    push_table,
    table_nodes_under_arc,
    update_node_deflections,
    write_node_speeds,
)


class StepMotion(NamedTuple):
    """Motion of disk and table in a step, as far as it is known.

    Attributes
    ----------
    velocity : Velocities
        Mean velocities in the step.
    change : Velocities
        Change of the velocities, by which the depths at both ends of the step deviate
        from uniform motion; zero unless `is_changed`.
    is_changed : bool
        True if the change by the forces is known.
    now : float
        Time [s] at the middle of the step.
    duration : float
        Length of the step [s].
    """

    velocity: Velocities
    change: Velocities
    is_changed: bool
    now: float
    duration: float


class RimBlock(NamedTuple):
    """Adjacent points of the rim in one block of RIM_BLOCK_POINTS: the first and their number."""

    first: int
    size: int


class RimArc(NamedTuple):
    """Arc of the rim that may touch the table in a step.

    Attributes
    ----------
    first, last : int
        First point, and the point after the last one. They may be outside one turn.
    travel : float
        Greatest change of a depth in the step [m].
    min_depth : float
        Depth of an undeformed block below a table at rest [m], above which it may touch.
    stiffness : float
        Stiffness of the spring of a point [N/m].
    first_node, node_count : int
        Nodes of the table under the arc; none without modes of the table.
    """

    first: int
    last: int
    travel: float
    min_depth: float
    stiffness: float
    first_node: int
    node_count: int


class RimPatch(NamedTuple):
    """Patch of adjacent points in contact; the sums run over these points.

    Attributes
    ----------
    first, size : int
        First point, which may be outside one turn, and number of points.
    depth_sum, square_sum : float
        Sums of the depths [m] and of their squares [m^2].
    depth_speed_sum : float
        Sum of the products of depth and approach speed [m^2/s].
    deepest, deepest_speed : float
        Greatest depth [m], and the absolute approach speed there [m/s].
    centre : tuple of float, length 3
        Depth-weighted mean of the positions relative to the centre of the disk [m].
    """

    first: int
    size: int
    depth_sum: float
    square_sum: float
    depth_speed_sum: float
    deepest: float
    deepest_speed: float
    centre: tuple[float, float, float]


@kernel
def write_depths(disk, edge, motion, rim, block, contacts):
    """Write the depths [m] of the points of a block below a table at rest.

    Depths are negative above the table.
    """
    size = block.size
    points = slice(block.first, block.first + size)
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
        place = motion.modes[0, j] * edge.endpoint_mean_factor[j]
        for i in range(size):
            depth[i] -= place * (axial[i] * rim.upright + radial[i] * rise[i])


@kernel
def write_positions(disk, edge, motion, block, contacts):
    """Write the distances [m] of the points of a block from the axis and below the middle
    plane of the deformed disk."""
    size = block.size
    points = slice(block.first, block.first + size)
    radius = contacts.radius
    below = contacts.below
    for i in range(size):
        radius[i] = disk.radius - disk.fillet
        below[i] = disk.half_thickness - disk.fillet
    for j in range(edge.axial.shape[0]):
        axial = edge.axial[j, points]
        radial = edge.radial[j, points]
        place = motion.modes[0, j] * edge.endpoint_mean_factor[j]
        for i in range(size):
            radius[i] += place * radial[i]
        for i in range(size):
            below[i] -= place * axial[i]


@kernel
def write_speeds(edge, rim, velocity, block, contacts, out):
    """Write the speeds [m/s] at which points approach a table at rest to `out` (p,).

    The points are those of the last call of `write_depths` and `write_positions`.
    """
    size = block.size
    points = slice(block.first, block.first + size)
    speed = out[points]
    rise = contacts.rise
    radius = contacts.radius
    below = contacts.below
    for i in range(size):
        speed[i] = -velocity.linear[2]
    for j in range(edge.axial.shape[0]):
        axial = edge.axial[j, points]
        radial = edge.radial[j, points]
        rate = velocity.modes[j]
        for i in range(size):
            speed[i] -= rate * (axial[i] * rim.upright + radial[i] * rise[i])
    cosine = edge.angles[0, points]
    sine = edge.angles[1, points]
    x = (rim.reference[0], rim.quarter_turn[0])
    y = (rim.reference[1], rim.quarter_turn[1])
    axis = (rim.axis[0], rim.axis[1])
    turn = (velocity.angular[0], velocity.angular[1])
    for i in range(size):
        arm_x = radius[i] * (cosine[i] * x[0] + sine[i] * x[1]) - below[i] * axis[0]
        arm_y = radius[i] * (cosine[i] * y[0] + sine[i] * y[1]) - below[i] * axis[1]
        speed[i] = speed[i] - turn[0] * arm_y + turn[1] * arm_x


@kernel
def block_depth(disk, edge, rim, block):
    """Return an upper bound of the depth [m] of the points of a block.

    Disk and table are assumed undeformed.
    """
    count = edge.heights.size
    first = block * RIM_BLOCK_POINTS
    last = min(first + RIM_BLOCK_POINTS, count) - 1
    x = rim.reference[2]
    y = rim.quarter_turn[2]
    rise = min(
        edge.angles[0, first] * x + edge.angles[1, first] * y,
        edge.angles[0, last] * x + edge.angles[1, last] * y,
    )
    rise -= rim.sine * (RIM_BLOCK_POINTS * 2 * np.pi / count) ** 2 / 8
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
def rim_patch(disk, edge, motion, rim, contacts, first, size):
    """Return the `RimPatch` of `size` adjacent points in contact from `first` on."""
    depth_sum = 0.0
    squares = 0.0
    speed_sum = 0.0
    deepest = 0.0
    fastest = 0.0
    cosine = 0.0
    sine = 0.0
    below = 0.0
    for place in range(first, first + size):
        i = place % edge.heights.size
        depth = contacts.depth[i]
        depth_sum += depth
        squares += depth * depth
        speed_sum += depth * contacts.speed[i]
        if depth > deepest:
            deepest = depth
            fastest = abs(contacts.speed[i])
        radius = disk.radius - disk.fillet
        for j in range(edge.axial.shape[0]):
            displacement = motion.modes[0, j] * edge.endpoint_mean_factor[j]
            radius += displacement * edge.radial[j, i]
            below -= depth * displacement * edge.axial[j, i]
        cosine += depth * radius * edge.angles[0, i]
        sine += depth * radius * edge.angles[1, i]
    cosine /= depth_sum
    sine /= depth_sum
    below = disk.half_thickness - disk.fillet + below / depth_sum
    x, y, z = point_in_space(rim, cosine, sine, below)
    return RimPatch(
        first,
        size,
        depth_sum,
        squares,
        speed_sum,
        deepest,
        fastest,
        (x, y, z - disk.fillet),
    )


@kernel
def dashpot_coefficient(disk, patch, stiffness, step):
    """Return the dashpot coefficient [N s/m] of a patch of springs of a `stiffness` [N/m]."""
    lever = patch.centre[0] ** 2 + patch.centre[1] ** 2
    mobility = 1 / disk.mass + lever / disk.diametral_inertia
    # number of points of a parabolic patch, continuous when points are added; the factor is the
    # length of a parabola times the sum of its squares, divided by the square of its sum
    parabola_factor = 1.2
    length = parabola_factor * patch.depth_sum**2 / patch.square_sum
    dashpot = 2 * disk.damping_ratio * np.sqrt(stiffness * length / mobility)
    # fraction of contact in a step in which contact starts or ends; see `mean_penetration`
    return dashpot * min(1.0, np.sqrt(2 * patch.deepest / (patch.deepest_speed * step)))


@kernel
def push_disk_modes(edge, rim, patch, spring, damping, contacts):
    """Add the forces of springs and dashpot of a patch to those on the modes of the disk."""
    for j in range(edge.axial.shape[0]):
        shape = 0.0
        for place in range(patch.first, patch.first + patch.size):
            i = place % edge.heights.size
            rise = (
                edge.angles[0, i] * rim.reference[2]
                + edge.angles[1, i] * rim.quarter_turn[2]
            )
            own = edge.axial[j, i] * rim.upright + edge.radial[j, i] * rise
            shape += contacts.depth[i] / patch.depth_sum * own
        contacts.pull[ELASTIC, j] += spring * shape
        contacts.pull[DASHPOT, j] += damping * shape


@kernel
def add_sliding_friction(disk, rim, moving, patch, normal, contacts):
    """Add the friction of a patch with a `normal` force [N] on the table at rest."""
    x, y, z = patch.centre
    velocity = moving.velocity
    spin_x, spin_y, spin_z = velocity.angular
    slip_x = velocity.linear[0] + spin_y * z - spin_z * y
    slip_y = velocity.linear[1] + spin_z * x - spin_x * z
    slip = np.hypot(slip_x, slip_y)
    if slip > 0 and disk.friction > 0 and normal > 0:
        # the contact moves along the rim at the rate w_3/sin(beta)
        speed = disk.radius * np.hypot(spin_x, spin_y) / rim.sine
        ellipse = (
            2 * patch.deepest * np.sqrt(disk.radius / rim.inclination * disk.fillet)
        )
        # Kalker's coefficient of longitudinal creep for a circle, close to that of a long ellipse
        creep_coefficient = 4.5
        creep = (
            creep_coefficient * disk.shear_modulus * ellipse * slip / max(speed, slip)
        )
        limit = disk.friction * normal
        push = creep / np.sqrt(1 + (creep / limit) ** 2)
        # friction impulse divided by mass times slip velocity
        max_slip_reduction = 0.25
        push = min(push, max_slip_reduction * disk.mass / moving.duration * slip)
        friction = (-push * slip_x / slip, -push * slip_y / slip, 0.0)
        add_force(contacts, FRICTION, friction, patch.centre)


@kernel
def press_patch(disk, edge, table, rim, moving, patch, stiffness, contacts):
    """Add the forces of a `RimPatch` of springs of a `stiffness` [N/m]."""
    spring = stiffness * patch.depth_sum
    dashpot = dashpot_coefficient(disk, patch, stiffness, moving.duration)
    damping = max(dashpot * patch.depth_speed_sum / patch.depth_sum, -spring)
    add_force(contacts, ELASTIC, (0.0, 0.0, spring), patch.centre)
    add_force(contacts, DASHPOT, (0.0, 0.0, damping), patch.centre)
    if table is not None:
        push_nodes(
            table,
            contacts.depth,
            patch.first,
            patch.size,
            stiffness,
            damping / patch.depth_sum,
        )
    push_disk_modes(edge, rim, patch, spring, damping, contacts)
    add_sliding_friction(disk, rim, moving, patch, spring + damping, contacts)


@kernel
def point_stiffness(disk, edge, rim):
    """Return the stiffness [N/m] of the spring of each point of the rim."""
    cell = 2 * np.pi / edge.heights.size
    curvature_radius = disk.radius / rim.inclination
    stiffness = disk.modulus * (curvature_radius * disk.fillet) ** 0.25
    return stiffness * (cell * disk.radius / np.sqrt(2 * curvature_radius))


@kernel
def greatest_travel(disk, edge, table, moving):
    """Return an upper bound of the change of the depths in a step [m]."""
    velocity = moving.velocity
    travel = abs(velocity.linear[2])
    travel += (abs(velocity.angular[0]) + abs(velocity.angular[1])) * (
        disk.radius + disk.half_thickness
    )
    for j in range(edge.axial.shape[0]):
        travel += edge.highest[1 + j] * abs(velocity.modes[j])
    if table is not None:
        speed = velocity.table_modes
        travel += table.shape_norm * np.sqrt(scalar_product(speed, speed))
    return travel * moving.duration


@kernel
def arc_near_table(disk, edge, rim, room, min_depth):
    """Return the first point and the end of the arc whose blocks may touch the table.

    These blocks are deeper than `min_depth`, among those with points less than `room`
    above the lowest point of the rim [m]. The arc is empty if there is none.
    """
    count = edge.heights.size
    _, place, number = arc_below(edge, rim, room)
    end = place + number
    first = end
    last = end
    while place < end:
        i = place % count
        after = place + min(RIM_BLOCK_POINTS - i % RIM_BLOCK_POINTS, count - i)
        if block_depth(disk, edge, rim, i // RIM_BLOCK_POINTS) > min_depth:
            first = min(first, place)
            last = min(after, end)
        place = after
    return first, last


@kernel
def rim_arc(disk, edge, table, motion, rim, moving):
    """Return the `RimArc` of a step, and evaluate the deflections of the table below it."""
    travel = greatest_travel(disk, edge, table, moving)
    reach = 0.0
    for j in range(edge.axial.shape[0]):
        reach += edge.highest[1 + j] * abs(motion.modes[0, j])
    table_reach = 0.0
    if table is not None:
        bend = motion.table_place
        table_reach = table.shape_norm * np.sqrt(scalar_product(bend, bend))
    room = edge.highest[0] + reach + table_reach + travel - rim.height + rim.tilt
    min_depth = -travel - reach - table_reach
    first = 0
    last = 0
    if room > 0:
        first, last = arc_near_table(disk, edge, rim, room, min_depth)
    node = 0
    nodes = 0
    if table is not None and first < last:
        node, nodes = table_nodes_under_arc(
            table, first, last - first, edge.heights.size
        )
        highest = update_node_deflections(
            disk, table, motion, rim, moving.now, node, nodes
        )
        min_depth = -travel - reach - highest
    stiffness = point_stiffness(disk, edge, rim)
    return RimArc(first, last, travel, min_depth, stiffness, node, nodes)


@kernel
def write_block_depths(disk, edge, table, motion, rim, block, contacts):
    """Write the depths [m] of a block below the moving table; return the greatest one."""
    write_depths(disk, edge, motion, rim, block, contacts)
    if table is not None:
        add_table(table, DEFLECTION, block.first, block.size, contacts.depth)
    deepest = -np.inf
    for i in range(block.first, block.first + block.size):
        deepest = max(deepest, contacts.depth[i])
    return deepest


@kernel
def write_block_speeds(disk, edge, table, motion, rim, moving, block, contacts):
    """Write the speeds [m/s] at which a block approaches the moving table."""
    write_positions(disk, edge, motion, block, contacts)
    write_speeds(edge, rim, moving.velocity, block, contacts, contacts.speed)
    if moving.is_changed:
        write_speeds(edge, rim, moving.change, block, contacts, contacts.change)
    if table is not None:
        add_table(table, SPEED, block.first, block.size, contacts.speed)
        if moving.is_changed:
            add_table(table, CHANGE, block.first, block.size, contacts.change)


@kernel
def write_mean_depth(moving, travel, i, contacts):
    """Write the mean positive depth of point i in a step; return the square [m^2].

    It is that in the middle of the step, or, if the change is known, the mean of those
    at both ends.
    """
    depth = contacts.depth[i]
    if depth <= -travel:
        contacts.depth[i] = 0.0
        return 0.0
    rise = contacts.speed[i] * moving.duration
    square = max(depth, 0.0) ** 2
    if moving.is_changed:
        depth += moving.duration / 4 * contacts.change[i]
        square = mean_square_end_depth(depth, rise)
    contacts.depth[i] = mean_penetration(depth, rise)
    return square


@kernel
def write_mean_depths(disk, edge, table, motion, rim, moving, arc, contacts):
    """Write the mean positive depths of the points of an arc; return the sum of squares."""
    count = edge.heights.size
    squares = 0.0
    has_node_speeds = False
    place = arc.first
    while place < arc.last:
        i = place % count
        size = min(RIM_BLOCK_POINTS - i % RIM_BLOCK_POINTS, count - i)
        block = RimBlock(i, min(size, arc.last - place))
        is_near = block_depth(disk, edge, rim, i // RIM_BLOCK_POINTS) > arc.min_depth
        if is_near:
            is_near = (
                write_block_depths(disk, edge, table, motion, rim, block, contacts)
                > -arc.travel
            )
        if is_near:
            if table is not None and not has_node_speeds:
                has_node_speeds = True
                write_node_speeds(
                    disk, table, rim, moving, arc.first_node, arc.node_count
                )
            write_block_speeds(disk, edge, table, motion, rim, moving, block, contacts)
            for i in range(block.first, block.first + block.size):
                squares += write_mean_depth(moving, arc.travel, i, contacts)
        else:
            contacts.depth[block.first : block.first + block.size] = 0.0
        place += block.size
    return squares


@kernel
def press_patches(disk, edge, table, motion, rim, moving, arc, contacts):
    """Add the forces of all patches of an arc whose mean depths are known."""
    size = 0
    i = arc.first % edge.heights.size
    for place in range(arc.first, arc.last + 1):
        if place < arc.last and contacts.depth[i] > 0:
            size += 1
        elif size > 0:
            patch = rim_patch(disk, edge, motion, rim, contacts, place - size, size)
            press_patch(disk, edge, table, rim, moving, patch, arc.stiffness, contacts)
            size = 0
        i += 1
        if i == edge.heights.size:
            i = 0


@kernel
def press_rim(disk, edge, table, motion, rim, moving, contacts):
    """Write the forces of all patches in a `StepMotion` and return their elastic energy [J].

    The energy is that in the middle of the step, or, if the change is known, the mean
    of those at both ends.
    """
    arc = rim_arc(disk, edge, table, motion, rim, moving)
    if arc.first == arc.last:
        return 0.0
    squares = write_mean_depths(disk, edge, table, motion, rim, moving, arc, contacts)
    press_patches(disk, edge, table, motion, rim, moving, arc, contacts)
    if table is not None:
        push_table(disk, table, motion, rim, arc.first_node, arc.node_count, contacts)
    return arc.stiffness * squares / 2


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
        if block_depth(disk, edge, rim, i // RIM_BLOCK_POINTS) > -reach:
            return False
        place += min(RIM_BLOCK_POINTS - i % RIM_BLOCK_POINTS, count - i)
    return True
