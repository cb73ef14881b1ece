"""Fits of very many texels: the same fit, printed as a compiled kernel."""
