"""The film before a browser's camera: one picture of a person who moves, written anew while the browser plays it.

Chromium reads each picture of a film of raw pictures (Y4M) from the file when it is due, and after the last one the
first again. A picture that is half written shows two postures that follow each other: no harm.
"""

import math
import os
from pathlib import Path

import numpy as np
from PIL import Image

STEP = 32  # px between two points of the grid that is moved
LEAN = 60.0  # px by which the upper edge moves to the side in a full lean; the lower edge stays
ROLL = 0.2  # rad, of the head
HEAD_AT = (291.0, 108.0)  # px, the middle of the head
HEAD_RADIUS, HEAD_EDGE = 100.0, 160.0  # px: within the radius all turns, beyond the edge nothing
SHRUG = 30.0  # px, of a shoulder
SHOULDERS_AT = {"right_shoulder": (174.0, 250.0), "left_shoulder": (403.0, 240.0)}  # px; her right is at our left
SHOULDER_RADIUS = 70.0  # px
NOISE = 4.0  # of 255: what a camera makes of light
NOISES = 8  # fields of noise, in turn
LUMA = [16 + value * 219 // 255 for value in range(256)]
CHROMA = [128 + (value - 128) * 224 // 255 for value in range(256)]
"""The numbers of video for those of a picture: of brightness, and of colour."""


def lean_angle(level):
    """Return the angle (rad) by which a person of this lean is tilted in a picture 480 px high."""
    return math.atan(LEAN * level / 480.0)


def moved_points(levels, size):
    """Return where in the picture at rest each point of the grid is taken from, (rows, columns, 2), px.

    `levels` has those of trunk, head, right_shoulder and left_shoulder, 0 (rest) to 1; `size` is width and height, px.
    """
    width, height = size
    x, y = np.meshgrid(np.arange(0, width + 1, STEP, dtype=np.float64), np.arange(0, height + 1, STEP))
    to_the_side = LEAN * levels["trunk"] * (1.0 - y / height)
    down = np.zeros_like(x)
    beside, below = x - HEAD_AT[0], y - HEAD_AT[1]
    turned = np.clip((HEAD_EDGE - np.hypot(beside, below)) / (HEAD_EDGE - HEAD_RADIUS), 0.0, 1.0)
    to_the_side -= ROLL * levels["head"] * turned * below
    down += ROLL * levels["head"] * turned * beside
    for joint, (at_x, at_y) in SHOULDERS_AT.items():
        distance = ((x - at_x) ** 2 + (y - at_y) ** 2) / SHOULDER_RADIUS**2
        down -= SHRUG * levels[joint] * np.exp(-distance / 2.0)
    return np.stack((np.clip(x - to_the_side, 0.0, width), np.clip(y - down, 0.0, height)), axis=2)


def moved(plane, points, scale):
    """Return a plane of a picture, of which the grid is taken from `points` times `scale`."""
    step, taken = round(STEP * scale), (points * scale).tolist()
    pieces = []
    for row in range(len(taken) - 1):
        above, below = taken[row], taken[row + 1]
        for column in range(len(above) - 1):
            box = (column * step, row * step, (column + 1) * step, (row + 1) * step)
            corners = (*above[column], *below[column], *below[column + 1], *above[column + 1])
            pieces.append((box, corners))
    return plane.transform(plane.size, Image.Transform.MESH, pieces, Image.Resampling.BILINEAR)


class Film:
    """A film of one picture, whose sides are multiples of STEP."""

    def __init__(self, file: Path, picture: Image.Image) -> None:
        width, height = self._size = picture.size
        luma, *chroma = picture.convert("YCbCr").split()
        self._luma = luma.point(LUMA)
        self._chroma = [plane.point(CHROMA).reduce(2) for plane in chroma]
        random = np.random.default_rng(1)
        self._noises = [np.rint(random.normal(0.0, NOISE, (height, width))).astype(np.int16) for _ in range(NOISES)]
        self._shown = 0
        head = f"YUV4MPEG2 W{width} H{height} F30:1 Ip A1:1 C420jpeg\nFRAME\n".encode("ascii")
        self._begin = len(head)
        self._file = os.open(file, os.O_RDWR | os.O_CREAT | os.O_TRUNC, 0o600)
        os.write(self._file, head)
        self.show(dict.fromkeys(("trunk", "head", *SHOULDERS_AT), 0.0))

    def show(self, levels):
        """Let the person take a posture, in pictures with other noise than the one before."""
        points = moved_points(levels, self._size)
        self._shown += 1
        luma = np.asarray(moved(self._luma, points, 1.0), dtype=np.int16) + self._noises[self._shown % NOISES]
        chroma = b"".join(moved(plane, points, 0.5).tobytes() for plane in self._chroma)
        os.pwrite(self._file, np.clip(luma, 16, 235).astype(np.uint8).tobytes() + chroma, self._begin)

    def close(self):
        """Write no more."""
        os.close(self._file)
