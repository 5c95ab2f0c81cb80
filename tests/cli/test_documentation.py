"""Claim: the README and the documentation are short where they should be, and name only things that
exist.

Source: README.md and docs/. Oracle: the files of the checkout; the commands and extras that the
package declares; the names that it exports; the output of the code on the pages.
"""

import re
import tomllib
from importlib import import_module
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest
import soundfile
from paths import ROOT

from sonify.__main__ import main
from sonify.sweeps.sweep import load_sweep

README = ROOT / "README.md"
PAGES = [
    README,
    ROOT / "CONTRIBUTING.md",
    ROOT / "CHANGELOG.md",
    *sorted((ROOT / "docs").glob("*.md")),
]
TEXTS = {page: page.read_text("utf-8") for page in PAGES}


def blocks(page: Path, language: str) -> list[str]:
    """Return the code blocks of a page in one language."""
    return re.findall(rf"```{language}\n(.*?)```", TEXTS[page], re.DOTALL)


def test_the_readme_is_short():
    lines = TEXTS[README].splitlines()
    assert len(lines) <= 110
    assert len(TEXTS[README].split()) <= 700
    assert max(len(line) for line in lines if not line.startswith("|")) <= 120


def test_the_page_on_the_detector_has_every_file_and_no_other():
    folders = ("hearing", "hearing/settling", "fitting")
    files = {
        path.name
        for folder in folders
        for path in (ROOT / "sonify" / folder).glob("*.py")
        if path.name != "__init__.py"
    }
    named = re.findall(r"\w+\.py", TEXTS[ROOT / "docs" / "detector_files.md"])
    assert set(named) == files


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_relative_link_leads_to_a_file(page):
    targets = re.findall(r"\]\(([^)#\s]+)[^)]*\)", TEXTS[page])
    local = [target for target in targets if "://" not in target]
    missing = [target for target in local if not (page.parent / target).exists()]
    assert missing == []


def test_every_file_that_contributing_names_exists():
    text = TEXTS[ROOT / "CONTRIBUTING.md"]
    named = set(re.findall(r"`((?:[\w-]+/)+[\w-]+\.\w+)`(?:: `(\w+)`)?", text))
    named = {(file, name) for file, name in named if not file.startswith("outputs/")}
    assert len(named) > 40
    missing = [
        (file, name)
        for file, name in named
        if not (ROOT / file).is_file() or name not in (ROOT / file).read_text("utf-8")
    ]
    assert missing == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_command_scene_and_extra_exists(page):
    text = TEXTS[page]
    commands = set(re.findall(r"python -m sonify ([a-z]+)", text))
    assert commands <= set(main.commands)
    scenes = set(re.findall(r"python -m sonify run ([a-z-]+)", text))
    assert {name for name in scenes if not name.startswith("-")} <= {
        file.stem for file in (ROOT / "sonify" / "scenes").glob("*.toml")
    }
    for module in re.findall(r"python -m (sonify\.[a-z_.]*[a-z_])", text):
        assert import_module(module).main
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"][
        "optional-dependencies"
    ]
    named = {
        extra
        for group in re.findall(r'"?\.\[([a-z,]+)\]', text)
        for extra in group.split(",")
    }
    assert named <= set(extras)


def test_the_api_page_lists_every_public_name():
    text = (ROOT / "docs" / "api.rst").read_text("utf-8")
    for name in ("sonify", "dynamics", "modal"):
        section = text.partition(f".. currentmodule:: {name}\n")[2].partition(
            ".. currentmodule::"
        )[0]
        listed = re.findall(r"^   (\w+)$", section, re.MULTILINE)
        assert listed == sorted(import_module(name).__all__)


@pytest.mark.slow
def test_the_lines_of_python_in_the_readme_run(tmp_path, monkeypatch, capsys):
    (code,) = blocks(README, "python")
    monkeypatch.chdir(tmp_path)
    names: dict = {}
    exec(code, names)
    end, *_ = capsys.readouterr().out.splitlines()
    result = names["result"]
    assert float(end) == pytest.approx(result.motion.t_end)
    assert result.scene.release.inclination_deg == 25
    assert (tmp_path / "outputs" / "mine" / "report.html").is_file()


def test_the_sweep_of_the_how_to_is_a_sweep():
    (document,) = blocks(ROOT / "docs" / "how_to.md", "toml")
    asked = load_sweep(tomllib.loads(document))
    assert asked.points.count == 24 * 2


def module_of_docs(name: str):
    """Return a module of the folder docs, which is no package."""
    spec = spec_from_file_location(name, ROOT / "docs" / f"{name}.py")
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


SHOWN_PAGES = sorted((ROOT / "docs").glob("*.md")) + sorted(
    (ROOT / "docs" / "charts").glob("*.md")
)


@pytest.mark.parametrize("page", SHOWN_PAGES, ids=lambda page: page.stem)
def test_a_page_reads_well_without_sphinx(page):
    """No block with a directive and no link without words is displayed; a comment with a directive
    is followed by links to what the directive includes."""
    text = page.read_text("utf-8")
    assert "```{" not in text
    assert "[](" not in text
    hidden = list(module_of_docs("conf").HIDDEN_DIRECTIVE.finditer(text))
    assert len(hidden) == text.count("<!-- sphinx:")
    for match in hidden:
        directive = match[1]
        fallback = match[0].partition("\n-->\n")[2]
        if directive.startswith("{include}"):
            included = directive.split()[1]
            assert (page.parent / included).is_file()
            assert f"]({included}" in fallback
        else:
            listed = directive.partition("\n\n")[2].split()
            assert directive.startswith("{toctree}")
            assert len(re.findall(r"^\* \[.+\]\(.+\)$", fallback, re.MULTILINE)) == len(
                listed
            )


def test_sphinx_reads_the_directive_in_place_of_its_fallback():
    page = ["before\n\n<!-- sphinx: {include} a.md\n:x: y\n-->\n[a](a.md)\n"]
    page[0] += "<!-- end of fallback -->\n\nafter\n"
    module_of_docs("conf").show_directives(None, "page", page)
    assert page == ["before\n\n```{include} a.md\n:x: y\n```\n\nafter\n"]


def test_the_pages_show_the_conclusions_of_the_sweeps():
    copies = module_of_docs("copy_conclusions")
    shown = set()
    for page in PAGES:
        assert copies.with_copies(TEXTS[page], page.parent) == TEXTS[page]
        for match in copies.COPY.finditer(TEXTS[page]):
            assert match[3]
            shown.add((page.parent / match[2]).resolve())
    conclusions = (ROOT / "outputs" / "shown" / "sweeps").glob("*/conclusion.md")
    copied = {path for path in conclusions if "verdict-" not in path.parent.name}
    assert shown == copied  # docs/verdict.md is made from the tables


def test_the_sounds_of_the_pages_are_short_and_small():
    shown = sorted((ROOT / "outputs" / "shown").glob("*/last_seconds.flac"))
    linked = {
        path.resolve()
        for page in PAGES
        for path in map(page.parent.joinpath, flacs(page))
    }
    assert linked == set(shown)
    for path in shown:
        about = soundfile.info(path)
        assert 0.5 < about.duration < 6.01
        assert path.stat().st_size < 300_000


def flacs(page: Path) -> list[str]:
    """Return the link targets of a page that are sound files."""
    return re.findall(r"\]\(([^)]+\.flac)\)", TEXTS[page])


def test_each_release_has_at_most_twenty_lines_of_changes():
    releases = re.split(r"^## ", TEXTS[ROOT / "CHANGELOG.md"], flags=re.MULTILINE)[1:]
    assert [release.splitlines()[0].split()[0] for release in releases][-1] == "0.1.0"
    for release in releases:
        assert len(release.splitlines()[1:]) <= 20


def test_the_documentation_lists_the_ranges_of_the_verdicts():
    from verdict_ranges import ranges_table

    assert ranges_table() in (ROOT / "docs" / "verdict.md").read_text("utf-8")


def test_the_documentation_has_the_verdicts_of_the_shown_tables():
    """Repair: python docs/article/verdict_page.py."""
    import verdict_page

    text = verdict_page.VERDICT_PAGE.read_text("utf-8")
    assert text.count("<!-- verdicts: ") == 2
    other = text.replace("yes in all", "no in all", 1)
    assert other != text
    assert verdict_page.with_verdicts(other) == text
