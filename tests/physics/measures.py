"""What is measured of a drive: what the person feels, the way to standstill, the loads of the wheels. No MuJoCo."""

import math
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray
from physics.chair_model import COLUMNS, LOADS, TIME_STEP
from scipy.signal import butter, sosfilt

from app.speed_limits import Speeds

FELT_CUTOFF: Final = 10.0  # Hz: a causal Butterworth low-pass of second order; quicker shakes do not move a body
STILL, STILL_TURN = 0.02, 0.02  # m/s, rad/s: below both, the chair stands
WINDOW: Final = 20  # samples, 20 ms, over which a wheel's load is averaged
LIFTED: Final = 1.0  # N: with less, a wheel has left the floor
SAMPLES_PER_TICK: Final = 10

Numbers = NDArray[np.float64]


class Felt(NamedTuple):
    """Magnitudes over time at the person's chest."""

    acceleration: Numbers  # (n,) m/s2
    jerk: Numbers  # (n,) m/s3


class Stop(NamedTuple):
    """The way to standstill; NaN where the chair did not come to standstill."""

    distance: float  # m
    time: float  # s
    roll_back: float  # m, from the first standstill to where the chair stands in the end


@dataclass(frozen=True, slots=True)
class Outcome:
    """One drive."""

    cell: str
    speeds: Speeds  # of the parameter set
    speed: float  # m/s at the ending
    stop: Stop
    felt_driving: float  # m/s2, largest before the ending
    deceleration: float  # m/s2, largest felt after the ending
    jerk: float  # m/s3, largest felt after the ending
    least_load: float  # smallest load of a wheel, as a share of its load at rest on this floor
    lifted_driving: bool  # whether a wheel left the floor before the ending
    lifted_stopping: bool  # ... and after it
    tilt: float  # degrees, largest angle between the chair and its floor
    is_tipped: bool
    height: float  # m above the floor on which the drive began, in the end


def outcome(cell: str, speeds: Speeds, samples: Numbers, ended: int, rest: Numbers, *, is_tipped: bool) -> Outcome:
    """Return the figures of a drive.

    Parameters
    ----------
    samples : (n, SAMPLE_WIDTH) at 1 kHz, n above WINDOW
    ended : index of the first sample after the ending; at most n, as of a chair that tipped over before
    rest : (4,) N, the loads at rest
    """
    acceleration, jerk = felt(samples[:, COLUMNS["chest"]])
    loads = running_mean(samples[:, LOADS])
    lifted: NDArray[np.bool_] = np.any(loads < LIFTED, axis=1)
    last = min(ended, len(samples) - 1)
    up = samples[:, COLUMNS["up"]][:, 2].clip(-1.0, 1.0)
    return Outcome(
        cell=cell,
        speeds=speeds,
        speed=float(np.linalg.norm(samples[last, COLUMNS["axle"]][:2])),
        stop=stop_of(samples[ended:]),
        felt_driving=float(acceleration[:ended].max()),
        deceleration=float(acceleration[ended:].max(initial=0.0)),
        jerk=float(jerk[ended:].max(initial=0.0)),
        least_load=float((loads / rest).min()),
        lifted_driving=bool(lifted[:ended].any()),
        lifted_stopping=bool(lifted[ended:].any()),
        tilt=math.degrees(math.acos(float(up.min()))),
        is_tipped=is_tipped,
        height=float(samples[-1, COLUMNS["place"]][2]),
    )


def felt(velocity: Numbers) -> Felt:
    """Return what a person feels of a velocity (n, 3) in m/s at 1 kHz; at its beginning the person is at rest."""
    low_pass = butter(2, FELT_CUTOFF, fs=1.0 / TIME_STEP, output="sos")
    smooth = sosfilt(low_pass, np.gradient(velocity, TIME_STEP, axis=0), axis=0)
    jerk = np.gradient(smooth, TIME_STEP, axis=0)
    return Felt(np.linalg.norm(smooth, axis=1), np.linalg.norm(jerk, axis=1))


def stop_of(samples: Numbers) -> Stop:
    """Return the way to standstill from samples (n, SAMPLE_WIDTH) that begin with the ending of the drive."""
    axle, turn = samples[:, COLUMNS["axle"]], samples[:, COLUMNS["turn"]]
    stands = np.flatnonzero((np.linalg.norm(axle[:, :2], axis=1) < STILL) & (np.abs(turn[:, 2]) < STILL_TURN))
    if not len(stands):
        return Stop(math.nan, math.nan, math.nan)
    first = int(stands[0])
    place = samples[:, COLUMNS["place"]][:, :2]
    way = np.linalg.norm(np.diff(place[: first + 1], axis=0), axis=1).sum()
    return Stop(float(way), first * TIME_STEP, float(np.linalg.norm(place[-1] - place[first])))


def running_mean(values: Numbers) -> Numbers:
    """Return the means (n - WINDOW + 1, k) of values (n, k), each over the WINDOW values that begin there."""
    total = np.cumsum(np.vstack([np.zeros((1, values.shape[1])), values]), axis=0)
    means: Numbers = (total[WINDOW:] - total[:-WINDOW]) / WINDOW
    return means


def course_of(samples: Numbers) -> Numbers:
    """Return x, y (m), heading (rad, without jumps), speed (m/s) and turn rate (rad/s) after each tick, (ticks, 5)."""
    each = samples[SAMPLES_PER_TICK - 1 :: SAMPLES_PER_TICK]
    ahead = each[:, COLUMNS["ahead"]]
    heading = np.unwrap(np.arctan2(ahead[:, 1], ahead[:, 0]))
    place, speed, turn = each[:, COLUMNS["place"]], each[:, COLUMNS["axle"]][:, 0], each[:, COLUMNS["turn"]][:, 2]
    return np.column_stack([place[:, :2], heading, speed, turn])
