"""Meshes with a colour at each vertex, drawn without lights: light and shade of a room are part of the colours."""

import math
from collections.abc import Iterable
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.scene.lighting import FULL_SKY, FULL_SUN, REFLECTED
from app.scene.meshes.bodies import Mesh, merged
from app.scene.meshes.palette import Colour
from app.scene.meshes.tone import light_of, linear_of
from app.world.scenery import Lights

Numbers = NDArray[np.float64]
DEFAULT_LIGHTS: Final = Lights()


class PaintedPart(NamedTuple):
    """A mesh with the light (n, 3) that each of its vertices sends out, drawn with one call and without lights.

    Light is linear red, green and blue before the renderer's tone mapping, 0 to 1. Colours between two vertices are
    interpolated.
    """

    mesh: Mesh
    light: Numbers


def painted(mesh: Mesh, colour: Colour, lights: Lights, shade: Numbers | float = 1.0) -> PaintedPart:
    """Return a mesh that has the shown `colour` where the default lights fall on it most directly.

    Parameters
    ----------
    mesh
        Its faces share no vertex across an edge that is to look sharp.
    colour
        As on the screen (sRGB), for a horizontal face, and for an upright face towards the default sun.
    lights
        Of the plan; dimmer lights make the mesh darker.
    shade
        Share of the light that reaches each vertex, (n,), or all of them.
    """
    normals = _normals(mesh)
    flat = np.hypot(normals[:, 0], normals[:, 1])
    azimuth = DEFAULT_LIGHTS.azimuth
    towards_sun = np.stack([flat * math.cos(azimuth), flat * math.sin(azimuth), normals[:, 2]], axis=1)
    share = irradiance(normals, lights) / irradiance(towards_sun, DEFAULT_LIGHTS)
    light = light_of(colour) * share * np.broadcast_to(shade, len(normals))[:, np.newaxis]
    return PaintedPart(mesh, np.clip(light, 0.0, 1.0))


def joined(parts: Iterable[PaintedPart]) -> PaintedPart:
    """Return one part of several."""
    several = list(parts)
    light = np.concatenate([part.light for part in several]) if several else np.zeros((0, 3))
    return PaintedPart(merged(part.mesh for part in several), light)


def irradiance(normals: Numbers, lights: Lights) -> Numbers:
    """Return red, green and blue (n, 3) that sun and sky of a plan send to faces with these unit normals (n, 3)."""
    out, up = math.cos(lights.elevation), math.sin(lights.elevation)
    sun = np.array([out * math.cos(lights.azimuth), out * math.sin(lights.azimuth), up])
    direct = np.maximum(normals @ sun, 0.0)[:, np.newaxis] * linear_of(lights.colour)
    upward = (0.5 + 0.5 * normals[:, 2])[:, np.newaxis]
    around = upward + (1.0 - upward) * linear_of(REFLECTED)
    total: Numbers = (FULL_SUN * lights.sun * direct + FULL_SKY * lights.sky * around) / math.pi
    return total


def _normals(mesh: Mesh) -> Numbers:
    """Return the unit normal (n, 3) of each vertex, from the faces that it belongs to."""
    a, b, c = (mesh.vertices[mesh.faces[:, corner]] for corner in range(3))
    across = np.cross(b - a, c - a)
    sums = np.zeros_like(mesh.vertices)
    for corner in range(3):
        np.add.at(sums, mesh.faces[:, corner], across)
    lengths = np.linalg.norm(sums, axis=1)[:, np.newaxis]
    normals: Numbers = sums / np.where(lengths > 0, lengths, 1.0)
    return normals
