"""Claim: a disk whose face meets the table fell or sank, by the speed of its face; speed and energy
are those of the impact.

Source: dynamics/face_contact.py. Oracle: closed forms for a disk without precession: the energy of
a free fall, on a frictionless table and on one that holds the contact, and the terminal speed of a
fall against a viscous moment.
"""

from math import cos, degrees, radians, sin, sqrt

import pytest
from scenes import roll

from dynamics import Outcome
from dynamics.disk import GRAVITY
from sonify import load_scene
from sonify.plan.plan import omissions_after_end

RADIUS = 0.03755
HALF = 0.0064
MASS = 0.4387
WEIGHT = MASS * GRAVITY
ABOUT_DIAMETER = MASS * (RADIUS**2 / 4 + HALF**2 / 3)
NO_MOMENTS = "arm_nutation=0,arm_rolling=0,arm_pivoting=0"


def released(inclination, *changes, mu="0"):
    """Return the scene of a disk at rest at an inclination [rad], without moments."""
    friction = f"friction={{mu_static={mu},mu_dynamic={mu},{NO_MOMENTS}}}"
    release = f"release={{inclination_deg={degrees(inclination)},omega=[0,0,0]}}"
    return load_scene("published").replace(friction, release, *changes)


def lost_height(inclination):
    """Return the height [m] by which the centre falls until the disk lies flat."""
    return RADIUS * sin(inclination) - 2 * HALF * sin(inclination / 2) ** 2


@pytest.mark.parametrize("inclination", [1e-3, radians(5)])
@pytest.mark.parametrize("mu", ["0", "inf"])
def test_a_disk_that_falls_without_resistance_meets_the_table_with_its_energy(
    inclination, mu
):
    """At 1e-3 rad without friction the far rim has 48.37 mm/s and 161.6 uJ."""
    motion = roll(released(inclination, mu=mu))
    assert motion.rolling_outcome is Outcome.FELL
    (event,) = motion.events
    energy = WEIGHT * lost_height(inclination)
    assert event.energy == pytest.approx(energy, rel=1e-6)
    about_contact = ABOUT_DIAMETER + MASS * RADIUS**2
    if mu == "inf":  # the centre also moves towards the contact
        about_contact += MASS * HALF**2
    speed = 2 * RADIUS * sqrt(2 * energy / about_contact)
    assert event.speed == pytest.approx(
        speed, rel=5e-4
    )  # the lever shortens by 1 - cos
    assert event.kind == "fell onto its face"
    assert event.t == motion.t[-1]
    if mu == "0" and inclination == 1e-3:
        assert event.speed == pytest.approx(48.37e-3, rel=1e-3)
        assert event.energy == pytest.approx(161.6e-6, rel=1e-3)


@pytest.mark.parametrize(
    ("damping", "inclination", "outcome"),
    [(1.0, 2e-3, Outcome.FELL), (10.0, 2e-4, Outcome.SANK)],
)
def test_against_a_viscous_moment_a_disk_falls_or_sinks_at_its_terminal_speed(
    damping, inclination, outcome
):
    """The moment c w balances weight times lever; 12.1 mm/s is a fall, 1.21 mm/s is none."""
    resisted = f"dissipation.viscous_moment={damping}"
    motion = roll(released(inclination, resisted))
    (event,) = motion.events
    assert motion.rolling_outcome is outcome
    assert outcome.lies_flat
    beta, nutation = motion.state[-1, [1, 5]]
    terminal = WEIGHT * (RADIUS * cos(beta) - HALF * sin(beta)) / damping
    assert nutation == pytest.approx(terminal, rel=0.01)
    assert event.speed == pytest.approx(2 * RADIUS * terminal, rel=0.01)
    kinetic = (ABOUT_DIAMETER + MASS * RADIUS**2) * terminal**2 / 2
    assert event.energy == pytest.approx(kinetic, rel=0.02)


def test_only_a_fall_leaves_out_an_impact():
    """The plan states speed and energy; a disk that sinks makes no impact to be left out."""
    fell = roll(released(1e-3))
    sank = roll(released(2e-4, "dissipation.viscous_moment=10"))
    assert any(
        "impact of the face" in sentence for sentence in omissions_after_end(fell)
    )
    assert omissions_after_end(sank) == []


def test_a_disk_that_settles_has_no_event(motion):
    assert motion.rolling_outcome is Outcome.SETTLED
    assert motion.events == ()
