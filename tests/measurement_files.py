"""Small files of every format, written here from the descriptions of the formats and not by the readers' own code."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np


def curet_folder(folder: Path, values: dict[int, list[float]], angles: np.ndarray) -> Path:
    """`angles` (N, 4): theta_v, phi_v, theta_i, phi_i."""
    folder.mkdir(parents=True, exist_ok=True)
    rows = ["   ".join([str(sample), *(f"{v:.3f}" for v in row)]) for sample, row in values.items()]
    (folder / "abrdf.dat").write_text("\n".join(rows) + "\n")
    table = ["  ".join([f"{k}", *(f"{a:.6f}" for a in row)]) for k, row in enumerate(angles, 1)]
    (folder / "table.txt").write_text("\n".join(table) + "\n")
    return folder


def some_angles(n: int, seed: int = 1) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return np.stack(
        [rng.uniform(0.1, 1.4, n), rng.uniform(-3, 3, n), rng.uniform(0.1, 1.4, n), rng.uniform(-3, 3, n)], 1
    )


def curet_bytes() -> dict[str, bytes]:
    rng = np.random.default_rng(2)
    rows = [" ".join([str(s), *(f"{v:.3f}" for v in rng.uniform(0.1, 1, 12))]) for s in (3, 7)]
    table = [" ".join([str(k), *(f"{a:.5f}" for a in row)]) for k, row in enumerate(some_angles(12), 1)]
    return {"abrdf.dat": "\n".join(rows).encode() + b"\n", "table.txt": "\n".join(table).encode() + b"\n"}


def cornell_text(n_rows: int = 9, wavelengths: tuple[float, ...] = (400, 550, 700)) -> str:
    rng = np.random.default_rng(3)
    lines = ["# Cornell University, Program of Computer Graphics", "# Test Paint", "# num wls", str(len(wavelengths))]
    lines += ["# wls", " ".join(f"{w:g}" for w in wavelengths), "# theta i  phi i  theta s  phi_s  values"]
    for _ in range(n_rows):
        angles = [rng.uniform(0, 1.4), 0.0, rng.uniform(0, 1.4), rng.uniform(-np.pi, np.pi)]
        lines.append(" ".join(f"{x:.6f}" for x in [*angles, *rng.uniform(0, 1, len(wavelengths))]))
    return "\n".join(lines) + "\n"


def merl_bytes(n: int = 4, fill: float = 100.0) -> bytes:
    rng = np.random.default_rng(4)
    return struct.pack("<3i", n, n, 2 * n) + (fill * rng.uniform(0.5, 1, (3, n, n, 2 * n))).astype("<f8").tobytes()


def mbsdf_bytes(n_theta: int = 5, n_phi: int = 6, values: np.ndarray | None = None) -> bytes:
    if values is None:
        values = np.random.default_rng(5).uniform(0.01, 1, (n_theta, n_theta, n_phi, 3))
    head = b"NVIDIA ARC MBSDF V1\nMBSDF_DATA_REFLECTION=\n" + struct.pack("<3i", 1, n_theta, n_phi)
    return head + values.astype("<f4").tobytes()


def tensor_file(fields: dict[str, np.ndarray]) -> bytes:
    """A tensor file, arrays aligned to 8 bytes."""
    codes = {"u1": 1, "u4": 5, "f4": 10}
    length = 18 + sum(2 + len(name) + 11 + 8 * a.ndim for name, a in fields.items())
    head, body = b"tensor_file\0\x01\x00" + struct.pack("<I", len(fields)), b""
    for name, array in fields.items():
        body += b"\0" * (-(length + len(body)) % 8)
        offset = length + len(body)
        head += struct.pack("<H", len(name)) + name.encode()
        head += struct.pack("<HBQ", array.ndim, codes[array.dtype.str[1:]], offset)
        head += struct.pack(f"<{array.ndim}Q", *array.shape)
        body += array.tobytes()
    return head + body


def rgl_fields(n_phi: int = 1, n_theta: int = 4, size: int = 6, grid: int = 5, seed: int = 6) -> dict[str, np.ndarray]:
    """Positive random tensors; `n_phi` > 2 is anisotropic: phi_i over a quarter of the circle, two mirrors."""
    rng = np.random.default_rng(seed)

    def f4(*shape: int) -> np.ndarray:
        return rng.uniform(0.2, 1, shape).astype("<f4")

    phi_i = np.zeros(1) if n_phi == 1 else np.linspace(-np.pi, -np.pi / 2, n_phi)
    return {
        "description": np.frombuffer(b"a test material", "u1").copy(),
        "version": np.array([1, 0], "<u4"),
        "jacobian": np.array([1], "u1"),
        "phi_i": phi_i.astype("<f4"),
        "theta_i": (np.linspace(0, 1, n_theta) ** 0.7 * np.pi / 2).astype("<f4"),
        # neither knows the azimuth where the material is isotropic
        "ndf": np.tile(f4(1, 9), (2, 1)) if n_phi == 1 else f4(7, 9),
        "sigma": np.tile(f4(1, 8), (2, 1)) if n_phi == 1 else f4(7, 8),
        "vndf": f4(n_phi, n_theta, size, size + 1),
        "luminance": f4(n_phi, n_theta, grid, grid),
        "rgb": f4(n_phi, n_theta, 3, grid, grid),
    }


def rig(n_lights: int = 9) -> list[tuple[np.ndarray, np.ndarray]]:
    """(L, V) of the four cameras of the rig: a light arm in the plane of incidence, cameras in it at fixed angles."""
    arm = np.radians(np.linspace(-80, 80, n_lights))
    L = np.stack([np.sin(arm), 0 * arm, np.cos(arm)], 1)
    cameras = []
    for tilt in np.radians([0.0, 20.0, 45.0, 70.0]):
        v = [-np.sin(tilt), 0.0, np.cos(tilt)]
        cameras.append((L, np.broadcast_to(v, L.shape).copy()))
    return cameras


def tvbrdf_bytes(n_scans: int = 2, n_lights: int = 3) -> dict[str, bytes]:
    rng = np.random.default_rng(7)
    info = "plaster (drying)\nExposures 0.2 4.0 32.0\nNumber of scans: 2\nscan 01: 0 s\nscan 02: 36 s\n"
    files = {"tvBrdf-info.txt": info.encode()}
    for t in range(n_scans):
        for v, (L, V) in enumerate(rig(n_lights), 1):
            text = "Exposure 0.200000 4.000000 32.000000\n"
            for light, view in zip(L, V, strict=True):
                f = rng.uniform(0.1, 1, 3)
                for label, (a, b, c) in zip("FLV", (f, light, view), strict=True):
                    text += f"{label} {a:.6f} {b:.6f} {c:.6f}\n"
            files[f"tvBrdf-data/scan{t + 1:02d}_brdf_camera{v}_allexposures.txt"] = text.encode()
    return files


def csv_text() -> str:
    rng = np.random.default_rng(8)
    lines = ["# a test", "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,time_s,weight,R,G,B"]
    for time in (0, 60):
        for k in range(6):
            row = [10 * k, 0, 5 + 10 * k, 30 * k, time, 1 + k, *rng.uniform(0.1, 1, 3).round(4)]
            lines.append(",".join(f"{x:g}" for x in row))
    return "\n".join(lines) + "\n"


def alta_text() -> str:
    lines = ["# Disclaimer: a test", "#DIM 1 3", "#PARAM_IN  COS_TH", "#PARAM_OUT RGB_COLOR"]
    return "\n".join([*lines, *(f"{c:.4f}\t0.1\t0.2\t0.3\t" for c in np.linspace(1, 0.1, 7))]) + "\n"


def write_exr(path: Path, pixels: np.ndarray, dtype: type = np.float16) -> None:
    """R, G, B (y, x, 3)."""
    import OpenEXR

    header = {"compression": OpenEXR.PIZ_COMPRESSION, "type": OpenEXR.scanlineimage}
    channels = {c: np.ascontiguousarray(pixels[..., i].astype(dtype)) for i, c in enumerate("RGB")}
    OpenEXR.File(header, channels).write(str(path))


def staf_folder(folder: Path, coefficients: dict[str, np.ndarray]) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for name, maps in coefficients.items():
        for d, pixels in enumerate(maps):
            write_exr(folder / f"{name}-{d}.exr", pixels)
    return folder


def write_all(folder: Path, files: dict[str, bytes]) -> Path:
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    return folder
