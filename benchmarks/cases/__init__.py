"""Define the benchmark problems with parameters, reference values and error
measures."""
