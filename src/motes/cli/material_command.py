"""``motes material``: a material without measurement, from a preset or a model with its values."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter

from motes.cli.options import Common


def material(
    text: str | None = None,
    /,
    *,
    list_: Annotated[bool, Parameter(name="--list", negative="")] = False,
    name: str | None = None,
    output: Annotated[str | None, Parameter(name=["--output", "-o"])] = None,
    common: Common = Common(),  # noqa: B008 (an immutable value)
) -> int:
    """List presets and models, show what a text means, or write it as a material.json.

    The same texts stand wherever a command takes a material: motes render gold -o gold.png.

    Parameters
    ----------
    text
        A preset, a model with its values such as "oren_nayar(K_d=0.8, sigma_d=0.4)", a material.json or a folder of motes fit; what is not given
        has its default.
    list_
        List the presets, with where their numbers come from, and the models with their parameters.
    name
        What the material that is written is called.
    output
        The material.json to write.
    """
    from dataclasses import replace

    from motes.cli import console
    from motes.cli.info_command import show_material
    from motes.errors import MotesError
    from motes.presets import named

    if list_ or text is None:
        option = next((o for o, v in (("--name", name), ("--output", output)) if v is not None), None)
        if option is not None or (list_ and text is not None):
            raise MotesError(
                f"a list was asked for, and {option or repr(text)} was given", "Write motes material TEXT -o NAME.json"
            )
        return _list(common)
    if name is not None and output is None:
        raise MotesError(f"--name {name} was given, and nothing is written", "Add -o NAME.json")
    found = named(text)
    if name is not None:
        found = replace(found, name=name)
    file = None if output is None else Path(output)
    if file is not None:
        if file.suffix.lower() != ".json":
            raise MotesError(f"{file} is no material by its name", "Write -o NAME.json")
        found.save(file)
    if common.json:
        console.print_json({**({} if file is None else {"path": str(file)}), **found.to_dict()})
    elif not common.quiet:
        show_material(found)
        if file is not None:
            console.print_facts([("written", str(file)), ("next", f"motes view {file}")])
    return 0


def _list(common: Common) -> int:
    """The presets and the models."""
    from motes.cli import console
    from motes.models import BRDF, describe, registered
    from motes.presets import PRESETS

    presets: list[dict[str, Any]] = []
    for preset in PRESETS.values():
        made = preset.material()
        facts = {"name": preset.name, "words": preset.words, "model": describe(made.brdf), "source": preset.source}
        presets.append({**facts, "changes": bool(made.trends)})
    models = {model: [f"{p.name}={p.default!r}" for p in cls.declared()] for model, cls in registered(BRDF).items()}
    if common.json:
        console.print_json({"presets": presets, "models": models})
    elif not common.quiet:
        print("Presets")
        console.print_facts([(p["name"], f"{p['words']}: {p['model']}\n{p['source']}") for p in presets])
        print("\nModels, with what they are where nothing is said; they add up with +")
        console.print_facts([(model, ", ".join(parameters)) for model, parameters in models.items()])
    return 0
