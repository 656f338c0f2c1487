"""`bodydrive prior`: what is known of other people in the same shirt, for those who have not been calibrated yet."""

import json
from pathlib import Path
from typing import Annotated

import typer

from app.cli.calibration.prior_of_clinic import export_prior, import_prior
from app.cli.errors import InputError
from app.cli.output import write_output
from app.features import names
from app.number_words import percent

prior_app = typer.Typer(
    help="Learn from other people in the same shirt, so that somebody new drives before being calibrated.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
)
if "prior" in names():  # a clinic keeps one
    prior_app.command("export")(export_prior)
    prior_app.command("import")(import_prior)

PriorFile = Annotated[Path, typer.Argument(metavar="PRIOR.json", help="The prior; it is made when there is none.")]
Person = Annotated[str, typer.Option(help="A code for the person: letters, digits, dots and dashes, no name.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")]


@prior_app.command("add")
def add(
    prior: PriorFile,
    signals: Annotated[
        list[Path],
        typer.Argument(
            metavar="SIGNALS...", help="CSV, Parquet or a recording's folder; all recordings of the person."
        ),
    ],
    *,
    layout: Annotated[Path, typer.Option(help="The shirt's layout, JSON.")],
    prompts: Annotated[
        list[Path],
        typer.Option(help="CSV start,end,joint: when which joint moved towards its gesture. One for each of SIGNALS."),
    ],
    person: Person,
    start: Annotated[float | None, typer.Option("--from", help="Where ten seconds of free movement begin, s.")] = None,
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
    if len(prompts) != len(signals):
        raise InputError(f"there are {len(signals)} recordings and {len(prompts)} tables of prompts: give one for each")
    try:
        shirt = read_layout(layout)
        document = read_prior(prior) if prior.exists() else OwnPrior(layout=shirt)
        if not isinstance(document, OwnPrior):
            raise InputError(f"{prior} is a release, which holds sums over people: add to the clinic's own prior")
        check_layout(document.layout, shirt)
        recordings = [read_recording(file, table, shirt, start) for file, table in zip(signals, prompts, strict=True)]
        entry = person_entry(recordings)
    except PriorError as error:
        raise InputError(f"{prior}, {layout}: {error}") from error
    except ValueError as error:
        raise InputError(str(error)) from error
    replaced = person in document.people
    document = document.with_person(person, entry)
    write_document(prior, document, *signals, *prompts, layout)
    summary = {
        "person": person,
        "replaced": replaced,
        "people": len(document.people),
        "recordings": entry.recordings,
        "joints": {name: {"seconds": one.seconds, "strokes": one.strokes} for name, one in entry.joints.items()},
        "prior": str(prior),
    }
    if as_json:
        typer.echo(json.dumps(summary))
        return
    strokes = sum(one.strokes for one in entry.joints.values())
    typer.echo(
        f"{person} {'replaced' if replaced else 'added'} with {strokes:.0f} strokes in {prior}, "
        f"which now holds {len(document.people)} {'person' if len(document.people) == 1 else 'people'}"
    )


@prior_app.command("remove")
def remove(prior: PriorFile, *, person: Person) -> None:
    """Take a person out of a prior, as if this person had never been added."""
    from app.calibration.prior.documents import OwnPrior
    from app.cli.calibration.prior_files import read_document, write_document

    document = read_document(prior)
    if not isinstance(document, OwnPrior) or person not in document.people:
        raise InputError(f"{prior}: there is no person '{person}' in it")
    write_document(prior, document.without_person(person))
    typer.echo(f"{person} removed from {prior}")


@prior_app.command("show")
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
    kind = "own prior, an entry per person" if document.kind == "own" else "release, sums only"
    typer.echo(f"{prior}: {kind}, {count} people in '{document.layout.name}'\n")
    width = max((len(name) for name in joints), default=5)
    head = "people  seconds  strokes  rate of strokes  ranges of the channels, signal units"
    typer.echo(f"{'joint and gesture':{width + 12}}  {head}")
    for name, joint in pool.joints.items():
        ranges = ", ".join(
            f"{channel} {value}" for channel, value in channel_ranges(document.layout, name, joint).items()
        )
        words = f"{name}, prompted"
        rates = stroke_rates(joint)
        speed = "-" if rates is None else f"{percent(rates['mean'])} ± {percent(rates['deviation'])}"
        figures = f"{joint.people:>6}  {joint.seconds:>7.0f}  {joint.strokes:>7.0f}  {speed:>15}"
        typer.echo(f"{words:{width + 12}}  {figures}  {ranges}")
    typer.echo("Rate of strokes: mean and deviation in a movement, as shares of the rate that counts as full")
    for name, known in rings.items():
        typer.echo(f"Ring {name}: how it sits is known of {known} people")
    if pool.people < FEWEST_PEOPLE:
        typer.echo(f"Too few to drive with: {FEWEST_PEOPLE} people are needed for a joint")


@prior_app.command("merge")
def merge(
    priors: Annotated[list[Path], typer.Argument(metavar="PRIORS...", help="Own priors or releases.")],
    *,
    out: Annotated[Path, typer.Option(help="Where the result goes: a .json file.")],
    own: Annotated[
        bool, typer.Option("--own", help="Keep an entry per person. The result must not leave the clinic.")
    ] = False,
) -> None:
    """Add priors up. The result holds sums over eight people or more, and nobody's entry: it may leave the clinic.

    An own prior keeps who was released, because nobody may be in two releases: of a prior that has grown, only the
    people who are new are released, and releases are added up. The files of the own priors that are released are
    written again for that.
    """
    from app.calibration.prior.map_prior import PriorError, union_of_people
    from app.cli.calibration.prior_files import bytes_of, read_document, write_release

    documents = [read_document(file) for file in priors]
    for i, document in enumerate(documents):
        if document in documents[:i]:
            raise InputError(f"{priors[i]} stands there twice: name each prior once")
    try:
        if own:
            merged = union_of_people(documents)
            write_output(out, bytes_of(merged), *priors)
            count = len(merged.people)
            typer.echo(f"{count} {'person' if count == 1 else 'people'} in {out}")
        else:
            write_release(priors, documents, out)
    except PriorError as error:
        raise InputError(f"{', '.join(map(str, priors))}: {error}") from error
