"""`bodydrive prior`: what is known of other people in the same shirt, for those who have not been calibrated yet.

`export` and `import` take the prior of a clinic out of its folder and into one.
"""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.clinic_folder import open_clinic
from app.cli.common_options import COMMAND_LINE, AsJson, State, settings_of
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.output import write_output
from app.cli.signal_options import (
    ChannelNames,
    SampleRate,
    TimeName,
    TimeUnit,
    reading_options,
    signals_refused,
)
from app.features import names
from app.number_format import percent
from app.plain_table import table_lines
from app.settings import Settings
from app.texts import Figure, Text, text_of

if TYPE_CHECKING:
    from app.calibration.prior.documents import OwnPrior, ReleasedPeople
    from app.layout import ShirtLayout
    from app.store.database import Transaction


prior_app = typer.Typer(no_args_is_help=True, pretty_exceptions_enable=False)
PriorFile = Annotated[Path, typer.Argument(metavar="PRIOR.json", help=help_text("cli-help-prior-file"))]
Person = Annotated[str, typer.Option(help=help_text("cli-help-prior-person"))]


@prior_app.command("add", help=help_text("cli-help-prior-add"))
def add(
    prior: PriorFile,
    signals: Annotated[list[Path], typer.Argument(metavar="SIGNALS...", help=help_text("cli-help-prior-add-signals"))],
    *,
    layout: Annotated[Path, typer.Option(help=help_text("cli-help-layout"))],
    prompts: Annotated[list[Path], typer.Option(help=help_text("cli-help-prior-add-prompts"))],
    person: Person,
    start: Annotated[float | None, typer.Option("--from", help=help_text("cli-help-prior-add-from"))] = None,
    time: TimeName = None,
    unit: TimeUnit = None,
    rate: SampleRate = None,
    channels: ChannelNames = None,
    as_json: AsJson = False,
) -> None:
    """Add a person's recordings to a prior. A person who is in it already is replaced."""
    from app.calibration.prior.documents import OwnPrior
    from app.calibration.prior.entry import person_entry
    from app.calibration.prior.map_prior import PriorError, check_layout
    from app.calibration.prior.prior_file import read_prior
    from app.cli.calibration.prior_files import check_code, read_recording, write_document
    from app.signals.signals import read_layout

    check_code(person)
    options = reading_options(time, unit, rate, channels)
    if len(prompts) != len(signals):
        raise InputError(Text("cli-prior-one-table-each", recordings=len(signals), tables=len(prompts)))
    try:
        shirt = read_layout(layout)
        document = read_prior(prior) if prior.exists() else OwnPrior(layout=shirt)
        if not isinstance(document, OwnPrior):
            raise InputError(Text("cli-prior-add-to-release", prior=str(prior)))
        check_layout(document.layout, shirt)
        recordings = [
            read_recording(file, table, shirt, start, options) for file, table in zip(signals, prompts, strict=True)
        ]
        entry = person_entry(recordings)
    except PriorError as error:
        raise InputError(Text("cli-named", name=f"{prior}, {layout}", text=error)) from error
    except ValueError as error:
        raise signals_refused(error) from error
    replaced = person in document.people
    document = document.with_person(person, entry)
    write_document(prior, document, *signals, *prompts, layout)
    summary = {
        "person": person,
        "replaced": replaced,
        "people": len(document.people),
        "recordings": entry.recordings,
        "joints": {name: {"seconds": joint.seconds, "strokes": joint.strokes} for name, joint in entry.joints.items()},
        "prior": str(prior),
    }
    if as_json:
        typer.echo(json.dumps(summary))
        return
    strokes = sum(joint.strokes for joint in entry.joints.values())
    done = Text(
        "cli-prior-replaced" if replaced else "cli-prior-added",
        person=person,
        strokes=Figure(strokes),
        prior=str(prior),
        people=len(document.people),
    )
    typer.echo(done)


@prior_app.command("remove", help=help_text("cli-help-prior-remove"))
def remove(prior: PriorFile, *, person: Person) -> None:
    """Take a person out of a prior, as if this person had never been added."""
    from app.calibration.prior.documents import OwnPrior
    from app.cli.calibration.prior_files import read_document, write_document

    document = read_document(prior)
    if not isinstance(document, OwnPrior) or person not in document.people:
        raise InputError(Text("cli-prior-nobody", prior=str(prior), person=person))
    write_document(prior, document.without_person(person))
    typer.echo(Text("cli-prior-removed", person=person, prior=str(prior)))


@prior_app.command("show", help=help_text("cli-help-prior-show"))
def show(prior: PriorFile, *, as_json: AsJson = False) -> None:
    """Show per joint and gesture what a prior knows: people, seconds, strokes and their rates, ranges of channels."""
    from app.calibration.prior.documents import FEWEST_PEOPLE, OwnPrior
    from app.calibration.prior.map_prior import MapPrior
    from app.cli.calibration.expected_figures import stroke_rates
    from app.cli.calibration.prior_files import channel_ranges, read_document

    document = read_document(prior)
    pool = MapPrior.of(document)
    joints = {
        name: {
            "gesture": name,
            "people": joint.people,
            "seconds": round(joint.seconds, 1),
            "strokes": round(joint.strokes),
            "stroke_rates": stroke_rates(joint),
            "ranges": channel_ranges(document.layout, name, joint),
        }
        for name, joint in pool.joints.items()
    }
    rings = {name: round(ring.people) for name, ring in pool.rings.items()}
    people = list(document.people) if isinstance(document, OwnPrior) else document.people
    if as_json:
        facts = {"kind": document.kind, "layout": document.layout.name, "people": people}
        typer.echo(json.dumps({**facts, "joints": joints, "rings": rings}))
        return
    count = people if isinstance(people, int) else len(people)
    kind = Text(
        "cli-prior-own" if document.kind == "own" else "cli-prior-release",
        prior=str(prior),
        people=count,
        layout=document.layout.name,
    )
    typer.echo(f"{kind}\n")
    titles = [Text(f"cli-prior-column-{title}") for title in ("people", "seconds", "strokes", "rate")]
    rows: list[tuple[object, ...]] = [(Text("cli-prior-movement"), *titles, Text("cli-prior-ranges"))]
    for name, joint in pool.joints.items():
        ranges = ", ".join(
            f"{channel} {value}" for channel, value in channel_ranges(document.layout, name, joint).items()
        )
        movement = Text("cli-prior-prompted", joint=name)
        rates = stroke_rates(joint)
        speed = "-" if rates is None else f"{percent(rates['mean'])} ± {percent(rates['deviation'])}"
        rows.append((movement, joint.people, f"{joint.seconds:.0f}", f"{joint.strokes:.0f}", speed, ranges))
    typer.echo("\n".join(table_lines(rows, left=(0, len(rows[0]) - 1))))
    typer.echo(Text("cli-prior-rate-means"))
    for name, people_in_ring in rings.items():
        typer.echo(Text("cli-prior-ring", ring=name, people=people_in_ring))
    if pool.people < FEWEST_PEOPLE:
        typer.echo(Text("cli-prior-too-few", people=FEWEST_PEOPLE))


@prior_app.command("merge", help=help_text("cli-help-prior-merge", "cli-help-prior-merge-released"))
def merge(
    priors: Annotated[list[Path], typer.Argument(metavar="PRIORS...", help=help_text("cli-help-prior-merge-priors"))],
    *,
    out: Annotated[Path, typer.Option(help=help_text("cli-help-prior-merge-out"))],
    own: Annotated[bool, typer.Option("--own", help=help_text("cli-help-prior-merge-own"))] = False,
) -> None:
    """Add priors up: to a release, or to an own prior with an entry per person."""
    from app.calibration.prior.map_prior import PriorError, union_of_people
    from app.cli.calibration.prior_files import bytes_of, read_document, write_release

    documents = [read_document(file) for file in priors]
    for i, document in enumerate(documents):
        if document in documents[:i]:
            raise InputError(Text("cli-prior-twice", prior=str(priors[i])))
    try:
        if own:
            merged = union_of_people(documents)
            write_output(out, bytes_of(merged), *priors)
            typer.echo(Text("cli-prior-merged", people=len(merged.people), out=str(out)))
        else:
            write_release(priors, documents, out)
    except PriorError as error:
        raise InputError(Text("cli-named", name=", ".join(map(str, priors)), text=error)) from error


def export_prior(
    out: Annotated[Path, typer.Option(metavar="PRIOR.json", help=help_text("cli-help-prior-export-out"))],
    layout: Annotated[Path, typer.Option(help=help_text("cli-help-prior-export-layout"))],
    *,
    release: Annotated[bool, typer.Option("--release", help=help_text("cli-help-prior-export-release"))] = False,
    state: State = None,
) -> None:
    """Write what the clinic knows of patients in a worn shirt. Without --release it must not leave the clinic."""
    from app.cli.calibration.prior_files import bytes_of
    from app.signals.signals import read_layout
    from app.store.log import write_log

    settings = settings_of(state)
    try:
        shirt = read_layout(layout)
    except ValueError as error:
        raise InputError(text_of(error)) from error
    with open_clinic(settings) as (database, _):
        is_written = False
        try:
            with database.transaction() as db:
                _require_clinic(db, settings)
                own_prior = _own_prior(db, shirt, to_share=release)
                write_log(db, COMMAND_LINE, "prior exported", release=release, people=len(own_prior.people))
                if release:
                    result = _write_release(db, own_prior, out, layout)
                else:
                    write_output(out, bytes_of(own_prior), layout)
                    result = Text("cli-prior-exported", people=len(own_prior.people), out=str(out))
                is_written = True
        except BaseException:
            if is_written:  # the clinic could not store whose entries are released: there is no such release
                out.unlink(missing_ok=True)
            raise
    typer.echo(result)


def import_prior(
    prior: Annotated[Path, typer.Argument(metavar="PRIOR.json", help=help_text("cli-help-prior-import-file"))],
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

    settings = settings_of(state)
    document = read_document(prior)
    if not isinstance(document, OwnPrior):
        raise InputError(Text("cli-prior-import-release", prior=str(prior)))
    shirt = Garment(document.layout, "worn", None).hash
    with open_clinic(settings) as (database, _), database.transaction() as db:
        _require_clinic(db, settings)
        if not is_prior_on(db):
            raise InputError(Text("cli-prior-switched-off"))
        patients = {patient.code: patient for patient in all_patients(db)}
        for code in document.people:
            if code not in patients:
                raise InputError(Text("cli-prior-no-patient", prior=str(prior), code=code))
            if not may_add(db, patients[code], simulated=False):
                raise InputError(Text("cli-prior-no-consent", prior=str(prior), code=code))
        for code, entry in document.people.items():
            put_entry(db, patients[code].id, shirt, entry.model_dump(mode="json"), simulated=False)
            _mark_released(db, code, shirt, document.released)
        write_log(db, COMMAND_LINE, "prior imported", people=len(document.people))
    typer.echo(Text("cli-prior-imported", people=len(document.people), prior=str(prior)))


if "prior" in names():  # a clinic keeps one
    prior_app.command("export", help=help_text("cli-help-prior-export"))(export_prior)
    prior_app.command("import", help=help_text("cli-help-prior-import"))(import_prior)


def _own_prior(db: "Transaction", layout: "ShirtLayout", *, to_share: bool) -> "OwnPrior":
    """Return the prior of the patients who consent; InputError when there are none."""
    from app.calibration.prior.documents import OwnPrior, PersonEntry, ReleasedPeople
    from app.features.prior.entries import releases_of, without_releases, worn_entries
    from app.session.calibration.garment import Garment

    shirt = Garment(layout, "worn", None).hash
    entries = worn_entries(db, shirt, to_share=to_share)
    if not entries:
        count = len(worn_entries(db, shirt, to_share=False))
        if count:
            raise InputError(Text("cli-prior-nobody-shares", people=count, layout=layout.name))
        raise InputError(Text("cli-prior-nobody-known", layout=layout.name))
    released: dict[str, dict[str, list[str]]] = {"joints": {}, "rings": {}}
    for code, document in entries:
        for part, part_names in releases_of(document).items():
            for name in part_names:
                released[part].setdefault(name, []).append(code)
    try:
        people = {
            code: PersonEntry.model_validate(without_releases(document)).in_layout(layout) for code, document in entries
        }
        return OwnPrior(layout=layout, people=people, released=ReleasedPeople.model_validate(released))
    except ValueError as error:
        raise InputError(Text("cli-prior-code")) from error


def _write_release(db: "Transaction", own_prior: "OwnPrior", out: Path, layout: Path) -> Text:
    """Write the sums that may leave the clinic, note whose entries they hold, and return a sentence on the result."""
    from app.calibration.prior.map_prior import PriorError
    from app.calibration.prior.release import release
    from app.cli.calibration.prior_files import bytes_of
    from app.session.calibration.garment import Garment

    try:
        document, people, left_out = release([own_prior])
    except PriorError as error:
        raise InputError(Text("cli-prior-no-release", problem=error)) from error
    shirt = Garment(own_prior.layout, "worn", None).hash
    for code in own_prior.people:
        _mark_released(db, code, shirt, people)
    write_output(out, bytes_of(document), layout)
    if left_out:
        return Text("cli-prior-sums-without", people=document.people, out=str(out), names=", ".join(left_out))
    return Text("cli-prior-sums", people=document.people, out=str(out))


def _mark_released(db: "Transaction", code: str, shirt: str, released: "ReleasedPeople") -> None:
    """Note what of a person stands in releases."""
    from app.features.prior.entries import mark_released

    joints, rings = (
        [name for name, codes in part.items() if code in codes] for part in (released.joints, released.rings)
    )
    mark_released(db, code, shirt, joints, rings)


def _require_clinic(db: "Transaction", settings: Settings) -> None:
    from app.store.people import the_clinic

    if the_clinic(db) is None:
        raise InputError(Text("cli-no-set-up", folder=str(settings.state)))
