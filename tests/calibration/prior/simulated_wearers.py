"""Simulated wearers of one knitted sleeve for the tests of the prior: a ring of sensors round one elbow.

The sleeve is alike on everybody: every sensor has its own way to follow the angle. What differs from person to person
are the gains, a little of how each sensor follows, and how quickly the person moves.
"""

import numpy as np

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.repetitions import Stretch
from app.calibration.prior.documents import OwnPrior
from app.calibration.prior.entry import person_entry
from app.layout import Channel, Joint, ShirtLayout
from app.signals.low_pass import slow_average

RATE = 50.0
LINEAR = np.array([1.0, -0.5, 0.8, 0.25, -0.9])
SQUARE = np.array([0.3, 0.6, -0.5, 0.0, 0.4])
SLOW = np.array([0.3, 0.2, 0.4, 0.1, 0.3])
SENSORS = len(LINEAR)


def sleeve(ring=True, sensors=SENSORS):
    """Return the layout of the sleeve."""
    places = [{"ring": "cuff", "place": i} if ring else {} for i in range(sensors)]
    return ShirtLayout(
        name="sleeve",
        channels=tuple(Channel(name=f"e{i}", joint="right_elbow", **place) for i, place in enumerate(places)),
        joints=(Joint(name="right_elbow", label="right elbow"),),
    )


class Wearer:
    """One person: `angle` (n,) 0 to 1, `values` (n, 5), and the true strokes as pairs of rows."""

    def __init__(self, seed, seconds=40.0, rate=RATE, gains=(0.7, 1.4)):
        rng = np.random.default_rng(seed)
        self.rate = rate
        self.t = np.arange(round(seconds * rate)) / rate
        self.angle = np.zeros(len(self.t))
        self.strokes = []
        start = 1.0
        while start + 3.5 < seconds:
            rise, back = rng.uniform(0.6, 0.9), rng.uniform(0.9, 1.3)
            size = rng.uniform(0.8, 1.0)
            there = np.clip((self.t - start) / rise, 0, 1)
            home = np.clip((self.t - start - rise - 0.4) / back, 0, 1)
            self.angle += size * 0.5 * (np.cos(np.pi * home) - np.cos(np.pi * there))
            self.strokes.append((round(start * rate), round((start + rise) * rate)))
            start += rng.uniform(3.2, 4.0)
        factor = np.exp(rng.uniform(*np.log(gains), SENSORS))
        linear = LINEAR + 0.08 * rng.normal(size=SENSORS)
        relaxed = slow_average(self.angle, 1.5, rate)
        clean = np.outer(self.angle, linear) + np.outer(self.angle**2, SQUARE) + np.outer(relaxed, SLOW)
        self.values = factor * clean + 0.004 * rng.normal(size=clean.shape) + rng.normal(size=SENSORS)
        self.lead = [rng.normal(0.3, 0.1) for _ in self.strokes]

    @property
    def moving(self):
        """Return where (n,) the angle rises in a stroke."""
        rows = np.zeros(len(self.t), dtype=bool)
        for start, stop in self.strokes:
            rows[start:stop] = True
        return rows

    def stretch(self, most=None, values=None):
        """Return the first prompted movements, whose cues lead."""
        cues = [
            slice(max(0, start - round(lead * self.rate)), max(1, stop - round(lead * self.rate)))
            for (start, stop), lead in zip(self.strokes[:most], self.lead, strict=False)
        ]
        last = cues[-1].stop + round(2.5 * self.rate)
        return Stretch("right_elbow", (self.values if values is None else values)[:last], tuple(cues))

    def recording(self, layout=None):
        """Return the recording that goes into a prior."""
        return CleanRecording.of(layout or sleeve(), self.rate, self.values, stretches=[self.stretch()])


def prior_of(seeds, layout=None):
    """Return an own prior of simulated wearers, with codes w1, w2, ..."""
    layout = layout or sleeve()
    return OwnPrior(
        layout=layout, people={f"w{seed}": person_entry([Wearer(seed).recording(layout)]) for seed in seeds}
    )
