"""Claim: a disk that has turned over sounds as one that has not: its faces are alike.

Source: the mirror symmetry of disk and modes about the middle plane.
Oracle: the sound of the same motion with the faces named the other way round.
"""

from dataclasses import replace

import numpy as np
import pytest

from dynamics import plan_motion
from dynamics.kinematics import turned_over
from dynamics.landing.after_rolling import landed_from_release
from dynamics.landing.landing_motion import LandingMotion
from dynamics.landing.solution import solve_landing
from modal import eigenmodes
from sonify import load_scene
from sonify.sound.render import Renderer

FALL = "release={inclination_deg=3.0, omega=[0.4, -2.0, 1.5]}"


def with_faces_exchanged(motion: LandingMotion) -> LandingMotion:
    """Return the same motion of a disk whose faces have exchanged their names."""
    solution = motion.solution
    start = motion.solution.path(0.0)
    start[[1, 2, 3, 5, 6, 7, 13]] *= -1  # the axis, its rate and the spin
    other = solve_landing(solution.model, start, float(motion.t[-1]))
    return replace(motion, solution=other, start=turned_over(motion.start))


@pytest.mark.slow
@pytest.mark.parametrize(("support", "film"), [("free", "none"), ("contact", "acts")])
def test_a_disk_on_its_other_face_sounds_the_same(support, film):
    scene = load_scene("published").replace(
        FALL,
        f"support.kind={support}",
        f"air.film={film}",
        "numerics.accuracy=draft",
        "numerics.time_limit=0.03",
    )
    motion = landed_from_release(plan_motion(scene), None)
    other = with_faces_exchanged(motion)
    t = np.linspace(0, motion.t[-1], 50)
    own, exchanged = motion.at(t), turned_over(other.at(t))
    whole_turn = np.array([2 * np.pi, *np.zeros(10)])
    assert exchanged == pytest.approx(own + whole_turn, abs=1e-6)
    modes = eigenmodes(scene, below=20e3)
    sounds = [
        np.vstack(list(Renderer(scene, one, modes).blocks())) for one in (motion, other)
    ]
    assert len(sounds[0]) == len(sounds[1])
    loudest = np.abs(sounds[0]).max()
    assert loudest > 1e-4  # Pa
    # the integrations of both motions round differently
    assert np.abs(sounds[0] - sounds[1]).max() < 1e-3 * loudest
