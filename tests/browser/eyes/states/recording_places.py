"""The page that imports a recording: what a file holds, a question about it, a refusal."""

import math
from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import Open, at, open_all, shows, steps
from browser.eyes.states.asked_places import PROBLEM

COUNT = 300


def brought(name: str, content: bytes) -> Open:
    """Return what chooses a file on the page."""

    def choose(page: Any, _clinic: EyesClinic) -> None:
        file = {"name": name, "mimeType": "application/octet-stream", "buffer": content}
        page.locator("main input[type=file]").set_input_files(file)

    return steps(at("import_recording"), choose)


def recording(header: str, step: float) -> bytes:
    """Return a table whose first column rises by `step`."""
    rows = (f"{i * step:g};{math.sin(i / 9):.3f};{math.cos(i / 7):.3f}".replace(".", ",") for i in range(COUNT))
    return "\n".join([header, *rows, ""]).encode()


def open_columns(page: Any, _clinic: EyesClinic) -> None:
    open_all(page)


IMPORT_PLACES: dict[str, Open] = {
    "import_recording": at("import_recording"),
    "import_recording, read": steps(
        brought("arm.csv", recording("t_ms;K1 [mV];K2 [mV]", 20)),
        shows(".fact-list"),
        open_columns,
        shows(".import-columns select"),
    ),
    "import_recording, question": steps(brought("arm.csv", recording("t;K1;K2", 20)), shows(PROBLEM)),
    "import_recording, refused": steps(brought("arm.csv", b"\x89PNG\r\n\x1a\n\x00\x00\xff\xfe"), shows(PROBLEM)),
}
