"""Claim: every valid scene, drawn at random from all sections, ends in a named outcome or in a
one-line SceneError.

It never ends in a traceback, a warning, a failed self-check or a finding with a non-numeric value.

Source: the keys of a scene and their ranges; sonify/claims/checks.py. Oracle: the balances that
every run checks; identities and limits of the equations of single parts.
"""

import json
import os
from math import atan, cos, pi, sin
from multiprocessing import get_context
from random import Random

import numpy as np
import pytest
from legal_scenes import any_document, faults_of
from paths import REFERENCES
from scenes import roll

from dynamics.compliant.law.tabulated import EdgeSeriesLaw
from dynamics.compliant.model_inputs import tabulated_contact_law
from dynamics.compliant.stepping.tangential import project_on_friction_circle
from dynamics.steady_motion import max_steady_inclination, steady_precession
from modal import eigenmodes
from modal.spectral.axisymmetric import drawing_mesh_split
from sonify.scene import from_document
from sonify.sound.fluid_loaded_modes import (
    MIN_FILM_MESH_CELLS,
    fluid_loaded_modes,
    mesh_cells,
)

KNOWN = json.loads((REFERENCES / "legal_scenes.json").read_text())
DRAWN_SCENE_COUNT = int(os.environ.get("SONIFY_DRAWN_SCENES", "12"))
"""Number of scenes that are drawn."""
MAX_SECONDS = 2400.0
MOST_REFUSED = 0.6


@pytest.mark.parametrize("name", KNOWN)
def test_a_scene_that_once_failed(name):
    ending, faults = faults_of(KNOWN[name])
    assert not faults
    assert not ending.startswith("SceneError")


def test_the_film_stiffens_the_modes_of_a_light_soft_disk():
    """A trapped film of gap g is a spring under a plate of mass m/A: the frequency is ~ g^(-1/2).

    At any gap the frequency is above zero and below half the sample rate.
    """
    scene = from_document(KNOWN["low_frequency_mode"]).replace(
        "audio.sample_rate=96000"
    )
    modes = eigenmodes(scene, below=200.0).select([0, 1, 2])
    table = fluid_loaded_modes(modes, scene)
    frequency, decay = table.tuning(
        np.linspace(table.log_gap[-1], table.log_gap[0], 500)
    )
    assert (frequency > 0).all()
    assert frequency.max() < scene.audio.sample_rate / 2
    assert (decay >= modes.decay_rate).all()
    gap = np.exp(table.log_gap[[6, 11]])
    stiffened = table.frequency[11] / table.frequency[6]
    assert stiffened == pytest.approx(np.sqrt(gap[0] / gap[1]), rel=0.15)
    assert (table.frequency[6] > 10 * modes.frequency).all()


@pytest.mark.parametrize("moves", [0.0, 20e3])
@pytest.mark.parametrize(
    "name", ["failed_check", "low_frequency_mode", "traceback_contact_spline"]
)
def test_every_spring_of_a_contact_in_series_with_its_disk_is_positive(name, moves):
    """No spring or length is negative; a bound limits the part of the edge."""
    table = tabulated_contact_law(
        from_document(KNOWN[name]), EdgeSeriesLaw, max_moving_frequency=moves
    )
    columns = table.spline(np.linspace(table.grid[0], table.grid[-1], 100_000))
    assert (columns[:, :-1] > 0).all()
    assert (columns[:, -1] >= 0).all()
    alone = table.law.stiffness(table.inclinations)
    assert (
        table.columns(table.inclinations)[:, 0] <= 2**1.5 * alone * (1 + 1e-9)
    ).all()


@pytest.mark.parametrize("ratio", [1.0, 30.0, 1e3, 1e6])
def test_a_sliding_force_lies_on_its_cone(ratio):
    """C p + y p = C p0 with |p| = limit, for any ratio of the two tangential springs."""
    first, second = project_on_friction_circle(
        3.0, 40.0, 1.0, ratio, 2.0, np.hypot(3.0, 40.0)
    )
    assert np.hypot(first, second) == pytest.approx(2.0, rel=1e-9)
    assert 1.0 * (3.0 / first - 1) == pytest.approx(
        ratio * (40.0 / second - 1), rel=1e-9
    )


def test_a_table_that_begins_to_move_gives_no_energy():
    scene = from_document(KNOWN["traceback_contact_spline"])
    motion = roll(scene)
    later = motion.switch_time
    assert 0 < later < motion.t[-1]
    before = motion.first.energy(later)[0]
    after = motion.then.energy(0.0)[0]
    assert after <= before * (1 + 1e-13)
    assert after > 0.99 * before
    assert motion.largest_energy_gain_error() == 0.0


@pytest.mark.parametrize("h", [0.01, 0.17, 0.8, 3.0, 20.0])
@pytest.mark.parametrize("K", [1.0, 2.0])
def test_steady_motions_exist_up_to_the_steepest(h, K):
    """At the limit the height of the centre over the contact's lever, or its inertia, vanishes."""
    steepest = max_steady_inclination(h, K)
    assert steady_precession(0.999 * steepest, h, K) > 0
    lever = cos(steepest) - h * sin(steepest)
    inertia = (1 + 4 * h * h / (3 * K)) * cos(steepest) - 2 * h * sin(steepest)
    assert min(abs(lever), abs(inertia)) < 1e-9 * (1 + h * h)
    assert steepest <= atan(1 / h) < pi / 2
    with pytest.raises(ValueError, match="no steady motion"):
        steady_precession(1.001 * steepest, h, K)


def test_hundreds_of_modes_take_no_longer_over_the_film():
    """The cost is modes times the square of the cells."""
    many = mesh_cells(np.full(600, 40.0))
    assert sum(c**2 for c in many) <= 5e4
    assert min(many) >= MIN_FILM_MESH_CELLS


def test_many_mode_shapes_fit_into_memory():
    """The shapes take at most 0.4 GB: 800 nodes times the cube of the split, three components each.

    Few modes are resolved in full.
    """
    assert drawing_mesh_split(highest_order=20, mode_count=40) == 4
    split = drawing_mesh_split(highest_order=36, mode_count=1400)
    assert 800 * split**3 * 3 * 8 * 1400 <= 4e8


def test_every_legal_scene_ends_with_a_name_and_passes_its_checks():
    drawn = [any_document(Random(seed)) for seed in range(1, DRAWN_SCENE_COUNT + 1)]
    with get_context("spawn").Pool(
        min(2, os.cpu_count() or 1), maxtasksperchild=20
    ) as pool:
        found = pool.map_async(faults_of, drawn, chunksize=1).get(timeout=MAX_SECONDS)
    wrong = [
        (ending, faults, json.dumps(document))
        for document, (ending, faults) in zip(drawn, found, strict=True)
        if faults
    ]
    assert not wrong
    refused = sum(ending.startswith("SceneError") for ending, _ in found)
    assert refused <= MOST_REFUSED * len(drawn)
