"""Claim: the film under a ring, such as a washer, is that of its face, with the ambient pressure at
its rim and in its hole; it slows the ring, lifts it off the table, and lets it sink.

Source: Reynolds' equation, incompressible and quasi-steady. Oracle: the closed form of a level ring;
the strip of a narrow ring at any tilt, in which the air flows across; the solid disk as the hole
closes; the solved motion over a hole in the table, which has the same film; the energy balance.
`test_film_over_hole.py` compares the film with finite volumes.
"""

import numpy as np
import pytest
from scenes import energy_spread, smooth_toy
from scipy.integrate import quad

from dynamics import Outcome, simulate
from dynamics.film.annular_film import annular_resistance
from dynamics.film.tilted_film import film_below
from dynamics.film.wedge import film_of_scene, film_under, hole_share
from dynamics.landing.lift_off import predict_lift_off
from dynamics.motion_plan import plan_motion
from dynamics.observables import precession_rate
from sonify import SceneError, load_scene

LATE = ("release.inclination_deg=2", "release.omega=[0.0,0.7,4.9]")
FILLET = 1.6e-3


def ring(wall, *changes):
    """Return a ring with the outer dimensions and the mass of the toy, rolling at 2 degrees."""
    shape = {"disk.shape": "shell", "disk.wall": wall}
    return smooth_toy(*LATE, shape, *changes)


@pytest.mark.slow
def test_the_film_is_that_over_a_hole_of_the_same_size_in_the_table():
    washer = ring(0.0075)
    share = (0.03755 - 0.0075) / (0.03755 - FILLET)
    assert hole_share(washer) == pytest.approx(share)
    found = film_of_scene(washer)
    assert found.hole == film_under(washer.disk, washer.air, 0.0, share).hole
    below = film_below(0.03755, FILLET, washer.air, hole=2 * 0.03005)
    landing = simulate(washer).landing
    assert landing.model.film == below


def test_of_two_holes_the_larger_one_counts():
    washer = ring(0.0075)
    assert hole_share(washer.replace("surface={hole=0.03}")) == hole_share(washer)
    wide = hole_share(washer.replace("surface={hole=0.065}"))
    assert wide == pytest.approx(0.0325 / 0.03595)


@pytest.mark.slow
def test_a_level_ring_meets_the_resistance_of_an_annular_squeeze_film():
    """F = -3 pi mu z'/(2 h^3) (b^4 - a^4 - (b^2 - a^2)^2/ln(b/a))."""
    air = ring(0.0075).air
    gap, a, b = 30e-6, 0.03005, 0.03595
    film = film_below(0.03755, FILLET, air, hole=2 * a)
    film = film._replace(mean_free_path=0.0, fillet=0.0)
    square = b**4 - a**4 - (b**2 - a**2) ** 2 / np.log(b / a)
    expected = 3 * np.pi * air.viscosity / (2 * gap**3) * square
    assert film.resistance(gap, 0.0).heave == pytest.approx(expected, rel=0.01)


def strip(tilt, weight):
    """Return the integral of weight(angle) w^3/(12 h^3) round a narrow ring of unit width, with
    the gap in its middle.

    The air flows across the strip: p'' = 12 mu v/h^3, so that its force is mu v w^3/h^3 for a unit
    length; 12 mu is the unit of the resistances."""
    return quad(
        lambda phi: weight(phi) / (12 * (1 + tilt * np.cos(phi)) ** 3), 0, 2 * np.pi
    )[0]


@pytest.mark.parametrize("tilt", [0.0, 0.5, 0.9])
def test_air_flows_across_a_narrow_ring(tilt):
    """The error is that of the square of the width, 1 % of the radius, over the distance in which
    the gap changes."""
    width = 0.01
    found = annular_resistance(1 - width, tilt)
    mean = 1 - width / 2
    slope = tilt * mean
    unit = width**3 * mean
    expected = [
        unit * strip(slope, lambda phi: 1.0),
        unit * mean * strip(slope, np.cos),
        unit * mean**2 * strip(slope, lambda phi: np.cos(phi) ** 2),
        unit * mean**2 * strip(slope, lambda phi: np.sin(phi) ** 2),
    ]
    assert list(found) == pytest.approx(expected, rel=0.02, abs=1e-3 * unit)


def test_a_ring_with_a_small_hole_rolls_like_a_disk():
    """Moments of inertia differ by 1e-6, and the drag of the film by 1 % over all inclinations."""
    solid = smooth_toy(*LATE)
    pierced = ring(0.03755 * (1 - 1e-3))
    beta, omega = np.array([1e-2, 1e-3]), (0.0, 0.0, 1.0)
    drag = [
        film_of_scene(one).rotation_and_fall_powers(beta, omega)[0]
        for one in (pierced, solid)
    ]
    thin_air = [
        film_of_scene(one.replace("air.pressure=1e9")).moments_at(beta, omega)[0]
        for one in (pierced, solid)
    ]
    assert thin_air[0] == pytest.approx(thin_air[1], rel=0.02)
    assert drag[0] == pytest.approx(drag[1], rel=0.2)  # the compression is left out


@pytest.mark.slow
@pytest.mark.parametrize("wall", [0.0075, 0.02])
def test_the_film_lifts_a_ring_off_the_table(wall):
    scene = ring(wall)
    motion = simulate(scene)
    rolling = motion.rolling
    assert energy_spread(rolling) < 1e-9
    assert rolling.rolling_outcome is Outcome.AIRBORNE
    predicted = predict_lift_off(scene.disk, scene.air, hole=hole_share(scene))
    last = rolling.at(rolling.t[-1])
    assert predicted.inclination == pytest.approx(last[0, 1], rel=0.1)
    rate = abs(precession_rate(last)[0])
    assert predicted.precession_rate == pytest.approx(rate, rel=0.2)
    kinds = [event.kind for event in motion.events]
    assert kinds[0] == "lifted by the film"
    assert motion.outcome is Outcome.AT_REST


def test_air_decides_the_film_of_a_ring():
    assert plan_motion(ring(0.0075)).film is not None
    assert plan_motion(ring(0.0075, "air.pressure=0")).film is None
    many = ("contact.law=elastic", "numerics.contact=many", "roughness.rms=1e-6")
    assert plan_motion(ring(0.0075, *many)).film is None


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (({"disk.wall": 0.001}, "air.film=acts"), "disk.wall must exceed the rounded"),
        (({"disk.wall": None}, "air.film=acts"), "disk.wall must exceed the rounded"),
        (
            (
                "contact.law=elastic",
                "roughness.rms=1e-6",
                "numerics.contact=many",
                "air.film=acts",
            ),
            "without contacts anywhere on the rim",
        ),
    ],
)
def test_an_impossible_film_is_one_line(changes, message):
    with pytest.raises((SceneError, ValueError)) as caught:
        plan_motion(ring(0.0075, *changes))
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


def test_the_page_of_a_ring_says_what_its_film_neglects():
    from sonify.plan.air import film_sentences

    modelled, neglected = film_sentences(ring(0.0075))
    assert "into its hole of 0.0601 m" in modelled[1]
    assert neglected[0].startswith("The effect of the film on the sound of the ring")
    hole = load_scene("toy").replace("surface={hole=0.03}")
    assert "in the table" in film_sentences(hole)[0][-1]
