"""The colours of the drawn world: light walls, calm floors, the chair in the product's teal.

The colours from FLOOR to DOOR_HANDLE are those on the screen (sRGB); all others are lit by sun and sky.
"""

from typing import Final

Colour = tuple[int, int, int]

FLOOR: Final[Colour] = (146, 154, 149)
FLOOR_TILE: Final[Colour] = (166, 173, 167)
WALL: Final[Colour] = (220, 221, 217)
WALL_TOP: Final[Colour] = (106, 122, 137)
CEILING: Final[Colour] = (184, 190, 194)
LAMP: Final[Colour] = (226, 226, 226)
SKIRTING: Final[Colour] = (66, 78, 90)
DOOR: Final[Colour] = (116, 74, 44)
DOOR_LEAF: Final[Colour] = (146, 92, 54)
DOOR_HANDLE: Final[Colour] = (58, 64, 70)
PATH: Final[Colour] = (255, 255, 255)
PATH_EDGE: Final[Colour] = (92, 114, 132)
GOAL: Final[Colour] = (11, 107, 107)
DRIVEN: Final[Colour] = (200, 30, 30)

WOOD: Final[Colour] = (184, 148, 108)
DARK_WOOD: Final[Colour] = (142, 110, 82)
FABRIC: Final[Colour] = (104, 134, 162)
LINEN: Final[Colour] = (240, 241, 238)
CERAMIC: Final[Colour] = (248, 250, 250)
METAL: Final[Colour] = (156, 166, 174)
LEAF: Final[Colour] = (104, 150, 106)
DARK: Final[Colour] = (62, 72, 82)
ACCENT: Final[Colour] = (226, 170, 92)

FRAME: Final[Colour] = (14, 124, 124)
TYRE: Final[Colour] = (48, 54, 60)
CUSHION: Final[Colour] = (74, 86, 98)
SKIN: Final[Colour] = (224, 182, 152)
HAIR: Final[Colour] = (92, 70, 54)
SHIRT: Final[Colour] = (94, 168, 180)
TROUSERS: Final[Colour] = (70, 92, 130)

SAND: Final[Colour] = (206, 176, 128)
SAND_RIPPLE: Final[Colour] = (190, 159, 112)
GRASS: Final[Colour] = (116, 150, 92)
GRASS_TUFT: Final[Colour] = (102, 137, 80)
ASPHALT: Final[Colour] = (112, 117, 122)
ASPHALT_SEAM: Final[Colour] = (96, 101, 107)
VERGE: Final[Colour] = (128, 150, 106)
HORIZON: Final[Colour] = (196, 208, 212)
ROCK: Final[Colour] = (146, 126, 106)
PALE_ROCK: Final[Colour] = (168, 148, 124)
CONE: Final[Colour] = (236, 104, 24)
MARK: Final[Colour] = (240, 178, 32)
LATER: Final[Colour] = (142, 156, 166)
JACKET: Final[Colour] = (206, 88, 52)

DRIVEN_STROKE: Final = "#c81e1e"
PRESCRIBED_STROKE: Final = "#1d5fa8"
"""The prescribed path is blue in plots; on the floor it is white, which is easier to see from a chair."""
