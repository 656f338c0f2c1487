"""The output file of a command: written completely or not at all, and never over an input file."""

import os
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from app.cli.errors import InputError
from app.files import write_atomically
from app.texts import Text

if TYPE_CHECKING:
    from app.signals.signals import Signals


def write_output(out: Path, content: bytes, *sources: Path) -> None:
    """Write `content` to `out`, or raise InputError with nothing changed; `sources` are the input files."""
    try:
        for source in sources:
            if out.exists() and source.exists() and out.samefile(source):
                raise InputError(Text("cli-out-was-read", file=str(out)))
        write_atomically(out, content)
    except OSError as error:
        raise unwritable(out, error) from error


def unwritable(out: Path, error: OSError) -> InputError:
    """Return the error for a file or folder that cannot be written."""
    return InputError(Text("cli-out-unwritable", file=str(out), reason=error.strerror or error))


def warn(sentence: Text | str | None) -> None:
    """Write a warning to stderr, unless there is none."""
    if sentence:
        typer.echo(f"bodydrive: {sentence}", err=True)


def check_new_folder(folder: Path) -> None:
    """Raise InputError when a folder could not be made; to be called before a long computation."""
    try:
        existing = next(place for place in (folder, *folder.absolute().parents) if place.exists())
    except OSError as error:
        raise unwritable(folder, error) from error
    if not existing.is_dir():
        raise InputError(Text("cli-out-no-folder", folder=str(folder), file=str(existing)))
    if not os.access(existing, os.W_OK | os.X_OK):
        raise InputError(Text("cli-out-forbidden", folder=str(folder), parent=str(existing)))


def dialect_summary(recorded: "Signals") -> dict[str, dict[str, str]]:
    """Return the dialect of a CSV file for `--json`; empty for other files."""
    if recorded.dialect is None:
        return {}
    return {"dialect": {"separator": recorded.dialect.separator, "decimal": recorded.dialect.decimal}}


def print_dialect(recorded: "Signals", file: Path) -> None:
    """Write to stdout the dialect of a CSV file that does not use the usual signs."""
    if recorded.dialect is not None and recorded.dialect.sentence:
        typer.echo(Text("cli-named", name=str(file), text=recorded.dialect.sentence))
