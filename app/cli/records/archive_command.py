"""`bodydrive archive`: a whole patient as one file, to be imported in another clinic."""

from contextlib import closing
from pathlib import Path
from typing import Annotated

import typer

from app.cli.clinic_folder import open_clinic
from app.cli.errors import InputError
from app.cli.records.written_files import COMMAND, patient_named, written_whole
from app.refusals import Refusal
from app.settings import Settings, state_folder

archive_app = typer.Typer(
    help="Take a whole patient to another clinic: sessions, controls, trials, recordings.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
)

State = Annotated[Path | None, typer.Option(help="The folder of the clinic's database and recordings.")]


@archive_app.command("make")
def make(
    patient: Annotated[str, typer.Argument(metavar="PATIENT", help="The code of the patient.")],
    out: Annotated[Path, typer.Option(metavar="FILE", help="The archive to write.")],
    state: State = None,
) -> None:
    """Write the archive of a patient, who must have consented; the clinic may be open meanwhile."""
    from app.computing_process import ComputingProcess
    from app.features.archive.service import make_archive
    from app.features.registration import report_for_archive
    from app.session.clinic_spread import ClinicSpread

    settings = Settings(state=(state or state_folder()).expanduser().resolve())
    with written_whole(out) as part, open_clinic(settings) as (database, _), closing(ComputingProcess()) as computing:
        clinic_id, patient_id = patient_named(database, patient)
        spreads_of = ClinicSpread(database, computing).for_patient(clinic_id, patient_id)
        make_report = report_for_archive(database, settings, clinic_id, patient_id, spreads_of)
        try:
            digest = make_archive(database, clinic_id, patient_id, COMMAND, settings.runs, part, make_report)
        except Refusal as refusal:
            raise InputError(str(refusal)) from refusal
    typer.echo(f"{out} is written. Its hash is {digest}.")


@archive_app.command("import")
def import_file(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="The archive.")],
    replace: Annotated[
        bool, typer.Option("--replace", help="Replace the patient who is here; first an archive of it is kept.")
    ] = False,
    state: State = None,
) -> None:
    """Import an archive; the same one once more changes nothing."""
    from app.features.archive.archive_import import import_archive
    from app.store.people import the_clinic

    settings = Settings(state=(state or state_folder()).expanduser().resolve())
    with open_clinic(settings) as (database, _):
        with database.transaction() as db:
            clinic = the_clinic(db)
        if clinic is None:
            raise InputError(f"The clinic in {settings.state} is not set up yet: open its pages first.")
        try:
            shelf = settings.replaced if replace else None
            found = import_archive(database, clinic.id, file, COMMAND, settings.runs, shelf=shelf)
        except (Refusal, ValueError) as refusal:
            raise InputError(str(refusal)) from refusal
    counts = f"Sessions: {found.sessions}. Finished and kept trials: {found.trials}."
    if found.is_new:
        words = f"The patient {found.code} is imported. {counts}"
    elif found.kept:
        kept = settings.replaced / found.kept
        words = f"The patient {found.code} is replaced. {counts} The patient as it was is kept for 30 days in {kept}."
    else:
        words = f"The patient {found.code} was imported from this archive before: nothing was changed."
    typer.echo(words)
