"""What people wrote and tested in a clinic of some years: a note, a comment and a two-minute test of each session."""

from collections.abc import Sequence
from datetime import timedelta
from typing import Any

from stored_interface_test import MEASURES

from app.features.comments.tables import CommentRevision, MomentComment
from app.features.records.tables import NoteRevision, SessionNote
from app.store.tables import InterfaceTest, Run
from app.world.cursor_task import CursorPlan

NOTE = "The left elbow tires after some trials; the right one is steady. " * 3
COMMENT = "Here the turn comes late, and the chair goes on towards the wall. " * 2

Documents = dict[Any, list[dict[str, Any]]]


def written_rows(
    sessions: Sequence[dict[str, Any]],
    trials: Sequence[dict[str, Any]],
    set_of: dict[int, int],
    person_id: int,
    source: dict[str, Any],
) -> Documents:
    """Return the documents of each table, in the order in which they refer to one another.

    `set_of` names a parameter set of each patient; `person_id` is the author of the comments.
    """
    of_session = {trial["session_id"]: trial for trial in trials}  # the last one
    plan = CursorPlan(seed=1).model_dump(mode="json")
    rows: Documents = {
        kind: [] for kind in (Run, InterfaceTest, SessionNote, NoteRevision, MomentComment, CommentRevision)
    }
    for own, session in enumerate(sessions, start=1):
        began, run = session["started"] + timedelta(minutes=5), f"test-{own}"
        ends = {"started": began, "ended": began + timedelta(seconds=120)}
        belongs = {"session_id": session["id"], "kind": "interface_test", "folder": run}
        rows[Run].append({"id": run, "rows": 12_000, "dropped": 0, **belongs, **ends, **source})
        rows[InterfaceTest].append(
            {
                "id": own,
                "clinic_id": session["clinic_id"],
                "patient_id": session["patient_id"],
                "session_id": session["id"],
                "parameters_id": set_of[session["patient_id"]],
                "run_id": run,
                "number": session["number"],
                "started": began,
                "status": "done",
                "end": "complete",
                "plan": plan,
                "measures": {**MEASURES, "throughput": 0.5 + 0.01 * session["number"]},
            }
        )
        rows[SessionNote].append({"id": own, "session_id": session["id"]})
        rows[NoteRevision].append({"id": own, "note_id": own, "text": NOTE, "person": "Ada", "written": began})
        trial = of_session[session["id"]]["id"]
        comment = {"id": own, "clinic_id": session["clinic_id"], "trial_id": trial, "person_id": person_id}
        rows[MomentComment].append({**comment, "author": None, "t": 12.5, "withdrawn": None})
        rows[CommentRevision].append({"id": own, "comment_id": own, "text": COMMENT, "written": began})
    return rows
