"""Build the documentation site: what make docs does.

    python tools/site_build.py                  # into out/site; open out/site/index.html
    python tools/site_build.py --output DIR

The pages of `docs/`, the README as first steps, and pages made from what the code declares (`site_pages.py`: models, presets, the library) are laid
out side by side and given to Sphinx (`site/conf.py`), whose warnings are errors.  Then every link within the site is followed, and nothing that a page
loads may come from elsewhere (`site_links.py`).
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
from pathlib import Path

from site_links import faults
from site_pages import api, models, presets

ROOT = Path(__file__).resolve().parents[1]
FROM_ROOT = ("CONTRIBUTING.md", "SECURITY.md", "CHANGELOG.md")
#: What Sphinx and its theme write, and what screen readers and keyboards need: headings have levels, what scrolls takes the focus.
FOR_EVERYBODY = (
    ('role="heading">', 'role="heading" aria-level="2">'),
    ("<pre>", '<pre tabindex="0">'),
    ('<div class="table-wrapper', '<div tabindex="0" class="table-wrapper'),
    ('<div class="math">', '<div class="math" tabindex="0">'),
)
_LINK = re.compile(r"(\]\()(?!https?:|#|mailto:)([^)#\s]+)(#[^)\s]*)?(\))")


def lay_out(source: Path) -> None:
    """The sources of the site, in a folder of their own."""
    shutil.rmtree(source, ignore_errors=True)
    shutil.copytree(ROOT / "site", source, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(ROOT / "docs" / "pictures", source / "pictures")
    pages = {path.name: path for path in (ROOT / "docs").glob("*.md")}
    pages |= {name: ROOT / name for name in FROM_ROOT} | {"start.md": ROOT / "README.md"}
    for name, path in pages.items():
        text = _links(path, path.read_text(encoding="utf-8"), source)
        if name == "start.md":
            text = text.replace("# Motes\n", "# First steps\n", 1)
        (source / name).write_text(text, encoding="utf-8")
    index = source / "index.md"
    more = sorted(
        name.removesuffix(".md")
        for name in pages
        if not re.search(rf"^{re.escape(name[:-3])}$", index.read_text(), re.M)
    )
    if more:  # a page that nobody has placed yet is found all the same
        index.write_text(
            index.read_text() + "\n```{toctree}\n:hidden:\n:caption: More\n\n" + "\n".join(more) + "\n```\n"
        )
    for name, made in (("models.md", models()), ("presets.md", presets()), ("api.rst", api())):
        (source / name).write_text(made, encoding="utf-8")


def _links(page: Path, text: str, source: Path) -> str:
    """The text of a page with its links as they are in the site: pages stand side by side, other files in files/."""

    def moved(match: re.Match[str]) -> str:
        target = (page.parent / match[2]).resolve()
        inside = target.relative_to(ROOT).as_posix()
        if not target.exists():
            raise SystemExit(f"{page.relative_to(ROOT)}: the link to {match[2]} leads nowhere")
        if target == ROOT / "README.md":
            new = "start.md"
        elif inside.startswith("docs/") and target.suffix != ".html":
            new = inside.removeprefix("docs/")
        elif inside in FROM_ROOT:
            new = inside
        elif target.is_file():
            new = f"files/{inside}"
            (source / new).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(target, source / new)
        else:
            raise SystemExit(f"{page.relative_to(ROOT)}: the link to the folder {match[2]} is none of a site")
        return f"{match[1]}{new}{match[3] or ''}{match[4]}"

    parts = re.split(r"(^```.*?^```)", text, flags=re.MULTILINE | re.DOTALL)  # what stands in blocks is code
    return "".join(part if part.startswith("```") else _LINK.sub(moved, part) for part in parts)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=Path, default=ROOT / "out" / "site")
    given = parser.parse_args()
    output, work = given.output, given.output.with_name(f"{given.output.name}-source")
    lay_out(work)
    shutil.rmtree(output, ignore_errors=True)
    command = [sys.executable, "-m", "sphinx", "-b", "html", "-W", "--keep-going", "-q", "-j", "2"]
    built = subprocess.run([*command, "-d", str(work / "_build"), str(work), str(output)], check=False)
    if built.returncode:
        return built.returncode
    for page in output.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        for written, meant in FOR_EVERYBODY:
            text = text.replace(written, meant)
        page.write_text(text, encoding="utf-8")
    found = faults(output)
    for fault in found:
        print(fault, file=sys.stderr)
    pages = sum(1 for _ in output.rglob("*.html"))
    print(f"{pages} pages in {output}; open {output / 'index.html'}")
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main())
