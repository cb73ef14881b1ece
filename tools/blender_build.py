"""Build Blender's extension: the files of blender/motes_dust with what Motes itself says, in one zip.

    python tools/blender_build.py [-o dist]

From Motes come ``gathering.py`` (a copy), ``numbers.py`` (the defaults of a deposit), ``dusts.json`` (each dust's lobes as functions of tau),
``sockets.json`` (what the sockets of the Principled BSDF are called) and an OSL shader for each dust.  The same sources give the same zip, bit by bit.
"""

from __future__ import annotations

import argparse
import json
import re
import zipfile
from pathlib import Path
from typing import Any

import numpy as np

from motes.arrays import NUMPY
from motes.exports.approximation import lobes
from motes.exports.osl_layer import layer_shader
from motes.exports.surface_blender import SOCKETS, STEP
from motes.models import Dust
from motes.models.dust_optics import DUSTS
from motes.models.multiple_scattering import INFINITE, Diffused
from motes.models.slants import Slant
from motes.models.standard import DIFFUSIVITY, MEAN_COSINE
from motes.rendering.deposition import GROWTH_PER_DAY, SETTLING
from motes.version import __version__

ROOT = Path(__file__).resolve().parents[1]
SOURCE = ROOT / "blender" / "motes_dust"
GATHERING = ROOT / "src" / "motes" / "rendering" / "gathering.py"
#: Stops of a colour ramp, of which Blender takes 32.
STOPS = 32


def facts(dust: Dust) -> dict[str, Any]:
    """The lobes of a layer of dust over anything: of light scattered once, and curves over tau / (1 + tau).

    With the transmittance T and the albedo a of what lies below, the layer is T base + a diffuse lobe of
    (1 - T) once + escaping + a below / (1 - a returned); see `motes.models.exchange.Exchange.importance`.
    """
    (once,) = lobes(dust)
    place = np.linspace(0, 1, STOPS)
    tau = np.where(place < 1, place / np.maximum(1 - place, 1e-12), INFINITE)[:, None]
    layer = Diffused(NUMPY, tau, np.broadcast_to(dust.w, 3), dust.g)
    mean = Slant.at(MEAN_COSINE)
    below = layer.straight(mean) * layer.mean_returned + layer.arriving(mean)
    curves = {
        "escaping": layer.escaping(mean),
        "below": below * layer.mean_arriving,
        "returned": layer.mean_returned,
    }
    return {
        "w": np.broadcast_to(dust.w, 3).tolist(),
        "g": float(dust.g),
        "diffusivity": DIFFUSIVITY,
        "once": np.broadcast_to(once.grazing, 3).tolist(),
        **{name: np.broadcast_to(curve, (STOPS, 3)).round(7).tolist() for name, curve in curves.items()},
    }


def files() -> dict[str, str]:
    """The texts of the extension, by path."""
    found = {path.name: path.read_text("utf-8") for path in sorted(SOURCE.iterdir()) if path.is_file()}
    found["blender_manifest.toml"] = re.sub(
        r'^version = ".*"', f'version = "{__version__}"', found["blender_manifest.toml"], flags=re.MULTILINE
    )
    found["gathering.py"] = GATHERING.read_text("utf-8")
    numbers = {name.upper(): option.default for name, option in SETTLING.items()} | {"GROWTH_PER_DAY": GROWTH_PER_DAY}
    found["numbers.py"] = '"""Defaults, as Motes has them."""\n\n' + "".join(
        f"{k} = {v!r}\n" for k, v in numbers.items()
    )
    dusts = {name: optics.dust() for name, optics in DUSTS.items()}
    table = {name: {"source": DUSTS[name].source, **facts(dust)} for name, dust in dusts.items()}
    found["dusts.json"] = json.dumps(table, indent=None, ensure_ascii=False) + "\n"
    for name, dust in dusts.items():
        found[f"osl/{name}.osl"] = layer_shader(
            dust, shader_name=f"motes_dust_{name}", title=f"Dust ({DUSTS[name].words})"
        )
    found["sockets.json"] = json.dumps({"sockets": SOCKETS, "step": STEP}, indent=1) + "\n"
    found["LICENSE"] = (ROOT / "LICENSE").read_text("utf-8")
    return found


def build(folder: Path) -> Path:
    """Write the zip into a folder; returns its path."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"motes_dust-{__version__}.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in sorted(files().items()):
            archive.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), text, zipfile.ZIP_DEFLATED)
    return path


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "dist")
    print(build(parser.parse_args().output))
