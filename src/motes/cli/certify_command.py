"""``motes certify``: one page that proves a material, or finds its fault."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from motes.cli.options import Common


def certify(
    subject: str,
    /,
    *,
    as_model: Annotated[str | None, Parameter(name="--as")] = None,
    against: str | None = None,
    cosine: Annotated[bool, Parameter(negative="")] = False,
    set: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    hours: float | None = None,
    exports: Annotated[bool, Parameter(negative="")] = False,
    date: str | None = None,
    output: Annotated[str | None, Parameter(name=["--output", "-o"])] = None,
    common: Common = Common(),  # noqa: B008 (an immutable value)
) -> int:
    """Prove that something reflects as it must, or find its fault and what it probably is.

    Writes a page (NAME.html) and the same as JSON (NAME.json). The exit status is 1 where a fault was found.

    Parameters
    ----------
    subject
        A material.json, a folder of motes fit, a preset, a model with its values, FILE.py:FUNCTION, FILE.c:FUNCTION or
        FILE.glsl:FUNCTION, mitsuba:PLUGIN, a BSDF of Mitsuba as XML or JSON, or measured data.
    as_model
        The model that it should be, such as "ggx(K_s=0.5, alpha=0.3)": rival conventions are told apart.
    against
        Another subject that it should be equal to, of any kind.
    cosine
        The function answers f cos(theta_r), not f.
    set
        NAME=VALUE: a parameter of the function; repeat for more.
    hours
        The moment of a material that changes.
    exports
        Print a material of Motes for every target of motes export, run what can be run here, and compare: some ten to thirty seconds.
    date
        Of the page, such as 2026-01-31, to make it again bit by bit; today when not given.
    output
        The page to write, NAME.html, or NAME.pdf for paper; certificate-SUBJECT.html when not given. NAME.json lies beside it.
    """
    from motes.certification import certify as certified
    from motes.certification.certificate import Outcome
    from motes.cli import console, paths
    from motes.cli.options import numbers
    from motes.cli.statuses import DONE, FAULT_FOUND
    from motes.errors import MotesError
    from motes.files import check_writable

    page = Path(output) if output is not None else None
    if page is not None and page.suffix.lower() not in (".html", ".pdf"):
        raise MotesError(f"{page} is no page by its name", "Write -o NAME.html, or NAME.pdf for paper")
    if page is not None:
        for file in (page, page.with_suffix(".json")):
            check_writable(file)  # before the work
    found = certified(
        subject,
        as_model=as_model,
        against=against,
        parameters=numbers(set, "--set"),
        cosine=cosine,
        hours=hours,
        exports=exports,
        date=date,
    )
    page = page or Path(f"certificate-{paths.slug(found.subject)}.html")
    written = [found.report(page), found.save(page.with_suffix(".json"))]
    if common.json:
        console.print_json({**found.to_dict(), "files": [str(file) for file in written]})
    elif not common.quiet:
        rows = [(str(check.outcome), f"{check.name}: {check.says}") for check in found.checks]
        for finding in found.findings:
            rows.append((f"{finding.outcome}!" if finding.outcome is Outcome.FAULT else "doubt", f"{finding.says}. {finding.probably}"))  # fmt: skip
        console.print_facts([("subject", f"{found.subject} ({found.kind})"), *rows])
        console.print_facts([("certificate", f"{found.number}, {found.outcome}"), *(("written", str(f)) for f in written)])  # fmt: skip
    return DONE if found.ok else FAULT_FOUND
