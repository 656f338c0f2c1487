"""Networks of LSL streams for tests: one of this folder's stand-in, one of pylsl itself on this machine alone."""

import os

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.fake_lsl import FakeLsl

from app.clock import MonotonicClock
from app.lsl_library import LSL_MISSING, load_lsl
from needed import lacks

ANSWER = 20.0  # s that anything on this machine may take


class StandIn:
    """The stand-in for pylsl, on a fake clock."""

    def __init__(self):
        self.clock = FakeClock(100.0)
        self.lsl = FakeLsl(self.clock)

    def add(self, name, source_id, labels, rate):
        return StandInSender(self.lsl.add_sender(name, len(labels), rate, source_id=source_id, labels=labels))


class StandInSender:
    """A sender of the stand-in; `push` takes time stamps (s, of LSL's clock)."""

    def __init__(self, sender):
        self._sender = sender

    def wait_for_receiver(self):
        assert self._sender.inlets

    def push(self, stamps, values):
        now = self._sender.lsl.clock.now()
        for stamp, row in zip(stamps, values, strict=True):
            self._sender.send(row.tolist(), now, stamp=float(stamp))

    def end(self):
        self._sender.end()


class Loopback:
    """pylsl, whose streams no other machine and no other test sees."""

    def __init__(self, folder, patch):
        file = folder / "lsl_api.cfg"
        settings = {
            "multicast": "ResolveScope = machine",
            "lab": f"KnownPeers = {{127.0.0.1}}\nSessionID = bodydrive-tests-{os.getpid()}",
            "log": "level = -2",
        }
        file.write_text("".join(f"[{part}]\n{lines}\n" for part, lines in settings.items()))
        patch.setenv("LSLAPICFG", str(file))
        self.clock = MonotonicClock()
        try:
            self.lsl = load_lsl()
        except LSL_MISSING:
            lacks("there is no pylsl with liblsl here: install what pyproject.toml names")

    def add(self, name, source_id, labels, rate):
        info = self.lsl.StreamInfo(name, "MoCap", len(labels), rate, "float32", source_id)
        channels = info.desc().append_child("channels")
        for label in labels:
            channels.append_child("channel").append_child_value("label", label)
        return LoopbackSender(self.lsl.StreamOutlet(info))


class LoopbackSender:
    """An outlet of pylsl."""

    def __init__(self, outlet):
        self._outlet = outlet

    def wait_for_receiver(self):
        assert self._outlet.wait_for_consumers(ANSWER)

    def push(self, stamps, values):
        rows = np.ascontiguousarray(values, dtype=np.float32)
        self._outlet.push_chunk(rows, [float(stamp) for stamp in stamps])

    def end(self):
        del self._outlet


def networks(tmp_path_factory):
    """Yield a function that returns a network by its name; pylsl reads its settings once in a process."""
    with pytest.MonkeyPatch.context() as patch:
        made = {}

        def network(name):
            if name not in made:
                made[name] = StandIn() if name == "stand-in" else Loopback(tmp_path_factory.mktemp("lsl"), patch)
            return made[name]

        yield network
