"""Small valid files of every format that Motes reads, made by the project itself, for tools/fuzz.py to damage."""

from __future__ import annotations

import base64
import io
import json
import shutil
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "src"), str(ROOT / "tests")]

import format_files  # noqa: E402
import image_files  # noqa: E402
import measurement_files as files  # noqa: E402
from motes import ageing, fit, maps, meshes  # noqa: E402
from motes.images import library  # noqa: E402
from motes.material import Material  # noqa: E402
from motes.measurements import read  # noqa: E402
from motes.models import parse  # noqa: E402
from motes.trends import KINDS, Tabulated, Trend  # noqa: E402

#: The files of a specimen, by their names.
Specimen = dict[str, bytes]
#: Specimens, each with the file to read, "" for the folder.
Specimens = list[tuple[Specimen, str]]


def one(*texts: str | bytes) -> Specimens:
    return [({"a": t.encode() if isinstance(t, str) else t}, "a") for t in texts]


def folder_of(make: Callable[[Path], object]) -> Specimen:
    """The files that a function puts into a folder."""
    with tempfile.TemporaryDirectory() as scratch:
        make(Path(scratch))
        found = sorted(f for f in Path(scratch).rglob("*") if f.is_file())
        return {str(f.relative_to(scratch)): f.read_bytes() for f in found}


def staf(folder: Path) -> None:
    rng = np.random.default_rng(1)
    names = ("Diffuse", "Specular", "Roughness")
    files.staf_folder(folder, {name: rng.uniform(0, 1, (2, 4, 5, 1)).repeat(3, axis=3) for name in names})


def native_staf(folder: Path) -> None:
    format_files.native_staf_folder(folder, lambda path, pixels: files.write_exr(path, pixels, np.float32), times=2)


def tables() -> Specimens:
    """Columns of every kind that the reader of tables knows: those of the tests that are not there to be refused."""
    known = json.loads((ROOT / "tests" / "tables.json").read_text(encoding="utf-8"))["tables"]
    return one(files.csv_text(), *(table["text"] for table in known if "refused" not in table))


def spreadsheet() -> bytes:
    """The table of the tests by openpyxl."""
    import openpyxl

    book, made = openpyxl.Workbook(), io.BytesIO()
    for line in files.csv_text().splitlines():
        book.active.append([float(c) if c.lstrip("-")[:1].isdigit() else c for c in line.split(",")])
    book.save(made)
    return made.getvalue()


def pictures() -> Specimens:
    """OpenEXR and PNG by the book; TIFF and JPEG by OpenImageIO."""
    rng = np.random.default_rng(1)
    codes = rng.integers(0, 255, (5, 7, 3), np.uint8)
    half = {name: rng.uniform(0, 1, (5, 7)).astype(np.float16) for name in "RGBA"}

    def exr(folder: Path) -> None:
        image_files.write_exr(folder / "a.exr", half)

    def others(folder: Path) -> None:
        oiio = library.oiio("Writing pictures")

        def write(name: str, pixels: NDArray[Any], tile: int = 0, **attributes: Any) -> None:
            facts = oiio.ImageSpec(*pixels.shape[1::-1], pixels.shape[2], pixels.dtype.name)
            for key, value in attributes.items():
                facts.attribute(key.replace("__", ":"), value)
            if tile:
                facts.tile_width = facts.tile_height = tile
            if pixels.shape[2] == 6:
                facts.channelnames = ("R", "G", "B", "A", "Z", "normal.X")
            out = oiio.ImageOutput.create(name)
            if not (out.open(str(folder / name), facts) and out.write_image(pixels) and out.close()):
                raise OSError(out.geterror())

        for name in ("a.tif", "a.jpg"):
            write(name, codes, Exif__ColorSpace=1)
        write("tiles.tif", np.tile(codes.astype(np.uint16) * 200, (4, 5, 1)), 16, compression="zip")
        many = rng.uniform(0, 1, (20, 24, 6)).astype(np.float32)
        for way in ("zip", "piz", "rle"):
            write(f"{way}.exr", many, 16, compression=way)

    found = {
        **folder_of(exr),
        "8.png": image_files.png_bytes(codes, [0, 1, 2, 3, 4]),
        "16.png": image_files.png_bytes(codes.astype(np.uint16) * 257, [4], chunks=((b"gAMA", b"\0\1\x86\xa0"),)),
        **folder_of(others),
    }
    return [({name: data}, name) for name, data in found.items()]


def solids() -> Specimens:
    """A sphere in all the formats of meshes, PLY by Motes, the others by trimesh."""
    import trimesh

    ball = trimesh.creation.icosphere(1)
    mesh = meshes.Mesh(ball.vertices, ball.faces.astype(np.int32))
    found = folder_of(lambda folder: meshes.write_ply(folder / "a.ply", mesh))
    found["text.ply"] = trimesh.exchange.ply.export_ply(ball, encoding="ascii")
    for name, kind in (("a.obj", "obj"), ("a.stl", "stl"), ("text.stl", "stl_ascii"), ("a.glb", "glb")):
        made = ball.export(file_type=kind)
        found[name] = made.encode() if isinstance(made, str) else made
    return [({name: data}, name) for name, data in found.items()]


def fitted_folder() -> Specimen:
    """What `motes fit` writes of a small table."""

    def make(folder: Path) -> None:
        (folder / "t.csv").write_text(files.csv_text())
        fit(read(folder / "t.csv").at(0), model="oren_nayar").save(folder)
        (folder / "t.csv").unlink()

    return folder_of(make)


def materials() -> Specimens:
    """The plaster of the demonstration, its parameters moving; a fitted one; a spectrum under dust, with a table of times."""
    moving = ageing.age(ageing.drying_plaster(0.0), "dust", hours=10.0)
    nm = np.linspace(400, 700, 5)
    dusty = parse("dust_layer(ggx(fresnel=dielectric) + oren_nayar, tau=0.2, scattering=multiple)").model
    table = {"K_d": Tabulated(np.array([0.0, 1.0, 4.0]), np.linspace(0.1, 0.5, 15).reshape(3, 5))}
    spectral = Material(dusty, "dusty", tuple(f"{w:g} nm" for w in nm), trends=table, wavelengths=tuple(nm))
    return [
        *one(json.dumps(moving.to_dict())),
        ({"a": fitted_folder()["material.json"]}, "a"),
        *one(json.dumps(spectral.to_dict())),
    ]


def models() -> Specimens:
    """Sums, layers, options and values, as --model takes them."""
    return one(
        "oren_nayar(K_d=[0.3, 0.4, 0.5], sigma_d=0.3) + torrance_sparrow(fresnel=schlick, sigma_s=.1)",
        "dust_layer(oren_nayar + torrance_sparrow(normalization='facets'), tau=0.2)",
        "(lambert + torrance_sparrow(fresnel=dielectric(n=1.5)))",
    )


def trends() -> Specimens:
    """Every kind, its values a number or one for each channel."""
    made: list[str] = [
        json.dumps({"kind": "tabulated", "hours": [0, 1, 5], "values": [[0.1, 0.2], [0.2, 0.3], [0.3, 0.3]]})
    ]
    for kind in KINDS.values():
        values = {c.name: [0.2, 0.3] if c.bounds is None else 2.0 if c.is_time else 0.5 for c in kind.coefficients}
        size = sum(2 if c.bounds is None else 1 for c in kind.coefficients)
        made.append(json.dumps(Trend(kind.name, values, (0.0, 10.0), (0.0, 1.0), 0.01 * np.eye(size)).to_dict()))
    return one(*made)


def links() -> Specimens:
    """What the viewer puts behind the # of its address."""
    state = {
        "values": [{"K_d": [0.5], "sigma_d": [0.2]}, {}],
        "hours": 2.5,
        "shape": "bunny",
        "environment": "sky",
        "dust": False,
    }
    dropped = {
        "dropped": [None, json.loads(materials()[1][0]["a"])],
        "compare": "split",
        "split": 0.3,
        "active": 1,
        "exposure": -1,
    }
    return one(*(b"#motes=" + base64.urlsafe_b64encode(json.dumps(s).encode()).rstrip(b"=") for s in (state, dropped)))


def table_of_lights() -> Specimens:
    head = "file,theta_i_deg,phi_i_deg,wo_x,wo_y,wo_z,time_min,exposure,note of the day"
    rows = [f"{k}.png,{10 + 20 * k},{40 * k}.5,0,0.6,0.8,{k},0.25,# fair" for k in range(3)]
    pictures = {f"{k}.png": b"" for k in range(3)}
    return [({"lights.csv": "\n".join([head, *rows, ""]).encode(), **pictures}, "lights.csv")]


def dust() -> Specimens:
    """Options of motes dust, a line each, with the mesh and the mask that they are for."""
    lines = [
        "days=30",
        "up=-z",
        "source=0,0.6,-0.8",
        "wind=1 0 0.1",
        "stroke=0,0,0,1,0,0,0.3",
        "set=noise=0.2 spread_deg=30",
    ]
    corners = "0 0 0 0 0 -1 0 0|1 0 0 0 0 -1 1 0|0 1 0 0 0 -1 0 1|1 1 0.2 0 0 -1 1 1".replace("|", "\n")
    names = "\n".join(f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz", "u", "v"))
    head = f"ply\nformat ascii 1.0\nelement vertex 4\n{names}\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
    mesh = f"{head}{corners}\n3 0 2 1\n3 1 2 3\n".encode()
    mask = image_files.png_bytes(np.arange(48, dtype=np.uint8).reshape(4, 4, 3), [0])
    return [({"options.txt": "\n".join(lines).encode(), "a.ply": mesh, "mask.png": mask}, "options.txt")]


def reflectance_map(folder: Path) -> None:
    wi = np.array([[0.0, 0, 1], [0.6, 0, 0.8]])
    made = maps.create_map(folder / "m.zarr", (3, 4), wi, wi[::-1], hours=(0.0, 1.0), chunk=2)
    made.write(0, 0, np.full((3, 4, 2, 2, 3), 0.1))


def packed_map(folder: Path) -> None:
    """Integers with the attributes that say what they mean, and weights."""
    import zarr

    wi = np.array([[0.0, 0, 1], [0.6, 0, 0.8]])
    made = maps.create_map(folder / "m.zarr", (3, 4), wi, wi[::-1], hours=(0.0, 1.0), weights=(1.0, 2.0))
    group = zarr.open_group(str(made.path), mode="r+")
    about = {**group["f_r"].attrs, "scale_factor": 0.01, "add_offset": 0.5, "_FillValue": 9}
    dims = group["f_r"].metadata.dimension_names
    del group["f_r"]
    codes = np.arange(144, dtype="u2").reshape(3, 4, 2, 2, 3)
    packed = group.create_array(
        "f_r", shape=codes.shape, chunks=codes.shape, dtype="u2", dimension_names=dims, attributes=about
    )
    packed[...] = codes


def fitted_map(folder: Path) -> None:
    maps.simulate_map(folder / "m.zarr", (3, 4), times=1, lights=4)
    maps.fit_map(folder / "m.zarr", model="lambert", out=folder / "f.zarr")
    shutil.rmtree(folder / "m.zarr")


def fitted_trends(folder: Path) -> None:
    """Coefficients of trends, covariances, and the record of a failure."""
    maps.simulate_map(folder / "m.zarr", (2, 3), times=3, lights=6)
    made = maps.fit_map(
        folder / "m.zarr", model="oren_nayar", out=folder / "f.zarr", trends={"K_d": "linear"}, covariance=True
    )
    made.record_failures([((0, 0), "a chunk that cannot be read")])
    shutil.rmtree(folder / "m.zarr")


def specimens() -> dict[str, Callable[[], Specimens]]:
    """Format -> what makes its specimens."""
    f = format_files
    return {
        "rgl": lambda: one(files.tensor_file(files.rgl_fields(n_theta=2, size=3, grid=3))),
        "utia": lambda: [({"m001_a.bin": f.utia_bytes()}, "m001_a.bin")],
        "mbsdf": lambda: one(files.mbsdf_bytes(3, 4)),
        "merl-slice": lambda: one(files.alta_text()),
        "merl": lambda: one(files.merl_bytes()),
        "tvbrdf": lambda: [(files.tvbrdf_bytes(n_lights=2), "")],
        "native-staf": lambda: [(folder_of(native_staf), "")],
        "staf": lambda: [(folder_of(staf), "")],
        "curet": lambda: [(files.curet_bytes(), "")],
        "bird": lambda: one(f.bird_json()),
        "openmaterial": lambda: one(f.xompt_json()),
        "bsdf-xml": lambda: one(f.klems_xml(), f.tree_xml(), f.tree_xml(d=4)),
        "zemax": lambda: one(f.zemax_text(), f.zemax_text(names=("TristimulusX", "TristimulusY", "TristimulusZ"))),
        "lighttools": lambda: one(f.lighttools_text()),
        "astm": lambda: one(f.astm_text(), f.astm_text(degrees=True, phi_i=None)),
        "pab-opto": lambda: one(f.pab_text(30, 0, step=30), f.pab_text(30, 0, step=30, dsf=True)),
        "cornell": lambda: one(files.cornell_text()),
        "csv": tables,
        "csv in a spreadsheet": lambda: [({"a.xlsx": spreadsheet()}, "a.xlsx")],
        "picture": pictures,
        "mesh": solids,
        "material": materials,
        "model": models,
        "trend": trends,
        "table of lights": table_of_lights,
        "dust": dust,
        "folder of a fit": lambda: [(fitted_folder(), "")],
        "reflectance map": lambda: [(folder_of(make), "m.zarr") for make in (reflectance_map, packed_map)],
        "fitted map": lambda: [(folder_of(make), "f.zarr") for make in (fitted_map, fitted_trends)],
    }
