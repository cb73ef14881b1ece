"""glTF: the look of a dusty mesh, as a colour at each vertex and a material.

glTF's material has a diffuse colour, which vertices may have, and one highlight for all of them.  So the diffuse standard lobes of the model,
the dust's among them, are the colours; the highlight of what lies below is as strong as on the mean vertex.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.arrays import NUMPY
from motes.exports.subject import depth_of
from motes.meshes.glb import SECONDS, write_glb
from motes.meshes.mesh import Mesh
from motes.models import BRDF, Reflection, StandardLobe
from motes.models.standard import MEAN_COSINE

#: The reflectance at normal incidence of glTF's dielectrics.
NORMAL_REFLECTANCE = 0.04


@dataclass(frozen=True)
class Look:
    """Colours (V, 3), linear; the material of glTF; what it cannot say, a sentence each."""

    colours: NDArray[np.float64]
    material: dict[str, Any]
    notes: tuple[str, ...]


def write_gltf(
    path: Path, mesh: Mesh, model: BRDF, moments: Sequence[tuple[float, NDArray[np.float64]]], told: str
) -> tuple[str, ...]:
    """Write a mesh as it looks under dust; of several days, the first and an animation through the others.

    Parameters
    ----------
    path
        ``NAME.glb``.
    mesh
        With normals; it gets tau of the last day as an attribute.
    model
        What it is made of, with a layer of dust on top.
    moments
        Days, increasing, with tau (V,) then.
    told
        A sentence for the file.

    Returns
    -------
    tuple of str
        What the file cannot say, a sentence each.

    Raises
    ------
    ParameterError
        For a model without dust on top.
    DataError
        For other than one or three channels.
    """
    days = [day for day, _ in moments]
    looks = [dusty_look(model, tau, f"{mesh.name} under dust") for _, tau in moments]
    dusty = mesh.with_attribute("tau", moments[-1][1])
    later = [(day, look.colours) for day, look in zip(days[1:], looks[1:], strict=True)]
    write_glb(path, dusty, looks[0].colours, looks[-1].material, f"Motes; {told}", later=later, first=days[0])
    notes = looks[-1].notes
    if later:
        notes += (
            f"Colours change from day {days[0]:g} to {days[-1]:g} in an animation of {SECONDS:g} seconds, linearly between "
            f"the days given; tau in the file is that of the last.",
        )
        if "specularColorFactor" in looks[-1].material["extensions"]["KHR_materials_specular"]:
            notes += (f"The highlight is that after {days[-1]:g} days throughout.",)
    return notes


def dusty_look(model: BRDF, tau: NDArray[np.float64], name: str = "dusty") -> Look:
    """How a model with dust on top looks where its optical thickness is tau (V,).

    Raises
    ------
    ParameterError
        For a model without dust on top.
    DataError
        For other than one or three channels.
    """
    each = model.with_parameters({depth_of(model, "glTF"): np.asarray(tau, np.float64)[:, None]})
    lobes = each.standard_lobes(NUMPY, each, MEAN_COSINE)
    matte = sum(_reflected(lobe, len(tau)) for lobe in lobes if lobe.reflection is Reflection.DIFFUSE)
    colours = np.clip(np.zeros((len(tau), 3)) + matte, 0, 1)
    shiny = [lobe for lobe in lobes if lobe.reflection is Reflection.GLOSSY]
    notes = [
        "The colours are those under diffuse light; the phase function of the dust and its darkening to grazing are left out."
    ]
    surface: dict[str, Any] = {"metallicFactor": 0.0, "roughnessFactor": 1.0}
    specular: dict[str, Any] = {"specularFactor": 0.0}
    if shiny:
        strength = [(_reflected(lobe, len(tau)) * lobe.normal).mean(axis=0) for lobe in shiny]
        widest = int(np.argmax([s.mean() for s in strength]))
        alpha = float(np.ravel(shiny[widest].roughness)[0])
        surface["roughnessFactor"] = float(np.sqrt(np.clip(alpha, 0, 1)))  # glTF's alpha is the square
        specular = {
            "specularFactor": 1.0,
            "specularColorFactor": np.minimum(strength[widest] / NORMAL_REFLECTANCE, 1 / NORMAL_REFLECTANCE).tolist(),
        }
        notes.append(
            "The highlight is as strong on every vertex as it is on average: glTF has none that dust covers by the vertex."
        )
        if len(shiny) > 1:
            notes.append(f"Of {len(shiny)} highlights the strongest is kept.")
    material = {
        "name": name,
        "pbrMetallicRoughness": surface,
        "extensions": {"KHR_materials_specular": specular},
        "doubleSided": True,
    }
    return Look(colours, material, tuple(notes))


def _reflected(lobe: StandardLobe, count: int) -> NDArray[np.float64]:
    """The share of light (count, 3) that a lobe reflects."""
    tint = np.asarray(lobe.tint or 1.0, np.float64)
    return np.broadcast_to(np.asarray(lobe.reflectance, np.float64) * tint, (count, 3))
