"""Sweeps: run many scenes locally or on a cluster, and evaluate the results."""

from sonify.extras import require_extra

require_extra("a sweep", "pyarrow", "sweep")
