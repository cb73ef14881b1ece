"""A measurement as a dataset of xarray."""

from __future__ import annotations

from typing import Any

from motes.errors import MissingExtraError


def dataset(data: Any) -> Any:
    """An `xarray.Dataset` of a measurement: what `Measurement.to_xarray` returns."""
    try:
        import xarray
    except ImportError:
        raise MissingExtraError("xarray", "xarray", "Measurement.to_xarray") from None
    dataset = xarray.Dataset(
        {
            "f_r": (
                ("time", "direction", "channel"),
                data.values,
                {"units": "1/sr", "long_name": "BRDF without the cosine"},
            ),
            "mask": (("time", "direction", "channel"), data.mask, {"long_name": "usable"}),
            "weight": (("direction",), data.weights, {"long_name": "relative solid angle"}),
            "wi": (("direction", "xyz"), data.wi, {"long_name": "to the light"}),
            "wo": (("direction", "xyz"), data.wo, {"long_name": "to the viewer"}),
        },
        coords={
            "time": ("time", data.times, {"units": data.time_unit}),
            "channel": list(data.channels),
            "xyz": ["x", "y", "z"],
        },
        attrs={
            "name": data.name,
            "format": str(data.provenance.get("format", "")),
            "notes": "; ".join(data.provenance.get("notes", ())),
        },
    )
    if data.uncertainties is not None:
        about = {"units": "1/sr", "long_name": "standard uncertainty of f_r"}
        dataset = dataset.assign(f_r_uncertainty=(("time", "direction", "channel"), data.uncertainties, about))
    if data.common_uncertainty is not None:
        dataset.attrs["common_uncertainty"] = data.common_uncertainty
    if data.wavelengths is not None:
        dataset = dataset.assign_coords(wavelength=("channel", data.wavelengths, {"units": "nm"}))
    return dataset
