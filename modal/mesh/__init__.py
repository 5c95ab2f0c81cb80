"""Meshes of hexahedra for the part of a held disk that its symmetries leave, and user meshes."""
