"""`bodydrive export`: the recordings and measures of a patient for other programs, as one zip file."""

from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.clinic_folder import open_clinic
from app.cli.errors import InputError
from app.cli.output import check_new_folder
from app.exports.forms import FORMS, Form
from app.refusals import Refusal
from app.settings import Settings, state_folder

if TYPE_CHECKING:
    from app.computing_process import ComputingProcess
    from app.exports.export_material import ExportMaterial
    from app.reports.material import SpreadsOf
    from app.scoring.verdict.spread import Spread
    from app.source import SourceGroup
    from app.store.database import Database

COMMAND = "command line"  # who did it, in the log


def export(
    patient: Annotated[str, typer.Argument(metavar="PATIENT", help="The code of the patient.")],
    out: Annotated[Path, typer.Option(metavar="FILE", help="The zip file to write.")],
    form: Annotated[str, typer.Option("--format", metavar="FORMAT", help=f"One of {', '.join(FORMS)}.")] = "csv",
    session: Annotated[
        int | None, typer.Option(metavar="N", help="The number of one session; without: all sessions.")
    ] = None,
    state: Annotated[Path | None, typer.Option(help="The folder of the clinic's database and recordings.")] = None,
) -> None:
    """Export a patient's recordings and measures; the clinic may be open meanwhile. The patient must have consented."""
    from app.exports.package import export_steps

    chosen: Form | None = next((one for one in FORMS if one == form), None)
    if chosen is None:
        raise InputError(f"--format {form}: give one of {', '.join(FORMS)}.")
    settings = Settings(state=(state or state_folder()).expanduser().resolve())
    with written_whole(out) as part:
        steps = export_steps(_material(settings, patient, session, chosen, part.parent), chosen)
        for done, step in enumerate(steps):
            if done:
                typer.echo(f"Recording {done} of {len(steps) - 1}", err=True)
            step(part)
    typer.echo(f"{out} is written.")


@contextmanager
def written_whole(out: Path) -> Iterator[Path]:
    """Yield a file beside `out` that replaces it at the end, or is removed when an error is raised."""
    check_new_folder(out.parent)
    if out.exists() and not out.is_file():
        raise InputError(f"--out {out} is no ordinary file: choose another place.")
    part = out.with_name(f".{out.name}.part")
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        yield part
        part.replace(out)
    except OSError as error:
        raise InputError(f"--out {out} cannot be written ({error.strerror or error}): choose another place.") from error
    finally:
        part.unlink(missing_ok=True)


def patient_named(database: "Database", code: str) -> tuple[int, int]:
    """Return the clinic and the id of the patient with this code."""
    from app.store.patients import all_patients
    from app.store.people import the_clinic

    with database.transaction() as db:
        clinic = the_clinic(db)
        found = [] if clinic is None else [one for one in all_patients(db, clinic.id) if one.code == code]
        if not found:
            raise InputError(f"There is no patient with the code '{code}': see the list of patients.")
        return found[0].clinic_id, found[0].id


def spreads_of_others(
    database: "Database", computing: "ComputingProcess", clinic_id: int, patient_id: int
) -> "SpreadsOf":
    """Return a function that returns the median spreads of the clinic's other patients in a task."""
    from app.session.clinic_spread import ClinicSpread, Task

    spread = ClinicSpread(database, computing)

    def spreads_of(floorplan: str, path: str, group: "SourceGroup") -> "dict[str, Spread]":
        return spread.of_others(Task(clinic_id, floorplan, path, group), patient_id)

    return spreads_of


def _material(settings: Settings, patient: str, session: int | None, form: Form, place: Path) -> "ExportMaterial":
    from app.computing_process import ComputingProcess
    from app.exports.export_material import exported_material

    with open_clinic(settings) as (database, _), closing(ComputingProcess()) as computing:
        clinic_id, patient_id = patient_named(database, patient)
        spreads_of = spreads_of_others(database, computing, clinic_id, patient_id)
        try:
            return exported_material(
                database, clinic_id, patient_id, session, form, COMMAND, settings.runs, spreads_of, place=place
            )
        except Refusal as refusal:
            raise InputError(str(refusal)) from refusal
