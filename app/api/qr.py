"""A text as a QR code, to be scanned from a page."""

import io

import segno

DOTS = 6  # pixels of the picture to one of the code


def qr_picture(text: str) -> str:
    """Return a text as a QR code, an SVG."""
    picture = io.BytesIO()
    segno.make_qr(text, error="m").save(
        picture, kind="svg", xmldecl=False, nl=False, scale=DOTS, dark="black", light="white"
    )
    return picture.getvalue().decode()
