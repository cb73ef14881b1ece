"""`motes.view`: a material, a fit or measured data to look at, in a notebook or as a page."""

from __future__ import annotations

import os
import webbrowser
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast, final, overload

from motes.errors import DataError, ParameterError
from motes.fitting.result import Fit
from motes.fitting.time_result import TimeFit
from motes.material import Material
from motes.measurements import Measurement
from motes.models import BRDF
from motes.viewer.contract import Payload
from motes.viewer.payload import as_material, payload

if TYPE_CHECKING:
    from motes.maps.fitted import FittedMap
    from motes.viewer.map_view import MapView

Viewable = Material | BRDF | Fit | TimeFit | Measurement


@final
class View:
    """What `view` returns: shown by a notebook as a widget, written to a file as a page.

    Attributes
    ----------
    payload
        What the page gets: plain JSON values.
    materials
        One or two.
    """

    def __init__(self, payload: Payload, materials: list[Material]) -> None:
        self.payload = payload
        self.materials = materials
        self._widget: Any = None

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write one self-contained HTML page that asks the network for nothing; returns its path."""
        from motes.viewer.page import write_page

        return write_page(self.payload, self.materials, path)

    def open(self, path: str | os.PathLike[str]) -> Path:
        """`save`, and open the page in the browser."""
        written = self.save(path)
        webbrowser.open(written.resolve().as_uri())
        return written

    @property
    def widget(self) -> Any:
        """The notebook's widget; its ``state`` follows what is set in it.

        Raises
        ------
        MissingExtraError
            Without the extra ``notebook``.
        """
        if self._widget is None:
            from motes.viewer.widget import make_widget

            self._widget = make_widget(self.payload)
        return self._widget

    def _repr_mimebundle_(self, **options: Any) -> Any:
        """How a notebook shows it."""
        return self.widget._repr_mimebundle_(**options)

    def __repr__(self) -> str:
        return f"View({', '.join(repr(material.name) for material in self.materials)})"


@overload
def view(
    what: Viewable,
    against: Viewable | None = None,
    *,
    data: Measurement | None = None,
    model: str = "auto",
    notes: tuple[str, ...] = (),
    fitted: Any = None,
) -> View: ...


@overload
def view(what: FittedMap, *, notes: tuple[str, ...] = ()) -> MapView: ...


def view(
    what: Viewable | FittedMap,
    against: Viewable | None = None,
    *,
    data: Measurement | None = None,
    model: str = "auto",
    notes: tuple[str, ...] = (),
    fitted: Any = None,
) -> View | MapView:
    """Look at a material: on a sphere, teapot, bunny or mesh of one's own, as a lobe, over its data, through time.

    Parameters
    ----------
    what
        A `Material` or a BRDF; a `Fit` or `TimeFit`, shown with its data; a `Measurement`, which is fitted first; or a `FittedMap`, whose page says at
        each texel what was fitted there.
    against
        A second one, to compare.
    data
        Points to show over the first, in place of those of a fit.
    model
        What measured data are fitted with.
    notes
        Sentences that the page shows.
    fitted
        The dictionary of the ``fit.json`` beside the first material, for what each scan said.

    Returns
    -------
    View
        In a notebook its value is the viewer (extra ``notebook``); ``.save("viewer.html")`` writes the page.  Of a map a `MapView`, which has
        ``save`` and ``open`` alone.

    Raises
    ------
    ParameterError
        When `what` is none of these, or a material has parameters for every direction.

    Examples
    --------
    >>> import motes
    >>> motes.view(motes.OrenNayar(K_d=(0.8, 0.7, 0.6), sigma_d=0.4))
    View('material')
    """
    if hasattr(what, "read_map"):  # a FittedMap, whose room needs the extra `scale`
        from motes.viewer.map_view import MapView

        if against is not None or data is not None:
            raise ParameterError("a map is shown alone", "Leave out `against` and `data`")
        return MapView(cast("FittedMap", what), notes)
    first, points, source = _resolved(what, model)
    materials = [first]
    if against is not None:
        materials.append(_resolved(against, model)[0])
    shown = payload(materials, data if data is not None else points, source or fitted, notes)
    return View(shown, materials)


def _resolved(what: Viewable, model: str) -> tuple[Material, Measurement | None, Fit | TimeFit | None]:
    """The material of what is looked at, with its data and fit where it has them."""
    if isinstance(what, (Material, BRDF)):
        return as_material(what), None, None
    if isinstance(what, (Fit, TimeFit)):
        return what.material, what.measurement, what
    if isinstance(what, Measurement):
        from motes.fitting import fit

        found = fit(what, model=model)
        return found.material, found.measurement, found
    if hasattr(what, "maps"):
        raise DataError("maps of parameters have a material for every texel", "Choose one texel")
    raise ParameterError(
        f"a {type(what).__name__} is neither a material nor a fit nor a measurement",
        "motes.load reads a material from its file, motes.read measured data",
    )
