"""Time stepping of the full compliant motion, compiled by numba."""
