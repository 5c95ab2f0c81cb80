"""Claim: the program selects the model of an elastic contact from the scene, before it solves
anything.

Source: the disk loses contact when the rms of N' exceeds 0.3 of the weight; the errors of the
filter are largest in slides. Oracle: the contact force of the event-driven motion at release; the
response of a linear contact, which is proportional to its roughness.
"""

import json

import numpy as np
import pytest
from law_scenes import named_scene
from paths import REFERENCES

from dynamics import plan_motion, simulate
from dynamics.compliant.model_selection import (
    flat_precession_rate,
    predicted_force_rms,
    release_force,
    steady_precession_rate,
)
from dynamics.motion_plan import motion_basis
from sonify import load_scene
from sonify.scene import from_document
from sonify.scene_keys import keys

GENTLE = (
    "release.inclination_deg=3",
    "release.omega=[0.0, 0.0, 7.0]",
    "friction.mu_static=2.0",
)


def vibration_of(scene):
    """Return inclinations [rad] and the predicted rms of N'/weight of a scene."""
    plan = plan_motion(scene)
    return predicted_force_rms(plan, plan.tabulated_law)


@pytest.fixture(scope="module")
def elastic():
    return load_scene("published").replace("contact.law=elastic")


@pytest.mark.parametrize("name", ["published", "hoop", "coin"])
def test_the_limit_of_the_precession_is_that_of_small_inclinations(name):
    scene = load_scene(name).replace("contact.fillet=1e-6")
    steady = steady_precession_rate(scene, 1e-4)
    assert flat_precession_rate(scene.disk, 1e-4) == pytest.approx(steady, rel=1e-3)


@pytest.mark.parametrize("scene", ["published", "hoop", "viscous"])
def test_first_force_is_that_of_the_rigid_motion(scene):
    """The second case slides at once; its force is read after the first short step of the slide."""
    read = named_scene(scene)
    for given, error in (
        (read, 1e-9),
        (read.replace("friction.mu_static=0.1", "friction.mu_dynamic=0.05"), 1e-5),
    ):
        motion = simulate(given.replace("numerics.time_limit=1e-3"))
        expected = motion.force([0.0])[0]
        assert release_force(motion_basis(given)) == pytest.approx(
            expected, rel=error, abs=error * given.disk.weight
        )


def test_a_slide_without_a_first_step_has_its_force_too():
    """With equal coefficients of friction the disk has no slip speed that gives a direction."""
    known = json.loads((REFERENCES / "legal_scenes.json").read_text())[
        "slides_at_release"
    ]
    known["numerics"]["integrator"] = "auto"  # that of the file may not be installed
    given = from_document(known)
    rounded = {"contact": {"law": "rigid", "fillet": known["contact"]["fillet"]}}
    smooth = {
        key: known[key] for key in known if key not in ("roughness", "surface")
    } | rounded
    rigid = from_document(smooth).replace("numerics.time_limit=1e-3")
    expected = simulate(rigid).force([0.0])[0]
    assert release_force(motion_basis(given)) == pytest.approx(
        expected, rel=1e-5, abs=1e-6 * given.disk.weight
    )


def test_rough_scenes_are_solved_in_full_from_where_contact_is_lost(elastic):
    gentle = elastic.replace(*GENTLE)
    beta, share = vibration_of(gentle.replace("roughness.rms=1e-8"))
    assert vibration_of(gentle.replace("roughness.rms=3e-8"))[1] == pytest.approx(
        3 * share
    )
    rms = 0.3e-8 / share.max()
    for factor, kind in ((0.99, "filter"), (1.01, "full")):
        rough = gentle.replace(f"roughness.rms={factor * rms}")
        assert vibration_of(rough)[1].max() == pytest.approx(0.3 * factor)
        chosen = plan_motion(rough).contact
        assert chosen.kind == kind
        lost = f"below {beta[np.argmax(share)]:.2g} rad, where contact is lost"
        assert (lost in chosen.reason) == (factor > 1)
        assert "0.3 " in chosen.reason


def test_a_force_too_large_for_one_contact_is_a_warning(elastic):
    gentle = elastic.replace(*GENTLE)
    rms = 1e-8 / vibration_of(gentle.replace("roughness.rms=1e-8"))[1].max()
    for force, is_warned in ((0.49, False), (0.51, True)):
        chosen = plan_motion(gentle.replace(f"roughness.rms={force * rms}")).contact
        assert chosen.kind == "full"
        assert ("it exceeds 0.5" in chosen.reason) == is_warned


@pytest.mark.slow
def test_a_disk_that_the_air_carries_does_not_break_its_contact_below(elastic):
    """The predicted inclination is that of AIRBORNE; down to it the filter is adequate."""
    fine = elastic.replace(
        *GENTLE,
        "release.inclination_deg=12",
        "release.omega=[0.0, 2.0, 14.0]",
        "roughness.rms=3e-8",
    )
    blown = fine.replace(
        "air.film=acts", "friction.arm_rolling=0.0", "dissipation.contour_moment=1e-4"
    )
    assert plan_motion(fine).contact.kind == "full"
    assert plan_motion(blown).contact.kind == "filter"
    assert vibration_of(blown)[1].max() < 0.3
    flown = simulate(blown.replace("contact.law=rigid")).rolling
    assert flown.rolling_outcome.name == "AIRBORNE"
    assert plan_motion(blown).film_decision.airborne_inclination == pytest.approx(
        flown.state[-1, 1], rel=0.2
    )
    assert plan_motion(fine).film_decision.airborne_inclination == 0.0


def test_slides_and_what_is_asked_for(elastic):
    assert plan_motion(elastic.replace("contact.law=rigid")).contact.kind == "rigid"
    assert "88% of its static limit" in plan_motion(elastic).contact.reason
    assert plan_motion(elastic).contact.kind == "full"
    assert plan_motion(elastic.replace(*GENTLE)).contact.kind == "filter"
    for asked in ("filter", "full"):
        assert (
            plan_motion(elastic.replace(f"numerics.contact={asked}")).contact.kind
            == asked
        )


def test_what_roughness_takes_besides_friction_acts_on_the_motion(elastic):
    """Roughness slows a disk with hardly any other dissipation; fitted friction includes this loss.

    The power of roughness is proportional to the square of the heights at every inclination, and so
    is its share.
    """
    free = (
        "friction.arm_rolling=0",
        "friction.arm_pivoting=0",
        "friction.arm_nutation=0",
        "air.film=none",
    )
    slow = elastic.replace(
        *GENTLE, *free, "dissipation.contour_moment=5e-8", "roughness.rms=1e-8"
    )
    chosen = plan_motion(slow).contact
    assert plan_motion(slow).roughness_energy_share > 0.05
    assert chosen.kind == "full"
    assert "in addition to friction" in chosen.reason
    assert plan_motion(slow.replace("roughness.loss=fitted")).contact.kind == "filter"
    little = slow.replace("dissipation.contour_moment=1e-3")
    assert plan_motion(little).contact.kind == "filter"
    assert plan_motion(
        little.replace("roughness.rms=5e-9")
    ).roughness_energy_share == pytest.approx(
        0.25 * plan_motion(little).roughness_energy_share, rel=0.01
    )


@pytest.mark.parametrize(
    ("rms", "kind"), [("0.03e-6", "filter"), ("2e-7", "full"), ("5e-6", "many")]
)
def test_auto_selects_any_of_the_three_models_as_its_help_states(rms, kind):
    """Granite as polished, as ground, and as rough as unfinished stone."""
    scene = load_scene("granite").replace(f"roughness.rms={rms}")
    assert plan_motion(scene).contact.kind == kind
    (row,) = [key for key in keys() if key.name == "numerics.contact"]
    assert "auto selects one of the three" in row.meaning
