"""Maps as the commands print them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from motes.maps import FittedMap

Row = tuple[str, str]


def stack_rows(s: dict[str, Any]) -> list[Row]:
    """What a measured map holds, from its summary."""
    times = s["times"]
    span = f", {times[0]:.4g} to {times[-1]:.4g} h" if len(times) > 1 else ""
    n = len(times)
    rows = [
        ("kind", s["kind"]),
        ("name", s["name"]),
        ("source", s["source"]),
        ("size", f"{s['shape'][1]} x {s['shape'][0]} texels, {s['bytes'] / 2**20:,.1f} MiB of {s['dtype']}"),
        ("times", f"{n} time{'' if n == 1 else 's'}{span}"),
        ("directions", f"{s['n_directions']}, one light and one viewer each for all texels"),
        ("channels", ", ".join(s["channels"][:8]) + (", .." if len(s["channels"]) > 8 else "")),
        *((k, f"{s[f'{k}_deg'][0]:.1f} to {s[f'{k}_deg'][1]:.1f} degrees") for k in ("theta_i", "theta_r")),
        ("chunks", f"{' x '.join(map(str, s['chunks']))}; {s['blocks'][0]} x {s['blocks'][1]} blocks"),
        ("truth", ", ".join(s["truth"])),
        ("notes", "\n".join(s["notes"])),
    ]
    return [(label, text) for label, text in rows if text]


def show_fitted(
    fitted: FittedMap, s: dict[str, Any], errors: dict[str, dict[str, float | None]], written: list[Row]
) -> None:
    """Print a fitted map: its summary `s`, quartiles, how far each parameter is from the truth where that is known, what was written."""
    from rich import box

    from motes.cli import console
    from motes.maps.comparison import quartiles
    from motes.measurements.origin import not_measured

    fits = {name: n for name, n in s["fits"].items() if n}
    verdicts = s["verdicts"]
    how = (
        f"{s['n_times']} times together, {', '.join(f'{q} {k}' for q, k in s['trends'].items())}"
        if s["trends"]
        else (f"{s['n_times']} times, each alone" if s["n_times"] > 1 else "one time")
    )
    rows = [
        ("map", f"{s['name']}: {s['shape'][1]} x {s['shape'][0]} texels, {how}"),
        *([("source", said)] if (said := not_measured({"source": s["origin"]})) else []),
        ("model", s["model"] + (f"  (the best of {len(s['tried'])} by BIC, on some texels)" if s["tried"] else "")),
        *([("time", f"{s['time']} alone, at {s['times'][0]:.4g} h")] if s["time"] is not None else []),
        *([("held", ", ".join(f"{k} = {v}" for k, v in s["fixed"].items()))] if s["fixed"] else []),
    ]
    console.print_facts(rows)
    print()
    table = console.Table(box=box.SIMPLE_HEAD, pad_edge=False)
    heads = (
        "map",
        "lower quarter",
        "median",
        "upper quarter",
        "standard error",
        *(("determined",) if verdicts else ()),
    )
    for k, head in enumerate((*heads, *(("error", "within 2 s.e.") if errors else ()))):
        table.add_column(head, justify="left" if k == 0 else "right")
    for name, (low, middle, high, stderr) in quartiles(fitted).items():
        e = errors.get(name)
        extra = ("", "")
        if e:
            inside = e["within_2_stderr"]
            extra = (f"{e['median_error']:.2g}", "" if inside is None else f"{100 * inside:.1f} %")
        table.add_row(
            console.clean(name),
            f"{low:.4g}",
            f"{middle:.4g}",
            f"{high:.4g}",
            f"{stderr:.2g}",
            *([share_of(verdicts[name], "identified")] if verdicts else []),
            *(extra if errors else ()),
        )
    console.print_table(table)
    print()
    counted = ", ".join(f"{n} {name.replace('_', ' ')}" for name, n in fits.items())
    loss = s["loss"] + ("" if s["robust"] == "none" else f", {s['robust']}")
    rows = [*tried_rows(s["tried"]), *verdict_rows(verdicts), ("loss", loss)]
    rows += [("fits", counted), ("blocks", f"{s['blocks_done']} of {s['blocks']} done"), *written]
    if errors:
        rows.insert(0, ("truth", "known: the error is the median distance from it"))
    console.print_facts(rows)


def share_of(counts: dict[str, int], *words: str) -> str:
    """The share of fitted values that have one of some verdicts."""
    total = sum(n for word, n in counts.items() if word != "not_fitted")
    share = sum(counts[word] for word in words) / total if total else 0.0
    # Never "100 %" or "0 %" of what is not all or nothing.
    return f"{100 * share:.0f} %" if share in (0, 1) else f"{100 * min(max(share, 5e-4), 0.9995):.1f} %"


def verdict_rows(verdicts: dict[str, dict[str, int]]) -> list[Row]:
    """A line for each verdict other than "identified", with the share of the values of each parameter that have it."""
    from motes.fitting.covariance import VERDICTS

    rows = []
    for verdict in VERDICTS:
        word = verdict.name.lower()
        if word == "identified":
            continue
        found = [(name, share_of(counts, word)) for name, counts in verdicts.items() if counts.get(word)]
        if found:
            rows.append(
                ("note", f"{', '.join(f'{name} in {share}' for name, share in found)} of its values: {verdict}")
            )
    return rows


def tried_rows(tried: list[dict[str, Any]]) -> list[Row]:
    """The models that were compared, with their distance from the data."""
    if not tried:
        return []
    best = min(t["bic"] for t in tried)
    lines = []
    for t in tried:
        rms = "" if t["relative_rms"] is None else f", relative RMS {100 * t['relative_rms']:.2f} %"
        standing = "chosen" if t["chosen"] else f"BIC {t['bic'] - best:+,.0f}"
        lines.append(f"{t['model']}: {standing}{rms}")
    return [("tried", "\n".join(lines))]
