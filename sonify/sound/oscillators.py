"""Integrate linear oscillators exactly for a piecewise linear force with jumps and
corners."""

from typing import NamedTuple

import numpy as np

from dynamics.numba_kernels import njit


class Knots(NamedTuple):
    """Jumps and corners of a force between samples, in order of time.

    Attributes
    ----------
    interval : ndarray, shape (j,)
        Index of the sample before each knot.
    since : ndarray, shape (j,)
        Time [s] since the previous knot or sample.
    until : ndarray, shape (j,)
        Time [s] to the next sample.
    jump : ndarray, shape (j, m)
        Jump of the force.
    bend : ndarray, shape (j, m)
        Deviation of the continuous part of the force from the straight line between the
        previous knot or sample and the next sample.
    """

    interval: np.ndarray
    since: np.ndarray
    until: np.ndarray
    jump: np.ndarray
    bend: np.ndarray

    def between(self, start: int, end: int) -> "Knots":
        """Return the knots in the intervals from `start` to `end`, counted from
        `start`."""
        inside = (self.interval >= start) & (self.interval < end)
        interval, *others = (values[inside] for values in self)
        return Knots(interval - start, *others)


def empty_knots(m: int) -> Knots:
    """Return an empty set of knots for a force of m components."""
    return Knots(
        np.zeros(0, int), np.zeros(0), np.zeros(0), np.zeros((0, m)), np.zeros((0, m))
    )


def free_response(
    omega: np.ndarray, decay: np.ndarray, t: float | np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the coefficients c and s of the free oscillation q = (c + decay s) q0 + s
    v0.

    It solves q'' + 2 decay q' + omega^2 q = 0 for omega > 0 and any decay >= 0, both
    [1/s], at times t [s]. With w = sqrt(omega^2 - decay^2), imaginary if overdamped: c
    = exp(-decay t) cos(w t), s = exp(-decay t) sin(w t)/w. All arguments broadcast."""
    omega, decay, t = np.broadcast_arrays(*map(np.asarray, (omega, decay, t)))
    w = np.sqrt((omega - decay) * (omega + decay) + 0j)
    rising = np.exp((-decay + 1j * w) * t)
    falling = np.exp((-decay - 1j * w) * t)
    small = np.abs(w * t) < 1e-3  # use the series of sin(x)/x, also at critical damping
    series = t * np.exp(-decay * t) * (1 - ((w * t) ** 2).real / 6)
    s = np.where(small, series, ((rising - falling) / np.where(small, 1, 2j * w)).real)
    return (rising + falling).real / 2, s


def step_and_ramp_responses(
    omega: np.ndarray, decay: np.ndarray, t: float | np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the displacements at times t [s] after a unit step and after a unit ramp
    of force.

    The velocity after a ramp equals the displacement after a step. Both follow from
    omega^2 q = force - 2 decay q' - q''. The arguments are those of `free_response`."""
    c, s = free_response(omega, decay, t)
    step = (1 - c - decay * s) / omega**2
    ramp = (t - 2 * decay * step - s) / omega**2
    return step, ramp


def compile_oscillators() -> None:
    """Compile the kernels of OscillatorBank; intended for a background thread."""
    OscillatorBank(np.ones(1), np.ones(1), 8.0).advance(np.zeros((1, 1)))


class OscillatorBank:
    """Bank of m oscillators q'' + 2 d q' + w^2 q = g(t), advanced block by block.

    The time step is exact for every g that is linear between samples and knots, and
    therefore unconditionally stable.

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
    >>> bank.set_steady_state(1.0)
    >>> bool(abs(bank.advance(np.ones((2, 1)))[0, 0]) < 1e-12)  # a constant force
    True
    """

    def __init__(
        self, frequency: np.ndarray, decay_rate: np.ndarray, sample_rate: float
    ) -> None:
        frequency = np.asarray(frequency, float)
        self.decay = np.asarray(decay_rate, float)
        if not np.all((frequency > 0) & (frequency < sample_rate / 2)):
            raise ValueError(
                "frequencies must be above 0 and below half the sample rate"
            )
        if not np.all((self.decay >= 0) & np.isfinite(self.decay)):
            raise ValueError("decay rates must be finite and not negative")
        self.omega = 2 * np.pi * frequency
        self.h = 1 / sample_rate
        self._compute_step()
        self.state: np.ndarray
        self.set_steady_state(0.0)

    def take_over(self, other: "OscillatorBank", g: np.ndarray) -> None:
        """Continue the oscillation of a bank with another tuning at a force sample g
        (m,), with its velocity and its displacement from static equilibrium."""
        moved = (other.back * other.state).sum(axis=1)
        moved += (other.late_from_equilibrium - self.late_from_equilibrium) * g
        self.state = (self.rows * moved).sum(axis=1)

    def set_steady_state(self, g: float | np.ndarray) -> None:
        """Set the state to the static response to a constant force g (m,).

        The samples of the next block must begin with g."""
        q = g / self.omega**2
        self.state = self.observable_state(np.stack([q, 0 * q]), g)

    def observable_state(self, x: np.ndarray, g: float | np.ndarray) -> np.ndarray:
        """Return the state (2, m) for displacement and velocity x (2, m) before a force
        sample g (m,)."""
        return self._to_observable_coordinates(x - self.late * g)

    def advance(
        self, g: np.ndarray, knots: Knots | None = None, out: np.ndarray | None = None
    ) -> np.ndarray:
        """Step through the samples of one block.

        Parameters
        ----------
        g : ndarray, shape (k + 1, m) or (k + 1, 1)
            Force at the samples; the value after the jump if a jump coincides with a
            sample. The last sample is also the first one of the next block. A single
            column acts on every mode.
        knots : Knots, optional
            Knots of the force, with as many components as g.
        out : ndarray, shape (k, m), optional
            Array for the result; allocating a new one for each block would take longer
            than the recursion.

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
        _step_bank(
            g,
            one_per_mode,
            self.state,
            self.step,
            stops,
            self.knot_impulses(knots),
            out,
        )
        return out

    def _compute_step(self) -> None:
        """Compute the coefficients of the time step for a force that is linear between
        samples.

        The step from g0 to g1 maps x = (q, q') to A x + early g0 + late g1. The state
        is x - late g in observable coordinates, so that the acceleration is the output
        of w1' = trace w1 + w2 + ..., w2' = -det w1 + ..., with five multiplications per
        sample.
        """
        c, s = free_response(self.omega, self.decay, self.h)
        step, ramp = step_and_ramp_responses(self.omega, self.decay, self.h)
        A = np.array(
            [[c + self.decay * s, s], [-(self.omega**2) * s, c - self.decay * s]]
        )
        early = np.array([step - ramp / self.h, s - step / self.h])
        self.late = np.array([ramp, step]) / self.h
        self.late_from_equilibrium = self.late - [self.omega**-2.0, 0 * self.omega]
        C = np.array([-(self.omega**2), -2 * self.decay])
        trace = 2 * c
        det = np.exp(-2 * self.decay * self.h)
        self.rows = np.array([C, np.einsum("i...,ij...->j...", C, A) - trace * C])
        (a, b), (c, d) = self.rows
        self.back = np.array([[d, -b], [-c, a]]) / (a * d - b * c)
        into = self._to_observable_coordinates(
            np.einsum("ij...,j...->i...", A, self.late) + early
        )
        through = 1 + np.einsum("i...,i...->...", C, self.late)
        self.step = np.ascontiguousarray([through, into[0], trace, into[1], -det])

    def _to_observable_coordinates(self, x: np.ndarray) -> np.ndarray:
        """Return x (2, ...) in observable coordinates."""
        return np.einsum("wi...,i...->w...", self.rows, x)

    def knot_impulses(self, knots: Knots) -> np.ndarray:
        """Return the state change (2, j, m) that each knot causes at the next sample.

        The reference is a force that is linear between the samples. In a bank of shape
        (j, m) each knot uses its own row.
        """
        modes = self.omega.shape[-1]
        if not (len(knots.interval) and modes):
            return np.zeros((2, len(knots.interval), modes))
        shortest = 1e-6 * self.h
        since = np.maximum(knots.since[:, None], shortest)
        until = np.maximum(knots.until[:, None], shortest)
        step, ramp = step_and_ramp_responses(self.omega, self.decay, until)
        rate = free_response(self.omega, self.decay, until)[1]
        early_step, early_ramp = step_and_ramp_responses(
            self.omega, self.decay, since + until
        )
        rise = knots.bend / since
        turn = knots.bend / since + knots.bend / until
        q = step * knots.jump + early_ramp * rise - ramp * turn
        v = rate * knots.jump + early_step * rise - step * turn
        return self._to_observable_coordinates(
            np.stack([q, v]) - self.late.reshape(2, -1, modes) * knots.jump
        )


@njit(cache=True, nogil=True)
def _step_bank(
    g: np.ndarray,
    one_per_mode: int,
    state: np.ndarray,
    step: np.ndarray,
    stops: np.ndarray,
    impulses: np.ndarray,
    out: np.ndarray,
) -> None:
    """Step the bank through samples g; `impulses` (2, j, m) act before the samples
    `stops`.

    Each mode has its own force if `one_per_mode` is 1; all modes share one force if it
    is 0. The operations at a sample do not depend on where a block starts, so the
    results are bit-identical for all block sizes."""
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
