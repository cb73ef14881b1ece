"""Fit real measurements: a sample of the CUReT database, with and without a highlight.

CUReT (Dana, van Ginneken, Nayar, Koenderink 1999) is not part of Motes; give the folder with abrdf.dat and table.txt:
python examples/03_fit_curet.py path/to/curet [sample]
"""

import sys
from pathlib import Path

import motes

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "curet")
sample = sys.argv[2] if len(sys.argv) > 2 else "10"
if not (folder / "abrdf.dat").is_file():
    print(f"no CUReT data at {folder}: give the folder that holds abrdf.dat")
    sys.exit()

data = motes.read(folder, sample=sample)
for model in ("oren_nayar", "oren_nayar + torrance_sparrow"):
    fit = motes.fit(data, model=model, loss="plain")
    values = ", ".join(f"{row['name']} = {row['value']} +- {row['stderr'] or '?'}" for row in fit.table())
    print(f"{data.name}, {model}: {values}; relative RMS {100 * fit.metrics['relative_rms']:.1f} %")
