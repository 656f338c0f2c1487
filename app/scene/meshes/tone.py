"""The renderer's tone mapping, and its inverse: which light a vertex must send out to be shown in a given colour.

viser's page draws with three.js and its "ACES filmic" tone mapping, after Stephen Hill's fit:
https://github.com/TheRealMJP/BakingLab/blob/master/BakingLab/ACES.hlsl
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.scene.meshes.palette import Colour

Numbers = NDArray[np.float64]

EXPOSURE: Final = 1 / 0.6  # as in three.js
INTO: Final = np.array([[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566], [0.02840, 0.13383, 0.83777]])
OUT_OF: Final = np.array([[1.60475, -0.53108, -0.07367], [-0.10208, 1.10813, -0.00605], [-0.00327, -0.07276, 1.07602]])
# The curve is (v (v + A) - B) / (v (C v + D) + E).
A, B, C, D, E = 0.0245786, 0.000090537, 0.983729, 0.4329510, 0.238081


def light_of(colour: Colour) -> Numbers:
    """Return the light (3,) that is shown as an sRGB colour; not over 1, which is shown as about (226, 226, 226)."""
    wanted = np.linalg.solve(OUT_OF, linear_of(colour))
    # The curve solved for v: a quadratic equation with one positive root.
    square, line, rest = 1 - C * wanted, A - D * wanted, -B - E * wanted
    values = (-line + np.sqrt(line * line - 4 * square * rest)) / (2 * square)
    light: Numbers = np.clip(np.linalg.solve(INTO, values) / EXPOSURE, 0.0, 1.0)
    return light


def linear_of(colour: Colour) -> Numbers:
    """Return the linear red, green and blue (3,) of an sRGB colour (IEC 61966-2-1)."""
    share = np.array(colour, dtype=np.float64) / 255
    return np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
