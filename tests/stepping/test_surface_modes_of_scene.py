"""Claim: `simulate(scene)` never ignores a table that reacts on the motion, and gives the motion of
a run.

Source: the docstring of `dynamics.simulate`. Oracle: the same scene with the modes from
`modal.surface_modes`; the run of the scene; the motion on a rigid table.
"""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from dynamics import MotionScene, OwnLaw, plan_motion, simulate
from dynamics.compliant.compliant_motion import CompliantMotion
from dynamics.compliant.law.sections import SwitchedContact
from dynamics.compliant.modes_from_scene import MAX_TABLE_FREQUENCY, modes_from_numbers
from dynamics.sections import as_motion_scene
from modal import surface_modes
from modal.modes import DEFAULT_HIGHEST_FREQUENCY
from sonify import load_scene, solve

LIGHT_MODE = "surface={kind='modes', modes=[{order=3, frequency=600.0, damping_ratio=0.005, modal_mass=1.0}]}"
RELEASED_FLAT = (
    "release.inclination_deg=0.3",
    "release.omega=[0.0, 0.461, 2.70]",
    "numerics.accuracy=draft",
)
THREE_MODES = (
    "surface={kind='modes', action='motion', modes=["
    "{order=2, frequency=900.0, damping_ratio=0.02, modal_mass=1.0},"
    "{order=0, frequency=600.0, damping_ratio=0.01, modal_mass=3.0},"
    "{order=3, frequency=30000.0, damping_ratio=0.01, modal_mass=2.0}]}"
)


@pytest.fixture(scope="module")
def scene():
    return load_scene("published")


def same(one, other):
    """Return True if times, states and forces of two motions are equal bit by bit."""
    pairs = [
        (one.t, other.t),
        (one.state, other.state),
        (one.force(one.t), other.force(other.t)),
    ]
    return all(np.array_equal(first, second) for first, second in pairs)


@pytest.mark.slow
def test_a_light_mode_in_the_scene_halts_the_published_disk_earlier(scene):
    """The halt precedes that on a rigid table, formerly the result here, by more than 1 s."""
    on_table = scene.replace(LIGHT_MODE)
    motion = simulate(on_table)
    assert same(motion, simulate(on_table, surface_modes=surface_modes(on_table)))
    assert simulate(scene).t_end - motion.t_end > 1.0
    assert len(motion.contact_losses) > 0
    assert same(
        motion, simulate(on_table.replace("roughness.rms=1e-7"))
    )  # the contact is rigid until then
    still = simulate(on_table.replace("surface.action=sound"))
    assert same(still, simulate(scene))


def test_a_table_that_reacts_at_the_release_is_coupled_from_the_start(scene):
    """Oracle: the motion with two-way coupling from the release on the same contact."""
    on_table = scene.replace(
        LIGHT_MODE.replace("modal_mass=1.0", "modal_mass=0.1"),
        *RELEASED_FLAT,
        "numerics.time_limit=0.01",
    )
    tilt = np.radians(on_table.release.inclination_deg)
    assert plan_motion(on_table).two_way.inclination == tilt
    requested = as_motion_scene(on_table).part(
        contact=SwitchedContact(law="elastic"),
        surface=replace(on_table.surface, action="motion"),
    )
    assert same(simulate(on_table), simulate(requested))


def test_modes_in_the_scene_are_those_of_modal(scene):
    """The two packages are independent; each evaluates the shapes itself."""
    on_table = scene.replace(THREE_MODES, "contact.law=elastic")
    ours = modes_from_numbers(on_table.surface, on_table.disk.radius)
    theirs = surface_modes(on_table)
    assert MAX_TABLE_FREQUENCY == DEFAULT_HIGHEST_FREQUENCY
    assert ours.frequency.tolist() == [600.0, 900.0, 900.0]
    for name in ("frequency", "decay_rate", "order", "coefficients", "place"):
        assert np.array_equal(getattr(ours, name), getattr(theirs, name)), name
    assert all(
        np.array_equal(*knots) for knots in zip(ours.knots, theirs.knots, strict=True)
    )
    x, y = np.random.default_rng(1).uniform(
        -0.05, 0.05, (2, 50)
    )  # beyond the contact circle too
    assert np.array_equal(ours.at(x, y), theirs.at(x, y))
    radius = on_table.disk.radius
    assert ours.compliance(radius) == theirs.compliance(radius) > 0
    r = radius / 2
    theta = 0.4
    closed = np.array([3**-0.5, np.cos(2 * theta) / 4, np.sin(2 * theta) / 4])
    assert ours.at([r * np.cos(theta)], [r * np.sin(theta)])[0] == pytest.approx(
        closed, abs=1e-4
    )


def test_a_scene_needs_no_more_sections_than_its_motion_reads(scene):
    """The other sections have their defaults: a rigid contact, smooth, without a film."""
    draft = scene.replace("numerics.accuracy=draft")
    names = ("disk", "friction", "dissipation", "release", "surface", "numerics")
    sections = {name: vars(draft)[name] for name in names}
    assert same(simulate(MotionScene(**sections)), simulate(draft))
    assert same(simulate(SimpleNamespace(**sections)), simulate(draft))


@pytest.mark.slow
@pytest.mark.parametrize("action", ["auto", "motion"])
def test_a_run_and_simulate_give_the_same_motion(scene, action):
    """One mode is inaudible, another above the Nyquist frequency; the motion includes both."""
    heard_little = (
        "audio.sample_rate=8000",
        "numerics.time_limit=0.3",
        "contact.law=elastic",
    )
    modes = THREE_MODES.replace("30000.0", "6000.0").replace(
        "modal_mass=3.0", "modal_mass=1e5"
    )
    wanted = scene.replace(
        *RELEASED_FLAT, *heard_little, modes.replace("motion", action)
    )
    result = solve(wanted)
    assert len(result.plan.sounding_table) < len(result.table) < 5
    assert same(result.motion, simulate(wanted))


@pytest.mark.slow
def test_a_plate_moves_as_in_a_run_by_the_modes_of_its_result():
    thin = "surface.thickness=0.003", "contact.law=elastic", "numerics.time_limit=0.3"
    plate = load_scene("glass-plate").replace(*RELEASED_FLAT, *thin)
    result = solve(plate)
    assert isinstance(result.motion, CompliantMotion)  # coupled from the release
    assert same(result.motion, simulate(plate, surface_modes=result.table))


@pytest.mark.parametrize("action", ["auto", "motion"])
@pytest.mark.parametrize("name", ["glass-plate", "wood-table"])
def test_a_table_without_modes_in_the_scene_is_refused(name, action):
    table = load_scene(name).replace("contact.law=elastic", f"surface.action={action}")
    refused = (
        rf"surface\.action = '{action}'.*surface_modes=modal\.surface_modes\(scene\)"
    )
    with pytest.raises(ValueError, match=refused) as caught:
        simulate(table)
    assert len(str(caught.value).splitlines()) == 1


def test_a_table_that_cannot_act_is_refused_or_at_rest_as_its_action_says(scene):
    endless = (
        "{kind='infinite', thickness=0.02, young=7e10, poisson=0.3, density=2700.0"
    )
    brief = scene.replace("numerics.time_limit=0.1")
    rests = simulate(brief)
    assert same(simulate(brief.replace(f"surface={endless}}}")), rests)
    with pytest.raises(ValueError, match=r"'motion' with surface\.kind = 'infinite'"):
        simulate(brief.replace(f"surface={endless}, action='motion'}}"))
    with pytest.raises(ValueError, match=r"'motion' with contact\.law = 'rigid'"):
        simulate(brief.replace(THREE_MODES))


def test_a_law_of_ones_own_needs_a_table_at_rest(scene):
    with pytest.raises(ValueError, match=r"loads: .* set surface\.action = 'sound'"):
        simulate(scene.replace(LIGHT_MODE), loads=OwnLaw())
