"""What a certification finds: findings with their probable causes, checks with their numbers, and the certificate that holds them."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import Path
from typing import Any, final

from motes import outlets
from motes.files import write_json

VERSION = 1


class Outcome(StrEnum):
    """How a check ended."""

    HOLDS = "holds"
    DOUBT = "doubt"
    FAULT = "fault"
    NOT_JUDGED = "not judged"


_ORDER = (Outcome.NOT_JUDGED, Outcome.HOLDS, Outcome.DOUBT, Outcome.FAULT)


@dataclass(frozen=True)
class Finding:
    """Something that is not as it should be.

    Attributes
    ----------
    name
        What it probably is, as a word for programs: ``factor-pi``, ``cosine-included``; the name of the check's own failure where
        no rival explains it.
    says
        What was found, in a sentence with numbers.
    probably
        What it probably is, as a question or the next step.
    outcome
        `Outcome.FAULT`, or `Outcome.DOUBT` for what may be meant so.
    """

    name: str
    says: str
    probably: str
    outcome: Outcome = Outcome.FAULT

    def to_dict(self) -> dict[str, str]:
        return {"name": self.name, "outcome": str(self.outcome), "says": self.says, "probably": self.probably}


@dataclass(frozen=True)
class Check:
    """One thing that was looked at.

    Attributes
    ----------
    name
        ``values``, ``energy``, ``reciprocity``, ``sampling``, ``gradients``, ``precision``, ``conventions`` or
        ``exports``.
    says
        The result in a sentence, or why it was not judged.
    findings
        What is wrong.
    numbers
        What it was judged by: plain JSON values, which the page draws.
    judged
        False where the subject cannot be asked.
    """

    name: str
    says: str
    findings: tuple[Finding, ...] = ()
    numbers: Mapping[str, Any] = field(default_factory=dict)
    judged: bool = True

    @property
    def outcome(self) -> Outcome:
        """The worst of the findings; ``holds`` without one."""
        if not self.judged and not self.findings:
            return Outcome.NOT_JUDGED
        return max((f.outcome for f in self.findings), key=_ORDER.index, default=Outcome.HOLDS)

    def to_dict(self) -> dict[str, Any]:
        return {
            "name": self.name,
            "outcome": str(self.outcome),
            "says": self.says,
            "findings": [finding.to_dict() for finding in self.findings],
            "numbers": dict(self.numbers),
        }


@final
@dataclass(frozen=True)
class Certificate:
    """What `motes.certify` returns.

    Attributes
    ----------
    subject
        Its name.
    kind
        What it is: ``Motes material``, ``Python function``, ...
    facts
        What is known about the subject: its parameters, how it was called; by label.
    checks
        In the order of the page.
    digest
        SHA-256 of what was certified: the file, the text of the model, the source of the function.
    versions
        Of Motes, Python, NumPy and whatever else computed.
    date
        ISO 8601, of the day; empty where none was given.
    """

    subject: str
    kind: str
    facts: Mapping[str, str]
    checks: tuple[Check, ...]
    digest: str
    versions: Mapping[str, str]
    date: str = ""

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Of all checks."""
        return tuple(finding for check in self.checks for finding in check.findings)

    @property
    def outcome(self) -> Outcome:
        """The worst of the checks."""
        return max((check.outcome for check in self.checks), key=_ORDER.index, default=Outcome.NOT_JUDGED)

    @property
    def ok(self) -> bool:
        """Whether no fault was found; a doubt is none."""
        return self.outcome is not Outcome.FAULT

    def check(self, name: str) -> Check:
        """The check of a name."""
        return next(check for check in self.checks if check.name == name)

    def body(self) -> dict[str, Any]:
        """Everything but the date and the number that comes of it."""
        return {
            "format": "motes certificate",
            "version": VERSION,
            "subject": self.subject,
            "kind": self.kind,
            "outcome": str(self.outcome),
            "facts": dict(self.facts),
            "sha256_of_subject": self.digest,
            "versions": dict(self.versions),
            "checks": [check.to_dict() for check in self.checks],
        }

    @property
    def number(self) -> str:
        """What the certificate is cited by: the head of the SHA-256 of all that it says, the date left out."""
        text = json.dumps(self.body(), sort_keys=True, allow_nan=False)
        return hashlib.sha256(text.encode()).hexdigest()[:16]

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON values."""
        return {**self.body(), "number": self.number, "date": self.date}

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the certificate as JSON, whole or not at all."""
        return write_json(path, self.to_dict())

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Write the certificate as one self-contained HTML page; see `motes.report.certificate_page`."""
        return outlets.report("certificate", self, path)
