"""TEXT -> TEXT: insert numbers, tables, figures and parts by name into Markdown.

`[[published.t_end]]` is the number with its uncertainty, `[[published.t_end|.2f]]` the value in a
Python format, and `[[scene.granite.roughness.rms|.2f*1e6]]` a million times the value. `verdict`,
`cause`, `margin`, `interval`, `percent`, `count` and `total` are its other fields. A number that is
typed instead of named is an error. `[[part:NAME]]` is a file of text/; `[[table:NAME]]` and
`[[figure:NAME]]` are made from numbers.json. The same text becomes a page of the documentation and a
section of the article."""

import re
from functools import partial

from article_figures import FIGURES
from article_numbers import (
    MissingNumberError,
    Numbers,
    references,
    text_of,
    with_numbers,
)
from article_tables import TABLES

PLACE = re.compile(r"^\[\[(part|table|figure):([a-z_-]+)\]\]$", re.MULTILINE)
REFERENCE = re.compile(r"@(fig|tbl):([a-z_]+)")
CITATION = re.compile(r"\[((?:@[a-z0-9]+(?:; )?)+)\]")
UNIT_SPACE = re.compile(
    r"(?<=[\d%)⁰¹²³⁴⁵⁶⁷⁸⁹]) (?=(?:s|m|mm|µm|kg|Hz|kHz|rad|dB|Pa|%|degrees|cents)\b|%|±|×)|(?<=[±×]) (?=\d)"
)
"""Space inside a quantity, where no line may end."""
MARKDOWN_PICTURE = re.compile(r"^!\[[^]]*\]\((?P<path>[^)]+)\)\n\n\*", re.MULTILINE)
"""Picture of a page, up to the beginning of its caption."""


def assembled(text: str) -> str:
    """Return a text with its parts. Raises MissingNumberError for a reference to nothing."""
    for _ in range(3):
        text = PLACE.sub(
            lambda match: text_of(match[2]) if match[1] == "part" else match[0], text
        )
    for key in re.findall(r"@([a-z0-9]+)", " ".join(CITATION.findall(text))):
        if key not in references():
            raise MissingNumberError(f"@{key}: no such reference in references.toml")
    places = {(kind, name) for kind, name in PLACE.findall(text)}
    for kind, name in REFERENCE.findall(text):
        if ({"fig": "figure", "tbl": "table"}[kind], name) not in places:
            raise MissingNumberError(f"@{kind}:{name}: the text does not contain it")
    return text


def page_text(text: str, numbers: Numbers, figure_folder: str) -> str:
    """Return the Markdown of a page of the documentation.

    Raises MissingNumberError and TypedNumberError.
    """
    text = PLACE.sub(
        partial(page_place, numbers=numbers, folder=figure_folder), assembled(text)
    )
    pictures = [match["path"] for match in MARKDOWN_PICTURE.finditer(text)]
    text = MARKDOWN_PICTURE.sub(
        lambda match: f"{match[0]}Figure {pictures.index(match['path']) + 1}. ", text
    )
    text = REFERENCE.sub(partial(page_reference, pictures=pictures), text)
    return CITATION.sub(
        lambda match: page_citation(match[1]), with_numbers(text, numbers)
    )


def page_reference(match: re.Match, pictures: list[str]) -> str:
    """Return a reference to a figure or table in Markdown, from the pictures of the page in
    order."""
    if match[1] == "fig":
        numbers = [
            number
            for number, path in enumerate(pictures, 1)
            if path.endswith(f"/{match[2]}.svg")
        ]
        return f"figure {numbers[0]}"
    return f"the table of {TABLES[match[2]].subject}"


def page_place(match: re.Match, numbers: Numbers, folder: str) -> str:
    """Return a table, or a figure with its caption, in Markdown."""
    kind, name = match[1], match[2]
    if kind == "table":
        return TABLES[name].markdown(numbers)
    figure = FIGURES[name]
    return f"![{figure.title}]({folder}/{name}.svg)\n\n*{figure.full_caption(numbers)}*"


def page_citation(keys: str) -> str:
    """Return links to the numbered references in Markdown."""
    known = list(references())
    found = [key.removeprefix("@") for key in keys.split("; ")]
    return ", ".join(rf"[\[{known.index(key) + 1}\]](references.md)" for key in found)


def article_text(text: str, numbers: Numbers) -> str:
    """Return the Markdown of the article for Pandoc, with raw Typst for figures and references."""
    text = PLACE.sub(partial(article_place, numbers=numbers), assembled(text))
    text = REFERENCE.sub(lambda match: f"`@{match[1]}:{match[2]}`{{=typst}}", text)
    return UNIT_SPACE.sub("\N{NO-BREAK SPACE}", with_numbers(text, numbers))


def article_place(match: re.Match, numbers: Numbers) -> str:
    """Return a table with caption and label, or a figure as raw Typst."""
    kind, name = match[1], match[2]
    if kind == "table":
        table = TABLES[name]
        if not table.markdown(numbers):
            return ""
        return f"{table.markdown(numbers)}\n\n: {table.caption} {{#tbl:{name}}}"
    figure = FIGURES[name]
    return (
        "```{=typst}\n"
        f'#figure(placement: auto, image("figures/{name}.svg", width: {figure.width_share:.0%}), '
        f"caption: [{typst_escaped(figure.full_caption(numbers))}]) <fig:{name}>\n"
        "```"
    )


def typst_escaped(text: str) -> str:
    """Return text as Typst content; code and emphasis of Markdown stay."""
    parts = re.split(r"(`[^`]*`)", text)
    for k in range(0, len(parts), 2):
        parts[k] = re.sub(r"([#$@<>*_\\])", r"\\\1", parts[k])
    return "".join(parts)
