"""Every motion can be stopped (safety S22): every mode, direction, kind of vocabulary and set of broken joints.

A person makes one movement until the chair moves along one axis. Then sensors break. Either the gate stops the chair
within 200 ms, or the person brings it to rest with the gestures that are left, long before any time-out could. A
sensor that is stuck at any value, with noise, is found a little later; with the noise of a good one it is not found,
and only sets are armed in which the person can stop the chair all the same.
"""

import copy
import itertools
import math
from typing import get_args

import numpy as np
import pytest

from app.calibration.vocabulary import (
    PAPER_VOCABULARY,
    STOP_TOGETHER,
    Binding,
    Control,
    ControlMode,
    DriveParameters,
    Feature,
    Gesture,
)
from app.faults import Fault, State
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.messages import SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.channel_health import STUCK_TIME
from app.pipeline.person_brakes import missing_brake
from app.pipeline.safety_gate import Conditions
from app.pipeline.stop_ramp import STOP_TIME
from building import make_profile

pytestmark = pytest.mark.uncompiled  # a chain is copied to look at what it would do

RATE = 100.0  # Hz
# Every case has half as many frames as the shirt sends; in `make drills` it has all of them.
RATES = (50.0, pytest.param(RATE, marks=pytest.mark.long))
TREMBLE = 1e-6  # signal units of noise, so that no channel is constant
PROFILE = make_profile(n_channels=8).model_copy(update={"noise": (TREMBLE,) * 8})  # two channels a joint
REST = np.zeros(8)
CHANNELS = {joint.name: list(joint.channels) for joint in PROFILE.joints}
FULL = {joint.name: joint.span * np.array(joint.direction) for joint in PROFILE.joints}  # of one full movement
for joint in PROFILE.joints:
    REST[CHANNELS[joint.name]] = joint.mean
MODES = get_args(ControlMode)
DIRECTIONS = [control for control in get_args(Control) if control != "stop"]
STOPPED_WITHIN = 0.2  # s
BRAKING = 3.0  # s: from any speed that is reached here to rest
NO_BRAKE = 0.5  # s: what has not slowed the chair by then is no brake, and need not be made for longer
NEVER = {"cruise_time": 30.0, "turn_cruise_time": 10.0}  # s: long enough that no time-out stops the chair
BIT = 0.1  # of the noise: what a stuck sensor still shows
STROKE = 1.5  # FS/s, and FS for a displacement gesture: beyond `full`


def both_ways(joint):
    """Return the two gestures of one joint."""
    return f"{joint}.on", f"{joint}.back"


PAPER = {control: (joint,) for joint, control in PAPER_VOCABULARY.items()}
ELBOW, SHOULDER = both_ways("right_elbow"), both_ways("right_shoulder")
PAIRED = {"u1+": ELBOW[:1], "u1-": ELBOW[1:], "u2+": SHOULDER[:1], "u2-": SHOULDER[1:]}
VOCABULARIES = {
    "paper": {**PAPER, "stop": STOP_TOGETHER},
    "paper, no stop": PAPER,
    "paper, stop of other joints": {**PAPER, "stop": ("right_shoulder", "left_shoulder")},
    "one joint both ways": PAIRED,
    "one joint both ways, stop": {**PAIRED, "stop": (ELBOW[0], SHOULDER[0])},
    "a stop that no body can make": {"u1+": ELBOW[:1], "u2+": SHOULDER[:1], "stop": ELBOW},
    "no way back": {"u1+": PAPER["u1+"], "u2-": PAPER["u2-"]},
}


def parameters_of(bound, feature, modes):
    """Return the set in which `bound` gestures, read as `feature`, drive in these modes."""
    names = sorted({name for gestures in bound.values() for name in gestures})
    gestures = [
        Gesture(
            name=name,
            joint=name.split(".")[0],
            direction=-1 if name.endswith(".back") else 1,
            feature=feature,
            dead_zone=0.2,
            full=1.0,
        )
        for name in names
    ]
    return DriveParameters(
        profile=PROFILE,
        gestures=tuple(gestures),
        bindings=tuple(Binding(control=control, gestures=names) for control, names in bound.items()),
        mode_u1=modes[0],
        mode_u2=modes[1],
        **NEVER,
    )


class Person:
    """A chain and a person, some of whose joints the shirt no longer senses."""

    def __init__(self, parameters, rate=RATE):
        self.parameters = parameters
        self.rate = rate
        self.chain = Chain(rate, parameters, VirtualChair(None, Pose(0.0, 0.0, 0.0)))
        self.gestures = {gesture.name: gesture for gesture in parameters.gestures}
        self.posture = dict.fromkeys((joint.name for joint in PROFILE.joints), 0.0)  # FS
        self.broken = frozenset()
        self.stuck = {}  # joint -> posture in which all its sensors are stuck
        self.noise = BIT  # of a stuck sensor, as a share of a good one's
        self.steps = 0

    def make(self, *names):
        """Make these gestures for one tick; all other joints rest."""
        wishes = {self.gestures[name].joint: self.gestures[name] for name in names}
        for joint, posture in self.posture.items():
            gesture = wishes.get(joint)
            if gesture and gesture.feature == "rate":
                self.posture[joint] = posture + gesture.direction * STROKE / self.rate
            elif self.parameters.gestures[0].feature == "displacement":
                wish = gesture.direction * STROKE if gesture else 0.0
                self.posture[joint] = posture + max(-10 / self.rate, min(10 / self.rate, wish - posture))
        return self._tick()

    def _tick(self):
        values = REST + TREMBLE * (self.steps % 2)
        for joint, channels in CHANNELS.items():
            posture = self.posture[joint]
            if joint in self.stuck:
                posture = self.stuck[joint]
                values[channels] = REST[channels] + self.noise * TREMBLE * (self.steps % 2)
            if posture:
                values[channels] += posture * FULL[joint]
            if joint in self.broken:
                values[channels[0]] = math.nan
        t = self.steps / self.rate
        self.steps += 1
        return self.chain.step(SensorFrame(self.steps, t, t, values), t, Conditions())

    def for_seconds(self, seconds, *names):
        """Make gestures for so long, and return the last tick's speeds."""
        for _ in range(round(seconds * self.rate)):
            tick = self.make(*names)
        return tick

    def twin(self):
        """Return a copy of this person; what never changes is shared."""
        return copy.deepcopy(self, {id(self.parameters): self.parameters, id(self.gestures): self.gestures})

    def sensed(self, names):
        """Return those of these gestures that the shirt senses."""
        return tuple(name for name in names if self.gestures[name].joint not in {*self.broken, *self.stuck})

    def rests_after(self, *names):
        """Return whether these gestures, of a copy of this person, bring the chair to rest or make the gate stop it."""
        other = self.twin()
        before = speeds(self.chain)
        for step in range(round(BRAKING * self.rate)):
            other.make(*names)
            pairs = list(zip(speeds(other.chain), before, strict=True))
            if all(now * then <= 0.0 for now, then in pairs):
                return True
            if step == round(NO_BRAKE * self.rate) and all(abs(now) >= abs(then) for now, then in pairs):
                return False
        return False


def first_brake(person, ways):
    """Return the first of these ways that brings the chair to rest, and let the search begin with it next time."""
    tried = set()
    for way in list(ways):
        sensed = person.sensed(way)
        if sensed not in tried and person.rests_after(*sensed):
            ways.remove(way)
            ways.insert(0, way)
            return way
        tried.add(sensed)
    return None


def speeds(chain):
    return chain.gate.last.v, chain.gate.last.omega


def moving_along(direction, bound, parameters, rate=RATE):
    """Return a person whose chair moves in this direction; None when the gate lets it not begin."""
    person = Person(parameters, rate)
    person.chain.arm()
    person.for_seconds(0.7)
    for _ in range(round(0.5 * rate)):
        tick = person.make(*bound[direction])
    if tick.state is State.FAULT:
        assert speeds(person.chain) == (0.0, 0.0)
        return None
    assert max(map(abs, speeds(person.chain))) > 0.05
    return person


def cases_of(vocabulary, feature, rate):
    """Yield each pair of modes, direction and set of broken joints, with a person whose chair moves like that."""
    bound = VOCABULARIES[vocabulary]
    for modes in itertools.product(MODES, repeat=2):
        parameters = parameters_of(bound, feature, modes)
        joints = sorted({gesture.joint for gesture in parameters.gestures})
        for direction in (control for control in DIRECTIONS if control in bound):
            start = moving_along(direction, bound, parameters, rate)
            for count in range(len(joints) + 1) if start else ():
                for broken in itertools.combinations(joints, count):
                    person = start.twin()
                    person.broken = frozenset(broken)
                    yield (modes, direction, broken), person


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize("vocabulary", VOCABULARIES)
@pytest.mark.parametrize("feature", get_args(Feature))
def test_what_moves_is_stopped_by_the_person_or_by_the_gate(vocabulary, feature, rate):
    unstoppable, went_on = [], 0
    stop = VOCABULARIES[vocabulary].get("stop", ())
    ways = list(dict.fromkeys([(), *((name,) for bound in VOCABULARIES[vocabulary].values() for name in bound), stop]))
    for case, person in cases_of(vocabulary, feature, rate):
        tick = person.for_seconds(STOPPED_WITHIN)
        if tick.state is State.FAULT:
            person.for_seconds(STOP_TIME)
            is_stopped = speeds(person.chain) == (0.0, 0.0)
        else:
            went_on += 1
            is_stopped = first_brake(person, ways) is not None
        if not is_stopped:
            unstoppable.append(case)
    assert unstoppable == []
    assert went_on > 0, "a gate that stops everything is none"


def test_the_cases_know_every_control():
    assert {control for bound in VOCABULARIES.values() for control in bound} == set(get_args(Control))


SEEMING_BRAKES = {
    "the same movement, only stronger": [("u1+", "right_elbow", 0.2, 1.0), ("u1-", "right_elbow", 0.8, 1.0)],
    "hardly any gain": [("u1+", "right_elbow", 0.2, 1.0), ("u1-", "left_elbow", 0.2, 1e-6)],
    "drives the other axis further": [
        ("u1+", "right_elbow", 0.2, 1.0),
        ("u2+", "right_elbow", 0.2, 1.0),
        ("u1-", "left_elbow", 0.2, 1.0),
        ("u2+", "left_elbow", 0.2, 1.0),
        ("u1+", "right_shoulder", 0.2, 1.0),
        ("u2-", "right_shoulder", 0.2, 1.0),
    ],
}


@pytest.mark.parametrize("terms", SEEMING_BRAKES.values(), ids=SEEMING_BRAKES)
def test_what_only_seems_to_be_a_brake_lets_no_motion_begin(terms):
    gestures = {f"{joint}.{dead_zone}": (joint, dead_zone) for _, joint, dead_zone, _ in terms}
    parameters = DriveParameters(
        profile=PROFILE,
        gestures=tuple(
            Gesture(name=name, joint=joint, dead_zone=dead_zone, full=dead_zone + 0.6)
            for name, (joint, dead_zone) in gestures.items()
        ),
        bindings=tuple(
            Binding(control=control, gestures=(f"{joint}.{dead_zone}",), gain=gain)
            for control, joint, dead_zone, gain in terms
        ),
        mode_u1="acceleration",
        mode_u2="acceleration",
        **NEVER,
    )
    person = Person(parameters)
    person.chain.arm()
    person.for_seconds(0.7)
    tick = person.for_seconds(0.5, "right_elbow.0.2")
    assert tick.state is State.FAULT
    assert speeds(person.chain) == (0.0, 0.0)


def test_a_broken_accelerator_leaves_the_brake_to_the_person():
    parameters = parameters_of(VOCABULARIES["paper"], "rate", ("acceleration", "velocity"))
    person = moving_along("u1+", VOCABULARIES["paper"], parameters)
    person.broken = frozenset({"right_elbow"})
    assert person.for_seconds(1.0).state is State.ARMED
    assert person.rests_after("left_elbow")


STUCK_IN = ("paper", "paper, stop of other joints", "one joint both ways")


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize("vocabulary", STUCK_IN)
@pytest.mark.parametrize("feature", get_args(Feature))
@pytest.mark.parametrize("modes", list(itertools.product(MODES, repeat=2)))
def test_what_is_stuck_with_a_bit_of_noise_is_found_and_stopped(feature, vocabulary, modes, rate):
    bound = VOCABULARIES[vocabulary]
    parameters = parameters_of(bound, feature, modes)
    ways = [(), *dict.fromkeys(bound.values())]
    for direction in (control for control in DIRECTIONS if control in bound):
        start = moving_along(direction, bound, parameters, rate)
        for joint in sorted({gesture.joint for gesture in parameters.gestures}) if start else ():
            for posture in (start.posture[joint], 0.0, 0.7):
                person = start.twin()
                person.stuck = {joint: posture}
                tick = person.for_seconds(STUCK_TIME + STOPPED_WITHIN)
                if tick.state is State.FAULT:
                    person.for_seconds(STOP_TIME)
                    assert speeds(person.chain) == (0.0, 0.0)
                else:
                    assert first_brake(person, ways) is not None, (direction, joint, posture)


def test_a_brake_that_is_stuck_with_a_bit_of_noise_is_a_fault_and_not_a_brake():
    """Nobody has to try three times: the chair stops because the only brake does not answer."""
    parameters = parameters_of(VOCABULARIES["paper, no stop"], "rate", ("acceleration", "velocity"))
    person = moving_along("u1+", VOCABULARIES["paper, no stop"], parameters)
    person.stuck = {"left_elbow": 0.0}
    tick = person.for_seconds(STUCK_TIME + STOPPED_WITHIN)
    assert (tick.state, tick.fault) == (State.FAULT, Fault.BRAKE_BAD)


def armed_although_stuck():
    """Yield each set with held postures that is armed, and the name of each joint that could be stuck."""
    for vocabulary, bound in VOCABULARIES.items():
        for modes in itertools.product(MODES, repeat=2):
            parameters = parameters_of(bound, "displacement", modes)
            if not missing_brake(parameters):
                for joint in sorted({gesture.joint for gesture in parameters.gestures}):
                    yield vocabulary, parameters, joint


def test_what_is_stuck_with_the_noise_of_a_good_sensor_is_stopped_by_the_person():
    cases = stopped = 0
    for vocabulary, parameters, joint in armed_although_stuck():
        bound = VOCABULARIES[vocabulary]
        directions = [control for control in DIRECTIONS if bound[control][0].startswith(joint)]
        starts = [moving_along(direction, bound, parameters) for direction in directions]
        for start, posture in itertools.product(filter(None, starts), (0.3, 0.5, 0.7, STROKE)):
            person = start.twin()
            person.stuck, person.noise = {joint: posture}, 1.0
            tick = person.for_seconds(1.0)
            if tick.state is State.FAULT:  # the posture in which it stuck was reached by a jump
                assert tick.fault is Fault.NO_MOVEMENT
                stopped += 1
                continue
            stops = [way for way in bound.values() if joint not in str(way)] + [bound["stop"]]
            others = [tuple(n for n in way if not n.startswith(joint)) for way in stops]
            assert any(person.rests_after(*way) for way in others), (vocabulary, joint, posture)
            cases += 1
    assert cases + stopped >= 20
    assert cases >= 5


@pytest.mark.parametrize(
    ("vocabulary", "is_armed"),
    [
        ("paper", True),
        ("paper, stop of other joints", True),
        ("paper, no stop", False),
        ("one joint both ways", False),
        ("one joint both ways, stop", False),
        ("no way back", False),
    ],
)
@pytest.mark.parametrize("modes", list(itertools.product(MODES, repeat=2)))
def test_held_postures_that_a_stuck_sensor_could_hold_for_ever_are_not_armed(vocabulary, is_armed, modes):
    sentence = missing_brake(parameters_of(VOCABULARIES[vocabulary], "displacement", modes))
    assert (sentence is None) == is_armed
    if modes == ("velocity", "velocity") and not is_armed:
        assert str(sentence).startswith("With these controls a sensor that sticks while a posture is held could drive")
