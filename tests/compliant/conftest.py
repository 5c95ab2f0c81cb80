"""What the tests of the compliant contact share."""

import pytest

from sonify import load_scene


@pytest.fixture(scope="module")
def elastic():
    return load_scene("published").replace(
        "contact.law=elastic", "contact.fillet=1.6e-3"
    )
