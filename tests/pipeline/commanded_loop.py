"""The commands of a control loop that runs on a fake clock in the process of the test."""

import json
import select
import socket

from fake_clock import FakeClock
from pipeline.scripted_shirt import ScriptedShirt

from app.hardware.shirt.udp import UdpConfig
from app.pipeline.commands import Commands
from app.pipeline.loop import ControlLoop
from app.pipeline.setup import Setup
from app.process.command_channel import NO_ANSWER, CommandServer
from app.texts import from_document
from building import make_parameters, make_ring, make_signals


class CommandedLoop:
    """A control loop with its commands, their answers, a scripted shirt and the heartbeat."""

    def __init__(self):
        self.parameters = make_parameters()
        signals = make_signals(self.parameters, 2000, strokes=False)
        self.clock = FakeClock()
        self.ring = make_ring()
        self.setup = Setup(self.clock)
        layout = self.parameters.profile.layout
        self.setup.shirt = ScriptedShirt(self.clock, [i / 100 for i in range(2000)], signals, layout=layout)
        self.setup.shirt_config = UdpConfig(kind="udp", key_file="shirt-1.key")  # may arm a real chair
        self.setup.use_parameters(self.parameters)
        self.loop = ControlLoop(self.setup, self.ring, None, self.clock)
        self._ours, theirs = socket.socketpair()
        self._ours.settimeout(10.0)
        self.commands = Commands(self.loop, CommandServer(theirs), [], self.clock)
        self._count = 0

    def ask(self, do, **fields):
        self._count += 1
        self._ours.sendall(json.dumps({"id": self._count, "do": do, **fields}).encode() + b"\n")
        return self.answer()

    def answer(self):
        """Poll until the answer comes, because devices are opened in a thread."""
        for _ in range(1000):
            self.commands.poll()
            if select.select([self._ours], [], [], 0.01)[0]:
                return json.loads(self._ours.recv(1 << 16))
        raise AssertionError("there is no answer")

    def notify(self, do, **fields):
        """Send a command without waiting for an answer."""
        self._ours.sendall(json.dumps({"id": NO_ANSWER, "do": do, **fields}).encode() + b"\n")
        self.commands.poll()

    def refused(self, do, **fields):
        answer = self.ask(do, **fields)
        assert not answer["ok"]
        sentence = str(from_document(answer["error"]))
        assert "\n" not in sentence
        return sentence

    def done(self, do, **fields):
        answer = self.ask(do, **fields)
        assert answer["ok"], answer
        return answer

    def live(self, seconds):
        until = self.clock.now() + seconds
        while self.clock.now() < until:
            self.loop.last_heartbeat = self.loop.last_screen_report = self.clock.now()
            self.loop.turn()

    def close(self):
        self.commands.close()
        self.setup.close()
        self._ours.close()
        self.ring.close()
