"""Mesh a symmetry sector of a held disk with hexahedra, and read user meshes."""
