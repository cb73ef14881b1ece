"""The machine that figures are from, and the versions of what ran: for the top of the page."""

from __future__ import annotations

import os
import platform
import shutil
from importlib import metadata
from pathlib import Path

import motes

PACKAGES = ("numpy", "llvmlite", "scipy", "torch", "mitsuba", "drjit", "zarr", "dask")


def description() -> dict[str, str]:
    """What is worth knowing, by name; nothing that tells whose machine it is."""
    found = {
        "Processor": _processor(),
        "Processors": f"{os.cpu_count()} ({_usable()} for this process)",
        "Vectors": vectors(),
        "Caches": ", ".join(_caches()) or "unknown",
        "Memory": _memory(),
        "System": f"{platform.system()} {platform.release().split('-')[0]}, {platform.machine()}",
        "Python": f"{platform.python_version()} ({platform.python_implementation()})",
        "Motes": motes.__version__,
    }
    versions = {name: version(name) for name in PACKAGES}
    found["Packages"] = ", ".join(f"{name} {version}" for name, version in versions.items() if version)
    if missing := [name for name, version in versions.items() if not version]:
        found["Not installed"] = ", ".join(missing)
    if (gpu := gpu_name()) is not None:
        found["GPU"] = gpu
    return found


def load() -> float:
    """Processes that wait for a processor, averaged over the last minute; NaN where the system does not say."""
    return os.getloadavg()[0] if hasattr(os, "getloadavg") else float("nan")


def memory_available() -> int:
    """Bytes that could be used now."""
    text = _read("/proc/meminfo")
    for line in text.splitlines():
        if line.startswith("MemAvailable"):
            return int(line.split()[1]) * 1024
    return 4 * 2**30


def gpu_name() -> str | None:
    """The first CUDA device that PyTorch sees; it is not imported where no driver is."""
    if not (Path("/dev/nvidiactl").exists() or shutil.which("nvidia-smi")):
        return None
    try:
        import torch
    except ImportError:
        return None
    return str(torch.cuda.get_device_name(0)) if torch.cuda.is_available() else None


def _usable() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _processor() -> str:
    for line in _read("/proc/cpuinfo").splitlines():
        if line.startswith(("model name", "Model")):
            return " ".join(line.split(":", 1)[1].split())
    return platform.processor() or platform.machine()


def vectors() -> str:
    """The widest vector instructions that the system names."""
    flags = next(
        (line.split() for line in _read("/proc/cpuinfo").splitlines() if line.startswith(("flags", "Features"))), []
    )
    known = {"avx512f": "AVX-512", "avx2": "AVX2", "sse2": "SSE2", "sve": "SVE", "asimd": "NEON"}
    return next((name for flag, name in known.items() if flag in flags), "unknown")


def _caches() -> list[str]:
    found = []
    for folder in sorted(Path("/sys/devices/system/cpu/cpu0/cache").glob("index*")):
        level, kind, size = (_read(folder / name).strip() for name in ("level", "type", "size"))
        if size and kind != "Instruction":
            shared = _read(folder / "shared_cpu_list").strip()
            found.append(f"L{level} {size.replace('K', ' KiB')}{' shared' if shared not in ('', '0') else ''}")
    return found


def _memory() -> str:
    try:
        return f"{os.sysconf('SC_PAGE_SIZE') * os.sysconf('SC_PHYS_PAGES') / 2**30:.0f} GiB"
    except (AttributeError, ValueError, OSError):
        return "unknown"


def version(package: str) -> str:
    """Of an installed package; empty where it is not."""
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return ""


def _read(path: str | Path) -> str:
    try:
        return Path(path).read_text(encoding="utf-8")
    except OSError:
        return ""
