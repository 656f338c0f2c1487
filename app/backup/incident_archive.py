"""The archive of an incident: log, recordings, parameters, versions and the machine's facts, in one signed tar file.

Its last three files are `manifest.json` (each other file with its SHA-256), `manifest.sig` (an Ed25519 signature of the
manifest) and `public-key.pem`.
"""

import json
import os
import platform
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from datetime import timedelta
from hashlib import sha256
from importlib.metadata import distributions
from pathlib import Path
from typing import Any, Final

from app import __version__
from app.backup.hashed_tar import hashed_tar, members_of
from app.backup.manifest import DAMAGED, MOST_BYTES, NAME
from app.backup.quiet_files import QuietReader, QuietWriter, hash_of
from app.backup.signing import fingerprint, is_signed, sign
from app.clock import monotonic, utc_now
from app.refusals import Refusal
from app.settings import Settings
from app.store.database import Database
from app.store.keeping.incident_rows import Rows, incident_rows, log_lines, newest_log_row, sessions_since
from app.store.keeping.incidents import mark_incident

PERIOD: Final = timedelta(hours=24)
SIGNATURE, PUBLIC_KEY = "manifest.sig", "public-key.pem"
FORMAT: Final = 1


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
        raise Refusal(f"There is a file {target} already: choose another name.")
    now = utc_now()
    since = now - PERIOD
    with database.transaction() as db:
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
    found = check_incident(target)
    with database.transaction(closing=True) as db:
        mark_incident(db, rows["clinic"][0]["id"], since, found.hash, _patients(rows), person)
    return found


def check_incident(file: Path, public: bytes | None = None) -> ArchivedIncident:
    """Check every hash and the signature of an archive, with the clinic's key or with the one inside.

    Raises
    ------
    Refusal
        In one sentence, when anything was changed, or when another key has signed it.
    """
    hashes: dict[str, str] = {}
    own: dict[str, bytes] = {}
    with QuietReader(file) as opened:
        for member, content in members_of(opened):
            if member.path in {NAME, SIGNATURE, PUBLIC_KEY}:
                own[member.path] = content.read(MOST_BYTES)
            else:
                _, hashes[member.path] = hash_of(content)
    if own.keys() != {NAME, SIGNATURE, PUBLIC_KEY}:
        raise Refusal(DAMAGED)
    if public is not None and fingerprint(public) != fingerprint(own[PUBLIC_KEY]):
        raise Refusal("Another key than the given one has signed this archive: ask where it comes from.")
    if not is_signed(own[NAME], own[SIGNATURE], own[PUBLIC_KEY]):
        raise Refusal("The signature of this archive is wrong: it was changed after it was made.")
    document: dict[str, Any] = json.loads(own[NAME])
    if document["files"] != hashes:
        wrong = sorted(
            name for name in {*hashes, *document["files"]} if hashes.get(name) != document["files"].get(name)
        )
        raise Refusal(f"{wrong[0]} in this archive was changed, or is missing.")
    recordings = {name.split("/")[1] for name in hashes if name.startswith("recordings/")}
    return ArchivedIncident(
        made=document["made"],
        since=document["since"],
        files=len(hashes),
        recordings=len(recordings),
        hash=sha256(own[NAME]).hexdigest(),
        fingerprint=fingerprint(own[PUBLIC_KEY]),
    )


def _recorded(settings: Settings, runs: list[str]) -> Iterator[tuple[str, Path]]:
    """Yield the files of recordings; a segment that is gone when it is opened is in one yielded after.

    Of a recording that is going on, what is written by now is archived.
    """
    for run in runs:
        known: set[Path] = set()
        while more := sorted({*(settings.runs / run).glob("*")} - known):
            known.update(more)
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
