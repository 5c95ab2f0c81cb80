"""Claim: the film under a tilted disk is that of Reynolds' equation, at any tilt, height and bowl.

Source: Reynolds' equation, incompressible and quasi-steady.
Oracle: closed forms of a level disk; a separable solution in bipolar coordinates, and the integral
of the film that closes at the rim, both computed elsewhere; the equation of a sinking disk.
"""

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

from dynamics import Disk
from dynamics.film.conformal_reynolds import film_resistance
from dynamics.film.tilted_film import TiltedFilm, tabulated_resistance

BIPOLAR = {  # tilt: heave, heave + coupling, heave + 2 coupling + along, across
    0.1: (0.39541817, 0.38055351, 0.39920432, 0.03292561),
    0.3: (0.41865959, 0.37047388, 0.36277253, 0.03462818),
    0.5: (0.47493731, 0.37963772, 0.34320261, 0.03865726),
    0.8: (0.72117787, 0.45221398, 0.34433289, 0.05479004),
    0.9: (0.96398522, 0.51482752, 0.35634894, 0.06842627),
    0.95: (1.22406471, 0.56749289, 0.36632857, 0.08064188),
    0.99: (1.76433330, 0.63722890, 0.37740937, 0.09841983),
    0.999: (2.21418789, 0.66270753, 0.38045476, 0.10564549),
}
"""Separable solution in bipolar coordinates, to the digits printed."""
CLOSED = (2.47520396, 0.66638869, 0.38080886, 0.10676079)
"""The same functions of the film that closes at the rim, by integrals of Bessel functions."""
DISK = Disk(radius=0.03755, thickness=0.0128, mass=0.4387)
FILM = TiltedFilm(viscosity=1.82e-5, radius=DISK.radius)


def about_rim(resistance):
    """Return heave, and the resistances to a rotation about the low point of the rim."""
    heave, coupling, along, across = resistance
    return heave, heave + coupling, heave + 2 * coupling + along, across


@pytest.mark.parametrize(("tilt", "expected"), BIPOLAR.items())
def test_the_collocation_is_the_bipolar_solution(tilt, expected):
    assert about_rim(film_resistance(tilt)) == pytest.approx(expected, abs=1e-8)


@pytest.mark.parametrize(("tilt", "expected"), [*BIPOLAR.items(), (1.0, CLOSED)])
def test_the_table_is_the_bipolar_solution(tilt, expected):
    assert about_rim(tabulated_resistance(tilt)) == pytest.approx(expected, rel=1e-4)


@pytest.mark.parametrize("depth", [0.0, 0.5, 20.0])
def test_a_level_disk_has_closed_forms(depth):
    level = film_resistance(0.0, depth)
    assert level.heave == pytest.approx(np.pi / 8 / (1 + depth), rel=1e-8)
    assert level.coupling == pytest.approx(0, abs=1e-12)
    if depth == 0:
        assert level.along == pytest.approx(np.pi / 96, rel=1e-8)
    assert level.across == pytest.approx(level.along, rel=1e-8)


def test_a_concave_table_has_the_values_of_a_galerkin_solution():
    expected = (0.135668, -0.015623, 0.009601, 0.007518)
    assert film_resistance(0.5, 2.0) == pytest.approx(expected, rel=1e-4)
    assert tabulated_resistance(0.5, 2.0) == pytest.approx(expected, rel=2e-4)


def test_the_table_is_the_solution_between_its_nodes():
    generator = np.random.default_rng(3)
    for _ in range(12):
        opening, share = generator.uniform(0.05, 1), generator.uniform(0, 0.95)
        arguments = 1 - opening**2, share / (1 - share)
        expected = about_rim(film_resistance(*arguments))
        assert about_rim(tabulated_resistance(*arguments)) == pytest.approx(
            expected, rel=1e-4
        )


@pytest.mark.parametrize(
    ("gap", "final", "changes", "time"),
    [
        (20e-6, 5e-6, {}, 0.74288),
        (20e-6, 1e-6, {}, 19.7605),
        (20e-6, 5e-6, {"mean_free_path": 66.3e-9}, 0.70385),
        (20e-6, 1e-6, {"mean_free_path": 66.3e-9}, 15.6996),
        (20e-6, 5e-6, {"depth": 107.93e-6}, 0.05077),
        (20e-6, 1e-6, {"depth": 107.93e-6}, 0.33909),
        pytest.param(
            20e-6,
            5e-6,
            {"depth": 1e-5, "radius": 0.03595, "hole": 0.05},
            0.008706,
            marks=pytest.mark.slow,
        ),
    ],
)
def test_a_level_disk_sinks_in_the_closed_time(gap, final, changes, time):
    film = FILM._replace(**changes)
    assert film.sink_time(gap, final, DISK.weight) == pytest.approx(time, rel=2e-4)
    found = solve_ivp(
        lambda t, z: [-film.sink_rate(z[0], DISK.weight)],
        (0, time),
        [gap],
        rtol=1e-9,
        atol=1e-15,
    )
    assert found.y[0, -1] == pytest.approx(final, rel=1e-3)


def test_the_edge_seals_the_film_within_its_rounding():
    radius, fillet, gap = 0.03595, 0.0016, 28e-6
    film = TiltedFilm(viscosity=1.82e-5, radius=radius, fillet=fillet)

    def pressure_at(r, seal):
        return quad(lambda s: s / thickness(s) ** 3, r, seal, epsabs=0, limit=200)[0]

    def thickness(r):
        inside = max(r - radius, 0.0)
        return gap + fillet - np.sqrt(fillet**2 - inside**2)

    outside = radius + 0.6 * fillet
    force = quad(lambda r: r * pressure_at(r, outside), 0, outside, epsrel=1e-8)[0]
    flat = film.ambient_pressure_radius(gap) ** 4 / (8 * gap**3)
    assert force == pytest.approx(flat, rel=1e-3)
