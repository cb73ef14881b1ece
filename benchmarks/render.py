"""How fast Mitsuba renders with the plugins of Motes, what their sampling saves, and what furnaces say.

    python benchmarks/render.py [--rounds 15] [--only speed compile scalar variance furnace]

Renderings are taken in turn in one process, so that ratios mean something on a busy machine: each is the median over the
rounds of the quotient to ``principled`` in the same round.  Processor time counts all threads.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes import Dielectric, Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow
from motes.models import BRDF
from motes.rendering import load_mitsuba, load_scene

Description = dict[str, Any]
SIZE, SPP = 256, 64


def rgb(*color: float) -> Description:
    return {"type": "rgb", "value": list(color)}


COLOR, WHITE = (0.8, 0.7, 0.6), (0.9, 0.8, 0.7)
DIFFUSE = {"type": "diffuse", "reflectance": rgb(*COLOR)}
PRINCIPLED = {"type": "principled", "base_color": rgb(*COLOR), "roughness": 0.3, "specular": 0.5}
DUST = {"type": "motes_dusty", "w": rgb(*WHITE), "g": 0.3, "tau": 0.2}
SURFACES: dict[str, Description] = {
    "principled": PRINCIPLED,
    "motes_dusty (equations 1-13)": DUST | {"K_d": rgb(*COLOR), "sigma_d": 0.4, "sigma_s": 0.15},
    "motes_dusty over diffuse": DUST | {"base": DIFFUSE},
    "motes_dusty over principled": DUST | {"base": PRINCIPLED},
    "motes_oren_nayar": {"type": "motes_oren_nayar", "K_d": rgb(*COLOR), "sigma_d": 0.4},
    "motes_torrance_sparrow": {"type": "motes_torrance_sparrow", "K_s": 0.3, "sigma_s": 0.15},
    "diffuse": DIFFUSE,
    "roughplastic": {"type": "roughplastic"},
}
FURNACE: dict[str, tuple[Description, BRDF]] = {
    "Oren-Nayar, K_d = 1, sigma_d = 0.4": (
        {"type": "motes_oren_nayar", "K_d": 1.0, "sigma_d": 0.4},
        OrenNayar(1.0, 0.4),
    ),
    "Torrance-Sparrow, glass, facets, sigma_s = 0.15": (
        {"type": "motes_torrance_sparrow", "K_s": 1.0, "fresnel": "dielectric", "normalization": "facets"},
        TorranceSparrow(1.0, normalization="facets", fresnel=Dielectric()),
    ),
    "dust, w = 1, g = 0, tau = 0.2 over white": (
        {"type": "motes_dusty", "base": {"type": "diffuse", "reflectance": rgb(1, 1, 1)}, "w": 1.0},
        DustLayer(Lambert(1.0), Dust(w=1.0), 0.2),
    ),
    "dust, w = 1, g = 0.6, tau = 1 over black": (
        {
            "type": "motes_dusty",
            "base": {"type": "diffuse", "reflectance": rgb(0, 0, 0)},
            "w": 1.0,
            "g": 0.6,
            "tau": 1.0,
        },
        DustLayer(Lambert(0.0), Dust(w=1.0, g=0.6), 1.0),
    ),
}


def sphere(bsdf: Description, size: int = SIZE, integrator: Description | None = None, lamp: bool = True) -> Any:
    """A sphere that fills the picture, under a white sky and a lamp, by path tracing."""
    mi = load_mitsuba()
    view = mi.ScalarTransform4f().look_at(origin=[0, 0, 5], target=[0, 0, 0], up=[0, 1, 0])
    film = {"type": "hdrfilm", "width": size, "height": size, "pixel_format": "rgb"}
    light = {
        "type": "sphere",
        "center": [3, 3, 3],
        "radius": 0.3,
        "emitter": {"type": "area", "radiance": rgb(20, 20, 20)},
    }
    return load_scene(
        {
            "type": "scene",
            "integrator": integrator or {"type": "path", "max_depth": 6},
            "sensor": {"type": "perspective", "fov": 24, "to_world": view, "film": film},
            "sky": {"type": "constant"},
            **({"lamp": light} if lamp else {}),
            "object": {"type": "sphere", "bsdf": bsdf},
        }
    )


def processor_time() -> float:
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def rendered(scene: Any, seed: int, spp: int = SPP) -> tuple[float, float]:
    """Seconds on the clock and of the processor for one picture."""
    import drjit as dr

    mi = load_mitsuba()
    wall, used = time.perf_counter(), processor_time()
    dr.eval(mi.render(scene, spp=spp, seed=seed))
    dr.sync_thread()
    return time.perf_counter() - wall, processor_time() - used


def speed(rounds: int) -> dict[str, tuple[float, float, float]]:
    """By surface: median seconds, and the quotients to principled by the clock and by processor time."""
    scenes = {name: sphere(bsdf) for name, bsdf in SURFACES.items()}
    for scene in scenes.values():  # compiles
        rendered(scene, 0)
    times = np.array([[rendered(scene, k) for scene in scenes.values()] for k in range(1, rounds + 1)])
    ratios = np.median(times / times[:, :1], axis=0)
    medians = np.median(times[:, :, 0], axis=0)
    return {name: (float(medians[k]), *map(float, ratios[k])) for k, name in enumerate(scenes)}


def print_speed(rounds: int) -> None:
    print(f"\n{SIZE} x {SIZE} pixels, {SPP} samples each, {load_mitsuba().variant()}, medians of {rounds} rounds\n")
    print("| surface | seconds | x principled | x principled, processor time |\n|---|---|---|---|")
    for name, (seconds, wall, used) in speed(rounds).items():
        print(f"| {name} | {seconds:.3f} | {wall:.2f} | {used:.2f} |")


COMPILE = """
import json, sys
sys.path.insert(0, {here!r})
from render import SURFACES, sphere, rendered
from motes.rendering import load_mitsuba
load_mitsuba()
import drjit as dr
scene = sphere(SURFACES[{name!r}])
with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
    first, _ = rendered(scene, 0)
    history = dr.kernel_history()
again, _ = rendered(scene, 1)
times = [(k["codegen_time"], k["backend_time"]) for k in history if k.get("uses_optix") is not None]
print(json.dumps([first, again, sum(t[0] for t in times) / 1e3, sum(t[1] for t in times) / 1e3]))
"""


def print_compile(names: tuple[str, ...]) -> None:
    """In a process of its own each, with an empty cache of kernels."""
    here = str(Path(__file__).resolve().parent)
    print("\n| first rendering of | seconds | of which LLVM | later | \n|---|---|---|---|")
    for name in names:
        with tempfile.TemporaryDirectory() as home:
            script = COMPILE.format(here=here, name=name)
            out = subprocess.check_output([sys.executable, "-c", script], env=os.environ | {"HOME": home}, text=True)
        first, again, _, backend = json.loads(out.splitlines()[-1])
        print(f"| {name} | {first:.2f} | {backend:.2f} | {again:.2f} |")


def print_scalar() -> None:
    """The scalar variant beside the compiled one, for as many samples."""
    name = "motes_dusty (equations 1-13)"
    per_sample = {}
    for variant, size, spp in (("llvm_ad_rgb", SIZE, SPP), ("scalar_rgb", 32, 4)):
        load_mitsuba(variant)
        for bsdf in (name, "principled"):
            scene = sphere(SURFACES[bsdf], size)
            rendered(scene, 0, spp)
            best = min(rendered(scene, k, spp)[0] for k in range(1, 6))
            per_sample[variant, bsdf] = best / (size * size * spp)
    load_mitsuba("llvm_ad_rgb")
    print("\n| nanoseconds a sample | scalar_rgb | llvm_ad_rgb | quotient |\n|---|---|---|---|")
    for bsdf in (name, "principled"):
        slow, fast = per_sample["scalar_rgb", bsdf], per_sample["llvm_ad_rgb", bsdf]
        print(f"| {bsdf} | {1e9 * slow:.0f} | {1e9 * fast:.0f} | {slow / fast:.0f} |")


def print_variance() -> None:
    """Under a white sky without light sampling: the variance of a pixel, by cosine sampling and by the plugin's own."""
    sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))
    from plugin_support import cosine_only

    mi = load_mitsuba()
    direct = {"type": "direct", "emitter_samples": 0, "bsdf_samples": 1, "hide_emitters": True}

    def variance(bsdf: Description) -> float:
        scene = sphere(bsdf, 32, direct, lamp=False)
        return float(np.stack([np.array(mi.render(scene, spp=256, seed=k)) for k in range(24)]).var(0).mean())

    print("\n| surface | variance by cosine sampling / by its own |\n|---|---|")
    for name, bsdf in SURFACES.items():
        if name.startswith("motes"):
            print(f"| {name} | {variance(cosine_only(bsdf)) / variance(bsdf):.1f} |")
    narrow = {"type": "motes_torrance_sparrow", "K_s": 1.0, "sigma_s": 0.05}
    print(f"| motes_torrance_sparrow, sigma_s = 0.05 | {variance(cosine_only(narrow)) / variance(narrow):.0f} |")


def albedo(description: Description, theta: float, n: int = 4_000_000) -> tuple[float, float]:
    """The mean weight of samples for a viewer at this polar angle, and its standard error."""
    import drjit as dr

    mi = load_mitsuba()
    rng = np.random.default_rng(5)
    u: NDArray[np.float32] = rng.random((3, n), np.float32)
    si = dr.zeros(mi.SurfaceInteraction3f, n)
    si.wi = mi.Vector3f(float(np.sin(theta)), 0.0, float(np.cos(theta)))
    bsdf = load_scene(description)
    weight = np.array(bsdf.sample(mi.BSDFContext(), si, mi.Float(u[0]), mi.Point2f(u[1:]))[1], np.float64)[0]
    return float(weight.mean()), float(weight.std() / np.sqrt(n))


def print_furnace() -> None:
    """Directional albedos by the plugins' sampling (float32) and by quadrature of the models (float64)."""
    angles = (0.0, 30.0, 60.0, 80.0)
    print(f"\n| directional albedo at | {' | '.join(f'{a:g} deg' for a in angles)} |\n|---|{'---|' * len(angles)}")
    for name, (description, model) in FURNACE.items():
        cells = []
        for degrees in angles:
            theta = np.deg2rad(degrees)
            expected = float(model.directional_albedo(np.array([np.sin(theta), 0, np.cos(theta)]), nodes=(400, 64))[0])
            mean, error = albedo(description, float(theta))
            cells.append(f"{mean:.5f} ({expected:.5f}, s.e. {error:.5f})")
        print(f"| {name} | {' | '.join(cells)} |")


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--rounds", type=int, default=15)
    sections: dict[str, Callable[[argparse.Namespace], None]] = {
        "speed": lambda o: print_speed(o.rounds),
        "compile": lambda o: print_compile(
            ("motes_dusty (equations 1-13)", "motes_dusty over principled", "principled")
        ),
        "scalar": lambda o: print_scalar(),
        "variance": lambda o: print_variance(),
        "furnace": lambda o: print_furnace(),
    }
    parser.add_argument("--only", nargs="*", choices=list(sections), default=list(sections))
    options = parser.parse_args()
    load_mitsuba("llvm_ad_rgb")
    for name in options.only:
        sections[name](options)


if __name__ == "__main__":
    main()
