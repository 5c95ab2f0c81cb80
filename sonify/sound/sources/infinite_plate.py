"""FORCE -> INFINITE PLATE -> PRESSURE: a table without resonances, in closed form.

Reference: Cremer, Heckl & Petersson, Structure-Borne Sound, 6.5. Far from a force F at a point of
an infinite plate in light air, p = rho F/(2 pi r m'')/(1 - (k/k_B)^4 sin^4 theta), with theta from
the normal, (k/k_B)^4 = (w/w_c)^2 and w_c = c^2 sqrt(m''/B). The mobility at the force is 1/(8
sqrt(B m'')). Below coincidence the radiated power is rho F^2/(2 pi c m''^2)."""

import numpy as np

from sonify.sound.force import lagrange_weights
from sonify.sound.oscillators import OscillatorBank
from sonify.sound.radiation import Listener
from sonify.sound.sources.protocol import DRIVE_FADE, FADE_OUT, Source
from sonify.sound.sources.tabletop import ARRIVAL_MARGIN, ElasticTable, contact_place

LAGRANGE_NODES = np.arange(-2, 4)  # samples
"""Samples around an arrival time that share the arrival, by Lagrange interpolation."""


def bending_stiffness(surface) -> float:
    """Return the bending stiffness B = E h^3/(12 (1 - nu^2)) of a plate [N m]."""
    return surface.young * surface.thickness**3 / (12 * (1 - surface.poisson**2))


def point_mobility(surface) -> float:
    """Return the point mobility of an infinite plate [m/(N s)]: 1/(8 sqrt(B m''))."""
    return 1 / (8 * np.sqrt(bending_stiffness(surface) * surface.density * surface.thickness))


def coincidence_frequency(surface, listener: Listener) -> float:
    """Return the frequency [Hz] above which bending waves of the plate precede the direct sound to
    the listener."""
    inertia = surface.density * surface.thickness / bending_stiffness(surface)
    return (
        listener.air.sound_speed**2
        * np.sqrt(inertia)
        / (2 * np.pi * np.cos(listener.elevation) ** 2)
    )


def force_to_pressure(surface, listener: Listener) -> float:
    """Return rho/(2 pi r m'') [1/m^2]: pressure at the listener over the force, far below
    coincidence."""
    return listener.air.density / (
        2 * np.pi * listener.distance * surface.density * surface.thickness
    )


class InfiniteTable(Source):
    """An infinite plate under the moving contact, in the far field; a pole pair at coincidence for
    each direction.

    Sound from a contact place nearer to the listener arrives earlier: a moving constant force
    radiates, one at rest does not. Above coincidence the bending waves of the plate arrive before
    the direct sound; here they arrive after it by the same time, with the same spectrum. The
    advance by the contact place is limited to four radii of the disk."""

    names = ("table",)

    def __init__(self, scene, listener: Listener):
        self._scene = scene
        self._rate = scene.audio.sample_rate
        self._strength = force_to_pressure(scene.surface, listener)
        self._direction = listener.position / listener.distance
        self._coincidence = coincidence_frequency(scene.surface, listener)
        self._air = listener.air
        self.channel_ends = np.array([[scene.disk.weight, DRIVE_FADE], [np.nan, DRIVE_FADE]])
        self._max_advance = 4 * scene.disk.radius / listener.air.sound_speed * self._rate
        self.tail_duration = 4 * FADE_OUT
        self.latency = ARRIVAL_MARGIN + int(self._max_advance)

    def channels(self, force, state):
        """Return the normal force [N], and the samples by which it arrives before sound from the
        centre, (k, 2)."""
        path = contact_place(state, self._scene.disk) @ self._direction[:2]
        advance = path / self._air.sound_speed * self._rate
        return np.column_stack(
            [force[:, 2], np.clip(advance, -self._max_advance, self._max_advance)]
        )

    def start_rendering(self, first, note):
        """Return the function that radiates the blocks after a constant force `first`."""
        latency = self.latency
        weight = self._scene.disk.weight
        bank = OscillatorBank(*self._poles(), self._rate)
        bank.settle(first[0] - weight)
        in_flight = np.zeros(2 * latency + len(LAGRANGE_NODES))
        in_flight[: int(latency - first[1])] = first[0]

        def advance(force):
            nonlocal in_flight
            count = len(force.t) - 1
            sent, earlier = force.samples[:-1].T
            arrived = np.append(in_flight, np.zeros(count))
            place = np.arange(count) + latency - earlier
            whole = np.floor(place).astype(int)
            for node, share in zip(
                LAGRANGE_NODES, lagrange_weights(LAGRANGE_NODES, place - whole), strict=True
            ):
                arrived += np.bincount(whole + node, sent * share, len(arrived))
            radiating = arrived[: count + 1] - weight
            in_flight = arrived[count:]
            if len(bank.omega):  # the pole pair w^2 q = force - q'' - 2 d q' radiates force - q''
                radiating[:-1] -= bank.advance(radiating[:, None])[:, 0]
            return -self._strength * radiating[:-1, None]

        return advance

    def _poles(self):
        """Return frequency and decay rate of the pole pair; empty if above half the sample rate."""
        sampled = self._coincidence < self._rate / 2
        frequency = np.array([self._coincidence] if sampled else [])
        return frequency, np.pi * frequency * self._scene.surface.loss_factor


def table_sources(scene, modes, listener: Listener) -> list[Source]:
    """Return the sources of the table; `modes` are those of an elastic table, or None."""
    if scene.surface.kind == "infinite":
        return [InfiniteTable(scene, listener)]
    return [ElasticTable(scene, modes, listener)] if modes is not None else []
