"""Five sensors on a recorded upper body: calibrated by the ordinary steps, driven along the clinic's path.

The recording has the rotation of each joint of a real person's arms. A simulated person decides which joint moves, when
and how far; the joint then turns as in its largest recorded movement.
"""

import numpy as np
import pytest

from app.calibration.map_grades import CROSS_TALK_LIMIT
from app.calibration.vocabulary import standard_parameters
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import PRACTISED
from app.hardware.shirt.orientation_sensors.body_parts import PARTS, TRUNK, layout_of
from app.hardware.shirt.orientation_sensors.orientation import angle_between, exponential, inverse, logarithm, product
from app.hardware.shirt.orientation_sensors.orientation_frames import REST_TIME, OrientationFrames
from app.messages import SensorFrame
from app.signals.columns import read_columns
from app.study.participant import Participant
from app.study.simulated_calibration import calibrate
from app.study.simulated_trial import drive_trial, score_trial
from app.world.scene import find_place
from folders import SHARED

FILE = SHARED / "data" / "upper_body" / "joint_rotations.csv"
ARM = ("upper_arm", "forearm", "hand")
WORN = (TRUNK, "right_upper_arm", "left_upper_arm", "right_forearm", "left_forearm")  # in the order of PARTS
RATE = 50.0  # Hz
RECORDED_RATE = 100.0  # Hz
MOVEMENT = 1.5  # s, of the recording: its largest movements take as long
STILL = 1400  # row of the recording at which the arms rest
STEPS = 1000  # of a movement
NOISE = 0.002  # rad, of a sensor
SWAY = 0.1  # rad by which the person turns in the chair
DRIFT = np.radians(0.1)  # rad/s

pytestmark = pytest.mark.skipif(not FILE.exists(), reason="the recorded upper body is not on this machine")


@pytest.fixture(scope="module")
def rotations():
    """Return the rotation vectors (n, 3) of each joint, from the part nearer to the trunk, rad."""
    table = read_columns(FILE)
    joints = {name.rpartition("_")[0] for name in table if name != "t"}
    return {joint: np.stack([table[f"{joint}_{axis}"] for axis in "xyz"], axis=1) for joint in joints}


def sensors_on(side, joints, trunk):
    """Return the orientation of each part of an arm in the room, of the rotations of its joints."""
    orientation, found = trunk, {}
    for part in ARM:
        name = f"{side}_{part}"
        orientation = product(orientation, joints[PARTS[name].joint])
        found[name] = orientation
    return found


def largest_movement(vectors):
    """Return the posture (4,) at the start of a joint's largest recorded movement, and the vectors (n, 3) from there.

    The vectors are at even steps along the way.
    """
    rows = round(MOVEMENT * RECORDED_RATE)
    start = int(np.argmax(np.linalg.norm(vectors[rows:] - vectors[:-rows], axis=1)))
    q = exponential(vectors[start : start + rows + 1])
    course = logarithm(product(inverse(q[0]), q))
    length = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(course, axis=0), axis=1))))
    even = np.linspace(0, length[-1], STEPS + 1)
    return q[0], np.stack([np.interp(even, length, course[:, axis]) for axis in range(3)], axis=1)


def aside(course):
    """Return a rotation vector across the way of a movement, by which its second degree of freedom turns the joint."""
    across = np.cross(course[-1], np.roll(course[-1], 1))
    return 0.4 * np.linalg.norm(course[-1]) * across / np.linalg.norm(across)


class Wearer(Participant):
    """A simulated person whose joints turn as in the recording, with a sensor on the trunk and four on the arms."""

    def __init__(self, rotations, seed, from_neighbour):
        super().__init__(SimulatedPerson(PRACTISED, seed), layout_of("trackers", WORN[1:]), RATE, seed)
        self._frames = OrientationFrames(WORN, (), RATE, from_neighbour)
        rest, course = zip(*(largest_movement(rotations[PARTS[part].joint]) for part in WORN[1:]), strict=True)
        self._rest, self._course = np.array(rest), np.array(course)
        self._aside = np.array([aside(way) for way in course])
        along = [PARTS[part].joint for part in WORN[1:]]
        self._along = [self.person.joints.index(joint) for joint in along]
        self._second = [self.person.joints.index(f"{joint}_up") for joint in along[:2]]
        self._rng = np.random.default_rng(seed)
        self._mounting = exponential(self._rng.normal(0, 1, (5, 3)))
        while np.isnan(self.rest().values).any():
            assert self._seq < 3 * REST_TIME * RATE

    def joints(self, posture):
        """Return the rotation of each joint (4, 4), shoulders before elbows."""
        along, second = posture[self._along], np.append(posture[self._second], (0.0, 0.0))
        within = np.clip(along, 0, 1)
        vectors = self._course[np.arange(4), np.round(within * STEPS).astype(int)]
        vectors = vectors + (along - within)[:, np.newaxis] * self._course[:, -1] + second[:, np.newaxis] * self._aside
        return product(self._rest, exponential(vectors))

    def _frame(self):
        joints = self.joints(self.person.step(self._dt, self._view))
        self._seq += 1
        t = self._seq * self._dt
        trunk = exponential(SWAY * np.array((0.2, 0.0, np.sin(0.6 * t))))
        upper_arms = product(trunk, joints[:2])
        body = np.concatenate((trunk[np.newaxis], upper_arms, product(upper_arms, joints[2:])))
        drift, noise = np.array((0.0, 0.0, DRIFT * t)), self._rng.normal(0, NOISE, (5, 3))
        seen = product(exponential(drift), product(product(body, self._mounting), exponential(noise)))
        for part, orientation in zip(WORN, seen, strict=True):
            self._frames.take_orientation(part, orientation, t)
        frame = self._frames.frame(t)
        values = np.full(15, np.nan, np.float32) if frame is None else frame
        return SensorFrame(self._seq, t, t, values[3:])  # the trunk, which comes first, is no gesture here


def test_the_recording_becomes_channels_without_a_gap_or_a_jump(rotations):
    """The channels of an arm measured from its neighbour are the recorded rotations, from where they began."""
    frames = OrientationFrames([TRUNK, *(f"right_{part}" for part in ARM)], (), RECORDED_RATE, from_neighbour=True)
    names = [PARTS[f"right_{part}"].joint for part in ARM]
    still, values = round(REST_TIME * RECORDED_RATE), []
    rows = np.concatenate(
        (np.full(still, 1400), np.arange(len(rotations["right_elbow"])))
    )  # at 54 s the arms are still
    quaternions = {joint: exponential(rotations[joint]) for joint in names}
    for i, row in enumerate(rows):
        turned = exponential(np.array((0.1, 0.0, 0.01 * i)))  # the person turns around
        arm = sensors_on("right", {joint: q[row] for joint, q in quaternions.items()}, turned)
        for part, orientation in {TRUNK: turned, **arm}.items():
            frames.take_orientation(part, orientation, i / RECORDED_RATE)
        values.append(frames.frame(i / RECORDED_RATE))
    channels = np.array(values[still:]).reshape(-1, 4, 3)[:, 1:]
    assert np.isfinite(channels).all()
    assert np.abs(np.diff(channels, axis=0)).max() < 0.35  # the fastest recorded movement is 0.22 rad in 10 ms
    for k, joint in enumerate(names):
        true = product(inverse(quaternions[joint][STILL]), quaternions[joint])
        assert angle_between(exponential(channels[:, k].astype(np.float64)), true).max() < 1e-5


@pytest.mark.parametrize("from_neighbour", [False, True])
def test_it_calibrates_by_the_ordinary_steps_and_drives_the_path_of_the_clinic(rotations, from_neighbour):
    wearer = Wearer(rotations, 1, from_neighbour)
    profile = calibrate(wearer)
    assert profile.left_out == {}
    assert [joint.name for joint in profile.joints] == wearer.layout.joint_names
    assert {joint.grade for joint in profile.joints} <= {"good", "usable"}
    others = np.array(profile.cross_talk)[~np.eye(4, dtype=bool)]
    assert (others.max() < CROSS_TALK_LIMIT) == from_neighbour, "an upper arm that moves takes its forearm with it"
    plan = find_place("clinic")
    path = plan.paths[0]
    trial = score_trial(plan, path, drive_trial(1, wearer, standard_parameters(profile), plan, path))
    assert trial.measures["path_length"] == pytest.approx(28.0)
    assert trial.measures["reached"]
    assert (trial.faults, trial.measures["collisions"]) == (0, 0)
