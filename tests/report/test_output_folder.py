"""Claim: a result has a folder only after it was written.

Source: sonify/result.py. Oracle: the error of a result without one.
"""

from dataclasses import fields
from types import SimpleNamespace

import pytest

from sonify.result import Result, output_folder


def result(**values):
    """Return a result whose other fields are None."""
    return Result(**dict.fromkeys(field.name for field in fields(Result)) | values)


def test_a_result_that_was_not_written_has_no_folder():
    with pytest.raises(ValueError, match="has no folder"):
        output_folder(result())


def test_a_result_passes_if_every_check_does():
    good, bad = SimpleNamespace(passed=True), SimpleNamespace(passed=False)
    assert result(checks=[good, good]).passed
    assert not result(checks=[good, bad]).passed
