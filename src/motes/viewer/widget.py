"""The viewer in a notebook: the same ES module as the page, through `anywidget` (extra ``notebook``)."""

from __future__ import annotations

from functools import cache
from typing import Any

from motes.errors import MissingExtraError
from motes.viewer.contract import Payload
from motes.viewer.page import asset


@cache
def widget_class() -> Any:
    """The class of the widget; made when it is first wanted, for anywidget is an extra.

    Raises
    ------
    MissingExtraError
        Without anywidget.
    """
    try:
        import anywidget
        import traitlets
    except ImportError:
        raise MissingExtraError("anywidget", "notebook", "The viewer in a notebook") from None

    class Viewer(anywidget.AnyWidget):
        """The viewer; ``state`` is what is set in it: values, time, light, ... as a link holds them."""

        _esm = asset("viewer.js")
        _css = asset("viewer.css")
        payload = traitlets.Dict().tag(sync=True)
        state = traitlets.Dict().tag(sync=True)

    return Viewer


def make_widget(payload: Payload) -> Any:
    """A widget that shows a payload."""
    return widget_class()(payload=payload)
