"""Checks of the pictures in a GLB file by their headers, before any picture is unpacked."""

import base64
import binascii
import io
from collections.abc import Iterable
from typing import Final

from PIL import Image

FORMATS: Final = ("PNG", "JPEG")  # glTF 2.0, section 3.8: others need an extension
MOST_PIXELS: Final = 16_000_000  # of one picture
MOST_PIXELS_IN_ALL: Final = 64_000_000  # a picture counts for each mention, since the reader unpacks it for each


def check_pictures(pictures: Iterable[bytes | str]) -> None:
    """Refuse pictures, as bytes or as a data URI, that have too many pixels or are neither PNG nor JPEG.

    Raises
    ------
    ValueError
        Half a sentence that says what is wrong and what to do.
    """
    total = 0
    for picture in pictures:
        width, height = _size(picture if isinstance(picture, bytes) else _decoded(picture))
        total += width * height
        if width * height > MOST_PIXELS:
            raise ValueError(
                f"a picture on it is {width:,} x {height:,} pixels large, and at most {MOST_PIXELS:,} pixels are read: "
                f"make it smaller"
            )
        if total > MOST_PIXELS_IN_ALL:
            raise ValueError(f"its pictures have more than {MOST_PIXELS_IN_ALL:,} pixels in all: use fewer of them")


def _decoded(address: str) -> bytes:
    try:
        return base64.b64decode(address.partition(",")[2], validate=True)
    except binascii.Error as error:
        raise ValueError("a picture on it is damaged: export it again") from error


def _size(content: bytes) -> tuple[int, int]:
    try:
        with Image.open(io.BytesIO(content), formats=FORMATS) as picture:
            return picture.size
    except (Image.DecompressionBombError, Image.DecompressionBombWarning) as error:
        raise ValueError(f"a picture on it has more than {MOST_PIXELS:,} pixels: make it smaller") from error
    except Exception as error:
        # Pillow may raise any exception for a damaged picture.
        raise ValueError("a picture on it is neither PNG nor JPEG, or damaged: export it again") from error
