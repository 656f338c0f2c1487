"""`bodydrive service install`: the machine starts the clinic by itself."""

import getpass
import os
import sys
from typing import Annotated

import typer

from app.cli.common_options import State, folder_of
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.refusals import Refusal
from app.texts import Text, text_of

service_app = typer.Typer(no_args_is_help=True)

System = Annotated[bool, typer.Option("--system", help=help_text("cli-help-service-install-system"))]
Account = Annotated[str | None, typer.Option(help=help_text("cli-help-service-install-account"))]
OnlyPrint = Annotated[bool, typer.Option("--print", help=help_text("cli-help-service-install-print"))]


@service_app.callback()
def _service() -> None:
    """Make `install` a command of its own: typer would drop the name of an only one."""


@service_app.command("install", help=help_text("cli-help-service-install"))
def install_service(
    system: System = False, account: Account = None, only_print: OnlyPrint = False, state: State = None
) -> None:
    """Install a systemd unit that runs `bodydrive serve --lan`, and start it."""
    from app.host.systemd_unit import install, unit

    if account is not None and not system:
        raise InputError(Text("cli-service-account"))
    owner = (account or os.environ.get("SUDO_USER") or getpass.getuser()) if system else None
    if owner == "root":
        raise InputError(Text("cli-service-root"))
    if system and state is None:
        raise InputError(Text("cli-service-state"))
    folder = folder_of(state)
    unprintable = next((letter for letter in f"{folder}{owner or ''}" if not letter.isprintable()), None)
    if unprintable is not None or (owner is not None and not owner.isascii()) or " " in (owner or ""):
        raise InputError(Text("cli-service-letters"))
    text = unit([sys.executable, "-m", "app.cli.main", "serve", "--lan", "--state", str(folder)], folder, owner)
    if only_print:
        typer.echo(text, nl=False)
        return
    try:
        for sentence in install(text, system=system):
            typer.echo(sentence)
    except Refusal as refusal:
        raise InputError(text_of(refusal)) from refusal
