"""Stores interface tests as if they had been done, for tests of what is shown of them."""

import uuid

from clinic_rows import SIMULATED

from app.features.interface_tests.service import add_interface_test, finish_interface_test
from app.store.parameters import current_parameters
from app.store.runs import add_run
from app.store.tables import PatientSession
from app.world.cursor_task import CursorPlan

WAYS = {way: {"acquired": 5, "missed": 0, "movement_time": 2.5} for way in ("ahead", "back", "left", "right")}
MEASURES = {
    "duration": 120.0,
    "complete": True,
    "acquired": 20,
    "missed": 1,
    "acquisitions_per_minute": 10.0,
    "first_entry": 2.5,
    "dial_in": 0.25,
    "entries": 1.1,
    "path_efficiency": 0.875,
    "effective_width": 0.15,
    "throughput": 0.75,
    "directions": WAYS,
}


def store_interface_test(db, session_id, *, end="complete", plan=None, **measures):
    """Store a test of a session that was done, with `measures` in place of the usual ones."""
    session = db.get_one(PatientSession, session_id)
    run = add_run(db, uuid.uuid4().hex, session_id, "interface_test", "gone", SIMULATED)
    row, _ = current_parameters(db, session.patient_id)
    document = CursorPlan(seed=1, **(plan or {})).model_dump(mode="json")
    test = add_interface_test(db, run=run, session=session, parameters_id=row.id, plan=document)
    return finish_interface_test(db, test.id, end, {**MEASURES, **measures})
