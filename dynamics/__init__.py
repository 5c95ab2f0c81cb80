"""SCENE -> MOTION: a rigid disk that rolls and slides on a plane, event by event."""

from lazy_loader import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)  # of __init__.pyi, on first use
