"""Claim: the tables in docs/predictions.md are those that `predictions`, `contact_circuit` and
`two_coins` of `sonify.examples` print, and what these measure is right.

Source: docs/predictions.md. Oracle: the motions, solved again; one mode under a harmonic force; a
mass on a moving board; sums of independent noises.
"""

import re
from importlib.util import find_spec
from types import SimpleNamespace

import numpy as np
import pytest
from paths import ROOT

from dynamics import simulate
from dynamics.compliant.law.linear_response import force_per_height
from dynamics.compliant.law.linearised import mobility
from dynamics.compliant.model_inputs import tabulated_contact_law
from sonify.examples import contact_circuit, predictions, two_coins

TEXT = (ROOT / "docs" / "predictions.md").read_text("utf-8")
NUMBER = r"\d+(?:\.\d+)?"


def numbers(row):
    return [float(found) for found in re.findall(NUMBER, row.split("|", 2)[2])]


def rows(text, column):
    """Return the rows of the table in a text whose first column has a head, by their first cell."""
    start = re.search(rf"\| +\| {column}", text).start()
    lines = text[start:].partition("\n\n")[0].splitlines()[2:]
    return {line.split("|")[1].strip(): line for line in lines}


def assert_same_tables(printed, column, scatter=0.01):
    printed, shown = rows(printed, column), rows(TEXT, column)
    assert printed.keys() == shown.keys()
    for words, row in printed.items():
        expected = numbers(shown[words])
        assert numbers(row) == pytest.approx(expected, rel=scatter, abs=0.06)


def test_the_predictions_for_the_mirror_are_those_of_a_run():
    """The first column, with the assumed values as they are; the others are in the slow test."""
    found = predictions.last_second(predictions.scenes()["mirror"])
    table = rows(TEXT, "mirror")
    for field, words in predictions.ROW_NAMES_BY_FIELD.items():
        shown = numbers(table[words])[0]
        assert getattr(found, field) == pytest.approx(shown, rel=0.01, abs=0.05)
    assert found.is_lifted


@pytest.mark.slow
@pytest.mark.skipif(
    not find_spec("heyoka"),
    reason="heyoka made the table; without it one number differs by 1 %",
)
def test_the_table_is_what_the_script_prints():
    assert_same_tables(predictions.main(), "mirror")


@pytest.mark.slow
def test_the_table_of_the_circuit_is_what_the_script_prints():
    """The openings of the rattling coin differ by 3 % on another processor."""
    assert_same_tables(contact_circuit.main(), "toy", scatter=0.1)


@pytest.mark.slow
def test_the_table_of_two_coins_is_what_the_script_prints():
    assert_same_tables(two_coins.main(), "100 mm apart")


def test_the_text_repeats_the_numbers_of_the_tables():
    table = rows(TEXT, "mirror")
    last = numbers(table[predictions.ROW_NAMES_BY_FIELD["last_rate"]])
    for value in (last[0], last[3], last[6]):
        assert f"{value:.0f} times a second" in TEXT
    circuit = rows(TEXT, "toy")
    opens = numbers(circuit[contact_circuit.ROW_NAMES_BY_FIELD["open_percent"]])
    assert f"open {opens[3]:.0f} % of the time" in TEXT
    coins = rows(TEXT, "100 mm apart")
    moved, pressed = (
        numbers(coins[two_coins.ROW_NAMES_BY_FIELD[field]])[0]
        for field in ("rms", "force_percent")
    )
    assert f"{moved:.0f} nm" in TEXT
    assert f"{pressed:.0f} % of its weight" in TEXT


def test_the_trace_of_the_circuit_follows_from_the_losses_of_contact():
    """Openings at 1.5 and 2.5 s of a rattle of 2.6 s, of which the last one reaches its end."""
    losses = [
        SimpleNamespace(t=t, duration=lasts)
        for t, lasts in ((0.5, 0.2), (1.65, 0.01), (1.8, 0.03), (2.5, 0.1))
    ]
    rolling = SimpleNamespace(t=np.array([0.0, 2.6]), contact_losses=losses)
    found = contact_circuit.trace(SimpleNamespace(rolling=rolling, landing=None))
    assert found.open_percent == pytest.approx(14.0)
    assert found.openings == 2
    assert found.longest == pytest.approx(30.0)
    assert found.last == pytest.approx(0.1)


@pytest.mark.slow
def test_the_toy_on_steel_opens_its_contact_once_and_floats():
    """The cushion of a level disk sinks as in `TiltedFilm.sink_time`; the plate is 10 um away."""
    name, coin = contact_circuit.ASSUMED_RANGES
    assert coin != name
    motion = simulate(contact_circuit.scenes()[name])
    found = contact_circuit.trace(motion)
    shown = rows(TEXT, "toy")
    for field, words in contact_circuit.ROW_NAMES_BY_FIELD.items():
        value = numbers(shown[words])[0]
        assert getattr(found, field) == pytest.approx(value, rel=0.05, abs=0.05)
    height = motion.landing.clearance(np.linspace(0, motion.landing.t[-1], 400)[100:])
    assert height.min() > contact_circuit.MAX_PLATE_DEVIATION


def one_mode(frequency, decay):
    return SimpleNamespace(
        frequency=np.array([frequency]), decay_rate=np.array([decay])
    )


def test_the_receptance_between_two_places_is_that_of_each_mode():
    """x'' + 2 d x' + w0^2 x = a b F: below resonance a b/w0^2, at resonance a b/(2 i d w0)."""
    modes = one_mode(300.0, 5.0)
    w0 = 2 * np.pi * 300.0
    one, two = np.array([0.5]), np.array([-0.2])
    found = two_coins.receptance(modes, one, two, np.array([0.0, w0]))
    assert found[0] == pytest.approx(-0.1 / w0**2)
    assert found[1] == pytest.approx(-0.1 / (10j * w0))
    swapped = two_coins.receptance(modes, two, one, np.array([0.0, w0]))
    assert swapped == pytest.approx(found)


def test_the_second_coin_follows_a_slow_board_as_a_mass():
    """N'/u = -w^2/W far below the resonance of the contact, with the mobility W of the rolling
    contact, whose tangential springs stick."""
    coin = two_coins.smooth_coin(two_coins.board())
    beta = np.array([two_coins.SECOND_COIN_INCLINATION])
    law = tabulated_contact_law(coin)
    omega = 2 * np.pi * np.array([50.0])
    system = law.linear_contact(beta, np.array([coin.disk.weight]))
    W = mobility(coin.disk, beta, law.law.rolling_fillet)[0]
    stuck = W[2, 2] - W[2, 1] ** 2 / W[1, 1]
    found = force_per_height(system, omega)
    assert found.real == pytest.approx(-(omega**2) / stuck, rel=0.02)


def test_two_independent_sounds_are_3_db_above_one():
    generator = np.random.default_rng(1)
    sounds = list(generator.normal(size=(4, 200000)))
    found = two_coins.level_differences(sounds)
    assert len(found) == 1 + 6 * 2
    assert found == pytest.approx([10 * np.log10(2)] * 13, abs=0.06)
    same = two_coins.level_differences([sounds[0]] * 3)
    assert same == pytest.approx([20 * np.log10(2)] * 4)
