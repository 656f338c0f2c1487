"""The layouts of a clinic: listed, saved, deleted; and those that come with the program, which stay as they are."""

from functools import cache

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.features.layouts.tables import ClinicLayout
from app.layout import ShirtLayout
from app.refusals import Conflict
from app.settings import data_folder
from app.store.access.visible_patients import own_clinic_id
from app.store.own_rows import own_row
from app.texts import Text

MOST_LAYOUTS = 100  # of a clinic


@cache
def bundled_layouts() -> tuple[ShirtLayout, ...]:
    """Return the layouts that come with the program."""
    files = sorted((data_folder() / "shirts").glob("*.json"))
    return tuple(ShirtLayout.model_validate_json(file.read_bytes()) for file in files)


def layouts_of(db: Session) -> list[ClinicLayout]:
    """Return the clinic's layouts, by name."""
    return list(db.scalars(select(ClinicLayout).order_by(func.lower(ClinicLayout.name))))


def find_layout(db: Session, layout_id: int) -> ClinicLayout:
    """Return one of the clinic's layouts."""
    return own_row(db, ClinicLayout, layout_id, Text("layouts-missing", number=layout_id))


def add_layout(db: Session, layout: ShirtLayout) -> ClinicLayout:
    """Save a new layout; Conflict when its name is taken, or there are too many."""
    if db.scalars(select(func.count(ClinicLayout.id))).one() >= MOST_LAYOUTS:
        raise Conflict(Text("layouts-most", count=MOST_LAYOUTS))
    _require_free_name(db, layout.name, None)
    row = ClinicLayout(clinic_id=own_clinic_id(db), version=0)
    db.add(row)
    _save(db, row, layout)
    return row


def replace_layout(db: Session, layout_id: int, layout: ShirtLayout, version: int) -> ClinicLayout:
    """Save a layout in place of its `version`; Conflict when somebody saved it meanwhile, or its name is taken."""
    row = find_layout(db, layout_id)
    if row.version != version:
        raise Conflict(Text("layouts-saved-meanwhile", name=row.name))
    _require_free_name(db, layout.name, row.id)
    _save(db, row, layout)
    return row


def delete_layout(db: Session, layout_id: int, given: ShirtLayout | None) -> ClinicLayout:
    """Delete a layout, and return its row; Conflict when it is the one that the shirt in use was given."""
    row = find_layout(db, layout_id)
    if given is not None and given.name == row.name:
        raise Conflict(Text("layouts-in-use", name=row.name))
    db.delete(row)
    db.flush()
    return row


def _save(db: Session, row: ClinicLayout, layout: ShirtLayout) -> None:
    row.name, row.document = layout.name, layout.without_liveness.model_dump(mode="json")
    row.version, row.saved = row.version + 1, utc_now()
    db.flush()


def _require_free_name(db: Session, name: str, own_id: int | None) -> None:
    """Refuse a name that another layout has; names do not differ by case."""
    rows = db.execute(select(ClinicLayout.id, ClinicLayout.name)).all()
    own = (other for layout_id, other in rows if layout_id != own_id)
    bundled = (layout.name for layout in bundled_layouts())
    if name.casefold() in {other.casefold() for other in (*own, *bundled)}:
        raise Conflict(Text("layouts-name-taken", name=name))
