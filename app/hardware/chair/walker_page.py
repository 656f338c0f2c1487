"""The page for who walks beside a chair while its joystick is measured: big words, and Stop. Standard library only.

It starts nothing. Anybody who reaches it can stop, as at any screen. Stop goes over the network, so the page says what
is surer: the chair's own switch, and any key where the program runs. It is in English only, as what the program says.
"""

import json
import threading
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import NamedTuple

LONGEST_REQUEST = 5.0  # s that a request may take
HEADERS = {
    "Cache-Control": "no-store",
    "Content-Security-Policy": "default-src 'self'; frame-ancestors 'none'",
    "X-Content-Type-Options": "nosniff",
}

HTML = """<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Beside the chair</title>
<link rel="stylesheet" href="page.css">
<script src="page.js" defer></script>
<main>
<h1 id="headline" role="status">...</h1>
<p id="instruction"></p>
<button id="stop" type="button">STOP</button>
<p>Stop goes over the network. Surer are the chair's own switch, and any key where the program runs.</p>
</main>
</html>
"""
CSS = """:root { color-scheme: light dark; }
body { margin: 0; font: 1.4rem/1.3 system-ui, sans-serif; }
main { display: flex; flex-direction: column; gap: 1rem; min-height: 100dvh; padding: 1rem; box-sizing: border-box; }
h1 { margin: 0; font-size: clamp(2.2rem, 9vw, 5rem); line-height: 1.1; }
p { margin: 0; }
button { flex: 1; min-height: 40vh; font: inherit; font-size: clamp(4rem, 22vw, 12rem); font-weight: 700; }
button { border: 0.5rem solid; border-radius: 1rem; background: CanvasText; color: Canvas; touch-action: manipulation; }
"""
JAVASCRIPT = """"use strict";
const [headline, instruction, stop] = ["headline", "instruction", "stop"].map((id) => document.getElementById(id));
const TRIES = 5;
const ENDED = "The program has ended, or the network is gone. Use the chair's own switch, or a key at the program.";
let heard = performance.now();
let isStopping = false;
let lost = "NO ANSWER";

function show(title, sentence) {
  if (headline.textContent !== title) headline.textContent = title;
  instruction.textContent = sentence;
}

async function look() {
  try {
    const answer = await fetch("state", { signal: AbortSignal.timeout(1000) });
    const state = await answer.json();
    heard = performance.now();
    lost = "NO ANSWER";
    if (!isStopping) show(state.headline, state.instruction);
  } catch {
    // it is said below, when that lasts
  }
  if (performance.now() - heard > 1500 && !isStopping) show(lost, ENDED);
  setTimeout(look, 250);
}

async function press() {
  if (isStopping) return;
  isStopping = true;
  show("STOP IS SENT", "");
  for (let count = 0; count < TRIES; count++) {
    try {
      const answer = await fetch("stop", { method: "POST", signal: AbortSignal.timeout(500) });
      if (answer.ok) {
        isStopping = false;
        return;
      }
    } catch {
      // it is tried again
    }
  }
  isStopping = false;
  heard = -Infinity;
  lost = "STOP DID NOT ARRIVE";
  show(lost, ENDED);
}

stop.addEventListener("pointerdown", press);
stop.addEventListener("click", ({ detail }) => detail === 0 && press()); // by the keyboard
look();
"""
FILES = {
    "/": ("text/html", HTML),
    "/page.css": ("text/css", CSS),
    "/page.js": ("text/javascript", JAVASCRIPT),
}


class WalkerMoment(NamedTuple):
    """What the page shows."""

    headline: str  # what the chair does
    instruction: str  # what to do


class WalkerPage:
    """The page on a port of its own, served by a thread until it is closed."""

    def __init__(self, host: str, port: int) -> None:
        """Begin to serve; raise OSError when the address is not to be had."""
        self.moment = WalkerMoment("", "")
        self._stop = stop = threading.Event()
        page = self

        class Handler(BaseHTTPRequestHandler):
            """Answers the page's requests."""

            timeout = LONGEST_REQUEST

            def do_GET(self) -> None:
                """Answer with the page, one of its files, or what it shows now."""
                if self.path == "/state":
                    self._answer("application/json", json.dumps(page.moment._asdict()))
                elif self.path in FILES:
                    self._answer(*FILES[self.path])
                else:
                    self.send_error(HTTPStatus.NOT_FOUND)

            def do_POST(self) -> None:
                """Stop."""
                if self.path == "/stop":
                    stop.set()
                    self._answer("text/plain", "")
                else:
                    self.send_error(HTTPStatus.NOT_FOUND)

            def log_message(self, format: str, *args: object) -> None:  # noqa: A002
                """Say nothing: the terminal shows the guided drive."""

            def _answer(self, kind: str, text: str) -> None:
                content = text.encode()
                self.send_response(HTTPStatus.OK)
                self.send_header("Content-Type", f"{kind}; charset=utf-8")
                self.send_header("Content-Length", str(len(content)))
                for name, value in HEADERS.items():
                    self.send_header(name, value)
                self.end_headers()
                self.wfile.write(content)

        class Server(ThreadingHTTPServer):
            """A server whose connections do not keep the program from ending, and that says nothing of broken ones."""

            daemon_threads = True

            def handle_error(self, request: object, client_address: object) -> None:
                """Say nothing: whoever had the page open has left."""

        self._server = Server((host, port), Handler)
        self._thread = threading.Thread(target=self._server.serve_forever, daemon=True)
        self._thread.start()

    @property
    def address(self) -> str:
        """Where the page is."""
        host, port = self._server.socket.getsockname()[:2]
        return f"http://{host}:{port}/"

    def take_stop(self) -> bool:
        """Return whether Stop was pressed since the last call."""
        was_pressed = self._stop.is_set()
        if was_pressed:
            self._stop.clear()
        return was_pressed

    def close(self) -> None:
        """End the page."""
        self._server.shutdown()
        self._server.server_close()
        self._thread.join()
