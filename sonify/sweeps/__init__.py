"""SCENE x AXES -> TABLE: run many scenes, here or on a cluster, and evaluate their table."""
