"""Folders that tests read: the root of the checkout and the stored reference data."""

from pathlib import Path

ROOT = Path(__file__).parents[2]
"""The root of the checkout."""
REFERENCES = ROOT / "tests" / "references"
"""Reference data, each beside the program that wrote it."""
