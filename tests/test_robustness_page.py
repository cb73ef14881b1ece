"""docs/robustness.md: the tests that it names exist, all findings have a row, and what it counts is what the tests try."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from kill_commands import JOBS

TESTS = Path(__file__).parent
PAGE = (TESTS.parent / "docs" / "robustness.md").read_text(encoding="utf-8")


@cache
def functions(file: str) -> frozenset[str]:
    """The tests of a file."""
    tree = ast.parse((TESTS / file).read_text(encoding="utf-8"))
    return frozenset(node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef))


def named() -> Iterator[tuple[str, str]]:
    """(file, test) as the page has them; a test without a file is one of the file before it."""
    file = ""
    for text in re.findall(r"`((?:tests/)?(?:test_\w+\.py)?(?:::test_\w+)?)`", PAGE):
        head, _, test = text.removeprefix("tests/").partition("::")
        file = head or file
        if file:
            yield file, test


def test_the_tests_that_are_named_exist() -> None:
    found = list(named())
    assert len(found) > 60
    for file, test in found:
        assert (TESTS / file).is_file(), file
        assert not test or test in functions(file), f"{file}::{test}"


def test_each_of_the_fourteen_findings_has_a_row_with_a_test() -> None:
    rows = re.findall(r"^\| (\d+) \|(.*)\|$", PAGE, re.MULTILINE)
    assert [int(number) for number, _ in rows] == list(range(1, 15))
    for number, row in rows:
        cells = row.split(" | ")
        assert len(cells) == 4, number
        assert "::test_" in cells[-1], number


def test_every_command_that_writes_is_counted() -> None:
    """Each job of kill_commands.py has a row: operations, how many of them it was killed at, none of them wrong."""
    part = PAGE.partition("| command | operations |")[2].partition("\n\n")[0]
    rows = re.findall(r"^\| (`[^|]+) \| (\d+) \| (\d+) \| (\d+) \|$", part, re.MULTILINE)
    assert len(rows) == len(JOBS)
    commands = {re.match(r"`(?:Fit\.)?(\w+)", name)[1] for name, *_ in rows}
    assert commands == {job.arguments[0] for job in JOBS.values()}
    assert commands >= {"fit", "simulate", "stack", "dust", "render", "age", "export", "view", "report"}
    assert any("a map" in name for name, *_ in rows if name.startswith("`fit`"))
    for name, operations, killed, wrong in rows:
        assert 4 <= int(killed) <= int(operations), name
        assert int(wrong) == 0, name
