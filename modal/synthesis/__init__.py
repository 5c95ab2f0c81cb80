"""FREE MODES + PATCH -> MODES: the held disk from the modes of the free one and tractions on the patch."""
