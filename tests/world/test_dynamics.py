"""The motion of a chair: the unicycle, and the wheelchair with lags, castors and slip."""

import math
from dataclasses import replace

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from app.geometry import STANDSTILL, Pose, Twist
from app.world import kinematics
from app.world.dynamics import BOUNDS, Motion, Wheelchair, step

ORIGIN = Motion(Pose(0.0, 0.0, 0.0))
CHAIR = Wheelchair()
IDEAL = Wheelchair(speed_lag=0.0, turn_lag=0.0, castor_push=0.0, turn_slip=0.0, speed_slip=0.0)

SPEEDS = st.floats(-2.0, 2.0)
TURNS = st.floats(-3.0, 3.0)
ANGLES = st.floats(-math.pi, math.pi)
TWISTS = st.builds(Twist, SPEEDS, TURNS)
MOTIONS = st.builds(Motion, st.builds(Pose, SPEEDS, SPEEDS, ANGLES), SPEEDS, TURNS, ANGLES, ANGLES)
CHAIRS = st.builds(Wheelchair, **{name: st.floats(low, high) for name, (low, high) in BOUNDS.items()})


def driven(motion, twist, seconds, dt=0.01, chair=CHAIR):
    """Return the motions of so many seconds, the first included."""
    motions = [motion]
    for _ in range(round(seconds / dt)):
        motions.append(step(motions[-1], twist, dt, chair))
    return motions


@given(MOTIONS, st.lists(TWISTS, min_size=1, max_size=20), st.floats(1e-4, 0.1))
def test_without_any_effect_the_model_is_exactly_the_unicycle(motion, twists, dt):
    pose = motion.pose
    for twist in twists:
        motion = step(motion, twist, dt, IDEAL)
        pose = Pose(*kinematics.unicycle(*pose, *twist, dt))
        assert (motion.pose, motion.v, motion.omega) == (pose, *twist)


@given(MOTIONS, CHAIRS)
def test_without_a_command_the_chair_comes_to_rest_and_stays(motion, chair):
    longest = max(chair.speed_lag, chair.turn_lag)
    last = driven(motion, STANDSTILL, 2.0 + 12.0 * longest, 0.02, chair)[-1]
    assert (last.v, last.omega) == (0.0, 0.0)
    assert step(last, STANDSTILL, 0.02, chair) == last


def test_at_rest_nothing_turns_its_castors():
    motion = Motion(Pose(1.0, 2.0, 3.0), left=1.0, right=-2.0)
    assert driven(motion, STANDSTILL, 10.0)[-1] == motion


@given(
    st.lists(st.builds(Twist, st.floats(-1e3, 1e3), st.floats(-1e3, 1e3)), max_size=60), CHAIRS, st.floats(1e-3, 0.1)
)
def test_no_command_makes_the_chair_much_faster_than_commanded(twists, chair, dt):
    motion, fastest = ORIGIN, 0.0
    for twist in twists:
        motion = step(motion, twist, dt, chair)
        fastest = max(fastest, abs(twist.v), abs(twist.omega))
        assert all(map(math.isfinite, (*motion.pose, *motion[1:])))
        assert max(abs(motion.v), abs(motion.omega)) <= 6.0 * fastest
        assert max(map(abs, (motion.pose.theta, motion.left, motion.right))) <= math.pi


@given(MOTIONS, SPEEDS, CHAIRS)
def test_driving_straight_with_castors_in_line_goes_straight(motion, v, chair):
    ahead = math.pi if v < 0 else 0.0
    start = Motion(motion.pose, 0.0, 0.0, ahead, ahead)
    for moved in driven(start, Twist(v, 0.0), 1.0, chair=chair):
        assert abs(moved.omega) < 1e-12
        assert moved.pose.theta == pytest.approx(start.pose.theta, abs=1e-12)
    assert moved.v == pytest.approx(v * (1.0 - math.exp(-1.0 / chair.speed_lag)) if chair.speed_lag else v, abs=1e-9)


@given(st.lists(TWISTS, min_size=1, max_size=6), CHAIRS)
def test_a_mirrored_command_drives_the_mirrored_way(twists, chair):
    # Not from a perfect reversal: there each castor must choose a side.
    left = right = Motion(ORIGIN.pose, 0.5, 0.1)
    right = right._replace(omega=-0.1)
    for twist in twists:
        for _ in range(20):
            left = step(left, twist, 0.01, chair)
            right = step(right, Twist(twist.v, -twist.omega), 0.01, chair)
    assert right.v == pytest.approx(left.v, abs=1e-6)
    assert right.omega == pytest.approx(-left.omega, abs=1e-6)
    assert (right.pose.x, right.pose.y) == pytest.approx((left.pose.x, -left.pose.y), abs=1e-6)


def test_it_is_63_percent_there_after_one_lag():
    chair = Wheelchair(castor_push=0.0, turn_slip=0.0, speed_slip=0.0)
    assert driven(ORIGIN, Twist(0.8, 0.0), chair.speed_lag, chair=chair)[-1].v == pytest.approx(0.8 * (1 - 1 / math.e))
    turned = driven(ORIGIN, Twist(0.0, 1.2), chair.turn_lag, chair=chair)[-1]
    assert turned.omega == pytest.approx(1.2 * (1 - 1 / math.e))


def test_a_step_of_1_ms_and_of_10_ms_lead_to_the_same_place():
    course = [(Twist(0.8, 0.0), 2.0), (Twist(0.5, 0.8), 2.0), (STANDSTILL, 1.0), (Twist(-0.3, 0.1), 3.0)]
    ends, ways = [], []
    for dt in (0.001, 0.01):
        motion, way = ORIGIN, 0.0
        for twist, seconds in course:
            motions = driven(motion, twist, seconds, dt)
            motion = motions[-1]
            way += sum(abs(moved.v) * dt for moved in motions)
        ends.append(motion)
        ways.append(way)
    fine, coarse = ends
    assert ways[1] == pytest.approx(ways[0], rel=0.005)
    assert math.dist(fine.pose[:2], coarse.pose[:2]) < 0.02
    assert coarse.pose.theta == pytest.approx(fine.pose.theta, abs=0.01)
    assert coarse[1:] == pytest.approx(fine[1:], abs=0.02)


def test_reversing_swings_the_castors_round_and_kicks_the_chair_aside_until_they_are():
    forwards = driven(ORIGIN, Twist(0.8, 0.0), 2.0)[-1]
    stands = driven(forwards, STANDSTILL, 2.0)[-1]
    assert (stands.left, stands.right) == (0.0, 0.0)
    backwards = driven(stands, Twist(-0.3, 0.0), 5.0)
    kick = max(abs(moved.omega) for moved in backwards)
    assert 0.02 < kick < 0.3  # felt, and no more than an eighth of a turn in a second
    last = backwards[-1]
    assert abs(last.omega) < 1e-3
    assert min(abs(last.left), abs(last.right)) > math.pi - 0.01
    assert 0.005 < abs(last.pose.theta) < 0.2  # off its direction by some degrees, for good
    swinging = [moved.v for moved in backwards if 1.0 < abs(moved.left) < 2.0]
    assert min(map(abs, swinging)) < 0.29  # and held back meanwhile


@pytest.mark.parametrize("side", [1, -1])
def test_from_turning_in_place_the_castors_push_on_to_the_side_that_it_turned_to(side):
    turning = driven(ORIGIN, Twist(0.0, side * 1.0), 3.0)[-1]
    assert min(side * turning.left, side * turning.right) > 0.8  # both across
    steady = Motion(ORIGIN.pose, 0.0, 0.0, turning.left, turning.right)
    ahead = driven(steady, Twist(0.5, 0.0), 4.0)
    assert max(abs(moved.omega) for moved in ahead) > 0.02
    assert abs(ahead[-1].omega) < 1e-3
    assert abs(ahead[-1].left) < 0.01
    in_line = driven(ORIGIN, Twist(0.5, 0.0), 4.0)[-1]
    assert ahead[-1].pose.theta * side > in_line.pose.theta


@given(TWISTS, CHAIRS)
def test_castors_that_keep_their_angle_do_not_push(twist, chair):
    steady = driven(ORIGIN, twist, 10.0 + 10 * max(chair.speed_lag, chair.turn_lag), 0.05, chair)[-1]
    after = step(steady, twist, 0.05, chair)
    assume(abs(after.left - steady.left) < 1e-9 and abs(after.right - steady.right) < 1e-9)
    free = step(steady, twist, 0.05, replace(chair, castor_push=0.0))
    assert after[1:3] == pytest.approx(free[1:3], abs=1e-6)


@settings(max_examples=60, deadline=None)
@given(st.floats(0.2, 1.5), st.floats(0.2, 2.5), st.booleans())
def test_slip_widens_a_curve_and_the_more_so_the_faster_it_is(v, omega, left):
    twist = Twist(v, omega if left else -omega)

    def radius(chair, of=twist):
        last = driven(ORIGIN, of, 6.0, chair=chair)[-1]
        return last.v / last.omega

    gripping = Wheelchair(turn_slip=0.0, speed_slip=0.0)
    assert radius(gripping) == pytest.approx(v / twist.omega, rel=1e-3)
    assert abs(radius(CHAIR)) > abs(radius(gripping))
    assert abs(radius(CHAIR)) / abs(radius(gripping)) < 1 / (1 - CHAIR.largest_slip)
    slower = Twist(v / 2, twist.omega / 2)
    assert abs(radius(CHAIR)) > abs(radius(CHAIR, slower))


@settings(max_examples=60, deadline=None)
@given(st.floats(-1.5, 1.5), st.floats(-2.5, 2.5), ANGLES, ANGLES)
def test_a_stop_takes_no_more_way_than_the_lag_explains(v, omega, left, right):
    motions = driven(Motion(ORIGIN.pose, v, omega, left, right), STANDSTILL, 5.0, 0.002)
    assert (motions[-1].v, motions[-1].omega) == (0.0, 0.0)
    way = sum(abs(moved.v) for moved in motions[1:]) * 0.002
    # Castors that are dragged round turn some of a turn into a way, and the reverse.
    assert way <= abs(v) * CHAIR.speed_lag + 0.15 * abs(omega) * CHAIR.turn_lag + 1e-3


@pytest.mark.parametrize("name", BOUNDS)
@pytest.mark.parametrize("side", [-1, 1])
def test_a_number_beyond_its_bounds_is_refused_by_name(name, side):
    low, high = BOUNDS[name]
    for bad in (math.nextafter(low, -1) if side < 0 else math.nextafter(high, 9), math.nan, side * math.inf):
        with pytest.raises(ValueError, match=name):
            Wheelchair(**{name: bad})
    assert getattr(Wheelchair(**{name: low if side < 0 else high}), name) in (low, high)
