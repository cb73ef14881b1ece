"""A Python function as a specimen: ``f(wi, wo)`` over arrays, or of a pair at a time; its sampling, density and derivatives where it has them."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np

from motes.certification.specimen import Drawn, Floats, Numbers, Slopes, Specimen, digest_of, shaped
from motes.errors import DataError, MotesError

MOST_CHANNELS = 64


def of_function(
    function: Callable[..., Any],
    *,
    name: str = "",
    sample: Callable[..., Any] | None = None,
    pdf: Callable[..., Any] | None = None,
    gradient: Callable[..., Any] | None = None,
    parameters: Mapping[str, Any] | None = None,
    cosine: bool = False,
    source: str = "",
) -> Specimen:
    """See `motes.certify`, whose arguments these are; `source` is what is hashed in place of the function's own text."""
    given = dict(parameters or {})
    owner = name or getattr(function, "__name__", type(function).__name__)
    functions = {"f": function, "sample": sample, "pdf": pdf, "gradient": gradient}
    texts = [source or _text(f) for f in functions.values() if f is not None]
    evaluate = _vectorised(partial(function, **given), owner)

    def value(wi: Floats, wo: Floats) -> Floats:
        values = shaped(evaluate(wi, wo), len(wi), owner)
        return divided(values, wo) if cosine else values

    def narrow(wi: Numbers, wo: Numbers) -> Numbers:
        values = np.asarray(evaluate(wi, wo))
        values = values[:, None] if values.ndim == 1 else values
        return divided(values, wo) if cosine else values

    probe = np.array([[0.0, 0.6, 0.8], [0.6, 0.0, 0.8]], np.float32)
    keeps = np.asarray(evaluate(probe, probe)).dtype == np.float32
    facts = {"called as": f"{owner}(wi, wo{''.join(f', {k}={v!r}' for k, v in given.items())})"}
    facts["answers"] = "f times the cosine of wo, divided here" if cosine else "f in 1/sr, without a cosine"
    return Specimen(
        name=owner,
        kind="Python function",
        eval=value,
        digest=digest_of(*texts, repr(sorted(given.items()))),
        sample=None if sample is None else partial(_sampled, partial(sample, **given), f"the sampling of {owner}"),
        pdf=None
        if pdf is None
        else _flat(_vectorised(partial(pdf, **given), f"the density of {owner}"), f"the density of {owner}"),
        narrow=narrow if keeps else None,
        slopes=None if gradient is None or not given else partial(_slopes, function, gradient, given, owner),
        strict=False,
        facts=facts,
    )


def _text(function: Callable[..., Any]) -> str:
    """The source of a function; its code's bytes where there is none to read."""
    while isinstance(function, partial):
        function = function.func
    try:
        return inspect.getsource(function)
    except (OSError, TypeError):
        code = getattr(function, "__code__", None)
        return f"{code.co_code!r}{code.co_consts!r}" if code is not None else repr(type(function))


def _vectorised(function: Callable[..., Any], owner: str) -> Callable[[Numbers, Numbers], Any]:
    """The function over arrays (N, 3), or where it does not take those, a pair at a time."""

    def at_once(wi: Numbers, wo: Numbers) -> Any:
        with np.errstate(all="ignore"):
            values = np.asarray(function(np.array(wi), np.array(wo)))
        if values.ndim == 0 or (values.ndim == 1 and len(values) != len(wi) and len(values) <= MOST_CHANNELS):
            values = np.broadcast_to(values, (len(wi), *values.shape))
        return values

    def one_by_one(wi: Numbers, wo: Numbers) -> Any:
        with np.errstate(all="ignore"):
            return np.array([function(a, b) for a, b in zip(wi, wo, strict=True)])

    probe = np.array([[0.0, 0.6, 0.8], [0.6, 0.0, 0.8], [0.0, 0.0, 1.0], [-0.48, 0.6, 0.64], [0.28, -0.96, 0.0]])
    try:
        if at_once(probe, probe[::-1]).shape[:1] == (len(probe),):
            return at_once
    except Exception:  # whatever it says of arrays, it may take a pair
        pass
    try:
        one_by_one(probe, probe[::-1])
    except MotesError:
        raise
    except Exception as error:
        raise DataError(
            f"{owner} cannot be called with two directions: {type(error).__name__}: {str(error)[:200]}",
            "Give a function f(wi, wo) of arrays (N, 3) of unit vectors, or of two vectors (3,), which returns (N,), (N, C) or a number",
        ) from error
    return one_by_one


def _flat(evaluate: Callable[[Numbers, Numbers], Any], owner: str) -> Callable[[Floats, Floats], Floats]:
    def density(wi: Floats, wo: Floats) -> Floats:
        values = shaped(evaluate(wi, wo), len(wi), owner)
        if values.shape[1] != 1:
            raise DataError(f"{owner} answers {values.shape[1]} numbers a direction", "Return an array (N,)")
        return values[:, 0]

    return density


def divided(values: Numbers, wo: Numbers) -> Floats:
    """Values of f cos(theta_r) as f, above the horizon."""
    cosine = wo[:, 2:]
    with np.errstate(all="ignore"):
        return np.where(cosine > 0, values / np.where(cosine > 0, cosine, 1), values)


def _sampled(sample: Callable[..., Any], owner: str, wi: Floats, u: Floats) -> Drawn:
    """``wo``, ``(wo, pdf)`` or ``(wo, pdf, weight)`` as samples."""
    with np.errstate(all="ignore"):
        answer = sample(np.broadcast_to(wi, (len(u), 3)).copy(), u)
    parts = answer if isinstance(answer, tuple) else (answer,)
    wo = np.asarray(parts[0], np.float64)
    if wo.shape != (len(u), 3):
        raise DataError(
            f"{owner} gives directions of shape {wo.shape} for {len(u)} random numbers", f"Return wo ({len(u)}, 3)"
        )
    pdf = np.asarray(parts[1], np.float64).reshape(len(u)) if len(parts) > 1 else np.full(len(u), np.nan)
    return Drawn(wo, pdf, shaped(parts[2], len(u), owner) if len(parts) > 2 else None)


def _slopes(
    function: Callable[..., Any],
    gradient: Callable[..., Any],
    given: Mapping[str, Any],
    owner: str,
    wi: Floats,
    wo: Floats,
) -> Mapping[str, Slopes]:
    """What ``gradient(wi, wo, **parameters)`` says, by name, against central differences: of all components of a parameter together."""
    said = gradient(wi, wo, **given)
    if not isinstance(said, Mapping) or not set(said) <= set(given):
        raise DataError(
            f"the gradient of {owner} is no dictionary of its parameters ({', '.join(given)})",
            'Return {"alpha": array (N,) or (N, C), ...}',
        )
    found = {}
    for name, slope in said.items():
        value = np.asarray(given[name], np.float64)
        h = 1e-5 * max(float(np.max(np.abs(value), initial=0.0)), 0.1)
        ends = [shaped(function(wi, wo, **{**given, name: value + s * h}), len(wi), owner) for s in (1, -1)]
        found[str(name)] = Slopes(shaped(slope, len(wi), owner), (ends[0] - ends[1]) / (2 * h))
    return found
