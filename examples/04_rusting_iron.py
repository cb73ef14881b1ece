"""Iron that rusts: the STAF maps (cubic polynomials of time in each texel) as time-varying materials. Nothing is fitted.

Run it with the folder that holds Diffuse-0.exr, ... Roughness-3.exr, and a folder to write to:
python examples/04_rusting_iron.py path/to/staf-tvBTF45 out
"""

import sys
from pathlib import Path

import numpy as np

import motes
from motes.ageing import rusting_material
from motes.ageing.rust import masked

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "staf-tvBTF45")
out = Path(sys.argv[2]) if len(sys.argv) > 2 else None
if not (folder / "Roughness-0.exr").is_file():
    print(f"no STAF maps at {folder}: give the folder that holds Roughness-0.exr")
    sys.exit()

TIMES = (0.0, 0.2, 0.4, 0.6, 0.8, 1.0)
maps = motes.read(folder)
mean = rusting_material(maps)
print("means of the maps' polynomials\n   t  Roughness [rad]  Specular  Diffuse")
for t in TIMES:
    print(f"{t:4.1f}  " + "  ".join(f"{maps.mean(t)[name]:.3f}" for name in ("Roughness", "Specular", "Diffuse")))
seen = masked(maps)
print(
    f"texels with Roughness <= 0 at these times: {seen.counts}; {np.count_nonzero(~seen.valid)} of {seen.valid.size} masked"
)
row, column = np.argwhere(seen.valid)[len(np.argwhere(seen.valid)) // 2]
texel = rusting_material(maps, (int(row), int(column)))
print(
    f"a texel at t = 0.5: K_s = {texel.at(0.5).parameters['K_s']:.3f}, sigma_s = {texel.at(0.5).parameters['sigma_s']:.3f} rad"
)

if out is not None:
    from matplotlib.figure import Figure

    from motes.drawing.colour import srgb_encode
    from motes.drawing.sphere import render_sphere

    out.mkdir(parents=True, exist_ok=True)
    print("material:", mean.save(out / "rusting.json"))
    figure = Figure(figsize=(2 * len(TIMES) + 0.9, 8.9), dpi=64)
    grid = figure.subplots(4, len(TIMES))
    # A plate of 2 x 2 seen from above, a lamp at the upper left, one unit away and one high: the highlight lies between.
    y, x = np.meshgrid(*[np.linspace(-1, 1, 230)] * 2, indexing="ij")
    lamp, eye = np.array([-1.0, 1.0, 1.0]), np.array([0.0, 0.0, 3.0])
    points = np.stack([x, -y, 0 * x], -1)
    wi, wo = ((v := w - points) / np.linalg.norm(v, axis=-1, keepdims=True) for w in (lamp, eye))
    rows = ("diffuse\ncolour", "$\\sigma_s$ [rad]", "under\na lamp", "mean\nmaterial")
    for k, t in enumerate(TIMES):
        now = {name: value[::2, ::2] for name, value in maps.at(t).items()}
        valid = now["sigma_s"] > 0.001  # rad; the others have no highlight
        sigma_s = np.where(valid, now["sigma_s"], 0.1)
        K_s = np.where(valid, now["K_s"], 0.0)[..., None]
        plate = motes.Lambert(K_d=now["K_d"]) + motes.TorranceSparrow(K_s=K_s, sigma_s=sigma_s)
        lit = np.pi * plate.eval(wi, wo) * wi[..., 2:]
        grid[0, k].imshow(srgb_encode(2.5 * now["K_d"]))
        picture = grid[1, k].imshow(np.where(valid, now["sigma_s"], np.nan), vmin=0, vmax=0.4, cmap="magma")
        grid[2, k].imshow(srgb_encode(3 * lit))
        grid[3, k].imshow(render_sphere(mean.at(t), 230, exposure=2))
        grid[0, k].set_title(f"t = {t:g}")
    for axes, label in zip(grid[:, 0], rows, strict=True):
        axes.set_ylabel(label)
    for axes in grid.flat:
        axes.set_xticks([])
        axes.set_yticks([])
        for side in axes.spines.values():
            side.set_visible(False)
    figure.subplots_adjust(left=0.06, right=0.93, top=0.96, bottom=0.01, wspace=0.03, hspace=0.03)
    top, bottom = grid[1, -1].get_position().y1, grid[1, -1].get_position().y0
    figure.colorbar(picture, cax=figure.add_axes((0.94, bottom, 0.012, top - bottom)))
    figure.savefig(out / "rusting.png", metadata={"Software": None})
    print("picture:", out / "rusting.png")
