"""Compute the modes of axisymmetric solids by the Ritz method with Fourier series and
polynomials."""
