"""The chair's footprint: the circle that touches walls, obstacles, cones and moving things."""

from typing import Final

CHAIR_RADIUS: Final = 0.32  # m; a powered chair is 0.64 m wide
