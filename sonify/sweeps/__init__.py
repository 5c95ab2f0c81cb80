"""Sweeps: run many scenes locally or on a cluster, and evaluate the results."""
