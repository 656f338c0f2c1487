"""`bodydrive prior export` and `import`: the prior of a clinic, out of its folder and into one."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.clinic_folder import open_clinic
from app.cli.errors import InputError
from app.cli.output import write_output
from app.settings import Settings, state_folder

if TYPE_CHECKING:
    from app.calibration.prior.documents import OwnPrior, ReleasedPeople
    from app.layout import ShirtLayout
    from app.store.database import Transaction
    from app.store.tables import Clinic

COMMAND = "command line"  # who did it, in the log
State = Annotated[Path | None, typer.Option(help="The folder of the clinic's database and recordings.")]


def export_prior(
    out: Annotated[Path, typer.Option(metavar="PRIOR.json", help="Where the prior goes.")],
    layout: Annotated[Path, typer.Option(help="The layout of the worn shirt, JSON.")],
    *,
    release: Annotated[
        bool, typer.Option("--release", help="Only sums over eight people or more, all of whom consent to sharing.")
    ] = False,
    state: State = None,
) -> None:
    """Write what the clinic knows of patients in a worn shirt. Without --release it must not leave the clinic."""
    from app.cli.calibration.prior_files import bytes_of
    from app.signals.signals import read_layout
    from app.store.log import write_log

    settings = _settings(state)
    try:
        shirt = read_layout(layout)
    except ValueError as error:
        raise InputError(str(error)) from error
    with open_clinic(settings) as (database, _):
        is_written = False
        try:
            with database.transaction() as db:
                clinic = _clinic(db, settings)
                own = _own_prior(db, clinic, shirt, to_share=release)
                write_log(db, COMMAND, "prior exported", release=release, people=len(own.people))
                if release:
                    words = _write_release(db, clinic, own, out, layout)
                else:
                    write_output(out, bytes_of(own), layout)
                    words = f"{_people(len(own.people))} in {out}, with an entry each: it must not leave the clinic."
                is_written = True
        except BaseException:
            if is_written:  # the clinic could not store whose entries are released: there is no such release
                out.unlink(missing_ok=True)
            raise
    typer.echo(words)


def import_prior(
    prior: Annotated[Path, typer.Argument(metavar="PRIOR.json", help="A clinic's own prior, as `export` writes it.")],
    *,
    state: State = None,
) -> None:
    """Take over a clinic's own prior: for all of its people, or for nobody. What is known of them is replaced."""
    from app.calibration.prior.documents import OwnPrior
    from app.cli.calibration.prior_files import read_document
    from app.features.prior.entries import is_prior_on, may_add, put_entry
    from app.session.calibration.garment import Garment
    from app.store.log import write_log
    from app.store.patients import all_patients

    settings = _settings(state)
    document = read_document(prior)
    if not isinstance(document, OwnPrior):
        raise InputError(
            f"{prior} is a release, which holds sums and no entries of people: use it with `calibrate --prior`, and "
            f"import the clinic's own prior"
        )
    shirt = Garment(document.layout, False, None).hash
    with open_clinic(settings) as (database, _), database.transaction() as db:
        clinic = _clinic(db, settings)
        if not is_prior_on(db, clinic.id):
            raise InputError("The clinic has switched off that calibrations help later patients: see Settings")
        patients = {patient.code: patient for patient in all_patients(db, clinic.id)}
        for code in document.people:
            if code not in patients:
                raise InputError(f"{prior}: there is no patient '{code}' in the clinic; nobody was imported")
            if not may_add(db, patients[code], simulated=False):
                raise InputError(
                    f"{prior}: the patient '{code}' has not consented to “Use for other patients of the clinic”; "
                    f"nobody was imported"
                )
        for code, entry in document.people.items():
            put_entry(db, patients[code].id, shirt, entry.model_dump(mode="json"), simulated=False)
            _mark_released(db, clinic, code, shirt, document.released)
        write_log(db, COMMAND, "prior imported", people=len(document.people))
    typer.echo(f"{_people(len(document.people))} imported from {prior}")


def _own_prior(db: "Transaction", clinic: "Clinic", layout: "ShirtLayout", *, to_share: bool) -> "OwnPrior":
    """Return the prior of the patients who consent; InputError when there are none."""
    from app.calibration.prior.documents import OwnPrior, PersonEntry, ReleasedPeople
    from app.features.prior.entries import releases_of, without_releases, worn_entries
    from app.session.calibration.garment import Garment

    shirt = Garment(layout, False, None).hash
    found = worn_entries(db, clinic.id, shirt, to_share=to_share)
    if not found:
        known = len(worn_entries(db, clinic.id, shirt, to_share=False))
        if known:
            raise InputError(
                f"Nobody of the {_people(known)} known in '{layout.name}' has consented to “Sharing outside of the "
                f"clinic”: ask them, and note it on the page of the patient"
            )
        raise InputError(
            f"Nobody is known in '{layout.name}': calibrate patients in it who have consented to “Use for other "
            f"patients of the clinic”"
        )
    released: dict[str, dict[str, list[str]]] = {"joints": {}, "rings": {}}
    for code, document in found:
        for part, names in releases_of(document).items():
            for name in names:
                released[part].setdefault(name, []).append(code)
    try:
        people = {
            code: PersonEntry.model_validate(without_releases(document)).in_layout(layout) for code, document in found
        }
        return OwnPrior(layout=layout, people=people, released=ReleasedPeople.model_validate(released))
    except ValueError as error:
        raise InputError(
            "A patient's code has characters that a prior cannot name: use letters, digits, dots and dashes only"
        ) from error


def _write_release(db: "Transaction", clinic: "Clinic", own: "OwnPrior", out: Path, layout: Path) -> str:
    """Write the sums that may leave the clinic, note whose entries they hold, and return what was done in words."""
    from app.calibration.prior.map_prior import PriorError
    from app.calibration.prior.release import release
    from app.cli.calibration.prior_files import bytes_of
    from app.session.calibration.garment import Garment

    try:
        document, people, left_out = release([own])
    except PriorError as error:
        raise InputError(f"Of those who have consented to “Sharing outside”: {error}") from error
    shirt = Garment(own.layout, False, None).hash
    for code in own.people:
        _mark_released(db, clinic, code, shirt, people)
    write_output(out, bytes_of(document), layout)
    words = f"{_people(document.people)} in {out}: sums only, which may leave the clinic."
    if left_out:
        words += f" Not in it, because fewer than eight people are in no release yet: {', '.join(left_out)}."
    return words


def _mark_released(db: "Transaction", clinic: "Clinic", code: str, shirt: str, released: "ReleasedPeople") -> None:
    """Note what of a person stands in releases."""
    from app.features.prior.entries import mark_released

    joints, rings = (
        [name for name, codes in part.items() if code in codes] for part in (released.joints, released.rings)
    )
    mark_released(db, clinic.id, code, shirt, joints, rings)


def _clinic(db: "Transaction", settings: Settings) -> "Clinic":
    from app.store.people import the_clinic

    clinic = the_clinic(db)
    if clinic is None:
        raise InputError(f"The clinic in {settings.state} is not set up yet: open its pages first.")
    return clinic


def _people(count: int) -> str:
    return f"{count} {'person' if count == 1 else 'people'}"


def _settings(state: Path | None) -> Settings:
    return Settings(state=(state or state_folder()).expanduser().resolve())
