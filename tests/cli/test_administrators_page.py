"""docs/administrators.md, defects.md and commands.md: each command is one that exists, with these words and options."""

import re
import shlex
import shutil
import subprocess
import sys
from functools import cache

import pytest
from cli.answers import output_of
from typer.main import get_command

from app import ports
from app.cli.main import COMMANDS, build
from app.settings import Settings
from app.store.database import Database
from folders import ROOT

PAGES = [ROOT / "docs" / name for name in ("administrators.md", "defects.md", "commands.md")]
BLOCK = re.compile(r"^```sh\n(.*?)^```", flags=re.DOTALL | re.MULTILINE)
SETTING = re.compile(r"[A-Z_]+=\S+")


def commands() -> list[list[str]]:
    """Return the words of every command on the pages: the lines of their blocks, and bodydrive's within sentences."""
    found = []
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        found += [line for block in BLOCK.findall(text) for line in block.splitlines()]
        found += re.findall(r"`(bodydrive [^`]+)`", text)
    split = [shlex.split(line, comments=True) for line in found]
    return [[word for word in words if not SETTING.fullmatch(word)] for words in split]


def program(words: list[str]) -> str:
    return words[0].rpartition("/")[2]


COMMAND_LINES = commands()
OURS = [words[1:] for words in COMMAND_LINES if program(words) == "bodydrive"]
OTHERS = [words for words in COMMAND_LINES if program(words) != "bodydrive"]


def test_the_pages_name_commands():
    assert {words[0] for words in OURS} >= {"serve", "log", "about", "chair"}
    assert {program(words) for words in OTHERS} == {"python3", "pip", "cp", "cd", "mkdir", "find"}


# Where a page names a command within a sentence, it may leave out what else the command needs.
INCOMPLETE = {"MissingParameter", "NoArgsIsHelpError"}


def complaint(words):
    """Read a command line as bodydrive does, without running it; return what is wrong with it, empty for nothing."""
    context = get_command(build(list(COMMANDS))).make_context("bodydrive", list(words))
    try:
        while hasattr(context.command, "resolve_command"):
            given = [*context._protected_args, *context.args]
            name, command, rest = context.command.resolve_command(context, given)
            context = command.make_context(name, rest, parent=context)
    except Exception as error:
        return "" if type(error).__name__ in INCOMPLETE else str(error)
    return ""


@pytest.mark.parametrize("words", OURS, ids=" ".join)
def test_a_command_of_bodydrive_is_understood(words):
    assert complaint([word for word in words if word != "--help"]) == ""


@pytest.mark.parametrize("words", [["verify"], ["serve", "--nothing"], ["log", "check"], ["serve", "--port", "many"]])
def test_a_command_that_does_not_exist_would_be_found(words):
    assert complaint(words)


@cache
def help_of_pip(command):
    words = [sys.executable, "-m", "pip", command, "--help"]
    return subprocess.run(words, capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize("words", OTHERS, ids=" ".join)
def test_a_command_of_the_system_is_there_with_its_options(words):
    name = program(words)
    if name != "pip":
        assert name == "cd" or shutil.which(name)
        return
    assert [word for word in words if word.startswith("--") and word not in help_of_pip(words[1])] == []


@pytest.mark.parametrize("words", [words for words in OURS if words[0] in {"about", "log"}], ids=" ".join)
def test_what_only_reads_is_run(words, bodydrive, tmp_path):
    settings = Settings(state=tmp_path)
    Database(settings.database).close()
    given = [str(tmp_path) if word == "/var/lib/bodydrive" else word for word in words]
    if words[0] == "log" and "--state" not in words:
        given += ["--state", str(tmp_path)]
    out = output_of(bodydrive(*given))
    assert out


def test_the_files_and_ports_of_the_page_are_those_of_the_program(tmp_path):
    text = PAGES[0].read_text(encoding="utf-8")
    table = text.partition("| in the state folder |")[2].partition("\n\n")[0]
    settings = Settings(state=tmp_path / "nobody yet")
    written = {settings.database.name, *(path.name for path in settings.state_paths)}
    assert written - {settings.state.name} <= set(re.findall(r"`([\w.-]+)/?`", table))
    assert f"TCP {settings.port} of {settings.host}" in text
    assert f"TCP {ports.HTTPS_PORT} of all addresses" in text
    assert f"shirt {ports.SHIRT_PORT}, trackers {ports.SLIMEVR_PORT} (" in text
    assert f"head tracker {ports.OPENTRACK_PORT} or {ports.FREEPIE_PORT}," in text
    assert f"UDP {ports.RECEIVER_PORT}; takes only commands" in text
