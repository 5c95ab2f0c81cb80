"""Interactive page to change a scene, run it, hear it and compare it with a
recording."""
