"""DISK -> MESH: hexahedra for the part of a held disk that its symmetries leave; meshes made elsewhere."""
