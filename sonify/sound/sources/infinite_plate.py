"""Compute the sound of an infinite plate, a table without resonances, in closed form.

Reference: Cremer, Heckl & Petersson, Structure-Borne Sound, 6.5. The far-field pressure
of a point force F on an infinite plate with light fluid loading is p = rho F/(2 pi r
m'')/(1 - (k/k_B)^4 sin^4 theta), where theta is measured from the normal, (k/k_B)^4 =
(w/w_c)^2 and w_c = c^2 sqrt(m''/B). The point mobility is 1/(8 sqrt(B m'')). Below
coincidence the radiated power is rho F^2/(2 pi c m''^2)."""

from typing import TYPE_CHECKING

import numpy as np

from dynamics.compliant.law.table_receptance import bending_stiffness
from dynamics.contact_geometry import contact_position
from dynamics.surface import InfiniteSurface
from sonify.sound.force import ContactForce, lagrange_weights
from sonify.sound.oscillators import OscillatorBank
from sonify.sound.radiation import Listener
from sonify.sound.sources.protocol import (
    FADE_OUT,
    MODAL_FORCE_FADE,
    Advance,
    Note,
    SoundSource,
)
from sonify.sound.sources.tabletop import ARRIVAL_MARGIN, ElasticTable

if TYPE_CHECKING:
    from modal.tabletop.record import SurfaceModes
    from sonify.scene import Scene

LAGRANGE_NODES = np.arange(-2, 4)  # samples
"""Offsets from an arrival time over which Lagrange interpolation distributes the
arriving force."""


def coincidence_frequency(surface: "InfiniteSurface", listener: Listener) -> float:
    """Return the frequency [Hz] above which bending waves reach the listener before the
    direct sound."""
    inertia = surface.density * surface.thickness / bending_stiffness(surface)
    return (
        listener.air.sound_speed**2
        * np.sqrt(inertia)
        / (2 * np.pi * np.cos(listener.elevation) ** 2)
    )


def pressure_per_force(surface: "InfiniteSurface", listener: Listener) -> float:
    """Return rho/(2 pi r m'') [1/m^2], the pressure at the listener per force far below
    coincidence."""
    return listener.air.density / (
        2 * np.pi * listener.distance * surface.density * surface.thickness
    )


class InfiniteTable(SoundSource):
    """Far field of an infinite plate under the moving contact, with one pole pair at
    coincidence.

    Sound from a contact point nearer to the listener arrives earlier, so a constant
    force radiates if it moves. Above coincidence the bending waves of the plate arrive
    before the direct sound; in the model they arrive after it by the same interval,
    with the same spectrum. The time advance due to the contact position is limited to
    that of a path of four disk radii."""

    names = ("table",)

    def __init__(self, scene: "Scene", listener: Listener) -> None:
        self._scene = scene
        self._rate = scene.audio.sample_rate
        surface = scene.surface
        if not isinstance(surface, InfiniteSurface):
            raise TypeError(f"surface.kind = {surface.kind!r}: must be 'infinite'")
        self._loss_factor = surface.loss_factor
        self._strength = pressure_per_force(surface, listener)
        self._direction = listener.position / listener.distance
        self._coincidence = coincidence_frequency(surface, listener)
        self._air = listener.air
        self.channel_ends = np.array(
            [[scene.disk.weight, MODAL_FORCE_FADE], [np.nan, MODAL_FORCE_FADE]]
        )
        self._max_advance = (
            4 * scene.disk.radius / listener.air.sound_speed * self._rate
        )
        self.tail_duration = 4 * FADE_OUT
        self.latency = ARRIVAL_MARGIN + int(self._max_advance)

    def input_channels(
        self, force: np.ndarray, state: np.ndarray, film: np.ndarray
    ) -> np.ndarray:
        """Return (k, 2): force of contact and film [N] and lead of its sound over sound from the
        centre [samples]."""
        disk = self._scene.disk
        fillet = self._scene.contact.rolling_fillet(disk)
        path = contact_position(state, disk, fillet) @ self._direction[:2]
        advance = path / self._air.sound_speed * self._rate
        return np.column_stack(
            [
                force[:, 2] + film[:, 1],
                np.clip(advance, -self._max_advance, self._max_advance),
            ]
        )

    def make_block_renderer(self, first: np.ndarray, note: Note) -> Advance:
        """Return a function that computes the pressure (k, 1) [Pa] of successive
        blocks.

        The force is constant before the first block."""
        latency = self.latency
        weight = self._scene.disk.weight
        bank = OscillatorBank(*self._coincidence_pole(), self._rate)
        bank.set_steady_state(first[0] - weight)
        in_flight = np.zeros(2 * latency + len(LAGRANGE_NODES))
        in_flight[: int(latency - first[1])] = first[0]

        def advance(force: ContactForce) -> np.ndarray:
            nonlocal in_flight
            count = len(force.t) - 1
            sent, earlier = force.samples[:-1].T
            arrived = np.append(in_flight, np.zeros(count))
            place = np.arange(count) + latency - earlier
            whole = np.floor(place).astype(int)
            for node, share in zip(
                LAGRANGE_NODES,
                lagrange_weights(LAGRANGE_NODES, place - whole),
                strict=True,
            ):
                arrived += np.bincount(whole + node, sent * share, len(arrived))
            radiating = arrived[: count + 1] - weight
            in_flight = arrived[count:]
            if len(
                bank.omega
            ):  # the pole pair w^2 q = force - q'' - 2 d q' radiates force - q''
                radiating[:-1] -= bank.advance(radiating[:, None])[:, 0]
            return -self._strength * radiating[:-1, None]

        return advance

    def _coincidence_pole(self) -> tuple[np.ndarray, np.ndarray]:
        """Return frequency and decay rate of the pole pair; empty arrays if it is above
        the Nyquist frequency."""
        sampled = self._coincidence < self._rate / 2
        frequency = np.array([self._coincidence] if sampled else [])
        return frequency, np.pi * frequency * self._loss_factor


def table_sources(
    scene: "Scene", modes: "SurfaceModes | None", listener: Listener
) -> list[SoundSource]:
    """Return the sound sources of the table; `modes` are those of an elastic table, or
    None."""
    if scene.surface.kind == "infinite":
        return [InfiniteTable(scene, listener)]
    return [ElasticTable(scene, modes, listener)] if modes is not None else []
