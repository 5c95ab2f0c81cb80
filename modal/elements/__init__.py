"""MESH -> MODES: finite elements, by scikit-fem."""
