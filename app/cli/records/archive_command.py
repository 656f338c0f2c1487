"""`bodydrive archive`: a whole patient as one file, to be imported in another clinic."""

from contextlib import closing
from pathlib import Path
from typing import Annotated

import typer

from app.cli.clinic_folder import open_clinic
from app.cli.common_options import COMMAND_LINE, State, settings_of
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.records.written_files import patient_named, written_whole
from app.refusals import Refusal
from app.texts import Text, text_of

archive_app = typer.Typer(no_args_is_help=True, pretty_exceptions_enable=False)


@archive_app.command("make", help=help_text("cli-help-archive-make"))
def make(
    patient: Annotated[str, typer.Argument(metavar="PATIENT", help=help_text("cli-help-patient"))],
    out: Annotated[Path, typer.Option(metavar="FILE", help=help_text("cli-help-archive-make-out"))],
    state: State = None,
) -> None:
    """Write the archive of a patient, who must have consented; the clinic may be open meanwhile."""
    from app.computing_process import ComputingProcess
    from app.features.archive.service import make_archive
    from app.features.registration import report_for_archive
    from app.session.clinic_spread import ClinicSpread

    settings = settings_of(state)
    with written_whole(out) as part, open_clinic(settings) as (database, _), closing(ComputingProcess()) as computing:
        patient_id = patient_named(database, patient)
        spreads_of = ClinicSpread(database, computing).for_patient(patient_id)
        make_report = report_for_archive(database, settings, patient_id, spreads_of)
        try:
            digest = make_archive(database, patient_id, COMMAND_LINE, settings.runs, part, make_report)
        except Refusal as refusal:
            raise InputError(text_of(refusal)) from refusal
    typer.echo(Text("cli-archive-made", file=str(out), hash=digest))


@archive_app.command("import", help=help_text("cli-help-archive-import"))
def import_file(
    file: Annotated[Path, typer.Argument(metavar="FILE", help=help_text("cli-help-archive-import-file"))],
    replace: Annotated[bool, typer.Option("--replace", help=help_text("cli-help-archive-import-replace"))] = False,
    state: State = None,
) -> None:
    """Import an archive; the same one once more changes nothing."""
    from app.features.archive.archive_import import import_archive
    from app.store.people import the_clinic

    settings = settings_of(state)
    with open_clinic(settings) as (database, _):
        with database.reading() as db:
            clinic = the_clinic(db)
        if clinic is None:
            raise InputError(Text("cli-no-set-up", folder=str(settings.state)))
        try:
            shelf = settings.replaced if replace else None
            imported = import_archive(database, file, COMMAND_LINE, settings.runs, shelf=shelf)
        except (Refusal, ValueError) as refusal:
            raise InputError(text_of(refusal)) from refusal
    code, sessions, trials = imported.code, imported.sessions, imported.trials
    if imported.is_new:
        typer.echo(Text("cli-archive-imported", code=code, sessions=sessions, trials=trials))
    elif imported.kept:
        kept = str(settings.replaced / imported.kept)
        typer.echo(Text("cli-archive-replaced", code=code, sessions=sessions, trials=trials, file=kept))
    else:
        typer.echo(Text("cli-archive-again", code=code))
