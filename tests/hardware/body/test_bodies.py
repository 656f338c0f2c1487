import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.cues import Cue
from app.hardware.base import BodyView, HardwareError, MovableBody
from app.hardware.body.joints import ARM_DEGREES_OF_FREEDOM, degrees_of_freedom, second_way
from app.hardware.body.minimum_jerk import Reach, minimum_jerk
from app.hardware.body.person import CuedBody
from app.hardware.body.recorded import RecordedBody, principal_postures
from app.hardware.body.visitor import Visitor
from folders import SHARED

DT = 0.01  # s
VIEW = BodyView()
ELBOW = ARM_DEGREES_OF_FREEDOM.index("right_elbow")
UPPER_BODY = SHARED / "data" / "upper_body" / "joint_rotations.csv"


def live(step, seconds):
    """Return postures (n, n_joints) over some time."""
    return np.array([step().copy() for _ in range(round(seconds / DT))])


def test_a_shoulder_moves_in_two_ways_and_other_joints_in_one():
    assert degrees_of_freedom(["left_shoulder", "left_wrist"]) == ("left_shoulder", "left_shoulder_up", "left_wrist")
    assert second_way("shoulder") == "shoulder_up"
    assert second_way("head") is None


@given(st.floats(-1, 2))
def test_minimum_jerk_goes_from_0_to_1_and_is_the_same_forwards_and_backwards(phase):
    assert 0.0 <= minimum_jerk(phase) <= 1.0
    assert minimum_jerk(phase) + minimum_jerk(1 - phase) == pytest.approx(1.0)


@given(st.floats(-1, 1), st.floats(-1, 1), st.floats(0.1, 3), st.floats(0, 1))
def test_a_reach_from_a_standstill_is_minimum_jerk(start, target, duration, share):
    reach = Reach(start, 0.0, target, duration)
    expected = start + (target - start) * minimum_jerk(share)
    assert reach.at(share * duration) == pytest.approx(expected, abs=1e-9)


@given(st.floats(-1, 1), st.floats(-3, 3), st.floats(-1, 1), st.floats(0.2, 2))
def test_a_reach_takes_over_place_and_speed_and_ends_at_rest(start, speed, target, duration):
    reach, step = Reach(start, speed, target, duration), 1e-6
    assert reach.at(0.0) == start
    assert (reach.at(step) - start) / step == pytest.approx(speed, abs=1e-2)
    assert reach.at(duration) == target
    assert (target - reach.at(duration - step)) / step == pytest.approx(0.0, abs=1e-2)
    assert reach.is_over(duration)


def test_at_rest_there_is_only_a_little_tremor():
    body = CuedBody(ARM_DEGREES_OF_FREEDOM, 1)
    postures = live(lambda: body.follow(DT, None), 5.0)
    assert 0.001 < postures.std() < 0.005
    assert np.abs(postures).max() < 0.02


def test_free_movement_moves_every_joint_in_both_its_ways_smoothly():
    body = CuedBody(ARM_DEGREES_OF_FREEDOM, 2)
    cue = Cue(start=0.0, end=10.0, kind="free")
    postures = live(lambda: body.follow(DT, cue), 10.0)
    assert (np.ptp(postures, axis=0) > 0.5).all()
    assert np.abs(np.diff(postures, axis=0)).max() / DT < 4.5  # of the range per second
    gone = live(lambda: body.follow(DT, None), 3.0)
    assert np.abs(gone[-1]).max() < 0.02
    assert body.is_at_rest


def test_a_prompted_movement_is_made_by_the_asked_joint_and_taken_back():
    body = CuedBody(ARM_DEGREES_OF_FREEDOM, 3)
    move = Cue(start=0.0, end=1.0, kind="move", joint="right_elbow", repetition=1)
    back = Cue(start=1.0, end=2.5, kind="return", joint="right_elbow", repetition=1)
    live(lambda: body.follow(DT, None), 1.0)
    there = live(lambda: body.follow(DT, move), 1.0)
    assert np.abs(there[:9]).max() < 0.03, "people react late"
    assert 0.7 < there[-1, ELBOW] < 1.1
    assert np.abs(np.delete(there, ELBOW, axis=1)).max() < 0.15
    assert (np.diff(there[15:, ELBOW]) > -0.01).all()
    again = live(lambda: body.follow(DT, back), 1.5)
    assert abs(again[-1, ELBOW]) < 0.03


def test_repetitions_vary_and_the_seed_decides_them():
    def tops(seed):
        body, tops = CuedBody(ARM_DEGREES_OF_FREEDOM, seed), []
        for i in range(3):
            move = Cue(start=3.0 * i, end=3.0 * i + 1, kind="move", joint="left_wrist", repetition=i + 1)
            back = Cue(start=3.0 * i + 1, end=3.0 * i + 3, kind="return", joint="left_wrist", repetition=i + 1)
            live(lambda m=move: body.follow(DT, m), 1.0)
            tops.append(float(body.follow(DT, move)[-1]))
            live(lambda b=back: body.follow(DT, b), 2.0)
        return tops

    assert len(set(tops(4))) == 3
    assert tops(4) == tops(4)
    assert tops(4) != tops(5)


def test_reset_begins_the_same_life_again():
    body = CuedBody(ARM_DEGREES_OF_FREEDOM, 6)
    cue = Cue(start=0.0, end=5.0, kind="free")
    first = live(lambda: body.follow(DT, cue), 1.0)
    body.reset()
    np.testing.assert_array_equal(live(lambda: body.follow(DT, cue), 1.0), first)


def test_equal_cues_are_one_cue_though_they_are_two_objects():
    def moved(cue_of):
        body = CuedBody(ARM_DEGREES_OF_FREEDOM, 7)
        return live(lambda: body.follow(DT, cue_of()), 1.0)

    one = Cue(start=0.0, end=1.0, kind="move", joint="right_elbow", repetition=1)
    np.testing.assert_array_equal(moved(lambda: one), moved(one.model_copy))


def test_a_pressed_key_is_a_stroke_of_half_a_second_and_a_slower_return():
    visitor = Visitor()
    visitor.move({"right_elbow": 1.0})
    there = live(lambda: visitor.step(DT, VIEW), 1.0)[:, ELBOW]
    assert there[49] > 0.95
    assert 2.0 < np.diff(there).max() / DT < 4.1
    assert (np.diff(there) >= 0).all(), "critically damped: no overshoot"
    visitor.move({"right_elbow": 0.0})
    back = live(lambda: visitor.step(DT, VIEW), 3.0)[:, ELBOW]
    assert back[49] > 0.1
    assert back[-1] == 0.0
    assert -np.diff(back).min() / DT < 2.1
    assert (np.diff(back) <= 0).all()


@given(
    st.lists(st.tuples(st.sampled_from(ARM_DEGREES_OF_FREEDOM), st.floats(0, 1)), max_size=10), st.floats(0.001, 0.5)
)
def test_wherever_the_visitor_points_the_limbs_stay_in_range(moves, dt):
    visitor = Visitor()
    for joint, place in moves:
        visitor.move({joint: place})
        for _ in range(5):
            posture = visitor.step(dt, VIEW)
            assert posture.min() >= -0.05
            assert posture.max() <= 1.2


def test_the_visitors_shoulder_is_shrugged_a_little_when_pushed():
    visitor = Visitor()
    visitor.move({"left_shoulder": 1.0})
    posture = dict(zip(visitor.joints, live(lambda: visitor.step(DT, VIEW), 2.0)[-1], strict=True))
    assert posture["left_shoulder"] == pytest.approx(1.0, abs=1e-3)
    assert 0.05 < posture["left_shoulder_up"] < 0.2
    assert posture["right_shoulder"] == 0.0


@pytest.mark.parametrize("joints", [{"tail": 0.5}, {"right_elbow": 1.5}, {"right_elbow": float("nan")}])
def test_where_no_joint_can_go_nothing_goes(joints):
    visitor = Visitor()
    with pytest.raises(ValueError, match=r"this body has no joint|cannot go to"):
        visitor.move({"left_elbow": 1.0, **joints})
    assert not live(lambda: visitor.step(DT, VIEW), 0.5).any()


def test_the_visitor_can_be_moved_and_a_body_of_its_own_will_cannot():
    assert isinstance(Visitor(), MovableBody)
    assert not isinstance(CuedBody(ARM_DEGREES_OF_FREEDOM, 1), MovableBody)


def write_rotations(file, seconds=12.0, joints=("right_elbow",), rate=50.0):
    """A joint that at times bends 1 rad about one axis, and a little about another."""
    t = np.arange(round(seconds * rate)) / rate
    bend = np.clip(np.sin(2 * np.pi * 0.25 * t), 0, None) ** 2
    header, columns = ["t"], [t + 40]
    for joint in joints:
        header += [f"{joint}_{axis}" for axis in "xyz"]
        columns += [0.6 * bend + 0.1, -0.8 * bend, 0.05 * np.sin(3 * t)]
    np.savetxt(file, np.stack(columns, axis=1), delimiter=",", header=",".join(header), comments="")
    return file, bend


def test_principal_axes_find_the_bend_whatever_its_axis_and_sign():
    t = np.arange(2000) / 100
    bend = np.clip(np.sin(t), 0, None) ** 4
    rotations = np.outer(-bend, [0.36, 0.48, 0.8]) + np.outer(0.02 * np.sin(5 * t), [0.8, -0.6, 0.0])
    first, second = principal_postures(rotations)
    assert np.corrcoef(first, bend)[0, 1] > 0.999
    assert abs(np.median(first)) < 0.1
    assert np.percentile(first, 99) == pytest.approx(1.0)
    assert abs(second).max() < 0.1


def test_a_joint_that_does_not_move_is_at_rest():
    first, second = principal_postures(np.full((100, 3), 0.3))
    assert not first.any()
    assert not second.any()


def test_a_recorded_body_goes_round_without_a_jump(tmp_path):
    body = RecordedBody(write_rotations(tmp_path / "body.csv")[0])
    assert body.duration == pytest.approx(11.0, abs=0.05)
    postures = live(lambda: body.step(DT, VIEW), 2.5 * body.duration)
    assert np.abs(np.diff(postures, axis=0)).max() / DT < 3.0
    assert np.ptp(postures[:, ELBOW]) > 0.9
    assert not np.delete(postures, ELBOW, axis=1).any(), "joints that were not recorded rest"
    body.reset()
    np.testing.assert_array_equal(live(lambda: body.step(DT, VIEW), 1.0), postures[:100])


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (None, "there is no such file"),
        ("t,a_x\n0,1\n1,2\n", "no joint of the simulated body"),
        ("t,right_elbow_x,right_elbow_y\n0,1,2\n1,2,3\n", "no column 'right_elbow_z'"),
        ("t,right_elbow_x,right_elbow_y,right_elbow_z\n0,1,2,3\n0,1,2,3\n", "do not rise"),
        ("t,right_elbow_x,right_elbow_y,right_elbow_z\n0,1,2,3\n1,1,2,3\n", "too short"),
        ("t,right_elbow_x,right_elbow_y,right_elbow_z\n0,1,2,3\n9,1,,3\n", "line 3"),
        ("t,right_elbow_x,right_elbow_y,right_elbow_z\n0,1,2,3\n9,2,3,4\n", "at least 10 rows a second"),
        (  # filled up evenly, a few rows would be a million, and a few more would be more than any memory holds
            "t,right_elbow_x,right_elbow_y,right_elbow_z\n0,1,2,3\n0.00001,1,2,4\n0.00002,2,2,4\n10,1,2,3\n",
            "too uneven",
        ),
    ],
)
def test_a_body_file_that_cannot_be_used_is_one_sentence(tmp_path, content, words):
    file = tmp_path / "body.csv"
    if content is not None:
        file.write_text(content)
    with pytest.raises(HardwareError, match=words) as refused:
        RecordedBody(file)
    assert str(file) in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_real_persons_movement_is_a_body():
    if not UPPER_BODY.exists():
        pytest.skip("The recording of a real upper body is not here.")
    body = RecordedBody(UPPER_BODY)
    assert body.duration > 90
    postures = live(lambda: body.step(DT, VIEW), body.duration)
    assert (np.ptp(postures, axis=0) > 0.5).all()
    assert np.abs(postures).max() < 1.5
    assert np.abs(np.diff(postures, axis=0)).max() / DT < 12
