"""The rig of "Time-Varying BRDFs" (TVCG 2007), simulated: what four cameras record while a lamp sweeps over a sample.

A lamp on an arm moves in the plane of incidence, half a degree between records, and four cameras look at the sample.
Each sweep is made at three exposures, which are merged into one high-dynamic-range radiance; a scan takes 36 s.
`simulate` writes such scans in the folder format of the TVBRDF database.

What is documented, and kept: the exposures, the step, the plane of incidence (y = 0), and the first record of camera 1,
with the lamp at 78 degrees from the normal and the camera at 12 degrees on the other side.  What is a choice of this
simulation:

- The other three cameras.  The original four stood in one vertical plane.  Here two of them stand outside the plane of
  incidence, so that the data tell more of azimuth than phi = 0 and 180 degrees.
- The arm sweeps from 78 to -78 degrees, and never hides the sample from a camera.  Nothing changes during a scan.
- The aperture follows the lamp: the shortest exposure saturates at a radiance of 20 times the irradiance, the longest
  (160 times as long) at an eighth of the irradiance.  What saturates the shortest is recorded at its ceiling.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import final

import numpy as np
from numpy.typing import NDArray

from motes.directions import from_spherical
from motes.errors import MotesError
from motes.material import Material
from motes.models import BRDF

Floats = NDArray[np.float64]
Surface = BRDF | Material | Callable[[float], BRDF]

CEILING = 20.0  # radiance that saturates the shortest exposure, over the irradiance; matte white reflects 1/pi
READ_NOISE = 1 / 4096  # standard deviation of a reading, over its full scale: one step of a 12-bit camera
MOST_RECORDS = 5_000_000  # in all the scans of a simulation; about 400 MB of text


@final
@dataclass(frozen=True)
class Rig:
    """Where lamp and cameras stand, and how a camera records.

    Parameters
    ----------
    cameras_deg
        ``(theta, phi)`` of each camera [degrees].
    arm_deg
        The lamp's first and last angle from the normal [degrees], positive towards +x.
    step_deg
        Between two records [degrees].
    exposures
        Of the three sweeps, in the database's units; the longest that does not saturate is the one that counts.
    irradiance
        Of the lamp, on a plane facing it: a white Lambertian surface has the radiance ``irradiance cos(theta_i) / pi``.
    """

    cameras_deg: tuple[tuple[float, float], ...] = ((12.0, 180.0), (45.0, 180.0), (65.0, 150.0), (35.0, 90.0))
    arm_deg: tuple[float, float] = (78.0, -78.0)
    step_deg: float = 0.5
    exposures: tuple[float, ...] = (0.2, 4.0, 32.0)
    irradiance: float = 1.0

    def __post_init__(self) -> None:
        if not 0.01 <= self.step_deg <= 45:
            raise MotesError(
                f"the lamp's step is {self.step_deg:g} degrees, outside [0.01, 45]",
                "The original rig steps by 0.5 degrees",
            )
        if not 0 < self.irradiance < float("inf"):
            raise MotesError(f"the irradiance is {self.irradiance:g}, not a positive number", "1 is the default")
        if not self.exposures or not all(0 < e < float("inf") for e in self.exposures):
            raise MotesError(
                f"the exposures {self.exposures} are not positive numbers", "The original rig has 0.2, 4 and 32"
            )
        for theta in (*self.arm_deg, *(theta for theta, _ in self.cameras_deg)):
            if not abs(theta) < 90:
                raise MotesError(
                    f"an angle of {theta:g} degrees from the normal is at or below the horizon",
                    "Choose one below 90 degrees",
                )

    @property
    def wi(self) -> Floats:
        """To the lamp (M, 3), in the order of the sweep."""
        first, last = self.arm_deg
        count = int(np.floor(abs(last - first) / self.step_deg + 1e-9)) + 1
        theta = np.radians(first + np.sign(last - first) * self.step_deg * np.arange(count))
        return np.stack([np.sin(theta), np.zeros(count), np.cos(theta)], axis=-1)

    @property
    def wo(self) -> Floats:
        """To the cameras (V, 3)."""
        theta, phi = np.radians(np.array(self.cameras_deg)).T
        wo = from_spherical(theta, phi)
        return np.where(np.abs(wo) < 1e-12, 0.0, wo)  # sin(180 degrees) is 0, not 1e-16

    def record(self, brdf: BRDF, noise: float, rng: np.random.Generator) -> list[tuple[Floats, Floats, Floats]]:
        """One scan: for each camera ``L (M, 3), V (M, 3), F (M, 3)``, the radiance F in R, G, B."""
        scan = []
        for wo in self.wo:
            wi, views = self.wi, np.broadcast_to(wo, self.wi.shape)
            radiance = self.irradiance * brdf.eval(wi, views) * wi[:, 2:3]
            scan.append((wi, views.copy(), self._merge(np.broadcast_to(radiance, wi.shape), noise, rng)))
        return scan

    def _merge(self, radiance: Floats, noise: float, rng: np.random.Generator) -> Floats:
        """One radiance from three: the longest exposure that does not saturate, else the ceiling of the shortest."""
        # Flicker of the lamp and grain of the sample scale with the signal and are drawn once for a record; read noise
        # is each exposure's own.
        signal = radiance * (1 + noise * rng.standard_normal(radiance.shape))
        merged = np.full(radiance.shape, CEILING * self.irradiance)
        for exposure in sorted(self.exposures):
            full_scale = CEILING * self.irradiance * min(self.exposures) / exposure
            reading = signal + (READ_NOISE * full_scale * rng.standard_normal(radiance.shape) if noise > 0 else 0.0)
            merged = np.where(reading < full_scale, reading, merged)
        return merged


def simulate(
    folder: str | os.PathLike[str],
    surface: Surface,
    *,
    scans: int = 12,
    hours: float = 6.0,
    noise: float = 0.02,
    seed: int = 0,
    rig: Rig | None = None,
    name: str = "",
    process: str = "simulated",
    progress: Callable[[int, int, str], None] | None = None,
) -> Path:
    """Measure a surface with the simulated rig and write the scans as a sample of the TVBRDF database.

    Parameters
    ----------
    folder
        To write: ``tvBrdf-info.txt`` and ``tvBrdf-data/``; `motes.read` reads it back.
    surface
        A BRDF or a material, or a function of the time [h] that returns a BRDF, such as `drying_plaster`; of one
        channel or three (R, G, B).
    scans, hours
        The number of scans, and the time of the last one; they are evenly spaced from 0.
    noise
        Relative standard deviation of each radiance.  With it comes read noise of one step in 4096 of the exposure's
        full scale, so that dark records may come out negative.  0 turns both off.
    seed
        Of the noise; the same seed gives the same files.
    rig
        The default is the paper's.
    name, process
        For ``tvBrdf-info.txt``.
    progress
        Called with (done, total, what).

    Returns
    -------
    The folder.

    Raises
    ------
    MotesError
        For numbers out of range, a surface with other than one or three channels, or a folder that cannot be written.
    """
    from motes.measurements.tvbrdf_writing import write_tvbrdf
    from motes.version import __version__

    rig = rig or Rig()
    if scans < 1:
        raise MotesError(f"{scans} scans were asked for", "Ask for at least one")
    if scans * len(rig.wi) * len(rig.cameras_deg) > MOST_RECORDS:
        raise MotesError(
            f"{scans} scans with steps of {rig.step_deg:g} degrees are more than {MOST_RECORDS:,} records",
            "Take fewer scans or larger steps",
        )
    if not 0 <= noise <= 1:
        raise MotesError(f"the noise is {noise:g}, outside [0, 1]", "0.02 is 2 % of each radiance")
    if not 0 < hours < 1e6:
        raise MotesError(f"the last scan is at {hours:g} h, outside (0, 1e6)", "6 is the default")
    if seed < 0:
        raise MotesError(f"the seed is {seed}, below 0", "Choose 0 or more")
    rng = np.random.default_rng(seed)
    times = np.linspace(0.0, hours, scans)
    recorded = []
    for k, time in enumerate(times):
        if progress:
            progress(k, scans, f"scan {k + 1}")
        brdf = (
            surface.at(float(time))
            if isinstance(surface, Material)
            else surface
            if isinstance(surface, BRDF)
            else surface(float(time))
        )
        if brdf.channels not in (1, 3):
            raise MotesError(
                f"the surface has {brdf.channels} channels, and the TVBRDF format has 3 (R, G, B)",
                "Give it one channel or three",
            )
        recorded.append(rig.record(brdf, noise, rng))
    if progress:
        progress(scans, scans, "writing")
    return write_tvbrdf(
        Path(folder),
        name=name or Path(folder).name,
        process=process,
        times_seconds=[3600 * float(time) for time in times],
        scans=recorded,
        exposures=rig.exposures,
        irradiance=rig.irradiance,
        source=f"simulated by Motes {__version__}, noise {noise:g}, seed {seed}",
    )
