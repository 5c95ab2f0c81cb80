"""The normal part of a step: gravity, the gap's energy, its loss, the yielding table. It cannot gain energy.

With v, L velocity and angular momentum, n the axis, J1, J2 the moments of inertia, e = 1/J2 - 1/J1, and ~ for the mean
of both ends of a step h:  dz = h v~,  dn = (h/J1) L~ x n~,  m dv = h (F - m g),  dL = h T.  Then |n| stays, and with
w~ = L~/J1 + e (L.n)~ n~ the kinetic energy changes by h (F.v~ + T.w~) exactly, whatever h: d(L.n) = h T.n~.

The gap is G = z - R s + H (1 - c) - w - z_t(path) - z_r(edge) with s = |n_xy| = sin(beta); its energy U = 2/5 K(s)
(-G)^2.5. Quotients of differences N = -dU/dG, g = dU/ds, m_t = dz_t/dpath, m_r = dz_r/dedge, f = R - H (s0 + s1)/(c0 +
c1) give dU = -N dG + g ds and dG = dz - f ds - dw - m_t dpath - m_r dedge without a remainder. The path lengths advance
by dpath = h (t.v~ + a.w~), dedge = h b.w~, so the force N (e3 - m_t t) and the torque (N f + g)/s~ n~_xy x n~ -
N (m_t a + m_r b) do the work -dU - N dw: kinetic energy + m g z + U is kept.

To N comes the loss c N of the approach, and N is never negative. Both only take energy: -c N (dG)^2/h, or, where the
contact tears off, what U still held. The table yields by dw = -h (N - m g)/Z and carries the weight, so that
m g (z - w) stands for m g z, and h (N - m g)^2/Z is radiated. The proof needs the one scalar equation for N solved.
"""

import numpy as np

from . import state as at
from .compiled import kernel
from .gap import column, mean_force, place, root, slope
from .profile import height
from .table import LOSS, A, K

CLOSE, MOST = 1e-12, 40
"""The equation for N is solved to this part of N and the weight, within so many iterations."""
NEAR = 3e-6
"""From so near the last step of Newton's method is taken along straight lines: an impact then keeps its energy to
1e-12, for which what is guessed has to know the energy of the gap as well as the force."""
STANDS, READ, READS = 1e-10, 1e-9, 3
"""A path that moves by less [m] in a step stands; heights are read again, a few times, where it moves by more [m].

The balance of energy does not depend on where exactly they were read: the slopes are quotients with the path as moved.
"""
FEWEST = 1e-4
"""Where sin(beta) changes by a smaller part of itself, the mean of dK/ds at both ends is exact to rounding."""


@kernel
def turned(n0, n1, n2, b0, b1, b2):
    """Return m - n where m - n = b x (m + n)."""
    k0, k1, k2 = b1 * n2 - b2 * n1, b2 * n0 - b0 * n2, b0 * n1 - b1 * n0
    q = 2 / (1 + b0 * b0 + b1 * b1 + b2 * b2)
    return q * (k0 + b1 * k2 - b2 * k1), q * (k1 + b2 * k0 - b0 * k2), q * (k2 + b0 * k1 - b1 * k0)


@kernel
def read(profile, path, moved, half, before):
    """Return the height at the end of a step along a path, that of before where the path stands."""
    return height(profile, path + moved, half) if abs(moved) > STANDS else before


@kernel
def secant(y0, y1, dx):
    """Return the mean slope of what is read along a path, 0 where the path stands."""
    return (y1 - y0) / dx if abs(dx) > STANDS else 0.0


@kernel
def half_way(N, turn, roll, slope, A0, A1, reach, d0, d1, y, push, h, weight):
    """Return velocity and angular momentum half a step on, under the force N and its torques; A is n at both ends."""
    V0, V1, V2 = y[3] + push * N * slope * d1, y[4] - push * N * slope * d0, y[5] + push * (N - weight)
    M0, M1 = y[9] + h / 2 * (turn * A1 + roll * d0), y[10] + h / 2 * (roll * d1 - turn * A0)
    return V0, V1, V2, M0, M1, y[11] - h / 2 * N * slope * reach


@kernel
def step_normal(y, law, start, per_unit, spline, table, rim, h):
    """Advance the state y by the normal part of a step h; return whether the equation for N was solved."""
    m, J, R, H, weight = law[at.MASS], law[at.J1], law[at.RADIUS], law[at.HALF], law[at.WEIGHT]
    push, twist, yields, ease = h / (2 * m), h / (2 * J), h / law[at.IMPEDANCE], 1 / J
    e, size = 1 / law[at.J2] - 1 / J, len(spline)
    n0, n1, n2, L0, L1, L2 = y[6], y[7], y[8], y[9], y[10], y[11]
    # what the step starts from: the energy of the gap, K and its loss
    s0, c0, spin, i, u = y[at.SINE], n2, L0 * n0 + L1 * n1 + L2 * n2, int(y[at.CELL]), y[at.PART]
    K0, loss, dK = column(spline, i, u, K), column(spline, i, u, LOSS), slope(spline, i, u, K) * per_unit / s0
    loss, half = loss / h, column(spline, i, u, A)
    rough0, rough1 = y[at.HEIGHTS], y[at.HEIGHTS + 1]
    gap0, r0 = y[at.GAP], root(y[at.GAP])
    U0 = 0.4 * r0**5
    # the directions d towards the contact and t along the path, half a step on; a = reach e3 - lever d, b = -(R/s) d
    p0, p1, p2 = turned(n0, n1, n2, twist / 2 * L0, twist / 2 * L1, twist / 2 * L2)
    p0, p1, p2 = n0 + p0, n1 + p1, n2 + p2
    sp = np.sqrt(p0 * p0 + p1 * p1)
    d0, d1, reach, rim_lever = p0 / sp, p1 / sp, R * p2 - H * sp, R / sp
    lever = reach * p2 / sp
    # a first guess: without the heights the gap is far smoother than the force
    N, g, rises = 0.0, 0.0, 3 * (y[at.RISES] - y[at.RISES + 1]) + y[at.RISES + 2]
    A0, A1, A2, inverse, lean = 2 * p0, 2 * p1, 2 * p2, 0.5 / sp, R - H * sp / p2
    wd = (L0 * d0 + L1 * d1) * ease + e * spin * sp
    dpath, dedge = h * (d0 * y[4] - d1 * y[3] + reach * (L2 * ease + e * spin * p2) - lever * wd), -h * rim_lever * wd
    z0, z1, mt, mr, read_path, read_edge, left, near = rough0, rough1, 0.0, 0.0, np.inf, np.inf, MOST, False
    while not near:
        if left == 0:
            return False
        left -= 1
        if left >= MOST - READS and max(abs(dpath - read_path), abs(dedge - read_edge)) > READ:
            read_path, read_edge = dpath, dedge
            z0, z1 = read(table, y[at.PATH], dpath, half, rough0), read(rim, y[at.EDGE], dedge, half, rough1)
            mt, mr = secant(rough0, z0, dpath), secant(rough1, z1, dedge)
            if left == MOST - 1:
                dgap = rises - (z0 - rough0) - (z1 - rough1)
                r1 = root(gap0 + dgap)
                N = max(0.0, K0 * mean_force(r0, r1, gap0, gap0 + dgap) * (1 - loss * dgap))
                g = (U0 + 0.4 * r1**5) / 2 * dK
        turn, roll = (N * lean + g) * A2 * inverse / 2, N * (mt * lever + mr * rim_lever)
        V0, V1, V2, M0, M1, M2 = half_way(N, turn, roll, mt, A0, A1, reach, d0, d1, y, push, h, weight)
        q0, q1, q2 = turned(n0, n1, n2, twist * M0, twist * M1, twist * M2)
        a0, a1, a2 = n0 + q0, n1 + q1, n2 + q2
        A0, A1, A2 = n0 + a0, n1 + a1, n2 + a2
        s1 = np.sqrt(a0 * a0 + a1 * a1)
        inverse, lean = 1 / (s0 + s1), R - H * (s0 + s1) / (c0 + a2)
        ds = (A0 * q0 + A1 * q1) * inverse
        mean = e / 4 * (spin + (2 * M0 - L0) * a0 + (2 * M1 - L1) * a1 + (2 * M2 - L2) * a2)
        wd = (M0 * d0 + M1 * d1) * ease + mean * (A0 * d0 + A1 * d1)
        dedge = -h * rim_lever * wd
        dpath = h * (d0 * V1 - d1 * V0 + reach * (M2 * ease + mean * A2) - lever * wd)
        i, u = place(s1, start, per_unit, size)
        K1, dK1 = column(spline, i, u, K), slope(spline, i, u, K) * per_unit / s1
        dgap = h * V2 + yields * (N - weight) - lean * ds - (z0 - rough0) - (z1 - rough1)
        r1 = root(gap0 + dgap)
        kept = (K0 + K1) / 2 * mean_force(r0, r1, gap0, gap0 + dgap)
        error = max(0.0, kept * (1 - loss * dgap)) - N
        steep, used = (K1 - K0) / ds if abs(ds) > FEWEST * s0 else (dK + dK1) / 2, g
        g = (U0 + 0.4 * r1**5) / 2 * steep
        W, stiffness = 1 / m + (lean * A2) ** 2 / (4 * J), K1 * (r0 / 2 + r1)
        more = error / (1 + stiffness * (h * h / 4 * W + yields / 2) + h * h / 2 * loss * kept * W)
        more = max(more, -N)
        mt, mr = secant(rough0, z0, dpath), secant(rough1, z1, dedge)
        missed = abs(g - used) + abs(N * (mt * lever + mr * rim_lever) - roll)
        near = max(abs(more), missed / R) <= NEAR * (N + weight)
        N += more
    turn, roll, before = (N * lean + g) * A2 * inverse / 2, N * (mt * lever + mr * rim_lever), V2
    b0, b1, b2 = M0, M1, M2
    V0, V1, V2, M0, M1, M2 = half_way(N, turn, roll, mt, A0, A1, reach, d0, d1, y, push, h, weight)
    b0, b1, b2 = twist * (M0 - b0), twist * (M1 - b1), twist * (M2 - b2)
    q0, q1, q2 = b1 * A2 - b2 * A1, b2 * A0 - b0 * A2, b0 * A1 - b1 * A0
    ds = (A0 * q0 + A1 * q1) * inverse
    dgap += h * (V2 - before) + yields * more - lean * ds
    u += per_unit * ds / s1
    kept = (K0 + column(spline, i, u, K)) / 2 * mean_force(r0, root(gap0 + dgap), gap0, gap0 + dgap)
    y[at.LOSSES] += (kept - N) * dgap
    y[at.LOSSES + 4] += yields * (N - weight) ** 2
    y[0], y[1], y[2] = y[0] + h * V0, y[1] + h * V1, y[2] + h * V2
    y[3], y[4], y[5] = 2 * V0 - y[3], 2 * V1 - y[4], 2 * V2 - y[5]
    y[6], y[7], y[8], y[9], y[10], y[11] = a0 + q0, a1 + q1, a2 + q2, 2 * M0 - L0, 2 * M1 - L1, 2 * M2 - L2
    y[at.PATH], y[at.EDGE], y[at.TABLE] = y[at.PATH] + dpath, y[at.EDGE] + dedge, y[at.TABLE] - yields * (N - weight)
    y[at.RISES + 2], y[at.RISES + 1], y[at.RISES] = y[at.RISES + 1], y[at.RISES], dgap + (z0 - rough0) + (z1 - rough1)
    y[at.FORCE], y[at.SPEED], y[at.GAP] = N, abs(dpath) / h, gap0 + dgap
    y[at.HEIGHTS], y[at.HEIGHTS + 1], y[at.SINE], y[at.CELL], y[at.PART] = z0, z1, s1 + ds, i, u
    return True
