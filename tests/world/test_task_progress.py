"""The progress along a line, and of each kind of task."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.geometry import Pose
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.path import Path
from app.world.progress import LineProgress, progress_of

LINE = ((0.0, 0.0), (4.0, 0.0))
PLACES = st.lists(st.tuples(st.floats(-1, 5), st.floats(-2, 2)), min_size=1, max_size=40)


def plan_with(points=LINE, task=None, movers=(), **changes):
    path = {"name": "main", "title": "Main", "points": points, "instruction": "Go.", **changes}
    if task is not None:
        path["task"] = task
    return FloorPlan(name="p", title="P", walls=(), paths=(PrescribedPath(**path),), movers=movers)


def begun(**changes):
    plan = plan_with(**changes)
    return progress_of(plan, plan.paths[0])


@given(PLACES)
def test_the_progress_on_a_path_is_that_along_its_line(places):
    task, plain = begun(), LineProgress(plan_with().paths[0].line, 0.5)
    for x, y in places:
        task.update(Pose(x, y, 1.0), 0.3, 1.0)
        plain.update(x, y)
        assert (task.s, task.cross_track, task.reached, task.covered) == (
            plain.s,
            plain.cross_track,
            plain.reached,
            plain.covered,
        )
    assert (task.stage, task.stages, task.length) == (0, 1, 4.0)


def drive(task, poses, v=0.3, dt=0.1):
    for number, pose in enumerate(poses):
        task.update(pose, v, number * dt)


def along(heading):
    return [Pose(0.1 * i, 0.0, heading) for i in range(41)]


def test_a_path_to_drive_backwards_is_done_backwards_only():
    plan = plan_with(task={"kind": "back"})
    assert plan.paths[0].start.theta == pytest.approx(math.pi)
    forwards, backwards = begun(task={"kind": "back"}), begun(task={"kind": "back"})
    drive(forwards, along(0.0))
    drive(backwards, along(math.pi))
    assert (forwards.reached, backwards.reached) == (False, True)


def turned(degrees, hold=2.0, task=None, at=(0.0, 0.0), v=0.0, step=3.0):
    """Turn on the spot from looking along x, then stand for `hold` seconds."""
    progress = begun(
        points=((0.0, 0.0), (0.0, 2.0)), start_heading=0.0, task=task or {"kind": "turn", "direction": "left"}
    )
    count = round(abs(degrees) / step)
    angles = [math.radians(math.copysign(step * i, degrees)) for i in range(count + 1)]
    angles += [angles[-1]] * round(hold / 0.1)
    drive(progress, [Pose(*at, math.remainder(angle, math.tau)) for angle in angles], v)
    return progress


def test_a_turn_is_done_after_standing_and_facing_the_mark():
    assert turned(90).reached
    assert turned(90).s == pytest.approx(math.pi / 2)
    assert turned(90).length == pytest.approx(math.pi / 2)
    assert not turned(90, hold=0.5).reached, "not long enough"
    assert not turned(75).reached, "not far enough"
    assert not turned(105).reached, "too far"
    assert turned(81).reached, "within the tolerance"
    assert not turned(90, v=0.2).reached, "it rolls"
    assert not turned(90, at=(0.6, 0.0)).reached, "not on the spot"
    assert turned(90, at=(0.3, 0.0)).cross_track == pytest.approx(0.3)


def test_a_turn_goes_the_asked_way_round():
    right = {"kind": "turn", "direction": "right"}
    assert turned(-270, task=right).reached
    assert turned(-270, task=right).length == pytest.approx(math.pi * 1.5)
    assert not turned(90, task=right).reached
    assert not turned(-270).reached
    assert turned(450).reached, "once more round, the asked way"


GUIDE = {"name": "guide", "kind": "person", "points": ((1.5, 0.0), (4.0, 0.0)), "pace": ((0.0, 0.5),)}


def test_a_leader_has_been_followed_when_both_have_arrived():
    task = {"kind": "follow", "leader": "guide"}
    early = begun(task=task, movers=(GUIDE,))
    drive(early, along(0.0)[:27], dt=0.1)  # at 2.6 m after 2.6 s, when the leader still goes
    assert not early.reached
    late = begun(task=task, movers=(GUIDE,))
    drive(late, along(0.0)[:27], dt=0.25)
    assert late.reached
    far = begun(task=task, movers=(GUIDE,))
    drive(far, along(0.0)[:19], dt=0.5)
    assert not far.reached, "the leader waits, but the chair is not there yet"


def test_an_unknown_leader_is_refused():
    with pytest.raises(ValueError, match="there is no mover 'nobody' to follow: use one of guide"):
        plan_with(task={"kind": "follow", "leader": "nobody"}, movers=(GUIDE,))


COURSE = {
    "kind": "course",
    "stages": (
        {"title": "Ahead", "instruction": "Go.", "points": ((0.0, 0.0), (4.0, 0.0))},
        {
            "title": "Left",
            "instruction": "Turn.",
            "points": ((4.0, 0.0), (4.0, 1.0)),
            "task": {"kind": "turn", "direction": "left"},
        },
        {"title": "Back", "instruction": "Back.", "points": ((4.0, 0.0), (4.0, -2.0)), "task": {"kind": "back"}},
    ),
}


def test_a_course_goes_from_stage_to_stage():
    course = begun(task=COURSE)
    assert (course.stage, course.stages, course.part.title) == (0, 3, "Ahead")
    seen = []
    poses = along(0.0)
    poses += [Pose(4.0, 0.0, math.radians(3 * i)) for i in range(31)] + [Pose(4.0, 0.0, math.pi / 2)] * 15
    poses += [Pose(4.0, -0.1 * i, math.pi / 2) for i in range(21)]
    for number, pose in enumerate(poses):
        course.update(pose, 0.0, number * 0.1)
        seen.append((course.stage, course.covered))
    assert course.reached
    assert [stage for stage, _ in seen] == sorted(stage for stage, _ in seen)
    assert {stage for stage, _ in seen} == {0, 1, 2}
    assert seen[-1][1] > 0.9


@given(
    st.lists(st.tuples(st.floats(-5, 5), st.floats(-5, 5), st.floats(-4, 4), st.floats(-1, 1)), max_size=60),
    st.sampled_from([None, {"kind": "back"}, {"kind": "turn", "direction": "right"}, COURSE]),
)
def test_what_was_reached_stays_reached_and_shares_are_shares(steps, task):
    progress = begun(task=task)
    reached, stage = False, 0
    for number, (x, y, theta, v) in enumerate(steps):
        progress.update(Pose(x, y, theta), v, number * 0.1)
        assert progress.reached or not reached
        assert progress.stage >= stage
        assert 0.0 <= progress.covered <= 1.0
        reached, stage = progress.reached, progress.stage


ROUND = [(0, 0), (10, 0), (10, 10), (0, 10), (0, 0)]


def follow_line(progress, line, spacing=0.1):
    path = Path(line)
    for number in range(int(path.length / spacing) + 1):
        progress.update(*path.point_at(number * spacing))
    progress.update(*path.points[-1])


def test_the_end_is_reached_after_the_path():
    progress = LineProgress(Path([(0, 0), (10, 0)]), 0.5)
    follow_line(progress, [(0, 1), (9, 1)])
    assert progress.s == pytest.approx(9)
    assert progress.cross_track == pytest.approx(1)
    assert not progress.reached
    follow_line(progress, [(9, 1), (9.6, 0)])
    assert progress.reached


def test_a_round_course_is_not_done_at_its_start():
    progress = LineProgress(Path(ROUND), 0.5)
    follow_line(progress, [(0, 0), (-1.5, 0), (0.3, 0)])  # back and forth at the start
    assert not progress.reached
    follow_line(progress, [(0.3, 0), *ROUND[1:]])
    assert progress.reached


def test_a_short_cut_to_the_end_does_not_reach_it():
    progress = LineProgress(Path([(0, 0), (10, 0), (10, 3), (0, 3)]), 0.5)
    follow_line(progress, [(0, 0), (0, 3)])
    assert not progress.reached


def test_a_chair_that_left_the_path_is_found_on_another_part_of_it():
    progress = LineProgress(Path(ROUND), 0.5)
    follow_line(progress, [(0, 0), (6, 0), (6, 5), (9, 5), (9, 9)])
    assert progress.s == pytest.approx(19, abs=1.1)
    assert abs(progress.cross_track) < 1.1


def test_waiting_covers_nothing():
    progress = LineProgress(Path(ROUND), 0.5)
    for _ in range(1000):
        progress.update(0, 0)
    assert progress.covered < 0.02
