"""The same surface, and two of Mitsuba's, by other means than the engine: NumPy, PyTorch, Dr.Jit.

NumPy in blocks and PyTorch are handed the traced formula, where the channels share what does not depend on them: their best case.
"""

from __future__ import annotations

import functools
import itertools
import warnings
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes import Dust, DustLayer, MotesError, OrenNayar, TorranceSparrow, workers
from motes.arrays import NUMPY
from motes.directions import Geometry, Vector
from motes.graph import tracing
from motes.kernels import numpy as numpy_code
from motes.printing.printer import statements

SURFACE = DustLayer(
    OrenNayar(K_d=(0.8, 0.7, 0.6), sigma_d=0.4) + TorranceSparrow(K_s=0.3, sigma_s=0.15),
    Dust(w=(0.7, 0.6, 0.5), g=0.3),
    tau=0.2,
)
PARAMETERS = 11
BLOCKS = (2048, 8192, 32768)
Rows = NDArray[Any]


def directions(n: int, seed: int, scalar: type = np.float32) -> Rows:
    """Uniform over the upper hemisphere, as a (3, n) array."""
    rng = np.random.default_rng(seed)
    z, phi = rng.random(n, scalar), rng.random(n, scalar) * scalar(2 * np.pi)
    r = np.sqrt((1 - z) * (1 + z))
    return np.stack([r * np.cos(phi), r * np.sin(phi), z])


# ---------------------------------------------------------------- NumPy


def plain_numpy(wi: Rows, wo: Rows) -> Rows:
    """The equations as they stand, over whole arrays (N, 3)."""
    with np.errstate(all="ignore"):
        return SURFACE.value(NUMPY, Geometry(NUMPY, Vector.of(wi), Vector.of(wo)))


@functools.cache
def _formula(library: str) -> Callable[..., Any]:
    """The surface's three channels as a function of the six components of two directions, over a library's functions."""
    trace = tracing.trace(SURFACE, 3)
    names = dict(zip(trace.directions, ("ix", "iy", "iz", "ox", "oy", "oz"), strict=True))
    values = {slot.name: slot.value for slot in SURFACE.slots()}
    numbers = {f"p{k}": float(np.ravel(values[p.slot])[p.channel or 0]) for k, p in enumerate(trace.parameters)}
    given = names | {p.symbol: f"p{k}" for k, p in enumerate(trace.parameters)}
    body, results = statements(numpy_code.NUMPY, trace.outputs, given)
    source = numpy_code.function("formula", [*names.values(), *numbers], body, results)
    scope: dict[str, Any] = _torch_functions() if library == "torch" else {}
    if library == "numpy":
        scope = {name: getattr(np, name) for name in ("arcsin", "exp", "expm1", "maximum", "minimum", "sqrt", "where")}
    exec(compile(source, f"<the surface over {library}>", "exec"), scope)
    return functools.partial(scope["formula"], **numbers)


def numpy_blocks(wi: Rows, wo: Rows, out: Rows, block: int, first: int = 0, last: int | None = None) -> None:
    """Rows (3, N), in blocks that stay in the cache."""
    formula = _formula("numpy")
    end = out.shape[1] if last is None else last
    with np.errstate(all="ignore"):
        for k in range(first, end, block):
            part = slice(k, min(end, k + block))
            for row, channel in zip(out, formula(*wi[:, part], *wo[:, part]), strict=True):
                row[part] = channel


def numpy_blocks_on_all_cores(wi: Rows, wo: Rows, out: Rows, block: int, pool: ThreadPoolExecutor) -> None:
    """The same with a share of the directions for each core; NumPy's loops let other threads run."""
    edges = np.linspace(0, out.shape[1], cores() + 1).astype(int).tolist()
    for future in [pool.submit(numpy_blocks, wi, wo, out, block, a, b) for a, b in itertools.pairwise(edges)]:
        future.result()


def cores() -> int:
    """Processors that this process may use, as the engine counts them."""
    return workers.threads()


# ---------------------------------------------------------------- PyTorch


def _torch_functions() -> dict[str, Any]:
    import torch

    def pair(function: Any, number: Any) -> Any:
        """PyTorch's minimum and maximum take no numbers, clamp does."""
        return lambda a, b: (
            function(a, b) if isinstance(a, torch.Tensor) and isinstance(b, torch.Tensor)
            else torch.clamp(a, **{number: b}) if isinstance(a, torch.Tensor)
            else torch.clamp(b, **{number: a}) if isinstance(b, torch.Tensor)
            else (min if number == "max" else max)(a, b)
        )  # fmt: skip

    def of(function: Any, plain: Any) -> Any:
        return lambda x: function(x) if isinstance(x, torch.Tensor) else float(plain(x))

    return {
        "sqrt": of(torch.sqrt, np.sqrt), "exp": of(torch.exp, np.exp), "expm1": of(torch.expm1, np.expm1),
        "arcsin": of(torch.asin, np.arcsin),
        "where": lambda c, a, b: torch.where(c, a, b) if isinstance(c, torch.Tensor) else (a if c else b),
        "minimum": pair(torch.minimum, "max"), "maximum": pair(torch.maximum, "min"),
    }  # fmt: skip


def torch_compiled(wi: Rows, wo: Rows, device: str = "cpu") -> tuple[Callable[[], Any], Callable[[], Rows]]:
    """A call that evaluates with `torch.compile`, and one that gives its result (3, N).

    Raises
    ------
    MotesError
        Where PyTorch is missing or cannot compile here, with the reason.
    """
    try:
        import torch
    except ImportError:
        raise MotesError("PyTorch is not installed", "pip install torch") from None
    torch.set_num_threads(cores())
    formula = _formula("torch")
    inputs = [torch.from_numpy(np.ascontiguousarray(row)).to(device) for w in (wi, wo) for row in w]
    result: list[Any] = []

    def call() -> None:
        with torch.no_grad():
            result[:] = compiled(*inputs)
            if device == "cuda":
                torch.cuda.synchronize()

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what Inductor thinks of the machine
        compiled = torch.compile(formula, fullgraph=True, dynamic=False)
        try:
            call()
        except Exception as error:  # no compiler, an unsupported Python: it raises what it likes
            reason = (str(error).strip().splitlines() or [type(error).__name__])[0][:160]
            raise MotesError(f"torch.compile does not work here: {reason}") from None
    return call, lambda: np.stack([channel.cpu().numpy() for channel in result])


# ---------------------------------------------------------------- Mitsuba

CPU_VARIANT, GPU_VARIANT = "llvm_ad_rgb", "cuda_ad_rgb"


def mitsuba(variant: str = CPU_VARIANT) -> Any:
    """Mitsuba with a variant set.

    Raises
    ------
    MotesError
        Where it or the variant is missing or cannot run.
    """
    from motes.rendering import load_mitsuba

    mi = load_mitsuba(variant)
    import drjit as dr

    if variant == CPU_VARIANT:
        dr.set_thread_count(cores())
    return mi


def bsdfs(mi: Any) -> dict[str, Any]:
    """`roughplastic` and `principled` with about the surface's colours and widths, and the surface itself as Motes' plugin."""
    values = {slot.name: slot.value for slot in SURFACE.slots()}
    colour = _rgb(values["K_d"])
    own = {name: _rgb(value) if np.ndim(value) else float(value) for name, value in values.items()}
    described = {
        "roughplastic": {"type": "roughplastic", "distribution": "beckmann", "alpha": 0.15, "diffuse_reflectance": colour},
        "principled": {"type": "principled", "base_color": colour, "roughness": 0.4, "specular": 0.5},
        "motes_dusty": {"type": "motes_dusty", **own},
    }  # fmt: skip
    return {name: mi.load_dict(description) for name, description in described.items()}


def _rgb(color: Sequence[float] | NDArray[Any]) -> dict[str, Any]:
    return {"type": "rgb", "value": [float(c) for c in color]}


def wavefront(mi: Any, wi: Rows, wo: Rows) -> tuple[Any, Any]:
    """Directions (3, N) in Dr.Jit's memory: a surface interaction that holds the first, and the second."""
    import drjit as dr

    si = dr.zeros(mi.SurfaceInteraction3f, wi.shape[1])
    si.wi = mi.Vector3f(wi)
    other = mi.Vector3f(wo)
    dr.eval(si, other)
    dr.sync_thread()
    return si, other


def drjit_call(mi: Any, bsdf: Any, si: Any, wo: Any) -> Callable[[], Any]:
    """A call that evaluates a BSDF at a wavefront, to arrays in memory."""
    import drjit as dr

    context = mi.BSDFContext()

    def call() -> Any:
        value = bsdf.eval(context, si, wo)
        dr.eval(value)
        dr.sync_thread()
        return value

    return call


def skipped(name: str, error: MotesError) -> str:
    """The line that says what is left out."""
    return f"{name}: {error.message}"
