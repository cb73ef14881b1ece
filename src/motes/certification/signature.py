"""What a function of C or GLSL takes and gives, as its own declaration says."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from motes.errors import DataError, FormatError

SHAPES = (
    "void f(const double wi[3], const double wo[3], double result[3]), double f(const double wi[3], const double wo[3]), "
    "double f(double theta_i, double theta_r, double dphi), in double or float, with further numbers behind; vec3 or float f(vec3 wi, vec3 wo) in GLSL"
)
_COMMENTS = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
ANGLES = ("theta_i", "theta_r", "dphi")


@dataclass(frozen=True)
class Argument:
    """One argument: its type without qualifiers, name, length of an array (0: a pointer; None: no array), whether it may not be written."""

    kind: str
    name: str
    size: int | None
    constant: bool


@dataclass(frozen=True)
class Signature:
    """A declared function."""

    name: str
    returns: str
    arguments: tuple[Argument, ...]

    @property
    def scalar(self) -> str:
        """``float`` or ``double``: what it computes in."""
        return "double" if "double" in (self.returns, *(a.kind for a in self.arguments)) else "float"


def without_comments(source: str) -> str:
    return _COMMENTS.sub(" ", source)


def declared(source: str, name: str) -> Signature | None:
    """The function of a name that a source defines; None where it does not."""
    found = re.search(
        rf"(?P<returns>[A-Za-z_]\w*)\s+{re.escape(name)}\s*\((?P<arguments>[^()]*)\)\s*\{{", without_comments(source)
    )
    if found is None:
        return None
    texts = [text.strip() for text in found["arguments"].split(",")]
    return Signature(name, found["returns"], tuple(_argument(text) for text in texts if text not in ("", "void")))


def functions(source: str) -> list[str]:
    """The names of the functions that a source defines, for errors."""
    words = re.findall(r"[A-Za-z_]\w*\s+([A-Za-z_]\w*)\s*\([^()]*\)\s*\{", without_comments(source))
    return [word for word in dict.fromkeys(words) if word not in ("if", "for", "while", "switch")]


def _argument(text: str) -> Argument:
    array = re.fullmatch(
        r"(?P<words>[\w\s]+?)\s*(?P<star>\*?)\s*(?:\brestrict\b\s*)?(?P<name>\w+)\s*(?:\[\s*(?P<size>\d*)\s*\])?", text
    )
    if array is None:
        raise FormatError(f"the argument {text[:80]!r} is not understood", f"Known are {SHAPES}")
    words = [w for w in array["words"].split() if w not in ("in", "highp", "mediump", "lowp", "struct", "volatile")]
    constant = "const" in words
    kind = " ".join(w for w in words if w != "const")
    size = int(array["size"]) if array["size"] else 0 if array["star"] or "[" in text else None
    return Argument(kind, array["name"], size, constant)


def numbers_for(signature: Signature, arguments: tuple[Argument, ...], given: Mapping[str, Any]) -> list[Any]:
    """The values of the further arguments, in their order.

    Raises
    ------
    DataError
        When one is not given, or one is given that is not there.
    """
    names = [argument.name for argument in arguments]
    missing = [name for name in names if name not in given]
    if missing:
        raise DataError(
            f"{signature.name} takes {', '.join(names)}, and {missing[0]} has no value",
            f"Give it: --set {missing[0]}=0.3",
        )
    return [given[name] for name in names]
