"""Compiled time stepping of the full compliant motion."""
