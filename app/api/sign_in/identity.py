"""The identity behind a request's cookies: a person who is signed in, or a paired screen of the patient."""

from dataclasses import dataclass

from starlette.requests import HTTPConnection

from app.api.sign_in.cookies import read_cookie
from app.store.access.rights import DRIVERS
from app.store.access.sign_ins import is_locked, signed_in, store_action
from app.store.access.visible_patients import VisiblePatients, every_patient
from app.store.database import Database
from app.store.patient_screens import find_screen

COOKIE = "bodydrive_sign_in"
PHONE_COOKIE = "bodydrive_phone"  # of a phone that is paired as a sensor: it gives access to nothing
SCREEN_COOKIE = "bodydrive_screen"  # of a paired screen of the patient: it gives access to the patient's picture only


@dataclass(frozen=True, slots=True)
class SignedInPerson:
    """A person with an open sign-in."""

    sign_in_id: int
    person_id: int
    clinic_id: int
    name: str
    role: str
    patients: VisiblePatients = None  # those that exist for this person; None: all
    locked: bool = False  # nothing may be seen or changed until the password was given

    @property
    def drives(self) -> bool:
        """Return whether this person may change what drives now."""
        return not self.locked and self.role in DRIVERS

    def sees(self, patient_id: int | None) -> bool:
        """Return whether this person may see a patient now; None stands for nobody, whom everybody may see."""
        return not self.locked and (patient_id is None or self.patients is None or patient_id in self.patients)


def find_sign_in(database: Database, connection: HTTPConnection, *, acts: bool = False) -> SignedInPerson | None:
    """Return the person whose sign-in the cookie opens, locked or not; None when there is none or it has ended.

    `acts`: the person does something at this moment, which is stored, so that the sign-in is not locked soon.
    """
    token = read_cookie(connection, COOKIE)
    if not token:
        return None
    with database.transaction() if acts else database.reading() as db:
        sign_in = signed_in(db, token)
        if sign_in is None:
            return None
        opened, person = sign_in
        if acts:
            store_action(opened, person)
        return SignedInPerson(
            opened.id,
            person.id,
            person.clinic_id,
            person.name,
            person.role,
            None if person.patients is None else frozenset(person.patients),
            is_locked(opened, person),
        )


@dataclass(frozen=True, slots=True)
class PairedScreen:
    """A paired screen of the patient, as long as its session is open."""

    screen_id: int
    session_id: int

    def sees(self, _patient_id: int | None) -> bool:
        """Return True: the screen is paired with the open session, and shows no other patient."""
        return True


@dataclass(frozen=True, slots=True)
class PairedPhone:
    """A phone that is paired as a sensor."""

    number: int

    def sees(self, _patient_id: int | None) -> bool:
        """Return False: a phone sends, and is shown nothing of a patient."""
        return False


def find_paired_screen(database: Database, connection: HTTPConnection) -> PairedScreen | None:
    """Return the patient's screen of the cookie, None when its session has ended or it was unpaired."""
    token = read_cookie(connection, SCREEN_COOKIE)
    if not token:
        return None
    with every_patient(), database.reading() as db:
        screen, _ = find_screen(db, token)
        return None if screen is None else PairedScreen(screen.id, screen.session_id)


def find_viewer(database: Database, connection: HTTPConnection) -> SignedInPerson | PairedScreen | None:
    """Return who may see the patient's picture: a person who is signed in, or a paired screen of the patient.

    A browser whose sign-in is locked still is the patient's screen that it was paired as.
    """
    person = find_sign_in(database, connection)
    if person is None or person.locked:
        return find_paired_screen(database, connection) or person
    return person
