"""A real demonstration for tests: its process, and a client that is signed in."""

import json
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import httpx
import psutil
from websockets.sync.client import ClientConnection, connect

from folders import ROOT

COMMAND = [sys.executable, "-c", "from app.cli.main import main; main()"]


def bodydrive(*words: str, **more: Any) -> "subprocess.Popen[str]":
    environment = {**os.environ, "PYTHONPATH": str(ROOT), **more}
    return subprocess.Popen(
        [*COMMAND, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment
    )


def printed_link(process: "subprocess.Popen[str]") -> str:
    assert process.stdout is not None
    for line in process.stdout:
        if line.startswith("http"):
            return line.strip()
    raise AssertionError(process.communicate()[1])


@contextmanager
def running_demo(**environment: str) -> Iterator[str]:
    """Yield the address of a running demonstration, and check that it ends in order."""
    with bodydrive("demo", "--port", "0", **environment) as process:
        try:
            yield printed_link(process)
        finally:
            process.send_signal(signal.SIGINT)
            assert process.wait(20) == 0


def free_port() -> int:
    """Return a TCP port of this machine that is free now."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


class SessionClient(httpx.Client):
    """A client that names the open session with every change, as a page does."""

    def __init__(self, base: str) -> None:
        super().__init__(base_url=f"{base}/api/v1", headers={"Origin": base}, timeout=60)

    def request(self, method: str, url: Any, **more: Any) -> httpx.Response:
        if method != "GET":
            answer = super().request("GET", "/session")
            session = (answer.json()["session"] or {}).get("id") if answer.is_success else None
            more["headers"] = {"Patient-Session": str(session or "none"), **(more.get("headers") or {})}
        return super().request(method, url, **more)


class Demo:
    """A running demonstration and a client that is signed in."""

    def __init__(self, process: "subprocess.Popen[str]") -> None:
        self.process = process
        base, self.code = printed_link(process).split("/#demo=")
        self.base = base
        self.client = SessionClient(base)
        assert self.client.post("/auth/demo", json={"code": self.code}).json()["signed_in"]

    def socket(self, name: str) -> ClientConnection:
        """Open the live socket or the screen socket."""
        cookie = "; ".join(f"{name}={value}" for name, value in self.client.cookies.items())
        address = f"{self.base.replace('http', 'ws')}/api/v1/{name}"
        return connect(address, additional_headers={"Cookie": cookie}, origin=self.base)

    def control_process(self) -> psutil.Process:
        children = psutil.Process(self.process.pid).children(recursive=True)
        return next(child for child in children if "app.pipeline.process" in child.cmdline())


def until(socket_: ClientConnection, good: Callable[[Any], bool]) -> Any:
    while True:
        message = json.loads(socket_.recv(timeout=60))
        if good(message):
            return message
