"""The licences of what the extras bring, from the metadata of the packages that are installed; writes its table into docs/libraries.md.

python tools/licences.py            # where motes[all] is installed
"""

from __future__ import annotations

import argparse
import re
from collections import defaultdict
from collections.abc import Iterator
from importlib import metadata
from importlib.metadata import PackageMetadata
from pathlib import Path

from packaging.markers import default_environment
from packaging.requirements import Requirement

from motes.files import write_text

PAGE = Path(__file__).resolve().parents[1] / "docs" / "libraries.md"
BEGIN, END = "<!-- licences: begin -->", "<!-- licences: end -->"
#: Not for users.
FOR_DEVELOPERS = {"dev", "test", "docs", "all"}


def requirements(package: str, extra: str = "") -> Iterator[Requirement]:
    """What a package asks for here, for an extra (or for itself)."""
    for text in metadata.requires(package) or []:
        wanted = Requirement(text)
        environment = {**default_environment(), "extra": extra}
        if wanted.marker is None or wanted.marker.evaluate(environment):
            yield wanted


def brought(extra: str) -> set[str]:
    """The names of all packages that an extra brings, and what those need in turn."""
    core = {normal(r.name) for r in requirements("motes")}
    found: set[str] = set()
    waiting = [r for r in requirements("motes", extra) if extra == "" or normal(r.name) not in core]
    while waiting:
        wanted = waiting.pop()
        name = normal(wanted.name)
        if name == "motes":
            for inner in wanted.extras:
                waiting += [r for r in requirements("motes", inner) if normal(r.name) not in core]
            continue
        if name in found:
            continue
        try:
            needed = [r for part in ("", *wanted.extras) for r in requirements(wanted.name, part)]
        except metadata.PackageNotFoundError:
            continue
        found.add(name)
        waiting += needed
    return found


def normal(name: str) -> str:
    """A package's name as indexes compare it."""
    return re.sub(r"[-_.]+", "-", name).lower()


def licence(name: str) -> str:
    """What its metadata say, in a few words."""
    return _of_metadata(metadata.metadata(name)) + (_inside_av() if name == "av" else "")


def _inside_av() -> str:
    """What PyAV's wheels hold beside its own code: FFmpeg, which says its licence itself, and the encoders that it is linked with."""
    from av._core import library_meta

    said = sorted({str(about["license"]) for about in library_meta.values()})
    found = sorted({lib for f in metadata.files("av") or [] for lib in ("x264", "x265") if f"lib{lib}" in f.name})
    beside = f", and beside it lib{' and lib'.join(found)}, whose projects license them under the GPL" if found else ""
    return f"; its wheels hold FFmpeg, which says {' and '.join(said)} of itself{beside}"


def _of_metadata(about: PackageMetadata) -> str:
    if expression := about.get("License-Expression"):
        return str(expression)
    classified = [c.rpartition(" :: ")[2] for c in about.get_all("Classifier") or [] if c.startswith("License ::")]
    words = [c for c in classified if c != "OSI Approved"]
    if words:
        return ", ".join(words)
    first = (about.get("License") or "").strip().splitlines()
    if first and len(first[0]) <= 60:
        return str(first[0])
    return "not said in its metadata" if not first else f"its own text: {first[0][:40]}"


def table() -> list[str]:
    """A row for each licence: which packages have it, and by which extra they come."""
    rows: dict[str, dict[str, set[str]]] = defaultdict(lambda: defaultdict(set))
    extras = ["", *sorted(set(metadata.metadata("motes").get_all("Provides-Extra") or []) - FOR_DEVELOPERS)]
    core = brought("")
    for extra in extras:
        for name in brought(extra) - (core if extra else set()):
            rows[licence(name)][name].add(extra or "core")
    lines = ["| licence | packages (by extra) |", "|---|---|"]
    for words in sorted(rows, key=str.lower):
        packages = [f"{name} ({', '.join(sorted(by))})" for name, by in sorted(rows[words].items())]
        lines.append(f"| {words} | {'; '.join(packages)} |")
    return lines


def written(page: str) -> str:
    """The page with its table made again."""
    before, _, rest = page.partition(BEGIN)
    _, _, after = rest.partition(END)
    return "\n".join([before + BEGIN, *table(), END]) + after


def main() -> None:
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    write_text(PAGE, written(PAGE.read_text(encoding="utf-8")))


if __name__ == "__main__":
    main()
