"""Modes of axisymmetric solids by Ritz's method in Fourier series and polynomials, order by
order."""
