"""The gallery: its page is what the tool writes, its pictures are there, and its commands are commands of today."""

from __future__ import annotations

import importlib.util
import re
import shlex
from pathlib import Path
from types import ModuleType

import pytest

from motes.cli.main import main, make_app

ROOT = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="module")
def gallery() -> ModuleType:
    """tools/gallery.py"""
    spec = importlib.util.spec_from_file_location("gallery", ROOT / "tools" / "gallery.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_page_is_what_the_tool_writes(gallery: ModuleType) -> None:
    assert gallery.PAGE.read_text(encoding="utf-8") == gallery.page()


def test_every_picture_is_there_and_written_by_its_last_command(gallery: ModuleType) -> None:
    shown = re.findall(r"\]\(pictures/(\S+?)\)", gallery.page())
    assert shown == [entry.picture for entry in gallery.ENTRIES]
    for entry in gallery.ENTRIES:
        data = (gallery.PICTURES / entry.picture).read_bytes()
        assert data[:4] == b"\x89PNG"
        words = shlex.split(entry.commands[-1])
        assert words[words.index("-o") + 1] == entry.picture


def test_every_command_is_understood(gallery: ModuleType) -> None:
    app = make_app()
    for entry in gallery.ENTRIES:
        for command in entry.commands:
            program, *arguments = shlex.split(command)
            assert program == "motes"
            app.parse_args(arguments, exit_on_error=False, print_error=False)


def test_the_materials_are_aged_as_the_page_says(
    gallery: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All but the pictures themselves, which take their time."""
    pytest.importorskip("zarr")
    monkeypatch.chdir(tmp_path)
    made = 0
    for entry in gallery.ENTRIES:
        for command in entry.commands[:-1]:
            few = command.replace("--size 96", "--size 6")  # texels along a side of a map
            assert main([*shlex.split(few)[1:], "--quiet"]) == 0
            made += 1
        subjects = [word for word in shlex.split(entry.commands[-1]) if word.endswith((".json", ".zarr"))]
        assert all((tmp_path / word).exists() for word in subjects)
    assert made == 4
