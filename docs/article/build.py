"""Build the pages of the documentation and the article: python docs/article/build.py

Everything follows from numbers.json, quoted.toml and text/; tables of sweeps and charts that changed
are read again. A missing or typed number, an unresolved
reference, an overfull figure, a long abstract or a wrong number of pages is an error. `--check` compares the pages with
those in docs/ instead of writing them; `--pages` leaves out the article."""

import json
import sys
from pathlib import Path

import click
from article_figures import write_figures
from article_numbers import HERE, ROOT, Numbers, load_numbers, save_numbers, text_of
from article_sources import sources
from article_tables import hayagriva
from article_text import article_text, page_text

from sonify.runtime.files import write_text
from sonify.sweeps.version import version

PAGES = ("results", "theory", "references", "gallery")
"""Pages of the documentation that are made from text/page_NAME.md."""
BUILD_FOLDER = ROOT / "outputs" / "article"
FIGURE_FOLDER = HERE / "figures"
MAX_ABSTRACT_WORDS = 200
MIN_PAGES = 8
MAX_PAGES = 12
NOTE = "<!-- Made by docs/article/build.py from docs/article/text/{name}.md; edit that file. -->\n\n"
"""First lines of a generated page."""


class ArticleError(ValueError):
    """The article does not keep a rule of its form."""


def with_current_tables(numbers: Numbers) -> Numbers:
    """Return the numbers, with those of sweeps and charts whose tables changed read again."""
    changed = {
        name: source.record()
        for name, source in sources().items()
        if not source.follows_program
        and (name not in numbers or numbers[name].inputs != source.inputs)
    }
    return Numbers(numbers | changed)


def pages(numbers: Numbers) -> dict[Path, str]:
    """Return the text of each generated page by path."""
    return {
        HERE.parent / f"{name}.md": NOTE.format(name=f"page_{name}")
        + page_text(text_of(f"page_{name}"), numbers, "article/figures")
        + "\n"
        for name in PAGES
    }


def to_typst(markdown: str) -> str:
    """Return Markdown as Typst, by Pandoc."""
    import pypandoc

    reader = (
        "markdown+pipe_tables+tex_math_dollars+raw_attribute-smart-implicit_figures"
    )
    text = pypandoc.convert_text(
        markdown, "typst", format=reader, extra_args=["--wrap=none", "--columns=40"]
    )
    return text.replace("\\'", "'").replace('\\"', '"')  # Typst sets curved quotes


def build_article(numbers: Numbers) -> Path:
    """Write the PDF of the article; return its path. Raises ArticleError."""
    abstract = article_text(text_of("abstract"), numbers)
    words = len(abstract.split())
    if words > MAX_ABSTRACT_WORDS:
        raise ArticleError(
            f"the abstract has {words} words, at most {MAX_ABSTRACT_WORDS} are allowed"
        )
    import typst

    body = to_typst(article_text(text_of("article"), numbers))
    source = (HERE / "template.typ").read_text("utf-8")
    for word, text in (
        ("VERSION", version()),
        ("ABSTRACT", to_typst(abstract)),
        ("BODY", body),
    ):
        source = source.replace(word, text)
    BUILD_FOLDER.mkdir(parents=True, exist_ok=True)
    write_figures(numbers, BUILD_FOLDER / "figures")
    (BUILD_FOLDER / "references.yml").write_text(
        json.dumps(hayagriva(), indent=1), "utf-8"
    )
    (BUILD_FOLDER / "article.typ").write_text(source, "utf-8")
    path = BUILD_FOLDER / "article.pdf"
    typst.compile(BUILD_FOLDER / "article.typ", output=path)
    query = typst.query(
        BUILD_FOLDER / "article.typ", "<page-count>", field="value", one=True
    )
    count = int(json.loads(query))
    if not MIN_PAGES <= count <= MAX_PAGES:
        raise ArticleError(f"{count} pages, {MIN_PAGES} to {MAX_PAGES} are allowed")
    return path


@click.command(help=__doc__)
@click.option(
    "--check", is_flag=True, help="Compare the pages instead of writing them."
)
@click.option("--pages", "only_pages", is_flag=True, help="Write no article.")
def main(check, only_pages):
    stored = load_numbers()
    numbers = with_current_tables(stored)
    if numbers != stored and not check:
        save_numbers(numbers)
    for path, text in pages(numbers).items():
        if not check:
            write_text(text, path)
        elif path.read_text("utf-8") != text:
            sys.exit(
                f"{path.relative_to(ROOT)} is out of date: python docs/article/build.py --pages"
            )
    if not check:
        write_figures(numbers, FIGURE_FOLDER)
    if not only_pages:
        click.echo(build_article(numbers))


if __name__ == "__main__":
    main()
