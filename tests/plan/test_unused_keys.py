"""Claim: a key set by a scene either changes a result of its run or is listed as unused; never
both.

Source: the schema of a scene, key by key. Oracle: the bytes of motion, modes and sound of short
drafts with two values of each key. For keys that affect only a finding, the input of this finding:
what ends the motion, and the film.
"""

import json
from functools import cache
from importlib.util import find_spec

import numpy as np
import pytest
from prepared_runs import remembered_modes
from table_models import MODE

from dynamics import plan_motion
from sonify import SceneError, load_scene, run
from sonify.plan.preflight import (
    check_solvable_scene,
    plan_with_modes,
    solvable_scene,
    solve_motion,
)
from sonify.plan.table import audible_table, solve_table
from sonify.plan.unused import UNUSED_KEY_RULES, unused_keys
from sonify.runtime.progress import Stages
from sonify.scene_keys import keys
from sonify.sound.render import Renderer

FLAT = "release.inclination_deg=1.0", "release.omega=[0.0, 0.84, 4.93]"
BRIEF = (
    "numerics.accuracy=draft",
    "numerics.time_limit=0.03",
    "audio.sample_rate=12000",
    "air.film=auto",
)
SOLID = "young=7e10, poisson=0.22, density=2500.0"
PLATE = f"kind='plate', action='motion', radius=0.15, thickness=0.006, {SOLID}, ring_radius=0.1, ring_stiffness=1e6"
BASES = {
    "rigid": (),
    "sliding": ("friction.mu_static=0.02", "friction.mu_dynamic=0.01"),
    "settling": (
        "numerics.final_inclination=0.098",
        "release.inclination_deg=5.7",
        "numerics.time_limit=1.0",
    ),
    "rough": (
        "contact.law=elastic",
        "roughness.rms=1e-7",
        "numerics.contact=full",
        *FLAT,
    ),
    "rattling": (
        "contact.law=elastic",
        "contact.restitution=0.8",
        "roughness.rms=2e-6",
        "numerics.contact=many",
        *FLAT,
    ),
    "filter": (
        "contact.law=elastic",
        "roughness.rms=1e-9",
        "numerics.contact=filter",
        *FLAT,
    ),
    "wavy": (
        "contact.law=elastic",
        "imperfection.order=2",
        "imperfection.amplitude=1e-6",
        *FLAT,
    ),
    "plate": (f"surface={{{PLATE}}}", "contact.law=elastic", *FLAT),
    "modes": (
        f"surface={{kind='modes', action='motion', modes=[{MODE}]}}",
        "contact.law=elastic",
        *FLAT,
    ),
    "endless": (f"surface={{kind='infinite', thickness=0.02, {SOLID}}}",),
    "film": ("air.film=acts", *FLAT),
    "vacuum": ("air.pressure=0.0",),
    "shell": (
        "disk.shape=shell",
        "disk.wall=0.005",
        "disk.thickness=0.03",
        "support.kind=free",
    ),
    "on contact": ("support.kind=contact",),
}
"""Changes to the published scene, by name."""
VALUES = {
    "disk.radius": "0.038",
    "disk.thickness": "0.0141",
    "disk.mass": "0.5",
    "disk.wall": "0.006",
    "material.name": "glass",
    "material.young": "1.9e11",
    "material.poisson": "0.31",
    "material.loss_factor": "0.003",
    "material.decay_rates": "[7.0]",
    "friction.mu_static": "5.0",
    "friction.mu_dynamic": "0.005",
    "friction.arm_nutation": "2e-5",
    "friction.arm_rolling": "2e-5",
    "friction.arm_pivoting": "2e-4",
    "release.inclination_deg": "5.9",
    "release.omega": "[0.1, 0.8, 4.5]",
    "support.kind": "free",
    "support.inclination_deg": "2.0",
    "support.half_angle_deg": "7.0",
    "support.height": "0.005",
    "support.position": "bottom",
    "support.held": "['tangential', 'axial']",
    "surface.action": "sound",
    "surface.hole": "0.02",
    "surface.radius": "0.16",
    "surface.thickness": "0.007",
    "surface.young": "6e10",
    "surface.poisson": "0.25",
    "surface.density": "2600.0",
    "surface.loss_factor": "0.03",
    "surface.edge": "free",
    "surface.ring_radius": "0.11",
    "surface.ring_stiffness": "2e6",
    "surface.place": "[0.01, 0.0]",
    "surface.sag": "1e-3",
    "surface.diameter": "0.3",
    "surface.baffle": "true",
    "surface.modes": f"[{MODE.replace('600.0', '500.0')}]",
    "dissipation.power_coefficient": "1e-6",
    "dissipation.power_exponent": "3.0",
    "dissipation.air_viscosity": "1e-4",
    "dissipation.boundary_layer_viscosity": "1e-4",
    "dissipation.air_density": "1.3",
    "dissipation.contour_moment": "1e-4",
    "dissipation.viscous_moment": "1e-6",
    "dissipation.viscous_force": "1e-3",
    "contact.fillet": "0.001",
    "contact.loss_factor": "0.03",
    "contact.body": "rigid",
    "contact.young": "5e10",
    "contact.poisson": "0.25",
    "contact.restitution": "0.7",
    "roughness.rms": "2e-7",
    "roughness.rms_edge": "1e-8",
    "roughness.shortest": "2e-4",
    "roughness.longest": "0.05",
    "roughness.exponent": "1.0",
    "roughness.loss": "fitted",
    "roughness.seed": "5",
    "roughness.grain": "true",
    "imperfection.order": "3",
    "imperfection.amplitude": "2e-6",
    "air.film": "acts",
    "air.viscosity": "2.5e-5",
    "air.density": "1.1",
    "air.pressure": "9e4",
    "air.temperature": "150.0",
    "audio.sample_rate": "13000",
    "audio.distance": "0.6",
    "audio.elevation_deg": "30.0",
    "audio.listeners": "[{distance=0.7}]",
    "numerics.accuracy": "standard",
    "numerics.integrator": "dop853",
    "numerics.tolerance": "1e-11",
    "numerics.final_inclination": "0.097",
    "numerics.contact": "full",
    "numerics.contact_rate": "2.2e6",
    "numerics.time_limit": "0.02",
}
"""An alternative value for each key, different from those of the bases."""
ANOTHER_SCENE = {
    "name",
    "disk.density",
    "disk.shape",
    "surface.kind",
    "surface.file",
    "surface.held",
    "contact.law",
    "roughness.profile",
    "roughness.profile_edge",
}
"""Keys with alternatives that require further keys."""
NOT_REACHED = {
    "friction.mu_static": "no change of the regime in the first 30 ms",
    "friction.mu_dynamic": "no slide in the first 30 ms",
    "numerics.final_inclination": "the disk is still above it after 30 ms",
    "numerics.contact": "`auto` takes this model anyway",
    "air.film": "the film acts already",
    "air.viscosity": "no film acts yet; a finding says from when it would",
    "numerics.accuracy": "differs in the sound after these 30 ms, or in what is stated",
    "dissipation.viscous_force": "less than the last bit of the force of a disk whose centre is "
    "at rest",
}
"""Keys that may have no effect in some bases, with the reason; each has an effect in at least one.
"""
if not find_spec("heyoka"):
    NOT_REACHED["numerics.integrator"] = "without heyoka there is only one"


def stages(scene, motion_plan):
    """Yield the bytes of the modes, the motion and the sound of a scene lazily."""
    plan, modes = plan_with_modes(scene, remembered_modes, motion_plan)
    yield modes.frequency.tobytes() + modes.decay_rate.tobytes()
    table = solve_table(scene, motion_plan)
    rendered = table and audible_table(table, scene)
    if motion_plan.lacks_surface_modes:
        motion_plan = motion_plan.with_surface_modes(table)
    motion = solve_motion(motion_plan)
    yield motion.t.tobytes() + motion.state.tobytes() + motion.force(motion.t).tobytes()
    renderer = Renderer(
        scene, motion, modes, plan.sounding, plan.max_contact_turn, rendered
    )
    yield np.ascontiguousarray(next(iter(renderer.blocks()))).tobytes()


@cache
def found_in(base):
    """Return the bytes of all stages of a base."""
    return list(stages(*solvable_scene(base_scene(base), None)))


def base_scene(base):
    """Return the scene of a base."""
    return load_scene("published").replace(*BRIEF, *BASES[base])


def differs(scene, motion_plan, base):
    """Return True at the first stage of a scene that differs from that of a base."""
    found = stages(scene, motion_plan)
    return any(one != other for one, other in zip(found, found_in(base), strict=True))


def allowed(base):
    """Yield the keys that may have another value in a base, with their scenes and plans."""
    known = check_solvable_scene(base_scene(base), None)
    for name, value in VALUES.items():
        try:
            scene, motion_plan = solvable_scene(
                base_scene(base).replace(f"{name}={value}"), None
            )
        except (
            SceneError
        ):  # the kind of table or support does not have it, or the numbers do not fit
            continue
        if scene != known:
            yield name, scene, motion_plan


def test_every_key_is_walked_over():
    known = {key.name for key in keys()}
    assert set(VALUES) | ANOTHER_SCENE == known
    assert not set(VALUES) & ANOTHER_SCENE
    assert {key for keys, _ in UNUSED_KEY_RULES for key in keys.split()} <= known


@pytest.mark.slow
@pytest.mark.parametrize("base", BASES)
def test_a_key_is_unused_or_changes_something(base):
    wrong = {}
    for name, scene, motion_plan in allowed(base):
        unused = name in unused_keys(scene, motion_plan)
        changes = differs(scene, motion_plan, base)
        if unused == changes and not (name in NOT_REACHED and not unused):
            wrong[name] = (
                "listed, but changes a result"
                if unused
                else "changes nothing, but is not listed"
            )
    assert wrong == {}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "base"),
    [
        ("friction.mu_static", "sliding"),
        ("friction.mu_dynamic", "sliding"),
        ("numerics.final_inclination", "settling"),
        ("numerics.contact", "filter"),
        ("air.film", "rigid"),
        ("air.viscosity", "film"),
        ("numerics.accuracy", "rough"),
        ("dissipation.viscous_force", "rigid"),
    ],
)
def test_what_is_not_reached_in_one_base_changes_another(name, base):
    changed = base_scene(base).replace(f"{name}={VALUES[name]}")
    assert differs(*solvable_scene(changed, None), base)


@pytest.mark.slow
def test_roughness_on_a_rigid_contact_is_listed_and_changes_no_byte(tmp_path):
    """Such roughness was formerly accepted without a notice."""
    notices = []

    class Noted(Stages):
        def notice(self, line):
            notices.append(line)

    brief = load_scene("published").replace(
        "numerics.time_limit=0.01", "numerics.accuracy=draft", "name=brief"
    )
    rough = brief.replace("roughness.rms=1e-7", "contact.young=7e10")
    files = [
        run(scene, tmp_path / folder, stages=Noted()).out
        for scene, folder in ((brief, "one"), (rough, "two"))
    ]
    records = [json.loads((out / "run.json").read_text("utf-8")) for out in files]
    assert [record["unused"] for record in records] == [
        [],
        ["roughness.rms", "contact.young"],
    ]
    assert [line for line in notices if "unused" in line] == [
        "unused: roughness.rms, contact.young (no effect on this run)"
    ]
    for name in ("sound.wav", "motion.npz"):
        one, other = ((out / name).read_bytes() for out in files)
        assert one == other, name
    again = load_scene(files[1] / "run.json")
    assert set(unused_keys(again, plan_motion(again))) == {
        "roughness.rms",
        "contact.young",
    }


def test_only_what_a_scene_sets_is_listed():
    published = load_scene("published")
    assert unused_keys(published, plan_motion(published)) == ()
    assert (
        unused_keys(
            published.replace("contact.loss_factor=0.02"), plan_motion(published)
        )
        == ()
    )  # the default
    elastic = published.replace(
        "contact.law=elastic", "roughness.rms=1e-7", "contact.young=7e10"
    )
    assert unused_keys(elastic, plan_motion(elastic)) == ()


def test_roughness_does_not_keep_a_table_from_acting_on_a_rigid_contact():
    """Roughness has no effect on a rigid contact; formerly it decided whether the table reacts on
    the motion."""
    table = load_scene("published").replace(f"surface={{kind='modes', modes=[{MODE}]}}")
    rough = table.replace("roughness.rms=1e-7")
    assert plan_motion(table).may_be_two_way
    assert plan_motion(rough).may_be_two_way
    on_elastic = plan_motion(rough.replace("contact.law=elastic"))
    assert on_elastic.rough_table.needs_two_way
    assert on_elastic.is_two_way_from_release
    assert unused_keys(rough, plan_motion(rough)) == ("roughness.rms",)
