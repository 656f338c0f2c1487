"""The command line: one command per task."""

import os
import sys
from collections.abc import Mapping
from importlib import import_module
from typing import Annotated

import typer

from app import __version__
from app.cli.errors import InputError, refuse
from app.features import names
from app.texts import ENGLISH, LANGUAGES, Text, reader_language

# Command: module and function, imported only when the command is used, so that `--help` starts quickly.
_COMMANDS = {
    "demo": ("app.cli.serve", "demo"),
    "serve": ("app.cli.serve", "serve"),
    "calibrate": ("app.cli.calibration.calibrate", "calibrate"),
    "prior": ("app.cli.calibration.prior_command", "prior_app"),
    "decode": ("app.cli.decode", "decode"),
    "score": ("app.cli.score", "score"),
    "study": ("app.cli.study.study_command", "study"),
    "replay": ("app.cli.replay", "replay"),
    "check": ("app.cli.host.machine_check", "check"),
    "service": ("app.cli.host.service", "service_app"),
    "shirt": ("app.cli.shirt", "shirt_app"),
    "chair": ("app.cli.chair", "chair_app"),
    "people": ("app.cli.people", "people_app"),
    "report": ("app.cli.records.report_command", "report"),
    "export": ("app.cli.records.export", "export"),
    "archive": ("app.cli.records.archive_command", "archive_app"),
    "log": ("app.cli.log_command", "log_app"),
    "backup": ("app.cli.records.backup_command", "backup"),
    "restore": ("app.cli.records.backup_command", "restore"),
    "incident": ("app.cli.records.incident_command", "incident"),
    "floorplan": ("app.cli.floorplan", "floorplan_app"),
    "about": ("app.cli.about", "about"),
}
OF_FEATURES = {
    "report": "reports",
    "export": "exports",
    "archive": "archive",
    "log": "log",
    "backup": "backup",
    "restore": "backup",
    "incident": "backup",
}
COMMANDS = {word: place for word, place in _COMMANDS.items() if OF_FEATURES.get(word) in {None, *names()}}
# Base class of typer's errors about commands and options, which has no public name in typer.
UsageError: type[Exception] = next(kind for kind in typer.BadParameter.__mro__ if kind.__name__ == "ClickException")


def build(command_names: list[str]) -> typer.Typer:
    """Return the application with these commands."""
    application = typer.Typer(
        name="bodydrive",
        help="Body-machine interface for powered wheelchairs: calibrate, practise, score, drive.",
        no_args_is_help=True,
        add_completion=False,
        pretty_exceptions_enable=False,
    )
    application.callback(invoke_without_command=True)(_options)
    for command_name in command_names:
        module, name = COMMANDS[command_name]
        command = getattr(import_module(module), name)
        if isinstance(command, typer.Typer):
            application.add_typer(command, name=command_name)
        else:
            application.command(command_name)(command)
    return application


def _options(
    version: Annotated[bool, typer.Option("--version", help="Say which version this is, and end.")] = False,
) -> None:
    if version:
        typer.echo(f"bodydrive {__version__}")
        raise typer.Exit


def main() -> None:
    """Run the command line; bad input is one sentence on stderr and exit code 2."""
    with reader_language(language_of(os.environ)):
        _run()


def language_of(environment: Mapping[str, str]) -> str:
    """Return the language of a terminal; English where the catalogue does not offer it."""
    locale = next(filter(None, map(environment.get, ("LC_ALL", "LC_MESSAGES", "LANG"))), "")
    return locale[:2] if locale[:2] in LANGUAGES else ENGLISH


def _run() -> None:
    arguments = [word for word in sys.argv[1:] if not word.startswith("-")]
    command_names = [arguments[0]] if arguments and arguments[0] in COMMANDS else list(COMMANDS)
    try:
        code = build(command_names)(standalone_mode=False, prog_name="bodydrive")
    except InputError as error:
        refuse(str(error))
    except UsageError as error:
        sentence = getattr(error, "format_message", error.__str__)()
        if not sentence:  # no command was given, and the help has been printed
            sys.exit(0)
        command = " ".join(["bodydrive", *command_names[: len(command_names) == 1]])
        refuse(str(Text("cli-see-help", problem=sentence.rstrip("."), command=command)))
    except OSError as error:
        reason = error.strerror or error
        if error.filename:
            refuse(str(Text("cli-file-failed", file=str(error.filename), reason=reason)))
        refuse(str(Text("cli-output-failed", reason=reason)))
    except (typer.Abort, KeyboardInterrupt):
        sys.exit(130)
    sys.exit(code if isinstance(code, int) else 0)


if __name__ == "__main__":
    main()
