"""Claim: the examples in the docstrings of `dynamics` run and print the output shown.

Source: the docstrings. Oracle: the output written in them.
"""

import doctest
import importlib

import pytest

MODULES = (
    "air",
    "disk",
    "dissipation",
    "equations",
    "hybrid",
    "motion",
    "solver_settings",
    "simulation",
    "surface",
    "switching",
)


@pytest.mark.parametrize("name", MODULES)
def test_examples_of_a_module(name):
    module = importlib.import_module(f"dynamics.{name}")
    result = doctest.testmod(module, raise_on_error=False)
    assert result.attempted > 0
    assert result.failed == 0
