"""The normal part of a step on a table of modes, regular where the disk lies flat. It cannot gain energy (compiled).

The rim touches in the horizontal direction e where its gap G = z - R n.e + H (1 - c) - sum q_m w_m - r is least, n
being the axis, c = n_z, and r how high table and edge are along the path of the contact and round the edge. With e and
the shapes w_m of that place at both ends of a step h, and ~ for the mean of both ends,

    dG = dz - u.dn - sum w~ dq + T,    u = (R e~, H),    T = -R n~.de - sum q~ dw - dr,

without a remainder; T is of the third order, because G is least. With U = 2/5 K (-G)^2.5 and the quotient N = -dU/dG
the force N on the centre, the torque N u x n~ and -N w~ on every mode do the work N (dG - T), so that kinetic energy +
m g z + U + the energy of the modes is kept but for -N T, which is put back into the velocities of the disk in
proportion, or taken out of U. K is that of the present inclination: where it grows the force is kept, where it falls
the approach, and both take energy. The horizontal force of the sloping table, of which a disk whose centre moves over
it would take a little work, is left out.
"""

import numpy as np

from . import state as at
from .bending import twist_rate
from .compiled import kernel
from .contact import LEAST_INCLINATION
from .gap import column, mean_force, place, root
from .normal import CLOSE, MOST, turned
from .table import LOSS, A, K
from .tangential import hold_at
from .waves import ANGLE, STIFF, TWIST, fall_free, follow, move_modes, sums, turned_by

JUMP = 0.3
"""Where the contact turns by more [rad] in a step it is another one: it did not roll there."""


@kernel
def soften(y, waves, spline):
    """Take the stiffness of the gap's energy to that of the present inclination, with the force or the approach as it
    was."""
    K0, K1, r0 = waves.contact[STIFF], column(spline, int(y[at.CELL]), y[at.PART], K), root(y[at.GAP])
    if r0 > 0 and K0 > 0:
        r1 = r0 * min(1.0, (K0 / K1) ** (1 / 3))
        y[at.LOSSES] += 0.4 * (K0 * r0**5 - K1 * r1**5)
        y[at.GAP] = -r1 * r1
    waves.contact[STIFF] = K1


@kernel
def step_waving(y, law, start, per_unit, spline, table, rim, waves, scratch, h):
    """Advance the state y and the modes by the normal part of a step h; return whether the equation was solved."""
    m, J, R, H, weight = law[at.MASS], law[at.J1], law[at.RADIUS], law[at.HALF], law[at.WEIGHT]
    twist, i, u = h / (2 * J), int(y[at.CELL]), y[at.PART]
    soften(y, waves, spline)
    stiff, loss = waves.contact[STIFF], column(spline, i, u, LOSS) / h
    v0, v1, v2, n0, n1, n2, L0, L1, L2 = y[3], y[4], y[5], y[6], y[7], y[8], y[9], y[10], y[11]
    p0, p1, p2 = turned(n0, n1, n2, twist * L0, twist * L1, twist * L2)
    a0, a1, a2 = n0 + p0, n1 + p1, n2 + p2
    fall_free(waves, h)
    before, twisted = waves.contact[ANGLE], h * twist_rate(law, n0, n1, n2, L0, L1, L2)
    waves.contact[TWIST] += twisted
    along = y[at.PATH] + h * (v1 * np.cos(before) - v0 * np.sin(before))
    edge = y[at.EDGE] + R * (turned_by(np.arctan2(n1, n0), before) - twisted)
    rough = table, rim, along, edge, column(spline, i, u, A)
    angle, high, far = follow(waves, law, y[0] + h * v0, y[1] + h * v1, a0, a1, a2, rough, scratch)
    rise = high - y[at.HEIGHTS] - y[at.HEIGHTS + 1]
    D, E, P, S = sums(waves, h)
    e0, e1 = (np.cos(before) + np.cos(angle)) / 2, (np.sin(before) + np.sin(angle)) / 2
    c0, c1 = np.cos(angle) - np.cos(before), np.sin(angle) - np.sin(before)
    W = 1 / m + R * R / J
    gap0, r0 = y[at.GAP], root(y[at.GAP])
    N = max(0.0, 3 * (y[at.FORCE] - y[at.LAST]) + y[at.LAST + 1])
    gap, M0, M1, M2, V2, kept, T, left = gap0, L0, L1, L2, v2, 0.0, 0.0, MOST
    while left > 0:
        left -= 1
        V2 = v2 + h / (2 * m) * (N - weight)
        t0, t1, t2 = (n0 + a0) / 2, (n1 + a1) / 2, (n2 + a2) / 2
        M0 = L0 + h / 2 * N * (R * e1 * t2 - H * t1)
        M1 = L1 + h / 2 * N * (H * t0 - R * e0 * t2)
        M2 = L2 + h / 2 * N * R * (e0 * t1 - e1 * t0)
        q0, q1, q2 = turned(n0, n1, n2, twist * M0, twist * M1, twist * M2)
        missed = abs(n0 + q0 - a0) + abs(n1 + q1 - a1) + abs(n2 + q2 - a2)
        a0, a1, a2 = n0 + q0, n1 + q1, n2 + q2
        T = -R * ((n0 + a0) * c0 + (n1 + a1) * c1) / 2 - (P - S * N) - rise
        dgap = h * V2 - R * (e0 * q0 + e1 * q1) - H * q2 - (D - E * N) + T
        gap = gap0 + dgap
        r1 = root(gap)
        kept = stiff * mean_force(r0, r1, gap0, gap)
        error = max(0.0, kept * (1 - loss * dgap)) - N
        if left < MOST - 1 and abs(error) <= CLOSE * (N + weight) and missed < CLOSE:
            break
        steep = stiff * (r0 / 2 + r1)
        N = max(0.0, N + error / (1 + steep * (h * h / 4 * W + E / 2) + loss * kept * (h * h / 2 * W + E)))
    if left == 0:
        return False
    y[at.LOSSES] += (kept - N) * (gap - gap0)
    y[at.EDGE] += R * (np.arctan2(n0 * a1 - n1 * a0, n0 * a0 + n1 * a1) - twisted)
    table, body = move_modes(waves, N, h)
    y[at.LOSSES + 4], y[at.LOSSES + 6] = y[at.LOSSES + 4] + table, y[at.LOSSES + 6] + body
    y[0], y[1], y[2] = y[0] + h * v0, y[1] + h * v1, y[2] + h * V2
    y[5], y[6], y[7], y[8] = 2 * V2 - v2, a0, a1, a2
    y[9], y[10], y[11] = 2 * M0 - L0, 2 * M1 - L1, 2 * M2 - L2
    turn = abs(turned_by(before, angle))
    y[at.PATH], y[at.HEIGHTS], y[at.HEIGHTS + 1] = along + far, high, 0.0
    if turn < JUMP:
        y[at.SPEED] = R * turn / h
    waves.contact[ANGLE] = angle
    y[at.LAST + 1], y[at.LAST], y[at.FORCE], y[at.GAP] = y[at.LAST], y[at.FORCE], N, gap
    put_back(y, law, waves, N * T)
    y[at.SINE] = np.sqrt(a0 * a0 + a1 * a1)
    y[at.CELL], y[at.PART] = place(max(y[at.SINE], LEAST_INCLINATION), start, per_unit, len(spline))
    return True


@kernel
def hold_waving(y, law, powers, spline, waves, h):
    """Advance y by the tangential part of a step h; the directions t, d are not quite principal ones of the mobility
    away from the lowest point, and what the midpoint rule misses there is put back into the velocities."""
    held = kinetic(y, law) + stored(y)
    angle = waves.contact[ANGLE]
    hold_at(y, law, powers, spline, np.cos(angle), np.sin(angle), h)
    put_back(y, law, waves, held - kinetic(y, law) - stored(y))


@kernel
def stored(y):
    """Return the energy of the springs and of squeezed air, and what was lost so far."""
    springs = y[at.STIFFNESS] * y[at.SPRING] ** 2 + y[at.STIFFNESS + 1] * y[at.SPRING + 1] ** 2
    return springs / 2 + y[at.SQUEEZED] + y[at.LOSSES + 1] + y[at.LOSSES + 2] + y[at.LOSSES + 3] + y[at.LOSSES + 5]


@kernel
def kinetic(y, law):
    """Return the kinetic energy of the disk."""
    spin, e = y[6] * y[9] + y[7] * y[10] + y[8] * y[11], 1 / law[at.J2] - 1 / law[at.J1]
    turning = (y[9] * y[9] + y[10] * y[10] + y[11] * y[11]) / law[at.J1] + e * spin * spin
    return (law[at.MASS] * (y[3] * y[3] + y[4] * y[4] + y[5] * y[5]) + turning) / 2


@kernel
def put_back(y, law, waves, work):
    """Change the kinetic energy of the disk by a work, every velocity in proportion; what it has not the gap gives, and
    what that has not, where a disk that lies all but flat comes to another wave, the velocities of the modes. What
    none of them has is owed: all is at rest, and the motion ends."""
    energy = kinetic(y, law)
    change = max(work, -energy)
    scale = np.sqrt(1 + change / energy) if energy > 0 else 0.0
    for i in range(3):
        y[3 + i], y[9 + i] = scale * y[3 + i], scale * y[9 + i]
    if energy > 0 and change == work:
        return
    left, r = change - work, root(y[at.GAP])
    most = 0.4 * waves.contact[STIFF] * r**5
    if most > 0 and left > 0:
        y[at.GAP] *= max(0.0, 1 - left / most) ** 0.4
    left -= min(left, most)
    moving = 0.0
    for m in range(len(waves.state)):
        moving += waves.state[m, at.V] ** 2 / 2
    if moving > 0 and left > 0:
        scale = np.sqrt(max(0.0, 1 - left / moving))
        for m in range(len(waves.state)):
            waves.state[m, at.V] *= scale
        left -= min(left, moving)
    y[at.LOSSES], y[at.OWED] = y[at.LOSSES] - left, y[at.OWED] + left
