"""A key as a QR code for a terminal."""

import io
import sys


def terminal_code(content: str) -> str:
    """Return a QR code for a terminal, in half blocks where it can show them."""
    import segno

    drawn = io.StringIO()
    has_blocks = "utf" in (sys.stdout.encoding or "").lower()
    segno.make_qr(content, error="m").terminal(drawn, compact=has_blocks)
    return drawn.getvalue()
