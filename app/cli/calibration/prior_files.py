"""The files of `bodydrive prior`: priors are read, written and released, recordings of a person are read."""

import math
from pathlib import Path

import typer
from pydantic import TypeAdapter

from app.calibration.clean_recording import CleanRecording
from app.calibration.prior.documents import OwnPrior, PriorDocument
from app.calibration.prior.map_prior import JointPrior
from app.calibration.prior.prior_file import read_prior
from app.calibration.prior.release import release
from app.calibration.prompts_file import read_prompts
from app.cli.calibration.file_fit import prompted_stretches
from app.cli.errors import InputError
from app.cli.output import warn, write_output
from app.files import write_atomically
from app.layout import ShirtLayout
from app.quantities import Name
from app.signals.signals import ReadingOptions, read_signals
from app.texts import Text, text_of


def write_release(priors: list[Path], documents: list[PriorDocument], out: Path) -> None:
    """Write a release, and into each own prior who is in it; there is no release that an own prior does not know."""
    released, people, left_out = release(documents)
    write_output(out, bytes_of(released), *priors)
    try:
        for file, document in zip(priors, documents, strict=True):
            if isinstance(document, OwnPrior):
                write_document(file, document.with_released(people))
    except InputError:
        out.unlink()
        raise
    typer.echo(Text("cli-prior-released", people=released.people, out=str(out)))
    if left_out:
        typer.echo(Text("cli-prior-left-out", names=", ".join(left_out)))


def read_recording(
    file: Path, table: Path, shirt: ShirtLayout, start: float | None, options: ReadingOptions
) -> CleanRecording:
    """Return the recording of a person with the stretches of its prompts; free movement begins at `start` (s)."""
    recorded = read_signals(file, shirt, options)
    warn(recorded.damage)
    stretches = prompted_stretches(recorded, read_prompts(table, shirt, float(recorded.t[0]), float(recorded.t[-1])))
    free = recorded.values[recorded.between(start, None)]
    return CleanRecording.of(shirt, recorded.sample_rate, free, stretches=stretches)


def read_document(file: Path) -> PriorDocument:
    """Return the prior in `file`, or raise InputError."""
    try:
        return read_prior(file)
    except ValueError as error:
        raise InputError(text_of(error)) from error


def write_document(file: Path, document: PriorDocument, *sources: Path) -> None:
    """Write `document` to `file`, completely or not at all; `sources` are the files that it was made of."""
    if any(file.exists() and source.exists() and file.samefile(source) for source in sources):
        raise InputError(Text("cli-prior-was-read", file=str(file)))
    try:
        write_atomically(file, bytes_of(document))
    except OSError as error:
        reason = error.strerror or error
        raise InputError(Text("cli-prior-unwritable", file=str(file), reason=reason)) from error


def bytes_of(document: PriorDocument) -> bytes:
    """Return the content of a prior's file."""
    return (document.model_dump_json() + "\n").encode()


def check_code(person: str) -> None:
    """Raise InputError unless `person` can be the code of a person."""
    try:
        TypeAdapter(Name).validate_python(person)
    except ValueError as error:
        raise InputError(Text("cli-prior-person", person=person)) from error


def channel_ranges(layout: ShirtLayout, joint: str, prior: JointPrior) -> dict[str, float | None]:
    """Return the usual range of each channel in signal units; None for a channel that nobody could use."""
    names = [layout.channel_names[i] for i in layout.channels_of_joint[joint]]
    logs = prior.expected.tolist()
    return {
        name: None if math.isnan(log) else float(f"{math.exp(log):.4g}") for name, log in zip(names, logs, strict=True)
    }
