"""Linear response of a rough contact along a rigid motion, without loss of contact.

Between knots the linearised contact is constant, and its response to heights that are
linear between samples is exact. Since the heights do not excite the rolling direction,
the state consists of four numbers: velocities and deflections along a_2 and a_3. The
deflection of an elastic table under the varying force is an additional height.
"""

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.integrate import trapezoid

from dynamics.compliant.law.driven_table import (
    DrivenTable,
    advance_table,
    driven_table,
    set_contact_circle,
)
from dynamics.compliant.law.height_profile import (
    SMOOTH_PROFILE,
    Profile,
    height_at,
    mean_height,
)
from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.law.roughness import ellipse_window, spectral_density
from dynamics.compliant.law.sections import Roughness
from dynamics.compliant.law.table_receptance import (
    RIGID_TABLE,
    TableReceptance,
    mean_square_response,
)
from dynamics.compliant.law.tabulated import TabulatedLaw
from dynamics.numba_kernels import kernel, outermost

if TYPE_CHECKING:
    from dynamics.compliant.law.linearised import LinearContact
    from dynamics.motion import Motion

SAMPLES_PER_KNOT = 16
"""Number of force samples between two knots."""
FILTER_STATES = [1, 2, 4, 5]
"""Indices in the state of `LinearContact`: velocities and deflections along a_2 and a_3."""
MAX_PHASE_PER_STEP = 2.0
"""Largest phase of the fastest resonance in one step [rad]."""
MIN_VIBRATION_FREQUENCY = 200.0
"""Frequency [Hz] that separates contact vibration from the motion of the disk."""


class MotionBlock(NamedTuple):
    """A rigid motion at equidistant knots.

    Attributes
    ----------
    t : (k,) array
        Times [s].
    inclination, load : (k,) arrays
        Inclination [rad] and normal force [N].
    rolls : (k,) array of bool
        True if the disk rolls.
    path, edge : (k,) arrays
        Path lengths of the contact on the table and on the edge [m].
    jumps : (k, 2) array
        Jumps of the force along a_2 and a_3 since the last knot [N].
    azimuth : (k,) array
        Direction of the contact from the centre of the disk [rad].
    centre : (2,) array
        Mean position of the centre of the disk since the release [m].
    """

    t: np.ndarray
    inclination: np.ndarray
    load: np.ndarray
    rolls: np.ndarray
    path: np.ndarray
    edge: np.ndarray
    jumps: np.ndarray
    azimuth: np.ndarray
    centre: np.ndarray


def motion_blocks(
    motion: "Motion", rate: float, start: float = 0.0, stop: float | None = None
) -> Iterator[MotionBlock]:
    """Yield the motion as MotionBlocks, which share their end knots.

    `rate` [1/s] is that of the samples. The contact advances by -R d(spin) along the
    edge, and by this distance minus the slip along the table. The last block ends at
    MIN_CONTACT_INCLINATION at the latest.
    """
    knots_per_block = 2048
    last = motion.t[np.flatnonzero(motion.state[:, 1] >= MIN_CONTACT_INCLINATION)[-1]]
    if stop is not None:
        last = min(last, stop)
    knots = int(np.floor((last - start) * rate / SAMPLES_PER_KNOT))
    path = 0.0
    jumps = motion.jumps
    for first in range(0, knots, knots_per_block):
        end = min(first + knots_per_block, knots)
        t = start + np.arange(first, end + 1) * (SAMPLES_PER_KNOT / rate)
        state, force = motion.at_and_force(t)
        edge = -motion.disk.radius * state[:, 2]
        slip = state[:, 8]
        mean_slip = (slip[1:] + slip[:-1]) / 2
        slid = np.append(0.0, np.cumsum(mean_slip)) * (SAMPLES_PER_KNOT / rate)
        rolls = np.char.startswith(motion.regime(t), "roll")
        change = np.zeros((len(t), 2))
        here = (jumps.t > t[0] - SAMPLES_PER_KNOT / rate) & (jumps.t <= t[-2])
        knot = np.searchsorted(t, jumps.t[here])
        np.add.at(change, knot, (jumps.after - jumps.before)[here, 1:])
        yield MotionBlock(
            t,
            state[:, 1],
            force[:, 2],
            rolls,
            edge + path - slid,
            edge,
            change,
            state[:, 0] + np.pi / 2,
            state[:, 3:5].mean(axis=0),
        )
        path -= slid[-1]


def linear_contact_force_blocks(
    tabulated: TabulatedLaw,
    blocks: Iterable[MotionBlock],
    rate: float,
    profiles: tuple[Profile, Profile] = (SMOOTH_PROFILE, SMOOTH_PROFILE),
    modes: Any = None,
    plate_mobility: float = 0.0,
) -> Iterator[np.ndarray]:
    """Yield the additional force of an elastic, rough contact along a_2 and a_3.

    Parameters
    ----------
    tabulated : TabulatedLaw
        Tabulated contact law.
    blocks : iterable of MotionBlock
        The rigid motion.
    rate : float
        Sample rate [1/s]; sample i of a block is at t[0] + (i + 1)/rate.
    profiles : (Profile, Profile)
        Heights of table and edge.
    modes : modal.SurfaceModes, optional
        Modes of a table that yields to the varying force.
    plate_mobility : float, optional
        Mobility of an infinite plate that yields to it [s/kg].

    Yields
    ------
    (n, 2) array
        Force [N] along a_2 and a_3 of each block.

    Raises
    ------
    ValueError
        If the phase of a resonance changes too much in one step; the message states the
        required rate.
    """
    x = np.zeros(4)
    z = np.nan
    yielding = driven_table(modes, 1 / rate, plate_mobility)
    radius = tabulated.law.disk.radius - tabulated.law.rolling_fillet
    for block in blocks:
        system = _coefficients(tabulated, block, rate)
        if np.isnan(z):
            half_length, path, edge = system[0][0, :3]
            heights, rim = profiles
            z = height_at(heights, path, half_length)
            z += height_at(rim, edge, half_length)
        if modes is not None:
            set_contact_circle(yielding, modes, modes.place + block.centre, radius)
        out, x, z = _filter_steps(
            x, z, system, 1 / rate, profiles, yielding, block.azimuth
        )
        yield out


def _coefficients(
    tabulated: TabulatedLaw, block: MotionBlock, rate: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return the coefficients of `_filter_steps`.

    Those at the knots (k, 13) are a, path, edge, and C and D of the force along a_2 and
    a_3. Those between knots are A (k - 1, 4, 4), B, and the deflections caused by jumps
    of the force.
    """
    rolls = block.rolls[1:] & block.rolls[:-1]
    speed = np.diff(block.path) / np.diff(block.t)
    inclination = (block.inclination[1:] + block.inclination[:-1]) / 2
    load = (block.load[1:] + block.load[:-1]) / 2
    system = tabulated.linear_contact(inclination, load, speed, rolls)
    A = system.A[:, FILTER_STATES][:, :, FILTER_STATES]
    B = system.B[:, FILTER_STATES]
    square = np.abs(A[:, 0, 2]) + np.abs(A[:, 1, 3])
    fastest = np.sqrt(square).max() / MAX_PHASE_PER_STEP
    if fastest > rate:
        raise ValueError(
            f"rate = {rate:g}: too low for the stiffness of the contact, must be at least "
            f"{fastest:.4g} 1/s"
        )
    springs, a, _ = tabulated.springs(block.inclination, block.load)
    there = tabulated.linear_contact(
        block.inclination, block.load, np.append(speed, speed[-1]), block.rolls
    )
    forces = np.concatenate(
        [there.C[:, 1:, FILTER_STATES], there.D[:, 1:, None]], axis=2
    )
    knots = np.column_stack([a, block.path, block.edge, forces.reshape(len(a), -1)])
    drive = np.column_stack(
        [
            np.where(rolls, block.jumps[:-1, 0] / springs.k2[:-1], np.nan),
            block.jumps[:-1, 1] / springs.kn[:-1],
        ]
    )
    return knots, np.ascontiguousarray(A), np.ascontiguousarray(B), drive


def predicted_rms(
    tabulated: TabulatedLaw,
    roughness: Roughness,
    inclination: np.ndarray,
    load: float | np.ndarray,
    speed: float | np.ndarray,
    above: float = MIN_VIBRATION_FREQUENCY,
    receptance: TableReceptance = RIGID_TABLE,
) -> np.ndarray:
    """Return the rms (k,) [N] of the force above a frequency [Hz] in steady motion.

    It is computed from the spectrum of the heights. The contact moves along table and
    edge at `speed` (k,) [m/s]; `receptance` is that of the table.
    """
    k = spectral_density(roughness, tabulated.law.disk.radius)[0]
    mean_squares = []
    for beta, force, velocity in np.broadcast(inclination, load, np.abs(speed)):
        f = k * velocity / (2 * np.pi)
        power = predicted_spectrum(
            tabulated, roughness, beta, force, velocity, f, receptance=receptance
        )
        mean_squares.append(trapezoid(power * (f > above), f))
    return np.sqrt(mean_squares)


def predicted_power(
    tabulated: TabulatedLaw,
    roughness: Roughness,
    inclination: float | np.ndarray,
    load: float | np.ndarray,
    speed: float | np.ndarray,
    receptance: TableReceptance = RIGID_TABLE,
) -> np.ndarray:
    """Return the mean power (k,) [W] dissipated by roughness in steady motion.

    It is the mean of N' dz/dt with the height z, computed as the integral of the
    spectrum of z times omega Im(N'/z). Contact, disk and table dissipate it.
    """
    k, heights = spectral_density(roughness, tabulated.law.disk.radius)
    powers = []
    for steady in np.broadcast(inclination, load, np.abs(speed)):
        beta, force, velocity = np.reshape(steady, (3, 1))
        a = tabulated.springs(beta, force)[1]
        _, response = _responses(
            tabulated, beta, force, velocity, k * velocity, True, receptance
        )
        power = heights * ellipse_window(k * a) ** 2 * k * velocity * response.imag
        powers.append(trapezoid(power, k))
    return np.array(powers)


def predicted_spectrum(
    tabulated: TabulatedLaw,
    roughness: Roughness,
    inclination: float,
    load: float,
    speed: float,
    frequency: np.ndarray,
    rolls: bool = True,
    receptance: TableReceptance = RIGID_TABLE,
) -> np.ndarray:
    """Return the power spectral density (f,) [N^2/Hz] of the force in a steady motion.

    The frequencies are (f,) [Hz].
    """
    beta, force, velocity = np.array([[inclination], [load], [speed]])
    a = tabulated.springs(beta, force)[1]
    omega = 2 * np.pi * frequency
    k = omega / abs(speed)
    spectrum = spectral_density(roughness, tabulated.law.disk.radius)
    heights = np.interp(k, *spectrum, left=0.0, right=0.0) * ellipse_window(k * a) ** 2
    square, _ = _responses(tabulated, beta, force, velocity, omega, rolls, receptance)
    return heights * square * 2 * np.pi / abs(speed)


def _responses(
    tabulated: TabulatedLaw,
    beta: np.ndarray,
    force: np.ndarray,
    velocity: np.ndarray,
    omega: np.ndarray,
    rolls: bool,
    receptance: TableReceptance,
) -> tuple[np.ndarray, np.ndarray]:
    """Return the means of |N'/z|^2 and of N'/z (f,) round the contact circle."""
    system = tabulated.linear_contact(beta, force, velocity, rolls)
    rate = float(np.abs(velocity / tabulated.law.place(beta).f)[0])
    on_rigid_table = force_per_height(system, omega)
    return mean_square_response(on_rigid_table, receptance(omega, rate))


def force_per_height(system: "LinearContact", omega: np.ndarray) -> np.ndarray:
    """Return N'/z (f,) [N/m] of a linearised contact at angular frequencies (f,) [rad/s]."""
    roots, vectors = np.linalg.eig(system.A[0][np.ix_(FILTER_STATES, FILTER_STATES)])
    weight = (system.C[0, 2, FILTER_STATES] @ vectors) * np.linalg.solve(
        vectors, system.B[0, FILTER_STATES].astype(complex)
    )
    s = 1j * omega
    return s * ((weight / (s[:, None] - roots)).sum(axis=1) + system.D[0, 2])


@kernel
def _propagator(A: np.ndarray, B: np.ndarray, h: float) -> np.ndarray:
    """Return [exp(A h), mean of exp(A s) B over a step] (4, 5) from a Taylor series."""
    # number of terms, exact within rounding up to MAX_PHASE_PER_STEP
    taylor_terms = 20
    total = np.empty((4, 5))
    term = np.empty((4, 5))
    next_term = np.empty((4, 5))
    for i in range(4):
        for j in range(5):
            term[i, j] = A[i, j] * h if j < 4 else B[i]
            total[i, j] = term[i, j] + (1.0 if i == j else 0.0)
    for n in range(2, taylor_terms):
        for i in range(4):
            for j in range(5):
                value = 0.0
                for m in range(4):
                    value += A[i, m] * term[m, j]
                next_term[i, j] = value * h / n
                total[i, j] += next_term[i, j]
        term, next_term = next_term, term
    return total


@outermost
def _filter_steps(
    x: np.ndarray,
    z: float,
    system: tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray],
    h: float,
    profiles: tuple[Profile, Profile],
    yielding: DrivenTable,
    azimuth: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, float]:
    """Return the force (n, 2) in a block, the last state and the last height.

    The `system` contains the `_coefficients`. NaN in `drive` along a_2 marks a sliding
    contact without a tangential spring. The table `yielding` is advanced in place.
    """
    knots, A, B, drive = system
    table, rim = profiles
    out = np.empty((SAMPLES_PER_KNOT * len(A), 2))
    next_x = np.empty(4)
    coefficients = np.empty(13)
    for j in range(len(A)):
        E = _propagator(A[j], B[j], h)
        slides = np.isnan(drive[j, 0])
        x[2] = 0.0 if slides else x[2] + drive[j, 0]
        x[3] += drive[j, 1]
        for i in range(SAMPLES_PER_KNOT):
            f = (i + 1) / SAMPLES_PER_KNOT
            for m in range(13):
                coefficients[m] = knots[j, m] + f * (knots[j + 1, m] - knots[j, m])
            half_length = coefficients[0]
            table_height = mean_height(table, coefficients[1], half_length)
            rise = table_height + mean_height(rim, coefficients[2], half_length) - z
            z += rise
            direction = azimuth[j] + f * (azimuth[j + 1] - azimuth[j])
            rise += advance_table(yielding, direction)
            if yielding.plate_mobility > 0.0:
                rise = _rise_relative_to_infinite_plate(
                    rise, yielding, x, E, coefficients[8:], h
                )
            for m in range(4):
                next_x[m] = (
                    E[m, 0] * x[0]
                    + E[m, 1] * x[1]
                    + E[m, 2] * x[2]
                    + E[m, 3] * x[3]
                    + E[m, 4] * rise
                )
            x, next_x = next_x, x
            for m in range(2):
                c = coefficients[3 + 5 * m : 8 + 5 * m]
                out[SAMPLES_PER_KNOT * j + i, m] = (
                    c[0] * x[0]
                    + c[1] * x[1]
                    + c[2] * x[2]
                    + c[3] * x[3]
                    + c[4] * rise / h
                )
            if slides:
                out[SAMPLES_PER_KNOT * j + i, 0] = 0.0
            yielding.force[0] = out[SAMPLES_PER_KNOT * j + i, 1]
    return out, x, z


@kernel
def _rise_relative_to_infinite_plate(
    rise: float,
    yielding: DrivenTable,
    x: np.ndarray,
    E: np.ndarray,
    normal: np.ndarray,
    h: float,
) -> float:
    """Return the rise minus the motion of an infinite plate in the step h.

    The plate moves by Y h times the mean of the forces N' before and after the step. The
    latter is linear in the rise, with the coefficients `normal` (5,) of the state.
    """
    still = 0.0
    gain = normal[4] / h
    for m in range(4):
        row = 0.0
        for n in range(4):
            row += E[m, n] * x[n]
        still += normal[m] * row
        gain += normal[m] * E[m, 4]
    half = yielding.plate_mobility * h / 2
    return (rise - half * (yielding.force[0] + still)) / (1 + half * gain)
