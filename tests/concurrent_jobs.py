"""What is done from many threads and processes at once: evaluate, fit, read every format, compile; and the bits that come of it.

``python concurrent_jobs.py HOW FOLDER`` prints a line of JSON: what the jobs gave serially, and each time that they were done again by HOW.
"""

from __future__ import annotations

import faulthandler
import hashlib
import json
import logging
import multiprocessing
import sys
import threading
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

TOOLS = Path(__file__).resolve().parents[1] / "tools"
sys.path[:0] = [str(TOOLS), str(Path(__file__).resolve().parent)]
THREADS, CHILDREN = 8, 2
PATIENCE = 400.0  # seconds, for all children together: a machine may be busy
#: Specimens that take long to make, or that are no files.
SLOW = ("model", "trend", "dust", "folder of a fit", "fitted map")


def written(folder: Path) -> tuple[list[tuple[str, Path]], list[str]]:
    """A specimen of each format that the fuzz harness knows, pictures of every kind: the name of the format and what to read.

    Then the formats left out, whose package is not installed: free-threaded Python has not all of them.
    """
    import fuzz_specimens

    import measurement_files as files

    found, left_out = [], []
    for name, make in fuzz_specimens.specimens().items():
        if name in SLOW:
            continue
        try:
            made = make() if name == "picture" else make()[:1]
        except ModuleNotFoundError as error:
            left_out.append(f"{name}: {error}")
            continue
        for k, (specimen, target) in enumerate(made):
            own = folder / f"{name}-{k}".replace(" ", "_").replace(":", "")
            files.write_all(own, specimen)
            found.append((name, own / target))
    return found, left_out


def reading(name: str, path: Path) -> Callable[[], bytes]:
    """Read a file, and say all that came out."""
    from motes import load, maps, meshes
    from motes.images import photograph, transfer_functions
    from motes.maps import lights
    from motes.measurements import read

    def work() -> bytes:
        if name == "picture":
            stated = transfer_functions.Transfer("linear") if path.suffix == ".tif" else None
            return photograph.open_photograph(path, stated).linear().tobytes()
        if name == "mesh":
            mesh = meshes.read_mesh(path)
            return mesh.positions.tobytes() + mesh.triangles.tobytes()
        if name == "material":
            return json.dumps(load(path).to_dict()).encode()
        if name == "reflectance map":
            return np.asarray(maps.open_map(path).read_block((0, 0))).tobytes()
        if name == "table of lights":
            return repr(lights.rows_of(path, path.parent)).encode()
        found = read(path, format=name.split()[0], **({"sample": 3} if name == "curet" else {}))
        numbers = [getattr(found, part, np.empty(0)) for part in ("values", "wi", "wo", "mask")]
        return json.dumps(found.summary()).encode() + b"".join(np.asarray(x).tobytes() for x in numbers)

    return work


def evaluating(text: str, single: bool) -> Callable[[], bytes]:
    """Through the compiled engine: enough directions for several chunks, with gradients."""
    from motes.kernels import engine
    from motes.models import parse

    model = parse(text).model
    rng = np.random.default_rng(7)
    wi, wo = (rng.normal(size=(40_000, 3)) for _ in range(2))
    wi, wo = (np.abs(w) / np.linalg.norm(w, axis=1, keepdims=True) for w in (wi, wo))
    if single:
        wi, wo = wi.astype(np.float32), wo.astype(np.float32)

    def work() -> bytes:
        values = engine.evaluate(model, wi, wo)
        return bytes(np.asarray(values).tobytes())

    return work


def fitting(path: Path) -> Callable[[], bytes]:
    import motes

    def work() -> bytes:
        fit = motes.fit(motes.read(path).at(0), model="oren_nayar")
        said = json.dumps(
            {name: [np.asarray(p.value).tolist(), np.asarray(p.stderr).tolist()] for name, p in fit.parameters.items()}
        )
        return said.encode()

    return work


def parsing() -> bytes:
    """Of a text that the parser of Python warns of."""
    from motes.models import describe, parse

    return describe(parse("dust_layer(oren_nayar(sigma_d=0.25) + torrance_sparrow, tau=0.5)").model).encode()


def jobs(folder: Path) -> dict[str, Callable[[], bytes]]:
    """The jobs by name; their files lie in a folder."""
    listing = folder / "files.json"
    if not folder.exists():
        files, left_out = written(folder)
        (folder / "left_out.json").write_text(json.dumps(left_out))
        listing.write_text(json.dumps([[name, str(path)] for name, path in files]))
    found = {f"read {path}": reading(name, Path(path)) for name, path in json.loads(listing.read_text())}
    table = next(path for name, path in json.loads(listing.read_text()) if name == "csv")
    found["fit"] = fitting(Path(table))
    found["parse"] = parsing
    for text, single in (("oren_nayar", False), ("oren_nayar + torrance_sparrow", True)):
        found[f"eval {text}"] = evaluating(text, single)
    return found


def done(work: dict[str, Callable[[], bytes]], first: int = 0) -> dict[str, str]:
    """Do all jobs, beginning with another one; what came of each, in short."""
    names = [*work][first:] + [*work][:first]
    said = {}
    for name in names:
        try:
            said[name] = hashlib.sha256(work[name]()).hexdigest()[:16]
        except Exception as error:
            said[name] = repr(error)[:300]
    return said


def in_threads(work: dict[str, Callable[[], bytes]]) -> list[dict[str, str]]:
    """All jobs from each of the threads, which begin at once, each with another job."""
    together = threading.Barrier(THREADS)
    said: list[dict[str, str]] = [{} for _ in range(THREADS)]

    def run(k: int) -> None:
        together.wait()
        said[k] = done(work, k * len(work) // THREADS)

    threads = [threading.Thread(target=run, args=(k,), daemon=True) for k in range(THREADS)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(PATIENCE)
    return [one if not thread.is_alive() else {"hangs": "yes"} for one, thread in zip(said, threads, strict=True)]


def compiled(work: dict[str, Callable[[], bytes]]) -> dict[str, Callable[[], bytes]]:
    """Those that compile."""
    return {name: each for name, each in work.items() if name.startswith("eval")}


def child(folder: Path, many: bool, answers: Any, k: int) -> None:
    """In a process of its own: the jobs; or those that compile from many threads."""
    faulthandler.dump_traceback_later(PATIENCE - 20, exit=True)
    work = compiled(jobs(folder)) if many else jobs(folder)
    for said in in_threads(work) if many else [done(work, k)]:
        answers.put(said)


def in_children(method: str, folder: Path, many: bool, count: int = CHILDREN) -> list[dict[str, str]]:
    """All jobs from each child, which begin one after another and work at once."""
    context = multiprocessing.get_context(method)
    answers = context.Queue()
    children = [context.Process(target=child, args=(folder, many, answers, k), daemon=True) for k in range(count)]
    for each in children:
        each.start()
    found = []
    try:
        for _ in range(count * (THREADS if many else 1)):
            found.append(answers.get(timeout=PATIENCE))
    except Exception as error:
        found.append({"hangs": repr(error)})
    for each in children:
        each.join(5)
        each.kill()
    return found


def main(how: str, folder: Path) -> None:
    warnings.filterwarnings("ignore", ".*fork", DeprecationWarning)
    said: list[str] = []
    handler = logging.Handler()
    handler.emit = lambda record: said.append(record.getMessage())  # type: ignore[method-assign]
    logging.getLogger("motes").addHandler(handler)
    logging.getLogger("motes").setLevel(logging.INFO)
    if how == "cold":  # nothing is compiled yet: two processes with all their threads at once
        work = compiled(jobs(folder))
        answers = [*in_children("spawn", folder, many=True, count=2)]
        serial = done(work)
        filters = list(warnings.filters)
    else:
        serial = done(jobs(folder))  # kernels, OpenImageIO, Zarr and the threads of all have been used
        filters = list(warnings.filters)
        if how == "threads":
            answers = in_threads(jobs(folder))
        elif how == "fork":  # while others are at work
            work, over = jobs(folder), threading.Event()

            def busy() -> None:
                while not over.is_set():
                    done(work)

            others = [threading.Thread(target=busy, daemon=True) for _ in range(2)]
            for other in others:
                other.start()
            answers = in_children("fork", folder, many=False)
            over.set()
            for other in others:
                other.join(PATIENCE)
        else:
            answers = in_children("spawn", folder, many=False)
    kept = list(warnings.filters) == filters
    left_out = json.loads((folder / "left_out.json").read_text())
    print(json.dumps({"serial": serial, "answers": answers, "filters kept": kept, "said": said, "left out": left_out}))


if __name__ == "__main__":
    faulthandler.enable()
    main(sys.argv[1], Path(sys.argv[2]))
