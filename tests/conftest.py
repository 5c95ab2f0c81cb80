"""What several files of tests share: the published scene and its motion, solved once."""

import pytest

from dynamics import simulate
from sonify import load_scene


@pytest.fixture(scope="session")
def scene():
    return load_scene("published")


@pytest.fixture(scope="session")
def motion(scene):
    return simulate(scene)
