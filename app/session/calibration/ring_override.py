"""The clinician's override of a detected rotation of a ring of sensors."""

from app.calibration.profile import CalibrationProfile
from app.json_values import JsonDocument
from app.refusals import Conflict, NotFound
from app.store.calibrations import recordings_of
from app.store.database import Database, Transaction
from app.store.log import write_log
from app.store.tables import PatientSession
from app.texts import Text

AS_WORN = "as_worn"  # in the script of a calibration: the rings, and the recording in which a rotation was detected


def rings_as_worn(db: Transaction, session: PatientSession) -> tuple[str, ...]:
    """Return the rings whose detected rotation is overridden; none once the free movement was recorded again."""
    override: JsonDocument = (session.script or {}).get(AS_WORN, {})
    if not override or override["recording"] != _free_movement(db, session.id):
        return ()
    return tuple(override["rings"])


def override_rotation(database: Database, session_id: int, joint: str, person: str, *, is_right: bool) -> None:
    """Store whether the detected rotations at a joint are overridden; the result must then be fitted again.

    Raises
    ------
    NotFound
        When the result has no such joint.
    Conflict
        When there is no result, or no rotation was detected at the joint.
    """
    with database.transaction() as db:
        session = db.get_one(PatientSession, session_id)
        if session.result is None or session.script is None:
            raise Conflict(Text("visit-no-result"))
        joints = {joint_map.name: joint_map for joint_map in CalibrationProfile.model_validate(session.result).joints}
        if joint not in joints:
            raise NotFound(Text("visit-no-map", joint=joint, joints=", ".join(joints)))
        prior = joints[joint].prior
        rings = set() if prior is None else {*prior.arrangement, *prior.as_worn}
        if not rings:
            raise Conflict(Text("visit-ring-not-turned"))
        before = set(rings_as_worn(db, session))
        override = {
            "recording": _free_movement(db, session_id),
            "rings": sorted(before | rings if is_right else before - rings),
        }
        session.script = {**session.script, AS_WORN: override}
        write_log(db, person, "shirt sits right", patient=session.patient_id, joint=joint, right=is_right)


def _free_movement(db: Transaction, session_id: int) -> str | None:
    """Return the folder of the recorded free movement."""
    return recordings_of(db, session_id).get("free")
