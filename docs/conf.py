"""Sphinx configuration: `sphinx-build -W docs build/docs` needs the extra `docs` and no network."""

import re
from pathlib import Path

from sonify import __version__

project = "eulers-disk-sonify"
author = "the authors of eulers-disk-sonify"
version = __version__
release = version

extensions = [
    "myst_parser",
    "numpydoc",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx_gallery.gen_gallery",
    "sphinx-mathjax-offline",
]
EXECUTED_EXAMPLES = (
    "one_motion",
    "mode_table",
    "many_scenes",
    "own_dissipation",
    "own_mesh",
)
"""Examples that are run when the site is built."""
sphinx_gallery_conf = {
    "examples_dirs": [str(Path(__file__).parents[1] / "sonify" / "examples")],
    "gallery_dirs": ["examples"],
    "filename_pattern": "|".join(rf"{name}\.py" for name in EXECUTED_EXAMPLES),
    "ignore_pattern": r"__init__\.py",
    "image_scrapers": (),
    "download_all_examples": False,
    "remove_config_comments": True,
    "show_memory": False,
    "min_reported_time": 1e9,
}
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
exclude_patterns = ["article/text", "build", "templates"]
templates_path = ["templates"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3

default_role = "code"
smartquotes_action = "qe"  # not of dashes: options begin with two
autosummary_generate = True
autodoc_typehints = "none"
autodoc_member_order = "bysource"
numpydoc_show_class_members = False

html_theme = "pydata_sphinx_theme"
html_static_path = ["sounds.js"]
html_js_files = [("sounds.js", {"defer": "defer"})]
html_sidebars = {
    page: []
    for page in (
        *(
            "getting_started",
            "how_to",
            "examples/index",
            "results",
            "theory",
            "gallery",
        ),
        *("classroom", "predictions", "glossary", "surfaces"),
        *("detector", "detector_files", "parameter_studies", "verdict"),
        *("comparison", "references"),
        *("file_formats", "contributing", "changes"),
    )
}
html_title = "Euler's disk, heard"
html_show_sourcelink = False
html_theme_options = {"show_prev_next": False, "secondary_sidebar_items": ["page-toc"]}


def escape_bars(
    app, what: str, name: str, obj: object, options: object, lines: list[str]
) -> None:
    """Escape the bars of absolute values, which reStructuredText takes for substitutions."""
    lines[:] = [line.replace("|", r"\|") for line in lines]


HIDDEN_DIRECTIVE = re.compile(
    r"^<!-- sphinx: (.*?)-->\n(?:.*?)^<!-- end of fallback -->$",
    re.DOTALL | re.MULTILINE,
)
"""Directive in a comment of a page, followed by the text that other renderers of Markdown show."""


def show_directives(app, page: str, source: list[str]) -> None:
    """Put the directives in the comments of a page in place of their fallback texts."""
    source[0] = HIDDEN_DIRECTIVE.sub(r"```\1```", source[0])


def setup(app) -> None:
    """Read the pages as for Sphinx, and escape docstrings before numpydoc reads them."""
    app.connect("source-read", show_directives)
    app.connect("autodoc-process-docstring", escape_bars, priority=100)
