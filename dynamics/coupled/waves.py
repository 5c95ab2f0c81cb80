"""The modes of table and disk, which deflect under the contact, and where along the rim these touch (compiled).

The table rises by W = sum q_m w_m(x, y), w_m of modal mass 1. A mode q'' = -k q - c q' - N w~, with ~ for the mean of
both ends of a step h, moves by the midpoint rule, whose k and c are such that it rings and decays at exactly its own
rates whatever the step: its energy (q'^2 + k q^2)/2 changes by the work -N w~ dq less h c q'~^2. So does a mode of the
disk by which the rim is lowered by q w (bending.py).
"""

from typing import NamedTuple

import numpy as np
from scipy.interpolate import make_interp_spline

from .bending import RIGID, Bending, read_rim, rim_shapes, ripple
from .compiled import kernel
from .profile import rim_heights
from .state import AXIS, BODY, FORCE, FREE, HALF, J1, MOMENTUM, NEXT, NOW, RADIUS, SPRING, SURFACE, Q, V

SCANNED, OFTEN, SELDOM = 48, 16, 256
"""Places at which the whole rim is looked at, and after so many steps, where the table is bent or hardly is."""
BESIDE = 3 * np.pi / SCANNED
"""What is as near to the contact [rad] is no other one."""
BENT = 1e-3
"""A table hardly is bent whose heights along the rim differ by less than this part of R sin(beta)."""
STIFFNESS, DAMPING, EASE = range(3)
"""Columns of their constants: k, c, and 1/(1 + h c/2 + h^2 k/4)."""
MOST = 4
ANGLE, LEFT, STIFF, FLAT_FOR, COUNT, TWIST, PLACES = range(7)
"""Of the contact: its direction, steps until the whole rim is looked at, stiffness K, steps for which the disk has lain
flat, how far the disk has turned about its axis [rad], and the minima of the gap that are followed, at most MOST."""


class Waves(NamedTuple):
    """m modes, t of a table and then d of the disk, for the steps: shapes, constants, place of the origin, and state.

    coefficients (a, b, t) over knots_x, knots_y [m]; constants (m, 3); place (2,) [m] in the frame of the splines, of
    the disk's centre if the modes go with it (`stays` = 0) as those do that are given by numbers, else of the origin
    (1); state (m, 5); contact (PLACES + MOST,); `rim` (d, 4), the shapes of `Bending`.
    """

    coefficients: np.ndarray
    knots_x: np.ndarray
    knots_y: np.ndarray
    constants: np.ndarray
    place: np.ndarray
    stays: float
    state: np.ndarray
    contact: np.ndarray
    rim: np.ndarray


def still(modes=None, h: float = 1.0, body: Bending = RIGID) -> Waves:
    """Return the Waves at rest of modes of a table (`modal.SurfaceModes`) and of the disk on it, for steps of h [s];
    without a table, none."""
    if modes is None or not len(modes.frequency):
        return _at_rest(np.zeros((0, 0, 0)), np.zeros(0), np.zeros(0), np.zeros((0, 3)), np.zeros(2), 1.0, RIGID)
    decay = np.append(modes.decay_rate, body.decay)
    root = -decay + 1j * np.sqrt(np.append((2 * np.pi * modes.frequency) ** 2, body.squared) - decay**2 + 0j)
    midpoint = 2 / h * np.tanh(root * h / 2)
    k, c = np.abs(midpoint) ** 2, -2 * midpoint.real
    constants = np.column_stack([k, c, 1 / (1 + h * c / 2 + h * h * k / 4)])
    splines = [np.array(part, order="C") for part in (modes.coefficients, *modes.knots)]  # read-only: another type
    stays = float(modes.mass > 0)  # else they are given by numbers
    return _at_rest(*splines, constants, np.array(modes.place, dtype=float), stays, body)


def _at_rest(coefficients, knots_x, knots_y, constants, place, stays, body):
    state, contact = np.zeros((len(constants), 5)), np.zeros(PLACES + MOST)
    return Waves(coefficients, knots_x, knots_y, constants, place, stays, state, contact, body.shapes)


def wavy(imperfection, y, law) -> Waves:
    """Return the Waves of a table that is wavy and rigid, one mode that does not move, with the disk of y raised onto
    it: it goes with the disk, as modes given by numbers do, and is amplitude (r/R)^n cos n theta from the crest on
    which the disk is let go, since there it need not rise."""
    n, R, a = imperfection.order, law[RADIUS], y[AXIS : AXIS + 2] / np.hypot(*y[AXIS : AXIS + 2])
    x = np.linspace(-R, R, 4 + 8 * n)
    height = imperfection.amplitude * (((x[:, None] + 1j * x) * (a[0] - 1j * a[1]) / R) ** n).real
    spline = make_interp_spline(x, make_interp_spline(x, height).c, axis=1)
    waves = still()._replace(
        coefficients=np.ascontiguousarray(spline.c.T[:, :, None]),
        knots_x=spline.t,
        knots_y=spline.t,
        constants=np.zeros((1, 3)),
        stays=0.0,
        state=np.array([[1.0, 0, 0, 0, 0]]),
    )
    waves.contact[ANGLE] = np.arctan2(a[1], a[0])
    read_shapes(waves, *(R * a), np.zeros((3, 4)), np.zeros((3, 4)), NOW)
    y[2] += waves.state[0, NOW]
    return waves


@kernel
def basis(knots, x, out):
    """Write the four cubic B-splines at x, their first and second derivatives into out (3, 4); return the first."""
    n = knots.size - 4
    x = min(max(x, knots[3]), knots[n])
    i = min(max(int((x - knots[3]) / (knots[n] - knots[3]) * (n - 3)) + 3, 3), n - 1)
    while x < knots[i]:
        i -= 1
    while i < n - 1 and x >= knots[i + 1]:
        i += 1
    a = 1 / (knots[i + 1] - knots[i])
    b0, b1 = 1 / (knots[i + 1] - knots[i - 1]), 1 / (knots[i + 2] - knots[i])
    c0, c1, c2 = 1 / (knots[i + 1] - knots[i - 2]), 1 / (knots[i + 2] - knots[i - 1]), 1 / (knots[i + 3] - knots[i])
    l0, l1 = (knots[i + 1] - x) * a, (x - knots[i]) * a
    q0, q2 = (knots[i + 1] - x) * b0 * l0, (x - knots[i]) * b1 * l1
    q1 = 1 - q0 - q2
    out[0, 0], out[0, 3] = (knots[i + 1] - x) * c0 * q0, (x - knots[i]) * c2 * q2
    out[0, 1] = (x - knots[i - 2]) * c0 * q0 + (knots[i + 2] - x) * c1 * q1
    out[0, 2] = 1 - out[0, 0] - out[0, 1] - out[0, 3]
    out[1, 0], out[1, 3] = -3 * c0 * q0, 3 * c2 * q2
    out[1, 1], out[1, 2] = 3 * (c0 * q0 - c1 * q1), 3 * (c1 * q1 - c2 * q2)
    d0, d1, d2 = -2 * b0 * l0, 2 * (b0 * l0 - b1 * l1), 2 * b1 * l1
    out[2, 0], out[2, 3] = -3 * c0 * d0, 3 * c2 * d2
    out[2, 1], out[2, 2] = 3 * (c0 * d0 - c1 * d1), 3 * (c1 * d1 - c2 * d2)
    return i - 3


@kernel
def read_shapes(waves, x, y, bx, by, into):
    """Write the shapes of the table at (x, y) [m] into a column of the state of the modes."""
    i, j = basis(waves.knots_x, x + waves.place[0], bx), basis(waves.knots_y, y + waves.place[1], by)
    modes, state = waves.coefficients.shape[2], waves.state
    for m in range(modes):
        state[m, into] = 0.0
    for a in range(4):
        for b in range(4):
            share = bx[0, a] * by[0, b]
            row = waves.coefficients[i + a, j + b]
            for m in range(modes):
                state[m, into] += share * row[m]


@kernel
def deflection(waves, x, y, bx, by, out):
    """Write W at the end of the step, its gradient and second derivatives (xx, xy, yy) at (x, y) into out (6,)."""
    i, j = basis(waves.knots_x, x + waves.place[0], bx), basis(waves.knots_y, y + waves.place[1], by)
    out[:] = 0.0
    for a in range(4):
        for b in range(4):
            row, value = waves.coefficients[i + a, j + b], 0.0
            for m in range(row.size):
                value += row[m] * (waves.state[m, Q] + waves.state[m, FREE])
            out[0] += bx[0, a] * by[0, b] * value
            out[1] += bx[1, a] * by[0, b] * value
            out[2] += bx[0, a] * by[1, b] * value
            out[3] += bx[2, a] * by[0, b] * value
            out[4] += bx[1, a] * by[1, b] * value
            out[5] += bx[0, a] * by[2, b] * value


@kernel
def turned_by(before, after):
    """Return the turn from one direction to another, the shorter way round."""
    return after - before - 2 * np.pi * np.rint((after - before) / (2 * np.pi))


@kernel
def read_gap(waves, law, x, y, n0, n1, n2, angle, scratch):
    """Read at an angle of the rim of a disk with the axis (n0, n1, n2) at (x, y) the table and its slopes, scratch[6],
    and the ripple of the rim, scratch[7]; return cosine, sine, the reach and n.e."""
    c, s = np.cos(angle), np.sin(angle)
    down = n0 * c + n1 * s
    reach = law[RADIUS] * n2 - down * law[HALF]
    deflection(waves, x + reach * c, y + reach * s, scratch[0:3, 0:4], scratch[3:6, 0:4], scratch[6])
    ripple(waves.rim, waves.state, angle - waves.contact[TWIST], down, n2, scratch[7])
    return c, s, reach, down


@kernel
def look_round(waves, law, x, y, n0, n1, n2, scratch):
    """Note the directions, at most MOST, in which the rim has a minimum of its gap, of SCANNED; beside the contact it
    is the contact, which is followed on."""
    R, most, least, count = law[RADIUS], -np.inf, np.inf, 0
    before = now = 0.0
    for n in range(SCANNED + 2):
        _, _, _, down = read_gap(waves, law, x, y, n0, n1, n2, 2 * np.pi * n / SCANNED, scratch)
        risen = scratch[6, 0] + scratch[7, 0]
        most, least, value = max(most, risen), min(least, risen), risen + R * down
        if n > 1 and now >= before and now > value and count < MOST:
            turn = turned_by(waves.contact[ANGLE], 2 * np.pi * (n - 1) / SCANNED)
            waves.contact[PLACES + count] = waves.contact[ANGLE] + (turn if abs(turn) > BESIDE else 0.0)
            count += 1
        before, now = now, value
    waves.contact[COUNT] = count
    bends = most - least > BENT * R * np.sqrt(n0 * n0 + n1 * n1)
    waves.contact[LEFT] = OFTEN if bends else SELDOM


@kernel
def follow(waves, law, x, y, n0, n1, n2, rough, scratch):
    """Find in which direction a disk with the axis (n0, n1, n2) at (x, y) touches, write the shapes there as NEXT;
    return it, how high table and edge are there, and how far it is along the path.

    Each minimum of the gap is followed by a step of Newton's method from where it was; the lowest is the contact.
    `rough` are the profiles of table and edge, the places [m] on them in the last direction, and the ellipse's half.
    """
    field, bent, R = scratch[6], scratch[7], law[RADIUS]
    x, y = waves.stays * x, waves.stays * y
    waves.contact[LEFT] -= 1
    if waves.contact[LEFT] < 0:
        look_round(waves, law, x, y, n0, n1, n2, scratch)
    last = waves.contact[ANGLE]
    best, found = -np.inf, last
    for n in range(int(waves.contact[COUNT])):
        angle = waves.contact[PLACES + n]
        c, s, reach, down = read_gap(waves, law, x, y, n0, n1, n2, angle, scratch)
        down, side = R * down, R * (n1 * c - n0 * s)  # of the rim, and its slope
        rim_heights(*rough, reach, R, turned_by(last, angle), bent)
        slope = side + reach * (field[2] * c - field[1] * s) + bent[1]
        bend = reach**2 * (field[3] * s * s - 2 * field[4] * s * c + field[5] * c * c)
        bend += bent[2] - reach * (field[1] * c + field[2] * s)
        step = slope / max(down - bend, 0.1 * R * np.sqrt(n0 * n0 + n1 * n1) + 1e-300)
        step = min(max(step, -0.1), 0.1)
        waves.contact[PLACES + n] = angle + step
        value = field[0] + bent[0] + down + step * slope / 2
        if value > best:
            best, found = value, angle + step
    c, s = np.cos(found), np.sin(found)
    reach = R * n2 - (n0 * c + n1 * s) * law[HALF]
    read_shapes(waves, x + reach * c, y + reach * s, scratch[0:3, 0:4], scratch[3:6, 0:4], NEXT)
    read_rim(waves.rim, waves.state, found - waves.contact[TWIST], n0 * c + n1 * s, n2, NEXT)
    bent[:] = 0.0
    rim_heights(*rough, reach, R, turned_by(last, found), bent)
    return found, bent[0], reach * turned_by(last, found)


@kernel
def fall_free(waves, h):
    """Note by how much every q would change in a step without a contact force."""
    for m in range(waves.state.shape[0]):
        q, v = waves.state[m, Q], waves.state[m, V]
        waves.state[m, FREE] = h * waves.constants[m, EASE] * (v - h / 2 * waves.constants[m, STIFFNESS] * q)


@kernel
def sums(waves, h):
    """Return sum w~ dq = D - E N and sum q~ dw = P - S N as D, E, P, S."""
    D = E = P = S = 0.0
    for m in range(waves.state.shape[0]):
        mean, change = (waves.state[m, NOW] + waves.state[m, NEXT]) / 2, waves.state[m, NEXT] - waves.state[m, NOW]
        yields = h * h / 2 * waves.constants[m, EASE] * mean
        D, E = D + mean * waves.state[m, FREE], E + yields * mean
        P, S = P + change * (waves.state[m, Q] + waves.state[m, FREE] / 2), S + change * yields / 2
    return D, E, P, S


@kernel
def move_modes(waves, N, h):
    """Advance the modes by a step h under the contact force N; return what those of the table and of the disk lose."""
    lost = every = 0.0
    first = len(waves.state) - len(waves.rim)
    for m in range(waves.state.shape[0]):
        mean = (waves.state[m, NOW] + waves.state[m, NEXT]) / 2
        change = waves.state[m, FREE] - h * h / 2 * waves.constants[m, EASE] * mean * N
        waves.state[m, Q] += change
        waves.state[m, V] = 2 * change / h - waves.state[m, V]
        waves.state[m, NOW] = waves.state[m, NEXT]
        every += waves.constants[m, DAMPING] * change * change / h
        if m < first:
            lost = every
    return lost, every - lost


@kernel
def energy_of(waves):
    """Return the energy [J] of the modes of the table and of those of the disk."""
    energy = every = 0.0
    first = len(waves.state) - len(waves.rim)
    for m in range(waves.state.shape[0]):
        q, v = waves.state[m, Q], waves.state[m, V]
        every += (v * v + waves.constants[m, STIFFNESS] * q * q) / 2
        if m < first:
            energy = every
    return energy, every - energy


def settle(waves: Waves, modes, model, y) -> None:
    """Give the modes the deflection and velocity with which they carry the force of a contact that turns steadily.

    The force then drives a mode with the Fourier series of its shape round the rim, and nothing else rings.
    """
    if modes is None or not len(waves.state):
        return
    law, n = model.constants, y[AXIS:MOMENTUM]
    s, start = np.hypot(n[0], n[1]), np.arctan2(n[1], n[0])
    reach = law[RADIUS] * n[2] - law[HALF] * s
    turning = (np.cross(y[MOMENTUM:SPRING], n)[:2] / law[J1]) @ np.array([-n[1], n[0]]) / s**2
    angle = start + 2 * np.pi * np.arange(SCANNED) / SCANNED
    east, north = (waves.stays * y[:2] + modes.place)[:, None] + reach * np.array([np.cos(angle), np.sin(angle)])
    shapes = np.hstack([modes.at(east, north), rim_shapes(model.bending, angle, np.arctan2(s, n[2]))])
    rate = 1j * turning * np.fft.fftfreq(SCANNED, 1 / SCANNED)[:, None]
    k, c = waves.constants[:, STIFFNESS], waves.constants[:, DAMPING]
    parts = -y[FORCE] * np.fft.fft(shapes, axis=0) / SCANNED / (k + c * rate + rate**2)
    waves.contact[ANGLE] = start
    waves.state[:, Q], waves.state[:, V] = parts.sum(axis=0).real, (rate * parts).sum(axis=0).real
    waves.state[:, NOW] = shapes[0]
    y[SURFACE], y[BODY] = energy_of(waves)
    y[2] += waves.state[:, Q] @ shapes[0]
