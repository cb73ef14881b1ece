"""`certify`: any subject through every check."""

from __future__ import annotations

import os
import platform
from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from typing import Any

import numpy as np

from motes.certification.certificate import Certificate, Check
from motes.certification.check_conventions import check_conventions
from motes.certification.check_energy import check_energy
from motes.certification.check_exports import check_exports
from motes.certification.check_gradients import check_gradients
from motes.certification.check_precision import check_precision
from motes.certification.check_reciprocity import check_reciprocity
from motes.certification.check_sampling import check_sampling
from motes.certification.check_values import check_values
from motes.certification.recognising import reference_of, specimen_of
from motes.errors import MotesError
from motes.version import __version__

CHECKS = (check_values, check_energy, check_reciprocity, check_sampling, check_gradients, check_precision)


def certify(
    subject: Any,
    *,
    as_model: str | None = None,
    against: Any = None,
    sample: Callable[..., Any] | None = None,
    pdf: Callable[..., Any] | None = None,
    gradient: Callable[..., Any] | None = None,
    parameters: Mapping[str, Any] | None = None,
    cosine: bool = False,
    name: str = "",
    hours: float | None = None,
    exports: bool = False,
    date: str | None = None,
) -> Certificate:
    """Prove that something reflects as a BRDF must, or find its fault and what it probably is.

    Parameters
    ----------
    subject
        A `Material`, a BRDF, the text of a model (``"oren_nayar(K_d=0.5, sigma_d=0.3)"``), the path of a ``material.json`` or of measured data,
        ``"FILE.py:FUNCTION"`` (or ``.c``, ``.glsl``), a BSDF of Mitsuba (a dictionary, ``"mitsuba:diffuse"``, XML, JSON, or itself; the variant is
        ``llvm_ad_rgb`` from then on), or a function ``f(wi, wo)`` of
        unit vectors (N, 3) away from the surface, z the normal, that returns (N,) or (N, C) in 1/sr.
    as_model
        The text of the model that it should be; parameters without a value are fitted to it.  Rival conventions are then told apart.
    against
        Another subject that it should be equal to, of any kind.
    sample
        Of a function: ``sample(wi, u)`` for wi (N, 3) and random numbers u (N, 2), which returns ``wo``, ``(wo, pdf)`` or ``(wo, pdf, weight)``.
    pdf
        Of a function: ``pdf(wi, wo)``, the density of its samples per solid angle.
    gradient
        Of a function: ``gradient(wi, wo, **parameters)``, a dictionary of derivatives (N,) or (N, C) by its parameters.
    parameters
        Passed to the functions by name.
    cosine
        True where a function answers f cos(theta_r).
    name
        In place of the subject's own.
    hours
        The moment [h] of a material that changes.
    exports
        Whether to print a material of Motes for every target, run what can be run here, and compare: some ten to thirty seconds.
    date
        Of the page, ISO 8601; today (UTC) when not given, or that of the environment variable SOURCE_DATE_EPOCH.

    Returns
    -------
    Certificate
        The same subject, versions and date give the same, bit by bit.

    Raises
    ------
    MotesError
        When the subject cannot be read or called, or both `as_model` and `against` are given.

    Examples
    --------
    >>> import numpy as np
    >>> found = certify(lambda wi, wo: np.full((len(wi), 1), 0.5), name="grey")  # 1/pi is missing
    >>> [finding.name for finding in found.findings if finding.outcome == "fault"]
    ['factor-pi']
    """
    if as_model is not None and against is not None:
        raise MotesError("both a model and a material to compare with were given", "Give --as or --against, not both")
    specimen = specimen_of(
        subject,
        sample=sample,
        pdf=pdf,
        gradient=gradient,
        parameters=parameters,
        cosine=cosine,
        name=name,
        hours=hours,
    )
    reference = reference_of(specimen, as_model, against)
    with np.errstate(all="ignore"):
        checks: list[Check] = [check(specimen) for check in CHECKS]
        checks.append(check_conventions(specimen, reference))
        checks.append(check_exports(specimen, exports))
    facts = dict(specimen.facts)
    if reference is not None:
        facts["compared with"] = f"{reference.name} ({reference.kind})"
        if as_model is not None:
            facts |= {f"{label} of that": value for label, value in reference.facts.items() if label != "model"}
    versions = {"motes": __version__, "python": platform.python_version(), "numpy": np.__version__, **specimen.versions}
    return Certificate(
        specimen.name,
        specimen.kind,
        facts,
        tuple(checks),
        specimen.digest,
        versions,
        _today() if date is None else date,
    )


def _today() -> str:
    """The date of the page: that which the environment gives for builds that are made again, else today's."""
    given = os.environ.get("SOURCE_DATE_EPOCH", "")
    moment = datetime.fromtimestamp(int(given), UTC) if given.isdigit() else datetime.now(UTC)
    return moment.date().isoformat()
