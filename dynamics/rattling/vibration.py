"""Free vibration of disk and table, and the table under the rim.

The table rises under the rim by W(x, y) = sum q_m w_m(x, y). The contact force is the
gradient of the elastic energy with respect to all coordinates of the gap: a force N
drives the modes by -N w_m and pushes the rim by (-N dW/dx, -N dW/dy, N). Between contacts
the modes vibrate freely and are advanced exactly, like those of the disk, but in one
flight from one evaluation of the table to the next. W is evaluated at nodes around the
rim and interpolated by the cubic through the four nearest nodes; the forces are spread over
these nodes with the same weights, so that both do the same work. Waves above the highest
mode are neglected.
"""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from dynamics.numba_kernels import kernel
from dynamics.rattling.body import (
    MotionState,
    PressedDisk,
    RimGeometry,
    Velocities,
    add_force,
    point_in_space,
    scalar_product,
)
from dynamics.rattling.layout import CENTRE, DASHPOT, ELASTIC, RattlingDisk
from dynamics.stepping_core.oscillators import ExactModes
from dynamics.stepping_core.table_shapes import (
    TableShapes,
    store_table_shapes,
    store_table_slopes,
)

if TYPE_CHECKING:
    from dynamics.stepping_core.vectors import Triple


class MovingTable(NamedTuple):
    """Modes of a table, of unit modal mass, at k nodes around the rim.

    Attributes
    ----------
    surface : TableShapes
        Mode shapes of the table.
    modes : ExactModes
        Frequencies and decay rates of the t modes.
    shape_norm : float
        Greatest norm of the interpolated mode shapes at a point [kg^-1/2].
    shapes : ndarray, shape (k, t)
        Mode shapes at the nodes [kg^-1/2], times their `mean_factor`.
    slopes : ndarray, shape (k, 2, t)
        Slopes of the mode shapes along x and y at the nodes [kg^-1/2/m], times their `mean_factor`.
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
    node : ndarray of int, shape (p, 4)
        The two nodes before and the two after each point of the rim.
    weight : ndarray, shape (p, 4)
        Weights of these nodes.
    """

    surface: TableShapes
    modes: ExactModes
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
    weight: np.ndarray


DEFLECTION, SPEED, CHANGE = range(3)
"""Rows of `MovingTable.motion`."""


INTERPOLATION_NORM = 1.25
"""Greatest sum of the magnitudes of the four weights, in the middle between two nodes."""


def interpolation_at(place: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the four nearest of `count` nodes (p, 4) of a ring, and their weights (p, 4).

    `place` (p,) is the position on the ring in units of the distance of two nodes. A cubic
    through four nodes is wrong by at most 3/128 (n d)^4 for a wave of order n at a distance d
    [rad] of the nodes.
    """
    before = np.floor(place).astype(int)
    u = (place - before)[:, None]
    nodes = np.arange(-1, 3)
    weight = np.ones((len(place), 4))
    for k in range(4):
        for other in nodes[nodes != nodes[k]]:
            weight[:, k : k + 1] *= (u - other) / (nodes[k] - other)
    return (before[:, None] + nodes) % count, weight


@kernel
def fly_table(table: MovingTable, motion: MotionState, propagator: np.ndarray) -> None:
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
def table_energy(table: MovingTable, motion: MotionState) -> float:
    """Return the energy [J] of the modes of the table."""
    speed = motion.table_speed
    rate = table.work
    for j in range(rate.size):
        rate[j] = table.modes.frequency[j] * motion.table_place[j]
    return (scalar_product(rate, rate) + scalar_product(speed, speed)) / 2


@kernel
def work_lost_to_damping(
    table: MovingTable, motion: MotionState, gain: np.ndarray, step: float
) -> float:
    """Return the part [J] of the work on the table modes that damping dissipates in a step.

    The impulses that change the speeds by `gain` (t,) represent forces that act during the
    whole step, in which the displacements decay. The work of these forces is smaller than
    that of the impulses; the difference is of first order in the decay rates.
    """
    lost = table.work
    for j in range(lost.size):
        bend = table.modes.frequency[j] ** 2 * motion.table_place[j]
        lost[j] = table.modes.decay[j] * (gain[j] * step / 4 - bend * step**2 / 12)
    return scalar_product(gain, lost)


@kernel
def table_deflection_bound(table: MovingTable, motion: MotionState) -> float:
    """Return an upper amplitude [m] of the table deflection until the next contact."""
    place = motion.table_place
    amplitude = table.work
    for j in range(amplitude.size):
        amplitude[j] = motion.table_speed[j] / table.modes.frequency[j]
    squares = scalar_product(place, place) + scalar_product(amplitude, amplitude)
    return table.shape_norm * np.sqrt(squares)


@kernel
def add_table(
    table: MovingTable, row: int, first: int, size: int, out: np.ndarray
) -> None:
    """Add a row of `MovingTable.motion` at `size` points from `first` on to `out` (p,).

    The row is interpolated between the nodes.
    """
    motion = table.motion[row]
    node = table.node
    weight = table.weight
    for i in range(first, first + size):
        for k in range(4):
            out[i] += weight[i, k] * motion[node[i, k]]


@kernel
def push_nodes(
    table: MovingTable,
    depth: np.ndarray,
    left: int,
    points: int,
    spring: float,
    damping: float,
) -> None:
    """Add the forces of a patch to the nodes of the table.

    `spring` and `damping` are the forces divided by the sum of the depths [N/m].
    """
    force = table.force
    for m in range(left, left + points):
        i = m % depth.size
        for k in range(4):
            pressed = table.weight[i, k] * depth[i]
            force[ELASTIC, table.node[i, k]] += spring * pressed
            force[DASHPOT, table.node[i, k]] += damping * pressed


@kernel
def table_nodes_under_arc(
    table: MovingTable, first: int, number: int, points: int
) -> tuple[int, int]:
    """Return the first of the nodes on which an arc of the rim depends, and their number.

    The arc consists of `number` points from `first` on, of `points` in all."""
    nodes = table.known_since.size
    begin = int(np.floor(first * nodes / points)) - 1
    end = int(np.floor((first + number) * nodes / points)) + 2
    return begin, min(end - begin + 1, nodes)


@kernel
def node_arm(
    disk: RattlingDisk, table: MovingTable, rim: RimGeometry, node: int
) -> "Triple":
    """Return the vector (x, y, z) [m] from the centre of the disk to a node of the rim."""
    angle = 2 * np.pi * node / table.known_since.size
    c = disk.core_radius * np.cos(angle)
    s = disk.core_radius * np.sin(angle)
    return point_in_space(rim, c, s, disk.core_depth)


@kernel
def update_node_mode_shapes(
    table: MovingTable,
    node: int,
    x: float,
    y: float,
    now: float,
    basis_x: np.ndarray,
    basis_y: np.ndarray,
) -> None:
    """Update the mode shapes of a node that has moved to (x, y) [m]."""
    linear_time = 1e-4  # s, for which the shapes near a node are linear
    shapes = table.shapes[node]
    slopes = table.slopes[node]
    if now - table.known_since[node] > linear_time:
        table.known_since[node] = now
        store_table_shapes(table.surface, x, y, basis_x, basis_y, shapes)
        store_table_slopes(table.surface, x, y, basis_x, basis_y, slopes)
        for m in range(shapes.size):
            shapes[m] *= table.modes.mean_factor[m]
            slopes[0, m] *= table.modes.mean_factor[m]
            slopes[1, m] *= table.modes.mean_factor[m]
    else:
        step_x = x - table.position[node, 0]
        step_y = y - table.position[node, 1]
        for m in range(shapes.size):
            shapes[m] += slopes[0, m] * step_x + slopes[1, m] * step_y
    table.position[node, 0] = x
    table.position[node, 1] = y


@kernel
def update_node_deflections(
    pressed: PressedDisk,
    table: MovingTable,
    rim: RimGeometry,
    now: float,
    begin: int,
    count: int,
) -> float:
    """Evaluate the deflection of the table at `count` nodes from `begin` on, and clear their
    forces; return an upper bound of the deflection between them [m].
    """
    disk, _, motion, _ = pressed
    for m in range(table.displacement.size):
        table.displacement[m] = (
            table.modes.endpoint_mean_factor[m] * motion.table_place[m]
        )
    basis_x = np.empty((3, 4))
    basis_y = np.empty((3, 4))
    highest = -np.inf
    lowest = np.inf
    for n in range(begin, begin + count):
        node = n % table.known_since.size
        table.force[ELASTIC, node] = 0.0
        table.force[DASHPOT, node] = 0.0
        if table.evaluated[0, node] != now:
            table.evaluated[0, node] = now
            x, y, _ = node_arm(disk, table, rim, node)
            x += table.surface.is_fixed * motion.disk[CENTRE, 0]
            y += table.surface.is_fixed * motion.disk[CENTRE, 1]
            update_node_mode_shapes(table, node, x, y, now, basis_x, basis_y)
            table.motion[DEFLECTION, node] = scalar_product(
                table.shapes[node], table.displacement
            )
        highest = max(highest, table.motion[DEFLECTION, node])
        lowest = min(lowest, table.motion[DEFLECTION, node])
    return highest + (INTERPOLATION_NORM - 1) / 2 * (highest - lowest)


@kernel
def write_node_speeds(
    disk: RattlingDisk,
    table: MovingTable,
    rim: RimGeometry,
    velocities: tuple[Velocities, Velocities],
    is_changed: bool,
    now: float,
    begin: int,
    count: int,
) -> None:
    """Evaluate slopes and speed of the table at `count` nodes from `begin` on.

    `velocities` is the pair of the mean velocity and of its change in the step. A speed that
    was evaluated before the change is corrected by half of it.
    """
    velocity, change = velocities
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
def node_speed(
    disk: RattlingDisk,
    table: MovingTable,
    rim: RimGeometry,
    velocity: Velocities,
    node: int,
) -> float:
    """Return the speed [m/s] at which the table rises under a node of the moving rim."""
    x, y, z = node_arm(disk, table, rim, node)
    spin_x, spin_y, spin_z = velocity.angular
    # velocity of the node relative to the mode shapes
    moved_x = table.surface.is_fixed * velocity.linear[0] + spin_y * z - spin_z * y
    moved_y = table.surface.is_fixed * velocity.linear[1] + spin_z * x - spin_x * z
    return (
        scalar_product(table.shapes[node], velocity.table_modes)
        + table.incline[node, 0] * moved_x
        + table.incline[node, 1] * moved_y
    )


@kernel
def push_table(
    pressed: PressedDisk,
    table: MovingTable,
    rim: RimGeometry,
    begin: int,
    count: int,
) -> None:
    """Add the forces on `count` nodes from `begin` on to those on the modes of the table, and their
    horizontal parts to those on the disk.
    """
    disk, _, motion, contacts = pressed
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
            contacts.force[origin, 0] -= (1 - table.surface.is_fixed) * push_x
            contacts.force[origin, 1] -= (1 - table.surface.is_fixed) * push_y
