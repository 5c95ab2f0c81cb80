"""Modes of the table top."""
