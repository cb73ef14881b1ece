"""Compiled evaluation (being written)."""

THRESHOLD = 10**18


def available() -> bool:
    return False
