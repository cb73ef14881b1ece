"""`fit_map`: the fit of every texel of a map, block by block, resumable."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Generator, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack, suppress
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from numpy.typing import ArrayLike

from motes.errors import MotesError
from motes.maps import zarrs
from motes.maps.beginning import create_fitted
from motes.maps.fitted import FittedMap, open_fitted
from motes.maps.making import at_work
from motes.maps.plan import Plan
from motes.maps.settings import Settings, with_block
from motes.maps.stack import MapStack, open_stack
from motes.maps.work import DONE, UNREADABLE, Outcome, fit_block, read_block, write_block
from motes.models import BRDF

#: Called with (texels done, texels in all, what is going on).
Progress = Callable[[int, int, str], None]


def fit_map(
    source: str | os.PathLike[str] | MapStack,
    model: str | BRDF = "oren_nayar + torrance_sparrow",
    *,
    out: str | os.PathLike[str],
    loss: str = "linear",
    robust: str = "none",
    time: int | None = None,
    trends: Mapping[str, str] | None = None,
    fixed: Collection[str] | Mapping[str, Any] = (),
    per_channel: Collection[str] = (),
    weights: str | ArrayLike = "measurement",
    max_theta: float | None = None,
    covariance: bool = False,
    block: tuple[int, int] | None = None,
    scheduler: str | None = None,
    workers: int | None = None,
    restart: bool = False,
    progress: Progress | None = None,
) -> FittedMap:
    """Fit a model to every texel of a map, and at every time unless trends are given.

    The map is worked on in blocks of texels; memory is bounded by a few of them.  A block's results are written whole, then it is
    marked done; the same call again, after an interrupt, fits only what is not done.

    Parameters
    ----------
    source
        A map: the path of a Zarr store, or a `MapStack`.
    model
        Text such as ``"oren_nayar + torrance_sparrow"`` (values given in it are held), a BRDF (fits also start from its values), or
        ``"auto"``: the one of those that `motes.fit` tries which some texels from all over the map prefer by BIC.
    out
        The Zarr store of the results.
    loss, robust
        As for `motes.fit`.
    time
        Which of the map's times to fit alone, from 0; None for all of them.
    trends
        Fit all times of a texel together, each parameter following a trend: names to kinds (`motes.trends.KINDS`); what is not named is
        constant.  None: every time alone.
    fixed, per_channel, max_theta
        As for `motes.fit`.
    weights
        ``"measurement"`` for those in the store, ``"uniform"``, or numbers >= 0 for the directions (D,).
    covariance
        Keep the covariance matrices of the fits besides: see `FittedMap.covariance`.
    block
        Rows and columns of texels that are fitted and saved at a time; by default whole chunks of the store.
    scheduler
        Address of a Dask scheduler (``tcp://127.0.0.1:8786``) whose workers do the work; they must see the same paths.
    workers
        Or: the number of worker processes to start here, of one thread each.
    restart
        Throw away what another run left in `out`.
    progress
        Called with (done, total, what) in texels.

    Returns
    -------
    FittedMap
        Its `failures` name the blocks that could not be read; all others are done.  The results are the same bit for bit
        however many processes or machines made them, and however often the run was interrupted.

    Raises
    ------
    FormatError, DataError, ParameterError
        For a store that is not a map, a model or names that do not fit.
    MotesError
        When `out` holds another run, cannot be written (the disk is full), or the scheduler is gone; finished blocks are kept.
    """
    if scheduler is not None and workers is not None:
        raise MotesError("both a scheduler and a number of workers were given", "Give one of them")
    if workers is not None and workers < 1:
        raise MotesError(f"{workers} workers cannot work", "Give 1 or more")
    stack = source if isinstance(source, MapStack) else open_stack(source)
    stack = with_block(stack, block)
    if progress:
        progress(0, 1, "planning")
    settings = Settings.of(
        stack,
        model,
        loss=loss,
        robust=robust,
        trends=trends,
        time=time,
        fixed=fixed,
        per_channel=per_channel,
        weights=weights,
        max_theta=max_theta,
        covariance=covariance,
    )
    path = Path(out)
    with ExitStack() as held:
        if restart and _lock(path).is_dir():
            held.enter_context(at_work(_lock(path), path))
        fitted = _resumed(path, settings, restart)
        if fitted is None:
            if progress:
                progress(0, 1, "finding starts")
            plan = Plan.make(stack, settings, model if isinstance(model, BRDF) else None)
            fitted = create_fitted(path, plan, restart)
        held.enter_context(at_work(_lock(fitted.path), path))
        _go_on(fitted, scheduler, workers, progress)
    return fitted


def _lock(path: Path) -> Path:
    """Where in a store the lock is, which those hold that fit."""
    return path / "run" / "done"


def _go_on(fitted: FittedMap, scheduler: str | None, workers: int | None, progress: Progress | None) -> None:
    """Fit what is not done yet."""
    done = fitted.done()
    waiting = [b for b in fitted.blocks if not done[b]]
    total = fitted.shape[0] * fitted.shape[1]
    so_far = total - sum(fitted.blocks.texels(b) for b in waiting)
    failures: list[tuple[tuple[int, int], str]] = []
    outcomes = _outcomes(fitted, waiting, scheduler, workers)
    if progress:
        progress(so_far, total, "fitting")
    try:
        for outcome in outcomes:
            if outcome.kind == DONE:
                so_far += outcome.texels
            elif outcome.kind == UNREADABLE:
                failures.append((outcome.block, outcome.reason))
            else:
                raise MotesError(
                    f"{fitted.path} cannot be written: {outcome.reason}",
                    f"Make room; the same command then goes on after the {fitted.done().sum()} blocks that are done",
                )
            if progress:
                progress(so_far, total, "fitting" + (f", {len(failures)} failed" if failures else ""))
    finally:
        outcomes.close()
        with suppress(OSError):
            fitted.record_failures(failures)
    if not failures:
        fitted.clean()


def _resumed(path: Path, settings: Settings, restart: bool) -> FittedMap | None:
    """The unfinished or finished map at a path, None where there is none; another run is an error."""
    if restart or not path.exists() or (path.is_dir() and not any(path.iterdir())):
        return None
    if not zarrs.is_store(path) or zarrs.kind_of(path) != "fitted":
        raise MotesError(f"{path} exists and is not a fitted map", "Choose another name with -o")
    fitted = open_fitted(path, mode="r+")
    difference = settings.differs(asdict(fitted.plan.settings))
    if difference:
        done = fitted.done()
        raise MotesError(
            f"{path} holds {done.sum()} of {done.size} blocks of another run: {difference}",
            "Choose another name with -o, or start over with --restart",
        )
    if fitted.version < zarrs.FITTED_VERSION and not fitted.done().all():
        raise MotesError(
            f"{path} was begun by an earlier Motes, which kept no verdicts",
            "Choose another name with -o, or start over with --restart",
        )
    if fitted.plan.settings.source != settings.source:  # the map was moved
        moved = replace(fitted.plan, settings=replace(fitted.plan.settings, source=settings.source))
        fitted.group["run"].attrs["plan"] = moved.to_dict()
        return open_fitted(path, mode="r+")
    return fitted


def _outcomes(
    fitted: FittedMap, blocks: list[tuple[int, int]], scheduler: str | None, workers: int | None
) -> Generator[Outcome]:
    """What becomes of the blocks, in the order in which they end."""
    if blocks and (scheduler is not None or workers is not None):
        from motes.maps.cluster import on_cluster

        return on_cluster(fitted, blocks, scheduler, workers)
    return _here(fitted, blocks)


def _here(fitted: FittedMap, blocks: list[tuple[int, int]]) -> Generator[Outcome]:
    """One block after the other in this process; meanwhile the next one is read and the one before is written."""
    with ThreadPoolExecutor(1) as reader, ThreadPoolExecutor(1) as writer:
        ahead = reader.submit(read_block, fitted, blocks[0]) if blocks else None
        behind: Future[Outcome] | None = None
        for k, block in enumerate(blocks):
            assert ahead is not None
            values = ahead.result()
            if k + 1 < len(blocks):
                ahead = reader.submit(read_block, fitted, blocks[k + 1])
            fit = None if isinstance(values, str) else fit_block(fitted, values)
            if behind is not None:
                yield behind.result()
            behind = None if fit is None else writer.submit(write_block, fitted, block, fit)
            if isinstance(values, str):
                yield Outcome(block, UNREADABLE, fitted.blocks.texels(block), values)
        if behind is not None:
            yield behind.result()
