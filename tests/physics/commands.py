"""From wishes to what a receiver drives: the chain's own shaper and gate, signed commands, the receiver of the chair.

Simulated time, no socket.
"""

from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from typing import Literal, NamedTuple

from hardware.chair.commanded_receiver import CommandedReceiver
from pipeline.gates import DT, armed_gate

from app.calibration.vocabulary import DriveParameters
from app.geometry import Twist
from app.hardware.chair.packet import DRIVE, STOP
from app.hardware.chair.reasons import Reason
from app.pipeline.shaping import Shaper
from app.speed_limits import Speeds
from building import make_parameters

Ending = Literal["stop", "silence", "switch"]
ENDINGS: tuple[Ending, ...] = ("stop", "silence", "switch")
TICKS_PER_COMMAND = 2  # 50 commands a second from 100 ticks


class Wish(NamedTuple):
    """Controls that are held for a while."""

    u1: float  # -1 to 1
    u2: float
    seconds: float

    @property
    def ticks(self) -> int:
        """How many ticks it lasts."""
        return round(self.seconds / DT)


@cache
def _parameters() -> DriveParameters:
    return make_parameters().model_copy(update={"mode_u1": "velocity", "mode_u2": "velocity"})


def gate_twists(speeds: Speeds, wishes: Sequence[Wish]) -> Iterator[Twist]:
    """Yield what an armed gate with these limits permits at each tick, 100 a second."""
    shaper = Shaper(_parameters().model_copy(update={"speeds": speeds}))
    gate = armed_gate(speeds)
    for wish in wishes:
        for _ in range(wish.ticks):
            yield gate.limit(shaper.step(wish.u1, wish.u2, gate.last, gate.rates, DT), DT)


def receiver_twists(twists: Iterable[Twist], ending: Ending = "stop") -> Iterator[Twist]:
    """Yield what the receiver drives in each 10 ms: `twists` as signed commands, then without end their ending.

    `stop`: a command with the stop flag; `silence`: no more commands; `switch`: the chair's own stop input.
    """
    chair = CommandedReceiver()
    chair.arm()
    for tick, twist in enumerate(twists):
        if tick % TICKS_PER_COMMAND == 0:
            chair.send(*twist, DRIVE)
        chair.step()
        yield chair.receiver.driven
    if ending == "stop":
        chair.send(0.0, 0.0, STOP)
    elif ending == "switch":
        chair.conditions["obstacle"] = Reason.STOP_INPUT
    while True:
        chair.step()
        yield chair.receiver.driven
