"""A real demonstration for tests: its process, and a client that is signed in."""

import json
import os
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Self

import httpx
import psutil
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect
from websockets.sync.connection import Connection
from websockets.typing import Origin

from app.clock import monotonic
from folders import ROOT

COMMAND = [sys.executable, "-c", "from app.cli.main import main; main()"]
OWNER = {"name": "Ada", "password": "correct horse battery"}
PATIENCE = 300  # s of silence that count as hung: how quick a machine is says nothing of the program
CONTINUES = 20  # taps of Continue; on a busy machine a report of the page may be late again and again


def environment() -> dict[str, str]:
    """Return an environment in which a process can import the tests."""
    return {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), str(ROOT / "tests")])}


def bodydrive(*words: str, **more: Any) -> "subprocess.Popen[str]":
    return subprocess.Popen(
        [*COMMAND, *words],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT), **more},
    )


def printed_link(process: "subprocess.Popen[str]") -> str:
    assert process.stdout is not None
    for line in process.stdout:
        if line.startswith("http"):
            return line.strip()
    raise AssertionError(process.communicate()[1])


@contextmanager
def running_program(*words: str, **environment: str) -> Iterator["subprocess.Popen[str]"]:
    """Run bodydrive; at the end it is asked to end, and killed when it does not."""
    with bodydrive(*words, **environment) as process:
        try:
            yield process
            if process.poll() is None:
                process.send_signal(signal.SIGINT)
                process.communicate(timeout=PATIENCE)
        finally:
            if process.poll() is None:
                process.kill()
                process.communicate()


@contextmanager
def running_demo(**environment: str) -> Iterator[str]:
    """Yield the address of a running demonstration, and check that it ends in order."""
    with running_program("demo", "--port", "0", **environment) as process:
        yield printed_link(process)
    assert process.returncode == 0


def free_port() -> int:
    """Return a TCP port of this machine that is free now."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


class SessionClient(httpx.Client):
    """A client that names the open session with every change, as a page does, unless the change names one itself."""

    def __init__(self, base: str, **more: Any) -> None:
        super().__init__(base_url=f"{base}/api/v1", headers={"Origin": base}, timeout=PATIENCE, **more)

    def request(self, method: str, url: Any, **more: Any) -> httpx.Response:
        if method != "GET" and "Patient-Session" not in (more.get("headers") or {}):
            answer = super().request("GET", "/session")
            session = (answer.json()["session"] or {}).get("id") if answer.is_success else None
            more["headers"] = {"Patient-Session": str(session or "none"), **(more.get("headers") or {})}
        return super().request(method, url, **more)


class ProgramClient:
    """A client of a running program."""

    def __init__(self, base: str) -> None:
        self.base = base
        self.client = SessionClient(base)

    def socket(self, name: str) -> ClientConnection:
        """Open the live socket or the screen socket; a busy machine may be late with an answer to a ping."""
        cookie = "; ".join(f"{name}={value}" for name, value in self.client.cookies.items())
        address = f"{self.base.replace('http', 'ws')}/api/v1/{name}"
        headers = {"Cookie": cookie}
        # A client with a full queue answers no ping, and is disconnected while the test does something else.
        return connect(
            address, additional_headers=headers, origin=Origin(self.base), ping_interval=None, max_queue=None
        )


class Served(ProgramClient):
    """A running program and a client of it."""

    def __init__(self, process: "subprocess.Popen[str]", base: str) -> None:
        super().__init__(base)
        self.process = process

    def control_process(self) -> psutil.Process:
        children = psutil.Process(self.process.pid).children(recursive=True)
        return next(child for child in children if "app.pipeline.process" in child.cmdline())


class Demo(Served):
    """A running demonstration and a client that is signed in; `state` is its folder, when one was chosen for it."""

    state: Path

    def __init__(self, process: "subprocess.Popen[str]") -> None:
        base, self.code = printed_link(process).split("/#demo=")
        super().__init__(process, base)
        assert self.client.post("/auth/demo", json={"code": self.code}).json()["signed_in"]

    @classmethod
    @contextmanager
    def running(cls, folder: Path | str = "") -> Iterator[Self]:
        """Yield a demonstration, whose state lies in a folder when one is given."""
        with running_program("demo", "--port", "0", **({"TMPDIR": str(folder)} if folder else {})) as process:
            demo = cls(process)
            demo.state = next(Path(folder).glob("bodydrive-demo-*")) if folder else Path()
            yield demo
            demo.client.close()

    def go_on_until(self, live: Connection, good: Callable[[Any], bool]) -> Any:
        """Wait for a message with `good`; at a stop, tap Continue, as a person does who sees only the newest message.

        A message that is older than the last tap, because it was not read before, does not count.
        """
        for _ in range(CONTINUES):
            message = until(live, lambda m: m["state"] == "fault" or good(m), since=monotonic())
            if message["state"] != "fault":
                return message
            answer = self.client.post("/control/clear", json={"stops": message["stops"]})
            assert answer.status_code in {200, 409}, answer.text  # 409: there was another stop meanwhile
        raise AssertionError(f"it could not be continued: {message['fault']}")


class InView:
    """A page's worker, which reports twenty times a second whether the page is in view; refused, it comes again."""

    def __init__(self, served: Served, word: str) -> None:
        self.visible = self.speaks = True
        self.refusals = 0
        self._ended = threading.Event()
        self._served, self._word, self._socket = served, word, served.socket("screen")
        self._thread = threading.Thread(target=self._say)
        self._thread.start()

    def hide(self) -> None:
        self.visible = False
        self._send()

    def close(self) -> None:
        self._ended.set()
        self._thread.join()
        self._socket.close()

    def _say(self) -> None:
        while not self._ended.wait(0.05):
            if self.speaks:
                self._send()

    def _send(self) -> None:
        try:
            self._socket.send(json.dumps({"screen": self._word, "visible": self.visible, "silence": 0.0}))
        except ConnectionClosed:
            self.refusals += 1
            self._socket = self._served.socket("screen")


def until(socket_: Connection, good: Callable[[Any], bool], since: float = 0.0) -> Any:
    """Read messages until one with `good` that was made after `since` (monotonic s)."""
    while True:
        message = json.loads(socket_.recv(timeout=PATIENCE))
        if good(message) and (message["t"] or 0.0) >= since:
            return message
