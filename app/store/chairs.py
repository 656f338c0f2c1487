"""Paired real chairs, and the clinic's speed limits."""

from collections.abc import Iterator

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.json_values import JsonDocument
from app.refusals import Conflict, NotFound
from app.speed_limits import HIGHEST_SPEEDS, Speeds
from app.store.access.visible_patients import own_clinic_id
from app.store.own_rows import own_row
from app.store.tables import Clinic, PairedChair
from app.texts import Text

LARGEST_KEY_ID = 65_535  # u16 of the frames to the chair
KEY_ELSEWHERE = 0  # no chair here ever has a key of this number


def add_chair(db: Session, clinic: Clinic, name: str, host: str, port: int, key_id: int, speeds: Speeds) -> PairedChair:
    """Add a chair that was just paired; the caller writes its key into `<state>/keys/<key_id>.key`."""
    if any(chair.name == name for chair in chairs_of(db)):
        raise Conflict(Text("store-chair-name-taken", name=name))
    chair = PairedChair(
        clinic_id=clinic.id,
        name=name,
        host=host,
        port=port,
        key_id=key_id,
        speeds=speeds.model_dump(mode="json"),
        paired=utc_now(),
        removed=None,
    )
    db.add(chair)
    db.flush()
    return chair


def free_key_ids(db: Session, clinic: Clinic) -> Iterator[int]:
    """Yield the key numbers that no chair here ever had, so that the key of a removed chair is never valid again."""
    used = set(db.scalars(select(PairedChair.key_id).where(PairedChair.clinic_id == clinic.id)))
    yield from (key_id for key_id in range(1, LARGEST_KEY_ID + 1) if key_id not in used)
    raise Conflict(Text("store-keys-used-up"))


def chair_elsewhere(db: Session) -> PairedChair:
    """Return the row to which drives of other clinics' chairs refer: removed, without address and key."""
    chair = db.scalar(select(PairedChair).where(PairedChair.key_id == KEY_ELSEWHERE))
    if chair is None:
        now = utc_now()
        chair = PairedChair(
            clinic_id=own_clinic_id(db),
            name="A chair of another clinic",
            host="",
            port=0,
            key_id=KEY_ELSEWHERE,
            speeds={},
            paired=now,
            removed=now,
        )
        db.add(chair)
        db.flush()
    return chair


def chairs_of(db: Session) -> list[PairedChair]:
    """Return the chairs that are paired, the newest last."""
    return list(db.scalars(select(PairedChair).where(PairedChair.removed.is_(None)).order_by(PairedChair.id)))


def find_chair(db: Session, chair_id: int) -> PairedChair:
    """Return one of the chairs that are paired."""
    missing = Text("store-no-chair", chair=chair_id)
    chair = own_row(db, PairedChair, chair_id, missing)
    if chair.removed is not None:
        raise NotFound(missing)
    return chair


def remove_chair(db: Session, chair_id: int) -> PairedChair:
    """Unpair a chair; the row stays, because drives refer to it."""
    chair = find_chair(db, chair_id)
    chair.removed = utc_now()
    db.flush()
    return chair


def limits_of(clinic: Clinic | None) -> Speeds:
    """Return what the clinic's owner allows; a limit that was not set is that of the application."""
    stored: JsonDocument = {} if clinic is None else clinic.limits or {}
    return Speeds.model_validate({**HIGHEST_SPEEDS.model_dump(mode="json"), **stored})
