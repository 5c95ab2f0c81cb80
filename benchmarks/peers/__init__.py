"""Other programs on the benchmark problems: physics engines and finite-element programs, one module
per engine."""
