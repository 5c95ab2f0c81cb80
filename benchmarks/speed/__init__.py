"""Contain scripts that print timings: python -m benchmarks.speed.<name>."""
