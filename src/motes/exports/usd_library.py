"""The package usd-core, where it is used."""

from __future__ import annotations

from typing import Any

from motes.errors import MissingExtraError

#: Of USD as text, in binary form (twice), and packed.
SUFFIXES = (".usda", ".usdc", ".usd", ".usdz")


def library() -> Any:
    """The modules of USD."""
    try:
        import pxr.Gf
        import pxr.Sdf
        import pxr.Usd
        import pxr.UsdGeom
        import pxr.UsdShade
        import pxr.UsdUtils
        import pxr.Vt
    except ImportError:
        raise MissingExtraError("usd-core", "usd", "writing USD") from None
    return pxr
