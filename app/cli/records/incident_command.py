"""`bodydrive incident`: freeze what was recorded in the last 24 hours in one signed archive; check such an archive."""

import json
from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from app.cli.clinic_folder import open_clinic
from app.cli.common_options import COMMAND_LINE, AsJson, State, settings_of
from app.cli.errors import InputError
from app.refusals import Refusal


def incident(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="The archive to make, or with --check to read.")],
    check: Annotated[
        bool, typer.Option("--check", help="Make none: check every hash and the signature of the archive FILE.")
    ] = False,
    public: Annotated[
        Path | None,
        typer.Option("--public-key", help="With --check: the clinic's public key (PEM), not the one inside."),
    ] = None,
    state: State = None,
    as_json: AsJson = False,
) -> None:
    """Archive log, recordings, parameters and versions of the last 24 hours, signed, and mark them as to be kept."""
    from app import realtime
    from app.features.backup.incident_archive import archive_incident, check_incident

    if public is not None and not check:
        raise InputError("--public-key belongs to --check: leave it out, or check an archive.")
    settings = settings_of(state)
    try:
        if check:
            archive = check_incident(file, None if public is None else public.read_bytes())
        else:
            if not file.absolute().parent.is_dir():
                raise InputError(f"There is no folder {file.absolute().parent}: make it, or choose another place.")
            with open_clinic(settings) as (database, _):
                archive = archive_incident(
                    settings, database, file.absolute(), COMMAND_LINE, realtime.take_lowest_priority
                )
    except Refusal as refusal:
        raise InputError(str(refusal)) from refusal
    if as_json:
        typer.echo(json.dumps(asdict(archive)))
        return
    contents = (
        f"{archive.files} files, {archive.recordings} recordings, from {archive.since[:16]} to {archive.made[:16]} UTC"
    )
    typer.echo(f"{file.name}: {contents}. Every hash and the signature are right.")
    typer.echo(f"Hash of the manifest: {archive.hash}\nFingerprint of the key: {archive.fingerprint}")
    if not check:
        typer.echo("Patients of these sessions are not erased before an owner lifts the mark (page Backup).")
