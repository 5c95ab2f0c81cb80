"""Claim: `plot` of a motion, of modes and of a sound draws their own values, with units.

Oracle: the arrays of the record; the artists of the figure.
"""

import numpy as np
import pytest

from dynamics.observables import precession_rate
from modal import eigenmodes
from sonify import solve
from sonify.hearing.spectrogram import REFERENCE_PRESSURE_PA, spectrogram


def test_a_motion_plots_its_values(motion):
    """The lines hold the values of the motion at their own times."""
    tilt, rate, force = motion.plot().axes
    t, degrees = tilt.lines[0].get_data()
    state, forces = motion.at_and_force(t)
    assert t[[0, -1]].tolist() == [0.0, motion.t[-1]]
    np.testing.assert_array_equal(degrees, np.degrees(state[:, 1]))
    np.testing.assert_array_equal(force.lines[0].get_ydata(), forces[:, 2])
    np.testing.assert_allclose(
        rate.lines[0].get_ydata(), np.abs(precession_rate(state)) / (2 * np.pi)
    )
    assert [panel.get_ylabel() for panel in (tilt, rate, force)] == [
        "inclination [degrees]",
        "precession [Hz]",
        "normal force [N]",
    ]


def test_modes_plot_their_frequencies_and_decay_times(scene):
    modes = eigenmodes(scene.replace("support.kind=free"), below=20e3)
    orders, decays = modes.plot().axes
    drawn = np.concatenate([line.get_ydata() for line in orders.lines])
    np.testing.assert_allclose(np.sort(drawn), np.sort(modes.frequency / 1e3))
    drawn = np.concatenate([line.get_ydata() for line in decays.lines])
    np.testing.assert_allclose(np.sort(drawn), np.sort(modes.decay_time))
    assert orders.get_legend_handles_labels()[1] == list(dict.fromkeys(modes.family))


@pytest.mark.slow
def test_a_sound_plots_its_pressure(scene):
    sound = solve(
        scene.replace("release.inclination_deg=1", "release.omega=[0, 0, 0]"), "draft"
    ).sound
    wave, image, _ = sound.plot().axes
    low, high = wave.dataLim.intervaly
    pressure = sound.pressure.read()
    assert (low, high) == pytest.approx((pressure.min(), pressure.max()), rel=1e-5)
    level = image.collections[0].get_array()
    assert level.max() == pytest.approx(
        spectrogram(sound.pressure, 0.02, 2000).level_db(REFERENCE_PRESSURE_PA).max()
    )
