"""Graphs (`motes.graph`) as source text: a shared printer, and one file for each language."""
