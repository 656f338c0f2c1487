"""`bodydrive incident`: freeze what was recorded in the last 24 hours in one signed archive; check such an archive."""

import json
from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from app.cli.clinic_folder import open_clinic
from app.cli.common_options import COMMAND_LINE, AsJson, State, settings_of
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.records.written_files import utc_time
from app.refusals import Refusal
from app.texts import Text, text_of


def incident(
    file: Annotated[Path, typer.Argument(metavar="FILE", help=help_text("cli-help-incident-file"))],
    check: Annotated[bool, typer.Option("--check", help=help_text("cli-help-incident-check"))] = False,
    public: Annotated[Path | None, typer.Option("--public-key", help=help_text("cli-help-incident-public-key"))] = None,
    state: State = None,
    as_json: AsJson = False,
) -> None:
    """Archive log, recordings, parameters and versions of the last 24 hours, signed, and mark them as to be kept."""
    from app import realtime
    from app.features.backup.incident_archive import archive_incident, check_incident

    if public is not None and not check:
        raise InputError(Text("cli-incident-key"))
    settings = settings_of(state)
    try:
        if check:
            archive = check_incident(file, None if public is None else public.read_bytes())
        else:
            folder = file.absolute().parent
            if not folder.is_dir():
                raise InputError(Text("cli-incident-no-folder", folder=str(folder)))
            with open_clinic(settings) as (database, _):
                archive = archive_incident(
                    settings, database, file.absolute(), COMMAND_LINE, realtime.take_lowest_priority
                )
    except Refusal as refusal:
        raise InputError(text_of(refusal)) from refusal
    if as_json:
        typer.echo(json.dumps(asdict(archive)))
        return
    right = Text(
        "cli-incident-right",
        name=file.name,
        files=archive.files,
        recordings=archive.recordings,
        start=utc_time(archive.since),
        end=utc_time(archive.made),
    )
    typer.echo(right)
    typer.echo(Text("cli-incident-hash", hash=archive.hash))
    typer.echo(Text("cli-incident-fingerprint", fingerprint=archive.fingerprint))
    if not check:
        typer.echo(Text("cli-incident-kept"))
