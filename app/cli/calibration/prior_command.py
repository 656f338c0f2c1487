"""`bodydrive prior`: what is known of other people in the same shirt, for those who have not been calibrated yet."""

import json
import math
from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from pydantic import TypeAdapter

from app.calibration.prior.documents import FEWEST_PEOPLE, OwnPrior, PriorDocument
from app.calibration.prior.entry import PersonRecording, person_entry
from app.calibration.prior.map_prior import JointPrior, MapPrior, PriorError, check_layout, united
from app.calibration.prior.prior_file import read_prior
from app.calibration.prior.release import release
from app.cli.calibration.prior_summary import prompted_stretches
from app.cli.errors import InputError
from app.cli.output import warn, write_output
from app.files import write_atomically
from app.layout import ShirtLayout
from app.quantities import Name
from app.signals.signals import read_layout, read_signals

prior_app = typer.Typer(
    help="Learn from other people in the same shirt, so that somebody new drives before being calibrated.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
)

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
    _check_code(person)
    if len(prompts) != len(signals):
        raise InputError(f"there are {len(signals)} recordings and {len(prompts)} tables of prompts: give one for each")
    try:
        shirt = read_layout(layout)
        document = read_prior(prior) if prior.exists() else OwnPrior(layout=shirt)
        if not isinstance(document, OwnPrior):
            raise InputError(f"{prior} is a release, which holds sums over people: add to the clinic's own prior")
        check_layout(document.layout, shirt)
        recordings = [_recording(file, table, shirt, start) for file, table in zip(signals, prompts, strict=True)]
        entry = person_entry(shirt, recordings)
    except PriorError as error:
        raise InputError(f"{prior}, {layout}: {error}") from error
    except ValueError as error:
        raise InputError(str(error)) from error
    replaced = person in document.people
    document = document.with_person(person, entry)
    _write(prior, document, *signals, *prompts, layout)
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
    document = _read(prior)
    if not isinstance(document, OwnPrior) or person not in document.people:
        raise InputError(f"{prior}: there is no person '{person}' in it")
    _write(prior, document.without_person(person))
    typer.echo(f"{person} removed from {prior}")


@prior_app.command("show")
def show(prior: PriorFile, *, as_json: AsJson = False) -> None:
    """Show per joint and gesture how many people, seconds and strokes a prior knows, and how far channels move."""
    document = _read(prior)
    pool = MapPrior.of(document)
    joints = {
        name: {
            "gesture": name,
            "people": joint.people,
            "seconds": round(joint.seconds, 1),
            "strokes": round(joint.strokes),
            "ranges": _ranges(document.layout, name, joint),
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
    typer.echo(f"{'joint and gesture':{width + 12}}  people  seconds  strokes  ranges of the channels, signal units")
    for name, joint in pool.joints.items():
        ranges = ", ".join(f"{channel} {value}" for channel, value in _ranges(document.layout, name, joint).items())
        words = f"{name}, prompted"
        typer.echo(f"{words:{width + 12}}  {joint.people:>6}  {joint.seconds:>7.0f}  {joint.strokes:>7.0f}  {ranges}")
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
    people who are new are released, and releases are added up.
    """
    documents = [_read(file) for file in priors]
    for i, document in enumerate(documents):
        if document in documents[:i]:
            raise InputError(f"{priors[i]} stands there twice: name each prior once")
    try:
        if own:
            merged = united(documents)
            write_output(out, _bytes(merged), *priors)
            count = len(merged.people)
            typer.echo(f"{count} {'person' if count == 1 else 'people'} in {out}")
        else:
            _release(priors, documents, out)
    except PriorError as error:
        raise InputError(f"{', '.join(map(str, priors))}: {error}") from error


def _release(priors: list[Path], documents: list[PriorDocument], out: Path) -> None:
    """Write a release, and into each own prior who is in it; there is no release that an own prior does not know."""
    released, people, left_out = release(documents)
    write_output(out, _bytes(released), *priors)
    try:
        for file, document in zip(priors, documents, strict=True):
            if isinstance(document, OwnPrior):
                _write(file, document.with_released(people))
    except InputError:
        out.unlink()
        raise
    typer.echo(f"{released.people} people in {out}")
    if left_out:
        typer.echo(f"Not in it, because fewer than eight people are in no release yet: {', '.join(left_out)}")


def _recording(file: Path, table: Path, shirt: ShirtLayout, start: float | None) -> PersonRecording:
    recorded = read_signals(file, shirt)
    warn(recorded.damage)
    stretches = prompted_stretches(recorded, table, shirt)
    free = recorded.values[recorded.between(start, None)]
    return PersonRecording(recorded.sample_rate, np.asarray(free, np.float64), stretches)


def _read(file: Path) -> PriorDocument:
    try:
        return read_prior(file)
    except ValueError as error:
        raise InputError(str(error)) from error


def _write(file: Path, document: PriorDocument, *sources: Path) -> None:
    if any(file.exists() and source.exists() and file.samefile(source) for source in sources):
        raise InputError(f"{file} is a file that was read for this: give the prior another name")
    try:
        write_atomically(file, _bytes(document))
    except OSError as error:
        raise InputError(f"{file} cannot be written ({error.strerror}): choose another place") from error


def _bytes(document: PriorDocument) -> bytes:
    return (document.model_dump_json() + "\n").encode()


def _check_code(person: str) -> None:
    try:
        TypeAdapter(Name).validate_python(person)
    except ValueError as error:
        raise InputError(f"--person {person}: give 1 to 64 letters, digits, dots or dashes") from error


def _ranges(layout: ShirtLayout, joint: str, known: JointPrior) -> dict[str, float | None]:
    """Return the usual range of each channel in signal units; None for a channel that nobody could use."""
    names = [layout.channel_names[i] for i in layout.channels_of_joint[joint]]
    logs = known.expected.tolist()
    return {
        name: None if math.isnan(log) else float(f"{math.exp(log):.4g}") for name, log in zip(names, logs, strict=True)
    }
