"""The force of a rough contact that is kept: a linear filter that varies slowly, along a rigid motion already solved.

Between knots the linearised contact is constant and stepped exactly for heights that are linear between samples; the
rolling direction is not excited, so that four numbers are its state: velocities and deflections along a_2 and a_3.
"""

from typing import NamedTuple

import numpy as np
from scipy.integrate import trapezoid

from . import profile
from .compiled import fingerprint, kernel, outermost
from .contact import LEAST_INCLINATION
from .profile import SMOOTH, height
from .roughness import density, window
from .sections import Roughness
from .table import LawTable

EVERY = 16
"""Samples between knots."""
BLOCK = 2048
"""Knots that are handled together."""
PART = [1, 2, 4, 5]
TERMS, LARGEST = 20, 2.0
"""Terms of a propagator, exact to rounding where the fastest resonance turns by no more radians in a step."""
AUDIBLE = 200.0
"""The force above this frequency [Hz] is the contact's, below it the motion's."""


class Along(NamedTuple):
    """A rigid motion at even knots t (k,) [s]: inclination [rad], normal force [N], whether it rolls.

    Path lengths [m] on the table and on the edge; `jumps` (k, 2) [N] of the force along a_2, a_3 since the last knot.
    """

    t: np.ndarray
    inclination: np.ndarray
    load: np.ndarray
    rolls: np.ndarray
    path: np.ndarray
    edge: np.ndarray
    jumps: np.ndarray


def along(motion, rate: float, start: float = 0.0, stop: float | None = None):
    """Yield the motion block by block, each as Along; the last knot of a block is the first of the next.

    `rate` [1/s] is that of the samples, EVERY to a knot. The contact advances by the edge's R d(spin) and the slip.
    Below LEAST_INCLINATION it is no ellipse: the motion is followed until then.
    """
    valid = motion.t[np.flatnonzero(motion.state[:, 1] >= LEAST_INCLINATION)[-1]]
    knots, path = int(np.floor((min(valid, valid if stop is None else stop) - start) * rate / EVERY)), 0.0
    jumps = motion.jumps
    for first in range(0, knots, BLOCK):
        t = start + np.arange(first, min(first + BLOCK, knots) + 1) * (EVERY / rate)
        state, force = motion.at_and_force(t)
        edge, slip = -motion.disk.radius * state[:, 2], state[:, 8]
        slid = np.append(0.0, np.cumsum((slip[1:] + slip[:-1]) / 2)) * (EVERY / rate)
        rolls = np.char.startswith(motion.regime(t), "roll")
        change = np.zeros((len(t), 2))
        here = (jumps.t > t[0] - EVERY / rate) & (jumps.t <= t[-2])
        np.add.at(change, np.searchsorted(t, jumps.t[here]), (jumps.after - jumps.before)[here, 1:])
        yield Along(t, state[:, 1], force[:, 2], rolls, edge + path - slid, edge, change)
        path -= slid[-1]


def respond(table: LawTable, blocks, rate: float, profiles=(SMOOTH, SMOOTH)):
    """Yield what the elastic, rough contact adds to the force, (n, 2) [N] along a_2 and a_3, for every block.

    `blocks` are those of `along`, `profiles` those of the table and of the edge.
    Sample i of a block is at t[0] + (i + 1)/rate. Raises ValueError, naming the rate needed, where a resonance turns
    too far in a step.
    """
    x, z = np.zeros(4), np.nan
    for block in blocks:
        knots, A, B, drive = _coefficients(table, block, rate)
        if np.isnan(z):
            z = sum(height(p, s, knots[0, 0]) for p, s in zip(profiles, (block.path[0], block.edge[0]), strict=True))
        out, x, z = _march(x, z, knots, A, B, drive, 1 / rate, *profiles)
        yield out


def _coefficients(table, block, rate):
    """Return what `_march` needs: at knots a, path, edge, C and D of the force along a_2, a_3 (k, 13); between them
    A (k - 1, 4, 4), B, drive."""
    rolls, speed = block.rolls[1:] & block.rolls[:-1], np.diff(block.path) / np.diff(block.t)
    inclination, load = ((at[1:] + at[:-1]) / 2 for at in (block.inclination, block.load))
    system = table.system(inclination, load, speed, rolls)
    A, B = system.A[:, PART][:, :, PART], system.B[:, PART]
    fastest = np.sqrt(np.abs(A[:, 0, 2]) + np.abs(A[:, 1, 3])).max() / LARGEST
    if fastest > rate:
        raise ValueError(
            f"rate = {rate:g}: too low for the stiffness of the contact, at least {fastest:.4g} 1/s is needed"
        )
    springs, a, _ = table.springs(block.inclination, block.load)
    there = table.system(block.inclination, block.load, np.append(speed, speed[-1]), block.rolls)
    forces = np.concatenate([there.C[:, 1:, PART], there.D[:, 1:, None]], axis=2)
    knots = np.column_stack([a, block.path, block.edge, forces.reshape(len(a), -1)])
    drive = np.column_stack(
        [np.where(rolls, block.jumps[:-1, 0] / springs.k2[:-1], np.nan), block.jumps[:-1, 1] / springs.kn[:-1]]
    )
    return knots, np.ascontiguousarray(A), np.ascontiguousarray(B), drive


def predicted_rms(table: LawTable, roughness: Roughness, inclination, load, speed, above=AUDIBLE):
    """Return the rms [N] of the force above a frequency [Hz] in steady motion, (k,), from the spectrum of the heights.

    Table and edge are read at `speed` (k,) [m/s], as long as they have many waves.
    """
    k, square = density(roughness, table.law.disk.radius)[0], []
    for one in np.broadcast(inclination, load, np.abs(speed)):
        f = k * one[2] / (2 * np.pi)
        power = predicted_spectrum(table, roughness, *one, f)
        square.append(trapezoid(power * (f > above), f))
    return np.sqrt(square)


def predicted_power(table: LawTable, roughness: Roughness, inclination, load, speed) -> np.ndarray:
    """Return the mean power (k,) [W] that heights take from a disk in steady motion: N' times the rate at which they
    rise, the sum over the waves z of their spectrum of omega Im(N'/z)."""
    (k, heights), powers = density(roughness, table.law.disk.radius), []
    for steady in np.broadcast(inclination, load, np.abs(speed)):
        one = np.reshape(steady, (3, 1))
        a, response = table.springs(*one[:2])[1], gain(table.system(*one), k * one[2])
        powers.append(trapezoid(heights * window(k * a) ** 2 * k * one[2] * response.imag, k))
    return np.array(powers)


def predicted_spectrum(table: LawTable, roughness: Roughness, inclination, load, speed, frequency, rolls=True):
    """Return the power spectral density [N^2/Hz] of the force at frequencies (f,) [Hz] in one steady motion."""
    steady = np.array([[inclination], [load], [speed]])
    a, system = table.springs(*steady[:2])[1], table.system(*steady, rolls)
    k = 2 * np.pi * frequency / abs(speed)
    heights = np.interp(k, *density(roughness, table.law.disk.radius), left=0.0, right=0.0) * window(k * a) ** 2
    return heights * np.abs(gain(system, 2 * np.pi * frequency)) ** 2 * 2 * np.pi / abs(speed)


def gain(system, omega):
    """Return N'/z (f,) [N/m] of a linearised contact at angular frequencies (f,) [rad/s]."""
    roots, vectors = np.linalg.eig(system.A[0][np.ix_(PART, PART)])
    weight = (system.C[0, 2, PART] @ vectors) * np.linalg.solve(vectors, system.B[0, PART].astype(complex))
    s = 1j * omega
    return s * ((weight / (s[:, None] - roots)).sum(axis=1) + system.D[0, 2])


@kernel
def _propagator(A, B, h):
    """Return [exp(A h), the mean of exp(A s) B over a step] (4, 5): the Taylor series of the matrix [A h, B; 0, 0]."""
    total, term, following = np.empty((4, 5)), np.empty((4, 5)), np.empty((4, 5))
    for i in range(4):
        for j in range(5):
            term[i, j] = A[i, j] * h if j < 4 else B[i]
            total[i, j] = term[i, j] + (1.0 if i == j else 0.0)
    for n in range(2, TERMS):
        for i in range(4):
            for j in range(5):
                value = 0.0
                for m in range(4):
                    value += A[i, m] * term[m, j]
                following[i, j] = value * h / n
                total[i, j] += following[i, j]
        term, following = following, term
    return total


@kernel
def _steps(x, z, knots, A, B, drive, h, table, rim):
    """Step through a block; return the force (n, 2), the last state and the last height.

    Where `drive` along a_2 is NaN the contact slides, and its tangential spring is gone.
    """
    out, following, now = np.empty((EVERY * len(A), 2)), np.empty(4), np.empty(13)
    for j in range(len(A)):
        E = _propagator(A[j], B[j], h)
        slides = np.isnan(drive[j, 0])
        x[2] = 0.0 if slides else x[2] + drive[j, 0]
        x[3] += drive[j, 1]
        for i in range(EVERY):
            f = (i + 1) / EVERY
            for m in range(13):
                now[m] = knots[j, m] + f * (knots[j + 1, m] - knots[j, m])
            rise = height(table, now[1], now[0]) + height(rim, now[2], now[0]) - z
            z += rise
            for m in range(4):
                following[m] = E[m, 0] * x[0] + E[m, 1] * x[1] + E[m, 2] * x[2] + E[m, 3] * x[3] + E[m, 4] * rise
            x, following = following, x
            for m in range(2):
                c = now[3 + 5 * m : 8 + 5 * m]
                out[EVERY * j + i, m] = c[0] * x[0] + c[1] * x[1] + c[2] * x[2] + c[3] * x[3] + c[4] * rise / h
            if slides:
                out[EVERY * j + i, 0] = 0.0
    return out, x, z


def _compiled(version):
    @outermost
    def march(x, z, knots, A, B, drive, h, table, rim):
        version  # noqa: B018 -- a part of the key under which the machine code is kept
        return _steps(x, z, knots, A, B, drive, h, table, rim)

    return march


_march = _compiled(fingerprint(profile))
