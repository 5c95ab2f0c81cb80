"""Solve the motion of a disk that rolls, slides and spins on a table."""

from lazy_loader import attach_stub

__getattr__, __dir__, __all__ = attach_stub(
    __name__, __file__
)  # of __init__.pyi, on first use
