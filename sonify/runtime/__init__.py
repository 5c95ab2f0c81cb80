"""Signals, worker processes, progress and files."""
