"""Compute the modes of the table top."""
