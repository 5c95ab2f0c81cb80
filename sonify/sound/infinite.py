"""FORCE -> ENDLESS PLATE -> PRESSURE: a table that never rings, in closed form.

Far from a force F at a point of an infinite plate in light air, Cremer, Heckl & Petersson, Structure-Borne Sound, 6.5:
p = rho F/(2 pi r m'')/(1 - (k/k_B)^4 sin^4 theta), theta from the normal, (k/k_B)^4 = (w/w_c)^2, w_c = c^2 sqrt(m''/B);
the mobility at the force is 1/(8 sqrt(B m'')), and below coincidence the power radiated rho F^2/(2 pi c m''^2).
"""

import numpy as np

from sonify.sound.force import lagrange
from sonify.sound.oscillators import OscillatorBank
from sonify.sound.radiation import Listener
from sonify.sound.sources import FADE_FALL, FADE_OUT
from sonify.sound.table import MARGIN, ElasticTable, contact_place

STRAYS = 4
"""Radii of the disk beyond which a contact that strays is heard no earlier or later."""
NODES = np.arange(-2, 4)
"""Samples over which what arrives between samples is spread, by Lagrange's polynomial through as many."""


def bending_stiffness(surface) -> float:
    """Return B = E h^3/(12 (1 - nu^2)) of a plate [N m]."""
    return surface.young * surface.thickness**3 / (12 * (1 - surface.poisson**2))


def mobility(surface) -> float:
    """Return velocity over force at a point of an endless plate [m/(N s)]: 1/(8 sqrt(B m''))."""
    return 1 / (8 * np.sqrt(bending_stiffness(surface) * surface.density * surface.thickness))


def coincidence(surface, listener: Listener) -> float:
    """Return the frequency [Hz] above which waves in the plate run ahead of the sound to the listener."""
    inertia = surface.density * surface.thickness / bending_stiffness(surface)
    return listener.air.sound_speed**2 * np.sqrt(inertia) / (2 * np.pi * np.cos(listener.elevation) ** 2)


def strength(surface, listener: Listener) -> float:
    """Return rho/(2 pi r m'') [1/m^2], the pressure at the listener over a force far below coincidence."""
    return listener.air.density / (2 * np.pi * listener.distance * surface.density * surface.thickness)


class InfiniteTable:
    """An endless plate under the moving contact, heard from afar: a pole pair at coincidence for every direction.

    What a place of the contact nearer to the listener sends arrives earlier, so that a constant force that moves is
    heard, and one at rest is not. Above coincidence the waves of the plate arrive before the direct sound; here they
    come as long after it, with the same spectrum.
    """

    names = ("table",)

    def __init__(self, scene, listener: Listener):
        self._scene, self._rate = scene, scene.audio.sample_rate
        self._strength, self._way = strength(scene.surface, listener), listener.position / listener.distance
        self._frequency, self._air = coincidence(scene.surface, listener), listener.air
        self.ends = np.array([[scene.disk.weight, FADE_FALL], [np.nan, FADE_FALL]])
        self._most = STRAYS * scene.disk.radius / listener.air.sound_speed * self._rate
        self.lasting, self.late = 4 * FADE_OUT, MARGIN + int(self._most)

    def channels(self, force, state):
        """Return the normal force [N], and by how many samples it is heard earlier than from the middle: (k, 2)."""
        ahead = contact_place(state, self._scene.disk) @ self._way[:2] / self._air.sound_speed * self._rate
        return np.column_stack([force[:, 2], np.clip(ahead, -self._most, self._most)])

    def from_rest(self, first, note):
        """Return what radiates the blocks that follow on a force that has long been there."""
        late, weight = self.late, self._scene.disk.weight
        bank = OscillatorBank(*self._poles(), self._rate)
        bank.settle(first[0] - weight)
        coming = np.zeros(2 * late + len(NODES))
        coming[: int(late - first[1])] = first[0]

        def advance(force):
            nonlocal coming
            count = len(force.t) - 1
            sent, ahead = force.samples[:-1].T
            arrived = np.append(coming, np.zeros(count))
            place = np.arange(count) + late - ahead
            whole = np.floor(place).astype(int)
            for node, share in zip(NODES, lagrange(NODES, place - whole), strict=True):
                arrived += np.bincount(whole + node, sent * share, len(arrived))
            heard, coming = arrived[: count + 1] - weight, arrived[count:]
            if len(bank.omega):  # of q'' + 2 d q' + w^2 q = force it is force - q''
                heard[:-1] -= bank.advance(heard[:, None])[:, 0]
            return -self._strength * heard[:-1, None]

        return advance

    def _poles(self):
        """Frequency and decay rate of the pole pair at coincidence; none where it is beyond what is sampled."""
        here = np.array([self._frequency] if self._frequency < self._rate / 2 else [])
        return here, np.pi * here * self._scene.surface.loss_factor


def table_sources(scene, modes, listener: Listener) -> list:
    """Return what sounds of the table of a scene, of which the `modes` are given where it has any."""
    if scene.surface.kind == "infinite":
        return [InfiniteTable(scene, listener)]
    return [ElasticTable(scene, modes, listener)] if modes is not None else []
