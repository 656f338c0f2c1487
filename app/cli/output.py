"""The output file of a command: written completely or not at all, and never over an input file."""

import os
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from app.cli.errors import InputError
from app.files import write_atomically

if TYPE_CHECKING:
    from app.signals.signals import Signals


def write_output(out: Path, content: bytes, *sources: Path) -> None:
    """Write `content` to `out`, or raise InputError with nothing changed; `sources` are the input files."""
    try:
        for source in sources:
            if out.exists() and source.exists() and out.samefile(source):
                raise InputError(f"--out {out} is a file that was read for this: choose another place")
        write_atomically(out, content)
    except OSError as error:
        raise InputError(f"--out {out} cannot be written ({error.strerror}): choose another place") from error


def warn(sentence: str) -> None:
    """Write a warning to stderr, unless it is empty."""
    if sentence:
        typer.echo(f"bodydrive: {sentence}", err=True)


def check_new_folder(folder: Path) -> None:
    """Raise InputError when a folder could not be made; to be called before a long computation."""
    try:
        existing = next(place for place in (folder, *folder.absolute().parents) if place.exists())
    except OSError as error:
        raise InputError(f"--out {folder} cannot be written ({error.strerror}): choose another place") from error
    if not existing.is_dir():
        raise InputError(f"--out {folder}: {existing} is a file and not a folder, choose another place")
    if not os.access(existing, os.W_OK | os.X_OK):
        raise InputError(f"--out {folder}: nothing may be written in {existing}, choose another place")


def dialect_summary(recorded: "Signals") -> dict[str, dict[str, str]]:
    """Return the dialect of a CSV file for `--json`; empty for other files."""
    return {} if recorded.dialect is None else {"dialect": recorded.dialect._asdict()}


def print_dialect(recorded: "Signals", file: Path) -> None:
    """Write to stdout the dialect of a CSV file that does not use the usual signs."""
    if recorded.dialect is not None and recorded.dialect.sentence:
        typer.echo(f"{file}: {recorded.dialect.sentence}")
