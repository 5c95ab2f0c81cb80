"""Benchmark speed against accuracy, and find out where methods fail.

The benchmarks run from a source checkout and are not part of wheels. `charts` measures
and draws (`sonify chart`), `cases` defines the problems, `methods` contains simpler
methods, `peers` other programs, and `references` the data for the error measures. The
scripts in `speed` only print timings."""
