"""The archive of an incident: log, recordings, parameters, versions and the machine's facts, in one signed tar file.

Its last three files are `manifest.json` (each other file with its SHA-256), `manifest.sig` (an Ed25519 signature of the
manifest) and `public-key.pem`. What people wrote about a patient, and who may look at it, is not in it: it stays in the
clinic, where the mark of the incident keeps it from being erased.
"""

import json
import os
import platform
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from datetime import date, datetime, timedelta
from hashlib import sha256
from importlib.metadata import distributions
from pathlib import Path
from typing import Any, Final

from sqlalchemy import Select, inspect, select
from sqlalchemy.orm import Session, undefer

from app import __version__
from app.clock import monotonic, utc_now
from app.features.backup.hashed_tar import hashed_tar, members_of
from app.features.backup.manifest import DAMAGED, MOST_BYTES, NAME
from app.features.backup.quiet_files import QuietReader, QuietWriter, hash_of
from app.features.backup.signature import fingerprint, is_signed, sign
from app.features.registration import features
from app.refusals import Refusal
from app.settings import Settings
from app.store.access.visible_patients import WITH_DELETED
from app.store.database import Database
from app.store.keeping.incidents import mark_incident
from app.store.log_chain import FIRST
from app.store.origins import ImportedSession, PatientImport
from app.store.tables import (
    CalibrationStep,
    Clinic,
    Drive,
    InterfaceTest,
    LogEntry,
    PairedChair,
    ParameterSet,
    PatientScreen,
    PatientSession,
    Profile,
    Run,
    Table,
    Trial,
)
from app.texts import Text

AT_ONCE = 500  # rows of the log in memory, and read under one lock of the database
SECRET = {"token_hash"}  # columns
WRITTEN = {"goal", "discard_reason"}  # columns with words about a patient

PERIOD: Final = timedelta(hours=24)
SIGNATURE, PUBLIC_KEY = "manifest.sig", "public-key.pem"
FORMAT: Final = 1

Rows = dict[str, list[dict[str, Any]]]


def log_lines(database: Database, since: datetime, newest: int) -> Iterator[str]:
    """Yield the rows of the log since a moment up to the row `newest`, as JSON lines with the hashes of their chain."""
    last = 0
    while True:
        query = select(LogEntry).where(LogEntry.id > last, LogEntry.id <= newest, LogEntry.at >= since)
        with database.reading() as db:
            rows = [(row.id, _document(row)) for row in db.scalars(query.order_by(LogEntry.id).limit(AT_ONCE))]
        if not rows:
            return
        yield from (f"{json.dumps(document)}\n" for _, document in rows)
        last = rows[-1][0]


def newest_log_row(db: Session) -> tuple[int, str]:
    """Return the id and the hash of the log's newest row; the hash covers all rows before it."""
    row = db.execute(select(LogEntry.id, LogEntry.hash).order_by(LogEntry.id.desc()).limit(1)).first()
    return (0, FIRST) if row is None else (row[0], row[1])


def incident_rows(db: Session, sessions: list[int]) -> Rows:
    """Return everything that describes these sessions: equipment, maps, parameters, runs, trials, drives."""
    conditions: dict[type[Table], Any] = {
        PatientSession: PatientSession.id.in_(sessions),
        Run: Run.session_id.in_(sessions),
        CalibrationStep: CalibrationStep.session_id.in_(sessions),
        Trial: Trial.session_id.in_(sessions),
        Drive: Drive.session_id.in_(sessions),
        InterfaceTest: InterfaceTest.session_id.in_(sessions),
        PatientScreen: PatientScreen.session_id.in_(sessions),
        ImportedSession: ImportedSession.session_id.in_(sessions),
    }
    rows: Rows = {kind.__tablename__: _all(db, select(kind).where(condition)) for kind, condition in conditions.items()}
    patients = {row["patient_id"] for row in rows["session"]}
    of_patients: list[type[Any]] = [PatientImport]
    of_patients += (table for feature in features().values() for table in feature.of_incidents)
    for kind in of_patients:
        rows[kind.__tablename__] = _all(db, select(kind).where(kind.patient_id.in_(patients)))
    profiles = _all(db, select(Profile).where(Profile.patient_id.in_(patients)))
    used = {row["parameters_id"] for row in (*rows["trial"], *rows["drive"], *rows["interface_test"])}
    of_profiles = ParameterSet.profile_id.in_([row["id"] for row in profiles])
    wanted = of_profiles & (ParameterSet.current | ParameterSet.id.in_(used))
    return rows | {
        "profile": profiles,
        "parameters": _all(db, select(ParameterSet).where(wanted)),
        "chair": _all(db, select(PairedChair)),
        "clinic": _all(db, select(Clinic)),
    }


def sessions_since(db: Session, since: datetime) -> list[int]:
    """Return the sessions that were open since a moment."""
    open_then = (PatientSession.ended >= since) | PatientSession.ended.is_(None) | (PatientSession.started >= since)
    return list(db.scalars(select(PatientSession.id).where(open_then), execution_options=WITH_DELETED))


def _all(db: Session, query: Select[Any]) -> list[dict[str, Any]]:
    return [_document(row) for row in db.scalars(query.options(undefer("*")), execution_options=WITH_DELETED)]


def _document(row: Table) -> dict[str, Any]:
    """Return the columns of a row for JSON, without secrets, and without what people wrote."""
    values = {column.key: getattr(row, column.key) for column in inspect(type(row)).column_attrs}
    return {
        name: value.isoformat() if isinstance(value, date) else str(value) if isinstance(value, Text) else value
        for name, value in values.items()
        if name not in SECRET | WRITTEN
    }


@dataclass(frozen=True, slots=True)
class ArchivedIncident:
    """What an archive holds, and how it is known again."""

    made: str
    since: str
    files: int
    recordings: int
    hash: str  # SHA-256 of the manifest
    fingerprint: str  # of the key that signed it


def archive_incident(
    settings: Settings,
    database: Database,
    target: Path,
    person: str | None,
    when_read: Callable[[], None] = lambda: None,
) -> ArchivedIncident:
    """Make the archive, and mark its patients as not to be erased; also while something is recorded.

    `when_read` is called before the recordings are copied: from then on this process needs no lock of the database for
    long, which others would wait for, and may take the lowest priority.

    Raises
    ------
    Refusal, OSError
        In one sentence, when it cannot be made; no file is left behind, and nothing is marked.
    """
    if target.exists():
        raise Refusal(Text("backups-file-there", file=str(target)))
    now = utc_now()
    since = now - PERIOD
    with database.reading() as db:
        sessions = sessions_since(db, since)
        rows = incident_rows(db, sessions)
        newest, head = newest_log_row(db)
    runs = [row["folder"] for row in rows["run"]]
    texts = {
        "parameters.json": json.dumps(rows, indent=1),
        "versions.json": json.dumps(_versions(), indent=1),
        "machine.json": json.dumps(_machine(settings), indent=1),
    }
    with QuietWriter(target) as out, tempfile.TemporaryFile(dir=target.parent) as log:
        for line in log_lines(database, since, newest):
            log.write(line.encode())
        size = log.tell()
        log.seek(0)
        when_read()
        with hashed_tar(out) as tar:
            hashes = {"log.jsonl": tar.add("log.jsonl", log, size)}
            hashes |= {name: tar.add_bytes(name, text.encode()) for name, text in texts.items()}
            for path, file in _recorded(settings, runs):
                with suppress(FileNotFoundError), QuietReader(file) as reader:
                    hashes[path] = tar.add(path, reader, reader.size())  # without what is added meanwhile
            manifest = json.dumps(
                {
                    "format": FORMAT,
                    "made": now.isoformat(),
                    "since": since.isoformat(),
                    "version": __version__,
                    "log_hash": head,
                    "files": hashes,
                },
                indent=1,
            ).encode()
            signature, public = sign(settings.signing, manifest)
            for name, content in ((NAME, manifest), (SIGNATURE, signature), (PUBLIC_KEY, public)):
                tar.add_bytes(name, content)
        out.keep()
    checked = check_incident(target)
    with database.transaction(closing=True) as db:
        mark_incident(db, since, checked.hash, _patients(rows), person)
    return checked


def check_incident(file: Path, public: bytes | None = None) -> ArchivedIncident:
    """Check every hash and the signature of an archive, with the clinic's key or with the one inside.

    Raises
    ------
    Refusal
        In one sentence, when anything was changed, or when another key has signed it.
    """
    hashes: dict[str, str] = {}
    files: dict[str, bytes] = {}
    with QuietReader(file) as opened:
        for member, content in members_of(opened):
            if member.path in {NAME, SIGNATURE, PUBLIC_KEY}:
                files[member.path] = content.read(MOST_BYTES)
            else:
                _, hashes[member.path] = hash_of(content)
    if files.keys() != {NAME, SIGNATURE, PUBLIC_KEY}:
        raise Refusal(DAMAGED)
    if public is not None and fingerprint(public) != fingerprint(files[PUBLIC_KEY]):
        raise Refusal(Text("backups-incident-other-key"))
    if not is_signed(files[NAME], files[SIGNATURE], files[PUBLIC_KEY]):
        raise Refusal(Text("backups-incident-wrong-signature"))
    document: dict[str, Any] = json.loads(files[NAME])
    if document["files"] != hashes:
        wrong = sorted(
            name for name in {*hashes, *document["files"]} if hashes.get(name) != document["files"].get(name)
        )
        raise Refusal(Text("backups-incident-changed", file=wrong[0]))
    recordings = {name.split("/")[1] for name in hashes if name.startswith("recordings/")}
    return ArchivedIncident(
        made=document["made"],
        since=document["since"],
        files=len(hashes),
        recordings=len(recordings),
        hash=sha256(files[NAME]).hexdigest(),
        fingerprint=fingerprint(files[PUBLIC_KEY]),
    )


def _recorded(settings: Settings, runs: list[str]) -> Iterator[tuple[str, Path]]:
    """Yield the files of recordings; a segment that is gone when it is opened is in one yielded after.

    Of a recording that is going on, what is written by now is archived.
    """
    for run in runs:
        yielded: set[Path] = set()
        while more := sorted({*(settings.runs / run).glob("*")} - yielded):
            yielded.update(more)
            yield from ((f"recordings/{run}/{file.name}", file) for file in more)


def _patients(rows: Rows) -> list[int]:
    return sorted({row["patient_id"] for row in rows["session"]})


def _versions() -> dict[str, Any]:
    packages = {each.metadata["Name"]: each.version for each in distributions() if each.metadata["Name"]}
    return {"bodydrive": __version__, "python": platform.python_version(), "packages": dict(sorted(packages.items()))}


def _machine(settings: Settings) -> dict[str, Any]:
    facts: dict[str, Any] = {
        "system": platform.platform(),
        "processor": platform.machine(),
        "cores": os.cpu_count(),
        "load": os.getloadavg(),
        "utc": utc_now().isoformat(),
        "running_for_s": round(monotonic()),
        "disk": shutil.disk_usage(settings.state)._asdict(),
    }
    for name in ("meminfo", "cpuinfo"):
        with suppress(OSError):
            facts[name] = Path(f"/proc/{name}").read_text()
    return facts
