"""Pages of the documentation site that are made from what the code declares: models, presets, the library."""

from __future__ import annotations

import inspect
import math
import re
import types
from collections.abc import Mapping

import motes
from motes.models import BRDF, describe, registered
from motes.parameters import Parameter
from motes.presets import PRESETS

#: Rooms of the library whose public names are listed, in the order of a user's work.
ROOMS = (
    "motes.measurements", "motes.models", "motes.fitting", "motes.trends", "motes.ageing", "motes.maps", "motes.meshes", "motes.rendering",
    "motes.exports", "motes.report", "motes.viewer", "motes.certification", "motes.soiling", "motes.directions", "motes.errors",
)  # fmt: skip


def models() -> str:
    """Every model with its parameters, from the declarations of `motes.models`."""
    lines = [
        "# Models",
        "",
        "Each model has a name in texts, such as `oren_nayar`, and a class, such as `motes.OrenNayar`. Models add up with `+`, and a layer lies over a base:",
        '`"oren_nayar(K_d=0.6) + ggx(K_s=0.04, alpha=0.2)"`, `"dust_layer(oren_nayar, scattering=multiple)"`. `motes fit DATA --model auto` chooses among them',
        "([Fitting](fitting.md)); where you know what the surface is, say so. This page is made from the declarations in the code.",
        "",
        "| in texts | class | what it is |",
        "|---|---|---|",
    ]
    known = registered(BRDF)
    for name, cls in known.items():
        lines.append(f"| [`{name}`](#{_anchor(name)}) | `{cls.__name__}` | {_first(cls)} |")
    for name, cls in known.items():
        lines += ["", f"## {name}", "", _first(cls), ""]
        lines += _table([p for p in cls.declared() if isinstance(p, Parameter)])
        note = _source(cls)
        if note:
            lines += ["", note]
    return "\n".join(lines) + "\n"


def _table(parameters: list[Parameter]) -> list[str]:
    if not parameters:
        return ["It has no parameters of its own."]
    lines = ["| parameter | what it is | unit | bounds | default | of each channel |", "|---|---|---|---|---|---|"]
    for p in parameters:
        low, high = (_bound(b) for b in p.bounds)
        bounds = f"{'(' if p.open else '['}{low}, {high}{')' if p.open or math.isinf(p.bounds[1]) else ']'}"
        each = "yes, one in a fit" if p.per_channel and p.shared_in_fit else "yes" if p.per_channel else "no"
        lines.append(f"| `{p.name}` | {p.doc} | {p.unit or '1'} | {bounds} | {p.default:g} | {each} |")
    return lines


def _bound(x: float) -> str:
    if math.isinf(x):
        return "∞" if x > 0 else "-∞"
    return "π/2" if math.isclose(x, math.pi / 2) else f"{x:g}"


def _anchor(name: str) -> str:
    return re.sub(r"[^a-z0-9_-]", "", name.lower())


def _first(thing: object) -> str:
    """The first sentence of a docstring, on one line."""
    text = inspect.cleandoc(getattr(thing, "__doc__", None) or "")
    return _plain(text.split("\n\n")[0])


def _source(cls: type) -> str:
    """What the module of a model says of its source."""
    text = inspect.cleandoc(inspect.getmodule(cls).__doc__ or "")  # type: ignore[union-attr]
    found = re.search(r"(?:^|\s)Sources?: (.*)", text, re.DOTALL)
    return f"Source: {_plain(found[1].split(chr(10) * 2)[0])}" if found else ""


def _plain(text: str) -> str:
    """Text of a docstring as Markdown on one line."""
    text = re.sub(r":\w+:`~?([^`]+)`", r"`\1`", text.replace("``", "`"))
    return re.sub(r"\s+", " ", text).replace("|", "\\|").replace("<", "&lt;").strip()


def presets() -> str:
    """The presets with their sources."""
    lines = [
        "# Presets",
        "",
        "A name that stands wherever a material is taken: `motes render gold -o gold.png`, `motes material gold -o gold.json` writes it as a file.",
        "Each says where its numbers come from; those that are commonly quoted and were not checked say so.",
        "",
        "| name | what it is | model | source |",
        "|---|---|---|---|",
    ]
    for preset in PRESETS.values():
        lines.append(
            f"| `{preset.name}` | {_plain(preset.words)} | `{describe(preset.material().brdf)}` | {_plain(preset.source)} |"
        )
    return "\n".join(lines) + "\n"


def api() -> str:
    """The public names of the library, for Sphinx's autodoc."""
    lines = [
        "The library",
        "===========",
        "",
        "What a script needs is in ``motes`` itself; the rooms have the rest.",
        "",
    ]
    lines += _room(motes)
    for name in ROOMS:
        lines += _room(__import__(name, fromlist=["_"]))
    return "\n".join(lines) + "\n"


def _room(module: types.ModuleType) -> list[str]:
    """A room: its words, its classes and functions with their docstrings, and its registries by their keys."""
    title = f"``{module.__name__}``"
    lines = [title, "-" * len(title), "", f".. automodule:: {module.__name__}", "   :no-members:", ""]
    for name in _public(module):
        found = getattr(module, name)
        if isinstance(found, Mapping):
            keys = ", ".join(f"``{key}``" for key in found)
            lines += [f".. py:data:: {module.__name__}.{name}", "   :no-index:", "", f"   A mapping: {keys}.", ""]
        elif inspect.isclass(found):
            lines += [f".. autoclass:: {module.__name__}.{name}", "   :members:", ""]
        elif inspect.isfunction(found):
            lines += [f".. autofunction:: {module.__name__}.{name}", ""]
    return lines


def _public(module: types.ModuleType) -> list[str]:
    """What a room offers, without what `motes` has already."""
    named = getattr(module, "__all__", None)
    if named is None:
        own = (n for n, f in vars(module).items() if getattr(f, "__module__", "") == module.__name__)
        named = [n for n in own if not n.startswith("_")]
    mine = [n for n in named if module is motes or n not in motes.__all__]
    ours = [
        n
        for n in mine
        if isinstance(getattr(module, n), Mapping) or getattr(getattr(module, n), "__module__", "").startswith("motes")
    ]
    return [n for n in ours if not n.startswith("_")]
