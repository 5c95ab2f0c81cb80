"""Solve the benchmark problems with other programs: physics engines and finite-element
programs."""
