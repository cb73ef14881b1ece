"""What a run skipped, said at its end by reason; and where everything is to be installed, a skip that is a failure.

With MOTES_REQUIRE_EXTRAS=1, which continuous integration sets, a test may be skipped only for what `EXCUSES` names: what the
machine is, what nobody may copy, and what has no package for it.  Whatever else is missing can be installed, so its test fails.
"""

from __future__ import annotations

import os
import re
import sys
from collections import Counter
from collections.abc import Generator
from pathlib import Path

import pytest

SHARED = Path(__file__).resolve().parents[2] / "shared"
REQUIRED = os.environ.get("MOTES_REQUIRE_EXTRAS", "") not in ("", "0")

#: Patterns of reasons that are good everywhere, each with a condition: whether it holds on this machine.
EXCUSES = {
    r"\.\./shared/\S+ is missing": not SHARED.exists(),  # measurements whose terms do not allow copies
    r"mounting a small file system needs root|mounting is not allowed here": True,
    r"\w+ is no wider than \w+ here": True,  # of NumPy's long double
    r"there is no /dev/full|there is no SIGKILL|no pipes here|no permission bits|the platform does not fork": (
        sys.platform != "linux"
    ),
    r"MOTES_BPY does not name a Python": sys.version_info[:2] != (3, 11),  # for which Blender 5.0 has its wheel
    r"oslc is not installed": True,  # in no distribution's packages that we know, and Blender's compiler is asked the same
}


def excused(reason: str) -> bool:
    """Whether a test may be skipped for this reason where everything is to be installed."""
    return any(holds and re.match(pattern, reason) for pattern, holds in EXCUSES.items())


def reason_of(report: pytest.TestReport | pytest.CollectReport) -> str:
    """Why a test or a file was skipped."""
    told = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
    return told.removeprefix("Skipped: ")


def required(report: pytest.TestReport | pytest.CollectReport) -> None:
    """Turn a skip into a failure where nothing excuses it."""
    if not REQUIRED or report.outcome != "skipped" or hasattr(report, "wasxfail"):
        return
    reason = reason_of(report)
    if not excused(reason):
        report.outcome = "failed"
        report.longrepr = f"skipped, and MOTES_REQUIRE_EXTRAS is set: {reason}"


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    report = yield
    required(report)
    return report


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report() -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    report = yield
    required(report)
    return report


def summary(skipped: list[pytest.TestReport | pytest.CollectReport]) -> list[str]:
    """A line a reason, the most frequent first: how many tests, and how many whole files, whose tests nobody counted."""
    counts: dict[str, Counter[str]] = {}
    for report in skipped:
        reason = reason_of(report).partition(": ")[0]  # without what this machine said about it
        kind = "file" if isinstance(report, pytest.CollectReport) else "test"
        counts.setdefault(reason, Counter())[kind] += 1

    def words(count: Counter[str]) -> str:
        return " and ".join(f"{n} {kind}{'s' * (n > 1)}" for kind, n in sorted(count.items(), reverse=True))

    lines = sorted(counts.items(), key=lambda item: (-item[1].total(), item[0]))
    total = sum(counts.values(), Counter())
    return [f"skipped: {words(total) or 'nothing'}", *(f"  {words(count)}: {reason}" for reason, count in lines)]


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    terminalreporter.line("")
    for line in summary(terminalreporter.stats.get("skipped", [])):
        terminalreporter.line(line)
