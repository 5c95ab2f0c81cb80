"""Signals, progress, files and the console: how a command meets the system around it."""
