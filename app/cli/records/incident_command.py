"""`bodydrive incident`: freeze what was recorded in the last 24 hours in one signed archive; check such an archive."""

import json
from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from app.cli.clinic_folder import open_clinic
from app.cli.errors import InputError
from app.refusals import Refusal
from app.settings import Settings, state_folder

COMMAND = "command line"  # who did it, in the log


def incident(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="The archive to make, or with --check to read.")],
    check: Annotated[
        bool, typer.Option("--check", help="Make none: check every hash and the signature of the archive FILE.")
    ] = False,
    public: Annotated[
        Path | None,
        typer.Option("--public-key", help="With --check: the clinic's public key (PEM), not the one inside."),
    ] = None,
    state: Annotated[Path | None, typer.Option(help="The folder of the clinic's database and recordings.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")] = False,
) -> None:
    """Archive log, recordings, parameters and versions of the last 24 hours, signed, and mark them as to be kept."""
    from app import realtime
    from app.features.backup.incident_archive import archive_incident, check_incident

    if public is not None and not check:
        raise InputError("--public-key belongs to --check: leave it out, or check an archive.")
    settings = Settings(state=(state or state_folder()).expanduser().resolve())
    try:
        if check:
            found = check_incident(file, None if public is None else public.read_bytes())
        else:
            if not file.absolute().parent.is_dir():
                raise InputError(f"There is no folder {file.absolute().parent}: make it, or choose another place.")
            with open_clinic(settings) as (database, _):
                found = archive_incident(settings, database, file.absolute(), COMMAND, realtime.take_lowest_priority)
    except Refusal as refusal:
        raise InputError(str(refusal)) from refusal
    if as_json:
        typer.echo(json.dumps(asdict(found)))
        return
    what = f"{found.files} files, {found.recordings} recordings, from {found.since[:16]} to {found.made[:16]} UTC"
    typer.echo(f"{file.name}: {what}. Every hash and the signature are right.")
    typer.echo(f"Hash of the manifest: {found.hash}\nFingerprint of the key: {found.fingerprint}")
    if not check:
        typer.echo("Patients of these sessions are not erased before an owner lifts the mark (page Backup).")
