"""FILM -> SOUND: the disk radiates through the film of air under it, and the film damps and detunes its modes.

Where the film is open, the air pushed out at the rim cancels what the face pushes: of the pressure p of a flush piston
in a baffle, a - g b is heard, where g is the share of the displaced air that leaves at the rim, and a, b hold the
height of the disk. All of it is that of the wedge (dynamics/film/reynolds.py) at the inclination of the instant.
"""

from dataclasses import replace

import numpy as np
from numba import njit

from dynamics.equations import Law
from dynamics.film.acting import film_of
from dynamics.film.law import compressibility, film_in
from dynamics.rates import precession_rate
from dynamics.regime import ARRAY
from sonify.sound.drive import in_patch_frame, listener_azimuth, rigid_acceleration
from sonify.sound.film_modes import Tuned, filmed, heights
from sonify.sound.response import Vibrating
from sonify.sound.sources import FADE_OUT, ElasticDisk, RigidDisk, noted_energy

LAM = np.array([0.01, 0.1, 0.2, 0.3, 0.5, 1, 2, 3, 5, 10, 20, 30, 50, 100, 200, 300])
SHARE = np.array([1, 0.9996, 0.9986, 0.9971, 0.9931, 0.9796, 0.9469, 0.9135, 0.8507, 0.7242, 0.5604, 0.4629, 0.3567])
SHARE = np.append(SHARE, [0.2473, 0.1712, 0.1391]) + 1e-4j * np.array(
    [0, 11, 18, 19, 13, -40, -193, -350, -612, -1021, -1285, -1313, -1242, -1024, -767, -619]
)
"""g1 of the turning, compressible wedge by `reynolds.compressible`; beyond it falls as the root of Lam."""
RELAXATION = 10.0 ** np.arange(-4, 0.1, 0.5)
WEIGHT = np.array([0.02328, 0.0028, 0.02786, 0.04064, 0.07065, 0.13892, 0.22665, 0.40624, 0.06297])
"""g0 of the wedge, within 0.005: sum of WEIGHT/(1 + i sigma RELAXATION), sigma = 12 mu w R^2/(p g^2)."""
ASIDE = 0.4288
"""Of a heave the open wedge lets out so much more towards its wide side: int q cos(theta) ds over int q ds."""


def with_film(scene, motion, rigid: RigidDisk, elastic: ElasticDisk) -> tuple[RigidDisk, ElasticDisk]:
    """Return what radiates the disk, through the film where it acts in the scene."""
    if film_of(scene).film is None:
        return rigid, elastic
    return FilmedRigid(scene, motion, rigid), FilmedElastic(scene, motion, elastic)


def share_of_tilt(Lam) -> np.ndarray:
    """Return g1 (k,), the share of the tilt's dipole that leaves at the rim, of a film that turns forward; numbers Lam
    (k,)."""
    inside = np.log(np.clip(Lam, LAM[0], LAM[-1]))
    share = np.interp(inside, np.log(LAM), SHARE.real) + 1j * np.interp(inside, np.log(LAM), SHARE.imag)
    return share / np.sqrt(np.maximum(Lam / LAM[-1], 1))


class FilmedRigid(RigidDisk):
    """The heave and the tilt of the rigid disk, through the film: it also presses on the disk, where it does so in the
    motion."""

    def __init__(self, scene, motion, open_disk: RigidDisk):
        self.__dict__ |= vars(open_disk)
        self.ends = np.array([[0.0, FADE_OUT]] * 2 + [[np.nan, 0.0]] * 2)
        self._air, self._film = scene.air, film_in(getattr(motion, "loads", None))
        self._a0, self._b0, self._a1, self._b1 = heights(scene.disk.thickness, scene.disk.radius)
        self._h = 1 / scene.audio.sample_rate

    def channels(self, force, state):
        """Return the heave and what is heard of the tilt towards the listener [m/s^2], the logarithm of the mean gap
        [m], and the cosine of the listener's azimuth, (k, 4)."""
        disk, (lift, across, along) = self._disk, self._pressed(state)
        turn = in_patch_frame(force, state[:, 1]) @ rigid_acceleration(np.eye(3), disk)[:, 3:]
        about_diameter = disk.mass * (disk.radius**2 * disk.gyration / 4 + disk.thickness**2 / 12)
        turn[:, :2] -= np.column_stack([along, across]) / about_diameter
        rate = precession_rate(state)
        share = share_of_tilt(compressibility(state[:, 1], rate, self._air))
        heard = self._a1 - self._b1 * np.where(rate < 0, share.conj(), share)
        azimuth = listener_azimuth(state, turning_with_body=False)
        tilt = (heard * (1j * turn[:, 0] - turn[:, 1]) * np.exp(-1j * azimuth)).real
        heave = (force[:, 2] + lift - disk.weight) / disk.mass
        return np.column_stack([heave, disk.radius * tilt, log_gap(state, disk), np.cos(azimuth)])

    def from_rest(self, first, note):
        """Return what radiates the blocks that follow on channels `first` (4,)."""
        upwards, aside = (self._face.from_rest(first[:2] * part) for part in ([self._a0 - self._b0, 1.0], [0.0, 0.0]))
        relaxed = np.full(len(WEIGHT), first[0])

        def advance(force):
            heave, tilt, gap, cosine = force.samples.T
            speed = self._h * self._air.pressure * np.exp(2 * gap) / (12 * self._air.viscosity * self._disk.radius**2)
            out, at_once = _relaxed(heave, speed, 1 / RELAXATION, WEIGHT, relaxed)
            smooth = np.column_stack([self._a0 * heave - self._b0 * out, tilt])
            jump = force.jump[:, :2].copy()
            jump[:, 0] *= self._a0 - self._b0 * at_once[force.knots[0]]
            dipole = np.column_stack([0 * out, 4 * ASIDE * self._b1 * out * cosine])
            both = (upwards, smooth, jump), (aside, dipole, 0 * jump)
            heard = [radiate(replace(force, smooth=a, steps=0 * a, jump=b)) for radiate, a, b in both]
            return heard[0] + heard[1][:, ::-1]

        return advance

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
        self._filmed = filmed(self._modes, scene)

    def channels(self, force, state):
        """Return cosine and sine of the listener's azimuth, the logarithm of the mean gap [m], and the force on each
        mode: (k, 3 + m)."""
        return np.insert(super().channels(force, state), 2, log_gap(state, self._scene.disk), axis=1)

    def from_rest(self, first, note):
        """Return what radiates the blocks that follow on `first` (3 + m,), and notes the energy of the modes."""
        rate, radiated = self._scene.audio.sample_rate, self._face.from_rest(first[:2], self.beside)
        carried = self._response(first[3:]) if isinstance(self._motion, Vibrating) else None
        tuned = Tuned(self._filmed, rate, first[3:], first[2])

        def advance(force):
            gap, driven = force.samples[:, 2], force.channels(slice(3, None))
            ringing = carried.advance(driven) if carried else tuned.advance(driven, gap)
            note(*noted_energy(force.t, ringing.sum(axis=0), self._modes, rate))
            return radiated(ringing * self._filmed.heard(gap[:-1]), force.samples[:-1, :2])

        return advance


def log_gap(state, disk):
    """Return the logarithm of the mean gap [m] at states (k, 11)."""
    return np.log(disk.radius * np.sin(state[:, 1]))


@njit(cache=True)
def _relaxed(x, speed, fast, weight, state):
    """Let `state` (r,) relax towards the samples x (k + 1,), of which the last is left to the next block, by `fast`
    times `speed` (k + 1,) a sample; return the weighted sum, and the part of a jump that is in it at once, (k + 1,)."""
    out, at_once = np.zeros(len(x)), np.zeros(len(x))
    for n in range(len(x) - 1):
        for r in range(len(fast)):
            share = 1 - np.exp(-speed[n] * fast[r])
            state[r] += share * (x[n] - state[r])
            out[n] += weight[r] * state[r]
            at_once[n] += weight[r] * share
    return out, at_once
