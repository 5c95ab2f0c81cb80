"""Contacts along the rim of a rattling disk.

Springs act at points along the rim. The force of each is linear in its depth, and the sum
is Hertz's force of the smooth contact. Adjacent points in contact form a patch. A dashpot
acts on the depth-weighted mean approach speed of a patch, because dashpots at single
points would resist rolling.
"""

import numpy as np

from dynamics.numba_kernels import kernel
from dynamics.rattling.body import (
    PressedDisk,
    RimGeometry,
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
    LowerEdge,
    RattlingDisk,
)
from dynamics.rattling.vibration import (
    CHANGE,
    DEFLECTION,
    SPEED,
    MovingTable,
    add_table,
    push_nodes,
    push_table,
    table_nodes_under_arc,
    update_node_deflections,
    write_node_speeds,
)


@kernel
def write_depths(pressed: PressedDisk, rim: RimGeometry, first: int, size: int) -> None:
    """Write the depths [m] of the points of a block below a table at rest.

    The block has `size` points and begins at the point `first`. Depths are negative
    above the table.
    """
    disk, edge, motion, contacts = pressed
    points = slice(first, first + size)
    heights = edge.heights[points]
    cosine = edge.angles[0, points]
    sine = edge.angles[1, points]
    depth = contacts.depth[points]
    rise = contacts.rise
    x = rim.reference[2]
    y = rim.quarter_turn[2]
    radius = disk.core_radius
    for i in range(size):
        rise[i] = cosine[i] * x + sine[i] * y
    for i in range(size):
        depth[i] = heights[i] - rim.height - radius * rise[i]
    for j in range(edge.axial.shape[0]):
        axial = edge.axial[j, points]
        radial = edge.radial[j, points]
        place = motion.modes[0, j] * edge.modes.endpoint_mean_factor[j]
        for i in range(size):
            depth[i] -= place * (axial[i] * rim.upright + radial[i] * rise[i])


@kernel
def write_speeds(
    pressed: PressedDisk,
    rim: RimGeometry,
    velocity: Velocities,
    first: int,
    size: int,
    out: np.ndarray,
) -> None:
    """Write the speeds [m/s] at which points approach a table at rest to `out` (p,).

    The points are those of the last call of `write_depths`.
    """
    disk, edge, motion, contacts = pressed
    points = slice(first, first + size)
    speed = out[points]
    rise = contacts.rise
    radius = contacts.radius
    below = contacts.below
    for i in range(size):
        speed[i] = -velocity.linear[2]
        radius[i] = disk.core_radius
        below[i] = disk.core_depth
    for j in range(edge.axial.shape[0]):
        axial = edge.axial[j, points]
        radial = edge.radial[j, points]
        place = motion.modes[0, j] * edge.modes.endpoint_mean_factor[j]
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
def block_depth(
    disk: RattlingDisk, edge: LowerEdge, rim: RimGeometry, block: int
) -> float:
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
    return edge.block_heights[block] - rim.height - disk.core_radius * rise


@kernel
def arc_below(edge: LowerEdge, rim: RimGeometry, room: float) -> tuple[float, int, int]:
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
def mean_penetration(depth: float, travel: float) -> float:
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
def mean_square_end_depth(depth: float, travel: float) -> float:
    """Return the mean square of the positive depths at both ends of a step.

    `depth` is their mean, and `travel` is their difference.
    """
    first = max(depth - travel / 2, 0.0)
    last = max(depth + travel / 2, 0.0)
    return (first**2 + last**2) / 2


@kernel
def press_patch(
    table: MovingTable | None,
    pressed: PressedDisk,
    rim: RimGeometry,
    velocity: Velocities,
    stiffness: float,
    step: float,
    left: int,
    points: int,
) -> None:
    """Add the forces of a patch of `points` adjacent points that begins at the point
    `left`."""
    disk, edge, motion, contacts = pressed
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
        radius = disk.core_radius
        for j in range(edge.axial.shape[0]):
            displacement = motion.modes[0, j] * edge.modes.endpoint_mean_factor[j]
            radius += displacement * edge.radial[j, i]
            below -= depth * displacement * edge.axial[j, i]
        cosine += depth * radius * edge.angles[0, i]
        sine += depth * radius * edge.angles[1, i]
    cosine /= depth_sum
    sine /= depth_sum
    below = disk.core_depth + below / depth_sum
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
    table: MovingTable | None,
    pressed: PressedDisk,
    rim: RimGeometry,
    velocity: Velocities,
    change: Velocities,
    is_changed: bool,
    now: float,
    step: float,
) -> float:
    """Write the forces of all patches and return their elastic energy [J]: that in the middle
    of the step, or, if `is_changed`, the mean of those at both ends.

    `velocity` is the mean velocity in the step, and `change` its change, by which the
    depths at both ends deviate from uniform motion; it is zero unless `is_changed`.
    """
    disk, edge, motion, contacts = pressed
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
        after = place + min(RIM_BLOCK_POINTS - i % RIM_BLOCK_POINTS, count - i)
        if block_depth(disk, edge, rim, i // RIM_BLOCK_POINTS) > min_depth:
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
        highest = update_node_deflections(pressed, table, rim, now, begin, nodes)
        min_depth = -travel - reach - highest
    points = 0
    left = first
    squares = 0.0
    place = first
    while place < last:
        begin_of_block = place % count
        size = min(
            RIM_BLOCK_POINTS - begin_of_block % RIM_BLOCK_POINTS, count - begin_of_block
        )
        size = min(size, last - place)
        block = begin_of_block // RIM_BLOCK_POINTS
        is_near = block_depth(disk, edge, rim, block) > min_depth
        if is_near:
            write_depths(pressed, rim, begin_of_block, size)
            if table is not None:
                add_table(table, DEFLECTION, begin_of_block, size, contacts.depth)
            deepest = -np.inf
            for i in range(begin_of_block, begin_of_block + size):
                deepest = max(deepest, contacts.depth[i])
            is_near = deepest > -travel
        if is_near:
            write_speeds(pressed, rim, velocity, begin_of_block, size, contacts.speed)
            if is_changed:
                write_speeds(
                    pressed, rim, change, begin_of_block, size, contacts.change
                )
            if table is not None:
                if not has_node_speeds:
                    has_node_speeds = True
                    write_node_speeds(
                        disk,
                        table,
                        rim,
                        (velocity, change),
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
                    table, pressed, rim, velocity, stiffness, step, left, points
                )
                points = 0
        place += size
    if table is not None:
        push_table(pressed, table, rim, begin, nodes)
    return stiffness * squares / 2


@kernel
def stays_clear(
    pressed: PressedDisk,
    rim: RimGeometry,
    max_deflection: float,
    gravity: float,
    duration: float,
) -> bool:
    """Return True if no point of the rim can touch the table within `duration` [s].

    The amplitudes of the modes bound their displacements; those of the table deflect it
    by at most `max_deflection` [m]. The lowest point of the rim falls at its present
    rate, accelerated by gravity, the rotation and the air film.
    """
    disk, edge, motion, contacts = pressed
    state = motion.disk
    lean = state[MOMENTUM, 0] * state[AXIS, 1] - state[MOMENTUM, 1] * state[AXIS, 0]
    lean /= disk.diametral_inertia  # rate of the cosine of the inclination
    below = disk.core_depth
    radius = disk.core_radius
    rate = state[VELOCITY, 2] - lean * (below - radius * rim.upright / rim.sine)
    turning = 0.0
    for i in range(3):
        turning += (state[MOMENTUM, i] / disk.diametral_inertia) ** 2
    fastest = gravity + 2 * (radius + below) * turning / rim.sine
    fastest += 10 * abs(contacts.force[FILM, 2]) / disk.mass
    reach = duration**2 / 2 * fastest - min(duration * rate, 0.0)
    for j in range(edge.axial.shape[0]):
        speed = motion.modes[1, j] / edge.modes.frequency[j]
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
