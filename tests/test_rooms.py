"""What the rooms hold to: no circles among files, a name for one thing, pages written by whom the front says; and that the check sees them."""

from __future__ import annotations

import importlib
import importlib.util
import inspect
import re
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

from motes import outlets

ROOT = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="module")
def rooms() -> ModuleType:
    """tools/rooms.py"""
    spec = importlib.util.spec_from_file_location("rooms", ROOT / "tools" / "rooms.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_there_are_no_circles_among_files(rooms: ModuleType) -> None:
    found = rooms.circles("motes")
    assert not found, "\n".join(map(str, found))


def test_a_name_is_one_thing(rooms: ModuleType) -> None:
    assert rooms.shared_names(ROOT / "src" / "motes") == {}


def test_sizes_count_what_runs(rooms: ModuleType, tmp_path: Path) -> None:
    text = '"""About."""\n\n# why\nx = 1  # one\n\n\ndef f():\n    """Idea.\n\n    More.\n    """\n    return """a\n\nb"""\n'
    assert rooms.code_lines(text) == 5  # x, def, and a text of three lines that is no docstring
    package(tmp_path, "kitchen", a=text, sink__b=text)
    found = rooms.sizes(tmp_path)
    assert found["kitchen/sink"][:2] == (2, 14)
    assert found["kitchen"] == (4, 28, 10)


def package(folder: Path, name: str, **files: str) -> None:
    """A package with these files; a slash is written as two underscores."""
    for file, text in {"__init__": "", **files}.items():
        parts = [file] if file == "__init__" else file.split("__", 1)
        path = folder.joinpath(name, *parts).with_suffix(".py")
        path.parent.mkdir(parents=True, exist_ok=True)
        (path.parent / "__init__.py").touch()
        path.write_text(text)


@pytest.mark.parametrize(
    ("name", "statement"),
    [
        ("at_the_top", "from {name} import a"),
        ("in_a_function", "def f():\n    from {name}.a import x\n"),
        ("for_type_checkers", "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from {name}.a import x\n"),
        ("in_a_try", "try:\n    import {name}.a as a\nexcept ImportError:\n    pass\n"),
        ("relative", "from . import a"),
    ],
)
def test_a_circle_is_seen(
    rooms: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, statement: str
) -> None:
    name = f"round_{name}"
    package(
        tmp_path,
        name,
        a=f"from {name}.low import b",
        low__b=f"import {name}.low.c",
        low__c=statement.format(name=name) if name != "round_relative" else "from .. import a",
        other=f"from {name} import a",
    )
    monkeypatch.syspath_prepend(tmp_path)
    (circle,) = rooms.circles(name)
    assert circle.files == (f"{name}.a", f"{name}.low.b", f"{name}.low.c")
    line = statement.format(name=name).splitlines()
    number = next(k for k, text in enumerate(line, 1) if "import" in text and "typing" not in text)
    assert f"{name}.low.c, line {number}: " in str(circle)


def test_a_package_that_imports_its_own_front_is_a_circle(
    rooms: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    package(tmp_path, "fronted", __init__="from fronted.a import x\nx", a="import fronted.b", b="x = 1")
    monkeypatch.syspath_prepend(tmp_path)
    assert rooms.circles("fronted") == []
    (tmp_path / "fronted" / "b.py").write_text("import fronted\nx = 1")
    (circle,) = rooms.circles("fronted")
    assert circle.files == ("fronted", "fronted.a", "fronted.b")


def test_shared_names_and_long_files_are_seen(rooms: ModuleType, tmp_path: Path) -> None:
    package(tmp_path, "p", a__table="x\n" * 11, b___table="", b__a="", a__c="", b__c="", d="x\n" * 10)
    folder = tmp_path / "p"
    shared = rooms.shared_names(folder, allowed={"c"})
    assert shared == {"table": ["a/table.py", "b/_table.py"], "a": ["a/__init__.py", "b/a.py"]}
    assert rooms.long_files(folder, limit=10) == {"a/table.py": 11}


def test_every_offered_page_has_a_writer_for_the_class_that_asks_for_it() -> None:
    """The pages are named in strings: the functions are there, and take what hands itself over."""
    kinds = {}
    for name in outlets.offered():
        parameters = list(inspect.signature(outlets.writer(name), eval_str=True).parameters.values())
        assert parameters[1].name == "path"
        kinds[name] = parameters[0].annotation
    assert len(set(kinds.values())) == len(kinds) == 5
    for name, kind in kinds.items():
        asked = name if getattr(kind, "kind", None) == name else f'"{name}"'
        call = f"outlets.report({'self.kind' if asked == name else asked}, self, path)"
        assert call in inspect.getsource(kind.report)


DOCUMENTS = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
SOURCES = sorted(p for folder in ("src", "examples", "tools", "benchmarks") for p in (ROOT / folder).rglob("*.py"))
#: Groups of entry points, which are no modules.
GROUPS = {"motes.readers"}


def is_there(name: str) -> bool:
    """Whether ``motes.a.b`` is a module, or something in one."""
    parts = name.split(".")
    found: object = importlib.import_module(parts[0])
    for k in range(1, len(parts)):
        try:
            found = getattr(found, parts[k])
        except AttributeError:
            try:
                found = importlib.import_module(".".join(parts[: k + 1]))
            except ModuleNotFoundError:
                return False
    return True


def test_documents_and_comments_name_what_is_there() -> None:
    """Paths of modules, functions and files, also where no import would fail over them."""
    missing = []
    for path in (*DOCUMENTS, *SOURCES):
        text = path.read_text("utf-8")
        names = {
            f"motes{found}" for found in re.findall(r"(?<![\w./-])motes((?:\.[A-Za-z_]\w*)+)(?![\w(]*\.zarr)", text)
        }
        missing += [f"{path.name}: {name}" for name in sorted(names - GROUPS) if not is_there(name)]
        for file in sorted(set(re.findall(r"`((?:\w+/)+\w+\.py)", text))):
            if not any((ROOT / root / file).is_file() for root in ("", "src", "src/motes")):
                missing.append(f"{path.name}: {file}")
    assert missing == []


def test_pages_are_imported_when_one_is_wanted() -> None:
    code = "import sys, motes.fitting, motes.maps; sys.exit(any(m.startswith('motes.report') for m in sys.modules))"
    assert subprocess.run([sys.executable, "-c", code], timeout=120).returncode == 0
