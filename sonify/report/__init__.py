"""Write the numbers, pictures and page of a run."""
