"""`render`: materials, times and measurements side by side, as a picture or a film."""

from __future__ import annotations

import hashlib
import os
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeGuard, final

import numpy as np
from numpy.typing import NDArray

from motes.errors import MotesError
from motes.files import check_writable
from motes.material import Material
from motes.rendering import films, panels, tonemap
from motes.rendering.arrangement import each_titled, layout, mosaic, words
from motes.rendering.flat import size_of
from motes.rendering.loading import native
from motes.rendering.passes import FILM, Look
from motes.rendering.rays import Progress
from motes.rendering.scenes import FLAT
from motes.rendering.stage import SMALL, measured_stage, stage
from motes.version import __version__

if TYPE_CHECKING:
    from motes.maps import FittedMap

Floats = NDArray[np.floating[Any]]
STILLS = (".png", ".exr")
FRAMES = 48  # of a film when nothing else is said
SIZE, PANEL = 512, 320  # pixels along a side: of a picture alone, of one among several or of a film


@final
@dataclass(frozen=True)
class Rendered:
    """What was made.

    Parameters
    ----------
    path
        The file.
    hours
        The times that are in it.
    look
        How it was looked at.
    rows, columns
        Panels.
    kept
        Frames that were there already, from a run that was stopped.
    tone
        What was done to the radiance, a sentence.
    notes
        What was assumed.
    not_finite
        Values of radiance that were no numbers; they are black.
    """

    path: Path
    hours: tuple[float, ...]
    look: Look
    rows: int
    columns: int
    kept: int
    tone: str
    notes: tuple[str, ...]
    not_finite: int


def render(
    materials: Sequence[Material | FittedMap],
    path: str | os.PathLike[str],
    *,
    look: Look | None = None,
    hours: Sequence[float] | None = None,
    settling: Mapping[str, Any] | None = None,
    scattering: str | None = None,
    measured: str | os.PathLike[str] | None = None,
    tone: str = "neutral",
    exposure: float = 0.0,
    fps: float = 12.0,
    labels: bool | None = None,
    keep_frames: bool = False,
    progress: Progress | None = None,
) -> Rendered:
    """Render materials and fitted maps on a preview scene, their times as the frames of a film or as panels of a picture.

    Parameters
    ----------
    materials
        Side by side; of a `motes.maps.FittedMap` every texel has its own parameters.
    path
        NAME.png, NAME.exr (radiance, without labels), NAME.gif or NAME.mp4.
    look
        The scene and the quality; by default a sphere, 512 x 512 pixels alone, 320 x 320 in company or as a film; where the first is a map a
        flat sample of its aspect.
    hours
        Times [h].  By default 0 for a picture, of maps their first time; for a film 48 steps over the time in which the materials change.
    settling
        Keyword arguments of `deposit`, for dust that lies where it settles; see `stage`.
    scattering
        ``"single"`` or ``"multiple"`` (where not given), of dust over a material that has none.
    measured
        An RGL or MERL file, shown first.
    tone, exposure
        See `motes.rendering.tonemap.picture`.
    fps
        Frames a second.
    labels
        Titles; by default where there is more than one panel, and in films.
    keep_frames
        Keep the frames' folder when all is done.
    progress
        Called with (done, total, what), with the time that is left.

    Returns
    -------
    Rendered

    Raises
    ------
    MotesError
        For what cannot be shown, or not be written.  Frames that are finished are kept beside `path`, also on an interrupt: the same call goes on from there.
    """
    target = Path(path)
    suffix = target.suffix.lower()
    if suffix not in (*STILLS, *films.SUFFIXES):
        raise MotesError(
            f"{target} is neither a picture nor a film by its name",
            f"Name it {', '.join('NAME' + s for s in (*STILLS, *films.SUFFIXES))}",
        )
    _writable(target)
    film = suffix in films.SUFFIXES
    if film:
        films.check_film(target, fps)
    times = _times(materials, hours, film)
    several = film or len(times) * len(materials) + (measured is not None) > 1
    look = look or default_look(several=several, film=film, aspect=aspect_of(materials))
    if look.repeat is not None and not any(map(is_map, materials)):
        raise MotesError(f"{look.repeat} copies were asked for, and nothing that is shown is a map", "Leave them out")
    tonemap.picture(np.zeros((1, 1, 3)), tone, exposure)  # says what is wrong with these before the work
    with tempfile.TemporaryDirectory(prefix="motes-") as work:
        span = (min(times), max(times))
        dust: dict[str, Any] = {"settling": settling, "scattering": scattering}
        stages = [stage(m, look, Path(work), hours=span, progress=progress, **dust) for m in materials]
        names = [m.name for m in materials]
        if measured is not None:
            stages.insert(0, measured_stage(measured, look))
            names.insert(0, "measured")
        table = layout(stages, names, times, film)
        settings = {
            "materials": [_settings(m) for m in materials],
            "hours": list(times),
            "look": [repr(look), *(digest_of(p) for p in (look.scene, look.env, measured))],
            "settling": repr(settling and {k: v for k, v in settling.items() if k != "progress"}),
            "scattering": scattering,
            "versions": _versions(),
        }
        folder = films.frames_folder(target, settings)
        cells = [cell for row in table for cell in row if cell is not None]

        def draw(k: int) -> Floats:
            if film:
                return np.concatenate([cell.stage.draw(times[k]) for cell in cells], axis=1)
            return cells[k].stage.draw(cells[k].hours)

        n = len(times) if film else len(cells)
        kept = len(list(folder.glob("?????.exr")))
        frames = films.render_frames(folder, n, draw, progress)
        stated = tonemap.stated(tone, exposure)
        titled = several if labels is None else labels
        bad = 0

        def shown(frame: Path) -> list[Floats]:
            """The panels of a frame."""
            nonlocal bad
            radiance = films.read_radiance(frame)
            bad += int(np.count_nonzero(~np.isfinite(radiance)))
            return np.split(radiance, len(cells) if film else 1, axis=1)

        def page(pictures: Sequence[Floats], when: float | None) -> NDArray[np.uint8]:
            made = iter([tonemap.picture(p, tone, exposure) for p in pictures])
            grid = [[None if cell is None else next(made) for cell in row] for row in table]
            if not titled:
                return panels.sheet(grid)
            if when is not None:
                titles = [
                    f"{words(when, span)}" if len(cells) == 1 else f"{cell.title}, {words(when, span)}"
                    for cell in table[0]
                    if cell
                ]
                return panels.sheet(grid, columns=titles)
            rows = names if len(table) > 1 and len(names) == len(table) and len(times) > 1 else ()
            heads = [cell.title for cell in table[0] if cell]
            return panels.sheet(grid, rows, heads) if len(table) == 1 or rows else each_titled(grid, table)

        if film:

            def all_frames() -> Iterator[NDArray[np.uint8]]:
                return (page(shown(frame), t) for frame, t in zip(frames, times, strict=True))

            films.write_film(target, all_frames, fps, f"motes render: {stated}")
            bad //= 2 if suffix == ".gif" else 1  # read twice
        elif suffix == ".png":
            films.write_picture(target, page([shown(f)[0] for f in frames], None), f"motes render: {stated}")
        else:
            made = iter([shown(f)[0] for f in frames])
            films.write_radiance(target, mosaic([[None if c is None else next(made) for c in row] for row in table]))
        if not keep_frames:
            films.forget(folder, frames)
    notes = tuple(dict.fromkeys(note for s in stages for note in s.notes))
    return Rendered(target, times, look, len(table), len(table[0]), min(kept, n), stated, notes, bad)


def default_look(*, several: bool = False, film: bool = False, aspect: float | None = None, **given: Any) -> Look:
    """A look with what is not given (None) set to what suits the picture, and small where only the scalar variant runs.

    With an `aspect`, of a map, the scene is a flat sample unless another is given, whose longer side has as many pixels as the picture would have.
    """
    from motes.rendering import slow_note

    side, samples = PANEL if several else SIZE, FILM if film else Look.samples
    if slow_note() is not None:
        side, samples = SMALL, 16
    given = {name: value for name, value in given.items() if value is not None}
    scene = given.setdefault("scene", FLAT if aspect is not None else Look.scene)
    given.setdefault("size", size_of(aspect, side) if aspect is not None and scene == FLAT else (side, side))
    return Look(**{"samples": samples, **given})


def is_map(material: Material | FittedMap) -> TypeGuard[FittedMap]:
    """Whether it is a `FittedMap`, whose room needs the extra `scale`."""
    return hasattr(material, "read_map")


def aspect_of(materials: Sequence[Material | FittedMap]) -> float | None:
    """How many times the first of them is as wide as it is high, where it is a map."""
    first = materials[0] if materials else None
    return first.shape[1] / first.shape[0] if first is not None and is_map(first) else None


def _settings(material: Material | FittedMap) -> dict[str, Any]:
    """What decides how it looks."""
    if is_map(material):
        from motes.rendering.map_stage import settings_of

        return settings_of(material)
    assert isinstance(material, Material)
    return material.to_dict()


def _writable(target: Path) -> None:
    """Raise before the work where the result cannot be written."""
    native(target)  # its frames lie beside it
    if target.is_dir():
        raise MotesError(f"{target} is a folder", f"Name a file, such as -o {target / 'picture.png'}")
    check_writable(target)


def _times(materials: Sequence[Material | FittedMap], hours: Sequence[float] | None, film: bool) -> tuple[float, ...]:
    if hours is not None:
        times = tuple(float(h) for h in hours)
        if not times or not np.isfinite(times).all():
            raise MotesError(f"the times {list(times)[:4]} are not numbers", "Give hours, such as 0:24h:48")
        return times
    maps = [m.interval[0] for m in materials if is_map(m) and m.interval is not None]
    if not film:
        return (min(maps) if len(maps) == len(materials) else 0.0,)
    intervals = [m.interval for m in materials if m.interval and m.interval[0] < m.interval[1]]
    if not intervals:
        raise MotesError(
            "nothing changes with time, so there is no film to make",
            "motes age makes materials that do; or write -o NAME.png",
        )
    first, last = min(a for a, _ in intervals), max(b for _, b in intervals)
    return tuple(np.linspace(first, last, FRAMES).tolist())


def digest_of(path: str | os.PathLike[str] | None) -> str:
    """The hash of a file's content, or an empty text where there is none."""
    if path is None or not Path(path).is_file():
        return ""
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _versions() -> list[str]:
    from motes.rendering import load_mitsuba

    mi = load_mitsuba()
    return [__version__, mi.__version__, mi.variant()]
