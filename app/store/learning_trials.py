"""The trials of a learning curve, each with its session and the version of the map that it was driven with."""

from typing import Any, NamedTuple

from sqlalchemy import JSON, select
from sqlalchemy.orm import Session

from app.source import SourceGroup, source_words
from app.store.tables import Parameters, PatientSession, Profile, Trial


class CountedTrial(NamedTuple):
    """A trial of a learning curve: finished, kept and measured."""

    trial: Trial
    session: int  # number of the session: 1, 2, 3 ... per patient
    profile_version: int
    origin: str  # of that version: calibration, adaptation, back

    @property
    def group(self) -> SourceGroup:
        """Return the group of trials that it belongs to."""
        return self.trial.run.source.group

    def row(self) -> dict[str, Any]:
        """Return its measures and its attributes by name."""
        return {
            **(self.trial.measures or {}),
            "number": self.trial.number,
            "id": self.trial.id,
            "session": self.session,
            "profile_version": self.profile_version,
            "origin": self.origin,
            "simulated": self.trial.run.simulated,
            "source": source_words(self.trial.run.source),
        }


def counted_trials(db: Session, clinic_id: int, patient_id: int, floorplan: str, path: str) -> list[CountedTrial]:
    """Return a patient's trials on one path over all sessions, of every source, the newest last."""
    found = db.execute(
        select(Trial, PatientSession.number, Profile.version, Profile.origin)
        .join(PatientSession, PatientSession.id == Trial.session_id)
        .join(Parameters, Parameters.id == Trial.parameters_id)
        .join(Profile, Profile.id == Parameters.profile_id)
        .where(
            Trial.clinic_id == clinic_id,
            Trial.patient_id == patient_id,
            Trial.floorplan == floorplan,
            Trial.path == path,
            Trial.kept.is_(True),
            Trial.status == "done",
            Trial.measures != JSON.NULL,
        )
        .order_by(Trial.id)
    )
    return [CountedTrial(*row) for row in found]
