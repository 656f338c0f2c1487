"""Each number that a trial or a two-minute test is given has an entry in the catalogue, and no other file a table."""

import re

import numpy as np

from app.faults import Fault, State
from app.scoring.interface_test.interface_measures import InterfaceMeasures
from app.scoring.measures import (
    CIRCUMSTANCES,
    EXPORTED,
    INTERRUPTIONS,
    REACHED,
    TEST_MEASURES,
    TRIAL_MEASURES,
)
from app.scoring.task_measures import task_measures
from app.scoring.verdict.leading_measures import LEADING, LEADING_OF_TESTS
from app.world.scene import bundled_places
from folders import ROOT

NO_MEASURES = {REACHED, "interrupted", "title", "kind", "parts"}
ORDINARY = {"dist", "e_diff", "time", "stops", "throughput"}  # words of other subjects, too
MAY_NAME = re.compile(
    r"app/scoring/([a-z_]+/)*[a-z]+_measures\.py|app/scoring/smoothness\.py|app/study/.+|app/world/cursor_task\.py"
)
SCORE = "app/cli/score.py"  # knows which measures say how well a path was followed
NEXT_TASK = "app/scoring/next_task.py"  # a trial with a contact did not go well


def a_trial(x: float, y: float) -> dict[str, np.ndarray]:
    """Return the rows of a trial that goes half a metre on from (x, y), m, with one halt."""
    n = 12
    t = np.arange(n) * 0.1
    columns = dict.fromkeys(("theta", "v", "in_contact", "contacts", "u1", "u2"), np.zeros(n))
    state = np.full(n, State.ARMED)
    state[4] = State.FAULT
    fault = np.where(state == State.FAULT, Fault.SHIRT_LOSSY, Fault.NONE)
    place = {"x": x + 0.05 * np.arange(n), "y": np.full(n, y)}
    return {**columns, **place, "t": t, "scene_t": t, "state": state, "fault": fault}


def test_each_number_of_a_trial_has_an_entry_and_each_entry_a_number() -> None:
    found: set[str] = set()
    for place in bundled_places().values():
        for path in place.plan.paths:
            measures = task_measures(place.plan, path, a_trial(*path.points[0]))
            for part in (measures, *measures.get("parts", ())):
                found |= part.keys()
    assert found - NO_MEASURES == {*TRIAL_MEASURES, *INTERRUPTIONS, *CIRCUMSTANCES}


def test_each_measure_of_a_two_minute_test_is_computed() -> None:
    assert TEST_MEASURES.keys() <= InterfaceMeasures.model_fields.keys()


def test_what_a_measure_names_is_in_the_catalogue() -> None:
    numbers = TRIAL_MEASURES | CIRCUMSTANCES
    assert {one.of for one in TRIAL_MEASURES.values()} <= {None, *numbers}
    assert {name for row in LEADING for names in row for name in names} <= numbers.keys()
    assert set(LEADING_OF_TESTS) < TEST_MEASURES.keys()
    assert EXPORTED.keys() == {*TRIAL_MEASURES, *INTERRUPTIONS}


def test_no_other_file_has_a_table_of_measures() -> None:
    """A page, a report, an export or a command that named them one by one would miss the next one."""
    keys = re.compile(rf"\b({'|'.join((TRIAL_MEASURES.keys() | TEST_MEASURES.keys()) - ORDINARY)})\b")
    found = {}
    for folder, kind in (("app", "py"), ("web_static/js", "js")):
        for file in (ROOT / folder).rglob(f"*.{kind}"):
            name = file.relative_to(ROOT).as_posix()
            named = set(keys.findall(file.read_text(encoding="utf-8")))
            if named and name != "app/scoring/measures.py" and not MAY_NAME.fullmatch(name):
                found[name] = named
    assert found == {
        SCORE: {"dist_ratio", "cross_track_rms", "cross_track_max", "mean_speed"},
        NEXT_TASK: {"collisions"},
    }


def test_words_of_a_measure_follow_from_its_name() -> None:
    plain = CIRCUMSTANCES["path_length"]
    assert (str(plain.as_subject), str(plain.defined_as)) == ("Length of the path", "Length of the path")
    named = TRIAL_MEASURES["stops"]
    assert (str(named.as_subject), str(named.defined_as)) == ("the number of standstills", "Number of standstills")


def test_levels_are_written_in_their_unit() -> None:
    assert str(TRIAL_MEASURES["heading_error_deg"].level(12.3)) == "12°"
    assert str(TRIAL_MEASURES["stops"].level(0.4)) == "0.4"
    assert str(TRIAL_MEASURES["sparc"].level(-0.001)) == "0.00"
    assert str(TRIAL_MEASURES["follow_near"].level(0.434)) == "43 %"
