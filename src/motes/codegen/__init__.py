"""Printing expression graphs (`motes.tracing`) as source text: one file a target, over a shared printer."""
