"""The page of licences is what the installed packages say, and leaves out none that an extra brings."""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="module")
def tool() -> ModuleType:
    spec = importlib.util.spec_from_file_location("licences", ROOT / "tools" / "licences.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_what_extras_bring_is_followed_to_the_end(tool: ModuleType) -> None:
    core = tool.brought("")
    assert {"numpy", "llvmlite", "rich", "cyclopts"} <= core
    assert "openpyxl" in tool.brought("xlsx")
    assert "et-xmlfile" in tool.brought("xlsx")  # of openpyxl
    assert "drjit" in tool.brought("render")  # of Mitsuba
    assert not tool.brought("xlsx") & core


def test_every_package_named_by_an_extra_is_on_the_page(tool: ModuleType) -> None:
    page = (ROOT / "docs" / "libraries.md").read_text(encoding="utf-8")
    table = page.partition(tool.BEGIN)[2].partition(tool.END)[0]
    listed = set(re.findall(r"([a-z\d-]+) \(", table))
    for extra in (
        "",
        "exr",
        "pictures",
        "xarray",
        "xlsx",
        "soiling",
        "scale",
        "render",
        "materialx",
        "usd",
        "notebook",
        "glsl",
    ):
        named = {tool.normal(r.name) for r in tool.requirements("motes", extra)} - {"motes"}
        assert named <= listed, extra


def test_metadata_in_all_its_forms(tool: ModuleType) -> None:
    from email.message import Message

    def of(**fields: str) -> str:
        about = Message()
        for name, value in fields.items():
            about[name.replace("_", "-")] = value
        return str(tool._of_metadata(about))

    assert of(License_Expression="MIT", License="other") == "MIT"
    assert of(Classifier="License :: OSI Approved :: BSD License") == "BSD License"
    assert of(License="Apache 2.0") == "Apache 2.0"
    assert of(License="Copyright " + 80 * "x").startswith("its own text: Copyright")
    assert of(Name="a") == "not said in its metadata"


def test_ffmpegs_own_words_are_asked_for(tool: ModuleType) -> None:
    pytest.importorskip("av")
    assert "of itself" in tool.licence("av")
