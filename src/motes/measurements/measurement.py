"""`Measurement`: reflectance measured at pairs of directions, at one time or many, with what is known about it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Self, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import directions
from motes.errors import DataError
from motes.measurements import _xarray, policy
from motes.measurements._facts import counted, extent, plain, uncertainty_facts
from motes.measurements._given import broadcast_mask, channel_names, deviations, numbers, samples, share, some


@final
@dataclass(frozen=True, eq=False)
class Measurement:
    """Measured reflectance: T times, N pairs of directions, C channels.  Immutable; its arrays are read-only.

    Make one with `motes.read` or `Measurement.from_arrays`, which apply the policy for invalid data of
    `motes.measurements.policy`.

    Parameters
    ----------
    wi, wo
        Unit vectors (N, 3) to the light and to the viewer, away from the surface, z = normal.
    values
        BRDF f_r [1/sr] without the cosine, (T, N, C), as read: also where it is masked.  NaN where there is no value.
    times
        (T,), strictly increasing, in `time_unit`; ``(0.,)`` for a measurement of one time.
    channels
        Names: ``"grey"``; ``"R", "G", "B"``; ``"400 nm"``, ...
    mask
        (T, N, C), True where the sample is usable.
    weights
        (N,), proportional to the solid angles d omega_i d omega_o that a sample stands for; ones where the format has
        none.  Only their ratios mean anything.
    masked
        Reason -> number of samples masked for it; the counts add up to the masked samples.
    provenance
        ``format, path, sample, name, source, notes``: where the numbers come from, what is known of their scale, what
        the reader did.
    time_unit
        ``"h"``, or ``"scan"`` where only the order is known.
    wavelengths
        (C,) [nm], or None.
    uncertainties
        (T, N, C), one standard deviation of the noise of each sample [1/sr], independent from sample to sample; NaN where
        it is not known; None where none is.
    common_uncertainty
        One standard deviation of an error of scale that all samples share, relative (0.02 is 2 %): of the lamp, of the
        standard that it was calibrated with.  None where it is not known.
    """

    wi: NDArray[np.float64]
    wo: NDArray[np.float64]
    values: NDArray[np.float64]
    times: NDArray[np.float64]
    channels: tuple[str, ...]
    mask: NDArray[np.bool_]
    weights: NDArray[np.float64]
    masked: Mapping[str, int]
    provenance: Mapping[str, Any]
    time_unit: str = "h"
    wavelengths: NDArray[np.float64] | None = None
    uncertainties: NDArray[np.float64] | None = None
    common_uncertainty: float | None = None
    # Why each sample is masked (see `policy.judge`): what lets a selection count its own masked samples.
    _codes: NDArray[np.uint8] | None = field(default=None, repr=False)
    _reasons: tuple[str, ...] = field(default=(), repr=False)

    def __post_init__(self) -> None:
        for name in ("wi", "wo", "values", "times", "mask", "weights", "wavelengths", "uncertainties", "_codes"):
            array = getattr(self, name)
            if array is None or (type(array) is np.ndarray and not array.flags.writeable):
                continue  # parts of a measurement share its directions, by which what is known of them is found again
            array = np.asarray(array).view()
            array.setflags(write=False)
            object.__setattr__(self, name, array)

    @classmethod
    def from_arrays(
        cls,
        wi: ArrayLike,
        wo: ArrayLike,
        values: ArrayLike,
        *,
        times: ArrayLike | None = None,
        channels: Sequence[str] | None = None,
        wavelengths: ArrayLike | None = None,
        weights: ArrayLike | None = None,
        mask: ArrayLike | None = None,
        provenance: Mapping[str, Any] | None = None,
        time_unit: str = "h",
        reasons: Mapping[str, ArrayLike] | None = None,
        uncertainties: ArrayLike | None = None,
        common_uncertainty: float | None = None,
    ) -> Measurement:
        """A measurement from arrays, checked, with invalid samples masked and counted.

        Parameters
        ----------
        wi, wo
            (N, 3); lengths within 0.001 of 1 are normalised, others are an error.
        values
            f_r [1/sr]: (N,), (N, C) or (T, N, C).
        times
            (T,), strictly increasing; the default is 0 for one time and 0, 1, 2, ... with the unit ``"scan"`` for
            several.
        channels
            C names; the default is the wavelengths, ``grey`` for one channel, ``R, G, B`` for three.
        wavelengths, weights
            (C,) [nm] and (N,).
        mask
            Broadcastable to (T, N, C), True where the sample is usable; the others count as "excluded by the caller".
        provenance
            See the class.
        reasons
            Reason -> boolean array broadcastable to (T, N, C), True where a sample is to be masked for this reason;
            these come before the general rules.
        uncertainties
            One standard deviation a sample [1/sr], broadcastable to the shape of `values`; NaN where it is not known.
            For relative ones give ``0.02 * np.abs(values)``.
        common_uncertainty
            That of a scale that all samples share, relative.

        Raises
        ------
        DataError
            For shapes that do not fit, directions that are not unit vectors, times that do not increase, uncertainties
            that are not above 0.

        Examples
        --------
        >>> from motes.directions import from_spherical
        >>> m = Measurement.from_arrays(from_spherical([0.1, 0.2], 0), from_spherical([0.3, 0.4], 1), [0.25, float("nan")])
        >>> m.mask.ravel().tolist(), dict(m.masked)
        ([True, False], {'not a finite number': 1})
        """
        wi, wo = policy.unit_directions(wi, "wi"), policy.unit_directions(wo, "wo")
        if len(wi) != len(wo):
            raise DataError(f"wi has {len(wi)} rows and wo {len(wo)}", "Give one pair of directions a sample")
        values = samples(numbers(values, "values"))
        if values.ndim != 3 or values.shape[1] != len(wi) or 0 in values.shape:
            raise DataError(
                f"values has shape {values.shape}, which is not (T, N, C) for N = {len(wi)} directions",
                "Give (N,), (N, C) or (T, N, C)",
            )
        n_times, n_directions, n_channels = values.shape
        if times is None:
            times, time_unit = np.arange(float(n_times)), time_unit if n_times == 1 else "scan"
        times = numbers(times, "times").reshape(-1)
        if len(times) != n_times or not np.all(np.isfinite(times)) or np.any(np.diff(times) <= 0):
            raise DataError(
                f"times has {len(times)} entries for {n_times} scans, or does not increase: {some(times)}",
                "Give one time a scan, in order",
            )
        if wavelengths is not None:
            wavelengths = numbers(wavelengths, "wavelengths").reshape(-1)
            if len(wavelengths) != n_channels or not np.all(np.isfinite(wavelengths) & (wavelengths > 0)):
                raise DataError(
                    f"wavelengths are {some(wavelengths)} for {n_channels} channels",
                    "Give one positive number [nm] a channel",
                )
        if weights is None:
            weights = np.ones(n_directions)
        weights = numbers(weights, "weights").reshape(-1)
        if len(weights) != n_directions or not np.all(np.isfinite(weights) & (weights >= 0)) or not np.any(weights > 0):
            raise DataError(
                f"weights are {some(weights)} for {n_directions} directions",
                "Give one number >= 0 a direction, at least one positive",
            )
        spread = None if uncertainties is None else deviations(uncertainties, values)
        channels = channel_names(channels, wavelengths, n_channels)
        codes, names = policy.judge(wi, wo, values, broadcast_mask(mask, values.shape), reasons, spread, channels)
        return cls(
            wi=wi,
            wo=wo,
            values=values,
            times=times,
            channels=channels,
            mask=codes == 0,
            weights=weights,
            masked=counted(codes, names),
            provenance=dict(provenance or {}),
            time_unit=time_unit,
            wavelengths=wavelengths,
            uncertainties=spread,
            common_uncertainty=None if common_uncertainty is None else share(common_uncertainty),
            _codes=codes,
            _reasons=names,
        )

    @property
    def n_times(self) -> int:
        return int(self.values.shape[0])

    @property
    def n_directions(self) -> int:
        return int(self.values.shape[1])

    @property
    def n_channels(self) -> int:
        return int(self.values.shape[2])

    @property
    def name(self) -> str:
        """The material's name, for people."""
        return str(self.provenance.get("name") or "measurement")

    @property
    def theta_i(self) -> NDArray[np.float64]:
        """Polar angles (N,) of ``wi`` [rad]."""
        return directions.theta(self.wi)

    @property
    def theta_r(self) -> NDArray[np.float64]:
        """Polar angles (N,) of ``wo`` [rad]."""
        return directions.theta(self.wo)

    @property
    def dphi(self) -> NDArray[np.float64]:
        """phi_r - phi_i (N,) [rad] in (-pi, pi]: 0 is backscatter, pi the specular side; 0 at normal incidence."""
        (xi, yi), (xo, yo) = self.wi.T[:2], self.wo.T[:2]
        return np.asarray(np.arctan2(xi * yo - yi * xo, xi * xo + yi * yo))

    def at(self, index: int) -> Self:
        """The measurement of one time, by its index; negative ones count from the end."""
        if not -self.n_times <= index < self.n_times:
            raise DataError(
                f"There is no time {index} among {self.n_times}", f"Give an index from 0 to {self.n_times - 1}"
            )
        one = slice(index % self.n_times, index % self.n_times + 1)
        return self._part(
            values=self.values[one],
            mask=self.mask[one],
            times=self.times[one],
            uncertainties=None if self.uncertainties is None else self.uncertainties[one],
            _codes=None if self._codes is None else self._codes[one],
        )

    def select(self, which: ArrayLike) -> Self:
        """The measurement at some of the directions.

        Parameters
        ----------
        which
            A boolean array (N,), or indices, in the order wanted.
        """
        which = np.asarray(which)
        if which.dtype == bool and which.shape != (self.n_directions,):
            raise DataError(
                f"The selection has shape {which.shape}",
                f"Give a boolean for each of the {self.n_directions} directions",
            )
        indices = np.flatnonzero(which) if which.dtype == bool else which.reshape(-1)
        if len(indices) == 0:
            raise DataError("The selection holds no direction", "Select at least one")
        if indices.dtype.kind not in "iu" or indices.min() < -self.n_directions or indices.max() >= self.n_directions:
            raise DataError(
                f"The selection {some(indices)} is not among the directions",
                f"Give integers from 0 to {self.n_directions - 1}",
            )
        return self._part(
            wi=self.wi[indices],
            wo=self.wo[indices],
            weights=self.weights[indices],
            values=self.values[:, indices],
            mask=self.mask[:, indices],
            uncertainties=None if self.uncertainties is None else self.uncertainties[:, indices],
            _codes=None if self._codes is None else self._codes[:, indices],
        )

    def with_uncertainties(
        self, uncertainties: ArrayLike | None = None, *, relative: float | None = None, common: float | None = None
    ) -> Self:
        """The same measurement with uncertainties; what is not given stays.

        Parameters
        ----------
        uncertainties
            One standard deviation a sample [1/sr], broadcastable to (T, N, C).
        relative
            The same as a share of each value: 0.02 is 2 %.
        common
            That of a scale that all samples share, relative.
        """
        if relative is not None:
            if uncertainties is not None or not 0 < relative < 1:
                raise DataError(
                    f"relative uncertainty {relative:g}: outside (0, 1), or beside absolute ones",
                    "0.02 is 2 % of each value",
                )
            absolute = relative * np.abs(self.values)
            uncertainties = np.where(absolute > 0, absolute, np.nan)
        return replace(
            self,
            uncertainties=self.uncertainties if uncertainties is None else deviations(uncertainties, self.values),
            common_uncertainty=self.common_uncertainty if common is None else share(common),
        )

    def rescaled(self, scale: float, stderr: float | None = None) -> Self:
        """The same measurement with its values divided by a scale, which its provenance says (that of all such calls together).

        Parameters
        ----------
        scale
            What the values are to be divided by, above 0: 1 where they are a BRDF in 1/sr.
        stderr
            One standard error of it, where it was fitted.
        """
        if not (np.isfinite(scale) and scale > 0):
            raise DataError(f"scale = {scale:g} is not above 0", "It is what the values are divided by")
        before = float(self.provenance.get("scale", 1.0))
        said: dict[str, Any] = {"scale": before * scale}
        if stderr is not None:
            said["scale_stderr"] = before * stderr
        return replace(
            self,
            values=self.values / scale,
            uncertainties=None if self.uncertainties is None else self.uncertainties / scale,
            provenance={**self.provenance, **said},
        )

    def with_mask(self, extra_mask: ArrayLike, reason: str) -> Self:
        """The same measurement with more samples masked.

        Parameters
        ----------
        extra_mask
            Broadcastable to (T, N, C); as in `mask`, True where a sample stays usable.
        reason
            What `masked` shall say of those that it takes out.
        """
        extra = broadcast_mask(extra_mask, self.values.shape)
        assert extra is not None
        codes, names = self._known_codes()
        names = names if reason in names else (*names, reason)
        codes = np.where(self.mask & ~extra, np.uint8(names.index(reason) + 1), codes)
        return replace(self, mask=self.mask & extra, masked=counted(codes, names), _codes=codes, _reasons=names)

    def to_xarray(self) -> Any:
        """An `xarray.Dataset` with the dimensions time, direction, channel (and xyz for the vectors)."""
        return _xarray.dataset(self)

    def summary(self) -> dict[str, Any]:
        """What ``motes info`` prints: sizes, ranges, what was masked and why, provenance.  Plain JSON types."""
        usable = self.values[self.mask]
        return {
            "kind": "measurement",
            "name": self.name,
            "n_times": self.n_times,
            "n_directions": self.n_directions,
            "n_channels": self.n_channels,
            "channels": list(self.channels),
            "wavelengths_nm": None if self.wavelengths is None else self.wavelengths.tolist(),
            "times": self.times.tolist(),
            "time_unit": self.time_unit,
            "theta_i_deg": extent(np.degrees(self.theta_i)),
            "theta_r_deg": extent(np.degrees(self.theta_r)),
            "f_r": extent(usable),
            "f_r_median": float(np.median(usable)) if usable.size else None,
            "n_samples": int(self.mask.size),
            "n_usable": int(usable.size),
            "masked": {reason: int(n) for reason, n in self.masked.items()},
            "weighted": bool(np.ptp(self.weights) > 0),
            "uncertainties": uncertainty_facts(self.values, self.mask, self.uncertainties),
            "common_uncertainty": self.common_uncertainty,
            **plain(dict(self.provenance)),
        }

    def _known_codes(self) -> tuple[NDArray[np.uint8], tuple[str, ...]]:
        if self._codes is not None:
            return self._codes, self._reasons
        return np.where(self.mask, 0, 1).astype(np.uint8), (policy.EXCLUDED,)

    def _part(self, **changes: Any) -> Self:
        part = replace(self, **changes)
        codes, names = part._known_codes()
        return replace(part, masked=counted(codes, names))
