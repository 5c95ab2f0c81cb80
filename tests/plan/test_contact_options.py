"""Claim: a plan states what each model of an elastic contact costs and by how much it is off.

Source: dynamics/contact_options.py and the chart contact-models. Oracle: the closed form of rolling
against a constant moment, the ends of solved motions in README.md, and the rows of the chart. How
long the runs really take is measured in benchmarks/speed/contact_option_seconds.py.
"""

import csv
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from dynamics import plan_motion
from dynamics.compliant.model_errors import (
    ERROR_BY_CURVATURE,
    ERROR_BY_FORCE_RMS,
    TABULATED_CURVATURE_NUMBERS,
    motion_error,
)
from dynamics.contact_options import (
    contact_options,
    release_energy,
    rolling_duration,
)
from dynamics.disk import inertias
from modal import surface_modes
from sonify import load_scene

CHART = Path(__file__).parents[2] / "outputs/shown/charts/contact_models.csv"


@pytest.fixture(scope="module")
def on_mirror():
    scene = load_scene("mirror-base")
    return plan_motion(scene, surface_modes(scene))


def test_a_constant_moment_takes_the_energy_in_the_time_of_its_closed_form():
    """The power of a contour moment M is M Omega. An almost flat disk on its sharp edge has
    Omega^2 = m g R/(J beta) and the energy 3/2 m g R beta; the time is
    (m g R J)^(1/2) beta^(3/2)/M."""
    scene = load_scene("granite").replace(
        "air.film=none",
        "contact.fillet=1e-5",
        "friction.arm_nutation=0",
        "friction.arm_pivoting=0",
        "friction.arm_rolling=0",
    )
    disk, beta = scene.disk, 0.01
    moment = scene.dissipation.contour_moment
    expected = (
        np.sqrt(disk.weight * disk.radius * inertias(disk)[0]) * beta**1.5 / moment
    )
    found = rolling_duration(plan_motion(scene), beta)
    assert found == pytest.approx(expected, rel=0.01)


@pytest.mark.parametrize(
    ("name", "end", "error"), [("granite", 38.7, 0.1), ("glass-plate", 12.1, 0.8)]
)
def test_the_duration_is_near_that_of_the_solved_motion(name, end, error):
    """The motion of `glass-plate` begins with slip and large nutation, which the prediction omits."""
    plan = plan_motion(load_scene(name))
    assert rolling_duration(plan) == pytest.approx(end, rel=error)


def test_the_energy_at_the_release_of_a_steady_disk_is_that_of_its_height_and_spin():
    scene = load_scene("granite").replace("release.omega=[0, 0, 0]")
    disk = scene.disk
    beta = np.radians(scene.release.inclination_deg)
    raised = disk.radius * np.sin(beta) + disk.thickness / 2 * (np.cos(beta) - 1)
    assert release_energy(scene) == pytest.approx(disk.weight * raised, rel=1e-12)


def test_the_errors_are_those_of_the_chart():
    with CHART.open() as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    for model, setting in (("filter", "192000 1/s"), ("full", "800000 1/s")):
        for kappa, listed in zip(
            TABULATED_CURVATURE_NUMBERS, ERROR_BY_CURVATURE[model], strict=True
        ):
            case = f"rough, long waves, {kappa:g}"
            found = [
                float(row["error"])
                for row in rows
                if (row["family"], row["setting"], row["case"])
                == (model, setting, case)
                and row["method"] != "spectrum"
            ]
            assert len(found) == 3
            assert max(max(found), 1e-4) == pytest.approx(listed, rel=0.06)


def test_errors_grow_with_the_vibration_and_the_curvature():
    assert motion_error("filter", 0.0, 0.0) == 0.0
    assert motion_error("filter", 0.39, 0.0) == ERROR_BY_FORCE_RMS["filter"][2]
    assert motion_error("full", 0.39, 0.35) > 0.1
    assert motion_error("full", 0.39, 0.0) < motion_error("filter", 0.39, 0.0)


def test_the_coupling_matters_for_the_filter_alone(on_mirror):
    one_way, two_way, full, many = on_mirror.contact_options
    assert [o.name for o in on_mirror.contact_options] == [
        "filter",
        "two-way filter",
        "full",
        "many",
    ]
    assert one_way.level_error == on_mirror.rough_table.level_error > 20
    assert two_way.level_error == full.level_error == many.level_error == 0
    assert one_way.seconds < two_way.seconds < full.seconds < many.seconds
    assert one_way.motion_error > two_way.motion_error > many.motion_error == 0


def test_twice_the_rate_takes_twice_the_steps(on_mirror):
    scene = on_mirror.scene
    slow = {o.name: o.seconds for o in on_mirror.contact_options}
    fast_plan = replace(
        on_mirror,
        scene=scene.replace("numerics.contact_rate=2400000"),
    )
    fast = {o.name: o.seconds for o in contact_options(fast_plan)}
    assert fast["full"] / slow["full"] == pytest.approx(6.0)
    assert fast["filter"] == slow["filter"]


def test_a_rigid_contact_has_no_options():
    assert plan_motion(load_scene("published")).contact_options == ()
