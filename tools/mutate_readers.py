"""Give every reader damaged files, many of them, and write docs/fuzzing.md.

    python tools/mutate_readers.py --seconds 20 --output docs/fuzzing.md

Each reader of measurements, spreadsheets, pictures and meshes gets small valid specimens of its format, of which bytes are flipped,
cut out, doubled, inserted or replaced by what is nasty (huge counts, NaN, signs, brackets, entities); of measurements every tenth is
read with the format found from the content, the others by its name.  A reader runs in a process of its own whose address space may
grow by 64 MiB, 20 times the size of any specimen and more.  What is counted as a failure: an exception that is no
`MotesError`, an error without a hint, memory refused by the system, an input that takes longer than ten seconds, the end of the
process.
"""

from __future__ import annotations

import argparse
import io
import json
import logging
import multiprocessing
import platform
import resource
import shlex
import signal
import sys
import tempfile
import time
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "src"), str(ROOT / "tests")]

import format_files  # noqa: E402
import image_files  # noqa: E402
import measurement_files as files  # noqa: E402
from motes import meshes  # noqa: E402
from motes.errors import MotesError  # noqa: E402
from motes.images import library, photograph, transfer_functions  # noqa: E402
from motes.measurements import READERS, Measurement, list_samples, read  # noqa: E402

GROWTH = 64 * 2**20
SECONDS = 10
NASTY = [
    b"\xff" * 8,
    b"\0" * 8,
    b"nan ",
    b"inf",
    b"1e308 ",
    b"-1",
    b"-",
    b"\n",
    b"9" * 12,
    b"{" * 40,
    b"[" * 80,
    b"<a>" * 70,
]
NASTY += [
    b"<!DOCTYPE x [<!ENTITY a 'b'>]>",
    b"&a;",
    b"null",
    b'"',
    b"\xef\xbb\xbf",
    b"\xfe\xff",
    b"#",
    b",,",
    b"2147483647 ",
    b"\x7f" * 4,
]
Specimen = dict[str, bytes]


def exr_folder(make: Callable[[Path], object]) -> Specimen:
    with tempfile.TemporaryDirectory() as folder:
        make(Path(folder))
        return {str(f.relative_to(folder)): f.read_bytes() for f in sorted(Path(folder).rglob("*")) if f.is_file()}


def staf(folder: Path) -> None:
    rng = np.random.default_rng(1)
    names = ("Diffuse", "Specular", "Roughness")
    files.staf_folder(folder, {name: rng.uniform(0, 1, (2, 4, 5, 1)).repeat(3, axis=3) for name in names})


def one(*texts: str | bytes) -> list[tuple[Specimen, str]]:
    return [({"a": t.encode() if isinstance(t, str) else t}, "a") for t in texts]


def specimens() -> dict[str, list[tuple[Specimen, str]]]:
    """Reader -> its specimens: the files, and the one to read, "" for the folder."""
    f32: Callable[[Path, np.ndarray], None] = lambda path, pixels: files.write_exr(path, pixels, np.float32)  # noqa: E731
    return {
        "rgl": one(files.tensor_file(files.rgl_fields())),
        "utia": [({"m001_a.bin": format_files.utia_bytes()}, "m001_a.bin")],
        "mbsdf": one(files.mbsdf_bytes()),
        "merl-slice": one(files.alta_text()),
        "merl": one(files.merl_bytes()),
        "tvbrdf": [(files.tvbrdf_bytes(), "")],
        "native-staf": [(exr_folder(lambda folder: format_files.native_staf_folder(folder, f32, times=2)), "")],
        "staf": [(exr_folder(staf), "")],
        "curet": [(files.curet_bytes(), "")],
        "bird": one(format_files.bird_json()),
        "openmaterial": one(format_files.xompt_json()),
        "bsdf-xml": one(format_files.klems_xml(), format_files.tree_xml(), format_files.tree_xml(d=4)),
        "zemax": one(
            format_files.zemax_text(), format_files.zemax_text(names=("TristimulusX", "TristimulusY", "TristimulusZ"))
        ),
        "lighttools": one(format_files.lighttools_text()),
        "astm": one(format_files.astm_text(), format_files.astm_text(degrees=True, phi_i=None)),
        "pab-opto": one(format_files.pab_text(30, 0, step=30), format_files.pab_text(30, 0, step=30, dsf=True)),
        "cornell": one(files.cornell_text()),
        "csv": one(files.csv_text()),
        "csv in a spreadsheet": [({"a.xlsx": spreadsheet()}, "a.xlsx")],
        "picture": [
            (exr_folder(lambda folder: exr(folder / "a.exr")), "a.exr"),
            *(({name: pixels}, name) for name, pixels in pictures().items()),
        ],
        "mesh": [({name: data}, name) for name, data in solids().items()],
    }


def spreadsheet() -> bytes:
    """The table of the tests by openpyxl."""
    import openpyxl

    book, made = openpyxl.Workbook(), io.BytesIO()
    for line in files.csv_text().splitlines():
        book.active.append([float(c) if c.lstrip("-")[:1].isdigit() else c for c in line.split(",")])
    book.save(made)
    return made.getvalue()


def exr(path: Path) -> None:
    rng = np.random.default_rng(1)
    image_files.write_exr(path, {name: rng.uniform(0, 1, (5, 7)).astype(np.float16) for name in "RGBA"})


def pictures() -> Specimen:
    """PNG by the book; TIFF and JPEG by OpenImageIO."""
    rng = np.random.default_rng(1)
    codes = rng.integers(0, 255, (5, 7, 3), np.uint8)
    found = {
        "8.png": image_files.png_bytes(codes, [0, 1, 2, 3, 4]),
        "16.png": image_files.png_bytes(codes.astype(np.uint16) * 257, [4], chunks=((b"gAMA", b"\0\1\x86\xa0"),)),
    }
    with tempfile.TemporaryDirectory() as folder:
        for name in ("a.tif", "a.jpg"):
            oiio = library.oiio("Writing pictures")
            facts = oiio.ImageSpec(7, 5, 3, "uint8")
            facts.attribute("Exif:ColorSpace", 1)
            out = oiio.ImageOutput.create(name)
            assert out.open(str(Path(folder) / name), facts), oiio.geterror()
            assert out.write_image(codes)
            out.close()
            found[name] = (Path(folder) / name).read_bytes()
    return found


def solids() -> Specimen:
    """A sphere in all the formats of meshes, PLY by Motes, the others by trimesh."""
    import trimesh

    ball = trimesh.creation.icosphere(1)
    mesh = meshes.Mesh(ball.vertices, ball.faces.astype(np.int32))
    with tempfile.TemporaryDirectory() as folder:
        binary = meshes.write_ply(Path(folder) / "a.ply", mesh).read_bytes()
    made = {kind: ball.export(file_type=kind) for kind in ("obj", "stl", "stl_ascii", "glb")}
    made = {kind: text.encode() if isinstance(text, str) else text for kind, text in made.items()}
    text = trimesh.exchange.ply.export_ply(ball, encoding="ascii")
    text_stl = {"text.stl": made.pop("stl_ascii")}
    return {"a.ply": binary, "text.ply": text, **text_stl, **{f"a.{kind}": data for kind, data in made.items()}}


def damaged(data: bytes, rng: np.random.Generator) -> bytes:
    """One change or a few."""
    for _ in range(int(rng.geometric(0.6))):
        at = int(rng.integers(0, len(data) + 1))
        kind = int(rng.integers(0, 8))
        piece = NASTY[int(rng.integers(len(NASTY)))] if rng.random() < 0.5 else rng.bytes(int(rng.integers(1, 17)))
        if kind == 0:
            data = data[:at]
        elif kind == 1:
            data = data[:at] + piece + data[at:]
        elif kind == 2:
            data = data[:at] + data[at + int(rng.integers(1, 200)) :]
        elif kind == 3:
            end = at + int(rng.integers(1, 400))
            data = data[:end] + data[at:end] + data[end:]
        elif kind == 4 and data[at : at + 1].isdigit():
            data = data[:at] + b"%d" % rng.integers(0, 10**9) + data[at + 1 :]
        elif kind == 5 and at < len(data):
            data = data[:at] + bytes([data[at] ^ (1 << int(rng.integers(8)))]) + data[at + 1 :]
        else:
            data = data[:at] + piece + data[at + len(piece) :]
    return data


class Slow(Exception):
    """An input that takes too long."""


@contextmanager
def limited() -> Iterator[None]:
    def ring(*_: object) -> None:
        raise Slow

    signal.signal(signal.SIGALRM, ring)
    signal.alarm(SECONDS)
    try:
        yield
    finally:
        signal.alarm(0)


def measurement(path: Path, name: str, by_name: bool) -> str:
    options = {"format": name.split()[0]} if by_name else {}
    sample = {"sample": 3} if name == "curet" else {}
    found = read(path, **options, **sample)
    json.dumps(found.summary(), allow_nan=False)
    if isinstance(found, Measurement) and sum(found.masked.values()) != np.count_nonzero(~found.mask):
        return "counts of masked samples do not add up"
    list_samples(path, **options)
    return "read"


def picture(path: Path, _name: str, _by_name: bool) -> str:
    stated = transfer_functions.Transfer("linear") if path.suffix == ".tif" else None
    values = photograph.open_photograph(path, stated).linear()
    return "read" if values.ndim == 3 and not np.isinf(values).any() else "not an array of numbers"


def mesh(path: Path, _name: str, _by_name: bool) -> str:
    found = meshes.read_mesh(path)
    bad = not np.isfinite(found.positions).all() or found.triangles.max() >= len(found.positions)
    return "positions or triangles that are none" if bad or found.triangles.min() < 0 else "read"


#: The readers that are none of measurements.
OTHERS: dict[str, Callable[[Path, str, bool], str]] = {"picture": picture, "mesh": mesh}


def attempt(path: Path, name: str, by_name: bool) -> str:
    """What became of one input: "read", "refused", or what went wrong."""
    try:
        with limited():
            return OTHERS.get(name, measurement)(path, name, by_name)
    except MotesError as error:
        if "more memory than there is" in error.message:
            return "memory"
        return "refused" if error.message and error.hint else f"no hint: {error.message[:80]}"
    except Slow:
        return f"longer than {SECONDS} s"
    except MemoryError:
        return "memory"
    except Exception as error:
        return f"{type(error).__name__}: {str(error)[:80]}"


def work(name: str, count: int, seconds: float, seed: int, pipe: multiprocessing.connection.Connection) -> None:
    warnings.simplefilter("error")
    logging.disable()  # of libraries: what is raised is what counts
    rng = np.random.default_rng(seed)
    found = specimens()[name]
    outcomes: Counter[str] = Counter()
    slowest, examples = 0.0, {}
    with tempfile.TemporaryDirectory(dir="/dev/shm" if Path("/dev/shm").is_dir() else None) as scratch:
        folder = Path(scratch) / "specimen"
        for specimen, target in found:  # everything is loaded before the limit is set
            files.write_all(folder, specimen)
            assert attempt(folder / target, name, True) == "read"
        size = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (size + GROWTH, size + GROWTH))
        end = time.monotonic() + seconds
        for n in range(count):
            if time.monotonic() > end:
                break
            specimen, target = found[n % len(found)]
            files.write_all(folder, specimen)
            victim = sorted(specimen)[int(rng.integers(len(specimen)))]
            (folder / victim).write_bytes(damaged(specimen[victim], rng))
            start = time.perf_counter()
            outcome = attempt(folder / target, name, n % 10 != 0)
            slowest = max(slowest, time.perf_counter() - start)
            outcomes[outcome] += 1
            if outcome not in ("read", "refused"):
                examples.setdefault(outcome, (folder / victim).read_bytes()[:2000].hex())
            if n % 50 == 0:
                pipe.send((dict(outcomes), slowest, examples))
    pipe.send((dict(outcomes), slowest, examples))


def run(name: str, count: int, seconds: float, seed: int) -> tuple[dict[str, int], float, dict[str, str]]:
    ours, theirs = multiprocessing.Pipe(duplex=False)
    process = multiprocessing.get_context("fork").Process(target=work, args=(name, count, seconds, seed, theirs))
    process.start()
    theirs.close()
    last: tuple[dict[str, int], float, dict[str, str]] = ({}, 0.0, {})
    try:
        while True:
            last = ours.recv()
    except EOFError:
        pass
    process.join()
    if process.exitcode != 0:
        last[0][f"the process ended with {process.exitcode}"] = 1
    return last


def page(results: dict[str, tuple[dict[str, int], float, dict[str, str]]]) -> str:
    total = sum(sum(outcomes.values()) for outcomes, _, _ in results.values())
    lines = [
        "# Damaged files",
        "",
        "Every reader is given damaged files: bytes of small valid specimens flipped, cut, doubled, inserted, or replaced by huge counts, NaN, brackets,",
        "entities. It must read them or refuse them with a sentence and a hint, within ten seconds and 64 MiB of memory, and nothing else.",
        f"`python {shlex.join(['tools/mutate_readers.py', *sys.argv[1:]])}` made this page; the test suite runs a few thousand of the same kind.",
        "",
        f"{total:,} inputs, {time.strftime('%Y-%m-%d')}, Python {platform.python_version()}, NumPy {np.__version__}.",
        "",
        "| reader | inputs | read | refused | failed | slowest [s] |",
        "|---|---|---|---|---|---|",
    ]
    failures = []
    for name, (outcomes, slowest, _) in results.items():
        bad = {k: n for k, n in outcomes.items() if k not in ("read", "refused")}
        n = sum(outcomes.values())
        lines.append(
            f"| `{name}` | {n:,} | {outcomes.get('read', 0):,} | {outcomes.get('refused', 0):,} | {sum(bad.values()):,} | {slowest:.2f} |"
        )
        failures += [f"- `{name}`: {what} ({count:,})" for what, count in sorted(bad.items())]
    lines += ["", "Where fewer inputs are shown than for other readers, the time given to each ran out.", ""]
    lines += [
        "`picture` is OpenEXR, PNG, TIFF and JPEG; `mesh` is PLY, OBJ, STL (binary and text) and glTF. TIFF and OpenEXR hold no checksums,",
        "so that flipped pixels are read.",
        "",
    ]
    lines += ["What failed:", "", *failures] if failures else ["Nothing failed."]
    return "\n".join(lines) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=100_000, help="inputs for each reader")
    parser.add_argument("--seconds", type=float, default=600, help="at most, for each reader")
    parser.add_argument("--readers", nargs="*", default=None, help="some of them; all by default")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--output", type=Path, default=None, help="such as docs/fuzzing.md; printed only by default")
    parser.add_argument("--examples", type=Path, default=None, help="a JSON file for the first input of each failure")
    given = parser.parse_args()
    names = list(specimens())
    assert set(READERS) <= set(names), set(READERS) - set(names)
    results: dict[str, tuple[dict[str, int], float, dict[str, str]]] = {}
    for name in given.readers or names:
        outcomes, slowest, examples = run(name, given.count, given.seconds, given.seed)
        print(name, outcomes, f"{slowest:.2f} s", flush=True)
        results[name] = (outcomes, slowest, examples)
        if given.examples:
            given.examples.write_text(json.dumps({k: v[2] for k, v in results.items() if v[2]}, indent=1))
        if given.output:
            given.output.write_text(page(results), encoding="utf-8")
    if not given.output:
        print(page(results))


if __name__ == "__main__":
    main()
