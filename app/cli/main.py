"""The command line: one command per task."""

import os
import sys
from collections.abc import Mapping
from importlib import import_module
from typing import Annotated

import typer

from app import __version__
from app.cli.errors import InputError, refuse
from app.cli.help_text import help_text
from app.features import names
from app.texts import ENGLISH, LANGUAGES, Text, reader_language

# Command: module and function, imported only when the command is used, so that `--help` starts quickly, and the ids
# of the paragraphs of its help.
_COMMANDS: dict[str, tuple[str, ...]] = {
    "demo": ("app.cli.serve", "demo", "cli-help-demo"),
    "serve": ("app.cli.serve", "serve", "cli-help-serve"),
    "calibrate": ("app.cli.calibration.calibrate", "calibrate", "cli-help-calibrate"),
    "prior": ("app.cli.calibration.prior_command", "prior_app", "cli-help-prior"),
    "decode": ("app.cli.decode", "decode", "cli-help-decode"),
    "signals": ("app.cli.signal_files", "signals_app", "cli-help-signals-command"),
    "score": ("app.cli.score", "score", "cli-help-score", "cli-help-score-following"),
    "study": ("app.cli.study.study_command", "study", "cli-help-study"),
    "replay": ("app.cli.replay", "replay", "cli-help-replay"),
    "check": ("app.cli.host.check_command", "check", "cli-help-check"),
    "service": ("app.cli.host.service", "service_app", "cli-help-service"),
    "shirt": ("app.cli.shirt", "shirt_app", "cli-help-shirt"),
    "chair": ("app.cli.chair", "chair_app", "cli-help-chair"),
    "people": ("app.cli.people", "people_app", "cli-help-people"),
    "report": ("app.cli.records.report_command", "report", "cli-help-report"),
    "export": ("app.cli.records.export", "export", "cli-help-export"),
    "archive": ("app.cli.records.archive_command", "archive_app", "cli-help-archive"),
    "log": ("app.cli.log_command", "log_app", "cli-help-log"),
    "backup": ("app.cli.records.backup_command", "backup", "cli-help-backup"),
    "restore": ("app.cli.records.backup_command", "restore", "cli-help-restore"),
    "incident": ("app.cli.records.incident_command", "incident", "cli-help-incident"),
    "floorplan": ("app.cli.floorplan", "floorplan_app", "cli-help-floorplan"),
    "about": ("app.cli.about", "about", "cli-help-about"),
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
        help=help_text("cli-help-program"),
        no_args_is_help=True,
        add_completion=False,
        pretty_exceptions_enable=False,
    )

    @application.callback(invoke_without_command=True)
    def _options(
        version: Annotated[bool, typer.Option("--version", help=help_text("cli-help-version"))] = False,
    ) -> None:
        if version:
            typer.echo(f"bodydrive {__version__}")
            raise typer.Exit

    for command_name in command_names:
        module, name, *paragraphs = COMMANDS[command_name]
        command = getattr(import_module(module), name)
        if isinstance(command, typer.Typer):
            application.add_typer(command, name=command_name, help=help_text(*paragraphs))
        else:
            application.command(command_name, help=help_text(*paragraphs))(command)
    return application


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
