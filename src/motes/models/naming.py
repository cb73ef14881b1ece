"""Models and Fresnel terms by the names under which texts know them: ``oren_nayar``, ``dielectric``.

A class registers itself where it is declared::

    @register("lambert")
    @final
    @dataclass(frozen=True, eq=False)
    class Lambert(BRDF): ...

and with that `motes.fit`, the command line, files, the viewer and the plugins of Mitsuba know it.
"""

from __future__ import annotations

import keyword
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from typing import TypeVar

from motes.errors import ParameterError
from motes.parameters import Parametrised

C = TypeVar("C", bound=Parametrised)
_classes: dict[str, type[Parametrised]] = {}
_unlisted: set[str] = set()


def register(name: str, *, listed: bool = True) -> Callable[[type[C]], type[C]]:
    """Make a class known by a name; a decorator above ``@dataclass``.

    Parameters
    ----------
    name
        Lower-case words joined by underscores.
    listed
        False for what texts and fits know but nobody is offered, such as the surfaces of other programs (`motes.models.surfaces`): no
        slider, plugin or page of its own.

    Raises
    ------
    ParameterError
        For a name that is none or is taken, a class that is no frozen dataclass, or a field that is not declared.

    Examples
    --------
    >>> from motes.models import Lambert, registered, BRDF
    >>> registered(BRDF)["lambert"] is Lambert
    True
    """
    if not (name.isidentifier() and name == name.lower() and not keyword.iskeyword(name)):
        raise ParameterError(f"{name!r} is no name for a model", "Lower-case words joined by underscores: oren_nayar")

    def registering(cls: type[C]) -> type[C]:
        taken = _classes.get(name)
        if taken is not None and (taken.__module__, taken.__qualname__) != (cls.__module__, cls.__qualname__):
            raise ParameterError(
                f"the name {name} is taken by {taken.__module__}.{taken.__qualname__}", "Choose another name"
            )
        if not (is_dataclass(cls) and "__dataclass_fields__" in vars(cls) and vars(cls)["__dataclass_params__"].frozen):
            raise ParameterError(
                f"{cls.__name__} is not a frozen dataclass", "Put @dataclass(frozen=True, eq=False) above its class"
            )
        for f in fields(cls):
            if not {"parameter", "option", "part"} & f.metadata.keys():
                raise ParameterError(
                    f"{cls.__name__}: the field {f.name} is not declared",
                    "Declare it by parameter(...), option(...) or part(...) of motes.parameters",
                )
        _classes[name] = cls
        if not listed:
            _unlisted.add(name)
        return cls

    return registering


def unregister(name: str) -> None:
    """Forget a name; nothing happens where nobody has it."""
    _classes.pop(name, None)
    _unlisted.discard(name)


def registered(base: type[C], *, unlisted: bool = False) -> dict[str, type[C]]:
    """The classes that derive from `base`, by name, in the order in which they were registered; with `unlisted`, those that are not offered, too."""
    return {
        name: cls for name, cls in _classes.items() if issubclass(cls, base) and (unlisted or name not in _unlisted)
    }


def name_of(cls: type[Parametrised]) -> str:
    """The name of a class; raises `ParameterError` where it has none."""
    for name, own in _classes.items():
        if own is cls:
            return name
    raise ParameterError(
        f"{cls.__name__} has no name in texts", "Put @register('a_name') of motes.models above the class"
    )
