"""A patient who has a row in every table of an archive, and every single change of the rows of it."""

import copy
import json
from collections.abc import Callable, Iterator
from contextlib import closing
from functools import partial
from pathlib import Path
from typing import Any

from clinic_rows import SIMULATED, rows_in
from exported_clinic import MEASURES, make_clinic
from features.archive.archive_clinics import archive_of
from recorded_trial import record_trial
from stored_interface_test import MEASURES as TEST_MEASURES

from app.calibration.script import calibration_script
from app.clock import utc_now
from app.features.archive.patient_rows import Rows, patient_rows
from app.features.comments.service import add_comment
from app.features.interface_tests.service import add_interface_test, finish_interface_test, save_workload
from app.features.records.service import add_note, add_scale
from app.scoring.control_quality import ControlQuality
from app.store.calibrations import begin_calibration
from app.store.chairs import chair_elsewhere
from app.store.control_quality import save_quality
from app.store.database import Database
from app.store.drives import add_drive, finish_drive
from app.store.map_versions import go_back, save_adapted
from app.store.parameters import as_document, current_parameters
from app.store.runs import add_run
from app.store.tables import PatientSession, Trial
from app.world.cursor_task import CursorPlan
from building import make_parameters

PART = {"title": "Turn", "kind": "turn", "reached": True, "time": 3.5, "heading_error_deg": 4.0, "turn_drift": 0.1}
ALL_MEASURES = {**MEASURES, "path_length": 6.0, "mean_speed": 0.5, "collisions": 0, "stages": 1, "parts": [PART]}
QUALITY = ControlQuality(
    map_angle_deg=4.0,
    evr=0.9,
    null_space_share=0.1,
    cross_talk=0.05,
    activations=20,
    activations_per_metre=3.0,
    joints=(),
    bad_channels=(),
)
WRONG: tuple[Any, ...] = (
    *(None, True, "x", "", "3", [], [[]], {}, {"x": {}}, -1, 0, 0.5, 1e300, -1e300, 2**62, "\u202ex", "x" * 9000),
    *("0001-01-01T00:00:00+14:00", "9999-12-31T23:59:59-14:00"),
)


def whole_clinic(state: Path, trials: int) -> tuple[Any, Path]:
    """Make a clinic whose patient has every kind of row, and this many trials; return its settings and the archive."""
    settings, parameters = make_clinic(state), make_parameters()
    with rows_in(settings) as clinic:
        db = clinic.db
        session = db.get_one(PatientSession, 1)
        db.get_one(Trial, 1).measures = ALL_MEASURES
        save_quality(db, 1, QUALITY)
        for number in range(2, trials + 1):
            measures = {**ALL_MEASURES, "time": 13.0 - number}
            clinic.trial(session, measures, run=f"{number:032x}", ticks=200, end="by hand")
        layout = parameters.profile.layout
        script = {"layout": layout.model_dump(mode="json"), "as_worn": {"recording": None, "rings": []}}
        begin_calibration(db, session, script, [step.id for step in calibration_script(layout)])
        session.result, session.accepted = parameters.profile.model_dump(mode="json"), True
        session.screen = {"arrow": True, "sounds": False, "large": False, "plan": False}
        difference = {"joints": {"left_elbow": {"range_moved": True}}, "trials": [1], "by_itself": True}
        save_adapted(db, 1, 1, as_document(*current_parameters(db, 1)), difference)
        go_back(db, 1, 1)
        row, _ = current_parameters(db, 1)
        run = add_run(db, "e" * 32, 1, "interface_test", "e" * 32, SIMULATED)
        plan_of_test = CursorPlan(seed=1).model_dump(mode="json")
        test = add_interface_test(db, run=run, session=session, parameters_id=row.id, plan=plan_of_test)
        finish_interface_test(db, test.id, "complete", TEST_MEASURES)
        save_workload(db, test.id, {"mental": 40})
        run = add_run(db, "d" * 32, 1, "drive", "d" * 32, SIMULATED)
        chair = chair_elsewhere(db).id
        drive = add_drive(db, run=run, patient_id=1, chair_id=chair, parameters_id=row.id, digest=row.hash)
        finish_drive(db, drive.id, "by hand", 12.5)
        add_note(db, 1, "Went well.", "Ana")
        add_scale(db, 1, "SCIM III", 41.5, utc_now().date())
        add_comment(db, db.get_one(Trial, 1), clinic.person("Dora", "reviewer").id, 2.5, "Here it turns late.")
    for number in range(2, trials + 1):
        record_trial(settings.runs / f"{number:032x}", parameters, seconds=2.0, seed=number)
    archive_of(settings, state / "whole.zip")
    return settings, state / "whole.zip"


def rows_of(settings: Any) -> Rows:
    with closing(Database(settings.database)) as database, database.transaction() as db:
        return json.loads(json.dumps(patient_rows(db, 1)))


def places(value: Any, place: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield the place of every value in a document; of equal elements of a list, that of the first."""
    if place:
        yield place
    if isinstance(value, dict):
        for name, inner in value.items():
            yield from places(inner, (*place, name))
    elif isinstance(value, list) and value:
        yield from places(value[0], (*place, 0))


def mutations(rows: Rows) -> Iterator[tuple[str, Callable[[], Rows]]]:
    """Yield every single change of these rows, with words for it: wrong values, left out, one more, lists swapped."""
    changes: list[tuple[str, Any]] = [(f"= {json.dumps(wrong)[:40]}", partial(_given, wrong)) for wrong in WRONG]
    changes += [("twice", lambda old: [old, old]), ("in a list", lambda old: [old])]
    changes += [("as a dict", lambda old: {"value": old}), ("with one more", _one_more)]
    for place in places(rows):
        if len(place) < 3:
            continue
        where = ".".join(map(str, place))
        for words, change in changes:
            yield f"{where} {words}", partial(changed, rows, place, change)
        if isinstance(place[-1], str):
            yield f"{where} left out", partial(changed, rows, place, None)


def _given(value: Any, _old: Any) -> Any:
    return value


def changed(rows: Rows, place: tuple[Any, ...], change: Any) -> Rows:
    """Return a copy of the rows with another value at a place; `change` None: the place is left out."""
    made = copy.deepcopy(rows) if len(place) < 2 else {**rows, place[0]: copy.deepcopy(rows[place[0]])}
    inner: Any = made
    for step in place[:-1]:
        inner = inner[step]
    if change is None:
        del inner[place[-1]]
    else:
        inner[place[-1]] = change(inner[place[-1]])
    return made


def _one_more(old: Any) -> Any:
    if isinstance(old, dict):
        return {**old, "one_more": 1}
    if isinstance(old, list):
        return [*old, old[0] if old else 0]
    return old + 1 if isinstance(old, int | float) else f"{old}x"
