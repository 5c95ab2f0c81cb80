"""Claim: the article and the generated pages of the documentation contain no number, table, figure or
reference that has no source, and the pages are those of the stored numbers.

Source: docs/article/. Oracle: the texts of the pages; closed forms evaluated again; texts with a
wrong name, a typed number or a wrong reference; a figure with a label outside its canvas."""

import re
from dataclasses import replace
from functools import partial

import article_numbers
import article_sources
import article_text
import build
import measure
import pytest
from article_figures import FIGURES, OverfullFigureError, check_inside
from article_numbers import (
    NUMBERS_FILE,
    MissingNumberError,
    Number,
    Numbers,
    TypedNumberError,
    load_numbers,
    quoted_numbers,
    references,
    save_numbers,
    text_of,
)
from article_text import CITATION, page_text
from build import MAX_ABSTRACT_WORDS, ArticleError, pages
from click.testing import CliRunner
from matplotlib.figure import Figure
from paths import ROOT

from sonify.sweeps.sweep import load_sweep

NUMBERS = load_numbers()


def test_the_generated_pages_are_those_of_the_numbers():
    """Repair: python docs/article/build.py --pages."""
    for path, text in pages(NUMBERS).items():
        assert path.read_text("utf-8") == text, path.relative_to(ROOT)


def test_the_figures_of_a_page_are_numbered_in_order():
    """A reference has the number of the picture with the name of the figure."""
    for path, text in pages(NUMBERS).items():
        captions = re.findall(r"/(\w+)\.\w+\)\n\n\*Figure (\d+)\.", text)
        assert [int(number) for _, number in captions] == list(
            range(1, 1 + text.count("!["))
        ), path.name
        source = text_of(f"page_{path.stem}")
        named = re.findall(r"@fig:([a-z]+)", article_text.assembled(source))
        assert re.findall(r"\bfigure (\d+)", text) == [
            dict(captions)[name] for name in named
        ]


def test_the_article_has_all_its_numbers_figures_and_references():
    text = article_text.article_text(text_of("article"), NUMBERS)
    assert "[[" not in text
    cited = {
        key.strip("@ ") for found in CITATION.findall(text) for key in found.split(";")
    }
    assert cited <= set(references())
    shown = set(re.findall(r"<fig:([a-z]+)>", text))
    assert shown == set(FIGURES)
    assert len(shown) <= 8


def test_the_abstract_is_short():
    text = article_text.article_text(text_of("abstract"), NUMBERS)
    assert len(text.split()) <= MAX_ABSTRACT_WORDS


def test_a_changed_table_is_read_again():
    old = replace(NUMBERS["sweep-halt"], inputs="other", numbers={})
    known = Numbers(NUMBERS | {"sweep-halt": old})
    made = build.with_current_tables(known)["sweep-halt"].numbers
    assert set(made) == set(NUMBERS["sweep-halt"].numbers)


def test_every_caption_has_command_and_version():
    for name, figure in FIGURES.items():
        caption = figure.full_caption(NUMBERS)
        assert "`python " in caption
        assert all(NUMBERS[source].version in caption for source in figure.sources), (
            name
        )


def test_what_the_text_says_of_the_recordings_is_so():
    """Three of the four intervals contain 1/2; 1/3 is outside all of them."""
    exponents = [
        number
        for key, number in NUMBERS["recordings"].numbers.items()
        if key.endswith("exponent")
    ]
    halves = [number.low <= 1 / 2 <= number.high for number in exponents]
    thirds = [number.low <= 1 / 3 <= number.high for number in exponents]
    assert (sum(halves), len(halves)) == (3, 4)
    assert not any(thirds)


def test_each_draw_of_a_shown_sweep_counts_once():
    record = article_sources.sweep_record(article_sources.SWEEPS / "verdict-paper")
    assert record.numbers["runs"].value == load_sweep("verdict-paper").samples.n


def test_the_numbers_are_small_and_come_from_known_sources():
    assert NUMBERS_FILE.stat().st_size < 500_000
    assert set(NUMBERS) <= set(article_sources.sources()) | {"coins", "recordings"}


@pytest.mark.parametrize("name", ["theory", "laws", "limits"])
def test_closed_forms_and_constants_are_stored_as_they_are(name):
    """Repair: python docs/article/measure.py --only NAME."""
    made = article_sources.sources()[name].record()
    stored = NUMBERS[name]
    assert set(made.numbers) == set(stored.numbers)
    for key, number in made.numbers.items():
        assert number.agrees(stored.numbers[key], 1e-5), key


def fail_to_build(monkeypatch, tmp_path, name, text):
    """Build the pages with another text; nothing is written."""
    for file in article_numbers.TEXT_FOLDER.glob("*.md"):
        (tmp_path / file.name).write_text(file.read_text("utf-8"), "utf-8")
    (tmp_path / f"{name}.md").write_text(text, "utf-8")
    monkeypatch.setattr(article_numbers, "TEXT_FOLDER", tmp_path)
    result = CliRunner().invoke(build.main, ["--check"])
    assert result.exit_code == 1
    return result.exception


def test_a_missing_number_fails_the_build(monkeypatch, tmp_path):
    error = fail_to_build(
        monkeypatch, tmp_path, "air", "It lasts [[published.nothing]] s."
    )
    assert isinstance(error, MissingNumberError)
    assert "published.nothing" in str(error)


def test_a_typed_number_fails_the_build(monkeypatch, tmp_path):
    error = fail_to_build(monkeypatch, tmp_path, "air", "It lasts 12.3 s, as in 2002.")
    assert isinstance(error, TypedNumberError)
    assert "12.3" in str(error)


@pytest.mark.slow
@pytest.mark.parametrize("wrong", ["[@nobody1999]", "@fig:nothing", "@tbl:nothing"])
def test_an_unresolved_reference_fails_the_build(monkeypatch, tmp_path, wrong):
    error = fail_to_build(monkeypatch, tmp_path, "air", f"See {wrong}.")
    assert isinstance(error, MissingNumberError)


def test_a_citation_without_a_reference_fails_the_article():
    with pytest.raises(MissingNumberError, match="nobody1999"):
        article_text.article_text("[@nobody1999]", NUMBERS)


def test_a_figure_that_is_too_wide_fails_the_build(monkeypatch, tmp_path):
    def draw_wide(numbers):
        figure = Figure(figsize=(3, 2))
        figure.text(0.9, 0.5, "a label that is much too long for this figure")
        return figure

    monkeypatch.setitem(FIGURES, "frames", replace(FIGURES["frames"], draw=draw_wide))
    monkeypatch.setattr(build, "FIGURE_FOLDER", tmp_path)
    monkeypatch.setattr(build, "with_current_tables", lambda numbers: numbers)
    monkeypatch.setattr(build, "pages", lambda numbers: {})
    result = CliRunner().invoke(build.main, ["--pages"])
    assert isinstance(result.exception, OverfullFigureError)


def test_a_long_abstract_fails_the_build(monkeypatch):
    monkeypatch.setattr(build, "MAX_ABSTRACT_WORDS", 100)
    with pytest.raises(ArticleError, match="at most 100"):
        build.build_article(NUMBERS)


def test_a_quoted_value_needs_a_source_that_contains_it(tmp_path):
    assert set(quoted_numbers()) >= {"thorne_duration", "coin_rate_error"}
    file = tmp_path / "quoted.toml"
    for source in (
        'reference = "nobody1999"',
        'file = "README.md"\ntext = "not in this file"',
    ):
        file.write_text(f"[wrong]\nvalue = 1.0\n{source}\n", "utf-8")
        with pytest.raises(MissingNumberError, match="wrong"):
            quoted_numbers(file)


@pytest.mark.slow
def test_an_interrupted_measurement_continues(monkeypatch, tmp_path):
    """From nothing the time is printed first; what is stored is not measured again."""
    file = tmp_path / "numbers.json"
    chosen = {name: article_sources.sources()[name] for name in ("laws", "one-mode")}
    monkeypatch.setattr(measure, "load_numbers", partial(load_numbers, file))
    monkeypatch.setattr(measure, "save_numbers", partial(save_numbers, path=file))
    monkeypatch.setattr(article_sources, "sources", lambda: chosen)
    monkeypatch.setattr(measure, "SWEEPS", tmp_path / "sweeps")
    monkeypatch.setattr(measure, "CHARTS", tmp_path / "charts")
    said = CliRunner().invoke(measure.main, ["--everything", "--dry-run"]).output
    assert re.search(r"^24 charts and sweeps, .* about \S+ (h|min) with", said)
    first = CliRunner().invoke(measure.main, ["--only", "laws", "--processes", "1"])
    assert first.output.startswith("1 of 2 sources, about ")
    assert set(load_numbers(file)) == {"laws"}
    rest = CliRunner().invoke(measure.main, ["--processes", "1"])
    assert rest.output.startswith("1 of 2 sources, about ")
    assert "one-mode" in rest.output
    assert "laws" not in rest.output
    assert set(load_numbers(file)) == {"laws", "one-mode"}


def test_a_figure_outside_its_canvas_is_an_error():
    figure = Figure(figsize=(3, 2))
    check_inside("fits", figure)
    figure.text(0.9, 0.5, "a label that is much too long for this figure")
    with pytest.raises(OverfullFigureError):
        check_inside("overfull", figure)


def test_numbers_differ_beyond_their_margins_and_scatter():
    number = Number(value=1.0, margin=0.1)
    assert number.agrees(replace(number, value=1.19), 0.0)
    assert not number.agrees(replace(number, value=1.21), 0.0)
    assert Number(value=100.0).agrees(Number(value=100.09), 1e-3)
    assert not Number(value=100.0).agrees(Number(value=100.2), 1e-3)


def test_the_wording_of_numbers():
    assert Number(value=1.2345, margin=0.012).measured == "1.23 ± 0.01"
    assert Number(value=0.5, low=0.25, high=0.75).measured == "0.5 (0.25 to 0.75)"
    text = page_text(
        "[[laws.impacts_0|.1f]] [[limits.contact_inclination|.0e]]", NUMBERS, ""
    )
    assert text == "0.5 5 × 10⁻⁸"
