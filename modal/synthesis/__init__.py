"""Synthesise the modes of a disk on a patch from those of the free disk and tractions
on the patch."""
