"""A web process with two browsers' worth of work: heartbeat, both 3D views at 60 Hz, both live pages at 20 Hz.

Both ends of the viewers' connections are in this process, so that it works harder than a web process.
Arguments: the shirt's port, the report's port, a folder for the recording, and for a real chair its port, its key file
and that of the shirt.
"""

import asyncio
import json
import math
import socket
import struct
import sys
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np

from app.clock import monotonic
from app.faults import State
from app.process.command_channel import LinkRefused
from app.process.supervisor import ControlProcess
from bench.subject import CHANNELS, bench_chair, bench_floorplan, bench_parameters

VIEWERS = 2
SAMPLE_RATE = 1000.0  # Hz, of the shirt
SCENE_RATE, PAGE_RATE, HEART_RATE = 60.0, 20.0, 10.0  # Hz
SCENE_PARTS = 12  # nodes of the scene that move with the chair, each with position and orientation
POSE = struct.Struct("<7f")


class Viewer:
    """A viewer who reads everything and keeps nothing."""

    def __init__(
        self, writer: asyncio.StreamWriter, reader: asyncio.StreamReader, way_back: asyncio.StreamWriter
    ) -> None:
        self.writer = writer
        self._way_back = way_back  # unused, kept open because closing it would end the connection
        self._watching = asyncio.create_task(self._watch(reader))

    @classmethod
    async def open(cls) -> "Viewer":
        """Return a connected viewer."""
        near, far = socket.socketpair()
        reader, way_back = await asyncio.open_connection(sock=far)
        _, writer = await asyncio.open_connection(sock=near)
        return cls(writer, reader, way_back)

    async def _watch(self, reader: asyncio.StreamReader) -> None:
        while await reader.read(65_536):
            pass


async def main(
    shirt_port: int, report_port: int, folder: Path, chair: dict[str, Any] | None, shirt_key: str | None
) -> None:
    """Start the control process, print a line, and keep the chair armed and the viewers served until stdin ends."""
    control = await ControlProcess.start("--report", f"127.0.0.1:{report_port}")
    # Acceleration mode on a real chair is refused without a stop switch.
    parameters = bench_parameters(SAMPLE_RATE, "acceleration" if chair is None else "velocity")
    shirt = {
        "kind": "udp",
        "host": "127.0.0.1",
        "port": shirt_port,
        "layout": parameters.profile.layout.model_dump(mode="json"),
        "sample_rate": SAMPLE_RATE,
        "key_file": shirt_key,
    }
    await control.call("shirt", config=shirt)
    await control.call("parameters", parameters=parameters.model_dump(mode="json"))
    await control.call("world", floorplan=bench_floorplan().model_dump(mode="json"), path="main")
    if chair is not None:
        await control.call("chair", config=chair)
    viewers = [await Viewer.open() for _ in range(VIEWERS)]
    work = [
        _every(HEART_RATE, lambda: control.send("heartbeat", screen_age=0.0)),
        _every(SCENE_RATE, lambda: _show_scene(control, viewers)),
        _every(PAGE_RATE, lambda: _show_page(control, viewers)),
        _keep_armed(control, parameters.hash, folder),
    ]
    tasks = [asyncio.create_task(part) for part in work]
    sys.stdout.write("ready\n")
    sys.stdout.flush()
    await asyncio.to_thread(sys.stdin.read)
    for task in tasks:
        task.cancel()
    await asyncio.gather(*tasks, return_exceptions=True)
    await control.close()


async def _every(rate: float, work: Callable[[], None]) -> None:
    deadline = monotonic()
    while True:
        work()
        deadline = max(deadline + 1 / rate, monotonic())
        await asyncio.sleep(deadline - monotonic())


def _show_scene(control: ControlProcess, viewers: list[Viewer]) -> None:
    """Move every part of the chair in every viewer's scene."""
    tick = control.newest()
    if tick is None:
        return
    x, y, theta = float(tick["x"]), float(tick["y"]), float(tick["theta"])
    for viewer in viewers:
        parts = [
            POSE.pack(x + 0.01 * part, y, 0.1 * part, math.cos(theta / 2), 0.0, 0.0, math.sin(theta / 2))
            for part in range(SCENE_PARTS)
        ]
        viewer.writer.write(b"".join(parts))


def _show_page(control: ControlProcess, viewers: list[Viewer]) -> None:
    """Make the live picture once and send it to every page."""
    tick = control.newest()
    if tick is None:
        return
    seen = control.since(max(0, int(tick["number"]) - int(SAMPLE_RATE / PAGE_RATE)))
    picture = {name: float(tick[name]) for name in ("t", "u1", "u2", "v", "omega", "x", "y", "theta")}
    lists = {name: np.nan_to_num(tick[name]).tolist() for name in ("score", "rate", "activation", "values")}
    spread = {"noise": np.nan_to_num(seen["values"][:, :CHANNELS]).std(axis=0).tolist()}
    text = json.dumps(picture | lists | spread).encode()
    for viewer in viewers:
        viewer.writer.write(text)


async def _keep_armed(control: ControlProcess, digest: str, folder: Path) -> None:
    """Begin a recorded drive with the first frame, and arm the chair whenever it is not armed."""
    recording = False
    while True:
        await asyncio.sleep(0.3)
        tick = control.newest()
        if tick is None or not tick["has_frame"]:
            continue
        if not recording:
            await control.call("run", run_id="bench", folder=str(folder), kind="drive", cues=[], meta={})
            recording = True
        with suppress(LinkRefused):
            if tick["state"] == State.FAULT:
                await control.call("clear", stops=int(tick["stops"]))
            if tick["state"] in (State.FAULT, State.DISARMED):
                await control.call("arm", hash=digest)


if __name__ == "__main__":
    real_chair = bench_chair(int(sys.argv[4]), Path(sys.argv[5])) if len(sys.argv) > 4 else None
    shirt_key = sys.argv[6] if len(sys.argv) > 6 else None
    asyncio.run(main(int(sys.argv[1]), int(sys.argv[2]), Path(sys.argv[3]), real_chair, shirt_key))
