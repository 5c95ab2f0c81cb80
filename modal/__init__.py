"""The elastic modes of disks and tables: `eigenmodes(scene)`, `surface_modes(scene)`."""

from lazy_loader import attach_stub

# imports what __init__.pyi lists, on first use
__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
