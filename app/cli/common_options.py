"""Options that several commands have: the clinic's folder, and the output as JSON."""

from pathlib import Path
from typing import Annotated

import typer

from app.cli.help_text import help_text
from app.settings import Settings, state_folder

COMMAND_LINE = "command line"  # who did it, in the log of the clinic

State = Annotated[Path | None, typer.Option(help=help_text("cli-help-state"))]
AsJson = Annotated[bool, typer.Option("--json", help=help_text("cli-help-json"))]


def folder_of(state: Path | None) -> Path:
    """Return the whole path of the clinic's folder; without the option that of this account."""
    return (state or state_folder()).expanduser().resolve()


def settings_of(state: Path | None) -> Settings:
    """Return the settings of a command that works on the clinic's folder."""
    return Settings(state=folder_of(state))
