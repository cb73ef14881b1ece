"""Whether every export of a material says what the material says: printed, run or read back here, and compared with NumPy in float64."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from motes.certification.certificate import Check, Finding
from motes.certification.check_conventions import check_conventions
from motes.certification.check_precision import places
from motes.certification.export_runs import RUNNERS, Run, Runner
from motes.certification.hemisphere import upper
from motes.certification.specimen import Floats, Specimen
from motes.certification.wording import degrees, plain, share, typical
from motes.errors import FormatError, MotesError
from motes.exports.subject import Subject, subject

BELOW = 300
#: What of the median value a difference is at least relative to: where the material is nearly black, digits are lost that nobody sees.
FLOOR = 0.05
UNKNOWN = "No rival convention explains it: a defect of the export, or of what runs it here; report it with this page."
LEFT_OUT = "Not judged: left out, since to print and run each takes some ten to thirty seconds; --exports (exports=True) asks for it."


def check_exports(specimen: Specimen, wanted: bool = True) -> Check:
    """All targets of `motes.exports`; one that cannot be run here is named, with the reason."""
    if specimen.material is None:
        return Check("exports", "Not judged: materials of Motes alone are exported.", judged=False)
    if not wanted:
        return Check("exports", LEFT_OUT, judged=False)
    what = subject(specimen.material, specimen.moment)
    rows: list[dict[str, Any]] = []
    findings = []
    for to, runners in RUNNERS.items():
        for runner in runners:
            with tempfile.TemporaryDirectory(prefix="motes-export-") as folder:
                row, finding = _tried(to, runner, what, Path(folder), specimen)
            rows.append(row)
            findings += [] if finding is None else [finding]
    return Check("exports", _said(rows), tuple(findings), {"targets": rows}, judged=any(r["outcome"] != "not run" for r in rows))  # fmt: skip


def _tried(
    to: str, runner: Runner, what: Subject, folder: Path, specimen: Specimen
) -> tuple[dict[str, Any], Finding | None]:
    """A target's row, and its fault: what compiles or reads badly is one, what cannot be run here is none."""
    try:
        return _judged(to, runner(what, folder), specimen)
    except FormatError as error:
        why = error.message
    except MotesError as error:
        return {"target": to, "outcome": "not run", "how": error.message}, None
    except Exception as error:  # of drivers and compilers, each of its own class
        lines = [line.strip() for line in str(error).splitlines() if line.strip()] or [type(error).__name__]
        why = next((line for line in lines if "error" in line.lower()), lines[0])[:300]
    row = {"target": to, "outcome": "differs", "how": why} | dict.fromkeys(("largest", "median", "at"))
    return row | {"judged_by": "", "tolerance": 0.0}, Finding(
        f"export-{to}", f"What was written for {to} cannot be used: {why}", UNKNOWN
    )


def _pairs() -> tuple[Floats, Floats]:
    """Where float32 is asked, and below the horizon; in float32, so that all targets get the same directions."""
    below = upper(BELOW, 23) * np.where(np.arange(BELOW)[:, None] % 3 == 0, -1.0, 1.0)
    under = upper(BELOW, 24) * np.where(np.arange(BELOW)[:, None] % 3 != 0, -1.0, 1.0)
    wi, wo = (np.concatenate(parts) for parts in zip(*places().values(), (below, under), strict=True))
    return wi.astype(np.float32).astype(np.float64), wo.astype(np.float32).astype(np.float64)


def _judged(to: str, run: Run, specimen: Specimen) -> tuple[dict[str, Any], Finding | None]:
    """A target's row of numbers, and its fault."""
    wi, wo = _pairs() if run.pairs is None else run.pairs
    expected = specimen.eval(wi, wo)
    if run.matrix is not None:
        expected = np.maximum(expected @ run.matrix, 0.0)
    found = run.values(wi, wo)
    found, expected = np.broadcast_arrays(found, expected)
    with np.errstate(all="ignore"):
        error = np.abs(found - expected) / np.maximum(np.abs(expected), FLOOR * typical(expected) + 1e-30)
    error = np.where(np.isfinite(found), error, np.inf).max(axis=1)
    worst = int(np.argmax(error))
    judged = float(np.median(error)) if run.typical else float(error[worst])
    good = judged <= run.tolerance
    row = {
        "target": to,
        "outcome": "agrees" if good else "differs",
        "how": run.how,
        "largest": plain(float(error[worst]), 3),
        "median": plain(float(np.median(error)), 3),
        "judged_by": "median" if run.typical else "largest",
        "tolerance": run.tolerance,
        "at": degrees(wi[worst], wo[worst]),
    }
    if good:
        return row, None
    by = "in the median" if run.typical else f"at {degrees(wi[worst], wo[worst])}"
    size = share(judged) if np.isfinite(judged) else "all of its value"
    says = f"What {to} answers ({run.how}) is off by {size} {by}"
    return row, Finding(f"export-{to}", says, _cause(to, run, specimen))


def _cause(to: str, run: Run, specimen: Specimen) -> str:
    """Which rival convention the target follows, where one explains it."""
    if run.matrix is not None:
        return f"Its channels are X, Y and Z, for which rivals are not tried. {UNKNOWN}"
    as_one = replace(
        specimen, name=to, kind="export", eval=run.values, pairs=run.pairs, single=run.tolerance > 1e-6, model=None
    )
    with np.errstate(all="ignore"):
        check = check_conventions(as_one, specimen)
    known = [f.probably for f in check.findings if f.name != "differs"]
    return " ".join(known) or UNKNOWN


def _said(rows: list[dict[str, Any]]) -> str:
    agree = [r for r in rows if r["outcome"] == "agrees"]
    differ = [r for r in rows if r["outcome"] == "differs"]
    parts = [f"{_listed(agree)} agree" if agree else "No target was run"]
    if agree:
        worst = max((r for r in agree if r["judged_by"] == "largest"), key=lambda r: _size(r), default=agree[0])
        parts[0] += (
            f", the worst of those that are exact, {worst['target']}, within {worst['largest']:.1g} of the value at {worst['at']}"
        )
    if differ:
        parts.append(f"{_listed(differ)} differ")
    left = [r for r in rows if r["outcome"] == "not run"]
    fitted = [r["target"] for r in left if "fitted" in r["how"]]
    parts += [f"{r['target']} was not run: {r['how']}" for r in left if r["target"] not in fitted]
    if fitted:
        parts.append(f"{', '.join(fitted)} have parameters of their own, which motes export fits")
    return "; ".join(parts) + "."


def _size(row: Mapping[str, Any]) -> float:
    return float(row["largest"] or 0.0) / float(row["tolerance"])


def _listed(rows: list[dict[str, Any]]) -> str:
    return ", ".join(dict.fromkeys(str(r["target"]) for r in rows))
