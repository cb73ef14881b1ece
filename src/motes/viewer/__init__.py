"""The browser viewer: one page that needs no network, and a notebook widget."""

from motes.viewer.viewing import View, view

__all__ = ["View", "view"]
