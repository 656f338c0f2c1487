"""The entries of the clinic's own prior: one per patient and shirt, of patients who have consented to it."""

from collections.abc import Collection
from typing import Any

from sqlalchemy import ColumnElement, delete, func, select, true
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.features.prior.tables import PriorEntry, PriorSwitch
from app.store.access.visible_patients import own_clinic_id
from app.store.consent import consented
from app.store.tables import Patient

RELEASED = "released"  # in a stored entry: its joints and rings that are in a release, because nobody is in two


def is_prior_on(db: Session) -> bool:
    """Return whether accepted calibrations add to the clinic's prior, and new patients are helped by it."""
    row = db.get(PriorSwitch, own_clinic_id(db))
    return row is None or row.on


def switch_prior(db: Session, *, on: bool) -> bool:
    """Switch the clinic's prior on or off, and return whether that is new; entries made before stay."""
    if is_prior_on(db) == on:
        return False
    db.merge(PriorSwitch(clinic_id=own_clinic_id(db), on=on))
    db.flush()
    return True


def may_add(db: Session, patient: Patient, *, simulated: bool) -> bool:
    """Return whether a calibration of this patient may add to the prior; practice needs no consent."""
    chosen = select(Patient.id).where(Patient.id == patient.id, _may_be_used(simulated))
    return is_prior_on(db) and db.scalar(chosen) is not None


def put_entry(db: Session, patient_id: int, shirt: str, document: dict[str, Any], *, simulated: bool) -> None:
    """Store what a patient adds to the prior of a shirt (its hash), in place of what was there."""
    row = db.scalar(select(PriorEntry).where(*_own(patient_id, shirt, simulated)))
    if row is None:
        row = PriorEntry(patient_id=patient_id, shirt=shirt, simulated=simulated)
        db.add(row)
        row.document = {}
    released = {RELEASED: row.document[RELEASED]} if RELEASED in row.document else {}
    row.document, row.made = {**document, **released}, utc_now()
    db.flush()


def entry_of_patient(db: Session, patient_id: int, shirt: str, *, simulated: bool) -> dict[str, Any] | None:
    """Return what a patient adds to the prior of a shirt (its hash), None when it is nothing."""
    document = db.scalar(select(PriorEntry.document).where(*_own(patient_id, shirt, simulated)))
    return None if document is None else without_releases(document)


def remove_entries(db: Session, patient_id: int) -> int:
    """Take a patient's worn entries out again, as when the consent is withdrawn; return how many there were."""
    worn = delete(PriorEntry).where(PriorEntry.patient_id == patient_id, PriorEntry.simulated.is_(False))
    return len(db.execute(worn.returning(PriorEntry.id)).fetchall())


def count_entries(db: Session, shirt: str, *, simulated: bool, without: int | None = None) -> int:
    """Return how many of the clinic's patients have an entry that may be used for a shirt, `without` one of them."""
    query = select(func.count()).select_from(PriorEntry).join(Patient, PriorEntry.patient_id == Patient.id)
    return db.scalar(query.where(*_usable(shirt, simulated, without))) or 0


def entries_of_others(db: Session, shirt: str, patient_id: int, *, simulated: bool) -> list[dict[str, Any]]:
    """Return the documents of the clinic's other patients for a shirt.

    Deleted patients are left out, and those who have not consented, or no longer do.
    """
    query = (
        select(PriorEntry.document)
        .join(Patient, Patient.id == PriorEntry.patient_id)
        .where(*_usable(shirt, simulated, patient_id))
        .order_by(PriorEntry.patient_id)
    )
    return [without_releases(document) for document in db.scalars(query)]


def worn_entries(db: Session, shirt: str, *, to_share: bool) -> list[tuple[str, dict[str, Any]]]:
    """Return the patients' codes with what each adds to the prior of a worn shirt, and with what is released of it.

    With `to_share` only those who have consented to sharing outside of the clinic, too.
    """
    query = (
        select(Patient.code, PriorEntry.document)
        .join(Patient, Patient.id == PriorEntry.patient_id)
        .where(*_usable(shirt, False, None))
        .order_by(PriorEntry.patient_id)
    )
    if to_share:
        query = query.where(consented("sharing"))
    return [(code, document) for code, document in db.execute(query)]


def mark_released(db: Session, code: str, shirt: str, joints: Collection[str], rings: Collection[str]) -> None:
    """Store that these joints and rings of what a patient adds to the prior of a worn shirt are in a release."""
    row = db.scalar(
        select(PriorEntry)
        .join(Patient, Patient.id == PriorEntry.patient_id)
        .where(Patient.code == code, PriorEntry.shirt == shirt)
        .where(PriorEntry.simulated.is_(False))
    )
    if row is None:
        return
    before = releases_of(row.document)
    after = {"joints": sorted({*before["joints"], *joints}), "rings": sorted({*before["rings"], *rings})}
    row.document = {**row.document, RELEASED: after}
    db.flush()


def releases_of(document: dict[str, Any]) -> dict[str, list[str]]:
    """Return the joints and the rings of a stored entry that are in a release."""
    releases: dict[str, list[str]] = document.get(RELEASED, {"joints": [], "rings": []})
    return releases


def without_releases(document: dict[str, Any]) -> dict[str, Any]:
    """Return a stored entry as the document of what a person adds."""
    return {name: part for name, part in document.items() if name != RELEASED}


def _usable(shirt: str, simulated: bool, without: int | None) -> tuple[ColumnElement[bool], ...]:
    return (
        Patient.id != (0 if without is None else without),
        Patient.deleted.is_(None),
        PriorEntry.shirt == shirt,
        PriorEntry.simulated.is_(simulated),
        _may_be_used(simulated),
    )


def _own(patient_id: int, shirt: str, simulated: bool) -> tuple[ColumnElement[bool], ...]:
    return PriorEntry.patient_id == patient_id, PriorEntry.shirt == shirt, PriorEntry.simulated.is_(simulated)


def _may_be_used(simulated: bool) -> ColumnElement[bool]:
    return true() if simulated else consented("clinic_prior")
