"""Claim: the examples in the docstrings of `dynamics` and `modal` run and print the output shown.

Source: the docstrings. Oracle: the output written in them.
"""

import doctest
import importlib

import pytest

MODULES = (
    "dynamics.air",
    "dynamics.disk",
    "dynamics.dissipation",
    "dynamics.equations",
    "dynamics.hybrid",
    "dynamics.motion",
    "dynamics.sections",
    "dynamics.solver_settings",
    "dynamics.simulation",
    "dynamics.surface",
    "dynamics.switching",
    "modal.modes",
    "modal.solve",
    "modal.spectral.axisymmetric",
    "modal.spectral.basis",
    "modal.synthesis.free_disk",
    "modal.tabletop.solve",
)


@pytest.mark.parametrize("name", MODULES)
def test_examples_of_a_module(name):
    module = importlib.import_module(name)
    result = doctest.testmod(module, raise_on_error=False)
    assert result.attempted > 0
    assert result.failed == 0
