"""SCENE -> PLAN: what a run computes, what it leaves out and why, and how far that is from the
reference."""
