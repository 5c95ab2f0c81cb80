"""Claim: the eigenvalues of a disk that turns on one mode of a table predict where its steady
motion becomes unstable.

Source: the docstring of campbell.py. Oracle: the limit of a heavy table; the crossing of the
nutation with the wave that runs against the contact; the time steps of the two-way motion, which do
not use eigenvalues.
"""

import numpy as np
import pytest

from benchmarks.charts.campbell_chart import (
    FLUTTER_SPEED,
    MODE,
    conclusion,
    draw,
    expected_growth,
    flutter_growth,
    growth_by_steps,
    is_divergent,
)
from benchmarks.methods.campbell import campbell_diagram
from dynamics.surface import SurfaceMode
from sonify.scene import load_scene

MODES = [
    (n, mass, zeta)
    for n in (2, 3, 5)
    for mass, zeta in ((20.0, 0.02), (50.0, 0.005), (200.0, 0.002))
]


@pytest.fixture(scope="module")
def disk():
    return load_scene("published").disk


def mode(n, mass, zeta, frequency=600.0):
    return SurfaceMode(
        order=n, frequency=frequency, damping_ratio=zeta, modal_mass=mass
    )


def nutation(disk):
    """Return the ratio of nutation to precession of a smooth disk on a rigid table.

    It is (3 J/(J + m R^2))^0.5, with the moment of inertia J written out.
    """
    J = 1 / 4 + disk.aspect**2 / 3
    return (3 * J / (J + 1)) ** 0.5


def test_on_a_heavy_table_disk_and_waves_go_their_ways(disk):
    n = 3
    zeta = 0.01
    x = np.array([0.4, 0.8, 1.2, 2.0])
    seen = campbell_diagram(disk, mode(n, 1e9, zeta), x)
    turning = nutation(disk)
    assert turning == pytest.approx(0.786, abs=5e-4)
    w = n / x  # over Omega
    for i, found in enumerate(seen.eigenvalue / seen.omega[:, None]):
        waves = [
            s * n + side * w[i] * (1 - zeta**2) ** 0.5
            for s in (1, -1)
            for side in (1, -1)
        ]
        due = np.array(
            [*(1j * np.array(waves) - zeta * w[i]), 1j * turning, -1j * turning, 0, 0]
        )
        assert (
            np.abs(found[:, None] - due).min(axis=1).max() < 1e-3
        )  # a double root is known to the square root
        assert np.abs(found[:, None] - due).min(axis=0).max() < 1e-3


@pytest.mark.parametrize(("n", "mass", "zeta"), MODES)
def test_divergence_below_the_resonance_and_flutter_of_the_nutation_above(
    disk, n, mass, zeta
):
    crossing = n / (n - nutation(disk))
    x = np.sort(np.append(np.linspace(0.5, 1.5 * crossing, 400), crossing))
    undamped = campbell_diagram(disk, mode(n, mass, 0.0), x)
    damped = campbell_diagram(disk, mode(n, mass, zeta), x)
    wide = x[is_divergent(undamped)]
    assert 0.85 < wide[0] < wide[-1] < 1
    assert np.diff(np.flatnonzero(is_divergent(undamped))).max() == 1
    growth = np.where(x > 1.1, flutter_growth(damped), 0.0)
    assert x[growth.argmax()] == pytest.approx(crossing, rel=0.01)
    at = damped.eigenvalue[growth.argmax()]
    assert abs(at[at.real.argmax()].imag) / damped.omega[
        growth.argmax()
    ] == pytest.approx(nutation(disk), rel=0.02)


def test_the_steps_flutter_as_the_eigenvalues_say():
    """The precession drifts by 1 % during the test, and the growth rate by 1 % of its maximum."""
    for x in (FLUTTER_SPEED, 1.05 * FLUTTER_SPEED):
        assert growth_by_steps(MODE, x, 2e5).real == pytest.approx(
            expected_growth(MODE, x), abs=0.03 * expected_growth(MODE, FLUTTER_SPEED)
        )


def test_its_picture_and_its_conclusion(tmp_path):
    draw([], "Campbell", tmp_path / "campbell.png")
    assert (tmp_path / "campbell.png").stat().st_size > 1e4
    assert "flutters most at x = 1.64" in conclusion([])[0]


def test_what_is_no_speed_or_no_wave_is_refused(disk):
    for wrong in (
        (mode(0, 1.0, 0.0), 1.0),
        (mode(2, 1.0, 0.0), 0.0),
        (mode(2, 1.0, 0.0), np.nan),
    ):
        with pytest.raises(ValueError, match="campbell: needs"):
            campbell_diagram(disk, *wrong)
    light = campbell_diagram(disk, mode(4, 1e-3, 0.0), 0.9)
    assert np.isnan(light.eigenvalue).all() or (light.inclination > 0).all()
