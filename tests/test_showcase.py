"""What the README and docs/viewer.md show is what Motes finds today, and what is true of the simulated plaster."""

from __future__ import annotations

import base64
import importlib.util
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import motes
from motes.cli.demo_command import true_trends
from motes.viewer.contract import Payload

ROOT = Path(__file__).resolve().parents[1]
#: Another machine's last digits, in standard errors.
SAME = 0.05
#: How many standard errors a number may be from the truth: there are about 20 of them, and 1 in 300 is beyond 3.
NEAR = 3.5


def tool() -> Any:
    """``tools/viewer_pictures.py`` as a module."""
    spec = importlib.util.spec_from_file_location("viewer_pictures", ROOT / "tools" / "viewer_pictures.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


viewer_pictures = tool()


@pytest.fixture(scope="module")
def shown() -> Any:
    """What the example page holds."""
    return json.loads(viewer_pictures.embedded(viewer_pictures.EXAMPLE))


@pytest.fixture(scope="module")
def fresh() -> Payload:
    """What it would hold today."""
    return motes.view(viewer_pictures.fit()).payload


def course(page: Any, name: str) -> dict[str, Any]:
    """A parameter over time: ``hours`` (M,), ``values`` and ``stderr`` (M, W), its ``kind`` and its ``scans``."""
    time = page["materials"][0]["time"]
    return {"hours": time["hours"], **time["trends"][name]}


def test_the_page_shows_todays_fit(shown: Any, fresh: Payload) -> None:
    old, new = shown["materials"][0], fresh["materials"][0]
    assert new["time"] is not None
    assert old["json"]["model"] == new["json"]["model"]
    assert list(old["time"]["trends"]) == list(new["time"]["trends"])
    assert old["time"]["hours"] == pytest.approx(new["time"]["hours"])
    for name in new["time"]["trends"]:
        was, now = course(shown, name), course(fresh, name)
        assert was["kind"] == now["kind"], name
        for a, b in ((was, now), (was["scans"], now["scans"])):
            error = np.array(b["stderr"], float)
            assert np.all(np.abs(np.subtract(a["values"], b["values"])) < SAME * error), name
            assert np.allclose(np.array(a["stderr"], float), error, rtol=0.05), name
    assert old["json"]["name"] == new["json"]["name"]
    assert old["json"]["channels"] == new["json"]["channels"]
    assert old["json"]["about"]["data"] == new["json"]["about"]["data"]


def test_the_page_shows_todays_data(shown: Any, fresh: Payload) -> None:
    old, new = shown["measurement"], fresh["measurement"]
    assert new is not None
    for name in ("wi", "wo", "values"):
        a, b = (np.frombuffer(base64.b64decode(x[name]), "<f4") for x in (old, new))  # type: ignore[literal-required]
        np.testing.assert_allclose(a, b, rtol=1e-6, atol=1e-7)
    assert old["hours"] == pytest.approx(new["hours"])
    assert shown["notes"] == fresh["notes"]


@pytest.mark.parametrize("name", true_trends(6.0))
def test_the_page_shows_the_truth(shown: Any, name: str) -> None:
    truth, found = true_trends(6.0)[name], course(shown, name)
    assert found["kind"] == truth["kind"]
    for at, when in ((0, "first"), (-1, "last")):
        distance = np.atleast_1d(truth[when]) - np.array(found["values"][at])
        assert np.all(np.abs(distance) < NEAR * np.array(found["stderr"][at])), (name, when)


@pytest.mark.parametrize("name", true_trends(6.0))
def test_curves_of_the_page_run_through_their_dots(shown: Any, name: str) -> None:
    found = course(shown, name)
    scans = found["scans"]
    values, error = np.array(scans["values"], float), np.array(scans["stderr"], float)
    curve = np.stack(
        [np.interp(scans["hours"], found["hours"], column) for column in np.transpose(found["values"])], axis=1
    )
    off = ((values - curve) / error)[np.isfinite(error)]
    assert off.size >= 0.8 * error.size
    assert np.sqrt(np.mean(off**2)) < 2, name


def test_the_page_says_that_the_data_are_simulated(shown: Any) -> None:
    assert shown["notes"][0].startswith("The data are not measured: simulated by Motes")
    assert shown["materials"][0]["json"]["about"]["data"]["simulated"] is True


@pytest.mark.parametrize("name", [shot[0] for shot in viewer_pictures.SHOTS])
def test_pictures_are_of_the_page(name: str) -> None:
    with Image.open(viewer_pictures.PICTURES / f"{name}.png") as picture:
        assert picture.info.get(viewer_pictures.DIGEST) == viewer_pictures.digest(viewer_pictures.EXAMPLE)
