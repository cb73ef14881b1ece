"""A reflectance map: simulate one, fit every texel, look at the errors, take a material out.

python examples/07_reflectance_map.py [OUT]
"""

import sys
import tempfile
from pathlib import Path

try:
    import zarr  # noqa: F401
except ImportError:
    print("this example needs zarr: pip install 'motes[scale]'")
    sys.exit()

from motes import maps
from motes.maps.comparison import compare

with tempfile.TemporaryDirectory() as temporary:
    out = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(temporary)

    # Stripes of paint that dry from the left, 48 x 48 texels at four times, 28 directions, 1 % noise.
    stack = maps.simulate_map(out / "paint.zarr", (48, 48), times=4, lights=14)
    print(f"{stack.shape[1]} x {stack.shape[0]} texels, {stack.sizes[0]} times, {stack.sizes[1]} directions")

    # Every texel and time is a fit of its own; run it again after an interrupt and it goes on.
    fitted = maps.fit_map(stack, "oren_nayar + torrance_sparrow", out=out / "fitted.zarr")
    print("fits:", {name: n for name, n in fitted.counts().items() if n})

    print("\nparameter   median   median error   within 2 standard errors")
    for name, e in compare(fitted, stack).items():
        print(f"{name:<10}{e['median_truth']:8.3f}{e['median_error']:15.4f}{100 * e['within_2_stderr']:21.1f} %")

    material = fitted.material(24, 24)
    print(f"\na texel in the middle: {material.name}")
    for hours in stack.hours:
        values = material.at(hours).parameters
        print(f"  {hours:.0f} h: K_s = {values['K_s']:.3f}, sigma_s = {values['sigma_s']:.3f} rad")
    print("\nto look at:", fitted.report(out / "paint.html"))
