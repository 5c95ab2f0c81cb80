"""Write the numbers, pictures, page and animation of a run."""
