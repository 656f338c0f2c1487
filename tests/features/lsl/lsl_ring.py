"""The ticks and the names that a clinic would give to what is sent over LSL, for tests to change."""

import numpy as np

from app.messages import NO_CUE, TICK


class Ring:
    """The ticks of a control process, as the control link gives them."""

    def __init__(self):
        self.ticks = np.empty(0, dtype=TICK)
        self.alive = True

    def add(self, t, **fields):
        tick = np.zeros(1, dtype=TICK)
        tick["number"], tick["t"], tick["cue"] = len(self.ticks) + 1, t, NO_CUE
        for name, value in fields.items():
            tick[name] = value
        self.ticks = np.concatenate((self.ticks, tick))

    def newest(self):
        return self.ticks[-1] if self.alive and len(self.ticks) else None

    def since(self, number):
        return self.ticks[self.ticks["number"] > number] if self.alive else None

    def begin_anew(self):
        self.ticks, self.alive = np.empty(0, dtype=TICK), True


class Names:
    """What the web process knows, for tests to change."""

    def __init__(self):
        self.runs = {}
        self.cues = {}
        self.decoded = ["lean", "shrug"]

    def name_of(self, run):
        return self.runs.get(run)

    def cue_of(self, run, index):
        return self.cues[run][index] if run in self.cues else None

    def gestures(self):
        return self.decoded


def described(info):
    channel, found = info.desc().child("channels").child("channel"), []
    while not channel.empty():
        found.append((channel.child_value("label"), channel.child_value("unit")))
        channel = channel.next_sibling("channel")
    return found
