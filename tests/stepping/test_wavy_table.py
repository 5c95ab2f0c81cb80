"""Claim: a wavy table breaks the contact when its waves outweigh the inclination of the disk, and
not before.

Source: the docstring of claims.table.waves_break_contact. Oracle: (n^2 - 1) delta/R, since other
programs find the first loss at 0.7 to 1.8 times this value; energies of the states; the disk on a
table without waves.
"""

import numpy as np
import pytest
from table_models import GRIPS, energy_error, run, steady

from dynamics.compliant.law.sections import Imperfection
from dynamics.compliant.law.tabulated import TabulatedLaw
from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.state_conversion import (
    columns,
    preloaded_compliant_state,
)
from dynamics.compliant.stepping.model import CompliantModel
from sonify import SceneError, load_scene
from sonify.plan.preflight import check_solvable_scene


@pytest.fixture(scope="module")
def wavy():
    return load_scene("wavy")


def fall(scene, order, amplitude, start, stop=3.0, friction=None, rate=4e5):
    """Return model, initial energy, times, states and losses of contact of a disk.

    It is released in steady motion at the inclination `start` [rad].
    """
    model = CompliantModel(
        tabulated_law=TabulatedLaw(law=contact_law(scene)),
        friction=friction or scene.friction,
        rate=rate,
        imperfection=Imperfection(order=order, amplitude=amplitude),
    )
    return model, *run(
        model,
        preloaded_compliant_state(model, steady(contact_law(scene), start)[0]),
        4,
        stop,
    )[:4]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("order", "amplitude", "is_stiff"),
    [
        *((order, 1e-6, False) for order in (2, 3, 4)),
        (2, 1e-5, True),
        (3, 1e-6, True),
        (2, 1e-7, True),
        (3, 1e-7, True),
        (7, 1e-8, True),
    ],
)
def test_where_contact_is_first_lost(wavy, order, amplitude, is_stiff):
    """The waves are higher than the static compression of the contact; lower waves come near its
    resonance. A contact a hundred times as stiff as granite on steel loses contact on waves down to
    a hundredth of a micrometre."""
    scale = (order**2 - 1) * amplitude / wavy.disk.radius
    if is_stiff:
        stiff = wavy.replace("contact.young=6e12", "material.young=1.95e13")
        found = fall(stiff, order, amplitude, 2.2 * scale, 0.7, rate=2e6)
    else:
        found = fall(wavy, order, amplitude, 4 * scale)
    model, first, t, state, losses = found
    assert 0.7 < np.interp(losses[0].t, t, columns(model, state)[:, 1]) / scale < 1.8
    assert energy_error(model, state, first) < 1e-9


def test_a_hundredth_of_the_wave_is_not_felt(wavy):
    """The inclination after 50 ms equals that on a table without waves, within the effect of the
    wave."""
    beta = 1e-3
    found = [
        columns(model, state[-1:])[0, 1]
        for model, _, _, state, losses in (
            fall(wavy, 3, amplitude, beta, 0.05, GRIPS) for amplitude in (1e-8, 1e-12)
        )
        if not losses
    ]
    assert found[0] == pytest.approx(found[1], rel=8 * 1e-8 / wavy.disk.radius / beta)


def test_what_is_not_solved_with_waves_is_refused_in_one_line(wavy):
    plate = "surface={kind='plate', radius=0.1, thickness=0.01, young=7e10, poisson=0.22, density=2500.0}"
    for change, said in (
        (("contact.law=rigid",), "contact.law"),
        (("numerics.contact=filter",), "numerics.contact"),
        ((plate, "surface.action=motion"), "not available for a wavy table"),
        (("imperfection.order=1",), "imperfection.order"),
        (("imperfection.amplitude=0.0",), "imperfection.amplitude"),
    ):
        with pytest.raises(SceneError, match=said) as caught:
            check_solvable_scene(wavy.replace(*change), None)
        assert len(str(caught.value).splitlines()) == 1
