"""Small files of the formats of measuring rooms and engines, written from their descriptions and not by our own writers."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

BRDF = Callable[[np.ndarray, np.ndarray], np.ndarray]


def vector(theta: float, phi: float) -> np.ndarray:
    """A unit vector from angles in degrees."""
    t, p = math.radians(theta), math.radians(phi)
    return np.array([math.sin(t) * math.cos(p), math.sin(t) * math.sin(p), math.cos(t)])


def lobed(wi: np.ndarray, wo: np.ndarray) -> float:
    """A BRDF with a lobe about the mirror direction, that knows left from right: 0.2/pi + ... [1/sr]."""
    across = wi[0] + wo[0], wi[1] + wo[1]
    return (
        0.2 / math.pi
        + 0.3 * math.exp(-6 * (across[0] ** 2 + across[1] ** 2))
        + 0.02 * wi[0] * wo[0]
        + 0.01 * wi[1] * wo[1]
    )


# ------------------------------------------------------------------------------------------------------------ BiRD


def bird_document(**changes: object) -> dict:
    """Two wavelengths, three geometries, an uncertainty a value."""
    theta_i, theta_r, phi_r = [0, 30, 45], [10, 30, 60], [0, 180, 90]
    nm = [450, 650]
    rows = [(i, r, p, w) for i, r, p in zip(theta_i, theta_r, phi_r, strict=True) for w in nm]
    values = [0.1 + 0.01 * k for k in range(len(rows))]
    data = {
        "theta_i": {"unit": "deg", "values": [row[0] for row in rows]},
        "phi_i": {"unit": "deg", "values": [0] * len(rows)},
        "theta_r": {"unit": "°", "values": [row[1] for row in rows]},
        "phi_r": {"unit": "rad", "values": [math.radians(row[2]) for row in rows]},
        "BRDF": {"unit": "sr^-1", "values": values},
        "uBRDF": {"unit": "%", "values": [2.0] * len(rows)},
        "wavelength_i": {"unit": "nm", "values": [row[3] for row in rows]},
    }
    unknown = dict.fromkeys(("country", "city", "street", "building_nr", "postal_code"), "x")
    metadata = {
        "schema": "https://raw.githubusercontent.com/BiRD-project/BiRD_view/master/BRDF_JSON_schema/brdf_json_schema_v1.0.json",
        "id": "urn:example:tile",
        "type": "BRDF",
        "timestamp": "2022-01-14T12:00:00+02:00",
        "provenance": {
            "organization": "Some Institute",
            "location": unknown,
            "email": "a@b.org",
            "contact_person": "N. N.",
        },
        "description": "a white tile",
        "method": "measurement",
        "instrumentation": "NA",
        "software": "NA",
        "sample": {
            "name": "tile",
            "type": "ceramic",
            "dimensions": {},
            "shape": "square",
            "zero_azimuth_location": "mark",
        },
        "environment": "NA",
    }
    data.update(changes)
    return {"metadata": metadata, "data": {name: column for name, column in data.items() if column is not None}}


def bird_json(**changes: object) -> str:
    return json.dumps(bird_document(**changes))


# --------------------------------------------------------------------------------------------------------- OpenMATERIAL


def xompt_json(rows: Sequence[Sequence[float | None]] | None = None) -> str:
    if rows is None:
        rows = [
            [w, math.radians(i), math.radians(o), math.radians(p), 0.1 + 0.001 * i + 0.0001 * o]
            for w in (4.5e-7, 6.5e-7)
            for i in (0, 40)
            for o in (10, 50)
            for p in (0, 180)
        ]
    metadata = {"name": "brick", "uuid": "42e8da0f-ba1d-4cc8-b07a-178819c894c0", "materialVersion": "1.0.0"}
    metadata |= {
        "openMaterial3dVersion": "1.0.0",
        "copyrights": ["x"],
        "license": "CC0",
        "authors": ["N. N."],
        "sources": "measurement",
    }
    brdf = {"wavelengths": sorted({row[0] for row in rows}), "lookupTable": rows}
    return json.dumps({"metadata": metadata, "brdf": brdf}, indent=1)


# ----------------------------------------------------------------------------------------------------------------- ASTM


def astm_text(degrees: bool = False, phi_i: float | None = 0.0, n: int | None = None) -> str:
    scale = 1.0 if degrees else math.pi / 180
    geometries = [(i, o, p) for i in (10, 60) for o in (0, 45) for p in (0, 100, 180)]
    head = ["LAB_NAME Somewhere", 'SAMPLE_NAME "a paint"', f"NUM_POINTS {len(geometries) if n is None else n}"]
    names = ["theta_i", *(["phi_i"] if phi_i is not None else []), "theta_s", "phi_s", "465nm", "630nm"]
    rows = []
    for k, (i, o, p) in enumerate(geometries):
        angles = [i, *([phi_i] if phi_i is not None else []), o, p]
        rows.append(",".join(f"{a * scale:.6f}" for a in angles) + f",{0.1 + 0.01 * k:.4f},{0.2 + 0.01 * k:.4f}")
    return "\r\n".join([*head, "VARS " + ",".join(names), "", *rows]) + "\r\n"


# ------------------------------------------------------------------------------------------------------------- pab-opto


def pab_text(
    theta_i: float, phi_i: float, f: BRDF = lobed, dsf: bool = False, step: float = 15.0, up: float | None = 90.0
) -> str:
    """One incident direction; with up = 90 the azimuths are those of the vectors."""
    turn = 0.0 if up is None else 90.0 - up
    if up is None:
        turn = 90.0
    lines = ['#sample_name "glass bead"', f"#format: theta phi {'DSF' if dsf else 'BSDF'}", "#date somewhen"]
    lines += [
        f"#intheta {theta_i:g}",
        f"#inphi {phi_i:g}",
        *([] if up is None else [f"#upphi {up:g}"]),
        "#colorimetry: CIE-Y",
    ]
    for theta in np.arange(step / 2, 90, step):
        for phi in np.arange(0, 360, step):
            value = f(vector(theta_i, phi_i + turn), vector(theta, phi + turn))
            lines.append(f"{theta:.3f}\t{phi:.3f}\t{value * (math.cos(math.radians(theta)) if dsf else 1):.6e}")
    return "\n".join(lines) + "\n"


# -------------------------------------------------------------------------------------------------------- WINDOW, Radiance


def window_xml(definition: str, blocks: str) -> str:
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<WindowElement xmlns="http://windows.lbl.gov">
<WindowElementType>System</WindowElementType>
<FileType>BSDF</FileType>
<Optical><Layer>
<Material><Name>a blind</Name><Manufacturer>Some Works</Manufacturer></Material>
<DataDefinition>{definition}</DataDefinition>
{blocks}
</Layer></Optical></WindowElement>
"""


def window_block(name: str, direction: str, bases: str, data: str, unit: str = "Integral") -> str:
    return f"""<WavelengthData><LayerNumber>System</LayerNumber><Wavelength unit="{unit}">{name}</Wavelength>
<WavelengthDataBlock><WavelengthDataDirection>{direction}</WavelengthDataDirection>{bases}
<ScatteringDataType>BRDF</ScatteringDataType><ScatteringData>{data}</ScatteringData></WavelengthDataBlock></WavelengthData>"""


QUARTER = [(1, 0, 9), (8, 9, 27), (12, 27, 45), (12, 45, 63), (8, 63, 90)]
KLEMS_BASES = "<ColumnAngleBasis>LBNL/Klems Quarter</ColumnAngleBasis><RowAngleBasis>LBNL/Klems Quarter</RowAngleBasis>"


def quarter_angles() -> list[tuple[float, float]]:
    """(theta, phi) [deg] of the 41 patches of Klems Quarter."""
    return [((low + high) / 2 if n > 1 else 0.0, 360 * k / n) for n, low, high in QUARTER for k in range(n)]


def klems_xml(
    f: BRDF = lobed, structure: str = "Columns", direction: str = "Reflection Back", names: Sequence[str] = ("Visible",)
) -> str:
    """Klems Quarter: incident patch (theta, phi) is lit from the azimuth phi + 180."""
    angles = quarter_angles()
    blocks = []
    for c, name in enumerate(names):
        table = np.array([[(c + 1) * f(vector(t, p + 180), vector(*out)) for t, p in angles] for out in angles])
        if structure == "Rows":
            table = table.T
        data = "\n".join(", ".join(f"{x:.6e}" for x in row) for row in table)
        blocks.append(window_block(name, direction, KLEMS_BASES, data))
    return window_xml(f"<IncidentDataStructure>{structure}</IncidentDataStructure>", "\n".join(blocks))


def tree_xml(data: str | None = None, d: int = 3, names: Sequence[str] = ("Visible",)) -> str:
    if data is None:  # the half that is used in eight cells of a grid, one of them divided again
        fine = "{" + " ".join(f"{0.1 + 0.01 * k:.3f}" for k in range(2**d)) + "}"
        data = "{" + "\n".join(fine if k == 0 else f"{{{0.2 + 0.01 * k:.3f}}}" for k in range(2**d)) + "}"
    basis = "<AngleBasis>LBNL/Shirley-Chiu</AngleBasis>"
    blocks = "\n".join(window_block(name, "Reflection Back", basis, data) for name in names)
    return window_xml(f"<IncidentDataStructure>TensorTree{d}</IncidentDataStructure>", blocks)


# ------------------------------------------------------------------------------------------------- Zemax, LightTools


def about_mirror(theta_i: float, radial: float, azimuth: float) -> np.ndarray:
    """The direction at a radial angle from the mirror direction of light at (theta_i, 0), by rotations [deg]."""

    def turn(axis: np.ndarray, angle: float, v: np.ndarray) -> np.ndarray:
        """Rodrigues' formula."""
        a = math.radians(angle)
        return v * math.cos(a) + np.cross(axis, v) * math.sin(a) + axis * (axis @ v) * (1 - math.cos(a))

    mirror = vector(theta_i, 180)
    y = np.array([0.0, 1.0, 0.0])
    towards_normal = turn(y, radial, mirror)  # about y, z goes towards +x: from -x up to the normal and beyond
    return turn(mirror, azimuth, towards_normal)


ZEMAX_ANGLES = ([0.0], [10.0, 40.0], [0.0, 60.0, 120.0, 180.0], [0.0, 5.0, 20.0, 60.0])


def zemax_text(f: BRDF = lobed, names: Sequence[str] = ("Monochrome",), scatter: str = "BRDF") -> str:
    rotations, incidences, azimuths, radials = ZEMAX_ANGLES
    lines = ["# by hand", "Source\tMeasured", "Symmetry\tPlaneSymmetrical"]
    lines += [f"SpectralContent\t{'Monochrome' if len(names) == 1 else 'XYZ'}", f"ScatterType\t{scatter}"]
    for key, angles in zip(
        ("SampleRotation", "AngleOfIncidence", "ScatterAzimuth", "ScatterRadial"), ZEMAX_ANGLES, strict=True
    ):
        lines += [f"{key} {len(angles)}", "\t".join(f"{a:g}" for a in angles)]
    lines.append("")
    for c, name in enumerate(names):
        lines += [name, "DataBegin"]
        for theta in incidences * len(rotations):
            lines.append("TIS 0.3")
            for azimuth in azimuths:
                row = []
                for radial in radials:
                    wo = about_mirror(theta, radial, azimuth)
                    row.append(f"{(c + 1) * f(vector(theta, 0), wo) if wo[2] > 0 else 0:.5E}")
                lines.append("\t".join(row))
        lines.append("DataEnd")
    return "\n".join(lines) + "\n"


LIGHTTOOLS_ANGLES = ([0.0, 90.0, 180.0, 270.0], [0.0, 30.0, 60.0])


def lighttools_text(f: BRDF = lobed) -> str:
    """Light at the azimuth 90 degrees."""
    azimuths, radials = LIGHTTOOLS_ANGLES
    lines = ["# by hand", "Symmetry Asymmetric", "SpectralContent Monochrome"]
    lines += [
        f"ScatterAzimuth {len(azimuths)}",
        " ".join(map(str, azimuths)),
        f"ScatterRadial {len(radials)}",
        " ".join(map(str, radials)),
    ]
    lines.append("DataBegin")
    for side, theta, nm, kind in (
        ("Front", 0, 550, "BRDF"),
        ("Front", 50, 550, "BRDF"),
        ("Front", 50, 550, "BTDF"),
        ("Back", 0, 550, "BRDF"),
    ):
        lines += [f"AOI {theta}", "POI 0", f"Side {side}", f"Wavelength {nm}", f"ScatterType {kind}", "TIS 0.4"]
        lines += [" ".join(f"{f(vector(theta, 90), vector(r, a)):.6e}" for r in radials) for a in azimuths]
    return "\n".join([*lines, "DataEnd"]) + "\n"


# ----------------------------------------------------------------------------------------------------------------- UTIA


def utia_table(f: BRDF = lobed) -> np.ndarray:
    """(6, 48, 6, 48, 3)."""
    theta, phi = np.radians(15.0 * np.arange(6)), np.radians(7.5 * np.arange(48))
    ti, pi, tv, pv = np.meshgrid(theta, phi, theta, phi, indexing="ij")
    wi = np.stack([np.sin(ti) * np.cos(pi), np.sin(ti) * np.sin(pi), np.cos(ti)])
    wo = np.stack([np.sin(tv) * np.cos(pv), np.sin(tv) * np.sin(pv), np.cos(tv)])
    across = (wi[0] + wo[0]) ** 2 + (wi[1] + wo[1]) ** 2
    value = 0.06 + 0.3 * np.exp(-6 * across) + 0.02 * np.cos(2 * pi) * np.sin(ti)
    return value[..., None] * np.array([1.0, 0.5, 0.25])


def utia_bytes() -> bytes:
    return np.ascontiguousarray(np.moveaxis(utia_table(), -1, 0)).astype("<f8").tobytes()


# ----------------------------------------------------------------------------------------------------------- native STAF


def native_staf_folder(
    folder: Path, write_exr: Callable[[Path, np.ndarray], None], times: int = 3, fitted: bool = True
) -> Path:
    """4 x 5 texels; Kd .3, .4, .5 ..., Ks 2, sigma .2 + .1 t."""
    (folder / "TSparamNew").mkdir(parents=True, exist_ok=True)
    (folder / "tvBTF45-info.txt").write_text("Texture Size: 4 x 5\nSample tvBTF45: cast iron rusting\n")
    (folder / "tvBTF45-time.txt").write_text("\n".join(f"0:{2 * k}:30:0" for k in range(times)) + "\n")
    one = np.ones((4, 5, 3))
    for k in range(times):
        maps = {"Kd": (0.3 + 0.1 * k) * one * [1, 0.5, 0.25], "Ks": 2 * one, "Sigma": one / (0.2 + 0.1 * k) ** 2}
        for name, picture in maps.items():
            write_exr(folder / "TSparamNew" / f"tvBTF45-{k + 1:02d}-00-TSparam-{name}.exr", picture)
    if fitted:
        (folder / "SIM").mkdir(exist_ok=True)
        line = " ".join(map(str, [0, 0, 0, 0, 0, 2, 1]))  # phi(x) = 2 x + 1
        (folder / "SIM" / "tvBTF45-staf-Kd-phi.txt").write_text(f"pphi_r: {line}\npphi_g: {line}\npphi_b: {line}\n")
        (folder / "SIM" / "tvBTF45-staf-Ks-phi.txt").write_text(f"pphi_Ks: {line}\npphi_S: {line}\n")
        for part in ("Kd", "Ks", "Sigma"):
            for letter, value in (("A", 0.1), ("B", 2.0), ("C", 0.5), ("D", 1.0)):
                write_exr(folder / "SIM" / f"tvBTF45-staf-{part}-{letter}.exr", value * one)
    return folder
