"""SCENE x AXES -> TABLE: many runs as one table, on this machine or on a cluster, and what the
table says."""
