"""Load the charts of `sonify chart` from the folder `benchmarks/` of a source checkout.

The wheel does not contain this folder.
"""

import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType

from sonify.scene_errors import InputError

CHART_NAMES = (
    "motion",
    "modes",
    "sound",
    "contact",
    "contact-models",
    "table",
    "campbell",
    "end-to-end",
    "film",
    "stability",
)
"""Chart names on the command line, in the order of `chart all`."""

CHECKOUT_FOLDER = Path(__file__).parents[1]
"""Folder that contains the package; the root of the checkout in an editable
installation."""


def load_chart_files() -> ModuleType:
    """Import `benchmarks.charts.chart_files` from the checkout that contains this
    package.

    Raises InputError if the package is not part of a checkout, e.g. if it was installed
    from a wheel."""
    is_checkout = (CHECKOUT_FOLDER / "pyproject.toml").is_file() and (
        CHECKOUT_FOLDER / "benchmarks" / "charts"
    ).is_dir()
    if not is_checkout:
        raise InputError(
            "chart: the charts are in the folder benchmarks/ of the source repository, not in the "
            "installed package; to run them, install a checkout with "
            "`python -m pip install -e .`"
        )
    if str(CHECKOUT_FOLDER) not in sys.path:
        sys.path.insert(0, str(CHECKOUT_FOLDER))
    return import_module("benchmarks.charts.chart_files")
