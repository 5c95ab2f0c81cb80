"""AXISYMMETRIC SOLID -> MODES: Ritz's method in a Fourier and polynomial basis, order by order."""
