"""The table of formats, and `read`, which finds the right one from what a file or folder holds.

Other packages add formats through entry points of the group ``motes.readers``, each of which names a `Reader`; see
``docs/data.md``.
"""

from __future__ import annotations

import inspect
import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from importlib import metadata
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from motes.errors import FormatError, MotesError
from motes.files import reading, settle
from motes.measurements import (
    astm,
    bird,
    bsdf_xml,
    cornell,
    curet,
    lighttools,
    mbsdf,
    merl,
    merl_slice,
    native_staf,
    openmaterial,
    pab_opto,
    rgl,
    staf,
    table,
    tvbrdf,
    utia,
    zemax,
)
from motes.measurements.measurement import Measurement
from motes.measurements.parameter_maps import ParameterMaps
from motes.measurements.tabulated_maps import TabulatedMaps

T = TypeVar("T")


@dataclass(frozen=True)
class Reader:
    """One format.

    Parameters
    ----------
    name, description, source
        For ``format=``, for people, and the citation.
    sniff
        ``sniff(path, head)``: whether the first bytes of a file, or what a folder holds (head is empty), are of this
        format.
    read
        ``read(path, **options)``.
    samples
        ``samples(path)``: the samples that a container holds; None for formats of one sample.
    """

    name: str
    description: str
    source: str
    sniff: Callable[[Path, bytes], bool]
    read: Callable[..., Measurement | ParameterMaps | TabulatedMaps]
    samples: Callable[[Path], list[str]] | None = None

    @property
    def takes_sample(self) -> bool:
        return self.samples is not None

    @property
    def options(self) -> tuple[str, ...]:
        """The names of the options that `read` takes."""
        return tuple(inspect.signature(self.read).parameters)[1:]


# Binary formats with a magic number first, then those that are told apart by their text.
_TABLE = (
    Reader(rgl.NAME, "RGL tensor file (.bsdf), adaptive RGB or spectral", rgl.SOURCE, rgl.sniff, rgl.read_rgl),
    Reader(utia.NAME, "UTIA BRDF table (.bin or .exr), 6 x 48 x 6 x 48 RGB", utia.SOURCE, utia.sniff, utia.read_utia),
    Reader(mbsdf.NAME, "MBSDF table of the MDL SDK", mbsdf.SOURCE, mbsdf.sniff, mbsdf.read_mbsdf),
    Reader(
        merl_slice.NAME,
        "slice of a MERL table (.alta text or 512 x 512 .exr)",
        merl_slice.SOURCE,
        merl_slice.sniff,
        merl_slice.read_merl_slice,
    ),
    Reader(merl.NAME, "MERL table (.binary), 90 x 90 x 180 RGB", merl.SOURCE, merl.sniff, merl.read_merl),
    Reader(
        tvbrdf.NAME,
        "TVBRDF sample folder: scans over time, 4 cameras, RGB",
        tvbrdf.SOURCE,
        tvbrdf.sniff,
        tvbrdf.read_tvbrdf,
        tvbrdf.samples,
    ),
    Reader(
        native_staf.NAME,
        "STAF folder of its authors: maps (.exr) at measured times",
        native_staf.SOURCE,
        native_staf.sniff,
        native_staf.read_native_staf,
    ),
    Reader(staf.NAME, "STAF folder of polynomial parameter maps (.exr)", staf.SOURCE, staf.sniff, staf.read_staf),
    Reader(
        curet.NAME,
        "CUReT abrdf.dat with table.txt, 205 directions, grey",
        curet.SOURCE,
        curet.sniff,
        curet.read_curet,
        curet.samples,
    ),
    Reader(bird.NAME, "BiRD JSON of BRDF metrology (16NRM08)", bird.SOURCE, bird.sniff, bird.read_bird),
    Reader(
        openmaterial.NAME,
        "ASAM OpenMATERIAL BRDF table (.xompt)",
        openmaterial.SOURCE,
        openmaterial.sniff,
        openmaterial.read_openmaterial,
    ),
    Reader(
        bsdf_xml.NAME,
        "WINDOW/Radiance BSDF (.xml): Klems matrix or tensor tree",
        bsdf_xml.SOURCE,
        bsdf_xml.sniff,
        bsdf_xml.read_bsdf_xml,
    ),
    Reader(zemax.NAME, "Zemax tabular BSDF (.bsdf text)", zemax.SOURCE, zemax.sniff, zemax.read_zemax),
    Reader(lighttools.NAME, "LightTools BSDF (text)", lighttools.SOURCE, lighttools.sniff, lighttools.read_lighttools),
    Reader(astm.NAME, "ASTM E1392/E2387 text (.astm)", astm.SOURCE, astm.sniff, astm.read_astm),
    Reader(
        pab_opto.NAME,
        "pab-opto goniophotometer text, a file or a folder of them",
        pab_opto.SOURCE,
        pab_opto.sniff,
        pab_opto.read_pab_opto,
    ),
    Reader(
        cornell.NAME, "Cornell spectral goniometer text (.brdf)", cornell.SOURCE, cornell.sniff, cornell.read_cornell
    ),
    Reader(
        table.NAME,
        "table: text or .xlsx with named columns of angles and values",
        table.SOURCE,
        table.sniff,
        table.read_table,
    ),
)
#: The formats that Motes itself reads, by name.
READERS: dict[str, Reader] = {reader.name: reader for reader in _TABLE}
GROUP = "motes.readers"


def readers() -> dict[str, Reader]:
    """All formats by name: `READERS`, and those that installed packages add."""
    return READERS | _added()[0]


def _added() -> tuple[dict[str, Reader], list[str]]:
    """The readers of installed packages, and a sentence on each entry point that gives none."""
    found: dict[str, Reader] = {}
    failures: list[str] = []
    for point in metadata.entry_points(group=GROUP):
        try:
            reader = point.load()
        except Exception as error:  # whatever another package does when it is imported
            failures.append(f"the reader {point.value} cannot be loaded ({type(error).__name__}: {error})")
            continue
        if not isinstance(reader, Reader):
            failures.append(f"{point.value} is a {type(reader).__name__}, not a Reader")
        elif reader.name in READERS or reader.name in found:
            failures.append(f"{point.value} has the name of another format, {reader.name}")
        else:
            found[reader.name] = reader
    return found, failures


def read(
    path: str | os.PathLike[str],
    *,
    format: str | None = None,
    sample: int | str | None = None,
    times: Any = None,
    relative_uncertainty: float | None = None,
    common_uncertainty: float | None = None,
    **options: Any,
) -> Measurement | ParameterMaps | TabulatedMaps:
    """Read measured reflectance; the format is found from the content of the file or folder.

    Parameters
    ----------
    path
        A file, or a folder (CUReT, TVBRDF, STAF).
    format
        A name in `readers`, to skip the search.
    sample
        Which sample, where the file or folder holds several; see `list_samples`.
    times
        Hours of the scans, for formats with several whose time stamps are missing or unreadable.
    relative_uncertainty
        One standard deviation of each sample as a share of its value, for data that bring none: 0.02 is 2 %.
    common_uncertainty
        That of a scale that all samples share, such as the calibration's, relative.
    **options
        Of the reader: ``irradiance`` (tvbrdf), ``resolution`` (rgl); ``columns``, ``sheet``, ``angles``, ``azimuth`` and more of tables
        (see ``docs/data.md``); those of the formats of measuring rooms are in ``docs/formats.md``.

    Returns
    -------
    Measurement, ParameterMaps or TabulatedMaps
        The last two for maps of fitted parameters (STAF): polynomials of time, or maps at measured times.

    Raises
    ------
    FormatError
        When there is nothing to read, the format is not known, or the file is damaged.
    DataError
        When the numbers cannot be used: directions that are not unit vectors, times that do not increase.
    """
    path, reader = _find(path, format)
    options |= {name: value for name, value in (("sample", sample), ("times", times)) if value is not None}
    for name in options:
        if name not in reader.options:
            known = f"its options are: {', '.join(reader.options)}" if reader.options else "it has none"
            raise MotesError(f"The format {reader.name} has no option {name!r}; {known}", "Leave it out")
    result = _guarded(path, lambda: reader.read(path, **options))
    said = {"relative_uncertainty": relative_uncertainty, "common_uncertainty": common_uncertainty}
    said |= {name: value for name, value in options.items() if name != "sample"}
    said = {name: value for name, value in said.items() if value is not None}
    if said and isinstance(result, Measurement):  # what it takes to read it so again
        result = replace(result, provenance={**result.provenance, "options": said})
    if relative_uncertainty is None and common_uncertainty is None:
        return result
    if not isinstance(result, Measurement):
        raise MotesError(f"{path} holds maps of parameters, which have no uncertainties of samples", "Leave them out")
    if relative_uncertainty is not None and result.uncertainties is not None:
        raise MotesError(
            f"{path} brings uncertainties of its own, and relative_uncertainty = {relative_uncertainty:g} was given",
            "Leave one of them out",
        )
    return result.with_uncertainties(relative=relative_uncertainty, common=common_uncertainty)


def list_samples(path: str | os.PathLike[str], *, format: str | None = None) -> list[str]:
    """The samples in a file or folder of several, as `read` takes them; empty for formats of one sample."""
    path, reader = _find(path, format)
    if reader.samples is None:
        return []
    samples = reader.samples
    return _guarded(path, lambda: samples(path))


def _find(path: str | os.PathLike[str], format: str | None) -> tuple[Path, Reader]:
    path = _expanded(Path(path))
    if format is None:
        return path, _guarded(path, lambda: _detect(path))
    reader = READERS.get(format) or readers().get(format)
    if reader is None:
        failures = _added()[1]
        raise FormatError(
            "; ".join([f"There is no format {format!r}", *failures]), f"The formats are: {', '.join(readers())}"
        )
    _guarded(path, lambda: _exists(path))
    return path, reader


def _expanded(path: Path) -> Path:
    """A path with ``~`` as the user's home, unless something has that very name."""
    if os.path.lexists(path):
        return path
    try:
        return path.expanduser()
    except RuntimeError:  # nobody of that name, or no home
        return path


def _exists(path: Path) -> bool:
    if not path.exists():
        raise FormatError(f"{path} does not exist", "Check the path")
    if not (path.is_file() or path.is_dir()):  # a pipe or a device would never end
        raise FormatError(f"{path} is neither a file nor a folder", "Give a regular file or a folder")
    if path.is_dir():
        settle(path)  # what a writer that was killed had decided to write
    return True


def _detect(path: Path) -> Reader:
    _exists(path)
    head = reading.head(path) if path.is_file() else b""
    *formats_of_ours, plain_table = _TABLE
    for reader in formats_of_ours:
        if reader.sniff(path, head):
            return reader
    added, failures = _added()
    for reader in (*added.values(), plain_table):  # whatever is text may be a table, so it is asked last
        if reader.sniff(path, head):
            return reader
    formats = "; ".join(
        [f"The formats are: {', '.join(READERS | added)}; force one with --read format=NAME", *failures]
    )
    if path.is_dir():
        names = sorted(f.name for f in path.iterdir())
        raise FormatError(
            f"{path} is a folder of no known format; it holds {', '.join(names[:5]) or 'nothing'}", formats
        )
    if not head:
        raise FormatError(f"{path} is empty", "Fetch or copy the file again")
    if table.is_headerless(head):
        raise FormatError(f"{path} holds rows of numbers, and no line names its columns", table.HEADER)
    if names := table.columns_without_directions(head):
        shown = ", ".join(repr(name[:40]) for name in names[:12])
        raise FormatError(
            f"{path} looks like a table, and no column is a direction by its name; its columns are {shown}",
            table.HEADER,
        )
    raise FormatError(f"{path} is of no known format; it starts with {head[:24]!r}", formats)


def _guarded(path: Path, action: Callable[[], T]) -> T:
    """The action, with the operating system's refusals as errors of ours."""
    try:
        # A damaged file holds 1e308 and signalling NaN: what is not finite is masked and counted, and needs no warning.
        with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
            return action()
    except MotesError:
        raise
    except OSError as error:
        raise FormatError(
            f"{path} cannot be read: {error.strerror or error}", "Check the path and its permissions"
        ) from error
    except MemoryError:
        raise FormatError(
            f"{path} needs more memory than there is", "Use a machine with more memory, or split the data"
        ) from None
