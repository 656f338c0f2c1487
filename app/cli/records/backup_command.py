"""`bodydrive backup` and `bodydrive restore`: the whole clinic in one file, or in a folder of backups."""

import json
import os
import sys
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.clinic_folder import FolderInUseError, lock_folder, open_clinic
from app.cli.common_options import COMMAND_LINE, AsJson, State, settings_of
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.records.written_files import utc_time
from app.file_modes import keep_new_files_private
from app.refusals import Refusal
from app.settings import Settings
from app.texts import Figure, Text, text_of

if TYPE_CHECKING:
    from app.features.backup.age_files import Secret
    from app.features.backup.service import MadeReport

PASSPHRASE = "BODYDRIVE_PASSPHRASE"  # noqa: S105  (the name of a variable)


def backup(
    target: Annotated[Path, typer.Argument(metavar="FILE", help=help_text("cli-help-backup-file"))],
    encrypt: Annotated[bool, typer.Option("--encrypt", help=help_text("cli-help-backup-encrypt"))] = False,
    with_keys: Annotated[bool, typer.Option("--with-keys", help=help_text("cli-help-backup-with-keys"))] = False,
    check: Annotated[bool, typer.Option("--check", help=help_text("cli-help-backup-check"))] = False,
    state: State = None,
    as_json: AsJson = False,
) -> None:
    """Back up a clinic, also while it is open, and read the backup back; into a folder, only what is new is written."""
    from app.features.backup.service import make_backup
    from app.realtime import take_lowest_priority

    if check:
        _check(target, as_json)
        return
    settings = settings_of(state)
    keep_new_files_private()
    take_lowest_priority()
    try:
        report = make_backup(
            settings, target.absolute(), _secret_to_make(target, encrypt), with_keys=with_keys, progress=_show_progress
        )
    except Refusal as refusal:
        raise InputError(text_of(refusal)) from refusal
    unlogged = _log_made(settings, target.absolute(), report)
    if as_json:
        typer.echo(json.dumps(asdict(report) | {"message": str(report.message or "")}))
        return
    made = Text(
        "cli-backup-made",
        name=report.name,
        files=report.files,
        size=Figure(report.bytes / 1e6, 1),
        keys="with" if report.with_keys else "without",
        encrypted="yes" if report.encrypted else "no",
    )
    for sentence in filter(None, (made, Text("cli-backup-hash", hash=report.hash), report.message, unlogged)):
        typer.echo(sentence)


def restore(
    source: Annotated[Path, typer.Argument(metavar="FILE", help=help_text("cli-help-restore-file"))],
    erased: Annotated[Path | None, typer.Option("--erased", help=help_text("cli-help-restore-erased"))] = None,
    state: State = None,
    as_json: AsJson = False,
) -> None:
    """Restore a clinic into an empty folder: every file equal by hash, patients who were erased since left out."""
    from app.features.backup.restoration import restore as restored_from
    from app.store.keeping.tombstones import read_tombstones

    settings = settings_of(state)
    if erased is not None and not erased.is_file():
        raise InputError(Text("cli-backup-no-erased", file=str(erased)))
    secret = _secret_to_read(source)
    try:
        with lock_folder(settings.state):
            keep_new_files_private()
            newer_erased = read_tombstones(erased) if erased is not None else frozenset()
            restored = restored_from(source.absolute(), settings, secret, newer_erased)
    except FolderInUseError as error:
        raise InputError(Text("cli-backup-clinic-open", folder=str(settings.state))) from error
    except Refusal as refusal:
        raise InputError(text_of(refusal)) from refusal
    manifest = restored.manifest
    facts: dict[str, object] = {
        "made": manifest.made,
        "files": len(manifest.files),
        "bytes": manifest.size,
        "hash": manifest.hash,
        "with_keys": manifest.with_keys,
        "erased_again": restored.erased_again,
    }
    if as_json:
        typer.echo(json.dumps(facts))
        return
    done = Text(
        "cli-restored-with-keys" if manifest.with_keys else "cli-restored-without-keys",
        time=utc_time(manifest.made),
        folder=str(settings.state),
        files=len(manifest.files),
        size=Figure(manifest.size / 1e6, 1),
    )
    typer.echo(done)
    typer.echo(Text("cli-backup-hash", hash=manifest.hash))
    if restored.erased_again:
        typer.echo(Text("cli-restored-erased", count=restored.erased_again))


def _check(target: Path, as_json: bool) -> None:
    from app.features.backup.backup_file import read_backup

    try:
        manifest = read_backup(target.absolute(), _secret_to_read(target))
    except Refusal as refusal:
        raise InputError(text_of(refusal)) from refusal
    files = len(manifest.files)
    if as_json:
        facts = {"made": manifest.made, "files": files, "bytes": manifest.size, "hash": manifest.hash}
        typer.echo(json.dumps(facts))
        return
    typer.echo(Text("cli-backup-whole", name=target.name, files=files, time=utc_time(manifest.made)))
    typer.echo(Text("cli-backup-hash", hash=manifest.hash))


def _secret_to_make(target: Path, encrypt: bool) -> "Secret | None":
    """Return the secret of a new backup; a folder that is encrypted already asks for its passphrase by itself."""
    from app.features.backup.age_files import new_secret
    from app.features.backup.backup_folder import HEADER, sealed_key_of_folder
    from app.features.backup.night_secret import secret_of_folder

    if (target / HEADER).is_file() and sealed_key_of_folder(target) is not None:
        return secret_of_folder(target, _passphrase(is_new=False))
    return new_secret(_passphrase(is_new=True)) if encrypt else None


def _secret_to_read(source: Path) -> "Secret | None":
    from app.features.backup.age_files import opened_secret
    from app.features.backup.backup_file import sealed_key_of

    newest = max(source.glob("*.backup"), default=None)  # the names of a folder begin with the time
    if newest is not None:
        raise InputError(Text("cli-backup-is-folder", folder=str(source), newest=str(newest)))
    if not source.is_file():
        raise InputError(Text("cli-no-backup", file=str(source)))
    sealed = sealed_key_of(source)
    try:
        return None if sealed is None else opened_secret(sealed, _passphrase(is_new=False))
    except Refusal as refusal:
        raise InputError(text_of(refusal)) from refusal


def _passphrase(*, is_new: bool) -> str:
    from app.features.backup.age_files import SHORTEST_PASSPHRASE

    passphrase = os.environ.get(PASSPHRASE)
    if passphrase is None:
        if not sys.stdin.isatty():
            raise InputError(Text("cli-passphrase-needed", variable=PASSPHRASE))
        question = str(Text("cli-passphrase"))
        passphrase = typer.prompt(question, hide_input=True, confirmation_prompt=is_new, err=True)
    if is_new and len(passphrase) < SHORTEST_PASSPHRASE:
        raise InputError(Text("cli-passphrase-short", least=SHORTEST_PASSPHRASE))
    return str(passphrase)


def _show_progress(step: str, done: int, total: int) -> None:
    if sys.stderr.isatty():
        progress = Text(f"cli-backup-step-{step}", done=Figure(done / 1e6), total=Figure(total / 1e6))
        sys.stderr.write(f"\r{progress} \033[K{'' if done < total else chr(10)}")


def _log_made(settings: Settings, target: Path, report: "MadeReport") -> Text | None:
    """Log the backup; return a sentence when the clinic is of another version and so cannot be opened."""
    from app.features.backup.made_backups import add_backup
    from app.store.schema import NEWEST, revision_of

    if revision_of(settings.database) != NEWEST:
        return Text("cli-backup-unlogged")
    with open_clinic(settings) as (database, _), database.transaction(closing=True) as db:
        add_backup(
            db,
            COMMAND_LINE,
            place=str(target),
            name=report.name,
            in_folder=target.is_dir(),
            good=True,
            message=report.message,
            files=report.files,
            size=report.bytes,
            digest=report.hash,
            encrypted=report.encrypted,
            with_keys=report.with_keys,
        )
    return None
