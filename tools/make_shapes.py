"""Write the numbers of the teapot and the bunny that Motes ships, from the files of two npm packages.

usage: python tools/make_shapes.py TeapotGeometry.js bunny/index.js [FOLDER]

`npm pack three bunny` fetches them: three (MIT) has examples/jsm/geometries/TeapotGeometry.js, which quotes the public data of Martin Newell; bunny
1.0.1 (public domain) is a decimated Stanford bunny.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

import numpy as np


def numbers(text: str) -> list[float]:
    """All numbers of a JavaScript array; signs may stand apart."""
    text = re.sub(r"/\*.*?\*/", "", text)
    return [float(x.replace(" ", "")) for x in re.findall(r"-?\s?\d+(?:\.\d*)?(?:e-?\d+)?|-?\s?\.\d+", text)]


def array(source: str, opening: str, closing: str) -> list[float]:
    """The numbers between two pieces of text."""
    return numbers(source.split(opening, 1)[1].split(closing, 1)[0])


def main() -> None:
    teapot, bunny = (Path(p).read_text(encoding="utf-8") for p in sys.argv[1:3])
    folder = Path(sys.argv[3] if len(sys.argv) > 3 else "src/motes/rendering/data")
    patches = np.array(array(teapot, "teapotPatches = [", "];")).reshape(32, 16).astype(np.uint16)
    points = np.array(array(teapot, "teapotVertices = [", "];")).reshape(-1, 3).astype(np.float32)
    assert patches.max() == len(points) - 1
    np.savez_compressed(folder / "teapot.npz", patches=patches, points=points)
    positions = np.array(array(bunny, "positions=[", "]]")).reshape(-1, 3).astype(np.float32)
    triangles = np.array(array(bunny, "cells=[", "]]")).reshape(-1, 3).astype(np.uint16)
    assert triangles.max() == len(positions) - 1
    np.savez_compressed(folder / "bunny.npz", positions=positions, triangles=triangles)
    for name in ("teapot", "bunny"):
        print(f"{folder / name}.npz: {(folder / f'{name}.npz').stat().st_size} bytes")


if __name__ == "__main__":
    main()
