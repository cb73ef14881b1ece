"""Everything that docs/trust.md leans on exists."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE = (ROOT / "docs" / "trust.md").read_text(encoding="utf-8")


def test_tests_scripts_and_pages_named_are_there() -> None:
    named = re.findall(r"`((?:tests|tools)/[\w/.*]+)`", PAGE)
    assert len(named) > 25
    assert [name for name in named if not list(ROOT.glob(name.rstrip("/")))] == []
    pages = re.findall(r"\]\((\w[\w-]*\.md)\)", PAGE)
    assert len(set(pages)) > 10
    assert [name for name in pages if not (ROOT / "docs" / name).is_file()] == []


def test_every_row_says_what_holds_it() -> None:
    rows = [line.split("|")[1:-1] for line in PAGE.splitlines() if line.startswith("| ")][1:]
    assert len(rows) > 15
    for what, against, by, figures in rows:
        assert all(cell.strip() for cell in (what, against, figures))
        assert re.search(r"`(tests/|make )", by), what


def test_the_readme_leads_here() -> None:
    assert "(docs/trust.md)" in (ROOT / "README.md").read_text(encoding="utf-8")
