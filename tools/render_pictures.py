"""Make the rendered pictures of the documentation.

usage: python tools/render_pictures.py [DATA [FOLDER [NAME ...]]]      (default: ../shared/data, docs/pictures, all)

Names are dust_days, drying_paint, rusting_sphere, rusting_map, plaster_lambert and measured. Those that need data (STAF maps, CUReT, RGL)
are left out, and said, where DATA does not hold them. About ten minutes on two cores.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import staf_map
from numpy.typing import NDArray

import motes
from motes import maps
from motes.ageing import PHENOMENA, age, rusting_material
from motes.meshes.shapes import SHAPES
from motes.rendering import load_mitsuba
from motes.rendering.films import read_radiance, write_picture
from motes.rendering.panels import sheet
from motes.rendering.passes import Look, rendered
from motes.rendering.pictures import render
from motes.rendering.scenes import Subject, on_stage, preview, subject
from motes.rendering.tonemap import picture

SAMPLES = 100  # 10 x 10 strata
RGB = ("R", "G", "B")
Bytes = NDArray[np.uint8]


def shots(material: motes.Material, look: Look, hours: list[float], **settling: Any) -> list[Bytes]:
    """A material at several times, one picture each."""
    made = []
    with TemporaryDirectory() as folder:
        for k, h in enumerate(hours):
            span = [h] if not settling else [h, max(hours)]  # dust is given by the whole span
            target = Path(folder) / f"{k}.exr"
            render([material], target, look=look, hours=span, settling=settling or None)
            made.append(picture(read_radiance(target)[:, : look.size[0]]))
    return made


def dust_days(data: Path, path: Path) -> None:
    """A glazed bunny and an enamelled teapot gather dust."""
    dust = motes.Dust(w=(0.97, 0.93, 0.86), g=-0.2)
    glaze = motes.OrenNayar(K_d=(0.05, 0.16, 0.15), sigma_d=0.2) + motes.TorranceSparrow(K_s=0.5, sigma_s=0.12)
    enamel = motes.OrenNayar(K_d=(0.42, 0.05, 0.04), sigma_d=0.15) + motes.TorranceSparrow(K_s=0.6, sigma_s=0.1)
    days = [0, 20, 60, 180]
    rows = []
    for name, surface in {"bunny": glaze, "teapot": enamel}.items():
        clean = motes.Material(motes.DustLayer(surface, dust, tau=0.0), name, RGB)
        dusty = age(clean, "dust", hours=24 * days[-1], tau_growth=1.8)
        look = Look(scene=name, size=(250, 250), samples=SAMPLES)
        rows.append(shots(dusty, look, [24.0 * d for d in days], noise=0.35, slipperiness=0.15))
    write_picture(path, sheet(rows, columns=[f"{d} days" for d in days]))


def drying_paint(data: Path, path: Path) -> None:
    """Red paint from wet to dry."""
    paint = PHENOMENA["drying_paint"].example(10)
    hours = [0.0, 1.0, 3.0, 10.0]
    look = Look(scene="teapot", size=(250, 170), samples=SAMPLES)
    write_picture(path, sheet([shots(paint, look, hours)], columns=[f"{h:g} h" for h in hours]))


def rusting_sphere(data: Path, path: Path) -> None:
    """Cast iron that rusts: the STAF maps on a sphere, texel by texel."""
    mi = load_mitsuba()
    maps = motes.read(data / "staf-tvBTF45")
    times = [0.0, 0.2, 0.4, 0.7]
    look = Look(size=(250, 250), samples=SAMPLES)
    ball = Subject(on_stage(SHAPES["sphere"]()), "sphere")  # a mesh, whose poles are above and below
    panels = []
    with TemporaryDirectory() as folder:
        file = rusting_material(maps).save(Path(folder) / "iron.json")
        for t in times:
            # Without the frame of the maps, which is brighter; a polynomial that comes near 0 is a mirror that nobody measured.
            now = {name: value[12:-12, 12:-12] for name, value in maps.at(t).items()}
            values = {
                "K_d": np.clip(now["K_d"], 0, 1),
                "K_s": np.clip(np.nan_to_num(now["K_s"], posinf=8), 0, 8)[..., None],
                "sigma_s": np.maximum(now["sigma_s"], 0.04)[..., None],
            }
            bsdf: dict[str, Any] = {"type": "motes_material", "filename": str(file), "time": t}
            for name, value in values.items():
                bitmap = mi.Bitmap(np.ascontiguousarray(value, np.float32))
                scale = mi.ScalarTransform4f().scale([4, 2, 1])
                bsdf[name] = {"type": "bitmap", "bitmap": bitmap, "raw": True, "to_uv": scale, "wrap_mode": "mirror"}
            panels.append(picture(rendered(lambda b=bsdf: preview(ball, b, size=look.size), look)))
    write_picture(path, sheet([panels], columns=[f"t = {t:g}" for t in times]))


def rusting_map(data: Path, path: Path) -> None:
    """The same iron as a map that was measured by a simulated rig and fitted at every texel and time: as the flat sample, and on a sphere."""
    size, times = 230, 4
    true = staf_map.parameters(data / "staf-tvBTF45", size, times)
    hours = np.linspace(0, 1, times)
    with TemporaryDirectory() as folder:
        made = maps.create_map(Path(folder) / "iron.zarr", (size, size), staf_map.lights(), (0, 0, 1), hours=hours)
        stack = staf_map.measured(made, true, 0.01)
        fitted = maps.fit_map(stack, staf_map.MODEL, out=Path(folder) / "fit.zarr")
        rows = []
        for scene, lamp in (("flat", (12.0, 135.0)), ("flat", (60.0, 135.0)), ("sphere", (45.0, 135.0))):
            target = Path(folder) / "row.exr"
            look = Look(scene=scene, size=(190, 190), samples=SAMPLES if scene == "sphere" else 16, lamp_deg=lamp)
            render([fitted], target, look=look, hours=hours.tolist())
            rows.append([picture(p) for p in np.split(read_radiance(target), times, axis=1)])
    names = ["lamp at 12°", "lamp at 60°", "on a sphere"]
    write_picture(path, sheet(rows, names, [f"t = {t:.2g}" for t in hours]))


def plaster_lambert(data: Path, path: Path) -> None:
    """CUReT's plaster as Oren-Nayar sees it, beside the best Lambert, under a lamp beside the camera: flat, without a dark rim."""
    mi = load_mitsuba()
    measurement = motes.read(data / "curet", sample=10)
    look = Look(size=(300, 300), samples=SAMPLES)
    panels, titles = [], []
    for name in ("oren_nayar", "lambert"):
        fit = motes.fit(measurement, model=name)
        with TemporaryDirectory() as folder:
            file = fit.material.save(Path(folder) / "plaster.json")

            def scene(file: Path = file) -> dict[str, Any]:
                described = preview(
                    subject("sphere"), {"type": "motes_material", "filename": str(file)}, size=look.size
                )
                for light in ("fill", "rim", "dome"):
                    del described[light]
                placed = mi.ScalarTransform4f().look_at(origin=[-0.8, 3.0, 7.5], target=[0, 0.9, 0], up=[0, 1, 0])
                described["key"]["to_world"] = placed.scale(0.5)
                described["key"]["emitter"] = {"type": "area", "radiance": {"type": "uniform", "value": 190.0}}
                return described

            panels.append(picture(rendered(scene, look)))
        titles.append(f"{name.replace('_', '-')}, {100 * fit.metrics['relative_rms']:.1f} % off")
    write_picture(path, sheet([panels], columns=titles))


def measured(data: Path, path: Path) -> None:
    """Measured materials beside their fits."""
    rows, titles = [], []
    for name in ("vch_silk_blue", "aurora_white"):
        file = data / "rgl" / f"{name}_rgb.bsdf"
        fit = motes.fit(motes.read(file), model="oren_nayar + torrance_sparrow")
        with TemporaryDirectory() as folder:
            target = Path(folder) / "both.exr"
            look = Look(size=(240, 240), samples=SAMPLES)
            render([fit.material], target, look=look, measured=file)
            rows.append([picture(p) for p in np.split(read_radiance(target), 2, axis=1)])
        titles.append(name.replace("_", " "))
    flat = [panel for row in rows for panel in row]
    names = [word for title in titles for word in (title, "its fit")]
    write_picture(path, np.concatenate([sheet([flat[k : k + 2]], columns=names[k : k + 2]) for k in (0, 2)], axis=1))


PICTURES: dict[str, tuple[Callable[[Path, Path], None], str]] = {
    "dust_days": (dust_days, ""),
    "drying_paint": (drying_paint, ""),
    "rusting_sphere": (rusting_sphere, "staf-tvBTF45"),
    "rusting_map": (rusting_map, "staf-tvBTF45"),
    "plaster_lambert": (plaster_lambert, "curet"),
    "measured": (measured, "rgl"),
}


def main() -> None:
    arguments = sys.argv[1:]
    data, folder = (Path(p) for p in (*arguments[:2], *("../shared/data", "docs/pictures")[len(arguments[:2]) :]))
    for name in arguments[2:] or PICTURES:
        draw, needed = PICTURES[name]
        if needed and not (data / needed).exists():
            print(f"{name} is left out: {data / needed} is missing")
            continue
        path = folder / f"{name}.png"
        draw(data, path)
        print(f"{path}: {path.stat().st_size // 1024} kB")


if __name__ == "__main__":
    main()
