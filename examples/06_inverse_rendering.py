"""A dusty sphere's picture is all that is given; how thick is the dust, and how strong and wide the highlight under it?

The parameters are found by least squares, with derivatives from Mitsuba's differentiable renderer, for the plugin's equations are
those of Motes, traced by Dr.Jit.  Run it with a folder to write the pictures to: python examples/06_inverse_rendering.py out
"""

import sys
import time
from importlib.util import find_spec
from pathlib import Path

import numpy as np

if find_spec("mitsuba") is None:
    print("Mitsuba is not installed: pip install 'motes[render]'")
    sys.exit()

from motes.rendering import load_mitsuba, load_scene, slow_note

if slow_note() is not None:  # derivatives need a compiled variant
    print(slow_note())
    sys.exit()
mi = load_mitsuba("llvm_ad_rgb")
import drjit as dr  # noqa: E402

TRUTH = {"tau": 0.15, "sigma_s": 0.2, "K_s": 0.5}
START = {"tau": 0.5, "sigma_s": 0.45, "K_s": 0.15}
SIZE, STEPS = 64, 8


def rgb(*color: float) -> dict[str, object]:
    return {"type": "rgb", "value": list(color)}


scene = load_scene(
    {
        "type": "scene",
        "integrator": {"type": "prb", "max_depth": 2},
        "sensor": {
            "type": "perspective",
            "fov": 24,
            "to_world": mi.ScalarTransform4f().look_at(origin=[0, 0, 5], target=[0, 0, 0], up=[0, 1, 0]),
            "film": {"type": "hdrfilm", "width": SIZE, "height": SIZE, "pixel_format": "rgb"},
        },
        "sky": {"type": "constant", "radiance": rgb(0.5, 0.5, 0.5)},
        "lamp": {"type": "point", "position": [3, 4, 5], "intensity": rgb(90, 90, 90)},
        "sphere": {
            "type": "sphere",
            "bsdf": {"type": "motes_dusty", "K_d": rgb(0.1, 0.2, 0.5), "w": rgb(0.9, 0.8, 0.65), "g": 0.2, **TRUTH},
        },
    }
)
parameters = mi.traverse(scene)
keys = {name: f"sphere.bsdf.{name}.value" for name in TRUTH}
given = np.array(mi.render(scene, spp=512, seed=1000)).ravel()


def render_with_slopes(values: dict[str, float], seed: int) -> tuple[np.ndarray, np.ndarray]:
    """The picture (pixels,) and its derivatives by the logarithms of the parameters (pixels, 3)."""
    slopes = []
    for name, key in keys.items():
        for other, value in values.items():
            parameters[keys[other]] = mi.Float(value)
        dr.enable_grad(parameters[key])
        parameters.update()
        rendered = mi.render(scene, parameters, spp=16, seed=seed)
        dr.forward(parameters[key])
        slopes.append(np.array(dr.grad(rendered)).ravel() * values[name])
    return np.array(mi.render(scene, spp=128, seed=seed)).ravel(), np.stack(slopes, -1)


# Gauss-Newton with damping, on the logarithms of the parameters: they stay positive, and steps are relative.
values = dict(START)
began = time.perf_counter()
print(f"{'step':>4}  {'difference':>10}  " + "  ".join(f"{name:>8}" for name in keys))
for step in range(STEPS + 1):
    now, slopes = render_with_slopes(values, step)
    residual = given - now
    numbers = "  ".join(f"{value:8.4f}" for value in values.values())
    print(f"{step:4}  {np.sqrt(np.mean(residual**2)):10.5f}  {numbers}")
    if step < STEPS:
        normal = slopes.T @ slopes
        change = np.linalg.solve(normal + 1e-3 * np.diag(np.diag(normal)), slopes.T @ residual)
        change = np.clip(change, -0.7, 0.7)  # the first steps would overshoot
        values = {name: value * float(np.exp(d)) for (name, value), d in zip(values.items(), change, strict=True)}
print("true              " + "  ".join(f"{value:8.4f}" for value in TRUTH.values()))
worst = max(abs(values[name] / TRUTH[name] - 1) for name in keys)
print(f"{STEPS} steps, {SIZE} x {SIZE} pixels, {time.perf_counter() - began:.1f} s; off by {100 * worst:.1f} % at most")

if len(sys.argv) > 1:
    out = Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    row = []
    for shown in (START, values, TRUTH):
        for name, value in shown.items():
            parameters[keys[name]] = mi.Float(value)
        parameters.update()
        row.append(np.array(mi.render(scene, spp=128, seed=77)))
    mi.util.write_bitmap(str(out / "inverse.png"), mi.TensorXf(np.concatenate(row, axis=1)))
    print("start, found, given:", out / "inverse.png")
