"""Euler's disk, heard: SCENE -> MOTION -> FORCE -> MODES -> SOUND -> FINDINGS."""

from lazy_loader import attach_stub

__version__ = "0.1.0"
__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)  # of __init__.pyi, on first use
