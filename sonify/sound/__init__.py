"""MOTION + MODES -> SOUND: the contact force, what it drives, and the pressure at the listener."""
