"""A recorded drive through the chain again, tick by tick: the commands equal the recorded ones to the last bit.

The gate's decisions are not made again but read from the recording, which does not hold all of their reasons.
Everything else uses the objects of the loop, in their order. `app.pipeline.replay.rerun` is hundreds of times faster
and equal to a millionth.
"""

# Compiled in a wheel (hatch_build.py).

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from app.calibration.vocabulary import DriveParameters
from app.faults import State
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.json_values import JsonDocument
from app.messages import SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.replay.rerun import chair_of, sample_rate_of
from app.pipeline.safety_gate import BadGestures, Conditions, SafetyGate
from app.recording.format import Columns
from app.recording.reader import RunRecording
from app.sentences import one_sentence
from app.speed_limits import Speeds
from app.texts import Text


class RecordedGate(SafetyGate):
    """Limits the twist as the gate does, and permits motion where the recording says that it was permitted."""

    recorded = State.DISARMED

    def decide(
        self, t: float, pause: float, neutral: bool, bad: BadGestures, frame_age: float, conditions: Conditions
    ) -> State:
        """Return the recorded decision of this tick; the arguments do not matter."""
        del t, pause, neutral, bad, frame_age, conditions
        if self.state is not self.recorded:
            self._withdraw(self.recorded)
        return self.state


DIAL_DIGITS = 6  # the dial is recorded in single precision; people set it in steps of 0.01


@dataclass(frozen=True, slots=True)
class Rerun:
    """The outputs of a rerun; (n_rows,) each, per gesture (n_rows, n_gestures). Units as in `app.messages.Tick`."""

    score: NDArray[np.float64]
    rate: NDArray[np.float64]
    activation: NDArray[np.float64]
    u1: NDArray[np.float64]
    u2: NDArray[np.float64]
    v: NDArray[np.float64]
    omega: NDArray[np.float64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    theta: NDArray[np.float64]


def replay_run(run: RunRecording, parameters: DriveParameters) -> Rerun:
    """Drive a recorded drive again through `parameters`, on the virtual chair.

    With the parameters of the recorded drive every number equals the recorded number, bit for bit, as long as no
    frame waited more than 50 ms for its tick.

    Raises
    ------
    ValueError
        In one sentence, when the run is empty, was recorded with another number of channels, or says nonsense of
        itself.
    """
    columns = run.columns
    count, channels = len(columns["t"]), len(parameters.profile.layout.channels)
    if count == 0:
        raise ValueError(Text("drives-replay-empty"))
    recorded = columns["values"].shape[1]
    if recorded != channels:
        raise ValueError(Text("drives-replay-channels", recorded=recorded, expected=channels))
    sample_rate = sample_rate_of(run.meta, parameters.profile.sample_rate)
    chain = Chain(sample_rate, parameters, chair_of(run.meta) or VirtualChair(None, Pose(0.0, 0.0, 0.0)))
    gate = RecordedGate(chain.limits, sample_rate)
    chain.gate = gate
    chain.set_clinic(_clinic(run.meta))
    return _drive(chain, gate, columns)


def _drive(chain: Chain, gate: RecordedGate, columns: Columns) -> Rerun:
    conditions = Conditions()
    count, gestures = len(columns["t"]), len(chain.parameters.gestures) if chain.parameters else 0
    numbers = {name: np.empty(count) for name in ("u1", "u2", "v", "omega", "x", "y", "theta")}
    lists = {name: np.empty((count, gestures)) for name in ("score", "rate", "activation")}
    dial = columns["dial"].astype(np.float64)
    for i in range(count):
        share = round(float(dial[i]), DIAL_DIGITS)
        if share != chain.dial:
            chain.set_dial(share)
        gate.recorded = State(int(columns["state"][i]))
        t = float(columns["t"][i])
        tick = chain.step(_frame(columns, i, t), t, conditions)
        for name, column in (*numbers.items(), *lists.items()):
            column[i] = getattr(tick, name)
    return Rerun(**lists, **numbers)


def _frame(columns: Columns, row: int, t: float) -> SensorFrame | None:
    if not columns["has_frame"][row]:
        return None
    device = float(columns["t_device"][row])
    return SensorFrame(int(columns["frame_seq"][row]), device, t, columns["values"][row].astype(np.float32))


def _clinic(meta: JsonDocument) -> Speeds:
    """Return the clinic's limits of a recording."""
    try:
        return Speeds.model_validate(meta.get("clinic"))
    except ValidationError as error:
        raise ValueError(one_sentence(error, Text("drives-replay-part", part="clinic"))) from error
