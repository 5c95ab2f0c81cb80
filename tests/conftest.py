"""Fixtures of several files, the published scene and its motion, and the order of the files."""

import os

# before NumPy is loaded, because the workers of pytest already use all cores
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import pytest

from dynamics import simulate
from sonify import load_scene

COMPILING = (
    "test_rattling_on_modes",
    "test_two_way_coupling",
    "test_rattling_disk",
    "test_motion_properties",
    "test_limits_of_range",
    "test_film_motion",
)
LONG = (
    "test_shipped_scenes",
    "test_legal_scenes",
    "test_fit",
    "test_plan",
    "test_unused_keys",
    "test_settling_detector",
    "test_fit_round_trip",
    "test_killed_sweeps",
    "test_page_browser",
    "test_run_outputs",
    "test_determinism",
    "test_charts_stability",
    "test_charts_modes",
    "test_charts_motion",
    "test_charts_peers",
    "test_charts_end_to_end",
    "test_random_scenes",
)
"""Files that compile the most, each something else, and those that take the longest."""


def pytest_collection_modifyitems(items):
    """Start with these files: the others reuse their compiled code, and both workers end together."""
    first = {name: place for place, name in enumerate((*COMPILING, *LONG))}
    items.sort(key=lambda item: first.get(item.path.stem, len(first)))


@pytest.fixture(scope="session")
def scene():
    return load_scene("published")


@pytest.fixture(scope="session")
def elastic(scene):
    return scene.replace("contact.law=elastic", "contact.fillet=1.6e-3")


@pytest.fixture(scope="session")
def motion(scene):
    return simulate(scene)
