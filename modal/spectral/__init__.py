"""Compute the modes of axisymmetric solids by Ritz's method with Fourier series and
polynomials."""
