"""Claim: the energy of a rattling disk balances by another quadrature; its contacts act on modes as
closed forms say; below the onset it moves as the other models of an elastic contact.

Source: dynamics/rattling. Oracle: forces, springs and powers computed again from positions and
velocities; Fourier series and frequencies of switched oscillators; the linear response of a rolling
disk and the motion on one ellipse.
"""

from functools import cache
from math import pi

import numpy as np
import pytest
from rattling_coin import RADIUS, coin, model_of, settle

from dynamics import plan_motion, simulate
from dynamics.compliant.law.unevenness import static_depth, unevenness
from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.model_selection import predicted_force_rms
from dynamics.disk import GRAVITY
from dynamics.rattling import layout
from dynamics.rattling.body import motion_state
from dynamics.rattling.rattling_motion import rigid_energy, rolling_state_at_release
from dynamics.rattling.time_loop import TimeSteps, step_rattling_disk
from dynamics.stepping_core.oscillators import exact_modes, write_propagator
from sonify.scene import from_document


def steps_of(model, state, seconds, per_sample=1):
    """Return the state (n, 5, 3) of a disk in the middle of every time step, or of each of
    several."""
    count = round(seconds * model.rate / per_sample)
    record = np.zeros(layout.RECORD_SIZE)
    record[layout.RECORD.flight_start] = -1.0
    samples = np.empty((count, state.size + layout.RECORD_SIZE))
    motion = motion_state(state, np.zeros((2, 0)), record, 0)
    flights = np.empty((count * per_sample, 3))
    options = (
        model.constants,
        model.edge(),
        model.table(),
        TimeSteps(1 / model.rate, per_sample, GRAVITY, 0.0, np.inf),
    )
    written, _, _ = step_rattling_disk(*options, motion, 0.0, samples, flights)
    assert written == count
    return samples[:, : state.size].reshape(count, *state.shape)


def springs_and_dashpots(model, state, reach=300):
    """Return the elastic energy (n,) [J] and the power of the dashpots (n,) [W] in states (n, 5, 3).

    The points of the rim within `reach` of the lowest one are examined.
    """
    disk = model.constants
    axis = state[:, layout.AXIS]
    reference = state[:, layout.RIM_REFERENCE_VECTOR]
    quarter_turn_vector = np.cross(axis, reference)
    sine = np.hypot(axis[:, 0], axis[:, 1])
    beta = np.arctan2(sine, axis[:, 2])
    cell = 2 * pi / len(model.heights)
    middle = np.round(
        np.arctan2(-quarter_turn_vector[:, 2], -reference[:, 2]) / cell
    ).astype(int)
    point = middle[:, None] + np.arange(-reach, reach + 1)
    cosine = np.cos(point * cell)
    sine_of = np.sin(point * cell)
    rise = cosine * reference[:, 2:] + sine_of * quarter_turn_vector[:, 2:]
    core = disk.radius - disk.fillet
    half = disk.half_thickness - disk.fillet
    height = state[:, layout.CENTRE, 2] - half * axis[:, 2] - disk.fillet
    depth = model.heights[point % len(model.heights)] - height[:, None] - core * rise
    momentum = state[:, layout.MOMENTUM]
    axial = np.sum(momentum * axis, axis=1)[:, None] * axis
    omega = (momentum - axial) / disk.diametral_inertia + axial / disk.axial_inertia
    horizontal = [
        core
        * (
            cosine * reference[:, i : i + 1]
            + sine_of * quarter_turn_vector[:, i : i + 1]
        )
        - half * axis[:, i : i + 1]
        for i in (0, 1)
    ]
    speed = omega[:, 1:2] * horizontal[0] - omega[:, :1] * horizontal[1]
    speed -= state[:, layout.VELOCITY, 2, None]
    curvature_radius = disk.radius / beta
    stiffness = disk.modulus * (curvature_radius * disk.fillet) ** 0.25
    stiffness *= cell * disk.radius / np.sqrt(2 * curvature_radius)
    pressed = depth > 0
    assert not pressed[:, [0, -1]].any()
    patch = (
        np.cumsum(pressed & ~np.roll(pressed, 1, axis=1)).reshape(depth.shape)[pressed]
        - 1
    )
    row = np.nonzero(pressed)[0]
    depths = np.bincount(patch, depth[pressed])
    points = 1.2 * depths**2 / np.bincount(patch, depth[pressed] ** 2)
    approach = np.bincount(patch, (depth * speed)[pressed]) / depths
    places = [
        np.bincount(patch, (depth * part)[pressed]) / depths for part in horizontal
    ]
    row = row[np.unique(patch, return_index=True)[1]]
    mobility = 1 / disk.mass + np.hypot(*places) ** 2 / disk.diametral_inertia
    dashpot = 2 * disk.damping_ratio * np.sqrt(stiffness[row] * points / mobility)
    force = np.maximum(dashpot * approach, -stiffness[row] * depths)
    stored = stiffness / 2 * np.sum(np.where(pressed, depth, 0.0) ** 2, axis=1)
    return stored, np.bincount(row, force * approach, len(state))


@pytest.mark.slow
@pytest.mark.parametrize("restitution", [0.5, 0.999999999])
def test_the_energy_balances_by_another_quadrature(restitution):
    """To 1e-6 of the initial energy, while impacts take 3e-3 of it.

    The dashpot of a patch starts within a step, which makes the error of the sum one of
    first order: 1.3e-6 and 0.8e-6 at 10 and 20 million steps per second.
    """
    scene = coin(3e-6, 1.0, restitution, 1, 0.1, "numerics.contact_rate=2e7")
    model = model_of(scene)
    release = rolling_state_at_release(model, 0.1, scene.release.omega)
    state = steps_of(model, release, 1e-3)
    stored, power = springs_and_dashpots(model, state)
    energy = rigid_energy(model, state) + stored
    balance = energy + (np.cumsum(power) - power / 2) / model.rate
    assert np.abs(balance / energy[0] - 1).max() < 1e-6
    assert (energy[-1] < 0.997 * energy[0]) == (restitution == 0.5)


def test_long_steps_above_the_table_miss_no_contact():
    """Every twelfth step, and long steps where a bound of the heights excludes contact."""
    scene = coin(1e-5, 1.0, 0.8, 1, 0.1, "numerics.contact_rate=1.2e6")
    model = model_of(scene)
    release = rolling_state_at_release(model, 0.1, scene.release.omega)
    short = steps_of(model, release.copy(), 6e-3)[11::12]
    long = steps_of(model, release, 6e-3, 12)
    bounces = np.sum(np.diff(np.sign(np.diff(long[:, layout.CENTRE, 2]))) > 0)
    assert bounces >= 3
    assert long == pytest.approx(short, rel=1e-7, abs=1e-9)


@cache
def coin_edge():
    return model_of(coin()).edge()


def propagator(frequency, decay, h):
    """Return the matrix (2, 2) of a mode over a time h [s], of its displacement and velocity."""
    one = np.array([frequency])
    out = np.empty((4, 1))
    write_propagator(exact_modes(one, np.array([decay]), 1 / h), h, out)
    return out.reshape(2, 2)


@pytest.mark.parametrize(
    ("decay", "depths"), [(100.0, (0.937, 0.513, 0.348)), (5.0, (0.053,))]
)
def test_envelope_of_a_mode_that_is_kicked_once_per_turn(decay, depths):
    """m_k = 2/sqrt(1 + (2 pi k f/sigma)^2) for a mode whose period divides the turn."""
    count = 7000
    turns = 30.0
    omega = 2 * pi * 350 * turns
    step = propagator(np.hypot(omega, decay), decay, 1 / turns / count)
    state = np.linalg.solve(np.eye(2) - np.linalg.matrix_power(step, count), [0.0, 1.0])
    amplitude = np.empty(count)
    for i in range(count):
        quadrature = (state[1] + decay * state[0]) / omega
        amplitude[i] = np.hypot(state[0], quadrature)
        state = step @ state
    waves = np.abs(np.fft.rfft(amplitude))
    found = 2 * waves[1 : len(depths) + 1] / waves[0]
    assert found == pytest.approx(depths, rel=0.01)


def test_contacts_at_random_shift_and_damp_a_mode():
    """+49.6 Hz and 80.8 1/s of simulations; 53 Hz and 83.3 1/s if a contact changes it little.

    K phi^2/omega^2 = 0.2 and c phi^2/omega = 0.05, closed for 100 us within 20 %, 5 % of the time.
    """
    random = np.random.default_rng(3)
    omega = 2 * pi * 10600.0
    closed = random.uniform(80e-6, 120e-6, 20000)
    opened = random.exponential(19 * 100e-6, 20000)
    state = np.array([1.0, 0.0])
    turned = 0.0
    logarithm = 0.0
    for lasts, frequency, decay in (
        pair
        for one, other in zip(closed, opened, strict=True)
        for pair in ((one, omega * np.sqrt(1.2), 0.025 * omega), (other, omega, 0.0))
    ):
        before = np.arctan2(-state[1] / omega, state[0])
        state = propagator(frequency, decay, lasts) @ state
        after = np.arctan2(-state[1] / omega, state[0])
        expected = frequency * lasts
        turned += (
            expected
            + np.angle(np.exp(1j * (after - before - expected)))
            - omega * lasts
        )
        size = np.hypot(state[1] / omega, state[0])
        logarithm -= np.log(size)
        state = state / size
    time = closed.sum() + opened.sum()
    assert turned / (2 * pi * time) == pytest.approx(49.6, abs=5.0)
    assert logarithm / time == pytest.approx(80.8, abs=6.0)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("ratio", "open_share", "tolerance"),
    [(1, 0.01, 0.01), (2, 0.06, 0.03), (5, 0.25, 0.04), (20, 0.47, 0.05)],
)
def test_share_of_time_without_contact_on_a_soft_table(ratio, open_share, tolerance):
    """E* = 4 GPa, delta = 0.312 um; means of four seeds."""
    depth = static_depth(0.0085 * GRAVITY, 4e9, RADIUS, 0.5e-3, 0.1)
    assert depth == pytest.approx(0.312e-6, rel=0.02)
    shares = []
    for seed in range(4):
        scene = coin(ratio * depth, 1.0, 0.5, seed, 0.105)
        model = model_of(scene)
        model = model._replace(constants=model.constants._replace(modulus=4e9))
        shares.append(settle(model, scene, 0.095, 0.25).open_share)
    assert np.mean(shares) == pytest.approx(open_share, abs=tolerance)


@pytest.mark.slow
@pytest.mark.parametrize("kappa", [0.1, 0.2])
def test_below_the_onset_the_other_models_agree(kappa):
    """On waves longer than the contact: the rms of the force from the linear response and from the
    motion on one ellipse; no contact is lost, and the inclination falls alike.
    """
    rms = kappa / 1.9886e5
    found = {}
    for kind in ("full", "many"):
        scene = coin(rms, 1.0, 0.5, 0, 0.105).document
        del scene["contact"]["restitution"]
        scene["contact"]["loss_factor"] = 0.3
        scene["numerics"] |= {"contact": kind, "time_limit": 0.3}
        scene["friction"]["mu_dynamic"] = 0.3
        scene["roughness"]["shortest"] = 2.65e-3
        scene = from_document(scene)
        motion = simulate(scene)
        load = motion.force(np.arange(0.05, 0.29, 2e-5))[:, 2] / scene.disk.weight
        lost = sum(loss.duration for loss in motion.contact_losses) / motion.t[-1]
        found[kind] = load.std(), lost, motion.inclination(np.array([0.29]))[0]
    plan = plan_motion(scene)
    linear = predicted_force_rms(plan, plan.tabulated_law)[1][0]
    assert unevenness(
        scene.disk, contact_law(scene), scene.roughness, 0.105
    ).curvature_number == (pytest.approx(kappa, rel=0.05))
    assert found["many"][0] == pytest.approx(linear, rel=0.2)
    assert found["many"][0] == pytest.approx(found["full"][0], rel=0.3)
    assert max(found["many"][1], found["full"][1]) < 2e-3
    assert found["many"][2] == pytest.approx(found["full"][2], rel=5e-3)
