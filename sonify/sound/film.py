"""FILM -> SOUND: the disk radiates through the film of air under it, and the film damps and detunes its modes.

Where the film is open, the air pushed out at the rim cancels what the face pushes: of the pressure p of a flush piston
in a baffle, a - g b is heard, where g is the share of the displaced air that leaves at the rim, and a, b hold the
height of the disk. All of it is that of the wedge (dynamics/film/reynolds.py) at the inclination of the instant.
"""

from functools import cached_property
from itertools import chain

import numpy as np
from numba import njit

from dynamics.equations import Law
from dynamics.film.acting import film_of
from dynamics.film.law import compressibility, film_in
from dynamics.rates import precession_rate
from dynamics.regime import ARRAY
from sonify.sound.drive import in_patch_frame, inertia, listener_azimuth, rigid_acceleration
from sonify.sound.film_modes import Tuned, filmed, heights
from sonify.sound.radiation import Listener
from sonify.sound.response import Vibrating
from sonify.sound.sources import FADE_OUT, ElasticDisk, RigidDisk, noted_energy

LAM, *SHARE = np.array(
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
LAM, SHARE = LAM.real, np.array(SHARE)
"""Lam, and of the flow out of the rim of the turning, compressible wedge one wave round it, g1, and two, g2, over the
dipole of the face, by `reynolds.compressible`; beyond they fall as the root of Lam."""
RELAXATION = 10.0 ** np.arange(-4, 0.1, 0.5)
WEIGHT = np.array([0.02328, 0.0028, 0.02786, 0.04064, 0.07065, 0.13892, 0.22665, 0.40624, 0.06297])
"""g0 of the wedge, within 0.005: sum of WEIGHT/(1 + i sigma RELAXATION), sigma = 12 mu w R^2/(p g^2)."""
FINE = 0.01
"""Logarithms of the gap between which the speed of this relaxation is taken linear: within FINE^2/2 of itself."""
ASIDE = 0.4288
"""Of a heave the open wedge lets out so much more towards its wide side: int q cos(theta) ds over int q ds."""


def with_film(
    scene, motion, rigid: RigidDisk, elastic: ElasticDisk, listener: Listener
) -> tuple[RigidDisk, ElasticDisk]:
    """Return what radiates the disk, the rigid one and its modes, through the film where it acts in the scene."""
    if film_of(scene).film is None:
        return rigid, elastic
    return FilmedRigid(scene, motion, rigid, listener), FilmedElastic(scene, motion, elastic)


def shares_of_tilt(Lam) -> np.ndarray:
    """Return g1 and g2 (2, k), the first and second harmonic of what leaves at the rim over the dipole of the tilt, of
    a film that turns forward; numbers Lam (k,)."""
    shares = np.empty((len(SHARE), len(Lam)), complex)
    inside, beyond = np.log(np.clip(Lam, LAM[0], LAM[-1])), np.sqrt(np.maximum(Lam / LAM[-1], 1))
    for share, g in zip(shares, SHARE, strict=True):
        share.real, share.imag = (np.interp(inside, np.log(LAM), part) / beyond for part in (g.real, g.imag))
    return shares


class FilmedRigid(RigidDisk):
    """The heave and the tilt of the rigid disk, through the film: it also presses on the disk, where it does so in the
    motion."""

    def __init__(self, scene, motion, open_disk: RigidDisk, listener: Listener):
        self.__dict__ |= vars(open_disk)
        self._listener = listener
        self._air, self._film = scene.air, film_in(getattr(motion, "loads", None))
        self._a0, self._b0, self._a1, self._b1 = heights(scene.disk.thickness, scene.disk.radius)
        self._h = 1 / scene.audio.sample_rate
        gaps = log_gap(motion.state, scene.disk)
        self._lowest = gaps.min()
        self._shares = self._share(np.arange(self._lowest, gaps.max() + 2 * FINE, FINE))

    @property
    def ends(self):
        """What sounds fades, and gap and cosines stay."""
        sounds, stays = [0.0, FADE_OUT], [np.nan, 0.0]
        return np.array([sounds] * 3 + [stays] * 2 + ([sounds] * 2 + [stays]) * (self.beside is not None))

    def channels(self, force, state):
        """Return the heave, what is heard of the tilt and of the second harmonic of the rim [m/s^2], the logarithm of
        the mean gap [m], and the cosine of the azimuth, (k, 5), the second, third and last also for the other ear."""
        disk, (lift, across, along) = self._disk, self._pressed(state)
        turn = in_patch_frame(force, state[:, 1]) @ rigid_acceleration(np.eye(3), disk)[:, 3:]
        turn[:, :2] -= np.column_stack([along, across]) / inertia(disk)[3:5]
        heave = (force[:, 2] + lift - disk.weight) / disk.mass
        rate = precession_rate(state)
        shares = shares_of_tilt(compressibility(state[:, 1], rate, self._air))
        shares.imag *= np.sign(rate)
        first, second = shares
        tilt = disk.radius * (self._a1 - self._b1 * first) * (1j * turn[:, 0] - turn[:, 1])
        second = self._b1 * second * self._twice(state[:, 1], rate)
        azimuth = self._azimuth + listener_azimuth(state, turning_with_body=False)
        waves = [_turned_back(azimuth + ear) for ear in (0.0, self.beside) if ear is not None]
        one, *other = [((tilt * wave).real, (second * wave**2).real, wave.real) for wave in waves]
        return np.column_stack([heave, *one[:2], log_gap(state, disk), one[2], *chain(*other)])

    def _twice(self, inclination, rate):
        """The acceleration [m/s^2] that a piston would need to be heard as two waves of the flow round the rim are,
        which turn at `rate` [rad/s] and of which the share 1 leaves: the quadrupole, for long waves."""
        R, r, elevation = self._disk.radius, self._listener.distance, self._listener.elevation
        x = rate * r / self._air.sound_speed
        near = 3 / 8 * (np.cos(elevation) * R / r) ** 2 * (1 + 2j * x - 4 / 3 * x**2)
        return near * R * np.sin(inclination) * rate**2

    def from_rest(self, first, note):
        """Return what radiates the blocks that follow on channels `first`."""
        still, held = first[:2] * [self._a0 - self._b0, 1.0], np.full(len(WEIGHT), first[0])
        starts = still, [first[2], 0.0], [still[0] + first[-2], first[-3]]
        own, aside, beside = map(self._face.from_rest, starts)

        def advance(force):
            heave, tilt, second, gap, cosine, *other = force.samples.T
            knots, jump = force.knots, force.jump[:, :2].copy()
            out = relaxed(heave, gap, self._lowest, self._shares, held)
            at_once = self._share(gap[knots[0]]) @ WEIGHT
            upwards, dipole = self._a0 * heave - self._b0 * out, 4 * ASIDE * self._b1 * out
            jump[:, 0] *= self._a0 - self._b0 * at_once
            heard = own(np.column_stack([upwards, tilt]), knots, jump)
            heard += aside(np.column_stack([second, dipole * cosine]), knots, 0 * jump)[:, ::-1]
            if self.beside is None:
                return heard
            tilt, second, cosine = other
            jump[:, 1] = force.jump[:, -3]
            there = beside(np.column_stack([upwards + second, tilt + dipole * cosine]), knots, jump)
            return np.column_stack([heard, there.sum(axis=1)])

        return advance

    def _share(self, gap):
        """The share (k, r) of the way that RELAXATION goes in a sample, at logarithms of mean gaps (k,)."""
        out = self._h * self._air.pressure * np.exp(2 * gap) / (12 * self._air.viscosity * self._disk.radius**2)
        return -np.expm1(-out[:, None] / RELAXATION)

    def _pressed(self, state):
        """The lift [N] of the film and its moments along e_1 and e_3 [N m] at states (k, 11)."""
        if self._film is None:
            return np.zeros((3, len(state)))
        disk, chi = self._disk, self._disk.time_unit
        law = Law(disk.aspect, disk.gyration, *[0.0] * 5)
        loads = self._film(state[:, 1], state[:, 5:8].T * chi, None, law, ARRAY)
        force = disk.mass * disk.radius / chi**2
        return np.array([loads.G3, disk.radius * loads.M1, disk.radius * loads.M3]) * force


class FilmedElastic(ElasticDisk):
    """The modes, which the film damps, detunes and muffles as its gap is at each instant."""

    def __init__(self, scene, motion, open_disk: ElasticDisk):
        self.__dict__ |= vars(open_disk)
        self.ends = np.vstack([self.ends[:2], [[np.nan, 0.0]], self.ends[2:]])
        self._least = scene.disk.radius * np.sin(motion.state[:, 1].min())

    @cached_property
    def _filmed(self):
        return filmed(self._modes, self._scene, self._least)

    def channels(self, force, state):
        """Return cosine and sine of the listener's azimuth, the logarithm of the mean gap [m], and the force on each
        mode: (k, 3 + m)."""
        own = super().channels(force, state)
        return np.hstack([own[:, :2], log_gap(state, self._scene.disk)[:, None], own[:, 2:]])

    def from_rest(self, first, note):
        """Return what radiates the blocks that follow on `first` (3 + m,), and notes the energy of the modes."""
        rate, radiated = self._scene.audio.sample_rate, self._face.from_rest(first[:2], self.beside)
        carried = self._response(first[3:]) if isinstance(self._motion, Vibrating) else None
        tuned = Tuned(self._filmed, rate, first[3:], first[2])

        def advance(force):
            seen, driven = force.channels(slice(3)).samples, force.channels(slice(3, None))
            gap = seen[:, 2]
            ringing = carried.advance(driven) if carried else tuned.advance(driven, gap)
            note(*noted_energy(force.t, ringing.sum(axis=0), self._modes, rate))
            return radiated(self._filmed.heard(ringing, gap[:-1]), seen[:-1, :2])

        return advance


def _turned_back(angle):
    """Return exp(-i angle), in half the time that a complex power takes."""
    wave = np.empty(len(angle), complex)
    wave.real, wave.imag = np.cos(angle), -np.sin(angle)
    return wave


def log_gap(state, disk):
    """Return the logarithm of the mean gap [m] at states (k, 11)."""
    return np.log(disk.radius * np.sin(state[:, 1]))


@njit(cache=True)
def relaxed(x, gap, lowest, shares, state):
    """Return what has relaxed of the samples x (k + 1,), of which the last is left to the next block: the sum of WEIGHT
    times `state` (r,), which go by a share of the way to x in a sample. These `shares` (g, r) are known at logarithms
    of the gap (k + 1,) from the `lowest` on, FINE apart; between them they are linear."""
    out = np.zeros(len(x))
    for n in range(len(x) - 1):
        where = min(max((gap[n] - lowest) / FINE, 0.0), len(shares) - 1.001)
        low, part = int(where), where - int(where)
        for r in range(len(state)):
            share = shares[low, r] + part * (shares[low + 1, r] - shares[low, r])
            state[r] += share * (x[n] - state[r])
            out[n] += WEIGHT[r] * state[r]
    return out
