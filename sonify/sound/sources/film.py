"""FILM -> SOUND: the disk radiates through the air film under it; the film damps and detunes its
modes.

Where the film is open, the air that the face displaces leaves at the rim and cancels part of the
sound of the face. If p is the pressure of a flush piston in a baffle, the disk radiates (a - g b)
p: g is the share of the displaced air that leaves at the rim, and a and b account for the height of
the disk. All terms are those of the wedge (dynamics/film/reynolds.py) at the inclination of each
instant."""

from functools import cached_property

import numpy as np
from numba import njit

from dynamics.equations import DiskConstants
from dynamics.film.activation import decide_film
from dynamics.film.wedge import compressibility
from dynamics.observables import precession_rate
from dynamics.rattling.rattling_motion import RattlingMotion
from dynamics.regime import ARRAY_FORMULAS
from sonify.sound.audible_modes import RingDown
from sonify.sound.fluid_loaded_modes import GapTunedOscillators, fluid_loaded_modes, height_factors
from sonify.sound.modal_forcing import in_patch_frame, inertia, listener_azimuth, rigid_acceleration
from sonify.sound.radiation import Listener
from sonify.sound.radiators import RigidFace
from sonify.sound.response import VibrationPart
from sonify.sound.sources.protocol import FADE_OUT, ElasticDisk, RigidDisk, energy_peaks
from sonify.sound.sources.rattling import RattlingModes

_RIM_FLOW = np.array(
    [
        (0.01, 1.0, 0.2890),
        (0.1, 0.9996 + 0.0011j, 0.2894 + 0.0008j),
        (0.2, 0.9986 + 0.0018j, 0.2898 + 0.0018j),
        (0.3, 0.9971 + 0.0019j, 0.2904 + 0.0028j),
        (0.5, 0.9931 + 0.0013j, 0.2921 + 0.0047j),
        (1, 0.9796 - 0.0040j, 0.2979 + 0.0081j),
        (2, 0.9469 - 0.0193j, 0.3102 + 0.0079j),
        (3, 0.9135 - 0.0350j, 0.3197 + 0.0020j),
        (5, 0.8507 - 0.0612j, 0.3292 - 0.0161j),
        (10, 0.7242 - 0.1021j, 0.3213 - 0.0607j),
        (20, 0.5604 - 0.1305j, 0.2713 - 0.1047j),
        (30, 0.4634 - 0.1336j, 0.2301 - 0.1168j),
        (50, 0.3573 - 0.1257j, 0.1808 - 0.1157j),
        (100, 0.2490 - 0.1059j, 0.1286 - 0.1007j),
        (200, 0.1730 - 0.0841j, 0.0908 - 0.0812j),
        (300, 0.1400 - 0.0721j, 0.0742 - 0.0698j),
    ]
).T
RIM_FLOW_COMPRESSIBILITY = _RIM_FLOW[0].real
"""Compressibility numbers Lam at which the rim flow of the turning wedge is tabulated."""
RIM_FLOW_SHARES = _RIM_FLOW[1:]
"""First and second harmonic g1, g2 of the rim flow over the dipole of the face, by
`reynolds.compressible_wedge_response`.

Above the last Lam both decrease as 1/sqrt(Lam)."""
HEAVE_RELAXATION_TIMES = 10.0 ** np.arange(-4, 0.1, 0.5)
"""Relaxation times of the heave, over the time scale 12 mu R^2/(p g^2) of the film."""
HEAVE_RELAXATION_WEIGHTS = np.array(
    [0.02328, 0.0028, 0.02786, 0.04064, 0.07065, 0.13892, 0.22665, 0.40624, 0.06297]
)
"""Weights of the relaxation times.

With sigma = 12 mu w R^2/(p g^2), the sum of weight/(1 + i sigma time) equals g0 of the wedge within
0.005."""
LOG_GAP_STEP = 0.01
"""Step of the log gap in the relaxation table; linear interpolation errs by LOG_GAP_STEP^2/2."""


def disk_sources(
    scene, motion, modes, chosen, listener: Listener, face: RigidFace
) -> tuple[RigidDisk, ElasticDisk]:
    """Return the sources of the rigid disk and of its modes; both radiate through an active
    film."""
    if isinstance(motion, RattlingMotion):
        rigid = RigidDisk(scene, face, listener.azimuth)
        return rigid, RattlingModes(scene, motion, modes, chosen, listener, face.reach)
    if decide_film(scene).film is None:
        rigid = RigidDisk(scene, face, listener.azimuth)
        return rigid, ElasticDisk(scene, motion, modes, chosen, listener, face.reach)
    rigid = RigidDiskOverFilm(scene, motion, face, listener)
    return rigid, ElasticDiskOverFilm(scene, motion, modes, chosen, listener, face.reach)


def rim_flow_shares(Lam) -> np.ndarray:
    """Return g1 and g2 (2, k): harmonics of the rim flow over the dipole of the tilt, at numbers
    Lam (k,).

    The film turns forward; for the other sense take the complex conjugate.
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
    """Heave and tilt of the rigid disk, radiated through the film.

    Where the film acts in the motion, its pressure also accelerates the disk.
    """

    def __init__(
        self, scene, motion, face: RigidFace, listener: Listener, second_ear: float | None = None
    ):
        super().__init__(scene, face, listener.azimuth, second_ear)
        self._motion = motion
        self._listener = listener
        self._air = scene.air
        self._film = motion.film
        self._a0, self._b0, self._a1, self._b1 = height_factors(
            scene.disk.thickness, scene.disk.radius
        )
        self._h = 1 / scene.audio.sample_rate
        gaps = log_mean_gap(motion.state, scene.disk)
        self._lowest = gaps.min()
        tabulated = np.arange(self._lowest, gaps.max() + 2 * LOG_GAP_STEP, LOG_GAP_STEP)
        self._fractions = self._relaxed_fractions(tabulated)

    def with_second_ear(self, other, turn):
        """Return the rigid disk with the pressure at a second ear, `turn` [rad] further round, as
        one more column."""
        return RigidDiskOverFilm(self._scene, self._motion, self._face, self._listener, turn)

    @property
    def channel_ends(self):
        """Accelerations fade to zero; the gap and the cosines keep their last values."""
        fades = [0.0, FADE_OUT]
        stays = [np.nan, 0.0]
        second = [] if self._second_ear is None else [fades, fades, stays]
        return np.array([fades, fades, fades, stays, stays, *second])

    def channels(self, force, state):
        """Return the input channels, (k, 5 or 8).

        Columns: heave, tilt and second harmonic of the rim flow as radiated towards the listener
        [m/s^2]; logarithm of the mean gap [m]; cosine of the azimuth. A second ear adds its tilt,
        second harmonic and cosine."""
        disk = self._disk
        lift, across, along = self._film_load(state)
        turn = in_patch_frame(force, state[:, 1]) @ rigid_acceleration(np.eye(3), disk)[:, 3:]
        turn[:, :2] -= np.column_stack([along, across]) / inertia(disk)[3:5]
        heave = (force[:, 2] + lift - disk.weight) / disk.mass
        rate = precession_rate(state)
        shares = rim_flow_shares(compressibility(state[:, 1], rate, self._air))
        shares.imag *= np.sign(rate)
        first, second = shares
        tilt = disk.radius * (self._a1 - self._b1 * first) * (1j * turn[:, 0] - turn[:, 1])
        second = self._b1 * second * self._second_harmonic(state[:, 1], rate)
        azimuth = self._azimuth + listener_azimuth(state, turning_with_body=False)
        wave = _turned_back(azimuth)
        columns = [
            heave,
            (tilt * wave).real,
            (second * wave**2).real,
            log_mean_gap(state, disk),
            wave.real,
        ]
        if self._second_ear is not None:
            wave = _turned_back(azimuth + self._second_ear)
            columns += [(tilt * wave).real, (second * wave**2).real, wave.real]
        return np.column_stack(columns)

    def _second_harmonic(self, inclination, rate):
        """Return the acceleration [m/s^2] of a piston that radiates as the second harmonic, for a
        share of 1.

        The rim flow turns at `rate` [rad/s] and radiates as a quadrupole, in the limit of long
        waves."""
        radius = self._disk.radius
        distance = self._listener.distance
        x = rate * distance / self._air.sound_speed
        near_field = 1 + 2j * x - 4 / 3 * x**2
        near = 3 / 8 * (np.cos(self._listener.elevation) * radius / distance) ** 2 * near_field
        return near * radius * np.sin(inclination) * rate**2

    def start_rendering(self, first, note):
        """Return the function that radiates the blocks which follow channels `first`."""
        dipole_per_heave = 4 * 0.4288  # int q cos(theta) ds / int q ds = 0.4288 for the open wedge
        still = first[:2] * [self._a0 - self._b0, 1.0]
        relaxed = np.full(len(HEAVE_RELAXATION_WEIGHTS), first[0])
        radiate_face = self._face.start_radiating(still)
        radiate_rim = self._face.start_radiating([first[2], 0.0])
        radiate_second_ear = self._face.start_radiating([still[0] + first[-2], first[-3]])

        def advance(force):
            heave, tilt, second, gap, cosine, *second_ear = force.samples.T
            knots = force.knots
            jump = force.jump[:, :2].copy()
            out = relax_heave(heave, gap, self._lowest, self._fractions, relaxed)
            at_once = self._relaxed_fractions(gap[knots[0]]) @ HEAVE_RELAXATION_WEIGHTS
            upwards = self._a0 * heave - self._b0 * out
            dipole = dipole_per_heave * self._b1 * out
            jump[:, 0] *= self._a0 - self._b0 * at_once
            pressure = radiate_face(np.column_stack([upwards, tilt]), knots, jump)
            pressure += radiate_rim(np.column_stack([second, dipole * cosine]), knots, 0 * jump)[
                :, ::-1
            ]
            if self._second_ear is None:
                return pressure
            tilt, second, cosine = second_ear
            jump[:, 1] = force.jump[:, -3]
            other = radiate_second_ear(
                np.column_stack([upwards + second, tilt + dipole * cosine]), knots, jump
            )
            return np.column_stack([pressure, other.sum(axis=1)])

        return advance

    def _relaxed_fractions(self, gap):
        """Return the fraction (k, r) by which each relaxation proceeds in a sample, at logarithms
        of gaps (k,)."""
        film_time = 12 * self._air.viscosity * self._disk.radius**2
        per_sample = self._h * self._air.pressure * np.exp(2 * gap) / film_time
        return -np.expm1(-per_sample[:, None] / HEAVE_RELAXATION_TIMES)

    def _film_load(self, state):
        """Return the lift [N] of the film and its moments [N m] about e_1 and e_3, (3, k), at
        states (k, 11)."""
        if self._film is None:
            return np.zeros((3, len(state)))
        disk = self._disk
        chi = disk.time_unit
        law = DiskConstants(disk.aspect, disk.gyration, *[0.0] * 5)
        loads = self._film(state[:, 1], state[:, 5:8].T * chi, None, law, ARRAY_FORMULAS)
        force = disk.mass * disk.radius / chi**2
        return np.array([loads.G3, disk.radius * loads.M1, disk.radius * loads.M3]) * force


class ElasticDiskOverFilm(ElasticDisk):
    """The elastic modes; the film damps, detunes and muffles them according to its gap."""

    def __init__(
        self,
        scene,
        motion,
        modes,
        chosen,
        listener: Listener,
        latency: int,
        second_ear: float | None = None,
    ):
        super().__init__(scene, motion, modes, chosen, listener, latency, second_ear)
        azimuth_ends, mode_ends = np.split(self.channel_ends, [2])
        self.channel_ends = np.vstack([azimuth_ends, [[np.nan, 0.0]], mode_ends])
        self._smallest_gap = scene.disk.radius * np.sin(motion.state[:, 1].min())

    @cached_property
    def ringing(self) -> RingDown:
        """Frequencies and decay rates of the modes after the motion, at the final mean gap."""
        gap = log_mean_gap(self._motion.state[-1:], self._scene.disk)[0]
        frequency, decay_rate = self._loaded_modes.nearest_tuning(gap)
        return RingDown(
            frequency=frequency,
            decay_rate=decay_rate,
            without_film=self._modes.decay_rate,
            gap=float(np.exp(gap)),
        )

    @cached_property
    def _loaded_modes(self):
        return fluid_loaded_modes(self._modes, self._scene, self._smallest_gap)

    def channels(self, force, state):
        """Return cosine and sine of the azimuth, logarithm of the mean gap [m], and modal forces,
        (k, 3 + m)."""
        own = super().channels(force, state)
        return np.hstack([own[:, :2], log_mean_gap(state, self._scene.disk)[:, None], own[:, 2:]])

    def start_rendering(self, first, note):
        """Return the function that radiates the blocks after `first` (3 + m,); it notes the energy
        of the modes."""
        rate = self._scene.audio.sample_rate
        radiate = self._face.start_radiating(first[:2], self._second_ear)
        solved = self._response(first[3:]) if isinstance(self._motion, VibrationPart) else None
        oscillators = GapTunedOscillators(self._loaded_modes, rate, first[3:], first[2])

        def advance(force):
            geometry = force.channels(slice(3)).samples
            modal_force = force.channels(slice(3, None))
            gap = geometry[:, 2]
            ringing = (
                solved.advance(modal_force) if solved else oscillators.advance(modal_force, gap)
            )
            note(*energy_peaks(force.t, ringing.sum(axis=0), self._modes, rate))
            return radiate(self._loaded_modes.apply_gain(ringing, gap[:-1]), geometry[:-1, :2])

        return advance


def _turned_back(angle):
    """Return exp(-i angle) (k,), in half the time that a complex exponential takes."""
    wave = np.empty(len(angle), complex)
    wave.real = np.cos(angle)
    wave.imag = -np.sin(angle)
    return wave


def log_mean_gap(state, disk):
    """Return the logarithm of the mean gap [m] under the disk at states (k, 11)."""
    return np.log(disk.radius * np.sin(state[:, 1]))


@njit(cache=True)
def relax_heave(x, gap, lowest, fractions, state):
    """Return the relaxed part of samples x (k + 1,); the last sample belongs to the next block, and
    is left at zero.

    Each component of `state` (r,) approaches x by a fraction per sample, and is updated in place.
    The result is the sum of the components times HEAVE_RELAXATION_WEIGHTS. `fractions` (g, r) are
    tabulated at logarithms of the gap, from `lowest` in steps of LOG_GAP_STEP, and interpolated
    linearly at `gap` (k + 1,)."""
    out = np.zeros(len(x))
    for n in range(len(x) - 1):
        where = min(max((gap[n] - lowest) / LOG_GAP_STEP, 0.0), len(fractions) - 1.001)
        low = int(where)
        part = where - low
        for r in range(len(state)):
            fraction = fractions[low, r] + part * (fractions[low + 1, r] - fractions[low, r])
            state[r] += fraction * (x[n] - state[r])
            out[n] += HEAVE_RELAXATION_WEIGHTS[r] * state[r]
    return out
