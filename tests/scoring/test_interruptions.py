"""Interruptions: waiting is no driving, and each kind has a figure of its own."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.faults import PEOPLE_STOPS, Fault, State
from app.scoring.interruptions import interruption_text, interruptions, reason_to_ask
from app.scoring.task_measures import task_measures
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.movers import Mover
from app.world.tasks import FollowLeader, Turn

RATE = 50.0
PATH = PrescribedPath(name="main", title="Main", instruction="Go.", points=((0.0, 0.0), (10.0, 0.0)), goal_radius=0.5)
PLAN = FloorPlan(name="p", title="P", walls=(), paths=(PATH,))
WAITS = {  # states and faults while the chair waits, and the kind
    "machine": (State.FAULT, Fault.SHIRT_SILENT),
    "pause": (State.DISARMED, Fault.SCREEN_SLOW),
    "person": (State.FAULT, Fault.STOP_TABLET),
}
COUNTS = {
    "machine": ("halts", "halt_time"),
    "pause": ("pauses", "pause_time"),
    "person": ("person_stops", "person_stop_time"),
}


def speeds(duration=20.0):
    """Return (n,) m/s: speed up, a wavy middle, and on past the goal."""
    t = np.arange(round(duration * RATE)) / RATE
    return np.minimum(t / 1.0, 1.0) * (0.6 + 0.1 * np.sin(2 * np.pi * 0.3 * t))


def driven(v, waits=(), y=0.0):
    """Return the columns of a drive that is interrupted at the rows `waits`: (row, s, kind).

    The chair comes to standstill within 0.2 s and, after the wait, starts again at 1 m/s2.
    """
    state = np.full(len(v), State.ARMED)
    fault = np.full(len(v), Fault.NONE)
    for row, duration, kind in sorted(waits, reverse=True):
        run_out = v[row] * np.linspace(1.0, 0.0, 11)[1:]
        start = np.arange(1, round(RATE * v[row])) / RATE
        wait, check = round(duration * RATE), round(0.5 * RATE)
        between = np.concatenate((run_out, np.zeros(wait + check - len(run_out)), start))
        halted = np.concatenate((np.full(wait, WAITS[kind][0]), np.full(check, State.CHECKING), np.full(len(start), 2)))
        why = np.concatenate((np.full(wait, WAITS[kind][1]), np.zeros(check + len(start))))
        v, state, fault = (
            np.concatenate((whole[:row], part, whole[row:]))
            for whole, part in ((v, between), (state, halted), (fault, why))
        )
    n = len(v)
    x = np.concatenate(([0.0], np.cumsum(v[1:]) / RATE))
    zeros = np.zeros(n)
    return {
        **dict.fromkeys(("theta", "in_contact", "contacts", "u2"), zeros),
        "t": np.arange(n) / RATE,
        "x": x,
        "y": np.full(n, y),
        "v": v,
        "scene_t": np.arange(n) / RATE,
        "u1": np.where(state == State.ARMED, 0.5, 0.0),
        "state": state,
        "fault": fault,
    }


def measured(waits=(), plan=PLAN, v=None):
    return task_measures(plan, plan.paths[0], driven(speeds() if v is None else v, waits))


@pytest.mark.parametrize("kind", WAITS)
@pytest.mark.parametrize("wait", [1.0, 15.0, 200.0])
def test_a_wait_is_no_driving_and_a_figure_of_its_own(kind, wait):
    plain, halted = measured(), measured([(400, wait, kind)])
    count, duration = COUNTS[kind]
    assert (halted[count], halted[duration]) == (1, pytest.approx(wait + 0.5, abs=0.03))
    assert plain[count] == plain[duration] == 0
    assert halted["time"] == pytest.approx(plain["time"], abs=0.7)  # starting again takes the chair some time
    assert halted["mean_speed"] == pytest.approx(plain["mean_speed"], rel=0.05)
    assert halted["stops"] == plain["stops"] == 0
    assert halted["dist"] == pytest.approx(plain["dist"], abs=0.02)
    assert halted["reached"]


def test_how_long_a_halt_lasts_changes_no_measure_of_driving():
    short, long = (measured([(400, wait, "machine")]) for wait in (1.0, 100.0))
    for name in set(short) - {"halt_time", "interrupted"}:
        assert long[name] == pytest.approx(short[name], abs=1e-9), name


def test_smoothness_sees_the_chair_stop_and_start_and_not_the_wait():
    plain, halted = measured(), measured([(400, 15.0, "machine")])
    assert plain["sparc"] - 0.75 < halted["sparc"] < plain["sparc"]
    standing = {**driven(speeds(), [(400, 15.0, "machine")])}
    del standing["state"]
    assert task_measures(PLAN, PATH, standing)["sparc"] < halted["sparc"]


def test_a_stop_of_the_person_is_a_stop_also_beside_a_halt():
    v = speeds()
    v[600:700] = 0.0
    assert measured(v=v)["stops"] == 1
    assert measured([(400, 15.0, "machine")], v=v)["stops"] == 1


def test_nobody_moves_for_a_while_after_continue_and_that_is_no_stop():
    v = speeds()
    rows = driven(v, [(400, 5.0, "machine")])
    begins = int(np.flatnonzero(rows["state"] == State.CHECKING)[-1]) + 1
    standing = {name: np.insert(column, begins, np.repeat(column[begins - 1], 100)) for name, column in rows.items()}
    standing["t"] = np.arange(len(standing["x"])) / RATE
    standing["state"][begins : begins + 100] = State.ARMED
    measures = task_measures(PLAN, PATH, standing)
    assert measures["stops"] == 0
    assert measures["time"] == pytest.approx(task_measures(PLAN, PATH, rows)["time"] + 2.0)  # it was permitted to move
    assert measures["sparc"] == pytest.approx(task_measures(PLAN, PATH, rows)["sparc"], abs=0.02)


@pytest.mark.parametrize("fault", sorted(set(Fault) - {Fault.NONE, Fault.NOT_NEUTRAL}))
def test_what_people_stop_on_purpose_is_no_halt_by_the_machine(fault):
    state = [State.ARMED, State.FAULT, State.FAULT, State.DISARMED, State.CHECKING, State.ARMED]
    found = interruptions(np.arange(6.0), state, [0, fault, fault, 0, 0, 0])
    expected = "person" if fault in PEOPLE_STOPS else "machine"
    assert found == [(expected, 0.0, 4.0)]
    assert {Fault.STOP_TABLET, Fault.STOP_GESTURE, Fault.STOP_KEY, Fault.STOP_CHAIR} == PEOPLE_STOPS


def test_a_check_for_rest_that_fails_belongs_to_the_halt_before_it():
    state = [State.ARMED, State.FAULT, State.CHECKING, State.FAULT, State.CHECKING, State.ARMED]
    found = interruptions(np.arange(6.0), state, [0, Fault.STOP_TABLET, 0, Fault.NOT_NEUTRAL, 0, 0])
    assert found == [("person", 0.0, 4.0)]


def test_a_stop_during_a_pause_is_told_apart_from_it():
    state = [State.ARMED, State.DISARMED, State.DISARMED, State.FAULT, State.CHECKING, State.ARMED]
    found = interruptions(np.arange(6.0), state, [0, Fault.SCREEN_LOST, Fault.SCREEN_LOST, Fault.STOP_KEY, 0, 0])
    assert found == [("pause", 0.0, 2.0), ("person", 0.0, 2.0)]


def test_the_end_of_a_trial_is_no_interruption_and_no_driving():
    rows = driven(speeds(10.0))
    more = {name: np.concatenate((column, np.repeat(column[-1], 500))) for name, column in rows.items()}
    more["t"], more["state"][-500:] = np.arange(1000) / RATE, State.DISARMED
    ended, plain = task_measures(PLAN, PATH, more), task_measures(PLAN, PATH, rows)
    assert ended["time"] == plain["time"] == pytest.approx(9.98)
    assert ended["halts"] == ended["pauses"] == ended["person_stops"] == 0
    more["state"][-500:], more["fault"][-500:] = State.FAULT, Fault.SHIRT_SILENT  # halted, and ended so
    assert task_measures(PLAN, PATH, more)["halt_time"] == pytest.approx(10.0)


def test_a_halt_in_the_goal_is_after_the_trial():
    v = np.concatenate((speeds(), np.zeros(50)))
    reached = int(np.flatnonzero(np.cumsum(v) / RATE > 10.2)[0])
    assert measured([(reached, 20.0, "machine")], v=v)["halts"] == 0


@pytest.mark.parametrize(
    ("waits", "is_interrupted"),
    [
        ([], False),
        ([(400, 1.0, "machine")], False),
        ([(400, 3.0, "machine")], True),
        ([(400, 3.0, "pause")], True),
        ([(400, 60.0, "person"), (500, 60.0, "person"), (600, 60.0, "person")], False),
        ([(400, 0.5, "machine"), (600, 0.5, "machine")], True),
        ([(400, 0.5, "machine"), (600, 0.4, "pause")], True),
        ([(400, 0.5, "machine"), (600, 9.0, "person")], False),
    ],
)
def test_more_than_one_halt_or_a_tenth_of_the_time_asks_a_person(waits, is_interrupted):
    assert measured(waits)["interrupted"] is is_interrupted


@settings(max_examples=40, deadline=None)
@given(
    st.lists(
        st.tuples(st.sampled_from([150, 300, 450, 600]), st.floats(0.5, 20.0), st.sampled_from([*WAITS])),
        max_size=4,
        unique_by=lambda wait: wait[0],
    )
)
def test_interruptions_and_driving_are_all_of_the_time(waits):
    rows = driven(np.minimum(speeds(), 0.3), waits)
    measures = task_measures(PLAN, PATH, rows)
    assert not measures["reached"]
    lost = sum(measures[COUNTS[kind][1]] for kind in WAITS)
    assert measures["time"] + lost == pytest.approx(rows["t"][-1], abs=0.03 * len(waits) + 1e-6)
    for kind, (count, _) in COUNTS.items():
        assert measures[count] == sum(wait[2] == kind for wait in waits)


@pytest.mark.parametrize("kind", ["follow", "turn"])
def test_other_tasks_leave_the_wait_out_too(kind):
    if kind == "turn":
        path = PATH.model_copy(update={"task": Turn(kind="turn", direction="left")})
        plan = FloorPlan(name="p", title="P", walls=(), paths=(path,))
    else:
        guide = Mover(name="guide", kind="person", points=((1.0, 0.0), (11.0, 0.0)), pace=((0.0, 0.5),))
        path = PATH.model_copy(update={"task": FollowLeader(kind="follow", leader="guide", distance=1.0)})
        plan = FloorPlan(name="p", title="P", walls=(), paths=(path,), movers=(guide,))
    v = np.minimum(speeds(8.0), 0.5)
    plain, halted = (task_measures(plan, path, driven(v, waits)) for waits in ([], [(200, 60.0, "machine")]))
    assert halted["time"] == pytest.approx(plain["time"], abs=0.7)
    assert halted["halt_time"] == pytest.approx(60.5, abs=0.03)


def test_interruptions_in_words():
    measures = {"halts": 3, "halt_time": 14.2, "pauses": 1, "pause_time": 2.6}
    measures |= {"person_stops": 0, "person_stop_time": 0.0}
    assert str(interruption_text(measures)) == "halted 3 times, 14 s; paused once, 3 s"
    assert interruption_text(None) is interruption_text({"time": 3.0}) is None
    assert reason_to_ask(measures) is None
    assert "halted 3 times, 14 s; paused once, 3 s" in str(reason_to_ask({**measures, "interrupted": True}))
