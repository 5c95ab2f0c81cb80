"""Compute frequency, decay and radiation of the modes above an air film as functions of
the gap."""

from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise
from math import pi
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.polynomial.legendre import legvander
from scipy.interpolate import PchipInterpolator
from scipy.optimize import brentq

from dynamics.air import PRANDTL_NUMBER, Air
from dynamics.numba_kernels import njit
from modal import Modes
from sonify.sound.film_radiation import MAX_RIM_ORDER
from sonify.sound.force import ContactForce
from sonify.sound.oscillators import OscillatorBank
from sonify.sound.radiation import (
    Listener,
    listener_of,
    listener_position,
    rayleigh,
    tabulated_directivity,
)
from sonify.sound.response import DrivenModes

if TYPE_CHECKING:
    from dynamics.film.reynolds import FilmMesh
    from sonify.scene import Scene

Parts = list[tuple["FilmMesh", np.ndarray]]
"""Parts of a shape on the bottom face, each with its half mesh."""

TABULATED_GAPS = np.geomspace(2.5e-3, 4e-6, 12)  # m
"""Mean gaps at which the film equation is solved; outside the range the nearest value
applies."""
FILM_MESH_GRADING = 6.0
"""Grading of the film's mesh, the argument `nearest` of FilmMesh."""
MIN_FILM_MESH_CELLS = 8
"""Smallest number of elements of the film's mesh along the radius."""
MAX_FILM_MESH_CELLS = 36
"""Largest number of elements of the film's mesh along the radius."""
TUNING_LOG_GAP_STEP = 0.02
"""Step of the log gap between successive tunings of the oscillators."""


@dataclass(frozen=True, kw_only=True, eq=False)
class FluidLoadedModes:
    """Properties of m modes above the film, tabulated at several mean gaps (a,).

    Attributes
    ----------
    log_gap : ndarray, shape (a,)
        Logarithms of the mean gaps [m], equally spaced, in descending order.
    frequency : ndarray, shape (a, m)
        Frequency of the damped mode [Hz].
    film_decay_rate : ndarray, shape (a, m)
        Decay rate due to the film [1/s].
    decay_rate : ndarray, shape (m,)
        Decay rate [1/s] without the film.
    gain : ndarray, shape (a, m)
        Radiated pressure, divided by that of the same mode above a closed film.
    """

    log_gap: np.ndarray
    frequency: np.ndarray
    film_decay_rate: np.ndarray
    decay_rate: np.ndarray
    gain: np.ndarray

    def apply_gain(self, ringing: np.ndarray, gap: np.ndarray) -> np.ndarray:
        """Multiply modal accelerations (s, k, m) in place by the gain at log gaps
        (k,)."""
        intervals = len(self.log_gap) - 1
        where = (gap - self.log_gap[0]) * (
            intervals / (self.log_gap[-1] - self.log_gap[0])
        )
        return _apply_gain(ringing, np.clip(where, 0.0, intervals), self.gain)

    def tuning(self, gap: float | np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return frequencies [Hz] and decay rates [1/s] (..., m) at log gaps (...).

        Frequencies and logarithms of the decay rates are interpolated monotonically."""
        offset = 1e-3  # 1/s; keeps the logarithm of the film's decay rate finite
        frequency, log_added = (
            PchipInterpolator(self.log_gap[::-1], column[::-1])(gap)
            for column in (self.frequency, np.log(self.film_decay_rate + offset))
        )
        return frequency, self.decay_rate + np.maximum(np.exp(log_added) - offset, 0.0)

    def nearest_tuning(self, gap: float) -> tuple[np.ndarray, np.ndarray]:
        """Return the frequencies and decay rates (m,) that GapTunedOscillators uses at
        a log gap."""
        return self.tuning_at_level(self.tuning_level(gap))

    def tuning_level(self, gap: float | np.ndarray) -> np.ndarray:
        """Return the number of steps of TUNING_LOG_GAP_STEP from the widest tabulated
        gap to a log gap."""
        inside = np.clip(gap, self.log_gap[-1], self.log_gap[0])
        return np.round((self.log_gap[0] - inside) / TUNING_LOG_GAP_STEP).astype(int)

    def tuning_at_level(self, level: int | np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the tuning after a number of steps of TUNING_LOG_GAP_STEP."""
        return self.tuning(self.log_gap[0] - TUNING_LOG_GAP_STEP * level)


@lru_cache(maxsize=1)  # one solution for all listeners
def fluid_loaded_modes(
    modes: Modes, scene: "Scene", smallest_gap: float = 0.0
) -> FluidLoadedModes:
    """Return the modes of a scene above its air film, tabulated down to `smallest_gap`
    [m].

    The contact coincides with the patch of the modes. The eigenvalue of a mode of unit
    modal mass solves lambda^2 + 2 drag lambda + w^2 = 0, with drag = d - 6 mu R^4/g^3
    int p w dA evaluated at the rate Im lambda, which is extrapolated from the wider
    gaps. If the logarithm of the computed rate differs from the extrapolated one by
    more than 0.1, the film dominates the mode, and `_phase_resonance` determines the
    rate. The film model includes the inertia of the air and heat conduction to both
    faces; the pressure vanishes at the rim."""
    air = scene.air
    radius = scene.disk.radius
    natural = 2 * pi * modes.frequency
    lowest = 0.05 * natural
    highest = 2 * pi * 0.45 * scene.audio.sample_rate
    shapes = _parity_parts_of_modes(
        modes, mesh_cells(natural * radius / air.sound_speed), radius
    )
    rate = natural
    previous_rate = natural
    frequencies = []
    film_decay_rate = []
    flows = []
    gaps = _gaps_down_to(smallest_gap)
    for gap in gaps:
        extrapolated = np.clip(rate * rate / previous_rate, lowest, highest)
        responses = [
            _film_response(parts, gap, r, radius, air)
            for parts, r in zip(shapes, extrapolated, strict=True)
        ]
        drag = np.array([response.drag for response in responses], complex)
        eigenvalue = _eigenvalues(drag + modes.decay_rate, natural)
        previous_rate = rate
        rate = np.clip(eigenvalue.imag, lowest, highest)
        decay = -eigenvalue.real
        for i in np.flatnonzero(np.abs(np.log(rate / extrapolated)) > 0.1):
            rate[i], responses[i] = _phase_resonance(
                shapes[i], gap, natural[i], (lowest[i], highest), radius, air
            )
            decay[i] = responses[i].drag.real + modes.decay_rate[i]
        frequencies.append(rate / (2 * pi))
        film_decay_rate.append(np.maximum(decay - modes.decay_rate, 0.0))
        flows.append([response.rim for response in responses])
    shape = (len(gaps), len(modes), 2 * MAX_RIM_ORDER + 1)
    return FluidLoadedModes(
        log_gap=np.log(gaps),
        frequency=np.array(frequencies),
        film_decay_rate=np.array(film_decay_rate),
        decay_rate=modes.decay_rate,
        gain=radiation_gain(modes, scene, np.reshape(flows, shape)),
    )


class ModeFilmResponse(NamedTuple):
    """Response of the film to a mode of unit modal mass.

    `drag` is half the impedance of the film [1/s]; `rim` (2 MAX_RIM_ORDER + 1,)
    contains the harmonics of the flow out of the rim."""

    drag: complex
    rim: np.ndarray


def _phase_resonance(
    parts: Parts,
    gap: float,
    natural: float,
    limits: tuple[float, float],
    radius: float,
    air: Air,
) -> tuple[float, ModeFilmResponse]:
    """Return the phase-resonance rate [rad/s] of a mode, and the film response at this
    rate.

    The rate lies within `limits` and solves w^2 + K(rate) = rate^2, where K = -2 rate
    Im drag is the stiffness of the film minus its inertia. The squeezed film acts as a
    spring in series with a leak: K grows as rate^2 and saturates, so the solution is
    unique."""
    responses = {}

    def excess(log_rate: float) -> float:
        rate = np.exp(log_rate)
        responses[log_rate] = _film_response(parts, gap, rate, radius, air)
        return natural**2 - 2 * rate * responses[log_rate].drag.imag - rate**2

    low, high = np.log(limits)
    if excess(low) <= 0:
        return limits[0], responses[low]
    if excess(high) >= 0:
        return limits[1], responses[high]
    log_rate = brentq(excess, low, high, xtol=5e-3)
    excess(log_rate)
    return float(np.exp(log_rate)), responses[log_rate]


def mesh_cells(wavenumber: np.ndarray) -> list[int]:
    """Return the numbers of radial mesh elements for modes with wavenumbers k R (m,).

    The computing time of a mode is proportional to the square of this number. If the
    sum of the squares corresponds to more than several minutes, the finest meshes are
    coarsened, but not below MIN_FILM_MESH_CELLS."""
    cells_per_wave = 2.5
    max_squared_cell_sum = 5e4  # sum of squares of element numbers
    cells = np.clip(
        np.ceil(cells_per_wave * np.asarray(wavenumber)),
        MIN_FILM_MESH_CELLS,
        MAX_FILM_MESH_CELLS,
    ).astype(int)
    finest = MAX_FILM_MESH_CELLS
    while (cells**2).sum() > max_squared_cell_sum and finest > MIN_FILM_MESH_CELLS:
        finest -= 1
        cells = np.minimum(cells, finest)
    return cells.tolist()


def _parity_parts(
    modes: Modes, i: int, half_meshes: "list[FilmMesh]", radius: float
) -> Parts:
    """Return the even and odd parts of a mode's bottom-face shape as pairs (half mesh,
    shape).

    Parts smaller than 1e-4 of the larger one are omitted, because the response is
    quadratic in the shape. A mode that does not move the face, such as a torsional
    mode, has no parts."""
    points = half_meshes[0].points
    here, mirrored = bottom_shape(modes, i, np.array([points, points.conj()]), radius)
    parts = [(mesh, (here + mesh.parity * mirrored) / 2) for mesh in half_meshes]
    negligible = 1e-4 * max(np.abs(part).max() for _, part in parts)
    return [(mesh, part) for mesh, part in parts if np.abs(part).max() > negligible]


def _film_response(
    parts: Parts, gap: float, rate: float, radius: float, air: Air
) -> ModeFilmResponse:
    """Return the response of a film of mean gap `gap` [m] to a mode vibrating at `rate`
    [rad/s]."""
    sigma = 12 * air.viscosity * rate * radius**2 / (air.pressure * gap**2)
    layers = boundary_layer_number(gap, rate, air)
    heat = layers * PRANDTL_NUMBER**0.5
    work = 0j
    rim = np.zeros(2 * MAX_RIM_ORDER + 1, complex)
    for mesh, shape in parts:
        response = mesh.linear_responses(
            [shape],
            [shape],
            sigma,
            inertia=layers,
            orders=MAX_RIM_ORDER,
            heat=heat,
        )[0]
        work += response.works[0]
        rim = rim + response.rim
    return ModeFilmResponse(-6 * air.viscosity * radius**4 / gap**3 * work, rim)


def raised_disk_pressure_ratios(
    thickness: float, radius: float
) -> tuple[float, float, float, float]:
    """Return the pressure ratios a0, b0, a1, b1 of a raised disk to a flush piston.

    The factors a apply to the motion of the upper face, and b to the flow out of the
    rim; index 0 denotes heave and index 1 tilt. The fits are accurate to 2 % below 1
    kHz, at a distance of 0.5 m and an elevation of 45 degrees."""
    x = thickness / radius
    return 1.0, 0.998, 1 + 0.75 * x / (1 + 2.45 * x), 1 + 1.66 * x / (1 + 1.5 * x)


def boundary_layer_number(gap: float, rate: float, air: Air) -> complex:
    """Return g sqrt(i w rho/mu), the ratio of the gap to the thickness of the viscous
    boundary layers."""
    return gap * (1j * rate * air.density / air.viscosity) ** 0.5


def bottom_shape(modes: Modes, i: int, points: np.ndarray, radius: float) -> np.ndarray:
    """Return the axial shape of mode i on the bottom face at complex points (x + i
    y)/radius.

    The contact is at -1."""
    wave = np.fft.rfft(modes.face_shape[i, 0], axis=1) / len(modes.face_angle)
    wave[:, 1:] *= 2
    nodes = modes.face_radius / radius
    degree = len(modes.face_radius) - 1
    polynomials = np.linalg.solve(
        legvander(2 * nodes - 1, degree), wave[:, : 2 * MAX_RIM_ORDER]
    )
    along = legvander(2 * np.abs(points).ravel() - 1, degree) @ polynomials
    turn = np.exp(1j * np.outer(np.angle(points) + pi, np.arange(along.shape[1])))
    return (along * turn).real.sum(axis=1).reshape(points.shape)


def _gaps_down_to(smallest_gap: float) -> np.ndarray:
    """Return the TABULATED_GAPS (n,) [m] down to a gap, and two narrower ones."""
    spare_gaps = 2
    return TABULATED_GAPS[
        : max(np.count_nonzero(smallest_gap < TABULATED_GAPS) + spare_gaps, 4)
    ]


def _parity_parts_of_modes(
    modes: Modes, cells: list[int], radius: float
) -> list[Parts]:
    """Return the `_parity_parts` of each mode on a mesh with its number of cells (m,)."""
    from dynamics.film.reynolds import FilmMesh  # scikit-fem loads slowly

    half_meshes = {
        count: [
            FilmMesh(count, nearest=FILM_MESH_GRADING, parity=parity)
            for parity in (1, -1)
        ]
        for count in set(cells)
    }
    return [
        _parity_parts(modes, i, half_meshes[count], radius)
        for i, count in enumerate(cells)
    ]


def _eigenvalues(drag: np.ndarray, natural: np.ndarray) -> np.ndarray:
    """Return the solutions (m,) of lambda^2 + 2 drag lambda + natural^2 = 0 that rotate
    forwards."""
    root = np.sqrt(drag**2 - natural**2)
    return -drag + np.where(root.imag < 0, -root, root)


def _rim_pressure(
    scene: "Scene",
    listener: Listener,
    azimuths: np.ndarray,
    wavenumber: np.ndarray,
    factors: tuple[float, float],
) -> np.ndarray:
    """Return the pressures (v, m, h) of unit harmonics of the rim flow at the azimuths (v,).

    Harmonics of order 0 and of higher orders are multiplied by the two `factors`.
    """
    angle_count = 64
    zeroth, other = factors
    signed_order = np.append(np.arange(MAX_RIM_ORDER + 1), np.arange(-MAX_RIM_ORDER, 0))
    order = np.abs(signed_order)
    radius = scene.disk.radius
    angle = 2 * pi * np.arange(angle_count) / angle_count
    turn = np.exp(1j * np.outer(signed_order, angle + pi))
    waves = np.where(order == 0, zeroth, other)[:, None] * turn * radius / (2 * pi)
    ring = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    weight = np.full(angle_count, radius * angle[1])
    return np.array(
        [
            rayleigh(
                waves,
                ring,
                weight,
                wavenumber[:, None],
                listener_position(listener, azimuth),
                listener.air.density,
            )
            for azimuth in azimuths
        ]
    )


def radiation_gain(modes: Modes, scene: "Scene", flows: np.ndarray) -> np.ndarray:
    """Return the ratio (a, m) of the total pressure to that of the upper face alone.

    The total pressure is that of the upper face and the flow out of the rim.

    `flows` (a, m, 2 MAX_RIM_ORDER + 1) are harmonics of the rim flow. Pressures
    are root mean squares over the azimuth. Harmonics 0 and 1 are corrected for the
    height of the disk. Modes with large k R radiate as above a closed film, because the
    model does not cover their rim flow.
    """
    azimuth_count = 16
    max_wavenumber = 1.5  # k R
    a0, b0, a1, b1 = raised_disk_pressure_ratios(
        scene.disk.thickness, scene.disk.radius
    )
    listener = listener_of(scene)
    wave = np.fft.rfft(modes.face_shape, axis=3)
    wave[..., 0] *= a0
    wave[..., 1] *= a1
    raised = replace(
        modes, face_shape=np.fft.irfft(wave, len(modes.face_angle), axis=3)
    )
    closed, top = (
        tabulated_directivity(m, listener, count=azimuth_count) for m in (modes, raised)
    )
    k = 2 * pi * modes.frequency / listener.air.sound_speed
    azimuths = 2 * pi * np.arange(azimuth_count) / azimuth_count
    rim_pressure = _rim_pressure(scene, listener, azimuths, k, (b0, b1))
    rim = np.einsum("amn,vmn->avm", flows, rim_pressure)
    alone = np.mean(np.abs(closed) ** 2, axis=0)
    power = np.mean(np.abs(top + rim) ** 2, axis=1)
    level = np.divide(
        power, alone, out=np.ones_like(power), where=alone > 0
    )  # torsional modes do not radiate
    return np.where(k * scene.disk.radius > max_wavenumber, 1.0, np.sqrt(level))


class GapTunedOscillators(DrivenModes):
    """Oscillators of m modes that are retuned without clicks as the gap changes.

    The solution is exact while the tuning is constant. A change of tuning conserves the
    velocity and the displacement from static equilibrium: the film does not resist slow
    motion, so a static load must not excite ringing.

    Parameters
    ----------
    tabulated : FluidLoadedModes
    sample_rate : float
        [Hz]
    settled : ndarray, shape (m,)
        Constant force on each mode before the first block.
    gap : float
        Logarithm of the mean gap [m] at the start of the first block.
    """

    def __init__(
        self,
        tabulated: FluidLoadedModes,
        sample_rate: float,
        settled: np.ndarray,
        gap: float,
    ) -> None:
        self._tabulated = tabulated
        self._rate = sample_rate
        self._banks_of_levels: dict[int, list[OscillatorBank]] = {}
        self._level = int(tabulated.tuning_level(gap))
        super().__init__(*tabulated.nearest_tuning(gap), sample_rate, settled)

    def advance_at_gap(self, force: ContactForce, gap: np.ndarray) -> np.ndarray:
        """Return the accelerations (2, k, m) due to smooth force and jumps in one
        block.

        `gap` (k + 1,) is the logarithm of the mean gap."""
        levels = self._tabulated.tuning_level(gap[:-1])
        changes = np.flatnonzero(np.diff(levels, prepend=self._level))
        out = np.empty((2, len(levels), force.smooth.shape[1]))
        parts = force.parts
        for start, end in pairwise([0, *changes, len(levels)]):
            if levels[start] != self._level:
                self._retune(int(levels[start]), [g[start] for g, _ in parts])
            for (g, knots), bank, ringing in zip(parts, self._banks, out, strict=True):
                bank.advance(
                    g[start : end + 1], knots.between(start, end), ringing[start:end]
                )
        return out

    def _retune(self, level: int, forces: list[np.ndarray]) -> None:
        """Change the tuning to a level at force samples (m,), one for each bank."""
        if level not in self._banks_of_levels:
            tuning = self._tabulated.tuning_at_level(level)
            self._banks_of_levels[level] = [
                OscillatorBank(*tuning, self._rate) for _ in forces
            ]
        before = self._banks
        self._banks = self._banks_of_levels[level]
        self._level = level
        for bank, other, g in zip(self._banks, before, forces, strict=True):
            bank.take_over(other, g)


@njit(cache=True)
def _apply_gain(ringing: np.ndarray, where: np.ndarray, gain: np.ndarray) -> np.ndarray:
    """Multiply accelerations (s, k, m) by the gain (a, m) interpolated at fractional
    rows (k,)."""
    for n in range(len(where)):
        low = min(int(where[n]), len(gain) - 2)
        for m in range(gain.shape[1]):
            factor = gain[low, m] + (where[n] - low) * (gain[low + 1, m] - gain[low, m])
            for s in range(len(ringing)):
                ringing[s, n, m] *= factor
    return ringing
