"""Sun and sky of a plan, without shadows: drawing them is too slow on a tablet."""

import math
from typing import Final

import viser

from app.world.scenery import Lights

FULL_SUN: Final = 3.14  # the renderer's intensity for a sun of 1
FULL_SKY: Final = 4.0  # the renderer's intensity for a sky of 1
FAR: Final = 10_000.0  # m, distance of the sun: its direction hardly changes while the world is moved
SKY: Final = (255, 255, 255)
REFLECTED: Final = (206, 208, 200)


class Lighting:
    """The lights on one 3D server; children of the world's node, so that a wall's shade stays when the chair turns."""

    def __init__(self, server: viser.ViserServer) -> None:
        scene = server.scene
        self._sky = scene.add_light_hemisphere("/world/sky", sky_color=SKY, ground_color=REFLECTED)
        self._sun = scene.add_light_directional("/world/sun")
        self.shine(Lights())

    def shine(self, lights: Lights) -> None:
        """Set sun and sky as a plan describes them."""
        out, up = FAR * math.cos(lights.elevation), FAR * math.sin(lights.elevation)
        self._sun.position = (out * math.cos(lights.azimuth), out * math.sin(lights.azimuth), up)
        self._sun.color = lights.colour
        self._sun.intensity = FULL_SUN * lights.sun
        self._sky.intensity = FULL_SKY * lights.sky
