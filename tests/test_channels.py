"""Names of channels: one convention for all rooms."""

from __future__ import annotations

import numpy as np
import pytest

from motes import Lambert, channels
from motes.ageing import age
from motes.drawing.colour import channels_to_srgb
from motes.exports.subject import subject
from motes.viewer.payload import as_material


@pytest.mark.parametrize("count", [1, 2, 3, 5])
def test_all_rooms_name_alike(count: int) -> None:
    brdf = Lambert(np.full(count, 0.3))
    names = channels.default_names(count)
    assert len(names) == count
    assert subject(brdf).channels == as_material(brdf).channels == age(brdf, "dust", hours=1).channels == names


def test_numbers_begin_at_one() -> None:
    assert channels.default_names(2) == ("channel 1", "channel 2")
    assert channels.names_or_default(["a", "b"], 2) == ("a", "b")
    assert channels.names_or_default(["a"], 3) == channels.names_or_default(None, 3) == ("R", "G", "B")
    assert channels.names_or_default("RGB", 3) == ("R", "G", "B")


def test_wavelengths_come_back() -> None:
    nm = (400.0, 412.5, 1100.0)
    assert channels.wavelengths_of(channels.spectral_names(nm)) == nm
    assert channels.wavelengths_of(("400 nm", "R")) is None
    assert channels.wavelengths_of(()) is None
    assert channels.wavelengths_of(("channel 1",)) is None


@pytest.mark.parametrize(
    ("names", "order"),
    [
        (("R", "G", "B"), (0, 1, 2)),
        (("blue", " Green", "RED"), (2, 1, 0)),
        (("R", "R", "B"), None),
        (("R", "G"), None),
        (("rough", "gloss", "bump"), None),
    ],
)
def test_colours_are_known_in_any_order(names: tuple[str, ...], order: tuple[int, int, int] | None) -> None:
    assert channels.colours_of(names) == order
    if order is not None:
        values = np.array([0.1, 0.2, 0.3])
        shown = values @ channels_to_srgb(names).matrix
        np.testing.assert_array_equal(shown[list(order)], values)
