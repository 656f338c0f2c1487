"""A stand-in for the control process, its shirt, and a calibration of that shirt."""

import asyncio
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.calibration.profile import CalibrationProfile
from app.clock import monotonic
from app.faults import Fault, State
from app.hardware.configs import SHIRTS
from app.layout import Channel, Joint, ShirtLayout
from app.messages import NO_CUE, TICK
from app.pipeline.commands import STOPPED_BY
from app.process.command_channel import LinkLost, LinkRefused
from building import joint_map, profile_of

JOINTS = ("right_elbow", "left_elbow", "right_shoulder", "left_shoulder")
LAYOUT = ShirtLayout(
    name="Test shirt",
    channels=tuple(Channel(name=f"{joint}_{i}", joint=joint) for joint in JOINTS for i in (1, 2)),
    joints=tuple(Joint(name=joint, label=joint.replace("_", " ").capitalize()) for joint in JOINTS),
)


def profile_for(layout: ShirtLayout) -> CalibrationProfile:
    maps = [
        joint_map(joint, channels, (1.0,) + (0.0,) * (len(channels) - 1), evr=0.85, signal_to_noise=20.0)
        for joint, channels in layout.channels_of_joint.items()
    ]
    profile: CalibrationProfile = profile_of(layout, maps)
    return profile


class FakeProcess:
    """Answers as the control process would, and keeps its commands; `run_t` is its clock for runs."""

    def __init__(self) -> None:
        self.calls: list[tuple[str, dict[str, Any]]] = []
        self.told: list[tuple[str, dict[str, Any]]] = []
        self.refuse: dict[str, str] = {}
        self.dead = asyncio.Event()
        self.loop = asyncio.get_running_loop()
        self.state, self.fault = State.DISARMED, Fault.NONE
        self.run, self.runs, self.run_t = 0, 0, 0.0
        self.pose = (0.0, 0.0, 0.0)
        self.number = 0
        self.parameters: dict[str, Any] | None = None
        self.silent = False
        self.shirt_words, self.sends = "Sends.", True  # whether frames come from the shirt
        self.stops, self.dial, self.chair = 0, 1.0, "virtual"
        self.says: dict[str, Any] = {"battery": 0.5}  # what the real chair says, by the names of the tick
        self.switch_seen = False
        self.document, self.crawls = "", False  # of the real chair
        self.mistrust = ""  # why the shirt arms no real chair
        self.senders: dict[str, Any] | None = None  # of a shirt over the network
        self.found: list[str] = []
        self.arrivals: dict[str, Any] | None = None  # what arrives at the shirt
        self.shirt, self.body = "", None
        self.layout = LAYOUT  # of the next shirt that is opened

    async def call(self, do: str, **fields: Any) -> dict[str, Any]:
        if self.dead.is_set():
            raise LinkLost
        if do != "status":  # which is asked all the time
            self.calls.append((do, fields))
        if do in self.refuse:
            raise LinkRefused(self.refuse[do])
        if do == "body":
            self.body = fields["config"]["kind"]
        if do == "shirt":
            self.shirt, self.body = fields["config"]["kind"], None
            return {"layout": self.layout.model_dump(mode="json"), "sample_rate": 100.0, "mistrust": self.mistrust}
        if do == "parameters":
            self.parameters = fields["parameters"]
        if do == "run":
            self.runs += 1
            self.run, self.run_t = self.runs, 0.0
            self._disarm()
            simulated = SHIRTS[self.shirt].simulated
            source = {"shirt": self.shirt, "body": self.body, "chair": self.chair, "simulated": simulated}
            return {"run": self.run, "source": source}
        if do == "end_run":
            self.run = 0
            self._disarm()
            return {"rows": 500, "dropped": 0}
        if do == "arm":
            if self.parameters is None:
                raise LinkRefused("Nothing is loaded.")
            if self.state is State.FAULT:
                raise LinkRefused("There was a stop. Take the stop back, then start again.")
            self.state = State.ARMED
        if do == "chair":
            self.chair = fields["config"]["kind"]
            return {"kind": self.chair}
        if do == "dial":
            self.dial = fields["share"]
            return {"share": self.dial}
        if do == "stop":
            self.stops += 1
            self.state, self.fault = State.FAULT, STOPPED_BY[fields["by"]]
        if do == "clear" and self.state is State.FAULT:
            if fields["stops"] != self.stops:
                raise LinkRefused("There was another stop meanwhile.")
            self.state, self.fault = (State.ARMED if self.run else State.DISARMED), Fault.NONE
        if do == "status":
            frames: dict[str, Any] = {"alive": self.sends, "silent": not self.sends, "sample_rate": 100.0, "lost": 0}
            others = {"senders": self.senders, "found": self.found, "arrivals": self.arrivals}
            shirt = {"kind": "simulator", "words": self.shirt_words, **frames, **others}
            chair = {"kind": self.chair, "words": f"A {self.chair} chair.", "switch_seen": self.switch_seen}
            chair |= {"document": self.document, "crawls": self.crawls}
            loop = {"realtime": ["No real-time scheduling."], "late": 0, "recording": None, "hash": None}
            return {"shirt": shirt, "chair": chair, "dial": self.dial, **loop}
        return {}

    def _disarm(self) -> None:
        if self.state is not State.FAULT:  # a latched stop outlives the run
            self.state = State.DISARMED

    def send(self, do: str, **fields: Any) -> None:
        if self.dead.is_set():
            raise LinkLost
        self.told.append((do, fields))

    def newest(self) -> np.void | None:
        ticks = self.since(0)
        return ticks[-1]

    def since(self, _number: int) -> NDArray[np.void]:
        self.number += 1
        tick = np.zeros(1, TICK)
        tick["number"], tick["t"] = self.number, 0.0 if self.silent else monotonic()
        tick["run"], tick["run_t"] = self.run, self.run_t if self.run else np.nan
        tick["x"], tick["y"], tick["theta"] = self.pose
        tick["state"], tick["fault"], tick["cue"] = self.state, self.fault, NO_CUE
        tick["has_frame"], tick["n_channels"], tick["n_gestures"] = self.sends, 8, 4
        tick["stops"], tick["dial"], tick["chair_kind"] = self.stops, self.dial, self.chair == "udp"
        for name, value in self.says.items():
            tick[name] = value
        tick["values"][0, :8] = np.nan
        tick["values"][0, 1] = 0.5
        return tick

    def kill(self) -> None:
        self.die()

    def die(self) -> None:
        """Die as a process does: at any moment, outside of every thread."""
        self.loop.call_soon_threadsafe(self.dead.set)

    async def died(self) -> None:
        await self.dead.wait()

    async def close(self) -> None:
        self.dead.set()
