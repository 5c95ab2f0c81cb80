"""SCENE -> MOTION: a rigid disk that rolls and slides on a plane, event by event."""

from importlib import import_module

_HOME = {"simulate": "simulation", "Motion": "motion", "Outcome": "motion", "ImpossibleContactError": "switching"}
__all__ = list(_HOME)


def __getattr__(name):
    """Import what is asked for when it is asked for: the package itself costs nothing to import."""
    if name in _HOME:
        return getattr(import_module(f".{_HOME[name]}", __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
