"""Sphinx configuration: `sphinx-build -W docs build/docs` needs the extra `docs` and no network."""

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
    "sphinx-mathjax-offline",
]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
exclude_patterns = ["build", "templates"]
templates_path = ["templates"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3

default_role = "code"
autosummary_generate = True
autodoc_typehints = "none"
autodoc_member_order = "bysource"
numpydoc_show_class_members = False

html_theme = "pydata_sphinx_theme"
html_sidebars = {
    page: []
    for page in (
        *("getting_started", "how_to", "examples", "results", "parameter_studies"),
        *("file_formats", "contributing", "changes"),
    )
}
html_title = "Euler's disk, heard"
html_show_sourcelink = False
html_theme_options = {"show_prev_next": False, "secondary_sidebar_items": ["page-toc"]}


def escape_bars(app, what: str, name: str, obj: object, options: object, lines: list[str]) -> None:
    """Escape the bars of absolute values, which reStructuredText takes for substitutions."""
    lines[:] = [line.replace("|", r"\|") for line in lines]


def setup(app) -> None:
    """Escape docstrings before numpydoc reads them."""
    app.connect("autodoc-process-docstring", escape_bars, priority=100)
