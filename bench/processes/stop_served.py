"""The web process of the stop's benchmark: the real application, its own control process, and a chair to be stopped.

Arguments: the chair's port and key file, the shirt's port and key file, a folder for the state. Prints the port that it
serves. Then, for each line on stdin: `arm` prints `armed` as soon as the chair may move; `stop` sends the command over
the link, and prints when (monotonic s); `beats` prints the longest time between two heartbeats since the last such line
(s); `turns` prints the p99 and the longest turn of the event loop (s of processor time), and the share of a core that
the process used, since the last such line. Ends with stdin.
"""

import asyncio
import selectors
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

from app.api.app import create_app
from app.api.parts import parts_of
from app.cli.host.event_loop import FewAtOnce
from app.cli.port import bind
from app.cli.server import WebServer
from app.clock import monotonic
from app.computing_process import ComputingProcess
from app.faults import EXPLANATIONS, Fault, State
from app.process.supervisor import ControlProcess
from app.refusals import Conflict
from app.session.control_link import ControlLink, ScreenSign
from app.settings import Settings
from bench.subject import bench_chair, bench_floorplan, bench_parameters

SAMPLE_RATE = 100.0  # Hz
LOOK_EVERY = 0.005  # s
ARMING_LIMIT = 30.0  # s
IDLE_LIMIT = 0.2  # s without a question, after which the computing process ends: the next question starts it again


class _Beats:
    """A screen that is always in view; each heartbeat asks for it."""

    def __init__(self) -> None:
        self._last = monotonic()
        self._longest = 0.0

    def sign(self) -> ScreenSign:
        """Return that the screen is in view, and note when."""
        now = monotonic()
        self._longest, self._last = max(self._longest, now - self._last), now
        return ScreenSign(0.0)

    def longest(self) -> float:
        """Return the longest time between two heartbeats (s) since the last call."""
        longest, self._longest = self._longest, 0.0
        return longest


class _Turns(FewAtOnce):
    """Notes the processor time of each turn of the event loop, which does not depend on how busy the machine is."""

    def __init__(self) -> None:
        super().__init__()
        self._woken: float | None = None
        self._turns: list[float] = []
        self._since = (monotonic(), time.process_time())

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        """Wait for what the next turn has to do."""
        if self._woken is not None:
            self._turns.append(time.thread_time() - self._woken)
        ready = super().select(timeout)
        self._woken = time.thread_time()
        return ready

    def report(self) -> str:
        """Return the p99 and the longest of the turns (s), and the share of a core, since the last report."""
        turns, self._turns = self._turns, []
        (since, used), self._since = self._since, (monotonic(), time.process_time())
        share = (self._since[1] - used) / (self._since[0] - since)
        return f"{np.percentile(turns, 99)} {max(turns)} {share}"


async def main(chair: dict[str, Any], shirt_port: int, shirt_key: str, folder: Path, turns: _Turns) -> None:
    """Serve until stdin ends."""
    with bind("127.0.0.1", 0) as listening:
        port = listening.getsockname()[1]
        app = create_app(Settings(state=folder, port=port), ControlProcess.start, ComputingProcess(IDLE_LIMIT))
        server = WebServer(app, listening, str(port))
        serving = asyncio.create_task(server.serve([listening]))
        while not server.started:
            if serving.done():
                raise RuntimeError("the web process of the benchmark did not start: its message stands above")
            await asyncio.sleep(LOOK_EVERY)
        control = parts_of(app)[ControlLink]
        beats = _Beats()
        control.follow_screen(beats.sign)
        digest = await _set_up(control, chair, shirt_port, shirt_key, folder)
        while word := (await asyncio.to_thread(sys.stdin.readline)).strip():
            if word == "arm":
                await _arm(control, digest)
                _say("armed")
            elif word == "beats":
                _say(repr(beats.longest()))
            elif word == "turns":
                _say(turns.report())
            else:
                before = monotonic()
                await control.call("stop", by="tablet")
                _say(repr(before))
        server.should_exit = True
        await serving


async def _set_up(control: ControlLink, chair: dict[str, Any], shirt_port: int, shirt_key: str, folder: Path) -> str:
    parameters = bench_parameters(SAMPLE_RATE, "velocity")  # acceleration mode would need a stop switch
    layout = parameters.profile.layout.model_dump(mode="json")
    shirt = {"kind": "udp", "port": shirt_port, "sample_rate": SAMPLE_RATE, "layout": layout, "key_file": shirt_key}
    await control.call("shirt", config=shirt)
    await control.call("parameters", parameters=parameters.model_dump(mode="json"))
    await control.call("world", floorplan=bench_floorplan().model_dump(mode="json"), path="main")
    await control.call("chair", config=chair)
    await control.call("run", run_id="bench", folder=str(folder / "run"), kind="drive", cues=[], meta={})
    return parameters.hash


async def _arm(control: ControlLink, digest: str) -> None:
    """Arm, again after a refusal, and return when the chair may move."""
    began, why = monotonic(), "there are no ticks"
    while monotonic() < began + ARMING_LIMIT:
        await asyncio.sleep(LOOK_EVERY)
        tick = control.newest()
        if tick is None or tick["t"] < began:
            continue
        if tick["state"] == State.ARMED:
            return
        why = str(EXPLANATIONS[Fault(int(tick["fault"]))].happened)
        try:
            if tick["state"] == State.FAULT:
                await control.call("clear", stops=int(tick["stops"]))
            elif tick["state"] == State.DISARMED:
                await control.call("arm", hash=digest)
        except Conflict as refusal:
            why = str(refusal)
    raise RuntimeError(f"the chair of the benchmark could not be armed: {why}")


def _say(line: str) -> None:
    sys.stdout.write(f"{line}\n")
    sys.stdout.flush()


if __name__ == "__main__":
    real_chair = bench_chair(int(sys.argv[1]), Path(sys.argv[2]))
    all_turns = _Turns()
    with asyncio.Runner(loop_factory=lambda: asyncio.SelectorEventLoop(all_turns)) as runner:
        runner.run(main(real_chair, int(sys.argv[3]), sys.argv[4], Path(sys.argv[5]), all_turns))
