"""FORCE -> MODES: linear oscillators stepped exactly for a force that is piecewise linear, jumps and corners
included."""

from typing import NamedTuple

import numpy as np
from numba import njit


class Knots(NamedTuple):
    """Where a force departs from the straight line between two samples.

    Knot j lies in the interval after sample `interval` (j,), `since` (j,) [s] after the previous knot or sample and
    `until` (j,) [s] before the next sample. There the force jumps by `jump` (j, m), and its continuous part lies `bend`
    (j, m) above the line from the previous knot or sample to the next sample. In order of time.
    """

    interval: np.ndarray
    since: np.ndarray
    until: np.ndarray
    jump: np.ndarray
    bend: np.ndarray


def no_knots(m: int) -> Knots:
    """Return the knots of a force of m components that has none."""
    return Knots(np.zeros(0, int), np.zeros(0), np.zeros(0), np.zeros((0, m)), np.zeros((0, m)))


def free_response(omega, decay, t):
    """Return c, s with q = (c + decay s) q0 + s v0 for q'' + 2 decay q' + omega^2 q = 0; any decay >= 0, omega > 0.

    With w = sqrt(omega^2 - decay^2), imaginary when overdamped: c = exp(-decay t) cos(w t), s = exp(-decay t) sin(w
    t)/w. All arguments broadcast; omega, decay [1/s], t [s].
    """
    omega, decay, t = np.broadcast_arrays(*map(np.asarray, (omega, decay, t)))
    w = np.sqrt((omega - decay) * (omega + decay) + 0j)
    rising, falling = np.exp((-decay + 1j * w) * t), np.exp((-decay - 1j * w) * t)
    near = np.abs(w * t) < 1e-3  # sin(x)/x by its series, also where the damping is critical
    series = t * np.exp(-decay * t) * (1 - ((w * t) ** 2).real / 6)
    s = np.where(near, series, ((rising - falling) / np.where(near, 1, 2j * w)).real)
    return (rising + falling).real / 2, s


def responses(omega, decay, t):
    """Return the displacement at time t after a unit step and after a unit ramp; the velocity of one is the other's
    rate.

    From the equation of motion itself: omega^2 q = force - 2 decay q' - q''. Arguments as `free_response`.
    """
    c, s = free_response(omega, decay, t)
    step = (1 - c - decay * s) / omega**2
    ramp = (t - 2 * decay * step - s) / omega**2
    return step, ramp


def compile_oscillators() -> None:
    """Compile what an OscillatorBank needs, beside other work."""
    OscillatorBank(np.ones(1), np.ones(1), 8.0).advance(np.zeros((1, 1)))


class OscillatorBank:
    """m oscillators q'' + 2 d q' + w^2 q = g(t) with states that carry over from block to block.

    `frequency` w/2pi (m,) [Hz] > 0 and below half the `sample_rate` [Hz]; `decay_rate` d (m,) [1/s] >= 0, also
    overdamped. Exact for every g that is linear between samples and knots; unconditionally stable, since it is the
    exact solution that is stepped. Raises ValueError for a frequency or a decay outside its range.
    tests/test_oscillators.py.
    """

    def __init__(self, frequency, decay_rate, sample_rate: float):
        frequency, self.decay = np.asarray(frequency, float), np.asarray(decay_rate, float)
        if not np.all((frequency > 0) & (frequency < sample_rate / 2)):
            raise ValueError("frequencies must lie above 0 and below half the sample rate")
        if not np.all((self.decay >= 0) & np.isfinite(self.decay)):
            raise ValueError("decay rates must be finite and not negative")
        self.omega, self.h = 2 * np.pi * frequency, 1 / sample_rate
        self._hold()
        self.settle(0.0)

    def settle(self, g, slope=0.0):
        """Put every oscillator where a force that has long been rising with `slope` (m,) has it when it reaches g (m,).

        The samples of the next block begin with g.
        """
        v = slope / self.omega**2 + 0 * self.omega
        q = (g - 2 * self.decay * v) / self.omega**2
        self.state = self._observed(np.stack([q, v]) - self.late * g)

    def advance(self, g, knots: Knots | None = None, out: np.ndarray | None = None) -> np.ndarray:
        """Step through the samples g (k + 1, m); return the accelerations q'' (k, m) at the first k of them.

        The last sample is the first of the next block. g is the force after a jump where one falls on a sample. A force
        (k + 1, 1), with knots of one component, acts on every mode. `out` (k, m), where given, is filled and returned:
        memory that is fresh for every block would take longer than the recursion.
        """
        g = np.ascontiguousarray(g, dtype=float)
        knots = knots or no_knots(g.shape[1])
        out = np.empty((len(g) - 1, len(self.omega))) if out is None else out
        stops = np.append(knots.interval + 1, len(out))
        _advance(g, int(len(g[0]) > 1), self.state, self.step, stops, self.kicks(knots), out)
        return out

    def _hold(self):
        """The exact step x' = A x + early g0 + late g1 of x = (q, q') under a force that goes linearly from g0 to g1.

        With the state x - late g and its observable coordinates the acceleration is the output of
        w1' = trace w1 + w2 + ..., w2' = -det w1 + ..., five multiplications a sample.
        """
        c, s = free_response(self.omega, self.decay, self.h)
        step, ramp = responses(self.omega, self.decay, self.h)
        A = np.array([[c + self.decay * s, s], [-(self.omega**2) * s, c - self.decay * s]])
        early, self.late = np.array([step - ramp / self.h, s - step / self.h]), np.array([ramp, step]) / self.h
        C = np.array([-(self.omega**2), -2 * self.decay])
        trace, det = 2 * c, np.exp(-2 * self.decay * self.h)
        self.rows = np.array([C, np.einsum("i...,ij...->j...", C, A) - trace * C])
        (a, b), (c, d) = self.rows
        self.back = np.array([[d, -b], [-c, a]]) / (a * d - b * c)
        into = self._observed(np.einsum("ij...,j...->i...", A, self.late) + early)
        through = 1 + np.einsum("i...,i...->...", C, self.late)
        self.step = np.ascontiguousarray([through, into[0], trace, into[1], -det])

    def known(self, state, g) -> np.ndarray:
        """Return displacement and velocity (2, m) in a state (2, m) before a sample of the force g (m,)."""
        return np.einsum("ij...,j...->i...", self.back, state) + self.late * g

    def taken(self, x, g) -> np.ndarray:
        """Return the state (2, m) that has displacement and velocity x (2, m) before a sample of the force g (m,)."""
        return self._observed(x - self.late * g)

    def _observed(self, x):
        return np.einsum("wi...,i...->w...", self.rows, x)

    def kicks(self, knots):
        """Return what knots add to the state at the next sample, beyond the line between the samples around them,
        (2, j, m); of a bank (j, m) every knot has its own row."""
        modes = self.omega.shape[-1]
        if not (len(knots.interval) and modes):
            return np.zeros((2, len(knots.interval), modes))
        since, until = np.maximum(knots.since[:, None], 1e-6 * self.h), np.maximum(knots.until[:, None], 1e-6 * self.h)
        step, ramp = responses(self.omega, self.decay, until)
        rate = free_response(self.omega, self.decay, until)[1]
        early_step, early_ramp = responses(self.omega, self.decay, since + until)
        rise, turn = knots.bend / since, knots.bend / since + knots.bend / until
        q = step * knots.jump + early_ramp * rise - ramp * turn
        v = rate * knots.jump + early_step * rise - step * turn
        return self._observed(np.stack([q, v]) - self.late.reshape(2, -1, modes) * knots.jump)


@njit(cache=True, nogil=True)
def _advance(g, own, state, step, stops, kicks, out):
    """Every sample comes from the same operations wherever a block begins: its bits do not depend on that. Every mode
    has a force of its `own` (1) or the same one (0); the kicks come before the samples `stops`."""
    start = 0
    for j in range(len(stops)):
        for n in range(start, stops[j]):
            for m in range(out.shape[1]):
                u = g[n, m] if own else g[n, 0]
                first, second = state[0, m], state[1, m]
                out[n, m] = step[0, m] * u + first
                state[0, m] = step[1, m] * u + (step[2, m] * first + second)
                state[1, m] = step[3, m] * u + step[4, m] * first
        for m in range(out.shape[1] if j < kicks.shape[1] else 0):
            state[0, m] += kicks[0, j, m]
            state[1, m] += kicks[1, j, m]
        start = stops[j]
