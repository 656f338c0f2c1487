"""A shirt with scripted frame times (s) on a fake clock, which advances while the shirt waits."""

import numpy as np

from app.messages import SensorFrame
from building import make_layout

RATE = 100.0


class ScriptedShirt:
    def __init__(self, clock, times, values=None, sample_rate=RATE, layout=None):
        self.layout, self.sample_rate, self.lost = layout or make_layout(8), sample_rate, 0
        self._values = np.ones((len(times), 8), np.float32) if values is None else values
        self._clock, self._times, self._seq = clock, list(times), 0

    def read(self, timeout):
        if not self._times or self._times[0] > self._clock.now() + timeout:
            self._clock.sleep_until(self._clock.now() + timeout)
            return None
        self._clock.sleep_until(self._times.pop(0))
        self._seq += 1
        values = self._values[self._seq - 1]
        return SensorFrame(self._seq, self._seq / self.sample_rate, self._clock.now(), values)

    def pending(self):
        return bool(self._times) and self._times[0] <= self._clock.now()

    def description(self):
        return "A shirt for tests."
