"""What several files of tests share: the published scene and its motion, solved once; and which
files come first."""

import pytest

from dynamics import simulate
from sonify import load_scene

COMPILING = (
    "test_motion_properties",
    "test_two_way_coupling",
    "test_limits_of_range",
    "test_film_motion",
)
LONG = (
    "test_fit",
    "test_run_outputs",
    "test_determinism",
    "test_charts_stability",
    "test_charts_modes",
    "test_charts_motion",
)
"""Files that compile the most, each something else, and those that take the longest."""


def pytest_collection_modifyitems(items):
    """Begin with these, so that what is compiled is there for all others, and both workers end at
    about one time."""
    first = {name: place for place, name in enumerate((*COMPILING, *LONG))}
    items.sort(key=lambda item: first.get(item.path.stem, len(first)))


@pytest.fixture(scope="session")
def scene():
    return load_scene("published")


@pytest.fixture(scope="session")
def motion(scene):
    return simulate(scene)
