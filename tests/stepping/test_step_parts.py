"""Claim: each part of a time step solves its own small problem exactly, whatever the step.

Source: the docstrings of dynamics/compliant/stepping (normal, tangential, table_modes) and of
dynamics/rattling (rim_contacts, resistance, air_impulses). Oracle: closed forms: the parabola of a
free fall, the regular precession of a free top, the damped oscillator, the exponential decay under
a film, Coulomb's moment, and the mean of a linear depth. The functions run without compilation.
"""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from interpreted import interpret_dynamics
from scipy.integrate import quad
from scipy.spatial.transform import Rotation

from dynamics import plan_motion
from dynamics.air import Air
from dynamics.compliant.compliant_motion import compliant_model
from dynamics.compliant.modes_from_scene import modes_from_numbers
from dynamics.compliant.state_conversion import (
    energy,
    limit_energy,
    preloaded_compliant_state,
)
from dynamics.compliant.stepping import (
    contact_energy,
    normal,
    table_modes,
    tangential,
)
from dynamics.compliant.stepping.model import CompiledModel
from dynamics.compliant.stepping.state_layout import STATE, STATE_SLICES
from dynamics.film import film_kernels
from dynamics.film.wedge import film_in_si_units, film_under
from dynamics.rattling import air_impulses, layout, resistance, rim_contacts
from dynamics.rattling.rattling_motion import rattling_model
from dynamics.stepping_core.rim_modes import NO_RIM_MODES
from dynamics.surface import ModesSurface, SurfaceMode
from dynamics.switching import ImpossibleContactError
from sonify import load_scene

STEP = 1e-3
"""A step [s] much longer than those of a motion."""


@pytest.fixture(autouse=True)
def interpreted(monkeypatch):
    interpret_dynamics(monkeypatch)


@pytest.fixture(scope="module")
def plan():
    return plan_motion(
        load_scene("published").replace(
            "contact.law=elastic", "contact.body=rigid", "numerics.contact=full"
        )
    )


@pytest.fixture(scope="module")
def model(plan):
    return compliant_model(plan)


@pytest.fixture
def state(model):
    """A tilted disk that turns about all three axes, on its contact."""
    return preloaded_compliant_state(
        model, np.array([0.4, 0.3, 0, 0, 0, 0.5, 2.0, -9.0, 0, 0, 0.0])
    )


def step_normal(model, y, h):
    compiled = CompiledModel(
        model.constants, np.zeros((0, 2)), model.cubics, *model.profiles
    )
    contact_energy.update_law_interval(y, compiled.law)
    assert normal.step_normal(y, compiled, h)


def test_without_contact_the_normal_step_is_a_parabola_and_a_regular_precession(
    model, state
):
    """The axis turns about the angular momentum by 2 atan(h L/2J), instead of h L/J."""
    state[STATE.position + 2] += 0.01
    state[STATE.gap] += 0.01
    before = state.copy()
    step_normal(model, state, STEP)
    fixed = model.constants
    gravity = [0, 0, -fixed.weight / fixed.mass]
    velocity = before[STATE_SLICES.velocity]
    assert state[STATE.normal_force] == 0
    assert state[STATE_SLICES.velocity] == pytest.approx(
        velocity + np.multiply(gravity, STEP)
    )
    assert state[STATE_SLICES.position] == pytest.approx(
        before[STATE_SLICES.position]
        + STEP * velocity
        + np.multiply(gravity, STEP**2 / 2)
    )
    momentum = before[STATE_SLICES.angular_momentum]
    assert state[STATE_SLICES.angular_momentum] == pytest.approx(momentum)
    size = np.linalg.norm(momentum)
    turn = 2 * np.arctan(STEP * size / (2 * fixed.diametral_inertia))
    turned = Rotation.from_rotvec(turn * momentum / size)
    assert state[STATE_SLICES.axis] == pytest.approx(
        turned.apply(before[STATE_SLICES.axis]), rel=1e-12
    )


@pytest.mark.parametrize("h", [1e-6, 1e-5, 4e-5])
def test_the_normal_step_balances_the_energy_of_a_compressed_contact(model, state, h):
    state[STATE.velocity + 2] -= 0.01
    first = energy(model, state[None])[0]
    step_normal(model, state, h)
    lost = state[STATE.contact_loss]
    assert lost > 0
    assert energy(model, state[None])[0] + lost == pytest.approx(first, rel=1e-12)


def table_mode(frequency=60.0, damping=0.05):
    mode = SurfaceMode(
        order=2, frequency=frequency, damping_ratio=damping, modal_mass=2.0
    )
    return modes_from_numbers(ModesSurface(modes=(mode,)), 0.03755)


def test_a_free_table_mode_is_the_exact_damped_oscillator_at_steps_of_a_third_of_its_period():
    modes = table_modes.modes_at_rest(table_mode(), 1 / 180, NO_RIM_MODES)
    omega = 2 * np.pi * 60.0
    pole = omega * (-0.05 + 1j * np.sqrt(1 - 0.05**2))
    midpoint_pole = 2 * 180 * np.tanh(pole / 360)
    start = 1e-6 * np.exp(0.7j)
    modes.amplitude[:] = start.real
    modes.velocity[:] = (start * midpoint_pole).real
    first, _ = table_modes.mode_energies(modes)
    lost = 0.0
    for n in range(1, 8):
        table_modes.predict_free_motion(modes, 1 / 180)
        lost += table_modes.advance_modes(modes, 0.0, 1 / 180)[0]
        assert modes.amplitude == pytest.approx((start * np.exp(pole * n / 180)).real)
    last, _ = table_modes.mode_energies(modes)
    assert first - last == pytest.approx(lost)
    assert last < 0.2 * first


def test_a_force_does_the_work_that_a_table_mode_stores_and_loses():
    modes = table_modes.modes_at_rest(table_mode(), STEP, NO_RIM_MODES)
    modes.shape_before[:] = 0.3
    modes.shape_after[:] = 0.7
    modes.velocity[:] = 2e-3
    first, _ = table_modes.mode_energies(modes)
    place = modes.amplitude.copy()
    table_modes.predict_free_motion(modes, STEP)
    lost, _ = table_modes.advance_modes(modes, 4.0, STEP)
    work = -4.0 * 0.5 * np.sum(modes.amplitude - place)
    last, _ = table_modes.mode_energies(modes)
    assert last - first + lost == pytest.approx(work, rel=1e-12)


def test_the_film_holds_a_table_mode_at_the_static_deflection_of_the_contact(
    model, state
):
    """q = -F w/omega^2, whether the contact bears F, or half of it, or the film alone."""
    h = 1e-5
    force = 4.0
    modes = table_modes.modes_at_rest(table_mode(), h, NO_RIM_MODES)
    for shapes in (modes.shape_before, modes.shape_after, modes.film_shape):
        shapes[:] = 0.7
    line = tangential.FilmLine(
        tangential.PlaceOfContact(1.0, 0.0, 0.3, 0.03, 0.0, 0.3), 0.02
    )
    static = -force * 0.7 / (2 * np.pi * 60.0) ** 2
    modes.amplitude[:] = static
    for by_film in (0.0, 0.5, 1.0):
        impulse = by_film * force * h / 2
        for _ in range(5):
            tangential.push_apart(state, model.constants, modes, line, 0.01, impulse)
            table_modes.predict_free_motion(modes, h)
            table_modes.advance_modes(modes, (1 - by_film) * force, h)
            tangential.push_apart(state, model.constants, modes, line, 0.01, impulse)
            assert modes.amplitude == pytest.approx(static, rel=1e-5)


def test_a_coupled_table_starts_in_its_steady_response_to_the_precession(plan, model):
    """q = A exp(i n theta), A = -P w/(omega^2 - (n Omega)^2 + 2 i zeta omega n Omega), where w is
    the shape under the contact."""
    beta = 0.1
    rate = -80.0
    waves = table_mode(damping=0.2)
    y = preloaded_compliant_state(
        model, np.array([0.4, beta, 0, 0, 0, 0, 0, rate * np.sin(beta), 0, 0, 0.0])
    )
    moving = replace(model, modes=waves, rate=1e6)
    modes = moving.supporting_modes(y)
    angle = modes.contact[table_modes.CONTACT.angle]
    omega = 2 * np.pi * 60.0
    turning = 2 * rate
    denominator = omega**2 - turning**2 + 0.4j * omega * turning
    # the response to the weight on a cosine under the contact, and on the sine beside it
    here = -model.constants.weight / denominator
    shape = np.hypot(*modes.shape_before)
    turned = (modes.amplitude[0] + 1j * modes.amplitude[1]) * np.exp(-2j * angle)
    speed = (modes.velocity[0] + 1j * modes.velocity[1]) * np.exp(-2j * angle)
    assert turned == pytest.approx(here * shape, rel=1e-3)
    assert speed == pytest.approx(1j * turning * here * shape, rel=1e-3)


def test_a_disk_put_on_its_springs_has_three_fifths_of_the_work_of_its_weight_less(
    model,
):
    """The weight does the work W d, of which Hertz's contact stores 2/5."""
    start = np.array([0.4, 0.3, 0, 0, 0, 0, 0, 0, 0, 0, 0.0])
    weight = model.constants.weight
    free, loaded = (
        preloaded_compliant_state(model, start, np.array([0, 0, force]))
        for force in (1e-12, weight)
    )
    depth = -loaded[STATE.gap]
    stiffness = float(model.tabulated_law.stiffness(np.log(np.sin([0.3])))[0])
    assert depth == pytest.approx((weight / stiffness) ** (2 / 3), rel=1e-6)
    step = np.diff(energy(model, np.array([free, loaded])))[0]
    assert step == pytest.approx(-0.6 * weight * depth, rel=1e-3)


def test_a_hand_over_that_must_not_gain_energy_slows_all_velocities_by_one_factor(
    model, state
):
    before = state.copy()
    total = energy(model, state[None])[0]
    moving = kinetic_energy(model.constants, state)
    limit_energy(model, state, total + 1.0)
    assert np.array_equal(state, before)
    limit_energy(model, state, total - moving / 4)
    factor = np.sqrt(3 / 4)
    for part in (STATE_SLICES.velocity, STATE_SLICES.angular_momentum):
        assert state[part] == pytest.approx(factor * before[part])
    assert energy(model, state[None])[0] == pytest.approx(total - moving / 4)
    with pytest.raises(ImpossibleContactError, match="bending the table"):
        limit_energy(model, state, total - 2 * moving)


def kinetic_energy(constants, y):
    momentum = y[STATE_SLICES.angular_momentum]
    spin = momentum @ y[STATE_SLICES.axis]
    turning = momentum @ momentum / constants.diametral_inertia
    turning += constants.inverse_inertia_excess * spin**2
    velocity = y[STATE_SLICES.velocity]
    return (constants.mass * velocity @ velocity + turning) / 2


@pytest.mark.parametrize("size", [1e-7, 1.0])
def test_a_resisting_moment_takes_its_work_and_at_most_stops_the_rotation(
    model, state, size
):
    fixed = model.constants
    J = fixed.diametral_inertia
    e = fixed.inverse_inertia_excess
    axis = state[STATE_SLICES.axis]
    upward = np.array([0.0, 0.0, 1.0])

    def rate():
        momentum = state[STATE_SLICES.angular_momentum]
        return momentum[2] / J + e * axis[2] * (axis @ momentum)

    before = rate()
    first = kinetic_energy(fixed, state)
    tangential.apply_angular_impulse(
        state, upward, size, 0.0, J, e, STATE.moment_loss, 0.0
    )
    mobility = 1 / J + e * axis[2] ** 2
    slower = np.sign(before) * max(abs(before) - size * mobility, 0.0)
    assert rate() == pytest.approx(slower, abs=1e-12)
    lost = first - kinetic_energy(fixed, state)
    assert state[STATE.moment_loss] == pytest.approx(lost, rel=1e-9)


@pytest.fixture(scope="module")
def film(plan):
    """The film in air so stiff that it is displaced, not compressed."""
    disk = plan.scene.disk
    return film_in_si_units(film_under(disk, Air(pressure=1e12)), disk)


def settling(model, state, beta, fall):
    """Set a disk that falls about its contact and precesses slowly."""
    state[:] = preloaded_compliant_state(
        model, np.array([0.4, beta, 0, 0, 0, fall, 0.0, -0.5 * beta, 0, 0, 0.0])
    )


def place_at(y, constants):
    """Return the place of the contact as far as the film needs it."""
    horizontal = y[STATE.axis : STATE.axis + 2]
    sine = np.hypot(*horizontal)
    reach = constants.core_radius * y[STATE.axis + 2] - constants.core_depth * sine
    return tangential.PlaceOfContact(*horizontal / sine, sine, reach, 0.0, sine)


@pytest.mark.parametrize("h", [1e-6, 1e-3, 1.0])
def test_the_film_slows_the_fall_exponentially_and_takes_its_energy(
    model, state, film, h
):
    beta = 2e-3
    settling(model, state, beta, 0.1)
    fixed = model.constants._replace(film=film)
    place = place_at(state, fixed)
    _, fall, lever, _, lift = tangential.film_loads(film, np.sin(beta), 0.5)
    assert lift < 1e-9 * fixed.weight * fixed.radius
    lever /= fixed.radius
    arm = place.reach - 1 / lever
    before, mobility = tangential.face_velocity_and_mobility(state, fixed, place, arm)
    first = kinetic_energy(fixed, state)
    tangential.apply_film_impulses(state, fixed, None, place, h)
    after, _ = tangential.face_velocity_and_mobility(state, fixed, place, arm)
    decay = np.exp(-h * lever**2 * fall * mobility)
    assert after == pytest.approx(before * decay, rel=1e-6, abs=1e-9 * abs(before))
    lost = first - kinetic_energy(fixed, state)
    assert state[STATE.film_loss] == pytest.approx(lost, rel=1e-6)


@pytest.mark.parametrize("speed", [-0.2, 0.0, 0.3])
@pytest.mark.parametrize("impulse", [1e-3, 1.0])
def test_compressed_air_does_at_most_the_work_of_its_energy(speed, impulse):
    """A mass of 1/mobility gains the kinetic energy that the air returns."""
    mass = 0.4
    given, work = film_kernels.compressed_air_impulse(impulse, speed, 1 / mass, 2e-3)
    gain = mass / 2 * ((speed + given / mass) ** 2 - speed**2)
    assert work == pytest.approx(gain, rel=1e-9)
    if impulse == 1.0:
        assert work == pytest.approx(2e-3)
    else:
        assert given == impulse
        assert work < 2e-3


def test_a_contact_that_opens_under_the_full_lift_leaves_the_table_at_rest(
    model, state, film
):
    """The same film presses on the table before and after, and holds it where it is."""
    h = 1e-6
    beta = 2e-3
    settling(model, state, beta, 0.1)
    fixed = model.constants._replace(film=film)
    place = place_at(state, fixed)
    modes = table_modes.modes_at_rest(table_mode(), h, NO_RIM_MODES)
    basis = np.zeros((3, 4)), np.zeros((3, 4))
    for shapes in (modes.shape_before, modes.shape_after):
        table_modes.store_table_shapes(
            modes.table, place.reach * place.d0, place.reach * place.d1, *basis, shapes
        )

    def press(gap):
        """Apply the film for half a step; return its force on the disk."""
        y = state.copy()
        y[STATE.gap] = gap
        tangential.apply_film_impulses(y, fixed, modes, place, h / 2)
        return (y - state)[STATE.velocity + 2] * fixed.mass / (h / 2)

    lift = press(0.0)
    modes.velocity[:] = 0.0
    static = -lift * modes.film_shape / modes.stiffness
    modes.amplitude[:] = static
    for gap in (-1e-9, 1e-9):
        for _ in range(10):
            press(gap)
            table_modes.predict_free_motion(modes, h)
            table_modes.advance_modes(modes, 0.0, h)
            assert press(gap) == pytest.approx(lift, rel=1e-4)
        assert modes.amplitude == pytest.approx(static, rel=1e-6)
        kick = lift * modes.film_shape * h / 2
        assert modes.velocity == pytest.approx(0, abs=1e-2 * np.abs(kick).max())


@pytest.mark.parametrize("eps", [0.3, 0.8, 0.99])
def test_two_forces_have_the_resistance_of_an_open_film(eps):
    """Force and moment about the low point, for a rise of the disk and for a fall about it."""
    heave, about, fall, across = film_kernels.open_film(eps)
    _, closed_about, closed_fall, closed_across = film_kernels.open_film(1.0)
    turning, falling, levers, at_low_point = film_kernels.film_opening(eps)
    lever = closed_about / closed_fall * levers
    at_centre = lever**2 * closed_fall * falling
    assert at_centre + at_low_point * closed_fall == pytest.approx(heave)
    assert at_centre / lever == pytest.approx(about)
    assert at_centre / lever**2 == pytest.approx(fall)
    assert turning * closed_across == pytest.approx(across)


def rattling_velocity(constants, y):
    momentum = y[STATE_SLICES.angular_momentum]
    axis = y[STATE_SLICES.axis]
    spin = momentum / constants.diametral_inertia
    spin = spin + constants.inverse_inertia_excess * (momentum @ axis) * axis
    return SimpleNamespace(linear=y[STATE_SLICES.velocity], angular=spin)


@pytest.mark.parametrize("clearance", [0.0, 20e-6, 300e-6])
def test_both_models_have_the_same_film_under_a_disk_on_or_above_its_sharp_edge(
    plan, state, film, clearance
):
    contact = replace(plan.scene.contact, fillet=1e-5)
    plan = plan.part(contact=contact)
    model = compliant_model(plan)
    beta = 2e-3
    settling(model, state, beta, 0.1)
    fixed = model.constants._replace(film=film)
    many = rattling_model(plan).constants._replace(film=film)
    axis = state[STATE_SLICES.axis]
    d0, d1 = axis[:2] / np.sin(beta)
    up_slope = np.array([-d0 * np.cos(beta), -d1 * np.cos(beta), np.sin(beta)])
    load = air_impulses.film_load(
        many, axis, up_slope, rattling_velocity(fixed, state), clearance, 0.0, 1e-9
    )
    state[STATE.gap] = clearance
    before = state.copy()
    tangential.apply_film_impulses(state, fixed, None, place_at(state, fixed), 1e-9)
    pressure = (state - before)[STATE.velocity + 2] * fixed.mass / 1e-9
    turning = (state - before)[STATE_SLICES.angular_momentum] / 1e-9
    assert load.pressure == pytest.approx(pressure, rel=3e-3)
    assert load.drag == pytest.approx(turning @ up_slope, rel=1e-3)
    raising = turning @ np.cross(up_slope, axis)
    assert load.pressure * load.place + load.righting == pytest.approx(
        raising, abs=1e-3 * pressure * fixed.radius
    )


@pytest.mark.parametrize("depth", [-2.0, -0.4, 0.0, 0.4, 2.0])
def test_the_mean_penetration_is_the_mean_of_a_depth_that_changes_evenly(depth):
    for travel in (1.0, -1.0):
        mean, _ = quad(
            lambda x, travel=travel: max(depth + x * travel, 0.0),
            -0.5,
            0.5,
            points=[-depth / travel] if abs(depth) < 0.5 else None,
        )
        assert rim_contacts.mean_penetration(depth, travel) == pytest.approx(mean)


@pytest.mark.parametrize("depth", [-0.4, 0.1, 2.0])
def test_springs_do_the_work_that_their_energy_loses_over_a_step(depth):
    """The force of a unit spring at the mean penetration, times its travel, is the change of
    its energy; the mean square at both ends is twice the mean of the energies."""
    first = max(depth - 0.5, 0.0)
    last = max(depth + 0.5, 0.0)
    work = rim_contacts.mean_penetration(depth, 1.0) * 1.0
    assert work == pytest.approx((last**2 - first**2) / 2)
    mean = rim_contacts.mean_square_end_depth(depth, 1.0)
    assert mean == pytest.approx((first**2 + last**2) / 2)


def resisted(plan, beta, load, angular, **moments):
    """Return the torque that resists an angular velocity (3,) under a load, and the diametral
    inertia."""
    none = {"arms": (0.0,) * 3, "contour_moment": 0.0, "spin_friction": (0.0,) * 15}
    constants = rattling_model(plan).constants._replace(**none | moments)
    s, c = np.sin(beta), np.cos(beta)
    axis = np.array([0.0, s, c])
    rim = SimpleNamespace(axis=axis, sine=s, upright=c, inclination=beta)
    force = np.zeros((5, 3))
    force[layout.ELASTIC, 2] = load
    contacts = SimpleNamespace(force=force, torque=np.zeros((5, 3)))
    velocity = SimpleNamespace(angular=angular)
    pressed = SimpleNamespace(disk=constants, contacts=contacts)
    resistance.add_resistance(pressed, rim, velocity, 0.0, 4.3, STEP)
    return contacts.torque[layout.RESISTANCE], constants.diametral_inertia


@pytest.mark.parametrize("arm", ["nutation", "rolling", "pivoting"])
@pytest.mark.parametrize("load", [4.0, 1e9])
def test_the_arms_of_a_rattling_disk_are_coulombs_moments(plan, arm, load):
    """Each opposes its rotation with the arm times the normal force, or stops it in the step."""
    place = ("nutation", "rolling", "pivoting").index(arm)
    direction = np.eye(3)[place]
    arms = tuple(1e-5 * direction)
    torque, inertia = resisted(plan, 0.3, load, 3.0 * direction, arms=arms)
    expected = -min(1e-5 * load, 3.0 * inertia / STEP) * direction
    assert torque == pytest.approx(expected)


@pytest.mark.parametrize("load", [-4.3, 4.3, 1e9])
def test_the_contour_moment_takes_its_power_at_the_rate_of_the_contact(plan, load):
    """A steady disk precesses at w3/sin(beta), which is the rate of the contact.

    A contact that pulls has no moment, and no moment reverses the rotation in a step.
    """
    beta = 0.1
    angular = 7.0 * np.array([0.0, -np.cos(beta), np.sin(beta)])
    torque, inertia = resisted(plan, beta, load, angular, contour_moment=2e-5)
    power = torque @ angular
    unbounded = 2e-5 * max(load, 0.0) / 4.3 * 7.0 / np.sin(beta)
    stops = inertia * 7.0**2 / STEP
    assert power == pytest.approx(-min(unbounded, stops))
