"""What the headers of answers tell browsers: the policy of each kind of page, https, and that nothing is kept.

Not here: the policy of a report, a file that leaves the program (app/features/reports/rendering.py).
"""

import re
from typing import Final

from starlette.datastructures import MutableHeaders

ALWAYS: Final = {
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
}
HEADERS: Final = ALWAYS | {
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "X-Frame-Options": "SAMEORIGIN",
}
# Our pages run only scripts of this program.
PAGE_POLICY: Final = "; ".join(
    (
        "default-src 'none'",
        "script-src 'self'",
        "worker-src 'self'",
        "style-src 'self' 'unsafe-inline'",
        "img-src 'self' data: blob:",
        "font-src 'self'",
        "connect-src 'self' {sockets}",
        "frame-src 'self'",
        "frame-ancestors 'self'",
        "form-action 'self'",
        "base-uri 'none'",
        "manifest-src 'self'",
        "media-src 'self'",
    )
)
# What reads a camera's pictures: only there a page of ours may compile WebAssembly. It reaches no other machine.
READER_POLICY: Final = "; ".join(
    (
        "default-src 'none'",
        "script-src 'self' 'wasm-unsafe-eval'",
        "connect-src 'self'",
        "frame-ancestors 'self'",
        "form-action 'none'",
        "base-uri 'none'",
    )
)
# The 3D view is viser's page: one file, with its scripts in it.
VIEW_POLICY: Final = "; ".join(
    (
        "default-src 'none'",
        "script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:",
        "worker-src blob: data:",
        "style-src 'unsafe-inline'",
        "img-src 'self' data: blob:",
        "font-src data:",
        "connect-src 'self'{sockets} blob: data:",
        "frame-ancestors 'self'",
        "base-uri 'none'",
        "form-action 'none'",
    )
)
# The page that explains to a tablet how to trust this machine, over http; it asks whether the tablet does over https.
TABLET_HEADERS: Final = ALWAYS | {"X-Frame-Options": "DENY"}
TABLET_POLICY: Final = "; ".join(
    (
        "default-src 'none'",
        "script-src 'self'",
        "style-src 'self'",
        "img-src 'self'",
        "connect-src 'self' {https}",
        "frame-ancestors 'none'",
        "form-action 'none'",
        "base-uri 'none'",
    )
)

# A browser that was here over https asks for no page of this name over http for 30 days (decisions/0041).
ONLY_HTTPS: Final = "max-age=2592000"

HOST: Final = re.compile(r"[A-Za-z0-9.\-]+(:\d+)?|\[[0-9A-Fa-f:.]+\](:\d+)?")


def add_headers(given: MutableHeaders, path: str, host: str, *, is_encrypted: bool) -> None:
    """Add to the headers of an answer those that it lacks; `host` is ours, or empty."""
    for name, value in HEADERS.items():
        given.setdefault(name, value)
    sockets = f"{'wss' if is_encrypted else 'ws'}://{host}" if host else ""
    given.setdefault("Content-Security-Policy", PAGE_POLICY.format(sockets=sockets))
    if is_encrypted:
        given.setdefault("Strict-Transport-Security", ONLY_HTTPS)
    if path.startswith("/api/"):
        given["Cache-Control"] = "no-store"


def view_headers(host: str, scheme: str) -> dict[str, str]:
    """Return the headers of viser's page, with the policy that lets its scripts reach this host only.

    viser's page opens any websocket that its address names; `connect-src` restricts it to this host.
    """
    sockets = f" {'wss' if scheme == 'https' else 'ws'}://{host}" if HOST.fullmatch(host) else ""
    return ALWAYS | {
        "Content-Security-Policy": VIEW_POLICY.format(sockets=sockets),
        "Cache-Control": "private, no-cache",
        "Vary": "Accept-Encoding",
    }
