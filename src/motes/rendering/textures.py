"""The parameters of a model as textures of Mitsuba: read from a scene, checked, and looked up where light meets a surface."""

from __future__ import annotations

import difflib
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes import arrays
from motes.arrays import Array
from motes.errors import ParameterError
from motes.models import BRDF
from motes.parameters import Parameter, Slot
from motes.rendering.beforehand import Numbers

Path = tuple[str, ...]


@dataclass
class Value:
    """A parameter and where its values come from; what the texture returns is multiplied by `scale`."""

    slot: Slot
    texture: Any
    scale: float = 1.0
    #: What it is everywhere, a float or an array of channels; None where it may differ from place to place.
    uniform: Array | None = None

    def look(self, mi: Any) -> None:
        """Read `uniform` from the texture: once it is made, and whenever it was changed."""
        name, per_channel = self.texture.class_name(), self.slot.parameter.per_channel
        even = name.startswith("Uniform") or (name.startswith("SRGB") and not mi.is_spectral)
        # In variants that do not compile there is nothing to compute beforehand.
        leaf = dict(mi.traverse(self.texture)).get("value") if even and not mi.variant().startswith("scalar") else None
        found = np.empty(0) if leaf is None else np.asarray(leaf, np.float64).ravel()
        if found.size == 0 or found.size not in (1, len(mi.UnpolarizedSpectrum(0.0)) if per_channel else 1):
            self.uniform = None
            return
        low, high = self._ends()
        # NaN becomes the lower end, as below.
        found = np.minimum(np.where(found * self.scale >= low, found * self.scale, low), high)
        self.uniform = float(found[0]) if (found == found[0]).all() else found

    def _ends(self) -> tuple[float, float]:
        parameter = self.slot.parameter
        low, high = parameter.bounds
        hair = 1e-6 * (high - low) if parameter.open else 0.0
        return low + hair, high - hair

    def at(self, dr: Any, si: Any, active: Any) -> Array:
        """The value where a ray meets the surface, kept within the declared bounds.

        Constants were checked before.  A texture may still go out of bounds (a mesh attribute, a step of an optimiser): it
        is cut off there, and NaN becomes the lower bound.  At a bound the gradient passes.
        """
        parameter = self.slot.parameter
        value = self.texture.eval(si, active) if parameter.per_channel else self.texture.eval_1(si, active)
        if self.scale != 1:
            value = value * self.scale
        low, high = self._ends()
        value = dr.select(value >= low, value, low)
        return dr.select(value <= high, value, high) if np.isfinite(high) else value


class Found(NamedTuple):
    """A model with its values where rays meet a surface.

    Attributes
    ----------
    xp
        The namespace of its values.
    model
        A value per channel is one of Mitsuba's spectra, or an array of channels that is known.
    averaged
        The same, to decide where to sample: means over the channels, and nothing has a gradient.
    """

    xp: Any
    model: BRDF
    averaged: BRDF


@dataclass
class Values:
    """All parameters of a model.

    Parameters
    ----------
    mi
        Mitsuba, with a variant set.
    owner
        The plugin's name, for messages.
    template
        The model; its values are the defaults.
    wavelengths
        Of the channels of the template's arrays [nm]; empty when they are red, green and blue.
    """

    mi: Any
    owner: str
    template: BRDF
    wavelengths: tuple[float, ...] = ()
    given: dict[Path, Value] = field(default_factory=dict)
    values: dict[Path, Value] = field(default_factory=dict)
    #: The model where all parameters are uniform, with what was computed of it.
    _uniform: Found | None = None

    def read_parameters(self, properties: Any, others: tuple[str, ...] = (), skip: tuple[Path, ...] = ()) -> None:
        """Take from a plugin's properties what is there, and the template's values for the rest.

        `others` are names that mean something else to the plugin; the parameters at `skip` are not its own.
        """
        slots = [slot for slot in self.template.slots() if slot.path not in skip]
        names = [slot.name for slot in slots]
        for key in properties:
            if key in names or key in others or key.startswith("_arg") or _is(self.mi, properties, key, "BSDF"):
                continue
            close = difflib.get_close_matches(key, [*names, *others], n=1, cutoff=0.4)
            raise ParameterError(
                f"{self.owner} has no parameter {key!r}",
                f"Did you mean {close[0]}?" if close else f"It has {', '.join([*names, *others])}",
            )
        self.given = {slot.path: self._from(properties, slot) for slot in slots if slot.name in properties}
        self.values = {slot.path: self.given.get(slot.path) or self._constant(slot) for slot in slots}
        self.look()

    def renew(self, template: BRDF) -> None:
        """Take the values of another template, but for what the scene gives itself."""
        self.template = template
        for slot in template.slots():
            if slot.path in self.values and slot.path not in self.given:
                self.values[slot.path] = self._constant(slot)
        self.look()

    def look(self) -> None:
        """Read anew what is uniform: after textures were changed."""
        self._uniform = None
        for value in self.values.values():
            value.look(self.mi)

    def models(self, si: Any, active: Any) -> Found:
        """The model with its values where rays meet the surface.

        What is uniform and has no gradient is known beforehand, and so is what is computed of it alone (`motes.rendering.beforehand`).
        """
        import drjit as dr

        found = {path: value.at(dr, si, active) for path, value in self.values.items()}
        mean = {
            path: dr.detach(dr.mean(value) if self.values[path].slot.parameter.per_channel else value)
            for path, value in found.items()
        }
        if self.mi.variant().startswith("scalar"):
            return Found(arrays.namespace(si.wi), _filled(self.template, found), _filled(self.template, mean))
        # A function that is frozen finds the variables of textures, and would keep what was computed of them beforehand.
        freezing = getattr(dr.JitFlag, "FreezingScope", None)
        even = {} if freezing is not None and dr.flag(freezing) else self._even()
        attached = {path for path in even if dr.grad_enabled(found[path])}
        whole = len(even) == len(found) and not attached
        if whole and self._uniform is not None:
            return self._uniform
        xp = Numbers(self.mi)
        full = {p: xp.known(even[p]) if p in even and p not in attached else xp.differing(found[p]) for p in found}
        rest = {p: xp.known(np.mean(even[p])) if p in even else xp.differing(mean[p]) for p in found}
        result = Found(xp, _filled(self.template, full), _filled(self.template, rest))
        if whole:
            self._uniform = result
        return result

    def _even(self) -> dict[Path, Array]:
        return {path: value.uniform for path, value in self.values.items() if value.uniform is not None}

    def textures(self) -> Iterator[tuple[str, Any]]:
        """Names and textures, for ``mitsuba.traverse``."""
        for value in self.values.values():
            yield value.slot.name, value.texture

    # ------------------------------------------------------------ reading one parameter

    def _from(self, properties: Any, slot: Slot) -> Value:
        kind, name, parameter = self.mi.Properties.Type, slot.name, slot.parameter
        found = properties.type(name)
        if found not in (kind.Float, kind.Integer, kind.Color, kind.Object, kind.Spectrum):
            self._refuse(parameter, f"is a {found.name.lower()}")
        if not parameter.per_channel and found in (kind.Color, kind.Spectrum):
            self._refuse(parameter, "is a colour, but one number serves all channels")
        if found in (kind.Float, kind.Integer):
            parameter.check(self.owner, float(properties.get(name)))
        if found == kind.Color:
            color = np.array(properties.get(name), np.float64).ravel()
            parameter.check(self.owner, color)
            if self.mi.is_spectral and color.max() > 1:
                return self._color(slot, color)
        if found == kind.Object and not _is(self.mi, properties, name, "Texture"):
            self._refuse(parameter, f"is a {type(properties.get(name)).__name__}")
        texture = properties.get_unbounded_texture(name)
        if found in (kind.Object, kind.Spectrum):
            self._check(parameter, texture)
        return Value(slot, texture)

    def _constant(self, slot: Slot) -> Value:
        value = np.asarray(slot.value, np.float64)
        if value.ndim > 1 or (value.ndim and not slot.parameter.per_channel):
            self._refuse(
                slot.parameter, f"has the shape {value.shape}", "Give a texture for what varies over a surface"
            )
        if value.size == 1:
            return Value(slot, self.mi.load_dict({"type": "uniform", "value": float(value.ravel()[0])}))
        if self.wavelengths:
            pairs = [(float(nm), float(v)) for nm, v in zip(self.wavelengths, value, strict=True)]
            return Value(slot, self.mi.load_dict({"type": "spectrum", "value": sorted(pairs)}))
        if value.size != 3:
            self._refuse(
                slot.parameter, f"has {value.size} channels of unknown wavelengths", "Mitsuba takes RGB or spectra"
            )
        return self._color(slot, value)

    def _color(self, slot: Slot, color: NDArray[np.float64]) -> Value:
        """A constant colour, also above 1; spectra are made of colours up to 1 only, so there a larger one is scaled."""
        scale = float(color.max()) if self.mi.is_spectral and color.max() > 1 else 1.0
        scaled = self.mi.ScalarColor3f((color / scale).tolist())
        texture = self.mi.load_dict({"type": "srgb", "color": scaled, "unbounded": not self.mi.is_spectral})
        return Value(slot, texture, scale)

    def _check(self, parameter: Parameter, texture: Any) -> None:
        """Refuse a texture whose numbers can be read and are out of bounds, or that cannot be asked for what is needed."""
        mi = self.mi
        name = texture.class_name()
        if not parameter.per_channel and name.startswith(("SRGB", "Regular", "Irregular", "D65", "BlackBody")):
            self._refuse(parameter, "is a colour or spectrum, but one number serves all channels")
        if name.startswith("Bitmap"):
            import drjit as dr

            try:  # a picture at a place of no meaning: only to hear whether it answers
                si = dr.zeros(mi.SurfaceInteraction3f)
                texture.eval(si) if parameter.per_channel else texture.eval_1(si)
            except RuntimeError:
                raw = "false" if parameter.per_channel else "true"
                self._refuse(parameter, "is a picture of the wrong kind", f"Set raw to {raw} on the bitmap")
        coefficients = mi.is_spectral and parameter.per_channel  # of spectra, not values
        for key, leaf in mi.traverse(texture):
            last = key.rsplit(".", 1)[-1]
            if last == "values" or (last in ("value", "data") and (not coefficients or name.startswith("Uniform"))):
                parameter.check(self.owner, np.asarray(leaf, np.float64))

    def _refuse(self, parameter: Parameter, what: str, hint: str = "") -> None:
        raise ParameterError(f"{self.owner}: {parameter.name} {what} ({parameter.doc})", hint or parameter.hint())


def _filled(model: Any, values: dict[Path, Array]) -> Any:
    """A copy with values put in as they are: they were checked, and in scalar variants this happens at every ray."""
    clone = object.__new__(type(model))
    clone.__dict__.update(model.__dict__)
    inner: dict[str, dict[Path, Array]] = {}
    for path, value in values.items():
        if len(path) == 1:
            clone.__dict__[path[0]] = value
        else:
            inner.setdefault(path[0], {})[path[1:]] = value
    for name, part in inner.items():
        clone.__dict__[name] = _filled(clone.__dict__[name], part)
    return clone


def _is(mi: Any, properties: Any, key: str, kind: str) -> bool:
    """Whether a property is an object of Mitsuba of this kind."""
    if properties.type(key) != mi.Properties.Type.Object:
        return False
    return isinstance(properties.get(key), getattr(mi, kind))
