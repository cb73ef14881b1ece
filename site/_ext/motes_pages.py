"""Formulas as MathML, which browsers draw themselves (no script, no font, no network), and docstrings of attributes as the sentences they are."""

from __future__ import annotations

from typing import Any

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml


def _inline(self: Any, node: nodes.math) -> None:
    self.body.append(tex2mathml(node.astext()))
    raise nodes.SkipNode


def _display(self: Any, node: nodes.math_block) -> None:
    self.body.append(f'<div class="math">{tex2mathml(node.astext(), as_block=True)}</div>')
    raise nodes.SkipNode


def _whole_sentence(app: Any, what: str, name: str, thing: object, options: Any, lines: list[str]) -> None:
    """Napoleon takes what stands before a colon in the first line of an attribute for its type; here it is a sentence."""
    if what in ("attribute", "data", "property"):
        lines.insert(0, "")


def setup(app: Any) -> dict[str, Any]:
    app.add_html_math_renderer("mathml", (_inline, None), (_display, None))
    app.connect("autodoc-process-docstring", _whole_sentence, priority=400)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
