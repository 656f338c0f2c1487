"""`bodydrive export`: the recordings and measures of a patient for other programs, as one zip file."""

from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.clinic_folder import open_clinic
from app.cli.common_options import COMMAND_LINE, State, settings_of
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.records.written_files import patient_named, written_whole
from app.features.exports.forms import FORMS, Form
from app.refusals import Refusal
from app.settings import Settings
from app.texts import Text, text_of

if TYPE_CHECKING:
    from app.features.exports.export_material import ExportMaterial


def export(
    patient: Annotated[str, typer.Argument(metavar="PATIENT", help=help_text("cli-help-patient"))],
    out: Annotated[Path, typer.Option(metavar="FILE", help=help_text("cli-help-export-out"))],
    form: Annotated[
        str, typer.Option("--format", metavar="|".join(FORMS), help=help_text("cli-help-export-format"))
    ] = "csv",
    session: Annotated[int | None, typer.Option(metavar="N", help=help_text("cli-help-export-session"))] = None,
    state: State = None,
) -> None:
    """Export a patient's recordings and measures; the clinic may be open meanwhile. The patient must have consented."""
    from app.features.exports.service import export_steps

    chosen: Form | None = next((name for name in FORMS if name == form), None)
    if chosen is None:
        raise InputError(Text("cli-export-format", format=form, formats=", ".join(FORMS)))
    settings = settings_of(state)
    with written_whole(out) as part:
        steps = export_steps(_material(settings, patient, session, chosen, part.parent), chosen)
        for done, step in enumerate(steps):
            if done:
                typer.echo(Text("cli-export-step", done=done, total=len(steps) - 1), err=True)
            step(part)
    typer.echo(Text("cli-file-written", file=str(out)))


def _material(settings: Settings, patient: str, session: int | None, form: Form, place: Path) -> "ExportMaterial":
    from app.computing_process import ComputingProcess
    from app.features.exports.export_material import exported_material
    from app.session.clinic_spread import ClinicSpread

    with open_clinic(settings) as (database, _), closing(ComputingProcess()) as computing:
        patient_id = patient_named(database, patient)
        spreads_of = ClinicSpread(database, computing).for_patient(patient_id)
        try:
            return exported_material(
                database, patient_id, session, form, COMMAND_LINE, settings.runs, spreads_of, place=place
            )
        except Refusal as refusal:
            raise InputError(text_of(refusal)) from refusal
