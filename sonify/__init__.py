"""Euler's disk, heard: SCENE -> MOTION -> FORCE -> MODES -> SOUND -> FINDINGS."""

from importlib import import_module

__all__ = ["SceneError", "load_scene", "run", "solve", "summary", "write"]

__version__ = "0.1.0"
_HOME = dict.fromkeys(__all__, "sonify.pipeline")
_HOME |= {"SceneError": "sonify.scene_errors", "load_scene": "sonify.scene", "summary": "sonify.report.write"}


def __getattr__(name):
    """Import a public name when it is first asked for, so that `--help` loads none of the numerics."""
    if name not in _HOME:
        raise AttributeError(f"module 'sonify' has no attribute {name!r}")
    return getattr(import_module(_HOME[name]), name)


def __dir__():
    return __all__
