"""Where a command's result goes: whole or not at all, and never over what it was made from."""

import os
from pathlib import Path

import typer

from app.cli.errors import InputError
from app.files import write_atomically
from app.signals.signals import Signals


def write_output(out: Path, content: bytes, *sources: Path) -> None:
    """Write `content` to `out`, or raise InputError and leave everything as it was; `sources` are what was read."""
    try:
        for source in sources:
            if out.exists() and source.exists() and out.samefile(source):
                raise InputError(f"--out {out} is a file that was read for this: choose another place")
        write_atomically(out, content)
    except OSError as error:
        raise InputError(f"--out {out} cannot be written ({error.strerror}): choose another place") from error


def warn(words: str) -> None:
    """Say on stderr what does not keep a command from its work, but should be known; nothing when there is nothing."""
    if words:
        typer.echo(f"bodydrive: {words}", err=True)


def check_new_folder(folder: Path) -> None:
    """Raise InputError when a folder could not be made, before anybody has worked for what would go there."""
    try:
        standing = next(place for place in (folder, *folder.absolute().parents) if place.exists())
    except OSError as error:
        raise InputError(f"--out {folder} cannot be written ({error.strerror}): choose another place") from error
    if not standing.is_dir():
        raise InputError(f"--out {folder}: {standing} is a file and not a folder, choose another place")
    if not os.access(standing, os.W_OK | os.X_OK):
        raise InputError(f"--out {folder}: nothing may be written in {standing}, choose another place")


def dialect_summary(recorded: Signals) -> dict[str, dict[str, str]]:
    """Return what `--json` says of the signs that a CSV file uses; nothing for other files."""
    return {} if recorded.dialect is None else {"dialect": recorded.dialect._asdict()}


def print_dialect(recorded: Signals, file: Path) -> None:
    """Say on stdout with which signs a CSV file was read, where they are not the usual ones."""
    if recorded.dialect is not None and recorded.dialect.words:
        typer.echo(f"{file}: {recorded.dialect.words}")
