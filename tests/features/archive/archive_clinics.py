"""Clinics that archives are brought to, and archives that are written anew with something else in them."""

import json
import zipfile
from contextlib import closing
from hashlib import sha256
from pathlib import Path

from clinic_rows import rows_in
from exported_clinic import make_clinic

from app.features.archive.archive_file import LIST, PATIENT, REPORT, ArchiveList, FileEntry, hash_of
from app.features.archive.archive_import import import_archive
from app.features.archive.service import make_archive
from app.settings import Settings
from app.store.database import Database


def empty_clinic(state) -> Settings:
    """Make a clinic with two other patients, so that its ids differ."""
    settings = Settings(state=state)
    with rows_in(settings, "Hillside") as clinic:
        for code in ("A-1", "A-2"):
            clinic.session(clinic.patient(code, "Wren"), accepted=False)
    return settings


def archive_of(settings: Settings, package: Path, patient: int = 1, person: str = "Ana") -> str:
    """Make the archive of a clinic's patient, and return its hash."""
    with closing(Database(settings.database)) as database:
        return make_archive(database, patient, person, settings.runs, package)


def archived_clinic(state: Path) -> Path:
    """Make a clinic whose patient has a recorded trial, and return the archive of the patient."""
    settings = make_clinic(state)
    archive_of(settings, settings.state / "heron.zip")
    return settings.state / "heron.zip"


def bring(settings, package, *, replace=False):
    shelf = settings.replaced if replace else None
    with closing(Database(settings.database)) as database:
        return import_archive(database, package, "Ben", settings.runs, shelf=shelf)


def state_of(settings):
    """Return all that an import could change: rows of all tables, and files of recordings."""
    with closing(Database(settings.database)) as database, database.transaction() as db:
        tables = [
            name for (name,) in db.connection().exec_driver_sql("SELECT name FROM sqlite_master WHERE type='table'")
        ]
        rows = {name: db.connection().exec_driver_sql(f"SELECT * FROM {name}").fetchall() for name in tables}
    files = [file.relative_to(settings.state).as_posix() for file in settings.state.rglob("*") if file.is_file()]
    return rows, sorted(name for name in files if "sqlite" not in name)


def rewrite(package, target, change=None, *, names=None, patient=None, text=("", ""), listed=None, files=None):
    """Write an archive anew, with right hashes: other names, rows, another text in the document, another list."""
    with zipfile.ZipFile(package) as source:
        contents = {name: source.read(name) for name in source.namelist()} | (files or {})
    if patient is not None:
        document = json.loads(contents[PATIENT])
        patient(document["tables"])
        contents[PATIENT] = json.dumps(document).encode()
    contents[PATIENT] = contents[PATIENT].replace(*(part.encode() for part in text))
    contents = {(names or {}).get(name, name): content for name, content in contents.items()}
    entries = {
        name: FileEntry(bytes=len(content), sha256=sha256(content).hexdigest())
        for name, content in contents.items()
        if name != LIST
    }
    report = entries.pop(REPORT, None)
    made = json.loads(
        ArchiveList(clinic="Riverside", hash=hash_of(entries), files=entries, report=report).model_dump_json()
    )
    contents[LIST] = json.dumps({**made, **(listed or {})}).encode()
    if change is not None:
        change(contents)
    with zipfile.ZipFile(target, "w") as written:
        for name, content in contents.items():
            kind = zipfile.ZIP_DEFLATED if name in (LIST, PATIENT, REPORT) else zipfile.ZIP_STORED
            written.writestr(name, content, kind)
