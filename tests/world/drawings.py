"""DXF drawings for tests."""

from itertools import pairwise

import ezdxf

ROOM = [(0, 0), (8, 0), (8, 6), (0, 6), (0, 0)]


def drawing(unit=6):
    document = ezdxf.new("R2010")
    document.header["$INSUNITS"] = unit
    return document, document.modelspace()


def room_drawing(unit=6):
    """Return a drawing with the room in it, and its model space."""
    document, space = drawing(unit)
    room(space)
    return document, space


def room(space, scale=1.0, at=(0.0, 0.0), layer="WALLS"):
    points = [(at[0] + x * scale, at[1] + y * scale) for x, y in ROOM]
    for a, b in pairwise(points):
        space.add_line(a, b, dxfattribs={"layer": layer})
