"""Claim: height profiles have the specified spectrum, are averaged exactly over the contact
ellipse, and depend only on the seed.

Source: the definition of a Gaussian profile with a power spectrum k^-p; Hertz's pressure along the
path. Oracle: explicit sums of the waves; numerical averages; statistics of many waves.
"""

import numpy as np
import pytest
from scipy.integrate import quad

from dynamics.compliant.law.height_profile import (
    SMOOTH_PROFILE,
    mean_heights,
    profile_from_csv,
)
from dynamics.compliant.law.roughness import (
    edge_profile,
    ellipse_window,
    shift_of_contact,
    spectral_density,
    table_profile,
    wave_spectrum,
)
from dynamics.compliant.law.sections import Roughness, require_resolved_waves

ROUGH = Roughness(rms=3e-8, shortest=1e-4, longest=0.1)


def read(profile, s, a):
    s, a = np.atleast_1d(s).astype(float), np.full(np.size(s), a)
    return mean_heights(profile, s, a)


@pytest.mark.parametrize("exponent", [0.0, 2.0])
def test_rms_and_spectrum(exponent):
    """Mean squares of n independent waves scatter by sqrt(2/n); the tolerance is five times that.

    The test covers whole profiles and one octave.
    """
    rough = Roughness(rms=3e-8, shortest=1e-3, longest=0.1, exponent=exponent)
    profile = table_profile(rough)
    k, power = wave_spectrum(rough, profile.period)
    assert power.sum() == pytest.approx(rough.rms**2)
    n = len(profile.coefficients) - 5
    z = read(profile, np.arange(n) / profile.cells_per_metre, 1e-5)
    waves = 2 * np.abs(np.fft.rfft(z) / n) ** 2
    octave = (k > 100) & (k < 200)
    for part in (slice(None), octave):
        scatter = (2 * np.sum(power[part] ** 2)) ** 0.5 / power[part].sum()
        found = waves[np.rint(k[part] * profile.period / (2 * np.pi)).astype(int)].sum()
        assert found == pytest.approx(power[part].sum(), rel=5 * scatter)


@pytest.mark.parametrize("a", [1e-4, 2.5e-4, 6e-3])
def test_one_wave_is_read_as_the_window_says(tmp_path, a):
    """The mean height of a 1 mm cosine is window(ka) times its value at any position.

    A quintic spline with cells d turns (kd/(2 pi -+ kd))^6 of a wave into its first aliases; their
    slopes enter the tolerance.
    """
    length = np.linspace(0, 0.01, 161)
    file = tmp_path / "wave.csv"
    file.write_text(
        "length;height\n"
        + "\n".join(f"{x:.17g};{np.cos(2e3 * np.pi * x):.17g}" for x in length)
    )
    s = np.array([-123.4567, 0.0, 1.234e-3, 5.4321, 98765.4321])
    k = 2e3 * np.pi
    cell = 0.01 / 160
    expected = ellipse_window(k * a) * np.cos(k * s)
    alias = k * cell / (2 * np.pi - k * cell * np.array([1, -1]))
    bound = 3 * sum(alias**5) / (k * a) ** 2 + 3 * sum(alias**6) / (k * a) ** 3
    assert read(profile_from_csv(file), s, a) == pytest.approx(expected, abs=bound)


def test_window_is_the_mean_under_hertz_pressure():
    for ka in (1e-3, 0.5, 7.0):
        mean = quad(lambda x, ka=ka: 0.75 * (1 - x * x) * np.cos(ka * x), -1, 1)[0]
        assert ellipse_window(ka) == pytest.approx(mean, rel=1e-9)


def test_edge_is_periodic_and_table_is_long():
    edge = edge_profile(ROUGH, 0.03755)
    table = table_profile(ROUGH)
    assert edge.period == pytest.approx(2 * np.pi * 0.03755, rel=1e-14)
    s = np.linspace(0, 0.1, 50)
    assert read(edge, s + 40 * edge.period, 3e-4) == pytest.approx(
        read(edge, s, 3e-4), abs=1e-7 * ROUGH.rms
    )
    assert table.period >= 64 * ROUGH.longest


def test_seed_decides_and_block_size_does_not():
    again = table_profile(ROUGH)
    other = table_profile(Roughness(rms=3e-8, seed=1))
    s = np.linspace(0, 2000, 1001)
    whole = read(again, s, 3e-4)
    assert (
        whole.tobytes()
        == np.concatenate(
            [read(table_profile(ROUGH), part, 3e-4) for part in np.split(s, [7, 500])]
        ).tobytes()
    )
    assert abs(np.corrcoef(whole, read(other, s, 3e-4))[0, 1]) < 5 / 1001**0.5
    assert (
        abs(np.corrcoef(whole, read(edge_profile(ROUGH, 0.03755), s, 3e-4))[0, 1])
        < 5 / 1001**0.5
    )
    assert not read(SMOOTH_PROFILE, s, 3e-4).any()


def test_a_measured_profile(tmp_path):
    """A profile keeps the measured heights, loses its tilt and repeats an edge once per turn."""
    rng = np.random.default_rng(1)
    length = np.linspace(0, 0.02, 401)
    z = np.convolve(rng.normal(size=401), np.hanning(41) / 20, "same") * 1e-7
    file = tmp_path / "stylus.csv"
    np.savetxt(
        file,
        np.column_stack([length, z + 1e-3 * length + 5e-6]),
        delimiter=",",
        header="length, height",
    )
    level = z - np.polynomial.Polynomial.fit(length, z, 1)(length)
    assert read(profile_from_csv(file), length[20:-20], 1e-6) == pytest.approx(
        level[20:-20] - mean(level), abs=2e-9
    )
    assert profile_from_csv(file, period=0.236).period * 6 == pytest.approx(0.236)


def mean(level):
    """Return the mean of the mirrored profile; each end counts once."""
    return (2 * level[1:-1].sum() + level[0] + level[-1]) / (2 * len(level) - 2)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"rms": 0.0}, "roughness.rms"),
        ({"rms": -1e-8}, "roughness.rms"),
        ({"shortest": 0.2}, "must exceed shortest"),
        ({"longest": np.inf}, "be finite"),
        ({"exponent": 99.0}, "roughness.exponent"),
        ({"shortest": 1e-7}, "times shortest"),
    ],
)
def test_wrong_roughness(changes, words):
    with pytest.raises(ValueError, match=words):
        Roughness(**{"rms": 3e-8} | changes)


def test_contact_runs_along_a_rough_edge():
    """In a narrow band the shift is k^2 R/beta times rms and window; shorter waves are errors."""
    wave = Roughness(rms=1e-8, shortest=0.999e-3, longest=1.001e-3)
    k = 2e3 * np.pi
    a = 3e-4
    beta = 0.01
    radius = 0.0375
    expected = 2**0.5 * 1e-8 * k**2 * abs(ellipse_window(k * a)) * radius / np.sin(beta)
    assert shift_of_contact(wave, np.array([beta]), a, radius) == pytest.approx(
        expected, rel=1e-2
    )
    require_resolved_waves(wave, a)
    with pytest.raises(ValueError, match="must exceed the length of the contact"):
        require_resolved_waves(wave, 6e-4)


@pytest.mark.parametrize("exponent", [0.0, 2.0, 4.0])
@pytest.mark.parametrize("radius", [0.012875, 0.03755])
def test_the_edge_has_its_rms_in_the_waves_that_fit_it(exponent, radius):
    """The edge's density is the mean square of each wave over the step in wave number."""
    edge = Roughness(rms=3e-8, exponent=exponent)
    table = Roughness(rms=3e-8, rms_edge=0.0, exponent=exponent)
    (k, both) = spectral_density(edge, radius)
    (_, alone) = spectral_density(table, radius)
    lines, squares = wave_spectrum(edge, 2 * np.pi * radius)
    some = (lines > 1.01 * k[0]) & (lines < 0.99 * k[-1])
    assert np.interp(lines, k, both - alone)[some] == pytest.approx(
        squares[some] * radius, rel=1e-4
    )


def test_an_edge_that_no_wave_fits_is_refused():
    with pytest.raises(ValueError, match="no wave"):
        edge_profile(Roughness(rms=1e-8, shortest=0.5, longest=1.0), 0.03755)
