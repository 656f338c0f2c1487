"""The help of every command is in plain words and in the language of the terminal, and names no symbol."""

import json
import os
import subprocess
import sys

import pytest
from cli.symbols import symbols_in
from fluent.syntax import FluentParser
from fluent.syntax import ast as fluent
from typer.testing import CliRunner

from app.cli.help_text import help_messages
from app.cli.main import COMMANDS, build
from app.cli.records.backup_command import PASSPHRASE
from app.texts import LANGUAGES
from folders import ROOT
from words import WORDS

HELPS = """
import json, sys
from typer.main import get_command
from app.cli.main import COMMANDS, build
from app.texts import reader_language

def helps_of(command):
    yield command.help
    yield from (param.help for param in command.params)
    for each in getattr(command, "commands", {}).values():
        yield from helps_of(each)

with reader_language(sys.argv[1]):
    print(json.dumps(list(helps_of(get_command(build(list(COMMANDS)))))))
"""


@pytest.mark.parametrize("command", COMMANDS)
def test_the_help_has_no_symbols(command):
    shown = CliRunner().invoke(build(list(COMMANDS)), [command, "--help"])
    assert shown.exit_code == 0, shown.output
    assert symbols_in(shown.output) == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_message_of_the_help_is_one_line_without_values(language):
    source = (WORDS / language / "server" / "command_help.ftl").read_text(encoding="utf-8")
    messages = [entry for entry in FluentParser().parse(source).body if isinstance(entry, fluent.Message)]
    assert {
        message.id.name: [getattr(part, "value", None) for part in message.value.elements] for message in messages
    } == {name: [text] for name, text in help_messages(language).items()}


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_command_and_option_has_its_help_in_the_language(language):
    """A module of a command reads its help once, so a process of its own imports it."""
    words = [sys.executable, "-c", HELPS, language]
    shown = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=True)
    paragraphs = {paragraph for text in json.loads(shown.stdout) for paragraph in text.split("\n\n")}
    assert paragraphs == set(help_messages(language).values())


def test_the_help_is_in_the_language_of_the_terminal():
    ended = subprocess.run(
        [sys.executable, "-m", "app.cli.main", "log", "--help"],
        cwd=ROOT,
        env={**os.environ, "LC_ALL": "es_ES.UTF-8", "PYTHONUTF8": "1", "COLUMNS": "200"},
        capture_output=True,
        encoding="utf-8",
        check=True,
    )
    assert help_messages("es")["cli-help-log"] in ended.stdout


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_help_of_a_backup_names_the_variable_of_the_passphrase(language):
    assert PASSPHRASE in help_messages(language)["cli-help-backup-encrypt"]
