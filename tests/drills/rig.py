"""Real processes for a drill: a shirt, a control process, a bad network, a receiver; armed and cruising."""

import asyncio
import json
import socket
import subprocess
import sys
import tempfile
from collections import deque
from contextlib import asynccontextmanager, suppress
from pathlib import Path

from drills.far_chairs import FarChair
from drills.relay import Relay
from drills.results import Watcher
from processes.chair_process import ReceiverProcess
from processes.running_control import clear, tick_with
from processes.served_demo import environment
from processes.udp_shirt import RATE, UdpShirtSender, free_port, paired_key_file, shirt_config

from app.clock import MonotonicClock
from app.faults import Fault, State
from app.process.command_channel import LinkLost, LinkRefused
from app.process.supervisor import ControlProcess
from building import make_parameters

NOISE = 1e-3  # signal units, standard deviation of a good sensor
MADE = make_parameters()  # acceleration mode: after one stroke the chair cruises while the hands rest
PROFILE = MADE.profile.model_copy(update={"noise": (NOISE,) * len(MADE.profile.low)})
PARAMETERS = MADE.model_copy(update={"profile": PROFILE})
STUCK_NOISE = 0.1  # of a good sensor's noise: what a stuck one still shows
CRUISE = 0.15  # m/s, least speed of cruising
AFTER = 0.75  # s of observation after the fault
TRIES = 6
REASON_LASTS = 0.5  # s between two tries: after a hold, frames count as lost for up to a second, and nothing is armed


class DrillShirt(UdpShirtSender):
    """A shirt that can stall, break in some of its channels, be loose, or have its frames kept back on their way."""

    def __init__(self, parameters, port, key_file):
        self.stalled = False
        self.kept_back = 0.0  # s
        self.broken = {}  # channel: value
        self.stuck = {}  # channel: value, which shows a bit of noise
        self.loose = None  # half a period in frames, and what a channel changes by: channel: value
        self.recent = deque(maxlen=300)  # frames
        super().__init__(parameters, port, key_file)

    def rest(self):
        """Return to rest."""
        self._stroke_at = None

    def stick(self, channels):
        """Let these channels stick where they are now."""
        values = self._values()
        self.stuck = {channel: values[channel] for channel in channels}

    def _values(self):
        values = super()._values()
        for channel, value in self.broken.items():
            values[channel] = value
        for channel, value in self.stuck.items():
            values[channel] = value + STUCK_NOISE * NOISE * (self._frames % 2)
        if self.loose is not None:
            frames, changes = self.loose
            for channel, change in changes.items():
                values[channel] += change * (self._frames // frames % 2)
        return values

    def _send(self):
        clock = MonotonicClock()
        due = clock.now()
        on_their_way = deque()  # when a frame was made (s), the frame
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            while not self._ended.is_set():
                if not self.stalled:
                    self.recent.append(self._frame())
                    on_their_way.append((due, self.recent[-1]))
                while on_their_way and on_their_way[0][0] + self.kept_back <= due:
                    sender.sendto(on_their_way.popleft()[1], self._address)
                self._frames += 1
                due += 1 / RATE
                clock.sleep_until(due)


class Rig:
    """The shirt, the control process, the network and the receiver of a drill."""

    def __init__(self, folder, seed, output=None):
        self._folder = Path(folder)
        at = self._folder / "chair"
        at.mkdir()
        self.receiver = ReceiverProcess(at) if output is None else FarChair(at, output)
        self.relay = Relay(self.receiver.config()["port"], seed)
        self.watcher = Watcher()
        self.shirt_port = free_port()
        self._key_file = paired_key_file(self._folder / "keys")
        self.shirt = DrillShirt(PARAMETERS, self.shirt_port, self._key_file)
        self.control = None
        self.screen_age, self.screen = 0.0, "in view"
        self.beats = True
        self._heart = None
        self._runs = 0

    async def start_control(self, *, switch=True):
        """Start a control process and give it everything it needs to arm; `switch`: show it the chair's switch."""
        self.control = await ControlProcess.start()
        self._heart = asyncio.create_task(self._beat(self.control))
        await self.control.call("shirt", config=self.shirt_config)
        await self.control.call("parameters", parameters=PARAMETERS.model_dump(mode="json"))
        await self.control.call("chair", config=self.receiver.config(port=self.relay.port))
        await tick_with(self.control, lambda tick: tick["has_frame"] and tick["chair_age"] < 0.3)
        if switch:
            await self.show_switch()
        await self.begin_run()

    @property
    def shirt_config(self):
        return shirt_config(PARAMETERS, self.shirt_port, self._key_file)

    async def begin_run(self):
        self._runs += 1
        run = {"run_id": f"d{self._runs}", "folder": str(self._folder / f"run{self._runs}"), "kind": "drive"}
        await self.control.call("run", **run, cues=[], meta={})

    async def show_switch(self):
        """Press and release the chair's switch once, so that acceleration mode may be armed."""
        self.receiver.press(True)
        await tick_with(self.control, lambda tick: tick["stop_input"] == 1)
        self.receiver.press(False)
        await tick_with(self.control, lambda tick: tick["stop_input"] == 0 and tick["chair_state"] == 0)

    async def arm(self):
        """Arm the chair at rest; return whether it is armed."""
        self.shirt.rest()
        with suppress(LinkRefused):
            await clear(self.control)
            await self.control.call("arm", hash=PARAMETERS.hash)
        return (await tick_with(self.control, _decided))["state"] == State.ARMED

    async def cruise(self):
        """Arm, make one stroke, and return when the chair drives by itself."""
        reasons = []
        for _ in range(TRIES):
            if await self.arm():
                self.shirt.stroke()
                await tick_with(self.control, lambda tick: tick["state"] != State.ARMED or tick["driven_v"] > CRUISE)
                await asyncio.sleep(0.45)  # the stroke ends, and the arm returns
                if self.control.newest()["state"] == State.ARMED and self.receiver.newest["v"] > CRUISE:
                    return
            reasons.append(Fault(int(self.control.newest()["fault"])).name)
            await asyncio.sleep(REASON_LASTS)
        raise AssertionError(f"the chair could not be brought to cruise: {', '.join(reasons)}")

    async def _beat(self, control):
        with suppress(LinkLost):
            while True:
                if self.beats:
                    control.send("heartbeat", screen_age=self.screen_age, screen=self.screen)
                await asyncio.sleep(0.05)

    async def start_web(self):
        """Start a process that starts a control process and arms the chair, and return when the chair cruises."""
        self._runs += 1
        self.shirt.rest()
        web = await self._child("processes.web_stand_in")
        await web.stdout.readline()  # the number of its control process
        await asyncio.sleep(1.0)
        for _ in range(TRIES):
            self.receiver.press(True)
            await asyncio.sleep(0.4)
            self.receiver.press(False)
            try:
                await asyncio.wait_for(web.stdout.readline(), 5.0)
            except TimeoutError:
                continue
            break
        await self._stroke_and_cruise()
        return web

    async def start_served_web(self):
        """Start the real web process, which arms the chair; return it and its port when the chair cruises."""
        self._runs += 1
        self.shirt.rest()
        web = await self._child("drills.served_web")
        try:
            port = int((await web.stdout.readline()).split()[1])
            self.receiver.press(True)
            await web.stdout.readline()
            self.receiver.press(False)
            await web.stdout.readline()
            await self._stroke_and_cruise()
        except BaseException:
            web.kill()
            raise
        return web, port

    async def _child(self, module):
        """Start a module of the tests that takes what it needs of this rig as JSON."""
        given = {
            "shirt": self.shirt_config,
            "chair": self.receiver.config(port=self.relay.port),
            "folder": str(self._folder / f"run{self._runs}"),
            "state": str(self._folder / f"state{self._runs}"),
        }
        command = (sys.executable, "-m", module, json.dumps(given))
        return await asyncio.create_subprocess_exec(*command, stdout=subprocess.PIPE, env=environment())

    async def _stroke_and_cruise(self):
        self.shirt.stroke()
        await asyncio.to_thread(self.receiver.wait_for, lambda line: line["v"] > CRUISE)
        await asyncio.sleep(0.45)

    async def end_control(self):
        if self._heart is not None:
            self._heart.cancel()
            await asyncio.gather(self._heart, return_exceptions=True)
        if self.control is not None:
            await self.control.close()
        self.control = None

    def chair_stopped(self, injured):
        """Return after how long (s) the chair began to stop, and was disarmed; None when it was not."""
        lines = self.receiver.since(injured)
        before = [line for line in self.receiver.lines[-400:] if line["t"] <= injured]
        cruise = before[-1]["v"] if before else 0.0
        begun = next((line["t"] for line in lines if line["v"] < cruise - 1e-6 or line["state"] != "armed"), None)
        disarmed = next((line["t"] for line in lines if line["state"] != "armed"), None)
        return tuple(None if t is None else t - injured for t in (begun, disarmed))

    def went_on(self, injured, after):
        """Return whether the chair became faster later than `after` (s), or did not stop."""
        speeds = [abs(line["v"]) for line in self.receiver.since(injured + after)]
        return speeds != sorted(speeds, reverse=True) or bool(speeds and speeds[-1])

    async def close(self):
        await self.end_control()
        await asyncio.to_thread(self.shirt.close)
        self.relay.close()
        self.receiver.close()
        self.watcher.close()


def _decided(tick):
    return tick["state"] in (State.ARMED, State.FAULT)


@asynccontextmanager
async def rig(seed=0, *, controlled=True, output=None):
    """Yield a rig whose chair can be made to cruise.

    `controlled`: with a control process of its own; `output`: with a chair at the far end of this output.
    """
    with tempfile.TemporaryDirectory(prefix="bodydrive-drill-") as folder:
        made = Rig(folder, seed, output)
        try:
            if controlled:
                await made.start_control()
            yield made
        finally:
            await made.close()
