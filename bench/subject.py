"""The subject of the benchmarks: parameters for 52 channels and four joints, a room of 100 walls, signals, a chair."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.calibration.linear_map import LinearMap
from app.calibration.profile import CalibrationProfile, JointMap
from app.calibration.vocabulary import PAPER_VOCABULARY, ControlMode, DriveParameters, standard_parameters
from app.layout import Channel, Joint, ShirtLayout
from app.speed_limits import HIGHEST_SPEEDS
from app.world.floorplan import FloorPlan

CHANNELS = 52
STROKE_TIME, CYCLE_TIME = 0.6, 6.0  # s
WALLS = 100


def bench_parameters(sample_rate: float, mode: ControlMode = "acceleration") -> DriveParameters:
    """Return the paper's vocabulary on a made-up calibration of 13 channels per joint; `mode` is that of u1."""
    rng = np.random.default_rng(1)
    joints = list(PAPER_VOCABULARY)
    layout = ShirtLayout(
        name="bench",
        channels=tuple(Channel(name=f"c{i}", joint=joints[i % 4]) for i in range(CHANNELS)),
        joints=tuple(Joint(name=joint, label=joint) for joint in joints),
    )
    maps = []
    for joint, channels in layout.channels_of_joint.items():
        weights = rng.normal(size=len(channels))
        maps.append(
            JointMap(
                name=joint,
                channels=tuple(channels),
                mean=(0.0,) * len(channels),
                evr=0.9,
                prompted=True,
                rest_rate=0.02,
                pca=LinearMap(
                    rates=(tuple((weights / np.linalg.norm(weights) / 3.0).tolist()),), dead_zone=0.2, full=1.0
                ),
                step=0.035,
                filtered_step=0.06,
                covariance=tuple(map(tuple, np.diag(1.0 / weights**2).tolist())),
                grade="good",
                reason="made for measuring",
            )
        )
    profile = CalibrationProfile(
        created="2026-01-01T00:00:00+00:00",
        software="bench",
        layout=layout,
        sample_rate=sample_rate,
        left_out={},
        low=(-10.0,) * CHANNELS,
        high=(10.0,) * CHANNELS,
        noise=(0.0,) * CHANNELS,
        joints=tuple(maps),
    )
    return standard_parameters(profile).model_copy(update={"mode_u1": mode})


def bench_signals(parameters: DriveParameters, seconds: float) -> NDArray[np.float32]:
    """Return (n, 52) values: every joint makes a stroke in turn, rests, and comes back."""
    rate = parameters.profile.sample_rate
    t = np.arange(int(seconds * rate)) / rate
    values = np.random.default_rng(2).normal(scale=0.002, size=(len(t), CHANNELS))
    for turn, joint in enumerate(parameters.profile.joints):
        phase = np.mod(t - turn * CYCLE_TIME / 4, CYCLE_TIME)
        rise = np.clip(phase / STROKE_TIME, 0, 1)
        fall = np.clip((phase - 2 * STROKE_TIME) / (2 * STROKE_TIME), 0, 1)
        posture = 0.6 * (rise**2 * (3 - 2 * rise) - fall**2 * (3 - 2 * fall))
        values[:, list(joint.channels)] += np.outer(posture * joint.span, joint.direction)
    return values.astype(np.float32)


def bench_floorplan() -> FloorPlan:
    """Return one large room with 100 walls and a path through its middle."""
    walls: list[tuple[tuple[float, float], ...]] = []
    for i in range(WALLS // 2):
        x = -25.0 + i
        walls += [((x, 2.0), (x + 0.5, 2.0 + (i % 3))), ((x, -2.0), (x + 0.5, -2.0 - (i % 3)))]
    document = {
        "name": "bench",
        "title": "Bench",
        "walls": walls,
        "paths": [
            {"name": "main", "title": "Main", "points": [(-20.0, 0.0), (20.0, 0.0)], "instruction": "Drive ahead."}
        ],
    }
    return FloorPlan.model_validate(document)


def bench_chair(port: int, key_file: Path) -> dict[str, Any]:
    """Return the configuration of a real chair whose receiver listens on `port` of this machine."""
    speeds = HIGHEST_SPEEDS.model_dump(mode="json")
    return {
        "kind": "udp",
        "name": "bench",
        "host": "127.0.0.1",
        "port": port,
        "key_file": str(key_file),
        "speeds": speeds,
    }
