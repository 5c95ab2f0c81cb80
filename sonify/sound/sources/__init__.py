"""Sources of sound, which turn the contact force into stems of pressure."""
