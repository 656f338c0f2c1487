"""How large a file may be of which a floor plan is made; of a floor plan itself it is MAX_BYTES in floorplan.py."""

from typing import Final

MOST_PLAN_BYTES: Final = 20_000_000  # of a drawing, a picture, or the picture of a map
MOST_MAP_BYTES: Final = 100_000  # of a map's YAML file, which has six lines
