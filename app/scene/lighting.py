"""Sun and sky of a plan; no shadows, which a tablet would have to draw."""

import math
from typing import Final

import viser

from app.world.scenery import Lights

FULL_SUN: Final = 3.14  # the renderer's intensity for 1
FULL_SKY: Final = 4.0
FAR: Final = 10_000.0  # m: its direction stays the same while the world moves
SKY: Final = (255, 255, 255)
REFLECTED: Final = (206, 208, 200)


class Lighting:
    """The lights on one 3D server. They hang under the world, so that a wall keeps its shade while the chair turns."""

    def __init__(self, server: viser.ViserServer) -> None:
        scene = server.scene
        self._sky = scene.add_light_hemisphere("/world/sky", sky_color=SKY, ground_color=REFLECTED)
        self._sun = scene.add_light_directional("/world/sun")
        self.shine(Lights())

    def shine(self, lights: Lights) -> None:
        """Let sun and sky be as a plan says."""
        out, up = FAR * math.cos(lights.elevation), FAR * math.sin(lights.elevation)
        self._sun.position = (out * math.cos(lights.azimuth), out * math.sin(lights.azimuth), up)
        self._sun.color = lights.colour
        self._sun.intensity = FULL_SUN * lights.sun
        self._sky.intensity = FULL_SKY * lights.sky
