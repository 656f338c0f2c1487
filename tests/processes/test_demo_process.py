"""The real demonstration process: its control process is killed, and the demonstration ends by a signal."""

import re
import signal
import socket
import stat
import time
from collections.abc import Iterator
from pathlib import Path

import httpx
import psutil
import pytest
from processes.served_demo import OWNER, Demo, bodydrive, printed_link, running_program, until


@pytest.fixture
def demo(tmp_path: Path) -> Iterator[Demo]:
    with Demo.running(tmp_path) as running:
        yield running


def test_the_story_of_a_control_process_that_dies_and_of_an_orderly_end(demo: Demo) -> None:
    equipment = demo.client.get("/equipment").json()
    assert len(equipment["layout"]["channels"]) == 52
    with demo.socket("live") as live:
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
        demo.process.send_signal(signal.SIGINT)
        _, errors = demo.process.communicate(timeout=60)
    assert demo.process.returncode == 0
    assert "Traceback" not in errors
    assert not control.is_running()
    assert not demo.state.exists()


def test_nothing_of_a_clinic_can_be_read_by_others(demo: Demo) -> None:
    """After a session with a recording, an upload, a floor plan, a paired chair; under the usual umask."""
    client = demo.client
    chair = {"name": "Blue", "host": "127.0.0.1", "port": 5354, "speeds": {}}
    assert client.post("/chairs", json=chair).status_code == 201
    table = "t,a,b\n" + "\n".join(f"{i / 100},{i},{i}" for i in range(200))
    assert client.post("/equipment/files", files={"file": ("arm.csv", table)}).status_code == 201
    client.post("/calibration/steps/rest/start")
    with demo.socket("live") as live:
        until(live, lambda m: m["run"] is not None and m["run"]["t"] > 0.7)
        while_recording = readable_by_others(demo.state)
        names = {place.name for place in demo.state.rglob("*")}
        client.post("/calibration/steps/rest/cancel")
        until(live, lambda m: m["run"] is None)
    assert while_recording == readable_by_others(demo.state) == []
    assert {"segment-0000.arrows", "run.json", "arm.csv", "1.key"} <= names
    database = {"bodydrive.sqlite", "bodydrive.sqlite-wal", "bodydrive.sqlite-shm"}
    assert database | {"bodydrive.sqlite.log-head", "bodydrive.sqlite.ballast"} <= names
    assert list(demo.state.rglob("run.parquet"))


def readable_by_others(folder: Path) -> list[Path]:
    return [place for place in (folder, *folder.rglob("*")) if stat.S_IMODE(place.stat().st_mode) & 0o077]


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
    words = ("serve", "--port", "0", "--state", str(tmp_path / "clinic"))
    with running_program(*words) as first:
        base, code = printed_link(first).split("/#setup=")
        with httpx.Client(base_url=f"{base}/api/v1", headers={"Origin": base}, timeout=60) as client:
            assert client.post("/auth/setup", json={"code": code, **OWNER}).json()["role"] == "owner"
        second = bodydrive(*words)
        _, errors = second.communicate(timeout=60)
        assert (second.returncode, errors.count("\n")) == (2, 1)
        assert "open already" in errors
        first.send_signal(signal.SIGTERM)
        assert "Traceback" not in first.communicate(timeout=60)[1]
        assert first.returncode == 0
