"""Films: frames that are kept as they are finished, so that a run that was stopped goes on where it was; GIF and MP4 from them."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import MissingExtraError, MotesError
from motes.files import replacing
from motes.rendering.loading import native
from motes.rendering.panels import pillow

Bytes = NDArray[np.uint8]
Floats = NDArray[np.floating[Any]]
Progress = Callable[[int, int, str], None]
SUFFIXES = (".gif", ".mp4")
COLORS = 255  # of a GIF, one less than it can have: some programs want one to be transparent


def frames_folder(path: str | os.PathLike[str], settings: Mapping[str, Any]) -> Path:
    """Where the frames of a film are kept: beside it, under a name made of everything that decides how they look."""
    digest = hashlib.sha256(json.dumps(settings, sort_keys=True, default=str).encode()).hexdigest()[:10]
    target = Path(path)
    return target.with_name(f"{target.stem}.frames-{digest}")


def render_frames(folder: Path, n: int, draw: Callable[[int], Floats], progress: Progress | None = None) -> list[Path]:
    """Draw the frames 0 to n - 1 that are not in a folder yet; each is a half-float EXR, whole or not there.

    Parameters
    ----------
    folder
        Made when it is not there.
    n
        How many frames the film has.
    draw
        From the index to radiance (H, W, 3).
    progress
        Called with (done, total, what), with the time that is left.

    Returns
    -------
    list of Path
        All frames in order.

    Raises
    ------
    MotesError
        When a frame cannot be written.  Those before it are kept, also on an interrupt.
    """
    from motes.rendering import load_mitsuba

    mi = load_mitsuba()
    paths = [folder / f"{k:05d}.exr" for k in range(n)]
    missing = [k for k, path in enumerate(paths) if not _readable(mi, path)]
    kept, begun = n - len(missing), time.monotonic()
    for done, k in enumerate(missing):
        if progress is not None:
            progress(kept + done, n, f"frame {k + 1} of {n}{_left(begun, done, len(missing))}")
        write_radiance(paths[k], draw(k), half=True)
    if progress is not None:
        progress(n, n, "all frames are there")
    return paths


def _left(begun: float, done: int, total: int) -> str:
    """The time that is left, in words, from that of the frames so far."""
    if not done:
        return ""
    seconds = (time.monotonic() - begun) / done * (total - done)
    minutes, rest = divmod(round(seconds), 60)
    return f", {minutes} min {rest} s left" if minutes else f", {rest} s left"


def _readable(mi: Any, path: Path) -> bool:
    if not path.is_file():
        return False
    try:
        mi.Bitmap(native(path))
    except Exception:  # whatever is wrong with it, it is drawn again
        return False
    return True


def read_radiance(path: Path) -> NDArray[np.float32]:
    """A frame (H, W, 3)."""
    from motes.rendering import load_mitsuba

    return np.array(load_mitsuba().Bitmap(native(path)), np.float32)


def write_radiance(path: str | os.PathLike[str], radiance: Floats, half: bool = False) -> Path:
    """Write radiance (H, W, 3) as EXR, whole or not at all; raises `MotesError` when it cannot be written."""
    from motes.rendering import load_mitsuba

    mi = load_mitsuba()
    bitmap = mi.Bitmap(np.ascontiguousarray(radiance, np.float32))
    if half:
        bitmap = bitmap.convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float16, False)
    with replacing(path) as temporary:
        try:
            bitmap.write(native(temporary), mi.Bitmap.FileFormat.OpenEXR)
        except RuntimeError as error:  # what Mitsuba makes of a full disk
            raise OSError(0, str(error).splitlines()[-1][:160]) from None
        if not temporary.stat().st_size:
            raise OSError(28, "No space left on device")
    return Path(path)


def write_picture(path: str | os.PathLike[str], picture: Bytes, comment: str = "") -> Path:
    """Write an 8-bit picture as PNG, whole or not at all; raises `MotesError` when it cannot be written."""
    Image, _, _ = pillow()
    from PIL.PngImagePlugin import PngInfo

    words = PngInfo()
    if comment:
        words.add_text("Comment", comment)
    with replacing(path) as temporary:
        Image.fromarray(picture).save(temporary, format="PNG", optimize=True, pnginfo=words)
    return Path(path)


def write_film(
    path: str | os.PathLike[str], frames: Callable[[], Iterator[Bytes]], fps: float, comment: str = ""
) -> Path:
    """Write a film of 8-bit frames (H, W, 3), as GIF or MP4 by the suffix, whole or not at all.

    Parameters
    ----------
    path
        NAME.gif or NAME.mp4.
    frames
        Gives the frames from the first on; called twice for a GIF, whose palette is one for all frames.
    fps
        Frames a second; a GIF counts time in hundredths of a second.
    comment
        Kept in the file.

    Raises
    ------
    MotesError
        For another suffix, frames a second out of range, or when the file cannot be written.
    MissingExtraError
        Without the package that writes it.
    """
    check_film(path, fps)
    suffix = Path(path).suffix.lower()
    with replacing(path) as temporary:
        (_gif if suffix == ".gif" else _mp4)(temporary, frames, fps, comment)
    return Path(path)


def check_film(path: str | os.PathLike[str], fps: float) -> None:
    """Raise what `write_film` would for its suffix and rate, before the work."""
    if Path(path).suffix.lower() not in SUFFIXES:
        raise MotesError(f"{path} is not a film by its name", f"Films are {' and '.join(SUFFIXES)} files")
    if not 0.1 <= fps <= 120:
        raise MotesError(f"{fps:g} frames a second are outside [0.1, 120]", "12 is usual")


def _gif(path: Path, frames: Callable[[], Iterator[Bytes]], fps: float, comment: str) -> None:
    Image, _, _ = pillow()
    # One palette for all frames, from a sample of their pixels: colours that change from frame to frame flicker.
    samples = [frame[::3, ::3].reshape(-1, 3) for frame in frames()]
    pixels = np.concatenate(samples)[:: max(len(samples) // 24, 1)]
    side = max(int(np.sqrt(len(pixels))), 1)
    sample = Image.fromarray(np.ascontiguousarray(pixels[: side * side].reshape(side, side, 3)))
    palette = sample.quantize(COLORS, method=Image.Quantize.MEDIANCUT, kmeans=2)
    dithered = (Image.fromarray(f).quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG) for f in frames())
    first = next(dithered)
    milliseconds = max(round(100 / fps), 1) * 10
    first.save(
        path,
        format="GIF",
        save_all=True,
        append_images=dithered,
        duration=milliseconds,
        loop=0,
        optimize=False,
        comment=comment.encode("ascii", "replace")[:200],
    )


def _mp4(path: Path, frames: Callable[[], Iterator[Bytes]], fps: float, comment: str) -> None:
    try:
        import av
    except ImportError:
        raise MissingExtraError("av", "render", "writing MP4 films") from None
    try:
        with av.open(str(path), "w", format="mp4", options={"movflags": "+faststart"}) as container:
            container.metadata["comment"] = comment
            stream: Any = None
            for frame in frames():
                even = frame[: frame.shape[0] // 2 * 2, : frame.shape[1] // 2 * 2]  # 4:2:0 halves both sides
                if stream is None:
                    stream = container.add_stream("libx264", rate=Fraction(fps).limit_denominator(1000))
                    stream.height, stream.width = even.shape[:2]
                    stream.pix_fmt = "yuv420p"
                    stream.options = {"crf": "16", "preset": "medium"}
                    # BT.709, said in the file: players otherwise guess, and colours shift.
                    context = stream.codec_context
                    context.color_primaries = context.color_trc = context.colorspace = 1
                    context.color_range = 1
                picture = av.VideoFrame.from_ndarray(np.ascontiguousarray(even), format="rgb24")
                converted = picture.reformat(format="yuv420p", dst_colorspace="ITU709", dst_color_range="MPEG")
                for packet in stream.encode(converted):
                    container.mux(packet)
            for packet in stream.encode():
                container.mux(packet)
    except av.FFmpegError as error:
        raise OSError(error.errno or 0, f"the film cannot be encoded: {error.strerror or error}") from error


def forget(folder: Path, frames: Sequence[Path]) -> None:
    """Remove the frames of a film that is finished, and their folder when nothing else is in it."""
    for frame in (*frames, *folder.glob(".*.partial")):  # the latter are of runs that were killed
        frame.unlink(missing_ok=True)
    if folder.is_dir() and not any(folder.iterdir()):
        shutil.rmtree(folder)
