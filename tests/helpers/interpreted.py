"""Compiled functions of dynamics as Python functions, so that a test can replace one of them."""

import sys

from numba.core.dispatcher import Dispatcher


def interpret_dynamics(monkeypatch):
    """Replace every compiled function in the modules of dynamics by its Python source.

    A function that calls another one by its name then calls what a test puts in its place.
    """
    for name, module in list(sys.modules.items()):
        if name.startswith("dynamics."):
            for own, value in list(vars(module).items()):
                if isinstance(value, Dispatcher):
                    monkeypatch.setattr(module, own, value.py_func)
