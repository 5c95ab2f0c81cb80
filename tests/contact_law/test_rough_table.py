"""Claim: the plan couples a rough contact to its table where one-way coupling would change the
A-weighted level by more than 1 dB, and selects the contact model by the force on the yielding table.

Source: dynamics/compliant/rough_table.py. Oracle: levels and forces of an independent program on the
mirror (edges up to 170 nm keep contact, on a rigid table up to 57 nm) and on slabs of granite; the
closed form of the curvature of a plate under a running load of one order.
"""

from dataclasses import replace

import numpy as np
import pytest
from table_models import one_mode

from dynamics import plan_motion, simulate
from dynamics.compliant.model_selection import steady_precession_rate
from dynamics.compliant.rough_table import bent_table_ratio, linear_range
from modal import surface_modes
from sonify import load_scene
from sonify.plan.plan import Plan
from sonify.plan.sentences import TABLE_YIELDS_AND_SOUNDS
from sonify.plan.table import table_action, with_rough_table
from sonify.plan.unused import unused_keys
from sonify.sound.sources.contact import ContactFilter

GRANITE = "young=60e9, poisson=0.2, density=2700.0"
STONE = "contact.young=60e9", "contact.poisson=0.2"


@pytest.fixture(scope="module")
def mirror_modes():
    return surface_modes(load_scene("toy"), 20e3)


def mirror_plan(modes, edge, *changes):
    scene = load_scene("toy").replace(f"roughness.rms_edge={edge}", *changes)
    return plan_motion(scene, modes)


@pytest.mark.parametrize(
    ("edge", "model", "two_way_rms"),
    [(30e-9, "filter", 0.054), (100e-9, "filter", 0.181), (200e-9, "full", 0.363)],
)
def test_the_force_on_the_yielding_table_selects_the_model(
    mirror_modes, edge, model, two_way_rms
):
    """On a rigid table, contact is lost from 57 nm on."""
    plan = mirror_plan(mirror_modes, edge)
    assert plan.contact.kind == model
    assert plan.rough_table.two_way_rms == pytest.approx(two_way_rms, rel=0.05)
    assert plan.filter_is_two_way == (model == "filter")
    assert plan.is_two_way_from_release == (model == "full")
    assert plan.surface_modes is mirror_modes
    assert 20 < plan.rough_table.level_error < 30
    assert "more than 1 dB" in table_action(plan).reason


@pytest.mark.slow
@pytest.mark.parametrize(
    ("edge", "contact", "limit"),
    [
        (30e-9, "auto", None),
        (100e-9, "filter", None),
        (190e-9, "filter", 0.3),
        (190e-9, "full", None),
        (300e-9, "auto", 0.5),
    ],
)
def test_the_plan_says_from_where_to_where_a_model_is_outside_its_limits(
    mirror_modes, edge, contact, limit
):
    """With the predicted error there; the rms is proportional to the heights."""
    plan = mirror_plan(mirror_modes, edge, f"numerics.contact={contact}")
    assert ("WARNING" in plan.contact.reason) == (limit is not None)
    if limit is None:
        return
    fine = mirror_plan(mirror_modes, 30e-9).rough_table
    rms = np.array([error.two_way_rms for error in fine.errors]) * edge / 30e-9
    outside = fine.inclination[rms > limit]
    said = f"from {outside.max():.2g} to {outside.min():.2g} rad it exceeds {limit:g}"
    assert said in plan.contact.reason
    model = "full" if plan.contact.kind == "full" else "filter"
    (own,) = (
        o for o in plan.contact_options if o.name.endswith(model) and not o.level_error
    )
    assert (
        f"predicted error of the motion is {own.motion_error:.1%}"
        in plan.contact.reason
    )


def test_the_modes_of_the_table_are_required(mirror_modes):
    scene = load_scene("toy")
    assert plan_motion(scene).lacks_surface_modes
    plan = plan_motion(scene, mirror_modes)
    assert not plan.lacks_surface_modes
    assert not plan.switches_to_two_way


def test_one_way_coupling_may_be_requested(mirror_modes):
    plan = mirror_plan(mirror_modes, 30e-9, "surface.action=sound")
    assert plan.rough_table is None
    assert not plan.lacks_surface_modes
    assert not plan.filter_is_two_way


@pytest.mark.parametrize(("thickness", "two_way"), [(0.12, False), (0.06, True)])
def test_a_thick_slab_is_not_coupled(thickness, two_way):
    scene = load_scene("toy").replace(
        f"surface={{kind='plate', radius=0.2, thickness={thickness}, {GRANITE}, "
        "loss_factor=0.02, edge='free'}",
        *STONE,
    )
    plan = plan_motion(scene, surface_modes(scene, 20e3))
    assert plan.contact.kind == "filter"
    assert plan.filter_is_two_way == two_way
    assert (abs(plan.rough_table.level_error) > 1) == two_way


def test_an_infinite_plate_yields_by_its_mobility():
    scene = load_scene("toy").replace(
        f"surface={{kind='infinite', thickness=0.03, {GRANITE}}}", *STONE
    )
    plan = plan_motion(scene)
    assert plan.filter_is_two_way
    assert plan.plate_mobility == pytest.approx(3.704e-5, rel=1e-3)
    assert unused_keys(scene, plan) == ()
    rigid = plan_motion(scene.replace("surface={kind='rigid'}"))
    assert rigid.plate_mobility == 0.0


def test_the_filter_ends_where_the_contact_is_as_fast_as_the_waves(mirror_modes):
    plan = mirror_plan(mirror_modes, 30e-9)
    assert plan.rough_table.linear_until == 0.0
    slow = one_mode(150.0, 1e-6, order=2)
    inclination = np.geomspace(0.2, 1e-3, 200)
    found, limit = linear_range(plan, slow, inclination)
    assert 2 * steady_precession_rate(plan.scene, found) == pytest.approx(
        np.pi * 150.0, rel=0.03
    )
    assert "half their frequency" in limit


def test_the_filter_ends_where_the_table_is_bent_like_the_rim(mirror_modes):
    plan = mirror_plan(mirror_modes, 30e-9)
    order, frequency, square, rate = 3, 2000.0, 1e3, 300.0
    pair = one_mode(frequency, square, order=order)
    stiff = (2 * np.pi * frequency) ** 2 - (order * rate) ** 2
    curvature = order**2 * plan.scene.disk.weight * square / stiff
    found = bent_table_ratio(plan, pair, 0.01, rate)
    assert found == pytest.approx(curvature / (plan.scene.disk.radius * 0.01), rel=1e-9)
    end, limit = linear_range(plan, pair, np.geomspace(0.2, 1e-3, 100))
    assert end > 0
    assert "bends the table" in limit


def test_the_plan_says_where_no_model_holds(mirror_modes):
    plan = mirror_plan(mirror_modes, 30e-9)
    said = with_rough_table(
        Plan(
            accuracy="draft",
            tolerance=0.0,
            final_inclination=0.0,
            highest_mode=0.0,
            max_contact_turn=0.0,
            decisions=(),
            modelled=(),
            left_out=(),
            motion=plan,
        )
    )
    assert any("receptance of all its modes" in sentence for sentence in said.modelled)
    assert not any("valid model" in sentence for sentence in said.left_out)
    beyond = plan.rough_table._replace(linear_until=0.02, limit="the table is bent")
    late = replace(plan, rough_table=beyond)
    bent = with_rough_table(replace(said, motion=late, left_out=(), modelled=()))
    assert any("below an inclination of 0.02 rad" in text for text in bent.left_out)


def test_the_force_of_the_sound_is_that_on_the_yielding_table(mirror_modes):
    """The rms falls from a sixth to a twentieth of the weight."""
    scene = load_scene("toy").replace(
        "numerics.time_limit=0.5", "numerics.accuracy=draft"
    )
    weight = scene.disk.weight
    rms = {}
    for action in ("auto", "sound"):
        one = scene.replace(f"surface.action={action}")
        motion = simulate(one, surface_modes=mirror_modes)
        blocks = ContactFilter.along(motion, one, 96_000, 0.0).blocks()
        force = np.concatenate(list(blocks))[4800:, 1]
        spectrum = np.abs(np.fft.rfft(force)) ** 2
        audible = np.fft.rfftfreq(len(force), 1 / 96e3) > 200
        rms[action] = np.sqrt(2 * spectrum[audible].sum()) / len(force) / weight
    expected = plan_motion(scene, mirror_modes).rough_table.errors[0]
    assert rms["auto"] == pytest.approx(expected.two_way_rms, rel=0.15)
    assert rms["sound"] == pytest.approx(expected.one_way_rms, rel=0.25)


@pytest.mark.parametrize("thickness", [0.006, 0.12])
def test_two_way_coupling_of_the_filter_may_be_requested(thickness):
    """It is included even if the prediction finds it negligible."""
    scene = load_scene("granite").replace(
        f"surface={{kind='plate', radius=0.2, thickness={thickness}, {GRANITE}, "
        "loss_factor=0.02, edge='free', action='motion'}",
        *STONE,
        "numerics.contact=filter",
    )
    assert plan_motion(scene).lacks_surface_modes
    plan = plan_motion(scene, surface_modes(scene, 20e3))
    assert plan.filter_is_two_way
    assert not plan.two_way.is_two_way
    assert not plan.may_be_two_way
    assert plan.rough_table.needs_two_way == (thickness < 0.1)
    assert unused_keys(scene, plan) == ("roughness.loss",)
    assert "surface.action = 'motion'" in table_action(plan).reason
    assert table_action(plan).choice == TABLE_YIELDS_AND_SOUNDS


def test_a_smooth_filter_cannot_be_coupled():
    scene = load_scene("granite").replace(
        {"roughness": None},
        f"surface={{kind='plate', radius=0.2, thickness=0.006, {GRANITE}, "
        "loss_factor=0.02, edge='free', action='motion'}",
        "numerics.contact=filter",
    )
    with pytest.raises(ValueError, match="two-way coupling requires 'full'"):
        plan_motion(scene)


def test_a_table_without_modes_below_20_khz_is_rigid():
    scene = load_scene("granite").replace(
        "surface={kind='plate', radius=0.04, thickness=0.04, young=400e9, poisson=0.2, "
        "density=3000.0, loss_factor=0.02, edge='clamped'}"
    )
    modes = surface_modes(scene, 20e3)
    assert not len(modes.frequency)
    plan = plan_motion(scene, modes)
    assert plan.rough_table.level_error == 0.0
    assert not plan.filter_is_two_way
