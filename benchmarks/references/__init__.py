"""Reference data of the benchmarks, and the script that computes the motions."""
