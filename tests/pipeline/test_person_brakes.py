import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.calibration.vocabulary import Binding, DriveParameters, Gesture
from app.geometry import STANDSTILL, Twist
from app.pipeline.person_brakes import Brakes, missing_brake
from building import make_parameters, make_profile

FASTER, SLOWER, LEFT, RIGHT = range(4)  # the order of the paper's joints in the test profile
FORWARD, BACK, TURN_LEFT, TURN_RIGHT = Twist(0.3, 0.0), Twist(-0.3, 0.0), Twist(0.0, 0.3), Twist(0.0, -0.3)
KEEPS = {"mode_u1": "acceleration", "mode_u2": "acceleration"}


def bad(*indices, count=4):
    return [i in indices for i in range(count)]


def brakes(stop=False, **changes):
    """Return the brakes of the paper's vocabulary, with its stop gesture or without."""
    parameters = make_parameters().model_copy(update={**KEEPS, **changes})
    kept = tuple(binding for binding in parameters.bindings if stop or binding.control != "stop")
    return Brakes(parameters.model_copy(update={"bindings": changes.get("bindings", kept)}))


@pytest.mark.parametrize(
    ("twist", "brake"), [(FORWARD, SLOWER), (BACK, FASTER), (TURN_LEFT, RIGHT), (TURN_RIGHT, LEFT)]
)
def test_each_direction_has_its_own_brake(twist, brake):
    for gesture in range(4):
        assert brakes().suffice(twist, bad(gesture)) == (gesture != brake)
    assert brakes().suffice(twist, bad(*{0, 1, 2, 3} - {brake}))


def test_both_axes_must_be_stoppable():
    twist = Twist(0.3, -0.3)
    assert brakes().suffice(twist, bad(FASTER, RIGHT))
    assert not brakes().suffice(twist, bad(LEFT))
    assert not brakes().suffice(twist, bad(SLOWER))


@pytest.mark.parametrize("twist", [FORWARD, BACK, STANDSTILL])
def test_an_axis_that_slows_by_itself_needs_no_brake(twist):
    velocity = brakes(mode_u1="velocity", mode_u2="velocity")
    assert velocity.suffice(twist, bad(0, 1, 2, 3))
    assert velocity.are_complete
    assert not velocity.are_needed(Twist(0.3, 0.3))


@pytest.mark.parametrize(("axis", "twist"), [("mode_u1", FORWARD), ("mode_u2", TURN_LEFT)])
def test_each_axis_has_a_mode_of_its_own(axis, twist):
    one = brakes(**{axis: "velocity"})
    assert one.suffice(twist, bad(0, 1, 2, 3))
    assert not one.suffice(Twist(0.3, 0.3), bad(0, 1, 2, 3))


@pytest.mark.parametrize("twist", [FORWARD, BACK, TURN_LEFT, TURN_RIGHT])
def test_a_whole_stop_gesture_stops_everything_and_half_of_one_nothing(twist):
    bindings = (
        Binding(control="u1+", gestures=("right_elbow",)),
        Binding(control="u2+", gestures=("right_shoulder",)),
        Binding(control="stop", gestures=("left_elbow", "left_shoulder")),
    )
    with_stop = brakes(bindings=bindings)
    assert with_stop.suffice(twist, bad(FASTER, LEFT)) is True
    assert with_stop.are_complete
    if twist in (FORWARD, TURN_LEFT):
        assert not with_stop.suffice(twist, bad(SLOWER))
        assert not with_stop.suffice(twist, bad(RIGHT))


def test_one_of_two_stop_gestures_is_enough():
    bindings = (
        Binding(control="u1+", gestures=("right_elbow",)),
        Binding(control="stop", gestures=("left_elbow",)),
        Binding(control="stop", gestures=("left_shoulder",)),
        Binding(control="stop", gestures=()),
    )
    assert brakes(bindings=bindings).suffice(FORWARD, bad(SLOWER))
    assert not brakes(bindings=bindings).suffice(FORWARD, bad(SLOWER, RIGHT))


@pytest.mark.parametrize(("broken", "suffices"), [((), True), ((0,), False), ((1,), False), ((0, 1), True)])
def test_at_rest_what_can_begin_must_be_stoppable(broken, suffices):
    assert brakes().suffice(STANDSTILL, bad(*broken)) == suffices


def test_an_axis_that_nothing_moves_needs_no_brake():
    bindings = tuple(Binding(control=control, gestures=(name,)) for control, name in ELBOWS)
    assert brakes(bindings=bindings).are_complete
    assert brakes(bindings=()).are_complete


ELBOWS = (("u1+", "right_elbow"), ("u1-", "left_elbow"))


def test_a_gesture_bound_to_both_directions_brakes_by_the_sum_of_its_gains():
    def gains(forward, back):
        return brakes(
            bindings=(
                Binding(control="u1+", gestures=("right_elbow", "left_elbow"), gain=forward),
                Binding(control="u1-", gestures=("left_elbow",), gain=back),
            )
        )

    assert gains(1.0, 2.0).suffice(FORWARD, bad())
    assert not gains(1.0, 1.0).suffice(FORWARD, bad())
    assert not gains(2.0, 1.0).suffice(FORWARD, bad())
    assert not gains(1.0, 1.0).suffice(BACK, bad(FASTER))
    assert gains(2.0, 1.0).suffice(BACK, bad(FASTER))


def pair(*features):
    """Return a set in which one joint drives forwards, and both directions of it together are the stop."""
    gestures = tuple(
        Gesture(name=name, joint="right_elbow", direction=direction, feature=feature, dead_zone=0.2, full=1.0)
        for name, direction, feature in zip(("on", "back"), (1, -1), features, strict=True)
    )
    bindings = (Binding(control="u1+", gestures=("on",)), Binding(control="stop", gestures=("on", "back")))
    return DriveParameters(profile=make_profile(), gestures=gestures, bindings=bindings)


def test_a_stop_that_asks_one_joint_for_both_directions_is_none():
    assert not Brakes(pair("rate", "rate")).are_complete
    assert not Brakes(pair("displacement", "displacement")).are_complete
    assert Brakes(pair("rate", "displacement")).are_complete  # the movement, and the return


def test_what_goes_on_without_any_gesture_needs_brakes():
    assert brakes(stop=True).are_needed(FORWARD)
    assert brakes().are_needed(TURN_RIGHT)
    assert not brakes().are_needed(STANDSTILL)


WITH_STOP, WITHOUT = brakes(stop=True), brakes()


@given(
    st.sampled_from([FORWARD, BACK, TURN_LEFT, TURN_RIGHT, STANDSTILL]), st.lists(st.booleans(), min_size=4, max_size=4)
)
def test_a_stop_gesture_never_makes_it_worse(twist, broken):
    assert WITH_STOP.suffice(twist, broken) >= WITHOUT.suffice(twist, broken)


def test_a_set_without_a_brake_says_what_to_do():
    assert missing_brake(make_parameters()) is None
    assert str(missing_brake(pair("rate", "rate"))) == (
        "With these controls the chair would keep a speed that no movement can slow: on the Controls page, bind a "
        "movement to the opposite direction or to Stop, or choose “Follows the movement”."
    )


def gestures_of(*thresholds, direction=1, joint="right_elbow"):
    """Return gestures of one joint and direction that begin at these dead-zones, by the names a, b ..."""
    return tuple(
        Gesture(name=name, joint=joint, direction=direction, dead_zone=dead_zone, full=dead_zone + 0.5)
        for name, dead_zone in zip("ab", thresholds, strict=True)
    )


@pytest.mark.parametrize("gains", [(1.0, 1.0), (1.0, 2.0), (2.0, 0.5)])
def test_a_movement_that_both_speeds_up_and_slows_is_no_brake(gains):
    """A weak movement accelerates and only a strong one slows down, so it does not count as a brake."""
    bindings = tuple(
        Binding(control=control, gestures=(name,), gain=gain)
        for control, name, gain in zip(("u1+", "u1-"), "ab", gains, strict=True)
    )
    parameters = DriveParameters(profile=make_profile(), gestures=gestures_of(0.2, 1.0), bindings=bindings)
    assert not Brakes(parameters).suffice(FORWARD, [False, False])
    assert not Brakes(parameters).are_complete
    back = parameters.gestures[1].model_copy(update={"direction": -1})
    assert Brakes(parameters.model_copy(update={"gestures": (parameters.gestures[0], back)})).are_complete


@pytest.mark.parametrize(("gain", "is_brake"), [(0.0, False), (1e-9, False), (0.09, False), (0.1, True), (1.0, True)])
@pytest.mark.parametrize(("control", "other", "twist"), [("u1-", "u1+", FORWARD), ("u1+", "u1-", BACK)])
def test_a_gesture_with_hardly_any_gain_is_no_brake(gain, is_brake, control, other, twist):
    bindings = (
        Binding(control=other, gestures=("right_elbow",)),
        Binding(control=control, gestures=("left_elbow",), gain=gain),
    )
    assert brakes(bindings=bindings).suffice(twist, bad()) == is_brake
    assert brakes(bindings=bindings).are_complete == is_brake


def test_what_is_no_brake_for_its_little_gain_can_still_begin_a_motion():
    bindings = (Binding(control="u1+", gestures=("right_elbow",), gain=1e-9),)
    assert not brakes(bindings=bindings).are_complete


@pytest.mark.parametrize(
    ("feature", "dead_zone", "full", "is_brake"),
    [
        ("rate", 9.0, 11.0, True),
        ("rate", 9.0, 11.1, False),
        ("rate", 99.0, 100.0, False),
        ("displacement", 0.9, 1.1, True),
        ("displacement", 0.9, 1.11, False),
    ],
)
def test_a_gesture_that_no_body_reaches_brakes_nothing_and_is_no_part_of_a_stop(feature, dead_zone, full, is_brake):
    parameters = make_parameters()
    far = parameters.gestures[SLOWER].model_copy(update={"feature": feature, "dead_zone": dead_zone, "full": full})
    gestures = (parameters.gestures[FASTER], far, *parameters.gestures[2:])
    for bindings in (ELBOWS, (ELBOWS[0], ("stop", "left_elbow"))):
        bound = tuple(Binding(control=control, gestures=(name,)) for control, name in bindings)
        made = Brakes(parameters.model_copy(update={"gestures": gestures, "bindings": bound}))
        assert made.suffice(FORWARD, bad()) == is_brake
        assert made.are_complete == is_brake


def test_a_gesture_that_no_body_reaches_can_still_begin_a_motion():
    parameters = make_parameters()
    far = parameters.gestures[FASTER].model_copy(update={"dead_zone": 50.0, "full": 60.0})
    bound = (Binding(control="u1+", gestures=("right_elbow",)),)
    one_way = parameters.model_copy(update={"gestures": (far, *parameters.gestures[1:]), "bindings": bound})
    assert not Brakes(one_way).are_complete


def test_a_brake_that_drives_the_other_axis_further_is_none():
    """Each of the two brakes would drive the other axis further."""
    bindings = (
        Binding(control="u1+", gestures=("right_elbow", "right_shoulder")),
        Binding(control="u1-", gestures=("left_elbow",)),
        Binding(control="u2+", gestures=("right_elbow", "left_elbow")),
        Binding(control="u2-", gestures=("right_shoulder",)),
    )
    coupled = brakes(bindings=bindings)
    assert not coupled.are_complete
    assert coupled.suffice(FORWARD, bad())
    assert coupled.suffice(TURN_LEFT, bad())
    assert not coupled.suffice(Twist(0.3, 0.3), bad())
    assert coupled.suffice(Twist(0.3, -0.3), bad())
    assert brakes(bindings=bindings, mode_u2="velocity").are_complete
    assert brakes(bindings=(*bindings, Binding(control="stop", gestures=("left_shoulder",)))).are_complete


@pytest.mark.parametrize("turn", ["u2+", "u2-"])
def test_a_brake_may_turn_a_chair_that_goes_straight_when_the_turn_can_be_stopped(turn):
    bindings = (
        Binding(control="u1+", gestures=("right_elbow",)),
        Binding(control="u1-", gestures=("left_elbow",)),
        Binding(control=turn, gestures=("left_elbow", "left_shoulder")),
    )
    back = Binding(control="u2-" if turn == "u2+" else "u2+", gestures=("right_shoulder",))
    assert brakes(bindings=(*bindings, back)).suffice(FORWARD, bad())
    assert not brakes(bindings=(*bindings, back)).suffice(FORWARD, bad(SLOWER))


def held(bindings, joints=("right_elbow", "left_elbow", "right_shoulder"), **of_joint):
    """Return a set of held postures in velocity mode, one per joint; `of_joint` has another feature by joint."""
    gestures = tuple(
        Gesture(name=joint, joint=joint, feature=of_joint.get(joint, "displacement"), dead_zone=0.2, full=0.8)
        for joint in joints
    )
    bound = tuple(Binding(control=control, gestures=names, gain=gain) for control, names, gain in bindings)
    return DriveParameters(
        profile=make_profile(), gestures=gestures, bindings=bound, mode_u1="velocity", mode_u2="velocity"
    )


BOTH_ELBOWS = ("right_elbow", "left_elbow")
FORTH, BACKWARD = ("u1+", ("right_elbow",), 1.0), ("u1-", ("left_elbow",), 1.0)


@pytest.mark.parametrize(
    ("bindings", "is_stoppable"),
    [
        ([FORTH], False),
        ([FORTH, BACKWARD], False),  # held against each other: nothing ends that
        ([FORTH, ("stop", ("right_shoulder",), 1.0)], True),
        ([FORTH, ("stop", ("right_elbow",), 1.0)], False),
        ([FORTH, ("stop", ("right_elbow", "right_shoulder"), 1.0)], False),  # stuck below half, nothing outweighs it
        ([FORTH, BACKWARD, ("stop", BOTH_ELBOWS, 1.0)], True),
        ([FORTH, ("u1-", ("left_elbow",), 0.51), ("stop", ("right_elbow", "right_shoulder"), 1.0)], True),
        ([FORTH, ("u1-", ("left_elbow",), 0.5), ("stop", ("right_elbow", "right_shoulder"), 1.0)], False),
        ([FORTH, BACKWARD, ("u2+", ("left_elbow",), 1.0), ("stop", BOTH_ELBOWS, 1.0)], False),  # it turns as it slows
        ([("u1+", ("right_elbow",), 0.0)], True),  # it drives nothing
        ([FORTH, BACKWARD, ("stop", ("right_elbow",), 1.0)], False),  # stuck below half there is no stop
        ([BACKWARD, ("u1+", ("right_elbow",), 0.51), ("stop", ("left_elbow", "right_shoulder"), 1.0)], True),
        ([BACKWARD, ("u1+", ("right_elbow",), 0.5), ("stop", ("left_elbow", "right_shoulder"), 1.0)], False),
        (
            [
                ("u1+", ("right_elbow",), 0.5),
                ("u1-", ("left_elbow",), 0.3),
                ("stop", ("right_elbow", "right_shoulder"), 1.0),
            ],
            True,
        ),
        (
            [
                ("u2+", ("right_elbow",), 1.0),
                ("u2-", ("left_elbow",), 1.0),
                ("stop", ("right_elbow", "right_shoulder"), 1.0),
            ],
            True,
        ),
    ],
)
def test_a_held_posture_needs_a_stop_that_works_while_its_sensors_are_stuck(bindings, is_stoppable):
    assert (missing_brake(held(bindings)) is None) == is_stoppable


def test_a_stop_may_need_every_gesture_that_there_is():
    assert missing_brake(held([FORTH, BACKWARD, ("stop", BOTH_ELBOWS, 1.0)], joints=BOTH_ELBOWS)) is None


def test_a_movement_whose_sensors_are_stuck_drives_nothing():
    assert missing_brake(held([FORTH], right_elbow="rate")) is None


def test_a_held_posture_without_a_stop_says_what_to_do():
    assert str(missing_brake(held([FORTH]))) == (
        "With these controls a sensor that sticks while a posture is held could drive the chair on, and no movement "
        "could stop it: on the Controls page, bind movements of other joints to Stop, or choose “Moving” in place of "
        "“Holding”."
    )
