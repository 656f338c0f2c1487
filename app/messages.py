"""The messages of each turn of the loop: frames, head poses and states of the chair in, ticks out."""

# Compiled in a wheel (hatch_build.py).

import math
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.faults import Fault, State
from app.layout import MAX_CHANNELS, MAX_JOINTS

MAX_GESTURES = MAX_JOINTS

NO_CUE = -1
LONGEST_SAMPLE = 512  # bytes of what a page that is a sensor sends at once
FRESH_PERIODS = 3.0  # periods of a sensor for which its newest sample counts; after them its channels are NaN
IDLE_RATE = 50.0  # ticks a second that the control loop makes at least, with or without frames
ALIVE = 0.5  # s without a frame or a pose after which a device counts as silent, in sentences and in the status


@dataclass(slots=True)
class SensorFrame:
    """All channels of the shirt at one instant."""

    seq: int  # the device's own counter, u32
    t_device: float  # the device's own clock, s
    t: float  # our monotonic clock at arrival, s
    values: NDArray[np.float32]  # (n_channels,)


class HeadPose(NamedTuple):
    """Direction of the head from straight ahead, and its position."""

    t: float  # our monotonic clock at arrival, s
    yaw: float  # rad, to the left positive
    pitch: float  # rad, up positive
    roll: float  # rad, towards the right shoulder positive
    x: float = 0.0  # m ahead of where it was set up
    y: float = 0.0  # m to the left
    z: float = 0.0  # m up


@dataclass(slots=True)
class Tick:
    """Inputs, results and outputs of one turn of the control loop.

    `score`, `rate`, `drive` and `activation` have one number per gesture, in the order of the vocabulary.
    """

    t: float = 0.0  # monotonic, s
    frame_seq: int = 0
    t_device: float = math.nan  # s; NaN when no frame came in this tick
    values: NDArray[np.float32] | None = None  # (n_channels,), None when no frame came
    score: list[float] = field(default_factory=list)  # FS
    rate: list[float] = field(default_factory=list)  # FS/s (or FS for a displacement gesture)
    drive: list[float] = field(default_factory=list)  # max(0, rate - dead_zone), not clipped above
    activation: list[float] = field(default_factory=list)  # 0..1
    estimated: int = 0  # bit i: channel i is bad, and gestures that read it use an estimate from its neighbours
    u1: float = 0.0
    u2: float = 0.0
    v: float = 0.0  # m/s, behind the safety gate
    omega: float = 0.0  # rad/s, behind the safety gate
    x: float = 0.0  # m
    y: float = 0.0  # m
    theta: float = 0.0  # rad
    state: State = State.DISARMED
    fault: Fault = Fault.NONE  # why motion is not permitted; with another state than FAULT: why the drive is paused
    in_contact: bool = False
    contacts: int = 0  # since the start of the run
    stops: int = 0  # number of latched stops and faults so far, including those during another one
    dial: float = 1.0  # the speed dial: share of forward, reverse and turn speed
    chair_kind: int = 0  # 0: virtual, 1: real. chair_state to battery have a meaning for a real chair only
    chair_state: int = 0  # from its telemetry: 0 disarmed, 1 checking neutral, 2 armed, 3 fault
    chair_fault: int = 0  # from its telemetry: app.hardware.chair.reasons.Reason
    stop_input: int = 0  # 1: the chair's own stop switch is pressed
    own_joystick: int = 0  # 1: somebody moves the chair's own joystick
    measured: int = 0  # 1: the chair measures driven_v and driven_omega; 0: they are what its receiver commands
    chair_age: float = 0.0  # s, age of the chair's newest telemetry
    battery: float = math.nan  # 0..1, NaN: unknown
    driven_v: float = 0.0  # m/s, reported by the chair
    driven_omega: float = 0.0  # rad/s, reported by the chair
    scene_t: float = 0.0  # s of permitted motion since the chair was put on the start: the time of moving things
    head_yaw: float = math.nan  # rad, left positive; NaN without a head tracker or before its first pose
    head_pitch: float = math.nan  # rad, up positive
    head_roll: float = math.nan  # rad, towards the right shoulder positive
    head_age: float = math.nan  # s since the head pose came


@dataclass(slots=True)
class ChairState:
    """Where a chair is and how it moves."""

    x: float  # m
    y: float  # m
    theta: float  # rad
    v: float  # m/s, forwards; less than commanded when a wall holds the virtual chair
    omega: float  # rad/s
    in_contact: bool
    contacts: int  # beginnings of contact since the chair was placed
    scene_t: float = 0.0  # s of permitted motion since the chair was placed: the time of what moves by itself


# A Tick and its place in the run as one flat record: a slot of the ring between the processes.
TICK = np.dtype(
    [
        ("number", "u8"),  # 1, 2, 3 ... since the control process started; 0: never written
        ("t", "f8"),
        ("t_device", "f8"),
        ("run_t", "f8"),  # s since the start of the run, NaN outside a run
        ("u1", "f8"),
        ("u2", "f8"),
        ("v", "f8"),
        ("omega", "f8"),
        ("x", "f8"),
        ("y", "f8"),
        ("theta", "f8"),
        ("scene_t", "f8"),
        ("estimated", "u8"),  # bit i: channel i is bad, and gestures that read it use an estimate from its neighbours
        ("frame_seq", "u4"),
        ("lost", "u4"),  # frames missing by the shirt's counter since the shirt was opened
        ("late", "u4"),  # ticks late by more than a period since the process started
        ("contacts", "u4"),
        ("run", "u4"),  # number of the run, 0 outside a run
        ("stops", "u4"),
        ("cue", "i4"),  # index into the run's cues, NO_CUE when none is in force
        ("dial", "f4"),
        ("chair_age", "f4"),
        ("battery", "f4"),
        ("driven_v", "f4"),
        ("driven_omega", "f4"),
        ("head_yaw", "f4"),
        ("head_pitch", "f4"),
        ("head_roll", "f4"),
        ("head_age", "f4"),
        ("n_channels", "u2"),
        ("n_gestures", "u2"),
        ("has_frame", "u1"),
        ("state", "u1"),
        ("fault", "u1"),
        ("in_contact", "u1"),
        ("chair_kind", "u1"),
        ("chair_state", "u1"),
        ("chair_fault", "u1"),
        ("stop_input", "u1"),
        ("own_joystick", "u1"),
        ("measured", "u1"),
        ("score", "f8", (MAX_GESTURES,)),
        ("rate", "f8", (MAX_GESTURES,)),
        ("activation", "f8", (MAX_GESTURES,)),
        ("values", "f4", (MAX_CHANNELS,)),
    ],
    align=True,
)
