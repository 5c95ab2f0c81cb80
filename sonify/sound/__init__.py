"""Compute the sound pressure at the listener from the motion and the elastic modes."""
