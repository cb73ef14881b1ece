"""The version of Motes: what files, kernels and pages that it makes are marked with."""

__version__ = "0.1.0"
