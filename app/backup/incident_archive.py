"""The archive of an incident: log, recordings, parameters, versions and the machine's facts, in one signed tar file.

Its last three files are `manifest.json` (each other file with its SHA-256), `manifest.sig` (an Ed25519 signature of the
manifest) and `public-key.pem`.
"""

import json
import os
import platform
import shutil
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from datetime import timedelta
from hashlib import sha256
from importlib.metadata import distributions
from pathlib import Path
from typing import Any, Final

from app import __version__
from app.backup.manifest import MOST_BYTES, NAME
from app.backup.quiet_files import Nowhere, QuietReader, QuietWriter, copy_hashed
from app.backup.signing import fingerprint, is_signed, sign
from app.backup.tar_stream import DAMAGED, TarStream, members_of
from app.clock import monotonic, utc_now
from app.refusals import Refusal
from app.settings import Settings
from app.store.database import Database
from app.store.keeping.incident_rows import Rows, incident_rows, log_lines, newest_log_hash, sessions_since
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


def archive_incident(settings: Settings, database: Database, target: Path, person: str | None) -> ArchivedIncident:
    """Make the archive, and mark its patients as not to be erased; also while something is recorded.

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
        log, head = log_lines(db, since), newest_log_hash(db)
    runs = [row["folder"] for row in rows["run"]]
    texts = {
        "log.jsonl": log,
        "parameters.json": json.dumps(rows, indent=1),
        "versions.json": json.dumps(_versions(), indent=1),
        "machine.json": json.dumps(_machine(settings), indent=1),
    }
    with QuietWriter(target) as out:
        with TarStream(out) as tar:
            hashes = {name: tar.add_bytes(name, text.encode()) for name, text in texts.items()}
            for path, content in _recorded(settings, runs):
                hashes[path] = tar.add_bytes(path, content)
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
                _, hashes[member.path] = copy_hashed(content, Nowhere())
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


def _recorded(settings: Settings, runs: list[str]) -> Iterator[tuple[str, bytes]]:
    """Yield the files of recordings as they are now; of one that is going on, what is written by now."""
    for run in runs:
        for file in sorted((settings.runs / run).glob("*")):
            with suppress(FileNotFoundError):  # its segments became one file just now, which is yielded after them
                yield f"recordings/{run}/{file.name}", file.read_bytes()


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
