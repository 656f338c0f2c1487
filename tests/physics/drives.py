"""Random drives of the physical chair behind its receiver, and its way when the castors turn round."""

import math
import random
from collections.abc import Mapping, Sequence
from itertools import islice
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray
from physics.built_in import built_in
from physics.chair_model import BUILT_IN, FRICTIONS, MOTOR_LAGS, Floor, PhysicalChair
from physics.commands import ENDINGS, Ending, Wish, gate_twists, receiver_twists
from physics.measures import SAMPLES_PER_TICK, Outcome, course_of, outcome
from physics.simulation import Simulation
from pipeline.gates import DT

from app.geometry import Twist
from app.speed_limits import FIRST_CHAIR_SPEEDS, HIGHEST_SPEEDS, Speeds

KERB: Final = 0.02  # m
UP, DOWN, ACROSS = 0.0, math.pi, math.pi / 2
CELLS: Final[Mapping[str, Floor]] = {
    "level": Floor(),
    "5 degrees, set off uphill": Floor(slope=math.radians(5.0), uphill=UP),
    "5 degrees, downhill": Floor(slope=math.radians(5.0), uphill=DOWN),
    "5 degrees, across": Floor(slope=math.radians(5.0), uphill=ACROSS),
    "10 degrees, set off uphill": Floor(slope=math.radians(10.0), uphill=UP),
    "10 degrees, downhill": Floor(slope=math.radians(10.0), uphill=DOWN),
    "10 degrees, across": Floor(slope=math.radians(10.0), uphill=ACROSS),
    "level, a kerb of 20 mm up": Floor(kerb=KERB),
}
"""The floors of the random drives; each drive draws its friction."""
STEEPEST: Final = frozenset(cell for cell in CELLS if cell.startswith("10 "))
AFTER: Final = 3.0  # s that are watched after the ending
LEAST_SPEED: Final = 0.1  # m/s, rad/s: slower sets are not drawn

Numbers = NDArray[np.float64]


class Plan(NamedTuple):
    """All that is random in a drive."""

    cell: str
    chair: PhysicalChair
    floor: Floor
    speeds: Speeds
    wishes: Sequence[Wish]
    ending: Ending


def random_speeds(rng: random.Random) -> Speeds:
    """Return the standard limits, those of a first chair, the highest ones, or in half of the cases any permitted."""
    kind = rng.randrange(6)
    if kind < 3:
        return (Speeds(), FIRST_CHAIR_SPEEDS, HIGHEST_SPEEDS)[kind]
    limits = Speeds.model_json_schema()["properties"]
    return Speeds(
        **{name: rng.uniform(limit.get("minimum", LEAST_SPEED), limit["maximum"]) for name, limit in limits.items()}
    )


def random_plan(cell: str, rng: random.Random) -> Plan:
    """Return a drive on one of CELLS; towards a kerb it goes straight on."""
    floor = CELLS[cell]
    wishes = [
        Wish(
            u1=rng.choice((1.0, 1.0, -1.0, 0.0, rng.uniform(-1.0, 1.0))),
            u2=rng.choice((0.0, 0.0, 1.0, -1.0, rng.uniform(-1.0, 1.0))),
            seconds=rng.uniform(0.4, 2.0),
        )
        for _ in range(rng.randint(3, 5))
    ]
    if floor.kerb:
        wishes = [Wish(rng.uniform(0.5, 1.0), 0.0, rng.uniform(2.0, 7.0))]
    return Plan(
        cell=cell,
        chair=PhysicalChair(motor_lag=rng.uniform(*MOTOR_LAGS)),
        floor=Floor(rng.uniform(*FRICTIONS), floor.slope, floor.uphill, floor.kerb),
        speeds=random_speeds(rng),
        wishes=wishes,
        ending=rng.choice(ENDINGS),
    )


def drive(plan: Plan) -> Outcome:
    """Drive a plan through gate and receiver; a drive ends early when the chair tips over."""
    simulation = Simulation(plan.chair, plan.floor)
    twists = list(gate_twists(plan.speeds, plan.wishes))
    ticks = len(twists) + round(AFTER / DT)
    for twist in islice(receiver_twists(twists, plan.ending), ticks):
        simulation.advance(twist)
        if simulation.is_tipped:
            break
    return outcome(
        plan.cell,
        plan.speeds,
        simulation.samples,
        len(twists) * SAMPLES_PER_TICK,
        simulation.rest,
        is_tipped=simulation.is_tipped,
    )


def random_drive(cell: str, seed: str) -> Outcome:
    """Return the figures of a random drive; equal seeds give equal figures on one machine."""
    return drive(random_plan(cell, random.Random(seed)))


def physical_course(twists: Sequence[Twist], chair: PhysicalChair, floor: Floor) -> Numbers:
    """Return the course (ticks, 5) of the physical chair whose receiver gets `twists`, 100 a second."""
    simulation = Simulation(chair, floor)
    for twist in islice(receiver_twists(twists), len(twists)):
        simulation.advance(twist)
    return course_of(simulation.samples)


class CastorDrift(NamedTuple):
    """By how much the chair leaves its direction while its castors turn round, degrees, in size."""

    backwards: float  # from a turn on the spot to driving backwards
    forwards: float  # from there to driving forwards
    built_in_backwards: float  # likewise of the built-in wheelchair
    built_in_forwards: float


def castor_wishes(rng: random.Random) -> tuple[Wish, ...]:
    """Turn on the spot, wait, straight back, wait, straight ahead."""
    turn = rng.choice((-1.0, 1.0)) * rng.uniform(0.3, 1.0)
    pause = Wish(0.0, 0.0, 1.0)
    return Wish(0.0, turn, rng.uniform(0.5, 1.5)), pause, Wish(-1.0, 0.0, 2.0), pause, Wish(1.0, 0.0, 3.0)


def castor_drift(seed: str) -> CastorDrift:
    """Return the drift of a random drive on a level floor, with the standard limits."""
    rng = random.Random(seed)
    wishes = castor_wishes(rng)
    twists = list(gate_twists(Speeds(), wishes))
    chair = PhysicalChair(motor_lag=rng.uniform(*MOTOR_LAGS))
    physical = physical_course(twists, chair, Floor(rng.uniform(*FRICTIONS)))
    stood = sum(wish.ticks for wish in wishes[:2]) - 1
    turned = sum(wish.ticks for wish in wishes[:4]) - 1
    drifts = [
        abs(math.degrees(course[end, 2] - course[begin, 2]))
        for course in (physical, built_in(twists, BUILT_IN))
        for begin, end in ((stood, turned), (turned, -1))
    ]
    return CastorDrift(*drifts)
