"""What Python tells the page, as types: `motes.viewer.declarations` prints them as TypeScript, so that the two cannot drift."""

from __future__ import annotations

from typing import Any, Literal, TypedDict

#: Changes when the page of an older Motes could not read a payload.
VERSION = 2
#: The table of what a shader keeps has columns for so many shares of dust, at the cubes of even steps from 0 to 1, which are dense where there is hardly any.
SHARES = 257


class ParameterJson(TypedDict):
    """A parameter in a material's JSON."""

    value: Any
    unit: str
    meaning: str


class MaterialJson(TypedDict):
    """A material as `motes.Material.to_dict` gives it."""

    format: str
    version: int
    name: str
    model: str
    parameters: dict[str, ParameterJson]
    channels: list[str]
    wavelengths_nm: list[float]
    trends: dict[str, Any]
    time_unit: str
    conventions: dict[str, str]
    about: dict[str, Any]


class UniformView(TypedDict):
    """A uniform of a printed shader: its parameter, and how many numbers it holds (1: a float; else a vec3 or an array)."""

    name: str
    slot: str
    size: int


class ShaderView(TypedDict):
    """A printed shader: ``name_with(wi, wo, ...)`` takes the uniforms' values in this order.

    Where it is in `stages`, ``name_parameters(...)`` computes once what parameters alone need, ``name_view(wo, ...)`` what ``name_light(wi, wo, ...)`` needs
    for each of many lights.  Where the first is long, `kept` are its variables, which a table holds instead; `table` is that of the first picture.
    """

    source: str
    name: str
    uniforms: list[UniformView]
    channels: int
    stages: bool
    kept: list[KeptView]
    table: KeptTable | None


class KeptTable(TypedDict):
    """What is kept, at the values that a page begins with: for each share of dust (`SHARES` of them) in turn all numbers of the variables."""

    values: dict[str, list[float]]
    data: str


class KeptView(TypedDict):
    """A global variable of a shader: ``float``, ``vec3`` or ``bool``."""

    name: str
    type: str


class ScansView(TypedDict):
    """What each scan said of a parameter on its own; None where it does not determine it."""

    hours: list[float]
    values: list[list[float | None]]
    stderr: list[list[float | None]]


class TrendView(TypedDict):
    """A parameter over the hours of a `TimeView`: values and one standard error, (T, W); None where it is not known."""

    kind: str
    values: list[list[float]]
    stderr: list[list[float | None]] | None
    scans: ScansView | None


class TimeView(TypedDict):
    """Trends, evaluated by Python at these times [h]; between them the page takes straight lines."""

    hours: list[float]
    interval: tuple[float, float]
    trends: dict[str, TrendView]


class RangeView(TypedDict):
    """Where a parameter's values lie; `high` is None where nothing ends them, and `open` means that the ends are none."""

    low: float
    high: float | None
    open: bool


class MaterialView(TypedDict):
    """A material: its JSON, its printed shader, its course in time, and how its channels become linear sRGB (C, 3).

    `ranges` are those of its parameters by slot: a model may allow less than the declaration of a parameter, as dust with all orders of scattering does.
    """

    json: MaterialJson
    shader: ShaderView
    ranges: dict[str, RangeView]
    time: TimeView | None
    to_srgb: list[list[float]]
    color: str


class MeasurementView(TypedDict):
    """Measured points.  Arrays are base64 of little-endian float32: wi, wo (N, 3), values (T, N, C) with NaN where masked."""

    name: str
    channels: list[str]
    hours: list[float]
    time_unit: str
    count: int
    total: int
    wi: str
    wo: str
    values: str
    note: str


class ShapeView(TypedDict):
    """A mesh.  Base64 of little-endian numbers: positions uint16 (V, 3) between low and high, normals int16 (V, 3) over 32767, triangles uint16
    (F, 3), dust uint8 (V,) over 255: the share of what settles on a level, open surface."""

    name: str
    low: tuple[float, float, float]
    high: tuple[float, float, float]
    positions: str
    normals: str
    triangles: str
    dust: str


class ShapesView(TypedDict):
    """The meshes of the page; and the share of dust that stays on an open surface whose normal makes an angle with up, at equal steps of the angle from 0 to
    180 degrees."""

    shapes: list[ShapeView]
    dust_by_inclination: list[float]


class Payload(TypedDict):
    """All that a page or a widget gets; the library, which only materials that are dropped need, is `deflated`: a dictionary of `ShaderView` by name."""

    format: Literal["motes view"]
    version: int
    motes: str
    materials: list[MaterialView]
    measurement: MeasurementView | None
    notes: list[str]
    library: str
    models: dict[str, Any]
    shapes: ShapesView


class LayerView(TypedDict):
    """A map of a parameter.  Base64 of little-endian numbers: values and stderr float32 (Y, X, times, channels), NaN where there is none; verdicts
    uint8, a code for each texel or for each texel and time, of several channels the worst.  The spans are the ends of colour scales."""

    name: str
    doc: str
    unit: str
    times: int
    channels: int
    values: str
    stderr: str | None
    verdicts: str | None
    span: tuple[float, float]
    error_span: tuple[float, float] | None


class MapPayload(TypedDict):
    """All that the page of a fitted map gets: every `step`-th texel of rows and columns.  Verdicts and statuses by name: the code, the colour; ramp is
    256 colours of three bytes."""

    format: Literal["motes map"]
    version: int
    motes: str
    name: str
    model: str
    shape: tuple[int, int]
    step: int
    hours: list[float]
    channels: list[str]
    to_srgb: list[list[float]]
    color: str
    ramp: str
    verdicts: dict[str, tuple[int, str]]
    statuses: dict[str, tuple[int, str]]
    status: str
    residual: LayerView
    layers: list[LayerView]
    notes: list[str]
