"""Tremor of every joint, at rest and in movement."""

import math

import numpy as np
from numpy.typing import NDArray

BAND = (4.0, 8.0)  # Hz: rest tremor 4 to 6, most action tremor 4 to 8 (Deuschl, Bain and Brin, Mov Disord 13 S3, 1998)
SINES = 5  # for each joint; their beats make the tremor grow and fade


class Tremor:
    """A sum of sines for each joint, with random frequencies in the band; the seed determines the tremor."""

    def __init__(self, joints: int, seed: int) -> None:
        """Draw frequencies and phases for `joints` degrees of freedom; no tremor until `size` is set."""
        random = np.random.default_rng((seed, 48))
        self.size = 0.0  # standard deviation, of a joint's range
        self._turn_rate = math.tau * random.uniform(*BAND, (joints, SINES))  # rad/s
        self._phase = random.uniform(0.0, math.tau, (joints, SINES))

    def at(self, t: float) -> NDArray[np.float64]:
        """Return the tremor of each joint at `t` (s), (n_joints,), of its range."""
        shaken: NDArray[np.float64] = np.sin(self._turn_rate * t + self._phase).sum(axis=1)
        return shaken * (self.size * math.sqrt(2.0 / SINES))  # the sum's variance is SINES / 2
