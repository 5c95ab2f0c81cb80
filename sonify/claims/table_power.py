"""Power that a table with one-way coupling takes, compared with that of the disk.

With one-way coupling the contact force drives the table, but the table does not slow the
disk. The heat in the table and its sound are then taken from nowhere. They must be small
compared with the power that the disk loses in the same time."""

from collections.abc import Callable, Iterator
from math import inf
from typing import NamedTuple

import numpy as np
from scipy.signal import lfilter

from dynamics import InfiniteSurface, Motion
from dynamics.compliant.law.table_receptance import infinite_plate_mobility
from modal import SurfaceModes
from sonify.claims.finding import Measured, finding
from sonify.claims.two_way import two_way_part
from sonify.scene import Scene
from sonify.sound.radiation import Listener
from sonify.sound.sources.contact import ContactFilter, superposed_part
from sonify.sound.sources.tabletop import shapes_at_contact, table_radiation

Powers = Callable[[np.ndarray, np.ndarray, np.ndarray], tuple[float, float]]
"""Function of times [s], forces [N] and a mask that returns the powers [W] which a
table takes and radiates."""

SAMPLE_RATE = 192_000
"""Rate [Hz] at which force and table are evaluated; it does not depend on the sound."""
LEAD_TIME = 0.05
"""Time [s] before each interval in which the force is switched on smoothly."""


class TablePower(NamedTuple):
    """Mean powers [W] in one interval of a motion with one-way coupling.

    Attributes
    ----------
    begin, end : float
        The interval [s].
    lost : float
        Power that the disk loses.
    heat : float
        Power that becomes heat or stored vibration in the table.
    radiated : float
        Power of the sound of the table.
    """

    begin: float
    end: float
    lost: float
    heat: float
    radiated: float

    def relative_to_loss(self, power: float) -> float:
        """Return a power divided by that which the disk loses; it may be infinite."""
        if self.lost > 0:
            return power / self.lost
        return inf if power > 0 else 0.0

    @property
    def share(self) -> float:
        """Power that the table takes, divided by the power that the disk loses."""
        return self.relative_to_loss(self.heat + self.radiated)


def one_way_end(motion: Motion) -> float:
    """Return the time [s] at which two-way coupling begins, or the end of the motion."""
    coupled = two_way_part(motion)
    return coupled[1] if coupled else float(motion.t[-1])


def intervals(end: float) -> list[tuple[float, float]]:
    """Return intervals (begin, end) [s] of a motion, closer together towards its end."""
    count = 8
    longest = 0.2  # s
    duration = min(longest, end / (2 * count))
    middles = end - np.geomspace(end - duration, duration, count)
    return [(middle - duration / 2, middle + duration / 2) for middle in middles]


def table_powers(
    scene: Scene, motion: Motion, table: SurfaceModes | None, listener: Listener
) -> Iterator[TablePower]:
    """Yield the `TablePower` in several intervals before any two-way coupling.

    `table` has all modes of the table; None stands for an infinite plate.
    """
    force_at = _contact_force(scene, motion)
    take = (
        _powers_of_plate(scene, listener)
        if table is None
        else _powers_of_modes(scene, motion, table, listener)
    )
    for begin, end in intervals(one_way_end(motion)):
        first = max(begin - LEAD_TIME, 0.0)
        t = first + np.arange(round((end - first) * SAMPLE_RATE)) / SAMPLE_RATE
        switched = np.sin(np.pi / 2 * np.clip((t - first) / LEAD_TIME, 0, 1)) ** 2
        heat, radiated = take(t, force_at(t) * switched, t >= begin)
        energy = motion.energy([begin, end])
        lost = float(energy[0] - energy[1]) / (end - begin)
        yield TablePower(begin, end, lost, heat, radiated)


def _contact_force(scene: Scene, motion: Motion) -> Callable[[np.ndarray], np.ndarray]:
    """Return a function of times (k,) [s] that returns the normal force (k,) [N].

    The force includes the vibration that the sound superposes on a rigid motion."""
    is_smooth = scene.roughness is None or scene.contact.law == "rigid"
    has_law = motion.plan.tabulated_law is not None
    rigid = superposed_part(scene, motion)
    if is_smooth or not has_law or rigid is None:
        return lambda t: motion.force(t)[:, 2]

    def rough_force(t: np.ndarray) -> np.ndarray:
        force = motion.force(t)[:, 2]
        added = ContactFilter.along(rigid, scene, SAMPLE_RATE, float(t[0]))
        done = 0
        for block in added.blocks():
            part = block[: len(t) - done, 1]
            force[done : done + len(part)] += part
            done += len(part)
            if done == len(t):
                break
        return force

    return rough_force


def _powers_of_plate(scene: Scene, listener: Listener) -> Powers:
    """Return a function that returns the powers [W] which an infinite plate takes and
    radiates.

    Reference: Cremer, Heckl & Petersson, Structure-Borne Sound, 6.5, as in the sound of
    this plate."""
    surface = scene.surface
    assert isinstance(surface, InfiniteSurface)  # other tables have modes
    mass = surface.density * surface.thickness
    mobility = infinite_plate_mobility(surface)
    air = listener.air
    radiation = 0.0  # in a vacuum
    if air.density:
        radiation = air.density / (2 * np.pi * air.sound_speed * mass**2)

    def take(
        t: np.ndarray, force: np.ndarray, inside: np.ndarray
    ) -> tuple[float, float]:
        varying = float(np.var(force[inside]))
        return mobility * varying, radiation * varying

    return take


def _powers_of_modes(
    scene: Scene, motion: Motion, table: SurfaceModes, listener: Listener
) -> Powers:
    """Return a function that returns the powers [W] which table modes take and radiate.

    The radiated power assumes the pressure at the listener in all directions above the
    table, which is accurate to a factor of two."""
    modes_at_once = 64  # to limit the memory
    stride = 4  # samples, in which a shape at the contact changes linearly
    heard = np.linspace(0.0, 1.25 * table.frequency.max(initial=1.0), 128)
    radiation = table_radiation(table, listener, heard, scene.surface.baffle)
    impedance = listener.air.density * listener.air.sound_speed
    sphere = 0.0  # nothing radiates in a vacuum
    if impedance:
        sphere = 2 * np.pi * listener.distance**2 / impedance

    def take(
        t: np.ndarray, force: np.ndarray, inside: np.ndarray
    ) -> tuple[float, float]:
        nodes = np.append(t[:-1:stride], t[-1])
        state = motion.at(nodes)
        count = int(inside.sum())
        hann = np.hanning(count)
        frequency = np.fft.rfftfreq(count, 1 / SAMPLE_RATE)
        pressure = np.zeros(len(frequency), complex)
        heat = 0.0
        for m in range(len(table)):
            if m % modes_at_once == 0:
                some = table.select(np.arange(len(table))[m : m + modes_at_once])
                shapes = shapes_at_contact(some, state, scene)
            drive = -force * np.interp(t, nodes, shapes[:, m % modes_at_once])
            moved = modal_displacement(
                drive, table.frequency[m], table.decay_rate[m], SAMPLE_RATE
            )
            speed = np.gradient(moved, 1 / SAMPLE_RATE)[inside]
            heat += vibration_power(speed, table.decay_rate[m], count / SAMPLE_RATE)
            acceleration = np.gradient(speed, 1 / SAMPLE_RATE)
            spectrum = np.fft.rfft(hann * acceleration)
            pressure += spectrum * np.interp(frequency, heard, radiation[:, m])
        squared = 2 * np.sum(np.abs(pressure) ** 2) / np.sum(hann**2) / count
        return heat, sphere * float(squared)

    return take


def vibration_power(speed: np.ndarray, decay_rate: float, duration: float) -> float:
    """Return the mean power [W] that a mode of unit mass dissipates and stores.

    The vibration stores twice its mean kinetic energy; the energy of a slow, static
    deflection, which the disk gets back, does not count."""
    squared = speed**2
    tenth = max(len(squared) // 10, 1)
    gained = squared[-tenth:].mean() - squared[:tenth].mean()
    return float(2 * decay_rate * squared.mean() + gained / (0.9 * duration))


def modal_displacement(
    drive: np.ndarray, frequency: float, decay_rate: float, rate: float
) -> np.ndarray:
    """Return the displacement (k,) of a mode at rest under a modal force (k,).

    The poles and the static response are exact at the sample rate [Hz]."""
    squared = (2 * np.pi * frequency) ** 2
    turning = np.sqrt(squared - decay_rate**2 + 0j)
    older = -np.exp(-2 * decay_rate / rate)
    newer = float((2 * np.exp(-decay_rate / rate) * np.cos(turning / rate)).real)
    gain = (1 - newer - older) / squared
    return lfilter([0.0, gain], [1.0, -newer, -older], drive)


@finding(needs=("scene", "motion", "sound"), at_most=1.0)
def disk_supplies_table(
    scene: Scene, motion: Motion, table: SurfaceModes | None, listener: Listener
) -> Measured:
    """The greatest ratio of the power that the table takes to the power that the disk
    loses in the same interval, before any two-way coupling."""
    powers = list(table_powers(scene, motion, table, listener))
    most = max(powers, key=lambda power: power.share)
    details = {
        "heat": most.relative_to_loss(most.heat),
        "radiated": most.relative_to_loss(most.radiated),
        "time": (most.begin + most.end) / 2,
    }
    return Measured(most.share, details["radiated"], details)
