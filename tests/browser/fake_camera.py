"""What a browser's camera sees in tests: a film of a person, who sways or goes away, for Chromium's fake camera."""

import io
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from browser.conftest import CHROMIUM, PATIENCE, PROGRAM, THIS_MACHINE_ONLY, modest
from PIL import Image
from playwright.sync_api import Browser, Playwright, expect

from needed import lacks, need

SIZE = (640, 480)
GREY = (96, 96, 96)
RATE = 30  # pictures a second, as Chromium plays such a film, again and again
SWAY = (0, 6, 12, 18, 24, 18, 12, 6)  # px to the side: a tenth of the shoulders' width
QUALITY = 80


def person() -> Image.Image:
    """Return the picture of an astronaut that scikit-image ships (NASA, public domain), in the middle of a film's."""
    found = find_spec("skimage")
    if found is None or found.origin is None:
        lacks("there is no picture of a person: install scikit-image, of the extra 'test'")
    astronaut = Image.open(Path(found.origin).parent / "data" / "astronaut.png").convert("RGB")
    picture = Image.new("RGB", SIZE, GREY)
    picture.paste(astronaut.resize((SIZE[1], SIZE[1])), ((SIZE[0] - SIZE[1]) // 2, 0))
    return picture


def moved(picture: Image.Image, pixels: int) -> Image.Image:
    """Return a picture whose upper edge is moved to the side, and its lower edge is not: the person leans."""
    width, height = picture.size
    return picture.transform(
        (width, height), Image.Transform.AFFINE, (1, pixels / height, -pixels, 0, 1, 0), fillcolor=GREY
    )


def jpeg(picture: Image.Image) -> bytes:
    buffer = io.BytesIO()
    picture.save(buffer, "JPEG", quality=QUALITY)
    return buffer.getvalue()


def film_of(file: Path, seconds: float, *, empty_seconds: float = 0.0) -> Path:
    """Write a film of a person who sways for so long, and is away afterwards for `empty_seconds`."""
    sways = [jpeg(moved(person(), pixels)) for pixels in SWAY]
    nobody = jpeg(Image.new("RGB", SIZE, GREY))
    pictures = [sways[i // 3 % len(sways)] for i in range(round(seconds * RATE))]
    file.write_bytes(b"".join([*pictures, *[nobody] * round(empty_seconds * RATE)]))
    return file


@contextmanager
def own_browser(playwright: Playwright, folder: Path, *words: str) -> Iterator[Browser]:
    """Yield a browser that is started with more words than others; `folder` takes the program that starts it."""
    program = PROGRAM or need("chromium", "chromium")
    expect.set_options(timeout=PATIENCE)
    arguments = [*CHROMIUM, THIS_MACHINE_ONLY, *words]
    chromium = playwright.chromium.launch(executable_path=modest(program, folder), args=arguments)
    try:
        yield chromium
    finally:
        chromium.close()


@contextmanager
def browser_with_camera(playwright: Playwright, film: Path, folder: Path) -> Iterator[Browser]:
    """Yield a browser whose camera shows a film, and which permits it to the pages that may have it."""
    with own_browser(
        playwright,
        folder,
        "--use-fake-ui-for-media-stream",
        "--use-fake-device-for-media-stream",
        f"--use-file-for-fake-video-capture={film}",
    ) as chromium:
        yield chromium


class Traffic:
    """All that a page sends: its requests with their bodies, and the messages of its sockets by their path."""

    def __init__(self, page: Any) -> None:
        self.bodies: list[tuple[str, str, int]] = []  # method, address, length in bytes
        self.messages: dict[str, list[bytes | str]] = {}
        page.on("request", self._request)
        page.on("websocket", self._opened)

    def _request(self, request: Any) -> None:
        self.bodies.append((request.method, request.url, len(request.post_data_buffer or b"")))

    def _opened(self, socket: Any) -> None:
        sent = self.messages.setdefault(socket.url.split("?")[0].rpartition("/api/v1")[2], [])
        socket.on("framesent", lambda frame: sent.append(frame))  # noqa: PLW0108  (Playwright marks the function)
