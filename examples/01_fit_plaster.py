"""Measure a drying plaster with the simulated rig, fit one scan, save the material and write a report.

Run it with a folder to write to: python examples/01_fit_plaster.py out/plaster
"""

import sys
import tempfile
from pathlib import Path

import numpy as np

import motes
from motes.ageing import drying_plaster, simulate

out = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(tempfile.mkdtemp(prefix="motes-"))

simulate(out / "scans", drying_plaster, scans=4, hours=3, seed=1)
data = motes.read(out / "scans")
fit = motes.fit(data, model="dust_layer(oren_nayar + torrance_sparrow)", time=2)

hours = float(data.times[2])
for name, true in drying_plaster(hours).parameters.items():
    found = fit.parameters[name]
    print(f"{name:8} true {np.round(true, 4)}  fitted {np.round(found.value, 4)} +- {np.round(found.stderr, 4)}")
print(f"relative RMS {100 * fit.metrics['relative_rms']:.1f} %, {fit.status}")
print("material:", fit.material.save(out / "plaster.json"))
print("report:", fit.report(out / "report.html"))
