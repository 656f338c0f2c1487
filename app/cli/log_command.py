"""`bodydrive log`: checks whether anybody changed the log of a clinic."""

import json
import sqlite3
from dataclasses import asdict

import typer

from app.cli.common_options import AsJson, State, settings_of
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.texts import Text

CHANGED = 1  # exit code

log_app = typer.Typer(no_args_is_help=True, pretty_exceptions_enable=False)


@log_app.callback()
def _log() -> None:
    """Make typer keep the sub-command `verify`, although it is the only one."""


@log_app.command("verify", help=help_text("cli-help-log-verify", "cli-help-log-verify-exit"))
def verify(
    state: State = None,
    as_json: AsJson = False,
) -> None:
    """Check that no row of the log was edited, moved, put in or removed; the clinic may be open meanwhile.

    The exit code is 0 when the log is whole, 1 when it was changed, 2 when it cannot be read.
    """
    from app.store.log_chain import verify_log

    settings = settings_of(state)
    if not settings.database.is_file():
        raise InputError(Text("cli-no-clinic", folder=str(settings.state)))
    try:
        check = verify_log(settings.database)
    except sqlite3.Error as error:
        raise InputError(Text("cli-log-unreadable", file=str(settings.database), reason=error)) from error
    typer.echo(json.dumps(asdict(check), default=str) if as_json else check.message)
    if not check.whole:
        raise typer.Exit(CHANGED)
