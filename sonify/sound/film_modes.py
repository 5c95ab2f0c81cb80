"""MODES + FILM -> MODES: frequency, decay and loudness against the gap, and oscillators that follow them."""

from dataclasses import dataclass, replace
from functools import cached_property
from math import pi

import numpy as np
from numba import njit
from scipy.interpolate import CubicSpline

from modal import Modes
from sonify.sound.force import ContactForce, lagrange
from sonify.sound.oscillators import Knots, OscillatorBank
from sonify.sound.radiation import directions, listener_of, position, rayleigh

GAPS, MORE = np.geomspace(2.5e-3, 4e-6, 12), 2
"""Mean gaps [m] at which the film is solved, down to the least one of a motion and so many more; a wider one acts as
the first, a closer one as the last."""
CELLS, NEAREST, ORDERS, VIEWS = 6, 5.0, 4, 16
"""Of the film's mesh, of the waves of the flow round its rim, and of the azimuths that hear it."""
NOTHING = 1e-4
"""Share of a mode that is even or odd about the contact which is left out: its pressure goes with the square."""
SMALL = 1.5
"""Above this number k R a mode is heard as above a closed film: the flow out of the rim is not known there."""
LEAST = 1e-3
"""Decay by the film [1/s] that is nothing, in the interpolation of its logarithm."""
STEP = 0.02
"""The oscillators change where the logarithm of the gap has changed by so much."""
HIGHEST = 0.45
"""No mode is tuned above this part of the sample rate."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Filmed:
    """What the film makes of m modes at the even logarithms `gap` (a,) of mean gaps [m], in descending order.

    frequency [Hz] of the damped mode, `added` decay rate [1/s] (a, m) beside `decay_rate` (m,) without the film; gain
    (a, m): pressure over that above a closed film.
    """

    gap: np.ndarray
    frequency: np.ndarray
    added: np.ndarray
    decay_rate: np.ndarray
    gain: np.ndarray

    def heard(self, ringing, gap) -> np.ndarray:
        """Return accelerations `ringing` (s, k, m), which are overwritten, as heard at logarithms of gaps (k,)."""
        between = len(self.gap) - 1  # the logarithms lie evenly
        where = (gap - self.gap[0]) * (between / (self.gap[-1] - self.gap[0]))
        return _times(ringing, np.clip(where, 0.0, between), self.gain)

    def tuned(self, gap) -> tuple[np.ndarray, np.ndarray]:
        """Return frequency and decay rate (..., m) at logarithms of gaps (...)."""
        frequency, added = self._curves
        return frequency(gap), self.decay_rate + np.maximum(np.exp(added(gap)) - LEAST, 0.0)

    @cached_property
    def _curves(self):
        return [CubicSpline(self.gap[::-1], t[::-1]) for t in (self.frequency, np.log(self.added + LEAST))]


def filmed(modes: Modes, scene, least: float = 0.0) -> Filmed:
    """Return the modes of a scene under its film, whose contact is at the patch of the modes, for gaps not below
    `least` [m].

    Of modal mass 1, lambda^2 + (2 d + D) lambda + w^2 = 0, D = -12 mu R^4/g^3 int p w dA at the rate Im lambda,
    as it is foreseen from the wider gaps. The air is isothermal, has inertia, and the rim is free of pressure.
    """
    from dynamics.film.reynolds import FilmMesh  # scikit-fem loads slowly

    air, R, halves = scene.air, scene.disk.radius, [FilmMesh(CELLS, nearest=NEAREST, parity=p) for p in (1, -1)]
    shapes = [_by_parity(modes, i, halves, R) for i in range(len(modes))]
    natural = 2 * pi * modes.frequency
    rate, before, found, flows = natural, natural, [], []
    gaps = GAPS[: max(np.count_nonzero(least < GAPS) + MORE, 4)]
    for g in gaps:
        ahead = rate * rate / before
        works, rim = zip(*(_answer(parts, g, r, R, air) for parts, r in zip(shapes, ahead, strict=True)), strict=True)
        drag = -12 * air.viscosity * R**4 / g**3 * np.array(works) / 2 + modes.decay_rate
        root = np.sqrt(drag**2 - natural**2)
        damped = -drag + np.where(root.imag < 0, -root, root)
        before, rate = rate, np.clip(damped.imag, 0.05 * natural, 2 * pi * HIGHEST * scene.audio.sample_rate)
        found.append((rate / (2 * pi), np.maximum(-damped.real - modes.decay_rate, 0.0)))
        flows.append(rim)
    frequency, added = np.swapaxes(found, 0, 1)
    gain = loudness(modes, scene, np.array(flows))
    return Filmed(gap=np.log(gaps), frequency=frequency, added=added, decay_rate=modes.decay_rate, gain=gain)


def _by_parity(modes, i, halves, radius):
    """The even and the odd part of the bottom face of a mode that it has, each with the half of the film's mesh."""
    here, there = below(modes, i, np.array([halves[0].points, halves[0].points.conj()]), radius)
    parts = [(mesh, (here + mesh.parity * there) / 2) for mesh in halves]
    least = NOTHING * max(np.abs(part).max() for _, part in parts)
    return [(mesh, part) for mesh, part in parts if np.abs(part).max() > least]


def _answer(parts, g, rate, radius, air):
    """The work of the film's pressure on a mode that goes with its velocity, and the orders of the flow at the rim."""
    numbers = 12 * air.viscosity * rate * radius**2 / (air.pressure * g**2), layered(g, rate, air), ORDERS
    answers = [mesh.linear(each, each, *numbers)[0] for mesh, w in parts for each in [[w]]]
    return sum(a.works[0] for a in answers), sum(a.rim for a in answers)


def heights(thickness: float, radius: float) -> tuple[float, float, float, float]:
    """Return a0, b0, a1, b1 of a disk that stands above the baffle: fits within 2 % below 1 kHz, at 0.5 m and 45
    degrees."""
    x = thickness / radius
    return 1.0, 0.998, 1 + 0.75 * x / (1 + 2.45 * x), 1 + 1.66 * x / (1 + 1.5 * x)


def layered(gap: float, rate: float, air) -> complex:
    """Return g sqrt(i w rho/mu), the gap over the depth of the boundary layers."""
    return gap * (1j * rate * air.density / air.viscosity) ** 0.5


def below(modes: Modes, i: int, points, radius: float) -> np.ndarray:
    """Return the axial shape of the bottom face at points x + i y over the radius, with the contact at x = -1."""
    wave = np.fft.rfft(modes.face_shape[i, 0], axis=1) / len(modes.face_angle)
    wave[:, 1:] *= 2
    along = lagrange(modes.face_radius / radius, np.abs(points).ravel()).T @ wave[:, : 2 * ORDERS]
    turn = np.exp(1j * np.outer(np.angle(points) + pi, np.arange(along.shape[1])))
    return (along * turn).real.sum(axis=1).reshape(points.shape)


def loudness(modes: Modes, scene, flows) -> np.ndarray:
    """Return the root mean square round the disk of what is heard of each mode with `flows` (a, m, 2 k + 1) out of the
    rim, over that of its upper face alone, (a, m). The height of the disk is taken along for the orders 0 and 1."""
    a0, b0, a1, b1 = heights(scene.disk.thickness, scene.disk.radius)
    listener, order = listener_of(scene), np.abs(np.append(np.arange(ORDERS + 1), np.arange(-ORDERS, 0)))
    wave = np.fft.rfft(modes.face_shape, axis=3)
    wave[..., 0] *= a0
    wave[..., 1] *= a1
    raised = replace(modes, face_shape=np.fft.irfft(wave, len(modes.face_angle), axis=3))
    closed, top = (directions(m, listener, count=VIEWS) for m in (modes, raised))
    R, angle, views = scene.disk.radius, 2 * pi * np.arange(64) / 64, 2 * pi * np.arange(VIEWS) / VIEWS
    turn = np.exp(1j * np.outer(np.append(np.arange(ORDERS + 1), np.arange(-ORDERS, 0)), angle + pi))
    waves = np.select([order == 0, order == 1], [b0, b1], b1)[:, None] * turn * R / (2 * pi)
    ring, weight = R * np.column_stack([np.cos(angle), np.sin(angle)]), np.full(64, R * angle[1])
    k = 2 * pi * modes.frequency / listener.air.sound_speed
    sides = [position(listener, a) for a in views]
    every = np.tile(waves, (len(k), 1)), ring, weight, np.repeat(k, len(waves))  # each wave at each mode's frequency
    each = np.array([rayleigh(*every, side, listener.air.density) for side in sides])
    rim = np.einsum("amn,vmn->avm", flows, each.reshape(VIEWS, len(k), -1))
    level = np.mean(np.abs(top + rim) ** 2, axis=1) / np.mean(np.abs(closed) ** 2, axis=0)
    return np.where(k * R > SMALL, 1.0, np.sqrt(level))


class Tuned:
    """m modes as oscillators whose frequency and decay follow the gap: exact while these stay, without a click
    where they change.

    `settled` (m,) is the force that has long been there when the first block begins, `gap` the logarithm of the gap.
    At a change velocity and the displacement from where the force holds it at rest stay as they are. The film gives way
    to what is slow, so that the rest is not stiffened and does not ring.
    """

    def __init__(self, table: Filmed, sample_rate: float, settled, gap: float):
        self._table, self._rate = table, sample_rate
        self._tuned = table.tuned(table.gap[0] - STEP * np.arange(self._level_of(table.gap[-1]) + 1))
        self._bank = _rows_of(OscillatorBank(*self._tuned, sample_rate))
        self._level = self._level_of(gap)
        smooth, jumps = (self._at(self._level) for _ in range(2))
        smooth.settle(settled)
        jumps.settle(0 * settled)
        self._states = [smooth.state, jumps.state]

    def advance(self, force: ContactForce, gap) -> np.ndarray:
        """Return the accelerations (2, k, m) in the block of a ContactForce, at logarithms of the gap (k + 1,)."""
        level, none = self._level_of(gap[:-1]), 0 * force.bend
        bank, out = self._at(level[force.knots[0]]), np.empty((2, len(level), force.smooth.shape[1]))
        every = (
            (force.smooth, Knots(*force.knots, none, force.bend)),
            (force.steps, Knots(*force.knots, force.jump, none)),
        )
        for (g, knots), state, ringing in zip(every, self._states, out, strict=True):
            g = np.ascontiguousarray(g, dtype=float)
            kicks = np.ascontiguousarray(bank.kicks(knots))
            _follow(level, self._level, self._bank, g, knots.interval, kicks, state, ringing)
        self._level = level[-1]
        return out

    def _level_of(self, gap):
        inside = np.clip(gap, self._table.gap[-1], self._table.gap[0])
        return np.round((self._table.gap[0] - inside) / STEP).astype(int)

    def _at(self, level):
        return OscillatorBank(*(t[level] for t in self._tuned), self._rate)


def _rows_of(bank: OscillatorBank) -> np.ndarray:
    """A bank (l, m) as (l, 15, m): its step, the state from what stays, (q - g/w^2, q') less `late` g, and back."""
    late = bank.late - [bank.omega**-2.0, 0 * bank.omega]
    return np.ascontiguousarray(np.concatenate([bank.step, *bank.rows, *bank.back, late]).swapaxes(0, 1))


@njit(cache=True)
def _times(ringing, where, gain):
    """Multiply (s, k, m) by the rows of a table (a, m) at places `where` (k,) among them, linear between."""
    for n in range(len(where)):
        low = min(int(where[n]), len(gain) - 2)
        for m in range(gain.shape[1]):
            factor = gain[low, m] + (where[n] - low) * (gain[low + 1, m] - gain[low, m])
            for s in range(len(ringing)):
                ringing[s, n, m] *= factor
    return ringing


@njit(cache=True)
def _follow(level, now, bank, g, interval, kicks, state, out):
    """Step the oscillators through the samples g (k + 1, m) at the levels (k,), the last one having been `now`; the
    kicks come at the ends of the intervals (j,)."""
    knot = 0
    for n in range(len(out)):
        old, new = bank[now], bank[level[n]]
        for m in range(out.shape[1]):
            u, first, second = g[n, m], state[0, m], state[1, m]
            if level[n] != now:
                q = old[9, m] * first + old[10, m] * second + (old[13, m] - new[13, m]) * u
                v = old[11, m] * first + old[12, m] * second + (old[14, m] - new[14, m]) * u
                first, second = new[5, m] * q + new[6, m] * v, new[7, m] * q + new[8, m] * v
            out[n, m] = new[0, m] * u + first
            state[0, m] = new[1, m] * u + (new[2, m] * first + second)
            state[1, m] = new[3, m] * u + new[4, m] * first
        while knot < len(interval) and interval[knot] == n:
            state += kicks[:, knot]
            knot += 1
        now = level[n]
