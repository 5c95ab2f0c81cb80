"""Compute the sound of a disk above an air film that damps and detunes its modes.

Where the film is open, the air displaced by the face leaves at the rim and cancels part
of the sound of the face. If p is the pressure of a flush piston in a baffle, the disk
radiates (a - g b) p, where g is the fraction of the displaced air that leaves at the
rim, and a and b account for the height of the disk. All coefficients are those of the
wedge (dynamics/film/reynolds.py) at the instantaneous inclination."""

from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from scipy.linalg import expm

from dynamics import Outcome
from dynamics.film.wedge import rotation_number
from dynamics.numba_kernels import njit
from sonify.sound.audible_modes import RingDown
from sonify.sound.fluid_loaded_modes import (
    FluidLoadedModes,
    GapTunedOscillators,
    fluid_loaded_modes,
    raised_disk_pressure_ratios,
)
from sonify.sound.modal_forcing import listener_azimuth, turning_acceleration
from sonify.sound.radiation import Listener
from sonify.sound.radiators import KnotTimes, NearRim, RigidFace
from sonify.sound.sources.protocol import (
    Advance,
    ElasticDisk,
    Note,
    RigidDisk,
    SoundSource,
    SourcePair,
)
from sonify.sound.sources.rattling import RattlingModes

if TYPE_CHECKING:
    from dynamics.motion import Motion
    from modal.modes import Modes
    from sonify.scene import Scene
    from sonify.sound.force import ContactForce

_RIM_FLOW = np.loadtxt(Path(__file__).with_name("rim_flow.csv"), delimiter=",")
RIM_FLOW_COMPRESSIBILITY = _RIM_FLOW[:, 0]
"""Compressibility numbers Lam at which the rim flow of the rotating wedge is
tabulated."""
RIM_FLOW_SHARES = (_RIM_FLOW[:, 1::2] + 1j * _RIM_FLOW[:, 2::2]).T
"""First and second harmonics g1, g2 of the rim flow, divided by the dipole of the face.

They were computed by benchmarks/methods/rotating_film.py; above the last Lam both
decrease as 1/sqrt(Lam)."""
HEAVE_RELAXATION_TIMES = np.array(
    [0.00034, 0.00358, 0.01685, 0.05083, 0.15874, 0.48427]
)
RIM_FLOW_RELAXATION_WEIGHTS = np.array(
    [0.04619, 0.06678, 0.1103, 0.14719, 0.32177, 0.30777]
)
HEAVE_RELAXATION_INERTIAS = np.array([0.0, 0.0, 0.0, 2.64222, 1.14717, 0.33167])
HEAVE_RELAXATION_RADIATION = np.array([0.0, 0.0, 0.0, 1.62412, 0.28655, 0.06386])
HEAVE_END_CORRECTION = 1.35743
"""Terms of the share of the displaced air that leaves at the rim during heave.

With sigma = 12 mu w R^2/(p g^2) and M = w R sqrt(rho/p), g0 is the sum of weight/(1 + (i
sigma + i M radiation - M^2 inertia (1 + end correction g/R)) time). The film alone, for
M = 0, is approximated within 0.003. With the air outside, |1 - g0| agrees with
`film_radiation.radiated_multipoles` within 4 dB (1.3 dB rms) up to 3.8 kHz for the
published disk and mean gaps from 4 um to 9 mm."""
RELAXATION_LOG_GAP_STEP = 0.01
"""Step of the log gap in the table of transitions; the error of linear interpolation is
RELAXATION_LOG_GAP_STEP^2/2."""


MIN_SLOPE = 1e-9
"""Smallest inclination [rad] for which a precession rate is computed."""
DIPOLE_PER_HEAVE = 4 * 0.4288
"""Dipole of the rim flow caused by heave, in units of that of the tilted face; int q
cos(theta) ds / int q ds is 0.4288 for the open wedge."""


def disk_sources(
    scene: "Scene",
    motion: "Motion",
    modes: "Modes",
    chosen: np.ndarray,
    listener: Listener,
    face: RigidFace,
) -> tuple[RigidDisk, ElasticDisk]:
    """Return the sources of the rigid disk and of its modes, above the film if it is
    active."""
    elastic: type[ElasticDisk]
    if motion.rim_modes is not None:
        rigid = RigidDisk(scene, face, listener.azimuth, comes_to_rest(motion))
        elastic = RattlingModes
    elif not radiates_above_film(motion):
        rigid = RigidDisk(scene, face, listener.azimuth, comes_to_rest(motion))
        elastic = ElasticDisk
    else:
        over_film = NearDiskOverFilm if listener.is_in_near_field else RigidDiskOverFilm
        rigid = over_film(scene, motion, face, listener)
        elastic = ElasticDiskOverFilm
    return rigid, elastic(scene, motion, modes, chosen, listener, face.reach)


def radiates_above_film(motion: "Motion") -> bool:
    """Return whether the disk radiates above a film of air; the sound of a ring is modelled
    as if there were none."""
    return motion.plan.film is not None and motion.disk.shape == "solid"


def comes_to_rest(motion: "Motion") -> bool:
    """Return whether a motion was solved until nothing moves, so that it needs no fade."""
    last = motion.landing or motion
    return last.rolling_outcome is Outcome.AT_REST


def rim_flow_shares(Lam: np.ndarray) -> np.ndarray:
    """Return the harmonics g1 and g2 (2, k) of the rim flow, divided by the tilt
    dipole, at Lam (k,).

    They apply to forward precession; for the opposite sense use the complex conjugate.
    """
    tabulated = RIM_FLOW_COMPRESSIBILITY
    shares = np.empty((len(RIM_FLOW_SHARES), len(Lam)), complex)
    inside = np.log(np.clip(Lam, tabulated[0], tabulated[-1]))
    decline = np.sqrt(np.maximum(Lam / tabulated[-1], 1))
    for share, g in zip(shares, RIM_FLOW_SHARES, strict=True):
        share.real = np.interp(inside, np.log(tabulated), g.real) / decline
        share.imag = np.interp(inside, np.log(tabulated), g.imag) / decline
    return shares


class RigidDiskOverFilm(RigidDisk):
    """Heave and tilt of the rigid disk, radiated above the film.

    If the film is part of the motion, its pressure also accelerates the disk.
    """

    def __init__(
        self, scene: "Scene", motion: "Motion", face: RigidFace, listener: Listener
    ) -> None:
        super().__init__(scene, face, listener.azimuth, comes_to_rest(motion))
        self._listener = listener
        self._air = scene.air
        self._a0, self._b0, self._a1, self._b1 = raised_disk_pressure_ratios(
            scene.disk.thickness, scene.disk.radius
        )
        self._h = 1 / scene.audio.sample_rate
        gaps = np.log(mean_gaps(motion))
        self._lowest = gaps.min()
        tabulated = np.arange(
            self._lowest,
            gaps.max() + 2 * RELAXATION_LOG_GAP_STEP,
            RELAXATION_LOG_GAP_STEP,
        )
        self._transitions = self._heave_transitions(tabulated)

    @property
    def channel_ends(self) -> np.ndarray:
        """Rest values and fade times: accelerations fade to zero, the gap and the
        cosines hold their last values."""
        fades = [0.0, self._fade]
        stays = [np.nan, 0.0]
        second = [] if self._second_ear is None else [fades, fades, stays]
        return np.array([fades, fades, fades, stays, stays, *second])

    def input_channels(
        self, force: np.ndarray, state: np.ndarray, film: np.ndarray
    ) -> np.ndarray:
        """Return the input channels, (k, 5 or 8).

        The columns are heave, tilt and second harmonic of the rim flow as radiated
        towards the listener [m/s^2], the logarithm of the mean gap [m], and the cosine
        of the azimuth. A second ear adds its own tilt, second harmonic and cosine."""
        heave, tilt, rate, first, second = self._accelerations(force, state, film)
        tilt = (self._a1 - self._b1 * first) * tilt
        second = (
            self._b1 * second * self._second_harmonic_acceleration(state[:, 1], rate)
        )

        def towards(azimuth: np.ndarray) -> list[np.ndarray]:
            wave = _conjugate_phasor(azimuth)
            return [(tilt * wave).real, (second * wave**2).real, wave.real]

        azimuth = self._azimuth + listener_azimuth(state)
        *flows, cosine = towards(azimuth)
        columns = [heave, *flows, np.log(film[:, 0]), cosine]
        if self._second_ear is not None:
            columns += towards(azimuth + self._second_ear)
        return np.column_stack(columns)

    def _accelerations(
        self, force: np.ndarray, state: np.ndarray, film: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Return heave (k,) and complex tilt of the rim (k,) [m/s^2], precession rate
        [rad/s], and the shares of the first and second harmonic of the rim flow."""
        disk = self._disk
        gap, lift, *_ = film.T
        turn = turning_acceleration(force, state[:, 1], film, disk)
        heave = (force[:, 2] + lift - disk.weight) / disk.mass
        tilted = np.maximum(np.sin(state[:, 1]), MIN_SLOPE)
        rate = state[:, 7] / tilted
        shares = rim_flow_shares(rotation_number(rate, gap / disk.radius, self._air))
        shares.imag *= np.sign(rate)
        return heave, disk.radius * (1j * turn[:, 0] - turn[:, 1]), rate, *shares

    def _second_harmonic_acceleration(
        self, inclination: np.ndarray, rate: np.ndarray
    ) -> np.ndarray:
        """Return the acceleration [m/s^2] of a piston equivalent to the second harmonic
        of the rim flow.

        The result applies to g2 = 1. The rim flow rotates at `rate` [rad/s] and
        radiates as a quadrupole in the long-wave limit."""
        radius = self._disk.radius
        distance = self._listener.distance
        x = rate * distance / self._air.sound_speed
        near_field = 1 + 2j * x - 4 / 3 * x**2
        near = (
            3
            / 8
            * (np.cos(self._listener.elevation) * radius / distance) ** 2
            * near_field
        )
        return near * radius * np.sin(inclination) * rate**2

    def make_block_renderer(self, first: np.ndarray, note: Note) -> Advance:
        """Return a function that computes the stems (k, s) [Pa] of successive blocks.

        Before the first block the channels have the values `first` (c,)."""
        still = first[:2] * [self._a0 - self._b0, 1.0]
        relaxed = resting_heave(first[0])
        radiate_face = self._face.make_block_radiator(still)
        radiate_rim = self._face.make_block_radiator(np.array([first[2], 0.0]))
        radiate_second_ear = self._face.make_block_radiator(
            np.array([still[0] + first[-2], first[-3]])
        )

        def advance(force: "ContactForce") -> np.ndarray:
            heave, tilt, second, gap, cosine, *second_ear = force.samples.T
            knots = force.knots
            jump = force.jump[:, :2].copy()
            out, at_once = self._relax(heave, gap, knots, relaxed)
            upwards = self._a0 * heave - self._b0 * out
            dipole = DIPOLE_PER_HEAVE * self._b1 * out
            jump[:, 0] *= self._a0 - self._b0 * at_once
            pressure = radiate_face(np.column_stack([upwards, tilt]), knots, jump)
            pressure += radiate_rim(
                np.column_stack([second, dipole * cosine]), knots, 0 * jump
            )[:, ::-1]
            if self._second_ear is None:
                return pressure
            tilt, second, cosine = second_ear
            jump[:, 1] = force.jump[:, -3]
            other = radiate_second_ear(
                np.column_stack([upwards + second, tilt + dipole * cosine]), knots, jump
            )
            return np.column_stack([pressure, other.sum(axis=1)])

        return advance

    def _relax(
        self, heave: np.ndarray, gap: np.ndarray, knots: KnotTimes, state: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the part (k + 1,) of the heave (k + 1,) that leaves at the rim, and
        the share (j,) of each jump that leaves within one sample."""
        out = relaxed_heave(heave, gap, self._lowest, self._transitions, state)
        left = self._heave_transitions(gap[knots[0]])[:, :, 0, 0]
        return out, (1 - left) @ RIM_FLOW_RELAXATION_WEIGHTS

    def _heave_transitions(self, gap: np.ndarray) -> np.ndarray:
        """Return the transitions (k, r, 2, 2) over one sample at log gaps (k,).

        A term obeys b y'' + a y' + y = x. The transition maps y - x and h y' from the
        start of a sample, in which x is constant, to its end."""
        air = self._air
        radius = self._disk.radius
        time = radius**2 / air.pressure * HEAVE_RELAXATION_TIMES / self._h
        impedance = np.sqrt(air.density * air.pressure) / radius
        mean_gap = np.exp(gap)[:, None]
        outside = 1 + HEAVE_END_CORRECTION * mean_gap / radius
        a = time * (
            12 * air.viscosity / mean_gap**2 + impedance * HEAVE_RELAXATION_RADIATION
        )
        b = time * air.density / self._h * HEAVE_RELAXATION_INERTIAS * outside
        a = np.maximum(a, 1e-3)  # a lag of a thousandth of a sample is none
        heavy = b > 1e-4 * np.maximum(a, 1) ** 2  # otherwise the inertia has no effect
        matrices = np.zeros((*a.shape, 2, 2))
        matrices[..., 0, 0] = np.where(heavy, 0.0, -1 / a)
        matrices[..., 0, 1] = heavy
        matrices[heavy, 1, 0] = -1 / b[heavy]
        matrices[heavy, 1, 1] = -a[heavy] / b[heavy]
        return expm(matrices)


class NearDiskOverFilm(RigidDiskOverFilm):
    """Heave and tilt above the film for a listener near the disk.

    Face and rim radiate from their actual positions.
    """

    @property
    def channel_ends(self) -> np.ndarray:
        """Rest values and fade times, as those of a distant listener."""
        return np.array([[0.0, self._fade]] * 4 + [[np.nan, 0.0]] * 2)

    def with_second_ear(self, other: SoundSource, turn: float) -> SoundSource:
        """Return both sources; each ear has its own near field."""
        return SourcePair(self, other)

    def input_channels(
        self, force: np.ndarray, state: np.ndarray, film: np.ndarray
    ) -> np.ndarray:
        """Return the input channels (k, 6).

        The columns are heave, tilt of the face, first and second harmonic of the rim
        flow towards the listener [m/s^2], the logarithm of the mean gap [m], and the
        cosine of the azimuth."""
        heave, tilt, rate, first, second = self._accelerations(force, state, film)
        wave = _conjugate_phasor(self._azimuth + listener_azimuth(state))
        flow = self._disk.radius * np.sin(state[:, 1]) * rate**2
        return np.column_stack(
            [
                heave,
                (tilt * wave).real,
                (first * tilt * wave).real,
                (second * flow * wave**2).real,
                np.log(film[:, 0]),
                wave.real,
            ]
        )

    def make_block_renderer(self, first: np.ndarray, note: Note) -> Advance:
        """Return a function that computes the stems (k, s) [Pa] of successive blocks.

        Before the first block the channels have the values `first` (c,)."""
        relaxed = resting_heave(first[0])
        radiate_face = self._face.make_block_radiator(first[:2])
        rim = NearRim(self._disk, self._listener, self._h)
        radiate_rim = rim.make_block_radiator(
            first[[0, 0, 2, 3]] * [-1.0, DIPOLE_PER_HEAVE * first[5], -1.0, 1.0]
        )

        def advance(force: "ContactForce") -> np.ndarray:
            heave, tilt, outflow, second, gap, cosine = force.samples.T
            knots = force.knots
            jump = force.jump[:, [0, 0, 2, 3]] * [-1.0, 0.0, -1.0, 0.0]
            out, at_once = self._relax(heave, gap, knots, relaxed)
            jump[:, 0] *= at_once
            dipole = DIPOLE_PER_HEAVE * out * cosine
            flows = np.column_stack([-out, dipole, -outflow, second])
            from_face = radiate_face(
                np.column_stack([heave, tilt]), knots, force.jump[:, :2]
            )
            from_rim = radiate_rim(flows, knots, jump)
            return from_face + from_rim[:, [0, 2]] + from_rim[:, [1, 3]]

        return advance


class ElasticDiskOverFilm(ElasticDisk):
    """Elastic modes with damping, detuning and radiation that depend on the gap of the
    film."""

    def __init__(
        self,
        scene: "Scene",
        motion: "Motion",
        modes: "Modes",
        chosen: np.ndarray,
        listener: Listener,
        latency: int,
    ) -> None:
        super().__init__(scene, motion, modes, chosen, listener, latency)
        azimuth_ends, mode_ends = np.split(self.channel_ends, [2])
        self.channel_ends = np.vstack([azimuth_ends, [[np.nan, 0.0]], mode_ends])
        gaps = mean_gaps(motion)
        self._smallest_gap = gaps.min()
        self._final_gap = gaps[-1]

    @cached_property
    def ringing(self) -> RingDown:
        """Frequencies and decay rates of the modes after the motion, at the final mean
        gap."""
        gap = np.log(self._final_gap)
        frequency, decay_rate = self._loaded_modes.nearest_tuning(gap)
        return RingDown(
            frequency=frequency,
            decay_rate=decay_rate,
            decay_rate_without_film=self._modes.decay_rate,
            gap=float(np.exp(gap)),
        )

    @cached_property
    def _loaded_modes(self) -> FluidLoadedModes:
        return fluid_loaded_modes(self._modes, self._scene, self._smallest_gap)

    def input_channels(
        self, force: np.ndarray, state: np.ndarray, film: np.ndarray
    ) -> np.ndarray:
        """Return (k, 3 + m): cosine and sine of the azimuth, logarithm of the mean gap
        [m], modal forces."""
        own = super().input_channels(force, state, film)
        return np.hstack([own[:, :2], np.log(film[:, :1]), own[:, 2:]])

    def _response(self, first: np.ndarray) -> Advance:
        oscillators = GapTunedOscillators(
            self._loaded_modes, self._scene.audio.sample_rate, first[3:], first[2]
        )
        return lambda force: oscillators.advance_at_gap(
            force.channels(slice(3, None)), _log_gap_channel(force)
        )

    def _radiating(self, ringing: np.ndarray, force: "ContactForce") -> np.ndarray:
        return self._loaded_modes.apply_gain(ringing, _log_gap_channel(force)[:-1])


def _log_gap_channel(force: "ContactForce") -> np.ndarray:
    """Return the logarithm of the mean gap (k + 1,) from the channels of
    ElasticDiskOverFilm."""
    return force.channels(slice(2, 3)).samples[:, 0]


def _conjugate_phasor(angle: np.ndarray) -> np.ndarray:
    """Return exp(-i angle) (k,), twice as fast as the complex exponential."""
    wave = np.empty(len(angle), complex)
    wave.real = np.cos(angle)
    wave.imag = -np.sin(angle)
    return wave


def mean_gaps(motion: "Motion") -> np.ndarray:
    """Return the mean gap (n,) [m] under the disk at the breakpoints of a motion."""
    return motion.film_loads(motion.t, motion.state)[:, 0]


def resting_heave(x: float) -> np.ndarray:
    """Return the state (r, 2) of the terms after a constant value x."""
    state = np.zeros((len(RIM_FLOW_RELAXATION_WEIGHTS), 2))
    state[:, 0] = x
    return state


@njit(cache=True)
def relaxed_heave(
    x: np.ndarray,
    gap: np.ndarray,
    lowest: float,
    transitions: np.ndarray,
    state: np.ndarray,
) -> np.ndarray:
    """Return the part (k + 1,) of samples x (k + 1,) that leaves at the rim.

    The last value belongs to the next block and is 0. The `state` (r, 2) of the terms,
    y and h y', is updated in place; the result is the sum of y times
    RIM_FLOW_RELAXATION_WEIGHTS. The `transitions` (g, r, 2, 2) are tabulated at log gaps
    that begin at `lowest`, in steps of RELAXATION_LOG_GAP_STEP, and interpolated
    linearly at `gap` (k + 1,)."""
    out = np.zeros(len(x))
    for n in range(len(x) - 1):
        where = min(
            max((gap[n] - lowest) / RELAXATION_LOG_GAP_STEP, 0.0),
            len(transitions) - 1.001,
        )
        low = int(where)
        part = where - low
        for r in range(len(state)):
            distance = state[r, 0] - x[n]
            change = state[r, 1]
            for k in range(2):
                to_distance = transitions[low, r, k, 0] + part * (
                    transitions[low + 1, r, k, 0] - transitions[low, r, k, 0]
                )
                to_change = transitions[low, r, k, 1] + part * (
                    transitions[low + 1, r, k, 1] - transitions[low, r, k, 1]
                )
                state[r, k] = to_distance * distance + to_change * change
            state[r, 0] += x[n]
            out[n] += RIM_FLOW_RELAXATION_WEIGHTS[r] * state[r, 0]
    return out
