"""`bodydrive report`: the report of a session, or of a patient's course of sessions, as PDF or HTML."""

from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.clinic_folder import open_clinic
from app.cli.common_options import COMMAND_LINE, State, settings_of
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.output import check_new_folder, write_output
from app.cli.records.written_files import patient_named
from app.refusals import Conflict, Refusal
from app.texts import LANGUAGES, Text, current_language, text_of

if TYPE_CHECKING:
    from app.features.reports.document import Form


def report(
    patient: Annotated[str, typer.Argument(metavar="PATIENT", help=help_text("cli-help-patient"))],
    out: Annotated[Path, typer.Option(metavar="FILE", help=help_text("cli-help-report-out"))],
    session: Annotated[int | None, typer.Option(metavar="N", help=help_text("cli-help-report-session"))] = None,
    letter: Annotated[bool, typer.Option("--letter", help=help_text("cli-help-report-letter"))] = False,
    for_patient: Annotated[bool, typer.Option("--for-patient", help=help_text("cli-help-report-for-patient"))] = False,
    language: Annotated[
        str | None, typer.Option(metavar="|".join(LANGUAGES), help=help_text("cli-help-report-language"))
    ] = None,
    state: State = None,
) -> None:
    """Write the report of a patient's session, or of all sessions; the clinic may be open meanwhile."""
    from app.computing_process import ComputingProcess
    from app.features.reports.composition import report_file
    from app.features.reports.service import Subject, exported_material
    from app.session.clinic_spread import ClinicSpread

    form = _form_of(out)
    if language is not None and language not in LANGUAGES:
        raise InputError(Text("report-no-language", language=language, languages=", ".join(LANGUAGES)))
    check_new_folder(out.parent)
    settings = settings_of(state)
    with open_clinic(settings) as (database, _), closing(ComputingProcess()) as computing:
        patient_id = patient_named(database, patient)
        subject = Subject(patient_id, session)
        spreads_of = ClinicSpread(database, computing).for_patient(patient_id)
        try:
            material = exported_material(
                database, settings, subject, form, COMMAND_LINE, spreads_of, for_patient=for_patient
            )
        except Conflict as refusal:
            raise InputError(Text("cli-report-for-patient", problem=refusal)) from refusal
        except Refusal as refusal:
            raise InputError(text_of(refusal)) from refusal
    write_output(out, report_file(material, form, "us-letter" if letter else "a4", language or current_language()))
    typer.echo(Text("cli-file-written", file=str(out)))


def _form_of(out: Path) -> "Form":
    suffix = out.suffix.lower()
    if suffix == ".pdf":
        return "pdf"
    if suffix == ".html":
        return "html"
    raise InputError(Text("cli-report-suffix", file=str(out)))
