"""Dust that gathers on mirrors over days: tau from falling specular reflectance, with bands, growth rates and resets.

Needs the package mirror-soiling-data: pip install 'motes[soiling]'. Run it with a folder to write a picture and a table to:
python examples/05_mirror_soiling.py out
"""

import sys
from pathlib import Path

import numpy as np

from motes import MotesError
from motes.soiling import cleanings, fit_soiling, growth, read_soiling

out = Path(sys.argv[1]) if len(sys.argv) > 1 else None
try:
    series = read_soiling()
except MotesError as error:
    print(error)
    sys.exit()

fits = [fit_soiling(one) for one in series]
sites = dict.fromkeys(one.site for one in series)
print(f"{len(series)} series of {sum(len(one.days) for one in series)} readings at {len(sites)} sites")

lines = ["| site | tilt | series | growth of tau, 0.001/day | resets |", "|---|---|---|---|---|"]
for row in growth(fits):
    rate = f"{1000 * row.rate:.2f} ± {1000 * row.stderr:.2f}"
    lines.append(f"| {row.site.replace('_', ' ')} | {row.tilt_deg:g}° | {row.mirrors} | {rate} | {row.resets} |")
print("\n".join(lines))

resets = [(fit.series, reset) for fit in fits for reset in fit.resets]
gauged = [reset for one, reset in resets if one.rained is not None]
wet = sum(int(fit.series.rained.sum()) for fit in fits if fit.series.rained is not None)
print(
    f"{len(resets)} resets within campaigns; where rain was gauged {len(gauged)}, of which {sum(bool(r.rained) for r in gauged)} with rain; {wet} rainy gaps"
)
for one, reset in resets:
    print(
        f"  {one.site} {one.campaign} {one.mirror}: tau -{reset.gain:.4f} ± {reset.stderr:.4f} at day {reset.days:.1f}, rain: {reset.rained}"
    )
print(f"{len(cleanings(series))} mirrors came back cleaner from one campaign to the next")

if out is not None:
    from matplotlib.figure import Figure

    out.mkdir(parents=True, exist_ok=True)
    (out / "soiling.md").write_text("\n".join(lines) + "\n", encoding="utf-8")
    shown = (
        ("wodonga", "2022-02-20"),
        ("wodonga", "2022-04-21"),
        ("port_augusta", "2023-08-26"),
        ("qut", "2017-09-05"),
    )
    figure = Figure(figsize=(11, 7.2), dpi=90, layout="constrained")
    for axes, (site, campaign) in zip(figure.subplots(2, 2).flat, shown, strict=True):
        chosen = [fit for fit in fits if (fit.series.site, fit.series.campaign) == (site, campaign)]
        for k, fit in enumerate(chosen):
            one, color = fit.series, f"C{k}"
            days = np.linspace(0, one.days[-1] * 1.15, 300)
            tau, error = fit.tau(days)
            read = np.log(fit.clean_reflectance / one.reflectance) / fit.slant
            axes.errorbar(
                one.days,
                read,
                one.stderr / one.reflectance / fit.slant,
                fmt="o",
                ms=3,
                color=color,
                label=f"{one.tilt_deg:g}°",
            )
            axes.plot(days, tau, color=color, lw=1)
            axes.fill_between(days, tau - error, tau + error, color=color, alpha=0.15, lw=0)
        rained = chosen[0].series.rained
        for k in np.flatnonzero(rained) if rained is not None else ():
            axes.axvspan(
                *chosen[0].series.days[k : k + 2],
                color="0.85",
                zorder=0,
                label="rain" if k == np.flatnonzero(rained)[0] else None,
            )
        for day in {reset.days for fit in chosen for reset in fit.resets}:
            axes.axvline(day, color="0.4", lw=0.8, ls=":")
        axes.set_title(f"{site.replace('_', ' ')}, from {campaign}")
        axes.set_xlabel("days")
        axes.set_ylabel(r"$\tau$ since the first reading")
        axes.legend(title="tilt", fontsize=8, loc="upper left")
    figure.savefig(out / "soiling.png", metadata={"Software": None})
    print("picture:", out / "soiling.png")
