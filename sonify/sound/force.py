"""Sample the contact force of a motion, with the exact times and sizes of its jumps."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy import sparse

from dynamics.observables import precession_rate
from dynamics.rigid_motion import FORCE_HARMONICS
from sonify.sound.fades import raised_cosine
from sonify.sound.modal_forcing import from_lower_face
from sonify.sound.oscillators import Knots

if TYPE_CHECKING:
    from dynamics.motion import ForceJumps, Motion

Channels = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]
"""Function of force (k, 3) [N], state (k, 11) and film loads (k, 5) that returns the
channels (k, c)."""

LOW_PASS_HALF_WIDTH = 8  # samples
"""Half-width of the windowed-sinc filter applied where the force varies too fast for
the sample rate."""
INTERPOLATION_STRIDE = 16  # samples
"""Spacing of the nodes at which a slowly varying force is evaluated before
interpolation."""
INTERPOLATION_NODES = 6
"""Number of nodes of the interpolating polynomial; half of them precede the sample."""


@dataclass(frozen=True, kw_only=True)
class ContactForce:
    """Channels of the contact force in one block: the sum of a continuous part and
    steps.

    Attributes
    ----------
    t : ndarray, shape (k,)
        Times of the samples [s].
    smooth : ndarray, shape (k, c)
        Continuous part at the samples.
    steps : ndarray, shape (k, c)
        Sum of all jumps up to each sample, including those before the block.
    jump_time : ndarray, shape (j,)
        Times of the jumps [s].
    jump : ndarray, shape (j, c)
        Sizes of the jumps.
    bend : ndarray, shape (j, c)
        Deviation of the continuous part at each jump from the straight line between the
        previous jump or sample and the next sample.
    """

    t: np.ndarray
    smooth: np.ndarray
    steps: np.ndarray
    jump_time: np.ndarray
    jump: np.ndarray
    bend: np.ndarray

    @classmethod
    def without_jumps(
        cls, t: np.ndarray, smooth: np.ndarray, steps: np.ndarray
    ) -> "ContactForce":
        """Return a force without jumps within the block."""
        none = np.zeros((0, smooth.shape[1]))
        return cls(
            t=t,
            smooth=smooth,
            steps=steps,
            jump_time=np.zeros(0),
            jump=none,
            bend=none,
        )

    @property
    def samples(self) -> np.ndarray:
        """Sum (k, c) of both parts at the samples; at a jump, the value after it."""
        return self.smooth + self.steps

    def channels(self, columns: slice) -> "ContactForce":
        """Return the same force with a selection of its channels."""
        return replace(
            self,
            smooth=self.smooth[:, columns],
            steps=self.steps[:, columns],
            jump=self.jump[:, columns],
            bend=self.bend[:, columns],
        )

    @property
    def knots(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Intervals of the jumps (j,), times since the previous jump or sample, and
        times to the next sample (j,) [s]."""
        interval = np.searchsorted(self.t, self.jump_time, side="left") - 1
        since = self.jump_time - _previous_knot(self.jump_time, self.t[interval])
        until = self.t[interval + 1] - self.jump_time
        return interval, since, until

    @property
    def parts(self) -> tuple[tuple[np.ndarray, Knots], tuple[np.ndarray, Knots]]:
        """Samples and knots of the continuous part, and those of the steps."""
        none = 0 * self.bend
        return (
            (self.smooth, Knots(*self.knots, none, self.bend)),
            (self.steps, Knots(*self.knots, self.jump, none)),
        )


def force_in_newton(
    force: np.ndarray, state: np.ndarray, film: np.ndarray
) -> np.ndarray:
    """Use the force (k, 3) [N] along a_1, a_2 and the normal as channels."""
    return force


def final_contact_rate(motion: "Motion") -> float:
    """Return the precession rate [rad/s] of the contact point at the end of a motion.

    The result is at least half the rate of steady motion at the final inclination,
    because a disk that rattles on a moving table may be at rest at the last instant."""
    state = motion.at(motion.t[-1:])
    steady = 2 / (motion.disk.time_unit * np.sqrt(np.sin(state[0, 1])))
    return max(abs(precession_rate(state)[0]), steady / 2)


class ForceSampler:
    """Samples channels of the contact force of a motion at times start + n /
    sample_rate [s].

    Before the motion, each channel has its initial value. Over the last revolutions of
    the contact point it fades to its mean and then stays constant, so that the end does
    not sound like an impact. The solution ends where the frequencies of the
    self-similar motion are far above the audible range. Blocks may be requested in any
    order and repeatedly. Where the force varies faster than the sample rate allows
    (`Motion.bandwidth`), the channels are low-pass filtered first.

    Parameters
    ----------
    motion : Motion
    sample_rate : float
        [Hz]
    start : float
        Time of sample 0 [s].
    channels : callable
        Function channels(force (k, 3) [N], state (k, 11), film (k, 5)) -> (k, c), where
        film contains the columns of `Motion.film_loads`; at a jump of the force it must
        be linear in the force. All of them are relative to the lower face.
    rest : float or ndarray, shape (c,)
        Value of each channel after the motion; NaN selects its mean.
    max_contact_turn : float
        Threshold [rad] for the phase advance of harmonic FORCE_HARMONICS of the force
        over INTERPOLATION_STRIDE samples. Below it, the channels are evaluated only at
        every INTERPOLATION_STRIDE-th sample and interpolated, except near jumps; 0
        disables the interpolation.
    fade : float or ndarray, shape (c,)
        Fade time [s] of each channel at the end of a motion that does not settle; 0
        holds the last value.

    Attributes
    ----------
    evaluations : int
        Number of times at which the motion was evaluated.
    """

    def __init__(
        self,
        motion: "Motion",
        sample_rate: float,
        start: float = 0.0,
        channels: Channels = force_in_newton,
        rest: float | np.ndarray = np.nan,
        max_contact_turn: float = 0.0,
        fade: float | np.ndarray = 0.0,
    ) -> None:
        # Number of revolutions of the contact point over which each channel fades to
        # its mean at the end of a settled motion
        fade_turns = 4
        self.motion = motion
        self.channels = channels
        self.sample_rate = sample_rate
        self.start = start
        self.max_contact_turn = max_contact_turn
        self.evaluations = 0
        self.end = float(motion.t[-1])
        if motion.rolling_outcome.name == "SETTLED":
            fade = fade_turns * 2 * np.pi / final_contact_rate(motion)
        span = np.min(fade, where=np.greater(fade, 0), initial=self.end)
        last = self._evaluate_channels(
            self.end - span * np.linspace(0, 1, 32 * fade_turns)
        )[1]
        mean = np.where(np.greater(fade, 0), last.mean(axis=0), last[0])
        self.rest = np.where(np.isnan(rest), mean, rest)
        self.fade = np.broadcast_to(fade, mean.shape)
        self._prepare_jumps(motion.jumps)

    def block(self, first: int, count: int) -> ContactForce:
        """Return the samples first ... first + count and the jumps between them.

        The last sample is also the first one of the next block.
        """
        n = np.arange(first, first + count + 1)
        t = self._sample_times(n)
        inside = slice(*np.searchsorted(self.jump_time, t[[0, -1]], side="right"))
        if t[0] > self.end + LOW_PASS_HALF_WIDTH / self.sample_rate:
            return self._block_at_rest(t)
        smooth, is_slow_slide = self._interpolate_samples(n)
        unfiltered = is_slow_slide.copy()
        smooth[~is_slow_slide], unfiltered[~is_slow_slide] = (
            self._sample_continuous_part(n[~is_slow_slide])
        )
        return ContactForce(
            t=t,
            smooth=smooth,
            steps=self._sum_of_jumps(t),
            jump_time=self.jump_time[inside],
            jump=self.jump[inside],
            bend=self._deviations_at_jumps(t, unfiltered, smooth, inside),
        )

    def _sample_continuous_part(self, n: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the continuous part at samples n (k,) and a mask (k,) of unfiltered
        samples."""
        t = self._sample_times(n)
        state, smooth = self._continuous_part(t)
        after_end = t > self.end + LOW_PASS_HALF_WIDTH / self.sample_rate
        unfiltered = (self._oversampling(state) == 1) | after_end
        smooth[~unfiltered] = self._low_pass_filtered(n[~unfiltered])
        return smooth, unfiltered

    def _interpolate_samples(self, n: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the interpolated continuous part at samples n (k,) and the mask (k,)
        where it is valid."""
        if not self.max_contact_turn:
            return np.empty((len(n), len(self.rest))), np.zeros(len(n), bool)
        nodes_before = INTERPOLATION_NODES // 2 - 1
        first = n[0] // INTERPOLATION_STRIDE
        cells = n[-1] // INTERPOLATION_STRIDE - first + 1
        t = self._sample_times(
            (first - nodes_before + np.arange(cells + INTERPOLATION_NODES - 1))
            * INTERPOLATION_STRIDE
        )
        state, values = self._continuous_part(t)
        jumps = np.searchsorted(self.jump_time, t)
        turning = 2 * np.pi / FORCE_HARMONICS * self.motion.bandwidth(state)
        slow = turning * INTERPOLATION_STRIDE < self.max_contact_turn * self.sample_rate
        slow_nodes = slow & (t >= 0) & (t <= self.end - self.fade.max())
        no_jump = jumps[INTERPOLATION_NODES - 1 :] == jumps[: 1 - INTERPOLATION_NODES]
        is_slow_slide = (
            sliding_window_view(slow_nodes, INTERPOLATION_NODES).all(axis=1) & no_jump
        )
        nodes = sliding_window_view(values, INTERPOLATION_NODES, axis=0).swapaxes(1, 2)
        within_cell = np.arange(INTERPOLATION_STRIDE) / INTERPOLATION_STRIDE
        weights = lagrange_weights(
            np.arange(INTERPOLATION_NODES) - nodes_before, within_cell
        )
        smooth = weights.T @ nodes
        start = n[0] % INTERPOLATION_STRIDE
        wanted = slice(start, start + len(n))
        is_valid = np.repeat(is_slow_slide, INTERPOLATION_STRIDE)[wanted]
        return smooth.reshape(-1, len(self.rest))[wanted], is_valid

    def _block_at_rest(self, t: np.ndarray) -> ContactForce:
        steps = np.broadcast_to(self._levels[-1], (len(t), len(self.rest)))
        return ContactForce.without_jumps(t, self.rest - steps, steps)

    def _prepare_jumps(self, jumps: "ForceJumps") -> None:
        self.jump_time = np.asarray(jumps.t)
        state = self.motion.at(self.jump_time)
        film = self.motion.film_loads(self.jump_time, state)
        before, after = (
            self.channels(*from_lower_face(np.asarray(force), state, film))
            for force in (jumps.before, jumps.after)
        )
        self.jump = self._fade_factor(self.jump_time) * (after - before)
        self._levels = np.vstack(
            [np.zeros_like(self.rest), np.cumsum(self.jump, axis=0)]
        )
        self._continuous_at_jump = (
            self._apply_fade(self.jump_time, before) - self._levels[:-1]
        )

    def _sample_times(self, n: np.ndarray) -> np.ndarray:
        return self.start + n / self.sample_rate

    def _clip_to_motion(self, t: np.ndarray) -> np.ndarray:
        return np.clip(t, 0.0, self.end)

    def _sum_of_jumps(self, t: np.ndarray) -> np.ndarray:
        return self._levels.take(
            np.searchsorted(self.jump_time, t, side="right"), axis=0
        )

    def _evaluate_channels(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return states (k, 11) and channels (k, c) at t (k,) [s], clipped to the
        motion."""
        self.evaluations += len(t)
        inside = self._clip_to_motion(t)
        state, force = self.motion.at_and_force(inside)
        film = self.motion.film_loads(inside, state)
        return state, self.channels(*from_lower_face(force, state, film))

    def _continuous_part(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return states (k, 11) and the continuous part of the channels (k, c) at t
        (k,) [s]."""
        state, channels = self._evaluate_channels(t)
        return state, self._apply_fade(t, channels) - self._sum_of_jumps(t)

    def _fade_factor(self, t: np.ndarray) -> np.ndarray:
        """Return the fade factor (k, c) at t (k,) [s], a raised cosine from 1 to 0 at
        the end."""
        share = (self.end - np.asarray(t)[:, None]) / np.maximum(self.fade, 1e-300)
        return raised_cosine(share)

    def _apply_fade(self, t: np.ndarray, values: np.ndarray) -> np.ndarray:
        late = np.asarray(t) > self.end - self.fade.max()
        if not late.any():
            return values
        values = values.copy()
        values[late] = self.rest + self._fade_factor(t[late]) * (
            values[late] - self.rest
        )
        return values

    def _oversampling(self, state: np.ndarray) -> np.ndarray:
        """Return the required oversampling (k,) at states (k, 11): a power of 2,
        usually 1."""
        needed = np.clip(2 * self.motion.bandwidth(state) / self.sample_rate, 1, 2**16)
        return 2 ** np.ceil(np.log2(needed)).astype(int)

    def _low_pass_filtered(self, n: np.ndarray) -> np.ndarray:
        """Return the continuous part at ascending samples n (k,), filtered by a
        windowed sinc."""
        if not len(n):
            return np.empty((0, len(self.rest)))
        width = LOW_PASS_HALF_WIDTH
        cells = np.arange(n[0] - width, n[-1] + width)
        middle = self._sample_times(cells + 0.5)
        oversampling = self._oversampling(self.motion.at(self._clip_to_motion(middle)))
        density = np.where(middle > self.end, 1, oversampling)
        cell = np.repeat(np.arange(len(cells)), density)
        within = np.arange(len(cell)) - (np.cumsum(density) - density)[cell]
        at = cells[cell] + (within + 0.5) / density[cell]
        edges = np.searchsorted(at, [n - width, n + width])
        row = np.repeat(np.arange(len(n)), edges[1] - edges[0])
        column = np.concatenate([np.arange(*pair) for pair in edges.T])
        distance = at[column] - n[row]
        weight = (
            np.sinc(distance)
            * np.cos(np.pi / 2 * distance / width) ** 2
            / density[cell[column]]
        )
        sinc = sparse.csr_array((weight, (row, column)), shape=(len(n), len(at)))
        return (sinc @ self._continuous_part(self._sample_times(at))[1]) / sinc.sum(
            axis=1
        )[:, None]

    def _deviations_at_jumps(
        self, t: np.ndarray, unfiltered: np.ndarray, smooth: np.ndarray, inside: slice
    ) -> np.ndarray:
        """Return `ContactForce.bend` of the jumps in the slice `inside`; zero where the
        samples are low-pass filtered."""
        times = self.jump_time[inside]
        at_jump = self._continuous_at_jump[inside]
        interval = np.searchsorted(t, times, side="left") - 1
        previous = _previous_knot(times, t[interval])
        after_sample = (previous == t[interval])[:, None]
        before = np.where(after_sample, smooth[interval], np.roll(at_jump, 1, axis=0))
        part = ((times - previous) / (t[interval + 1] - previous))[:, None]
        bend = at_jump - (before + part * (smooth[interval + 1] - before))
        return np.where(
            (unfiltered[interval] & unfiltered[interval + 1])[:, None], bend, 0.0
        )


def lagrange_weights(nodes: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Return the Lagrange interpolation weights (n, k) of `nodes` (n,) at x (k,)."""
    differences = np.subtract.outer(nodes, nodes) + np.eye(len(nodes))
    ratios = (x - nodes[:, None])[None] / differences[..., None]
    factors = np.where(np.eye(len(nodes), dtype=bool)[..., None], 1.0, ratios)
    return factors.prod(axis=1)


def _previous_knot(times: np.ndarray, samples: np.ndarray) -> np.ndarray:
    """Return the time (j,) [s] of the previous jump or sample, whichever is later."""
    return np.maximum(np.concatenate([[-np.inf], times[:-1]]), samples)
