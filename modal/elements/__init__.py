"""Modes of meshed bodies by finite elements (scikit-fem)."""
