"""FORCE -> MODES: linear oscillators, stepped exactly for a piecewise linear force with jumps and
corners."""

from typing import NamedTuple

import numpy as np
from numba import njit


class Knots(NamedTuple):
    """Times, in ascending order, at which a force departs from a straight line between samples.

    Attributes
    ----------
    interval : ndarray, shape (j,)
        Number of the sample before each knot.
    since : ndarray, shape (j,)
        Time [s] since the previous knot or sample.
    until : ndarray, shape (j,)
        Time [s] to the next sample.
    jump : ndarray, shape (j, m)
        Jump of the force.
    bend : ndarray, shape (j, m)
        Continuous part of the force minus the line from the previous knot or sample to the next
        sample.
    """

    interval: np.ndarray
    since: np.ndarray
    until: np.ndarray
    jump: np.ndarray
    bend: np.ndarray


def empty_knots(m: int) -> Knots:
    """Return the knots of a force of m components without knots."""
    return Knots(np.zeros(0, int), np.zeros(0), np.zeros(0), np.zeros((0, m)), np.zeros((0, m)))


def free_response(omega, decay, t):
    """Return c and s of the free oscillation q = (c + decay s) q0 + s v0.

    It solves q'' + 2 decay q' + omega^2 q = 0 for omega > 0 and any decay >= 0, both [1/s], at
    times t [s]. With w = sqrt(omega^2 - decay^2), imaginary if overdamped: c = exp(-decay t) cos(w
    t), s = exp(-decay t) sin(w t)/w. All arguments broadcast."""
    omega, decay, t = np.broadcast_arrays(*map(np.asarray, (omega, decay, t)))
    w = np.sqrt((omega - decay) * (omega + decay) + 0j)
    rising = np.exp((-decay + 1j * w) * t)
    falling = np.exp((-decay - 1j * w) * t)
    small = np.abs(w * t) < 1e-3  # use the series of sin(x)/x, also at critical damping
    series = t * np.exp(-decay * t) * (1 - ((w * t) ** 2).real / 6)
    s = np.where(small, series, ((rising - falling) / np.where(small, 1, 2j * w)).real)
    return (rising + falling).real / 2, s


def step_and_ramp_responses(omega, decay, t):
    """Return the displacements at times t [s] after a unit step and after a unit ramp of the force.

    The velocity after a ramp is the displacement after a step. Both follow from omega^2 q = force -
    2 decay q' - q''. Arguments as in `free_response`."""
    c, s = free_response(omega, decay, t)
    step = (1 - c - decay * s) / omega**2
    ramp = (t - 2 * decay * step - s) / omega**2
    return step, ramp


def compile_oscillators() -> None:
    """Compile the kernels of OscillatorBank; call it in a background thread."""
    OscillatorBank(np.ones(1), np.ones(1), 8.0).advance(np.zeros((1, 1)))


class OscillatorBank:
    """m oscillators q'' + 2 d q' + w^2 q = g(t), with states that carry over from block to block.

    The exact solution is stepped: it is unconditionally stable, and exact for every g that is
    linear between samples and knots.

    Parameters
    ----------
    frequency : ndarray, shape (m,)
        w/2pi [Hz], above 0 and below half the sample rate.
    decay_rate : ndarray, shape (m,)
        d [1/s], not negative; overdamped oscillators are allowed.
    sample_rate : float
        [Hz]

    Raises
    ------
    ValueError
        If a frequency or a decay rate is outside its range.

    Examples
    --------
    >>> bank = OscillatorBank([100.0], [0.0], 1000.0)
    >>> bank.advance(np.ones((2, 1)))  # the acceleration at the start of a unit step
    array([[1.]])
    """

    def __init__(self, frequency, decay_rate, sample_rate: float):
        frequency = np.asarray(frequency, float)
        self.decay = np.asarray(decay_rate, float)
        if not np.all((frequency > 0) & (frequency < sample_rate / 2)):
            raise ValueError("frequencies must be above 0 and below half the sample rate")
        if not np.all((self.decay >= 0) & np.isfinite(self.decay)):
            raise ValueError("decay rates must be finite and not negative")
        self.omega = 2 * np.pi * frequency
        self.h = 1 / sample_rate
        self._compute_step()
        self.settle(0.0)

    def settle(self, g, slope=0.0):
        """Set the steady response to a force with value g (m,) that has always risen with `slope`
        (m,).

        The samples of the next block must begin with g."""
        v = slope / self.omega**2 + 0 * self.omega
        q = (g - 2 * self.decay * v) / self.omega**2
        self.state = self._observed(np.stack([q, v]) - self.late * g)

    def advance(self, g, knots: Knots | None = None, out: np.ndarray | None = None) -> np.ndarray:
        """Step through the samples of one block.

        Parameters
        ----------
        g : ndarray, shape (k + 1, m) or (k + 1, 1)
            Force at the samples, after the jump where a jump coincides with a sample. The last
            sample is also the first one of the next block. A single column acts on every mode.
        knots : Knots, optional
            Knots of the force, with as many components as g.
        out : ndarray, shape (k, m), optional
            Array for the result. Allocating one per block takes longer than the recursion.

        Returns
        -------
        ndarray, shape (k, m)
            Accelerations q'' at the first k samples.
        """
        g = np.ascontiguousarray(g, dtype=float)
        knots = knots or empty_knots(g.shape[1])
        out = np.empty((len(g) - 1, len(self.omega))) if out is None else out
        stops = np.append(knots.interval + 1, len(out))
        one_per_mode = int(len(g[0]) > 1)
        _step_bank(g, one_per_mode, self.state, self.step, stops, self.knot_impulses(knots), out)
        return out

    def _compute_step(self):
        """Compute the step x' = A x + early g0 + late g1 of x = (q, q') under a force linear from
        g0 to g1.

        The state is x - late g in observable coordinates, so that the acceleration is the output of
        w1' = trace w1 + w2 + ..., w2' = -det w1 + ...: five multiplications per sample.
        """
        c, s = free_response(self.omega, self.decay, self.h)
        step, ramp = step_and_ramp_responses(self.omega, self.decay, self.h)
        A = np.array([[c + self.decay * s, s], [-(self.omega**2) * s, c - self.decay * s]])
        early = np.array([step - ramp / self.h, s - step / self.h])
        self.late = np.array([ramp, step]) / self.h
        C = np.array([-(self.omega**2), -2 * self.decay])
        trace = 2 * c
        det = np.exp(-2 * self.decay * self.h)
        self.rows = np.array([C, np.einsum("i...,ij...->j...", C, A) - trace * C])
        (a, b), (c, d) = self.rows
        self.back = np.array([[d, -b], [-c, a]]) / (a * d - b * c)
        into = self._observed(np.einsum("ij...,j...->i...", A, self.late) + early)
        through = 1 + np.einsum("i...,i...->...", C, self.late)
        self.step = np.ascontiguousarray([through, into[0], trace, into[1], -det])

    def displacement_velocity(self, state, g) -> np.ndarray:
        """Return displacement and velocity (2, m) in a state (2, m) before a sample of the force g
        (m,)."""
        return np.einsum("ij...,j...->i...", self.back, state) + self.late * g

    def state_from(self, x, g) -> np.ndarray:
        """Return the state (2, m) of displacement and velocity x (2, m) before a sample of the
        force g (m,)."""
        return self._observed(x - self.late * g)

    def _observed(self, x):
        """Return x (2, ...) in observable coordinates."""
        return np.einsum("wi...,i...->w...", self.rows, x)

    def knot_impulses(self, knots):
        """Return the change of the state at the next sample by each knot, relative to a straight
        line, (2, j, m).

        In a bank (j, m) each knot has a row of its own.
        """
        modes = self.omega.shape[-1]
        if not (len(knots.interval) and modes):
            return np.zeros((2, len(knots.interval), modes))
        shortest = 1e-6 * self.h
        since = np.maximum(knots.since[:, None], shortest)
        until = np.maximum(knots.until[:, None], shortest)
        step, ramp = step_and_ramp_responses(self.omega, self.decay, until)
        rate = free_response(self.omega, self.decay, until)[1]
        early_step, early_ramp = step_and_ramp_responses(self.omega, self.decay, since + until)
        rise = knots.bend / since
        turn = knots.bend / since + knots.bend / until
        q = step * knots.jump + early_ramp * rise - ramp * turn
        v = rate * knots.jump + early_step * rise - step * turn
        return self._observed(np.stack([q, v]) - self.late.reshape(2, -1, modes) * knots.jump)


@njit(cache=True, nogil=True)
def _step_bank(g, one_per_mode, state, step, stops, impulses, out):
    """Step the bank through samples g; `impulses` (2, j, m) act before the samples `stops`.

    Each mode has its own force if `one_per_mode` is 1, and the same force if it is 0. The
    operations at a sample do not depend on the start of a block, so the results are bit-identical
    for all block sizes."""
    start = 0
    for j in range(len(stops)):
        for n in range(start, stops[j]):
            for m in range(out.shape[1]):
                u = g[n, m] if one_per_mode else g[n, 0]
                first = state[0, m]
                second = state[1, m]
                out[n, m] = step[0, m] * u + first
                state[0, m] = step[1, m] * u + (step[2, m] * first + second)
                state[1, m] = step[3, m] * u + step[4, m] * first
        for m in range(out.shape[1] if j < impulses.shape[1] else 0):
            state[0, m] += impulses[0, j, m]
            state[1, m] += impulses[1, j, m]
        start = stops[j]
