"""Build the viewer: the types that TypeScript takes from Python, the meshes, the module and the style sheet that ship with Motes.

python tools/viewer_build.py            types and bundle (Node with npm)
python tools/viewer_build.py --shapes   the meshes, too (the extra render)
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

from motes.files import write_text
from motes.viewer.declarations import typescript
from motes.viewer.shipped_shapes import FILE, make

ROOT = Path(__file__).resolve().parents[1]
SOURCES = ROOT / "viewer"
STATIC = ROOT / "src" / "motes" / "viewer" / "static"


def main() -> None:
    """See the module."""
    write_text(SOURCES / "src" / "generated.ts", typescript())
    if "--shapes" in sys.argv[1:]:
        write_text(STATIC / FILE, json.dumps(make(), separators=(",", ":")) + "\n")
    if not (SOURCES / "node_modules").is_dir():
        subprocess.run(["npm", "ci"], cwd=SOURCES, check=True)
    for command in (["npm", "run", "--silent", "check"], ["npm", "run", "--silent", "build"]):
        subprocess.run(command, cwd=SOURCES, check=True)
    for file in sorted(STATIC.iterdir()):
        print(f"{file.relative_to(ROOT)}  {file.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
