"""What is known of other people in the same shirt: the clinic's own prior, and the one that ships with the shirt."""

from app.calibration.prior.documents import FEWEST_PEOPLE, PersonEntry
from app.calibration.prior.map_prior import MapPrior, sums_of
from app.features.prior.entries import (
    count_entries,
    entries_of_others,
    entry_of_patient,
    is_prior_on,
    may_add,
    put_entry,
)
from app.session.calibration.garment import Garment
from app.store.access.visible_patients import every_patient
from app.store.database import Database
from app.store.tables import Patient, PatientSession


class ClinicPrior:
    """The prior for the patient of a session, and what this patient adds to it for others.

    A worn shirt learns from worn ones only, a camera from cameras, a simulated shirt from the same simulated shirt. The
    standard simulated shirt has a prior that ships with the program.
    """

    def __init__(self, database: Database) -> None:
        self._database = database

    def people(self, session_id: int, garment: Garment) -> int:
        """Return how many other people are known in this shirt; 0 when they are too few, or the owner wants none."""
        with every_patient(), self._database.reading() as db:
            session = db.get_one(PatientSession, session_id)
            if not is_prior_on(db):
                return 0
            count = count_entries(db, garment.hash, simulated=garment.simulated, without=session.patient_id)
        shipped = garment.shipped_prior
        if shipped is not None:
            return count + shipped.people
        # Somebody of whom one joint is known counts, too, and a joint needs enough people who are known in it. With so
        # many entries that one joint must have enough, they need not be read.
        if count > (FEWEST_PEOPLE - 1) * len(garment.layout.joints):
            return count
        return count if count >= FEWEST_PEOPLE and self.of_others(session_id, garment) is not None else 0

    def of_others(self, session_id: int, garment: Garment) -> MapPrior | None:
        """Return what is known of other people in this shirt; None when they are too few, or the owner wants none."""
        with every_patient(), self._database.reading() as db:
            session = db.get_one(PatientSession, session_id)
            if not is_prior_on(db):
                return None
            others = entries_of_others(db, garment.hash, session.patient_id, simulated=garment.simulated)
        entries = [PersonEntry.model_validate(entry).in_layout(garment.layout) for entry in others]
        prior = MapPrior(garment.layout, *sums_of(entries))
        shipped = garment.shipped_prior
        if shipped is not None:
            prior += MapPrior.of(shipped)
        return prior if prior.people >= FEWEST_PEOPLE else None

    def may_learn(self, session_id: int, garment: Garment) -> bool:
        """Return whether the calibration of a session may add to the prior: consent, and the owner's switch."""
        with self._database.reading() as db:
            patient = db.get_one(Patient, db.get_one(PatientSession, session_id).patient_id)
            return may_add(db, patient, simulated=garment.simulated)

    def add(self, session_id: int, garment: Garment, entry: PersonEntry) -> None:
        """Store what the patient of a session adds, in place of what this patient added of these joints before."""
        with self._database.transaction() as db:
            patient_id = db.get_one(PatientSession, session_id).patient_id
            before = entry_of_patient(db, patient_id, garment.hash, simulated=garment.simulated)
            if before is not None:
                entry = entry.completed(PersonEntry.model_validate(before))
            document = entry.model_dump(mode="json")
            put_entry(db, patient_id, garment.hash, document, simulated=garment.simulated)
