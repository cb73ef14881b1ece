"""Running graphs: printed as NumPy functions and as LLVM's instructions, compiled once and kept (the engine)."""
