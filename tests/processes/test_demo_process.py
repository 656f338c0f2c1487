"""The real demonstration: started as a person would, its control process killed, ended by a signal."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx
import psutil
import pytest
from websockets.sync.client import ClientConnection, connect

ROOT = Path(__file__).resolve().parents[2]
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


class Demo:
    """A running demonstration and somebody who is signed in to it."""

    def __init__(self, process: "subprocess.Popen[str]") -> None:
        self.process = process
        base, code = printed_link(process).split("/#demo=")
        self.base = base
        self.client = httpx.Client(base_url=f"{base}/api/v1", headers={"Origin": base}, timeout=60)
        assert self.client.post("/auth/demo", json={"code": code}).json()["signed_in"]

    def live(self) -> ClientConnection:
        cookie = "; ".join(f"{name}={value}" for name, value in self.client.cookies.items())
        return connect(
            f"{self.base.replace('http', 'ws')}/api/v1/live", additional_headers={"Cookie": cookie}, origin=self.base
        )

    def control_process(self) -> psutil.Process:
        children = psutil.Process(self.process.pid).children(recursive=True)
        return next(child for child in children if "app.pipeline.process" in child.cmdline())


@pytest.fixture
def demo(tmp_path: Path) -> Iterator[Demo]:
    process = bodydrive("demo", "--port", "0", TMPDIR=str(tmp_path))
    try:
        running = Demo(process)
        yield running
        running.client.close()
    finally:
        if process.poll() is None:
            process.kill()
        process.communicate()


def until(socket_: ClientConnection, good: Callable[[Any], bool]) -> Any:
    while True:
        message = json.loads(socket_.recv(timeout=60))
        if good(message):
            return message


def test_the_story_of_a_control_process_that_dies_and_of_an_orderly_end(demo: Demo, tmp_path: Path) -> None:
    equipment = demo.client.get("/equipment").json()
    assert len(equipment["layout"]["channels"]) == 52
    with demo.live() as live:
        message = until(live, lambda m: m["values"] is not None)
        assert len(message["values"]) == 52
        until(live, lambda m: "quality" in m and "silent" not in m["quality"])

        started = demo.client.post("/calibration/steps/rest/start").json()
        assert started["running"]["step"] == "rest"
        until(live, lambda m: m["run"] is not None and m["run"]["kind"] == "rest" and m["run"]["t"] > 0.2)
        control = demo.control_process()
        control.kill()
        lost = until(live, lambda m: m["control"] != "alive")
        assert (lost["v"], lost["omega"], lost["fault"]["name"]) == (0.0, 0.0, "control_lost")
        again = until(live, lambda m: m["control"] == "alive" and m["values"] is not None)
        assert (again["state"], len(again["values"])) == ("disarmed", 52)
        wizard = demo.client.get("/calibration").json()
        assert wizard["running"] is None
        assert wizard["steps"][0]["status"] == "failed"

        control = demo.control_process()
        state = next(tmp_path.glob("bodydrive-demo-*"))
        demo.process.send_signal(signal.SIGINT)
        _, errors = demo.process.communicate(timeout=60)
    assert demo.process.returncode == 0
    assert "Traceback" not in errors
    assert not control.is_running()
    assert not state.exists()


def test_a_web_process_that_is_killed_leaves_no_control_process(demo: Demo) -> None:
    control = demo.control_process()
    demo.process.kill()
    demo.process.wait()
    while control.is_running() and control.status() != psutil.STATUS_ZOMBIE:
        time.sleep(0.01)


def test_a_busy_port_is_one_sentence() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        process = bodydrive("demo", "--port", str(port))
        out, errors = process.communicate(timeout=60)
    assert (process.returncode, out) == (2, "")
    assert re.fullmatch(rf"bodydrive: Port {port} of 127\.0\.0\.1 is busy: .*\n", errors)


def test_a_clinic_is_set_up_once_and_held_by_one(tmp_path: Path) -> None:
    first = bodydrive("serve", "--port", "0", "--state", str(tmp_path / "clinic"))
    try:
        base, code = printed_link(first).split("/#setup=")
        with httpx.Client(base_url=f"{base}/api/v1", headers={"Origin": base}, timeout=60) as client:
            owner = {"code": code, "name": "Ada", "password": "correct horse battery"}
            assert client.post("/auth/setup", json=owner).json()["role"] == "owner"
        second = bodydrive("serve", "--port", "0", "--state", str(tmp_path / "clinic"))
        _, errors = second.communicate(timeout=60)
        assert (second.returncode, errors.count("\n")) == (2, 1)
        assert "open already" in errors
        first.send_signal(signal.SIGTERM)
        assert "Traceback" not in first.communicate(timeout=60)[1]
        assert first.returncode == 0
    finally:
        if first.poll() is None:
            first.kill()
            first.communicate()
