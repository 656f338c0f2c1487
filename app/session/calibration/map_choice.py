"""Choose which map decodes a joint, on the result of a calibration before it is accepted."""

from app.calibration.linear_map import MapKind
from app.calibration.profile import CalibrationProfile
from app.refusals import Conflict, NotFound
from app.store.database import Database
from app.store.tables import PatientSession
from app.texts import Text


def choose_map(database: Database, session_id: int, joint: str, kind: MapKind) -> None:
    """Let one joint of the session's result be decoded by this map; an accepted result must be accepted again.

    A guided map is refused where it is not better than the paper's on the held-out repetitions, other people's map
    where there is none or it is worse.
    """
    with database.transaction() as db:
        session = db.get_one(PatientSession, session_id)
        if session.result is None:
            raise Conflict(Text("visit-no-result"))
        profile = CalibrationProfile.model_validate(session.result)
        names = [joint_map.name for joint_map in profile.joints]
        if joint not in names:
            raise NotFound(Text("visit-no-map", joint=joint, joints=", ".join(names)))
        chosen = profile.joints[names.index(joint)]
        if kind == "guided" and (chosen.guided is None or not chosen.guided.is_better):
            raise Conflict(Text("visit-guided-not-better"))
        if kind == "prior" and (chosen.prior is None or not chosen.prior.is_better):
            raise Conflict(Text("visit-prior-not-better"))
        if chosen.map == kind:
            return
        joints = tuple(
            joint_map.model_copy(update={"map": kind}) if joint_map.name == joint else joint_map
            for joint_map in profile.joints
        )
        session.result = profile.model_copy(update={"joints": joints}).model_dump(mode="json")
        session.accepted = False
