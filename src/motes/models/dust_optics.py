"""Real dusts: single-scattering albedo w and mean cosine g of what settles on surfaces, from published optics, with their sources.

>>> from motes.models.dust_optics import DUSTS
>>> soot = DUSTS["soot"].dust()
>>> soot.w.round(3), round(float(soot.g), 3)
(array([0.188, 0.209, 0.24 ]), 0.34)

What the numbers are: of particles in air, far from each other, taken as spheres of the stated sizes (Mie theory), whose phase function is
then replaced by a Henyey-Greenstein one of the same g.  What they are not: measurements of a layer that lies on something.  Grains that
touch scatter less forward, flakes and fibres otherwise than spheres, and real deposits are coarser than what flies; see docs/real_dusts.md.
The test suite computes w and g again, from the refractive index and the sizes that the sources state.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import channels
from motes.errors import ParameterError
from motes.models.dust import Dust

#: Dominant wavelengths of red, green and blue of sRGB (ITU-R BT.709 primaries, white D65) [nm].
RGB_WAVELENGTHS = (611.4, 549.1, 464.2)
#: Where a dust is looked at that is to have no colour [nm].
GREY_WAVELENGTH = 550.0

OPAC = (
    "Hess, Koepke, Schult, Optical properties of aerosols and clouds: the software package OPAC, Bull. Am. Meteorol. Soc. 79, 1998, "
    "doi:10.1175/1520-0477(1998)079<0831:OPOAAC>2.0.CO;2"
)
SNICAR = (
    "w and g in the library of Flanner et al., SNICAR-ADv3: a community tool for modeling spectral snow albedo, Geosci. Model Dev. 14, "
    "2021, doi:10.5194/gmd-14-7673-2021"
)
_OPAC_NM = (400.0, 450.0, 500.0, 550.0, 600.0, 650.0, 700.0, 750.0, 800.0, 900.0, 1000.0)
_SNICAR_NM = (405.0, 455.0, 505.0, 555.0, 605.0, 655.0, 705.0, 755.0, 805.0, 905.0, 1005.0)


@final
@dataclass(frozen=True)
class DustOptics:
    """A dust with published optics.

    Parameters
    ----------
    name, words
        As at the command line, and as in a sentence.
    wavelengths
        Where w and g are known [nm], rising (N,).
    w, g
        Single-scattering albedo and mean cosine of the deviation angle (N,).
    grains
        Sizes of the particles behind the numbers.
    source
        Where they come from.
    trust
        How far they can be trusted, in a sentence or two.
    """

    name: str
    words: str
    wavelengths: tuple[float, ...]
    w: tuple[float, ...]
    g: tuple[float, ...]
    grains: str
    source: str
    trust: str

    def at(self, wavelengths: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """w and g at wavelengths [nm], by straight lines between those that are known.

        Raises
        ------
        ParameterError
            For a wavelength outside those that are known.
        """
        nm = np.asarray(wavelengths, np.float64)
        low, high = self.wavelengths[0], self.wavelengths[-1]
        bad = ~((nm >= low) & (nm <= high))
        if bad.any():
            raise ParameterError(
                f"{self.name}: {nm[bad].flat[0]:g} nm is outside [{low:g}, {high:g}] nm, where its optics are known",
                "Give w and g yourself, or leave these channels out",
            )
        return np.interp(nm, self.wavelengths, self.w), np.interp(nm, self.wavelengths, self.g)

    def values(
        self, names: Sequence[str] = channels.RGB, wavelengths: Sequence[float] = ()
    ) -> tuple[float | NDArray[np.float64], float]:
        """w for each channel, or one where channels are neither colours nor wavelengths; and one g, the mean over the channels.

        Parameters
        ----------
        names
            Of the channels: colours are looked up at the dominant wavelengths of the primaries of sRGB.
        wavelengths
            Of the channels [nm], where they are known besides.
        """
        known = tuple(wavelengths) or channels.wavelengths_of(names)
        colours = channels.colours_of(names)
        if known:
            w, g = self.at(known)
        elif colours:
            w, g = self.at([RGB_WAVELENGTHS[k] for k in colours])
        else:
            w, g = self.at(GREY_WAVELENGTH)
        return (w if w.size > 1 else float(w.flat[0])), float(g.mean())

    def dust(self, names: Sequence[str] = channels.RGB, wavelengths: Sequence[float] = ()) -> Dust:
        """The model with these values; `names` and `wavelengths` are those of the channels, as of a material."""
        w, g = self.values(names, wavelengths)
        return Dust(w=w, g=g)


DUSTS: dict[str, DustOptics] = {
    dust.name: dust
    for dust in (
        DustOptics(
            "desert",
            "desert dust that the wind has carried far",
            _OPAC_NM,
            (0.6797, 0.7551, 0.7814, 0.8370, 0.8690, 0.8761, 0.8934, 0.8999, 0.9048, 0.9129, 0.9213),
            (0.850, 0.814, 0.799, 0.775, 0.760, 0.752, 0.742, 0.736, 0.731, 0.721, 0.714),
            "lognormal, mode radius 0.5 µm, sigma 2.2, 0.02 to 5 µm",
            f"component `mineral (transported)`, MITR, of {OPAC}",
            "Darker than later measurements: 19 dusts from all deserts have w = 0.85 to 0.98 at 520 nm in the laboratory (Di Biagio et al. 2019, "
            "doi:10.5194/acp-19-15503-2019). Take it for the dark end, and `mountain` for the bright one.",
        ),
        DustOptics(
            "desert_coarse",
            "coarse desert dust near where it comes from",
            _OPAC_NM,
            (0.5670, 0.6013, 0.6178, 0.6659, 0.7018, 0.7115, 0.7364, 0.7455, 0.7535, 0.7681, 0.7815),
            (0.940, 0.924, 0.915, 0.895, 0.879, 0.874, 0.863, 0.858, 0.854, 0.845, 0.836),
            "lognormal, mode radius 1.9 µm, sigma 2.15, 0.005 to 60 µm",
            f"component `mineral (coarse mode)`, MICM, of {OPAC}",
            "Sizes of what settles soon; much of g is diffraction, which neither darkens nor blurs. Absorption as of `desert`, so too dark likewise.",
        ),
        DustOptics(
            "sahara",
            "Saharan dust, reddened by hematite",
            _SNICAR_NM,
            (0.6873, 0.7726, 0.8441, 0.8856, 0.9504, 0.9653, 0.9709, 0.9754, 0.9771, 0.9791, 0.9815),
            (0.8694, 0.8333, 0.8108, 0.7897, 0.7621, 0.7542, 0.7547, 0.7568, 0.7569, 0.7362, 0.7000),
            "lognormal, number median radius 0.414 µm, sigma 2, of which 1.25 to 2.5 µm",
            "refractive index of Balkanski et al. 2007 (central hematite), doi:10.5194/acp-7-81-2007; " + SNICAR,
            "An index that agrees with what satellites and sun photometers see of dust in the air. One of five bins of size: in the next finer and "
            "coarser ones w is 0.93 and 0.82 at 555 nm.",
        ),
        DustOptics(
            "mountain",
            "soil dust that settled on mountain snow in Colorado",
            _SNICAR_NM,
            (0.9358, 0.9475, 0.9566, 0.9663, 0.9723, 0.9744, 0.9768, 0.9793, 0.9813, 0.9834, 0.9851),
            (0.7843, 0.7721, 0.7693, 0.7609, 0.7494, 0.7429, 0.7408, 0.7425, 0.7458, 0.7374, 0.7072),
            "lognormal, number median radius 0.414 µm, sigma 2, of which 1.25 to 2.5 µm",
            "refractive index of Skiles et al. 2017, from the reflectance of collected dust, doi:10.1017/jog.2016.126; " + SNICAR,
            "The only one here whose absorption was found from the reflectance of dust that had settled: the nearest to what lies on things outdoors.",
        ),
        DustOptics(
            "soil",
            "soil particles with some organic matter",
            _OPAC_NM,
            (0.6918, 0.7054, 0.7184, 0.7300, 0.7408, 0.7504, 0.7596, 0.7685, 0.7769, 0.7913, 0.8039),
            (0.860, 0.849, 0.840, 0.831, 0.822, 0.815, 0.808, 0.801, 0.797, 0.787, 0.777),
            "lognormal, mode radius 0.471 µm, sigma 2.51, 0.005 to 20 µm",
            f"component `insoluble`, INSO, of {OPAC}",
            "Its imaginary index is one number, 0.008 from 300 to 2000 nm, so that what colour it has comes from its sizes alone.",
        ),
        DustOptics(
            "soot",
            "soot",
            _OPAC_NM,
            (0.2672, 0.2456, 0.2257, 0.2088, 0.1920, 0.1756, 0.1616, 0.1479, 0.1354, 0.1129, 0.0965),
            (0.396, 0.374, 0.353, 0.336, 0.320, 0.305, 0.291, 0.278, 0.266, 0.244, 0.225),
            "lognormal, mode radius 0.0118 µm, sigma 2, 0.005 to 20 µm",
            f"component SOOT of {OPAC}",
            "Single small spheres; real soot grows in chains. For a median radius of 0.04 µm the library of SNICAR-ADv3 has w = 0.36 at 555 nm. Black "
            "either way.",
        ),
        DustOptics(
            "volcanic_ash",
            "ash of Eyjafjallajökull, 2010",
            _SNICAR_NM,
            (0.7971, 0.8209, 0.8441, 0.8611, 0.8708, 0.8795, 0.8877, 0.8922, 0.8966, 0.9032, 0.9033),
            (0.8290, 0.8122, 0.8019, 0.7942, 0.7815, 0.7736, 0.7677, 0.7667, 0.7694, 0.7656, 0.7412),
            "lognormal, number median radius 0.162 µm, sigma 2.8, of which 1.25 to 2.5 µm",
            "Flanner et al. 2014, doi:10.1002/2014JD021977; " + SNICAR,
            "Of one eruption. Its imaginary index is 0.004 to 0.005 here, and 0.001 to 0.005 in the laboratory (Rocha-Lima et al., Atmos. Chem. Phys. "
            "2014); grains beyond 5 µm are darker (w = 0.66 at 555 nm).",
        ),
        DustOptics(
            "mars",
            "dust of Mars",
            _SNICAR_NM,
            (0.7085, 0.7653, 0.8278, 0.8838, 0.9413, 0.9594, 0.9686, 0.9695, 0.9698, 0.9656, 0.9577),
            (0.8630, 0.8393, 0.8185, 0.7915, 0.7666, 0.7582, 0.7575, 0.7606, 0.7604, 0.7400, 0.7068),
            "lognormal, number median radius 0.414 µm, sigma 2, of which 1.25 to 2.5 µm",
            "refractive index of Wolff et al. 2009, doi:10.1029/2009JE003350; " + SNICAR,
            "The index comes from dust in the air of Mars as seen from orbit; the sizes are those of one of five bins, chosen.",
        ),
        DustOptics(
            "snow",
            "fine clean snow",
            _SNICAR_NM,
            (0.999998, 0.999998, 0.999997, 0.999994, 0.999989, 0.999974, 0.999952, 0.999907, 0.999817, 0.999482, 0.998059),
            (0.8873, 0.8883, 0.8890, 0.8895, 0.8898, 0.8900, 0.8902, 0.8904, 0.8905, 0.8907, 0.8910),
            "ice spheres, lognormal, effective radius 100 µm, sigma 1.5",
            "ice of Picard et al. 2016, doi:10.5194/tc-10-2655-2016; " + SNICAR,
            "For albedos. In blue light they come out above 0.99, which has been measured in Antarctica alone; crystals scatter less forward than "
            "spheres, and the phase function of neither is Henyey-Greenstein's.",
        ),
    )
}  # fmt: skip


def dust_optics(name: str) -> DustOptics:
    """The dust of a name; raises `ParameterError` with the names there are."""
    if name not in DUSTS:
        raise ParameterError(
            f"{str(name)[:80]!r} is not a dust with published optics", f"Choose one of {', '.join(DUSTS)}"
        )
    return DUSTS[name]
