"""`bodydrive shirt`: pair with a shirt over the network, and send frames as a paired shirt."""

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from app.cli.common_options import State, settings_of
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.qr import terminal_code
from app.file_modes import keep_new_files_private
from app.hardware.shirt import sender
from app.ports import SHIRT_PORT
from app.refusals import Refusal
from app.settings import Settings
from app.texts import Text, text_of

if TYPE_CHECKING:
    from app.hardware.chair.key import Key

shirt_app = typer.Typer(no_args_is_help=True, pretty_exceptions_enable=False)


@shirt_app.command(
    "send",
    help=help_text("cli-help-shirt-send"),
    add_help_option=False,  # the program has its own --help
    context_settings={"allow_extra_args": True, "ignore_unknown_options": True},
)
def send(context: typer.Context) -> None:
    """Send a file or slow waves as a paired shirt does: the example for a shirt's firmware."""
    raise typer.Exit(sender.main(context.args, "bodydrive shirt send"))


@shirt_app.command("pair", help=help_text("cli-help-shirt-pair"))
def pair(
    state: State = None,
) -> None:
    """Make a key for a shirt, keep it with the clinic, and show it once as a QR code."""
    settings = settings_of(state)
    try:
        key = _paired(settings)
    except Refusal as refusal:
        raise InputError(text_of(refusal)) from refusal
    typer.echo(terminal_code(key.line))
    _print_instructions(key, settings.keys)


def _paired(settings: Settings) -> "Key":
    """Write the key and the log entry, both or none; the clinic may be served meanwhile."""
    from app.session.equipment.pairing import pair_shirt, unpair_shirt
    from app.store.database import Database
    from app.store.log import write_log
    from app.store.people import add_clinic, the_clinic

    keep_new_files_private()
    database, key = Database(settings.database), None
    try:
        with database.transaction() as db:
            if the_clinic(db) is None:
                add_clinic(db, str(Text("cli-clinic-name")))
            key = pair_shirt(settings.keys)
            write_log(db, None, "shirt paired", key_id=key.id)
    except BaseException:
        if key is not None:
            unpair_shirt(settings.keys, key.id)
        raise
    finally:
        database.close()
    return key


def _print_instructions(key: "Key", keys: Path) -> None:
    file = f"shirt-{key.id}.key"
    typer.echo(Text("cli-shirt-paired", path=str(keys / file), file=file))
    typer.echo(Text("cli-shirt-next", file=file))
    typer.echo(f"bodydrive shirt send --key-file {file} --to HOST:{SHIRT_PORT}")
