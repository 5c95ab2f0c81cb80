"""Scripts that print timings: python -m benchmarks.speed.<name>."""
