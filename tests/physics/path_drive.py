"""The study's 28 m path: what a practised person commanded there, given to the physical and the built-in chairs."""

import random
from collections.abc import Sequence
from typing import Final

from physics.built_in import UNICYCLE, Difference, Pair, built_in, difference, fit
from physics.chair_model import BUILT_IN, MOTOR_LAGS, Floor, PhysicalChair
from physics.commands import gate_twists
from physics.drives import castor_wishes, physical_course

from app.calibration.vocabulary import standard_parameters
from app.geometry import Twist
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import PRACTISED
from app.speed_limits import Speeds
from app.study.experiment import SEEDS_APART, shirt_layout
from app.study.participant import Participant
from app.study.simulated_calibration import SAMPLE_RATE, calibrate
from app.study.simulated_trial import drive_trial
from app.world.dynamics import Wheelchair
from app.world.floorplan import bundled_floorplans, load_floorplan

FIT_LAGS: Final = (MOTOR_LAGS[0], PhysicalChair().motor_lag, MOTOR_LAGS[1])  # s
MANOEUVRES: Final = 4  # with castors that turn round, beside the path


def path_twists(seed: int) -> list[Twist]:
    """Return what the gate permitted a practised simulated person on the 28 m path, 100 a second."""
    plan = load_floorplan(bundled_floorplans()["clinic"])
    participant = Participant(SimulatedPerson(PRACTISED, seed), shirt_layout(), SAMPLE_RATE, seed + SEEDS_APART)
    parameters = standard_parameters(calibrate(participant))
    columns = drive_trial(1, participant, parameters, plan, plan.path_named("main")).columns
    return [Twist(v, omega) for v, omega in zip(columns["v"].tolist(), columns["omega"].tolist(), strict=True)]


def compare(twists: Sequence[Twist], fitted: Wheelchair) -> dict[str, Difference]:
    """Return how far the built-in chairs are from the physical one on a level floor."""
    physical = physical_course(twists, PhysicalChair(), Floor())
    chairs = {"answers at once": UNICYCLE, "wheelchair": BUILT_IN, "wheelchair, fitted": fitted}
    return {name: difference(built_in(twists, chair), physical) for name, chair in chairs.items()}


def fit_all(twists: Sequence[Twist], seed: int) -> dict[float, Wheelchair]:
    """Return the built-in wheelchair that fits the physical one, for each of FIT_LAGS (s)."""
    rng = random.Random(seed)
    courses = [twists, *(list(gate_twists(Speeds(), castor_wishes(rng))) for _ in range(MANOEUVRES))]
    found = {}
    for motor_lag in FIT_LAGS:
        chair = PhysicalChair(motor_lag=motor_lag)
        pairs: list[Pair] = [(each, physical_course(each, chair, Floor())) for each in courses]
        found[motor_lag] = fit(pairs)
    return found
