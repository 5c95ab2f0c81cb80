"""Claim: the pictures of a run label every axis with its unit, hide no data and explain their
colours.

A motion is drawn in SI units; the dimensionless figures of the paper are drawn for its scene only,
with the unit of time. Oracle: the artists of the figures, their positions in pixels, and curves
known in advance.
"""

import re
from io import BytesIO
from types import SimpleNamespace

import numpy as np
import pytest
import soundfile
from PIL import Image
from readable import assert_readable, figures
from scenes import scene

from dynamics import simulate
from dynamics.observables import plotted_rates
from sonify.hearing.spectrogram import (
    CONTACT_RATE_BAND_HZ,
    CONTACT_RATE_WINDOW_S,
    MODE_WINDOW_S,
    spectrogram,
)
from sonify.report import maps, pictures, sound
from sonify.report import motion as motion_pictures
from sonify.report.figure import running_range
from sonify.scene import load_scene


@pytest.fixture
def drawn(monkeypatch):
    """Return a function that draws a picture and returns its laid-out figure."""
    made = figures(monkeypatch)

    def draw(function, **data):
        file = BytesIO()
        function(path=file, **data)
        image = Image.open(BytesIO(file.getvalue()))
        assert np.ptp(np.asarray(image)) > 0
        return made[-1]

    return draw


def course(motion):
    return {"motion": pictures._time_histories(motion)}


@pytest.fixture(scope="module")
def short():
    return simulate(scene({"time_limit": 3.0}))


def test_a_motion_is_drawn_in_si_units_without_the_paper(drawn, short):
    one = drawn(motion_pictures.draw_motion, **course(short))
    assert_readable(one)
    names = [(panel.get_xlabel(), panel.get_ylabel()) for panel in one.axes]
    assert len(names) == 6
    assert all(
        re.search(r"\[(s|mm)\]$", x) and re.search(r"\[(degrees|mJ|N|Hz|mm)\]$", y)
        for x, y in names
    )
    assert not any("τ" in x for x, _ in names)
    tilt = one.axes[0].lines[0]
    middle = np.interp(1.5, tilt.get_xdata(), tilt.get_ydata())
    around = np.degrees(short.at(np.linspace(1.4, 1.6, 500))[:, 1])
    assert around.min() < middle < around.max()
    energy = one.axes[2].lines[0]
    assert energy.get_ydata()[0] == pytest.approx(1e3 * short.energy([0.0])[0])


def test_the_figures_of_the_paper_are_drawn_for_its_scene_alone(drawn, short):
    paper = pictures._paper_figures(short)
    one = drawn(motion_pictures.draw_motion, **course(short), paper=paper)
    assert_readable(one)
    assert len(one.axes) == 12
    below = one.axes[6:]
    labels = [panel.get_xlabel() for panel in below]
    assert labels.count("time τ = t/χ, χ = 0.06917 s") == 5
    assert labels.count("x/R") == 1
    for name, own in (("published", True), ("coin-polished", False)):
        found = SimpleNamespace(motion=short, scene=load_scene(name))
        assert (pictures.motion_curve_data(found)["paper"] is not None) is own


def test_an_envelope_holds_the_oscillation_and_not_the_decline():
    """The envelope of 3 + sin spans 2 to 4; that of a straight line has zero width, except at its
    ends."""
    t = np.linspace(0, 100, 20_001)
    mean, least, greatest = running_range(3 + np.sin(2 * np.pi * t), 0.02)
    assert least[20:-20] == pytest.approx(2, abs=0.01)
    assert greatest[20:-20] == pytest.approx(4, abs=0.01)
    assert mean[20:-20] == pytest.approx(3, abs=0.01)
    _, least, greatest = running_range(t, 0.02)
    assert (greatest - least)[20:-20] == pytest.approx(0, abs=1e-6)
    rough = np.random.default_rng(1).exponential(size=20_001)
    _, least, greatest = running_range(rough, 0.02)
    assert least.min() >= rough.min()
    assert greatest.max() <= rough.max()


@pytest.fixture(scope="module")
def bands(tmp_path_factory):
    """Spectrograms of two seconds of noise, in the bands of the rates and of the modes."""
    path = tmp_path_factory.mktemp("sound") / "noise.wav"
    soundfile.write(
        path,
        0.1 * np.random.default_rng(0).standard_normal(96_000),
        48_000,
        subtype="FLOAT",
    )
    low = spectrogram(path, CONTACT_RATE_WINDOW_S).band(*CONTACT_RATE_BAND_HZ)
    return low, spectrogram(path, MODE_WINDOW_S)


@pytest.mark.parametrize("table", [(), (320.0, 912.0)])
def test_a_spectrogram_names_its_axes_and_the_level_that_its_colour_is(
    drawn, bands, short, table
):
    time, *rates = plotted_rates(short)
    marks = {
        "frequencies": [800.5, 7266.6],
        "table": table,
        "carrier": (np.arange(3.0), np.full(3, 2000.0)),
    }
    spans = [(0.0, 2.0), (1.0, 2.0)]
    one = drawn(
        sound.draw_spectrogram,
        bands=bands,
        spans=spans,
        time=time,
        rates=rates,
        **marks,
    )
    assert_readable(one)
    assert [panel.get_ylabel() for panel in one.axes[4:]] == 2 * [
        "level of a sine [dB re 20 µPa]"
    ]
    beside = {text.get_text() for text in one.axes[1].texts}
    assert beside == {f"{f:.0f} Hz" for f in table}, (
        "a label of a line that is not drawn"
    )


def test_a_recording_names_its_axes_and_the_level_that_its_colour_is(drawn, bands):
    low, high = bands
    one = drawn(sound.draw_recording, low=low, high=high, span=(0.0, 2.0))
    assert_readable(one)
    assert [panel.get_ylabel() for panel in one.axes[2:]] == 2 * [
        "level of a sine [dB re full scale, RMS]"
    ]


def test_causes_of_sound_are_drawn_beside_their_legend(drawn):
    time = np.linspace(0, 10, 50)
    names = ("heave", "tilt", "ringing_smooth", "ringing_jumps", "table")
    stems = {name: (time, 70 + np.sin(time), 60 + np.cos(time)) for name in names}
    one = drawn(sound.draw_stems, stems=stems, end=9.0, duration=10.0)
    assert_readable(one)
    shown = [text.get_text() for text in one.axes[0].get_legend().get_texts()]
    assert shown == [
        "heave",
        "tilt",
        "ringing smooth",
        "ringing jumps",
        "table",
        "end of the motion",
    ]


def test_the_legend_marks_a_cause_of_sound_below_the_axis(drawn):
    time = np.linspace(0, 10, 50)
    stems = {
        name: (time, np.full(50, level), np.full(50, level - 20))
        for name, level in (("heave", -19.0), ("ringing_smooth", -21.0))
    }
    one = drawn(sound.draw_stems, stems=stems, end=9.0, duration=10.0)
    shown = [text.get_text() for text in one.axes[0].get_legend().get_texts()]
    assert shown == ["heave", "ringing smooth (fainter)", "end of the motion"]


def test_energies_are_drawn_beside_their_legend(drawn):
    left = np.geomspace(1, 1e-4, 50)
    held = dict.fromkeys(("disk", "modes of the table", "modes of the disk"), left)
    causes = (
        "contact",
        "creep",
        "slip",
        "moments",
        "table",
        "film",
        "body",
        "sound of the table",
    )
    one = drawn(
        motion_pictures.draw_energy,
        left=left,
        held=held,
        lost=dict.fromkeys(causes, 2 - left),
    )
    assert_readable(one)
    shown = [text.get_text() for text in one.axes[1].get_legend().get_texts()]
    assert "friction of rolling and pivoting" in shown
    assert len(shown) == len(causes)


@pytest.mark.parametrize("x", [1.0, 1e-5])
def test_a_map_names_its_axes_and_what_its_colour_is(drawn, x):
    places = [(x * 10**i, 1e-5 * 3**j) for i in range(3) for j in range(3)]
    columns = {
        "a.x": [p[0] for p in places],
        "a.y": [p[1] for p in places],
        "t_end": [float(i) for i in range(9)],
    }
    what = maps.Map(
        x="a.x",
        y="a.y",
        drawn_column="t_end",
        columns=columns,
        logs={"a.x", "a.y"},
        units={"a.x": "m", "t_end": "s"},
    )
    one = drawn(lambda path: maps.draw_map(what, path))
    assert_readable(one)
    panel, bar = one.axes
    assert (panel.get_xlabel(), panel.get_ylabel(), bar.get_ylabel()) == (
        "a.x [m]",
        "a.y",
        "t_end [s]",
    )
