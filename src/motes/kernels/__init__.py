"""Running graphs: printed as NumPy functions and Numba kernels, compiled once and kept (the engine)."""
