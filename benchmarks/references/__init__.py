"""Contain the reference data of the benchmarks and the script that computes the
motions."""
