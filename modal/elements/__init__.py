"""Compute the modes of meshed bodies by finite elements (scikit-fem)."""
