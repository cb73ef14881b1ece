"""Formulas as graphs: recorded, differentiated, separated; what depends on what."""
