"""The tools that judge dust and picture it: what they say of a model that is known to be right, or wrong, is so."""

from __future__ import annotations

import csv
import importlib.util
import re
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from catalogue import upper_directions
from motes import Lambert
from motes.directions import from_spherical

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "docs" / "dust.md").read_text(encoding="utf-8")
pytest.importorskip("PythonicDISORT")


def tool(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, ROOT / "tools" / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module  # where its dataclasses look for their annotations
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def errors() -> ModuleType:
    return tool("dust_errors")


def test_single_scattering_errs_as_is_known(errors: ModuleType) -> None:
    """Right in the thin limit, wrong by the factor that made the source's form a special case."""
    albedo, brdf = errors.errors_at(1e-4, 0.9, 0.3, "single")
    assert albedo < 2e-3  # of which the quadrature of the model's albedo has a part
    assert brdf < 1e-3
    albedo, brdf = errors.errors_at(1.0, 0.99, 0.3, "single")
    assert albedo > 0.7
    assert brdf > 0.5


def test_rows_of_a_table_are_judged(errors: ModuleType, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Three rows, of which single scattering is 20 % wrong in one: counted, and named as the worst."""
    from discrete_ordinates import layer

    rows = []
    for k, off in enumerate((1.0, 1.0, 0.8)):
        theta_i, tau = 0.3 + 0.1 * k, 1e-5
        truth = layer(Lambert(0.5), tau, 0.9, 0.3, theta_i, 16)
        at = int(np.argmin(abs(truth.cosines - 0.6)))
        rows.append(
            {"tau": tau, "w": 0.9, "g": 0.3, "base": 0.5, "theta_i": theta_i, "theta_r": np.arccos(truth.cosines[at]), "dphi": 1.0,
             "brdf": truth.brdf(1.0)[at, 0] * off, "albedo": truth.albedo, "spread": 0.0}
        )  # fmt: skip
    with (tmp_path / "rows.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    errors.golden(tmp_path / "rows.csv", "single")
    printed = capsys.readouterr().out
    (line,) = [line for line in printed.splitlines() if line.startswith("| all |")]
    cells = [cell.strip() for cell in line.strip("|").split("|")]
    assert cells[1:3] == ["3", "3"]
    assert float(cells[5]) < 0.1  # albedos are right
    assert cells[8] == "25"  # 1/0.8
    assert "+25 % at tau = 1e-05" in printed


@pytest.mark.parametrize("form", re.findall(r"<!-- table: (\w+) -->", PAGE))
def test_the_page_states_what_the_tool_measures(
    errors: ModuleType, shared: Callable[[str], Path], capsys: pytest.CaptureFixture[str], form: str
) -> None:
    """Every line of the table of each form of the model; the last digit may be rounded otherwise elsewhere."""
    errors.golden(shared("golden/dust_layer_exact.csv"), form)
    printed = [line for line in capsys.readouterr().out.splitlines() if re.match(r"\| (all|tau|w|g|base) ", line)]
    stated = PAGE.partition(f"<!-- table: {form} -->\n")[2].partition("\n\n")[0].splitlines()[2:]
    assert len(printed) == len(stated) == 17
    for one, other in zip(printed, stated, strict=True):
        (name, *measured), (named, *figures) = (
            [cell.strip() for cell in line.strip("|").split("|")] for line in (one, other)
        )
        assert name == named
        np.testing.assert_allclose(np.array(figures, float), np.array(measured, float), rtol=0.06, err_msg=name)


def test_the_page_states_what_the_furnace_keeps(errors: ModuleType, capsys: pytest.CaptureFixture[str]) -> None:
    """Every figure of its table; and single scattering, which loses most light, is told from it."""
    errors.furnace("multiple")
    printed = [line for line in capsys.readouterr().out.splitlines() if re.match(r"\| [-\d]", line)]
    stated = PAGE.partition("<!-- furnace -->\n")[2].partition("\n\n")[0].splitlines()[2:]
    assert len(printed) == len(stated) == 6
    for one, other in zip(printed, stated, strict=True):
        measured, figures = (np.array(line.strip("|").split("|"), float) for line in (one, other))
        np.testing.assert_allclose(figures, measured, rtol=0.1, atol=2e-3)
    errors.furnace("single")
    lost = [line for line in capsys.readouterr().out.splitlines() if re.match(r"\| [-\d]", line)]
    assert min(float(line.split("|")[2]) for line in lost) > 50


def test_a_highlight_under_dust_is_judged(errors: ModuleType) -> None:
    """In the thinnest dust nothing is wrong but noise; in thick dust single scattering is far too dark."""
    thin = errors.glossy_row("GGX", 0.3, 0.6, 1e-5, "single", 2**10).split(" | ")
    assert thin[:4] == ["GGX", "0.3", "0.6", "1e-05"]
    assert float(thin[5]) < 0.1
    thick = errors.glossy_row("Torrance-Sparrow", 0.3, 0.6, 1.0, "single", 2**10).split(" | ")
    assert float(thick[4]) > 50
    assert float(thick[7]) < -70


def test_a_picture_by_photons_is_of_the_surface() -> None:
    """Without dust it is the base, colour by colour; below the horizon it is black."""
    picture = tool("dust_picture")
    base, bases = picture.SURFACES["red, glossy"]
    wi, wo = upper_directions(50, 1), upper_directions(50, 2)
    wi, wo = wi[wi[:, 2] > 0.01], wo[wi[:, 2] > 0.01]
    wo = wo / np.linalg.norm(wo, axis=1, keepdims=True)
    seen = picture.Followed(bases, 0.0, 4).eval(wi, wo)
    above = wo[:, 2] > 1e-3
    np.testing.assert_allclose(seen[above], base.eval(wi, wo)[above], rtol=1e-10)
    low = from_spherical(np.array([1.5707]), np.array([0.0]))
    np.testing.assert_array_equal(picture.Followed(bases, 1.0, 4).eval(low, wo[:1]), 0.0)
