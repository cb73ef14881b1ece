"""Circles among files, names that two files share, long files, sizes of rooms: ``python tools/rooms.py`` prints them; exit status 1 for the first two.

import-linter checks that *rooms* import one way.  This looks inside the rooms too, and counts every import statement: at the top of a file,
inside a function, or for type checkers alone.  A file can be read alone only where none of what it needs, needs it.

A package's ``__init__`` counts as a file like any other; importing ``motes.fitting.result`` is no import of ``motes/fitting/__init__.py`` (Python runs
that one first, but the importing file uses nothing of it), while ``from motes.fitting import fit`` is.  Names in strings (``motes.outlets``, the
front's list of homes, the export targets) are not seen: they are there to be looked up when everything has been imported.
"""

from __future__ import annotations

import ast
import io
import sys
import tokenize
from collections import Counter, defaultdict
from collections.abc import Collection
from pathlib import Path
from typing import NamedTuple

import grimp
import networkx

LONG = 400  # lines
_NO_CODE = {
    tokenize.COMMENT,
    tokenize.NL,
    tokenize.NEWLINE,
    tokenize.INDENT,
    tokenize.DEDENT,
    tokenize.ENDMARKER,
}
# A language is printed by one file and exported to by another: two sides of one thing, under its name.
LANGUAGES = frozenset({"c", "glsl", "hlsl", "osl", "wgsl"})


class Circle(NamedTuple):
    """Files that need one another, and the statements by which they do."""

    files: tuple[str, ...]
    statements: tuple[str, ...]

    def __str__(self) -> str:
        return "\n".join([f"circle of {len(self.files)} files: {', '.join(self.files)}", *self.statements])


def circles(package: str) -> list[Circle]:
    """Every group of files of which each imports, directly or not, all the others; the largest first."""
    graph = grimp.build_graph(package, cache_dir=None)
    arrows = networkx.DiGraph((m, n) for m in graph.modules for n in graph.find_modules_directly_imported_by(m))
    found = []
    for group in networkx.strongly_connected_components(arrows):
        if len(group) == 1:
            continue
        statements = sorted(
            f"  {importer}, line {detail['line_number']}: {detail['line_contents']}"
            for importer in group
            for imported in graph.find_modules_directly_imported_by(importer) & group
            for detail in graph.get_import_details(importer=importer, imported=imported)
        )
        found.append(Circle(tuple(sorted(group)), tuple(statements)))
    return sorted(found, key=lambda circle: (-len(circle.files), circle.files))


def shared_names(folder: Path, allowed: Collection[str] = LANGUAGES) -> dict[str, list[str]]:
    """Names that two files or rooms (folders) have, with their paths; `allowed` names may be shared.

    An underscore in front of a name or behind it makes no other name of it.
    """
    by_name = defaultdict(list)
    for path in sorted(folder.rglob("*.py")):
        by_name[(path.parent.name if path.stem == "__init__" else path.stem).strip("_")].append(
            str(path.relative_to(folder))
        )
    return {name: paths for name, paths in by_name.items() if len(paths) > 1 and name not in allowed}


def long_files(folder: Path, limit: int = LONG) -> dict[str, int]:
    """Files of more than `limit` lines, with their numbers of lines, the longest first."""
    lines = Counter(
        {str(path.relative_to(folder)): len(path.read_text("utf-8").splitlines()) for path in folder.rglob("*.py")}
    )
    return {path: n for path, n in lines.most_common() if n > limit}


def code_lines(text: str) -> int:
    """Lines of Python that hold more than comments and docstrings."""
    ends: set[int] = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef) and ast.get_docstring(node) is not None:
            ends |= set(range(node.body[0].lineno, (node.body[0].end_lineno or 0) + 1))
    held: set[int] = set()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type not in _NO_CODE:
            held |= set(range(token.start[0], token.end[0] + 1))
    return len(held - ends)


def sizes(folder: Path) -> dict[str, tuple[int, int, int]]:
    """Of each folder of files, those of the folders in it included: files, lines, lines of code."""
    found = {}
    for room in sorted(path for path in folder.rglob("*") if path.is_dir() and any(path.glob("*.py"))):
        texts = [path.read_text("utf-8") for path in room.rglob("*.py")]
        lines = sum(len(text.splitlines()) for text in texts)
        found[str(room.relative_to(folder))] = (len(texts), lines, sum(map(code_lines, texts)))
    return found


def main() -> int:
    folder = Path(__file__).resolve().parents[1] / "src" / "motes"
    sys.path.insert(0, str(folder.parent))
    rounds, doubles, long = circles("motes"), shared_names(folder), long_files(folder)
    print(f"circles among files: {len(rounds)}", *rounds, sep="\n")
    print(f"names that several files have: {len(doubles)}")
    print(*(f"  {name}: {', '.join(paths)}" for name, paths in doubles.items()), sep="\n", end="\n" if doubles else "")
    print(f"files of more than {LONG} lines: {len(long)}")
    print(*(f"  {n} {path}" for path, n in long.items()), sep="\n", end="\n" if long else "")
    print("rooms: files, lines, lines of code")
    print(*(f"  {room}: {n}, {lines:,}, {code:,}" for room, (n, lines, code) in sizes(folder).items()), sep="\n")
    return 1 if rounds or doubles else 0


if __name__ == "__main__":
    sys.exit(main())
