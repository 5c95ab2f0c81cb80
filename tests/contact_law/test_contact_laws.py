"""Claim: the elastic contact obeys the laws of Hertz, Mindlin and Kalker, and the disk on it has
the resulting resonances.

Source: Johnson, Contact Mechanics (1985), ch. 4 and 7; Mindlin (1949); Kalker (1990), table E3.
Oracle: elliptic integrals in 30 digits; half-space integrals of the tractions; spheres; values of an
independent prototype; a dense eigenproblem.
"""

import mpmath as mp
import numpy as np
import pytest
from arithmetic import gamma
from contact_elements import elliptical_elements
from contact_scenes import GRANITE, REFERENCE, STEEL, granite, on_springs, prototype
from scipy.integrate import quad

from benchmarks.cases.elastic_steady_motion import stiffness_slope
from dynamics.compliant.law.hertz_mindlin import ElasticConstants
from dynamics.compliant.law.kalker import (
    AXIS_RATIOS,
    KALKER_C11,
    KALKER_C22,
    creep_coefficients,
    slender_creep_coefficients,
)
from dynamics.compliant.law.linearised import (
    linear_contact,
    mobility,
    normal_damping,
    resonances,
    rigid_mode_shapes,
    stiffness_matrix,
)
from dynamics.compliant.law.tabulated import TabulatedLaw


def column(name):
    return np.array([row[name] for row in REFERENCE["static"]])


def on_rounded_edge(contact, beta):
    """Return the inclinations at which the fillet has the curvature of a sharp rim at `beta`."""
    ratio = contact.fillet / contact.disk.radius
    sine = np.sin(beta)
    return np.arcsin(sine * (1 - ratio) / (1 - ratio * sine))


def test_static_numbers():
    """The prototype rolls on a rim of the radius R; the ellipse depends on the curvature alone."""
    contact = granite()
    load = 4.30365
    beta = on_rounded_edge(contact, column("inclination"))
    a, b = contact.semi_axes(beta, load)
    found = (
        a * 1e6,
        b * 1e6,
        contact.approach(beta, load) * 1e6,
        contact.stiffness(beta),
        contact.springs(beta, load).kn,
    )
    for values, name in zip(
        found, ("a_um", "b_um", "approach_um", "K", "kn"), strict=True
    ):
        assert values == pytest.approx(column(name), rel=1e-4)
    assert 1 / mobility(contact.disk, column("inclination"))[:, 2, 2] == pytest.approx(
        column("normal_mass"), rel=1e-4
    )


def test_resonances_of_the_prototype():
    contact = granite()
    beta = column("inclination")
    springs = prototype(contact, on_rounded_edge(contact, beta))
    free = on_springs(rigid_mode_shapes(contact.disk, beta), stiffness_matrix(springs))
    assert free[:, 3:] == pytest.approx(column("free"), rel=1e-4)
    found = resonances(linear_contact(contact.disk, beta, springs, column("speed")))
    assert found.frequency == pytest.approx(column("relaxed")[:, 0], rel=1e-3)
    assert found.loss_factor == pytest.approx(column("relaxed")[:, 1], rel=1e-2)


def test_one_resonance_rings_and_rises():
    """Kalker's creep changes the contact resonance by less than 2 % against constant creep.

    It remains the only lightly damped resonance.
    """
    contact = granite(loss_factor=0.0)
    beta = column("inclination")
    found = TabulatedLaw(law=contact).contact_resonance(
        beta, contact.disk.weight, column("speed")
    )
    rounded = mobility(contact.disk, beta, contact.fillet)[:, 2, 2]
    lighter = np.sqrt(rounded / mobility(contact.disk, beta)[:, 2, 2])
    assert found.frequency == pytest.approx(
        lighter * column("relaxed")[:, 0, 2], rel=0.02
    )
    assert (np.diff(found.frequency) > 0).all()
    assert (found.loss_factor < 0.2).all()
    springs = contact.springs(beta, contact.disk.weight)
    assert (
        resonances(
            linear_contact(contact.disk, beta, springs, column("speed"))
        ).loss_factor[:, :2]
        > 0.5
    ).all()


def test_loss_factor_is_that_of_the_normal_resonance():
    """Without tangential springs the loss factor is exactly 2 zeta of the law."""
    contact = granite(loss_factor=0.03)
    beta = np.array([0.5, 0.01])
    springs = contact.springs(beta, 4.0)
    c = normal_damping(contact, beta, 4.0)
    slides = linear_contact(
        contact.disk,
        beta,
        springs._replace(k1=0.0 * beta, k2=0.0 * beta),
        1.0,
        c,
        fillet=contact.fillet,
    )
    assert resonances(slides).loss_factor[:, 2] == pytest.approx(0.03, rel=1e-9)


def test_sphere():
    """An upright disk with a fillet of its own radius is a sphere.

    N = 4/3 E* sqrt(R) delta^1.5, k = 2 a E*, and k_t is Mindlin's.
    """
    sphere = granite(fillet=0.03755, thickness=0.0751)
    upright = np.array([np.pi / 2])
    radius = 0.03755
    assert sphere.stiffness(upright) == pytest.approx(
        4 / 3 * sphere.modulus * radius**0.5, rel=1e-12
    )
    a, b = sphere.semi_axes(upright, 1.0)
    springs = sphere.springs(upright, 1.0)
    assert a == pytest.approx(b, rel=1e-12)
    assert springs.kn == pytest.approx(2 * a * sphere.modulus, rel=1e-12)
    shear = 1 / sum((2 - m.poisson) / m.shear for m in (STEEL, GRANITE))
    assert springs.k1 == pytest.approx(8 * a * shear, rel=1e-12)
    assert springs.k2 == pytest.approx(springs.k1, rel=1e-12)


@pytest.mark.parametrize("fillet", [5e-5, 1.6e-3, 6.4e-3])
@pytest.mark.parametrize(
    "table", [GRANITE, ElasticConstants(3e9, 0.38), ElasticConstants(400e9, 0.1)]
)
def test_any_fillet_material_and_inclination_in_thirty_digits(fillet, table):
    """Hertz's equation with elliptic integrals in 30 digits agrees to about 100 roundings."""
    contact = granite(fillet=fillet, table=table)
    load = 4.3
    with mp.workdps(30):
        for beta in (1.4, 0.57, 0.01, 1e-6):
            s = mp.sin(mp.mpf(beta))
            A = s / (2 * (mp.mpf(contact.disk.radius) - mp.mpf(fillet) * (1 - s)))
            B = 1 / (2 * mp.mpf(fillet))

            def excess(log_q, ratio=B / A):
                q = mp.e**log_q
                E = mp.ellipe(1 - q * q)
                K = mp.ellipk(1 - q * q)
                return (E / q**2 - K) / (K - E) - ratio

            q = mp.e ** mp.findroot(excess, mp.log(A / B) * 0.636)
            K = mp.ellipk(1 - q * q)
            E = mp.ellipe(1 - q * q)
            J = (K - E) / (1 - q * q)
            modulus = 1 / sum(
                (1 - mp.mpf(m.poisson) ** 2) / mp.mpf(m.young) for m in (STEEL, table)
            )
            a = mp.cbrt(3 * load * J / (2 * mp.pi * modulus * A))
            yields = [
                sum(
                    ((1 - m.poisson) * K + m.poisson * part) / mp.mpf(m.shear)
                    for m in (STEEL, table)
                )
                for part in (J, K - J)
            ]
            exact = [
                a,
                q * a,
                mp.pi * a * modulus / K,
                *(2 * mp.pi * a / y for y in yields),
                3 * load * K / (2 * mp.pi * a * modulus),
            ]
            springs = contact.springs(np.array([beta]), load)
            found = [
                *contact.semi_axes(np.array([beta]), load),
                springs.kn,
                springs.k1,
                springs.k2,
                contact.approach(np.array([beta]), load),
            ]
            assert np.ravel(found) == pytest.approx(
                np.array(exact, dtype=float), rel=gamma(100)
            )


def test_slope_is_that_of_the_stiffness():
    contact = granite()
    beta = np.geomspace(1e-6, 1.2, 9)
    step = 1e-4 * beta
    central = [
        (contact.stiffness(beta + s) - contact.stiffness(beta - s)) / (2 * s)
        for s in (step, 2 * step)
    ]
    assert stiffness_slope(contact, beta) == pytest.approx(
        (4 * central[0] - central[1]) / 3, rel=1e-8
    )


def test_tangential_springs_are_integrals_of_the_tractions():
    """Each line through the centre contributes Q/4 s_0/ab.

    The traction is Q/(2 pi a b) divided by the root of 1 - x^2/a^2 - y^2/b^2.
    """
    contact = granite()
    beta = 0.1
    (a, b) = contact.semi_axes(beta, 4.3)
    springs = contact.springs(beta, 4.3)

    def yields(material, along):
        def line(phi):
            x = np.cos(phi) if along else np.sin(phi)
            reach = 1 / np.hypot(np.cos(phi) / a, np.sin(phi) / b)
            return (
                (1 - material.poisson + material.poisson * x * x) * reach / (4 * a * b)
            )

        return (
            4
            * quad(line, 0, np.pi / 2, epsrel=1e-11, limit=400)[0]
            / (2 * np.pi * material.shear)
        )

    for stiffness, along in ((springs.k1, True), (springs.k2, False)):
        assert 1 / stiffness == pytest.approx(
            yields(STEEL, along) + yields(GRANITE, along), rel=1e-8
        )


def test_creep_table():
    """The creep coefficients equal Kalker's table at its nodes and the line-contact asymptote.

    They are continuous at b/a = 0.1, and the relaxation length tends to a.
    """
    along, across = creep_coefficients(AXIS_RATIOS, 0.25)
    assert along == pytest.approx(KALKER_C11[1], rel=1e-12)
    assert across == pytest.approx(KALKER_C22[1], rel=1e-12)
    for below, above in zip(
        creep_coefficients(0.1 - 1e-9, 0.28),
        creep_coefficients(0.1 + 1e-9, 0.28),
        strict=True,
    ):
        assert below == pytest.approx(above, rel=1e-6)
    for value, limit in zip(
        creep_coefficients(1e-9, 0.28),
        slender_creep_coefficients(1e-9, 0.28),
        strict=True,
    ):
        assert value == pytest.approx(limit, rel=1e-8)
    contact = granite()
    beta = np.geomspace(1e-6, 0.57, 30)
    ratio = np.array(contact.springs(beta, 4.3)[3:]) / contact.semi_axes(beta, 4.3)[0]
    assert ((ratio > 1.05) & (ratio < 1.1 * 1.2)).all(), (
        "the one number 1.1 is right within 20 %"
    )
    assert (np.diff(ratio) > 0).all()


@pytest.mark.parametrize("ratio", [1.0, 0.1, 0.03])
def test_creep_of_a_steadily_rolling_ellipse(ratio):
    """Boundary elements for Poisson's ratio 0; the displacement grows by the creep in each element.

    U = (1/pi G) times the integral of q/r over the ellipse, for both bodies together. With 32
    elements per side the sum has an error of about 1 %.
    """
    x, _, dx, dy, grown = elliptical_elements(ratio, 32 if ratio == 1 else 20)
    found = np.linalg.solve(grown, np.full(len(x), dx)).sum() * dx * dy / ratio
    assert found == pytest.approx(creep_coefficients(ratio, 0.0)[0], rel=0.04)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"fillet": 1e-7}, "at least 2.86e-06"),
        ({"fillet": 0.0}, "positive"),
        ({"fillet": 0.01}, "at most 0.0064"),
    ],
)
def test_wrong_fillets(changes, words):
    with pytest.raises(ValueError, match=words):
        granite(**changes)
