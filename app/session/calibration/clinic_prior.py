"""What is known of other people in the same shirt: the clinic's own prior, and the one that ships with the shirt."""

import hashlib
import json
from typing import NamedTuple

from app.calibration.prior.documents import FEWEST_PEOPLE, PersonEntry, ReleasedPrior
from app.calibration.prior.map_prior import MapPrior, layout_key, sums_of
from app.calibration.prior.shipped import SHIPPED_SEED, shipped_prior
from app.layout import ShirtLayout
from app.store.access.visible_patients import every_patient
from app.store.database import Database
from app.store.prior.prior_entries import (
    count_entries,
    entries_of_others,
    entry_of_patient,
    is_prior_on,
    may_add,
    put_entry,
)
from app.store.tables import Patient, PatientSession


class Garment(NamedTuple):
    """What must be equal so that other people's movements say something of a patient's.

    Rings need not be: they may come to a layout later.
    """

    layout: ShirtLayout
    simulated: bool  # whether nobody wears the shirt
    seed: int | None  # of a simulated shirt: each seed is a different one

    @property
    def hash(self) -> str:
        """SHA-256, hex."""
        # None twice: such was the hash of a layout without rings when rings were a part of it.
        key = [(*channel, None, None) for channel in layout_key(self.layout)]
        return hashlib.sha256(json.dumps([key, self.seed]).encode()).hexdigest()

    @property
    def shipped_prior(self) -> ReleasedPrior | None:
        """The prior that ships with this shirt; None for a worn shirt, and for another simulated one."""
        return shipped_prior(self.layout) if self.simulated and self.seed == SHIPPED_SEED else None


class ClinicPrior:
    """The prior for the patient of a session, and what this patient adds to it for others.

    A worn shirt learns from worn ones only, a simulated one from the same simulated shirt only. The standard simulated
    shirt has a prior that ships with the program.
    """

    def __init__(self, database: Database) -> None:
        self._database = database

    def people(self, session_id: int, garment: Garment) -> int:
        """Return how many other people are known in this shirt; 0 when they are too few, or the owner wants none."""
        with every_patient(), self._database.transaction() as db:
            session = db.get_one(PatientSession, session_id)
            if not is_prior_on(db, session.clinic_id):
                return 0
            count = count_entries(
                db, session.clinic_id, garment.hash, simulated=garment.simulated, without=session.patient_id
            )
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
        with every_patient(), self._database.transaction() as db:
            session = db.get_one(PatientSession, session_id)
            if not is_prior_on(db, session.clinic_id):
                return None
            found = entries_of_others(
                db, session.clinic_id, garment.hash, session.patient_id, simulated=garment.simulated
            )
        entries = [PersonEntry.model_validate(entry).in_layout(garment.layout) for entry in found]
        prior = MapPrior(garment.layout, *sums_of(entries))
        shipped = garment.shipped_prior
        if shipped is not None:
            prior += MapPrior.of(shipped)
        return prior if prior.people >= FEWEST_PEOPLE else None

    def may_learn(self, session_id: int, garment: Garment) -> bool:
        """Return whether the calibration of a session may add to the prior: consent, and the owner's switch."""
        with self._database.transaction() as db:
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
