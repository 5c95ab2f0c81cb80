"""The benchmark problems: parameters, reference values and error measures, one module per chart."""
