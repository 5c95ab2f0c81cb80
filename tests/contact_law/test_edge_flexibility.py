"""Claim: the bending of the disk lowers its contact resonance, and the filter and the full model
predict the same resonance as the modes.

Source: the springs of the contact and of the disk in series at the contact resonance. Oracle: the
modes of the elastic disk on its contact, which do not use the series (modal/spring_supported.py); a
rigid disk.
"""

import numpy as np
import pytest
from contact_scenes import steady_speed

from dynamics.compliant.law.linearised import suspension
from dynamics.compliant.law.tabulated import EdgeSeriesLaw, TabulatedLaw
from dynamics.compliant.model_inputs import tabulated_contact_law
from modal.solve import free_plate
from modal.spring_supported import contact_modes
from sonify import load_scene

INCLINATIONS = 0.57, 0.1, 0.01, 1e-3, 1e-4


def ringing(scene, beta):
    """Return frequency [Hz] and loss factor of the least damped mode below the first free one."""
    table = tabulated_contact_law(scene)
    modes = contact_modes(
        free_plate(scene), suspension(table.law, beta), beta, 24e3, "standard"
    )
    loss = (
        2 * modes.decay_rate / np.hypot(2 * np.pi * modes.frequency, modes.decay_rate)
    )
    first = 0.95 * scene.elastic_edge.squared.min() ** 0.5 / (2 * np.pi)
    i = min(np.flatnonzero(modes.frequency < first), key=lambda i: loss[i])
    return modes.frequency[i], loss[i]


@pytest.mark.parametrize(
    ("name", "angles"), [("granite", INCLINATIONS), ("coin-polished", INCLINATIONS[:3])]
)
def test_the_filter_rings_as_the_elastic_disk_does(name, angles):
    """The series is exact without losses; its error is of second order in the loss factor."""
    scene = load_scene(name)
    table = tabulated_contact_law(scene)
    for beta in angles:
        found = table.contact_resonance(
            np.array([beta]), scene.disk.weight, steady_speed(table.law, beta)
        )
        frequency, loss = ringing(scene, beta)
        assert found.frequency[0] == pytest.approx(frequency, rel=1e-3 + loss**2 / 8)
        energy = (
            (2 * np.pi * frequency) ** 2 / table.edge.squared.min()
        )  # kinetic energy of the body, which a spring lacks
        assert found.loss_factor[0] == pytest.approx(loss, rel=0.02 + energy / 2)


@pytest.mark.parametrize(
    ("name", "angles", "off"),
    [("granite", INCLINATIONS, 0.01), ("coin-polished", INCLINATIONS[1:3], 0.02)],
)
def test_the_springs_of_the_full_motion_have_the_carrier_but_for_what_couples_them(
    name, angles, off
):
    """The springs of the full motion neglect the flexibility that couples a_2 and a_3."""
    scene = load_scene(name)
    for beta in angles:
        speed = steady_speed(tabulated_contact_law(scene).law, beta)
        (frequency, _) = ringing(scene, beta)
        found = tabulated_contact_law(scene, EdgeSeriesLaw).contact_resonance(
            np.array([beta]), scene.disk.weight, speed
        )
        assert found.frequency[0] == pytest.approx(frequency, rel=off)


def test_a_rigid_body_and_a_shell_have_hertz_springs_alone():
    scene = load_scene("granite")
    beta = np.array([0.1])
    rigid, bends = (
        tabulated_contact_law(scene.replace(f"contact.body={body}"))
        for body in ("rigid", "elastic")
    )
    assert rigid.edge is None
    assert load_scene("hoop").elastic_edge is None
    assert not rigid.flexibility(beta).any()
    assert bends.columns(beta) == pytest.approx(rigid.columns(beta), rel=1e-14)
    hertz, series = (
        tabulated_contact_law(scene, kind).springs(beta, 4.0)[0]
        for kind in (TabulatedLaw, EdgeSeriesLaw)
    )
    creep = [s.k2 / s.length2**-1 for s in (hertz, series)]
    assert creep[0] == pytest.approx(creep[1], rel=1e-12)


def test_a_sharp_edge_bends_the_disk_as_a_round_one_does():
    """A sharp edge has softer springs on the same body, so the body's share is smaller.

    The polynomials through the thickness would not resolve a strip of 0.05 mm.
    """
    shares = []
    stiffness = []
    for fillet in (1.6e-3, 5e-5):
        scene = load_scene("granite").replace(
            f"contact.fillet={fillet}", "contact.body=rigid"
        )
        rigid = tabulated_contact_law(scene)
        one = np.array([0.1])
        speed = steady_speed(rigid.law, 0.1)
        alone = rigid.contact_resonance(one, scene.disk.weight, speed).frequency[0]
        shares.append(1 - ringing(scene, 0.1)[0] / alone)
        stiffness.append(rigid.springs(one, scene.disk.weight)[0].kn[0])
    assert shares[1] / shares[0] == pytest.approx(stiffness[1] / stiffness[0], rel=0.1)
