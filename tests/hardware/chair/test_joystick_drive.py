"""A guided drive: what is driven, what ends it, and which document comes of it, whatever is typed or measured."""

import json
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.geometry import Twist
from app.hardware.chair.chair_document import table_of
from app.hardware.chair.joystick_drive import (
    AGAIN,
    CENTRE,
    DONE,
    LONGEST,
    QUIT,
    AxisRows,
    Deflection,
    DrivePhase,
    GuidedDrive,
    typed_speed,
)
from app.hardware.chair.readings import NO_READINGS, ChairReadings

STEP = 0.05  # s
MOST = Twist(0.5, 0.8)


class Session:
    """A guided drive on a simulated time, and what was driven."""

    def __init__(self, most=MOST):
        self.drive = GuidedDrive(most)
        self.t = 10.0
        self.deflection = CENTRE
        self.told = []

    def step(self, readings=NO_READINGS, obstacle="", dt=STEP):
        self.t += dt
        self.deflection = self.drive.step(self.t, readings, obstacle)
        self.told += self.drive.told
        self.drive.told.clear()
        return self.deflection

    def run(self, seconds, readings=NO_READINGS):
        return [self.step(readings) for _ in range(round(seconds / STEP))]

    def begin(self):
        self.step()
        self.drive.hear("\n")
        self.run(1.5)
        assert self.drive.phase is DrivePhase.DRIVES

    def typed(self, line):
        """Drive, end the drive by a key, and type what was measured."""
        self.begin()
        driven = self.deflection
        self.drive.hear("x")
        self.drive.hear(line)
        self.step()
        return driven


def test_a_drive_rises_lasts_ten_seconds_at_most_and_lets_go():
    session = Session()
    session.step()
    session.drive.hear("\n")
    driven = session.run(12.0)
    moving = [each for each in driven if each.is_driven]
    assert driven[0] == CENTRE, "the centre comes first"
    assert moving[0].ahead == 0.0
    assert moving[-1] == Deflection(True, 5.0, 0.0)
    assert [each.ahead for each in moving] == sorted(each.ahead for each in moving)
    assert len(moving) * STEP <= LONGEST + 2 * STEP
    assert driven[-1] == CENTRE
    assert session.drive.phase is DrivePhase.COUNTS


def test_all_three_directions_by_tape_measure_make_a_document_that_its_reader_takes(tmp_path):
    session = Session()
    assert session.typed("0") == Deflection(True, 5.0, 0.0)
    assert session.typed("1,0 10").ahead == 10.0
    assert session.typed("2 10").ahead == 20.0
    assert session.typed("3 10").ahead == 30.0
    session.drive.hear(DONE)
    assert session.typed("0").ahead == -5.0
    assert session.typed("2.5 5").ahead == -10.0, "as fast as it may be: no further drive"
    assert session.typed("90 2") == Deflection(True, 0.0, 5.0)
    assert session.drive.phase is DrivePhase.ENDED
    document = session.drive.document
    assert document == {
        "version": 1,
        "dead_band": 0,
        "forward": [[10, 0.1], [20, 0.2], [30, 0.3]],
        "back": [[10, 0.5]],
        "turn": [[5, pytest.approx(math.pi / 4)]],
    }
    table = table_of(json.dumps(document), tmp_path)
    assert table.deflection(Twist(0.3, 0.0))[0] == 30.0


def test_what_the_chair_measures_is_taken_with_its_lag():
    session = Session()
    for _ in range(2):
        session.step()
        session.drive.hear("\n")
        session.run(1.0)
        session.run(11.0, ChairReadings(0.6, 0.0) if session.drive._percent == 10 else ChairReadings(0.0, 0.0))
    assert session.drive._axes["forward"].rows == [(10, pytest.approx(0.6))]
    (lag,) = session.drive._lags
    assert lag == pytest.approx(0.55 - 0.25, abs=0.06)
    assert "The chair measured 0.600 m/s." in " ".join(session.told)
    assert session.drive._axis == "back"


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"obstacle": "The stop switch."}, "The stop switch."),
        ({"dt": 0.2}, "held up"),
        ({"dt": -1.0}, "held up"),
        ({"readings": ChairReadings(-0.1, 0.0)}, "the other way"),
        ({"readings": ChairReadings(0.8, 0.0)}, "faster"),
    ],
)
def test_what_ends_a_drive_lets_go_at_once_and_the_same_drive_is_next(change, why):
    session = Session()
    session.begin()
    assert session.step(**change) == CENTRE
    assert session.drive.phase is DrivePhase.ASKS
    assert why in " ".join(session.told)
    assert "FORWARDS, 5 percent" in session.told[-1]


def test_an_end_in_the_midst_of_a_step_is_not_forgotten():
    session = Session()
    session.begin()
    session.drive.end()
    session.drive.phase = DrivePhase.DRIVES  # as a step sets it that the signal interrupted
    assert session.step() == CENTRE
    assert session.drive.phase is DrivePhase.ENDED


def test_nothing_begins_while_the_chair_cannot_be_driven_or_by_a_wrong_word():
    session = Session()
    session.drive.hear("\n")
    assert session.drive.phase is DrivePhase.ASKS, "nothing is known of the output yet"
    session.step(obstacle="It is switched off.")
    for line in ("\n", "go", DONE):
        session.drive.hear(line)
        assert session.drive.phase is DrivePhase.ASKS
    assert "switched off" in session.drive.told[0]
    session.step()
    session.drive.hear("\n")
    session.drive.hear("x")
    assert session.drive.phase is DrivePhase.ASKS, "a key before it moves"
    session.drive.hear(QUIT)
    assert session.drive.phase is DrivePhase.ENDED
    assert session.drive.document is None


def test_a_speed_that_does_not_rise_is_driven_again_and_a_chair_that_never_moves_ends_all():
    session = Session()
    session.typed("1 10")
    for line in ("1 10", "0", "again"):
        assert session.typed(line).ahead == 15.0
    standing = Session()
    for percent in range(5, 55, 5):
        assert standing.typed("0").ahead == percent
    assert standing.drive.phase is DrivePhase.ENDED
    assert standing.drive.document is None


def test_stop_ends_a_drive_and_the_wait_before_it_and_begins_none():
    session = Session()
    session.step()
    session.drive.stop()
    assert (session.drive.phase, session.drive.told) == (DrivePhase.ASKS, [])
    session.begin()
    session.drive.stop()
    assert session.step() == CENTRE
    assert session.drive.phase is DrivePhase.ASKS
    session.drive.hear("\n")
    session.drive.stop()
    assert set(session.run(2.0)) == {CENTRE}
    session.begin()
    session.drive.hear("x")
    session.drive.stop()
    assert session.drive.phase is DrivePhase.COUNTS, "what was measured can still be typed"


def test_the_next_drive_is_not_expected_to_be_too_fast():
    rows = AxisRows(0.5, stood=5)
    for percent, speed, following in ((10, 0.1, 20), (20, 0.28, 30), (30, 0.36, 40), (40, 0.44, None)):
        assert rows.add(percent, speed) == ""
        assert rows.next_percent() == following


@pytest.mark.parametrize(
    "line", ["", "x", "1", "nan 1", "inf 1", "1 0", "-1 1", "1e3 1", "1_0 1", "1 2 3", "0 0", "99 1"]
)
def test_what_is_no_measurement_is_none(line):
    assert typed_speed(line, is_turn=False) is None


WORDS = ("\n", "\n", "\n", "0", "1 10", "2 10", "3 5", "90 3", AGAIN, DONE, QUIT, "x")
LINES = st.sampled_from(WORDS) | st.text(max_size=8)
SPEEDS = st.floats(allow_nan=True, allow_infinity=True)
STEPS = st.tuples(st.sampled_from([0.01, 0.09, 0.1, 1.0, -0.1]), SPEEDS, SPEEDS, st.sampled_from(["", "", "", "Stop."]))


@given(st.lists(LINES | STEPS | st.just((0.09, math.nan, math.nan, "")), max_size=150))
def test_whatever_is_typed_or_measured_no_drive_exceeds_its_percent_or_its_time(tmp_path_factory, events):
    drive, t, begun = GuidedDrive(MOST), 0.0, None
    for event in events:
        if isinstance(event, str):
            drive.hear(event)
            continue
        dt, v, omega, obstacle = event
        t += dt
        is_driven, ahead, right = drive.step(t, ChairReadings(v, omega), obstacle)
        assert max(abs(ahead), abs(right)) <= drive._percent <= 100
        assert 0.0 in (ahead, right)
        assert is_driven is (drive.phase is DrivePhase.DRIVES)
        assert is_driven or (ahead, right) == (0.0, 0.0)
        assert not (is_driven and obstacle)
        begun = (t if begun is None else begun) if is_driven else None
        assert begun is None or t - begun <= LONGEST
    drive.end()
    assert drive.step(t + 0.01, NO_READINGS) == CENTRE
    if drive.document is not None:
        table_of(json.dumps(drive.document), tmp_path_factory.getbasetemp())
