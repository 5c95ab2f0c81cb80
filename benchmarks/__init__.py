"""Benchmarks: speed against accuracy, and where methods fail. They run from a source checkout; no
wheel contains them.

`charts` measures and draws (`sonify chart`), `cases` states the problems, `methods` holds simpler
methods and `peers` other programs, `references` the data from which the errors are computed. The
scripts in `speed` only print timings."""
