"""RESULT -> FILES: the numbers, pictures, page and film of a run."""
