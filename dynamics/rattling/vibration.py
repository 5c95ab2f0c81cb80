"""Free vibration of disk and table, and the table under the rim.

The table rises under the rim by W(x, y) = sum q_m w_m(x, y). The contact force is the
gradient of the elastic energy with respect to all coordinates of the gap: a force N
drives the modes by -N w_m and pushes the rim by (-N dW/dx, -N dW/dy, N). Between contacts
the modes vibrate freely and are advanced exactly, like those of the disk, but in one
flight from one evaluation of the table to the next. W is evaluated at nodes around the
rim and interpolated linearly. Waves above the highest mode are neglected.
"""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.stepping.round_table import RoundTable
from dynamics.compliant.stepping.table_modes import (
    store_table_shapes,
    store_table_slopes,
)
from dynamics.numba_kernels import kernel
from dynamics.rattling.body import add_force, point_in_space, scalar_product
from dynamics.rattling.layout import CENTRE, DASHPOT, ELASTIC


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
    mean_factor, endpoint_mean_factor : ndarray, shape (t,)
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
    endpoint_mean_factor: np.ndarray
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
def update_node_deflections(disk, table, motion, rim, now, begin, count):
    """Evaluate the deflection of the table at `count` nodes from `begin` on, and clear their
    forces; return the greatest deflection [m].
    """
    for m in range(table.displacement.size):
        table.displacement[m] = table.endpoint_mean_factor[m] * motion.table_place[m]
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
