"""How the shirt sits, as a person says it: rings of sensors that are left as worn although they look turned."""

from typing import Any

from app.calibration.profile import CalibrationProfile
from app.refusals import Conflict, NotFound
from app.store.calibrations import recordings_of
from app.store.database import Database, Transaction
from app.store.log import write_log
from app.store.tables import PatientSession

AS_WORN = "as_worn"  # in the calibration under way: which rings, and the recording in which they looked turned


def rings_as_worn(db: Transaction, session: PatientSession) -> tuple[str, ...]:
    """Return the rings that a person is sure of; none once the free movement was recorded again."""
    noted: dict[str, Any] = (session.script or {}).get(AS_WORN, {})
    if not noted or noted["recording"] != _free_movement(db, session.id):
        return ()
    return tuple(noted["rings"])


def note_sitting(database: Database, session_id: int, joint: str, person: str, *, is_right: bool) -> None:
    """Store whether the shirt sits right at a joint; the result must then be fitted again.

    Raises
    ------
    NotFound
        When the result has no such joint.
    Conflict
        When there is no result, or the shirt sits at the joint as on other people.
    """
    with database.transaction() as db:
        session = db.get_one(PatientSession, session_id)
        if session.result is None or session.script is None:
            raise Conflict("There is no result yet: do every step first.")
        joints = {one.name: one for one in CalibrationProfile.model_validate(session.result).joints}
        if joint not in joints:
            raise NotFound(f"There is no calibration for '{joint}': choose one of {', '.join(joints)}.")
        prior = joints[joint].prior
        rings = set() if prior is None else {*prior.arrangement, *prior.as_worn}
        if not rings:
            raise Conflict("At this joint the shirt sits as on other people: there is nothing to choose.")
        before = set(rings_as_worn(db, session))
        noted = {
            "recording": _free_movement(db, session_id),
            "rings": sorted(before | rings if is_right else before - rings),
        }
        session.script = {**session.script, AS_WORN: noted}
        write_log(db, person, "shirt sits right", patient=session.patient_id, joint=joint, right=is_right)


def _free_movement(db: Transaction, session_id: int) -> str | None:
    """Return the folder of the recorded free movement."""
    return recordings_of(db, session_id).get("free")
