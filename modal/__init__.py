"""Compute the elastic modes of disks (`eigenmodes(scene)`) and of tables
(`surface_modes(scene)`)."""

from lazy_loader import attach_stub

# imports the names listed in __init__.pyi on first use
__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
