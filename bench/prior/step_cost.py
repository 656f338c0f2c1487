"""What four maps from other people cost in a step of the chain, against four of the paper's, measured in turn."""

import statistics

import numpy as np
from numpy.typing import NDArray

from app.calibration.linear_map import RATE_LAGS, LinearMap
from app.calibration.profile import JointMap
from app.calibration.vocabulary import DriveParameters
from app.clock import stopwatch
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.messages import SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.safety_gate import Conditions
from bench.subject import bench_floorplan, bench_parameters, bench_signals

SAMPLE_RATE, SECONDS, TURNS = 1000.0, 2.0, 15


def step_cost() -> list[str]:
    """Return in words how long a step takes with each kind of map, and their ratio, without and with a bad channel."""
    plain = bench_parameters(SAMPLE_RATE)
    joints = tuple(_with_prior(joint) for joint in plain.profile.joints)
    prior = plain.model_copy(update={"profile": plain.profile.model_copy(update={"joints": joints})})
    values = bench_signals(plain, SECONDS)
    broken = values.copy()
    broken[:, plain.profile.joints[0].channels[0]] = np.nan
    return [_compared(plain, prior, values, ""), _compared(plain, prior, broken, ", one channel without a value")]


def _compared(plain: DriveParameters, prior: DriveParameters, values: NDArray[np.float32], which: str) -> str:
    frames = [SensorFrame(i, i / SAMPLE_RATE, i / SAMPLE_RATE, frame) for i, frame in enumerate(values)]
    times = [(_step_time(plain, frames), _step_time(prior, frames)) for _ in range(TURNS)]
    ratio = statistics.median(other / one for one, other in times)
    before, after = (1e6 * statistics.median(column) for column in zip(*times, strict=True))
    return (
        f"chain.step, 52 channels at 1 kHz{which}: {before:.1f} us with four of the paper's maps, {after:.1f} us with "
        f"four from other people; median ratio of {TURNS} turns {ratio:.2f}"
    )


def _with_prior(joint: JointMap) -> JointMap:
    part = tuple((np.array(joint.direction) / 6.0).tolist())
    prior = LinearMap(
        rates=(part,) * len(RATE_LAGS),
        short=part,
        long=part,
        dead_zone=joint.pca.dead_zone,
        full=joint.pca.full,
        people=8,
    )
    return joint.model_copy(update={"map": "prior", "prior": prior})


def _step_time(parameters: DriveParameters, frames: list[SensorFrame]) -> float:
    """Return the median time of a step, s."""
    chain = Chain(SAMPLE_RATE, parameters, VirtualChair(bench_floorplan(), Pose(-20.0, 0.0, 0.0)))
    chain.arm()
    conditions = Conditions()
    times = []
    for frame in frames:
        before = stopwatch()
        chain.step(frame, frame.t, conditions)
        times.append(stopwatch() - before)
    return statistics.median(times)
