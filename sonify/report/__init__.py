"""RESULT -> FILES: the numbers, the pictures, the page and the film of a run."""
