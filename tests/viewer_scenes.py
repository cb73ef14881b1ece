"""Files for the viewer's scene, written here byte by byte: dusty meshes, meshes with coloured faces, skies."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray


def dusty_square(tau: float = 0.8) -> str:
    """A level square of four vertices as PLY, z up, with dust that grows from 0 to `tau` along x."""
    head = "ply\nformat ascii 1.0\nelement vertex 4\n" + "".join(
        f"property float {n}\n" for n in ("x", "y", "z", "tau")
    )
    head += "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    corners = ((-1, -1, 0), (1, -1, tau), (1, 1, tau), (-1, 1, 0))
    return head + "".join(f"{x} {y} 0 {t}\n" for x, y, t in corners) + "4 0 1 2 3\n"


def coloured_faces(texture: bool = False) -> str:
    """A roof of two triangles that share an edge, each face with a colour, or with places in a texture, of its own."""
    head = "ply\nformat ascii 1.0\nelement vertex 4\n" + "".join(f"property float {n}\n" for n in ("x", "y", "z"))
    head += "element face 2\nproperty list uchar int vertex_indices\n"
    own = (
        "property list uchar float texcoord\n"
        if texture
        else "".join(f"property uchar {n}\n" for n in ("red", "green", "blue"))
    )
    rows = ("6 0 0 1 0 1 1", "6 0 0 1 1 0 1") if texture else ("255 0 0", "0 255 0")
    points = ((-1, 0, 0), (0, 0.5, -1), (0, 0.5, 1), (1, 0, 0))
    faces = ((0, 2, 1), (1, 2, 3))
    text = head + own + "end_header\n" + "".join(f"{x} {y} {z}\n" for x, y, z in points)
    return text + "".join(f"3 {a} {b} {c} {row}\n" for (a, b, c), row in zip(faces, rows, strict=True))


def panorama(height: int = 128) -> NDArray[np.float64]:
    """A sky (H, 2 H, 3): red above, blue below, ten times as bright in a patch to the right (+x) of who looks along -z."""
    picture = np.zeros((height, 2 * height, 3))
    picture[: height // 2, :, 0] = 0.5
    picture[height // 2 :, :, 2] = 0.25
    middle = slice(int(0.7 * 2 * height), int(0.8 * 2 * height))
    picture[int(0.45 * height) : height // 2, middle, 0] = 5.0
    return picture


def radiance_hdr(picture: NDArray[Any]) -> bytes:
    """A picture as Radiance HDR, pixels one by one: the mantissas of eight bits under a common exponent."""
    brightest = picture.max(-1)
    mantissa, exponent = np.frexp(brightest)
    scale = np.where(brightest > 1e-32, mantissa * 256 / np.where(brightest > 0, brightest, 1), 0)
    rgbe = np.zeros((*picture.shape[:2], 4), np.uint8)
    rgbe[..., :3] = np.floor(picture * scale[..., None])
    rgbe[..., 3] = np.where(brightest > 1e-32, exponent + 128, 0)
    height, width = brightest.shape
    return f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode() + rgbe.tobytes()
