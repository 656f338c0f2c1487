"""The colours that three.js shows of unlit vertex colours: its ACES filmic tone mapping, then sRGB."""

import numpy as np

# As in three.js, src/renderers/shaders/ShaderChunk/tonemapping_pars_fragment.glsl.js, by rows.
INTO = [[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566], [0.02840, 0.13383, 0.83777]]
OUT_OF = [[1.60475, -0.53108, -0.07367], [-0.10208, 1.10813, -0.00605], [-0.00327, -0.07276, 1.07602]]


def linear_shown(light):
    """Return the linear red, green and blue (..., 3) on the screen, 0 to 1."""
    v = np.asarray(light) / 0.6 @ np.transpose(INTO)
    v = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081)
    return np.clip(v @ np.transpose(OUT_OF), 0.0, 1.0)


def shown(light):
    """Return the sRGB colours (..., 3) on the screen, 0 to 255."""
    linear = linear_shown(light)
    return 255 * np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def luminance(light):
    """Return the relative luminance (...,) on the screen, as WCAG 2.2 defines it."""
    return linear_shown(light) @ (0.2126, 0.7152, 0.0722)


def contrast(one, other):
    """Return the contrast of two luminances, as WCAG 2.2 defines it."""
    return (max(one, other) + 0.05) / (min(one, other) + 0.05)
