"""Physical simulation of Euler's disk: motion, contact force, modes and sound of a
scene."""

from lazy_loader import attach_stub

__version__ = "0.3.0.dev0"
__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)  # imported on first use
