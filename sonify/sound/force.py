"""MOTION -> FORCE: the contact force, or what it does, at audio rate, with exact times and sizes of its jumps."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy import sparse

from dynamics.rates import precession_rate
from dynamics.rigid_motion import HARMONICS

HALF_WIDTH = 8
"""Half the width of the low-pass before the samples, where the force holds more than they can [samples]."""
STRIDE = 16
"""Samples between the nodes at which a calm force is read; between them it is interpolated."""
CALM = 6
"""The nodes of the polynomial through them: three before a sample, three after it."""
FADE_TURNS = 4
"""Turns of the contact, before the end of a settled motion, over which everything goes to its mean over these turns."""


@dataclass(frozen=True, kw_only=True)
class ContactForce:
    """Channels of the contact force at t (k,) [s]: a continuous part plus steps.

    `smooth` (k, c) are samples of the continuous part. From each `jump_time` (j,) [s] on a channel has `jump` (j, c)
    more; there its continuous part lies `bend` (j, c) above the line from the previous jump or sample to the next
    sample. `steps` (k, c) is the sum of all jumps so far, those before the block included.
    """

    t: np.ndarray
    smooth: np.ndarray
    steps: np.ndarray
    jump_time: np.ndarray
    jump: np.ndarray
    bend: np.ndarray

    @property
    def samples(self) -> np.ndarray:
        """Both parts together at the samples, (k, c); at a jump the value after it."""
        return self.smooth + self.steps

    def channels(self, some: slice) -> "ContactForce":
        """Return `some` of the channels."""
        parts = {name: getattr(self, name)[:, some] for name in ("smooth", "steps", "jump", "bend")}
        return replace(self, **parts)

    @property
    def knots(self):
        """Of each jump: the interval it lies in (j,), the time since the previous jump or sample and to the next
        sample."""
        interval = np.searchsorted(self.t, self.jump_time, side="left") - 1
        return (
            interval,
            self.jump_time - _previous(self.jump_time, self.t[interval]),
            self.t[interval + 1] - self.jump_time,
        )


def in_newton(force, state):
    """The channels that are the force itself: along a_1, a_2 and the normal [N]."""
    return force


def last_rate(motion) -> float:
    """Return how fast [rad/s] the contact goes round at the end of a motion, at least as half the steady motion there:
    a disk that rattles on a table which acts back may stand still at its last instant."""
    state = motion.at(motion.t[-1:])
    steady = 2 / (motion.disk.time_unit * np.sqrt(np.sin(state[0, 1])))
    return max(abs(precession_rate(state)[0]), steady / 2)


class ForceSampler:
    """Samples channels(force (k, 3) [N], state (k, 11)) -> (k, c) of a motion at start + n / sample_rate [s].

    A channel may turn with the state, but at a jump of the force it must be linear in the force. Before the motion the
    channels have their first values. After it they keep the mean over the last turns of the contact, so that the end is
    no blow: what is left of the self-similar end after the solution stops is far above hearing. `rest` (c,) overrides
    the mean where it is not NaN. A motion that breaks off has no such turns: there each channel goes to its mean, or
    its rest, over the last `fade` (c,) [s], and keeps its last value where that is 0. Where the force holds more than
    the sample rate can (`Motion.bandwidth`), the samples are those of the low-passed channels.

    Where no jump is near and the force holds no more than HARMONICS turns of the contact by `calm` [rad] in STRIDE
    samples, the channels are read that often only, and interpolated; never with calm = 0. `read` counts the instants at
    which the motion was asked. Nothing else changes by use: blocks may be asked for in any order, again and again.
    tests/test_sound_force.py.
    """

    def __init__(
        self, motion, sample_rate: float, start: float = 0.0, channels=in_newton, rest=np.nan, calm=0.0, fade=0.0
    ):
        self.motion, self.channels, self.sample_rate, self.start = motion, channels, sample_rate, start
        self.calm, self.read = calm, 0
        self.end = float(motion.t[-1])
        if motion.outcome.name == "SETTLED":
            fade = FADE_TURNS * 2 * np.pi / last_rate(motion)
        span = np.min(fade, where=np.greater(fade, 0), initial=self.end)
        last = self._read(self.end - span * np.linspace(0, 1, 32 * FADE_TURNS))[1]
        mean = np.where(np.greater(fade, 0), last.mean(axis=0), last[0])
        self.rest = np.where(np.isnan(rest), mean, rest)
        self.fade = np.broadcast_to(fade, mean.shape)
        self._prepare_jumps(motion.jumps)

    def block(self, first: int, count: int) -> ContactForce:
        """Return the samples first ... first + count and the jumps between them; the last sample is the next block's
        first."""
        n = np.arange(first, first + count + 1)
        t = self._times(n)
        inside = slice(*np.searchsorted(self.jump_time, t[[0, -1]], side="right"))
        if t[0] > self.end + HALF_WIDTH / self.sample_rate:
            return self._at_rest(t)
        smooth, calm = self._interpolated(n)
        slow = calm.copy()
        smooth[~calm], slow[~calm] = self._sampled(n[~calm])
        return ContactForce(
            t=t,
            smooth=smooth,
            steps=self._steps(t),
            jump_time=self.jump_time[inside],
            jump=self.jump[inside],
            bend=self._bends(t, slow, smooth, inside),
        )

    def _sampled(self, n):
        """The continuous part at the samples n (k,), and whether it holds no more than samples can (k,)."""
        t = self._times(n)
        state, smooth = self._continuous(t)
        slow = (self._crowd(state) == 1) | (t > self.end + HALF_WIDTH / self.sample_rate)
        smooth[~slow] = self._low_passed(n[~slow])
        return smooth, slow

    def _interpolated(self, n):
        """The continuous part at successive samples n (k,) by the polynomial through CALM nodes, and where it is calm
        enough for that (k,)."""
        if not self.calm:
            return np.empty((len(n), len(self.rest))), np.zeros(len(n), bool)
        before = CALM // 2 - 1
        first, cells = n[0] // STRIDE, n[-1] // STRIDE - n[0] // STRIDE + 1
        t = self._times((first - before + np.arange(cells + CALM - 1)) * STRIDE)
        state, values = self._continuous(t)
        jumps = np.searchsorted(self.jump_time, t)
        turning = 2 * np.pi / HARMONICS * self.motion.bandwidth(state)
        still = (turning * STRIDE < self.calm * self.sample_rate) & (t >= 0) & (t <= self.end - self.fade.max())
        calm = sliding_window_view(still, CALM).all(axis=1) & (jumps[CALM - 1 :] == jumps[: 1 - CALM])
        nodes = sliding_window_view(values, CALM, axis=0).swapaxes(1, 2)
        smooth = lagrange(np.arange(CALM) - before, np.arange(STRIDE) / STRIDE).T @ nodes
        here = slice(n[0] - first * STRIDE, n[0] - first * STRIDE + len(n))
        return smooth.reshape(-1, len(self.rest))[here], np.repeat(calm, STRIDE)[here]

    def _at_rest(self, t):
        steps = np.broadcast_to(self._levels[-1], (len(t), len(self.rest)))
        none = np.zeros((0, len(self.rest)))
        return ContactForce(t=t, smooth=self.rest - steps, steps=steps, jump_time=np.zeros(0), jump=none, bend=none)

    def _prepare_jumps(self, jumps):
        self.jump_time = np.asarray(jumps.t)
        state = self.motion.at(self.jump_time)
        before, after = (self.channels(np.asarray(force), state) for force in (jumps.before, jumps.after))
        self.jump = self._faded(self.jump_time) * (after - before)
        self._levels = np.vstack([np.zeros_like(self.rest), np.cumsum(self.jump, axis=0)])
        self._left = self._fading(self.jump_time, before) - self._levels[:-1]

    def _times(self, n):
        return self.start + n / self.sample_rate

    def _within(self, t):
        return np.clip(t, 0.0, self.end)

    def _steps(self, t):
        return self._levels.take(np.searchsorted(self.jump_time, t, side="right"), axis=0)

    def _read(self, t):
        """The states (k, 11) and the channels (k, c) at t (k,), or at the end of the motion that is nearer."""
        self.read += len(t)
        state, force = self.motion.at_and_force(self._within(t))
        return state, self.channels(force, state)

    def _continuous(self, t):
        """The states (k, 11) and the continuous part (k, c) at t (k,)."""
        state, channels = self._read(t)
        return state, self._fading(t, channels) - self._steps(t)

    def _smooth(self, t):
        return self._continuous(t)[1]

    def _faded(self, t):
        share = (self.end - np.asarray(t)[:, None]) / np.maximum(self.fade, 1e-300)
        return np.cos(np.pi / 2 * np.clip(1 - share, 0, 1)) ** 2

    def _fading(self, t, values):
        late = np.asarray(t) > self.end - self.fade.max()
        if not late.any():
            return values
        values = values.copy()
        values[late] = self.rest + self._faded(t[late]) * (values[late] - self.rest)
        return values

    def _crowd(self, state):
        """How many times denser than the samples the force must be read at states (k, 11); a power of 2, mostly 1."""
        return 2 ** np.ceil(np.log2(np.clip(2 * self.motion.bandwidth(state) / self.sample_rate, 1, 2**16))).astype(int)

    def _low_passed(self, n):
        """The continuous part through a windowed sinc, at the samples n (k,) in ascending order."""
        if not len(n):
            return np.empty((0, len(self.rest)))
        cells = np.arange(n[0] - HALF_WIDTH, n[-1] + HALF_WIDTH)
        middle = self._times(cells + 0.5)
        density = np.where(middle > self.end, 1, self._crowd(self.motion.at(self._within(middle))))
        cell = np.repeat(np.arange(len(cells)), density)
        within = np.arange(len(cell)) - (np.cumsum(density) - density)[cell]
        at = cells[cell] + (within + 0.5) / density[cell]
        edges = np.searchsorted(at, [n - HALF_WIDTH, n + HALF_WIDTH])
        row = np.repeat(np.arange(len(n)), edges[1] - edges[0])
        column = np.concatenate([np.arange(*pair) for pair in edges.T])
        away = at[column] - n[row]
        weight = np.sinc(away) * np.cos(np.pi / 2 * away / HALF_WIDTH) ** 2 / density[cell[column]]
        filtering = sparse.csr_array((weight, (row, column)), shape=(len(n), len(at)))
        return (filtering @ self._smooth(self._times(at))) / filtering.sum(axis=1)[:, None]

    def _bends(self, t, slow, smooth, inside):
        """By how much the continuous part at the jumps departs from the line to the next sample; none if low-passed."""
        times, here = self.jump_time[inside], self._left[inside]
        interval = np.searchsorted(t, times, side="left") - 1
        since = _previous(times, t[interval])
        before = np.where((since == t[interval])[:, None], smooth[interval], np.roll(here, 1, axis=0))
        part = ((times - since) / (t[interval + 1] - since))[:, None]
        bend = here - (before + part * (smooth[interval + 1] - before))
        return np.where((slow[interval] & slow[interval + 1])[:, None], bend, 0.0)


def lagrange(nodes, x) -> np.ndarray:
    """Return the weights (n, k) with which values at `nodes` (n,) give their polynomial at x (k,)."""
    apart = np.subtract.outer(nodes, nodes) + np.eye(len(nodes))
    factors = np.where(np.eye(len(nodes), dtype=bool)[..., None], 1.0, (x - nodes[:, None])[None] / apart[..., None])
    return factors.prod(axis=1)


def _previous(times, samples):
    """The later of the previous jump and the previous sample, (j,) [s]."""
    return np.maximum(np.concatenate([[-np.inf], times[:-1]]), samples)
