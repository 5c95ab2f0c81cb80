"""Claim: the numbers on the sheet for the classroom are those of the runs that it names.

Source: docs/classroom.md. Oracle: the solved motions; the rate of steady rolling in closed form.
"""

import re
import shlex
from math import pi, radians, sin, sqrt

import pytest
from paths import ROOT

from dynamics import Outcome, simulate
from dynamics.disk import GRAVITY
from sonify import load_scene
from sonify.__main__ import _repeat_set_option

TEXT = (ROOT / "docs" / "classroom.md").read_text("utf-8")
TABLE = TEXT.partition("## Three things to change")[2].partition(
    "What the numbers show"
)[0]
ROWS = [
    [cell.strip() for cell in line.strip("|").split("|")]
    for line in TABLE.splitlines()
    if line.startswith("|") and "---" not in line
][1:]


def scene_of(cell):
    """Return the scene of a cell with the arguments of --set, on a rigid table of the same shape.

    The roughness of the toy is a filter on the motion of a rigid contact, which the table does not
    change."""
    arguments = shlex.split(cell.strip("`"))
    repeated = [
        word for word in _repeat_set_option(["--set", *arguments]) if word != "--set"
    ]
    scene = load_scene("toy").replace(*repeated)
    shape = {"sag": scene.surface.sag, "diameter": scene.surface.diameter}
    sections = ("roughness", "support", "contact.law")
    return scene.replace(dict.fromkeys(sections) | {"surface": shape})


def turns_per_second(motion, time, window=0.1):
    """Return the mean number of turns of the contact per second around a time [s]."""
    end = motion.t[-1]
    span = [max(time - window / 2, 0.0), min(time + window / 2, end)]
    first, last = motion.precession(span)
    return abs(last - first) / (2 * pi) / (span[1] - span[0])


@pytest.mark.slow
@pytest.mark.parametrize("row", ROWS, ids=[row[0] for row in ROWS])
def test_a_row_is_the_run(row):
    scene = scene_of(row[1])
    motion = simulate(scene).rolling
    lasts, at_first, before_the_end = map(float, row[2:])
    assert motion.t[-1] == pytest.approx(lasts, rel=0.005)
    assert turns_per_second(motion, 0.5) == pytest.approx(at_first, abs=0.06)
    assert turns_per_second(motion, motion.t[-1] - 1) == pytest.approx(
        before_the_end, rel=0.02
    )
    assert motion.rolling_outcome is Outcome.AIRBORNE
    weight = re.search(r"([\d.]+) kg", row[0])
    if weight:
        assert scene.disk.mass == pytest.approx(float(weight[1]), abs=0.005)
        share = scene.dissipation.contour_moment / scene.disk.weight / scene.disk.radius
        toy = load_scene("toy")
        same = toy.dissipation.contour_moment / toy.disk.weight / toy.disk.radius
        assert share == pytest.approx(same, rel=0.01)


def test_the_table_has_three_changes():
    assert len(ROWS) == 7
    assert {row[0].split(":")[0].strip("* ") for row in ROWS} == {
        "none",
        "Surface",
        "Angle",
        "Material",
    }


def test_the_rate_of_steady_rolling_and_the_height_of_the_rim_are_right():
    disk = load_scene("toy").disk
    rate = sqrt(4 * GRAVITY / (disk.radius * sin(radians(12)))) / (2 * pi)
    assert f"f is about {rate:.1f} turns a second" in " ".join(TEXT.split())
    assert f"only {2000 * disk.radius * sin(radians(0.1)):.2f} mm" in TEXT
