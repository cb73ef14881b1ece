"""Write docs/gallery.md and its pictures: each picture by the commands that the page shows, run as they stand there.

python tools/gallery.py              the page and the pictures (the extra render)
python tools/gallery.py --page       the page alone
"""

from __future__ import annotations

import shlex
import shutil
import sys
import tempfile
from contextlib import chdir
from pathlib import Path
from typing import NamedTuple

from motes.cli.main import main as motes
from motes.files import write_text

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "gallery.md"
PICTURES = ROOT / "docs" / "pictures"


class Entry(NamedTuple):
    """A picture: its title, its file, the commands that make it (the last one writes the file), and what is seen."""

    title: str
    picture: str
    commands: tuple[str, ...]
    words: str


ENTRIES = (
    Entry(
        "Metals of the presets",
        "gallery_metals.png",
        ("motes render gold silver copper aluminium --size 240 --samples 200 -o gallery_metals.png",),
        "Presets stand side by side; `motes material --list` shows all of them, and where their numbers come from.",
    ),
    Entry(
        "Rough and smooth",
        "gallery_rough.png",
        (
            'motes render "oren_nayar(K_d=(0.8,0.55,0.35), sigma_d=0)" "oren_nayar(K_d=(0.8,0.55,0.35), sigma_d=0.6)" '
            "--size 320 --samples 200 --no-labels -o gallery_rough.png",
        ),
        "A Lambertian sphere and one whose facets are steep: the rough one is flat, like the full moon. Equations (1)-(8).",
    ),
    Entry(
        "A varnished teapot through half a year",
        "gallery_dusty.png",
        (
            "motes age varnish --phenomenon dust --hours 4000 -o dusty.json",
            "motes render dusty.json --scene teapot --deposit --time 0,1000,4000 --size 280 --samples 64 -o gallery_dusty.png",
        ),
        "Dust lies where it settles, on what faces the sky; all orders of scattering.",
    ),
    Entry(
        "Paint that dries",
        "gallery_paint.png",
        (
            "motes age red_paint --phenomenon drying_paint --hours 6 -o paint.json",
            "motes render paint.json --scene bunny --time 0,1,6 --size 280 --samples 64 -o gallery_paint.png",
        ),
        "The highlight of wet paint fades and spreads, and its colour pales.",
    ),
    Entry(
        "A painted wall, every texel another",
        "gallery_wall.png",
        (
            "motes simulate wall.zarr --size 96 --scans 3",
            'motes fit wall.zarr --model "oren_nayar + torrance_sparrow"',
            "motes render motes-wall.zarr --scene sphere --time 0,2,6 --size 280 --samples 100 -o gallery_wall.png",
        ),
        "A fitted map on a sphere: stripes that dry, simulated, measured with noise, fitted at each of 96 x 96 texels and three times. "
        "Without `--scene` it is the flat sample, seen from above.",
    ),
)

HEAD = """# Gallery

Pictures, each with the commands that made it; `python tools/gallery.py` makes them all anew.
They run from any folder once Motes is installed with the extra `render`.
[Pictures and films](render-command.md) has all options, [Ageing](ageing.md) the phenomena.
"""
FOOT = """
## More pictures
[The viewer](viewer.md) is looked at in a browser, [maps](maps.md) of real surfaces and [dust on meshes](deposition.md) have pages of their own.
"""


def page() -> str:
    """The text of the page."""
    parts = [HEAD]
    for entry in ENTRIES:
        commands = "\n".join(entry.commands)
        parts.append(
            f"\n## {entry.title}\n![{entry.title}](pictures/{entry.picture})\n\n{entry.words}\n\n```\n{commands}\n```\n"
        )
    return "".join([*parts, FOOT])


def make(entry: Entry) -> None:
    """Run the commands of a picture, and keep what the last one writes."""
    with tempfile.TemporaryDirectory() as folder, chdir(folder):
        for command in entry.commands:
            status = motes([*shlex.split(command)[1:], "--quiet"])
            if status:
                raise SystemExit(f"{command} ended with status {status}")
        shutil.copyfile(entry.picture, PICTURES / entry.picture)


def main() -> None:
    """See the module."""
    write_text(PAGE, page())
    if "--page" not in sys.argv[1:]:
        for entry in ENTRIES:
            make(entry)
            print(entry.picture)


if __name__ == "__main__":
    main()
