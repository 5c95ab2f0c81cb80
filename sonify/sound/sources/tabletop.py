"""Compute the sound of an elastic table under the moving contact, with or without a
baffle."""

from math import ceil
from typing import TYPE_CHECKING

import numpy as np
from numpy.lib.stride_tricks import as_strided

from dynamics.contact_geometry import contact_position
from dynamics.motion import FILM_COLUMNS
from modal.tabletop.record import SurfaceModes
from sonify.sound.audible_modes import (
    MAX_RING_TIME,
    RING_DOWN_DB,
    loudness_and_energy,
)
from sonify.sound.oscillators import Knots, OscillatorBank
from sonify.sound.radiation import Listener, listeners_of
from sonify.sound.sources.protocol import (
    FADE_OUT,
    MODAL_FORCE_FADE,
    Advance,
    Note,
    SoundSource,
    windowed_energy_peaks,
)
from sonify.sound.unbaffled import UnbaffledRatio

if TYPE_CHECKING:
    from sonify.scene import Scene
    from sonify.sound.force import ContactForce

LIFT, MOMENT = (FILM_COLUMNS.index(name) for name in ("lift", "moment_1"))
"""Columns of the loads of the film."""
ARRIVAL_MARGIN = 12  # samples
"""Margin before the first and after the last arrival, in which the band-limited kernels
decay."""


def shapes_at_contact(
    modes: SurfaceModes, state: np.ndarray, scene: "Scene"
) -> np.ndarray:
    """Return the shapes w (k, m) [kg^-1/2] of the table at the contact, for states (k,
    11)."""
    if (
        scene.surface.kind == "modes"
    ):  # shapes are known only on the contact circle, which moves with the disk
        ahead = state[:, 0] + np.pi / 2
        return modes.at(
            scene.disk.radius * np.cos(ahead), scene.disk.radius * np.sin(ahead)
        )
    fillet = scene.contact.rolling_fillet(scene.disk)
    return modes.at(*(modes.place + contact_position(state, scene.disk, fillet)).T)


class ElasticTable(SoundSource):
    """Elastic table driven at the moving contact, with a top face that radiates
    upwards.

    Shading of the table by the disk is neglected. So is the friction force, because its
    bending of a plate is smaller than that of the normal force by the ratio of
    thickness to wavelength."""

    names = ("table",)

    def __init__(self, scene: "Scene", modes: SurfaceModes, listener: Listener) -> None:
        self._scene = scene
        self._modes = modes
        self._rate = scene.audio.sample_rate
        self.latency = table_latency(modes, listener, self._rate)
        self._kernels = radiation_kernels(
            modes, listener, self._rate, self.latency, scene.surface.baffle
        )
        self.channel_ends = np.tile([np.nan, MODAL_FORCE_FADE], (len(modes), 1))
        slowest = modes.decay_rate.min(initial=np.inf)
        audible = min(
            np.log(10) / 20 * RING_DOWN_DB / max(slowest, 1e-9), MAX_RING_TIME
        )
        self.tail_duration = FADE_OUT + max(FADE_OUT, audible)

    def input_channels(
        self, force: np.ndarray, state: np.ndarray, film: np.ndarray
    ) -> np.ndarray:
        """Return the modal forces (k, m) [N kg^-1/2].

        They are minus the normal force times the shapes at the contact. The lift of the film,
        which presses on the table as well, is replaced by forces at the contact and below the
        centre of the disk with the same resultant and moment about e_1.
        """
        contact = shapes_at_contact(self._modes, state, self._scene)
        lift, moment = film[:, LIFT], film[:, MOMENT]
        if not lift.any() and not moment.any():
            return -force[:, 2:] * contact
        near = moment / self._scene.disk.radius
        if self._scene.surface.kind == "modes":  # shapes are known at the contact only
            near = lift
        at_contact = (force[:, 2] + near)[:, None] * contact
        below_centre = self._modes.at(*(self._modes.place + state[:, 3:5]).T)
        return -at_contact - (lift - near)[:, None] * below_centre

    def make_block_renderer(self, first: np.ndarray, note: Note) -> Advance:
        """Return a function that computes the pressure (k, 1) [Pa] of successive
        blocks.

        The modal forces `first` (m,) are constant before the first block."""
        bank = OscillatorBank(self._modes.frequency, self._modes.decay_rate, self._rate)
        bank.set_steady_state(first)
        past = len(self._kernels) - 1
        moved = np.zeros((past, len(self._modes)))

        def advance(force: "ContactForce") -> np.ndarray:
            nonlocal moved
            count = len(force.t) - 1
            # Reuse memory, because allocation would take longer than the steps.
            if len(moved) < past + count:
                moved = np.vstack([moved[:past], np.empty((count, len(self._modes)))])
            knots = Knots(*force.knots, force.jump, force.bend)
            accelerations = bank.advance(
                force.samples, knots, out=moved[past : past + count]
            )
            note(
                *windowed_energy_peaks(force.t, accelerations, self._modes, self._rate)
            )
            pressure = convolve_kernels(moved[: past + count], self._kernels)[:, None]
            moved[:past] = moved[count : past + count].copy()
            return pressure

        return advance


def table_latency(modes: SurfaceModes, listener: Listener, sample_rate: float) -> int:
    """Return the latency [samples] of the sound of the table.

    It is the maximum lead of sound from the table over sound from the disk, plus
    ARRIVAL_MARGIN."""
    path = _path_lengths(modes, listener)
    return (
        ceil((listener.distance - path.min()) / listener.air.sound_speed * sample_rate)
        + ARRIVAL_MARGIN
    )


def radiation_kernels(
    modes: SurfaceModes,
    listener: Listener,
    sample_rate: float,
    latency: int,
    baffle: bool = True,
) -> np.ndarray:
    """Return kernels (j, m) that convert modal accelerations to pressure by
    convolution.

    The pressure [Pa] at sample n is the sum of kernels[i] times the accelerations at n
    - i. The kernels are those of `table_radiation` delayed by `latency` samples, exact
    over most of the frequency range and tapered to zero below the Nyquist frequency."""
    passband = 0.84  # of the Nyquist frequency
    longest = _path_lengths(modes, listener).max()
    if not baffle:  # the edge scatters sound across the table
        longest += 2 * np.ptp(modes.points - modes.place, axis=0).max()
    last_arrival = (longest - listener.distance) / listener.air.sound_speed
    count = latency + ceil(last_arrival * sample_rate) + ARRIVAL_MARGIN
    size = 2 << (2 * count).bit_length()
    frequency = np.fft.rfftfreq(size, 1 / sample_rate)
    above_passband = np.clip(
        (2 * frequency / sample_rate - passband) / (1 - passband), 0, 1
    )
    taper = np.cos(np.pi / 2 * above_passband) ** 2
    spectrum = table_radiation(modes, listener, frequency, baffle)
    delay = np.exp(-2j * np.pi * frequency / sample_rate * latency)
    return np.fft.irfft(spectrum * (taper * delay)[:, None], size, axis=0)[:count]


def table_radiation(
    modes: SurfaceModes, listener: Listener, frequency: np.ndarray, baffle: bool = True
) -> np.ndarray:
    """Return the pressure (f, m) [Pa] of the table per unit modal acceleration at
    frequencies (f,) [Hz].

    The factor exp(-i k distance) is omitted. In a plane baffle the result is Rayleigh's
    integral over the top face, exact above and below coincidence. Without a baffle both
    faces radiate, and each point is weighted by `UnbaffledRatio`, which is exact for a
    round table and a distant listener. Matrix products over blocks of frequencies
    reduce memory traffic."""
    block_size = 32  # frequencies
    path = _path_lengths(modes, listener)
    delay = (path - listener.distance) / listener.air.sound_speed
    share = listener.air.density / (2 * np.pi) * modes.weights / path
    edge = None
    if not baffle and len(modes):
        edge = UnbaffledRatio(
            modes.points - modes.place,
            modes.weights,
            listener.position / listener.distance,
            listener.air.sound_speed,
        )
    pressure = np.empty((len(frequency), len(modes)), complex)
    for n in range(0, len(frequency), block_size):
        some = frequency[n : n + block_size]
        waves = share * np.exp(-2j * np.pi * np.multiply.outer(some, delay))
        if edge is not None:
            waves = waves * [edge.ratio_at(f) for f in some]
        pressure[n : n + block_size] = waves.real @ modes.face.T + 1j * (
            waves.imag @ modes.face.T
        )
    return pressure


def convolve_kernels(accelerations: np.ndarray, kernels: np.ndarray) -> np.ndarray:
    """Return the convolutions of accelerations (j - 1 + k, m) with kernels (j, m),
    summed over modes (k,).

    The first j - 1 accelerations precede the first pressure. The blocks fit into the
    processor cache."""
    block_size = 4096  # samples
    count = len(kernels)
    reversed_kernels = np.ascontiguousarray(kernels[::-1].T)
    out = np.empty(len(accelerations) - count + 1)
    for n in range(0, len(out), block_size):
        products = accelerations[n : n + block_size + count - 1] @ reversed_kernels
        size = len(products) - count + 1
        step = products.itemsize
        diagonals = as_strided(
            products, (size, count), (count * step, (count + 1) * step)
        )
        out[n : n + size] = diagonals.sum(axis=1)
    return out


def _path_lengths(modes: SurfaceModes, listener: Listener) -> np.ndarray:
    """Return the distances (p,) [m] of the listener from the points of the top face;
    for a near listener the disk's centre is half a thickness above the table."""
    below = np.full(len(modes.points), -listener.face_height)
    points = np.column_stack([modes.points - modes.place, below])
    return np.linalg.norm(listener.position - points, axis=1)


def response_to_unit_jump(
    modes: SurfaceModes, scene: "Scene"
) -> tuple[np.ndarray, np.ndarray]:
    """Return loudness (m,) [Pa^2 s] and energy (m,) [J] of the modes after a force jump
    of 1 N.

    The loudness of `audible_modes.response_to_unit_jump` is maximised over the
    listeners. Each shape is represented by its root mean square over the circle covered
    by the disk."""
    circle_radius, circle_angle = np.meshgrid(
        scene.disk.radius * np.arange(1, 9) / 8, np.arange(64) * np.pi / 32
    )
    r = circle_radius.ravel()
    angle = circle_angle.ravel()
    points = modes.place[:, None] + r * np.array([np.cos(angle), np.sin(angle)])
    g2 = r @ modes.at(*points) ** 2 / r.sum()
    pressure = np.zeros(len(modes))
    for ear in listeners_of(scene):
        each = table_radiation(modes, ear, modes.frequency, scene.surface.baffle)
        pressure = np.maximum(pressure, np.abs(np.diag(each)))
    return loudness_and_energy(modes, g2, pressure**2)
