"""Modes of a disk on a patch, from the modes of the free disk and tractions on the patch."""
