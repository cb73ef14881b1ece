"""Dust that settles on meshes: known shapes, a quadrature of the sky, and mirrors that gathered dust in the sun."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes import Dust, DustLayer, Lambert, Material
from motes.ageing import age
from motes.errors import FormatError, MotesError, ParameterError

if (
    find_spec("mitsuba") is None
):  # not importorskip: Dr.Jit chooses its LLVM when it is imported, and Motes must come first
    pytest.skip("mitsuba is not installed", allow_module_level=True)

from motes.meshes.mesh import Mesh, with_normals
from motes.meshes.meshfile import read_mesh
from motes.meshes.shapes import plane, sphere, teapot
from motes.meshes.subdivision import refine
from motes.rendering.baking import bake, write_texture
from motes.rendering.deposition import SETTLING, Points, checked_tau, deposit, open_tau
from motes.rendering.gathering import falling, hold
from motes.rendering.noise import cloudy, gradient_noise
from motes.rendering.wiping import Stroke, look_up, read_mask

ROOT = Path(__file__).resolve().parents[1]
EVEN: dict[str, Any] = {"noise": 0}


def block(low: tuple[float, float, float], high: tuple[float, float, float], levels: int = 4) -> Mesh:
    """A box, each side cut into 4**levels x 2 triangles."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))], np.int32)
    return refine(with_normals(Mesh(corners * np.subtract(high, low) + low, triangles)), levels)


def joined(*meshes: Mesh) -> Mesh:
    starts = np.cumsum([0, *(len(m.positions) for m in meshes)])
    return Mesh(
        np.concatenate([m.positions for m in meshes]),
        np.concatenate([m.triangles + s for m, s in zip(meshes, starts, strict=False)]).astype(np.int32),
        np.concatenate([m.normals for m in meshes]),
    )


def inclination_deg(mesh: Mesh) -> np.ndarray:
    return np.rad2deg(np.arccos(np.clip(mesh.normals[:, 1], -1, 1)))


# ---------------------------------------------------------------- known shapes


def test_a_sphere_gathers_dust_on_its_upper_half() -> None:
    ball = sphere(64)
    share, theta = deposit(ball, **EVEN).share, inclination_deg(ball)
    assert share[theta == 0] == pytest.approx(1, abs=1e-6)
    assert share[theta < 30].min() > 0.85
    assert share[(theta > 88) & (theta < 92)].max() < 0.03
    assert share[theta > 90].max() < 0.02
    assert share[theta > 106].max() == 0
    rings = share[: 65 * 128].reshape(128, 65).mean(0)  # from the lower pole up, without the seam
    assert (np.diff(rings[:-1]) >= 0).all()  # less and less from the top down; the pole itself has one vertex in many


def test_what_falls_is_the_integral_over_the_sky() -> None:
    # On a convex body nothing is hidden: the integral of the density times the cosine, by a quadrature of its own.
    spread_deg = 20.0
    ball = sphere(16)
    fall = deposit(ball, rays=1024, spread_deg=spread_deg, **EVEN).factors["fall"]
    theta, phi = np.meshgrid((np.arange(200) + 0.5) / 200 * np.pi / 2, (np.arange(200) + 0.5) / 200 * 2 * np.pi)
    omega = np.stack([np.sin(theta) * np.cos(phi), np.cos(theta), np.sin(theta) * np.sin(phi)], -1).reshape(-1, 3)
    density = (np.cos(theta) ** (1 / np.deg2rad(spread_deg) ** 2) * np.sin(theta)).ravel()
    expected = np.maximum(ball.normals @ omega.T, 0) @ density / (density @ omega[:, 1])
    np.testing.assert_allclose(fall, expected, atol=3e-3)


def test_nothing_lands_under_a_table() -> None:
    top = block((-2, 1, -2), (2, 1.1, 2))
    legs = [block((x, 0.02, z), (x + 0.1, 1, z + 0.1), 2) for x in (-1.9, 1.8) for z in (-1.9, 1.8)]
    floor = plane(80, size=16)
    mesh = joined(floor, top, *legs)
    share, theta, p = deposit(mesh, **EVEN).share, inclination_deg(mesh), mesh.positions
    on_floor, under = p[:, 1] == 0, (np.abs(p[:, [0, 2]]) < 0.8).all(1)
    assert share[on_floor & under].max() == 0
    assert share[on_floor & (np.abs(p).max(1) > 4)] == pytest.approx(1, abs=1e-5)
    on_top = (p[:, 1] > 1.05) & (theta < 1)
    assert share[on_top] == pytest.approx(1, abs=1e-5)
    assert share[(theta > 179) & (p[:, 1] > 0.5)].max() == 0  # its underside
    assert share[(np.abs(theta - 90) < 1) & (p[:, 1] > 0.5)].max() < 0.03  # legs and edges
    # Another mesh shelters the floor as well as a part of the same does.
    apart = deposit(floor, others=[top, *legs], **EVEN).share
    np.testing.assert_allclose(apart, share[: len(apart)], atol=1e-12)


def step() -> Mesh:
    """A block, 1 high and very wide, on a floor; its lee side is at x = 0."""
    return joined(plane(2, size=32), block((-8, 0, -16), (0, 1, 16), 0))


def level(x: np.ndarray, height: float) -> Points:
    """Places on a level surface, along x, at z = 0.03."""
    return Points(
        np.stack([x, np.full_like(x, height), np.full_like(x, 0.03)], -1), np.tile([0.0, 1.0, 0.0], (len(x), 1)), None
    )


def test_dust_stays_in_the_lee_of_a_step() -> None:
    mesh, x = step(), np.linspace(0.2, 16, 80)
    kept = deposit(mesh, wind=(-1, 0, 0), rays=512, where=level(x, 0), **EVEN).factors["lee"]
    assert kept[x < 2.5].min() > 0.99  # at the foot of the step nothing is blown away
    assert kept[x > 14].max() < 0.55
    assert (np.diff(kept) <= 1e-9).all()
    # Half of the wind reaches the ground 6 step heights away, where a flow comes down again.
    assert np.interp(-(1 - 0.5 * SETTLING["scour"].default), -kept, x) == pytest.approx(6, abs=0.5)
    top = deposit(mesh, wind=(-1, 0, 0), rays=512, where=level(np.linspace(-7.9, -0.1, 40), 1), **EVEN).factors["lee"]
    assert top == pytest.approx(1 - SETTLING["scour"].default, abs=1e-6)
    # And from the other side the same floor lies before the step, where the wind blows.
    against = deposit(mesh, wind=(1, 0, 0), rays=256, where=level(x, 0), **EVEN).factors["lee"]
    assert against == pytest.approx(1 - SETTLING["scour"].default, abs=1e-6)


def test_a_step_shades_dust_that_comes_from_the_side() -> None:
    x = np.linspace(0.05, 8, 160)
    fall = deposit(step(), source=(-1, 1, 0), spread_deg=1, where=level(x, 0), **EVEN).factors["fall"]
    assert fall[x < 0.9].max() == 0  # the shadow of a step of height 1 at 45 degrees is 1 long
    assert fall[x > 1.2] == pytest.approx(np.sqrt(0.5), rel=2e-3)


def test_slopes_hold_what_adhesion_and_slipperiness_say() -> None:
    theta = np.array([0.0, 40, 60, 80, 90, 120])
    cosine = np.cos(np.deg2rad(theta))
    np.testing.assert_allclose(hold(cosine, 1.0, 0.5), [1, 1, 1, 25 / 27, 0.5, 0], atol=1e-12)
    half = hold(cosine, 0.2, 0.5)
    assert half[0] == 1
    assert half[2] == pytest.approx(0.2)  # 60 is 15 beyond 45, where all but what sticks has slid
    assert hold(np.cos(np.deg2rad([45.0])), 0.0, 0.5) == pytest.approx(0.5)


def test_up_may_be_any_direction() -> None:
    ball = sphere(24)
    up = np.array([0.6, -0.48, 0.64])
    share = deposit(ball, up=up, **EVEN).share
    assert np.argmax(share) == np.argmax(ball.normals @ up)
    assert share[ball.normals @ up < -0.3].max() == 0


def test_size_and_place_do_not_matter() -> None:
    ball = sphere(24)
    there = ball.moved(1e-3, (5e3, -2e4, 1e3))
    np.testing.assert_allclose(deposit(there, **EVEN).share, deposit(ball, **EVEN).share, atol=2e-3)


def test_mirrors_in_the_sun_gathered_dust_as_their_inclination_says() -> None:
    """Growth of tau on mirrors at five solar plants, by tilt (docs/ageing.md, from the readings of the plants)."""
    rows = re.findall(
        r"^\| ([\w ]+) \| (\d+)° \| \d+ \| (\S+) ± (\S+) \|", (ROOT / "docs" / "ageing.md").read_text(), re.MULTILINE
    )
    assert len(rows) == 24
    chi2 = {"model": 0.0, "no inclination": 0.0}
    for site in {row[0] for row in rows}:
        tilt, growth, error = np.array([row[1:] for row in rows if row[0] == site], float).T
        normals = np.stack([np.sin(np.deg2rad(tilt)), np.cos(np.deg2rad(tilt)), 0 * tilt], -1)
        default = {name: option.default for name, option in SETTLING.items()}
        sky = falling(np.array([0.0, 1.0, 0.0]), default["spread_deg"], 2048)
        fall = np.maximum(normals @ sky.T, 0).mean(1) / sky[:, 1].mean()
        share = fall * hold(normals[:, 1], default["adhesion"], default["slipperiness"])
        for name, shape in (("model", share), ("no inclination", np.ones_like(share))):
            level = (shape * growth / error**2).sum() / (shape**2 / error**2).sum()  # the site's own amount of dust
            chi2[name] += float((((growth - level * shape) / error) ** 2).sum())
    assert chi2["model"] < 19 + 2 * np.sqrt(2 * 19)  # 24 rows, an amount for each of 5 sites
    assert chi2["no inclination"] > 5 * chi2["model"]


# ---------------------------------------------------------------- wiping, noise


def test_a_stroke_wipes_what_it_passes() -> None:
    floor = plane(64)
    left = deposit(floor, strokes=[Stroke(np.array([[-1, 0, 0], [1, 0, 0]]), 0.3, bristles=0)], **EVEN).share
    distance = np.hypot(np.maximum(np.abs(floor.positions[:, 0]) - 1, 0), floor.positions[:, 2])
    assert left[distance < 0.2].max() == 0
    assert left[distance > 0.3] == pytest.approx(1, abs=1e-5)
    half = deposit(floor, strokes=[Stroke(np.array([[0, 0, 0]]), 0.3, strength=0.5, bristles=0)], **EVEN).share
    assert half.min() == pytest.approx(0.5, abs=1e-5)
    streaked = deposit(floor, strokes=[Stroke(np.array([[-1, 0, 0], [1, 0, 0]]), 0.3)], **EVEN).share
    middle = (np.abs(floor.positions[:, 0]) < 0.9) & (distance < 0.2)
    rows = [streaked[middle & (floor.positions[:, 2] == z)] for z in np.unique(floor.positions[middle, 2])]
    assert max(np.ptp(row) for row in rows) < 1e-9  # streaks run along the stroke
    assert np.ptp([row[0] for row in rows]) > 0.2  # and differ across it


def test_a_mask_wipes_where_it_is_white() -> None:
    floor = plane(32)
    mask = np.zeros((64, 64))
    mask[:32, :32] = 1  # the top left quarter: u < 1/2, v > 1/2
    left = deposit(floor, mask=mask, **EVEN).share
    u, v = floor.uv.T
    assert left[(u > 0.02) & (u < 0.48) & (v > 0.52) & (v < 0.98)].max() == 0
    assert left[(u > 0.52) & (u < 0.98)] == pytest.approx(1, abs=1e-5)
    bare = Mesh(floor.positions, floor.triangles, floor.normals)
    with pytest.raises(MotesError, match="no texture coordinates"):
        deposit(bare, mask=mask)


def test_what_rubs_wipes_where_it_touches() -> None:
    floor = plane(64)
    other = block((-0.5, 0.005, -0.5), (0.5, 1, 0.5), 0)
    left = deposit(floor, rubbed_by=other, **EVEN).share
    inside = (np.abs(floor.positions[:, [0, 2]]) < 0.49).all(1)
    assert left[inside].max() == 0
    assert left[(np.abs(floor.positions[:, [0, 2]]) > 0.51).any(1)] == pytest.approx(1, abs=1e-5)


def test_noise_is_smooth_and_has_no_mean() -> None:
    rng = np.random.default_rng(5)
    x = rng.uniform(-50, 50, (40_000, 3))
    values = gradient_noise(x)
    assert abs(values.mean()) < 0.01
    assert 0.2 < values.std() < 0.4
    assert np.abs(values).max() <= 1
    assert np.abs(gradient_noise(x + 1e-4) - values).max() < 1e-3
    np.testing.assert_allclose(gradient_noise(np.array([[3.0, -4.0, 250.0]])), 0)  # at the grid's points
    assert np.abs(cloudy(x)).max() <= 1
    assert np.corrcoef(values, gradient_noise(x, seed=1))[0, 1] == pytest.approx(0, abs=0.05)
    floor = plane(32)
    noisy = deposit(floor, seed=1).share
    assert noisy.mean() == pytest.approx(1, abs=0.05)
    assert 0.02 < noisy.std() < 0.25
    np.testing.assert_array_equal(noisy, deposit(floor, seed=1).share)
    assert np.abs(noisy - deposit(floor, seed=2).share).max() > 0.05


# ---------------------------------------------------------------- tau


def test_tau_follows_the_phenomenon() -> None:
    assert open_tau(0) == 0
    assert open_tau(30) == pytest.approx(30 * 0.005)
    assert open_tau(30, growth_per_day=0.02) == pytest.approx(0.6)
    slate = age(Lambert(K_d=0.4), "dust", hours=240, tau_growth=0.7)
    assert open_tau(10, material=slate) == pytest.approx(0.7)
    assert open_tau(5, material=slate) == pytest.approx(0.35)
    constant = Material(DustLayer(Lambert(K_d=0.4), Dust(), tau=0.3))
    assert open_tau(99, material=constant) == pytest.approx(0.3)
    found = deposit(plane(2), **EVEN)
    np.testing.assert_allclose(found.tau(0.4), 0.4, atol=1e-6)


@pytest.mark.parametrize(
    ("values", "words"),
    [([0.1, np.nan], "1 of 2 .* not finite"), ([-0.1], "negative"), ([1e30, 0.1], "huge"), ([np.inf], "not finite")],
)
def test_tau_out_of_range_is_explained(values: list[float], words: str) -> None:
    with pytest.raises(ParameterError, match=words):
        checked_tau(np.array(values), "a mesh")


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: open_tau(-1), "days = -1"),
        (lambda: open_tau(float("nan")), "days = nan"),
        (lambda: open_tau(1, growth_per_day=-1), "growth_per_day"),
        (lambda: open_tau(1, material=Material(Lambert())), "no layer of dust"),
        (lambda: deposit(plane(1), stickiness=1), "no option 'stickiness'"),
        (lambda: deposit(plane(1), adhesion=2), r"adhesion = 2 is outside \[0, 1\]"),
        (lambda: deposit(plane(1), noise=10**400), "noise = .* is not a number"),
        (lambda: deposit(plane(1), up=(0, 0, 0)), "up = .* is not a direction"),
        (lambda: deposit(plane(1), wind=(0, 1, 0)), "straight along up"),
        (lambda: deposit(plane(1), rays=0), "rays = 0"),
        (lambda: deposit(Mesh(plane(1).positions, plane(1).triangles)), "no normals"),
        (lambda: deposit(plane(1), **EVEN).tau(float("nan")), "not finite"),
        (lambda: Stroke(np.zeros((0, 3)), 1.0), "points"),
        (lambda: Stroke(np.zeros((1, 3)), 0.0), "radius"),
        (lambda: Stroke(np.zeros((1, 3)), 1e-320), "radius"),
        (lambda: Stroke(np.full((1, 3), 1e308), 1.0), "within 1e\\+30"),
        (lambda: Stroke(np.full((1, 3), np.nan), 1.0), "within 1e\\+30"),
        (lambda: Stroke(np.zeros((1, 3)), 1.0, strength=2), "strength"),
        (lambda: bake(Mesh(plane(1).positions, plane(1).triangles, plane(1).normals)), "no texture coordinates"),
        (lambda: bake(plane(1), 0), "0 x 0"),
        (lambda: write_texture("a.png", np.zeros((2, 2), np.float32)), "not a texture"),
    ],
)
def test_what_cannot_be_is_explained(call: Any, words: str) -> None:
    with pytest.raises(MotesError, match=words):
        call()


# ---------------------------------------------------------------- textures


def test_a_baked_texture_says_what_the_vertices_say(tmp_path: Path) -> None:
    from motes.rendering import load_mitsuba

    mi = load_mitsuba()
    pot = teapot(8)
    baked = bake(pot, 512, rays=64, **EVEN)
    picture = baked.texture(0.5)
    tau = deposit(pot, rays=64, **EVEN).tau(0.5)
    difference = np.abs(look_up(picture.astype(float), pot.uv) - tau)
    # Tessellation hides some vertices behind their neighbours, and a texel sees the flat triangle beside them.
    assert np.quantile(difference, 0.9) < 0.02
    for suffix in (".exr", ".pfm"):
        stored = np.array(mi.Bitmap(str(write_texture(tmp_path / f"tau{suffix}", picture)))).squeeze()
        np.testing.assert_array_equal(stored if stored.ndim == 2 else stored[..., 0], picture)


def test_baking_is_upright() -> None:
    # A plane whose dust was wiped at u > 1/2, v > 1/2: the top right of the picture.
    floor = plane(4)
    stroke = Stroke(np.array([[1.0, 0, -1.0]]), 0.5, bristles=0)
    picture = bake(floor, 64, rays=16, strokes=[stroke], **EVEN).texture(1.0)
    assert picture[16, 48] == 0
    assert picture[[16, 48, 48], [16, 16, 48]] == pytest.approx(1, abs=1e-4)


@pytest.mark.parametrize("name", ["mask.png", "mask.exr", "mask.pfm"])
def test_masks_are_read(tmp_path: Path, name: str) -> None:
    from motes.rendering import load_mitsuba

    mi = load_mitsuba()
    painted = np.zeros((4, 6, 3), np.uint8 if name.endswith("png") else np.float32)
    painted[0, 1] = 255 if name.endswith("png") else 1
    mi.Bitmap(painted).write(str(tmp_path / name))
    mask = read_mask(tmp_path / name)
    assert mask.shape == (4, 6)
    assert mask[0, 1] == pytest.approx(1)
    assert mask.sum() == pytest.approx(1)


def test_masks_that_are_none_are_explained(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match="does not exist"):
        read_mask(tmp_path / "none.png")
    (tmp_path / "text.png").write_text("not a picture")
    with pytest.raises(FormatError, match="no picture of a known format"):
        read_mask(tmp_path / "text.png")


def test_the_scalar_variant_says_the_same() -> None:
    script = """
from motes.rendering import load_mitsuba
import sys
load_mitsuba(sys.argv[1])
from motes.rendering.deposition import deposit
from motes.rendering.baking import bake
from motes.meshes.shapes import sphere, plane
found = deposit(sphere(6), rays=8, wind=(1, 0, 0), noise=0, rubbed_by=plane(1))
print(*found.share.round(6).tolist())
print(*bake(plane(2), 4, rays=4).deposit.share.round(6).tolist())
"""
    said = [
        subprocess.run(
            [sys.executable, "-c", script, variant], capture_output=True, text=True, timeout=300, env=os.environ
        )
        for variant in ("scalar_rgb", "llvm_ad_rgb")
    ]
    assert [run.returncode for run in said] == [0, 0], said
    scalar, llvm = (np.array(run.stdout.split(), float) for run in said)
    np.testing.assert_allclose(scalar, llvm, atol=1e-4)
    assert len(scalar) > 100


def test_a_mesh_with_dust_comes_back_from_its_file(tmp_path: Path) -> None:
    from motes.meshes.ply import write_ply

    pot = teapot(4)
    tau = deposit(pot, rays=16).tau(0.3)
    back = read_mesh(write_ply(tmp_path / "dusty.ply", pot.with_attribute("tau", tau)))
    np.testing.assert_allclose(back.attributes["tau"], tau, atol=1e-7)
